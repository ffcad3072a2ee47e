"""The verb genset: how evenly a generating set runs, and several of them on one foundation."""

from __future__ import annotations

from functools import partial
from typing import TYPE_CHECKING, Annotated

from crankstar.cli.options import (
    Csv,
    EngineName,
    Estimating,
    Json,
    Output,
    Settings,
    Speed,
    loaded_values,
    option,
    together,
)
from crankstar.cli.output import working
from crankstar.cli.tabulating import give, resting_on, words_for
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.forms import TABLES, form_of
from crankstar.options.gas import degree_of_irregularity, refuse_weak_beside_off, weaker_cylinders

if TYPE_CHECKING:
    from crankstar.analysis.document import Document
    from crankstar.engine.engine import Engine
    from crankstar.mechanics.gas import Cycle

MOST_PAIRS = 200
"""Of poles: more than any slow hydroelectric generator has."""


def genset(
    engine: EngineName,
    /,
    *,
    pole_pairs: Annotated[int | None, option("--pole-pairs")] = None,
    engines: Annotated[int | None, option("--engines", "Default: 1.")] = None,
    flywheel: Annotated[str | None, option("--flywheel")] = None,
    irregularity: Annotated[str | None, option("--irregularity")] = None,
    off: Annotated[str | None, option("--off")] = None,
    weaker: Annotated[list[str] | None, option("--weaker")] = None,
    point: Annotated[str | None, option("--point")] = None,
    speed: Speed = None,
    settings: Settings = None,
    estimate: Estimating = False,
    json: Json = False,
    csv: Csv = False,
    output: Output = None,
) -> None:
    """Compute how evenly a generating set runs, and what several do to one foundation."""
    from crankstar.mechanics.gas import cycle_or_reason
    from crankstar.mechanics.phase_sums import MOST
    from crankstar.options.marine import inertia
    from crankstar.studies.answers import torques
    from crankstar.studies.generating_sets import generating_set
    from crankstar.tables.generating_sets import (
        generating_set_document,
        missing_running,
        missing_sums,
    )
    from crankstar.tables.ranges import ranged

    form, (loaded, spread), turning, silent, weak, pairs, count, wheel, even = together(
        partial(form_of, output, TABLES, json=json, csv=csv),
        partial(loaded_values, engine, settings, estimate=estimate),
        partial(request.speed, speed),
        partial(request.cylinders_off, off),
        partial(weaker_cylinders, weaker),
        partial(request.within, "--pole-pairs", pole_pairs, most=MOST_PAIRS),
        partial(request.within, "--engines", engines, most=MOST),
        partial(inertia, flywheel),
        partial(degree_of_irregularity, irregularity),
    )
    refuse_weak_beside_off(weak, silent)

    of_running = {
        "--pole-pairs": pole_pairs,
        "--flywheel": flywheel,
        "--irregularity": irregularity,
    }

    def sheet(each: Engine) -> Document:
        found = generating_set(
            each,
            point=point or "",
            speed=turning,
            flywheel=wheel,
            pole_pairs=pairs,
            engines=count or 1,
            irregularity=even,
            off=silent,
            weaker=dict(weak),
        )
        if lacking := missing_running(found):
            request.refuse_unused(of_running, why=lacking)
        if lacking := missing_sums(found):
            request.refuse_unused({"--engines": engines}, why=lacking)
        return generating_set_document(found)

    def burnt(each: Engine) -> Cycle | None:
        load = {"off": silent, "weaker": dict(weak)}
        return cycle_or_reason(each, point=point or "", speed=turning, **load)[0]

    with working(_("Computing the cycle ...")), words_for(form):
        answered = partial(torques, loaded, burnt, flywheel=wheel, irregularity=even, sums=True)
        document = ranged(sheet, spread, loaded, rests=resting_on(form, loaded, answered))
    give(document, output, form=form)
