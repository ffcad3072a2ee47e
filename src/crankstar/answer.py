"""The machine-readable answers: a Balance as the public JSON object, versioned, and as CSV; the strokes as JSON."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from math import degrees, pi
from typing import Any

import numpy as np

from crankstar import phasor
from crankstar.balance import Balance, total
from crankstar.engine import Engine
from crankstar.mechanism import Totals
from crankstar.phasor import Spectrum
from crankstar.strokes import (
    ChamberStrokes,
    ExhaustGroup,
    WorkingCycle,
    disturbances,
    exhaust_groups,
    exhaust_intervals,
    working_cycle,
)
from crankstar.succession import in_succession, neighbours, partners
from crankstar.valves import EVENTS

FORMAT = 1
GREATEST_DEFAULT_ORDER = 6.0
SIGNIFICANT = 1e-9


def orders_present(result: Balance, *, highest: float = GREATEST_DEFAULT_ORDER) -> tuple[float, ...]:
    """The orders up to `highest` at which any part pushes, even where the sum of all is nothing; at least the first."""
    sizes = [_sizes(spectrum) for spectrum in (result.force, result.couple, result.roll)]
    shown = np.any([size > SIGNIFICANT * size.max(initial=0.0) for size in sizes], axis=0)
    return tuple(result.force.orders[shown & (result.force.orders <= highest)].tolist()) or (1.0,)


def _sizes(spectrum: Spectrum) -> np.ndarray:
    return (np.abs(spectrum.forward) + np.abs(spectrum.backward)).max(axis=0, initial=0.0)


def tree(name: str, result: Balance, *, orders: Sequence[float] | None = None) -> dict[str, Any]:
    """The public JSON object. Pairs are [up, right] for force and couple, [real, imaginary] of Re(c exp(i k theta)) for roll.

    Without a speed, or for an engine without masses or sizes, `speed_rpm` is null and the units are those of m r w^2.
    """
    wanted = tuple(orders) if orders else orders_present(result)
    sums = Totals(*(phasor.selected(spectrum, wanted) for spectrum in total(result)))
    out: dict[str, Any] = {
        "format": FORMAT,
        "engine": name,
        "speed_rpm": None if result.speed is None else float(f"{result.speed * 30 / pi:.12g}"),
        "reference_z": result.reference.z,
    }
    if result.reference.up or result.reference.right:
        out |= {"reference_up": result.reference.up, "reference_right": result.reference.right}
    out["units"] = result.units._asdict()
    out["orders"] = [
        {
            "order": order,
            "force": {"forward": _pair(sums.force.forward[i]), "backward": _pair(sums.force.backward[i])},
            "couple": {"forward": _pair(sums.couple.forward[i]), "backward": _pair(sums.couple.backward[i])},
            "roll": _pair(phasor.amplitude(sums.roll)[i]),
        }
        for i, order in enumerate(wanted)
    ]
    return out


def strokes_tree(engine: Engine) -> dict[str, Any]:
    """The public JSON object of strokes and exhausts; all angles are degrees of the reference crankshaft.

    A window `[from, to]` begins within the cycle and may end in the next. Raises EngineError as `strokes.working_cycle`.
    """
    found = working_cycle(engine)
    timing = {name: float(f"{degrees(getattr(found.timing, name)):.12g}") for name in EVENTS}
    return {
        "format": FORMAT,
        "engine": engine.name,
        "cycle_deg": found.cycle_deg,
        "firing_order": list(found.firing.order),
        "firing_angles_deg": [round(angle, 9) for angle in found.firing.angles_deg],
        "firing_intervals_deg": list(found.firing.intervals_deg),
        "timing_deg": timing,
        "assumed": list(found.timing.assumed),
        "cylinders": [_strokes_of(one) for one in found.chambers],
        "exhausts": [_exhaust(found, group) for group in exhaust_groups(engine)],
        "neighbours_in_succession": [step[:2] for step in in_succession(found.firing, neighbours(engine))],
        "partners_in_succession": [step[:2] for step in in_succession(found.firing, partners(engine))],
    }


def _strokes_of(one: ChamberStrokes) -> dict[str, Any]:
    return {
        "number": one.number,
        "fires_deg": one.fires_deg,
        "strokes": {stroke.name: list(stroke.window) for stroke in one.strokes},
        "intake_open": list(one.intake),
        "exhaust_open": list(one.exhaust),
        "blow_down": list(one.blow_down),
    }


def _exhaust(found: WorkingCycle, group: ExhaustGroup) -> dict[str, Any]:
    return {
        "name": group.name,
        "cylinders": list(group.chambers),
        "intervals": [step._asdict() for step in exhaust_intervals(found, group.chambers)],
        "disturbances": [one._asdict() for one in disturbances(found, group.chambers)],
    }


def _pair(value: complex) -> list[float]:
    return [float(value.real) + 0.0, float(value.imag) + 0.0]


def csv_text(name: str, result: Balance, *, orders: Sequence[float] | None = None) -> str:
    """The same numbers and the inertia torque as CSV, a row per order, units in the header."""
    answer = tree(name, result, orders=orders)
    units = answer["units"]
    header = ["engine", "speed_rpm", "order"]
    for quantity in ("force", "couple"):
        header += [f"{quantity}_{turn}_{way} [{units[quantity]}]" for turn in ("forward", "backward") for way in ("up", "right")]
    header += [f"{name}_{part} [{units['roll']}]" for name in ("roll", "torque") for part in ("real", "imaginary")]
    torque = phasor.amplitude(phasor.selected(total(result).torque, [row["order"] for row in answer["orders"]]))
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(header)
    for row, moment in zip(answer["orders"], torque, strict=True):
        numbers = [x for q in ("force", "couple") for turn in ("forward", "backward") for x in row[q][turn]]
        writer.writerow([_plain(name), answer["speed_rpm"], row["order"], *numbers, *row["roll"], *_pair(moment)])
    return out.getvalue()


def _plain(name: str) -> str:
    """A name that a spreadsheet does not take for a formula."""
    return "'" + name if name[:1] in ("=", "+", "-", "@") else name


def json_text(tree: dict[str, Any]) -> str:
    """A tree as JSON, a pair of numbers on one line."""
    import json
    import re

    text = json.dumps(tree, indent=1, ensure_ascii=False, allow_nan=False)
    # A pair of numbers on one line. A raw line break cannot stand inside a string, so no name is touched.
    return re.sub(r"\[\n\s+([-+.\de]+),\n\s+([-+.\de]+)\n\s+\]", r"[\1, \2]", text) + "\n"
