"""The vectors of one order of every cylinder, throw and weight, turning with or against the crank.

The forces of a row of cylinders on one crankshaft act along one axis. Textbooks then draw one star
of vectors `C_k exp(i k alpha)`, whose component along the cylinder axis is the force; such a vector
is twice the one that turns with the crank. Other engines have two stars: the vectors that turn with
the crank and those that turn against it.
"""

from __future__ import annotations

from math import degrees
from typing import Literal, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.charts.drawing import BLUE, GREY, VERMILION, ChartError, checked_order
from crankstar.engine import motion
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number, unit_text
from crankstar.mechanics.balance import Balance, balance, total
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.remains import NEGLIGIBLE
from crankstar.spectra import Spectrum

Quantity = Literal["force", "couple"]
COLOURS = {"cylinder": BLUE, "throw": VERMILION, "weight": GREY}
HEADINGS = {
    "force": N_("Force of order {order}, in {unit}"),
    "couple": N_("Couple of order {order}, in {unit}"),
}
WITH, AGAINST = N_("with the crank"), N_("against the crank")


class Vector(NamedTuple):
    """The vector of one cylinder, throw or weight at theta = 0 (up + i*right); `name` labels it."""

    name: str
    kind: str
    value: complex


class Star(NamedTuple):
    """Vectors that turn by `rate` turns clockwise per turn of the crank, and their resultant."""

    vectors: tuple[Vector, ...]
    resultant: complex
    rate: float
    title: str


class Stars(NamedTuple):
    """All vectors of one order: one star along the `axis` of the cylinders, else two stars."""

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
        return max(
            (abs(vector.value) for star in self.stars for vector in star.vectors), default=0.0
        )


def checked_quantity(quantity: str, among: tuple[str, ...] = ("force", "couple")) -> str:
    """A quantity that a figure can show; raises ChartError."""
    if quantity not in among:
        raise ChartError(
            _(
                "{quantity} is not a quantity of this figure; give one of {quantities}",
                quantity=repr(quantity),
                quantities=", ".join(among),
            )
        )
    return quantity


def stars(
    engine: Engine,
    *,
    order: float = 1.0,
    quantity: Quantity = "force",
    reference: Reference | None = None,
    speed: float | None = None,
) -> Stars:
    """The vectors of an order in N, N m at `speed` (rad/s), else in m r w^2 |A_k|.

    A_k is that of the first cylinder's piston.
    """
    order = checked_order(order)
    checked_quantity(quantity)
    result = balance(engine, speed=speed, reference=reference)
    unit, factor = result.units._asdict()[quantity], 1.0
    if result.speed is None:
        factor, subscript = harmonic(engine, order)
        unit = unit.replace("m*r*w^2", f"m*r*w^2*{subscript}") if subscript else unit
    shares = spectra.scaled(spectra.selected(getattr(result, quantity), order), 1 / factor)
    whole = spectra.scaled(spectra.selected(getattr(total(result), quantity), order), 1 / factor)
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
        found = (
            Star(_seen(forward), ahead, rate, _(WITH)),
            Star(_seen(backward), against, -rate, _(AGAINST)),
        )
    first = engine.throw(engine.first)
    from_crank = axis is not None and abs(np.exp(1j * (first.angle - axis)) - 1) < 1e-9
    return Stars(
        engine.name, quantity, order, unit_text(unit), found, axis, engine.sense, from_crank
    )


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
    return tuple(
        vector for vector in vectors if greatest and abs(vector.value) > NEGLIGIBLE * greatest
    )


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


def heading(shown: Stars) -> str:
    """Quantity, order and unit."""
    return _(HEADINGS[shown.quantity], order=f"{shown.order:g}", unit=shown.unit)
