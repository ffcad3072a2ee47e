"""Balance shafts: which an engine needs, what each cancels, where a pair must lie against roll.

In order k = |n| an engine's force is a vector F turning one way and one turning the other; a shaft
of speed ratio n turns with one of them. Weights u_j on it, in planes z_j, push with n^2 w^2 u_j.
They cancel force and couple about z0 where

    n^2 sum u_j = -F,    n^2 sum (z_j - z0) u_j = -M,

and of all such weights those with the least sum of |u_j|^2 are taken. A straight line of force (the
second order of a four) needs two shafts, of ratio 2 and -2, half each: F. W. Lanchester's pair. A
couple of one sense needs one shaft with two opposite weights (the first order of a three).

Where a shaft lies changes force and couple not at all, but its push has an arm P about the
crankshaft, and so a rolling moment Im(conj(P) F). A pair at different heights rolls with its order,
and can take away the rolling moment of that order: shafts of unequal height, as Mitsubishi built
them from 1974.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from functools import lru_cache
from math import isfinite
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.engine.arguments import check_planes
from crankstar.engine.assembly import GREATEST_SHAFTS
from crankstar.engine.copies import with_shaft, with_values, with_weights
from crankstar.engine.engine import Engine
from crankstar.engine.main_bearings import end_webs
from crankstar.engine.records import Shaft, Weight
from crankstar.mechanics import remains
from crankstar.mechanics.balance import default_reference, spectra_of
from crankstar.mechanics.excitation import Totals, part_spectra, total
from crankstar.mechanics.mechanism import mechanism
from crankstar.remedy.counterweights import RemedyError, apart, turned_weights
from crankstar.remedy.kept import least_weights
from crankstar.remedy.rolling import push, roll, roll_of
from crankstar.spectra import Spectrum

GREATEST_RATIO = 8
ZERO = remains.NEGLIGIBLE
"""Share of the sum of all parts' sizes below which a vector is zero."""


class Need(NamedTuple):
    """A force (kg m) and couple about the middle (kg m^2) at 1 rad/s that a shaft would cancel."""

    ratio: Fraction
    force: complex
    couple: complex


@lru_cache(maxsize=512)  # asked for again and again while weights and shafts are fitted
def needs(engine: Engine, *, highest: int = 2, zero: float = ZERO) -> tuple[Need, ...]:
    """The vectors up to order `highest` that remain; each needs a shaft to cancel it.

    For ratio 1 the crankshaft itself is such a shaft, by its counterweights. A vector below the
    share `zero` of the sum of its parts counts as zero.

    >>> from crankstar.files.catalog import load
    >>> [str(need.ratio) for need in needs(load("i4"))]  # the pair of F. W. Lanchester
    ['2', '-2']
    >>> [(str(need.ratio), abs(need.force)) for need in needs(load("triple-120"))]  # couples alone
    [('1', 0.0), ('-1', 0.0), ('2', 0.0), ('-2', 0.0)]
    """
    parts = spectra_of(engine, default_reference(engine))
    orders = parts.force.orders[parts.force.orders <= highest + 1e-9].tolist()
    ratios = sorted({Fraction(order).limit_denominator(1000) for order in orders})
    sums = total(parts)
    remaining = [
        Need(ratio, *_vectors(parts, sums, ratio, zero))
        for order in ratios
        for ratio in (order, -order)
    ]
    return tuple(need for need in remaining if need.force or need.couple)


def _vectors(
    parts: Totals, sums: Totals, ratio: Fraction, share: float = ZERO
) -> tuple[complex, complex]:
    """Force and couple that turn at this ratio; zero where negligible beside the parts."""

    def vector_of(name: str) -> complex:
        spectrum = spectra.selected(getattr(sums, name), [abs(float(ratio))])
        vector = complex((spectrum.forward if ratio > 0 else spectrum.backward)[0])
        return vector if abs(vector) > share * _pushed(getattr(parts, name)) else 0j

    return vector_of("force"), vector_of("couple")


def _pushed(spectrum: Spectrum) -> float:
    """The sum of the sizes of all parts, in the order in which it is greatest."""
    return float(
        (np.abs(spectrum.forward) + np.abs(spectrum.backward)).sum(axis=0).max(initial=0.0)
    )


def with_balance_shaft(
    engine: Engine,
    *,
    ratio: Fraction | int,
    planes: Sequence[float],
    up: float = 0.0,
    right: float = 0.0,
    share: float = 1.0,
) -> Engine:
    """The engine with one more shaft at `up`, `right` of the crankshaft, weights in these planes.

    `ratio` is its speed per turn of the crankshaft, negative against it; `planes` are places along
    it: two or more, or one in which the force alone acts. `share` is the part of force and couple
    that it cancels, the rest being left to other shafts. Raises RemedyError, also where there is
    nothing for it to balance.

    >>> from crankstar import load, spectra, total
    >>> from crankstar.mechanics.balance import balance
    >>> single = with_balance_shaft(load("i4"), ratio=2, planes=[1, -1])
    >>> pair = with_balance_shaft(single, ratio=-2, planes=[1, -1])
    >>> second = spectra.selected(total(balance(pair)).force, 2)
    >>> bool(abs(second.forward[0]) + abs(second.backward[0]) < 1e-15)  # F. W. Lanchester's pair
    True
    """
    if not isfinite(up) or not isfinite(right):
        raise RemedyError(
            "the place of a balance shaft is not finite; give up and right as finite lengths"
        )
    ratio = _fraction(ratio)
    if ratio == 0 or abs(ratio) > GREATEST_RATIO:
        raise RemedyError(
            "a balance shaft cannot have the speed ratio {ratio}; give one from -{greatest} to "
            "{greatest}, not 0",
            ratio=ratio,
            greatest=GREATEST_RATIO,
        )
    check_planes(planes)
    if not planes or len(set(planes)) < len(planes):
        raise RemedyError("a balance shaft needs planes for its weights, all different; give two")
    apart(engine, planes)
    if len(engine.shafts) >= GREATEST_SHAFTS:
        raise RemedyError(
            "the engine already has {count} shafts; the greatest number is {greatest}",
            count=len(engine.shafts),
            greatest=GREATEST_SHAFTS,
        )
    vectors = unbalances(engine, ratio, planes)
    if not vectors:
        raise RemedyError(
            "no force or couple of order {order} turns with a shaft of speed ratio {ratio}; "
            "leave the shaft out",
            order=abs(ratio),
            ratio=ratio,
        )
    weights = tuple(turned_weights([share * vector for vector in vectors], planes))
    shaft = Shaft(name=_name(engine, ratio), speed_ratio=ratio, up=up, right=right, weights=weights)
    return with_shaft(engine, shaft)


def unbalances(
    engine: Engine, ratio: Fraction, planes: Sequence[float], *, couple: bool = True
) -> list[complex]:
    """The least unbalances in these planes that cancel what turns at a ratio; none if nothing does.

    kg m (or m r), up + i right at theta = 0. Raises RemedyError where one plane has a couple to
    cancel, unless the `couple` may remain.
    """
    reference = default_reference(engine)
    parts = part_spectra(mechanism(engine), reference=reference)
    force, moment = _vectors(parts, total(parts), ratio)
    arms, squared = [plane - reference.z for plane in planes], float(ratio) ** 2
    if not (force or moment):
        return []
    if len(arms) > 1:
        return least_weights(force=-force / squared, moment=-moment / squared, planes=arms)
    if couple and abs(moment - arms[0] * force) > ZERO * _pushed(parts.couple):
        raise RemedyError("one plane cannot cancel a couple; give two planes or more")
    return [-force / squared]


def with_turning_cancelled(engine: Engine, *, ratio: Fraction | int) -> Engine:
    """The engine with the vector of this ratio cancelled on the end webs of its crankshafts.

    The least unbalance that does it stands there beside the weights that the crankshafts have. A
    balance factor cannot always do it: where cylinder axes miss the crank axis, no share of the
    reciprocating masses turns with the crank. Raises RemedyError if no crankshaft has this ratio.

    >>> from crankstar.files.catalog import load
    >>> quiet = with_turning_cancelled(load("vw-vr6"), ratio=1)
    >>> [str(need.ratio) for need in needs(quiet, highest=1)]
    ['-1']
    """
    ratio = _fraction(ratio)
    shafts = [shaft for shaft in engine.shafts if shaft.throws and shaft.speed_ratio == ratio]
    if not shafts:
        raise RemedyError(
            "no crankshaft has the speed ratio {ratio}; use a balance shaft", ratio=ratio
        )
    at = [(shaft, plane) for shaft in shafts for plane in end_webs(engine, shaft)]
    added = list(zip(at, unbalances(engine, ratio, [plane for _, plane in at]), strict=False))
    weights: dict[str, Sequence[Weight]] = {}
    for shaft in shafts:
        own = [(plane, vector) for (home, plane), vector in added if home is shaft]
        throws = {weight.z: weight.throw for weight in shaft.weights}
        more = turned_weights(
            [vector for _plane, vector in own],
            [plane for plane, _vector in own],
            throws=[throws.get(plane) for plane, _vector in own],
        )
        weights[shaft.name] = [*shaft.weights, *more]
    return with_weights(engine, weights)


def with_roll_cancelled(engine: Engine, *, order: Fraction | int) -> Engine:
    """The engine with its balance shafts of ratio +-`order` moved just enough to stop the roll.

    The rolling moment is what the block feels when flywheel and driveline take the torque
    (`excitation.rolling_moment`). Raises RemedyError where there is no such pair, or it has no
    force to do it with.

    >>> from crankstar.files.catalog import load
    >>> pair = load("i4")
    >>> for ratio in (2, -2):
    ...     pair = with_balance_shaft(pair, ratio=ratio, planes=[0.0])
    >>> level = with_roll_cancelled(pair, order=2)
    >>> [round(shaft.up, 3) for shaft in level.shafts[1:]]  # apart by nearly a rod length, 4 r
    [1.969, -1.969]
    """
    order = abs(_fraction(order))
    pair = [
        index
        for index, s in enumerate(engine.shafts)
        if s.weights and not s.throws and abs(s.speed_ratio) == order
    ]
    if sorted(engine.shafts[place].speed_ratio for place in pair) != [-order, order]:
        raise RemedyError(
            "there is no pair of balance shafts of speed ratios {order} and -{order} to move",
            order=order,
        )
    columns: list[complex] = []
    for place in pair:
        shaft = engine.shafts[place]
        # Re(c exp(i k theta)) of Im(conj(P) F) for P = 1 (up) and P = i (right)
        columns += [
            roll_of(engine, force=push(shaft), ratio=shaft.speed_ratio, place=at)
            for at in (1.0, 1j)
        ]
    matrix = np.array([np.real(columns), np.imag(columns)])
    rest = roll(engine, order, default_reference(engine))
    move = np.linalg.pinv(matrix, rcond=1e-9) @ -np.array([rest.real, rest.imag])
    shafts = list(engine.shafts)
    for place, (up, right) in zip(pair, move.reshape(2, 2), strict=True):
        shafts[place] = with_values(
            shafts[place],
            up=_rounded(shafts[place].up + up, move),
            right=_rounded(shafts[place].right + right, move),
        )
    moved = with_values(engine, shafts=tuple(shafts))
    left = roll(moved, order, default_reference(moved))
    if abs(left) > ZERO * max(abs(rest), _pushed(part_spectra(mechanism(engine)).axis_moment)):
        raise RemedyError(
            "the forces of the pair of ratios {order} and -{order} cannot cancel the rolling "
            "moment at any height",
            order=order,
        )
    return moved


def _fraction(ratio: Fraction | int) -> Fraction:
    try:
        return Fraction(ratio)
    except (ValueError, OverflowError, ZeroDivisionError, TypeError):
        raise RemedyError(
            "{ratio} is not a speed ratio; give a whole number or a fraction, negative against "
            "the crank",
            ratio=ratio,
        ) from None


def _rounded(value: float, among: np.ndarray) -> float:
    """A place without the rounding error of the move."""
    return 0.0 if abs(value) < 1e-12 * float(np.abs(among).max(initial=0.0)) else float(value)


def _name(engine: Engine, ratio: Fraction) -> str:
    names = {shaft.name for shaft in engine.shafts}
    name = f"balancer {ratio}"
    count = 2
    while name in names:
        name, count = f"balancer {ratio} no. {count}", count + 1
    return name
