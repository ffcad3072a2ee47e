"""The Pareto front of a search: what one objective costs in the other, each point by its number, and a key of firing orders."""

from __future__ import annotations

from cmath import exp
from collections.abc import Sequence
from itertools import accumulate, pairwise
from math import ceil, floor, hypot, log10, radians
from typing import TYPE_CHECKING, Any, NamedTuple

from crankstar.charts.drawing import (
    BLUE,
    GREY,
    LETTER,
    PALETTE,
    SMALL,
    TEXT,
    WIDTH,
    ChartError,
    Panel,
    figure,
    layered,
    numbers_text,
    of_rows,
    text_width,
)
from crankstar.charts.labels import WIDER, Box, meets
from crankstar.search.engines import firing_order
from crankstar.search.question import Front
from crankstar.search.stars import Stars
from crankstar.wording import number, unit_text

if TYPE_CHECKING:
    import altair

    from crankstar.search.findings import Finding, Findings

HEIGHT = 250
"""Of the plotting area, px."""
DECADES = 2.0
"""Powers of ten that values must span before their axis becomes logarithmic of itself."""
DOT = 80.0
"""Area of the mark of a point, px^2."""
CELL = 2.0
"""px: of other stars in one square of this size one is drawn."""
MOST_LISTED = 20
"""Points whose firing orders are written below the chart."""
CROWD = 40
"""Points among which a number far from its own tells nothing, even with a line between them."""
RADIUS = DOT**0.5 / 2
"""Of a mark, px."""
NEARER = 3.0
"""Px by which a number without a line is nearer to its own mark than to any other."""
LED = (20.0, 27.0, 35.0, 45.0)
"""Px from marks to numbers to which a line leads."""
MOST_DRAWN = 2000
"""Points that are all drawn; of more those that would cover each other are not."""
KEY = 520
"""Px that the key may be wide; longer firing orders are folded."""
LEFT = 24.0
"""Px by which the key begins left of the axis."""
DASH = 0.33
"""Width of a dash or a point in the size of the letters."""
LINE = 17.0
"""Height of a line of the key, px."""
GAP, EDGE = 0.18, 0.05
"""Shares of the span of a logarithmic axis: between 0 and the least value, and beyond the outermost ones."""


class Column(NamedTuple):
    """One of the values of a finding: its name, its unit, whether it is a count."""

    name: str
    unit: str
    counted: bool

    @property
    def title(self) -> str:
        """The name with its unit, for an axis."""
        return f"{self.name} ({unit_text(self.unit)})" if self.unit else self.name


class Axis(NamedTuple):
    """From values to px: straight, or by powers of ten, and then, if any value is 0, with a place for it beside a gap."""

    low: float
    high: float
    length: float
    powers: bool = False
    zero: float | None = None

    def drawn(self, value: float) -> float:
        """The value at which a value is drawn: itself, but for 0 among powers of ten."""
        return self.zero if self.zero is not None and value <= 0 else value

    def place(self, value: float) -> float:
        """Px from the lower end of the axis."""
        one = self.drawn(value)
        share = log10(one / self.low) / log10(self.high / self.low) if self.powers else (one - self.low) / (self.high - self.low)
        return share * self.length

    def value(self, place: float) -> float:
        """The value that is drawn at a place, px."""
        share = place / self.length
        return self.low * (self.high / self.low) ** share if self.powers else self.low + share * (self.high - self.low)

    @property
    def ticks(self) -> list[float]:
        """Where a logarithmic axis has its numbers: powers of ten, where these are few what lies between as well, and 0."""
        least = self.low if self.zero is None else self.zero * (self.high / self.low) ** (GAP / 2)
        tens = [10.0**power for power in range(floor(log10(least)), ceil(log10(self.high)) + 1)]
        among = [ten for ten in tens if least < ten <= self.high]
        for steps in ((1, 2, 5), range(1, 10)):
            if len(among) < 3:
                among = [ten * step for ten in tens for step in steps if least < ten * step <= self.high]
        return among if self.zero is None else [self.zero, *among]


def columns(found: Findings) -> tuple[Column, ...]:
    """What the values of findings are, in their order: the objectives, then what Python functions judged."""
    question = found.question
    named = [Column(one.name, one.unit, counted=bool(one.neighbours) and not one.terms) for one in question.objectives]
    return (*named, *(Column(judge.name, judge.unit, counted=False) for judge in question.judges))


def pareto_front(found: Findings, *, others: Findings | None = None, logarithmic: bool | None = None) -> altair.VConcatChart:
    """The points of a front by their first two objectives, coloured by the third, numbered, with firing orders below.

    With two objectives no star is below the dashed line and left of it; with more there is no such line, since what two of them
    make look worse may be better in the third. `others` are further stars judged by the same
    two, drawn pale. `logarithmic`: powers of ten on both axes, 0 at a place of its own; left out, where values span two powers
    of ten or more. Counts stay as they are. Raises ChartError.
    """
    heads = columns(found)
    if len(heads) < 2:
        raise ChartError(
            f"a front is drawn by two objectives, and here {'is one' if heads else 'are none'}; ask for two, or draw the stars"
        )
    if not found.rows:
        raise ChartError("there is no star to draw; none was found within the limits")
    if others is not None and columns(others)[:2] != heads[:2]:
        raise ChartError("the other stars are judged by something else; ask for both by the same first two objectives")
    points = [row.values for row in found.rows]
    pale = [row.values for row in others.rows] if others is not None else []
    powers = any(_spans(points, place) for place in (0, 1) if not heads[place].counted) if logarithmic is None else logarithmic
    every = [*points, *pale]
    across = _axis([one[0] for one in every], WIDTH, powers=powers and not heads[0].counted)
    upward = _axis([one[1] for one in every], HEIGHT, powers=powers and not heads[1].counted)
    panel, every_number = _front_panel(found, heads, across, upward, pale)
    kind = "Front of" if isinstance(found.question.ask, Front) else "Stars by"
    title = f"{kind} {', '.join(head.name for head in heads[:-1])} and {heads[-1].name}"
    told = [] if every_number else ["numbered where there is room"]
    return figure([[panel], [key(found)]], title=title, subtitle=[engine_words(found.question.stars), *told])


def engine_words(stars: Stars) -> str:
    """Which engine the stars are of."""
    pitches = {a - b for a, b in pairwise(stars.positions)}
    more = [*(["symmetric crank"] if stars.symmetric else []), *(["unequal pitches"] if len(pitches) > 1 else [])]
    if stars.fixed:
        more.append(f"throws of {numbers_text([cylinder for cylinder, _ in stars.fixed])} fixed")
    return ", ".join([f"{stars.cylinders} cylinders", stars.cycle, *more])


def units_text(heads: Sequence[Column]) -> str:
    """In what the values are counted: `M1, M2 in m r ω² a`."""
    units = list(dict.fromkeys(head.unit for head in heads if head.unit))
    return "; ".join(f"{', '.join(head.name for head in heads if head.unit == unit)} in {unit_text(unit)}" for unit in units)


def order_lines(stars: Stars, row: Finding, *, width: float) -> list[str]:
    """The firing order of a finding's star in lines up to so many px wide; a line that goes on ends in a dash."""
    lines = [""]
    for place, one in enumerate(firing_order(stars, row.star), 1):
        said = f"{one}-" if place < stars.cylinders else str(one)
        if lines[-1] and _width(lines[-1] + said) > width:
            lines.append("")
        lines[-1] += said
    return lines


def _spans(points: Sequence[tuple[float, ...]], place: int) -> bool:
    sizes = [one[place] for one in points if one[place] > 0]
    return bool(sizes) and max(sizes) >= 10**DECADES * min(sizes)


def _axis(values: Sequence[float], length: float, *, powers: bool) -> Axis:
    sizes = [value for value in values if value > 0]
    if not powers or not sizes:
        return Axis(0.0, 1.08 * max(sizes, default=1.0), length)
    low, high = min(sizes), max(sizes)
    span = max(high / low, 10.0)
    zero = low / span**GAP if min(values) <= 0 else None
    return Axis((zero or low) / span**EDGE, high * span**EDGE, length, powers=True, zero=zero)


def _front_panel(
    found: Findings, heads: Sequence[Column], across: Axis, upward: Axis, pale: Sequence[tuple[float, ...]]
) -> tuple[Panel, bool]:
    """The points in a panel, and whether each has its number."""
    import altair as alt

    x, y = _channel(alt.X, "x", across, heads[0].title), _channel(alt.Y, "y", upward, heads[1].title)
    layers: list[Any] = []
    if pale:
        spots = (pale[index] for index in _seen(pale, across, upward))
        dots = of_rows([{"x": across.drawn(one[0]), "y": upward.drawn(one[1])} for one in spots])
        layers.append(dots.mark_point(filled=True, shape="circle", size=16, opacity=0.4, color=GREY).encode(x=x, y=y))
    points = [row.values for row in found.rows]
    steps = _steps(points, across, upward) if len(heads) == 2 else []
    if steps:
        line = of_rows(steps).mark_line(color=GREY, strokeWidth=1.3, strokeDash=[5, 3])
        layers.append(line.encode(x=x, y=y, order=alt.Order("at:Q")))
    shown = range(len(points)) if len(points) <= MOST_DRAWN else _seen(points, across, upward)
    rows = [_row(found, heads, place, across, upward) for place in shown]
    hints = [alt.Tooltip("row:N", title="row"), alt.Tooltip("order:N", title="fires")]
    hints += [alt.Tooltip(f"value{place}:Q", title=head.title) for place, head in enumerate(heads)]
    dots = of_rows(rows).mark_point(filled=True, shape="circle", size=DOT, opacity=1)
    layers.append(dots.encode(x=x, y=y, color=_colour(heads, rows), tooltip=hints))
    numbers, leaders = _numbers(rows, steps, across, upward)
    if leaders:
        lines = of_rows(leaders).mark_rule(color=GREY, strokeWidth=0.8)
        layers.append(lines.encode(x=x, y=y, x2=alt.X2("x2:Q"), y2=alt.Y2("y2:Q")))
    said = of_rows(numbers).mark_text(fontSize=SMALL, color=GREY, baseline="middle").encode(x=x, y=y, text=alt.Text("text:N"))
    return layered([*layers, said], width=WIDTH, height=HEIGHT), len(numbers) == len(found.rows)


def _channel(kind: Any, field: str, axis: Axis, title: str) -> Any:
    import altair as alt

    domain = [axis.low, axis.high]
    if not axis.powers:
        return kind(f"{field}:Q", scale=alt.Scale(domain=domain, nice=False), title=title, axis=alt.Axis(tickCount=5))
    zero = 0 if axis.zero is None else axis.zero * (axis.high / axis.low) ** (EDGE / 2)
    said = f"datum.value < {zero!r} ? '0' : format(datum.value, '~g')"
    marks = alt.Axis(values=axis.ticks, labelExpr=said)
    return kind(f"{field}:Q", scale=alt.Scale(type="log", domain=domain, nice=False), title=title, axis=marks)


def _row(found: Findings, heads: Sequence[Column], place: int, across: Axis, upward: Axis) -> dict[str, Any]:
    """A point: where it is drawn, its number, its firing order, its values."""
    row = found.rows[place]
    order = "-".join(map(str, firing_order(found.question.stars, row.star)))
    values = {f"value{column}": row.values[column] for column in range(len(heads))}
    return {"x": across.drawn(row.values[0]), "y": upward.drawn(row.values[1]), "row": place + 1, "order": order, **values}


def _colour(heads: Sequence[Column], rows: Sequence[dict[str, Any]]) -> Any:
    """One colour, or, where it differs, that of the third objective: a few counts by name, a length by a scale."""
    import altair as alt

    if len(heads) < 3 or len({row["value2"] for row in rows}) < 2:
        return alt.ColorValue(BLUE)
    said = {"title": heads[2].title, "titleColor": GREY, "titleFontSize": TEXT, "titleFontWeight": "normal"}
    kinds = sorted({row["value2"] for row in rows})
    if heads[2].counted and len(kinds) <= len(PALETTE):
        legend = alt.Legend(orient="top", titleOrient="left", format="d", **said)
        return alt.Color("value2:O", scale=alt.Scale(domain=kinds, range=list(PALETTE[: len(kinds)])), legend=legend)
    legend = alt.Legend(orient="top", gradientLength=WIDTH, gradientThickness=10, tickCount=5, **said)
    return alt.Color("value2:Q", scale=alt.Scale(scheme="viridis"), legend=legend)


def _seen(points: Sequence[tuple[float, ...]], across: Axis, upward: Axis) -> list[int]:
    """Of points that would cover each other the first: their indices."""
    first: dict[tuple[int, int], int] = {}
    for index, one in enumerate(points):
        first.setdefault((round(across.place(one[0]) / CELL), round(upward.place(one[1]) / CELL)), index)
    return list(first.values())


def _steps(points: Sequence[tuple[float, ...]], across: Axis, upward: Axis) -> list[dict[str, float]]:
    """The corners of the line between what is reached and what is not, from the upper to the right edge."""
    best: list[tuple[float, float]] = []
    for one, two, *_ in sorted(points):
        if not best or two < best[-1][1]:
            best.append((one, two))
    corners = [(best[0][0], upward.high), best[0]]
    for (_, above), (one, two) in pairwise(best):
        corners += [(one, above), (one, two)]
    corners.append((across.high, best[-1][1]))
    return [{"x": across.drawn(one), "y": upward.drawn(two), "at": place} for place, (one, two) in enumerate(corners)]


def _numbers(
    rows: Sequence[dict[str, Any]], steps: Sequence[dict[str, float]], across: Axis, upward: Axis
) -> tuple[list[dict[str, Any]], list[dict[str, float]]]:
    """The numbers of the points where there is room for them, off the points, the line and each other; lines to those not beside.

    Points on the line come first, then those of the key; of others the numbers are left out.
    """
    spots = {row["row"]: complex(upward.place(row["y"]), across.place(row["x"])) for row in rows}
    corners = [complex(upward.place(step["y"]), across.place(step["x"])) for step in steps]
    on_line = [row for row, spot in spots.items() if spot in corners]
    lines = [Box((a + b) / 2, abs((b - a).imag) / 2, abs((b - a).real) / 2) for a, b in pairwise(corners)]
    taken = [Box(spot, RADIUS, RADIUS) for spot in spots.values()]
    numbers, leaders = [], []
    for row in dict.fromkeys([*on_line, *(row for row in spots if row <= MOST_LISTED)]):
        spot, led = spots[row], row in on_line or len(rows) <= CROWD
        others = [one for one in spots.values() if one != spot]
        beside = _beside(str(row), spot, others, taken, lines)
        placed = beside or (_led(str(row), spot, taken, lines) if led else None)
        if placed is None:
            continue
        numbers.append({"text": str(row), "x": across.value(placed.middle.imag), "y": upward.value(placed.middle.real)})
        taken.append(placed)
        if not beside:
            line = _leader(spot, placed)
            taken += [Box(point, 1.0, 1.0) for point in line]
            (x, y), (x2, y2) = ((across.value(end.imag), upward.value(end.real)) for end in (line[0], line[-1]))
            leaders.append({"x": x, "y": y, "x2": x2, "y2": y2})
    return numbers, leaders


def _beside(text: str, spot: complex, others: Sequence[complex], taken: Sequence[Box], lines: Sequence[Box]) -> Box | None:
    """A place for a number next to its own dot, nearer to it than to any other; below and left, where fronts end, first."""
    wide, high = text_width(text, SMALL) / 2, SMALL / 2
    places = []
    off = RADIUS + 1.0
    for up, right in ((-1, 0), (0, -1), (-1, -1), (1, -1), (-1, 1), (1, 0), (1, 1), (0, 1)):
        places.append(Box(spot + complex(up * (high + off), right * (wide + off)), wide, high))
    free = [place for place in places if _is_free(place, taken)]
    own = [place for place in free if all(_gap(place, one) > _gap(place, spot) + NEARER for one in others)]
    return min(own, key=lambda place: sum(meets(place, line) for line in lines), default=None)


def _led(text: str, spot: complex, taken: Sequence[Box], lines: Sequence[Box]) -> Box | None:
    """The nearest place for a number to which a line can be drawn from its dot that meets nothing; None if there is none."""
    wide, high = text_width(text, SMALL) / 2, SMALL / 2
    others = [one for one in taken if one.middle != spot]
    for far in LED:
        places = [Box(spot + far * exp(1j * radians(225 + turn)), wide, high) for turn in range(0, 360, 15)]
        free = [place for place in places if _is_free(place, taken)]
        free = [place for place in free if all(_is_free(Box(one, 1.5, 1.5), others) for one in _leader(spot, place))]
        if free:
            return min(free, key=lambda place: sum(meets(place, line) for line in lines))
    return None


def _leader(spot: complex, place: Box) -> list[complex]:
    """The points of the line from a dot to its number, from edge to edge, about a px apart."""
    off = place.middle - spot
    way = off / abs(off)
    within = min(place.across / max(abs(way.imag), 1e-9), place.upright / max(abs(way.real), 1e-9))
    length = abs(off) - 1.0 - within - RADIUS
    return [spot + way * (RADIUS + length * step / ceil(length)) for step in range(ceil(length) + 1)]


def _is_free(place: Box, taken: Sequence[Box]) -> bool:
    off = place.middle - complex(HEIGHT, WIDTH) / 2
    inside = abs(off.imag) + place.across <= WIDTH / 2 and abs(off.real) + place.upright <= HEIGHT / 2
    return inside and not any(meets(place, one) for one in taken)


def _gap(place: Box, spot: complex) -> float:
    """How far a point is from a rectangle, px."""
    off = spot - place.middle
    return hypot(max(abs(off.imag) - place.across, 0.0), max(abs(off.real) - place.upright, 0.0))


def key(found: Findings) -> Panel:
    """What the numbers stand for: firing order, values, neighbours that fire one after the other, as a table."""
    import altair as alt

    heads = columns(found)
    beside = [] if any(head.counted for head in heads) else ["neighbours"]
    names = [*(head.name for head in heads), *beside]
    listed = found.rows[:MOST_LISTED]
    cells = [[*(number(value, digits=4) for value in row.values), *(str(row.neighbours) for _ in beside)] for row in listed]
    widths = [max(_width(text) for text in column) + 16 for column in zip(names, *cells, strict=True)]
    room = max(KEY - sum(widths), 120.0)
    orders = [order_lines(found.question.stars, row, width=room) for row in listed]
    ends = list(accumulate(widths, initial=max(_width(line) for order in orders for line in order)))
    texts = [_text("fires", 0, 0), *(_text(name, end, 0, "right") for name, end in zip(names, ends[1:], strict=True))]
    line = 1.3
    for place, (order, row) in enumerate(zip(orders, cells, strict=True), 1):
        texts += [_text(str(place), -10, line, "right")]
        texts += [_text(text, end, line, "right") for text, end in zip(row, ends[1:], strict=True)]
        texts += [_text(said, 0, line + further) for further, said in enumerate(order)]
        line += len(order)
    if len(found.rows) > MOST_LISTED:
        texts.append(_text(f"and {len(found.rows) - MOST_LISTED} more", 0, line))
        line += 1
    x = alt.X("x:Q", scale=alt.Scale(domain=[0, ends[-1] - LEFT], nice=False), axis=None)
    y = alt.Y("y:Q", scale=alt.Scale(domain=[line, 0], nice=False), axis=None)
    layers = []
    for side in ("left", "right"):
        own = [text for text in texts if text["side"] == side]
        layers.append(of_rows(own).mark_text(fontSize=SMALL, color=GREY, align=side).encode(x=x, y=y, text=alt.Text("text:N")))
    return layered(layers, width=ends[-1] - LEFT, height=line * LINE)


def _text(text: str, x: float, line: float, side: str = "left") -> dict[str, Any]:
    return {"text": text, "x": x - LEFT, "y": line + 0.5, "side": side}


def _width(text: str) -> float:
    """About how wide digits and dashes are, px."""
    return WIDER * (text_width(text, SMALL) - (LETTER - DASH) * SMALL * (text.count("-") + text.count(".")))
