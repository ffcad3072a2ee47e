"""The vectors of one order of every cylinder, throw and weight, turning with or against the crank.

The forces of a row of cylinders on one crankshaft act along one axis. Textbooks then draw one star
of vectors `C_k exp(i k alpha)`, whose component along the cylinder axis is the force; such a vector
is twice the one that turns with the crank. Other engines have two stars: the vectors that turn with
the crank and those that turn against it.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.charts.canvas import speed_of
from crankstar.charts.comparison import same_unit
from crankstar.charts.drawing import BLUE, GREY, VERMILION, checked_order
from crankstar.charts.estimates import ends_of
from crankstar.charts.sums import Quantity, checked_quantity, unit_of
from crankstar.engine import motion
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number, unit_text
from crankstar.language.shown_units import shown
from crankstar.mechanics.balance import Balance, balance, total
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.remains import NEGLIGIBLE
from crankstar.spectra import Spectrum

COLOURS = {"cylinder": BLUE, "throw": VERMILION, "weight": GREY}
NAMES = {"throw": N_("throw"), "weight": N_("weight")}
WITH, AGAINST = N_("with the crank"), N_("against the crank")


class Vector(NamedTuple):
    """The vector of one cylinder, throw or weight at theta = 0 (up + i*right); `name` labels it."""

    name: str
    kind: str
    value: complex


class Star(NamedTuple):
    """Vectors that turn by `rate` turns clockwise per turn of the crank, and their resultant.

    `ends` are resultants in the middle and at the corners of the ranges of an estimated engine.
    """

    vectors: tuple[Vector, ...]
    resultant: complex
    rate: float
    title: str
    ends: tuple[complex, ...] = ()


class Stars(NamedTuple):
    """All vectors of one order: one star along the `axis` of the cylinders, else two stars.

    The unit is written as in a Balance until `in_one_unit` writes it as readers see it.
    """

    quantity: Quantity
    order: float
    unit: str
    stars: tuple[Star, ...]
    axis: float | None
    sense: int
    from_crank: bool


def stars(
    engine: Engine,
    *,
    order: float = 1.0,
    quantity: Quantity = "force",
    reference: Reference | None = None,
    speed: float | None = None,
    divided: bool = True,
) -> Stars:
    """The vectors of an order in N, N m at `speed` (rad/s), else in m r w^2 |A_k|.

    A_k is that of the first cylinder's piston; not `divided` by it, they are in m r w^2.
    """
    order = checked_order(order)
    checked_quantity(quantity)
    speed = speed_of(engine, speed)
    result = balance(engine, speed=speed, reference=reference)
    unit, factor = unit_of(result, quantity), 1.0
    if result.speed is None and divided:
        factor, subscript = harmonic(engine, order)
        unit = unit.replace("m*r*w^2", f"m*r*w^2*{subscript}") if subscript else unit
    shares = spectra.scaled(spectra.selected(getattr(result, quantity), order), 1 / factor)
    whole = spectra.scaled(spectra.selected(getattr(total(result), quantity), order), 1 / factor)
    others = [
        spectra.scaled(spectra.selected(getattr(total(end), quantity), order), 1 / size)
        for end, size in _ends(engine, order, factor, speed=speed, reference=reference)
    ]
    names, axis = _names(engine, result), _axis(engine, shares)
    out = []
    for turning, sense, title in (("forward", 1, WITH), ("backward", -1, AGAINST)):
        # cylinders along one axis: one star, twice as long
        times = 1 if axis is None else 2
        values = times * getattr(shares, turning)[:, 0]
        vectors = [
            Vector(name, kind, complex(values[rows].sum())) for (name, kind), rows in names.items()
        ]
        greatest = max((abs(vector.value) for vector in vectors), default=0.0)
        seen = (one for one in vectors if abs(one.value) > NEGLIGIBLE * greatest)
        resultant = complex(getattr(whole, turning)[0])
        rate = sense * engine.sense * order
        words = "" if axis is not None else _(title)
        ends = tuple(times * complex(getattr(end, turning)[0]) for end in others)
        out.append(Star(tuple(seen), times * resultant, rate, words, ends))
    first = engine.throw(engine.first)
    from_crank = axis is not None and abs(np.exp(1j * (first.angle - axis)) - 1) < 1e-9
    drawn = tuple(out if axis is None else out[:1])
    return Stars(quantity, order, unit, drawn, axis, engine.sense, from_crank)


def _ends(
    engine: Engine, order: float, factor: float, *, speed: float | None, reference: Reference | None
) -> list[tuple[Balance, float]]:
    """The Balances in the middle and at the corners of an engine's ranges, each with its |A_k|.

    The latter is 1 where `factor`, that of the engine itself, is.
    """
    return [
        (
            balance(each, speed=speed, reference=reference),
            1.0 if factor == 1.0 else harmonic(each, order)[0],
        )
        for each in ends_of(engine)
    ]


def in_one_unit(systems: Sequence[Stars]) -> list[Stars]:
    """The stars of several engines, in the one unit that the longest vector of all is shown in.

    Raises ChartError where the engines are not counted in the same unit.
    """
    values = [star.resultant for each in systems for star in each.stars]
    values += [v.value for each in systems for star in each.stars for v in star.vectors]
    said = shown(same_unit(each.unit for each in systems), max(map(abs, values), default=0.0))
    return [
        each._replace(
            unit=unit_text(said.unit), stars=tuple(_times(star, said.factor) for star in each.stars)
        )
        for each in systems
    ]


def _times(star: Star, factor: float) -> Star:
    vectors = tuple(vector._replace(value=factor * vector.value) for vector in star.vectors)
    ends = tuple(factor * end for end in star.ends)
    return star._replace(vectors=vectors, resultant=factor * star.resultant, ends=ends)


def harmonic(engine: Engine, order: float) -> tuple[float, str]:
    """The |A_k| of the first cylinder's piston and its symbol; 1 and empty if it is the unit."""
    size = motion.first_harmonic(engine, order)
    if not size or abs(size - 1) < NEGLIGIBLE:
        return 1.0, ""
    letter = f"A{int(order)}"  # no lowered figure: few fonts of those that make pictures have one
    plain = size.real > 0 and abs(size.imag) < NEGLIGIBLE * abs(size)
    return abs(size), letter if plain else f"|{letter}|"


def _names(engine: Engine, result: Balance) -> dict[tuple[str, str], list[int]]:
    """The rows of a Balance of each cylinder, throw and weight, by label and kind."""
    alike: dict[tuple[int | None, str, str], list[int]] = {}
    for row, part in enumerate(result.parts):
        kind = "cylinder" if part.cylinder is not None else part.kind
        alike.setdefault((part.cylinder, kind, part.shaft), []).append(row)
    several = sum(1 for shaft in engine.shafts if shaft.throws) > 1
    out: dict[tuple[str, str], list[int]] = {}
    for (cylinder, kind, shaft), rows in alike.items():
        if cylinder is not None:
            out[str(cylinder), kind] = rows
            continue
        own = f"{shaft} " if several or not engine.shaft(shaft).throws else ""
        for index, row in enumerate(rows, 1):
            counted = "" if len(rows) == 1 else f" {index}"
            out[f"{own}{_(NAMES[kind])}{counted}", kind] = [row]
    return out


def _axis(engine: Engine, shares: Spectrum) -> float | None:
    """The bearing along which all forces act, for a row of cylinders on the first crankshaft."""
    first = engine.first
    if any(
        c.shaft != engine.shafts[0].name or abs(c.bearing - first.bearing) > 1e-9
        for c in engine.cylinders
    ):
        return None
    forward, backward = shares.forward[:, 0], shares.backward[:, 0]
    mirrored = np.exp(2j * first.bearing) * np.conj(forward)
    greatest = float(np.abs(forward).max(initial=0.0) + np.abs(backward).max(initial=0.0))
    lines = bool(np.all(np.abs(mirrored - backward) <= NEGLIGIBLE * greatest))
    return first.bearing if lines else None


def angle_text(shown: Stars, value: complex) -> str:
    """The plane of a resultant at theta = 0: its angle from the cylinder axis, or its bearing.

    The angle counts in the direction of rotation.
    """
    if shown.axis is None:
        return _("at {angle}°", angle=_degrees(float(np.angle(value))))
    angle = _degrees(float(np.angle(value * np.exp(-1j * shown.axis))) * shown.sense)
    if shown.from_crank:
        return _("{angle}° from crank 1", angle=angle)
    return _("{angle}° from the cylinder axis", angle=angle)


def _degrees(angle: float) -> str:
    shown = round(degrees(angle), 2)
    return number(180.0 if shown == -180 else shown, 180.0).replace("-", "−")
