"""The Engine: shafts and cylinders as one frozen record, and the checks that make it possible.

The checks here need no motion: what only the moving engine shows (a slave rod that cannot reach,
a firing order that does not fit) is found by `motion` and `firing`.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping
from itertools import count, pairwise
from math import lcm
from typing import Any

from pydantic import Field, model_validator

from crankstar import valves
from crankstar.fault import EngineError, Fault, counted, cylinders, listed
from crankstar.quantity import GREATEST_LENGTH, GREATEST_RELATIVE, Pitch, Unknown, seen
from crankstar.records import GREATEST_CYLINDERS, Block, Cylinder, Identity, Shaft, Throw

MINIMUM_CLEARANCE = 1.001
"""Least rod length over (crank radius + |offset|): nearer to locking, forces run away and no real engine is there."""

ROUNDED = 1e-3
"""Share by which moments of inertia given to a few figures may miss what they must be."""
GREATEST_SHAFTS = 16
GREATEST_CHAIN = 8
"""Rods one on the other: real engines have one on a master; a longer chain is a mistake, and dear to follow."""
GREATEST_TURNS = 2000
"""Turns of the reference shaft after which all geared shafts must be back at the start."""


class Engine(Identity):
    """A piston engine: shafts with throws and weights, cylinders on them. Always valid: an impossible one raises.

    `relative` names what is not known and therefore counted in its own unit: masses in the first cylinder's
    reciprocating mass, lengths across the crankshaft in its crank radius, lengths along it in bore pitches.
    """

    relative: tuple[Unknown, ...] = Field(
        default=(), description="what is not known, and so given as bare numbers in units of itself"
    )
    bore_pitch: Pitch | None = Field(default=None, description="the length a in which couples are counted when normalised")
    shafts: tuple[Shaft, ...] = Field(
        validation_alias="shaft",
        serialization_alias="shaft",
        min_length=1,
        max_length=GREATEST_SHAFTS,
        description="the shafts, the reference crankshaft first",
    )
    cylinders: tuple[Cylinder, ...] = Field(
        min_length=1, max_length=GREATEST_CYLINDERS, description="pistons, rods and where they work"
    )

    @model_validator(mode="after")
    def _possible(self) -> Engine:
        faults = list(_faults(self))
        if faults:
            raise EngineError(faults)
        return self

    def _repr_html_(self) -> str:
        """The engine as tables, in a notebook."""
        from crankstar import description, wording

        return wording.html(description.description(self))

    @property
    def sense(self) -> int:
        """+1 if the reference crankshaft turns clockwise seen from the front, else -1."""
        return 1 if self.rotation == "clockwise" else -1

    @property
    def across(self) -> str:
        """What lengths across the crankshaft are counted in: m, or crank radii."""
        return "crank radii" if "radius" in self.relative else "m"

    @property
    def cycle_angle(self) -> float:
        """Degrees of the reference crankshaft in one working cycle: 360 or 720."""
        return 360.0 if self.cycle == "two-stroke" else 720.0

    @property
    def chambers(self) -> dict[int, tuple[Cylinder, ...]]:
        """The cylinders of each combustion chamber, by its number, in order of first mention."""
        groups: dict[int, tuple[Cylinder, ...]] = {}
        for cylinder in self.cylinders:
            number = cylinder.chamber or cylinder.number
            groups[number] = (*groups.get(number, ()), cylinder)
        return groups

    @property
    def banks(self) -> dict[str, tuple[int, ...]]:
        """The cylinder numbers of each bank; cylinders that name none are grouped by shaft and bearing."""
        groups: dict[Any, list[int]] = {}
        for cylinder in self.cylinders:
            key = cylinder.bank or (cylinder.shaft, round(cylinder.bearing, 9))
            groups.setdefault(key, []).append(cylinder.number)
        free = (name for name in (f"bank {place}" for place in count(1)) if name not in groups)
        names = {key: key if isinstance(key, str) else next(free) for key in groups}
        return {names[key]: tuple(numbers) for key, numbers in groups.items()}

    def shaft(self, name: str) -> Shaft:
        """The shaft of that name."""
        return next(shaft for shaft in self.shafts if shaft.name == name)

    def throw(self, cylinder: Cylinder) -> Throw:
        """The throw on which a cylinder's rod, or its master's, works."""
        return self.shaft(cylinder.shaft).throws[cylinder.throw - 1]

    @property
    def first(self) -> Cylinder:
        """The cylinder whose mass, crank radius and harmonics are the units of normalised results: the lowest number."""
        return min(self.cylinders, key=lambda cylinder: cylinder.number)

    @property
    def pitch(self) -> float:
        """The length a in which normalised couples are counted, m.

        `bore_pitch`; where none is given the closest spacing within a bank, else of any two cylinders, else 1 m.
        """
        if self.bore_pitch is not None:
            return self.bore_pitch
        places = {cylinder.number: cylinder.z for cylinder in self.cylinders}
        for groups in (self.banks.values(), [tuple(places)]):
            gaps = [gap for numbers in groups for gap in _gaps([places[number] for number in numbers])]
            if gaps:
                return min(gaps)
        return 1.0


def _gaps(places: list[float]) -> list[float]:
    ordered = sorted(places)
    return [b - a for a, b in pairwise(ordered) if b - a > 1e-9]


def _faults(engine: Engine) -> Iterator[Fault]:
    yield from _shaft_faults(engine)
    yield from _cylinder_faults(engine)
    yield from _firing_faults(engine)
    yield from valves.faults(engine.valves, cycle=engine.cycle, chambers=engine.chambers)
    yield from _block_faults(engine.block)
    if len(set(engine.relative)) != len(engine.relative):
        yield Fault(("relative",), "names the same thing twice; name each once")


def _block_faults(block: Block | None) -> Iterator[Fault]:
    """Moments of inertia that no body has: each is at most the sum of the two others."""
    if block is None:
        return
    told = {name: getattr(block, name) for name in ("inertia_up", "inertia_right", "inertia_z")}
    missing = [name for name, value in told.items() if value is None]
    if 0 < len(missing) < len(told):
        yield Fault(("block", missing[0]), "is missing, and other moments of inertia are given; give all three, or none of them")
    if missing:
        return
    name = max(told, key=told.__getitem__)
    rest = sum(told.values()) - told[name]
    if told[name] > rest * (1 + ROUNDED):
        others = " and ".join(other for other in told if other != name)
        message = f"is {told[name]:.6g}, more than {others} together ({rest:.6g}); no body has such moments of inertia"
        yield Fault(("block", name), message)


def _shaft_faults(engine: Engine) -> Iterator[Fault]:
    names = Counter(shaft.name for shaft in engine.shafts)
    for index, shaft in enumerate(engine.shafts):
        if names[shaft.name] > 1:
            yield Fault(("shaft", index, "name"), f'"{shaft.name}" names {names[shaft.name]} shafts; give each its own name')
    if engine.shafts[0].speed_ratio != 1:
        yield Fault(
            ("shaft", 0, "speed_ratio"),
            f"is {engine.shafts[0].speed_ratio}; the first shaft is the reference crankshaft, its ratio is 1 "
            '(use rotation = "counter-clockwise" for one that turns the other way)',
        )
    if engine.shafts[0].up or engine.shafts[0].right:
        yield Fault(("shaft", 0), "is not at 0, 0; the first shaft is the reference crankshaft, leave its up and right out")
    turns = lcm(*(shaft.speed_ratio.denominator for shaft in engine.shafts))
    if turns > GREATEST_TURNS:
        yield Fault(
            ("shaft",), f"the geared shafts are back at the start only after {turns} turns; up to {GREATEST_TURNS} are allowed"
        )


def _cylinder_faults(engine: Engine) -> Iterator[Fault]:
    shafts = {shaft.name: shaft for shaft in engine.shafts}
    numbers = Counter(cylinder.number for cylinder in engine.cylinders)
    by_number = {cylinder.number: cylinder for cylinder in engine.cylinders}
    if "mass" not in engine.relative and not any(c.reciprocating_mass or c.rod for c in engine.cylinders):
        place = ("cylinders", 0, "reciprocating_mass")
        message = 'is 0, and no cylinder has a piston of any mass; a mass is needed, such as "650 g"'
        yield Fault(place, message, engine.cylinders[0].number)
    for index, cylinder in enumerate(engine.cylinders):
        here = ("cylinders", index)
        if numbers[cylinder.number] > 1:
            yield Fault(
                (*here, "number"), f"is {cylinder.number}, as for {numbers[cylinder.number]} cylinders; give each its own number"
            )
        shaft = shafts.get(cylinder.shaft)
        if shaft is None:
            yield Fault((*here, "shaft"), f"is {seen(cylinder.shaft)}, and there is no such shaft; there are: {', '.join(shafts)}")
        elif cylinder.throw > len(shaft.throws):
            there = f"throws 1 to {len(shaft.throws)}" if shaft.throws else "no throws"
            message = f"is {cylinder.throw}, but shaft {seen(shaft.name)} has {there}; name one of them, or add a [[shaft.throw]]"
            yield Fault((*here, "throw"), message)
        elif cylinder.articulated is None:
            yield from _reach_faults(here, cylinder, shaft.throws[cylinder.throw - 1].radius, engine.across)
        if cylinder.articulated is not None:
            yield from _articulation_faults(here, cylinder, by_number)
    for number, pistons in engine.chambers.items():
        ratios = {abs(shafts[piston.shaft].speed_ratio) for piston in pistons if piston.shaft in shafts}
        if len(pistons) > 2 or len(ratios) > 1:
            count = f"{len(pistons)} pistons" if len(pistons) > 2 else "pistons on shafts of different speed"
            yield Fault(("cylinders",), f"combustion chamber {number} has {count}; one or two of equal speed can share a chamber")


def _reach_faults(here: tuple[str | int, ...], cylinder: Cylinder, radius: float, unit: str) -> Iterator[Fault]:
    reach = radius + abs(cylinder.offset)
    if cylinder.rod_length < MINIMUM_CLEARANCE * reach:
        offset = f" + offset {abs(cylinder.offset):.6g} {unit}" if cylinder.offset else ""
        yield Fault(
            (*here, "rod_length"),
            f"is {cylinder.rod_length:.6g} {unit}, and the rod is too short to turn with crank radius {radius:.6g} {unit}{offset}; "
            f"at least {MINIMUM_CLEARANCE * reach:.6g} {unit} is needed",
            cylinder.number,
        )
    greatest = GREATEST_RELATIVE if unit != "m" else GREATEST_LENGTH
    if cylinder.rod_length > greatest:
        message = f"is {cylinder.rod_length:.6g} {unit}, too long for an engine; at most {greatest:g} {unit} can be"
        yield Fault((*here, "rod_length"), message, cylinder.number)


def _articulation_faults(here: tuple[str | int, ...], cylinder: Cylinder, by_number: Mapping[int, Cylinder]) -> Iterator[Fault]:
    path = (*here, "articulated", "master")
    seen_before = [cylinder.number]
    link: Cylinder | None = cylinder
    while link is not None and link.articulated is not None:
        master = link.articulated.master
        if master not in by_number:
            if link is cylinder:
                message = f"is {master}, and there is no such cylinder; there are: {listed(sorted(by_number))}"
                yield Fault(path, message, cylinder.number)
            return
        if master in seen_before:
            if master == cylinder.number == min(seen_before):  # tell of a loop once, and where it closes
                yield Fault(path, f"is {link.articulated.master}: {_loop(seen_before)}", cylinder.number)
            return
        seen_before.append(master)
        link = by_number[master]
    if len(seen_before) > GREATEST_CHAIN:
        message = f"leads over {len(seen_before)} rods to the crank pin; at most {GREATEST_CHAIN} can sit one on the other"
        yield Fault(path, message, cylinder.number)
    root = by_number[seen_before[-1]]
    if (root.shaft, root.throw) != (cylinder.shaft, cylinder.throw):
        yield Fault(
            here,
            f"works on shaft {seen(cylinder.shaft)} throw {cylinder.throw}, its master on {seen(root.shaft)} throw {root.throw}; "
            "they must be the same",
            cylinder.number,
        )


def _loop(numbers: list[int]) -> str:
    first = numbers[0]
    chain = " on ".join(str(number) for number in [*numbers[:GREATEST_CHAIN], first])
    tell = "on itself" if len(numbers) == 1 else f"in a loop ({chain if len(numbers) <= GREATEST_CHAIN else f'of {len(numbers)}'})"
    return f"cylinder {first} is articulated {tell}; one rod of a group must sit on the crank pin"


def _firing_faults(engine: Engine) -> Iterator[Fault]:
    order, chambers = engine.firing_order, set(engine.chambers)
    path = ("firing_order",)
    if engine.firing_angles is not None and len(engine.firing_angles) != len(order):
        angles, firings = counted(len(engine.firing_angles), "angle"), counted(len(order), "firing")
        yield Fault(("firing_angles",), f"lists {angles} for {firings} in firing_order; give one for each, in the same order")
    if not order:
        return
    repeated = sorted(number for number, count in Counter(order).items() if count > 1)
    foreign, missing = sorted(set(order) - chambers), sorted(chambers - set(order))
    if repeated:
        yield Fault(path, f"has {cylinders(repeated)} more than once; each fires once a cycle")
    if foreign:
        yield Fault(path, f"has {cylinders(foreign)}, and there is no such cylinder; there are: {listed(sorted(chambers))}")
    if missing:
        yield Fault(path, f"misses {cylinders(missing)}; each of {listed(sorted(chambers))} must fire")
