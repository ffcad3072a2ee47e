"""The stars of a real engine: its cylinders' places, and vector sums in newtons and newton metres.

A cylinder of an in-line engine, with its throw and its counterweights, adds to each order k of
force or couple a vector f_j that turns with the crankshaft and one, b_j, that turns against it.
Throws that come to top dead centre later by phi_j turn these vectors, and the largest value over a
turn is

    |sum of f_j exp(-i k phi_j)| + |sum of b_j exp(i k phi_j)|.

Where cylinders differ by weights q_j only, f_j = q_j f and b_j = q_j b, it is

    (|f| + |b|) |sum of q_j exp(i k phi_j)|;

for couples the weights are q_j z_j. N and N m at a speed, else units of m r w^2.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from math import hypot, pi, radians, sqrt
from typing import Literal

import numpy as np

from crankstar import spectra
from crankstar.derive.algebra import rational
from crankstar.engine.copies import throws_of_weights, with_throws_turned
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.mechanics.balance import Balance, balance
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.guide_moments import MarineError, guide_moments
from crankstar.mechanics.operating_points import GasError
from crankstar.spectra import Spectrum
from crankstar.stars.engines import firing_order
from crankstar.stars.faults import SearchError, error, fault
from crankstar.stars.sequence_engines import shaft_of_engine
from crankstar.stars.star import Star, Stars
from crankstar.stars.sums import Objective, Side, VectorSum, couple, force, sizes, twisting

ORDERS = (1, 2, 4, 6)
"""Of the couple of all orders together: those that a piston makes, but for the small."""
ALIKE = 1e-11
"""Share of the greatest by which vectors and ratios may differ and be equal, or be zero."""
SAME_COUPLE = 1e-6
"""Share by which the couples of alike cylinders may differ, each from its own samples."""
PISTONS = "{name} (pistons)"
IN_PHASE = "{name} (pistons in phase)"
"""Names of sums that leave out the rotating parts, or also what offsets shift the pistons by."""


def _in_vee(engine: Engine) -> bool:
    """Whether star and firing sequence of an engine can be searched together."""
    with suppress(SearchError):
        shaft_of_engine(engine)
        return True
    return False


def stars_of(engine: Engine) -> Stars:
    """All stars of the cylinders of an in-line engine, at their places (in m, or in pitches).

    Raises SearchError where the engine is not in line with a throw for each cylinder.
    """
    cylinders = sorted(engine.cylinders, key=lambda cylinder: -cylinder.z)
    bearings = {round(cylinder.bearing, 9) for cylinder in cylinders}
    throws = {cylinder.throw for cylinder in cylinders}
    name = engine.name
    if len(cylinders) > 1 == len(throws):
        raise error("", "one-throw", engine=name)
    faults = [fault("", "one-cylinder", engine=name)] if len(cylinders) < 2 else []
    if engine.shaft(engine.first.shaft).speed_ratio != 1:
        faults.append(fault("", "geared", engine=name))
    in_line = len({cylinder.shaft for cylinder in cylinders}) == len(bearings) == 1
    if not in_line or len(throws) < len(cylinders):
        if _in_vee(engine):
            raise error("", "shared-pins", engine=name)
        faults.append(fault("", "not-in-line", engine=name))
    if any(cylinder.articulated or cylinder.chamber for cylinder in cylinders):
        faults.append(fault("", "slave-rods", engine=name))
    if [cylinder.number for cylinder in cylinders] != list(range(1, len(cylinders) + 1)):
        faults.append(fault("", "numbering", engine=name))
    if faults:
        raise SearchError(faults)
    places = [rational.ratio(cylinder.z) for cylinder in cylinders]
    middle = (places[0] + places[-1]) / 2
    return Stars(len(cylinders), engine.cycle, tuple(place - middle for place in places))


def star_of(engine: Engine, stars: Stars) -> Star | None:
    """The star that an engine has now; None where its throws stand elsewhere.

    >>> from crankstar.files.catalog import load
    >>> engine = load("i6")
    >>> star_of(engine, stars_of(engine))
    (0, 1, 2, 2, 1, 0)
    """
    angles = [
        engine.throw(cylinder).angle
        for cylinder in sorted(engine.cylinders, key=lambda cylinder: cylinder.number)
    ]
    places = [(angles[0] - angle) * engine.sense * stars.directions / (2 * pi) for angle in angles]
    if any(abs(place - round(place)) > ALIKE for place in places):
        return None
    star = tuple(round(place) % stars.directions for place in places)
    return None if stars.misfit(star) else star


def force_of(
    engine: Engine, stars: Stars, order: int, *, speed: float | None = None, side: Side = ""
) -> VectorSum:
    """F_k of an engine: the largest value over a turn of its force of an order, for a star.

    N at a speed or m r w^2; of a `side` only what acts up or to the right. See `_sum_of` for what
    is counted.
    """
    return _sum_of(engine, force(stars, order), "force", speed, side)[0]


def couple_of(
    engine: Engine, stars: Stars, order: int, *, speed: float | None = None, side: Side = ""
) -> VectorSum:
    """M_k of an engine: the largest value over a turn of its couple of an order, for a star.

    About the middle, N m at a speed or m r w^2 a; of a `side` the external moment in the vertical
    plane (M_kV) or in the horizontal one (M_kH). See `_sum_of` for what is counted.

    >>> from crankstar.files.catalog import load
    >>> engine = load("sinitsyn-7-first")
    >>> round(couple_of(engine, stars_of(engine), 1).length((0, 4, 2, 5, 1, 3, 6)), 4)
    0.8516
    """
    return _sum_of(engine, couple(stars, order), "couple", speed, side)[0]


def twisting_of(
    engine: Engine, stars: Stars, order: Fraction, *, speed: float | None = None
) -> VectorSum:
    """X_k of an engine, the guide-force moment that twists its frame, for a star, N m.

    With the gas of its file at a speed (rad/s), and inertia where masses are known. Raises
    SearchError for an engine without gas or pitch, or with cylinders that differ.
    """
    plain = twisting(stars, order)
    if "pitch" in engine.relative:
        raise error("", "x-pitch", name=plain.name, engine=engine.name)
    if engine.gas is None:
        problem = _("the engine file has no table [gas]")
        raise error("", "x-gas", name=plain.name, problem=problem)
    try:
        found = guide_moments(engine, cycle(engine, speed=speed))
    except (GasError, MarineError) as problem:
        raise error("", "x-gas", name=plain.name, problem=str(problem)) from None
    at = np.flatnonzero(np.isclose(found.orders, float(order), rtol=0, atol=1e-9))
    couples = np.abs(found.rolling[:, at]).sum(axis=1)
    if not couples.any():
        raise error("", "x-none", name=plain.name)
    if np.ptp(couples) > SAME_COUPLE * couples.max():
        raise error("", "x-unequal", name=plain.name, engine=engine.name)
    scale = float(couples.mean()) / found.length
    return replace(plain, scale=scale, unit="N*m")


def rms_couple(engine: Engine, stars: Stars, *, speed: float | None = None) -> Objective:
    """The root mean square, over a turn, of the couple of orders 1, 2, 4 and 6.

    A vector f with and b against the crank has the root of |f|^2 + |b|^2.
    """
    sums = [_sum_of(engine, couple(stars, order), "couple", speed) for order in ORDERS]
    terms = tuple((mean, vector) for vector, mean in sums if vector.scale > 0)
    of_engine = not any(vector.parts for _mean, vector in terms)
    name = "couple" if of_engine else PISTONS.format(name="couple")
    return Objective(name, terms, unit=sums[0][0].unit)


def with_star(
    engine: Engine, stars: Stars, star: Star, *, later_deg: Sequence[float] | None = None
) -> Engine:
    """The engine with its throws turned to a star, weights with them, and its firing order.

    `later_deg`: by how many degrees of crank angle each cylinder comes later to top dead centre
    than the star says.
    """
    later = later_deg or (0.0,) * stars.cylinders
    first = engine.throw(engine.first).angle
    turn = -engine.sense * 2 * pi / stars.directions
    turns: dict[tuple[str, int], float] = {}
    for cylinder in engine.cylinders:
        place = cylinder.number - 1
        behind = -engine.sense * radians(later[place] - later[0])
        angle = first + turn * (star[place] - star[0]) + behind
        turns[cylinder.shaft, cylinder.throw] = angle - engine.throw(cylinder).angle
    order = firing_order(stars, star)
    words = f"{engine.name}, throws turned: fires {'-'.join(map(str, order))}"
    known = {
        key: value
        for key, value in engine.provenance.items()
        if "throw" not in key and not key.startswith("firing")
    }
    return with_throws_turned(
        engine, turns, name=words, firing_order=order, firing_angles=None, provenance=known
    )


def _sum_of(
    engine: Engine,
    plain: VectorSum,
    quantity: Literal["force", "couple"],
    speed: float | None,
    side: Side = "",
) -> tuple[VectorSum, float]:
    """A sum of an engine, and its root mean square over a turn where its largest value is 1.

    Pistons push along the cylinders; throws and weights turn with the crankshaft. Where each
    cylinder and its throw add the same two vectors, with and against the crankshaft, times a
    weight, the largest value over a turn is the length of one sum for every star. Where throws
    differ in more, or parts that stay push in this order, that sum is of the pistons only and
    named so; what all parts add is kept beside it.
    """
    order = int(plain.order)
    plain = replace(plain, name=f"{plain.name}{side}", side=side)
    result = balance(engine, speed=speed, orders=sorted({1, order}))
    homes = _cylinders(engine, result)
    moving = np.array([part.cylinder is not None for part in result.parts])
    spectrum = getattr(result, quantity)
    unit = getattr(result.units, quantity)
    pushes = np.abs(_vectors(engine, result.force[moving], homes[moving], order)[1:, 0])
    if pushes.max() <= ALIKE * np.abs([result.force.forward, result.force.backward]).max():
        return replace(plain, scale=0.0, unit=unit), 0.0
    shares = [rational.ratio(float(size), rounding=ALIKE) for size in pushes / pushes.max()]
    weights = tuple(share * own for share, own in zip(shares, plain.weights, strict=True))
    vectors = _vectors(engine, spectrum, homes, order)
    common = _common(vectors, weights)
    if common is not None and common.any():
        against, along = np.abs(common).tolist()
        rms = hypot(against, along) / (against + along)
        scale = _seen_from(side, common[None], greatest=against + along)
        return replace(plain, weights=weights, scale=scale, unit=unit), rms
    of_pistons = _vectors(engine, spectrum[moving], homes[moving], order)
    in_phase = _common(of_pistons[:, :1], weights) is not None
    reach = sum(abs(weight) for weight in weights)
    size = 2 * float(np.abs(of_pistons[1:, 0]).sum() / reach) if reach else 0.0
    size = _seen_from(side, of_pistons[1:], greatest=size)
    name = (PISTONS if in_phase else IN_PHASE).format(name=plain.name)
    parts = tuple((complex(a), complex(b)) for a, b in vectors[:, :: engine.sense])
    return replace(plain, name=name, weights=weights, scale=size, unit=unit, parts=parts), sqrt(0.5)


def _seen_from(side: Side, vectors: np.ndarray, *, greatest: float) -> float:
    """The share of a side in the greatest value, 0 where rounding leaves nothing else."""
    share = float(sizes(vectors, side).sum() / sizes(vectors).sum()) if vectors.any() else 0.0
    return share * greatest if share > ALIKE else 0.0


def _cylinders(engine: Engine, result: Balance) -> np.ndarray:
    """The cylinder with which each part turns to a star, 0 for those that stay [part]."""
    own = {(cylinder.shaft, cylinder.throw): cylinder.number for cylinder in engine.cylinders}
    out = [part.cylinder for part in result.parts if part.cylinder is not None]
    for homes in (lambda shaft: range(1, len(shaft.throws) + 1), throws_of_weights):
        out += [
            own.get((shaft.name, home or 0), 0) for shaft in engine.shafts for home in homes(shaft)
        ]
    return np.array(out)


def _vectors(engine: Engine, spectrum: Spectrum, homes: np.ndarray, order: int) -> np.ndarray:
    """Vectors of an order against and with the crankshaft [cylinders + 1, 2].

    The first row is of what stays, then one of each cylinder as if on the throw of the first.
    """
    of_order = spectra.selected(spectrum, order)
    columns = np.stack([of_order.backward[:, 0], of_order.forward[:, 0]], axis=1)
    first = engine.throw(engine.first).angle
    ahead = [0.0] * (len(engine.cylinders) + 1)
    for cylinder in engine.cylinders:
        ahead[cylinder.number] = order * (engine.throw(cylinder).angle - first)
    out = np.array([columns[homes == number].sum(axis=0) for number in range(len(ahead))])
    out *= np.exp(np.outer(ahead, [1j, -1j]))
    return out


def _common(vectors: np.ndarray, weights: Sequence[Fraction]) -> np.ndarray | None:
    """The vectors that all cylinders add, each times its weight, if there are such [columns]."""
    own = np.array([0.0, *map(float, weights)])
    common = own @ vectors / max(own @ own, ALIKE)
    apart = np.abs(vectors - np.outer(own, common)).max()
    return common if apart <= ALIKE * np.abs(vectors).max() else None
