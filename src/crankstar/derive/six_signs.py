"""The six signs of balance of a single-shaft engine, as textbooks list them: P_R, M_R, P_I, M_I, P_II, M_II.

P_R is the sum of the centrifugal forces of equal masses on all cranks, M_R the sum of their moments; P_I, P_II and M_I, M_II
those of the inertia forces of the first and second order. In a row of cylinders the latter are the parts, along the
cylinders, of fictitious vectors C_I and C_II that turn once and twice as fast as the crank; their sum is given as a vector
at theta = 0, its bearing from the cylinders' plane in the direction of rotation. Other engines have a vector that turns with
the crank and one that turns against it.

Source: V. A. Sinitsyn, balance of single-shaft engines, where a sign is a sum that may vanish.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from crankstar.derive import bodies as parts
from crankstar.derive import cyclotomic, enclosure, meant, wave
from crankstar.derive.formula import Formula, Polar, Sum, Symbol, product
from crankstar.derive.positions import Arms, arms
from crankstar.derive.records import Chapter, DerivationError, Line, Step
from crankstar.derive.wave import Amount, Wave, joined, scaled
from crankstar.engine import Engine
from crankstar.mechanism import Reference

NAMES = {"R": "rotating masses", "I": "first order", "II": "second order"}


@dataclass(frozen=True)
class Sign:
    """One of the six sums: a fictitious vector at theta = 0 (`along`), or vectors that turn with and against the crank.

    Counted in m r w^2 (of the rotating mass of one crank for R), of order II times A_2 where all cylinders have one A_2
    (`counted`); moments times lengths in bore pitches. `zero` is proved where `exact`.
    """

    letter: str
    below: str
    along: Wave | None
    forward: Wave
    backward: Wave
    exact: bool
    counted: bool = True

    @property
    def zero(self) -> bool:
        """Whether the sum vanishes."""
        return not self.forward and not self.backward


def signs(engine: Engine, *, reference: Reference | None = None) -> tuple[Sign, ...]:
    """The six sums of an engine with one crankshaft, moments about the middle of the cylinders unless told otherwise.

    Raises DerivationError for an engine with several crankshafts.

    >>> from crankstar.catalog import load
    >>> [sign.zero for sign in signs(load("sinitsyn-6-loop"))]
    [True, True, True, True, True, False]
    """
    if len({cylinder.shaft for cylinder in engine.cylinders}) > 1:
        raise DerivationError("the six signs of balance are those of an engine with one crankshaft; this one has several")
    if engine.shaft(engine.first.shaft).speed_ratio != 1:
        raise DerivationError("the six signs of balance need the pistons on the reference crankshaft; these are on a geared one")
    with cyclotomic.precision(cyclotomic.DIGITS):
        placed = arms(engine, reference)
        out: list[Sign] = [*_rotating(engine, placed)]
        try:
            for below, order in (("I", 1), ("II", 2)):
                out += _reciprocating(engine, placed, below, Fraction(order))
        except ValueError as error:
            raise DerivationError(f"the six signs cannot be given: {error}") from None
        return tuple(out)


def _rotating(engine: Engine, placed: Arms) -> list[Sign]:
    """Equal masses on all throws, or those of the file; in a row of cylinders seen from their plane, as the fictitious vectors."""
    shaft = engine.shaft(engine.first.shaft)
    exact = all(meant.turn(throw.angle) is not None for throw in shaft.throws)
    loads = [throw.rotating_mass * throw.radius for throw in shaft.throws]
    for cylinder in engine.cylinders:
        loads[cylinder.throw - 1] += parts.on_pin(engine, cylinder)
    greatest = max(loads)
    vectors: list[tuple[Wave, tuple[str, int]]] = []
    for place, throw in enumerate(shaft.throws, 1):
        turn = meant.turn(throw.angle)
        share = meant.ratio(loads[place - 1] / greatest) if greatest else Fraction(1)
        where: Amount = enclosure.Ball(enclosure.angle_of(throw.angle, base=shaft.throws[0].angle))
        if exact and turn is not None:
            where = cyclotomic.root(turn)
        vectors.append(({(): where.times(share)}, (shaft.name, place)))
    force = joined(vector for vector, _ in vectors)
    moment = joined(scaled(vector, placed.throw[key]) for vector, key in vectors)
    return [Sign(letter, "R", _seen(engine, sums), sums, {}, exact) for letter, sums in (("P", force), ("M", moment))]


def _seen(engine: Engine, vector: Wave) -> Wave | None:
    """A vector of the clock plane from the plane of a row of cylinders, in the direction of rotation; None for several rows."""
    bearings = {round(cylinder.bearing, 12) for cylinder in engine.cylinders}
    turn = meant.turn(engine.first.bearing)
    if len(bearings) > 1 or turn is None:
        return None
    turned = {key: amount.turned(-turn) for key, amount in vector.items()}
    return turned if engine.sense > 0 else wave.conjugated(turned)


def _reciprocating(engine: Engine, placed: Arms, below: str, order: Fraction) -> list[Sign]:
    found = parts.bodies(engine, order)
    pistons = [body for body in found.moving if body.cylinder is not None]
    out = []
    for letter in ("P", "M"):
        moving = pistons if letter == "P" else [parts.armed(b, placed.cylinder[b.cylinder or 0]) for b in pistons]
        up, right = joined(b.up for b in moving), joined(b.right for b in moving)
        forward, backward = wave.vectors(up, right, sense=engine.sense)
        one_row = len({round(body.bearing_deg, 9) for body in moving}) == 1
        along = joined(body.along or {} for body in moving) if one_row else None
        out.append(Sign(letter, below, along, forward, backward, not found.why, found.harmonic is not None))
    return out


def signs_chapter(engine: Engine, *, reference: Reference | None = None) -> Chapter:
    """The six signs as a chapter to be read."""
    found = signs(engine, reference=reference)
    lines: list[Line] = []
    for sign in found:
        unit = Symbol("P", "R") if sign.below == "R" else Symbol("C", sign.below if sign.counted else "I")
        told = f"{'force' if sign.letter == 'P' else 'moment'}, {NAMES[sign.below]}"
        name = Symbol("Σ" + sign.letter, sign.below)
        if sign.along is not None:
            lines.append(Line(name, (_counted(sign.along, unit),), label=f"{told}: {_verdict(sign.along, sign)}"))
        else:
            lines.append(
                Line(name, (_counted(sign.forward, unit),), label=f"{told}, with the crank: {_verdict(sign.forward, sign)}")
            )
            lines.append(Line(name, (_counted(sign.backward, unit),), label=f"{told}, against it: {_verdict(sign.backward, sign)}"))
    left = [f"{'P' if sign.letter == 'P' else 'M'}_{sign.below}" for sign in found if not sign.zero]
    one_row = all(sign.along is not None for sign in found)
    measured = "from the plane of the cylinders in the direction of rotation" if one_row else "clockwise from up"
    meaning = (
        "Six sums tell whether an engine is balanced: of the centrifugal forces of the rotating masses and their moments, and of "
        "the inertia forces of the first and second order and their moments. "
        f"Each is a vector at θ = 0: its length ∠ its bearing, {measured}."
    )
    verdict = f"Not zero: {', '.join(left)}." if left else "All six are zero: cranks and pistons are balanced in themselves."
    if any(shaft.weights for shaft in engine.shafts):
        verdict += " Counterweights and balance weights are left out."
    words = (meaning, verdict)
    return Chapter(engine.name, "The six signs of balance", 1, {}, (Step("Forces and moments", words, tuple(lines)),))


def _verdict(vector: Wave, sign: Sign) -> str:
    if vector:
        return "not zero"
    return "exactly zero" if sign.exact else "cannot be told from zero"


def _counted(vector: Wave, unit: Symbol) -> Formula:
    formula = wave.vector(vector)
    if isinstance(formula, Polar):
        return Polar(product(unit, formula.length), formula.angle)
    if isinstance(formula, Sum):
        return Sum(tuple(Polar(product(unit, p.length), p.angle) for p in formula.terms if isinstance(p, Polar)))
    return formula
