"""The options of `crankstar balance` as they are typed, and the balanced engine they ask for."""

from __future__ import annotations

from pydantic import BaseModel, ConfigDict, Field

from crankstar.engine.engine import Engine
from crankstar.options import values as request
from crankstar.options.refusals import RequestError
from crankstar.remedy import fitting
from crankstar.tables.remedies import Job


class BalanceOptions(BaseModel):
    """The options of a balance as they are typed: a factor or best weights, balance shafts."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    factor: float | None = Field(
        default=None,
        description="Share of the reciprocating mass on each pin that is balanced, 0 to 1.5 "
        "(default: the file's, else 0.5).",
    )
    weights: str = Field(
        default="pins",
        description="Places of the counterweights: pins (the default), webs, ends (the end webs), "
        'or positions along the shaft, such as "-200 mm, 200 mm".',
    )
    minimise: str | None = Field(
        default=None,
        description="Instead of a factor, find the weights that minimise one of force, couple, "
        "pitch, yaw, each also with rms in front, or bearing (the greatest load on a main "
        "bearing).",
    )
    pitch_share: float | None = Field(
        default=None,
        description="With --minimise couple: weight of pitch, 0 to 1; yaw has the rest (default: "
        "equal).",
    )
    limit: list[str] = Field(
        default=[],
        description="With --minimise: upper limit, such as couple=50% (of bare crankshafts), "
        'couple=1.5 (m r ω² a) or force="500 N"; repeatable.',
    )
    greatest_unbalance: str | None = Field(
        default=None,
        description='With --minimise: greatest unbalance of one weight, such as "0.02 kg*m".',
    )
    radius: str | None = Field(
        default=None,
        description='Radius at which the masses of weights are given, such as "60 mm" (default: '
        "the crank radius).",
    )
    shafts: str | None = Field(
        default=None,
        description="Add balance shafts: needed (the lowest order that remains; also without a "
        'value), all (first and second order), or speed ratios, such as -1 or "2, -2".',
    )
    shaft_planes: str | None = Field(
        default=None,
        description="Positions of the weights along the balance shafts (default: beyond both "
        "ends).",
    )
    shaft_place: str | None = Field(
        default=None,
        description='Up and right of the crankshaft, such as "-60 mm, 0 mm" (default: on its '
        "axis).",
    )
    shaft_spacing: str | None = Field(
        default=None,
        description='Horizontal distance between the two shafts of a pair, such as "120 mm" '
        "(default: 0).",
    )
    level: bool = Field(
        default=False,
        description="Move the two shafts of a pair to the heights at which the block does not "
        "roll.",
    )
    recommended: bool = Field(
        default=False,
        description="Fit what `crankstar verdict` recommends: the counterweights that cancel what "
        "turns with the crankshafts, then balance shafts for the lowest order that remains.",
    )


PARTS = {
    "minimise": ("pitch_share", "limit", "greatest_unbalance"),
    "shafts": ("shaft_planes", "shaft_place", "shaft_spacing", "level"),
}
"""Options that have an effect only with another one."""


def balanced(
    engine: Engine, options: BalanceOptions, *, speed: str | None = None, own_factor: float = 0.5
) -> Job:
    """The engine before and after; `own_factor` is the balance factor of its file.

    Raises RequestError and RemedyError.
    """
    for name, parts in PARTS.items():
        given = {f"--{part.replace('_', '-')}": getattr(options, part) for part in parts}
        if getattr(options, name) is None:
            request.refuse_unused(given, without=f"--{name}")
    places = request.weights(options.weights, engine)
    radius = request.length("--radius", options.radius, engine, positive=True)
    turning = engine.speed if speed is None else request.speed(speed)
    if options.recommended:
        return _recommended(engine, options)._replace(radius=radius, speed=turning)
    if options.minimise is None:
        factor = own_factor if options.factor is None else options.factor
        after = fitting.by_factor(engine, factor=factor, weights=places)
        job = Job(engine, after, factor, radius=radius, speed=turning)
    else:
        request.refuse_unused({"--factor": options.factor}, beside="--minimise")
        best = fitting.best(
            engine,
            weights=places,
            aim=request.aim("--minimise", options.minimise, pitch=options.pitch_share),
            limits=request.limits(options.limit, engine, speed=turning),
            greatest_unbalance=request.unbalance(
                "--greatest-unbalance", options.greatest_unbalance, engine
            ),
        )
        job = Job(engine, best.engine, None, best, radius, turning)
    return _with_shafts(job, options)


def _recommended(engine: Engine, options: BalanceOptions) -> Job:
    """The job that fits what the verdict recommends. Raises RequestError."""
    others = {"--factor": options.factor, "--minimise": options.minimise}
    weights = None if options.weights == "pins" else options.weights
    request.refuse_unused(
        {**others, "--weights": weights, "--shafts": options.shafts}, beside="--recommended"
    )
    fitted = fitting.recommended(engine)
    if fitted is None:
        raise RequestError(
            "--recommended: no primary or secondary force or couple remains that weights or "
            "balance shafts remove"
        )
    return Job(engine, fitted.after, fitted.factor, description=fitted.description)


def _with_shafts(job: Job, options: BalanceOptions) -> Job:
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
