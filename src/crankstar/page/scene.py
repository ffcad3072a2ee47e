"""Engine -> Scene: shafts, pins, webs, counterweights, gears, cylinders and pistons as drawn."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import inf, nextafter, pi, sin

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft
from crankstar.language.messages import _, _n
from crankstar.page.crankshafts import HALF_ANGLE, Crank, Lump, crank, lumps, moved
from crankstar.page.gears import Place, gears
from crankstar.page.proportions import Proportions, proportions
from crankstar.page.records import CylinderShown, GearShown, Scene, ShaftShown, WeightShown

STEEL = 7850.0
"""kg/m^3, of counterweights whose unbalance is known."""
BALANCE_SHAFT = 0.13
"""Bores: radius of a balance shaft."""
HEAD = 0.12
"""Bores: clearance of a piston at its top from the head, and wall thickness of the bore."""
STUB = 0.5
"""Bores: overhang of a shaft at both ends."""


def scene(engine: Engine, known: Proportions | None = None) -> Scene:
    """The drawn engine, with a sentence on every proportion that is assumed."""
    sizes = known or proportions(engine)
    cranks = {
        index: crank(engine, shaft, sizes)
        for index, shaft in enumerate(engine.shafts)
        if shaft.throws
    }
    assumed = [*sizes.assumed, *(text for drawn in cranks.values() for text in drawn.assumed)]
    places = _places(engine, sizes, assumed)
    reach = max(
        throw.radius + 1.6 * throw.pin_radius for drawn in cranks.values() for throw in drawn.throws
    )
    weights = [_lumps(shaft, cranks.get(index), sizes) for index, shaft in enumerate(engine.shafts)]
    if any(moved(engine.shafts[index], weights[index], sizes) for index in cranks):
        assumed.append(
            _("Counterweights are drawn on the nearest webs; the numbers use their true places.")
        )
    rear = min(
        [drawn.ends[0] for drawn in cranks.values()]
        + [lump.z - lump.thickness / 2 for own in weights for lump in own]
    )
    wheels, notes = gears(engine, places, reach=reach, bore=sizes.bore, behind=rear)
    assumed += notes
    rooms = [
        _weight_room(engine, index, cranks.get(index), sizes, places)
        for index in range(len(engine.shafts))
    ]
    density = _density(engine, weights, rooms)
    shafts = tuple(
        _shaft(
            shaft,
            sizes.bore,
            cranks.get(index),
            places[index],
            [
                _weight(lump, density, *rooms[index])
                for lump in weights[index]
                if abs(lump.vector) > 0
            ],
            [wheel for wheel in wheels if wheel.shaft == index],
        )
        for index, shaft in enumerate(engine.shafts)
    )
    cylinders = _cylinders(engine, sizes, cranks)
    low, high = _box(shafts, wheels, cylinders, sizes)
    return Scene(
        length_unit=engine.across,
        low=low,
        high=high,
        shafts=shafts,
        gears=wheels,
        cylinders=cylinders,
        assumed=tuple(dict.fromkeys(assumed)),
    )


def _places(engine: Engine, sizes: Proportions, assumed: list[str]) -> list[Place]:
    """Where the shafts are drawn: balance shafts without a place below the crankshaft."""
    places = [Place(shaft.up, shaft.right) for shaft in engine.shafts]
    astray = [
        i
        for i, shaft in enumerate(engine.shafts)
        if i and not shaft.throws and not (shaft.up or shaft.right)
    ]
    if not astray:
        return places
    reach = (
        max(throw.radius for shaft in engine.shafts for throw in shaft.throws) + 0.45 * sizes.bore
    )
    step = 2.4 * 2 * BALANCE_SHAFT * sizes.bore
    for place, index in enumerate(astray):
        aside = (place - (len(astray) - 1) / 2) * max(step, 0.8 * reach)
        places[index] = Place(-1.25 * reach, aside)
    assumed.append(
        _n(
            "The file gives no place for the balance shaft {shafts}; it is drawn below the "
            "crankshaft.",
            "The file gives no place for the balance shafts {shafts}; they are drawn below the "
            "crankshaft.",
            len(astray),
            shafts=", ".join(engine.shafts[index].name for index in astray),
        )
    )
    return places


def _density(
    engine: Engine, weights: Sequence[Sequence[Lump]], rooms: Sequence[tuple[float, float]]
) -> float:
    """The density of drawn weights: steel, or one that fits engines without masses or sizes."""
    if {"mass", "radius"}.isdisjoint(engine.relative):
        return STEEL
    # balance shafts can be as long as they need, webs are as thick as they are
    for with_throws in (True, False):
        needed = [
            abs(lump.vector)
            / max(2 / 3 * sin(HALF_ANGLE) * lump.thickness * ((0.9 * room) ** 3 - inner**3), 1e-12)
            for shaft, own, (inner, room) in zip(engine.shafts, weights, rooms, strict=True)
            if bool(shaft.throws) is with_throws
            for lump in own
        ]
        if any(needed):
            return max(needed)
    return 1.0


def _lumps(shaft: Shaft, drawn: Crank | None, sizes: Proportions) -> list[Lump]:
    if drawn is not None:
        return lumps(shaft, drawn, sizes)
    places = sorted({weight.z for weight in shaft.weights})
    gap = min((b - a for a, b in pairwise(places)), default=1e9) * sizes.along
    thickness = min(1.2 * sizes.bore, 0.8 * gap)
    return [
        Lump(complex(w.unbalance * np.exp(1j * w.angle)), w.z * sizes.along, thickness)
        for w in shaft.weights
    ]


def _weight_room(
    engine: Engine, index: int, drawn: Crank | None, sizes: Proportions, places: Sequence[Place]
) -> tuple[float, float]:
    """Inner and greatest outer radius of a shaft's weights, clear of pistons and other shafts."""
    own = [
        row
        for row, cylinder in enumerate(engine.cylinders)
        if cylinder.shaft == engine.shafts[index].name
    ]
    inner = 0.8 * drawn.journal_radius if drawn is not None else 0.0
    room = min(
        (float(sizes.travel[row, 0] - sizes.skirts[row]) for row in own), default=0.5 * sizes.bore
    )
    for other, place in enumerate(places):
        distance = places[index].distance(place)
        if other != index and distance > 1e-9:
            room = min(room, _half(engine, index, other, distance, sizes))
    return inner, max(0.96 * room, 1.05 * inner)


def _half(engine: Engine, index: int, other: int, distance: float, sizes: Proportions) -> float:
    """A shaft's share of its distance to another: half, or the room beside a crank."""
    crank_here, crank_there = bool(engine.shafts[index].throws), bool(engine.shafts[other].throws)
    if crank_here == crank_there:
        return distance / 2
    cranked = engine.shafts[index if crank_here else other]
    reach = min(max(throw.radius for throw in cranked.throws) + 0.4 * sizes.bore, 0.75 * distance)
    return reach if crank_here else distance - reach


def _shaft(
    shaft: Shaft,
    bore: float,
    drawn: Crank | None,
    place: Place,
    weights: Sequence[WeightShown],
    wheels: Sequence[GearShown],
) -> ShaftShown:
    discs = [*weights, *wheels]
    ends = [*(drawn.ends if drawn else ())]
    ends += [disc.z + side * disc.thickness / 2 for disc in discs for side in (-1, 1)]
    ends = ends or [-bore, bore]
    stub = STUB * bore if drawn is not None else 0.25 * bore
    return ShaftShown(
        name=shaft.name,
        kind="crankshaft" if shaft.throws else "balance shaft",
        speed_ratio=float(shaft.speed_ratio),
        up=place.up,
        right=place.right,
        z_from=min(ends) - (stub if not wheels else 0.1 * bore),
        z_to=max(ends) + stub,
        journal_radius=drawn.journal_radius if drawn is not None else BALANCE_SHAFT * bore,
        throws=tuple(drawn.throws) if drawn is not None else (),
        webs=tuple(drawn.webs) if drawn is not None else (),
        weights=tuple(weights),
    )


def _weight(lump: Lump, density: float, inner: float, room: float) -> WeightShown:
    """A sector of a disc with the unbalance of a lump.

    U = 2/3 density thickness sin(half) (R^3 - r^3), within its room.
    """
    size = abs(lump.vector)
    half = HALF_ANGLE
    outer = (1.5 * size / (density * lump.thickness * sin(half)) + inner**3) ** (1 / 3)
    outer = max(outer, nextafter(inner, inf))  # of next to nothing, whose cube is lost
    if outer > room:
        half, outer = pi / 2, room
    return WeightShown(
        angle=float(np.angle(lump.vector)),
        z=lump.z,
        unbalance=size,
        inner_radius=inner,
        outer_radius=outer,
        half_angle=half,
        thickness=lump.thickness,
    )


def _cylinders(
    engine: Engine, sizes: Proportions, cranks: dict[int, Crank]
) -> tuple[CylinderShown, ...]:
    index_of = {shaft.name: index for index, shaft in enumerate(engine.shafts)}
    row_of = {cylinder.number: row for row, cylinder in enumerate(engine.cylinders)}
    out = []
    for row, cylinder in enumerate(engine.cylinders):
        shaft, link = index_of[cylinder.shaft], cylinder.articulated
        rod, bore, throw = (
            cranks[shaft].rods[cylinder.number],
            float(sizes.bores[row]),
            engine.throw(cylinder),
        )
        crown, skirt = float(sizes.crowns[row]), float(sizes.skirts[row])
        out.append(
            CylinderShown(
                number=cylinder.number,
                shaft=shaft,
                throw=cylinder.throw - 1,
                throw_angle=throw.angle,
                crank_radius=throw.radius,
                bearing=cylinder.bearing,
                z=cylinder.z * sizes.along,
                offset=cylinder.offset,
                rod_length=cylinder.rod_length,
                master=-1 if link is None else row_of[link.master],
                knuckle_radius=0.0 if link is None else link.radius,
                knuckle_angle=0.0 if link is None else link.angle,
                rod=rod.kind,  # pyright: ignore[reportArgumentType]
                rod_z=rod.z,
                rod_width=rod.width,
                bore=bore,
                pin_height=crown,
                skirt=skirt,
                bore_from=float(sizes.travel[row, 0]) - skirt,
                bore_to=float(sizes.travel[row, 1]) + crown + min(HEAD * bore, 0.1 * crown),
                chamber=cylinder.chamber or cylinder.number,
            )
        )
    return tuple(out)


def _box(
    shafts: Sequence[ShaftShown],
    wheels: Sequence[GearShown],
    cylinders: Sequence[CylinderShown],
    sizes: Proportions,
) -> tuple[tuple[float, float, float], tuple[float, float, float]]:
    """The smallest upright box that holds all parts at every crank angle."""
    points = [np.array([*_round_parts(shafts, wheels), *_bores(cylinders, shafts)])]
    for row, cylinder in enumerate(cylinders):
        place = complex(shafts[cylinder.shaft].up, shafts[cylinder.shaft].right)
        end = sizes.big_ends[row] + place
        margin = 1.6 * shafts[cylinder.shaft].throws[cylinder.throw].pin_radius
        z = np.full(end.size, cylinder.rod_z)
        points += [
            np.column_stack([end.real + side, end.imag + side, z]) for side in (-margin, margin)
        ]
    every = np.concatenate(points)
    low, high = every.min(axis=0).tolist(), every.max(axis=0).tolist()
    return tuple(low), tuple(high)


def _round_parts(
    shafts: Sequence[ShaftShown], wheels: Sequence[GearShown]
) -> Iterator[tuple[float, float, float]]:
    """Corners of the boxes round what turns about a shaft."""
    for index, shaft in enumerate(shafts):
        radii = [shaft.journal_radius, *(weight.outer_radius for weight in shaft.weights)]
        radii += [throw.radius + 1.6 * throw.pin_radius for throw in shaft.throws]
        radii += [wheel.radius * (1 + 2 / wheel.teeth) for wheel in wheels if wheel.shaft == index]
        for side in (-1, 1):
            for z in (shaft.z_from, shaft.z_to):
                yield shaft.up + side * max(radii), shaft.right + side * max(radii), z


def _bores(
    cylinders: Sequence[CylinderShown], shafts: Sequence[ShaftShown]
) -> Iterator[tuple[float, float, float]]:
    """Corners of the bores with the head on them."""
    for cylinder in cylinders:
        axis = np.exp(1j * cylinder.bearing)
        place = complex(shafts[cylinder.shaft].up, shafts[cylinder.shaft].right)
        half = cylinder.bore * (0.5 + HEAD)
        for s in (cylinder.bore_from, cylinder.bore_to):
            for side in (-1, 1):
                point = place + axis * (s + 1j * (cylinder.offset + side * half))
                for z in (cylinder.z - half, cylinder.z + half):
                    yield float(point.real), float(point.imag), z
