"""Families of engines: closed forms in which a dimension stays a letter.

* `alpha`: any V engine whose two banks share their crank pins, half the bank angle left open. With S = sum of exp(i k p) over
  the pins (p from pin 1) and T = sum of z exp(i k p), one V of two cylinders draws an ellipse with the semi-axes
  2 cos(alpha) cos(k alpha) up and 2 sin(alpha) sin(k alpha) to the right, and the engine draws it S (or T) times.
* `phi`: a twin with parallel cylinders, its second crank phi behind the first.
* `n`: n cylinders in line on evenly spaced cranks: n cos(k theta) where n divides k, else nothing.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from math import pi

from crankstar.derive import cyclotomic, meant, wave
from crankstar.derive.bodies import inexact
from crankstar.derive.formula import (
    NOUGHT,
    THETA,
    Applied,
    Formula,
    Pi,
    Power,
    Ratio,
    Symbol,
    angle,
    cosine,
    number,
    product,
    summed,
)
from crankstar.derive.positions import arms
from crankstar.derive.records import Chapter, DerivationError, Line, Quantity, Step, nth, unit_formula, unit_symbol
from crankstar.derive.wave import Wave, joined, scaled
from crankstar.engine import Engine

ALPHA, PHI, COUNT = Symbol("alpha"), Symbol("phi"), Symbol("n")


def family(engine: Engine, order: float | Fraction, quantity: Quantity, *, symbol: str) -> Chapter:
    """The closed form of one order for all engines that differ from this one in one dimension only.

    `symbol` is `alpha`, `phi` or `n`. Raises DerivationError where the engine has no such dimension.

    >>> from crankstar.catalog import load
    >>> from crankstar.derive.typeset import text
    >>> up = family(load("v2-90"), 1, "force", symbol="alpha").steps[-1].lines[0]
    >>> text(up.chain[-1])
    '2 cos² α cos(θ − α)'
    """
    if symbol not in FAMILIES:
        raise DerivationError(f"no family leaves {symbol!r} open; there are: {', '.join(FAMILIES)}")
    if isinstance(order, bool) or order not in range(1, 25):
        raise DerivationError(f"the order is {order!r}; a family has whole orders from 1 to 24")
    if quantity not in ("force", "couple"):
        raise DerivationError(f"there is no derivation of {quantity!r}; the quantity can be force or couple")
    _alike(engine)
    with cyclotomic.precision(cyclotomic.DIGITS):
        return FAMILIES[symbol](engine, int(order), quantity)


def _alike(engine: Engine) -> None:
    why = inexact(engine)
    if why:
        raise DerivationError(f"a family needs an engine whose forms are exact: {why}")
    if len({cylinder.shaft for cylinder in engine.cylinders}) > 1:
        raise DerivationError("a family needs an engine with one crankshaft; this one has several")
    sizes = {(c.reciprocating_mass, c.rod_length, engine.throw(c).radius) for c in engine.cylinders}
    if len(sizes) > 1 or any(cylinder.rod for cylinder in engine.cylinders):
        raise DerivationError("a family needs cylinders that are all alike in mass, rod and stroke")
    shaft = engine.shaft(engine.first.shaft)
    if shaft.speed_ratio != 1:
        raise DerivationError("a family needs cylinders on the reference crankshaft")


def _chapter(engine: Engine, order: int, quantity: Quantity, named: str, steps: list[Step]) -> Chapter:
    title = nth(Fraction(order), quantity)
    symbols = {symbol.name: float(value) for symbol, value in arms(engine).values.items()}
    if order > 1 and order % 2:
        words = f"The pistons of a centred crank have no harmonic of order {order}: nothing is left, whatever the angles."
        steps = [Step("No such harmonic", (words,))]
    counted = Line(unit_symbol(order), (unit_formula(order),), label="unit")
    first = Step("The family", (f"{named} Numbers are counted in the unit below; rotating masses are left out.",), (counted,))
    return Chapter(
        engine.name, f"{title[0].upper()}{title[1:]}, {named.rstrip('.').split(',')[0]}", order, symbols, (first, *steps)
    )


def _vee(engine: Engine, order: int, quantity: Quantity) -> Chapter:
    """All V engines with these pins: up 2 cos(alpha) cos(k alpha), right 2 sin(alpha) sin(k alpha), times the star of the pins."""
    pins: dict[int, dict[Fraction, int]] = {}
    for cylinder in engine.cylinders:
        pins.setdefault(cylinder.throw, {})[meant.turn(cylinder.bearing) or Fraction(0)] = cylinder.number
    bearings = {bearing for sharing in pins.values() for bearing in sharing}
    if len(bearings) != 2 or sum(bearings) != 0 or any(len(sharing) != 2 for sharing in pins.values()):
        raise DerivationError(
            "alpha is half the angle between two banks that share their crank pins; this engine is not of that kind"
        )
    first = engine.first
    start = meant.turn(engine.throw(first).angle) or Fraction(0)
    leading = meant.turn(first.bearing) or Fraction(0)
    side, sense = (1 if leading > 0 else -1), engine.sense
    placed = arms(engine)
    star: list[Wave] = []
    moments: list[Wave] = []
    offsets: list[Wave] = []
    half = Fraction(1, 2)
    for place, sharing in pins.items():
        turn = meant.turn(engine.shaft(first.shaft).throws[place - 1].angle) or Fraction(0)
        vector: Wave = {(): cyclotomic.root(sense * order * (turn - start))}
        mine, other = placed.cylinder[sharing[leading]], placed.cylinder[sharing[-leading]]
        star.append(vector)
        moments.append(scaled(vector, wave.form_sum([(half, mine), (half, other)])))
        offsets.append(scaled(vector, wave.form_sum([(half, mine), (-half, other)])))
    sums, arm, apart = joined(star), joined(moments), joined(offsets)
    lead = product(sense * side * order, ALPHA)
    both, across = _of_angle(order)
    if quantity == "force":
        up = _shifted(sums, order, lead, product(2, both))
        right = _shifted(_turned(sums), order, lead, product(2 * sense, across))
    else:
        cross, along = _crossed(order)
        up = summed(
            _shifted(arm, order, lead, product(2, both)), _shifted(_turned(apart), order, lead, product(2 * sense * side, cross))
        )
        right = summed(
            _shifted(_turned(arm), order, lead, product(2 * sense, across)), _shifted(apart, order, lead, product(2 * side, along))
        )
    letter = "F" if quantity == "force" else "M"
    told = [Line(Symbol("S"), (wave.vector(sums),), label="star of the pins")]
    if quantity == "couple":
        told.append(Line(Symbol("T"), (wave.vector(arm),), label="star of the pins with their arms"))
    ellipse = (
        "Two cylinders at bearings +α and −α work on one pin. The second reaches its dead centre 2α later or earlier than the "
        "first, and their cosines add to an ellipse with the semi-axes 2 cos α cos kα upwards and 2 sin α sin kα to the right."
    )
    pinned = (
        "All pins do the same at other crank angles: the sum is that of one pin times S, the sum of unit vectors at k times "
        "the angles of the pins from pin 1"
    )
    if quantity == "couple":
        pinned += ", or times T, the same with the arms of the pins"
        pinned += "; and where one bank stands in front of the other, with half of that as arms"
    told = [*_one_pin(order, sense, side), *told]
    form = (
        Line(Symbol(letter, "up"), (up,), "signal", (), 0.0, "up"),
        Line(Symbol(letter, "right"), (right,), "signal", (), 90.0, "right"),
    )
    steps = [Step("One V, and the star of its pins", (ellipse, f"{pinned}."), tuple(told)), Step("The closed form", (), form)]
    return _chapter(engine, order, quantity, "V of bank angle 2α, its banks on common pins.", steps)


def _one_pin(order: int, sense: int, side: int) -> list[Line]:
    """The two cylinders of one pin: their cosines added, upwards and to the right."""
    both, across = _of_angle(order)
    turning = product(order, THETA)
    one, other = cosine(turning), cosine(summed(turning, product(2 * sense * side * order, ALPHA)))
    middle = summed(turning, product(sense * side * order, ALPHA))
    sine = Applied("sin", ALPHA)
    up = (summed(product(cosine(ALPHA), one), product(cosine(ALPHA), other)), product(2, both, cosine(middle)))
    right = (summed(product(side, sine, one), product(-side, sine, other)), product(2 * sense, across, Applied("sin", middle)))
    return [Line(Symbol("V", "up"), up, label="one pin, up"), Line(Symbol("V", "right"), right, label="one pin, right")]


def _of_angle(order: int) -> tuple[Formula, Formula]:
    """The factors cos(alpha) cos(k alpha) and sin(alpha) sin(k alpha)."""
    if order == 1:
        return Power(Applied("cos", ALPHA), 2), Power(Applied("sin", ALPHA), 2)
    inside = product(order, ALPHA)
    return product(cosine(ALPHA), cosine(inside)), product(Applied("sin", ALPHA), Applied("sin", inside))


def _crossed(order: int) -> tuple[Formula, Formula]:
    """The factors cos(alpha) sin(k alpha) and sin(alpha) cos(k alpha)."""
    inside = product(order, ALPHA)
    return product(cosine(ALPHA), Applied("sin", inside)), product(Applied("sin", ALPHA), cosine(inside))


def _turned(vector: Wave) -> Wave:
    """A quarter of a turn behind: Re(-i z exp(i x)) = z sin x for a real z."""
    return wave.multiplied(vector, cyclotomic.root(Fraction(-1, 4)))


def _shifted(vector: Wave, order: int, lead: Formula, factor: Formula) -> Formula:
    """A signal with letters in its size and phase: sum of size * factor * cos(k theta + lead + angle)."""
    terms = []
    for piece in wave.pieces(vector):
        inside = summed(product(order, THETA), lead)
        if piece.phase in (Fraction(1, 4), Fraction(-1, 4)):
            sign = -1 if piece.phase > 0 else 1  # pyright: ignore[reportOptionalOperand]
            terms.append(product(sign, piece.size, factor, Applied("sin", inside)))
        else:
            terms.append(product(piece.size, factor, cosine(summed(inside, piece.angle))))
    return summed(*terms)


def _twin(engine: Engine, order: int, quantity: Quantity) -> Chapter:
    """Two parallel cylinders, the second crank phi behind: cos x + cos(x - k phi), and their difference times half the pitch."""
    cylinders = engine.cylinders
    if len(cylinders) != 2 or len({c.throw for c in cylinders}) != 2 or len({meant.turn(c.bearing) for c in cylinders}) != 1:
        raise DerivationError(
            "phi is the angle between the cranks of two parallel cylinders on one shaft; this engine is not such a twin"
        )
    behind = product(-order, PHI)
    half = PHI if order == 2 else Ratio(product(order, PHI), number(2)) if order % 2 else product(order // 2, PHI)
    inside, middle = product(order, THETA), product(-1, half)
    first, second = cosine(inside), cosine(summed(inside, behind))
    if quantity == "force":
        chain: tuple[Formula, ...] = (summed(first, second), product(2, cosine(half), cosine(summed(inside, middle))))
    else:
        placed = arms(engine)
        one, other = (wave.form(placed.cylinder[number]) for number in sorted(placed.cylinder))
        if one == other:
            chain = (NOUGHT,)
        else:
            raw = summed(product(one, first), product(other, second))
            size = product(2, one)
            chain = (raw, product(-1, size, Applied("sin", half), Applied("sin", summed(inside, middle))))
    bearing = cylinders[0].bearing
    along = Line(Symbol("F" if quantity == "force" else "M"), chain, "signal", (), bearing * 180 / pi, "along the cylinders")
    words = "cos x + cos y = 2 cos((x − y)/2) cos((x + y)/2); cos x − cos y = −2 sin((x − y)/2) sin((x + y)/2)."
    return _chapter(
        engine, order, quantity, "Twin whose second crank stands φ behind the first.", [Step("The closed form", (words,), (along,))]
    )


def _row(engine: Engine, order: int, quantity: Quantity) -> Chapter:
    """The n cylinders of a row on evenly spaced cranks."""
    turns = sorted(((meant.turn(engine.throw(c).angle) or Fraction(0)) % 1) for c in engine.cylinders)
    count = len(turns)
    even = [(turn - turns[0]) % 1 for turn in turns] == [Fraction(i, count) for i in range(count)]
    if not even or len({meant.turn(c.bearing) for c in engine.cylinders}) != 1:
        raise DerivationError(
            "n is the number of cylinders in one row on cranks evenly spread over a turn; this engine is not of that kind"
        )
    if quantity == "couple":
        raise DerivationError(
            "the couple of n cylinders in a row depends on how the cranks are numbered; leave --symbolic out for it"
        )
    part = Ratio(product(order, Pi()), COUNT)
    geometric = Ratio(Applied("sin", angle(Fraction(order, 2))), Applied("sin", part))
    series = (
        "The cranks stand at the n-th parts of a turn, so in order k the vectors stand k/n of a turn apart, whatever the "
        "numbering: a geometric series, with the sum n where n divides k and else sin(kπ)/sin(kπ/n) = 0."
    )
    words = (series, f"Here k = {order}: of all rows only those with n = {_divisors(order)} have a force of this order.")
    whole = count if order % count == 0 else 0
    chain = (COUNT,) if whole else (geometric, NOUGHT)
    divides = f"n = {count}: n {'divides' if whole else 'does not divide'} {order}"
    along = engine.first.bearing * 180 / pi
    lines = (
        Line(Symbol("S"), chain, label=divides),
        Line(Symbol("F"), (product(whole, _start(engine, order)),), "signal", (), along, "along the cylinders"),
    )
    return _chapter(engine, order, quantity, "Row of n cylinders on evenly spaced cranks.", [Step("The closed form", words, lines)])


def _start(engine: Engine, order: int) -> Formula:
    first = engine.first
    lag = (meant.turn(engine.throw(first).angle) or Fraction(0)) - (meant.turn(first.bearing) or Fraction(0))
    return cosine(summed(product(order, THETA), angle(engine.sense * order * lag)))


def _divisors(order: int) -> str:
    return ", ".join(str(n) for n in range(1, order + 1) if order % n == 0)


FAMILIES: dict[str, Callable[[Engine, int, Quantity], Chapter]] = {"alpha": _vee, "phi": _twin, "n": _row}
