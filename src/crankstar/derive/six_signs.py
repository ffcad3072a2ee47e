"""The six signs of balance of a single-shaft engine: P_R, M_R, P_I, M_I, P_II, M_II.

P_R is the sum of the centrifugal forces of equal masses on all cranks, M_R the sum of their
moments; P_I, P_II and M_I, M_II those of the inertia forces of the first and second order. In a row
of cylinders the latter are the parts, along the cylinders, of fictitious vectors C_I and C_II that
turn once and twice as fast as the crank; their sum is given as a vector at theta = 0, its bearing
from the cylinders' plane in the direction of rotation. Other engines have a vector that turns with
the crank and one that turns against it.

Source: V. A. Sinitsyn, balance of single-shaft engines, where a sign is a sum that may vanish.
"""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction

from crankstar.derive.algebra import cyclotomic, enclosure, rational, wave
from crankstar.derive.algebra.formula import Symbol
from crankstar.derive.algebra.wave import Amount, Wave, joined, scaled
from crankstar.derive.bodies import armed, bodies, pushed
from crankstar.derive.chapters import Chapter
from crankstar.derive.positions import Arms, arms
from crankstar.derive.records import DerivationError, Line, Step
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.mechanics.excitation import Reference

NAMES = {
    ("P", "R"): N_("force of the rotating masses"),
    ("M", "R"): N_("couple of the rotating masses"),
    ("P", "I"): N_("primary force"),
    ("M", "I"): N_("primary couple"),
    ("P", "II"): N_("secondary force"),
    ("M", "II"): N_("secondary couple"),
}


@dataclass(frozen=True)
class Sign:
    """One of the six sums.

    A fictitious vector at theta = 0 (`along`), or vectors that turn with and against the crank.
    Counted in m r w^2 (of the rotating mass of one crank for R), of order II times A_2 where all
    cylinders have one A_2 (`counted`); moments times lengths in bore pitches. `zero` is proved
    where `exact`.
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
    """The six sums of an engine with one crankshaft.

    Moments are about the middle of the cylinders unless a `reference` is given. Raises
    DerivationError for an engine with several crankshafts.

    >>> from crankstar.files.catalog import load
    >>> [sign.zero for sign in signs(load("sinitsyn-6-loop"))]
    [True, True, True, True, True, False]
    """
    if len({cylinder.shaft for cylinder in engine.cylinders}) > 1:
        raise DerivationError(
            _("The six signs of balance need an engine with one crankshaft; this one has several.")
        )
    if engine.shaft(engine.first.shaft).speed_ratio != 1:
        raise DerivationError(
            _(
                "The six signs of balance need the pistons on the reference crankshaft; these are "
                "on a geared one."
            )
        )
    with cyclotomic.precision(cyclotomic.DIGITS):
        placed = arms(engine, reference)
        out: list[Sign] = [*_rotating(engine, placed)]
        try:
            for below, order in (("I", 1), ("II", 2)):
                out += _reciprocating(engine, placed, below, Fraction(order))
        except enclosure.EnclosureError:
            raise DerivationError(
                _(
                    "The six signs cannot be given: the rods come too near to locking for their "
                    "harmonics to be enclosed."
                )
            ) from None
        return tuple(out)


def _rotating(engine: Engine, placed: Arms) -> list[Sign]:
    """Equal masses on all throws, or those of the file, as the fictitious vectors of a row."""
    shaft = engine.shaft(engine.first.shaft)
    exact = all(rational.turn(throw.angle) is not None for throw in shaft.throws)
    loads = [throw.turning_mass * throw.radius for throw in shaft.throws]
    for cylinder in engine.cylinders:
        loads[cylinder.throw - 1] += cylinder.rotating * engine.throw(cylinder).radius
    greatest = max(loads)
    vectors: list[tuple[Wave, tuple[str, int]]] = []
    for number, throw in enumerate(shaft.throws, 1):
        turn = rational.turn(throw.angle)
        share = rational.ratio(loads[number - 1] / greatest) if greatest else Fraction(1)
        where: Amount = enclosure.Ball(enclosure.angle_of(throw.angle, base=shaft.throws[0].angle))
        if exact and turn is not None:
            where = cyclotomic.root(turn)
        vectors.append(({(): where.times(share)}, (shaft.name, number)))
    force = joined(vector for vector, _ in vectors)
    moment = joined(scaled(vector, placed.throw[key]) for vector, key in vectors)
    return [
        Sign(letter, "R", _seen(engine, sums), sums, {}, exact)
        for letter, sums in (("P", force), ("M", moment))
    ]


def _seen(engine: Engine, vector: Wave) -> Wave | None:
    """A clock-plane vector measured from the plane of a row, in the direction of rotation.

    None for several rows.
    """
    bearings = {round(cylinder.bearing, 12) for cylinder in engine.cylinders}
    turn = rational.turn(engine.first.bearing)
    if len(bearings) > 1 or turn is None:
        return None
    turned = {key: amount.turned(-turn) for key, amount in vector.items()}
    return turned if engine.sense > 0 else wave.conjugated(turned)


def _reciprocating(engine: Engine, placed: Arms, below: str, order: Fraction) -> list[Sign]:
    parts = bodies(engine, order)
    pistons = [body for body in parts.moving if not body.turning]
    with_arms = [armed(body, placed.cylinder[body.cylinder or 0]) for body in pistons]
    out = []
    for letter, moving in (("P", pistons), ("M", with_arms)):
        forward, backward = wave.vectors(*pushed(moving), sense=engine.sense)
        one_row = len({round(body.bearing_deg, 9) for body in moving}) == 1
        along = joined(body.along or {} for body in moving) if one_row else None
        out.append(
            Sign(letter, below, along, forward, backward, not parts.why, parts.harmonic is not None)
        )
    return out


def signs_chapter(engine: Engine, *, reference: Reference | None = None) -> Chapter:
    """The six signs as a chapter to be read."""
    sums = signs(engine, reference=reference)
    lines = [line for sign in sums for line in _lines(sign)]
    words = [
        _(
            "Six sums show whether an engine is balanced: the centrifugal forces of the rotating "
            "masses and their moments, and the inertia forces of the first and second order and "
            "their moments."
        )
    ]
    if all(sign.along is not None for sign in sums):
        words.append(
            _(
                "Vectors at θ = 0: length ∠ bearing, from the plane of the cylinders in the "
                "direction of rotation."
            )
        )
    else:
        words.append(_("Vectors at θ = 0: length ∠ bearing, clockwise from up."))
    left = [f"{sign.letter}_{sign.below}" for sign in sums if not sign.zero]
    if left:
        words.append(_("Not zero: {signs}.", signs=", ".join(left)))
    else:
        words.append(_("All six are zero: cranks and pistons are balanced in themselves."))
    if any(shaft.weights for shaft in engine.shafts):
        words.append(_("Counterweights and balance weights are left out."))
    step = Step(_("Forces and moments"), tuple(words), tuple(lines))
    return Chapter(engine.name, _("The six signs of balance"), 1, {}, (step,))


def _lines(sign: Sign) -> list[Line]:
    """A sum as a line, or as two: with the crank and against it."""
    unit = Symbol("C", sign.below if sign.counted else "I")
    if sign.below == "R":
        unit = Symbol("P", "R")
    name, words = Symbol("Σ" + sign.letter, sign.below), _(NAMES[sign.letter, sign.below])
    vectors = [(sign.along, words)]
    if sign.along is None:
        vectors = [
            (sign.forward, _("{sum}, with the crank", sum=words)),
            (sign.backward, _("{sum}, against the crank", sum=words)),
        ]
    return [
        Line(name, (wave.counted(wave.vector(vector), unit),), label=_label(turning, vector, sign))
        for vector, turning in vectors
        if vector is not None
    ]


def _label(words: str, vector: Wave, sign: Sign) -> str:
    """The label of a sum: whether it vanishes."""
    if vector:
        return _("{sum}: not zero", sum=words)
    if sign.exact:
        return _("{sum}: exactly zero", sum=words)
    return _("{sum}: cannot be distinguished from zero", sum=words)
