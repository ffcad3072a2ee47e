"""Harmonics of pistons and knuckle pins to fifty digits, each with a proved bound of its error.

The place of a piston along its cylinder is sampled in ball arithmetic at N points of a turn. It is analytic in the crank
angle as long as no rod can lie square to its cylinder, so in a strip |Im psi| <= rho it is bounded by some M, and the
harmonics of its samples miss the true ones by no more than

    2 M (exp(-rho (N - k)) + exp(-rho (N + k))) / (1 - exp(-rho N)),

the harmonics folded onto k. M and rho come from |sin psi|, |cos psi| <= cosh rho alone: for a rod of length l whose big end
strays at most y from the cylinder's axis, y < l, the rod's sine is at most y/l and its cosine at most sqrt(1 + (y/l)^2).

Source: L. N. Trefethen and J. A. C. Weideman, The exponentially convergent trapezoidal rule, SIAM Review 56 (2014), theorem 3.2.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import ceil, cosh, exp, log, sqrt

from flint import acb, arb, fmpq

from crankstar.derive import cyclotomic, meant
from crankstar.derive.cyclotomic import DIGITS
from crankstar.engine import Engine
from crankstar.records import Cylinder

GREATEST_SAMPLES = 8192
HALVINGS = 12
"""Widths of the strip tried, each two thirds of the one before."""


@dataclass(frozen=True)
class Ball:
    """A complex number known by a ball that holds it; has the arithmetic of an exact `Number`."""

    value: acb

    def __add__(self, other: Ball) -> Ball:
        return Ball(self.value + other.value)

    def __neg__(self) -> Ball:
        return Ball(-self.value)

    def __sub__(self, other: Ball) -> Ball:
        return Ball(self.value - other.value)

    def __mul__(self, other: Ball) -> Ball:
        return Ball(self.value * other.value)

    @property
    def zero(self) -> bool:
        """Whether the number cannot be told from zero."""
        return bool(self.value.contains(0))

    @property
    def conjugate(self) -> Ball:
        """The complex conjugate."""
        return Ball(self.value.conjugate())

    def times(self, factor: Fraction | int) -> Ball:
        """The number times a rational one."""
        return Ball(self.value * arb_of(Fraction(factor)))

    def turned(self, turn: Fraction) -> Ball:
        """The number turned by a part of a full turn."""
        return Ball(self.value * rotation(turn))

    def enclosed(self) -> acb:
        """The ball."""
        return self.value

    def __complex__(self) -> complex:
        return complex(float(self.value.real.mid()), float(self.value.imag.mid()))


def arb_of(value: Fraction) -> arb:
    """A fraction as a ball."""
    return arb(fmpq(value.numerator, value.denominator))


def rotation(turn: Fraction) -> acb:
    """exp(2 pi i turn) as a ball."""
    part = fmpq(2 * turn.numerator, turn.denominator)
    return acb(arb.cos_pi_fmpq(part), arb.sin_pi_fmpq(part))


def angle_of(radians: float, *, base: float = 0.0) -> acb:
    """exp(i angle) as a ball: of the rational part of a turn that was meant, from nought or from `base`, else of the double."""
    for start in (0.0, base):
        turn = meant.turn(radians - start)
        if turn is not None:
            return rotation(turn) * _exactly(start)
    return _exactly(radians)


def _exactly(radians: float) -> acb:
    return acb(arb(radians).cos(), arb(radians).sin())


@dataclass(frozen=True)
class Link:
    """One rod of a chain from the crank pin outward; bearing from the first cylinder's axis; lengths in crank radii."""

    length: Fraction
    offset: Fraction
    bearing: float
    knuckle_radius: Fraction
    knuckle_angle: float


def chain(engine: Engine, cylinder: Cylinder) -> tuple[Link, ...]:
    """The rods from the crank pin to a cylinder's piston."""
    radius = engine.throw(cylinder).radius
    by_number = {other.number: other for other in engine.cylinders}
    rods = [cylinder]
    while rods[0].articulated is not None:
        rods.insert(0, by_number[rods[0].articulated.master])

    def link(one: Cylinder) -> Link:
        on = one.articulated
        return Link(
            length=meant.ratio(one.rod_length / radius),
            offset=meant.ratio(one.offset / radius),
            bearing=one.bearing - rods[0].bearing,
            knuckle_radius=Fraction(0) if on is None else meant.ratio(on.radius / radius),
            knuckle_angle=0.0 if on is None else on.angle,
        )

    return tuple(map(link, rods))


@dataclass(frozen=True)
class Harmonic:
    """Order k of the last rod of a chain: force of a unit mass, in units of r w^2, as amplitudes of exp(i k psi).

    `piston` along its cylinder; `up`, `right` of the big end, from the first cylinder's axis.
    """

    piston: acb
    up: acb
    right: acb


@lru_cache(maxsize=1024)
def harmonic(rods: tuple[Link, ...], order: int) -> Harmonic:
    """The k-th harmonics of a chain of rods. ValueError where they cannot be enclosed."""
    with cyclotomic.precision(DIGITS):
        samples, bound, strip = _samples(rods)
        count = len(samples)
        folded = 2 * bound * (exp(-strip * (count - order)) + exp(-strip * (count + order))) / (1 - exp(-strip * count))
        out = []
        for coordinate in zip(*samples, strict=True):
            found = acb(0)
            for place, value in enumerate(coordinate):
                found += rotation(Fraction(-order * place % count, count)) * value
            error = arb(0, folded)
            out.append((found * 2 / count + acb(error, error)) * order**2)
        return Harmonic(*out)


def coefficient(rod_ratio: Fraction, order: int) -> arb:
    """A_k of a centred crank as a ball, rod_ratio = l/r.

    >>> with cyclotomic.precision(50):
    ...     print(coefficient(Fraction(4), 2).str(20, radius=False))
    0.25402504230697527657
    """
    rod = Link(length=rod_ratio, offset=Fraction(0), bearing=0.0, knuckle_radius=Fraction(0), knuckle_angle=0.0)
    return harmonic((rod,), order).piston.real


@lru_cache(maxsize=256)
def _samples(rods: tuple[Link, ...]) -> tuple[list[tuple[arb, arb, arb]], float, float]:
    """Piston along its cylinder, big end up and right, at N points; the bound M and half width rho of a strip."""
    strip, bound = _strip(rods)
    count = 2 * ceil((DIGITS * log(10) + log(max(bound, 1.0)) + 24 * strip + 4) / strip / 2)
    if count > GREATEST_SAMPLES:
        raise ValueError("the rods come too near to locking for their harmonics to be enclosed")
    return [_place(rods, rotation(Fraction(n, count))) for n in range(count)], bound, strip


def _place(rods: tuple[Link, ...], pin: acb) -> tuple[arb, arb, arb]:
    joint, along, direction = pin, arb(0), acb(0)
    for rod in rods:
        if rod.knuckle_radius:
            joint += angle_of(rod.knuckle_angle) * direction * arb_of(rod.knuckle_radius)
        axis = angle_of(rod.bearing)
        seen = joint / axis
        length = arb_of(rod.length)
        across = seen.imag - arb_of(rod.offset)
        height = (length**2 - across**2).sqrt()
        along = seen.real + height
        direction = axis * acb(height, -across) / length
    return along, joint.real, joint.imag


def _strip(rods: tuple[Link, ...]) -> tuple[float, float]:
    """The half width of a strip in which the motion is analytic, and a bound of it there, in crank radii."""
    strip = 3.0
    for _ in range(HALVINGS * 2):
        bound = _bound(rods, strip)
        if bound is not None:
            return strip, bound
        strip *= 2 / 3
    raise ValueError("the rods come too near to locking for their harmonics to be enclosed")


def _bound(rods: tuple[Link, ...], strip: float) -> float | None:
    """A bound of the piston's and the big end's place in the strip, None where the rod might lie square to its cylinder.

    |cos psi| and |sin psi| are at most cosh rho; a direction has |sine| <= s < 1 and |cosine| <= sqrt(1 + s^2).
    """
    reach, sine, turned, along = cosh(strip) * 1.0000001, 0.0, 0.0, 0.0
    widest = reach
    for rod in rods:
        # Either coordinate of the joint, in whatever frame, is a sum of two coordinates times a cosine and a sine.
        if rod.knuckle_radius:
            widest = widest + float(rod.knuckle_radius) * turned * 1.0000001
        # In the frame of a slave's cylinder a coordinate is made of both: at most sqrt(2) times the greater.
        frame = widest if rod is rods[0] else widest * sqrt(2.0)
        across = frame + abs(float(rod.offset))
        sine = across / float(rod.length)
        if sine >= 1:
            return None
        cosine = sqrt(1 + sine**2)
        along = frame + float(rod.length) * cosine
        # A knuckle pin's arm turned by a rod's direction and by its own angle: |cos| |direction| + |sin| |direction|.
        turned = sine + cosine
    return 1.0000001 * max(along, widest)
