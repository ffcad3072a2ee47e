"""The drawn crankshaft: pins as long as their rods need, webs, journals, counterweights on webs."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from math import pi

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder, Shaft
from crankstar.language.messages import _
from crankstar.page.proportions import (
    JOURNAL,
    JOURNAL_OF_THROW,
    PIN,
    PIN_OF_KNUCKLE,
    PIN_OF_THROW,
    ROD,
    Proportions,
)
from crankstar.page.records import ThrowShown, Web

SHARE_OF_GAP, BESIDE = 0.8, 0.42
"""Width of a rod as a share of the distance to the next rod on its pin, and of that to a rod on the
next pin."""
WEB = 0.24
"""Bores: how thick a web is where there is room."""
CLEARANCE = 0.03
"""Bores: between a rod and a web."""
SPLIT = 0.3
"""Bores: pins closer than this share one thin web (split pins)."""


@dataclass(frozen=True)
class RodPlace:
    """Where a rod runs along z, its width, and its kind."""

    z: float
    width: float
    kind: str


@dataclass
class Crank:
    """A crankshaft's drawn parts; `rods` by cylinder number."""

    throws: list[ThrowShown] = field(default_factory=list)
    webs: list[Web] = field(default_factory=list)
    rods: dict[int, RodPlace] = field(default_factory=dict)
    journal_radius: float = 0.0
    assumed: list[str] = field(default_factory=list)

    @property
    def ends(self) -> tuple[float, float]:
        """The rear and the front end of its webs and pins."""
        places = [z for web in self.webs for z in (web.z_from, web.z_to)]
        places += [z for throw in self.throws for z in (throw.pin_from, throw.pin_to)]
        return min(places), max(places)


def crank(engine: Engine, shaft: Shaft, sizes: Proportions) -> Crank:
    """The drawn parts of a shaft with throws."""
    out = Crank()
    used = [c for c in engine.cylinders if c.shaft == shaft.name]
    radius = min(throw.radius for throw in shaft.throws)
    knuckles = [c.articulated.radius for c in used if c.articulated is not None]
    pin = min(
        PIN * sizes.bore, PIN_OF_THROW * radius, *(PIN_OF_KNUCKLE * knuckle for knuckle in knuckles)
    )
    out.journal_radius = min(JOURNAL * sizes.bore, JOURNAL_OF_THROW * radius)
    places = _throw_places(shaft, sizes, out)
    on_pin = [
        [c for c in used if c.throw == number and c.articulated is None]
        for number in range(1, len(shaft.throws) + 1)
    ]
    width = _width(on_pin, places, sizes)
    for number, cylinders in enumerate(on_pin):
        _put_rods(cylinders, places[number], width, sizes, out)
    for cylinder in used:
        if cylinder.articulated is not None:
            out.rods[cylinder.number] = RodPlace(cylinder.z * sizes.along, 0.6 * width, "slave")
    masters = {c.articulated.master for c in used if c.articulated is not None}
    for number in masters & out.rods.keys():
        if out.rods[number].kind != "slave":
            out.rods[number] = RodPlace(out.rods[number].z, width, "master")
    spans = [
        _pin_span(cylinders, places[number], width, out, sizes)
        for number, cylinders in enumerate(on_pin)
    ]
    for throw, (rear, front), cylinders, z in zip(shaft.throws, spans, on_pin, places, strict=True):
        numbers = tuple(cylinder.number for cylinder in cylinders)
        out.throws.append(
            ThrowShown(
                angle=throw.angle,
                radius=throw.radius,
                z=z,
                pin_radius=pin,
                pin_from=rear,
                pin_to=front,
                cylinders=numbers,
            )
        )
    out.webs = _webs(spans, sizes.bore)
    return out


def _throw_places(shaft: Shaft, sizes: Proportions, out: Crank) -> list[float]:
    """The middles of the pins; those of throws at the same place are drawn side by side."""
    places = [throw.z * sizes.along for throw in shaft.throws]
    step = (ROD + 0.14) * sizes.bore
    together: dict[int, list[int]] = {}
    for number, z in enumerate(places):
        together.setdefault(round(z / (1e-3 * sizes.bore)), []).append(number)
    for numbers in together.values():
        if len(numbers) > 1:
            for index, number in enumerate(numbers):
                places[number] += ((len(numbers) - 1) / 2 - index) * step
    if any(len(numbers) > 1 for numbers in together.values()):
        out.assumed.append(
            _("Crank pins at the same place along the shaft are drawn side by side.")
        )
    return places


def _width(
    on_pin: Sequence[Sequence[Cylinder]], places: Sequence[float], sizes: Proportions
) -> float:
    """The width of the rods of a shaft, which leaves room for rods beside them and for webs."""
    width = ROD * sizes.bore
    for cylinders in on_pin:
        gaps = [
            b - a for a, b in pairwise(sorted({round(c.z * sizes.along, 12) for c in cylinders}))
        ]
        width = min([width, *(SHARE_OF_GAP * gap for gap in gaps if gap > 0.02 * sizes.bore)])
    apart = [b - a for a, b in pairwise(sorted(places)) if b - a > 1e-9]
    return min([width, *(BESIDE * gap for gap in apart)])


def _put_rods(
    cylinders: Sequence[Cylinder], z: float, width: float, sizes: Proportions, out: Crank
) -> None:
    """Place the rods on one pin: at their cylinders, two at the same place as fork and blade."""
    spots: dict[int, list[Cylinder]] = {}
    for cylinder in cylinders:
        spots.setdefault(round(cylinder.z * sizes.along / (0.02 * sizes.bore)), []).append(cylinder)
    moved = (
        len(spots) == 1 and abs(cylinders[0].z * sizes.along - z) < 0.5 * sizes.bore
        if cylinders
        else False
    )
    for together in spots.values():
        place = z if moved else together[0].z * sizes.along
        if len(together) == 2:
            fork, blade = together
            out.rods[fork.number] = RodPlace(place, width, "fork")
            out.rods[blade.number] = RodPlace(place, width / 2, "blade")
            out.assumed.append(
                _("Two rods at the same place on one pin are drawn as fork and blade.")
            )
            continue
        for index, cylinder in enumerate(together):
            aside = (index - (len(together) - 1) / 2) * width / len(together)
            out.rods[cylinder.number] = RodPlace(
                place + aside, 0.94 * width / len(together), "plain"
            )


def _pin_span(
    cylinders: Sequence[Cylinder], z: float, width: float, out: Crank, sizes: Proportions
) -> tuple[float, float]:
    """The rear and the front end of a pin."""
    rods = [out.rods[c.number] for c in cylinders]
    ends = [rod.z + side * rod.width / 2 for rod in rods for side in (-1, 1)] or [
        z - width / 2,
        z + width / 2,
    ]
    margin = min(CLEARANCE * sizes.bore, 0.1 * width)
    return min(*ends, z) - margin, max(*ends, z) + margin


def _webs(spans: Sequence[tuple[float, float]], bore: float) -> list[Web]:
    """Two webs to a throw; webs between close pins share the gap."""
    order = sorted(range(len(spans)), key=lambda number: spans[number][0])
    webs: list[Web] = []
    thickness = WEB * bore
    gaps = [spans[b][0] - spans[a][1] for a, b in pairwise(order)]
    thickness = min([thickness, *(0.36 * gap for gap in gaps if gap > SPLIT * bore)])
    for index, number in enumerate(order):
        rear, front = spans[number]
        behind = _thickness(gaps[index - 1], thickness, bore) if index else thickness
        ahead = _thickness(gaps[index], thickness, bore) if index < len(gaps) else thickness
        if behind > 0:
            webs.append(Web(z_from=rear - behind, z_to=rear, throw=number))
        if ahead > 0:
            webs.append(Web(z_from=front, z_to=front + ahead, throw=number))
    return webs


def _thickness(gap: float, thickness: float, bore: float) -> float:
    if gap <= 1e-6 * bore:
        return 0.0
    return thickness if gap > SPLIT * bore else gap / 2


@dataclass(frozen=True)
class Lump:
    """Weights at one place: their unbalance `up + i*right`, place and thickness."""

    vector: complex
    z: float
    thickness: float


def lumps(shaft: Shaft, drawn: Crank, sizes: Proportions) -> list[Lump]:
    """The weights of a crankshaft on the nearest webs; one inside a pin on both its webs."""
    by_web: dict[int, complex] = {}
    free: list[Lump] = []
    middles = [(web.z_from + web.z_to) / 2 for web in drawn.webs]
    for weight in shaft.weights:
        z, vector = weight.z * sizes.along, weight.unbalance * np.exp(1j * weight.angle)
        inside = next((n for n, t in enumerate(drawn.throws) if t.pin_from < z < t.pin_to), None)
        nearest = sorted(range(len(middles)), key=lambda index: abs(middles[index] - z))
        if inside is not None:
            nearest = [
                index for index, web in enumerate(drawn.webs) if web.throw == inside
            ] or nearest[:1]
            for index in nearest:
                by_web[index] = by_web.get(index, 0j) + vector / len(nearest)
        elif nearest and abs(middles[nearest[0]] - z) < 0.5 * sizes.bore:
            by_web[nearest[0]] = by_web.get(nearest[0], 0j) + vector
        else:
            free.append(Lump(complex(vector), z, WEB * sizes.bore))
    on_webs = [
        Lump(complex(vector), middles[index], drawn.webs[index].z_to - drawn.webs[index].z_from)
        for index, vector in by_web.items()
    ]
    return on_webs + free


def moved(shaft: Shaft, standing: Sequence[Lump], sizes: Proportions) -> bool:
    """Whether the drawn places of the weights change their couple visibly."""
    vectors = [
        (weight.unbalance * np.exp(1j * weight.angle), weight.z * sizes.along)
        for weight in shaft.weights
    ]
    couple = sum(vector * z for vector, z in vectors) - sum(
        lump.vector * lump.z for lump in standing
    )
    return bool(abs(couple) > VISIBLE * sum(abs(vector * z) for vector, z in vectors))


VISIBLE = 0.03
"""Share of the couples of weights by which those that are drawn may differ without a note."""
HALF_ANGLE = pi / 3
"""Half the sector of a counterweight, unless it needs more for its unbalance."""
