"""The parts of an engine that push in one order, exactly where that can be, else in balls.

What turns with a shaft pushes, once a turn of it, towards where it is; a piston pushes along its
cylinder (`pistons`). With angles that are rational parts of a turn all pushes are sums of roots of
unity times rational numbers; A_j stays a symbol where cylinders differ in it.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from math import lcm

from crankstar.derive.algebra import rational
from crankstar.derive.algebra.wave import Key, Wave
from crankstar.derive.body import Body
from crankstar.derive.pistons import Harmonics, pistons
from crankstar.derive.rotors import Rows, rotors
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.mechanics.balance import parts

GREATEST_FIELD = 36_000
"""Order N of the field Q(zeta_N) beyond which an engine's angles are taken as decimals.

A hundredth of a degree needs this.
"""
GREATEST_WORK = 3_000_000
"""Order of the field times cylinders beyond which exact sums would take minutes."""


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
            return _("The common part of a turn of all angles is too small for exact sums.")
    return ""


def bodies(engine: Engine, order: Fraction) -> Bodies:
    """The parts that push in this order of the reference crankshaft."""
    why = inexact(engine)
    first = engine.first
    mass = first.reciprocating_mass or (first.rod.mass if first.rod else 1.0)
    unit = mass * engine.throw(first).radius
    rows = _rows(engine)
    pushing, harmonics = pistons(engine, order, unit, rows, exact=not why)
    turning = rotors(engine, order, unit, rows, exact=not why)
    keys = {key for body in pushing for key in (body.along or {})}
    if not why and len(keys) == 1 and (not turning or keys == {()}):
        key = keys.pop()
        number, ratio = harmonics[key[0]] if key else (1, None)
        return Bodies((*(_counted(b, key) for b in pushing), *turning), number, ratio, {}, why)
    return Bodies((*pushing, *turning), None, None, {} if why else harmonics, why)


def _counted(body: Body, key: Key) -> Body:
    """A piston's push counted in its harmonic."""

    def plain(wave: Wave) -> Wave:
        return dict.fromkeys([()], next(iter(wave.values()))) if wave else {}

    if not key:
        return body
    return replace(body, up=plain(body.up), right=plain(body.right), along=plain(body.along or {}))


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
