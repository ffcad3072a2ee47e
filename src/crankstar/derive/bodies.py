"""The parts of an engine that push in one order, exactly where that can be, else in balls.

What turns with a shaft pushes, once a turn of it, towards where it is. A piston on a centred crank
pushes along its cylinder (bearing beta) with

    m r n^2 w^2 A_j cos(j psi),     psi = alpha - beta + s n theta,     k = j |n|,

alpha the bearing of its throw at theta = 0, n the signed speed ratio of its shaft, s the sense of
rotation, A_j its j-th harmonic: so with `cos(k theta + delta)`, delta = s sgn(n) j (alpha - beta).
With angles that are rational parts of a turn all pushes are sums of roots of unity times rational
numbers; A_j stays a symbol where cylinders differ in it. A rod given as a rigid body acts as two
point masses in force and couple: its share centre/length at the piston pin, the rest at the crank
pin.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from fractions import Fraction
from math import lcm, pi
from typing import Literal, NamedTuple

from flint import acb

from crankstar.derive.algebra import cyclotomic, enclosure, rational
from crankstar.derive.algebra.enclosure import Amount, Ball
from crankstar.derive.algebra.formula import Symbol
from crankstar.derive.algebra.wave import Form, Key, Wave, joined, multiplied, scaled
from crankstar.derive.records import DerivationError
from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder, Shaft
from crankstar.language.messages import _
from crankstar.mechanics.balance import parts, unit_unbalance

GREATEST_FIELD = 36_000
"""Order N of the field Q(zeta_N) beyond which an engine's angles are taken as decimals.

A hundredth of a degree needs this.
"""
GREATEST_WORK = 3_000_000
"""Order of the field times cylinders beyond which exact sums would take minutes."""

Kind = Literal["piston", "throw", "weight", "big end"]
Harmonics = dict[Symbol, tuple[int, Fraction]]
"""The number j and the rod ratio of each harmonic that stays a symbol."""
Rows = dict[tuple[str, object], tuple[int, ...]]
"""The rows of a Balance of a cylinder, a throw or a weight."""


class Push(NamedTuple):
    """Signals upwards and to the right."""

    up: Wave
    right: Wave


@dataclass(frozen=True)
class Body:
    """One moving part, with its push on the block upwards and to the right.

    `along` is the push of a piston along its cylinder; None for what turns. `lag` is delta in
    turns, None where it is not a rational part of one; `dead_centre` is where the piston is
    farthest out, in turns of the reference crankshaft. `cylinder` is None for throws and weights;
    `place` counts the throws, or the weights, of a shaft. `sharing` is how many bodies the rows
    stand for together: a rod's crank end, the big end, is a body of its own.
    """

    kind: Kind
    shaft: str
    place: int
    push: Push
    rows: tuple[int, ...]
    cylinder: int | None = None
    bank: str = ""
    along: Wave | None = None
    bearing: Fraction | None = None
    bearing_deg: float = 0.0
    lag: Fraction | None = None
    dead_centre: Fraction | None = None
    sharing: int = 1

    @property
    def turning(self) -> bool:
        """Whether the part turns with its shaft."""
        return self.kind != "piston"


def pushed(moving: Iterable[Body]) -> Push:
    """The sum of the pushes of parts."""
    pushes = [body.push for body in moving]
    return Push(joined(push.up for push in pushes), joined(push.right for push in pushes))


def armed(body: Body, arm: Form) -> Body:
    """What a part does to the couple: its push times its arm."""
    along = None if body.along is None else scaled(body.along, arm)
    return replace(body, push=Push(*(scaled(side, arm) for side in body.push)), along=along)


@dataclass(frozen=True)
class Bodies:
    """The parts of an engine that push in one order, and the harmonic they have in common.

    `harmonic` is the number j of the A_j that all pushes are counted in, None where they are not
    counted in one. `values` has the harmonics that stay symbols. `why` says why the pushes are
    decimals, empty where they are exact.
    """

    moving: tuple[Body, ...]
    harmonic: int | None
    rod_ratio: Fraction | None
    values: Harmonics
    why: str


def inexact(engine: Engine) -> str:
    """Why an engine's derivation is in decimals: empty where it is exact."""
    if any(c.articulated for c in engine.cylinders):
        return _("The motion of articulated rods is no finite series of cosines.")
    if any(c.offset for c in engine.cylinders):
        return _(
            "A cylinder whose axis misses the crankshaft has harmonics with phases of their own."
        )
    angles = [t.angle for s in engine.shafts for t in (*s.throws, *s.weights)]
    turns = [rational.turn(angle) for angle in (*angles, *(c.bearing for c in engine.cylinders))]
    if None in turns:
        return _("The angles of the engine are not rational parts of a turn.")
    field = 4
    for turn in turns:
        field = lcm(field, turn.denominator if turn else 1)
        if field > GREATEST_FIELD or field * len(engine.cylinders) > GREATEST_WORK:
            return _("The common divisor of all angles is too small for exact sums.")
    return ""


def alike(engine: Engine) -> None:
    """Raise DerivationError for an engine without one crankshaft, equal cylinders, exact angles."""
    if inexact(engine):
        raise DerivationError(_("There is no exact closed form. {reason}", reason=inexact(engine)))
    if len({cylinder.shaft for cylinder in engine.cylinders}) > 1:
        raise DerivationError(
            _("This closed form needs an engine with one crankshaft; this one has several.")
        )
    if any(cylinder.rod for cylinder in engine.cylinders):
        raise DerivationError(
            _(
                "This closed form needs rods as two masses; here a rod is a rigid body "
                "(cylinder.rod), as in estimated engines."
            )
        )
    sizes = {(c.reciprocating_mass, c.rod_length, engine.throw(c).radius) for c in engine.cylinders}
    if len(sizes) > 1:
        raise DerivationError(
            _("This closed form needs cylinders that are all alike in mass, rod and stroke.")
        )
    if engine.shaft(engine.first.shaft).speed_ratio != 1:
        raise DerivationError(
            _("This closed form needs the cylinders on the reference crankshaft.")
        )


def bodies(engine: Engine, order: Fraction) -> Bodies:
    """The parts that push in this order of the reference crankshaft."""
    why, unit, rows = inexact(engine), unit_unbalance(engine), _rows(engine)
    symbols: dict[tuple[int, Fraction], Symbol] = {}
    pistons: list[Body] = []
    for cylinder in engine.cylinders:
        j = order / abs(engine.shaft(cylinder.shaft).speed_ratio)
        if j.denominator > 1 or (not why and j > 1 and j % 2):
            continue
        own = rows["cylinder", cylinder.number]
        if why:
            pistons.append(_enclosed(engine, cylinder, int(j), unit, own))
        else:
            pistons.append(_exact(engine, cylinder, int(j), unit, own, symbols))
    rotors = [
        body
        for shaft in engine.shafts
        if abs(shaft.speed_ratio) == order
        for body in _rotors(engine, shaft, unit, rows, exact=not why)
    ]
    harmonics = {symbol: key for key, symbol in symbols.items()}
    keys = {key for body in pistons for key in (body.along or {})}
    if not why and len(keys) == 1 and (not rotors or keys == {()}):
        key = keys.pop()
        number, ratio = harmonics[key[0]] if key else (1, None)
        return Bodies((*map(_counted, pistons), *rotors), number, ratio, {}, why)
    return Bodies((*pistons, *rotors), None, None, {} if why else harmonics, why)


def _counted(body: Body) -> Body:
    """A piston's push counted in its harmonic."""
    up, right, along = (
        dict.fromkeys([()], next(iter(wave.values()))) if wave else {}
        for wave in (*body.push, body.along)
    )
    return replace(body, push=Push(up, right), along=along)


def _rows(engine: Engine) -> Rows:
    """The rows of a Balance that belong to a cylinder, a throw or a weight."""
    out: Rows = {}
    throws = [("throw", (s.name, i)) for s in engine.shafts for i in range(1, len(s.throws) + 1)]
    weights = [("weight", (s.name, i)) for s in engine.shafts for i in range(1, len(s.weights) + 1)]
    turning = iter(throws + weights)
    for row, part in enumerate(parts(engine)):
        key = ("cylinder", part.cylinder) if part.cylinder is not None else next(turning)
        out[key] = (*out.get(key, ()), row)
    return out


def _sense(engine: Engine, shaft: str) -> int:
    """The sense in which a shaft turns, 1 for clockwise."""
    return engine.sense if engine.shaft(shaft).speed_ratio > 0 else -engine.sense


def _angle(engine: Engine, radians: float) -> Amount:
    """A unit vector in balls.

    Angles are often rational parts of a turn from the first throw even where it is not one itself.
    """
    with cyclotomic.precision(cyclotomic.DIGITS):
        return Ball(enclosure.angle_of(radians, base=engine.throw(engine.first).angle))


def _turning(
    engine: Engine, shaft: Shaft, *, exact: bool
) -> Iterator[tuple[Kind, int, float, float, int | None]]:
    """Kind, place, angle, mass moment and cylinder of what turns with a shaft."""
    for number, throw in enumerate(shaft.throws, 1):
        yield "throw", number, throw.angle, throw.turning_mass * throw.radius, None
    for number, weight in enumerate(shaft.weights, 1):
        yield "weight", number, weight.angle, weight.unbalance, None
    for cylinder in engine.cylinders if exact else ():
        if cylinder.shaft == shaft.name:
            throw, mass = engine.throw(cylinder), cylinder.rotating
            yield "big end", cylinder.throw, throw.angle, mass * throw.radius, cylinder.number


def _rotors(
    engine: Engine, shaft: Shaft, unit: float, rows: Rows, *, exact: bool
) -> Iterator[Body]:
    """Throws, weights and big ends on a shaft, counted in `unit`."""
    sign = _sense(engine, shaft.name)
    for kind, place, angle, amount, number in _turning(engine, shaft, exact=exact):
        if not amount:
            continue
        turn = rational.turn(angle)
        if exact and turn is not None:
            where: Amount = cyclotomic.root(sign * turn)
        else:
            where = _angle(engine, angle)
            where = where if sign > 0 else where.conjugate
        up: Wave = {(): where.times(rational.ratio(amount / unit) * shaft.speed_ratio**2)}
        # right = s sin(k theta + s alpha): a quarter of a turn behind, or before where it turns
        # the other way
        push = Push(up, multiplied(up, cyclotomic.root(Fraction(-sign, 4))))
        own = rows["cylinder", number] if number else rows[kind, (shaft.name, place)]
        lag, sharing = None if turn is None else sign * turn, 2 if number else 1
        yield Body(kind, shaft.name, place, push, own, number, lag=lag, sharing=sharing)


def _piston(
    engine: Engine, cylinder: Cylinder, push: Push, rows: tuple[int, ...], along: Wave | None
) -> Body:
    """A piston with its bank and its bearing."""
    number, bearing = cylinder.number, rational.turn(cylinder.bearing)
    degrees = float(360 * bearing) if bearing is not None else cylinder.bearing * 180 / pi
    bank = next(name for name, numbers in engine.banks.items() if number in numbers)
    seat = cylinder.shaft, cylinder.throw
    return Body("piston", *seat, push, rows, number, bank, along, bearing, degrees)


def _exact(
    engine: Engine,
    cylinder: Cylinder,
    j: int,
    unit: float,
    rows: tuple[int, ...],
    symbols: dict[tuple[int, Fraction], Symbol],
) -> Body:
    """A piston on a centred crank."""
    throw, speed = engine.throw(cylinder), engine.shaft(cylinder.shaft).speed_ratio
    amount = rational.ratio(cylinder.reciprocating * throw.radius / unit) * speed**2
    alpha, beta = rational.turn(throw.angle), rational.turn(cylinder.bearing)
    if alpha is None or beta is None:
        raise ValueError("an exact derivation needs angles that are rational parts of a turn")
    lead = _sense(engine, cylinder.shaft) * (alpha - beta)
    key: Key = ()
    if j > 1:
        own = (j, rational.ratio(cylinder.rod_length / throw.radius))
        primes = "′" * sum(1 for other in symbols if other[0] == j and other != own)
        key = (symbols.setdefault(own, Symbol("A" + primes, str(j))),)
    along: Wave = {key: cyclotomic.root(j * lead).times(amount)}
    resolved = (multiplied(along, share(beta)) for share in (cyclotomic.cosine, cyclotomic.sine))
    return replace(
        _piston(engine, cylinder, Push(*resolved), rows, along),
        lag=j * lead,
        dead_centre=-lead % 1 / abs(speed),
        sharing=2 if j == 1 and cylinder.rotating else 1,
    )


def _enclosed(
    engine: Engine, cylinder: Cylinder, j: int, unit: float, rows: tuple[int, ...]
) -> Body:
    """Any piston with its rod, in balls."""
    throw, root, rod = engine.throw(cylinder), cylinder, cylinder.rod
    while root.articulated is not None:
        master = root.articulated.master
        root = next(other for other in engine.cylinders if other.number == master)
    harmonic = enclosure.harmonic(enclosure.chain(engine, cylinder), j)
    reciprocating, carried, big_end = (
        rational.ratio(mass * throw.radius / unit) * engine.shaft(cylinder.shaft).speed_ratio ** 2
        for mass in (cylinder.reciprocating_mass, rod.mass if rod else 0.0, cylinder.big_end_mass)
    )
    share = rational.ratio(rod.centre / cylinder.rod_length) if rod else Fraction(0)
    with cyclotomic.precision(cyclotomic.DIGITS):
        axis, frame = enclosure.angle_of(cylinder.bearing), enclosure.angle_of(root.bearing)
        turn = (_angle(engine, throw.angle).enclosed() / frame) ** j

        def push(value: acb, amount: Fraction) -> Wave:
            ball = Ball(turn * value).times(amount)
            forward = _sense(engine, cylinder.shaft) > 0
            return {} if amount == 0 else {(): ball if forward else ball.conjugate}

        along = push(harmonic.piston, reciprocating + carried * share)
        at_pin = carried * (1 - share) + big_end
        joint = harmonic.up, harmonic.right
        up = frame.real * joint[0] - frame.imag * joint[1]
        right = frame.imag * joint[0] + frame.real * joint[1]
        resolved = (
            joined([multiplied(along, Ball(acb(side))), push(pin, at_pin)])
            for side, pin in ((axis.real, up), (axis.imag, right))
        )
        return _piston(engine, cylinder, Push(*resolved), rows, None if at_pin else along)
