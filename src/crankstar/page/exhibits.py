"""Engine -> Exhibit: the data of an engine on the page, as it is and with weights and shafts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from importlib.metadata import version
from math import lcm, pi
from typing import Any

from crankstar import files
from crankstar.charts.strokes import STROKE_COLOURS
from crankstar.engine.copies import throws_of_weights, with_values
from crankstar.engine.engine import Engine
from crankstar.firing.strokes import WorkingCycle, working_cycle
from crankstar.language.faults import EngineError
from crankstar.language.numbers import unit_text
from crankstar.mechanics import remains
from crankstar.mechanics.balance import Balance, balance, scales
from crankstar.page import orders as vectors
from crankstar.page.bearing_loads import bearings_shown
from crankstar.page.keys import chart_keys, derivation_keys
from crankstar.page.printed import printed
from crankstar.page.proportions import proportions
from crankstar.page.records import (
    Exhibit,
    Exhibition,
    Fact,
    Scale,
    StrokeColours,
    StrokeWindow,
    Table,
    Units,
)
from crankstar.page.scene import scene
from crankstar.remedy import fitting
from crankstar.tables import headings, remedies, strokes
from crankstar.tables.conditions import unit_sentence, unit_sizes, unverified
from crankstar.tables.verdict import subjects, verdict


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
    return Exhibition(
        engines=shown,
        fitted=tuple(
            fitted(engine, file=tree) for engine, tree in zip(engines, trees, strict=True)
        ),
        stroke_colours=StrokeColours(**STROKE_COLOURS),
        sources=tuple(sources),
        command=command,
        version=version("crankstar"),
    )


def _distinguished(engines: Sequence[Engine], sources: Sequence[str]) -> list[Engine]:
    """The engines, those of the same name with their sources or places added to it."""
    names = [engine.name for engine in engines]
    if len(set(names)) == len(names):
        return list(engines)
    words = sources if len(set(sources)) == len(names) else range(1, len(names) + 1)
    return [
        with_values(engine, name=f"{engine.name} ({word})")
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
    result = balance(engine, speed=engine.speed)
    sums = remains.summed(result)
    orders = remains.orders_shown(result, sums)
    along, cycle = proportions(engine).along, _cycle(engine)
    subject_of = subjects()
    return Exhibit(
        name=engine.name,
        file=dict(file) if file is not None else files.explicit(engine),
        cycle_deg=engine.cycle_angle,
        turns=_turns(engine),
        weight_throws=tuple(map(throws_of_weights, engine.shafts)),
        relative=engine.relative,
        sense=1 if engine.sense > 0 else -1,
        speed_rpm=None if engine.speed is None else float(f"{engine.speed * 30 / pi:.12g}"),
        units=Units(
            force=unit_text(result.units.force),
            couple=unit_text(result.units.couple),
            roll=unit_text(result.units.moment),
            length=engine.across,
        ),
        scale=_scale(engine),
        heading=_heading(engine, result),
        unverified=tuple(unverified(engine)),
        reference_z=result.reference.z * along,
        couple_length=along,
        orders=orders,
        total=vectors.sums_of(sums, orders),
        cylinders=vectors.by_cylinder(engine, result, orders, along=along),
        whirl=vectors.free_response(engine, orders, along=along),
        bearings=bearings_shown(engine),
        scene=scene(engine),
        table=vectors.rows(sums, orders),
        verdict=tuple(
            Fact(about=subject_of[fact.about], sentence=fact.sentence)
            for fact in verdict(engine, relatives=relatives)
        ),
        strokes=printed(strokes.tables(engine, cycle)) if cycle else (),
        stroke_windows=_windows(cycle) if cycle else (),
        charts=chart_keys(engine, remains.orders_pushed(result)),
        derivations=derivation_keys(remains.orders_pushed(result)),
        remedies=tuple(remedies),
    )


def fitted(
    engine: Engine, *, file: Mapping[str, Any] | None = None, bare: bool = False
) -> Exhibit | None:
    """The engine with the weights and shafts that the verdict recommends, None if it needs none.

    `file` is the tree of its engine file. New counterweights stand beside those of the file or,
    with `bare`, instead of them.
    """
    remedy = fitting.recommended(engine, bare=bare)
    if remedy is None:
        return None
    return fitted_with(
        engine, remedy.after, factor=remedy.factor, description=remedy.description, file=file
    )


def fitted_with(
    engine: Engine,
    after: Engine,
    *,
    factor: float | None,
    description: str = "",
    file: Mapping[str, Any] | None = None,
) -> Exhibit:
    """The exhibit of `after`, with the tables of its weights and shafts, `description` first.

    Its file keeps the form of the `file` of the engine, where that can say everything.
    """
    job = remedies.Job(engine, after, factor, speed=engine.speed, description=description)
    tables = printed(tuple(remedies.parts(job)))
    own = files.part_by_part(after) if file is None else files.rewritten_by_parts(file, after)
    return exhibit(after, file=own, relatives=False, remedies=tables)


def _scale(engine: Engine) -> Scale:
    """Crank radius, m r w^2 and m r w^2 a of the first cylinder in the units of the exhibit."""
    (counted, _), (unit, _) = scales(engine, engine.speed), scales(engine, None)
    return Scale(
        length=engine.throw(engine.first).radius,
        force=counted.force / unit.force,
        couple=counted.couple / unit.couple,
    )


def _turns(engine: Engine) -> int:
    """Turns of the first shaft after which shafts and firing are back at the start."""
    cycle = Fraction(int(engine.cycle_angle), 360)
    return lcm(int(cycle), *(shaft.speed_ratio.denominator for shaft in engine.shafts))


def _heading(engine: Engine, result: Balance) -> tuple[str, ...]:
    """The lines under the name: cycle, firing, units."""
    units = (unit_sentence(engine, result), unit_sizes(engine))
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
