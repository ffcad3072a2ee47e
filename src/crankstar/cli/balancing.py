"""The verb that balances an engine: balance."""

from __future__ import annotations

from typing import Annotated

from crankstar.cli.application import app
from crankstar.cli.options import EngineName, Settings, Speed, flag, loaded_engine, output, text
from crankstar.cli.output import display, working, write
from crankstar.language.faults import EngineError
from crankstar.options import values as request
from crankstar.options.values import RequestError


@app.command
def balance(
    engine: EngineName,
    /,
    *,
    factor: Annotated[
        float | None,
        text(
            "Share of the reciprocating mass on each pin that is balanced, 0 to 1.5 (default: the "
            "file's, else 0.5)."
        ),
    ] = None,
    weights: Annotated[
        str,
        text(
            "Places of the counterweights: pins, webs, ends (the end webs), or positions along the "
            'shaft, such as "-200 mm, 200 mm".'
        ),
    ] = "pins",
    minimise: Annotated[
        str | None,
        text(
            "Instead of a factor, find the weights that minimise one of force, couple, pitch, yaw, "
            "each also with rms in front, or bearing (the greatest load on a main bearing).",
            "--minimise",
            "--minimize",
        ),
    ] = None,
    pitch_share: Annotated[
        float | None,
        text("With --minimise couple: weight of pitch, 0 to 1; yaw has the rest (default: equal)."),
    ] = None,
    limit: Annotated[
        list[str] | None,
        flag(
            "With --minimise: upper limit, such as couple=50% (of bare crankshafts), couple=1.5 "
            '(m r ω² a) or force="500 N"; repeatable.'
        ),
    ] = None,
    greatest_unbalance: Annotated[
        str | None, text('With --minimise: greatest unbalance of one weight, such as "0.02 kg*m".')
    ] = None,
    radius: Annotated[
        str | None,
        text(
            'Radius at which the masses of weights are given, such as "60 mm" (default: the '
            "crank radius)."
        ),
    ] = None,
    shafts: Annotated[
        str | None,
        text(
            "Add balance shafts: needed (the lowest order that remains; also without a value), all "
            '(first and second order), or speed ratios, such as -1 or "2, -2".'
        ),
    ] = None,
    shaft_planes: Annotated[
        str | None,
        text("Positions of the weights along the balance shafts (default: beyond both ends)."),
    ] = None,
    shaft_place: Annotated[
        str | None,
        text('Up and right of the crankshaft, such as "-60 mm, 0 mm" (default: on its axis).'),
    ] = None,
    shaft_spacing: Annotated[
        str | None,
        text(
            'Horizontal distance between the two shafts of a pair, such as "120 mm" (default: 0).'
        ),
    ] = None,
    level: Annotated[
        bool, flag("Move the two shafts of a pair to the heights at which the block does not roll.")
    ] = False,
    prove: Annotated[
        bool, flag("Print the exact weights and shafts and prove the cancellation.")
    ] = False,
    speed: Speed = None,
    settings: Settings = None,
    output: Annotated[
        str | None, output("File to write the balanced engine to, in the explicit form.")
    ] = None,
) -> None:
    """Balance an engine with counterweights and balance shafts; print what remains."""
    from crankstar.derive import DerivationError, documents
    from crankstar.files import engine_of, toml, tree_of
    from crankstar.options.balancing import BalanceOptions, BestOptions, ShaftOptions, balanced
    from crankstar.remedy import RemedyError
    from crankstar.tables.remedies import balancing_sheet

    options = BalanceOptions(
        factor,
        weights,
        BestOptions(minimise, pitch_share, tuple(limit or ()), greatest_unbalance),
        ShaftOptions(shafts, shaft_planes, shaft_place, shaft_spacing, level),
        radius,
        speed,
        request.own_factor(engine, settings, otherwise=0.5),
    )
    try:
        with working("balancing ..."):
            job = balanced(loaded_engine(engine, settings), options)
            proof = []
            if prove:  # exact algebra is slow to load
                from crankstar.derive.cure import proofs

                proof = proofs(job.before, job.after)
    except (RemedyError, DerivationError, EngineError) as error:
        raise RequestError(str(error)) from None
    sheet = balancing_sheet(job)
    if output is not None:
        content = toml(job.after)
        engine_of(tree_of(content, name=output), name=output)  # write only what can be read again
        write(content, output)
    display(sheet)
    if proof:
        display(documents.rendered(proof))
