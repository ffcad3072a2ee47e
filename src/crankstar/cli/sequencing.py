"""The verb search where star and firing sequence are searched together."""

from __future__ import annotations

import os
from contextlib import ExitStack
from functools import partial
from typing import Any

from crankstar.cli.options import write_engine
from crankstar.cli.output import complain, display, progress, working, write_result
from crankstar.cli.search_options import Line, Work, no_such_row
from crankstar.cli.tabulating import give, words_for
from crankstar.language.messages import _
from crankstar.options import charts as chart_request
from crankstar.options import sequences
from crankstar.options.forms import PICTURES, STANDARD_OUTPUT, usual_place
from crankstar.options.refusals import not_compiled
from crankstar.options.values import RequestError

MOST_THREADS = 64
LONG_STARS = 1_000_000_000
"""Stars that take more than a few minutes."""


def searched(line: Line) -> int | None:
    """Find the front over stars and firing sequences, and show it or write a row."""
    wanted, form, kind = line.wanted, line.form, line.kind
    front = _front(wanted.question, line.workers or os.cpu_count() or 1, line.work)
    if kind in PICTURES:
        return _draw(front, line)
    judged = _judged(front, wanted)
    if form.row is not None and front.complete:
        first = next(iter(judged.values())).rows if judged else {}
        _show_row(front, {shown: way.fired for shown, way in first.items()}, line)
        return None
    from crankstar.tables.search_sequences import ROWS, search_sequences

    with words_for(kind):
        limit = ROWS if kind == "txt" else None
        found = search_sequences(
            front, engine=wanted.engine, why=wanted.why, mode=wanted.mode, found=judged, limit=limit
        )
    if front.complete:
        give(found, form.output, form=kind)
        return None
    display(found)
    return 130


def _draw(front: Any, line: Line) -> int | None:
    """Write the front, or its first stars, as a picture; none of a search that was stopped."""
    from crankstar.tables.search_sequences import certificate, heading

    if not front.complete:
        complain(f"crankstar: {certificate(front)}")
        return 130
    drawing, title = chart_request.charts(), heading(front.question)
    chart, kind = line.form.chart, line.kind
    draw = drawing.sequence_stars if chart == "stars" else drawing.sequence_chart
    made = drawing.printed(partial(draw, front), line.paper, title=title)
    place = usual_place(line.named, "search", chart or "front", kind=kind)
    write_result(drawing.saved_print(made, kind, title=title), line.form.output, place)
    return None


def _front(question: Any, workers: int, work: Work) -> Any:
    """The front, with its progress. Raises RequestError where it takes long without consent."""
    if question.shaft.count > LONG_STARS and not (work.yes or work.scheduler):
        raise RequestError(
            "There are {stars} stars to go through, which takes long; to do it, add --yes.",
            stars=f"{question.shaft.count:,}",
        )
    with working(_("Getting ready (the first search is compiled for about ten seconds) ...")):
        try:
            from crankstar.cli.checkpoints import kept
            from crankstar.stars import executors
            from crankstar.stars.progress import note
            from crankstar.stars.sequence_fronts import sequence_front
        except ImportError as error:
            raise not_compiled(error) from None
    checkpoint = kept(work.checkpoint, question)
    with ExitStack() as stack:
        with working(_("Starting workers ...")):
            shared = executors.cluster(work.scheduler) if work.scheduler else None
            pool = stack.enter_context(shared or executors.threads(workers))
        show = stack.enter_context(progress(_("searching")))
        return sequence_front(
            question,
            workers=pool,
            checkpoint=checkpoint,
            watch=lambda now: show(now.done, now.blocks, note(now)),
        )


def _judged(front: Any, wanted: sequences.Sequences) -> dict[Any, Any]:
    """What the whole engine does with the best way of each point. Raises RequestError."""
    from crankstar.stars.sequence_engines import fired_of_engine
    from crankstar.stars.sequence_fronts import ways
    from crankstar.studies.judged_orders import FAILURES, JudgedWays, best_way

    engine, out = wanted.engine, {}
    if engine is None or not wanted.judges:
        return out
    shaft = front.question.shaft
    beside = [each for each in (fired_of_engine(engine, shaft), wanted.why) if each is not None]
    every = {point.fired: ways(front, point) for point in front.points}
    judged, of = sum(map(len, every.values())), sum(point.orders for point in front.points)
    whole, done = len(wanted.judges) * (judged + len(beside)), 0
    with progress(_("judging")) as show:
        for judge in wanted.judges:
            out[judge] = JudgedWays({}, {}, judged, of)
            try:
                for shown, those in every.items():
                    show(done, whole, "")
                    out[judge].rows[shown] = best_way(engine, shaft, those, judge)
                    done += len(those)
                for fired in beside:
                    out[judge].beside[fired] = best_way(engine, shaft, [fired], judge).value
            except FAILURES as error:
                raise RequestError(f"{engine.name}: {error}") from None
            done += len(beside)
    return out


def _show_row(front: Any, best: dict[Any, Any], line: Line) -> None:
    """Write a row as an engine file; uneven angles as a table, or the engine of the last one.

    best: the ways that were judged best, by the orders that rows show. Raises RequestError where
    there is no such row.
    """
    from crankstar.stars.sequence_engines import engine_of, with_fired
    from crankstar.stars.uneven_sequences import uneven_sequences
    from crankstar.tables.uneven_angles import uneven_angles

    row, output, engine = line.form.row or 1, line.form.output, line.engine
    if row > len(front.points):
        raise no_such_row(row, len(front.points))
    shown, shaft, later = front.points[row - 1].fired, front.question.shaft, ()
    fired = best.get(shown, shown)
    if line.deviations is not None:
        with working(_("Refining the angles ...")):
            curve = uneven_sequences(front.question, fired, deviations_deg=line.deviations)
        if output not in STANDARD_OUTPUT or output is None:
            display(uneven_angles(curve))
        if output is None:
            return
        later = curve[-1].later_deg
    built = (
        engine_of(shaft, fired, later)
        if engine is None
        else with_fired(engine, shaft, fired, later)
    )
    write_engine(built, line.tree, output)
