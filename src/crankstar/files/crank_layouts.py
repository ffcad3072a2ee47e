"""Layout tables for another number of cylinders: which cranks an engine of a kind can have.

Each function takes the layout table of an engine file and returns it for a number of cylinders,
once for every crank that is worth an offer, the one to begin with first. Sizes, offsets, names and
sides of banks stay. Angles are written in degrees.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import islice
from math import degrees
from typing import Any, NamedTuple

from crankstar.engine.copies import wrapped
from crankstar.engine.engine import Engine
from crankstar.firing.rows import UNEVEN, row_cranks
from crankstar.firing.vees import GREATEST_VEE, vees

Table = dict[str, Any]
GREATEST_ROW = 16
"""Cylinders of one row: beyond that nobody builds them, and there are too many cranks."""
GREATEST_BOXER = 20
"""Cylinders of a boxer: each pair of them doubles the number of firing orders."""
GREATEST_SPLIT = 60.0
"""Degrees up to which pins are split: what is left of the pin must still carry the load."""
OFFERED = 5
"""Cranks of a V engine at one bank angle."""
OTHER_BANK_ANGLES = (45.0, 60.0, 72.0, 90.0, 120.0, 180.0)
"""Bank angles, degrees, that are offered where they fire evenly without split pins."""
ONE = 1e-6


class Kind(NamedTuple):
    """How an engine's cylinders are counted: so many more at a time, up to so many."""

    step: int
    greatest: int


def kind_of(layout: Mapping[str, Any], cycle: str) -> Kind:
    """The step of the number of cylinders of a layout, and the greatest number."""
    match layout.get("type"):
        case "boxer":
            return Kind(2, GREATEST_BOXER)
        case "vee":
            banks = len(layout.get("banks", ()))
            return Kind(banks, GREATEST_ROW * banks)
        case "tandem":
            rows = sum(len(crank.get("banks", ())) for crank in layout.get("cranks", ()))
            return Kind(rows, GREATEST_ROW * rows)
        case "radial":
            rows = len(layout.get("rows", ()))
            # an even number on one pin cannot fire evenly in a four-stroke engine
            return Kind(2 * rows if cycle == "four-stroke" else rows, 11 * rows)
    return Kind(1, GREATEST_ROW)


def layouts_for(engine: Engine, layout: Mapping[str, Any], *, count: int) -> Iterator[Table]:
    """The layouts of an engine with so many combustion chambers, the first to begin with."""
    makers: dict[str, Callable[..., Iterator[Table]]] = {
        "inline": _inline,
        "opposed": _inline,
        "vee": _vee,
        "boxer": _boxer,
        "tandem": _tandem,
        "radial": _radial,
    }
    kept = {key: value for key, value in layout.items() if key != "positions"}
    if "positions" in layout and "pitch" not in engine.relative and engine.bore_pitch:
        kept["bore_pitch"] = f"{1000 * engine.bore_pitch:.9g} mm"
    yield from makers[layout["type"]](engine, kept, count)


def _angles(throws: Sequence[float], *, mirrored: bool = False) -> list[str]:
    return [_angle(-angle if mirrored else angle) for angle in throws]


def _angle(value: float) -> str:
    turned = value - 360.0 * -(-(value - 180.0) // 360.0)
    return f"{round(turned, 6) + 0.0:.9g} deg"


def _rows(engine: Engine, count: int, *, lone: bool = False) -> Iterator[list[str]]:
    """Throws of one row: even ones, then uneven ones that are built; none of longer rows.

    Two pins of an engine that has more than a `lone` row stand opposite each other at first.
    """
    backwards = engine.sense < 0
    if count > GREATEST_ROW:
        return
    if count == 2 and not lone:
        yield _angles((0.0, 180.0))
    for crank in row_cranks(cylinders=count, cycle=engine.cycle):
        yield _angles(crank.throws_deg, mirrored=backwards)
    if engine.cycle == "four-stroke":
        for throws in UNEVEN.get(count, ()):
            yield _angles(throws, mirrored=backwards)


def _inline(engine: Engine, layout: Table, count: int) -> Iterator[Table]:
    for throws in _rows(engine, count, lone=True):
        yield {**layout, "throws": throws}


def _numbered(layout: Mapping[str, Any], pins: int) -> list[list[int]]:
    """The numbers of each bank: along one bank after the other, or from side to side."""
    banks = layout["banks"]
    first = banks[0]["cylinders"]
    along = len(first) > 1 and abs(first[1] - first[0]) == 1
    return [
        [bank * pins + slot + 1 if along else slot * len(banks) + bank + 1 for slot in range(pins)]
        for bank in range(len(banks))
    ]


def _banks(layout: Mapping[str, Any], pins: int, *, plain: bool = True) -> list[Table]:
    """The banks with so many cylinders each; `plain`: their pins stand as those of the first."""
    return [
        {
            **{key: value for key, value in bank.items() if not (plain and key == "pin_angle")},
            "cylinders": numbers,
        }
        for bank, numbers in zip(layout["banks"], _numbered(layout, pins), strict=True)
    ]


def _boxer(engine: Engine, layout: Table, count: int) -> Iterator[Table]:
    pins = count // 2
    if pins > GREATEST_ROW:
        return
    for crank in islice(row_cranks(cylinders=pins, cycle="two-stroke"), 3):
        throws = _angles(crank.throws_deg, mirrored=engine.sense < 0)
        yield {**layout, "banks": _banks(layout, pins), "throws": throws}


def _vee(engine: Engine, layout: Table, count: int) -> Iterator[Table]:
    """Cranks of V engines that fire evenly at the bank angle, shared pins, other bank angles."""
    count_of_banks = len(layout["banks"])
    pins = count // count_of_banks
    bare = {key: value for key, value in layout.items() if key != "pin_split"}
    bare["banks"] = _banks(layout, pins)
    shared = ({**bare, "throws": throws} for throws in _rows(engine, pins))
    if count_of_banks != 2 or count > GREATEST_VEE:
        yield from shared
        return
    angle = bank_angle_deg(engine, layout)
    split = "pin_split" in layout or len(layout.get("throws", ())) == 2 * len(
        layout["banks"][0]["cylinders"]
    )
    greatest = 180.0 if split else GREATEST_SPLIT
    if ONE < abs(angle) <= 180:
        yield from _even_vees(engine, bare, count, angle, greatest)
    yield from islice(shared, 2)
    interval = (360.0 if engine.cycle == "two-stroke" else 720.0) / count
    for other in OTHER_BANK_ANGLES:
        whole = abs(other / interval - round(other / interval)) < ONE
        if whole and abs(other - abs(angle)) > ONE:
            turned = with_bank_angle(engine, bare, other if angle > 0 else -other)
            yield from islice(_even_vees(engine, turned, count, other, 0.0, sign=angle), 1)


def _even_vees(
    engine: Engine,
    layout: Table,
    count: int,
    angle: float,
    greatest_split: float,
    *,
    sign: float | None = None,
) -> Iterator[Table]:
    """Evenly firing V engines at a bank angle (degrees; negative: the first bank at the left)."""
    left = (angle if sign is None else sign) < 0
    found = vees(cylinders=count, bank_angles_deg=(abs(angle),), cycle=engine.cycle)
    few = [vee for vee in found if abs(vee.pin_split_deg) <= greatest_split + ONE]
    for vee in few[:OFFERED]:
        table = {**layout, "throws": _angles(vee.stars[0], mirrored=left)}
        if abs(vee.pin_split_deg) > ONE:
            table["pin_split"] = _angle(-vee.pin_split_deg if left else vee.pin_split_deg)
        yield table


def bank_angle_deg(engine: Engine, layout: Mapping[str, Any]) -> float:
    """The angle of the first of two banks clockwise from the second, degrees, -180 to 180."""
    bearings = [
        next(c.bearing for c in engine.cylinders if c.number == bank["cylinders"][0])
        for bank in layout["banks"][:2]
    ]
    return degrees(wrapped(bearings[0] - bearings[1]))


def with_bank_angle(engine: Engine, layout: Table, angle: float) -> Table:
    """The layout whose two banks stand at this angle, the middle between them where it was."""
    first, second = layout["banks"]
    there = next(c.bearing for c in engine.cylinders if c.number == second["cylinders"][0])
    middle = degrees(there) + bank_angle_deg(engine, layout) / 2
    return {
        **layout,
        "banks": [
            {**first, "bearing": _angle(middle + angle / 2)},
            {**second, "bearing": _angle(middle - angle / 2)},
        ],
    }


def _tandem(engine: Engine, layout: Table, count: int) -> Iterator[Table]:
    cranks = layout["cranks"]
    rows = sum(len(crank["banks"]) for crank in cranks)
    pins = count // rows
    for throws in _rows(engine, pins):
        first, changed = 1, []
        for crank in cranks:
            ratio = crank.get("speed_ratio", 1)
            back = str(ratio).strip().startswith("-")
            banks = []
            for bank in crank["banks"]:
                banks.append({**bank, "cylinders": list(range(first, first + pins))})
                first += pins
            own = [_angle(-float(angle.split()[0])) for angle in throws] if back else throws
            changed.append({**crank, "banks": banks, "throws": own})
        yield {**layout, "cranks": changed}


def _radial(_engine: Engine, layout: Table, count: int) -> Iterator[Table]:
    rows = layout["rows"]
    each = count // len(rows)
    listed = rows[0]["cylinders"]
    backwards = len(rows) == 1 and len(listed) > 2 and listed[1] == max(listed)
    changed = []
    for index, row in enumerate(rows):
        along = len(rows) == 1 or row["cylinders"][1:2] == [row["cylinders"][0] + 1]
        numbers = [
            index * each + slot + 1 if along else slot * len(rows) + index + 1
            for slot in range(each)
        ]
        if backwards:
            numbers = [numbers[0], *numbers[:0:-1]]
        own = {key: value for key, value in row.items() if key != "master"}
        if index and row.get("bearing") is not None:
            own["bearing"] = _angle(360.0 * index / each / len(rows))
        if row.get("master") in numbers:
            own["master"] = row["master"]
        changed.append({**own, "cylinders": numbers})
    yield {**layout, "rows": changed}
