"""The verb that searches: search."""

from __future__ import annotations

from dataclasses import asdict
from functools import partial
from types import ModuleType
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

from crankstar.cli.options import (
    FLAT,
    Estimating,
    Looks,
    Settings,
    Speed,
    once,
    read_engine,
    together,
    write_engine,
)
from crankstar.cli.output import complain, display, working, writable, write_result
from crankstar.cli.search_options import Form, Sequenced, Work, no_such_row
from crankstar.cli.tabulating import give, words_for
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.options import charts as chart_request
from crankstar.options import values as request
from crankstar.options.forms import ENGINES, PICTURES, STANDARD_OUTPUT, TABLES, form_of, usual_place
from crankstar.options.refusals import not_compiled
from crankstar.options.values import RequestError
from crankstar.options.words import SearchWords, SequenceWords, sequence_options

if TYPE_CHECKING:
    from crankstar.stars.answer import Answer

GREATEST_WORKERS = 1024
GREATEST_ROW = 200_000


def search(
    cylinders: Annotated[
        str,
        Parameter(
            help="Number of cylinders, or an engine in line or, with twist, in V (name or file)."
        ),
    ],
    /,
    *,
    words: Annotated[SearchWords, FLAT] = SearchWords(),  # noqa: B008  # it is frozen
    speed: Speed = None,
    settings: Settings = None,
    estimate: Estimating = False,
    sequenced: Annotated[Sequenced, FLAT] = Sequenced(),  # noqa: B008
    work: Annotated[Work, FLAT] = Work(),  # noqa: B008
    looks: Annotated[Looks, FLAT] = Looks(),  # noqa: B008
    form: Annotated[Form, FLAT] = Form(),  # noqa: B008
) -> int | None:
    """Find better cranks: all arrangements of evenly spaced throws, searched with proof."""
    from crankstar.options import search as options

    sequenced.check()
    more = SequenceWords(**asdict(sequenced))
    if sequence_options(words, more):
        from crankstar.cli import sequencing

        about_engine = {"settings": settings, "speed": speed, "estimate": estimate}
        asked = {"work": work, "looks": looks, "form": form}
        return sequencing.searched(cylinders, words, more, **about_engine, **asked)
    read_kind = once(partial(_kind, form))

    def read_paper() -> Any:
        if read_kind() in PICTURES:
            return chart_request.paper(read_kind(), **asdict(looks))
        looks.refuse(_("an engine") if form.row is not None else _("a table"))
        return None

    pace, tree, number = None, None, options.whole_number(cylinders)
    given = {"--set": settings, "--speed": speed, "--estimate": estimate}
    load = partial(read_engine, cylinders, settings, estimate=estimate, speed=speed, ranged=False)
    kind, paper, row, workers, deviations, _work, found, turning = together(
        read_kind,
        read_paper,
        partial(request.within, "--row", form.row, most=GREATEST_ROW),
        partial(request.within, "--workers", work.workers, most=GREATEST_WORKERS),
        lambda: None if form.uneven is None else options.deviations(form.uneven),
        partial(work.check, form.output),
        load if number is None else partial(request.refuse_unused, given, without=_("an engine")),
        partial(request.speed, speed),
    )
    about: int | Engine = number or 0
    if number is None:
        about, tree = found.engine, found.tree
        pace = turning or found.engine.speed
    wanted = options.search_of(about, words, speed=pace)
    chart = form.chart or ("front" if kind in PICTURES else None)
    options.check_use(wanted.question, chart=chart, deviations=deviations)
    if form.output is not None:
        writable(form.output)
    answer = _job().answer_of(wanted, work, workers=workers)
    if answer.certificate.interrupted:
        return _stopped(answer, wanted.engine, kind if row is None else "engine", form.output)
    if row is not None:
        _show_row(answer, wanted.engine, row, deviations, pace, form.output, tree)
    else:
        _show(cylinders, answer, wanted.engine, kind, form.chart, form.output, paper)
    return None


def _job() -> ModuleType:
    """The part that runs searches. Raises RequestError where numba is not installed."""
    try:
        from crankstar.cli import search_job
    except ImportError as error:
        raise not_compiled(error) from None
    return search_job


def _stopped(answer: Answer, engine: Engine | None, kind: str, output: str | None) -> int:
    """Show the best so far of a stopped search and say that it is incomplete.

    Engines and pictures are not written, nor any file if nothing was found: it may hold an earlier
    answer.
    """
    from crankstar.tables.search_stars import certificate, search_stars

    if kind in TABLES[1:] and (answer.rows or output is None):
        _show("", answer, engine, kind, None, output)
        complain(f"crankstar: {certificate(answer)}")
        return 130
    display(search_stars(answer, engine=engine))
    if output is not None:
        complain(
            _("crankstar: the search was stopped; {file} was not written", file=one_line(output))
        )
    return 130


def _kind(form: Form) -> str:
    """The form of the answer, or of the engine of a row. Raises RequestError."""
    if form.row is None and form.uneven is not None:
        raise RequestError("--uneven: name the row to refine, as in --row 2 --uneven 1,2,5")
    flags = {"--csv": form.csv, "--json": form.json}
    if form.row is not None:
        request.refuse_unused({**flags, "--chart": form.chart}, beside="--row")
        return form_of(form.output, ENGINES)
    if form.chart is not None:
        request.refuse_unused(flags, beside="--chart")
        chart_request.charts()
        return chart_request.suffix(form.output)
    kind = form_of(form.output, (*TABLES, *PICTURES), json=form.json, csv=form.csv)
    if kind in PICTURES:
        chart_request.charts()
    return kind


def _show(
    about: str,
    answer: Answer,
    engine: Engine | None,
    kind: str,
    chart: str | None,
    output: str | None,
    paper: Any = None,
) -> None:
    """Write the answer in the form asked for; `about` is the word for what was searched."""
    from crankstar.tables import search_stars as tables

    if kind in PICTURES:
        drawing = chart_request.charts()
        title = tables.heading(answer.question)
        draw = drawing.best_stars if chart == "stars" else drawing.pareto_front
        made = drawing.printed(partial(draw, answer), paper, title=title)
        content = drawing.saved_print(made, kind, title=title)
        write_result(content, output, usual_place(about, "search", chart or "front", kind=kind))
    else:
        limit = tables.ROWS if kind == "txt" else None
        with words_for(kind):
            document = tables.search_stars(answer, engine=engine, limit=limit)
        give(document, output, form=kind)


def _show_row(
    answer: Answer,
    engine: Engine | None,
    row: int,
    deviations: list[float] | None,
    speed: float | None,
    output: str | None,
    tree: dict[str, Any] | None,
) -> None:
    """Write a row as an engine file; uneven angles as a table, or the engine of the last one."""
    from crankstar.stars import engine_stars, engines
    from crankstar.tables import uneven_angles

    if row > len(answer.rows):
        raise no_such_row(row, len(answer.rows))
    star = answer.rows[row - 1].star
    stars, later = answer.question.stars, None
    if deviations is not None:
        with working(_("Refining the angles ...")):
            curve = uneven_angles.curve_of(
                answer.question, star, deviations_deg=deviations, engine=engine, speed=speed
            )
        if output not in STANDARD_OUTPUT or output is None:
            display(uneven_angles.uneven_angles(curve))
        if output is None:
            return
        later = curve[-1].later_deg
    build = engines.engine if engine is None else partial(engine_stars.with_star, engine)
    write_engine(build(stars, star, later_deg=later), tree, output)
