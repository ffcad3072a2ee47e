"""A search as the command line runs it: estimated, shared out, reported, kept in a file."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, nullcontext
from pathlib import Path

from crankstar.cli.checkpoints import kept
from crankstar.cli.output import progress, working
from crankstar.cli.search_options import Work
from crankstar.language.messages import _
from crankstar.language.numbers import duration
from crankstar.options.search import whole
from crankstar.options.values import RequestError
from crankstar.stars import estimates, executors, halves
from crankstar.stars.answer import Answer, answer_to
from crankstar.stars.interrupts import aside
from crankstar.stars.options import Search
from crankstar.stars.progress import note

LONG_SECONDS = 3600.0
"""A search longer than this must be agreed to."""
ALONE_SECONDS = 4.0
"""A search shorter than this is done in this process: starting others would take as long."""


def answer_of(search: Search, work: Work, *, workers: int | None) -> Answer:
    """The answer. Raises SearchError, and RequestError where it takes long without consent."""
    question = search.question
    halves.check(question)
    # one that is there may be of another search: nothing is compiled for it
    there = work.checkpoint is not None and Path(work.checkpoint).exists()
    checkpoint = kept(work.checkpoint, question) if there else None
    with working(_("Getting ready (the first search is compiled for about ten seconds) ...")):
        seconds = aside(lambda: estimates.estimate(question))
    count = workers or os.cpu_count() or 1
    if seconds / count > LONG_SECONDS and not (work.yes or work.scheduler):
        raise RequestError(
            "This search takes about {duration} on {count} processors. To narrow it, fix throws "
            "(--fix 1=0,2=3), ask for symmetric cranks (--symmetric) or require a sum to vanish "
            "(--zero M2). To run it all the same, add --yes; to use a cluster, --scheduler.",
            duration=duration(seconds / count),
            count=count,
        )
    checkpoint = checkpoint or kept(work.checkpoint, question)
    with ExitStack() as stack:
        with working(_("Starting workers ...")):
            alone = workers == 1 or (workers is None and seconds < ALONE_SECONDS)
            pool = stack.enter_context(_workers(0 if alone else count, work.scheduler))
        show = stack.enter_context(progress(_("searching")))
        answer = answer_to(
            question,
            workers=pool,
            checkpoint=checkpoint,
            watch=lambda now: show(now.done, now.blocks, note(now)),
        )
    return whole(search, answer)


@contextmanager
def _workers(count: int, scheduler: str | None) -> Iterator[executors.Workers | None]:
    """A cluster, so many processes of this machine, or None for this process alone."""
    with (
        executors.cluster(scheduler)
        if scheduler
        else executors.processes(count)
        if count
        else nullcontext()
    ) as workers:
        yield workers
