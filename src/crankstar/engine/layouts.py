"""Layouts as functions: in-line, vee, boxer, radial, tandem, opposed pistons.

Each takes a `Basis` (who the engine is and what its cylinders are like) and the few numbers of the
layout, and places cylinders and pins; everything below sees shafts, throws, weights and cylinders
only. Engines are drawn at theta = 0 with cylinder 1 at top dead centre; the middle of the
cylinders' span is z = 0. Bearings, and the angles of throws measured from pin 1, are clockwise seen
from the front, whichever way the engine turns.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from math import cos, pi, sin
from types import MappingProxyType
from typing import Annotated, Any, ClassVar

from pydantic import Field

from crankstar.engine.added_layouts import added_layouts
from crankstar.engine.arrangement import Place, ShaftPlace, assembled
from crankstar.engine.banks import (
    Bank,
    BankOffset,
    Banks,
    BorePitch,
    Crank,
    Cranks,
    Positions,
    Throws,
    arranged,
)
from crankstar.engine.basis import Basis
from crankstar.engine.checks import order_faults
from crankstar.engine.engine import Engine
from crankstar.engine.packages import PackageError
from crankstar.engine.quantities import Angle, Ordinal, Pitch, Size, SpeedRatio
from crankstar.engine.records import GREATEST_CYLINDERS, Articulation, Record
from crankstar.language.faults import EngineError, Fault
from crankstar.spectra import ROUNDING


class Row(Record):
    """A star of cylinders round one crank pin."""

    cylinders: tuple[Ordinal, ...] = Field(
        min_length=1, max_length=GREATEST_CYLINDERS, description="numbers clockwise"
    )
    bearing: Angle = Field(default=0.0, description="of the first one listed")
    throw: Angle = Field(default=0.0, description="of this row's pin from pin 1, clockwise")
    master: Ordinal | None = Field(
        default=None, description="the cylinder with the master rod; the first listed if left out"
    )


Rows = Annotated[
    tuple[Row, ...],
    Field(min_length=1, max_length=32, description="the stars, the front one first"),
]


def inline(
    basis: Basis,
    *,
    throws: Annotated[
        Throws | None,
        Field(
            description=(
                "from pin 1, clockwise, front to rear; left out, evenly spaced ones as the "
                "firing order needs"
            )
        ),
    ] = None,
    bearing: Annotated[
        Angle,
        Field(
            description="where the cylinders point, clockwise from up: a slanted or a lying engine"
        ),
    ] = 0.0,
    bore_pitch: BorePitch = None,
    positions: Positions = None,
) -> Engine:
    """Cylinders 1, 2, ... in a row from front to rear, one throw each.

    `throws` from pin 1, clockwise; left out, the evenly spaced ones that the firing order needs.
    `positions`: distances behind cylinder 1 where the pitch is not even.

    >>> three = inline(Basis(name="triple", cycle="two-stroke", firing_order=(1, 3, 2)))
    >>> [round(throw.angle * 180 / pi) for throw in three.shafts[0].throws]  # pin 3 is next
    [0, 120, -120]
    """
    if throws is not None and not throws:
        raise _refused("throws", code="throws-missing")
    if throws is None:
        throws = _even_throws(basis, _numbered(basis.firing_order))
    bank = Bank(bearing=bearing, cylinders=tuple(range(1, len(throws) + 1)))
    return vee(basis, banks=(bank,), throws=throws, bore_pitch=bore_pitch, positions=positions)


def _numbered(order: Sequence[int]) -> Sequence[int]:
    """A firing order of cylinders 1, 2, ..., from which throws follow. Raises EngineError."""
    if not order:
        raise _refused("throws", code="throws-missing")
    last = max(order)
    chambers = range(1, 1 + (last if 0 < last <= GREATEST_CYLINDERS else len(order)))
    if faults := list(order_faults(order, set(chambers))):
        raise EngineError(faults)
    return order


def _even_throws(basis: Basis, order: Sequence[int]) -> tuple[float, ...]:
    """Pins that reach top dead centre in the firing order, evenly over the cycle."""
    sense = 1 if basis.rotation == "clockwise" else -1
    turns = 1 if basis.cycle == "two-stroke" else 2
    angles = {
        number: -sense * 2 * pi * ((turns * index / len(order)) % 1)
        for index, number in enumerate(order)
    }
    return tuple((angles[number] - angles[1]) % (2 * pi) for number in sorted(angles))


def vee(
    basis: Basis,
    *,
    banks: Banks,
    throws: Annotated[
        Throws,
        Field(
            description=(
                "from pin 1, clockwise: one for each pin of a bank, or one for each cylinder "
                "by its number"
            )
        ),
    ],
    bore_pitch: BorePitch = None,
    bank_offset: BankOffset = 0.0,
    pin_split: Annotated[
        Angle,
        Field(
            description=(
                "split pins: how far the pins of each bank are turned clockwise from those of "
                "the bank before"
            )
        ),
    ] = 0.0,
    positions: Positions = None,
) -> Engine:
    """Any number of banks on one crankshaft: V, VR, W, X, flat.

    As many `throws` as a bank has cylinders: the k-th cylinder of each bank shares pin k;
    `pin_split` turns the pins of each further bank clockwise by that much (split pins), a bank's
    own `pin_angle` more exactly. As many throws as there are cylinders: one each, by cylinder
    number. `bank_offset`: how far each bank stands in front of the next.
    """
    crank = Crank(banks=banks, throws=throws)
    return arranged(
        basis,
        (crank,),
        bore_pitch=bore_pitch,
        bank_offset=bank_offset,
        pin_split=pin_split,
        positions=positions,
    )


def boxer(
    basis: Basis,
    *,
    banks: Banks,
    throws: Annotated[Throws, Field(description="of the first bank, from pin 1, clockwise")],
    bore_pitch: BorePitch = None,
    bank_offset: BankOffset = 0.0,
    positions: Positions = None,
) -> Engine:
    """Two opposed banks whose pistons move in and out together, each pair on pins 180 deg apart.

    `throws` are those of the first bank. (A 180 deg V, with shared pins, is a `vee`.)
    """
    if len(banks) != 2:
        raise _refused("banks", code="boxer-banks", values={"count": len(banks)})
    if len(throws) != len(banks[0].cylinders):
        values = {"count": len(throws), "pins": len(banks[0].cylinders)}
        raise _refused("throws", code="boxer-throws", values=values)
    return vee(
        basis,
        banks=banks,
        throws=throws,
        bore_pitch=bore_pitch,
        bank_offset=bank_offset,
        pin_split=pi,
        positions=positions,
    )


def tandem(
    basis: Basis,
    *,
    cranks: Cranks,
    bore_pitch: BorePitch = None,
    bank_offset: BankOffset = 0.0,
    positions: Positions = None,
) -> Engine:
    """Several geared crankshafts, each with its banks: tandem twins, U, square four, H, delta."""
    return arranged(
        basis,
        cranks,
        bore_pitch=bore_pitch,
        bank_offset=bank_offset,
        pin_split=0.0,
        positions=positions,
    )


def opposed(
    basis: Basis,
    *,
    throws: Annotated[
        Throws,
        Field(
            description="of the first crankshaft, from its pin 1, clockwise, one for each cylinder"
        ),
    ],
    crank_distance: Annotated[Size, Field(description="from the first crankshaft to the second")],
    lag: Annotated[
        Angle, Field(description="turn of the first crankshaft by which the second follows")
    ] = 0.0,
    speed_ratio: Annotated[
        SpeedRatio, Field(description="of the second crankshaft; -1 if it turns the other way")
    ] = Fraction(1),
    bearing: Annotated[
        Angle,
        Field(description="where the second crankshaft stands from the first, clockwise from up"),
    ] = 0.0,
    bore_pitch: BorePitch = None,
    positions: Positions = None,
) -> Engine:
    """Two pistons in each cylinder, working on crankshafts at its two ends.

    Cylinder k has piston k on the first crankshaft and piston n + k on the second, which stands
    `crank_distance` away at `bearing` from the first and follows it by `lag`. The pistons of the
    first point towards the second.
    """
    count = len(throws)
    first = Bank(bearing=bearing, cylinders=tuple(range(1, count + 1)), name="first crankshaft")
    second = Bank(
        bearing=bearing + pi,
        cylinders=tuple(range(count + 1, 2 * count + 1)),
        name="second crankshaft",
    )
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
    return arranged(
        basis,
        cranks,
        bore_pitch=bore_pitch,
        bank_offset=0.0,
        pin_split=0.0,
        positions=positions,
        sharing_chambers=True,
    )


def _exact(part: float, whole: float) -> float:
    """A component of a length without what rounding left of cos 90 deg."""
    return 0.0 if abs(part) < ROUNDING * whole else part


def radial(
    basis: Basis,
    *,
    rows: Rows,
    row_pitch: Annotated[
        Pitch | None,
        Field(
            description=(
                "distance of neighbouring rows along the crankshaft; the unit a of normalised "
                "couples"
            )
        ),
    ] = None,
    knuckle_radius: Annotated[
        Size | None,
        Field(
            description=(
                "from crank pin to the knuckle pins of slave rods; left out, all rods sit on "
                "the crank pin"
            )
        ),
    ] = None,
    slave_rod_length: Annotated[
        Size | None,
        Field(description="between centres; the master's rod less the knuckle radius if left out"),
    ] = None,
) -> Engine:
    """Stars of evenly spaced cylinders round a crank pin, the numbers of each row clockwise.

    With `knuckle_radius` each row has a master rod, and slave rods on knuckle pins as far from it,
    seen from the crank pin, as their cylinders are; slave rods are shorter by the knuckle radius
    unless `slave_rod_length` says otherwise. Without it all rods sit on the crank pin itself.
    """
    places: list[Place] = []
    for index, row in enumerate(rows):
        master = row.cylinders[0] if row.master is None else row.master
        if master not in row.cylinders:
            values = {"value": master, "numbers": list(row.cylinders)}
            raise _refused("rows", index, "master", code="master-elsewhere", values=values)
        step = 2 * pi / len(row.cylinders)
        for slot, number in enumerate(row.cylinders):
            link = None
            if knuckle_radius is not None and number != master:
                link = Articulation(
                    master=master,
                    radius=knuckle_radius,
                    angle=(slot - row.cylinders.index(master)) * step,
                )
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


def _refused(
    *path: str | int, code: str, values: Mapping[str, Any] = MappingProxyType({})
) -> EngineError:
    return EngineError([Fault(("layout", *path), f"layout.{code}", values)])


class Layouts(Mapping[str, Callable[..., Engine]]):
    """Layouts by name: those of this module, then those that other packages add.

    Another package adds one by an entry point of the group `crankstar.layouts`, whose name is that
    of `layout.type`; these are looked for only where a name is none of this module, and those that
    cannot be used are skipped.
    """

    _own: ClassVar[dict[str, Callable[..., Engine]]] = {
        function.__name__: function for function in (inline, vee, boxer, tandem, opposed, radial)
    }
    _others = added_layouts([*_own])

    def __getitem__(self, name: str) -> Callable[..., Engine]:
        """The layout of a name. Raises PackageError for one that cannot be used, or KeyError."""
        return self._own[name] if name in self._own else self._others[name]

    def __contains__(self, name: object) -> bool:
        """Whether there is a layout of that name that can be used."""
        try:
            return isinstance(name, str) and self[name] is not None
        except (KeyError, PackageError):
            return False

    def __iter__(self) -> Iterator[str]:
        """The names, those of this module first."""
        yield from self._own
        yield from self._others.usable()

    def __len__(self) -> int:
        """How many there are."""
        return sum(1 for _name in self)

    def why_not(self, name: str) -> str:
        """Why what a package adds under this name cannot be used; empty where nothing is wrong."""
        try:
            self.get(name)
        except PackageError as error:
            return str(error)
        return ""


LAYOUTS = Layouts()
"""The layouts of short engine files, by the name that `layout.type` gives them."""
