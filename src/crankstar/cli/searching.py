"""The verb that searches: search."""

from __future__ import annotations

from dataclasses import asdict, replace
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
from crankstar.cli.search_options import Form, Line, Sequenced, Work, in_options, no_such_row
from crankstar.cli.tabulating import give, words_for
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.options import charts as chart_request
from crankstar.options import values as request
from crankstar.options.forms import ENGINES, PICTURES, STANDARD_OUTPUT, TABLES, form_of, usual_place
from crankstar.options.refusals import not_compiled, or_none
from crankstar.options.values import RequestError
from crankstar.options.words import SearchWords, SequenceWords, sequence_options

if TYPE_CHECKING:
    from crankstar.stars.answer import Answer

GREATEST_WORKERS, GREATEST_THREADS = 1024, 64
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
    given = {"--set": settings, "--speed": speed, "--estimate": estimate}
    sequenced.check()
    line = _Reading(cylinders, words, SequenceWords(**asdict(sequenced)), given, work, looks, form)
    asked = line.read()
    if line.sequences:
        from crankstar.cli import sequencing

        return sequencing.searched(asked)
    answer = _job().answer_of(asked.wanted, work, workers=asked.workers)
    if answer.certificate.interrupted:
        return _stopped(answer, asked)
    if form.row is not None:
        _show_row(answer, asked, form.row)
    else:
        _show(answer, asked)
    return None


class _Reading:
    """What a command line of a search says, each part with the mistakes of its own.

    `given` are the options of an engine as typed; `sequences` those that ask for firing sequences.
    """

    def __init__(
        self,
        named: str,
        words: SearchWords,
        more: SequenceWords,
        given: dict[str, Any],
        work: Work,
        looks: Looks,
        form: Form,
    ) -> None:
        self.named, self.words, self.more, self.given = named, words, more, given
        self.work, self.looks, self.form = work, looks, form
        self.sequences = sequence_options(words, more)
        self.kind = once(partial(_kind, form))
        self.source = once(self._source)
        self.speed = once(partial(request.speed, given["--speed"]))
        self.deviations = once(self._deviations)
        self.bank = once(self._bank)

    def read(self) -> Line:
        """All of it. Raises MistakesError with every mistake."""
        most = GREATEST_THREADS if self.sequences else GREATEST_WORKERS
        kind, paper, workers, deviations, speed, source, wanted, *_checked = together(
            self.kind,
            self._paper,
            partial(request.within, "--workers", self.work.workers, most=most),
            self.deviations,
            self.speed,
            self.source,
            partial(in_options, self._wanted),
            partial(request.within, "--row", self.form.row, most=GREATEST_ROW),
            partial(self.work.check, self.form.output),
            self.bank,
            self._check_output,
            self._check_words,
        )
        about, tree = source
        if isinstance(about, Engine) and speed is None:
            speed = about.speed
        out = {"kind": kind, "paper": paper, "workers": workers, "deviations": deviations}
        return Line(
            named=self.named,
            source=about,
            tree=tree,
            speed=speed,
            wanted=wanted,
            work=self.work,
            form=self.form,
            **out,
        )

    def _source(self) -> tuple[int | Engine, dict[str, Any] | None]:
        from crankstar.options.search import whole_number

        number = in_options(partial(whole_number, self.named))
        if number is None:
            own = {} if self.sequences else {"estimate": self.given["--estimate"]}
            own |= {} if self.sequences else {"speed": self.given["--speed"]}
            found = read_engine(self.named, self.given["--set"], ranged=False, **own)
            return found.engine, found.tree
        given = {"--set": self.given["--set"]} if self.sequences else self.given
        request.refuse_unused({**given, "--judge": self.more.judge}, without=_("an engine"))
        return number, None

    def _deviations(self) -> list[float] | None:
        from crankstar.options.search import deviations

        return None if self.form.uneven is None else deviations(self.form.uneven)

    def _bank(self) -> bool:
        """That the bank angle can be read, if there is one."""
        if self.more.bank is not None:
            request.degrees("--bank", self.more.bank)
        return True

    def _paper(self) -> Any:
        if self.kind() in PICTURES:
            request.refuse_unused({"--judge": self.more.judge}, beside=_("a picture"))
            return chart_request.paper(self.kind(), **asdict(self.looks))
        self.looks.refuse(_("an engine") if self.form.row is not None else _("a table"))
        return None

    def _check_output(self) -> None:
        if self.form.output is not None:
            writable(self.form.output)

    def _check_words(self) -> None:
        """Refuse what a search of stars alone has, and what is no judge, beside sequences."""
        if self.sequences:
            from crankstar.options.sequences import check_words, judges_of

            beside = {key: own for key, own in self.given.items() if key != "--set"}
            together(
                partial(request.refuse_unused, beside, beside=self.sequences),
                partial(check_words, self.words, self.more),
                partial(judges_of, self.more.judge),
            )

    def _wanted(self) -> Any:
        """What is searched for; what can be told of the words where it is not known of what."""
        source = or_none(self.source)
        if self.sequences:
            from crankstar.options.sequences import sequences_of

            if source is None:
                return None
            more = self.more if or_none(self.bank) else replace(self.more, bank=None)
            return sequences_of(source[0], self.words, more)
        from crankstar.options import search as options

        if source is None:
            return options.goals_of(self.words)
        about = source[0]
        own = about.speed if isinstance(about, Engine) else None
        speed = or_none(self.speed)
        wanted = options.search_of(about, self.words, speed=own if speed is None else speed)
        chart = self.form.chart or ("front" if or_none(self.kind) in PICTURES else None)
        deviations = or_none(self.deviations)
        options.check_use(wanted.question, chart=chart, deviations=deviations)
        return wanted


def _job() -> ModuleType:
    """The part that runs searches. Raises RequestError where numba is not installed."""
    try:
        from crankstar.cli import search_job
    except ImportError as error:
        raise not_compiled(error) from None
    return search_job


def _stopped(answer: Answer, line: Line) -> int:
    """Show the best so far of a stopped search and say that it is incomplete.

    Engines and pictures are not written, nor any file if nothing was found: it may hold an earlier
    answer.
    """
    from crankstar.tables.search_stars import certificate, search_stars

    output = line.form.output
    tabled = line.form.row is None and line.kind in TABLES[1:]
    if tabled and (answer.rows or output is None):
        _show(answer, line)
        complain(f"crankstar: {certificate(answer)}")
        return 130
    display(search_stars(answer, engine=line.engine))
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


def _show(answer: Answer, line: Line) -> None:
    """Write the answer in the form asked for."""
    from crankstar.tables import search_stars as tables

    kind, output, chart = line.kind, line.form.output, line.form.chart
    if kind in PICTURES:
        drawing = chart_request.charts()
        title = tables.heading(answer.question)
        draw = drawing.best_stars if chart == "stars" else drawing.pareto_front
        made = drawing.printed(partial(draw, answer), line.paper, title=title)
        content = drawing.saved_print(made, kind, title=title)
        place = usual_place(line.named, "search", chart or "front", kind=kind)
        write_result(content, output, place)
    else:
        limit = tables.ROWS if kind == "txt" else None
        with words_for(kind):
            document = tables.search_stars(answer, engine=line.engine, limit=limit)
        give(document, output, form=kind)


def _show_row(answer: Answer, line: Line, row: int) -> None:
    """Write a row as an engine file; uneven angles as a table, or the engine of the last one."""
    from crankstar.stars import engine_stars, engines
    from crankstar.tables import uneven_angles

    if row > len(answer.rows):
        raise no_such_row(row, len(answer.rows))
    star, output, engine = answer.rows[row - 1].star, line.form.output, line.engine
    stars, later = answer.question.stars, None
    if line.deviations is not None:
        with working(_("Refining the angles ...")):
            curve = uneven_angles.curve_of(
                answer.question,
                star,
                deviations_deg=line.deviations,
                engine=engine,
                speed=line.speed,
            )
        if output not in STANDARD_OUTPUT or output is None:
            display(uneven_angles.uneven_angles(curve))
        if output is None:
            return
        later = curve[-1].later_deg
    build = engines.engine if engine is None else partial(engine_stars.with_star, engine)
    write_engine(build(stars, star, later_deg=later), line.tree, output)
