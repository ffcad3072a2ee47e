"""What each moving part of an engine does to the block in one order, exactly where that can be, else in enclosing balls.

A piston on a centred crank pushes along its cylinder (bearing beta) with

    m r n^2 w^2 A_j cos(j psi),     psi = alpha - beta + s n theta,     k = j |n|,

alpha the bearing of its throw at theta = 0, n the signed speed ratio of its shaft, s the sense of rotation, A_j its j-th
harmonic: so with `cos(k theta + delta)`, delta = s sgn(n) j (alpha - beta). What turns with a shaft pushes, once a turn of
it, towards where it is. With angles that are rational parts of a turn all these are sums of roots of unity times rational
numbers; A_j stays a symbol where cylinders differ in it. A rod given as a rigid body acts as two point masses in force and
couple: its share centre/length at the piston pin, the rest at the crank pin.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from math import lcm, pi

from flint import acb

from crankstar.balance import parts
from crankstar.derive import cyclotomic, enclosure, meant
from crankstar.derive.cyclotomic import DIGITS
from crankstar.derive.enclosure import Ball
from crankstar.derive.formula import Symbol
from crankstar.derive.wave import Amount, Form, Key, Wave, joined, multiplied, scaled
from crankstar.engine import Engine
from crankstar.records import Cylinder

GREATEST_FIELD = 36_000
"""Order N of the field Q(zeta_N) beyond which an engine's angles are taken as decimals; a hundredth of a degree needs this."""
GREATEST_WORK = 3_000_000
"""Order of the field times cylinders beyond which exact sums would take minutes, and are taken as decimals."""


@dataclass(frozen=True)
class Body:
    """One moving part: what it is, the rows of a Balance it accounts for, and its push as signals up and right.

    `along` is the push of a piston along its cylinder; None for what turns. `lag` is delta in turns, None where it is not
    a rational part of one; `dead_centre` is where the piston is farthest out, in turns of the reference crankshaft.
    `sharing` is how many bodies the rows stand for together: a rod's crank end, `crank_end_of` a cylinder, is a body of its own.
    """

    name: str
    rows: tuple[int, ...]
    cylinder: int | None
    shaft: str
    place: int
    up: Wave
    right: Wave
    along: Wave | None = None
    bearing: Fraction | None = None
    bearing_deg: float = 0.0
    lag: Fraction | None = None
    dead_centre: Fraction | None = None
    sharing: int = 1
    crank_end_of: int | None = None


@dataclass(frozen=True)
class Bodies:
    """The parts of an engine that push in one order, and the harmonic that all of them have in common.

    `harmonic` is the number j of the A_j that all pushes are counted in, None where they are not counted in one. `values`
    has the harmonics that stay symbols. `why` says why the pushes are decimals, empty where they are exact.
    """

    moving: tuple[Body, ...]
    harmonic: int | None
    rod_ratio: Fraction | None
    values: dict[Symbol, tuple[int, Fraction]]
    why: str


def inexact(engine: Engine) -> str:
    """Why an engine's derivation is in decimals: empty where it is exact."""
    offset = [c.number for c in engine.cylinders if c.offset]
    if any(c.articulated for c in engine.cylinders):
        return "articulated rods move by no finite series of cosines"
    if offset:
        return "a cylinder whose axis misses the crankshaft has harmonics with phases of their own"
    angles = [t.angle for s in engine.shafts for t in s.throws] + [w.angle for s in engine.shafts for w in s.weights]
    turns = [meant.turn(angle) for angle in (*angles, *(c.bearing for c in engine.cylinders))]
    if None in turns:
        return "its angles are not rational parts of a turn"
    field = 4
    for turn in turns:
        field = lcm(field, turn.denominator if turn else 1)
        if field > GREATEST_FIELD or field * len(engine.cylinders) > GREATEST_WORK:
            return "its angles are parts of a turn with no common part of use"
    return ""


def bodies(engine: Engine, order: Fraction) -> Bodies:
    """The parts that push in this order of the reference crankshaft."""
    why = inexact(engine)
    first = engine.first
    unit = (first.reciprocating_mass or (first.rod.mass if first.rod else 1.0)) * engine.throw(first).radius
    rows = _rows(engine)
    pistons, classes = _pistons(engine, order, unit, rows, exact=not why)
    turning = _rotors(engine, order, unit, rows, exact=not why)
    harmonics = {key for body in pistons for key in (body.along or {})}
    if not why and len(harmonics) == 1 and (not turning or harmonics == {()}):
        key = harmonics.pop()
        found = classes[key[0]] if key else (1, None)
        plain = tuple(_without(body, key) for body in pistons)
        return Bodies((*plain, *turning), found[0], found[1], {}, why)
    return Bodies((*pistons, *turning), None, None, {} if why else classes, why)


def _without(body: Body, key: Key) -> Body:
    """A piston's push counted in its harmonic."""

    def plain(wave: Wave) -> Wave:
        return dict.fromkeys([()], next(iter(wave.values()))) if wave else {}

    return replace(body, up=plain(body.up), right=plain(body.right), along=plain(body.along or {})) if key else body


def _rows(engine: Engine) -> dict[tuple[str, object], tuple[int, ...]]:
    """The rows of a Balance that belong to a cylinder, a throw or a weight."""
    out: dict[tuple[str, object], tuple[int, ...]] = {}
    throws = [("throw", (s.name, i)) for s in engine.shafts for i in range(1, len(s.throws) + 1)]
    weights = [("weight", (s.name, i)) for s in engine.shafts for i in range(1, len(s.weights) + 1)]
    turning = iter(throws + weights)
    for row, part in enumerate(parts(engine)):
        key = ("cylinder", part.cylinder) if part.cylinder is not None else next(turning)
        out[key] = (*out.get(key, ()), row)
    return out


def _ratio_of(engine: Engine, shaft: str) -> Fraction:
    return Fraction(engine.shaft(shaft).speed_ratio)


def _pistons(
    engine: Engine, order: Fraction, unit: float, rows: dict[tuple[str, object], tuple[int, ...]], *, exact: bool
) -> tuple[list[Body], dict[Symbol, tuple[int, Fraction]]]:
    classes: dict[tuple[int, Fraction], Symbol] = {}
    out: list[Body] = []
    for cylinder in engine.cylinders:
        speed = _ratio_of(engine, cylinder.shaft)
        j = order / abs(speed)
        if j.denominator != 1:
            continue
        body = _exact(engine, cylinder, int(j), unit, classes) if exact else _enclosed(engine, cylinder, int(j), unit)
        if body is not None:
            sharing = 2 if exact and j == 1 and on_pin(engine, cylinder) else 1
            out.append(replace(_labelled(body, engine, cylinder, rows), sharing=sharing))
    return out, {symbol: key for key, symbol in classes.items()}


def _labelled(body: Body, engine: Engine, cylinder: Cylinder, rows: dict[tuple[str, object], tuple[int, ...]]) -> Body:
    bearing = meant.turn(cylinder.bearing)
    bank = next(name for name, numbers in engine.banks.items() if cylinder.number in numbers)
    return replace(
        body,
        name=bank,
        rows=rows["cylinder", cylinder.number],
        bearing=bearing,
        bearing_deg=float(360 * bearing) if bearing is not None else cylinder.bearing * 180 / pi,
    )


def _exact(engine: Engine, cylinder: Cylinder, j: int, unit: float, classes: dict[tuple[int, Fraction], Symbol]) -> Body | None:
    """A piston on a centred crank."""
    throw = engine.throw(cylinder)
    speed = _ratio_of(engine, cylinder.shaft)
    if j > 1 and j % 2:
        return None
    mass = cylinder.reciprocating_mass
    if cylinder.rod is not None:
        mass += cylinder.rod.mass * cylinder.rod.centre / cylinder.rod_length
    amount = meant.ratio(mass * throw.radius / unit) * speed**2
    sign = engine.sense * (1 if speed > 0 else -1)
    alpha, beta = meant.turn(throw.angle), meant.turn(cylinder.bearing)
    if alpha is None or beta is None:
        raise ValueError("an exact derivation needs angles that are rational parts of a turn")
    delta = sign * j * (alpha - beta)
    key: Key = ()
    if j > 1:
        own = (j, meant.ratio(cylinder.rod_length / throw.radius))
        primes = "′" * sum(1 for other in classes if other[0] == j and other != own)
        key = (classes.setdefault(own, Symbol("A" + primes, str(j))),)
    along: dict[Key, Amount] = {key: cyclotomic.root(delta).times(amount)}
    up, right = multiplied(along, cyclotomic.cosine(beta)), multiplied(along, cyclotomic.sine(beta))
    centre = (-sign * (alpha - beta)) % 1 / abs(speed)
    return Body("", (), cylinder.number, cylinder.shaft, cylinder.throw, up, right, along, lag=delta, dead_centre=centre)


def _enclosed(engine: Engine, cylinder: Cylinder, j: int, unit: float) -> Body | None:
    """Any piston with its rod, in balls."""
    throw = engine.throw(cylinder)
    speed = _ratio_of(engine, cylinder.shaft)
    root = cylinder
    while root.articulated is not None:
        master = root.articulated.master
        root = next(other for other in engine.cylinders if other.number == master)
    found = enclosure.harmonic(enclosure.chain(engine, cylinder), j)
    with cyclotomic.precision(DIGITS):
        turn = (enclosure.angle_of(throw.angle, base=_base(engine)) / enclosure.angle_of(root.bearing)) ** j
        share = meant.ratio(cylinder.rod.centre / cylinder.rod_length) if cylinder.rod is not None else Fraction(0)
        rod = cylinder.rod.mass if cylinder.rod is not None else 0.0
        moving, carried = (meant.ratio(mass * throw.radius / unit) * speed**2 for mass in (cylinder.reciprocating_mass, rod))
        held = meant.ratio(cylinder.big_end_mass * throw.radius / unit) * speed**2

        def wave(value: acb, amount: Fraction) -> Wave:
            ball = Ball(turn * value).times(amount)
            same = engine.sense * speed > 0
            return {} if amount == 0 else {(): ball if same else ball.conjugate}

        along = wave(found.piston, moving + carried * share)
        axis, frame = enclosure.angle_of(cylinder.bearing), enclosure.angle_of(root.bearing)
        pushes_up, pushes_right = [multiplied(along, Ball(acb(axis.real)))], [multiplied(along, Ball(acb(axis.imag)))]
        on_pin = carried * (1 - share) + held
        if on_pin:
            joint_up = frame.real * found.up - frame.imag * found.right
            joint_right = frame.imag * found.up + frame.real * found.right
            pushes_up.append(wave(joint_up, on_pin))
            pushes_right.append(wave(joint_right, on_pin))
    body = Body("", (), cylinder.number, cylinder.shaft, cylinder.throw, joined(pushes_up), joined(pushes_right))
    return replace(body, along=along) if not on_pin else body


def _base(engine: Engine) -> float:
    """The angle of a throw, from which the others are rational parts of a turn even where it is not one."""
    return engine.throw(engine.first).angle


def _rotors(
    engine: Engine, order: Fraction, unit: float, rows: dict[tuple[str, object], tuple[int, ...]], *, exact: bool
) -> list[Body]:
    """Throws and weights that have mass, on the shafts whose speed is this order, and the crank ends of rigid rods."""
    out: list[Body] = []
    for shaft in engine.shafts:
        speed = Fraction(shaft.speed_ratio)
        if abs(speed) != order:
            continue
        things = [("throw", i, t.angle, t.rotating_mass * t.radius) for i, t in enumerate(shaft.throws, 1)]
        things += [("weight", i, w.angle, w.unbalance) for i, w in enumerate(shaft.weights, 1)]
        for kind, place, angle, unbalance in things:
            if unbalance == 0:
                continue
            own = rows[kind, (shaft.name, place)]
            out.append(_turning(engine, shaft.name, f"{kind} {place}", place, angle, unbalance / unit, own, exact=exact))
        if exact:
            for c in engine.cylinders:
                amount = on_pin(engine, c)
                if c.shaft == shaft.name and amount:
                    name, angle, own = f"big end {c.number}", engine.throw(c).angle, rows["cylinder", c.number]
                    body = _turning(engine, shaft.name, name, c.throw, angle, amount / unit, own, exact=True)
                    out.append(replace(body, sharing=2, crank_end_of=c.number))
    return out


def on_pin(engine: Engine, cylinder: Cylinder) -> float:
    """The mass moment of a plain rod's crank end, given apart from the throw."""
    mass = cylinder.big_end_mass
    if cylinder.rod is not None:
        mass += cylinder.rod.mass * (1 - cylinder.rod.centre / cylinder.rod_length)
    return mass * engine.throw(cylinder).radius


def _turning(
    engine: Engine, shaft: str, name: str, place: int, angle: float, amount: float, rows: tuple[int, ...], *, exact: bool
) -> Body:
    speed = _ratio_of(engine, shaft)
    sign = engine.sense * (1 if speed > 0 else -1)
    weight = meant.ratio(amount) * speed**2
    turn = meant.turn(angle)
    if exact and turn is not None:
        where: Amount = cyclotomic.root(sign * turn)
    else:
        with cyclotomic.precision(DIGITS):
            ball = enclosure.angle_of(angle, base=_base(engine))
            where = Ball(ball if sign > 0 else ball.conjugate())
    up: Wave = {(): where.times(weight)}
    # right = s sin(k theta + s alpha): a quarter of a turn behind, or before where it turns the other way
    quarter = cyclotomic.root(Fraction(-sign, 4))
    return Body(name, rows, None, shaft, place, up, multiplied(up, quarter), lag=sign * turn if turn is not None else None)


def armed(body: Body, arm: Form) -> Body:
    """What a part does to the couple: its push times its arm."""
    along = None if body.along is None else scaled(body.along, arm)
    return replace(body, up=scaled(body.up, arm), right=scaled(body.right, arm), along=along)
