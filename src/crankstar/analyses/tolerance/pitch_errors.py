"""Errors of the distances between cylinders, and which throw belongs to what."""

from __future__ import annotations

import numpy as np

from crankstar.engine.copies import throws_of_weights
from crankstar.engine.engine import Engine
from crankstar.files.mistakes import Tree
from crankstar.language.messages import _

Arrays = dict[str, np.ndarray]
Moves = list[tuple[str, Arrays]]
"""Parts by name, and what a unit of the error of each moves."""


def throw_of(engine: Engine, index: int) -> int:
    """The index of the throw of a cylinder among the rotors of all shafts."""
    cylinder = engine.cylinders[index]
    before = 0
    for shaft in engine.shafts:
        if shaft.name == cylinder.shaft:
            return before + cylinder.throw - 1
        before += len(shaft.throws)
    raise ValueError(cylinder.shaft)


def homes_of(engine: Engine) -> np.ndarray:
    """The throw of each rotor, of all shafts: its own, or the one a weight turns with; -1."""
    throws: list[int] = []
    weights: list[int] = []
    for shaft in engine.shafts:
        first = len(throws)
        throws += range(first, first + len(shaft.throws))
        weights += [-1 if home is None else first + home - 1 for home in throws_of_weights(shaft)]
    return np.array([*throws, *weights])


def of_pitches(plain: Tree, engine: Engine) -> Moves:
    """Each distance between neighbours: half of its error moves all in front, half all behind.

    So z is counted from the middle of each engine's own span, as its reference point is.
    """
    slots = _slots(plain, engine)
    homes = homes_of(engine)
    of_cylinder = np.array([slots[cylinder.number] for cylinder in engine.cylinders])
    of_throw: dict[int, list[int]] = {}
    for index in range(of_cylinder.size):
        of_throw.setdefault(throw_of(engine, index), []).append(int(of_cylinder[index]))
    of_rotor = np.array(
        [np.mean(of_throw[home]) if home in of_throw else np.nan for home in homes.tolist()]
    )
    out = []
    for gap in range(int(of_cylinder.max())):
        moves = {
            "z": np.where(of_cylinder > gap, -0.5, 0.5),
            "unbalance_z": np.where(
                np.isnan(of_rotor), 0.0, np.where(of_rotor > gap + 0.5, -0.5, 0.5)
            ),
        }
        part = _("pitch {front} to {rear}", front=gap + 1, rear=gap + 2)
        out.append((part, moves))
    return out


def _slots(plain: Tree, engine: Engine) -> dict[int, int]:
    """The place of each cylinder along its bank, from the front."""
    layout = plain["layout"]
    rows, count = layout.get("rows"), len(engine.cylinders)
    if layout["type"] in ("inline", "opposed"):
        along = count // 2 if layout["type"] == "opposed" else count
        return {number: (number - 1) % along for number in range(1, count + 1)}
    if rows is not None:
        return {number: index for index, row in enumerate(rows) for number in row["cylinders"]}
    cranks = layout.get("cranks") or [layout]
    slots: dict[int, int] = {}
    for crank in cranks:
        for bank in crank.get("banks") or ():
            slots |= {number: index for index, number in enumerate(bank["cylinders"])}
    return slots
