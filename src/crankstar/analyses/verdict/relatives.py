"""Engines of the catalog with as many cylinders: which have the same balance, how others differ."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from itertools import pairwise
from math import isclose
from pathlib import Path
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.files.catalog import summaries
from crankstar.language.alike import as_given
from crankstar.language.messages import N_, _, _n
from crankstar.language.numbers import number
from crankstar.language.written import joined
from crankstar.mechanics.balance import balance
from crankstar.mechanics.bounds import size

BALANCES = Path(__file__).with_name("piston_balances.tsv")
"""The piston balance of every engine of the catalog; `tools/catalog_lists.py` writes it."""
COMPARED = 4
"""Engines that are compared one by one."""
LISTED = 5
"""Names in a list."""


class PistonBalance(NamedTuple):
    """Greatest force and couple of the pistons, in m r w^2 and in m r w^2 times the `spacing`."""

    force_1: float
    couple_1: float
    force_2: float
    couple_2: float


def piston_balance(engine: Engine) -> PistonBalance:
    """Of the reciprocating masses, the rods' share at the pistons among them; m is all of one.

    What turns with the crank pins, and weights, count for nothing.
    """
    orders = (1.0, 2.0)
    result = balance(_lumped(engine), orders=orders)
    rows = [row for row, part in enumerate(result.parts) if part.kind == "piston"]
    lengths: list[float] = []
    for order in orders:
        for name in ("force", "couple"):
            whole = spectra.total(getattr(result, name)[rows, :])
            arm = spacing(engine) / engine.pitch if name == "couple" else 1.0
            lengths.append(size(whole, order) * (1 / arm))
    return PistonBalance(*(0.0 if length < 1e-6 else length for length in lengths))


def _lumped(engine: Engine) -> Engine:
    """The engine whose rods are two masses each, in force the same as the rigid body."""
    if not any(cylinder.rod for cylinder in engine.cylinders):
        return engine
    lumped = (
        with_values(cylinder, reciprocating_mass=cylinder.reciprocating, rod=None)
        for cylinder in engine.cylinders
    )
    return with_values(engine, cylinders=tuple(lumped))


def spacing(engine: Engine) -> float:
    """The length in which couples of different engines are compared.

    The distance of the nearest cylinders of a bank. Where no bank has two, that between the first
    and the last of all: a bore pitch says nothing of arms there. A lone cylinder has its pitch.
    """
    place = {cylinder.number: cylinder.z for cylinder in engine.cylinders}
    rows = [sorted(place[number] for number in numbers) for numbers in engine.banks.values()]
    near = [behind - before for row in rows for before, behind in pairwise(row) if behind > before]
    return min(near, default=max(place.values()) - min(place.values()) or engine.pitch)


def relative_lines(engine: Engine) -> list[str]:
    """Engines with the same number of cylinders and cycle: equal ones, then the nearest others."""
    own = piston_balance(engine)
    count = len(engine.chambers)
    rows = [row for row in summaries() if row.cylinders == count and row.cycle == engine.cycle]
    known = _of_catalog()
    others = [(row.name, known[row.name]) for row in rows if row.title != engine.name]
    if not others:
        return [
            _n(
                "The catalog has no other {cycle} engine with {count} cylinder.",
                "The catalog has no other {cycle} engine with {count} cylinders.",
                count,
                cycle=_(engine.cycle),
                count=count,
            )
        ]
    equal = [name for name, other in others if np.allclose(own, other, rtol=0.05, atol=0.01)]
    lines = (
        [_("Same balance of the pistons, each in its own m r ω²: {names}.", names=_names(equal))]
        if equal
        else []
    )
    different: dict[PistonBalance, list[str]] = {}
    for name, other in others:
        if name not in equal:
            key = next(
                (near for near in different if np.allclose(near, other, rtol=0.05, atol=0.01)),
                other,
            )
            different.setdefault(key, []).append(name)
    arm = "a" if isclose(spacing(engine), engine.pitch) else "d"
    nearest = sorted(different, key=lambda other: float(np.abs(np.subtract(own, other)).sum()))
    told = as_given("nearest", nearest[:COMPARED])
    return lines + [
        _(
            "Compared with {names}, pistons only, each in its own m, r and a: {differences}.",
            names=_names(different[other]),
            differences=_differences(own, other, arm),
        )
        for other in told
        if other in different
    ]


@cache
def _of_catalog() -> dict[str, PistonBalance]:
    """The piston balance of every engine of the catalog by its name."""
    lines = BALANCES.read_text(encoding="utf-8").splitlines()
    rows = (line.split("\t") for line in lines)
    return {name: PistonBalance(*map(float, values)) for name, *values in rows}


def _names(names: Sequence[str]) -> str:
    shown, more = ", ".join(names[:LISTED]), len(names) - LISTED
    return _("{names} and {count} more", names=shown, count=more) if more > 0 else shown


def _differences(own: PistonBalance, other: PistonBalance, arm: str) -> str:
    """The numbers that differ, the largest difference first."""
    differing = {
        name: abs(mine - theirs)
        for name, mine, theirs in zip(PistonBalance._fields, own, other, strict=True)
        if abs(mine - theirs) > 0.01
    }
    ranked = sorted(differing, key=lambda name: -differing[name])
    pairs = [
        (name, getattr(own, name), getattr(other, name))
        for name in as_given(("differing", other), ranked)
    ]
    out: list[str] = []
    for name, mine, theirs in pairs:
        unit = "m r ω²" if name.startswith("force") else f"m r ω² {arm}"
        values = {"mine": number(mine, digits=4), "theirs": number(theirs, digits=4), "unit": unit}
        out.append(_(DIFFERENCES[name], **values))
    text = joined(", ", out)
    if arm == "d" and any(name.startswith("couple") for name, *_values in pairs):
        return _("{differences} (d: distance of the cylinders)", differences=text)
    return text


DIFFERENCES = {
    "force_1": N_("primary force {mine} against {theirs} {unit}"),
    "couple_1": N_("primary couple {mine} against {theirs} {unit}"),
    "force_2": N_("secondary force {mine} against {theirs} {unit}"),
    "couple_2": N_("secondary couple {mine} against {theirs} {unit}"),
}
