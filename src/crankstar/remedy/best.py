"""Best weights: the unbalances in chosen planes that minimise an aim within limits, with proof.

Aims are convex in the unbalances (`aims`), so the minimum is a second-order cone programme
(`programme`). A peak over a turn is a cone at every crank angle; the angles at which it is reached
are added one by one. The certificate is two numbers: the aim measured on the finished engine, and a
lower bound that no weights within the limits can beat.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import NamedTuple, get_args

import numpy as np

from crankstar import spectra
from crankstar.dynamics.bearings import Model
from crankstar.engine.copies import with_weights
from crankstar.engine.engine import Engine
from crankstar.engine.records import Weight
from crankstar.language.messages import _
from crankstar.mechanics.balance import unit_unbalance
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.remains import OPTIMISED
from crankstar.remedy.aim_names import aim_name, aim_text
from crankstar.remedy.aims import (
    Aim,
    Plane,
    Quantity,
    Setting,
    cones,
    influence,
    maxima,
    measured,
    setting,
)
from crankstar.remedy.counterweights import (
    RemedyError,
    apart,
    on_the_shaft,
    turned_weights,
    without_counterweights,
)
from crankstar.remedy.loads import loads
from crankstar.remedy.programme import Ceiling, Cone, MissingSolverError, Solution, solved
from crankstar.spectra import Complex, Real

FIRST_ANGLES = 48
"""Crank angles per turn with which the search for peaks begins."""
ROUNDS = 30
GREATEST_TURNS = 60
"""Longest period of geared shafts, in turns, over which a peak is searched."""
SLACK = 3e-8
"""Loss in the aim, in its unit and as a share of it, accepted for smaller weights."""
CLOSE = 3e-9
"""Greatest error of a peak between the chosen angles, m r w^2 (a) or a share of the bare value."""
GENTLE = 0.03
"""Weight of the unbalances beside the bearing loads, among equally good sets of weights."""
NOISE = 1e-6
"""Share of the greatest unbalance below which a weight is rounding of the solver."""
MOST = 2.0
"""Greatest unbalance of one weight, in unbalances of all pins together."""
TIDY = 1e-7
"""Share of the weights below which their sum, or the sum of their moments, is rounding."""
TIDY_BEARINGS = 1e-4
"""The same with an aim or limit for bearings, where a small net force allows smaller weights."""


class Limit(NamedTuple):
    """An upper limit for an aim, in its unit; `implied` where the caller gave none."""

    aim: Aim
    at_most: float
    implied: bool = False


class Best(NamedTuple):
    """The best weights: the engine with them, unbalances by plane, and the certificate.

    `unbalance` in m r, up + i right at theta = 0, beside the weights of the file if they are
    `kept`. `value` is the `aim` with these weights, `before` without them; no weights within the
    limits make it smaller than `bound`. `limits` pairs each limit with the value reached; `angles`
    (radians) are the crank angles of a peak.
    """

    engine: Engine
    planes: tuple[Plane, ...]
    unbalance: tuple[complex, ...]
    value: float
    before: float
    bound: float
    limits: tuple[tuple[Limit, float], ...]
    angles: tuple[float, ...]
    aim: Aim
    kept: bool
    model: Model = "determinate"


def best_weights(
    engine: Engine,
    *,
    planes: Sequence[Plane],
    aim: Aim,
    limits: Sequence[Limit] = (),
    greatest_unbalance: float | None = None,
    reference: Reference | None = None,
    bare: bool = False,
    model: Model = "determinate",
    speed: float | None = None,
) -> Best:
    """The weights in these planes that minimise `aim`, beside those of the crankshafts.

    With `bare` they replace those of the crankshafts.

    `greatest_unbalance` (m r of the first cylinder) bounds each of them; the default is twice the
    unbalance of all pins. `model`: how main bearings share a load. Raises RemedyError, also where
    the limits cannot be met, and by how much (in N at `speed`, rad/s, if that is given).

    >>> from crankstar.files.catalog import load
    >>> middle = [Plane("crank", 0.0)]
    >>> best = best_weights(load("single"), planes=middle, aim=Aim("force", rms=True))
    >>> round(abs(best.unbalance[0]), 9)  # half of the reciprocating mass
    0.5
    """
    _possible(engine, planes)
    most = _most(engine, greatest_unbalance)
    for limit in limits:
        if not limit.at_most >= 0 or not np.isfinite(limit.at_most):
            raise RemedyError(
                "a limit of {limit} cannot be met; give a number from 0 up",
                limit=f"{limit.at_most:g}",
            )
    for wanted in (aim, *(limit.aim for limit in limits)):
        _check_aim(wanted)
    start = without_counterweights(engine) if bare else engine
    case = setting(start, planes, reference=reference, model=model)
    _check_moved(case, aim)
    try:
        x, bound = _least(case, aim, limits, most)
        if x is None:
            told = partial(aim_text, engine=engine, speed=speed)
            raise RemedyError(_infeasible(case, limits, most, told))
    except MissingSolverError:
        needed = 'the best weights need Clarabel: pip install "crankstar[weights]"'
        raise RemedyError(needed) from None
    x = _tidied(case, planes, x, [aim, *(limit.aim for limit in limits)], most)
    value = measured(case, aim, x)
    return Best(
        engine=_with(start, planes, x),
        planes=tuple(planes),
        unbalance=tuple(complex(up, right) for up, right in x.reshape(-1, 2)),
        value=value,
        before=measured(case, aim, np.zeros_like(x)),
        bound=min(max(bound, 0.0), value),
        limits=tuple((limit, measured(case, limit.aim, x)) for limit in limits),
        angles=tuple(
            sorted(
                {round(float(angle), 6) for angle in maxima(case, aim, x, above=value * (1 - 1e-6))}
            )
        ),
        aim=aim,
        kept=any(shaft.weights for shaft in start.shafts if shaft.throws),
        model=model,
    )


def _check_aim(aim: Aim) -> None:
    if not aim.possible:
        raise RemedyError(
            "the quantity to minimise is one of {quantities}, with shares of up and right from 0 "
            "that are not both 0; one order, above 0, is that of a peak of force, couple or roll",
            quantities=", ".join(get_args(Quantity)),
        )


def _check_moved(case: Setting, aim: Aim) -> None:
    """Refuse a roll, or an order, that no weight in these planes changes."""
    if (aim.quantity != "roll" and aim.order is None) or influence(case, aim).any():
        return
    if aim.quantity == "roll":
        raise RemedyError(
            "the {aim} does not depend on the weights of these crankshafts, only on the place of "
            "balance shafts, which --shafts with --box finds; leave --minimise out",
            aim=aim_name(aim),
        )
    raise RemedyError(
        "the {aim} does not depend on weights in these planes, which are of order {orders}; "
        "balance shafts may remove it: --shafts all",
        aim=aim_name(aim),
        orders=", ".join(f"{order:g}" for order in spectra.distinct(case.order)),
    )


def without_weights(
    engine: Engine, aim: Aim, *, bare: bool = True, model: Model = "determinate"
) -> float:
    """An aim before weights are added, in its unit; `bare`: on bare crankshafts."""
    start = without_counterweights(engine) if bare else engine
    return measured(setting(start, [], model=model), aim, np.zeros(0))


def _possible(engine: Engine, planes: Sequence[Plane]) -> None:
    names = [shaft.name for shaft in engine.shafts if shaft.throws]
    foreign = [plane.shaft for plane in planes if plane.shaft not in names]
    if foreign:
        raise RemedyError(
            'there is no crankshaft "{name}"; the crankshafts are {names}',
            name=foreign[0],
            names=", ".join(names),
        )
    if not planes or len(set(planes)) < len(planes):
        raise RemedyError("give one plane or more, all different")
    for name in names:
        own = [plane.z for plane in planes if plane.shaft == name]
        apart(engine, own)
        on_the_shaft(engine, own)


def _most(engine: Engine, greatest: float | None) -> float:
    carried = sum(pin.whole * pin.radius for pin in loads(engine)) / unit_unbalance(engine)
    if greatest is not None and not greatest > OPTIMISED * carried:
        raise RemedyError("so small a greatest unbalance allows no weights; give a larger one")
    return min(greatest or np.inf, MOST * carried)


def _with(start: Engine, planes: Sequence[Plane], x: Real) -> Engine:
    """The engine with weights of these unbalances beside those it has."""
    unit = unit_unbalance(start)
    weights: dict[str, list[Weight]] = {}
    for name in {plane.shaft for plane in planes}:
        kept = start.shaft(name).weights
        own = [
            (complex(*pair) * unit, p.z)
            for p, pair in zip(planes, x.reshape(-1, 2), strict=True)
            if p.shaft == name
        ]
        more = turned_weights(
            [u for u, place in own],
            [place for u, place in own],
            negligible=NOISE,
            beside=max((weight.unbalance for weight in kept), default=0.0),
        )
        weights[name] = [*kept, *more]
    return with_weights(start, weights)


def _least(case: Setting, aim: Aim, limits: Sequence[Limit], most: float) -> Solution:
    """The best x (None if the limits cannot be met) and the lower bound of the aim.

    Many sets of weights are equally good for the most loaded bearing; of these the one that loads
    the other bearings least is taken.
    """
    best = _settled(case, aim, limits, most)
    if best.x is None or aim.quantity != "bearing":
        return best
    kept = Limit(aim, measured(case, aim, best.x) * (1 + SLACK) + SLACK)
    gentlest = _settled(case, None, [kept, *limits], most)
    return best if gentlest.x is None else Solution(gentlest.x, best.bound)


def _settled(case: Setting, aim: Aim | None, limits: Sequence[Limit], most: float) -> Solution:
    """The x that minimises an aim, or without one the rms of all bearing loads.

    Crank angles at which a peak is too high are added until there are none.
    """
    wanted = [*([aim] if aim else []), *(limit.aim for limit in limits)]
    turns = max(map(spectra.period, (case.force, case.couple, case.roll)))
    peaky = [each for each in wanted if each.peaky]
    if peaky and turns > GREATEST_TURNS:
        raise RemedyError(
            "{aim}: its period is {turns} turns of the geared shafts, too long to find the peak; "
            "minimise the rms instead",
            aim=aim_name(peaky[0]),
            turns=turns,
        )
    angles = [
        np.arange(FIRST_ANGLES * turns if peaky else 0) * (2 * np.pi / FIRST_ANGLES)
        for _each in wanted
    ]
    none = np.zeros(2 * case.order.size)
    # An aim may be small beside the weights themselves, which set the solver's precision.
    precision = CLOSE * max(1.0, *(measured(case, each, none) for each in wanted))
    best, x = Solution(none, 0.0), none
    for _round in range(ROUNDS):
        groups = [cones(case, each, theta) for each, theta in zip(wanted, angles, strict=True)]
        first = groups.pop(0) if aim else [_together(cones(case, Aim("bearing"), none))]
        best = solved(
            first,
            [Ceiling(group, limit.at_most) for group, limit in zip(groups, limits, strict=True)],
            greatest=most,
        )
        x = best.x
        if x is None:
            return best
        tops = [
            *([max(cone.at(x) for cone in first)] if aim else []),
            *(limit.at_most for limit in limits),
        ]
        missing = [
            maxima(case, each, x, above=top + precision)
            for each, top in zip(wanted, tops, strict=True)
        ]
        if not any(more.size for more in missing):
            return best
        angles = [np.append(theta, more) for theta, more in zip(angles, missing, strict=True)]
    return Solution(_drawn_in(case, limits, x, precision), best.bound)


def _drawn_in(case: Setting, limits: Sequence[Limit], x: Real, precision: float) -> Real:
    """The weights nearest to x, on the way to it from none, that are within the limits.

    Limits that leave next to no room are neared too slowly. Raises RemedyError where the engine
    without weights is not within them.
    """

    def within(share: float) -> bool:
        return all(measured(case, aim, share * x) <= top + precision for aim, top, _ in limits)

    if not within(0.0):
        raise RemedyError(
            "the search for the best weights did not converge; use fewer planes, or minimise "
            "another quantity"
        )
    low, high = 0.0, 1.0
    for _halving in range(30):
        share = (low + high) / 2
        low, high = (share, high) if within(share) else (low, share)
    return low * x if low * np.abs(x).max() > NOISE else np.zeros_like(x)


def _together(parts: Sequence[Cone]) -> Cone:
    """The norm of several vectors as one, with a little of the weights, so that one set is best."""
    gentle = GENTLE * np.eye(parts[0].matrix.shape[1])
    matrix = np.concatenate([*(cone.matrix for cone in parts), gentle])
    return Cone(matrix, np.concatenate([*(cone.shift for cone in parts), np.zeros(len(gentle))]))


def _tidied(
    case: Setting, planes: Sequence[Plane], x: Real, wanted: Sequence[Aim], most: float
) -> Real:
    """The smallest weights with the same effect: equal sums for forces, moments for couples.

    With an aim or limit for bearings every weight counts; then only rounding sums become zero.
    """
    # all weights of a shaft are at one place, so that their sum makes the roll
    asked = {"force" if aim.quantity == "roll" else aim.quantity for aim in wanted}
    vectors = x[0::2] + 1j * x[1::2]
    for shaft in {plane.shaft for plane in planes}:
        own = np.array([plane.shaft == shaft for plane in planes])
        rows = {"force": np.ones(int(own.sum())), "couple": case.arm[own]}
        matrix = np.array([rows[quantity] for quantity in sorted(asked - {"bearing"})])
        if not matrix.size:
            continue
        sums = matrix @ vectors[own]
        rounding = np.abs(sums) < (TIDY_BEARINGS if "bearing" in asked else TIDY) * np.abs(
            matrix
        ) @ np.abs(vectors[own])
        backwards = np.linalg.pinv(matrix, rcond=1e-12)
        if "bearing" in asked:
            vectors[own] -= backwards @ np.where(rounding, sums, 0.0)
        else:
            vectors[own] = backwards @ np.where(rounding, 0.0, sums)
    return x if np.abs(vectors).max() > most else _parts(vectors)


def _parts(vectors: Complex) -> Real:
    """Up and right parts of vectors, one after the other."""
    return np.ascontiguousarray(vectors, complex).view(float)


def _infeasible(case: Setting, limits: Sequence[Limit], most: float, told: partial[str]) -> str:
    """The sentence on a limit that cannot be met, alone or together with the others."""
    for limit in limits:
        x = _least(case, limit.aim, [], most).x
        least = measured(case, limit.aim, x) if x is not None else np.inf
        if least > limit.at_most:
            return _(
                "the limit of {limit}, {aim}, cannot be met with these planes and unbalances up to "
                "{unbalance} m r; the least is {least}, {excess} more",
                limit=told(limit.aim, limit.at_most),
                aim=aim_name(limit.aim),
                unbalance=f"{most:g}",
                least=told(limit.aim, least),
                excess=told(limit.aim, least - limit.at_most),
            )
    *others, last = limits
    x = _least(case, last.aim, others, most).x
    if x is None:
        return _infeasible(case, others, most, told)
    least = measured(case, last.aim, x)
    return _(
        "the limits cannot be met together: within the others the least {aim} is {least}, "
        "{excess} more than {limit}",
        least=told(last.aim, least),
        aim=aim_name(last.aim),
        excess=told(last.aim, least - last.at_most),
        limit=told(last.aim, last.at_most),
    )
