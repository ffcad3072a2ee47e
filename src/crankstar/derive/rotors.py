"""What turns with the shafts: throws and weights that have mass, the crank ends of rigid rods."""

from __future__ import annotations

from fractions import Fraction

from crankstar.derive.algebra import cyclotomic, enclosure, rational
from crankstar.derive.algebra.cyclotomic import DIGITS
from crankstar.derive.algebra.enclosure import Ball
from crankstar.derive.algebra.wave import Amount, Wave, multiplied
from crankstar.derive.body import Body, base_angle, on_pin, speed_ratio
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft

Rows = dict[tuple[str, object], tuple[int, ...]]
"""The rows of a Balance of a cylinder, a throw or a weight."""


def rotors(engine: Engine, order: Fraction, unit: float, rows: Rows, *, exact: bool) -> list[Body]:
    """Throws, weights and big ends on the shafts whose speed is this order, counted in `unit`."""
    shafts = [s for s in engine.shafts if abs(speed_ratio(engine, s.name)) == order]
    return [
        body
        for shaft in shafts
        for body in (
            *_throws(engine, shaft, unit, rows, exact=exact),
            *_weights(engine, shaft, unit, rows, exact=exact),
            *(_big_ends(engine, shaft, unit, rows) if exact else ()),
        )
    ]


def _throws(engine: Engine, shaft: Shaft, unit: float, rows: Rows, *, exact: bool) -> list[Body]:
    out: list[Body] = []
    for place, throw in enumerate(shaft.throws, 1):
        if amount := throw.rotating_mass * throw.radius:
            up, right, lag = _push(engine, shaft, throw.angle, amount / unit, exact=exact)
            own = rows["throw", (shaft.name, place)]
            out.append(Body("throw", shaft.name, place, up, right, own, lag=lag))
    return out


def _weights(engine: Engine, shaft: Shaft, unit: float, rows: Rows, *, exact: bool) -> list[Body]:
    out: list[Body] = []
    for place, weight in enumerate(shaft.weights, 1):
        if weight.unbalance:
            up, right, lag = _push(
                engine, shaft, weight.angle, weight.unbalance / unit, exact=exact
            )
            own = rows["weight", (shaft.name, place)]
            out.append(Body("weight", shaft.name, place, up, right, own, lag=lag))
    return out


def _big_ends(engine: Engine, shaft: Shaft, unit: float, rows: Rows) -> list[Body]:
    out: list[Body] = []
    for cylinder in engine.cylinders:
        amount = on_pin(engine, cylinder)
        if cylinder.shaft == shaft.name and amount:
            angle = engine.throw(cylinder).angle
            up, right, lag = _push(engine, shaft, angle, amount / unit, exact=True)
            own, number = rows["cylinder", cylinder.number], cylinder.number
            out.append(
                Body(
                    "big end",
                    shaft.name,
                    cylinder.throw,
                    up,
                    right,
                    own,
                    number,
                    lag=lag,
                    sharing=2,
                )
            )
    return out


def _push(
    engine: Engine, shaft: Shaft, angle: float, amount: float, *, exact: bool
) -> tuple[Wave, Wave, Fraction | None]:
    """The push up and to the right, and its lag in turns."""
    speed = speed_ratio(engine, shaft.name)
    sign = engine.sense * (1 if speed > 0 else -1)
    turn = rational.turn(angle)
    if exact and turn is not None:
        where: Amount = cyclotomic.root(sign * turn)
    else:
        with cyclotomic.precision(DIGITS):
            ball = enclosure.angle_of(angle, base=base_angle(engine))
            where = Ball(ball if sign > 0 else ball.conjugate())
    up: Wave = {(): where.times(rational.ratio(amount) * speed**2)}
    # right = s sin(k theta + s alpha): a quarter of a turn behind, or before where it turns the
    # other way
    right = multiplied(up, cyclotomic.root(Fraction(-sign, 4)))
    return up, right, None if turn is None else sign * turn
