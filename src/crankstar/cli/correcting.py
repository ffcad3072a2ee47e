"""The verb correct: corrections of a rotor in two planes."""

from __future__ import annotations

from cmath import rect
from functools import partial
from math import pi, radians
from os.path import realpath
from typing import TYPE_CHECKING, Annotated

import numpy as np
from cyclopts import Parameter

from crankstar.cli.options import FLAT, Csv, Json, option, together
from crankstar.cli.output import working, writable, write, write_bytes
from crankstar.cli.tabulating import give, words_for
from crankstar.engine.quantities import LENGTH, POSITION
from crankstar.files import units
from crankstar.files.lists import read_list
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options import workshop
from crankstar.options.forms import PICTURES, TABLES, form_of, suffix_of
from crankstar.options.refusals import RequestError, refusal
from crankstar.options.workshop import DrillOptions
from crankstar.remedy.two_planes import Split

if TYPE_CHECKING:
    from crankstar.analysis.document import Document
    from crankstar.charts.grammar import Chart
    from crankstar.options.coefficients import Coefficients
    from crankstar.remedy.drilling import Drill
    from crankstar.spectra import Complex
    from crankstar.tables.two_planes import Corrections

RUNS = "CSV file (or .xlsx) with an initial run, and one with a trial weight in each plane."
MOST_POSITIONS = 360
APART = 1e-4
"""Metres: planes of a rotor nearer to each other are at one place."""


def correct(
    runs: Annotated[str | None, Parameter(help=RUNS)] = None,
    /,
    *,
    unbalance: Annotated[
        str | None, option("--unbalance", "Two, in the measuring planes, with directions.")
    ] = None,
    measuring_planes: Annotated[str | None, option("--measuring-planes")] = None,
    correction_planes: Annotated[str | None, option("--correction-planes")] = None,
    coefficients: Annotated[str | None, option("--coefficients")] = None,
    save_coefficients: Annotated[str | None, option("--save-coefficients")] = None,
    positions: Annotated[str | None, option("--positions")] = None,
    options: Annotated[DrillOptions, FLAT] = DrillOptions(),  # noqa: B008  # it is frozen
    json: Json = False,
    csv: Csv = False,
    output: Annotated[str | None, option("--output", "A picture (.svg) has the vectors.")] = None,
) -> None:
    """Say what to add or to drill in two planes of a rotor."""
    from crankstar.options.coefficients import coefficients_text

    form = form_of(output, (*TABLES, *PICTURES), json=json, csv=csv)
    both = {"--measuring-planes": measuring_planes, "--correction-planes": correction_planes}
    if (runs is None) == (unbalance is None):
        raise RequestError(
            "give either a list of runs with trial weights, or what a balancing machine shows, as "
            'in --unbalance "850 g*mm at 20 deg, 400 g*mm at 200 deg"'
        )
    if runs is not None:
        request.refuse_unused(both, beside="RUNS")
    others = {"--coefficients": coefficients, "--save-coefficients": save_coefficients}
    if runs is None:
        request.refuse_unused(others, beside="--unbalance")
    if coefficients is not None:
        own = {"--save-coefficients": save_coefficients}
        request.refuse_unused(own, beside="--coefficients")
    drill, radius, allowed, _saved = together(
        partial(_drill, options),
        partial(_radius, options),
        partial(_positions, positions),
        partial(_check_saved, save_coefficients, apart=(runs, output)),
    )
    request.refuse_unused({"--positions": positions}, beside="--diameter") if drill else None
    with words_for(form if form in TABLES else "txt"):
        if runs is not None:
            found, own = _of_runs(runs, coefficients, radius, allowed)
            saved = None if save_coefficients is None else coefficients_text(own)
        else:
            found = _of_machine(unbalance or "", both, radius, allowed)
            saved = None
        if form in PICTURES:
            _draw(found, form, output)
            _save(saved, save_coefficients)
            return
        document = _document(found, drill)
    _save(saved, save_coefficients)
    give(document, output, form=form)


def _drill(options: DrillOptions) -> Drill | None:
    """The drill, where a hole is described."""
    given = options.model_dump(exclude={"at_radius"}, exclude_defaults=True)
    return workshop.drill_of(options) if given else None


def _radius(options: DrillOptions) -> float | None:
    text = options.at_radius
    return None if text is None else workshop.size("--at-radius", text, LENGTH)


def _positions(text: str | None) -> list[float] | None:
    """Allowed positions: so many at equal steps from 0, or their angles."""
    if text is None:
        return None
    parts = request.listed(text)
    if len(parts) == 1 and parts[0].isdecimal():
        count = int(parts[0])
        if not 3 <= count <= MOST_POSITIONS:
            raise refusal("--positions", text, "give from 3 to {most} of them", most=MOST_POSITIONS)
        return [2 * pi * at / count for at in range(count)]
    if len(parts) < 2:
        raise refusal(
            "--positions",
            text,
            "give how many there are at equal steps, as in 12, or the angles of two or more, as in "
            '"0, 45, 90 deg"',
        )
    return [radians(each) for each in request.degrees("--positions", text)]


def _planes(option: str, text: str | None) -> list[float]:
    """Two places along the rotor."""
    parts = request.listed(text)
    if len(parts) != 2:
        raise refusal(option, text or '""', 'give two places, as in "0 mm, 400 mm"')
    found: list[float] = []
    for part in parts:
        if units.is_bare(part):
            raise refusal(option, part, "write it with a unit, {example}", example='"400 mm"')
        with request.reading(option):
            found.append(units.si(part, POSITION))
    if abs(found[0] - found[1]) < APART:
        raise refusal(option, text or "", "the two are at one place; give planes apart")
    return found


def _of_machine(
    text: str, both: dict[str, str | None], radius: float | None, allowed: list[float] | None
) -> Corrections:
    """Corrections for the unbalance that a balancing machine shows in two planes."""
    from crankstar.remedy.two_planes import in_planes
    from crankstar.tables.two_planes import Corrections

    spots, at, planes = together(
        partial(workshop.measured, text, radius=radius, most=2),
        *(partial(_planes, name, value) for name, value in both.items()),
    )
    if len(spots) != 2 or any(spot.angle is None for spot in spots):
        raise refusal("--unbalance", text, "give two, each with its direction: heavy spots")
    measured = np.array([rect(spot.unbalance, spot.angle or 0.0) for spot in spots])
    found = in_planes(measured, at=at, planes=planes)
    return Corrections(found, _added(found, allowed), radius, measured, at)


def _of_runs(
    place: str, coefficients: str | None, radius: float | None, allowed: list[float] | None
) -> tuple[Corrections, Coefficients]:
    """Corrections by influence coefficients of trial runs, or by known ones; the coefficients."""
    from crankstar.options.coefficients import Coefficients, coefficients_of, in_units_of
    from crankstar.options.trial_runs import trial_runs
    from crankstar.remedy.two_planes import effects, influence, share_left
    from crankstar.tables.two_planes import Corrections

    known = coefficients is not None
    runs, *others = together(
        lambda: trial_runs(read_list(place), known=known),
        *([lambda: coefficients_of(read_list(coefficients))] if coefficients is not None else []),
    )
    if not runs.initial.any():
        raise RequestError("the initial run has no vibration: there is nothing to correct")
    if coefficients is not None:
        matrix = in_units_of(others[0], runs.shown, option="--coefficients", given=coefficients)
    else:
        matrix = influence(runs.initial, runs.trials, runs.runs)
    found = np.linalg.solve(matrix, runs.initial)
    check = runs.check
    return Corrections(
        found,
        _added(found, allowed),
        radius,
        left=None if check is None else np.linalg.solve(matrix, check),
        effects=None if known else effects(runs.initial, runs.runs),
        influence=matrix,
        left_share=None if check is None else share_left(matrix, runs.initial, check),
        known=known,
    ), Coefficients(matrix, runs.shown)


def _check_saved(place: str | None, *, apart: tuple[str | None, str | None]) -> None:
    """Refuse a name under which no coefficients can be written.

    `apart`: what is read, and what else is written. Raises RequestError.
    """
    if place is None:
        return
    if suffix_of(place) != "csv":
        raise refusal("--save-coefficients", place, "the name must end in .csv")
    if any(realpath(place) == realpath(other) for other in apart if other is not None):
        raise refusal(
            "--save-coefficients",
            place,
            "it is read or written besides and would be lost; name another",
        )
    writable(place, option="--save-coefficients")
    if apart[-1] is not None:
        writable(apart[-1])


def _save(text: str | None, place: str | None) -> None:
    if text is not None:
        write(text, place, option="--save-coefficients")


def _added(unbalance: Complex, allowed: list[float] | None) -> tuple[tuple[Split, ...], ...]:
    """What to add in each plane: opposite the heavy spot, or at allowed positions beside that."""
    from crankstar.remedy.two_planes import split

    if allowed is not None:
        return tuple(split(complex(-each), allowed) for each in unbalance)
    return tuple(
        (Split(float(np.angle(-each)), float(abs(each))),) if abs(each) else ()
        for each in unbalance
    )


def _document(found: Corrections, drill: Drill | None) -> Document:
    from crankstar.remedy.drilling import holes
    from crankstar.tables.two_planes import corrections_document
    from crankstar.tables.workshop import Correction, drilling_document

    if drill is None:
        return corrections_document(found)
    made = [
        Correction(str(at), None, float(abs(each)), float(np.angle(each)), holes(abs(each), drill))
        for at, each in enumerate(found.unbalance, 1)
    ]
    return corrections_document(found, drilling_document("", made, drill))


def _draw(found: Corrections, form: str, output: str | None) -> None:
    """The unbalance and what is added to it, plane by plane."""
    from crankstar.options import charts as chart_request

    drawing = chart_request.charts()
    title = _("Correction in two planes")

    def draw() -> Chart:
        diagrams = [
            drawing.Diagram(
                _("plane {number}", number=at),
                (
                    drawing.Named(_("heavy spot"), 1e6 * complex(own)),
                    *(
                        drawing.Named(_("add"), 1e6 * rect(each.unbalance, each.angle))
                        for each in added
                    ),
                ),
            )
            for at, (own, added) in enumerate(zip(found.unbalance, found.added, strict=True), 1)
        ]
        about = _("unbalance in g mm; 0 deg is up, angles run clockwise")
        return drawing.polar_vectors(diagrams, title=title, subtitle=[about])

    look = chart_request.paper(form, theme=None, width=None, height=None, dpi=None, font_size=None)
    with working(_("Drawing {chart} ...", chart=title)):
        made = drawing.printed(draw, look, title=title)
        write_bytes(drawing.saved_print(made, form, title=title), output)
