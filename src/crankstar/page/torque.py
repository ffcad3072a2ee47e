"""Gas and inertia torque over a working cycle, and the exhaust as a sound, as the page has them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import lru_cache
from math import radians
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.analyses.marine.large_engines import large_engine_table
from crankstar.analysis.document import Table
from crankstar.dynamics import sound
from crankstar.dynamics.uneven import Running, driven
from crankstar.engine.engine import Engine
from crankstar.engine.gas import Gas
from crankstar.firing.intervals import firing
from crankstar.firing.strokes import exhaust_groups
from crankstar.language.faults import EngineError
from crankstar.language.messages import MessageError, _
from crankstar.language.numbers import unit_text
from crankstar.language.shown_units import shown
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.doubts import point_doubts
from crankstar.mechanics.excitation import Totals
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.gas_torque import added, chamber_torque, friction_torque, gas_torque
from crankstar.mechanics.operating_points import GasError, default_point
from crankstar.page.cycle_records import Chamber, Exhaust, Load, Pipe, Torque, Wave
from crankstar.page.printed import printed
from crankstar.page.unit_records import Unit
from crankstar.spectra import Complex, Real, Spectrum
from crankstar.tables.meshes import mesh_table
from crankstar.tables.torque import assumed_notes, notes
from crankstar.tables.torque_parts import side_thrust_tables

MOST_LOADS = 12
"""Operating points that are sent; the command line has all."""
FIGURES = 11
"""Figures of an amplitude that are sent."""
HIGHEST_HEARD = 48.0
"""The highest order of a pulse that is sent: those above are less than a thousandth of it."""


class Cycles(NamedTuple):
    """Two cycles of an operating point: all chambers burning, and none."""

    burning: Cycle
    still: Cycle


@lru_cache(maxsize=16)
def cycles(engine: Engine) -> tuple[Cycles, ...]:
    """The cycles of every operating point. Raises GasError.

    The load of the table [gas] comes first, left out where points are given instead of it.

    >>> from crankstar.files.catalog import load
    >>> (only,) = cycles(load("honda-b18c"))
    >>> round(only.burning.imep), only.still.motored
    (900000, True)
    """
    gas = engine.gas or Gas()
    named = [point.name for point in gas.points]
    wanted = list(dict.fromkeys([default_point(gas), *named]))[:MOST_LOADS]
    return tuple(
        Cycles(cycle(engine, point=name), cycle(engine, point=name, motored=True))
        for name in wanted
    )


def gas_needs(engine: Engine) -> str:
    """What the gas torque of an engine needs, as a sentence; empty where it can be computed."""
    try:
        cycles(engine)
    except GasError as error:
        return sentence_of(error)
    return ""


def sentence_of(error: MessageError) -> str:
    """What an error says, as a sentence."""
    reason = str(error)
    return _("{reason}.", reason=reason[:1].upper() + reason[1:])


def torque(engine: Engine) -> Torque | None:
    """The torque of an engine at its operating points; None where gas cannot be computed.

    >>> from crankstar.files.catalog import load
    >>> found = torque(load("honda-b18c"))
    >>> found.orders[:4], len(found.chambers), len(found.loads[0].burning)
    ((0.5, 1.0, 1.5, 2.0), 4, 1)
    """
    try:
        found = cycles(engine)
    except GasError:
        return None
    moving = _moving(engine)
    first = found[0].burning
    wave = gas_torque(first).total
    if moving is not None:
        wave = added(wave, added(moving.torque, moving.axis_moment))
    orders = wave.orders
    places = first.volumes
    rows = _rows(found)
    return Torque(
        orders=tuple(orders.tolist()),
        cycle=places.cycle,
        displacement=float(places.swept[[*places.kind]].sum()),
        chambers=tuple(
            Chamber(number=number, fires=float(fires), wave=rows.index(_row(found, index)))
            for index, (number, fires) in enumerate(zip(places.numbers, places.fires, strict=True))
        ),
        moving=None if moving is None else wave_of(_at(moving.torque, orders)),
        axis=wave_of(np.zeros(orders.size) if moving is None else _at(moving.axis_moment, orders)),
        loads=tuple(_loads(engine, found, orders, [_place(found, row) for row in rows])),
    )


def torque_unit(engine: Engine) -> Unit:
    """The unit of the torque of an engine in the units of the context."""
    try:
        largest = max(float(np.abs(chamber_torque(both.burning)).max()) for both in cycles(engine))
    except GasError:
        largest = 1.0
    unit = shown("N*m", largest)
    return Unit(label=unit_text(unit.unit), factor=unit.factor)


def exhaust(engine: Engine) -> Exhaust | None:
    """What is heard of the exhaust, None without a firing order.

    >>> from crankstar.files.catalog import load
    >>> heard = exhaust(load("v8-cross-plane"))
    >>> [len(pipe.fires) for pipe in heard.pipes], heard.pulse[11]
    ([4, 4], 0.5)
    """
    try:
        fired = firing(engine) if engine.firing_order else None
    except EngineError:
        fired = None
    if fired is None:
        return None
    angle = dict(zip(fired.order, fired.angles_deg, strict=True))
    step = 360 / fired.cycle_deg
    return Exhaust(
        cycle=radians(fired.cycle_deg),
        pulse=tuple(
            float(f"{sound.pulse_order(number * step):.6g}")
            for number in range(1, int(HIGHEST_HEARD / step) + 1)
        ),
        back=sound.echo(sound.PIPE) / sound.RATE,
        reflected=sound.REFLECTED,
        pipes=tuple(
            Pipe(
                name=group.name,
                chambers=tuple(group.chambers),
                fires=tuple(radians(angle[n]) for n in group.chambers),
            )
            for group in exhaust_groups(engine)
        ),
    )


def _moving(engine: Engine) -> Totals | None:
    """Torque and moments of the moving parts at 1 rad/s, None where masses are not known."""
    result = balance(engine, speed=1.0)
    return None if result.speed is None else total(result)


def _row(found: Sequence[Cycles], index: int) -> tuple[int, bytes]:
    """What tells a chamber from others: its motion, and its pressure at every load."""
    pressures = b"".join(each.pressure[index].tobytes() for both in found for each in both)
    return found[0].burning.volumes.kind[index], pressures


def _rows(found: Sequence[Cycles]) -> list[tuple[int, bytes]]:
    """Those that differ, each once."""
    chambers = range(len(found[0].burning.volumes.numbers))
    return list(dict.fromkeys(_row(found, place) for place in chambers))


def _place(found: Sequence[Cycles], row: tuple[int, bytes]) -> int:
    chambers = range(len(found[0].burning.volumes.numbers))
    return next(place for place in chambers if _row(found, place) == row)


def _loads(
    engine: Engine, found: Sequence[Cycles], orders: Real, chambers: Sequence[int]
) -> Iterator[Load]:
    """The loads, with the waves of these chambers."""
    for both in found:
        burning = both.burning
        lines = [*notes(engine, burning), *assumed_notes(engine, burning)]
        running = None
        try:
            running = driven(engine, burning)
        except MessageError as error:
            lines.append(sentence_of(error))
        yield Load(
            name=burning.name,
            assumed="imep" in burning.assumed,
            speed=burning.speed,
            burning=tuple(_waves(burning, orders, chambers)),
            burning_mean=tuple(_means(burning, chambers)),
            still=tuple(_waves(both.still, orders, chambers)),
            still_mean=tuple(_means(both.still, chambers)),
            friction=friction_torque(burning) or 0.0,
            irregularity=None if running is None else running.irregularity,
            inertia=None if running is None else running.inertia,
            notes=tuple(lines),
            doubts=tuple(fault.sentence for fault in point_doubts(engine, burning)),
            tables=printed(_tables(engine, burning, running)),
        )


def _tables(engine: Engine, burning: Cycle, running: Running | None) -> Iterator[Table]:
    """Side thrust, gears between crankshafts, guide-force moments of a large engine."""
    gears = mesh_table(engine, burning, running=running)
    if gears is not None:
        yield gears
    yield from side_thrust_tables(engine, burning)
    guide = large_engine_table(engine, burning)
    if guide is not None:
        yield guide


def _waves(found: Cycle, orders: Real, chambers: Sequence[int]) -> Iterator[Wave]:
    """The gas torque of chambers from where each fires."""
    own = gas_torque(found)
    turned = np.exp(1j * own.torque.orders * found.volumes.fires[:, None])
    wave = spectra.real_signal(own.torque.orders, spectra.amplitude(own.torque) * turned)
    for place in chambers:
        yield wave_of(_at(wave[place], orders))


def _means(found: Cycle, chambers: Sequence[int]) -> Iterator[float]:
    return (float(mean) for mean in chamber_torque(found).mean(axis=-1)[[*chambers]])


def _at(spectrum: Spectrum, orders: Real) -> Complex:
    """The amplitudes at these orders, nought where there are none."""
    return spectra.amplitude(spectra.selected(spectrum, orders.tolist()))


def wave_of(values: Complex | Real) -> Wave:
    """Amplitudes as pairs of numbers with so many figures."""
    return tuple((_short(value.real), _short(value.imag)) for value in np.asarray(values, complex))


def _short(value: float) -> float:
    return float(f"{value:.{FIGURES}g}") + 0.0
