"""What the numbers of a figure rest on: the gravest in a line below it, all of it for machines.

A figure names its `Rests`: of which engines, by which `Answer`, and the command that lists it all.
It is worked out when the figure is composed, on a page of its own and in a notebook; where all of
it is beside the figures anyway, the canvas leaves it.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from functools import partial
from math import inf
from typing import TYPE_CHECKING, Any, NamedTuple

from crankstar.analysis.assumptions import Answer, Assumption
from crankstar.charts.canvas import shows_rests, speed_of
from crankstar.charts.grammar import Layer, constant, field, of_rows
from crankstar.charts.letters import SMALL, folded, text_width, words
from crankstar.engine.engine import Engine
from crankstar.language.messages import _, passage
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.gas import Cycle
from crankstar.studies import answers
from crankstar.studies.answer_parts import TURNING, in_own_unit, narrowed, without_speed
from crankstar.studies.chart_answers import firing, of_no_force, vectors
from crankstar.studies.load_answers import bearing_peaks
from crankstar.tables.assumptions import (
    assumption_facts,
    assumption_lines,
    assumption_remarks,
    leading_lines,
)
from crankstar.tables.field_names import field_name
from crankstar.tables.sweep_notes import doubt_sentences

if TYPE_CHECKING:
    from crankstar.studies.sweep import Curve, Sweep

FOOT = "rests"
"""The name of the panel below the others."""
MOST_LINES = 8
"""Lines of what matters most; of more the last sentences, or words, are left out."""
SENTENCE_END = re.compile(r"(?<=[.?])\s+|(?<=。)")
LETTERS_ROOM = 0.88
"""Share of the width in which lines are folded: other fonts have broader letters."""
LEADING = 1.25
"""From line to line, in the size of the letters."""
OF_INERTIA = ("force", "couple", "roll")
LAYOUT = ("layout", "cylinder.stroke", "cylinders", "rotation", "shaft", "crankshaft")
"""Key paths from which the shape of a crankshaft comes."""
OF_COMPONENT = {
    "vertical": "force", "horizontal": "force", "pitch": "couple", "yaw": "couple"
}  # fmt: skip


class Rests(NamedTuple):
    """The engines of a figure, the answer it gives of each, and what lists all that this rests on.

    `command` is a verb of the command line; `at` are the values, of many, at which it is found;
    `doubts` says what is hardly right of others of them.
    """

    engines: Sequence[Engine]
    answer: Callable[[Engine], Answer]
    command: str
    at: str = ""
    doubts: Callable[[], Sequence[str]] = tuple


class Told(NamedTuple):
    """What a figure rests on: lines for its foot, all sentences, and rows for machines.

    `named` is the one line on a paper that has no room for the foot.
    """

    foot: list[str]
    named: str
    sentences: tuple[str, ...]
    facts: dict[str, Any]


NOTHING = Told([], "", (), {})
_KNOWN: ContextVar[list[Told] | None] = ContextVar("known", default=None)


@contextmanager
def known_once() -> Iterator[None]:
    """Within it a figure is drawn again and again: what it rests on is worked out once."""
    token = _KNOWN.set([])
    try:
        yield
    finally:
        _KNOWN.reset(token)


def told(rests: Rests | None) -> Told:
    """What a figure rests on; nothing where the canvas leaves it or nothing is assumed."""
    if rests is None or not shows_rests():
        return NOTHING
    known = _KNOWN.get()
    if known:
        return known[0]
    found = [(engine, answers.rests_on(engine, rests.answer(engine))) for engine in rests.engines]
    out = _told(found, rests.command, rests.at)
    if doubts := rests.doubts():
        out = out._replace(foot=[*doubts, *out.foot], sentences=(*doubts, *out.sentences))
    if known is not None:
        known.append(out)
    return out


def _told(found: Sequence[tuple[Engine, tuple[Assumption, ...]]], command: str, at: str) -> Told:
    several = len(found) > 1
    sentences: list[str] = []
    rows: list[dict[str, Any]] = []
    for engine, own in found:
        name = engine.name if several else ""
        for part in assumption_remarks(own, of=name, at=at):
            sentences += part.lines
        beside = {"engine": name} if several else {}
        rows += [{**beside, **row} for row in assumption_facts(own).get("rests_on", ())]
    if not rows:
        return NOTHING
    engine, gravest = max(found, key=lambda each: max((own.effect for own in each[1]), default=-1))
    foot, others = leading_lines(gravest)
    others += len(rows) - len(gravest)
    foot[0] = f"{engine.name}: {foot[0]}" if several else foot[0]
    for other, own in found:
        parts = [] if other is engine else [each for each in own if each.status == "not modelled"]
        foot += [f"{other.name}: {line}" for line in assumption_lines(parts)]
        others -= len(parts)
    if at:
        foot[0] = passage([_("With {values} this rests on:", values=at), foot[0]])
    if others:
        foot.append(_("And {count} more: crankstar {command}", count=others, command=command))
    named = _("What it rests on: crankstar {command}", command=command)
    return Told(foot, named, tuple(sentences), {"rests_on": rows})


def foot_panel(lines: Sequence[str], *, width: float) -> dict[str, Any]:
    """Lines at the foot of a figure, in its width (px); all but the first are kept whole."""
    first, *others = lines
    room = LETTERS_ROOM * width
    written = _kept(first, room)
    written += [line for other in others for line in folded(other, width=room, size=SMALL)]
    height = len(written) * LEADING * SMALL
    rows = [{"y": (at + 0.5) * LEADING * SMALL, "text": line} for at, line in enumerate(written)]
    words: Layer = of_rows(rows).mark(
        "text", align="left", baseline="middle", fontSize=SMALL, color="#808080"
    )
    drawn = words.encode(x=constant(0), y=field("y:Q", scale=None, axis=None), text=field("text:N"))
    sides = {"width": round(width, 3), "height": round(height, 3)}
    return {"name": FOOT, "layer": [drawn.spec], **sides}


def _kept(text: str, width: float) -> list[str]:
    """A text in at most MOST_LINES lines of a width: whole sentences of it, else whole words."""
    sentences = SENTENCE_END.split(text)
    lines = folded(text, width=width, size=SMALL)
    while len(lines) > MOST_LINES and len(sentences) > 1:
        sentences.pop()
        lines = folded(passage(sentences), width=width, size=SMALL)
    if len(lines) <= MOST_LINES:
        return lines
    last = words(lines[MOST_LINES - 1])
    while text_width("".join(last).rstrip() + "…", SMALL) > width and len(last) > 1:
        last.pop()
    return [*lines[: MOST_LINES - 1], "".join(last).rstrip(" .,。、") + "…"]


def of_inertia(
    engines: Sequence[Engine],
    quantities: Sequence[str] = OF_INERTIA,
    *,
    speed: float | None,
    orders: Sequence[float] | None = None,
    command: str = "analyze",
    **options: Any,
) -> Rests:
    """Of a figure of forces, couples or rolling moments of inertia.

    At a `speed` (rad/s), or in m r omega^2; `options` are those of `answers.amplitudes`. The
    inertia torque has the size of the rolling moment, and no gas is missed in it.
    """
    kinds = ["roll" if name == "torque" else name for name in quantities]
    make = partial(answers.amplitudes, gas="roll" not in quantities, highest=inf, **options)

    def answer(engine: Engine) -> Answer:
        return _at(make, engine, speed_of(engine, speed), kinds, orders)

    return Rests(engines, answer, command)


def of_vectors(
    engines: Sequence[Engine],
    quantity: str,
    *,
    speed: float | None,
    orders: Sequence[float],
    **options: Any,
) -> Rests:
    """Of a figure of the vectors of each part: their lengths, at a speed or in m r omega^2."""

    def make(_engine: Engine, speed: float | None = None) -> Answer:
        return vectors(quantity, speed=speed, **options)

    def answer(engine: Engine) -> Answer:
        return _at(make, engine, speed_of(engine, speed), ("vectors",), orders)

    return Rests(engines, answer, "analyze")


def of_resultants(
    engines: Sequence[Engine],
    quantity: str,
    *,
    drawn: bool,
    speed: float | None,
    orders: Sequence[float],
    reference: Reference | None,
) -> Rests:
    """Of a figure of vectors with their resultant; where none is `drawn`, of the vectors alone."""
    if not drawn:
        return of_vectors(engines, quantity, speed=speed, orders=orders, reference=reference)
    return of_inertia(engines, [quantity], speed=speed, orders=orders, reference=reference)


def _at(
    make: Callable[..., Answer],
    engine: Engine,
    speed: float | None,
    quantities: Sequence[str],
    orders: Sequence[float] | None,
) -> Answer:
    """An answer at a speed, or without one in the engine's own unit."""
    made = in_own_unit(make(without_speed(engine))) if speed is None else make(engine, speed=speed)
    return narrowed(made, quantities, orders=orders)


def of_gas(
    engine: Engine, make: Callable[[Engine], Cycle], quantities: Sequence[str], command: str
) -> Rests:
    """Of a figure of a working cycle, by the quantities of `answers.torques`."""

    def answer(each: Engine) -> Answer:
        made = answers.torques(each, make, running=False)
        return narrowed(made, quantities, given=TURNING)

    return Rests([engine], answer, command)


def of_loads(
    engine: Engine,
    make: Callable[[Engine], Cycle | None],
    kind: str,
    *,
    speed: float | None,
    model: str = "determinate",
) -> Rests:
    """Of a figure of loads, by one of the `load_answers.KINDS`.

    At a `speed` (rad/s), or without gas in m r omega^2.
    """

    def answer(each: Engine) -> Answer:
        if speed is None and make(each) is None:
            own = without_speed(each)
            return in_own_unit(bearing_peaks(own, make, model=model, kinds=[kind]))
        return bearing_peaks(each, make, speed=speed, model=model, kinds=[kind])

    return Rests([engine], answer, "bearings")


def of_speeds(
    engine: Engine,
    components: Sequence[str],
    *,
    top: float,
    orders: Sequence[float] | None,
    reference: Reference | None,
    point: str | None,
) -> Rests:
    """Of a figure of amplitudes up to a `top` speed (rad/s), with the gas of a `point`, or none."""
    kinds = [OF_COMPONENT.get(name, name) for name in components] or ["force"]

    def answer(each: Engine) -> Answer:
        if point is None:
            with_gas = "roll" not in kinds
            made = answers.amplitudes(
                each, speed=top, gas=with_gas, reference=reference, highest=inf
            )
        else:
            made = answers.outlook(each, speed=top, point=point, reference=reference, highest=inf)
        return narrowed(made, kinds, orders=orders)

    return Rests([engine], answer, "analyze")


def of_layout(engine: Engine) -> Rests:
    """Of a figure of shape: no force is in it, only what is read from the layout."""
    others = [path for path in engine.provenance if not path.startswith(LAYOUT)]
    return Rests([engine], lambda _engine: of_no_force(given=others), "analyze")


def of_firing(engine: Engine, *, valves: bool = False) -> Rests:
    """Of a figure of firing angles; with `valves` also of timing that the file does not give."""
    return Rests([engine], partial(firing, valves=valves), "strokes")


def of_sweep(sweep: Sweep, curves: Sequence[Curve]) -> Rests:
    """Of a figure of the curves of a sweep."""
    from crankstar.studies.sweep_answers import judged

    found = judged(sweep, curves)
    at = ", ".join(f"{field_name(path)} = {value}" for path, value in found.values.items())
    doubts = partial(doubt_sentences, sweep, curves)
    return Rests([found.engine], lambda _engine: found.answer, "sweep", at, doubts)
