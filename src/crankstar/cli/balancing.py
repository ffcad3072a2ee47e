"""The verb that balances an engine: balance."""

from __future__ import annotations

from contextlib import nullcontext
from dataclasses import replace
from functools import partial
from typing import Annotated

from crankstar.cli.options import (
    FLAT,
    EngineName,
    Estimating,
    Settings,
    Speed,
    command_text,
    engine_suffix,
    mark_speed,
    once,
    option,
    read_engine,
    together,
    write_engine,
)
from crankstar.cli.output import complain, display, working
from crankstar.cli.tabulating import resting_on
from crankstar.engine.copies import with_values
from crankstar.language.messages import _
from crankstar.options.balancing import BalanceOptions


def balance(
    engine: EngineName,
    /,
    *,
    options: Annotated[BalanceOptions, FLAT] = BalanceOptions(),  # noqa: B008  # it is frozen
    prove: Annotated[bool, option("--prove")] = False,
    speed: Speed = None,
    settings: Settings = None,
    estimate: Estimating = False,
    output: Annotated[str | None, option("--output", "The balanced engine.")] = None,
) -> None:
    """Balance an engine with counterweights and balance shafts; print what remains."""
    from crankstar.analysis.document import remarks
    from crankstar.derive import documents
    from crankstar.language.alike import refusals_marked
    from crankstar.mechanics.remains import OPTIMISED
    from crankstar.options.balancing import balanced, new_name, readings
    from crankstar.remedy import needs
    from crankstar.tables import remedies
    from crankstar.tables.ranges import ranged, resting

    load = once(partial(read_engine, engine, settings, estimate=estimate, speed=speed))
    found, *_read = together(
        load, partial(engine_suffix, output), *readings(options, lambda: load().engine, speed=speed)
    )
    loaded, spread, own = found.engine, found.spread, found.balance_factor
    mark_speed(speed, loaded)
    with working(_("balancing ...")):
        with refusals_marked() if spread else nullcontext():
            job = balanced(loaded, options, speed=speed, own_factor=own)
        make = partial(balanced, options=options, speed=speed, own_factor=own, like=job)
        sheet = ranged(lambda each: remedies.balancing_sheet(make(each)), spread, loaded)
        answered = partial(remedies.resting, job)
        document = resting(sheet, resting_on("txt", job.after, answered))
        proof = []
        if prove:  # exact algebra is slow to load
            from crankstar.derive.cure import proofs

            proof = proofs(job.before, job.after)
            if not proof:
                complain(_("--prove changes nothing here: there is no equation to prove."))
        if options.bare and not any(shaft.weights for shaft in loaded.shafts if shaft.throws):
            complain(_("--bare changes nothing here: the crankshafts of the file have no weights."))
    if options.recommended and needs(job.after, zero=OPTIMISED):
        command = command_text("balance", engine, {"--set": settings})
        flags = {"--estimate": estimate, "--bare": options.bare}
        words = [command, *(name for name, given in flags.items() if given), "--recommended"]
        how = _("To fit these too: {command}", command=" ".join([*words, "--shafts all"]))
        document = replace(document, parts=(*document.parts, *remarks(how)))
    if spread is not None and job.sized:
        document = replace(
            document, parts=(*document.parts, *remarks(_(remedies.SIZED), kind="note"))
        )
    if output is not None:
        write_engine(with_values(job.after, name=new_name(job, options)), found.tree, output)
    display(document)
    if proof:
        display(documents.rendered(proof))
