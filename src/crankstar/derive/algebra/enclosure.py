"""Harmonics of pistons and knuckle pins to fifty digits, each with a proved bound of its error.

The place of a piston along its cylinder is sampled in ball arithmetic at N points of a turn. It is
analytic in the crank angle as long as no rod can lie square to its cylinder, so in a strip |Im psi|
<= rho it is bounded by some M, and the harmonics of its samples miss the true ones by no more than

    2 M (exp(-rho (N - k)) + exp(-rho (N + k))) / (1 - exp(-rho N)),

the harmonics folded onto k. M and rho come from |sin psi|, |cos psi| <= cosh rho alone: for a rod
of length l whose big end strays at most y from the cylinder's axis, y < l, the rod's sine is at
most y/l and its cosine at most sqrt(1 + (y/l)^2).

Source: L. N. Trefethen and J. A. C. Weideman, The exponentially convergent trapezoidal rule, SIAM
Review 56 (2014), theorem 3.2.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from math import ceil, cosh, exp, log, pi, sqrt

from flint import acb, arb, fmpq

from crankstar.derive.algebra import cyclotomic, rational
from crankstar.derive.algebra.cyclotomic import DIGITS, Number
from crankstar.engine.engine import Engine
from crankstar.engine.motion import series_coefficient
from crankstar.engine.records import Cylinder


class EnclosureError(ValueError):
    """Rods that come too near to locking for their harmonics to be enclosed."""


GREATEST_SAMPLES = 8192
HALVINGS = 12
"""Widths of the strip tried, each two thirds of the one before."""


@dataclass(frozen=True)
class Ball:
    """A complex number known by a ball that holds it.

    It has the arithmetic of an exact `Number`; what is made of both is a ball.
    """

    value: acb

    def __add__(self, other: Amount) -> Ball:
        return Ball(self.value + other.enclosed())

    def __neg__(self) -> Ball:
        return Ball(-self.value)

    def __sub__(self, other: Amount) -> Ball:
        return self + -other

    def __mul__(self, other: Amount) -> Ball:
        return Ball(self.value * other.enclosed())

    __radd__, __rmul__ = __add__, __mul__

    @property
    def zero(self) -> bool:
        """Whether the ball contains zero."""
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


Amount = Number | Ball


def arb_of(value: Fraction) -> arb:
    """A fraction as a ball."""
    return arb(fmpq(value.numerator, value.denominator))


def rotation(turn: Fraction) -> acb:
    """exp(2 pi i turn) as a ball."""
    part = fmpq(2 * turn.numerator, turn.denominator)
    return acb(arb.cos_pi_fmpq(part), arb.sin_pi_fmpq(part))


def angle_of(radians: float, *, base: float = 0.0) -> acb:
    """exp(i angle) as a ball, from the rational part of a turn where there is one.

    It is counted from zero or from `base`; without one the ball has every angle that the double
    may stand for after a layout's sums, so that what these leave over is not told from zero.

    >>> opposite = angle_of(1.775) + angle_of(1.775 + pi)
    >>> opposite.contains(acb(0)), float(abs(angle_of(1.775) - acb(0, 1.775).exp()).upper()) < 1e-11
    (True, True)
    """
    for start in (0.0, base):
        turn = rational.turn(radians - start)
        if turn is not None:
            return rotation(turn) * _nearly(start)
    return _nearly(radians)


def _nearly(radians: float) -> acb:
    if radians == 0:
        return acb(1)
    angle = arb(radians, 2 * pi * rational.TURN_ROUNDING)
    return acb(angle.cos(), angle.sin())


@dataclass(frozen=True)
class Link:
    """One rod of a chain, in crank radii; bearing from the first cylinder's axis."""

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

    def link(rod: Cylinder) -> Link:
        on = rod.articulated
        return Link(
            length=rational.ratio(rod.rod_length / radius),
            offset=rational.ratio(rod.offset / radius),
            bearing=rod.bearing - rods[0].bearing,
            knuckle_radius=Fraction(0) if on is None else rational.ratio(on.radius / radius),
            knuckle_angle=0.0 if on is None else on.angle,
        )

    return tuple(map(link, rods))


@dataclass(frozen=True)
class Harmonic:
    """Order k of the last rod of a chain: force of a unit mass in r w^2, by exp(i k psi).

    `piston` along its cylinder; `up`, `right` of the big end, from the first cylinder's axis.
    """

    piston: acb
    up: acb
    right: acb


@lru_cache(maxsize=1024)
def harmonic(rods: tuple[Link, ...], order: int) -> Harmonic:
    """The k-th harmonics of a chain of rods. EnclosureError where they cannot be enclosed."""
    with cyclotomic.precision(DIGITS):
        samples, bound, strip = _samples(rods)
        count = len(samples)
        both = exp(-strip * (count - order)) + exp(-strip * (count + order))
        folded = 2 * bound * both / (1 - exp(-strip * count))
        out = []
        for coordinate in zip(*samples, strict=True):
            total = acb(0)
            for index, value in enumerate(coordinate):
                total += rotation(Fraction(-order * index % count, count)) * value
            error = arb(0, folded)
            out.append((total * 2 / count + acb(error, error)) * order**2)
        return Harmonic(*out)


def coefficient(rod_ratio: Fraction, order: int) -> arb:
    """A_k of a centred crank as a ball, rod_ratio = l/r > 1: all digits true, however small it is.

    From its series in lambda = r/l, the terms of which have one sign; from the j-th power on which
    each term is less than lambda^2 times the one before, the rest is less than the next term over
    1 - lambda^2.

    >>> with cyclotomic.precision(50):
    ...     print(coefficient(Fraction(4), 2).str(20, radius=False))
    0.25402504230697527657
    """
    if order == 1 or order % 2:
        return arb(int(order == 1))
    with cyclotomic.precision(DIGITS):
        ratio, half = arb_of(1 / rod_ratio), order // 2
        term = arb_of(series_coefficient(order, order - 1)) * ratio ** (order - 1)
        total, j = arb(0), half
        while 2 * j <= half**2 or not abs(term) < abs(total) * arb(10) ** -DIGITS:
            total += term
            term *= ratio**2 * arb_of(Fraction(4 * j**2 - 1, 4 * ((j + 1) ** 2 - half**2)))
            j += 1
        return total + (term / (1 - ratio**2)).union(arb(0))


@lru_cache(maxsize=256)
def _samples(rods: tuple[Link, ...]) -> tuple[list[tuple[arb, arb, arb]], float, float]:
    """Piston travel, big end (up, right) at N points; bound M and half width rho of a strip."""
    strip, bound = _strip(rods)
    count = 2 * ceil((DIGITS * log(10) + log(max(bound, 1.0)) + 24 * strip + 4) / strip / 2)
    if count > GREATEST_SAMPLES:
        raise EnclosureError("the rods come too near to locking for their harmonics to be enclosed")
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
    """The half width of a strip in which the motion is analytic, and its bound in crank radii."""
    strip = 3.0
    for _ in range(HALVINGS * 2):
        bound = _bound(rods, strip)
        if bound is not None:
            return strip, bound
        strip *= 2 / 3
    raise EnclosureError("the rods come too near to locking for their harmonics to be enclosed")


def _bound(rods: tuple[Link, ...], strip: float) -> float | None:
    """A bound of piston and big end in the strip; None where a rod may be square to its cylinder.

    |cos psi| and |sin psi| are at most cosh rho; a direction has |sine| <= s < 1 and |cosine| <=
    sqrt(1 + s^2).
    """
    reach, sine, turned, along = cosh(strip) * 1.0000001, 0.0, 0.0, 0.0
    widest = reach
    for rod in rods:
        # Either coordinate of the joint, in whatever frame, is a sum of two coordinates times a
        # cosine and a sine.
        if rod.knuckle_radius:
            widest = widest + float(rod.knuckle_radius) * turned * 1.0000001
        # In the frame of a slave's cylinder a coordinate is made of both: at most sqrt(2) times the
        # greater.
        frame = widest if rod is rods[0] else widest * sqrt(2.0)
        across = frame + abs(float(rod.offset))
        sine = across / float(rod.length)
        if sine >= 1:
            return None
        cosine = sqrt(1 + sine**2)
        along = frame + float(rod.length) * cosine
        # A knuckle pin's arm turned by a rod's direction and by its own angle: |cos| |direction| +
        # |sin| |direction|.
        turned = sine + cosine
    return 1.0000001 * max(along, widest)
