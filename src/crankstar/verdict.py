"""The facts that a Balance shows, as short sentences with numbers: what is free, what remains, what cures it, who does better."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import isclose
from typing import NamedTuple

import numpy as np
from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from crankstar import phasor
from crankstar.answer import orders_present
from crankstar.balance import Balance, balance, total
from crankstar.catalog import load, summaries
from crankstar.engine import Engine
from crankstar.fault import EngineError
from crankstar.firing import firing
from crankstar.fitting import quiet_cranks
from crankstar.mechanism import Totals
from crankstar.phasor import Spectrum
from crankstar.records import Shaft
from crankstar.remedy import bobweight, loads, main_bearings, needs, without_counterweights
from crankstar.remedy.planes import spans
from crankstar.strokes import exhaust_groups, exhaust_intervals, working_cycle
from crankstar.succession import Follower, in_succession, partners
from crankstar.succession import neighbours as neighbours_of
from crankstar.wording import NEGLIGIBLE, cures, firing_sentence, number, shape, unit_text

HIGHEST = 6.0
"""The highest order that is spoken of."""
MINOR = 0.02
"""An order smaller than this share of the largest is told by its size alone."""
COMPARED = 4
"""Engines of the catalog, and firings, that are spoken of one by one."""
FEW = 4
"""Cylinders: of fewer it goes without saying who fires after whom."""
UNEVEN = 0.75
"""Exhausts that follow each other in less than this share of the even interval are uneven; slave rods shift them by less."""
BURBLE = (90.0, 180.0, 180.0, 270.0)
"""Degrees between the exhausts of a bank of a cross-plane V8, from the shortest."""


class Fact(NamedTuple):
    """A sentence, and what it is about: layout, firing, force, couple, roll, cure, neighbours."""

    about: str
    sentence: str


class Pulses(NamedTuple):
    """The exhausts of a bank or manifold in the order in which they open, with the crank angles between them."""

    name: str
    steps: tuple[Follower, ...]

    @property
    def closest(self) -> Follower:
        """The two that follow each other soonest."""
        return min(self.steps, key=lambda step: round(step.interval_deg, 3))

    @property
    def even(self) -> float:
        """The interval if all were equal, degrees."""
        return sum(step.interval_deg for step in self.steps) / len(self.steps)


class Likeness(NamedTuple):
    """What the pistons of an engine do: greatest force and couple of two orders, in m r w^2 and in m r w^2 times its `spacing`."""

    force_1: float
    couple_1: float
    force_2: float
    couple_2: float


def verdict(engine: Engine, *, neighbours: bool = True) -> tuple[Fact, ...]:
    """The facts of an engine, in units of m r w^2 of its first cylinder, couples about the middle of the cylinders.

    >>> facts = verdict(load("i4"), neighbours=False)
    >>> facts[2].sentence
    'No force of order 1; order 2 remains: 1.0161 m r ω², a vertical line; order 4: 0.016392; order 6: 0.00029752.'
    """
    result = balance(engine)
    sums = total(result)
    facts = [Fact("layout", _layout(engine)), *(Fact("firing", sentence) for sentence in _succession(engine))]
    facts += [Fact(name, _quantity(name, result, sums)) for name in ("force", "couple")]
    facts.append(Fact("roll", _roll(result, sums)))
    facts += [Fact("cure", sentence) for sentence in _cures(engine)]
    return (*facts, *(Fact("neighbours", sentence) for sentence in (_neighbours(engine) if neighbours else [])))


def shown(engine: Engine, facts: Sequence[Fact]) -> RenderableType:
    """The facts of an engine as a table without lines: what each is about, and the sentence."""
    out = Table.grid(padding=(0, 2))
    out.add_column(no_wrap=True)
    out.add_column(overflow="fold")
    before = ""
    for fact in facts:
        out.add_row(Text(fact.about if fact.about != before else "", style="dim"), Text(fact.sentence))
        before = fact.about
    return Group(Text(engine.name, style="bold"), out)


def _layout(engine: Engine) -> str:
    """Firing, throws and main bearings."""
    cranks = [(shaft.name, _throws(engine, shaft)) for shaft in engine.shafts if shaft.throws]
    if len({told for _, told in cranks}) == 1:
        each = f"{len(cranks)} crankshafts, each with " if len(cranks) > 1 else ""
        told = each + cranks[0][1]
    else:
        told = "; ".join(f"crankshaft {name}: {told}" for name, told in cranks)
    if engine.firing_order:
        return f"It {firing_sentence(firing(engine))}; {told}."
    return f"{told[0].upper()}{told[1:]}."


def _throws(engine: Engine, shaft: Shaft) -> str:
    throws = spans(engine, shaft)
    counts = sorted({len(span.throws) for span in throws})
    pins = f" of {' or '.join(map(str, counts))} pins each (split pins)" if counts[-1] > 1 else ""
    between = "one between every two throws" if len(throws) > 1 else "one on either side"
    count = len(main_bearings(engine, shaft))
    return f"{len(throws)} throw{'s' if len(throws) > 1 else ''}{pins}, {count} main bearings where there is {between}"


def _succession(engine: Engine) -> list[str]:
    """The exhaust pulses of banks or manifolds, and neighbours and partners on a pin that fire one after the other."""
    if len(engine.chambers) < FEW or not engine.firing_order:
        return []
    try:
        found = working_cycle(engine)
    except EngineError:  # crankshafts of different speed have no common strokes
        return []
    groups = [group for group in exhaust_groups(engine) if len(group.chambers) > 1]
    told = [_pulses(engine, [Pulses(group.name, exhaust_intervals(found, group.chambers)) for group in groups])]
    pairs = [("neighbours", neighbours_of(engine)), ("partners on a pin", partners(engine))]
    several = [(name, in_succession(found.firing, some)) for name, some in pairs if some and len(_throws_used(engine)) > 1]
    parts = [f"{name} {_steps_text(steps)}" for name, steps in several if steps]
    if parts:
        first, *others = parts
        told.append(_sentence("; so do ".join([f"{first} fire one after the other", *others])))
    elif several:
        told.append(f"No {' or '.join(name for name, _ in several)} fire one after the other.")
    return [sentence for sentence in told if sentence]


def _throws_used(engine: Engine) -> set[tuple[str, int]]:
    return {(cylinder.shaft, cylinder.throw) for cylinder in engine.cylinders}


def _steps_text(steps: Sequence[Follower]) -> str:
    shown = ", ".join(f"{step.first}-{step.then}" for step in steps[:COMPARED])
    return shown + (f" and {len(steps) - COMPARED} more" if len(steps) > COMPARED else "")


def _pulses(engine: Engine, groups: Sequence[Pulses]) -> str:
    """How evenly the exhausts of each of several banks follow each other."""
    if len(groups) < 2:
        return ""  # all cylinders exhaust as they fire
    intervals = {round(step.interval_deg, 3) for group in groups for step in group.steps}
    if len(intervals) == 1:
        return f"Each {groups[0].name.split()[0]} exhausts evenly, every {number(intervals.pop())} deg."
    uneven = [group for group in groups if group.closest.interval_deg < UNEVEN * group.even]
    if not uneven:
        return ""
    parts = [
        f"{one.closest.first} and {one.closest.then} of {one.name} exhaust {number(one.closest.interval_deg)} deg apart"
        + (f" ({'-'.join(number(step.interval_deg, digits=4) for step in one.steps)})" if len(one.steps) <= COMPARED else "")
        for one in uneven[:2]
    ]
    more = f"; so it is in {len(uneven) - 2} more" if len(uneven) > 2 else ""
    kind = uneven[0].name.split()[0]
    burble = ", the burble of a cross-plane V8" if _burbles(engine, groups) else ""
    return f"Cylinders {', and '.join(parts)}{more}: uneven {kind} pulses{burble}."


def _burbles(engine: Engine, groups: Sequence[Pulses]) -> bool:
    """Whether it is a V8 that fires evenly while each of its two banks exhausts 90, 180, 180 and 270 deg apart."""
    sizes = (len(engine.chambers), len(engine.banks), len(groups), *(len(one.steps) for one in groups))
    if engine.cycle != "four-stroke" or sizes != (8, 2, 2, 4, 4):
        return False
    alike = all(np.allclose(sorted(step.interval_deg for step in one.steps), BURBLE, atol=1.0) for one in groups)
    return alike and firing(engine).even


def _quantity(name: str, result: Balance, sums: Totals) -> str:
    """Which orders of force or couple are free, which remain, and as what."""
    spectrum: Spectrum = getattr(sums, name)
    unit = unit_text(getattr(result.units, name))
    orders = orders_present(result, highest=HIGHEST)
    pushed = _pushed(getattr(result, name), orders)
    found = phasor.selected(spectrum, orders)
    sizes = np.abs(found.forward) + np.abs(found.backward)
    # A couple that is nothing beside the forces at a bore pitch is nothing, where no part has an arm.
    scale = max(float(pushed.max(initial=0.0)), NEGLIGIBLE)
    free = [order for order, size in zip(orders, sizes, strict=True) if size <= NEGLIGIBLE * scale]
    left = [place for place, size in enumerate(sizes) if size > NEGLIGIBLE * scale]
    if not left:
        return f"No {name} of any order up to {HIGHEST:g}."
    told: list[str] = []
    for place in left:
        size = number(float(sizes[place]), float(sizes.max()))
        path = shape(phasor.ellipse(complex(found.forward[place]), complex(found.backward[place])))
        path = f", a{'n' if path[0] in 'aeiou' else ''} {path}" if sizes[place] > MINOR * sizes.max() else ""
        told.append(f"order {orders[place]:g}" + (f" remains: {size} {unit}" if not told else f": {size}") + path)
    none = f"No {name} of order {_listed(free)}; " if free else ""
    sentence = none + "; ".join(told) + "."
    return sentence[0].upper() + sentence[1:]


def _pushed(parts: Spectrum, orders: Sequence[float]) -> np.ndarray:
    one = phasor.selected(parts, orders)
    return (np.abs(one.forward) + np.abs(one.backward)).sum(axis=0)


def _listed(orders: Sequence[float]) -> str:
    names = [f"{order:g}" for order in orders]
    return names[0] if len(names) == 1 else f"{', '.join(names[:-1])} and {names[-1]}"


def _roll(result: Balance, sums: Totals) -> str:
    """The inertia torque, which the block feels when a flywheel takes it, and the moment of the forces about the crank axis."""
    unit = unit_text(result.units.roll)
    pushed = float(np.abs(result.torque.forward).sum() + np.abs(result.roll.forward).sum())
    told: list[str] = []
    for signal, words in (
        (sums.torque, "The inertia torque rolls the block where a flywheel takes it, most in order"),
        (sums.roll, "The forces have a moment about the axis of the reference crankshaft, most in order"),
    ):
        sizes = np.abs(phasor.amplitude(signal))
        if sizes.size and sizes.max() > NEGLIGIBLE * pushed:
            place = int(np.argmax(sizes))
            told.append(f"{words} {signal.orders[place]:g}: {number(float(sizes[place]))} {unit}.")
    return " ".join(told) or "No rolling moment from inertia on the block."


def _cures(engine: Engine) -> list[str]:
    """What removes what remains of the first two orders, and what the best balance factor leaves."""
    found = needs(engine)
    told = [_sentence(one) for one in cures(engine, found)] or ["Nothing of the first and second order is left to cure."]
    cranks = tuple(shaft for shaft in engine.shafts if shaft.throws)
    engine = engine.model_copy(update={"shafts": cranks})  # without the balance shafts it may have
    ratios = {shaft.speed_ratio for shaft in cranks}
    if any(need.ratio in ratios for need in needs(without_counterweights(engine), highest=1)):
        fitted, factor = quiet_cranks(engine)
        first = "No balance factor, but weights of their own on the end webs take away what turns with a crankshaft, and"
        if factor is not None:
            scale, unit = (1.0, "m") if "mass" in engine.relative else (1000.0, "g")
            heaviest = scale * max(bobweight(pin, factor) for pin in loads(engine))
            first = f"Counterweights of a balance factor of {factor:g} (heaviest bobweight {number(heaviest)} {unit})"
        if not needs(fitted, highest=1):
            told.append(f"{first} leave nothing of the first order.")
        else:
            told.append(f"{first} leave of the first order {_first_left(fitted)}, turning against the crank.")
    return told


def _first_left(engine: Engine) -> str:
    sums = total(balance(engine))
    out: list[str] = []
    for name, unit in (("force", "m r ω²"), ("couple", "m r ω² a")):
        size = abs(complex(phasor.selected(getattr(sums, name), [1.0]).backward[0]))
        if size > NEGLIGIBLE:
            out.append(f"a {name} of {number(size)} {unit}")
    return " and ".join(out)


def _sentence(text: str) -> str:
    return text[0].upper() + text[1:] + "."


def likeness(engine: Engine) -> Likeness:
    """What the pistons (and rods as bodies) of an engine do, without rotating masses and weights."""
    orders = (1.0, 2.0)
    result = balance(engine, orders=orders)
    rows = [row for row, part in enumerate(result.parts) if part.kind in ("piston", "rod")]
    sizes: list[float] = []
    for order in orders:
        for name in ("force", "couple"):
            one = phasor.selected(phasor.total(getattr(result, name)[rows, :]), [order])
            arm = spacing(engine) / engine.pitch if name == "couple" else 1.0
            sizes.append(float(abs(complex(one.forward[0])) + abs(complex(one.backward[0]))) / arm)
    return Likeness(*(0.0 if size < 1e-6 else size for size in sizes))


def spacing(engine: Engine) -> float:
    """The length in which couples of different engines are compared: between the nearest cylinders of a bank.

    Where no bank has two, between the first and the last of all: there a bore pitch says nothing of arms, and files give what
    they like. A lone cylinder has its pitch.
    """
    place = {cylinder.number: cylinder.z for cylinder in engine.cylinders}
    rows = [sorted(place[number] for number in numbers) for numbers in engine.banks.values()]
    near = [behind - before for row in rows for before, behind in pairwise(row) if behind > before]
    return min(near, default=max(place.values()) - min(place.values()) or engine.pitch)


def _neighbours(engine: Engine) -> list[str]:
    """Engines of the catalog with as many cylinders and the same cycle: which shake alike, and how the others differ."""
    own = likeness(engine)
    count = len(engine.chambers)
    rows = [row for row in summaries() if row.cylinders == count and row.cycle == engine.cycle]
    others = [(row.name, likeness(found)) for row in rows if (found := load(row.name)).name != engine.name]
    if not others:
        return [f"The catalog has no other {engine.cycle} engine with {count} cylinder{'s' if count > 1 else ''}."]
    alike = [name for name, other in others if np.allclose(own, other, rtol=0.05, atol=0.01)]
    told = [f"Its pistons alone, each counted in its own m r ω², shake like those of {_names(alike)}."] if alike else []
    different: dict[Likeness, list[str]] = {}
    for name, other in others:
        if name not in alike:
            key = next((seen for seen in different if np.allclose(seen, other, rtol=0.05, atol=0.01)), other)
            different.setdefault(key, []).append(name)
    arm = "a" if isclose(spacing(engine), engine.pitch) else "times the distance of its cylinders"
    nearest = sorted(different, key=lambda other: float(np.abs(np.subtract(own, other)).sum()))[:COMPARED]
    return told + [
        f"By the pistons alone, beside {_names(different[other])} it has {_difference(own, other, arm)}." for other in nearest
    ]


def _names(names: Sequence[str]) -> str:
    shown = list(names[:5])
    rest = len(names) - len(shown)
    return ", ".join(shown) + (f" and {rest} more" if rest else "")


def _difference(own: Likeness, other: Likeness, arm: str) -> str:
    """The numbers that differ, the largest difference first."""
    names = ("first-order force", "first-order couple", "second-order force", "second-order couple")
    words = dict(zip(Likeness._fields, names, strict=True))
    units = {"force": "m r ω²", "couple": f"m r ω² {arm}"}
    pairs = [(name, mine, theirs) for name, mine, theirs in zip(words, own, other, strict=True) if abs(mine - theirs) > 0.01]
    pairs.sort(key=lambda pair: -abs(pair[1] - pair[2]))
    said = []
    for name, mine, theirs in pairs:
        unit = units[name.split("_")[0]]
        mine_text = "no" if mine == 0 else f"{number(mine, digits=4)} {unit} of"
        theirs_text = "none" if theirs == 0 else number(theirs, digits=4)
        said.append(f"{mine_text} {words[name]} (there {theirs_text})")
    return ", ".join(said)
