"""Places along the crankshaft as linear forms in the bore pitch a and the bank offset b.

Within a bank the cylinders stand at multiples of the pitch; by how much the front cylinder of
another bank stands before or behind that of the first one is an offset b (b_1, b_2, ... where there
are several). A shaft's throw stands in the middle of its cylinders, a weight at its throw. What
stands elsewhere keeps its own multiple of a.
"""

from __future__ import annotations

from fractions import Fraction
from typing import NamedTuple, TypeVar

from crankstar.derive.algebra import rational
from crankstar.derive.algebra.formula import Symbol
from crankstar.derive.algebra.wave import Form, Key, form_sum
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.mechanics.balance import default_reference
from crankstar.mechanics.excitation import Reference

SAME_PLACE = 1e-9
"""Bore pitches: places closer than this are one."""
GREATEST_STEP = 100
"""Denominator up to which a place within a bank is a multiple of the pitch."""

P = TypeVar("P")
PITCH: Key = (Symbol("a"),)


class Arms(NamedTuple):
    """Distances in front of the reference plane: cylinders by number, throws and weights by shaft.

    `values` gives the length of each symbol in bore pitches.
    """

    cylinder: dict[int, Form]
    throw: dict[tuple[str, int], Form]
    weight: dict[tuple[str, int], Form]
    values: dict[Symbol, Fraction]


def arms(engine: Engine, reference: Reference | None = None) -> Arms:
    """The arms of all parts about the reference plane, the middle of the cylinders unless given."""
    pitch = engine.pitch
    places = {cylinder.number: cylinder.z for cylinder in engine.cylinders}
    forms, values = _cylinders(engine, pitch)
    front, rear = (end(places, key=lambda number: places[number]) for end in (max, min))
    half = Fraction(-1, 2)
    centred = _moved(forms, form_sum([(half, forms[front]), (half, forms[rear])]))
    centre = (places[front] + places[rear]) / 2
    throws = {
        (shaft.name, index): _shared(
            engine, shaft.name, index, (throw.z - centre) / pitch, centred, values
        )
        for shaft in engine.shafts
        for index, throw in enumerate(shaft.throws, 1)
    }
    weights: dict[tuple[str, int], Form] = {}
    for shaft in engine.shafts:
        for index, weight in enumerate(shaft.weights, 1):
            beside = (
                throws[shaft.name, number]
                for number, throw in enumerate(shaft.throws, 1)
                if abs(throw.z - weight.z) < SAME_PLACE * pitch
            )
            weights[shaft.name, index] = next(beside, _multiple((weight.z - centre) / pitch))
    away = 0.0 if reference is None else (reference.z - default_reference(engine).z) / pitch
    by: Form = {}
    if abs(away) > SAME_PLACE:
        values[Symbol("z", "0")] = rational.ratio(away)
        by = {(Symbol("z", "0"),): Fraction(-1)}
    return Arms(_moved(centred, by), _moved(throws, by), _moved(weights, by), values)


def _moved(places: dict[P, Form], by: Form) -> dict[P, Form]:
    """Places moved by a length."""
    unit = Fraction(1)
    return {key: form_sum([(unit, form), (unit, by)]) for key, form in places.items()}


def meanings(engine: Engine, placed: Arms) -> dict[str, str]:
    """The meanings of the letters a, b, z_0 in this engine, with their sizes where known."""
    known = "pitch" not in engine.relative
    size = f"{engine.pitch * 1000:.6g} mm"
    out = {"a": _meaning_of_pitch(engine, size if known else "")}
    for symbol, value in placed.values.items():
        pitches = float(value)
        size = f"{pitches * engine.pitch * 1000:.6g} mm" if known else f"{pitches:.6g} a"
        if symbol.letter == "b":
            out[symbol.name] = _("bank offset, {size}", size=size)
        elif symbol.letter == "z":
            out[symbol.name] = _(
                "distance of the reference plane in front of the middle of the cylinders, {size}",
                size=size,
            )
    return out


def _meaning_of_pitch(engine: Engine, size: str) -> str:
    """What the letter a is, with its size unless that is empty."""
    if engine.bore_pitch is not None:
        return _("bore pitch, {size}", size=size) if size else _("bore pitch")
    if len({cylinder.z for cylinder in engine.cylinders}) == 1:
        return _("unit of length, {size}", size=size) if size else _("unit of length")
    if size:
        return _("closest spacing of cylinders, {size}", size=size)
    return _("closest spacing of cylinders")


def _cylinders(engine: Engine, pitch: float) -> tuple[dict[int, Form], dict[Symbol, Fraction]]:
    """The cylinders' places before the front one of the first bank."""
    places = {cylinder.number: cylinder.z for cylinder in engine.cylinders}
    banks = list(engine.banks.values())
    anchors = [max(places[number] for number in numbers) for numbers in banks]
    shifts = [(anchor - anchors[0]) / pitch for anchor in anchors]
    sizes = sorted(
        {round(abs(shift), 9) for shift in shifts if abs(shift) > SAME_PLACE}, reverse=True
    )
    names = (
        [Symbol("b")]
        if len(sizes) == 1
        else [Symbol("b", str(index)) for index in range(1, len(sizes) + 1)]
    )
    exact = {round(abs(shift), 9): abs(shift) for shift in shifts}
    values = {PITCH[0]: Fraction(1)} | {
        name: rational.ratio(exact[size]) for name, size in zip(names, sizes, strict=True)
    }
    forms: dict[int, Form] = {}
    for numbers, anchor, shift in zip(banks, anchors, shifts, strict=True):
        offset: dict[Key, Fraction] = {}
        if abs(shift) > SAME_PLACE:
            offset[(names[sizes.index(round(abs(shift), 9))],)] = Fraction(1 if shift > 0 else -1)
        for number in numbers:
            forms[number] = form_sum(
                [(Fraction(1), _multiple((places[number] - anchor) / pitch)), (Fraction(1), offset)]
            )
    return forms, values


def in_pitches(pitches: float) -> Fraction:
    """A place as a short multiple of the bore pitch, where it is that."""
    near = Fraction(pitches).limit_denominator(GREATEST_STEP)
    return near if abs(float(near) - pitches) < SAME_PLACE / 100 else rational.ratio(pitches)


def _multiple(pitches: float) -> Form:
    multiple = in_pitches(pitches)
    return {PITCH: multiple} if multiple else {}


def _shared(
    engine: Engine,
    shaft: str,
    throw: int,
    pitches: float,
    centred: dict[int, Form],
    values: dict[Symbol, Fraction],
) -> Form:
    """A throw's place as the mean of its cylinders', if it is that."""
    on = [c.number for c in engine.cylinders if (c.shaft, c.throw) == (shaft, throw)]
    if on:
        mean = form_sum([(Fraction(1, len(on)), centred[number]) for number in on])
        if (
            abs(float(sum(value * values[key[0]] for key, value in mean.items())) - pitches)
            < SAME_PLACE
        ):
            return mean
    return _multiple(pitches)
