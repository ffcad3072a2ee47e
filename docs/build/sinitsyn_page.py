"""The parts of the page on Sinitsyn's engines, computed when the page is built."""

from __future__ import annotations

from cmath import phase
from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise, permutations
from math import cos, degrees, pi, radians, sin, trunc
from typing import Any

import numpy as np

import crankstar
from crankstar import charts
from crankstar.derive import signs, signs_chapter
from crankstar.derive.algebra import cyclotomic, wave
from crankstar.derive.algebra.formula import Symbol, has_decimal, product
from crankstar.derive.cure import Cure, cure
from crankstar.derive.documents import math
from crankstar.derive.notations import SINITSYN, notated
from crankstar.language.numbers import number
from crankstar.remedy import end_planes, end_webs, with_balance_shaft, with_counterweights

WEIGHT = "#d55e00"
NO_SHORT_FORM = " has no short closed form; its square x is exactly a root of "
"""What a derivation says between a length and its equation."""
NO_BREAK = "\N{NON-BREAKING HYPHEN}"
"""Keeps a firing order in a cell on one line."""
SAME = 1e-12
"""Within this, sums of cosines are the same."""


@dataclass(frozen=True)
class Printed:
    """One printed sum of the chapter: length and angle (degrees), with their last places."""

    sums: str
    length: str
    angle: str
    value: float
    step: float = 0.0


@dataclass(frozen=True)
class Scheme:
    """One engine of the chapter: catalog file, title, other orders, printed values."""

    file: str
    called: str
    anchor: str
    others: tuple[str, ...] = ()
    printed: tuple[Printed, ...] = ()


SCHEMES = {
    "6-valve": Scheme(
        "sinitsyn-6-valve",
        "two-stroke six, valve scavenged",
        "two-stroke-six-valve-scavenged",
        ("sinitsyn-6-valve-mirror",),
        (Printed("M_R and M_I", "2√3", "30", 2 * 3**0.5),),
    ),
    "6-loop": Scheme(
        "sinitsyn-6-loop",
        "two-stroke six, loop scavenged",
        "two-stroke-six-loop-scavenged",
        ("sinitsyn-6-loop-mirror",),
        (Printed("M_I", "0", "", 0.0), Printed("M_II", "2√3", "-30", 2 * 3**0.5)),
    ),
    "7-first": Scheme(
        "sinitsyn-7-first",
        "seven, first scheme",
        "seven-first-scheme",
        (
            "sinitsyn-7-first-mirror",
            "sinitsyn-7-first-four-stroke",
            "sinitsyn-7-first-four-stroke-mirror",
        ),
        (
            Printed("M_R and M_I", "0.85", "-70", 0.85, 0.01),
            Printed("M_II", "5.52", "-57", 5.52, 0.01),
        ),
    ),
    "7-second": Scheme(
        "sinitsyn-7-second",
        "seven, second scheme",
        "seven-second-scheme",
        ("sinitsyn-7-second-four-stroke",),
        (Printed("M_R and M_I", "0.27", "-64", 0.27, 0.01), Printed("M_II", "1", "-38", 1.0, 1.0)),
    ),
    "8-four-stroke": Scheme(
        "sinitsyn-8-four-stroke-1",
        "four-stroke eight",
        "four-stroke-eight",
        ("sinitsyn-8-four-stroke-2", "sinitsyn-8-four-stroke-3", "sinitsyn-8-four-stroke-4"),
        (Printed("M_R and M_I", "0", "", 0.0), Printed("M_II", "0", "", 0.0)),
    ),
    "8-two-stroke": Scheme(
        "sinitsyn-8-two-stroke",
        "two-stroke eight",
        "two-stroke-eight-the-unfinished-problem",
        ("sinitsyn-8-two-stroke-mirror",),
    ),
}
"""By the name that a marker gives it. What is printed is quoted; everything else is computed."""


def page(part: str) -> str:
    """A part of the page: `table` of all engines, `forces` of one, or everything about one."""
    if part == "table":
        return table()
    if part == "forces":
        return forces()
    return about(SCHEMES[part])


# Numbers


@lru_cache
def sums(file: str) -> dict[str, complex]:
    """The six sums of an engine of the catalog; see `sums_of`."""
    return sums_of(crankstar.load(file))


def sums_of(engine: crankstar.Engine) -> dict[str, complex]:
    """The six sums as vectors at theta = 0, their bearings in the direction of rotation.

    Exact zeros are 0.
    """
    out: dict[str, complex] = {}
    with cyclotomic.precision(cyclotomic.DIGITS):
        for sign in signs(engine):
            if sign.along is None or not sign.exact:
                raise ValueError(f"{engine.name}: {sign.letter}_{sign.below} is not exact")
            out[f"{sign.letter}_{sign.below}"] = complex(
                sum(complex(amount) for amount in sign.along.values())
            )
    return out


def neighbours(order: Sequence[int]) -> list[tuple[int, int]]:
    """Neighbouring cylinders that fire one after the other, round the cycle."""
    return [(one, other) for one, other in pairwise([*order, order[0]]) if abs(one - other) == 1]


def relation(file: str, other: str) -> str:
    """How the sums of another engine compare.

    The `same`, or `mirrored`, at angles of the other sign. Raises ValueError.
    """
    mine, theirs = sums(file), sums(other)
    if all(abs(mine[key] - theirs[key]) < SAME for key in mine):
        return "same"
    if all(abs(mine[key].conjugate() - theirs[key]) < SAME for key in mine):
        return "mirrored"
    raise ValueError(f"{other} has other sums than {file}")


@dataclass(frozen=True)
class Search:
    """All stars of a two-stroke engine.

    How many there are, how many have no moment of one order, and the best of these.
    """

    stars: int
    without: int
    least: float
    orders: tuple[tuple[int, ...], ...]
    least_symmetric: float
    least_double_cross: float
    first_orders: int


@lru_cache
def search(count: int, *, without: int) -> Search:
    """All stars of even cranks without a moment of order `without`, and the least other moment.

    The other order is 1 or 2.

    `least_symmetric` is that among stars whose second-order vectors are symmetric along the shaft:
    cylinders as far from the front as from the rear have cranks on one line through the shaft.
    `least_double_cross` is that of those in which the two outer pairs of vectors lie on one line,
    opposite to each other, and so do the two inner pairs; `first_orders` counts the stars that
    have the same vectors of the second order as the first of these.
    """
    seats = np.array([[0, *rest] for rest in permutations(range(1, count))])
    arms = count - 1 - 2 * np.arange(count)
    whole = np.zeros((len(seats), count), dtype=int)
    for cylinder, arm in enumerate(arms):
        np.add.at(whole, (np.arange(len(seats)), without * seats[:, cylinder] % count), arm)
    free = seats[cyclotomic.vanishing(whole)]
    left = np.abs((np.exp(2j * pi * (3 - without) * free / count) * arms / 2).sum(axis=1))
    best = free[left < left.min() + 1e-9]
    paired = ((free - free[:, ::-1]) % count == count // 2).all(axis=1)
    orders = tuple(sorted(tuple(int(i) + 1 for i in np.argsort(star)) for star in best))
    second = 2 * free % count
    crossed = paired & ((second[:, ::2] - second[:, 1::2]) % count == count // 2).all(axis=1)
    same = (second == second[crossed][0]).all(axis=1) if crossed.any() else crossed
    return Search(
        len(seats),
        len(free),
        float(left.min()),
        orders,
        float(left[paired].min()) if paired.any() else float("nan"),
        float(left[crossed].min()) if crossed.any() else float("nan"),
        int(same.sum()),
    )


# Cures


def _loaded(file: str) -> crankstar.Engine:
    """The engine with rotating masses on its cranks, as great as the reciprocating ones."""
    return crankstar.load(file, changes={"cylinder.rotating_mass": 1.0})


def _without_pistons(engine: crankstar.Engine) -> crankstar.Engine:
    cylinders = tuple(
        cylinder.model_copy(update={"reciprocating_mass": 0.0}) for cylinder in engine.cylinders
    )
    return engine.model_copy(update={"cylinders": cylinders})


def weighted(file: str) -> crankstar.Engine:
    """The engine with rotating masses equal to the reciprocating ones, and their end weights."""
    engine = _loaded(file)
    return (
        with_counterweights(engine, factor=0, planes=end_webs(engine, engine.shafts[0]))
        if sums(file)["M_R"]
        else engine
    )


def cured(file: str) -> crankstar.Engine:
    """The engine with end weights and all its two-shaft mechanisms on both sides."""
    engine = weighted(file)
    for ratio in mechanisms(file):
        for way, side in ((ratio, -1), (-ratio, 1)):
            engine = with_balance_shaft(
                engine, ratio=way, planes=end_planes(engine), right=side * 3.0 * ratio
            )
    return engine


def mechanisms(file: str) -> list[int]:
    """The speeds, per turn of the crankshaft, of the two-shaft mechanisms that an engine needs."""
    found = sums(file)
    return [ratio for ratio, key in ((1, "M_I"), (2, "M_II")) if found[key]]


@lru_cache
def cures(file: str) -> dict[str, Cure]:
    """The exact weights: `crank` on the outermost webs, in m_R r.

    `1`, `-1`, `2`, `-2` on shafts of that speed, in m r A_k.
    """
    engine = crankstar.load(file)
    out: dict[str, Cure] = {}
    if sums(file)["M_R"]:
        out["crank"] = cure(
            _without_pistons(_loaded(file)), ratio=1, planes=end_webs(engine, engine.shafts[0])
        )
    for ratio in mechanisms(file):
        for way in (ratio, -ratio):
            out[str(way)] = cure(engine, ratio=way, planes=end_planes(engine))
    unproved = [key for key, one in out.items() if not one.proved]
    if unproved:
        raise ValueError(f"{file}: it is not proved that {', '.join(unproved)} leaves nothing")
    return out


# Words


def table() -> str:
    """All engines: firing order, remaining moments, neighbours in succession, remedies."""
    lines = [
        "| engine | firing order | M_R = M_I | M_II | neighbours in succession | to balance it |",
        "|---|---|---|---|---|---|",
    ]
    for scheme in SCHEMES.values():
        engine, found = crankstar.load(scheme.file), sums(scheme.file)
        cells = [
            f"[{scheme.called}](#{scheme.anchor})",
            _order(engine.firing_order).replace("-", NO_BREAK),
            _vector(found["M_I"]),
            _vector(found["M_II"]),
            _pairs(neighbours(engine.firing_order)),
            _needed(scheme.file),
        ]
        lines.append(f"| {' | '.join(cells)} |")
    return (
        "\n".join(lines)
        .replace("M_R = M_I", f"{_sum('M_R')} = {_sum('M_I')}")
        .replace("M_II", _sum("M_II"))
    )


def _needed(file: str) -> str:
    parts = (["end weights"] if sums(file)["M_R"] else []) + [
        f"two shafts at {ratio}×" for ratio in mechanisms(file)
    ]
    return ", ".join(parts) or "no weights"


def forces() -> str:
    """The force polygons of an engine, as an example of polygons that close."""
    engine = crankstar.load(SCHEMES["7-first"].file)
    return _figures(
        [
            _drawn(
                charts.polygon(engine, order=k, quantity="force"),
                f"Force polygon of order {k}, {engine.name}",
            )
            for k in (1, 2)
        ]
    )


def about(scheme: Scheme) -> str:
    """All about one engine."""
    engine = crankstar.load(scheme.file)
    first = f"Firing order **{_order(engine.firing_order)}**; {_succession(engine.firing_order)}."
    parts = [
        f"{first} In the catalog it is `{scheme.file}`.",
        _six(scheme.file),
        *_algebraic(engine),
        _printed(scheme),
        *_extra(scheme),
        _weights(scheme.file),
        _figures(_pictures(scheme.file)),
        _others(scheme),
    ]
    return "\n\n".join(part for part in parts if part)


def _order(order: Sequence[int]) -> str:
    return "-".join(map(str, order))


def _pairs(pairs: Sequence[tuple[int, int]]) -> str:
    return ", ".join(f"{one}-{other}" for one, other in pairs) or "none"


def _succession(order: Sequence[int]) -> str:
    pairs = neighbours(order)
    return (
        f"neighbours that fire in succession: {_pairs(pairs)}"
        if pairs
        else "no neighbours fire in succession"
    )


def _sum(key: str) -> str:
    """A sum's letter, its index lowered."""
    letter, below = key.split("_")
    return f"{letter}<sub>{below}</sub>"


def _told(words: str) -> str:
    return " ".join(_sum(word) if "_" in word else word for word in words.split(" "))


def _degrees(vector: complex) -> str:
    return f"{number(round(degrees(phase(vector)), 2), 180.0)}°".replace("-", "−")


def _vector(vector: complex) -> str:
    """Length and angle as decimals; 0 is an exact zero."""
    return f"{abs(vector):.4f} at {_degrees(vector)}" if vector else "0"


def _six(file: str) -> str:
    """The six signs in closed form."""
    engine, found = crankstar.load(file), sums(file)
    (step,) = notated(signs_chapter(engine), SINITSYN).steps
    shown = dict(zip(found, (line.chain[-1] for line in step.lines), strict=True))
    lines = [
        "| the six signs | rotating masses | first order | second order |",
        "|---|---|---|---|",
    ]
    for letter, name in (("P", "force"), ("M", "moment")):
        cells = []
        for below in ("R", "I", "II"):
            key = f"{letter}_{below}"
            decimals = f"<br>{_vector(found[key])}" if found[key] else ""
            cells.append(f"{_sum(key)} = {math(shown[key])}{decimals}")
        lines.append(f"| {name} | {' | '.join(cells)} |")
    return "\n".join(lines)


def _algebraic(engine: crankstar.Engine) -> list[str]:
    """Lengths without a short closed form; one sentence if both solve one equation."""
    found = []
    for order in (1, 2):
        words = [
            words
            for step in crankstar.derivation(engine, order, "couple").steps
            for words in step.words
        ]
        found += [one.split(NO_SHORT_FORM) for one in words if NO_SHORT_FORM in one][:1]
    if len(found) == 2 and found[0][1] == found[1][1]:
        equation = found[0][1]
        return [
            (
                f"{found[0][0]} and {found[1][0]} have no short closed form; "
                f"their squares are exactly two roots of {equation}"
            )
        ]
    return [" ".join(NO_SHORT_FORM.join(one) for one in found)] if found else []


def _printed(scheme: Scheme) -> str:
    """What the chapter prints beside what is true."""
    if not scheme.printed:
        return ""
    lines = ["| sum | the chapter prints | computed | verdict |", "|---|---|---|---|"]
    for one in scheme.printed:
        true = sums(scheme.file)["M_II" if one.sums == "M_II" else "M_I"]
        angle = f" at {one.angle}°".replace("-", "−") if one.angle else ""
        lines.append(
            f"| {_told(one.sums)} | {one.length}{angle} | {_vector(true)} | {verdict(one, true)} |"
        )
    return "\n".join(lines)


def verdict(one: Printed, true: complex) -> str:
    """Whether what is printed is what is true, as finely as it is printed."""
    if not abs(abs(true) - one.value) <= one.step / 2 + SAME:
        return "the length is wrong"
    if not one.angle:
        return "correct"
    angle, printed = degrees(phase(true)), int(one.angle)
    if abs(angle - printed) <= 0.5:
        return "correct"
    if trunc(angle) == printed:
        return f"correct; the angle is cut, not rounded to {round(angle)}°".replace("-", "−")
    return "the angle is wrong"


def _weights(file: str) -> str:
    """The end weights and the mechanisms, in closed form."""
    found = cures(file)
    if not found:
        return "All moments are zero: no weights are needed."
    lines = [
        "| weights on | cancel | unbalance of each | front end | rear end | remaining |",
        "|---|---|---|---|---|---|",
    ]
    for key, one in found.items():
        front, rear = (complex(amount) for amount in one.unbalance)
        place = number(float(one.planes[0]))
        cells = [
            ("the outermost webs" if key == "crank" else _shaft(one.ratio))
            + f", z&nbsp;=&nbsp;±{place}&nbsp;l₀",
            _sum("M_R")
            if key == "crank"
            else f"half of {_sum('M_I' if abs(one.ratio) == 1 else 'M_II')}",
            _unbalance(one, rotating=key == "crank"),
            _degrees(front),
            _degrees(rear),
            "exactly 0, proved",
        ]
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def _shaft(ratio: Fraction) -> str:
    return f"shaft {'with' if ratio > 0 else 'against'} the crank, {abs(ratio)}×"


def _unbalance(one: Cure, *, rotating: bool) -> str:
    units = [Symbol("m", "R") if rotating else Symbol("m"), Symbol("r")]
    if one.harmonic not in (None, 1):
        units.append(Symbol("A", str(one.harmonic)))
    length = wave.length(one.unbalance[0])
    decimals = f"<br>{abs(complex(one.unbalance[0])):.4f}" if not has_decimal(length) else ""
    return math(product(*units, length)) + decimals


def _others(scheme: Scheme) -> str:
    """Other orders with the same sums, each with its neighbours in succession."""
    told: dict[str, list[str]] = {"same": [], "mirrored": []}
    for other in scheme.others:
        engine = crankstar.load(other)
        told[relation(scheme.file, other)].append(
            f"{_order(engine.firing_order)} ({engine.cycle}; {_succession(engine.firing_order)})"
        )
    out = []
    if told["same"]:
        out.append(f"The same sums: {', '.join(told['same'])}.")
    if told["mirrored"]:
        out.append(
            f"Mirrored, with the same sums at opposite angles: {', '.join(told['mirrored'])}."
        )
    return " ".join(out)


def _extra(scheme: Scheme) -> list[str]:
    """What only one engine has: a search through all stars, a comparison."""
    words = ""
    if scheme.file == "sinitsyn-6-loop":
        found = search(6, without=1)
        words = (
            f"Of the {found.stars} stars of six cranks {found.without} have no primary moment. The "
            f"smallest secondary moment among them is {found.least:.4f}, and only "
            f"{' and '.join(map(_order, found.orders))} have it: his choice is the best."
        )
    if scheme.file == "sinitsyn-8-two-stroke":
        found = search(8, without=2)
        words = (
            f"Of the {found.stars} stars of eight cranks {found.without} have no secondary moment. "
            f"The smallest primary moment among them is {found.least:.4f}, of "
            f"{' and '.join(map(_order, found.orders))}. Stars that are symmetric along the "
            "shaft in the second order (1 with 8, 2 with 7, 3 with 6, 4 with 5) reach "
            f"{found.least_symmetric:.4f}. The variant with which the chapter begins, a double "
            "cross of the outer pairs (1-8 against 2-7) and the inner pairs (3-6 against 4-5), "
            f"reaches {found.least_double_cross:.4f}. To each star of the second order of this "
            f"kind belong {found.first_orders} of the first, with crank 1 up; the chapter has two."
        )
    if scheme.file == "sinitsyn-7-second":
        first, second = sums("sinitsyn-7-first"), sums(scheme.file)
        one, two = (abs(first[key]) / abs(second[key]) for key in ("M_I", "M_II"))
        words = (
            f"Compared with the first scheme, {_sum('M_R')} and {_sum('M_I')} are {one:.2f} times "
            f"smaller, {_sum('M_II')} is {two:.2f} times smaller (the chapter: 3 and 5.5)."
        )
    return [words] if words else []


# Pictures


def _pictures(file: str) -> list[str]:
    """Crank star, crankshaft with end weights, stars, moment polygons and mechanisms."""
    engine = crankstar.load(file)
    weights = " with its end weights" if sums(file)["M_R"] else ""
    out = [
        _drawn(charts.crank_star(engine), f"Crank star, {engine.name}"),
        _drawn(
            charts.shaft_elevation(weighted(file)),
            f"Crankshaft{weights} from the side, {engine.name}",
        ),
    ]
    out += [
        _drawn(
            charts.vector_star(engine, order=k, quantity="force"),
            f"Star of the vectors of order {k}, {engine.name}",
        )
        for k in (1, 2)
    ]
    out += [
        _drawn(
            charts.polygon(engine, order=k, quantity="couple"),
            f"Moment polygon of order {k}, {engine.name}",
        )
        for k in (1, 2)
    ]
    found = cures(file)
    return out + [
        _mechanism(found[str(ratio)], found[str(-ratio)], engine.name) for ratio in mechanisms(file)
    ]


def _drawn(chart: Any, title: str) -> str:
    return charts.svg(chart, title).replace(charts.GREY, "currentColor")


def _figures(drawings: Sequence[str]) -> str:
    figures = "\n".join(f'<figure class="erratum">{drawing}</figure>' for drawing in drawings)
    return f'<div class="errata" markdown="0">\n{figures}\n</div>'


def _mechanism(ahead: Cure, against: Cure, name: str) -> str:
    """Two shafts from the front at theta = 0: front weight filled, rear weight hollow."""
    ratio = abs(ahead.ratio)
    parts = [
        f"<title>Two-shaft mechanism at {ratio} times the speed of the crankshaft, {name}</title>",
        _text(8, 18, f"Two shafts at {ratio}× from the front, at θ = 0", size=14, anchor="start"),
        _text(8, 36, "full: weight at the front end, hollow: rear end", anchor="start"),
        '<path d="M195 58V236" stroke="currentColor" stroke-dasharray="4 4"/>',
        _text(195, 250, "plane of the cylinders"),
    ]
    for one, x, way in ((ahead, 95, 1), (against, 295, -1)):
        parts.append(_text(x, 66, f"{'with' if way > 0 else 'against'} the crank"))
        parts.append(
            f'<circle cx="{x}" cy="146" r="48" fill="none" stroke="currentColor" '
            'stroke-opacity=".3"/>'
        )
        front, rear = (phase(complex(amount)) for amount in one.unbalance)
        for bearing, full in ((front, True), (rear, False)):
            along, down = x + 48 * sin(bearing), 146 - 48 * cos(bearing)
            parts.append(
                f'<path d="M{x} 146L{along:.2f} {down:.2f}" stroke="currentColor" '
                'stroke-width="2"/>'
            )
            inside = WEIGHT if full else "var(--md-default-bg-color, white)"
            parts.append(
                f'<circle cx="{along:.2f}" cy="{down:.2f}" r="11" fill="{inside}" '
                f'stroke="{WEIGHT}" stroke-width="3"/>'
            )
        parts.append(f'<circle cx="{x}" cy="146" r="5" fill="currentColor"/>')
        parts.append(_turning(x, 146, 24, way))
        parts.append(_text(x, 226, f"front {_degrees(complex(one.unbalance[0]))}"))
    drawing = "".join(parts)
    return (
        '<svg role="img" viewBox="0 0 390 260" fill="currentColor" '
        f'font-family="sans-serif">{drawing}</svg>'
    )


def _turning(x: float, y: float, radius: float, way: int) -> str:
    """An arc with a head, clockwise or against it."""
    begin, end = (radians(way * bearing) for bearing in (-60, 60))
    x0, y0, x1, y1 = (
        x + radius * sin(begin),
        y - radius * cos(begin),
        x + radius * sin(end),
        y - radius * cos(end),
    )
    ahead, aside = (way * cos(end), way * sin(end)), (sin(end), -cos(end))
    head = [
        (x1 + on * ahead[0] + off * aside[0], y1 + on * ahead[1] + off * aside[1])
        for on, off in ((11, 0), (0, 5), (0, -5))
    ]
    points = " ".join(f"{a:.2f},{b:.2f}" for a, b in head)
    arc = (
        f'<path d="M{x0:.2f} {y0:.2f}A{radius:g} {radius:g} 0 0 {int(way > 0)} '
        f'{x1:.2f} {y1:.2f}" fill="none"'
    )
    return f'{arc} stroke="currentColor" stroke-width="2"/><polygon points="{points}"/>'


def _text(x: float, y: float, words: str, *, size: int = 13, anchor: str = "middle") -> str:
    return f'<text x="{x:g}" y="{y:g}" font-size="{size}" text-anchor="{anchor}">{words}</text>'
