"""Banks of cylinders on crankshafts: their records, and the places of cylinders and pins."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import Annotated

from pydantic import Field

from crankstar.engine.arrangement import Place, ShaftPlace, assembled, repeated_numbers
from crankstar.engine.basis import Basis
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import Angle, Length, Line, Ordinal, Pitch, Position, SpeedRatio
from crankstar.engine.records import GREATEST_CYLINDERS, Record
from crankstar.language.faults import EngineError, Fault


class Bank(Record):
    """A row of cylinders along one crankshaft."""

    bearing: Angle = Field(default=0.0, description="where the cylinders point, clockwise from up")
    cylinders: tuple[Ordinal, ...] = Field(
        min_length=1, max_length=GREATEST_CYLINDERS, description="numbers from front to rear"
    )
    name: Line | None = Field(
        default=None, description="by which results name it; bank 1, bank 2, ... if left out"
    )
    offset: Length | None = Field(
        default=None, description="of this bank's axes, clockwise of the shaft axis"
    )
    set_back: Position | None = Field(
        default=None, description="how far this bank stands behind the first"
    )
    pin_angle: Angle | None = Field(
        default=None, description="how far its pins are turned clockwise from the first bank's"
    )


class Crank(Record):
    """One of several crankshafts, with its banks; the first is the reference crankshaft."""

    name: Line | None = Field(
        default=None, description="by which results name it; crank 1, crank 2, ... if left out"
    )
    up: Length = Field(default=0.0, description="height over the first crankshaft")
    right: Length = Field(
        default=0.0, description="to the right of the first crankshaft, seen from the front"
    )
    speed_ratio: SpeedRatio = Field(
        default=Fraction(1), description="turns per turn of the first; negative turns the other way"
    )
    lag: Angle = Field(
        default=0.0,
        description=(
            "turn of the first crankshaft after which this one's first cylinder is at top "
            "dead centre"
        ),
    )
    banks: tuple[Bank, ...] = Field(
        min_length=1, max_length=32, description="its rows of cylinders"
    )
    throws: tuple[Angle, ...] = Field(
        default=(0.0,), min_length=1, description="from its own pin 1, clockwise"
    )


Throws = Annotated[tuple[Angle, ...], Field(max_length=GREATEST_CYLINDERS)]
Positions = Annotated[
    Annotated[tuple[Position, ...], Field(max_length=GREATEST_CYLINDERS)] | None,
    Field(
        description=(
            "distances of the cylinders of a bank behind its first, where the pitch is not even"
        )
    ),
]
BorePitch = Annotated[
    Pitch | None,
    Field(
        description=(
            "distance of neighbouring cylinders of a bank along the crankshaft; the unit a of "
            "normalised couples"
        )
    ),
]
BankOffset = Annotated[
    Position,
    Field(description="how far each bank stands in front of the next; 0 for fork-and-blade rods"),
]
Banks = Annotated[
    tuple[Bank, ...],
    Field(min_length=1, max_length=32, description="the rows of cylinders, front bank first"),
]
Cranks = Annotated[
    tuple[Crank, ...],
    Field(
        min_length=2, max_length=16, description="the crankshafts, the reference crankshaft first"
    ),
]


def arranged(
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
    faults = repeated_numbers(
        number for crank in cranks for bank in crank.banks for number in bank.cylinders
    )
    repeated = bool(faults)
    for shaft, crank in enumerate(cranks):
        at = ("cranks", shaft) if len(cranks) > 1 and not sharing_chambers else ()
        own = _bank_faults(("layout", *at), crank, positions)
        faults += [each for each in own if not repeated or each.code not in OF_COUNTS]
        if not faults:
            places += _row_places(
                shaft,
                crank,
                bore_pitch=bore_pitch,
                bank_offset=bank_offset,
                pin_split=pin_split,
                positions=positions,
            )
    if faults:
        raise EngineError(faults)
    if sharing_chambers:
        count = len(places) // 2
        places = [replace(place, chamber=(place.number - 1) % count + 1) for place in places]
    shafts = [
        ShaftPlace(
            crank.name or ("crank" if len(cranks) == 1 else f"crank {index}"),
            crank.up,
            crank.right,
            crank.speed_ratio,
            crank.lag,
        )
        for index, crank in enumerate(cranks, 1)
    ]
    pitch = bore_pitch if bore_pitch or positions is None else _least_gap(positions)
    longest = max(len(bank.cylinders) for crank in cranks for bank in crank.banks)
    return assembled(
        basis, places, shafts, pitch=pitch, pitch_needed=longest > 1 and positions is None
    )


OF_COUNTS = (
    "layout.banks-unlike",
    "layout.throws-of-pins",
    "layout.throws-of-cylinders",
    "layout.positions-count",
)
"""Faults that may come from a cylinder that is listed twice."""


def _least_gap(positions: Sequence[float]) -> float | None:
    ordered = sorted(positions)
    return min((b - a for a, b in pairwise(ordered) if b > a), default=None)


def _bank_faults(
    here: tuple[str | int, ...], crank: Crank, positions: Sequence[float] | None
) -> Iterator[Fault]:
    pins = len(crank.banks[0].cylinders)
    cylinders = sum(len(bank.cylinders) for bank in crank.banks)
    for index, bank in enumerate(crank.banks):
        if len(bank.cylinders) != pins:
            values = {"count": len(bank.cylinders), "first": pins}
            yield Fault((*here, "banks", index, "cylinders"), "layout.banks-unlike", values)
    if len(crank.throws) not in (pins, cylinders):
        code = "layout.throws-of-pins" if len(crank.banks) > 1 else "layout.throws-of-cylinders"
        values = {"count": len(crank.throws), "pins": pins, "each": cylinders}
        yield Fault((*here, "throws"), code, values)
    if positions is None:
        return
    if len(positions) != pins:
        values = {"count": len(positions), "pins": pins}
        yield Fault((*here, "positions"), "layout.positions-count", values)
    before = 0.0
    for index, place in enumerate(positions):
        if place < before:
            values = {"value": place, "before": before}
            code = "layout.position-descending" if index else "layout.position-negative"
            yield Fault((*here, "positions", index), code, values)
            return
        before = place


def _row_places(
    shaft: int,
    crank: Crank,
    *,
    bore_pitch: float | None,
    bank_offset: float,
    pin_split: float,
    positions: Sequence[float] | None,
) -> Iterator[Place]:
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
