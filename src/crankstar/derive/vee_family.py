"""V engines with common crank pins, half the bank angle alpha kept as a letter.

With S = sum of exp(i k p) over the pins (p from pin 1) and T = sum of z exp(i k p), one V of two
cylinders draws an ellipse with the semi-axes 2 cos(alpha) cos(k alpha) up and 2 sin(alpha)
sin(k alpha) to the right, and the engine draws it S (or T) times.
"""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple

from crankstar.derive.algebra import cyclotomic, rational, wave
from crankstar.derive.algebra.formula import (
    THETA,
    Applied,
    Formula,
    Power,
    Symbol,
    cosine,
    product,
    summed,
)
from crankstar.derive.algebra.wave import HALF, Wave, joined, scaled
from crankstar.derive.positions import arms
from crankstar.derive.records import DerivationError, Line, Quantity, Step
from crankstar.engine.engine import Engine
from crankstar.language.messages import _

ALPHA = Symbol("alpha")


class Star(NamedTuple):
    """The pins of a V, from pin 1.

    `side` is 1 where the first cylinder leans to the right, else -1; `sums`, `moments` and
    `offsets` are the sums of unit vectors at k times the angles of the pins, plain, with the arms
    of the pins, and with half of what one bank stands in front of the other.
    """

    side: int
    sums: Wave
    moments: Wave
    offsets: Wave


def vee(engine: Engine, order: int, quantity: Quantity) -> list[Step]:
    """Up 2 cos(alpha) cos(k alpha), right 2 sin(alpha) sin(k alpha), times the star of the pins."""
    star, sense = _star(engine, order), engine.sense
    letter, arms, offsets = "F", star.sums, {}
    if quantity == "couple":
        letter, arms, offsets = "M", star.moments, star.offsets
    up, right = _whole(arms, offsets, order, sense, star.side)
    lines = [*_one_pin(order, sense, star.side), _line("S", star.sums, _("star of the pins"))]
    if quantity == "couple":
        lines.append(_line("T", star.moments, _("star of the pins with their arms")))
    form = (
        Line(Symbol(letter, "up"), (up,), "signal", (), 0.0, _("up")),
        Line(Symbol(letter, "right"), (right,), "signal", (), 90.0, _("right")),
    )
    return [
        Step(_("One V, and the star of its pins"), _words(quantity), tuple(lines)),
        Step(_("The closed form"), (), form),
    ]


def _words(quantity: Quantity) -> tuple[str, ...]:
    ellipse = _(
        "Two cylinders at bearings +α and −α share one pin. The second reaches its dead centre "
        "2α later or earlier than the first, and their cosines add up to an ellipse with the "
        "semi-axes 2 cos α cos kα upwards and 2 sin α sin kα to the right."
    )
    pins = _(
        "The other pins add the same sum at other crank angles: the total is that of one pin "
        "times S, the sum of unit vectors at k times the angles of the pins from pin 1."
    )
    if quantity == "force":
        return ellipse, pins
    arms = _(
        "For the couple, T replaces S: the same sum with the arms of the pins and, where one "
        "bank stands in front of the other, with half of that offset as arms."
    )
    return ellipse, pins, arms


def _line(letter: str, vector: Wave, label: str) -> Line:
    return Line(Symbol(letter), (wave.vector(vector),), label=label)


def _star(engine: Engine, order: int) -> Star:
    pins: dict[int, dict[Fraction, int]] = {}
    for cylinder in engine.cylinders:
        bearing = rational.turn(cylinder.bearing) or Fraction(0)
        pins.setdefault(cylinder.throw, {})[bearing] = cylinder.number
    bearings = {bearing for sharing in pins.values() for bearing in sharing}
    pairs = all(len(sharing) == 2 for sharing in pins.values())
    if len(bearings) != 2 or sum(bearings) != 0 or not pairs:
        raise DerivationError(
            _(
                "alpha is half the angle between two banks that share their crank pins; this "
                "engine is not of that kind."
            )
        )
    first = engine.first
    start = rational.turn(engine.throw(first).angle) or Fraction(0)
    leading = rational.turn(first.bearing) or Fraction(0)
    placed = arms(engine).cylinder
    star: list[tuple[Wave, Wave, Wave]] = []
    for place, sharing in pins.items():
        turn = rational.turn(engine.shaft(first.shaft).throws[place - 1].angle) or Fraction(0)
        vector: Wave = {(): cyclotomic.root(engine.sense * order * (turn - start))}
        mine, other = placed[sharing[leading]], placed[sharing[-leading]]
        middle = wave.form_sum([(HALF, mine), (HALF, other)])
        apart = wave.form_sum([(HALF, mine), (-HALF, other)])
        star.append((vector, scaled(vector, middle), scaled(vector, apart)))
    sums, moments, offsets = (joined(own) for own in zip(*star, strict=True))
    return Star(1 if leading > 0 else -1, sums, moments, offsets)


def _whole(arms: Wave, offsets: Wave, order: int, sense: int, side: int) -> tuple[Formula, Formula]:
    """The force, or the couple of the forces, up and to the right."""
    lead = product(sense * side * order, ALPHA)

    def part(vector: Wave, factor: int, outer: str, inner: str) -> Formula:
        return _shifted(vector, order, lead, product(factor, _of_angle(outer, inner, order)))

    up = summed(part(arms, 2, "cos", "cos"), part(_turned(offsets), 2 * sense * side, "cos", "sin"))
    right = summed(
        part(_turned(arms), 2 * sense, "sin", "sin"), part(offsets, 2 * side, "sin", "cos")
    )
    return up, right


def _one_pin(order: int, sense: int, side: int) -> list[Line]:
    """The two cylinders of one pin: their cosines added, upwards and to the right."""
    both, across = (_of_angle(name, name, order) for name in ("cos", "sin"))
    turning, lead = product(order, THETA), product(sense * side * order, ALPHA)
    first, second = cosine(turning), cosine(summed(turning, product(2, lead)))
    middle, sine = summed(turning, lead), Applied("sin", ALPHA)
    up = (
        summed(product(cosine(ALPHA), first), product(cosine(ALPHA), second)),
        product(2, both, cosine(middle)),
    )
    right = (
        summed(product(side, sine, first), product(-side, sine, second)),
        product(2 * sense, across, Applied("sin", middle)),
    )
    return [
        Line(Symbol("V", "up"), up, label=_("one pin, up")),
        Line(Symbol("V", "right"), right, label=_("one pin, right")),
    ]


def _of_angle(outer: str, inner: str, order: int) -> Formula:
    """A factor such as cos(alpha) sin(k alpha), by the names of its functions."""
    if order == 1 and outer == inner:
        return Power(Applied(outer, ALPHA), 2)
    return product(Applied(outer, ALPHA), Applied(inner, product(order, ALPHA)))


def _turned(vector: Wave) -> Wave:
    """A quarter of a turn behind: Re(-i z exp(i x)) = z sin x for a real z."""
    return wave.multiplied(vector, cyclotomic.root(Fraction(-1, 4)))


def _shifted(vector: Wave, order: int, lead: Formula, factor: Formula) -> Formula:
    """A signal with letters: the sum of size * factor * cos(k theta + lead + angle)."""
    inside = summed(product(order, THETA), lead)
    return summed(
        *(
            wave.written(piece._replace(size=product(piece.size, factor)), inside)
            for piece in wave.pieces(vector)
        )
    )
