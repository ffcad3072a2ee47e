"""V engines that were found, crank and bank together, as a table, as CSV and as JSON."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from typing import Any

from rich.console import Group, RenderableType
from rich.text import Text

from crankstar.search.vees import ORDERS, Vee, interval_deg
from crankstar.wording import number, table

FORMAT = 1
"""Version of the JSON object."""
UNITS = {"force": "m*r*w^2*A_k", "couple": "m*r*w^2*A_k*a", "left": "m*r*w^2"}


NOTES = (
    "Throws are those of the first bank, from pin 1, clockwise, of one of the cranks with this balance; those of the second",
    "bank are turned clockwise by the split. stars: how many --star counts; cranks: those with their mirror images and reverses.",
    "Forces in m r ω² Aₖ, couples in m r ω² Aₖ a about the middle, greatest over a turn, the rods of a pin in one plane; the",
    "first-order couple with the crank and against it. left: all that counterweights cannot take away, in m r ω² at a rod ratio",
    "of 4, a couple counted at an arm of a. --row N -o FILE writes an engine file.",
)
SPLIT_EXAMPLES = (60.0, 90.0, 72.0)
"""Bank angles (degrees) of which two that need split pins are named to who has not asked for any."""


def vees_table(found: Sequence[Vee], *, limit: int, only_multiples: bool = False) -> RenderableType:
    """The first solutions, best first: bank angle, split, one of the cranks, force and couple order by order, what must stay.

    `only_multiples`: whether no other bank angles were tried than multiples of the firing interval, which is then said.
    """
    heads = ("row", "bank [deg]", "split [deg]", "throws [deg]", "stars", "cranks", *(f"force {order}" for order in ORDERS))
    heads = (*heads, "couple 1 with", "against", *(f"couple {order}" for order in ORDERS[1:]), "left")
    out = table(*heads, left=("throws [deg]",))
    for place, one in enumerate(found[:limit], 1):
        sizes = [vector.greatest for vector in one.force] + list(one.couple[0]) + [vector.greatest for vector in one.couple[1:]]
        angles = (number(one.bank_angle_deg), number(one.pin_split_deg))
        counts = (str(len(one.stars)), str(one.count))
        out.add_row(str(place), *angles, _throws(one), *counts, *(number(size) for size in sizes), number(one.left))
    if not found:
        return Text("No V engine like that fires evenly.")
    return Group(_title(found), Text(), out, Text(), *map(Text, _remarks(found, limit, only_multiples)))


def _title(found: Sequence[Vee]) -> Text:
    one = found[0]
    step = interval_deg(cylinders=one.cylinders, cycle=one.cycle)
    return Text(f"V{one.cylinders}, {one.cycle}, fires every {number(step)} deg", style="bold")


def _remarks(found: Sequence[Vee], limit: int, only_multiples: bool) -> list[str]:
    cranks, different = sum(one.count for one in found), sum(len(one.stars) for one in found)
    balances = f"{len(found)} balance{'s' if len(found) > 1 else ''}"
    told = f"{cranks} crank{'s' if cranks > 1 else ''}, {different} but for mirror images and reversal, with {balances}."
    if limit < len(found):
        told += f" {limit} {'is' if limit == 1 else 'are'} shown; --limit shows more, --csv all."
    return [told, *([_split_pins(found[0])] if only_multiples else []), " ".join(NOTES)]


def _split_pins(one: Vee) -> str:
    """How other bank angles are asked for than the multiples of the firing interval."""
    step = interval_deg(cylinders=one.cylinders, cycle=one.cycle)
    others = [angle for angle in SPLIT_EXAMPLES if abs(angle / step - round(angle / step)) > 1e-9]
    example = ", ".join(f"{angle:g} deg" for angle in others[:2])
    return (
        f"Only bank angles that are multiples of {number(step)} deg were tried; with split pins others fire evenly too: "
        f'--bank "{example}" asks for them.'
    )


def _throws(one: Vee) -> str:
    return ", ".join(number(angle) for angle in one.stars[0])


def vees_csv(found: Sequence[Vee]) -> str:
    """All solutions as CSV, a row for each crank that is not another's mirror image or reversed."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    parts = [(name, order, way) for name in ("force", "couple") for order in ORDERS for way in ("forward", "backward")]
    vectors = [f"{name}_{order}_{way} [{UNITS[name]}]" for name, order, way in parts]
    angles = ["bank_angle [deg]", "pin_split [deg]", "throws [deg]"]
    writer.writerow(["row", "star", *angles, "stars_in_row", "cranks_in_row", *vectors, f"left [{UNITS['left']}]"])
    for place, one in enumerate(found, 1):
        sizes = [size for part in (one.force, one.couple) for vector in part for size in vector]
        for star, throws in enumerate(one.stars, 1):
            here = [one.bank_angle_deg, one.pin_split_deg, " ".join(f"{angle:.10g}" for angle in throws)]
            writer.writerow([place, star, *here, len(one.stars), one.count, *sizes, one.left])
    return out.getvalue()


def vees_tree(found: Sequence[Vee]) -> dict[str, Any]:
    """All solutions as a JSON object; lengths of the vectors with the crank (forward) and against it, by order."""
    return {"format": FORMAT, "units": UNITS, "solutions": [_tree(place, one) for place, one in enumerate(found, 1)]}


def _tree(place: int, one: Vee) -> dict[str, Any]:
    vectors = {
        name: [{"order": order, **vector._asdict()} for order, vector in zip(ORDERS, getattr(one, name), strict=True)]
        for name in ("force", "couple")
    }
    return {
        "row": place,
        "cylinders": one.cylinders,
        "cycle": one.cycle,
        "bank_angle_deg": one.bank_angle_deg,
        "pin_split_deg": one.pin_split_deg,
        "stars": len(one.stars),
        "stars_deg": [list(star) for star in one.stars],
        "cranks": one.count,
        **vectors,
        "counterweights_suffice": one.counterweights_suffice,
        "left": one.left,
    }
