"""Verbs that make or judge files: balance, check, new, schema."""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

from crankstar import request
from crankstar.catalog import load
from crankstar.cli.application import app
from crankstar.cli.options import EngineName, Output, Settings, loaded_engine
from crankstar.files import STANDARD_INPUT, EngineFileError
from crankstar.output import complain, display, is_file, write
from crankstar.quantity import one_line, seen
from crankstar.request import RequestError


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

    loaded = loaded_engine(engine, settings)
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
