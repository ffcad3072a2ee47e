"""The options that several verbs share, with their help, and the engine that they name.

An option means the same in every verb: each is drawn from the vocabulary by `option`.
"""

from __future__ import annotations

import shlex
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from pathlib import Path
from typing import Annotated, Any

from cyclopts import Parameter, Token

from crankstar.analysis.reader import Option
from crankstar.cli.output import complain, writable
from crankstar.engine.engine import Engine
from crankstar.engine.gas import LOADS
from crankstar.files import engine_of, keys_of
from crankstar.files.catalog import tree_of
from crankstar.language.messages import _
from crankstar.language.quoting import one_line, seen
from crankstar.mechanics.operating_points import operating_state
from crankstar.options import values as request
from crankstar.options.refusals import beside as beside
from crankstar.options.refusals import once as once  # with the options that they read
from crankstar.options.refusals import or_none as or_none
from crankstar.options.refusals import together as together
from crankstar.options.sources import Loaded, loaded
from crankstar.options.vocabulary import OPTIONS


def option(name: str, more: str = "", *, own: Option | None = None) -> Parameter:
    """An option of the vocabulary, or its `own` entry; `more` says how this verb uses it.

    A flag has no `--no-` form, text may begin with a minus sign, and a whole number is read here,
    since the parser itself would round 1.5.
    """
    entry = own or OPTIONS[name]
    takes = entry.takes
    return Parameter(
        name=[name, "-o"] if name == "--output" else name,
        help=f"{entry.meaning} {more}".rstrip(),
        negative=(),
        allow_leading_hyphen=takes == "text" and name != "--output",
        converter=whole if takes == "whole number" else None,
    )


def whole(_kind: object, tokens: Sequence[Token]) -> int:
    """A whole number. Raises ValueError."""
    try:
        return int(tokens[0].value)
    except ValueError:
        raise ValueError(f"unable to convert {seen(tokens[0].value)} into int") from None


ENGINE = "Name from the catalog, engine file, or - for standard input."
FLAT = Parameter(name="*", negative=(), allow_leading_hyphen=True, show_default=False)
"""A record of options, each of which is an option of the verb."""

EngineName = Annotated[str, Parameter(help=ENGINE)]
Speed = Annotated[str | None, option("--speed")]
Orders = Annotated[str | None, option("--orders", "Default: those up to 6 that occur.")]
ReferencePoint = Annotated[str | None, option("--reference")]
Theta = Annotated[str | None, option("--theta", "Also the sum of all orders there.")]
Beside = Annotated[list[str] | None, option("--beside")]
Output = Annotated[str | None, option("--output", "Default: standard output.")]
Settings = Annotated[list[str] | None, option("--set")]
Estimating = Annotated[bool, option("--estimate")]
Json = Annotated[bool, option("--json")]
Csv = Annotated[bool, option("--csv")]


@dataclass(frozen=True)
class Looks:
    """How a picture looks: its colours, its size and the size of its letters."""

    theme: Annotated[str | None, option("--theme")] = None
    width: Annotated[str | None, option("--width")] = None
    height: Annotated[str | None, option("--height")] = None
    dpi: Annotated[float | None, option("--dpi")] = None
    font_size: Annotated[str | None, option("--font-size")] = None

    def refuse(self, beside: str) -> None:
        """Refuse what is given beside something that is no picture. Raises RequestError."""
        given = {f"--{name.replace('_', '-')}": value for name, value in asdict(self).items()}
        request.refuse_unused(given, beside=beside)


def read_engine(
    name: str,
    settings: Sequence[str] | None = None,
    *,
    estimate: bool = False,
    speed: object = None,
    chains: bool = False,
    ranged: bool = True,
) -> Loaded:
    """The engine of a name or file with the values of --set, and with --estimate completed.

    But for the speed where a `speed` is asked for.

    With `chains` also a drive line; `ranged`: with its ranges. A name that is none is told beside a
    setting that cannot be read.
    """
    changes = beside(partial(request.settings, settings), partial(tree_of, name))
    found = loaded(name, changes, estimate=estimate, speed=speed, chains=chains, ranged=ranged)
    if estimate and not found.filled and isinstance(found.source, Engine):
        complain(_("--estimate changes nothing here: all that could be estimated is given."))
    return found


def engine_read(load: Callable[[], Loaded]) -> Engine | None:
    """The engine that is read, for what depends on it; None where it is refused, as is told."""
    return or_none(lambda: load().engine)


def mark_speed(speed: str | float | None, *engines: Engine) -> None:
    """Mark a speed that changes nothing: one of the engines has no masses or no sizes, and no gas.

    Its forces are then in its own m r w^2.
    """
    keys = {"mass": "cylinder.reciprocating_mass", "radius": "cylinder.stroke"}
    lacking = [
        key
        for scale, key in keys.items()
        if any(scale in engine.relative and engine.gas is None for engine in engines)
    ]
    if speed is not None and lacking:
        complain(
            _(
                "--speed changes nothing here: without {keys} the results are in m r ω².",
                keys=", ".join(lacking),
            )
        )


def mark_load(
    settings: Sequence[str] | None, engine: Engine, *, point: str, speed: float | None
) -> None:
    """Mark a load of the table [gas] that was set and does not count at the point or the speed."""
    keys = {".".join(map(str, keys_of(text.partition("=")[0]))) for text in settings or ()}
    unused = sorted(keys & {f"gas.{name}" for name in LOADS})
    shares = operating_state(engine, point=point, speed=speed).shares if unused else ()
    counting = [name for name, _share in shares]
    if counting and "" not in counting:
        complain(
            _(
                "--set {keys} changes nothing here: the load of the table [gas] does not count at "
                "the operating point {points}.",
                keys=", ".join(unused),
                points=", ".join(one_line(name) for name in counting),
            )
        )


def command_text(verb: str, engine: str, options: Mapping[str, Sequence[str] | None]) -> str:
    """A command line: each option with each of its values; a flag has one that is empty."""
    pairs = [(option, value) for option, values in options.items() for value in values or ()]
    return shlex.join(
        ["crankstar", verb, engine, *(word for pair in pairs for word in pair if word)]
    )


def written_tree(engine: Engine, tree: Mapping[str, Any] | None = None) -> dict[str, Any]:
    """The tree of an engine file for an engine.

    In the form of the file it came from, whose tree is given, where that can say it; else explicit.
    """
    from crankstar.files import explicit, rewritten

    own = None if tree is None else {**tree, "name": engine.name}  # at its place in the file
    return explicit(engine) if own is None else rewritten(own, engine)


def sheet_tree(
    name: str, settings: Sequence[str] | None, found: Loaded, *, estimate: bool = False
) -> dict[str, Any]:
    """The tree for a spreadsheet: that of the file, or the explicit form where values were set."""
    from crankstar.files import explicit
    from crankstar.files.read_files import STANDARD_INPUT

    as_read = not (settings or estimate or name == STANDARD_INPUT)
    return found.tree if as_read else explicit(found.engine)


def write_engine(
    engine: Engine, tree: Mapping[str, Any] | None, path: str | None, *, option: str = "-o"
) -> None:
    """Write an engine file in the form of its `tree`, or print it; `option` names the file."""
    write_tree(written_tree(engine, tree), path, option=option)


def engine_suffix(path: str | None, *, option: str = "-o") -> str:
    """How the name of an engine file ends, empty without one.

    Raises RequestError for others, OutputError where it cannot be written.
    """
    from crankstar.options.refusals import refusal

    suffix = "" if path is None else Path(path).suffix.lower()
    if suffix not in ("", ".toml", ".json", ".xlsx"):
        raise refusal(option, path, "the name must end in .toml, .json or .xlsx")
    if path is not None:
        writable(path, option=option)
    return suffix


def numbered(place: str, count: int) -> list[str]:
    """The name of a file, for several each with its number.

    >>> numbered("mine.toml", 1), numbered("mine.toml", 2)
    (['mine.toml'], ['mine-1.toml', 'mine-2.toml'])
    """
    if count == 1:
        return [place]
    path = Path(place)
    return [str(path.with_name(f"{path.stem}-{n}{path.suffix}")) for n in range(1, count + 1)]


def write_tree(tree: Mapping[str, Any], path: str | None, *, option: str = "-o") -> None:
    """Write an engine file as its name says: TOML, JSON or a spreadsheet; print it without a name.

    It is never written where it could not be read again. Raises RequestError for other names.
    """
    from crankstar.cli.output import write, write_bytes
    from crankstar.files import tree_of as tree_in
    from crankstar.files import tree_text
    from crankstar.options.forms import require

    suffix = engine_suffix(path, option=option)
    if suffix == ".xlsx" and path is not None:
        require("xlsx")
        from crankstar.files.sheets import sheets_of
        from crankstar.files.workbook import workbook_bytes, workbook_tree

        content = workbook_bytes(sheets_of(dict(tree)))
        engine_of(workbook_tree(content, path))
        write_bytes(content, path, option=option)
        return
    from crankstar.tables.machine import json_text

    text = json_text(tree) if suffix == ".json" else tree_text(dict(tree))
    engine_of(tree_in(text))
    write(text, path, option=option)
