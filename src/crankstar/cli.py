"""The command line: verbs only. Every verb reads engines, asks a function, prints what it gives."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from fractions import Fraction
from importlib.metadata import version
from typing import Annotated

from cyclopts import App, CycloptsError, Parameter, UnusedCliTokensError

from crankstar import request
from crankstar.catalog import load
from crankstar.engine import Engine
from crankstar.files import STANDARD_INPUT, EngineFileError
from crankstar.output import OutputError, abandon, complain, display, is_file, terminal_width, working, write
from crankstar.quantity import one_line, seen
from crankstar.request import RequestError

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
    turning = request.speed(speed)
    point = request.reference(reference, loaded)
    if json or csv:
        result = balance(loaded, speed=loaded.speed if turning is None else turning, reference=point)
        wanted = request.orders(orders, result.force.orders.tolist())
        if csv:
            write(answer.csv_text(loaded.name, result, orders=wanted), output)
        else:
            write(answer.json_text(answer.tree(loaded.name, result, orders=wanted)), output)
        return
    from crankstar.tables import analysis, report

    shown = analysis(loaded, speed=turning, reference=point)
    wanted = request.orders(orders, shown.normalised.force.orders.tolist())
    shown = shown._replace(orders=tuple(wanted), turning=tuple(wanted)) if wanted else shown
    display(
        report(shown, wide=output is not None or terminal_width() >= WIDE, angles=request.angles(at), by=request.grouping(by)),
        output,
    )


@app.command
def compare(
    first: EngineName, second: EngineName, /, *others: EngineName, speed: Speed = None, orders: Orders = None, output: Output = None
) -> None:
    """Several engines side by side: the greatest force, couple and roll of each order."""
    from crankstar.tables import analysis, comparison

    at = request.speed(speed)
    shown = [analysis(_loaded(name, None), speed=at) for name in (first, second, *others)]
    wanted = request.orders(orders, shown[0].normalised.force.orders.tolist())
    display(comparison([one._replace(orders=tuple(wanted), turning=tuple(wanted)) for one in shown] if wanted else shown), output)


@app.command
def derive(
    engine: EngineName,
    /,
    *,
    order: Annotated[
        str | None,
        Parameter(name=["--order", "--orders"], allow_leading_hyphen=True, help="crank orders, as in 2 or 1,2,4; all is 1,2,4,6"),
    ] = None,
    quantity: Annotated[str | None, Parameter(help="force or couple; else both")] = None,
    form: Annotated[str, Parameter(name="--format", help="text, latex, markdown or html")] = "text",
    notation: Annotated[
        str | None, Parameter(help="letters: crankstar (r, l, λ = r/l), stroke (S, L = l/S) or sinitsyn (P_R, C_I, C_II, l0)")
    ] = None,
    power: Annotated[int | None, Parameter(help="highest power of λ in the series of each harmonic, else 7")] = None,
    symbolic: Annotated[
        str | None,
        Parameter(help="leave a dimension open: alpha (half the bank angle), phi (crank phase of a twin), n (cylinders in a row)"),
    ] = None,
    signs: Annotated[bool, Parameter(help="the six signs of balance instead: P_R, M_R, P_I, M_I, P_II, M_II", negative=())] = False,
    speed: Speed = None,
    reference: ReferencePoint = None,
    settings: Settings = None,
    output: Output = None,
) -> None:
    """Derive the closed form of each order, step by step, exactly: from one cylinder to the resultant."""
    from crankstar import derive as exact
    from crankstar.derive import documents, notations

    loaded = _loaded(engine, settings)
    turning = request.speed(speed)
    point = request.reference(reference, loaded)
    forms = ["text", *documents.FORMATS]
    if form not in forms:
        raise RequestError(f"--format {one_line(form)}: it can be {', '.join(forms)}")
    if power is not None and not 1 <= power <= 24:
        raise RequestError(f"--power {power}: give a power of λ from 1 to 24")
    given = {"--order": order, "--quantity": quantity, "--power": power, "--speed": speed, "--reference": reference}
    if signs:
        request.alone("--signs", {**given, "--reference": None, "--symbolic": symbolic})
    elif symbolic is not None:
        request.alone("--symbolic", {**given, "--order": None, "--quantity": None})
    wanted: list[tuple[Fraction, request.Derived]] = [
        (one, kind) for one in request.derived_orders("1,2" if order is None else order) for kind in request.quantities(quantity)
    ]
    try:
        letters = notations.chosen(("sinitsyn" if signs else "crankstar") if notation is None else notation)
        with working("deriving ...") as tell:
            chapters = [exact.signs_chapter(loaded, reference=point)] if signs else []
            for one, kind in [] if signs else wanted:
                tell(f"deriving the {kind} of order {one} ...")
                if symbolic is not None:
                    chapters.append(exact.family(loaded, one, kind, symbol=symbolic))
                else:
                    chapters.append(exact.derivation(loaded, one, kind, reference=point, speed=turning, power=power or 7).chapter)
    except exact.DerivationError as error:
        raise RequestError(str(error)) from None
    if form == "text":
        display(documents.rendered(chapters, letters), output)
    else:
        write(documents.FORMATS[form](chapters, letters), output)


@app.command(name="balance")
def balanced(
    engine: EngineName,
    /,
    *,
    factor: Annotated[
        float, Parameter(help="share of all the reciprocating mass on each pin, 0 to 1.5", allow_leading_hyphen=True)
    ] = 0.5,
    planes: Annotated[
        str | None,
        Parameter(
            help='places of the weights along the shaft, as in "-200 mm, 200 mm"; else opposite each pin', allow_leading_hyphen=True
        ),
    ] = None,
    shafts: Annotated[
        str | None, Parameter(help='also balance shafts of these speed ratios, as in -1 or "2, -2"', allow_leading_hyphen=True)
    ] = None,
    settings: Settings = None,
    output: Annotated[
        str | None, Parameter(name=["--output", "-o"], help="also write the balanced engine, in the explicit form")
    ] = None,
) -> None:
    """Balance the crankshaft: bobweights, counterweights, and what they leave of the first order."""
    from crankstar.files import toml
    from crankstar.remedy import RemedyError, end_planes, with_balance_shaft, with_counterweights
    from crankstar.workshop import balance_card

    loaded = _loaded(engine, settings)
    try:
        places = request.planes(planes, loaded)
        better = with_counterweights(loaded, factor=factor, planes=places)
        for ratio in request.ratios(shafts):
            better = with_balance_shaft(better, ratio=ratio, planes=end_planes(loaded) if places is None else places)
    except RemedyError as error:
        raise RequestError(str(error)) from None
    if output is not None:
        write(toml(better), output)
    display(balance_card(loaded, better, factor))


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
    from crankstar.answer import json_text
    from crankstar.files import schema as file_schema

    write(json_text(file_schema()), output)


@app.command
def errata(
    *,
    source: Annotated[str | None, Parameter(help="only of this source: its key in the references, such as yamamoto2012")] = None,
    output: Output = None,
) -> None:
    """What the sources got wrong: each printed formula beside the true one."""
    from crankstar.errata import ErrataError
    from crankstar.errata import errata as found
    from crankstar.misprints import errata_tables

    try:
        wanted = found(source)
    except ErrataError as error:
        raise RequestError(f"--source {one_line(source or '')}: {error}") from None
    display(errata_tables(wanted), output)


def _loaded(name: str, settings: list[str] | None) -> Engine:
    return load(name, changes=dict(request.setting(text) for text in settings or []))
