"""An engine as a Python script for EXUDYN: rigid bodies, joints, constant speed, reactions.

The script stands alone: it needs exudyn and numpy. It builds every shaft, rod and piston as a rigid
body where it is at theta = 0, holds the shafts in two main bearings each and the pistons in their
bores, turns the shafts at constant speed, and gives force, couple, roll, torque and the moment
about the axis from the reactions on the block. No law of this package is in it: its numbers are a
second road to those of `mechanics`.

A rod is a rigid body where the engine describes it so; otherwise it has no mass of its own, since
the masses at its two ends are in the piston and in the throw, or its big end's at the pin. A weight
is a small ball of the same unbalance at one crank radius.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from importlib.resources import files
from math import lcm
from textwrap import wrap
from typing import Any

from crankstar.engine import motion
from crankstar.engine.engine import Engine
from crankstar.language.quoting import one_line
from crankstar.mechanics.balance import default_reference
from crankstar.mechanics.excitation import Reference

ORDERS = 12
"""Orders that the script prints."""
USUAL_SPEED = 100.0
"""rad/s, of an engine without a speed: forces go with its square."""
UNITS = {
    "mass": ("kg", "reciprocating masses of the first cylinder"),
    "radius": ("m", "crank radii of the first cylinder"),
    "pitch": ("m", "bore pitches"),
}
MEANINGS = {
    "SHAFTS": "place of the axis; turns per turn of the first shaft, negative the other way",
    "THROWS": "bearing at theta = 0, crank radius, place along the shaft, mass at the pin",
    "WEIGHTS": "unbalance (mass times radius), bearing at theta = 0, place along the shaft",
    "CYLINDERS": (
        "bearing of the axis, place along the shaft, offset of the axis clockwise; rod_centre from "
        "the big end; rod_inertia about the centre of mass; master: the cylinder whose rod carries "
        "the knuckle pin"
    ),
}


def exudyn_script(
    engine: Engine, *, speed: float | None = None, reference: Reference | None = None
) -> str:
    """The script of an engine at `speed` (rad/s; else the engine's own, or 100 rad/s).

    Couples and moments are taken about `reference`, the middle of the cylinders unless given.
    Masses or sizes that are not known are counted in units of themselves.

    >>> from crankstar.files.catalog import load
    >>> print(exudyn_script(load("single")).splitlines()[0])
    # Single-cylinder engine: a multibody model for EXUDYN, written by crankstar.
    """
    point = reference or default_reference(engine)
    turns = lcm(*(shaft.speed_ratio.denominator for shaft in engine.shafts))
    facts = {
        "SPEED": (speed or engine.speed or USUAL_SPEED, "rad/s, of the first shaft"),
        "SENSE": (engine.sense, "1: it turns clockwise seen from the front, -1: the other way"),
        "REFERENCE": (tuple(point), "z, up, right of the point of couples and moments"),
        "TURNS": (turns, "after which all shafts repeat"),
        "ORDERS": (ORDERS, "the highest order that is computed"),
    }
    units = {name: both[name in engine.relative] for name, both in UNITS.items()}
    head = [
        f"# {one_line(engine.name)}: a multibody model for EXUDYN, written by crankstar.",
        "# Run it with python; it needs exudyn (made for version 1.13) and numpy.",
        f"# Masses in {units['mass']},",
        f"# lengths across the shafts in {units['radius']}, along them in {units['pitch']};",
        "# angles in radians, clockwise from up.",
        *_estimated(engine),
        "",
        *(f"{name} = {value!r}  # {meaning}" for name, (value, meaning) in facts.items()),
    ]
    for name, rows in _lists(engine).items():
        head += ["", *(f"# {line}" for line in wrap(MEANINGS[name], 96)), f"{name} = ["]
        head += [line for row in rows for line in _written(row)]
        head.append("]")
    model = files("crankstar.exports").joinpath("multibody.txt").read_text("utf-8")
    return "\n".join(head) + "\n\n" + model


def _estimated(engine: Engine) -> Iterator[str]:
    """That values are estimated, and between which multiples of the value here each may lie."""
    sources = {
        path: source for path, source in engine.provenance.items() if source.status == "estimated"
    }
    if sources:
        yield "# ESTIMATED, not measured; all that the script finds rests on them:"
    for path, source in sources.items():
        ends = source.range and f", {source.range[0]:g} to {source.range[1]:g} times the value here"
        yield f"#   {one_line(path)}{ends or ''}"


def _written(row: Mapping[str, Any]) -> Iterator[str]:
    """A row of a list as lines of Python."""
    line = "    {"
    for key, value in row.items():
        item = f"{key!r}: {value!r}, "
        if len(line) + len(item) > 99:
            yield line.rstrip()
            line = "     "
        line += item
    yield f"{line.rstrip(', ')}}},"


def _lists(engine: Engine) -> dict[str, list[dict[str, Any]]]:
    shafts = engine.shafts
    return {
        "SHAFTS": [
            {"name": s.name, "speed_ratio": float(s.speed_ratio), "up": s.up, "right": s.right}
            for s in shafts
        ],
        "THROWS": [
            {"shaft": s.name, "number": number}
            | {name: getattr(t, name) for name in ("angle", "radius", "z")}
            | {"rotating_mass": t.turning_mass}
            for s in shafts
            for number, t in enumerate(s.throws, 1)
        ],
        "WEIGHTS": [
            {"shaft": s.name, "unbalance": w.unbalance, "angle": w.angle, "z": w.z}
            for s in shafts
            for w in s.weights
        ],
        "CYLINDERS": _cylinders(engine),
    }


def _cylinders(engine: Engine) -> list[dict[str, Any]]:
    """The cylinders, a master before its slaves."""
    master = motion.linkage(engine).master
    order = sorted(range(len(master)), key=lambda index: len(motion.chain(master, index)))
    plain = ("number", "shaft", "throw", "bearing", "z", "offset", "rod_length")
    masses = ("reciprocating_mass", "big_end_mass")
    rows: list[dict[str, Any]] = []
    for cylinder in (engine.cylinders[index] for index in order):
        rod, link = cylinder.rod, cylinder.articulated
        rows.append(
            {name: getattr(cylinder, name) for name in (*plain, *masses)}
            | {
                "rod_mass": rod.mass if rod else 0.0,
                "rod_centre": rod.centre if rod else 0.0,
                "rod_inertia": rod.turning_inertia(cylinder.rod_length) if rod else 0.0,
                "master": link.master if link else None,
                "knuckle_radius": link.radius if link else 0.0,
                "knuckle_angle": link.angle if link else 0.0,
            }
        )
    return rows
