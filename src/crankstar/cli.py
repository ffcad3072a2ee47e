"""The command line: verbs only. Every verb reads engines, asks a function, prints what it gives."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from importlib.metadata import version
from math import isfinite
from typing import Annotated, Any

from cyclopts import App, CycloptsError, Parameter, UnusedCliTokensError

from crankstar.catalog import load
from crankstar.engine import Engine
from crankstar.files import STANDARD_INPUT, EngineFileError
from crankstar.mechanism import Reference
from crankstar.output import OutputError, abandon, complain, display, is_file, terminal_width, write
from crankstar.quantity import one_line, seen

app = App(
    name="crankstar",
    help="How a piston engine shakes, why, and what to do about it. ENGINE is a name from the catalog or a file in TOML or "
    "JSON; - reads standard input.",
    version=lambda: version("crankstar"),
    help_format="plaintext",
    result_action="return_value",
    suppress_keyboard_interrupt=False,
)
app.register_install_completion_command(help="Install completion of commands and options for this shell.")


WIDE = 92
"""Columns from which a table shows everything."""


class RequestError(ValueError):
    """A request that cannot be met, as one sentence that says what would be right."""


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line and leave the process: 0 done, 2 a bad request or file, 130 interrupted."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")  # pyright: ignore[reportAttributeAccessIssue]
    try:
        code = app(_spelt_out(sys.argv[1:] if arguments is None else arguments), exit_on_error=False, print_error=False) or 0
        if sys.stdout is not None:
            sys.stdout.flush()
    except CycloptsError as error:
        code = _refuse(_told(error))
    except (RequestError, OutputError, EngineFileError) as error:
        code = _refuse(str(error))
    except (BrokenPipeError, SystemExit):  # the latter is how rich says it
        code = 0  # the reader of the pipe has what it wanted
    except OSError as error:
        place = "standard output" if error.filename is None else one_line(str(error.filename))
        code = _refuse(f"{place}: cannot be written ({error.strerror or error}); make room, or name another file with -o")
    except MemoryError:
        code = _refuse("there is not enough memory for this engine; take fewer cylinders, or longer rods")
    except KeyboardInterrupt:
        code = 130
    abandon()
    sys.exit(code)


def _spelt_out(arguments: Sequence[str]) -> list[str]:
    """Arguments with the lone hyphen as a file name; the parser would take it for an option."""
    pairs = zip(["", *arguments], arguments, strict=False)
    named = {"-o": "/dev/stdout", "--output": "/dev/stdout"}
    return [named.get(before, STANDARD_INPUT) if word == "-" else word for before, word in pairs]


def _told(error: CycloptsError) -> str:
    """What is wrong with the words of a command line, and where to read on."""
    text = one_line(str(error).strip(), longest=300)
    text = text.replace("into int", "into a whole number").replace("into bool", "into yes or no")
    if isinstance(error, UnusedCliTokensError):
        text = f"too many arguments: {', '.join(map(seen, error.unused_tokens or ()))}"
    command = " ".join(["crankstar", *(error.command_chain or ())])
    return f"{text}\nSee: {command} --help"


def _refuse(message: str) -> int:
    complain(f"crankstar: {message}")
    return 2


EngineName = Annotated[str, Parameter(help="a name from the catalog, a file, or - for standard input")]
Speed = Annotated[
    str | None,
    Parameter(
        name="--speed", allow_leading_hyphen=True, help='crank speed with its unit, as in "6000 rpm"; else the speed in the file'
    ),
]
Orders = Annotated[
    str | None,
    Parameter(name="--orders", allow_leading_hyphen=True, help="crank orders, as in 1,2,4,6 or all; else those up to 6 that occur"),
]
ReferencePoint = Annotated[
    str | None,
    Parameter(
        name="--reference",
        allow_leading_hyphen=True,
        help='point for couples and rolls: z, or z, up and right, as in "-120 mm" or "0 mm, 35 mm, 0 mm"; z as in crankstar show '
        "(else the middle of the cylinders' span, on the crank axis)",
    ),
]
Angles = Annotated[
    str | None,
    Parameter(name="--at", allow_leading_hyphen=True, help='also all orders together at these crank angles, as in "0 deg, 90 deg"'),
]
Output = Annotated[
    str | None, Parameter(name=["--output", "-o"], help="write to this file instead; it is replaced only when all went well")
]
Settings = Annotated[
    list[str] | None,
    Parameter(
        name="--set",
        help='change a value of the file, as in --set layout.bore_pitch="100 mm" --set balance_factor=0.5',
        negative=(),
    ),
]


@app.command(name="list")
def list_engines(
    *,
    cylinders: Annotated[int | None, Parameter(help="only engines with so many cylinders")] = None,
    layout: Annotated[
        str | None, Parameter(help="only engines of this layout: inline, vee, boxer, tandem, opposed, radial, explicit")
    ] = None,
) -> None:
    """List the engines of the catalog."""
    from crankstar.catalog import summaries
    from crankstar.description import catalog_table

    rows = summaries()
    kinds = sorted({row.layout for row in rows})
    if layout is not None and layout not in kinds:
        raise RequestError(f"--layout {one_line(layout)}: there is no such layout in the catalog; there are: {', '.join(kinds)}")
    found = [row for row in rows if cylinders in (None, row.cylinders) and layout in (None, row.layout)]
    if not found:
        raise RequestError("no engine of the catalog is like that; `crankstar list` shows all")
    display(catalog_table(found))


@app.command
def show(
    engine: EngineName,
    /,
    *,
    explicit: Annotated[bool, Parameter(help="as a complete engine file in the explicit form", negative=())] = False,
    settings: Settings = None,
    output: Output = None,
) -> None:
    """Show an engine: throws, cylinders, dead centres, firing, and where each value comes from."""
    from crankstar.description import description
    from crankstar.files import toml

    loaded = _loaded(engine, settings)
    if explicit:
        write(toml(loaded), output)
    else:
        display(description(loaded), output)


@app.command
def analyze(
    engine: EngineName,
    /,
    *,
    speed: Speed = None,
    orders: Orders = None,
    reference: ReferencePoint = None,
    settings: Settings = None,
    at: Angles = None,
    by: Annotated[str | None, Parameter(help="also the share of each: cylinder, bank, shaft or kind (of part)")] = None,
    json: Annotated[bool, Parameter(help="the machine-readable answer, one object", negative=())] = False,
    csv: Annotated[bool, Parameter(help="the same numbers, a row per order", negative=())] = False,
    output: Output = None,
) -> None:
    """Inertia forces, couples and rolling moments of an engine, order by order."""
    from crankstar import answer
    from crankstar.balance import balance

    if json and csv:
        raise RequestError("--json and --csv: ask for one of them")
    if (json or csv) and (at or by):
        raise RequestError("--at and --by belong to the printed tables; leave them out with --json and --csv")
    loaded = _loaded(engine, settings)
    turning = _speed(speed)
    point = _reference(reference, loaded)
    if json or csv:
        result = balance(loaded, speed=loaded.speed if turning is None else turning, reference=point)
        wanted = _orders(orders, result.force.orders.tolist())
        if csv:
            write(answer.csv_text(loaded.name, result, orders=wanted), output)
        else:
            write(_json(answer.tree(loaded.name, result, orders=wanted)), output)
        return
    from crankstar.tables import analysis, report

    shown = analysis(loaded, speed=turning, reference=point)
    wanted = _orders(orders, shown.normalised.force.orders.tolist())
    shown = shown._replace(orders=tuple(wanted), turning=tuple(wanted)) if wanted else shown
    display(report(shown, wide=output is not None or terminal_width() >= WIDE, angles=_angles(at), by=_grouping(by)), output)


@app.command
def compare(
    first: EngineName, second: EngineName, /, *others: EngineName, speed: Speed = None, orders: Orders = None, output: Output = None
) -> None:
    """Several engines side by side: the greatest force, couple and roll of each order."""
    from crankstar.tables import analysis, comparison

    at = _speed(speed)
    shown = [analysis(_loaded(name, None), speed=at) for name in (first, second, *others)]
    wanted = _orders(orders, shown[0].normalised.force.orders.tolist())
    display(comparison([one._replace(orders=tuple(wanted), turning=tuple(wanted)) for one in shown] if wanted else shown), output)


@app.command
def check(*files: Annotated[str, Parameter(help="engine files, or names from the catalog")]) -> int:
    """Check engine files: every mistake in each, in one go."""
    from rich.text import Text

    from crankstar.firing import firing
    from crankstar.wording import firing_sentence

    if not files:
        raise RequestError("check: name at least one engine file")
    failed = 0
    for name in files:
        try:
            loaded = load(name)
        except EngineFileError as error:
            failed += 1
            complain(str(error))
        else:
            count = len(loaded.cylinders)
            shown = "standard input" if name == STANDARD_INPUT else one_line(name)
            fires = f"; {firing_sentence(firing(loaded))}" if loaded.firing_order else ""
            display(Text(f"{shown}: good ({loaded.name}, {count} piston{'s' if count > 1 else ''}{fires})"))
    return 2 if failed else 0


@app.command
def new(
    layout: Annotated[str, Parameter(help="inline, vee, boxer, tandem, opposed, radial or explicit")],
    /,
    *,
    output: Output = None,
    force: Annotated[bool, Parameter(help="overwrite a file that is there", negative=())] = False,
) -> None:
    """Write a commented engine file to begin with."""
    from crankstar.files.starters import STARTERS

    if layout not in STARTERS:
        raise RequestError(f"there is no layout {seen(layout)}; there are: {', '.join(STARTERS)}")
    if output is not None and not force and is_file(output):
        raise RequestError(f"{one_line(output)}: is there already; --force overwrites it")
    write(STARTERS[layout], output)


@app.command
def schema(*, output: Output = None) -> None:
    """Print the JSON Schema of engine files; editors complete and check with it."""
    from crankstar.files import schema as file_schema

    write(_json(file_schema()), output)


def _loaded(name: str, settings: list[str] | None) -> Engine:
    return load(name, changes=dict(_setting(text) for text in settings or []))


def _setting(text: str) -> tuple[str, Any]:
    """A --set argument: a key path and a value, which is TOML where it can be read so, else text."""
    import tomllib

    path, equals, value = text.partition("=")
    if not equals or not path.strip():
        raise RequestError(f'--set {one_line(text)}: give a key path and a value, as in --set layout.bore_pitch="100 mm"')
    try:
        return path.strip(), tomllib.loads(f"value = {value}")["value"]
    except (ValueError, RecursionError):  # not TOML, or a number of thousands of digits
        return path.strip(), value


def _speed(text: str | None) -> float | None:
    from crankstar import units
    from crankstar.quantity import SPEED

    if text is None:
        return None
    try:
        speed = units.si(text, SPEED)
    except ValueError as error:
        raise RequestError(f"--speed: {error}") from None
    if speed <= 0:
        raise RequestError(f'--speed: is {seen(text)}; it must be greater than 0, such as "{SPEED.example}"')
    return speed


def _orders(text: str | None, present: list[float]) -> list[float] | None:
    if text is None:
        return None
    if text.strip() == "all":
        return present
    try:
        wanted = [float(part) for part in text.split(",") if part.strip()]
    except ValueError:
        wanted = []
    if not wanted or not all(isfinite(order) and 0 < order <= 1000 for order in wanted) or len(wanted) > 200:
        raise RequestError(f"--orders {one_line(text)}: give numbers from above 0 up to 1000 with commas, as in 1,2,4,6, or all")
    return list(dict.fromkeys(wanted))


def _angles(text: str | None) -> list[float]:
    from crankstar import units
    from crankstar.quantity import ANGLE

    try:
        return [units.si(part.strip(), ANGLE) for part in (text or "").split(",") if part.strip()]
    except ValueError as error:
        raise RequestError(f"--at: {error}") from None


def _grouping(text: str | None) -> Any:
    from typing import get_args

    from crankstar.balance import Grouping

    if text is not None and text not in get_args(Grouping):
        raise RequestError(f"--by {one_line(text)}: it can be {', '.join(get_args(Grouping))}")
    return text


def _reference(text: str | None, engine: Engine) -> Reference | None:
    from crankstar import units
    from crankstar.quantity import LENGTH, POSITION

    if text is None:
        return None
    parts = [part.strip() for part in text.split(",")]
    example = 'as in "-120 mm" (z) or "0 mm, 35 mm, 0 mm" (z, up, right)'
    if len(parts) not in (1, 3):
        raise RequestError(f"--reference {one_line(text)}: give z, or z, up and right, {example}")
    read = units.reader(frozenset(engine.relative))
    marks = [POSITION, LENGTH, LENGTH]
    for part, mark in zip(parts, marks, strict=False):
        if units.is_bare(part) and not mark.relative_to & frozenset(engine.relative):
            raise RequestError(f"--reference {one_line(text)}: {one_line(part)} has no unit; write it with one, {example}")
    try:
        return Reference(*(read(part, mark) for part, mark in zip(parts, marks, strict=False)))
    except ValueError as error:
        raise RequestError(f"--reference: {error}, {example}") from None


def _json(tree: dict[str, Any]) -> str:
    import json
    import re

    text = json.dumps(tree, indent=1, ensure_ascii=False, allow_nan=False)
    # A pair of numbers on one line. A raw line break cannot stand inside a string, so no name is touched.
    return re.sub(r"\[\n\s+([-+.\de]+),\n\s+([-+.\de]+)\n\s+\]", r"[\1, \2]", text) + "\n"
