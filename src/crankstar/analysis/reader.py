"""How one value of a question is read: its option, and what text or number may stand there."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import MISSING, dataclass, fields, replace
from typing import Any, Literal, NamedTuple, get_type_hints

from crankstar.language.messages import MessageError

Takes = Literal["nothing", "text", "several texts", "whole number", "number"]
"""What follows an option. `several texts`: it may be repeated."""


class Option(NamedTuple):
    """What an option takes, what it means, and other names under which people look for it."""

    takes: Takes
    meaning: str
    also: tuple[str, ...] = ()


@dataclass(frozen=True)
class Reader:
    """The option of the vocabulary that gives a value, and what reads it where it is given.

    `read` refuses with a RequestError that names the option; it also takes the engine where the
    value depends on it (`of_source`), as places do, and by name the values of other fields on which
    it depends (`beside`). `more` is how one analysis uses the option, as a sentence of the catalog
    of messages. `number` checks what a Python function is given that is no text, in SI units, and
    takes what `read` takes; without it such a value is written as text. Without hyphens the option
    is the name of a word that follows the engine (`follows`), has no default, and `more` is what it
    means. `own` is what the option takes and means where the vocabulary has none of that name, as
    the option of another package.

    >>> percent = Reader("--factor", lambda text: float(text.rstrip("%")) / 100)
    >>> percent.read("52%"), percent.saying("Default: that of the file.").more
    (0.52, 'Default: that of the file.')
    """

    option: str
    read: Callable[..., Any]
    more: str = ""
    of_source: bool = False
    beside: tuple[str, ...] = ()
    number: Callable[..., Any] | None = None
    own: Option | None = None

    @property
    def follows(self) -> bool:
        """Whether it reads a word that follows the engine, of no option.

        >>> Reader("measured", str).follows, Reader("--speed", float).follows
        (True, False)
        """
        return not self.option.startswith("-")

    def saying(self, more: str) -> Reader:
        """The same, with how an analysis uses it."""
        return replace(self, more=more)


class Asked(NamedTuple):
    """A field of a question: its name, what reads it, and its value where nothing is given."""

    name: str
    reader: Reader
    default: Any


def asked(question: type[Any]) -> tuple[Asked, ...]:
    """The fields of a question in their order; each is annotated with its Reader.

    Those that follow the engine are the first.

    >>> from crankstar.analysis.registry import analysis
    >>> [each.reader.option for each in asked(analysis("mounts").question.value)]
    ['--point', '--speed', '--speeds', '--at', '--orders']
    """
    hints = get_type_hints(question, include_extras=True)
    out: list[Asked] = []
    for field in fields(question):
        reader = next(each for each in hints[field.name].__metadata__ if isinstance(each, Reader))
        if field.default is MISSING and not reader.follows:
            raise TypeError(f"{question.__name__}.{field.name} has no default")
        out.append(Asked(field.name, reader, field.default))
    return tuple(sorted(out, key=lambda one: not one.reader.follows))


def readings(
    question: type[Any], given: Mapping[str, Any], source: Callable[[], Any]
) -> dict[str, Callable[[], Any]]:
    """What reads each field of a question: all are called, so that every refusal is told at once.

    `given` are texts and numbers by field, None where there is none; `source` gives the engine.
    """

    def reading(one: Asked) -> Callable[[], Any]:
        def read() -> Any:
            value = given.get(one.name)
            if value is None:
                return one.default
            engine = [source()] if one.reader.of_source else []
            return one.reader.read(
                value, *engine, **{name: out[name]() for name in one.reader.beside}
            )

        return read

    out = {one.name: reading(one) for one in asked(question)}
    return out


def being_read(question: type[Any], reading: Mapping[str, Callable[[], Any]]) -> Any:
    """A question whose fields are read when they are looked at.

    What does not go together is so refused next to fields that cannot be read: one that is looked
    at raises its own refusal.
    """

    class BeingRead(question):
        def __getattribute__(self, name: str) -> Any:
            return reading[name]() if name in reading else super().__getattribute__(name)

    return object.__new__(BeingRead)


def is_given(question: Any, name: str) -> bool:
    """Whether a field of a question, which may be being read, has a value, right or wrong."""
    try:
        return getattr(question, name) is not None
    except MessageError:
        return True
