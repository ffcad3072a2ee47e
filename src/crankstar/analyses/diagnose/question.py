"""What is asked of a measurement."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any

from crankstar.analysis.reader import Reader
from crankstar.engine.engine import Engine
from crankstar.files.lists import Listed, ListError, list_given, read_list
from crankstar.language.messages import N_
from crankstar.options import readers
from crankstar.options.refusals import RequestError

if TYPE_CHECKING:
    from crankstar.analyses.diagnose.readings import Reading

MEASURED = N_(
    "CSV file (or .xlsx): columns order, up, right, z, direction, amplitude, phase; also speed, "
    "error."
)


def _listed(name: str) -> Callable[[Any], Listed]:
    """What reads a list that Python gives: a data frame, rows by heading, a path."""
    return partial(list_given, name=name)


@dataclass(frozen=True)
class Question:
    """Which list was measured, and before the fault; at which speed (rad/s) and point."""

    measured: Annotated[Listed, Reader("measured", read_list, MEASURED, number=_listed("measured"))]
    before: Annotated[Listed | None, Reader("--before", read_list, number=_listed("before"))] = None
    speed: Annotated[float | None, readers.SPEED] = None
    point: Annotated[str, readers.POINT] = ""

    def readings(self, engine: Engine) -> tuple[Sequence[Reading], Sequence[Reading]]:
        """Those measured and those before, none without. Raises RequestError, GasError."""
        from crankstar.analyses.diagnose.readings import readings_of
        from crankstar.mechanics.operating_points import operating_state

        speed = operating_state(engine, point=self.point, speed=self.speed).speed
        lists: list[Sequence[Reading]] = []
        errors: dict[str, None] = {}
        for listed in (self.measured, self.before):
            try:
                lists.append(() if listed is None else readings_of(listed, engine, speed=speed))
            except ListError as error:
                errors[str(error)] = None
        if errors:
            text = "\n".join(errors)
            raise RequestError(text)
        measured, before = lists
        return measured, before


def refuse(engine: Engine, question: Question) -> None:
    """Refuse lists with errors, of both at once. Raises RequestError, GasError."""
    question.readings(engine)
