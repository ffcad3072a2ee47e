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

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, permutations
from typing import Any, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.gas_torque import gas_torque
from crankstar.mechanics.operating_points import (
    GasError,
    OperatingState,
    operating_state,
    points_by_speed,
    resolved,
)
from crankstar.spectra import Complex, Real, Spectrum

STRAIGHT = 17
"""Speeds of a range over which gas is bent, from each of which it may be taken to go straight."""
WALL_NODES = 9
"""Speeds of a polynomial through cycles with heat to the walls: to some 1e-5 over a range."""


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


def is_linear(engine: Engine) -> bool:
    """Whether the pressure of an engine is linear in its load."""
    values, _assumed = resolved(engine)
    if values["process"] == "otto":
        return True
    plain = not values.get("variable_gamma") and values.get("wall_temperature") is None
    return values["process"] == "heat-release" and plain


def _charged_alike(one: Cycle, other: Cycle) -> bool:
    """Whether two loads have one charge: a pressure that is assumed rises with the load."""
    return one.values.get("intake_pressure") == other.values.get("intake_pressure")


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
    both = [cycle(engine, point=point, speed=speed, imep=each) for each in (low, high)]
    if low == high or not is_linear(engine) or not _charged_alike(*both):
        return _stacked(
            loads, [cycle(engine, point=point, speed=speed, imep=each) for each in loads]
        )
    ends = _stacked(np.array([low, high]), both)
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


class GasCourse(NamedTuple):
    """Values of a cycle against speed: in pieces, each the polynomial through some of its speeds.

    `starts` are the speeds (rad/s) at which the pieces after the first begin; `nodes` and `values`
    [node, ...] are those of each piece.
    """

    starts: tuple[float, ...]
    nodes: tuple[Real, ...]
    values: tuple[Complex, ...]

    def at(self, speed: float | Real) -> Complex:
        """The values at crank speeds (rad/s) [speed, ...]; without that axis at one.

        >>> nodes = np.array([1.0]), np.array([2.0, 4.0])
        >>> own = GasCourse((2.0,), nodes, (np.array([5.0]), np.array([5.0, 7.0])))
        >>> float(own.at(3.0)), own.at(np.array([0.0, 4.0])).tolist()
        (6.0, [5.0, 7.0])
        """
        wanted = np.atleast_1d(np.asarray(speed, float))
        piece = np.searchsorted(self.starts, wanted, side="right")
        out = np.zeros((wanted.size, *self.values[0].shape[1:]), self.values[0].dtype)
        for number in np.unique(piece).tolist():
            own = piece == number
            weights = _lagrange(self.nodes[number], wanted[own])
            out[own] = np.tensordot(weights, self.values[number], axes=1)
        return out if np.ndim(speed) else out[0]


def _lagrange(nodes: Real, at: Real) -> Real:
    """The weights [at, node] of values at nodes in the polynomial through them."""
    out = np.ones((at.size, nodes.size))
    for one, other in permutations(range(nodes.size), 2):
        out[:, one] *= (at - nodes[other]) / (nodes[one] - nodes[other])
    return out


def gas_course(
    engine: Engine,
    value: Callable[[Cycle], Complex],
    *,
    ends: tuple[float, float],
    point: str = "",
    off: Collection[int] = (),
    weaker: Mapping[int, float] | None = None,
) -> GasCourse:
    """Values of the cycle that are linear in the pressure, at any speed between two (rad/s).

    Each is that of `cycle` at its speed: between operating points straight from one to the next. Of
    a single point only what its speed changes: friction, which a brake mean effective pressure has
    to overcome, and the heat to the walls. Friction is a polynomial of the speed, so that three
    speeds give it exactly; with heat to the walls it is one of `WALL_NODES`. Raises GasError.
    """

    def of(name: str, speed: float) -> Complex:
        return value(cycle(engine, point=name, speed=speed, off=off, weaker=weaker))

    known = {} if point else points_by_speed(engine)
    knots = [speed for speed in known if ends[0] < speed < ends[1]]
    bounds = [ends[0], *knots, ends[1]]
    nodes = [
        np.array([low, high])
        if low < high
        and len(operating_state(engine, point=point, speed=(low + high) / 2).shares) > 1
        else _speeds_of(engine, point, low, high)
        for low, high in pairwise(bounds)
    ]
    values = [np.array([of(point, float(speed)) for speed in own]) for own in nodes]
    return GasCourse(tuple(knots), tuple(nodes), tuple(values))


def _speeds_of(engine: Engine, point: str, low: float, high: float) -> Real:
    """The speeds at which the cycles of one point are needed for all between two speeds."""
    middle = (low + high) / 2
    name = operating_state(engine, point=point, speed=middle).point
    values, _assumed = resolved(engine, point=name, speed=middle)
    walls = values.get("wall_temperature") is not None
    rubs = "bmep" in values and values.get("friction_pressure") is None
    if low == high or not (walls or (rubs and values["friction"] != "none")):
        return np.array([middle])
    ends = (cycle(engine, point=name, speed=each) for each in (low, high))
    if not walls and is_linear(engine) and _charged_alike(*ends):
        return np.array([low, middle, high])
    angle = (np.arange(WALL_NODES) + 0.5) * np.pi / WALL_NODES
    return middle - (high - low) / 2 * np.cos(angle) / np.cos(angle[0])


def straight_speeds(engine: Engine, ends: tuple[float, float]) -> Real:
    """Speeds (rad/s) from which gas may be taken to go straight to the next, without a named point.

    Those of the operating points, and a few more where friction or heat to the walls bend it.

    >>> from crankstar.files.catalog import load
    >>> straight_speeds(load("audi-25-tfsi"), (80.0, 600.0)).round(1).tolist()
    [78.5, 555.0, 680.7]
    >>> straight_speeds(load("honda-b18c"), (80.0, 600.0)).tolist()
    [600.0]
    """
    known = [*points_by_speed(engine)]
    bounds = [ends[0], *known[:1], *known[-1:], ends[1]]
    bent = [
        np.linspace(low, high, STRAIGHT)
        for low, high in ((bounds[0], bounds[1]), (bounds[-2], bounds[-1]))
        if low < high and _speeds_of(engine, "", low, high).size > 1
    ]
    return np.unique(np.concatenate([known or [ends[1]], *bent]))


def gas_over_speeds(
    engine: Engine,
    speeds: Sequence[float] | Real,
    *,
    point: str = "",
    weaker: Mapping[int, float] | None = None,
) -> Spectrum:
    """The gas torque of the engine at each speed (rad/s), N m [speed, order]. Raises GasError.

    Each is that of `cycle` at this speed, see `gas_course`; cylinders are `weaker` as there.
    """
    wanted = np.atleast_1d(np.asarray(speeds, float))
    ends = float(wanted.min()), float(wanted.max())
    one = gas_torque(cycle(engine, point=point, speed=ends[0], weaker=weaker)).total
    found = gas_course(
        engine,
        lambda each: spectra.amplitude(gas_torque(each).total),
        ends=ends,
        point=point,
        weaker=weaker,
    )
    return spectra.real_signal(one.orders, found.at(wanted))


def vibrating_state(
    engine: Engine, *, point: str = "", speed: float | None = None
) -> OperatingState:
    """The operating state of what needs a speed. Raises GasError without one."""
    state = operating_state(engine, point=point, speed=speed)
    if state.speed is None:
        raise GasError('give the speed, as in --speed "800 rpm"')
    return state
