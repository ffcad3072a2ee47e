"""The verbs fault and diagnose: what a fault changes, and which fault explains a measurement."""

from __future__ import annotations

import re
from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

from crankstar.cli.options import (
    Csv,
    EngineName,
    Json,
    Output,
    Settings,
    Speed,
    loaded_engine,
    option,
    together,
)
from crankstar.cli.output import complain, working, write_bytes
from crankstar.cli.tabulating import give, resting_on, words_for
from crankstar.engine.quantities import MASS
from crankstar.files import units
from crankstar.files.lists import read_list
from crankstar.language.messages import _
from crankstar.mechanics.occurring_orders import check_orders
from crankstar.options import charts as chart_request
from crankstar.options import values as request
from crankstar.options.forms import PICTURES, TABLES, form_of
from crankstar.options.gas import gas_orders, share, weaker_cylinders
from crankstar.options.refusals import RequestError, refusal

if TYPE_CHECKING:
    from crankstar.engine.engine import Engine
    from crankstar.studies.diagnosis import Diagnosis
    from crankstar.studies.readings import Reading
    from crankstar.studies.single_faults import Fault

MEASURED = (
    "CSV file (or .xlsx): columns order, up, right, z, direction, amplitude, phase; also speed, "
    "error."
)
HEAVIER = {"piston": "piston", "big_end": "big_end", "big-end": "big_end", "rod": "big_end"}
"""The parts that may be heavier by their names."""


def fault(
    engine: EngineName,
    /,
    *,
    cut: Annotated[str | None, option("--cut")] = None,
    weaker: Annotated[list[str] | None, option("--weaker")] = None,
    heavier: Annotated[list[str] | None, option("--heavier")] = None,
    lost_weight: Annotated[list[str] | None, option("--lost-weight")] = None,
    speed: Speed = None,
    point: Annotated[str | None, option("--point")] = None,
    at: Annotated[str | None, option("--at")] = None,
    orders: Annotated[str | None, option("--orders", "Default: up to 6, with halves.")] = None,
    settings: Settings = None,
    json: Json = False,
    csv: Csv = False,
    output: Output = None,
) -> None:
    """Tell what would be felt of a fault."""
    from crankstar.studies.response_answers import felt
    from crankstar.studies.single_faults import check_faults, known, shaken
    from crankstar.tables.diagnoses import faults_document, shown_orders
    from crankstar.tables.ranges import resting

    form = form_of(output, TABLES, json=json, csv=csv)
    loaded, turning, wanted, *parts = together(
        partial(loaded_engine, engine, settings),
        partial(request.speed, speed),
        partial(gas_orders, orders),
        partial(_cut, cut),
        partial(_weaker, weaker),
        partial(_heavier, heavier),
        partial(_lost, lost_weight),
    )
    faults = [each for some in parts for each in some]
    if not faults:
        raise RequestError(
            "name a fault: --cut 3, --weaker 3=20%, --heavier piston.3=20g or --lost-weight 2"
        )
    check_faults(known(loaded), faults)
    check_orders(loaded, wanted or (), gas=loaded.gas is not None or point is not None)
    where = request.block_point(at, loaded)
    if where is None and loaded.block is not None and loaded.block.points:
        where = loaded.block.points[0].place
    rest: dict[str, Any] = {"point": point or "", "speed": turning, "orders": wanted or ()}
    with working(_("Computing what changes ...")), words_for(form):
        before, after = (shaken(loaded, some, **rest) for some in ((), faults))
        document = faults_document(before, after, faults, point=where, every=form != "txt")
        answered = partial(
            felt,
            loaded,
            faults,
            point=point or "",
            speed=turning,
            orders=shown_orders(document) or wanted or (),
            at=where,
        )
        document = resting(document, resting_on(form, loaded, answered))
    give(document, output, form=form)


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


def _cut(text: str | None) -> list[Fault]:
    from crankstar.studies.single_faults import Fault

    if text is None:
        return []
    parts = request.listed(text)
    if not parts or any(not part.isdecimal() or len(part) > 4 for part in parts):
        raise refusal("--cut", text, "give numbers of cylinders, as in 2,3")
    return [Fault("combustion", int(part)) for part in dict.fromkeys(parts)]


def _weaker(texts: Sequence[str] | None) -> list[Fault]:
    from crankstar.studies.single_faults import Fault

    return [Fault("combustion", number, lost) for number, lost in weaker_cylinders(texts)]


def _heavier(texts: Sequence[str] | None) -> list[Fault]:
    from crankstar.studies.single_faults import Fault

    found: list[Fault] = []
    for text in texts or ():
        match = re.fullmatch(r"\s*([a-z_-]+)[.\s](\d{1,4})\s*=\s*(.+)", text, re.IGNORECASE)
        kind = None if match is None else HEAVIER.get(match[1].lower())
        if match is None or kind is None:
            raise refusal(
                "--heavier", text, "give a part, its cylinder and a mass, as in piston.3=20g"
            )
        if units.is_bare(match[3]):
            raise refusal("--heavier", text, "write the mass with a unit, such as 20g")
        with request.reading("--heavier"):
            size = units.si(match[3], MASS)
        found.append(Fault("piston" if kind == "piston" else "big_end", int(match[2]), size))
    return found


def _lost(texts: Sequence[str] | None) -> list[Fault]:
    from crankstar.studies.single_faults import Fault

    found: list[Fault] = []
    for text in texts or ():
        match = re.fullmatch(r"\s*(?:(.+)\.)?(\d{1,4})\s*(?:=\s*(.+))?", text)
        if match is None:
            raise refusal("--lost-weight", text, "give the number of a weight, as in 2 or 2=30%")
        lost = 1.0 if match[3] is None else share("--lost-weight", text, match[3].strip())
        found.append(Fault("weight", int(match[2]), lost, match[1] or ""))
    return found
