"""The vectors of one order: what every cylinder and every turning part pushes, as arrows that turn with or against the crank.

In a row of cylinders on one crankshaft nothing but pistons pushes along one axis; then a textbook draws one star: vectors
`C_k exp(i k alpha)`, whose part along the axis of the cylinders is the force. Such a vector is twice the one that turns
with the crank. Everywhere else there are two stars, of the vectors that turn with the crank and of those against it.
"""

from __future__ import annotations

from math import degrees
from typing import Literal, NamedTuple

import numpy as np

from crankstar import motion, phasor
from crankstar.balance import Balance, balance, total
from crankstar.charts.drawing import BLUE, GREY, VERMILION, ChartError, checked_order
from crankstar.engine import Engine
from crankstar.mechanism import Reference
from crankstar.phasor import Spectrum
from crankstar.wording import number, unit_text

Quantity = Literal["force", "couple"]
NOTHING = 1e-9
"""Share of the greatest vector below which one is not drawn."""
COLOURS = {"cylinder": BLUE, "throw": VERMILION, "weight": GREY}


class Vector(NamedTuple):
    """What one cylinder, throw or weight contributes at theta = 0 (up + i*right); `name` is its label."""

    name: str
    kind: str
    value: complex


class Star(NamedTuple):
    """Vectors that turn together by `rate` turns clockwise per turn of the crank, their sum, and what they are."""

    vectors: tuple[Vector, ...]
    resultant: complex
    rate: float
    title: str


class Stars(NamedTuple):
    """All vectors of one order of an engine: one star where `axis`, the bearing of all cylinders, is given; else two."""

    name: str
    quantity: Quantity
    order: float
    unit: str
    stars: tuple[Star, ...]
    axis: float | None
    sense: int
    from_crank: bool

    @property
    def reach(self) -> float:
        """The length of the longest vector."""
        return max((abs(vector.value) for star in self.stars for vector in star.vectors), default=0.0)


def checked_quantity(quantity: str, among: tuple[str, ...] = ("force", "couple")) -> str:
    """A quantity that a figure can show; raises ChartError."""
    if quantity not in among:
        raise ChartError(f"{quantity!r} is not a quantity of this figure; give one of {', '.join(among)}")
    return quantity


def stars(
    engine: Engine,
    *,
    order: float = 1.0,
    quantity: Quantity = "force",
    reference: Reference | None = None,
    speed: float | None = None,
) -> Stars:
    """The vectors of an order: in N, N m at `speed` (rad/s); without it in m r w^2 |A_k|, A_k of the first cylinder's piston."""
    order = checked_order(order)
    checked_quantity(quantity)
    result = balance(engine, speed=speed, reference=reference)
    unit, factor = result.units._asdict()[quantity], 1.0
    if result.speed is None:
        factor, subscript = harmonic(engine, order)
        unit = unit.replace("m*r*w^2", f"m*r*w^2*{subscript}") if subscript else unit
    shares = phasor.scaled(phasor.selected(getattr(result, quantity), order), 1 / factor)
    whole = phasor.scaled(phasor.selected(getattr(total(result), quantity), order), 1 / factor)
    names = _names(engine, result)
    rows = [(name, kind, _sum(shares, places)) for (name, kind), places in names.items()]
    axis = _axis(engine, shares)
    rate = engine.sense * order
    forward = tuple(Vector(name, kind, one[0]) for name, kind, one in rows)
    backward = tuple(Vector(name, kind, one[1]) for name, kind, one in rows)
    ahead, against = complex(whole.forward[0]), complex(whole.backward[0])
    if axis is not None:
        forward = tuple(vector._replace(value=2 * vector.value) for vector in forward)
        found = (Star(_seen(forward), 2 * ahead, rate, ""),)
    else:
        found = (Star(_seen(forward), ahead, rate, "with the crank"), Star(_seen(backward), against, -rate, "against the crank"))
    first = engine.throw(engine.first)
    from_crank = axis is not None and abs(np.exp(1j * (first.angle - axis)) - 1) < 1e-9
    return Stars(engine.name, quantity, order, unit_text(unit), found, axis, engine.sense, from_crank)


def harmonic(engine: Engine, order: float) -> tuple[float, str]:
    """|A_k| of the first cylinder's piston and how it is written; 1 and nothing where it has none, or is itself the unit."""
    first = engine.first
    if order != int(order) or first.articulated is not None or order == 1:
        return 1.0, ""
    found = motion.piston_harmonics(crank_radius=engine.throw(first).radius, rod_length=first.rod_length, offset=first.offset)
    size = complex(found[int(order)]) if order < found.size else 0j
    if abs(size) < motion.TAIL * 10:
        return 1.0, ""
    letter = f"A{int(order)}"  # no lowered figure: few fonts of those that make pictures have one
    return abs(size), letter if size.real > 0 and abs(size.imag) < 1e-9 * abs(size) else f"|{letter}|"


def _names(engine: Engine, result: Balance) -> dict[tuple[str, str], list[int]]:
    """The rows of a Balance that belong to each cylinder, throw and weight, by label and kind, in this order."""
    out: dict[tuple[str, str], list[int]] = {}
    several = sum(1 for shaft in engine.shafts if shaft.throws) > 1
    counts: dict[tuple[str, str], int] = {}
    sizes = {
        (kind, shaft.name): len(items)
        for shaft in engine.shafts
        for kind, items in (("throw", shaft.throws), ("weight", shaft.weights))
    }
    for row, part in enumerate(result.parts):
        if part.cylinder is not None:
            out.setdefault((str(part.cylinder), "cylinder"), []).append(row)
            continue
        key = (part.kind, part.shaft)
        counts[key] = counts.get(key, 0) + 1
        label = part.kind if sizes[key] == 1 else f"{part.kind} {counts[key]}"
        own = several or not engine.shaft(part.shaft).throws
        out.setdefault((f"{part.shaft} {label}" if own else label, part.kind), []).append(row)
    return out


def _sum(shares: Spectrum, rows: list[int]) -> tuple[complex, complex]:
    return complex(shares.forward[rows, 0].sum()), complex(shares.backward[rows, 0].sum())


def _seen(vectors: tuple[Vector, ...]) -> tuple[Vector, ...]:
    greatest = max((abs(vector.value) for vector in vectors), default=0.0)
    return tuple(vector for vector in vectors if greatest and abs(vector.value) > NOTHING * greatest)


def _axis(engine: Engine, shares: Spectrum) -> float | None:
    """The bearing along which everything pushes, if all cylinders stand in a row on the reference crankshaft."""
    first = engine.first
    if any(c.shaft != engine.shafts[0].name or abs(c.bearing - first.bearing) > 1e-9 for c in engine.cylinders):
        return None
    forward, backward = shares.forward[:, 0], shares.backward[:, 0]
    mirrored = np.exp(2j * first.bearing) * np.conj(forward)
    greatest = float(np.abs(forward).max(initial=0.0) + np.abs(backward).max(initial=0.0))
    lines = bool(np.all(np.abs(mirrored - backward) <= NOTHING * greatest))
    return first.bearing if lines else None


def angle_text(found: Stars, value: complex) -> str:
    """The plane of a resultant at theta = 0: from the axis of the cylinders in the direction of rotation, or from up."""
    if found.axis is not None:
        turned = float(np.angle(value * np.exp(-1j * found.axis))) * found.sense
        return f"{_degrees(turned)}° from {'crank 1' if found.from_crank else 'the cylinder axis'}"
    return f"at {_degrees(float(np.angle(value)))}°"


def _degrees(angle: float) -> str:
    shown = round(degrees(angle), 2)
    return number(180.0 if shown == -180 else shown, 180.0).replace("-", "−")


def heading(found: Stars, drawn: str = "") -> str:
    """What is drawn, of which order, in which units."""
    return f"{' '.join(filter(None, (found.quantity, drawn))).capitalize()} of order {found.order:g}, in {found.unit}"
