"""The torsional vibration of an engine or a drive line: all that is asked of it, in one record.

An engine vibrates over a range of speeds with the gas of the operating point that is named, else
with that of the points of its file, between them by the speed; where gas cannot be computed, with
its moving parts alone, or, without speeds, not at all. A drive line without cylinders has modes
only, and critical speeds of the orders that are asked for.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_criticals import (
    Barred,
    Critical,
    barred,
    criticals,
    half_power_speeds,
    of_note,
    stresses,
)
from crankstar.dynamics.torsion_excitation import Excitation, excitation, firing_phases
from crankstar.dynamics.torsion_modes import Mode, torsion_modes
from crankstar.dynamics.torsion_response import Response, joined, response
from crankstar.dynamics.torsion_system import TorsionChain
from crankstar.dynamics.torsion_variable import variable_response
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.maxima import refined
from crankstar.mechanics.occurring_orders import check_orders
from crankstar.mechanics.operating_points import GasError, operating_state
from crankstar.spectra import Real

STEPS = 151
"""Speeds of a range that is not asked for."""
SLOWEST, FASTEST = 0.25, 1.1
"""Of the one speed that is known: the range that is taken."""
SAME_ORDER = 1e-9
GREATEST_UNKNOWNS = 4000
"""Of the model with the inertia of each angle: beyond, its matrix is too large."""
MEETING = 2
"""Speeds from which on there is a range in which the greatest can be looked for."""
HIGHEST_CRITICAL = 24.0
"""The highest order of critical speeds where none is asked for."""


@dataclass(frozen=True)
class TorsionAnalysis:
    """What twists, how it would vibrate freely, and how it does.

    `speeds` (rad/s, ascending) are those of `response`, empty where none is known: those of a range
    with its critical speeds, half-power points and maxima among them. `at` is the same
    at the one speed that is asked for, `exact` that with the inertia of each crank angle. `cycle`
    is that of the operating point and speed that are meant, `point` the one that is named.
    `without_gas` says why there is no gas; `push` is what drives it at any of the speeds.

    >>> from crankstar.engine.torsion import Disc
    >>> pair = [Disc(name="motor", inertia=2), Disc(name="fan", inertia=3, to="motor", stiffness=6)]
    >>> found = torsion(Chain(name="fan drive", discs=pair), speeds=[0, 9], orders=[1, 2])
    >>> [(each.order, round(each.speed**2, 9)) for each in found.criticals]
    [(1.0, 5.0), (2.0, 1.25)]
    """

    chain: TorsionChain
    modes: tuple[Mode, ...]
    speeds: Real
    criticals: tuple[Critical, ...]
    response: Response | None
    at: Response | None
    cycle: Cycle | None
    limit: float | None
    without_gas: str = ""
    range_assumed: bool = False
    exact: Response | None = None
    point: str = ""
    push: Excitation | None = None

    @cached_property
    def barred(self) -> tuple[Barred, ...]:
        """The speeds at which the stress of a shaft passes the limit; none without a limit."""
        if self.limit is None or self.response is None:
            return ()
        return barred(self.speeds, stresses(self.response)[0], limit=self.limit)

    @property
    def noted(self) -> list[Critical]:
        """Critical speeds of which readers are told, the strongest first.

        Without gas nothing says how strong those of several modes are beside each other: these are
        those of the first mode, by vector sum.
        """
        if self.cycle is not None:
            return of_note(self.criticals)
        first = [each for each in self.criticals if each.mode == 1]
        plain = {each._replace(torque=None, equilibrium=None): each for each in first}
        return [plain[each] for each in of_note([*plain])]

    @property
    def strongest(self) -> Critical | None:
        """The critical speed that counts for most; None without gas, by which that is decided."""
        return self.noted[0] if self.cycle is not None and self.criticals else None

    @property
    def free_end(self) -> int:
        """The first mass from the front that a shaft holds, of which the amplitude is told."""
        free = self.chain.rings
        return next((n for n, own in enumerate(self.chain.freedom) if own not in free), 0)


def torsion(
    source: Engine | Chain,
    *,
    point: str = "",
    speed: float | None = None,
    speeds: Sequence[float] | Real = (),
    orders: Sequence[float] | None = None,
    modes: int | None = None,
    off: Collection[int] = (),
    weaker: Mapping[int, float] | None = None,
) -> TorsionAnalysis:
    """The torsional vibration of an engine with a table [torsion], or of a drive line.

    `speed` is one of which more is listed, else that of the point; `speeds` are those of the range
    (rad/s); critical speeds are those of `orders`, and of so many `modes`; the response has all
    orders. Cylinders that are `off` are motored, `weaker` ones lack a share of their combustion.
    Raises TorsionError,
    OrderError for an order that does not occur in an engine, and GasError for an operating point
    that it has not.

    >>> from crankstar.files.catalog import load
    >>> disc = {"name": "flywheel", "inertia": "1 kg*m^2", "to": "rear", "stiffness": "1 MN*m/rad"}
    >>> own = {"inertia": "0.02 kg*m^2", "stiffness": "0.6 MN*m/rad", "disc": [disc]}
    >>> found = torsion(load("audi-25-tfsi", changes={"torsion": own}), speeds=[100])
    >>> found.chain.names[-1], found.response.turns.shape, found.without_gas
    ('flywheel', (1, 48, 6), '')
    """
    found = torsion_on_grid(
        source,
        point=point,
        speed=speed,
        speeds=speeds,
        orders=orders,
        modes=modes,
        off=off,
        weaker=weaker,
    )
    return found if isinstance(source, Chain) else peaked(found)


def torsion_on_grid(
    source: Engine | Chain,
    *,
    point: str = "",
    speed: float | None = None,
    speeds: Sequence[float] | Real = (),
    orders: Sequence[float] | None = None,
    modes: int | None = None,
    single: bool = True,
    off: Collection[int] = (),
    weaker: Mapping[int, float] | None = None,
) -> TorsionAnalysis:
    """The same as `torsion` at the speeds of the range and critical ones, not yet at the peaks.

    For those who refine other curves (`peaked`), or a single value. What is listed of the one
    `speed` is left out unless `single`. Raises what `torsion` raises.
    """
    chain = torsion_chain(source)
    free = torsion_modes(chain)
    if isinstance(source, Chain):
        return _of_chain(source, chain, free, speeds, orders, modes)
    check_orders(source, orders or (), gas=True)
    found, why = _cycle(source, point, speed, off, weaker or {})
    if point and speed is None and not len(speeds):
        speed = operating_state(source, point=point).speed
    wanted, assumed = _range(source, speed, speeds)
    limit = None if source.torsion is None else source.torsion.shear_limit
    if not len(wanted):
        return TorsionAnalysis(chain, free, wanted, (), None, None, found, limit, why)
    push = excitation(chain, source, found, ends=_ends(wanted), point=point)
    own = replace(push, course=None)
    driven = found is not None or push.inertia is not None
    alone = driven and single
    meeting = orders or [float(k) for k in push.orders if k <= HIGHEST_CRITICAL]
    rough = TorsionAnalysis(
        chain=chain,
        modes=free,
        speeds=wanted,
        criticals=criticals(
            chain,
            orders=meeting,
            low=float(wanted[0]),
            high=float(wanted[-1]),
            modes=modes,
            phases=firing_phases(source),
            excitation=push if driven else None,
        ),
        response=None,
        at=response(chain, own, speeds=np.array([speed])) if alone and speed else None,
        cycle=found,
        limit=limit,
        without_gas=why,
        range_assumed=assumed,
        exact=_exact(source, chain, own, speed) if alone and speed else None,
        point=point,
        push=push,
    )
    if not driven:
        return rough
    speeds = _with_criticals(source, rough, push, whole=not orders and modes is None)
    return replace(rough, speeds=speeds, response=response(chain, push, speeds=speeds))


def _with_criticals(
    engine: Engine, found: TorsionAnalysis, push: Excitation, *, whole: bool
) -> Real:
    """The speeds with the critical ones of all orders and modes, and the main half-power points.

    `whole` says that those of the analysis are all.
    """
    chain, low, high = found.chain, found.speeds[0], found.speeds[-1]
    if not chain.damped or not low < high:  # without damping there is no bound there
        return found.speeds
    every = found.criticals
    if not whole:
        every = criticals(
            chain,
            orders=[float(k) for k in push.orders if k <= HIGHEST_CRITICAL],
            low=float(low),
            high=float(high),
            phases=firing_phases(engine),
            excitation=push,
        )
    beside = (half_power_speeds(chain, each, found.modes) for each in of_note(every))
    noted = [speed for both in beside for speed in both]
    more = np.array([*(each.speed for each in every), *noted])
    return np.union1d(found.speeds, more[(low < more) & (more < high)])


def peaked(
    found: TorsionAnalysis, *, curves: Callable[[Response], Real] | None = None
) -> TorsionAnalysis:
    """The same with the speeds at which the vibration is greatest, and those that the limit bars.

    `curves` are values of a response [speed, curve] of which the maxima are wanted, else the
    torques over the cycle, the turn of the free end and the whole heat.

    >>> from crankstar.files.catalog import load
    >>> disc = {"name": "flywheel", "inertia": "1 kg*m^2", "to": "rear", "stiffness": "1 MN*m/rad"}
    >>> own = {"inertia": "0.02 kg*m^2", "stiffness": "0.6 MN*m/rad", "disc": [disc]}
    >>> five = load("audi-25-tfsi", changes={"torsion": own})
    >>> rough, fine = (torsion(five, speeds=np.linspace(100, 700, n)).response for n in (2, 151))
    >>> bool(np.allclose(rough.peak.max(axis=0), fine.peak.max(axis=0), rtol=1e-6))
    True
    """
    chain, whole, push = found.chain, found.response, found.push
    if whole is None or push is None or not chain.damped or found.speeds.size < MEETING:
        return found

    def told(own: Response) -> Real:
        heat = own.heat.sum(axis=-1) + own.absolute_heat.sum(axis=-1)
        return np.column_stack([own.peak, own.peak_turn(found.free_end), heat])

    limits = None
    if found.limit is not None and curves is None:
        modulus = [each.modulus or np.nan for each in chain.sections]
        limits = np.array([*(found.limit * np.array(modulus)), np.nan, np.nan])
    whole = refined(
        found.speeds,
        whole,
        at=lambda speeds: response(chain, push, speeds=speeds),
        joined=joined,
        curves=curves or told,
        limits=limits,
    )
    return replace(found, speeds=whole.speeds, response=whole)


def _ends(speeds: Real) -> tuple[float, float]:
    """The first and the last of some speeds."""
    return float(speeds[0]), float(speeds[-1])


def _exact(engine: Engine, chain: TorsionChain, push: Excitation, speed: float) -> Response | None:
    """The response with the inertia of each angle; None without masses, or for orders between."""
    lowest = 1.0 if engine.cycle == "two-stroke" else 0.5
    between = np.abs(push.orders / lowest - np.rint(push.orders / lowest)) > SAME_ORDER
    unknown = 2 * float(push.orders.max()) / lowest * chain.freedoms
    if push.inertia is None or between.any() or unknown > GREATEST_UNKNOWNS:
        return None
    return variable_response(chain, push, speed=speed, lowest=lowest)


def _of_chain(
    source: Chain,
    chain: TorsionChain,
    free: tuple[Mode, ...],
    speeds: Sequence[float] | Real,
    orders: Sequence[float] | None,
    modes: int | None,
) -> TorsionAnalysis:
    wanted = np.sort(np.asarray(speeds, float))
    if not wanted.size and source.speed is not None:
        wanted = np.array([SLOWEST, FASTEST]) * source.speed
    meeting = (
        criticals(chain, orders=orders, low=float(wanted[0]), high=float(wanted[-1]), modes=modes)
        if orders and wanted.size
        else ()
    )
    return TorsionAnalysis(chain, free, wanted, meeting, None, None, None, None)


def _cycle(
    engine: Engine,
    point: str,
    speed: float | None,
    off: Collection[int],
    weaker: Mapping[int, float],
) -> tuple[Cycle | None, str]:
    """The cycle of an operating point, or why there is none."""
    try:
        return cycle(engine, point=point, speed=speed, off=off, weaker=weaker), ""
    except GasError as error:
        if point or off or weaker:
            raise
        return None, str(error)


def _range(
    engine: Engine, speed: float | None, speeds: Sequence[float] | Real
) -> tuple[Real, bool]:
    """The speeds of the range, and whether they are assumed about a single one."""
    if len(speeds):
        return np.sort(np.asarray(speeds, float)), False
    known = {engine.speed}
    if engine.gas is not None:
        known |= {engine.gas.speed, *(point.speed for point in engine.gas.points)}
    given = sorted({each for each in known if each is not None} or ({speed} if speed else set()))
    if not given:
        return np.array([]), False
    if len(given) > 1:
        return np.linspace(given[0], given[-1], STEPS), False
    return np.linspace(SLOWEST * given[0], FASTEST * given[0], STEPS), True
