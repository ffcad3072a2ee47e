"""Best weights: the unbalances in chosen planes that make an aim as small as it can be, within limits, and the proof of it.

Aims are convex in the unbalances (module `aims`), so the least is found as what it is, a second-order cone programme
(module `programme`). A peak over a turn is a cone at every crank angle: those at which it is reached are found one after
the other. The certificate is two numbers: the aim measured on the finished engine, and a lower bound that no weights
within the limits can beat.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, get_args

import numpy as np

from crankstar import phasor
from crankstar.engine import Engine
from crankstar.mechanism import Reference
from crankstar.phasor import Complex, Real
from crankstar.records import Shaft
from crankstar.remedy.aims import Aim, Plane, Quantity, Setting, cones, measured, setting, summits, unit_unbalance
from crankstar.remedy.counterweights import RemedyError, apart, on_the_shaft, turned_weights, without_counterweights
from crankstar.remedy.loads import loads
from crankstar.remedy.programme import Ceiling, Cone, MissingSolverError, Solution, solved

FIRST_ANGLES = 48
"""Crank angles per turn with which the search for peaks begins."""
ROUNDS = 30
GREATEST_TURNS = 60
"""Turns after which geared shafts are back at the start, up to which a peak is followed."""
SLACK = 3e-8
"""What may be given away of the aim, in its unit and as a share of it, for smaller weights."""
CLOSE = 3e-9
"""How near the peaks at the angles looked at must come to the true ones: in m r w^2 (a), or a share of what there is."""


TIDY_BEARINGS = 1e-4
"""The same where bearings count: there a small force would buy smaller weights."""
GENTLE = 0.03
"""How much weights themselves count, beside the loads they leave, among those that are equally good for the worst bearing."""
NOISE = 1e-6
"""Share of the greatest unbalance below which a weight is nothing but the solver's precision."""
MOST = 2.0
"""Of what all pins carry together: a greater weight is none."""
TIDY = 1e-7
"""A sum of weights, or of their moments, that is smaller than this share of them is nothing but the solver's precision."""


class Limit(NamedTuple):
    """What an aim may at most be, m r w^2 or m r w^2 a; `quiet` where nobody asked for it in so many words."""

    aim: Aim
    at_most: float
    quiet: bool = False


class Best(NamedTuple):
    """The best weights: the engine with them, unbalance vectors (m r, up + i right at theta = 0) by plane, and the certificate.

    `value` is the `aim` with these weights, `bare` without any; no weights within the limits make it smaller than `bound`.
    `held` are the limits and what became of them; `angles` (radians) the crank angles at which a peak is reached.
    """

    engine: Engine
    planes: tuple[Plane, ...]
    unbalance: tuple[complex, ...]
    value: float
    bare: float
    bound: float
    held: tuple[tuple[Limit, float], ...]
    angles: tuple[float, ...]
    aim: Aim


def best_weights(
    engine: Engine,
    *,
    planes: Sequence[Plane],
    aim: Aim,
    limits: Sequence[Limit] = (),
    greatest_unbalance: float | None = None,
    reference: Reference | None = None,
) -> Best:
    """The weights in these planes that make `aim` least; they replace those of the crankshafts.

    `greatest_unbalance` (m r of the first cylinder) bounds each of them; without one it is twice what all pins carry.
    Raises RemedyError, also where the limits cannot be met, with by how much.

    >>> from crankstar.catalog import load
    >>> found = best_weights(load("single"), planes=[Plane("crank", 0.0)], aim=Aim("force", rms=True))
    >>> round(abs(found.unbalance[0]), 9)  # half of the reciprocating mass
    0.5
    """
    _possible(engine, planes)
    most = _most(engine, greatest_unbalance)
    for limit in limits:
        if not limit.at_most >= 0 or not np.isfinite(limit.at_most):
            raise RemedyError(f"a limit of {limit.at_most:g} cannot be met; give a number from 0 up")
    for one in (aim, *(limit.aim for limit in limits)):
        _sensible(one)
    bare = without_counterweights(engine)
    case = setting(bare, planes, reference=reference)
    try:
        x, bound = _least(case, aim, limits, most)
        if x is None:
            raise RemedyError(_infeasible(case, limits, most))
    except MissingSolverError:
        raise RemedyError('best weights are found with Clarabel: pip install "crankstar[weights]"') from None
    x = _tidied(case, planes, x, [aim, *(limit.aim for limit in limits)], most)
    value = measured(case, aim, x)
    return Best(
        engine=_with(bare, planes, x),
        planes=tuple(planes),
        unbalance=tuple(complex(up, right) for up, right in x.reshape(-1, 2)),
        value=value,
        bare=measured(case, aim, np.zeros_like(x)),
        bound=min(max(bound, 0.0), value),
        held=tuple((limit, measured(case, limit.aim, x)) for limit in limits),
        angles=tuple(sorted({round(float(angle), 6) for angle in summits(case, aim, x, above=value * (1 - 1e-6))})),
        aim=aim,
    )


def _sensible(aim: Aim) -> None:
    shares = (aim.up, aim.right)
    if aim.quantity not in get_args(Quantity) or not np.isfinite(shares).all() or min(shares) < 0 or max(shares) == 0:
        raise RemedyError(f"an aim is one of {', '.join(get_args(Quantity))}, with shares of up and right from 0, not both 0")


def without_weights(engine: Engine, aim: Aim) -> float:
    """An aim on bare crankshafts, m r w^2 or m r w^2 a."""
    return measured(setting(without_counterweights(engine), []), aim, np.zeros(0))


def bearing_load(engine: Engine) -> float:
    """The greatest first-order load on a main bearing of an engine with the weights it has, m r w^2 (see `aims`)."""
    return measured(setting(engine, []), Aim("bearing"), np.zeros(0))


def _possible(engine: Engine, planes: Sequence[Plane]) -> None:
    names = [shaft.name for shaft in engine.shafts if shaft.throws]
    foreign = [plane.shaft for plane in planes if plane.shaft not in names]
    if foreign:
        raise RemedyError(f'there is no crankshaft "{foreign[0]}"; there are: {", ".join(names)}')
    if not planes or len(set(planes)) < len(planes):
        raise RemedyError("name one plane for weights or more, all different")
    for name in names:
        own = [plane.z for plane in planes if plane.shaft == name]
        apart(engine, own)
        on_the_shaft(engine, own)


def _most(engine: Engine, greatest: float | None) -> float:
    if greatest is not None and not greatest > 0:
        raise RemedyError(f"a greatest unbalance of {greatest:g} leaves no weights; give a number above 0")
    carried = sum((pin.rotating + pin.reciprocating) * pin.radius for pin in loads(engine)) / unit_unbalance(engine)
    return min(greatest or np.inf, MOST * carried)


def _with(engine: Engine, planes: Sequence[Plane], x: Real) -> Engine:
    unit = unit_unbalance(engine)

    def weighted(shaft: Shaft) -> Shaft:
        own = [(complex(*pair) * unit, p.z) for p, pair in zip(planes, x.reshape(-1, 2), strict=True) if p.shaft == shaft.name]
        if not own:
            return shaft
        return shaft.model_copy(
            update={"weights": tuple(turned_weights([u for u, _ in own], [z for _, z in own], negligible=NOISE))}
        )

    return engine.model_copy(update={"shafts": tuple(weighted(shaft) for shaft in engine.shafts)})


def _least(case: Setting, aim: Aim, limits: Sequence[Limit], most: float) -> Solution:
    """The best x (None if the limits cannot be met) and the lower bound of the aim.

    Where only the bearing with the greatest load counts, many weights are equally good: then those which leave the
    least on the others too.
    """
    found = _settled(case, aim, limits, most)
    if found.x is None or aim.quantity != "bearing":
        return found
    kept = Limit(aim, measured(case, aim, found.x) * (1 + SLACK) + SLACK)
    gentlest = _settled(case, None, [kept, *limits], most)
    return found if gentlest.x is None else Solution(gentlest.x, found.bound)


def _settled(case: Setting, aim: Aim | None, limits: Sequence[Limit], most: float) -> Solution:
    """The x that makes an aim, or without one the rms of all bearings' loads, least.

    Crank angles at which a peak comes too high are added until there are none.
    """
    wanted = [*([aim] if aim else []), *(limit.aim for limit in limits)]
    turns = max(phasor.period(case.force), phasor.period(case.couple))
    peaky = [one for one in wanted if not one.rms and one.quantity != "bearing"]
    if peaky and turns > GREATEST_TURNS:
        raise RemedyError(
            f"the {said(peaky[0])} comes round only every {turns} turns of the geared shafts, too long to follow; "
            "ask for the rms instead"
        )
    angles = [np.arange(FIRST_ANGLES * turns if peaky else 0) * (2 * np.pi / FIRST_ANGLES) for _ in wanted]
    none = np.zeros(2 * case.order.size)
    # What is asked of one quantity may be small beside the weights that are moved about: the solver's precision is of these.
    precision = CLOSE * max(1.0, *(measured(case, one, none) for one in wanted))
    for _ in range(ROUNDS):
        groups = [cones(case, one, theta) for one, theta in zip(wanted, angles, strict=True)]
        first = groups.pop(0) if aim else [_together(cones(case, Aim("bearing"), none))]
        found = solved(first, [Ceiling(group, limit.at_most) for group, limit in zip(groups, limits, strict=True)], greatest=most)
        x = found.x
        if x is None:
            return found
        tops = [*([max(cone.at(x) for cone in first)] if aim else []), *(limit.at_most for limit in limits)]
        missing = [summits(case, one, x, above=top + precision) for one, top in zip(wanted, tops, strict=True)]
        if not any(more.size for more in missing):
            return found
        angles = [np.append(theta, more) for theta, more in zip(angles, missing, strict=True)]
    raise RemedyError("the best weights were not found: the peaks wander; take fewer planes, or another aim")


def _together(parts: Sequence[Cone]) -> Cone:
    """The norm of several vectors as one, and a little of the weights themselves, so that only one set of them is best."""
    count = parts[0].matrix.shape[1]
    matrix = np.concatenate([*(cone.matrix for cone in parts), GENTLE * np.eye(count)])
    return Cone(matrix, np.concatenate([*(cone.shift for cone in parts), np.zeros(count)]))


def _tidied(case: Setting, planes: Sequence[Plane], x: Real, wanted: Sequence[Aim], most: float) -> Real:
    """The least weights that do all that was asked for: the same sum where it was of forces, the same moment if of couples.

    Where bearings were spoken of every weight counts, and only sums that are nothing are made nothing.
    """
    asked = {aim.quantity for aim in wanted}
    vectors = x[0::2] + 1j * x[1::2]
    for shaft in {plane.shaft for plane in planes}:
        own = np.array([plane.shaft == shaft for plane in planes])
        rows = {"force": np.ones(int(own.sum())), "couple": case.arm[own]}
        matrix = np.array([rows[quantity] for quantity in sorted(asked - {"bearing"})])
        if not matrix.size:
            continue
        sums = matrix @ vectors[own]
        nothing = np.abs(sums) < (TIDY_BEARINGS if "bearing" in asked else TIDY) * np.abs(matrix) @ np.abs(vectors[own])
        backwards = np.linalg.pinv(matrix, rcond=1e-12)
        if "bearing" in asked:
            vectors[own] -= backwards @ np.where(nothing, sums, 0.0)
        else:
            vectors[own] = backwards @ np.where(nothing, 0.0, sums)
    return x if np.abs(vectors).max() > most else _parts(vectors)


def _parts(vectors: Complex) -> Real:
    """Up and right parts of vectors, one after the other."""
    return np.ascontiguousarray(vectors, complex).view(float)


def _infeasible(case: Setting, limits: Sequence[Limit], most: float) -> str:
    """Which limit cannot be met and by how much, alone or together with the others."""
    for limit in limits:
        x, _ = _least(case, limit.aim, [], most)
        least = measured(case, limit.aim, x) if x is not None else np.inf
        if least > limit.at_most:
            return (
                f"the limit of {limit.at_most:g} {_unit(limit.aim)} for the {said(limit.aim)} cannot be met: with these planes and "
                f"unbalances up to {most:g} m r the least is {least:g}, {least - limit.at_most:.3g} more"
            )
    last = limits[-1]
    x, _ = _least(case, last.aim, limits[:-1], most)
    if x is None:
        return _infeasible(case, limits[:-1], most)
    least = measured(case, last.aim, x)
    return (
        f"the limits cannot be met together: while the others hold, the least {said(last.aim)} is {least:g} {_unit(last.aim)}, "
        f"{least - last.at_most:.3g} more than {last.at_most:g}"
    )


def _unit(aim: Aim) -> str:
    return "m r ω² a" if aim.quantity == "couple" else "m r ω²"


def said(aim: Aim) -> str:
    """An aim in words."""
    names = {("couple", 1.0, 0.0): "pitch", ("couple", 0.0, 1.0): "yaw", ("force", 1.0, 0.0): "upward force"}
    name = names.get((aim.quantity, aim.up, aim.right), aim.quantity)
    if aim.quantity == "bearing":
        return "greatest load on a main bearing"
    return f"rms {name}" if aim.rms else f"peak {name}"
