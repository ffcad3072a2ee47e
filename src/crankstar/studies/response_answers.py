"""What engine, crankshaft and mounts do, by figures: answers that resonate."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import degrees
from typing import TYPE_CHECKING, Any

import numpy as np

from crankstar.analysis.assumptions import LOAD_OF, Answer
from crankstar.analysis.tried_values import Figure, Figures, Tuning
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.spectra import Real
from crankstar.studies.answer_parts import IN_VIBRATION, gas_of, usual_gas
from crankstar.studies.assumed_gas import usual_load

if TYPE_CHECKING:
    from crankstar.dynamics.mount_analysis import MountAnalysis
    from crankstar.dynamics.torsion_analysis import TorsionAnalysis
    from crankstar.dynamics.torsion_criticals import Critical
    from crankstar.dynamics.torsion_response import Response
    from crankstar.studies.single_faults import Fault


def twist(
    engine: Engine,
    *,
    point: str = "",
    speed: float | None = None,
    speeds: Sequence[float] | Real = (),
) -> Answer:
    """The first natural frequency of torsion, and how far and how hard the crankshaft is twisted.

    The greatest turn of the free end, in which the uneven running of the whole is, and the greatest
    shear stress of a shaft over the speeds (its torque where none has a diameter); of the order
    that resonates most, the turn of the free end at that resonance.
    """
    from crankstar.dynamics.torsion_analysis import torsion_on_grid
    from crankstar.dynamics.torsion_chain import torsion_chain
    from crankstar.dynamics.torsion_modes import torsion_modes

    fixed: dict[str, Any] = {"point": point, "speed": speed, "single": False}
    whole = torsion_on_grid(engine, speeds=speeds, **fixed)
    ends = [float(whole.speeds[0]), float(whole.speeds[-1])] if len(whole.speeds) else []

    def figures(each: Engine) -> Figures:
        each = each if whole.cycle is not None else _gas_as_in(engine, each)
        rough = torsion_on_grid(each, speeds=ends, **fixed)
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

    tunings = []
    if ends and whole.response is not None:
        orders = whole.response.orders.tolist()
        tunings = [Tuning(natural, orders, (ends[0], ends[-1]))]
    return Answer(
        figures=figures,
        unit=lambda quantity, _engine: OF_TORSION[quantity],
        uses=("inertia", "torsion", *(("gas",) if whole.cycle is not None else ())),
        gas=whole.cycle,
        gasless=IN_VIBRATION,
        why_gasless="" if engine.gas is None else whole.without_gas,
        least=least,
        tunings=tunings,
    )


def twisting_modes() -> Answer:
    """The first natural frequency of torsion alone, which no gas and no damping moves."""
    from crankstar.dynamics.torsion_chain import torsion_chain
    from crankstar.dynamics.torsion_modes import torsion_modes

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
    from crankstar.dynamics.torsion_analysis import peaked
    from crankstar.dynamics.torsion_peaks import PeakOfSections
    from crankstar.dynamics.torsion_response import response

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
        out[name, None] = unit * most.greatest
    if strongest is not None and rough.push is not None and rough.chain.damped:
        there = rough.modes[strongest.mode - 1].speed / strongest.order
        met = response(rough.chain, rough.push, speeds=np.array([there]))
        order = int(np.argmin(np.abs(met.orders - strongest.order)))
        size = abs(met.turns[0, order, rough.free_end])
        out["resonant amplitude", strongest.order] = degrees(float(size))
    return out


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
ON_MOUNTS = {
    "mount load": "N",
    "mount force": "N",
    "mount moment": "N*m",
    "one mount": "N",
    "velocity at the point": "mm/s",
    "displacement at the point": "um",
    "acceleration at the point": "m/s^2",
    "weighted acceleration": "m/s^2",
    "transmissibility": "",
}
"""The units of the figures of an engine on its mounts, beside those of its modes, Hz."""


def _unit_on_mounts(quantity: str) -> str:
    return "N" if quantity.startswith(LOAD_OF) else ON_MOUNTS.get(quantity, "Hz")


def on_mounts(
    engine: Engine,
    *,
    point: str = "",
    speed: float | None = None,
    speeds: Sequence[float] | Real = (),
    at: Sequence[float] | None = None,
) -> Answer:
    """The natural frequencies of the block, and what its mounts transmit and a point of it does.

    The maximum of each over the speeds, looked for from where it is of the engine as given and from
    both ends; `at`
    is the point of the block (up, right, z; m), as of `mount_analysis.mounts`. Also what each mount
    bears upward at rest, measured by the greatest of them.
    """
    from crankstar.dynamics.mount_analysis import mounts
    from crankstar.dynamics.mount_modes import mount_modes
    from crankstar.dynamics.mounted_block import borne, mounted_block, settled

    whole = mounts(engine, point=point, speed=speed, speeds=speeds, at=at)
    over = whole.over
    ends = None if over is None else (float(over.speeds[0]), float(over.speeds[-1]))
    places: list[float] = []
    if over is not None:
        tops = [int(np.nanargmax(curve)) for curve in _forced(whole).values()]
        places = over.speeds[sorted({0, len(over.speeds) - 1, *tops})].tolist()

    def figures(each: Engine) -> Figures:
        return with_gas(_gas_as_in(engine, each))

    def with_gas(each: Engine) -> Figures:
        block = mounted_block(each)
        loads = settled(block)[1]
        modes = mount_modes(block)
        out: dict[Figure, float] = {
            ("mount load", None): float(np.linalg.norm(loads, axis=-1).max())
        }
        out |= {(f"mode {number}", None): mode.frequency for number, mode in enumerate(modes, 1)}
        out |= {
            (f"{LOAD_OF}{mount.name}", None): load
            for mount, load in zip(block.mounts, borne(block, loads).tolist(), strict=True)
        }
        if places:
            found = mounts(each, point=point, speed=speed, speeds=places, at=at)
            out |= {(name, None): float(np.nanmax(own)) for name, own in _forced(found).items()}
        return out

    def least(each: Engine) -> Mapping[str, float]:
        block = mounted_block(each)
        loads = borne(block, settled(block)[1])
        return {f"{LOAD_OF}{own.name}": float(np.abs(loads).max()) for own in block.mounts}

    gas, why = gas_of(engine, point=point, speed=speed)
    usual = usual_gas(engine, speed=speed)[0] if places else None
    return Answer(
        figures=figures,
        unit=lambda quantity, _engine: _unit_on_mounts(quantity),
        uses=("inertia", "mounts", *(("gas",) if gas is not None else ())),
        gas=gas,
        gasless="" if usual else IN_VIBRATION,
        why_gasless=why,
        choices=[usual_load(usual, with_gas, IN_VIBRATION)] if usual else [],
        least=least,
        tunings=[] if over is None else [_on_mounts_tuned(over.orders.tolist(), *(ends or (0, 0)))],
    )


def mounted_modes() -> Answer:
    """The natural frequencies of the block on its mounts alone."""
    from crankstar.dynamics.mount_modes import mount_modes
    from crankstar.dynamics.mounted_block import mounted_block

    def figures(each: Engine) -> Figures:
        modes = mount_modes(mounted_block(each))
        return {(f"mode {number}", None): mode.frequency for number, mode in enumerate(modes, 1)}

    return Answer(
        figures=figures,
        unit=lambda quantity, _engine: _unit_on_mounts(quantity),
        uses=("inertia", "mounts"),
    )


def _gas_as_in(engine: Engine, changed: Engine) -> Engine:
    """A changed engine, without gas where the file has none: a usual cycle may have been varied."""
    return with_values(changed, gas=None) if engine.gas is None else changed


def _on_mounts_tuned(orders: Sequence[float], low: float, high: float) -> Tuning:
    """The natural frequencies of an engine on its mounts and the orders of some speeds, rad/s."""
    from crankstar.dynamics.mount_modes import mount_modes
    from crankstar.dynamics.mounted_block import mounted_block

    def natural(each: Engine) -> list[float]:
        return [mode.speed for mode in mount_modes(mounted_block(each))]

    return Tuning(natural, orders, (low, high))


def _forced(found: MountAnalysis) -> dict[str, Real]:
    """What the mounts transmit and what the point does, rms, against speed; nothing without one."""
    from crankstar.dynamics.mount_response import rms

    over, at = found.over, found.point
    if over is None:
        return {}
    each = [rms(over.mount_force[:, :, place]) for place in range(len(over.block.mounts))]
    curves = {
        "mount force": rms(over.ground_force[..., :3]),
        "mount moment": rms(over.ground_force[..., 3:]),
        "one mount": np.max(each, axis=0),
        "velocity at the point": 1e3 * rms(over.velocity(at)),
        "displacement at the point": 1e6 * rms(over.displacement(at)),
        "acceleration at the point": rms(over.acceleration(at)),
        "weighted acceleration": rms(over.hand_arm(at)),
    }
    if np.isfinite(over.transmissibility).any():
        curves["transmissibility"] = np.nanmax(over.transmissibility, axis=1)
    return curves


def felt(
    engine: Engine,
    faults: Sequence[Fault],
    *,
    point: str = "",
    speed: float | None = None,
    orders: Sequence[float] = (),
    at: Sequence[float] | None = None,
) -> Answer:
    """What shakes the block and the velocity of a point of it, of an engine with faults, by order.

    Of the `orders` that are named, at the point `at` (up, right, z; m) or the centre of mass,
    wherever that is: the numbers of `Shaken.sizes`.
    """
    from crankstar.studies.single_faults import shaken

    units = {"force": "N", "couple": "N*m", "roll": "N*m", "torque": "N*m", "velocity": "mm/s"}

    def figures(each: Engine) -> Figures:
        found = shaken(each, faults, point=point, speed=speed, orders=orders)
        return {
            (name, order): size
            for order, row in zip(found.orders.tolist(), found.sizes(at).tolist(), strict=True)
            for name, size in zip(units, row, strict=True)
        }

    gas, why = gas_of(engine, point=point, speed=speed)
    usual = usual_gas(engine, speed=speed)[0]
    tunings = []
    if engine.mounts:
        now = shaken(engine, faults, point=point, speed=speed, orders=orders)
        tunings = [_on_mounts_tuned(now.orders.tolist(), now.speed, now.speed)]
    return Answer(
        figures=figures,
        unit=lambda quantity, _engine: units[quantity],
        uses=("inertia", "mounts", *(("gas",) if gas is not None else ())),
        gas=gas,
        gasless="" if usual else IN_VIBRATION,
        why_gasless=why,
        choices=[usual_load(usual, figures, IN_VIBRATION)] if usual else [],
        tunings=tunings,
    )
