"""The verb diagnose: which fault explains a measurement."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from crankstar.cli.options import (
    Csv,
    EngineName,
    Json,
    Settings,
    Speed,
    loaded_engine,
    option,
    together,
)
from crankstar.cli.output import complain, working, write_bytes
from crankstar.cli.tabulating import give, resting_on, words_for
from crankstar.files.lists import read_list
from crankstar.language.messages import _
from crankstar.options import charts as chart_request
from crankstar.options import values as request
from crankstar.options.forms import PICTURES, TABLES, form_of

if TYPE_CHECKING:
    from crankstar.engine.engine import Engine
    from crankstar.studies.diagnosis import Diagnosis
    from crankstar.studies.readings import Reading

MEASURED = (
    "CSV file (or .xlsx): columns order, up, right, z, direction, amplitude, phase; also speed, "
    "error."
)


def diagnose(
    engine: EngineName,
    measured: Annotated[str, Parameter(help=MEASURED)],
    /,
    *,
    before: Annotated[str | None, option("--before")] = None,
    speed: Speed = None,
    point: Annotated[str | None, option("--point")] = None,
    settings: Settings = None,
    json: Json = False,
    csv: Csv = False,
    output: Annotated[
        str | None, option("--output", "A picture (.svg) has the suspects and vectors.")
    ] = None,
) -> None:
    """Find the likeliest fault by measured vibration."""
    from crankstar.mechanics.operating_points import operating_state
    from crankstar.studies.answers import explained
    from crankstar.studies.diagnosis import diagnosed
    from crankstar.tables.diagnoses import diagnosis_document
    from crankstar.tables.ranges import resting

    form = form_of(output, (*TABLES, *PICTURES), json=json, csv=csv)
    loaded, turning = together(
        partial(loaded_engine, engine, settings), partial(request.speed, speed)
    )
    state = operating_state(loaded, point=point or "", speed=turning)
    own = state.speed
    found_lists = together(
        partial(_readings, measured, loaded, own),
        *([partial(_readings, before, loaded, own)] if before is not None else []),
    )
    healthy: Sequence[Reading] = found_lists[1] if before is not None else ()
    with working(_("Trying every fault ...")), words_for(form if form in TABLES else "txt"):
        found = diagnosed(loaded, found_lists[0], before=healthy, point=point or "")
        if form in PICTURES:
            _draw(found, form, output)
            return
        every = form != "txt"
        document = diagnosis_document(found, every=every, before=before is not None)
        answered = partial(explained, found)
        document = resting(document, resting_on(form, loaded, answered))
    give(document, output, form=form)


def _draw(found: Diagnosis, form: str, output: str | None) -> None:
    drawing = chart_request.charts()
    title = _("{engine}: diagnosis", engine=found.engine.name)
    look = chart_request.paper(form, theme=None, width=None, height=None, dpi=None, font_size=None)
    made = drawing.printed(partial(drawing.suspect_chart, found), look, title=title)
    write_bytes(drawing.saved_print(made, form, title=title), output)
    for line in made.chart.notes:
        complain(line)


def _readings(place: str, engine: Engine, speed: float | None) -> Sequence[Reading]:
    from crankstar.studies.readings import readings_of

    return readings_of(read_list(place), engine, speed=speed)
