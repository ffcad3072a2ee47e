"""A search as the command line runs it: estimated first, on so many workers, its progress told, kept in a file."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, nullcontext
from pathlib import Path

from crankstar.interrupts import aside
from crankstar.output import progress, working
from crankstar.request import RequestError
from crankstar.search import halves, hands, likeness, run
from crankstar.search.checkpoint import opened
from crankstar.search.findings import Findings, findings
from crankstar.search.question import All
from crankstar.search.run import Progress
from crankstar.search.stars import SearchError
from crankstar.search_request import Request
from crankstar.wording import duration

LONG_SECONDS = 3600.0
"""A search longer than this must be agreed to."""
ALONE_SECONDS = 4.0
"""A search shorter than this is done in this process: starting others would take as long."""
NARROWER = "To narrow it: fix throws (--fix 1=0,2=3), take symmetric cranks (--symmetric), let a sum vanish (--zero M2)"


def found(
    wanted: Request,
    *,
    workers: int | None = None,
    scheduler: str | None = None,
    checkpoint: str | None = None,
    agreed: bool = False,
) -> Findings:
    """The answer. Raises RequestError where it cannot be had, or takes more than an hour and that was not agreed to."""
    try:
        halves.check(wanted.question)
        with working("getting ready (the first time loops are compiled, about ten seconds) ..."):
            seconds = aside(lambda: run.estimate(wanted.question))
        count = workers or os.cpu_count() or 1
        if seconds / count > LONG_SECONDS and not (agreed or scheduler):
            told = f"about {duration(seconds / count)} on {count} processor{'s' if count > 1 else ''}"
            raise RequestError(f"this search takes {told}; add --yes if you want to wait, or --scheduler for a cluster. {NARROWER}")
        kept = opened(Path(checkpoint), wanted.question) if checkpoint else None
        with ExitStack() as stack:
            with working(f"asking the scheduler at {scheduler} ..." if scheduler else "starting ..."):
                crew = stack.enter_context(_crew(seconds, workers, count, scheduler))
            tell = stack.enter_context(progress("searching"))
            answer = findings(wanted.question, hands=crew, checkpoint=kept, watch=lambda now: tell(now.done, now.blocks, note(now)))
        most = wanted.question.ask.size
        if isinstance(wanted.question.ask, All) and len(answer.rows) >= most:
            many = f"{answer.stars:,} stars lie within these limits, in more classes than the {most:,} that can be listed"
            raise RequestError(f"{many}; narrow it, as in --limit M1=2, or ask for --best 100")
        return likeness.chosen(answer, wanted.likeness) if wanted.likeness else answer
    except SearchError as error:
        raise RequestError(str(error)) from None


@contextmanager
def _crew(seconds: float, workers: int | None, count: int, scheduler: str | None) -> Iterator[hands.Hands | None]:
    """Who does the work: a cluster, processes of this machine, or this process alone where it is soon done."""
    alone = workers == 1 or (workers is None and seconds < ALONE_SECONDS)
    with hands.cluster(scheduler) if scheduler else nullcontext() if alone else hands.processes(count) as crew:
        yield crew


def note(now: Progress) -> str:
    """How fast a search is, and how long it will take yet."""
    rate = f"{now.met / now.seconds:,.0f} stars/s" if now.seconds > 0 else ""
    left = f", {duration(now.seconds_left)} left" if now.seconds_left is not None else ""
    again = f" (attempt {now.attempt + 1})" if now.attempt else ""
    return f"{rate}{left}{again}"
