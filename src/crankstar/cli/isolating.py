"""The verb isolate: the best mounts of an engine within limits."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

from crankstar.cli.options import (
    Json,
    Settings,
    engine_place,
    engine_with_tree,
    once,
    option,
    together,
    write_engine,
)
from crankstar.cli.output import display, progress, write
from crankstar.cli.tabulating import resting_on
from crankstar.language.messages import _
from crankstar.options import isolating as asked
from crankstar.options import values as request
from crankstar.options.ranges import speeds_of

if TYPE_CHECKING:
    from crankstar.engine.engine import Engine

HELP = "Name from the catalog, or engine file with [[mounts]]; - for standard input."


def isolate(
    engine: Annotated[str, Parameter(help=HELP)],
    /,
    *,
    minimise: Annotated[
        str,
        option(
            "--minimise",
            "force (on the ground), mounts (the forces of all) or velocity (of the point): the "
            "greatest over the speeds; each also with rms in front; or roll (what is not roll in "
            "the mode of roll).",
        ),
    ] = "force",
    stiffness: Annotated[str | None, option("--stiffness")] = None,
    shift: Annotated[str | None, option("--shift")] = None,
    sag: Annotated[str | None, option("--sag")] = None,
    frequencies: Annotated[str | None, option("--frequencies")] = None,
    point: Annotated[str | None, option("--point")] = None,
    speeds: Annotated[str | None, option("--speeds", "Default: those of the file.")] = None,
    at: Annotated[str | None, option("--at")] = None,
    starts: Annotated[int | None, option("--starts", "Default: 6.")] = None,
    settings: Settings = None,
    json: Json = False,
    output: Annotated[str | None, option("--output", "The engine on the best mounts.")] = None,
) -> None:
    """Find the stiffness and place of mounts, within limits, that pass on or shake least."""
    from crankstar.analyses.mounts.figures import on_mounts
    from crankstar.dynamics.mount_analysis import mounts as analysis
    from crankstar.remedy.isolation import STARTS, MountLimits, isolated
    from crankstar.search.interrupts import ended_once
    from crankstar.tables import machine
    from crankstar.tables.isolation import isolation_document
    from crankstar.tables.ranges import resting

    load = once(partial(_on_mounts, engine, settings))
    _place, (loaded, tree), aim, over, count, place, _checked, *free = together(
        partial(engine_place, output),  # before minutes are spent
        load,
        partial(asked.aim, minimise),
        partial(speeds_of, speeds, beside_speed=False),
        partial(request.within, "--starts", starts, most=asked.GREATEST_STARTS),
        lambda: request.block_point(at, load()[0]),
        partial(asked.refuse_unused, minimise, at=at, speeds=speeds, point=point),
        partial(asked.stiffness, stiffness),
        lambda: asked.shift(shift, load()[0]),
        lambda: request.length("--sag", sag, load()[0], positive=True),
        partial(asked.frequencies, frequencies),
    )
    limits = MountLimits(*free)
    how = {"point": point or "", "speeds": over, "at": place}
    with ended_once(), progress(_("Looking for the best mounts")) as tell:
        found = analysis(loaded, **how)
        best = isolated(
            loaded,
            found,
            aim=aim,
            limits=limits,
            starts=STARTS if count is None else count,
            tell=lambda done, of: tell(done, of, f"{done}/{of}"),
        )
        document = isolation_document(best, found, analysis(best.engine, **how), limits)
        answered = partial(on_mounts, best.engine, **how)
        document = resting(document, resting_on("json", best.engine, answered))
    if output is not None:
        write_engine(best.engine, tree, output)
    if json:
        write(machine.json_text(machine.tree(document)), None)
    else:
        display(document)


def _on_mounts(name: str, settings: list[str] | None) -> tuple[Engine, dict[str, Any]]:
    """The engine and the tree of its file. Raises MountError where it has no mounts."""
    from crankstar.dynamics.mounted_block import mounted_block

    loaded, tree = engine_with_tree(name, settings)
    mounted_block(loaded)
    return loaded, tree
