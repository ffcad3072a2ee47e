"""Verbs that make or judge files: balance, check, new, schema."""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

from crankstar import request
from crankstar.catalog import load
from crankstar.cli.application import app
from crankstar.cli.options import EngineName, Output, Settings, Speed, loaded_engine
from crankstar.files import STANDARD_INPUT, EngineFileError
from crankstar.output import complain, display, is_file, working, write
from crankstar.quantity import one_line, seen
from crankstar.request import RequestError


@app.command(name="balance")
def balanced(
    engine: EngineName,
    /,
    *,
    factor: Annotated[
        float | None,
        Parameter(
            help="share of all the reciprocating mass on each pin, 0 to 1.5; else that of the file, else 0.5",
            allow_leading_hyphen=True,
        ),
    ] = None,
    weights: Annotated[
        str,
        Parameter(
            help='where the counterweights go: pins, webs, ends (the end webs), or places along the shaft as in "-200 mm, 200 mm"',
            allow_leading_hyphen=True,
        ),
    ] = "pins",
    least: Annotated[
        str | None,
        Parameter(
            help="best weights instead of a factor: what they make least, one of force, couple, rms force, rms couple, pitch, yaw, "
            "rms pitch, rms yaw, bearing (load on a main bearing)"
        ),
    ] = None,
    pitch: Annotated[
        float | None, Parameter(help="with --least couple: how much pitch counts, 0 to 1; yaw counts the rest")
    ] = None,
    limit: Annotated[
        list[str] | None,
        Parameter(
            help="with --least: what may at most be left, as in couple=50% (of bare), couple=1.5 (m r ω² a), force='500 N'",
            negative=(),
        ),
    ] = None,
    most_unbalance: Annotated[
        str | None, Parameter(help='with --least: the greatest unbalance of one weight, as in "0.02 kg*m"')
    ] = None,
    radius: Annotated[
        str | None, Parameter(help='radius at which weights are told as masses, as in "60 mm"; else the crank radius')
    ] = None,
    shafts: Annotated[
        str | None,
        Parameter(
            help="also balance shafts: alone, those of the lowest order that is left; all, of the first and second order; or of "
            'these speed ratios, as in -1 or "2, -2"',
            allow_leading_hyphen=True,
        ),
    ] = None,
    shaft_planes: Annotated[
        str | None, Parameter(help="places of their weights along them; else beyond both ends", allow_leading_hyphen=True)
    ] = None,
    shaft_place: Annotated[
        str | None,
        Parameter(help='where they lie, up and right of the crankshaft, as in "-60 mm, 0 mm"', allow_leading_hyphen=True),
    ] = None,
    apart: Annotated[
        str | None, Parameter(help='how far the two shafts of a pair lie apart, left and right, as in "120 mm"')
    ] = None,
    level: Annotated[
        bool, Parameter(help="move the two shafts of a pair to the heights at which the block does not roll", negative=())
    ] = False,
    prove: Annotated[
        bool, Parameter(help="also the exact weights and shafts, with the proof that what they take away is zero", negative=())
    ] = False,
    speed: Speed = None,
    settings: Settings = None,
    output: Annotated[
        str | None, Parameter(name=["--output", "-o"], help="also write the balanced engine, in the explicit form")
    ] = None,
) -> None:
    """Balance the crankshaft: bobweights, counterweights, balance shafts, and what they leave."""
    from crankstar import fitting
    from crankstar.derive import DerivationError, documents
    from crankstar.files import engine_of, toml, tree_of
    from crankstar.remedy import RemedyError
    from crankstar.workshop import Job, balance_card

    loaded = loaded_engine(engine, settings)
    only_best = {"--pitch": pitch, "--limit": limit, "--most-unbalance": most_unbalance}
    request.alone("a balance factor" if least is None else "--least", only_best if least is None else {"--factor": factor})
    only_shafts = {"--shaft-planes": shaft_planes, "--shaft-place": shaft_place, "--apart": apart, "--level": level or None}
    if shafts is None:
        request.alone("a balance without --shafts", only_shafts)
    at = request.weights(weights, loaded)
    told = request.length("--radius", radius, loaded, positive=True)
    turning = loaded.speed if speed is None else request.speed(speed)
    try:
        with working("balancing ..."):
            if least is None:
                share = request.own_factor(engine, settings, otherwise=0.5) if factor is None else factor
                job = Job(loaded, fitting.by_factor(loaded, factor=share, weights=at), share, radius=told)
            else:
                best = fitting.best(
                    loaded,
                    weights=at,
                    aim=request.aim("--least", least, pitch=pitch),
                    limits=request.limits(limit, loaded, speed=turning),
                    greatest_unbalance=request.unbalance("--most-unbalance", most_unbalance, loaded),
                )
                job = Job(loaded, best.engine, None, best, told)
            if shafts is not None:
                placed = request.shaft_places(loaded, planes_text=shaft_planes, place=shaft_place, apart=apart)
                job = job._replace(after=fitting.with_shafts(job.after, ratios=request.ratios(shafts), places=placed, level=level))
            proof = fitting.proofs(job.before, job.after) if prove else []
    except (RemedyError, DerivationError) as error:
        raise RequestError(str(error)) from None
    card = balance_card(job._replace(speed=turning))
    if output is not None:
        text = toml(job.after)
        engine_of(tree_of(text, name=output), name=output)  # never written where it could not be read again
        write(text, output)
    display(card)
    if proof:
        display(documents.rendered(proof))


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
