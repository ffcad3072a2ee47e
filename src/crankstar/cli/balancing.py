"""The verb that balances an engine: balance."""

from __future__ import annotations

from functools import partial
from typing import Annotated, cast

from cyclopts import Parameter

from crankstar.cli.application import app
from crankstar.cli.options import (
    FLAT,
    EngineName,
    Settings,
    Speed,
    engine_text,
    flag,
    loaded_engine,
    output,
    together,
)
from crankstar.cli.output import display, working, write
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.balancing import BalanceOptions


class Options(BalanceOptions):
    """The same options, one of them in both spellings."""

    minimise: Annotated[str | None, Parameter(alias="--minimize")] = cast(
        "str | None", BalanceOptions.model_fields["minimise"]
    )


@app.command
def balance(
    engine: EngineName,
    /,
    *,
    options: Annotated[Options, FLAT] = Options(),  # noqa: B008  # it is frozen
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
    from crankstar.derive import documents
    from crankstar.options.balancing import balanced
    from crankstar.tables.remedies import balancing_sheet

    own, loaded, _turning = together(
        partial(request.own_factor, engine, settings, otherwise=0.5),
        partial(loaded_engine, engine, settings),
        partial(request.speed, speed),
    )
    with working(_("balancing ...")):
        job = balanced(loaded, options, speed=speed, own_factor=own)
        proof = []
        if prove:  # exact algebra is slow to load
            from crankstar.derive.cure import proofs

            proof = proofs(job.before, job.after)
    if output is not None:
        write(engine_text(job.after), output)
    display(balancing_sheet(job))
    if proof:
        display(documents.rendered(proof))
