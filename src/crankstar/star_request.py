"""What words say of crank stars: how many cylinders, where they stand, which throws are fixed, which star a firing order is."""

from __future__ import annotations

import re
from dataclasses import replace
from fractions import Fraction
from typing import get_args

from crankstar.engine import Engine
from crankstar.fault import counted
from crankstar.quantity import Cycle, one_line
from crankstar.request import RequestError
from crankstar.search import weighed
from crankstar.search.stars import GREATEST_CYLINDERS, Star, Stars


def whole_number(text: str) -> int | None:
    """A number of cylinders, None if the word is none (a name or file then). Raises RequestError where it is none that can be."""
    if not re.fullmatch(r"[-+]?\d+", text.strip(), re.ASCII):
        return None
    if len(text) > 6 or not 2 <= int(text) <= GREATEST_CYLINDERS:
        raise RequestError(f"{one_line(text)} is no number of cylinders that have a star; it can be from 2 to {GREATEST_CYLINDERS}")
    return int(text)


def stars_of(
    cylinders: int | Engine, cycle: str | None, *, pitch: str | None, fix: str | None, symmetric: bool, faults: list[str]
) -> Stars:
    """The stars that are meant; mistakes in the words are told in `faults`, and what they would say left out."""
    if cycle is not None and cycle not in get_args(Cycle):
        faults.append(f"--cycle {one_line(cycle)}: it can be {', '.join(get_args(Cycle))}")
        cycle = None
    if isinstance(cylinders, Engine):
        if cycle not in (None, cylinders.cycle):
            faults.append(
                f"--cycle {cycle}: {cylinders.name} is a {cylinders.cycle}; leave --cycle out, or change the engine's own"
            )
        if pitch:
            faults.append("--pitch: the places of an engine's cylinders are in its file; leave it out")
        base = weighed.stars_of(cylinders)
        number, kind, positions = base.cylinders, base.cycle, base.positions
    else:
        number, kind = cylinders, cycle or "four-stroke"
        positions = _positions(pitch, number, faults)
    base = Stars(number, kind, positions)  # pyright: ignore[reportArgumentType]
    if symmetric and base.sharing == 2 and base.evenly_placed:
        base = replace(base, symmetric=True)
    elif symmetric:
        faults.append("--symmetric: only a four-stroke engine with an even number of evenly placed cylinders has symmetric cranks")
    told = len(faults)
    fixed = _fixed(fix, base, faults)
    return base if len(faults) > told else replace(base, fixed=fixed)


def _positions(text: str | None, number: int, faults: list[str]) -> tuple[Fraction, ...]:
    """Places from the gaps between the cylinders, from the front, in units of the pitch; measured from the middle."""
    gaps = [Fraction(1)] * (number - 1)
    if text is not None:
        given = [fraction(part) for part in text.split(",")]
        if any(gap is None or not 0 < gap <= 1000 for gap in given):
            faults.append(f"--pitch {one_line(text)}: give the gaps from the front, in pitches, greater than 0, as in 1,1,1.5,1")
        elif len(given) != number - 1:
            faults.append(
                f"--pitch: has {counted(len(given), 'gap')}; {number} cylinders have {number - 1} (from the front, in pitches)"
            )
        else:
            gaps = [gap for gap in given if gap is not None]
    places = [Fraction(0)]
    for gap in gaps:
        places.append(places[-1] - gap)
    middle = (places[0] + places[-1]) / 2
    return tuple(place - middle for place in places)


def _fixed(text: str | None, stars: Stars, faults: list[str]) -> tuple[tuple[int, int], ...]:
    """Directions that cylinders must have: `1=0, 4=3`."""
    if text is None:
        return ()
    found: dict[int, int] = {}
    for part in text.split(","):
        match = re.fullmatch(r"\s*(\d{1,3})\s*=\s*(\d{1,3})\s*", part, re.ASCII)
        if match is None:
            faults.append(f"--fix {one_line(part)}: give cylinder = direction, as in 1=0,4=3")
            continue
        cylinder, direction = int(match[1]), int(match[2])
        if not 1 <= cylinder <= stars.cylinders:
            faults.append(f"--fix {one_line(part)}: there is no cylinder {cylinder}; there are 1 to {stars.cylinders}")
        elif not direction < stars.directions:
            angle = f"d means {360 / stars.directions:.4g} d deg behind direction 0"
            faults.append(
                f"--fix {one_line(part)}: there is no direction {direction}; there are 0 to {stars.directions - 1}, {angle}"
            )
        elif found.setdefault(cylinder, direction) != direction:
            faults.append(f"--fix {one_line(part)}: cylinder {cylinder} has direction {found[cylinder]} already")
    for direction in sorted(set(found.values())):
        held = {min(c, stars.cylinders + 1 - c) if stars.symmetric else c for c in found if found[c] == direction}
        if len(held) > stars.each:
            room = f"{stars.sharing} cylinder{'s' if stars.sharing > 1 else ''}"
            told = ", ".join(str(c) for c in sorted(found) if found[c] == direction)
            faults.append(f"--fix: cylinders {told} cannot all have direction {direction}; each has room for {room}")
    if stars.symmetric:
        for cylinder in found:
            other = stars.cylinders + 1 - cylinder
            if other in found and found[other] != found[cylinder] and cylinder < other:
                faults.append(f"--fix: with --symmetric, cylinders {cylinder} and {other} have the same direction")
    return tuple(sorted(found.items()))


def star_of(text: str, stars: Stars) -> Star | None:
    """The star of a firing order, where it settles the star; None if it is no order of these cylinders."""
    words = re.split(r"[-,\s]+", text.strip())
    if not all(re.fullmatch(r"\d{1,3}", word, re.ASCII) for word in words):
        return None
    order = [int(word) for word in words]
    if sorted(order) != list(range(1, stars.cylinders + 1)):
        return None
    step = stars.step or 1
    directions = {number: place * step % stars.directions for place, number in enumerate(order)}
    return tuple(directions[number] for number in range(1, stars.cylinders + 1))


def fraction(text: str) -> Fraction | None:
    """A decimal number or fraction exactly; None if it is none, or longer than a number is."""
    text = text.strip()
    form = r"[-+]?(\d{1,12}(\.\d{0,12})?|\.\d{1,12})(/\d{1,6}|[eE][-+]?\d{1,2})?"
    if not re.fullmatch(form, text, re.ASCII) or text.endswith("/0"):
        return None
    try:
        return Fraction(text)
    except (ValueError, ZeroDivisionError):
        whole, _, part = text.partition("/")
        return Fraction(whole) / int(part) if part and int(part) else None
