"""The options of `crankstar balance` as values, and the balanced engine that they ask for."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from crankstar.engine.engine import Engine
from crankstar.options import values as request
from crankstar.remedy import fitting
from crankstar.tables.remedies import Job


@dataclass(frozen=True)
class BestOptions:
    """Best weights instead of a balance factor; every field as written on a command line."""

    minimise: str | None = None
    pitch_share: float | None = None
    limit: Sequence[str] = ()
    greatest_unbalance: str | None = None


@dataclass(frozen=True)
class ShaftOptions:
    """Balance shafts; every field as written on a command line."""

    shafts: str | None = None
    shaft_planes: str | None = None
    shaft_place: str | None = None
    shaft_spacing: str | None = None
    level: bool = False


@dataclass(frozen=True)
class BalanceOptions:
    """The options of `crankstar balance`; `own_factor` is the factor of the file, or 0.5."""

    factor: float | None = None
    weights: str = "pins"
    best: BestOptions = BestOptions()
    shafts: ShaftOptions = ShaftOptions()
    radius: str | None = None
    speed: str | None = None
    own_factor: float = 0.5


def balanced(engine: Engine, options: BalanceOptions) -> Job:
    """The engine before and after. Raises RequestError and RemedyError."""
    _check(options)
    places = request.weights(options.weights, engine)
    radius = request.length("--radius", options.radius, engine, positive=True)
    speed = engine.speed if options.speed is None else request.speed(options.speed)
    if options.best.minimise is None:
        factor = options.own_factor if options.factor is None else options.factor
        job = Job(
            engine, fitting.by_factor(engine, factor=factor, weights=places), factor, radius=radius
        )
    else:
        best = fitting.best(
            engine,
            weights=places,
            aim=request.aim("--minimise", options.best.minimise, pitch=options.best.pitch_share),
            limits=request.limits(options.best.limit, engine, speed=speed),
            greatest_unbalance=request.unbalance(
                "--greatest-unbalance", options.best.greatest_unbalance, engine
            ),
        )
        job = Job(engine, best.engine, None, best, radius)
    return _with_shafts(job._replace(speed=speed), options.shafts)


def _check(options: BalanceOptions) -> None:
    """Refuse options without effect. Raises RequestError."""
    best, shafts = options.best, options.shafts
    if best.minimise is None:
        request.alone(
            "a balance factor",
            {
                "--pitch-share": best.pitch_share,
                "--limit": best.limit or None,
                "--greatest-unbalance": best.greatest_unbalance,
            },
        )
    else:
        request.alone("--minimise", {"--factor": options.factor})
    if shafts.shafts is None:
        request.alone(
            "a balance without --shafts",
            {
                "--shaft-planes": shafts.shaft_planes,
                "--shaft-place": shafts.shaft_place,
                "--shaft-spacing": shafts.shaft_spacing,
                "--level": shafts.level or None,
            },
        )


def _with_shafts(job: Job, options: ShaftOptions) -> Job:
    """The job with its balance shafts, if any."""
    if options.shafts is None:
        return job
    places = request.shaft_places(
        job.before,
        planes_text=options.shaft_planes,
        place=options.shaft_place,
        spacing=options.shaft_spacing,
    )
    ratios = request.ratios(options.shafts)
    after = fitting.with_shafts(job.after, ratios=ratios, places=places, level=options.level)
    return job._replace(after=after)
