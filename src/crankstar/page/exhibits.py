"""Engine -> Exhibit: the data of an engine on the page, as it is and with weights and shafts."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import partial
from math import lcm
from typing import Any, NamedTuple

from crankstar import __version__, files
from crankstar.analyses.strokes.charts.timing_diagram import STROKE_COLOURS
from crankstar.analyses.strokes.document import tables as stroke_tables
from crankstar.analyses.verdict.document import subjects
from crankstar.analyses.verdict.facts import verdict
from crankstar.analyses.verdict.ranges import ranged_facts
from crankstar.analysis.document import Document
from crankstar.dynamics.bearings import BearingLoads, bearing_loads
from crankstar.engine.copies import throws_of_weights, with_values
from crankstar.engine.engine import Engine
from crankstar.files.box import Spread, spread
from crankstar.firing.strokes import WorkingCycle, working_cycle
from crankstar.language.alike import alike
from crankstar.language.faults import EngineError
from crankstar.language.glossary import terms
from crankstar.language.messages import _
from crankstar.language.numbers import rpm_of
from crankstar.language.quoting import one_line
from crankstar.mechanics import remains
from crankstar.mechanics.balance import Balance, balance, scales
from crankstar.page import orders as vectors
from crankstar.page.bearing_loads import (
    bearing_numbers,
    bearings_shown,
    gas_bearing_numbers,
    gas_bearings_shown,
)
from crankstar.page.cycle_records import StrokeColours, StrokeWindow
from crankstar.page.keys import chart_keys, derivation_keys
from crankstar.page.mounts import mount_numbers, mounts_shown
from crankstar.page.printed import printed
from crankstar.page.proportions import proportions
from crankstar.page.records import Exhibit, Exhibition, Fact, Scale
from crankstar.page.scene import scene
from crankstar.page.shown_units import offered, units_of
from crankstar.page.told import panels, told_charts, told_tables
from crankstar.page.torque import exhaust, gas_needs, torque, torque_unit
from crankstar.page.torsion import torsion_charts, torsion_needs, torsion_numbers, torsion_shown
from crankstar.page.unit_records import Table
from crankstar.remedy import fitting
from crankstar.remedy.kept import with_source
from crankstar.remedy.sizing import Remedied, resized
from crankstar.studies.answer_parts import joined
from crankstar.studies.answers import amplitudes, rests_on
from crankstar.studies.load_answers import first_load
from crankstar.tables import headings, remedies
from crankstar.tables.assumptions import assumption_lines
from crankstar.tables.conditions import can_be_estimated, unit_sentence, unit_sizes
from crankstar.tables.laid import merged
from crankstar.tables.ranges import estimated_paths, ranged_lines


def exhibition(
    engines: Sequence[Engine],
    *,
    files_given: Sequence[Mapping[str, Any]] = (),
    sources: Sequence[str] = (),
    command: str = "",
    relatives: bool = True,
) -> Exhibition:
    """The contents of a page: one engine, or two side by side, also with weights and shafts.

    `files_given` are the trees of their files, `sources` their names on the command line.
    """
    trees = [dict(tree) for tree in files_given] or [files.explicit(engine) for engine in engines]
    engines = _distinguished(engines, sources)
    shown = tuple(
        exhibit(engine, file=tree, relatives=relatives)
        for engine, tree in zip(engines, trees, strict=True)
    )
    cured = tuple(fitted(engine, file=tree) for engine, tree in zip(engines, trees, strict=True))
    return opening(shown, cured, sources=sources, command=command)


def opening(
    shown: Sequence[Exhibit],
    cured: Sequence[Exhibit | None],
    *,
    sources: Sequence[str] = (),
    command: str = "",
) -> Exhibition:
    """What a page opens with, for these engines as they are and with weights and shafts."""
    return Exhibition(
        engines=tuple(shown),
        fitted=tuple(cured),
        stroke_colours=StrokeColours(**STROKE_COLOURS),
        panels=panels(),
        units=offered(),
        glossary=terms(),
        sources=tuple(sources),
        command=command,
        version=__version__,
    )


def _distinguished(engines: Sequence[Engine], sources: Sequence[str]) -> list[Engine]:
    """The engines, those of the same name with their sources or places added to it."""
    names = [engine.name for engine in engines]
    if len(set(names)) == len(names):
        return list(engines)
    words = sources if len(set(sources)) == len(names) else range(1, len(names) + 1)
    return [
        with_values(engine, name=one_line(f"{engine.name} ({word})"))
        for engine, word in zip(engines, words, strict=True)
    ]


def exhibit(
    engine: Engine,
    *,
    file: Mapping[str, Any] | None = None,
    relatives: bool = True,
    remedies: Sequence[Table] = (),
) -> Exhibit:
    """One engine on the page.

    `file` is its engine file as a tree, by default in the explicit form; `relatives`: the verdict
    also names better engines of the catalog, which takes the longest the first time.
    """
    tree = dict(file) if file is not None else files.explicit(engine)
    over = spread_of(engine, tree)
    known = _known(engine, over)
    result, sums, ends, loads = known
    orders = remains.orders_shown(result, sums)
    explained = remains.orders_explained(result, sums)
    sizes, cycle = proportions(engine), _cycle(engine)
    along = sizes.along
    return Exhibit(
        name=engine.name,
        file=tree,
        cycle_deg=engine.cycle_angle,
        turns=_turns(engine),
        weight_throws=tuple(map(throws_of_weights, engine.shafts)),
        relative=engine.relative,
        sense=1 if engine.sense > 0 else -1,
        speed_rpm=rpm_of(engine.speed),
        scale=_scale(engine),
        estimated=tuple(estimated_paths(engine)),
        can_estimate=can_be_estimated(engine),
        ends=vectors.ends_of(ends, orders),
        reference_z=result.reference.z * along,
        couple_length=along,
        orders=orders,
        total=vectors.sums_of(sums, orders),
        cylinders=vectors.by_cylinder(engine, result, orders, along=along),
        whirl=vectors.free_response(engine, orders, along=along),
        whirl_ends=tuple(
            vectors.free_response(each, orders, along=along) for each in (over.ends if over else ())
        ),
        bearings=bearings_shown(engine, loads),
        gas_bearings=gas_bearings_shown(engine),
        scene=scene(engine, sizes),
        strokes=printed(stroke_tables(engine, cycle)) if cycle else (),
        stroke_windows=_windows(cycle) if cycle else (),
        torque=torque(engine),
        gas_needs=gas_needs(engine),
        exhaust=exhaust(engine),
        torsion=torsion_shown(engine),
        torsion_needs=torsion_needs(engine),
        mounts=mounts_shown(engine),
        charts=(
            *chart_keys(engine, explained),
            *torsion_charts(engine),
            *told_charts(engine, tree),
        ),
        derivations=derivation_keys(explained),
        remedies=tuple(remedies),
        **in_units(engine, over, tree=tree, relatives=relatives, known=known),
    )


class _Known(NamedTuple):
    """What several parts of an exhibit are made from, worked out once."""

    result: Balance
    sums: remains.Sums
    ends: list[remains.Sums]
    loads: BearingLoads


def _known(engine: Engine, over: Spread | None) -> _Known:
    result = balance(engine, speed=engine.speed)
    return _Known(
        result,
        remains.summed(result),
        [remains.summed(balance(each, speed=each.speed)) for each in over.ends] if over else [],
        bearing_loads(engine, speed=engine.speed),
    )


def in_units(
    engine: Engine,
    over: Spread | None,
    *,
    tree: Mapping[str, Any],
    relatives: bool,
    known: _Known | None = None,
) -> dict[str, Any]:
    """The parts of an exhibit that are in the units of the context: units, texts and numbers.

    `tree` is that of the engine file.
    """
    result, sums, ends, loads = known or _known(engine, over)
    units, scaling = units_of(engine, result, sums)
    subject_of = subjects()
    facts = ranged_facts(partial(verdict, relatives=relatives), over, engine)
    told = joined([amplitudes(engine, gas=True), first_load(engine)])
    return {
        "units": units,
        "heading": ranged_lines(_heading, over, engine),
        "rests_on": tuple(assumption_lines(rests_on(engine, told))),
        "table": vectors.rows(sums, remains.orders_shown(result, sums), scaling=scaling, ends=ends),
        "bearing_numbers": bearing_numbers(engine, over, loads),
        "gas_bearing_numbers": gas_bearing_numbers(engine),
        "torque_unit": torque_unit(engine),
        "torsion_numbers": torsion_numbers(engine),
        "mount_numbers": mount_numbers(engine),
        "told": told_tables(engine, tree, over),
        "verdict": tuple(
            Fact(subject=fact.about, about=subject_of[fact.about], sentence=fact.sentence)
            for fact in facts
        ),
    }


class Done(NamedTuple):
    """An engine with weights and shafts: by which balance factor, and in words."""

    after: Engine
    factor: float | None
    description: str = ""


Fit = Callable[[Engine], Done | None]


def advised(engine: Engine, *, bare: bool = False) -> Done | None:
    """The engine with the weights and shafts that the verdict recommends, if there are any."""
    remedy = fitting.recommended(engine, bare=bare)
    return None if remedy is None else Done(remedy.after, remedy.factor, remedy.description)


def fitted(
    engine: Engine, *, file: Mapping[str, Any] | None = None, bare: bool = False
) -> Exhibit | None:
    """The engine with the weights and shafts that the verdict recommends, None if it needs none.

    `file` is the tree of its engine file. New counterweights stand beside those of the file or,
    with `bare`, instead of them.
    """
    return fitted_with(engine, partial(advised, bare=bare), file=file)


def fitted_with(
    engine: Engine, fit: Fit, *, file: Mapping[str, Any] | None = None
) -> Exhibit | None:
    """The engine as it is fitted, with the tables of its weights and shafts; None without any.

    Its file keeps the form of the `file` of the engine, where that can say everything.
    """
    done = fit(engine)
    if done is None:
        return None
    after = with_source(engine, done.after)
    own = files.part_by_part(after) if file is None else files.rewritten_by_parts(file, after)
    tables = remedy_tables(engine, fit, None if file is None else spread_of(engine, file))
    return exhibit(after, file=own, relatives=False, remedies=tables)


def remedy_tables(engine: Engine, fit: Fit, over: Spread | None) -> tuple[Table, ...]:
    """The tables of weights and shafts; with ranges, for engines each fitted for its own masses."""
    first = fit(engine)
    if first is None:
        return ()

    def sheet(each: Engine) -> Document:
        own = fit(each)
        after = resized(Remedied(engine, first.after), each, own and own.after)
        job = remedies.Job(
            each, after, first.factor, speed=each.speed, description=first.description
        )
        return Document("", tuple(remedies.parts(job)))

    if over is None:
        return printed(sheet(engine).parts)
    tables = printed(merged(alike(sheet, over.engines)).parts)
    last = max((index for index, table in enumerate(tables) if table.rows), default=-1)
    return tuple(
        Table(**{**table.model_dump(), "notes": (*table.notes, _(remedies.SIZED))})
        if index == last
        else table
        for index, table in enumerate(tables)
    )


def spread_of(engine: Engine, tree: Mapping[str, Any]) -> Spread | None:
    """The engine over the ranges of the estimated values of its file; None where it has none."""
    ends = spread(dict(tree), name=engine.name)
    return None if ends is None else ends._replace(engine=engine)


def _scale(engine: Engine) -> Scale:
    """Crank radius, m r w^2 (also times a, times r) of the first cylinder, in its units."""
    (counted, _), (unit, _) = scales(engine, engine.speed), scales(engine, None)
    return Scale(
        length=engine.throw(engine.first).radius,
        force=counted.force / unit.force,
        couple=counted.couple / unit.couple,
        roll=counted.moment / unit.moment,
    )


def _turns(engine: Engine) -> int:
    """Turns of the first shaft after which shafts and firing are back at the start."""
    cycle = Fraction(int(engine.cycle_angle), 360)
    return lcm(int(cycle), *(shaft.speed_ratio.denominator for shaft in engine.shafts))


def _heading(engine: Engine) -> tuple[str, ...]:
    """The lines under the name: cycle, firing, units."""
    result = balance(engine, speed=engine.speed)
    units = (unit_sentence(engine, result), unit_sizes(engine, result))
    return tuple(filter(None, [*headings.heading_lines(engine), *units]))


def _cycle(engine: Engine) -> WorkingCycle | None:
    """The working cycle, None without a firing order or a common cycle."""
    try:
        return working_cycle(engine) if engine.firing_order else None
    except EngineError:
        return None


def _windows(cycle: WorkingCycle) -> tuple[StrokeWindow, ...]:
    """The strokes of every chamber between two crank angles."""
    return tuple(
        StrokeWindow(
            chamber=chamber.number,
            stroke=stroke.name,
            from_deg=stroke.window.start_deg,
            to_deg=stroke.window.end_deg,
        )
        for chamber in cycle.chambers
        for stroke in chamber.strokes
    )
