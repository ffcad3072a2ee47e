"""Gas torque at many loads: over the mean effective pressure, and over the speed.

A chamber of constant gamma and tight walls, and the Otto cycle, have a pressure that is linear in
the heat, and so in the load. Their torque at any load is then a sum of two spectra,

    T_k(imep) = T_k(a) + (imep - a)/(b - a) (T_k(b) - T_k(a))       N m

exactly, from two cycles. Other processes are computed load by load.

Handbooks write the torque of one cylinder as the tangential pressure on its crank circle,

    t = T/(A R) = 2 T/V_d                                           Pa

of which t_k is the amplitude of order k: it depends on the load and the cycle, and not on the size
of the engine.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.gas_torque import gas_torque
from crankstar.mechanics.operating_points import GasError, operating_state, resolved
from crankstar.spectra import Complex, Real, Spectrum


@dataclass(frozen=True)
class LoadedTorques:
    """Gas torque at many loads: mean [load, chamber] and spectrum [load, chamber, order], N m."""

    imep: Real
    numbers: tuple[int, ...]
    swept: Real
    mean: Real
    torque: Spectrum

    @property
    def total(self) -> Spectrum:
        """The torque of the engine [load, order], rounding errors set to zero."""
        return spectra.total(self.torque)

    @property
    def tangential(self) -> Complex:
        """Amplitudes of the tangential pressure of the first chamber, Pa [load, order].

        Their phase counts from the dead centre at which it fires where it fires at 0.
        """
        return spectra.amplitude(self.torque)[:, 0] * (2 / self.swept[0])


def is_linear(engine: Engine, *, point: str = "", speed: float | None = None) -> bool:
    """Whether the pressure of an engine is linear in its load."""
    values, _assumed = resolved(engine, point=point, speed=speed)
    if values["process"] == "otto":
        return True
    plain = not values.get("variable_gamma") and values.get("wall_temperature") is None
    return values["process"] == "heat-release" and plain


def torques_at_loads(
    engine: Engine, *, imep: Sequence[float] | Real, point: str = "", speed: float | None = None
) -> LoadedTorques:
    """The gas torque at each indicated mean effective pressure (Pa). Raises GasError.

    >>> from crankstar.files.catalog import load
    >>> found = torques_at_loads(load("honda-b18c"), imep=[4e5, 8e5, 12e5])
    >>> second = abs(spectra.amplitude(spectra.selected(found.total, 2)))[:, 0]

    What compression gives stands still, the rest grows with the load:

    >>> bool(np.isclose(second[2] - second[1], second[1] - second[0], rtol=0.1))
    True
    """
    loads = np.atleast_1d(np.asarray(imep, float))
    if engine.gas is not None and engine.gas.trace is not None:
        raise GasError("a measured pressure has a load of its own: ask for no other")
    low, high = float(loads.min()), float(loads.max())
    if low == high or not is_linear(engine, point=point, speed=speed):
        return _stacked(
            loads, [cycle(engine, point=point, speed=speed, imep=each) for each in loads]
        )
    ends = _stacked(
        np.array([low, high]),
        [cycle(engine, point=point, speed=speed, imep=each) for each in (low, high)],
    )
    share = (loads - low) / (high - low)

    def between(values: Any) -> Any:
        first, last = values
        return first + np.multiply.outer(share, last - first)

    torque = replace(
        ends.torque, forward=between(ends.torque.forward), backward=between(ends.torque.backward)
    )
    return replace(ends, imep=loads, mean=between(ends.mean), torque=torque)


def _stacked(loads: Real, cycles: Sequence[Cycle]) -> LoadedTorques:
    found = [gas_torque(each) for each in cycles]
    places = cycles[0].volumes
    return LoadedTorques(
        loads,
        places.numbers,
        places.swept[[*places.kind]],
        np.array([each.mean for each in found]),
        spectra.stacked([each.torque for each in found]),
    )


def points_by_speed(engine: Engine) -> dict[float, str]:
    """The operating points between which gas is interpolated, by speed; none unless two or more.

    The load of the table [gas] itself is one, by the name "", where it has one.

    >>> from crankstar.files.catalog import load
    >>> points_by_speed(load("honda-b18c"))
    {}
    """
    if engine.gas is None:
        return {}
    known = {each.speed: each.name for each in engine.gas.points if each.speed is not None}
    own = operating_state(engine)
    if not own.point and own.speed is not None:
        known[own.speed] = ""
    return known if len(known) > 1 else {}


def gas_over_speeds(
    engine: Engine,
    speeds: Sequence[float] | Real,
    *,
    point: str = "",
    weaker: Mapping[int, float] | None = None,
) -> Spectrum:
    """The gas torque of the engine at each speed (rad/s), N m [speed, order]. Raises GasError.

    Cylinders are `weaker` as in `cycle`. Of a named operating point at all speeds alike. Without
    one: between the operating points of the file that have speeds the torque is interpolated, and
    kept beyond the first and the last; the load of the file itself where there are no two of them.
    """
    wanted = np.atleast_1d(np.asarray(speeds, float))
    by_speed = {} if point else points_by_speed(engine)
    known = sorted(by_speed)
    if not known:
        one = gas_torque(cycle(engine, point=point, speed=float(wanted[-1]), weaker=weaker)).total
        shape = (wanted.size, one.orders.size)
        return replace(
            one,
            forward=np.broadcast_to(one.forward, shape),
            backward=np.broadcast_to(one.backward, shape),
        )
    spectra_known = [
        gas_torque(cycle(engine, point=by_speed[at], weaker=weaker)).total for at in known
    ]
    first = spectra_known[0]
    after = np.clip(np.searchsorted(known, wanted), 1, len(known) - 1)
    low, high = np.array(known)[after - 1], np.array(known)[after]
    share = np.clip((wanted - low) / (high - low), 0.0, 1.0)[:, None]
    ahead, behind = (np.array([getattr(s, w) for s in spectra_known]) for w in _WAYS)
    return replace(
        first,
        forward=(1 - share) * ahead[after - 1] + share * ahead[after],
        backward=(1 - share) * behind[after - 1] + share * behind[after],
    )


class Turning(NamedTuple):
    """A point that is named or meant, "" where the load is between points, and a speed, rad/s."""

    point: str
    speed: float


def vibrating_state(engine: Engine, *, point: str = "", speed: float | None = None) -> Turning:
    """The operating point and speed at which an engine on its mounts vibrates.

    Raises GasError without a speed, and for a point that the engine has not.
    """
    state = operating_state(engine, point=point, speed=speed)
    if state.speed is None:
        raise GasError('give the speed, as in --speed "800 rpm"')
    alone = bool(point) or speed is None or len(points_by_speed(engine)) == 0
    return Turning(state.point if alone else "", state.speed)


_WAYS = ("forward", "backward")
