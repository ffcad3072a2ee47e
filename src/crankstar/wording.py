"""Numbers, amplitudes, paths and firing orders as an engineer writes them, and tables in one style."""

from __future__ import annotations

import re
from collections.abc import Sequence
from io import StringIO
from math import degrees

import numpy as np
from rich import box
from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from crankstar import phasor
from crankstar.engine import Engine
from crankstar.firing import Firing, firing
from crankstar.remedy import Need
from crankstar.valves import Timing, timing

NEGLIGIBLE = 1e-9
"""A number smaller than this share of the largest beside it is written as 0."""


def heading(engine: Engine) -> RenderableType:
    """Name, cycle, rotation, firing order with its intervals."""
    count = len(engine.chambers)
    pistons = f", {len(engine.cylinders)} pistons" if len(engine.cylinders) != count else ""
    lines = [Text(engine.name, style="bold")]
    lines.append(
        Text(f"{engine.cycle}, {count} cylinder{'s' if count > 1 else ''}{pistons}, turning {engine.rotation} seen from the front")
    )
    if engine.firing_order:
        lines.append(Text(firing_sentence(firing(engine))))
    return Group(*lines)


def firing_sentence(fired: Firing) -> str:
    """The firing order and its intervals: `fires 1-3-4-2 every 180 deg`."""
    order = "-".join(map(str, fired.order))
    if fired.even:
        return f"fires {order} every {number(fired.intervals_deg[0])} deg"
    return f"fires {order} at intervals of {'-'.join(number(x, digits=4) for x in fired.intervals_deg)} deg"


def timing_lines(engine: Engine) -> list[str]:
    """When valves or ports open and close, what of that is assumed, and which exhausts the engine file joins.

    >>> from crankstar.catalog import load
    >>> timing_lines(load("kr250-racer"))[1]
    'exhaust ports or valves: open 85 deg (assumed) before bottom dead centre, close 85 deg (assumed) after bottom dead centre'
    """
    found = timing(engine.valves, cycle=engine.cycle)
    ports, apart = ("ports or valves", "bottom") if engine.cycle == "two-stroke" else ("valves", "top")
    lines = []
    for side, opens, closes in (("intake", apart, "bottom"), ("exhaust", "bottom", apart)):
        verbs = (("open", f"{side}_opens", "before", opens), ("close", f"{side}_closes", "after", closes))
        told = [f"{verb} {_timed(found, name)} {when} {which} dead centre" for verb, name, when, which in verbs]
        lines.append(f"{side} {ports}: {', '.join(told)}")
    if engine.valves is not None and engine.valves.manifolds:
        lines.append(f"exhaust manifolds: {'; '.join(', '.join(map(str, one)) for one in engine.valves.manifolds)}")
    return lines


def _timed(found: Timing, name: str) -> str:
    return f"{number(degrees(getattr(found, name)), 180.0)} deg" + (" (assumed)" if name in found.assumed else "")


def wave(value: complex, largest: float = 0.0) -> str:
    """A complex amplitude as `a ∠ p°`."""
    size = abs(complex(value))
    if size <= NEGLIGIBLE * largest or size == 0:
        return "0"
    phase = round(degrees(np.angle(value)), 2)
    return f"{number(size)} ∠ {0.0 if phase == 0 else 180.0 if phase == -180 else phase:g}°"


def shape(path: phasor.Ellipse, largest: float = 0.0) -> str:
    """An ellipse in words: circle, line or ellipse, its bearing, and which way it is run through."""
    if path.semi_major <= NEGLIGIBLE * largest or path.semi_major == 0:
        return "none"
    way = "with the crank" if path.sense > 0 else "against the crank"
    bearing = round(degrees(path.bearing), 2)
    bearing = 90.0 if bearing == -90 else bearing + 0.0
    if path.semi_minor <= NEGLIGIBLE * path.semi_major:
        names = {0.0: "vertical line", 90.0: "horizontal line"}
        return names.get(bearing, f"line at {bearing:g}°")
    if path.semi_major - path.semi_minor <= NEGLIGIBLE * path.semi_major:
        return f"circle {way}"
    return f"ellipse {path.semi_minor / path.semi_major:.3g}:1 at {bearing:g}°, {way}"


def number(value: float, largest: float = 0.0, *, digits: int = 5) -> str:
    """A number to five figures, without an exponent where it can be done, and 0 where it is nothing beside `largest`."""
    value = float(value)
    if abs(value) <= NEGLIGIBLE * largest or value == 0:
        return "0"
    if 1e5 <= abs(value) < 1e9:
        return f"{value:.0f}"
    return f"{value:.{digits}g}"


def duration(seconds: float) -> str:
    """A time in words, to what matters: `3 s`, `4 min`, `2.5 h`, `12 days`.

    >>> duration(0.2), duration(200), duration(9000), duration(1e6), duration(1e10)
    ('1 s', '3 min', '2.5 h', '12 days', '317 years')
    """
    if seconds < 100:
        return f"{max(1, round(seconds))} s"
    for unit, size, most, decimals in (("min", 60, 100, 0), ("h", 3600, 48, 1), ("days", 86400, 1000, 0)):
        if seconds < most * size:
            return f"{seconds / size:.{decimals}f} {unit}"
    return f"{seconds / 31_557_600:,.0f} years"


def html(renderable: RenderableType) -> str:
    """A renderable as HTML for a notebook; every text in it is escaped."""
    console = Console(record=True, file=StringIO(), width=140, force_jupyter=False, markup=False)
    console.print(renderable)
    return console.export_html(inline_styles=True, code_format="<pre style='line-height:1.3'>{code}</pre>")


def bearing_text(vector: complex) -> str:
    """The bearing of a vector in degrees, in (-180, 180]."""
    bearing = round(degrees(np.angle(vector)), 3)
    return number(180.0 if bearing == -180 else bearing, 180.0)


def unit_text(unit: str) -> str:
    """A unit of a Balance in print: m r² ω² for m*r^2*w^2, with A2 for A_2 (fonts of figures lack small digits)."""
    plain = unit.replace("w^2", "ω²").replace("r^2", "r²").replace("*", " ")
    return re.sub(r"_(\d+)", r"\1", plain)


def table(*heads: str, left: Sequence[str] = (), folded: Sequence[str] = ()) -> Table:
    """An empty table with these heads, numbers to the right, the heads in `left` to the left.

    Only the columns in `folded` give way where the table is too wide: a number is never cut.
    """
    out = Table(box=box.SIMPLE_HEAD, pad_edge=False, show_edge=False, header_style="", padding=(0, 1), collapse_padding=True)
    for head in heads:
        out.add_column(Text(head), justify="left" if head in left else "right", overflow="fold", no_wrap=head not in folded)
    return out


def titled(title: str, body: RenderableType) -> RenderableType:
    """A table under its title, with a blank line before it."""
    return Group(Text(), Text(title, style="bold"), body)


def least_width(renderable: RenderableType, console: Console) -> int:
    """The columns a renderable needs so that no number in its tables is cut."""
    if isinstance(renderable, Group):
        return max((least_width(part, console) for part in renderable.renderables), default=0)
    if isinstance(renderable, Table) and all(column.no_wrap for column in renderable.columns):
        return console.measure(renderable, options=console.options.update(max_width=10_000)).maximum
    return 0


EQUAL = 1e-2
"""Two vectors that differ by no more than this share are called a pair."""


def cures(engine: Engine, found: Sequence[Need]) -> list[str]:
    """What would take away the vectors an engine is left with, a sentence for each, or for a pair of shafts that do it together.

    >>> from crankstar.catalog import load
    >>> from crankstar.remedy import needs
    >>> cures(load("i4"), needs(load("i4")))
    ['order 2, force: a pair of shafts of speed ratios 2 and -2 (Lanchester)']
    """
    cranks = {shaft.speed_ratio: shaft.name for shaft in reversed(engine.shafts) if shaft.throws}
    weighted = {shaft.speed_ratio: bool(shaft.weights) for shaft in engine.shafts if shaft.throws}
    by_ratio = {need.ratio: need for need in found}
    out: list[str] = []
    for need in found:
        other = by_ratio.get(-need.ratio)
        paired = other is not None and _alike(need, other) and not {need.ratio, -need.ratio} & set(cranks)
        what = " and ".join(name for name, vector in (("force", need.force), ("couple", need.couple)) if vector)
        if paired:
            if need.ratio > 0:
                ratios = f"{need.ratio} and -{need.ratio}"
                out.append(
                    f"order {need.ratio}, {what}: a pair of shafts of speed ratios {ratios}"
                    + (" (Lanchester)" if need.force else "")
                )
            continue
        turning = f"order {abs(need.ratio)}, {what} {'with' if need.ratio > 0 else 'against'} the crank"
        if need.ratio in cranks:
            several = f" {cranks[need.ratio]}" if len(cranks) > 1 else ""
            weights = "other counterweights" if weighted[need.ratio] else "counterweights"
            out.append(f"{turning}: {weights} on the crankshaft{several}" + ("" if need.force else ", two opposite ones"))
        else:
            ends = "" if need.force else " with opposite weights at its ends"
            out.append(f"{turning}: one shaft{ends}, of speed ratio {need.ratio}")
    return out


def _alike(need: Need, other: Need) -> bool:
    """Whether two vectors that turn against each other are as long as each other."""
    pairs = ((abs(need.force), abs(other.force)), (abs(need.couple), abs(other.couple)))
    return all(abs(one - two) <= EQUAL * max(one, two) for one, two in pairs)
