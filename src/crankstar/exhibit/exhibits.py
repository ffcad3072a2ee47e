"""Engine -> Exhibit: everything the page is told of an engine at once, and of the same engine with weights and shafts."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from importlib.metadata import version
from math import lcm, pi
from typing import Any

from crankstar import files, fitting, stroke_table, tables, wording, workshop
from crankstar.answer import orders_present
from crankstar.balance import balance
from crankstar.engine import Engine
from crankstar.exhibit import numbers, tellings
from crankstar.exhibit.keys import chart_keys, derivation_keys
from crankstar.exhibit.proportions import proportions
from crankstar.exhibit.records import Exhibit, Exhibition, Fact, StrokeWindow, Table, Units
from crankstar.exhibit.scene import scene
from crankstar.fault import EngineError
from crankstar.strokes import working_cycle
from crankstar.verdict import verdict
from crankstar.wording import number, unit_text


def exhibition(
    engines: Sequence[Engine],
    *,
    files_given: Sequence[Mapping[str, Any]] = (),
    sources: Sequence[str] = (),
    command: str = "",
    neighbours: bool = True,
) -> Exhibition:
    """What a page opens with: one engine, or two side by side, each as it is and with weights and shafts.

    `files_given` are the trees of their files, `sources` the words with which they were named.
    """
    trees = [dict(tree) for tree in files_given] or [files.explicit(engine) for engine in engines]
    engines = _told_apart(engines, sources)
    shown = tuple(exhibit(engine, file=tree, neighbours=neighbours) for engine, tree in zip(engines, trees, strict=True))
    return Exhibition(
        engines=shown,
        fitted=tuple(fitted(engine) for engine in engines),
        sources=tuple(sources),
        command=command,
        version=version("crankstar"),
    )


def _told_apart(engines: Sequence[Engine], sources: Sequence[str]) -> list[Engine]:
    """Engines of different names: where files give the same, with what they were named by, else with their places."""
    names = [engine.name for engine in engines]
    if len(set(names)) == len(names):
        return list(engines)
    words = sources if len(set(sources)) == len(names) else range(1, len(names) + 1)
    return [engine.model_copy(update={"name": f"{engine.name} ({word})"}) for engine, word in zip(engines, words, strict=True)]


def exhibit(
    engine: Engine, *, file: Mapping[str, Any] | None = None, neighbours: bool = True, remedies: Sequence[Table] = ()
) -> Exhibit:
    """All that the page is told of one engine; `file` is its engine file as a tree, else the explicit form is given.

    `neighbours`: the verdict also names engines of the catalog that do better, which takes much the longest when first asked.
    """
    result = balance(engine, speed=engine.speed)
    sums = numbers.summed(result)
    orders = numbers.orders_shown(result, sums)
    along = proportions(engine).along
    strokes, windows = _strokes(engine)
    return Exhibit(
        name=engine.name,
        file=dict(file) if file is not None else files.explicit(engine),
        cycle_deg=engine.cycle_angle,
        turns=_turns(engine),
        sense=1 if engine.sense > 0 else -1,
        speed_rpm=None if result.speed is None else result.speed * 30 / pi,
        units=Units(
            force=unit_text(result.units.force),
            couple=unit_text(result.units.couple),
            roll=unit_text(result.units.roll),
            length=engine.across,
        ),
        heading=_heading(engine, result.speed),
        reference_z=result.reference.z * along,
        couple_length=along,
        orders=orders,
        total=numbers.sums_of(sums, orders),
        cylinders=numbers.by_cylinder(engine, result, orders, along=along),
        whirl=numbers.free_response(engine, orders, along=along),
        scene=scene(engine),
        table=numbers.rows(sums, orders),
        verdict=tuple(Fact(about=fact.about, sentence=fact.sentence) for fact in verdict(engine, neighbours=neighbours)),
        strokes=strokes,
        stroke_windows=windows,
        charts=chart_keys(engine, orders_present(result)),
        derivations=derivation_keys(orders_present(result)),
        remedies=tuple(remedies),
    )


def fitted(engine: Engine) -> Exhibit | None:
    """The exhibit of the engine with what the verdict recommends; None where there is nothing of the first two orders."""
    found = fitting.recommended(engine)
    if found is None:
        return None
    return fitted_with(engine, found.after, factor=found.factor, told=found.told)


def fitted_with(engine: Engine, after: Engine, *, factor: float | None, told: str = "") -> Exhibit:
    """The exhibit of `after`, an engine with weights and balance shafts of its own, and tables of what they do; first `told`."""
    job = workshop.Job(before=engine, after=after, factor=factor, speed=engine.speed)
    first = (Table(title="", heads=(), rows=(), notes=(told,)),) if told else ()
    remedies = (*first, *tellings.tables(workshop.balance_card(job)))
    return exhibit(after, file=files.part_by_part(after), neighbours=False, remedies=remedies)


def _turns(engine: Engine) -> int:
    """Turns of the first shaft after which shafts and firing are back at the start."""
    cycle = Fraction(int(engine.cycle_angle), 360)
    return lcm(int(cycle), *(shaft.speed_ratio.denominator for shaft in engine.shafts))


def _heading(engine: Engine, speed: float | None) -> tuple[str, ...]:
    """The lines under the name: cycle, firing, what the numbers are counted in, what nobody vouches for."""
    lines = [text.plain for text in wording.heading(engine).renderables[1:]]  # pyright: ignore[reportAttributeAccessIssue]
    if speed is not None:
        lines.append(f"forces at {number(speed * 30 / pi)} rpm{tables.unit_sizes(engine)}")
    elif "mass" in engine.relative or "radius" in engine.relative:
        lines.append(f"forces in units of m r ω², the same at every speed{tables.unit_sizes(engine)}")
    else:
        newtons = 'for newtons give speed = "6000 rpm" in the engine file'
        lines.append(f"forces in units of m r ω²{tables.unit_sizes(engine)}; {newtons}")
    doubtful = tables.unverified(engine)
    if doubtful:
        lines.append(f"unverified: {', '.join(doubtful)}")
    return tuple(lines)


def _strokes(engine: Engine) -> tuple[tuple[Table, ...], tuple[StrokeWindow, ...]]:
    """The tables of strokes and exhausts, and the strokes as windows; nothing where an engine has none."""
    if not engine.firing_order:
        return (), ()
    try:
        found = working_cycle(engine)
        told = tellings.tables(stroke_table.stroke_tables(engine))
    except EngineError:
        return (), ()
    windows = tuple(
        StrokeWindow(chamber=one.number, stroke=stroke.name, from_deg=stroke.window.start_deg, to_deg=stroke.window.end_deg)
        for one in found.chambers
        for stroke in one.strokes
    )
    return told, windows
