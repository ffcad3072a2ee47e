"""What is said below a sweep: its speed and units, where it has no result, what is hardly right."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from crankstar.analysis.document import Document, Remarks, remarks
from crankstar.analysis.registry import measures
from crankstar.language.messages import _, passage
from crankstar.language.numbers import RPM, number
from crankstar.mechanics.balance import balance
from crankstar.studies.answers import rests_on
from crankstar.studies.gas_results import GAS_WATCHABLE
from crankstar.studies.sweep import Axis, Curve, Sweep
from crankstar.studies.sweep_answers import judged, more_beyond
from crankstar.studies.sweep_doubts import Doubted, Ignited, doubted, ignited
from crankstar.tables import ranges
from crankstar.tables.assumptions import assumption_facts, assumption_lines
from crankstar.tables.conditions import missing_sentence, unit_sentence

MOST_BEYOND = 3
"""Of what matters more at the other end of a range so many have a sentence each."""
SIZES = {"bore", "stroke", "rod_length"}
"""Dimensions of a cylinder from which masses are estimated."""


def notes(sweep: Sweep, curves: Sequence[Curve]) -> tuple[Remarks, ...]:
    """The speed of the forces, or what the file lacks for newtons; what a varied speed does."""
    engine = sweep.engine
    if sweep.highest_speed is None:
        counted = unit_sentence(engine, balance(engine, speed=sweep.speed, orders=[1]))
    else:
        counted = missing_sentence(engine)
    added = _(
        "The engine file has weights on the crankshaft; those of the balance factor are added to "
        "them."
    )
    doubts = remarks(*doubt_sentences(sweep, curves), kind="doubt")
    net = ""
    if any(curve.what == "mount_force" for curve in curves):
        net = _(
            "mount_force: the net force on the ground, rms; that in a single mount may be greater."
        )
    if any(curve.what.endswith("_with_gas") and curve.order is None for curve in curves):
        without = _(
            "torque_with_gas, roll_with_gas: the maximum deviation from the mean over a cycle."
        )
        net = passage((net, without))
    net = passage([each for each in (_forced(sweep, curves), net) if each])
    more = (net, _estimates_note(sweep), added if sweep.adds else "")
    if curves and all(curve.what in measures() for curve in curves):
        return (*remarks(net, _estimates_note(sweep), kind="note"), *doubts)
    own = (*GAS_WATCHABLE, *measures())
    gas = bool(curves) and all(curve.what in own for curve in curves)
    if gas:  # in N m, bar or none; the record says what is not in them
        counted = counted if sweep.units.force == "N" else ""
    return (*remarks(counted, "" if gas else speed_note(sweep), *more, kind="note"), *doubts)


def _forced(sweep: Sweep, curves: Sequence[Curve]) -> str:
    """At which speed forced vibration is told, or that it is the maximum over all."""
    if sweep.highest_speed is not None or not is_forced(curves):
        return ""
    if sweep.alone and sweep.speed is not None:
        return _("Forced vibration is that at {rpm} rpm.", rpm=number(sweep.speed * RPM))
    return _("Forced vibration is the maximum over the speeds of the file.")


def is_forced(curves: Sequence[Curve]) -> bool:
    """Whether one of the curves is of forced vibration."""
    known = measures()
    return any(curve.what in known and not known[curve.what][1].natural for curve in curves)


def rested(document: Document, sweep: Sweep, curves: Sequence[Curve]) -> Document:
    """The document of a sweep with what it rests on, and what matters more at its other end."""
    own = judged(sweep, curves)
    found = rests_on(own.engine, own.answer)
    out = ranges.resting(document, lambda: found, at=own.at)
    at, more = more_beyond(sweep, curves, found)
    if not more:
        return out
    told = assumption_lines(more, most=MOST_BEYOND)
    lines = (_("With {values} these move more:", values=at), *told)
    rows = [{"at": at, **row} for row in assumption_facts(more)["rests_on"]]
    doubts = [isinstance(part, Remarks) and part.kind == "doubt" for part in out.parts]
    place = doubts.index(True) + 1 if True in doubts else 0
    return replace(
        out,
        parts=(*out.parts[:place], Remarks(lines, kind="doubt"), *out.parts[place:]),
        facts={**out.facts, "rests_on": [*out.facts.get("rests_on", ()), *rows]},
    )


def doubt_sentences(sweep: Sweep, curves: Sequence[Curve]) -> list[str]:
    """What is hardly right at some of the values, or at all of them."""
    alike: dict[tuple[int, ...], list[Curve]] = {}
    for curve in curves:
        if curve.gaps:
            alike.setdefault(tuple(gap.place for gap in curve.gaps), []).append(curve)
    gaps = [_gaps(sweep, own) for own in alike.values()]
    own = ignited(sweep, curves)
    changes = [] if own is None else [_ignited(sweep, own)]
    return [*gaps, *changes, *(_doubt(sweep, one) for one in doubted(sweep, curves))]


def _ignited(sweep: Sweep, own: Ignited) -> str:
    """From which value on, or at which pair of values, another ignition is assumed."""

    def at(place: Sequence[int]) -> str:
        return ", ".join(
            f"{axis.path} = {number(float(axis.values[index]))} {axis.unit}".strip()
            for axis, index in zip(sweep.axes, place, strict=True)
        )

    words = {"also": ", ".join(f"gas.{name}" for name in own.also)}
    if len(sweep.axes) > 1:
        first, other = own.runs[:2]
        return _(
            "gas.ignition is not in the file: {ignition} is assumed at {at}, {other} at {then}, "
            "and with it other values of {also}.",
            ignition=first[2], at=at(first[0]), other=other[2], then=at(other[0]), **words,
        )  # fmt: skip
    axis = next(iter(sweep.axes))
    ranges: list[str] = []
    for (low,), (high,), fires in own.runs:
        first, last = (
            f"{number(float(axis.values[each]))} {axis.unit}".strip() for each in (low, high)
        )
        if low == high:
            ranges.append(_("{ignition} at {value}", ignition=fires, value=first))
        else:
            ranges.append(
                _("{ignition} from {low} to {high}", ignition=fires, low=first, high=last)
            )
    return _(
        "gas.ignition is not in the file: assumed is {ranges}, and with it other values of {also}.",
        ranges=", ".join(ranges), **words,
    )  # fmt: skip


def _gaps(sweep: Sweep, curves: Sequence[Curve]) -> str:
    """At which values, or pairs of them, there are no results, and why."""
    gaps = curves[0].gaps
    ends = [np.unravel_index(gap.place, sweep.shape) for gap in (gaps[0], gaps[-1])]
    first, last = (
        ", ".join(
            f"{axis.path} = {number(float(axis.values[at]))} {axis.unit}".strip()
            for axis, at in zip(sweep.axes, end, strict=True)
        )
        for end in ends
    )
    labels = ", ".join(curve.label for curve in curves)
    words = {"curves": labels, "first": first, "reason": gaps[0].reason.rstrip(".。")}
    if len(gaps) == 1:
        return _("No {curves} at {first}: {reason}.", **words)
    return _(
        "No {curves} at {count} of {whole} values, from {first} to {last}. At {first}: {reason}.",
        **words,
        last=last,
        count=len(gaps),
        whole=curves[0].values.size,
    )


def _doubt(sweep: Sweep, one: Doubted) -> str:
    """One doubt: at all values, at those of a range, or at some."""

    def value(axis: Axis, index: int) -> str:
        return f"{number(float(axis.values[index]))} {axis.unit}".strip()

    if one.everywhere:
        return one.fault.sentence
    words = {
        "at": ", ".join(
            f"{axis.path} = {value(axis, place)}"
            for axis, place in zip(sweep.axes, one.at, strict=True)
        ),
        "doubt": _ended(one.fault.sentence),
    }
    if len(sweep.axes) == 1 and len(one.places) > 1:
        (axis,) = sweep.axes
        ends = [[value(axis, place) for place in run] for run in one.runs]
        if len(ends) > 1:
            words["values"] = ", ".join(
                low if low == high else _("{low} to {high}", low=low, high=high)
                for low, high in ends
            )
            return _("At {at}: {doubt} So it is at {values}.", **words)
        [[low, high]] = ends
        return _("At {at}: {doubt} So it is from {low} to {high}.", **words, low=low, high=high)
    if len(one.places) > 1:
        return _("At {at}, as at others: {doubt}", **words)
    return _("At {at}: {doubt}", **words)


def _ended(sentence: str) -> str:
    """A sentence with a full stop, where it does not end with a sign of its own."""
    return (
        sentence if sentence.endswith(tuple(".?!。？！")) else _("{sentence}.", sentence=sentence)
    )


def _estimates_note(sweep: Sweep) -> str:
    """That estimated masses do not follow a bore, stroke or rod that is varied."""
    sizes = [axis.path for axis in sweep.axes if axis.path.rpartition(".")[2] in SIZES]
    if not sizes or not ranges.estimated_paths(sweep.engine):
        return ""
    return _(
        "The estimated values are those of the engine file; they do not change with {paths}.",
        paths=", ".join(sizes),
    )


def speed_note(sweep: Sweep) -> str:
    """How inertia grows with the speed, where that is varied, and what a unit of it means."""
    if sweep.highest_speed is None:
        return ""
    law = _(
        "Inertia forces grow with the square of the speed: twice the speed, four times as much."
    )
    if sweep.units.force == "N":
        return law
    rpm = number(sweep.highest_speed * RPM)
    unit = _("ω0 is the highest speed, {rpm} rpm.", rpm=rpm)
    return f"{law} {unit}"
