"""The verbs of the balancing shop: drill, grade."""

from __future__ import annotations

from cmath import rect
from functools import partial
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from crankstar.cli.options import (
    ENGINE,
    FLAT,
    Csv,
    Estimating,
    Json,
    Output,
    Settings,
    Speed,
    once,
    option,
    read_engine,
    together,
)
from crankstar.cli.tabulating import give, resting_on
from crankstar.language.messages import _
from crankstar.language.numbers import number
from crankstar.options import remedies, workshop
from crankstar.options import values as request
from crankstar.options.forms import TABLES, form_of
from crankstar.options.refusals import RequestError
from crankstar.options.sources import Loaded
from crankstar.options.workshop import DrillOptions

if TYPE_CHECKING:
    from crankstar.analysis.document import Document
    from crankstar.engine.engine import Engine
    from crankstar.files.box import Spread
    from crankstar.remedy.drilling import Drill

AnyEngine = Annotated[str | None, Parameter(help=ENGINE)]
Factor = Annotated[str | None, option("--factor")]


def _factor(text: str | None, found: Loaded) -> tuple[float, bool]:
    """The balance factor that is asked for, else that of the file, else a half; if it is that."""
    own = found.balance_factor if text is None else remedies.factor(text)
    return (remedies.HALF, True) if own is None else (own, False)


def drill(
    engine: AnyEngine = None,
    /,
    *,
    options: Annotated[DrillOptions, FLAT] = DrillOptions(),  # noqa: B008  # it is frozen
    unbalance: Annotated[
        str | None, option("--unbalance", "A mass alone is at the radius of --at-radius.")
    ] = None,
    factor: Factor = None,
    weights: Annotated[str | None, option("--weights", "Default: ends.")] = None,
    settings: Settings = None,
    estimate: Estimating = False,
    json: Json = False,
    csv: Csv = False,
    output: Output = None,
) -> None:
    """Say what to drill, or which slugs to fit: for a measured unbalance, or for an engine's."""
    from crankstar.studies.answers import bobweights
    from crankstar.tables.ranges import ranged

    form = form_of(output, TABLES, json=json, csv=csv)
    if engine is None and unbalance is None:
        raise RequestError(
            "name an engine file with its counterweights, or give what the balancing machine "
            'shows, as in --unbalance "850 g*mm at 20 deg"'
        )
    if engine is None or unbalance is not None:
        others = {
            "--factor": factor,
            "--weights": weights,
            "--set": settings,
            "--estimate": estimate,
        }
        request.refuse_unused({"ENGINE": engine, **others}, beside="--unbalance")
        (made,) = together(partial(workshop.drill_of, options))
        document = _measured_holes(unbalance or "", made)
    else:
        load = once(partial(read_engine, engine, settings, estimate=estimate))
        made, found, (share, assumed) = together(
            partial(workshop.drill_of, options), load, lambda: _factor(factor, load())
        )
        loaded, planes = found.engine, weights or "ends"
        build = partial(_engine_holes, made=made, factor=share, weights=planes)
        rests = resting_on(form, loaded, partial(bobweights, loaded, factor=share, assumed=assumed))
        document = ranged(build, found.spread, loaded, rests=rests)
    give(document, output, form=form)


def _measured_holes(text: str, made: Drill) -> Document:
    """The holes for the unbalances that a balancing machine shows."""
    from crankstar.remedy.drilling import holes
    from crankstar.tables.workshop import Correction, drilling_document

    spots = workshop.measured(text, radius=made.radius)
    corrections = [
        Correction(str(place), None, spot.unbalance, spot.angle, holes(spot.unbalance, made))
        for place, spot in enumerate(spots, 1)
    ]
    lines: list[str] = []
    if any(spot.at_usual_radius for spot in spots):
        radius = number(1000 * made.radius)
        lines.append(
            _("A mass without a radius counts at {radius} mm, that of --at-radius.", radius=radius)
        )
    title = _("Correction of a measured unbalance")
    return drilling_document(title, corrections, made, lines=lines)


def _engine_holes(engine: Engine, made: Drill, factor: float, weights: str) -> Document:
    """The holes for what a crankshaft with its counterweights has too much.

    Those of an engine at the ends of estimated ranges are the holes of the engine as given.
    """
    from crankstar.language.kept import as_given, bounded
    from crankstar.remedy import fitting
    from crankstar.remedy.drilling import heavy_spots, holes
    from crankstar.tables.ranges import estimated_paths
    from crankstar.tables.scales import scales
    from crankstar.tables.workshop import Correction, drilling_document

    if {"mass", "radius", "pitch"} & {*engine.relative}:
        raise RequestError(
            "what to drill is in grams and millimetres; add to the file what it leaves out of "
            "cylinder.stroke, layout.bore_pitch and cylinder.parts or the two masses"
        )
    after = fitting.by_factor(engine, factor=factor, weights=remedies.weights(weights, engine))
    cranks = [shaft for shaft in engine.shafts if shaft.throws]
    lines = []
    if not any(shaft.weights for shaft in cranks):
        lines.append(
            _(
                "The file gives no counterweights: what is listed is all that the throws and "
                "their bobweights come to. Add the crankshaft's weights to the file."
            )
        )
    spots = heavy_spots(engine, after)
    lines.append(
        _(
            "Bobweights of the rotating masses and {factor} of the reciprocating masses.",
            factor=f"{100 * factor:.6g} %",
        )
    )
    if not spots:
        lines.append(_("The counterweights fit the bobweights: nothing is to be drilled."))
    first = {shaft.name: shaft.throws[0].angle for shaft in cranks}
    corrections = []
    for place, spot in enumerate(spots, 1):
        drilled = as_given(("drilled", place), spot)
        corrections.append(
            Correction(
                f"{spot.shaft} {place}" if len(cranks) > 1 else str(place),
                spot.z,
                bounded(spot.unbalance, [[rect(spot.unbalance, spot.angle)]]),
                spot.angle,
                holes(drilled.unbalance, made),
                first[spot.shaft],
                drilled.angle,
            )
        )
    estimated = bool(estimated_paths(engine))
    along = scales(engine).along
    return drilling_document(
        engine.name, corrections, made, along=along, lines=lines, estimated=estimated
    )


def _over_speeds(engine: Engine) -> Spread | None:
    """An engine over the range of its speed, where that is estimated."""
    from crankstar.engine.copies import with_values
    from crankstar.files.box import Spread

    origin = engine.provenance.get("speed")
    if engine.speed is None or origin is None or origin.range is None:
        return None
    low, high = (with_values(engine, speed=end * engine.speed) for end in origin.range)
    middle = with_values(engine, speed=sum(origin.range) / 2 * engine.speed)
    return Spread(engine, middle, (low, high))


def grade(
    engine: AnyEngine = None,
    /,
    *,
    mass: Annotated[str | None, option("--mass")] = None,
    speed: Speed = None,
    grade: Annotated[str | None, option("--grade", "Default: the usual ones.")] = None,
    bearing_distances: Annotated[str | None, option("--bearing-distances")] = None,
    unbalance: Annotated[str | None, option("--unbalance", "Which grade does it meet?")] = None,
    settings: Settings = None,
    json: Json = False,
    csv: Csv = False,
    output: Output = None,
) -> None:
    """Print the unbalance that may remain by ISO 21940-11, or the grade that a measured one meets.

    The speed is that of ENGINE where --speed is not given.
    """
    from crankstar.engine.quantities import MASS
    from crankstar.remedy.grades import shares
    from crankstar.tables.ranges import ranged
    from crankstar.tables.workshop import Rotor, grade_document

    form = form_of(output, TABLES, json=json, csv=csv)
    if engine is None:
        request.refuse_unused({"--set": settings}, without="ENGINE")
    if mass is None:
        raise RequestError('give the mass of the rotor, as in --mass "28 kg"')
    kilograms, turning, wanted, apart, loaded, spots = together(
        partial(workshop.size, "--mass", mass, MASS),
        partial(request.speed, speed),
        lambda: None if grade is None else workshop.grade(grade),
        partial(workshop.distances, bearing_distances),
        lambda: None if engine is None else read_engine(engine, settings, ranged=False).engine,
        lambda: [] if unbalance is None else workshop.measured(unbalance, most=2),
    )
    if turning is None and (loaded is None or loaded.speed is None):
        raise RequestError('give the greatest service speed, as in --speed "6000 rpm"')
    planes = shares(front=apart[0], rear=apart[1])
    found = [spot.unbalance for spot in spots]

    def graded(each: Engine | None) -> Document:
        title = _("Balance quality of a rotor") if each is None else each.name
        own = turning if turning is not None else (each.speed or 0.0) if each is not None else 0.0
        return grade_document(title, Rotor(kilograms, own, planes), grade=wanted, measured=found)

    document = graded(loaded)
    if loaded is not None and turning is None and (spread := _over_speeds(loaded)) is not None:
        document = ranged(graded, spread, loaded)
    give(document, output, form=form)
