"""Functions that write Engines the way engineers speak of them: in-line, vee, boxer, radial, tandem, opposed pistons.

Each takes a `Basis` (who the engine is and what its cylinders are like) and the few numbers of the layout, and places
cylinders and pins; everything below sees shafts, throws, weights and cylinders only. Engines are drawn at theta = 0
with cylinder 1 at top dead centre; the middle of the cylinders' span is z = 0. Bearings, and the angles of throws
measured from pin 1, are clockwise seen from the front, whichever way the engine turns.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from math import cos, pi, sin
from typing import Annotated

from pydantic import Field

from crankstar.arrangement import Basis, Place, ShaftPlace, assembled
from crankstar.engine import Engine
from crankstar.fault import EngineError, Fault, listed
from crankstar.phasor import ROUNDING
from crankstar.quantity import Angle, Length, Line, Ordinal, Pitch, Position, Size, SpeedRatio
from crankstar.records import GREATEST_CYLINDERS, Articulation, Record


class Bank(Record):
    """A row of cylinders along one crankshaft."""

    bearing: Angle = Field(default=0.0, description="where the cylinders point, clockwise from up")
    cylinders: tuple[Ordinal, ...] = Field(min_length=1, max_length=GREATEST_CYLINDERS, description="numbers from front to rear")
    name: Line | None = Field(default=None, description="by which results name it; bank 1, bank 2, ... if left out")
    offset: Length | None = Field(default=None, description="of this bank's axes, clockwise of the shaft axis")
    set_back: Position | None = Field(default=None, description="how far this bank stands behind the first")
    pin_angle: Angle | None = Field(default=None, description="how far its pins are turned clockwise from the first bank's")


class Crank(Record):
    """One of several crankshafts, with its banks; the first is the reference crankshaft."""

    name: Line | None = Field(default=None, description="by which results name it; crank 1, crank 2, ... if left out")
    up: Length = Field(default=0.0, description="height over the first crankshaft")
    right: Length = Field(default=0.0, description="to the right of the first crankshaft, seen from the front")
    speed_ratio: SpeedRatio = Field(default=Fraction(1), description="turns per turn of the first; negative turns the other way")
    lag: Angle = Field(
        default=0.0, description="turn of the first crankshaft after which this one's first cylinder is at top dead centre"
    )
    banks: tuple[Bank, ...] = Field(min_length=1, max_length=32, description="its rows of cylinders")
    throws: tuple[Angle, ...] = Field(default=(0.0,), min_length=1, description="from its own pin 1, clockwise")


class Row(Record):
    """A star of cylinders round one crank pin."""

    cylinders: tuple[Ordinal, ...] = Field(min_length=1, max_length=GREATEST_CYLINDERS, description="numbers clockwise")
    bearing: Angle = Field(default=0.0, description="of the first one listed")
    throw: Angle = Field(default=0.0, description="of this row's pin from pin 1, clockwise")
    master: Ordinal | None = Field(default=None, description="the cylinder with the master rod; the first listed if left out")


Throws = Annotated[tuple[Angle, ...], Field(max_length=GREATEST_CYLINDERS)]
Positions = Annotated[
    Annotated[tuple[Position, ...], Field(max_length=GREATEST_CYLINDERS)] | None,
    Field(description="distances of the cylinders of a bank behind its first, where the pitch is not even"),
]
BorePitch = Annotated[
    Pitch | None,
    Field(description="distance of neighbouring cylinders of a bank along the crankshaft; the unit a of normalised couples"),
]
BankOffset = Annotated[Position, Field(description="how far each bank stands in front of the next; 0 for fork-and-blade rods")]
Banks = Annotated[tuple[Bank, ...], Field(min_length=1, max_length=32, description="the rows of cylinders, front bank first")]
Rows = Annotated[tuple[Row, ...], Field(min_length=1, max_length=32, description="the stars, the front one first")]
Cranks = Annotated[
    tuple[Crank, ...], Field(min_length=2, max_length=16, description="the crankshafts, the reference crankshaft first")
]


def inline(
    basis: Basis,
    *,
    throws: Annotated[
        Throws | None,
        Field(description="from pin 1, clockwise, front to rear; left out, evenly spaced ones as the firing order needs"),
    ] = None,
    bearing: Annotated[Angle, Field(description="where the cylinders point, clockwise from up: a slanted or a lying engine")] = 0.0,
    bore_pitch: BorePitch = None,
    positions: Positions = None,
) -> Engine:
    """Cylinders 1, 2, ... in a row from front to rear, one throw each.

    `throws` from pin 1, clockwise; left out, the evenly spaced ones that the firing order needs. `positions`: distances
    behind cylinder 1 where the pitch is not even.

    >>> three = inline(Basis(name="triple", cycle="two-stroke", firing_order=(1, 3, 2)))
    >>> [round(throw.angle * 180 / pi) for throw in three.shafts[0].throws]  # pin 3 follows by 120 deg
    [0, 120, -120]
    """
    if throws is None:
        order = basis.firing_order
        if not order or sorted(order) != list(range(1, len(order) + 1)):
            message = "is missing; give it, or a firing_order of cylinders 1, 2, ... from which evenly spaced throws follow"
            raise _fault("throws", message)
        throws = _even_throws(basis, order)
    if basis.firing_order and len(basis.firing_order) != len(throws):
        told = f"has {len(throws)} angles, but {len(basis.firing_order)} cylinders fire; give one angle for each cylinder"
        raise _fault("throws", told)
    bank = Bank(bearing=bearing, cylinders=tuple(range(1, len(throws) + 1)))
    return vee(basis, banks=(bank,), throws=throws, bore_pitch=bore_pitch, positions=positions)


def _even_throws(basis: Basis, order: Sequence[int]) -> tuple[float, ...]:
    """Pins that reach top dead centre one after the other in the firing order, evenly over the cycle."""
    sense = 1 if basis.rotation == "clockwise" else -1
    turns = 1 if basis.cycle == "two-stroke" else 2
    angles = {number: -sense * 2 * pi * ((turns * place / len(order)) % 1) for place, number in enumerate(order)}
    return tuple((angles[number] - angles[1]) % (2 * pi) for number in sorted(angles))


def vee(
    basis: Basis,
    *,
    banks: Banks,
    throws: Annotated[
        Throws, Field(description="from pin 1, clockwise: one for each pin of a bank, or one for each cylinder by its number")
    ],
    bore_pitch: BorePitch = None,
    bank_offset: BankOffset = 0.0,
    pin_split: Annotated[
        Angle, Field(description="split pins: how far the pins of each bank are turned clockwise from those of the bank before")
    ] = 0.0,
    positions: Positions = None,
) -> Engine:
    """Any number of banks on one crankshaft: V, VR, W, X, flat.

    As many `throws` as a bank has cylinders: the k-th cylinder of each bank shares pin k; `pin_split` turns the pins of each
    further bank clockwise by that much (split pins), a bank's own `pin_angle` more exactly. As many throws as there are
    cylinders: one each, by cylinder number. `bank_offset`: how far each bank stands in front of the next.
    """
    crank = Crank(banks=banks, throws=throws)
    return _arranged(basis, (crank,), bore_pitch=bore_pitch, bank_offset=bank_offset, pin_split=pin_split, positions=positions)


def boxer(
    basis: Basis,
    *,
    banks: Banks,
    throws: Annotated[Throws, Field(description="of the first bank, from pin 1, clockwise")],
    bore_pitch: BorePitch = None,
    bank_offset: BankOffset = 0.0,
    positions: Positions = None,
) -> Engine:
    """Two banks opposite each other whose pistons move in and out together: each pair on two pins 180 deg apart.

    `throws` are those of the first bank. (A 180 deg V, with shared pins, is a `vee`.)
    """
    if len(banks) != 2:
        raise _fault("banks", f"a boxer has two banks, opposite each other; here are {len(banks)}")
    if len(throws) != len(banks[0].cylinders):
        told = (
            f"has {len(throws)} angles; give {len(banks[0].cylinders)}, the pins of the first bank (the second bank's are opposite)"
        )
        raise _fault("throws", told)
    return vee(basis, banks=banks, throws=throws, bore_pitch=bore_pitch, bank_offset=bank_offset, pin_split=pi, positions=positions)


def tandem(
    basis: Basis, *, cranks: Cranks, bore_pitch: BorePitch = None, bank_offset: BankOffset = 0.0, positions: Positions = None
) -> Engine:
    """Several crankshafts geared together, each with its banks: tandem twins, U, square four, H, delta."""
    return _arranged(basis, cranks, bore_pitch=bore_pitch, bank_offset=bank_offset, pin_split=0.0, positions=positions)


def opposed(
    basis: Basis,
    *,
    throws: Annotated[Throws, Field(description="of the first crankshaft, from its pin 1, clockwise, one for each cylinder")],
    crank_distance: Annotated[Size, Field(description="from the first crankshaft to the second")],
    lag: Annotated[Angle, Field(description="turn of the first crankshaft by which the second follows")] = 0.0,
    speed_ratio: Annotated[SpeedRatio, Field(description="of the second crankshaft; -1 if it turns the other way")] = Fraction(1),
    bearing: Annotated[Angle, Field(description="where the second crankshaft stands from the first, clockwise from up")] = 0.0,
    bore_pitch: BorePitch = None,
    positions: Positions = None,
) -> Engine:
    """Two pistons in each cylinder, working on crankshafts at its two ends.

    Cylinder k has piston k on the first crankshaft and piston n + k on the second, which stands `crank_distance` away at
    `bearing` from the first and follows it by `lag`. The pistons of the first point towards the second.
    """
    count = len(throws)
    first = Bank(bearing=bearing, cylinders=tuple(range(1, count + 1)), name="first crankshaft")
    second = Bank(bearing=bearing + pi, cylinders=tuple(range(count + 1, 2 * count + 1)), name="second crankshaft")
    up, right = crank_distance * cos(bearing), crank_distance * sin(bearing)
    other = -1 if speed_ratio < 0 else 1
    cranks = (
        Crank(name="first", banks=(first,), throws=throws),
        Crank(
            name="second",
            banks=(second,),
            throws=tuple(other * angle for angle in throws),
            speed_ratio=speed_ratio,
            lag=lag,
            up=_exact(up, crank_distance),
            right=_exact(right, crank_distance),
        ),
    )
    return _arranged(
        basis, cranks, bore_pitch=bore_pitch, bank_offset=0.0, pin_split=0.0, positions=positions, sharing_chambers=True
    )


def _exact(part: float, whole: float) -> float:
    """A component of a length without what rounding left of cos 90 deg."""
    return 0.0 if abs(part) < ROUNDING * whole else part


def radial(
    basis: Basis,
    *,
    rows: Rows,
    row_pitch: Annotated[
        Pitch | None, Field(description="distance of neighbouring rows along the crankshaft; the unit a of normalised couples")
    ] = None,
    knuckle_radius: Annotated[
        Size | None, Field(description="from crank pin to the knuckle pins of slave rods; left out, all rods sit on the crank pin")
    ] = None,
    slave_rod_length: Annotated[
        Size | None, Field(description="between centres; the master's rod less the knuckle radius if left out")
    ] = None,
) -> Engine:
    """Stars of evenly spaced cylinders round a crank pin, the numbers of each row clockwise.

    With `knuckle_radius` each row has a master rod, and slave rods on knuckle pins as far from it, seen from the crank
    pin, as their cylinders are; slave rods are shorter by the knuckle radius unless `slave_rod_length` says otherwise.
    Without it all rods sit on the crank pin itself.
    """
    places: list[Place] = []
    for index, row in enumerate(rows):
        master = row.cylinders[0] if row.master is None else row.master
        if master not in row.cylinders:
            message = f"is {master}, and there is no such cylinder in the row; there are: {listed(list(row.cylinders))}"
            raise _fault("rows", message, index, "master")
        step = 2 * pi / len(row.cylinders)
        for slot, number in enumerate(row.cylinders):
            link = None
            if knuckle_radius is not None and number != master:
                link = Articulation(master=master, radius=knuckle_radius, angle=(slot - row.cylinders.index(master)) * step)
            places.append(
                Place(
                    number,
                    shaft=0,
                    pin=index,
                    pin_angle=row.throw,
                    bearing=row.bearing + slot * step,
                    z=-index * (row_pitch if row_pitch is not None else 1.0),
                    bank=f"row {index + 1}",
                    articulated=link,
                    slave_rod_length=slave_rod_length,
                )
            )
    return assembled(basis, places, [ShaftPlace()], pitch=row_pitch)


def _arranged(
    basis: Basis,
    cranks: Sequence[Crank],
    *,
    bore_pitch: float | None,
    bank_offset: float,
    pin_split: float,
    positions: Sequence[float] | None,
    sharing_chambers: bool = False,
) -> Engine:
    """Banks on crankshafts, placed pin by pin."""
    places: list[Place] = []
    faults: list[Fault] = []
    for shaft, crank in enumerate(cranks):
        at = ("cranks", shaft) if len(cranks) > 1 and not sharing_chambers else ()
        faults += [Fault(("layout", *at, *path), message) for path, message in _bank_faults(crank, positions)]
        if not faults:
            places += _row_places(
                shaft, crank, bore_pitch=bore_pitch, bank_offset=bank_offset, pin_split=pin_split, positions=positions
            )
    if faults:
        raise EngineError(faults)
    if sharing_chambers:
        count = len(places) // 2
        places = [replace(place, chamber=(place.number - 1) % count + 1) for place in places]
    shafts = [
        ShaftPlace(
            crank.name or ("crank" if len(cranks) == 1 else f"crank {index}"), crank.up, crank.right, crank.speed_ratio, crank.lag
        )
        for index, crank in enumerate(cranks, 1)
    ]
    pitch = bore_pitch if positions is None else _least_gap(positions)
    longest = max(len(bank.cylinders) for crank in cranks for bank in crank.banks)
    return assembled(basis, places, shafts, pitch=pitch, pitch_needed=longest > 1 and positions is None)


def _least_gap(positions: Sequence[float]) -> float | None:
    ordered = sorted(positions)
    return min((b - a for a, b in pairwise(ordered) if b > a), default=None)


def _bank_faults(crank: Crank, positions: Sequence[float] | None) -> Iterable[tuple[tuple[str | int, ...], str]]:
    lengths = [len(bank.cylinders) for bank in crank.banks]
    numbers = [number for bank in crank.banks for number in bank.cylinders]
    for index, length in enumerate(lengths):
        if length != lengths[0]:
            yield ("banks", index, "cylinders"), f"lists {length} cylinders, the first bank {lengths[0]}; banks must be alike"
    if len(crank.throws) not in (lengths[0], len(numbers)):
        shared = f"{lengths[0]} (one for each pin) or " if len(crank.banks) > 1 else ""
        yield ("throws",), f"has {len(crank.throws)} angles; give {shared}{len(numbers)} (one for each cylinder)"
    if positions is not None and len(positions) != lengths[0]:
        yield ("positions",), f"has {len(positions)} places; give {lengths[0]}, one for each cylinder of a bank"


def _row_places(
    shaft: int, crank: Crank, *, bore_pitch: float | None, bank_offset: float, pin_split: float, positions: Sequence[float] | None
) -> Iterable[Place]:
    pitch = 1.0 if bore_pitch is None else bore_pitch
    by_number = sorted(number for bank in crank.banks for number in bank.cylinders)
    shared = len(crank.throws) == len(crank.banks[0].cylinders)
    for index, bank in enumerate(crank.banks):
        split = bank.pin_angle if bank.pin_angle is not None else index * pin_split
        set_back = bank.set_back if bank.set_back is not None else index * bank_offset
        for slot, number in enumerate(bank.cylinders):
            own = by_number.index(number)
            yield Place(
                number,
                shaft=shaft,
                # Pins that are not turned against each other are one pin.
                pin=(slot if split == 0 else slot + (index + 1) * 10_000) if shared else own,
                pin_angle=crank.throws[slot] + split if shared else crank.throws[own],
                bearing=bank.bearing,
                z=-(positions[slot] if positions is not None else slot * pitch) - set_back,
                bank=bank.name,
                offset=bank.offset,
            )


def _fault(key: str, message: str, *rest: str | int, at: str = "layout") -> EngineError:
    return EngineError([Fault((*([at] if at else []), key, *rest), message)])


LAYOUTS: dict[str, Callable[..., Engine]] = {
    function.__name__: function for function in (inline, vee, boxer, tandem, opposed, radial)
}
"""The layouts of short engine files, by the name that `layout.type` gives them."""
