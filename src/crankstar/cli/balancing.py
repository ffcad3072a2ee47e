"""The verb that balances an engine: balance."""

from __future__ import annotations

from functools import partial
from typing import Annotated

from crankstar.cli.application import app
from crankstar.cli.options import (
    FLAT,
    EngineName,
    Settings,
    Speed,
    engine_with_tree,
    option,
    together,
    write_engine,
)
from crankstar.cli.output import display, working
from crankstar.engine.copies import with_values
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.balancing import BalanceOptions


@app.command
def balance(
    engine: EngineName,
    /,
    *,
    options: Annotated[BalanceOptions, FLAT] = BalanceOptions(),  # noqa: B008  # it is frozen
    prove: Annotated[bool, option("--prove")] = False,
    speed: Speed = None,
    settings: Settings = None,
    output: Annotated[str | None, option("--output", "The balanced engine.")] = None,
) -> None:
    """Balance an engine with counterweights and balance shafts; print what remains."""
    from crankstar.derive import documents
    from crankstar.options.balancing import balanced, new_name
    from crankstar.tables.remedies import balancing_sheet

    own, (loaded, tree), _turning = together(
        partial(request.own_factor, engine, settings, otherwise=0.5),
        partial(engine_with_tree, engine, settings),
        partial(request.speed, speed),
    )
    with working(_("balancing ...")):
        job = balanced(loaded, options, speed=speed, own_factor=own)
        proof = []
        if prove:  # exact algebra is slow to load
            from crankstar.derive.cure import proofs

            proof = proofs(job.before, job.after)
    if output is not None:
        write_engine(with_values(job.after, name=new_name(job, options)), tree, output)
    display(balancing_sheet(job))
    if proof:
        display(documents.rendered(proof))
