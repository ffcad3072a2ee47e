"""What a crankshaft that twists does, by figures: what an answer rests on moves them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import degrees
from typing import Any

import numpy as np

from crankstar.analysis.assumptions import Answer
from crankstar.analysis.tried_values import Figure, Figures, Tuning
from crankstar.dynamics.torsion_analysis import TorsionAnalysis, peaked, torsion_on_grid
from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_criticals import Critical
from crankstar.dynamics.torsion_modes import torsion_modes
from crankstar.dynamics.torsion_peaks import PeakOfSections
from crankstar.dynamics.torsion_response import Response, response
from crankstar.engine.engine import Engine
from crankstar.mechanics.operating_points import GasError
from crankstar.spectra import Real
from crankstar.studies.answer_parts import IN_VIBRATION, gas_as_in
from crankstar.studies.assumed_loads import of_load_on_shaft
from crankstar.studies.gas_alone import lacking_gas

OF_TORSION = {
    "natural frequency": "Hz",
    "torsional amplitude": "deg",
    "resonant amplitude": "deg",
    "torsional stress": "MPa",
    "torsional torque": "N*m",
}
"""The units of the figures of a crankshaft that twists."""
MINOR = 0.05
"""Share of the whole amplitude that a resonance is measured by at least."""


def twist(
    engine: Engine,
    *,
    point: str = "",
    speed: float | None = None,
    speeds: Sequence[float] | Real = (),
    off: Sequence[int] = (),
    weaker: Mapping[int, float] | None = None,
) -> Answer:
    """The first natural frequency of torsion, and how far and how hard the crankshaft is twisted.

    The maximum turn of the free end, in which the uneven running of the whole is, and the maximum
    shear stress of a shaft over the speeds (its torque where none has a diameter); of the order
    that resonates most, the turn of the free end at that resonance.
    """
    load = {"off": off, "weaker": weaker}
    fixed: dict[str, Any] = {"point": point, "speed": speed, "single": False, **load}
    whole = torsion_on_grid(engine, speeds=speeds, **fixed)
    ends = [float(whole.speeds[0]), float(whole.speeds[-1])] if len(whole.speeds) else []

    def figures(each: Engine) -> Figures:
        each = each if whole.cycle is not None else gas_as_in(engine, each)
        rough = torsion_on_grid(each, speeds=ends, **fixed)
        if whole.cycle is not None and rough.cycle is None:
            raise GasError(rough.without_gas)
        out: dict[Figure, float] = {}
        if rough.modes:
            out["natural frequency", None] = rough.modes[0].frequency
        return out | _forced_twist(rough, whole.strongest)

    def least(_engine: Engine) -> Mapping[str, float]:
        if whole.response is None:
            return {}
        turn = degrees(float(whole.response.peak_turn(whole.free_end).max()))
        return {"resonant amplitude": MINOR * turn}

    def natural(each: Engine) -> list[float]:
        return [mode.speed for mode in torsion_modes(torsion_chain(each))]

    lacking = lacking_gas(engine, figures, IN_VIBRATION, speed=speed, point=point)
    tunings = []
    if ends and whole.response is not None:
        orders = whole.response.orders.tolist()
        tunings = [Tuning(natural, orders, (ends[0], ends[-1]))]
    return Answer(
        figures=figures,
        unit=lambda quantity, _engine: OF_TORSION[quantity],
        uses=("inertia", "torsion", *(("gas",) if whole.cycle is not None else ())),
        gas=whole.cycle,
        gasless="" if lacking else IN_VIBRATION,
        why_gasless="" if engine.gas is None else whole.without_gas,
        least=least,
        choices=[*([lacking] if lacking else ()), *of_load_on_shaft(engine, whole.cycle)],
        tunings=tunings,
        shown=["torsion.loss_factor"],  # among the shafts, and the heat of damping goes with it
    )


def twisting_modes() -> Answer:
    """The first natural frequency of torsion alone, which no gas and no damping moves."""

    def figures(each: Engine) -> Figures:
        modes = torsion_modes(torsion_chain(each))
        return {("natural frequency", None): modes[0].frequency} if modes else {}

    return Answer(
        figures=figures,
        unit=lambda quantity, _engine: OF_TORSION[quantity],
        uses=("inertia", "torsion"),
    )


def _forced_twist(rough: TorsionAnalysis, strongest: Critical | None) -> dict[Figure, float]:
    """The figures of a forced response, from the one at critical speeds; none without one.

    `strongest` is the order, with its mode, of which the resonance is wanted, wherever it is: of a
    changed engine it may lie outside the speeds.
    """
    if rough.response is None:
        return {}
    modulus = np.array([each.modulus or np.nan for each in rough.chain.sections])
    stressed = bool(np.isfinite(modulus).any())
    most = PeakOfSections(modulus if stressed else np.ones_like(modulus))

    def curves(own: Response) -> Real:
        return np.column_stack([own.peak_turn(rough.free_end), most(own)])

    curves(rough.response)  # where there is nothing to refine it is all
    found = peaked(rough, curves=curves).response or rough.response
    turn = found.peak_turn(rough.free_end)
    out: dict[Figure, float] = {("torsional amplitude", None): degrees(float(turn.max()))}
    if modulus.size:
        name, unit = ("torsional stress", 1e-6) if stressed else ("torsional torque", 1.0)
        out[name, None] = unit * most.maximum
    if strongest is not None and rough.push is not None and rough.chain.damped:
        there = rough.modes[strongest.mode - 1].speed / strongest.order
        met = response(rough.chain, rough.push, speeds=np.array([there]))
        order = int(np.argmin(np.abs(met.orders - strongest.order)))
        size = abs(met.turns[0, order, rough.free_end])
        out["resonant amplitude", strongest.order] = degrees(float(size))
    return out
