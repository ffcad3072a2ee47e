"""What pistons push with, exactly or in balls.

A piston on a centred crank pushes along its cylinder (bearing beta) with

    m r n^2 w^2 A_j cos(j psi),     psi = alpha - beta + s n theta,     k = j |n|,

alpha the bearing of its throw at theta = 0, n the signed speed ratio of its shaft, s the sense of
rotation, A_j its j-th harmonic: so with `cos(k theta + delta)`, delta = s sgn(n) j (alpha - beta).
A rod given as a rigid body acts as two point masses in force and couple: its share centre/length at
the piston pin, the rest at the crank pin.
"""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import pi

from flint import acb

from crankstar.derive.algebra import cyclotomic, enclosure, rational
from crankstar.derive.algebra.cyclotomic import DIGITS
from crankstar.derive.algebra.enclosure import Ball
from crankstar.derive.algebra.formula import Symbol
from crankstar.derive.algebra.wave import Key, Wave, joined, multiplied
from crankstar.derive.body import Body, base_angle, on_pin, speed_ratio
from crankstar.derive.rotors import Rows
from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder

Harmonics = dict[Symbol, tuple[int, Fraction]]
"""The number j and the rod ratio of each harmonic that stays a symbol."""


def pistons(
    engine: Engine, order: Fraction, unit: float, rows: Rows, *, exact: bool
) -> tuple[list[Body], Harmonics]:
    """The pistons that push in this order, counted in `unit`, and their harmonics."""
    symbols: dict[tuple[int, Fraction], Symbol] = {}
    out: list[Body] = []
    for cylinder in engine.cylinders:
        j = order / abs(speed_ratio(engine, cylinder.shaft))
        if j.denominator != 1:
            continue
        body = (
            _exact(engine, cylinder, int(j), unit, symbols)
            if exact
            else _enclosed(engine, cylinder, int(j), unit)
        )
        if body is not None:
            sharing = 2 if exact and j == 1 and on_pin(engine, cylinder) else 1
            out.append(replace(_placed(body, engine, cylinder, rows), sharing=sharing))
    return out, {symbol: key for key, symbol in symbols.items()}


def _placed(body: Body, engine: Engine, cylinder: Cylinder, rows: Rows) -> Body:
    """A piston with its bank, its bearing and its rows."""
    bearing = rational.turn(cylinder.bearing)
    bank = next(name for name, numbers in engine.banks.items() if cylinder.number in numbers)
    return replace(
        body,
        bank=bank,
        rows=rows["cylinder", cylinder.number],
        bearing=bearing,
        bearing_deg=float(360 * bearing) if bearing is not None else cylinder.bearing * 180 / pi,
    )


def _exact(
    engine: Engine,
    cylinder: Cylinder,
    j: int,
    unit: float,
    symbols: dict[tuple[int, Fraction], Symbol],
) -> Body | None:
    """A piston on a centred crank."""
    throw, speed = engine.throw(cylinder), speed_ratio(engine, cylinder.shaft)
    if j > 1 and j % 2:
        return None
    mass = cylinder.reciprocating_mass
    if cylinder.rod is not None:
        mass += cylinder.rod.mass * cylinder.rod.centre / cylinder.rod_length
    amount = rational.ratio(mass * throw.radius / unit) * speed**2
    sign = engine.sense * (1 if speed > 0 else -1)
    alpha, beta = rational.turn(throw.angle), rational.turn(cylinder.bearing)
    if alpha is None or beta is None:
        raise ValueError("an exact derivation needs angles that are rational parts of a turn")
    delta = sign * j * (alpha - beta)
    key: Key = ()
    if j > 1:
        own = (j, rational.ratio(cylinder.rod_length / throw.radius))
        primes = "′" * sum(1 for other in symbols if other[0] == j and other != own)
        key = (symbols.setdefault(own, Symbol("A" + primes, str(j))),)
    along: Wave = {key: cyclotomic.root(delta).times(amount)}
    return Body(
        "piston",
        cylinder.shaft,
        cylinder.throw,
        multiplied(along, cyclotomic.cosine(beta)),
        multiplied(along, cyclotomic.sine(beta)),
        cylinder=cylinder.number,
        along=along,
        lag=delta,
        dead_centre=(-sign * (alpha - beta)) % 1 / abs(speed),
    )


def _enclosed(engine: Engine, cylinder: Cylinder, j: int, unit: float) -> Body | None:
    """Any piston with its rod, in balls."""
    throw, speed = engine.throw(cylinder), speed_ratio(engine, cylinder.shaft)
    root = cylinder
    while root.articulated is not None:
        master = root.articulated.master
        root = next(other for other in engine.cylinders if other.number == master)
    unit_push = enclosure.harmonic(enclosure.chain(engine, cylinder), j)
    with cyclotomic.precision(DIGITS):
        angle = enclosure.angle_of(throw.angle, base=base_angle(engine))
        turn = (angle / enclosure.angle_of(root.bearing)) ** j
        share, rod = Fraction(0), 0.0
        if cylinder.rod is not None:
            share, rod = (
                rational.ratio(cylinder.rod.centre / cylinder.rod_length),
                cylinder.rod.mass,
            )
        reciprocating, carried, big_end = (
            rational.ratio(mass * throw.radius / unit) * speed**2
            for mass in (cylinder.reciprocating_mass, rod, cylinder.big_end_mass)
        )

        def push(value: acb, amount: Fraction) -> Wave:
            ball = Ball(turn * value).times(amount)
            same = engine.sense * speed > 0
            return {} if amount == 0 else {(): ball if same else ball.conjugate}

        along = push(unit_push.piston, reciprocating + carried * share)
        axis, frame = enclosure.angle_of(cylinder.bearing), enclosure.angle_of(root.bearing)
        ups: list[Wave] = [multiplied(along, Ball(acb(axis.real)))]
        rights: list[Wave] = [multiplied(along, Ball(acb(axis.imag)))]
        at_pin = carried * (1 - share) + big_end
        if at_pin:
            joint = unit_push.up, unit_push.right
            ups.append(push(frame.real * joint[0] - frame.imag * joint[1], at_pin))
            rights.append(push(frame.imag * joint[0] + frame.real * joint[1], at_pin))
    return Body(
        "piston",
        cylinder.shaft,
        cylinder.throw,
        joined(ups),
        joined(rights),
        cylinder=cylinder.number,
        along=None if at_pin else along,
    )
