"""Random engines that have everything at once, for the laws where features meet.

Rods of every kind, gas from a cycle, a trace or between two operating points, cylinders off or
weak, a load course, several crankshafts, mounts, weights and an elastic crankshaft.
"""

from __future__ import annotations

from math import pi, radians
from typing import Any

import numpy as np
from hypothesis import assume
from hypothesis import strategies as st
from tests.strategies import blocks, engines, fired, mounted, number, twisting

from crankstar.engine.copies import with_values
from crankstar.engine.dead_centres import dead_centres
from crankstar.engine.drive import Drive
from crankstar.engine.engine import Engine
from crankstar.engine.gas import Gas, OperatingPoint, Trace
from crankstar.language.faults import EngineError
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.operating_points import GasError

POINTS = (
    OperatingPoint(name="idle", speed=60.0, imep=3e5, intake_pressure=0.5e5),
    OperatingPoint(name="full", speed=400.0, imep=12e5, intake_pressure=1.5e5),
)
"""Two loads, between which the gas of most speeds is."""


@st.composite
def loaded_engines(draw: Any) -> tuple[Engine, Cycle]:
    """Any engine with rods of every kind, its gas at any load or traced, some cylinders off."""
    drawn = draw(engines(max_shafts=2, known=True))
    cylinders = tuple(with_values(c, bore=draw(number(0.04, 0.2))) for c in drawn.cylinders)
    shafts = tuple(
        with_values(each, speed_ratio=1 if each.speed_ratio > 0 else -1) for each in drawn.shafts
    )
    changed = {"cylinders": cylinders, "shafts": shafts, "valves": None}
    try:
        engine = with_values(
            drawn, **changed, firing_order=(), firing_angles=None, torsion=None, bore_pitch=None
        )
        engine = fired(engine, with_angles=False)
    except EngineError:
        assume(False)
        raise
    turn = 360.0
    assume(all(abs(top.period_deg - turn) < 1e-6 for top in dead_centres(engine).values()))
    whole = radians(engine.cycle_angle)
    angle = np.arange(0, 180) * (whole / 180)
    pressure = 1e5 + 3e6 * np.exp(-9 * (1 - np.cos(angle * 2 * pi / whole)))
    trace = Trace(angle=tuple(angle.tolist()), pressure=(tuple(pressure.tolist()),))
    gas = draw(
        st.builds(Gas, imep=number(3e5, 15e5), compression_ratio=number(8.0, 12.0))
        | st.just(Gas(trace=trace))
        | st.builds(Gas, compression_ratio=number(8.0, 12.0), points=st.just(POINTS))
    )
    engine = with_values(engine, gas=gas)
    off = draw(st.sets(st.sampled_from([each.number for each in engine.cylinders]), max_size=2))
    try:
        return engine, cycle(engine, speed=draw(number(30.0, 600.0)), off=off)
    except GasError:
        assume(False)
        raise


@st.composite
def whole_engines(draw: Any) -> tuple[Engine, Cycle]:
    """Any engine with everything at once, and its cycle with some cylinders off or weak."""
    engine, found = draw(loaded_engines())
    assert found.speed is not None
    angle = np.linspace(0.0, radians(engine.cycle_angle), 24, endpoint=False)
    wave = 1 + draw(number(0.0, 0.9)) * np.sin(draw(st.integers(1, 4)) * angle)
    drive = draw(
        st.builds(Drive, inertia=number(0.5, 5.0), load_exponent=st.sampled_from([-1.0, 0.0, 2.0]))
        | st.just(
            Drive(inertia=2.0, load_angle=tuple(angle.tolist()), load_torque=tuple(wave.tolist()))
        )
    )
    engine = with_values(engine, drive=drive, block=draw(blocks(engine.cylinders)))
    engine = draw(twisting(draw(mounted(engine))))
    weak = {each: draw(number(0.05, 0.9)) for each in draw(st.sets(_numbers(engine), max_size=2))}
    off = [each.number for key in found.off for each in engine.chambers[key]]
    firing = {cylinder: share for cylinder, share in weak.items() if cylinder not in off}
    try:
        return engine, cycle(engine, speed=found.speed, off=off, weaker=firing)
    except GasError:
        assume(False)
        raise


def _numbers(engine: Engine) -> st.SearchStrategy[int]:
    """The numbers of the cylinders."""
    return st.sampled_from([each.number for each in engine.cylinders])
