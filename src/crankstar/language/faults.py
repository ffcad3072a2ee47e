"""Faults: what is wrong with an engine, a file or a question, as a record; and its sentence.

Rooms above name a code and the values that belong to it; the sentences stand in the tables of
`engine_faults`, `file_faults` and others, marked for translation. Each host says where a
fault is in its own words: `where(path)` in an engine file, an option on the command line, a field
in a dialog.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from string import Formatter
from typing import Any, NamedTuple

from crankstar.language import (
    engine_faults,
    file_faults,
    gas_faults,
    mount_faults,
    search_faults,
    server_faults,
    tolerance_faults,
    torsion_faults,
    value_faults,
)
from crankstar.language.messages import MessageError, Plural, _, _n
from crankstar.language.quoting import one_line
from crankstar.language.written import joined

SENTENCES: dict[str, str | Plural] = {
    **engine_faults.SENTENCES,
    **file_faults.SENTENCES,
    **gas_faults.SENTENCES,
    **mount_faults.SENTENCES,
    **tolerance_faults.SENTENCES,
    **torsion_faults.SENTENCES,
    **value_faults.SENTENCES,
    **search_faults.SENTENCES,
    **server_faults.SENTENCES,
}
"""By code; `{where}` stands for the place, a plural goes by the value `count`."""
GREATEST_LISTED = 12
"""Values of a list up to which a sentence has all of them."""


class Fault(NamedTuple):
    """One thing wrong: where (keys and indices from nought), which, and the values of its sentence.

    Values are numbers, texts, lists and tables of them. `cylinder` is the number of the one
    cylinder it is about, since a short file lists its cylinders in another way.
    """

    path: tuple[str | int, ...]
    code: str
    values: Mapping[str, Any] = {}
    cylinder: int | None = None

    @property
    def sentence(self) -> str:
        """What is wrong and what would be right, the place named as in an engine file."""
        return sentence(self.code, self.values, place=where(self.path))


class EngineError(MessageError):
    """An engine that cannot be; carries every fault found, not only the first.

    >>> import crankstar
    >>> from crankstar.engine.copies import with_values
    >>> engine = crankstar.load("i4")
    >>> weight = crankstar.Weight(unbalance=1, angle=0, throw=5)
    >>> try:
    ...     with_values(engine, shafts=(with_values(engine.shafts[0], weights=[weight]),))
    ... except crankstar.EngineError as error:
    ...     error.faults[0].path
    ('shaft', 0, 'weight', 0, 'throw')
    """

    def __init__(self, faults: Sequence[Fault]) -> None:
        self.faults = list(faults)
        super().__init__(joined("\n", (fault.sentence for fault in self.faults)))


class ValueFaultError(MessageError):
    """A value that cannot be, found where its place is not known."""

    def __init__(self, code: str, **values: Any) -> None:
        self.code, self.values = code, values
        super().__init__(sentence(code, values, place=_("the value")))

    def at(self, place: str) -> str:
        """The sentence with the place where the value stands."""
        return sentence(self.code, self.values, place=place)

    def __reduce__(self) -> tuple[Any, ...]:
        """It goes from process to process."""
        return partial(type(self), self.code, **self.values), ()


def sentence(
    code: str, values: Mapping[str, Any], *, place: str, named: Callable[[str], str] = str
) -> str:
    """The sentence of a fault in the language of the context.

    named: how the host writes the name of an option.

    >>> sentence("shaft.reference-ratio", {"value": 2}, place="shaft[1].speed_ratio").split(";")[0]
    'shaft[1].speed_ratio is 2'
    """
    template = SENTENCES[code]
    shown = {name: _shown(name, value) for name, value in values.items()}
    if isinstance(template, Plural):
        return _n(template.one, template.several, values["count"], where=place, **shown)
    shown["where"] = place
    names = {name for _text, name, *_rest in Formatter().parse(template) if name} - set(shown)
    return _(template, **shown, **{name: named(name) for name in names})


def _shown(name: str, value: Any) -> str:
    if isinstance(value, str):
        words = file_faults.NAMED.get(name, {}).get(value)
        return value if words is None else _(words)
    if isinstance(value, float):
        return f"{value:.6g}"
    if isinstance(value, Mapping):
        return ", ".join(f"{key}: {_shown('', item)}" for key, item in value.items())
    return listed(value) if isinstance(value, list | tuple) else str(value)


def where(path: tuple[str | int, ...]) -> str:
    """A key path as text, indices counting from one.

    >>> where(("shaft", 0, "throw", 2, "radius")), where(("provenance", "cylinder.bore"))
    ('shaft[1].throw[3].radius', 'provenance."cylinder.bore"')
    """
    text = ""
    for key in path:
        text += f"[{key + 1}]" if isinstance(key, int) else f"{'.' if text else ''}{_key(key)}"
    return text or _("the file")


def _key(key: str) -> str:
    r"""A key as TOML writes it: quoted where it holds anything but letters, digits, - and _.

    >>> print(_key("bore"), _key("cylinder.bore"), _key('5"\a'))
    bore "cylinder.bore" "5\"\u0007"
    """
    cut = one_line(key, longest=60) if len(key) > 60 else key
    if re.fullmatch(r"[A-Za-z0-9_-]+", key):
        return cut
    return f'"{"".join(map(_letter, cut))}"'


def _letter(letter: str) -> str:
    """A letter of a quoted key."""
    if letter in '"\\':
        return f"\\{letter}"
    if letter.isprintable():
        return letter
    if "\ud800" <= letter <= "\udfff":  # half a character, which TOML cannot write
        return "?"
    return f"\\u{ord(letter):04x}" if ord(letter) < 0x10000 else f"\\U{ord(letter):08x}"


def listed(values: Sequence[Any]) -> str:
    """Values with commas, the middle of a long row left out.

    >>> listed([1, 2, 4]), listed(range(100, 200))[-16:]
    ('1, 2, 4', '... (100 in all)')
    """
    texts = [_shown("", value) for value in values]
    if len(texts) > GREATEST_LISTED:
        shown = ", ".join(texts[: GREATEST_LISTED - 2])
        return _("{values}, ... ({count} in all)", values=shown, count=len(texts))
    return ", ".join(texts)
