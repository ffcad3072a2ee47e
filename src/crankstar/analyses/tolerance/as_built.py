"""What views tell of engines built to the tolerances of their file, where it has any.

It is worked out once for a verdict, the section of a report and the panel of a page.
"""

from __future__ import annotations

from crankstar.analyses.tolerance import RECORD
from crankstar.analyses.tolerance.answer import compute
from crankstar.analyses.tolerance.document import sentences
from crankstar.analyses.tolerance.question import Question
from crankstar.analyses.tolerance.scatter import Scatter, ScatterError
from crankstar.files.tolerances import tolerances_of
from crankstar.options.sources import Loaded


def as_built(file: Loaded, *, speed: float | None = None) -> Scatter | None:
    """The scatter of the engine of a file; None without significant tolerances.

    At `speed` (rad/s), else at that of the file.

    >>> from crankstar.options.sources import loaded
    >>> as_built(loaded("i4")) is None
    True
    """
    if not tolerances_of(file.tree):
        return None
    try:
        return compute(file, Question(speed=speed, **RECORD.views))
    except ScatterError:  # no force depends on what has tolerances
        return None


def facts(file: Loaded, *, speed: float | None = None) -> list[str]:
    """The sentences of a verdict."""
    found = as_built(file, speed=speed)
    return [] if found is None else sentences(found)
