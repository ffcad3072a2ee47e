"""What an engine does on its mounts, by figures: what an answer rests on moves them."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np

from crankstar.analysis.assumptions import LOAD_OF, Answer
from crankstar.analysis.tried_values import Figure, Figures
from crankstar.dynamics.mount_analysis import MountAnalysis, mounts
from crankstar.dynamics.mount_modes import mount_modes
from crankstar.dynamics.mount_response import rms
from crankstar.dynamics.mounted_block import borne, mounted_block, settled
from crankstar.engine.engine import Engine
from crankstar.mechanics.operating_points import GasError
from crankstar.spectra import Real
from crankstar.studies.answer_parts import (
    IN_VIBRATION,
    gas_as_in,
    gas_of,
    tuned_on_mounts,
    usual_gas,
)
from crankstar.studies.assumed_gas import usual_load
from crankstar.studies.assumed_loads import of_load
from crankstar.studies.gas_alone import lacking_gas

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

Judged = Callable[[Engine], tuple[Mapping[str, float], str]]
"""Figures of an engine on its mounts by name, and why they have no gas in them; empty with it."""


def _unit_on_mounts(quantity: str) -> str:
    return "N" if quantity.startswith(LOAD_OF) else ON_MOUNTS.get(quantity, "Hz")


def on_mounts(
    engine: Engine,
    *,
    point: str = "",
    speed: float | None = None,
    speeds: Sequence[float] | Real = (),
    at: Sequence[float] | None = None,
    judged: Judged | None = None,
) -> Answer:
    """The natural frequencies of the block, and what its mounts transmit and a point of it does.

    The maximum of each over the speeds, looked for from where it is of the engine as given and from
    both ends; `at` is the point of the block (up, right, z; m), as of `mount_analysis.mounts`. Also
    what each mount bears upward at rest, measured by the maximum of them. `judged` gives figures
    instead of those maxima.
    """
    whole = mounts(engine, point=point, speed=speed, speeds=speeds, at=at)
    over = whole.over
    ends = None if over is None else (float(over.speeds[0]), float(over.speeds[-1]))
    places: list[float] = []
    if over is not None:
        tops = [int(np.nanargmax(curve)) for curve in _forced(whole).values()]
        places = over.speeds[sorted({0, len(over.speeds) - 1, *tops})].tolist()
    gas, gasless = gas_of(engine, point=point, speed=speed)

    def greatest(each: Engine) -> tuple[Mapping[str, float], str]:
        found = mounts(each, point=point, speed=speed, speeds=places, at=at)
        why = "" if found.over is None else found.over.excitation.without_gas
        return {name: float(np.nanmax(own)) for name, own in _forced(found).items()}, why

    def figures(each: Engine) -> Figures:
        return with_gas(gas_as_in(engine, each), burns=gas is not None)

    def with_gas(each: Engine, *, burns: bool = True) -> Figures:
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
            told, why = (judged or greatest)(each)
            if burns and why:
                raise GasError(why)
            out |= {(name, None): size for name, size in told.items()}
        return out

    def least(each: Engine) -> Mapping[str, float]:
        block = mounted_block(each)
        loads = borne(block, settled(block)[1])
        return {f"{LOAD_OF}{own.name}": float(np.abs(loads).max()) for own in block.mounts}

    usual, short = usual_gas(engine, speed=speed) if places else (None, "")
    left = None if usual is None else usual_load(usual, with_gas, IN_VIBRATION)
    if places and left is None:
        left = lacking_gas(engine, with_gas, IN_VIBRATION, speed=speed, point=point)
    return Answer(
        figures=figures,
        unit=lambda quantity, _engine: _unit_on_mounts(quantity),
        uses=("inertia", "mounts", *(("gas",) if gas is not None else ())),
        gas=gas,
        gasless="" if left else IN_VIBRATION,
        why_gasless=gasless or short,
        choices=[*([left] if left else []), *of_load(engine, gas)],
        least=least,
        tunings=[]
        if over is None or ends is None
        else [tuned_on_mounts(over.orders.tolist(), between=ends)],
    )


def mounted_modes() -> Answer:
    """The natural frequencies of the block on its mounts alone."""

    def figures(each: Engine) -> Figures:
        modes = mount_modes(mounted_block(each))
        return {(f"mode {number}", None): mode.frequency for number, mode in enumerate(modes, 1)}

    return Answer(
        figures=figures,
        unit=lambda quantity, _engine: _unit_on_mounts(quantity),
        uses=("inertia", "mounts"),
    )


def _forced(found: MountAnalysis) -> dict[str, Real]:
    """What the mounts transmit and what the point does, rms, against speed; nothing without one."""
    over, at = found.over, found.point
    if over is None:
        return {}
    each = [rms(over.mount_force[:, :, index]) for index in range(len(over.block.mounts))]
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
