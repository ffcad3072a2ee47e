"""The options of `crankstar balance` as they are typed, and the balanced engine they ask for."""

from __future__ import annotations

from fractions import Fraction

from pydantic import BaseModel, ConfigDict, Field

from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.options import remedies
from crankstar.options import values as request
from crankstar.options.refusals import RequestError
from crankstar.options.vocabulary import meaning
from crankstar.remedy import balance_shafts, fitting, placed
from crankstar.remedy.kept import with_source
from crankstar.tables.remedies import Job


class BalanceOptions(BaseModel):
    """The options of a balance as they are typed: a factor or best weights, balance shafts."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    factor: str | None = Field(default=None, description=meaning("--factor"))
    bare: bool = Field(default=False, description=meaning("--bare"))
    weights: str = Field(default="pins", description=meaning("--weights", "Default: pins."))
    minimise: str | None = Field(
        default=None,
        description=meaning(
            "--minimise",
            "Instead of a factor, find the weights for one of force, couple, pitch, yaw, roll, "
            "each also with rms in front, roll 2 (one order), or bearing (the greatest load on a "
            "main bearing).",
        ),
    )
    model: str | None = Field(default=None, description=meaning("--model"))
    pitch_share: float | None = Field(default=None, description=meaning("--pitch-share"))
    limit: list[str] = Field(
        default=[],
        description=meaning(
            "--limit",
            "With --minimise, such as couple=50% (of bare crankshafts), couple=1.5 (m r ω² a) or "
            'force="500 N".',
        ),
    )
    greatest_unbalance: str | None = Field(
        default=None, description=meaning("--greatest-unbalance")
    )
    radius: str | None = Field(default=None, description=meaning("--radius"))
    shafts: str | None = Field(default=None, description=meaning("--shafts"))
    shaft_planes: str | None = Field(default=None, description=meaning("--shaft-planes"))
    shaft_place: str | None = Field(default=None, description=meaning("--shaft-place"))
    shaft_spacing: str | None = Field(default=None, description=meaning("--shaft-spacing"))
    box: list[str] = Field(default=[], description=meaning("--box"))
    level: bool = Field(default=False, description=meaning("--level"))
    recommended: bool = Field(default=False, description=meaning("--recommended"))


PARTS = {
    "minimise": ("pitch_share", "limit", "greatest_unbalance"),
    "shafts": ("shaft_planes", "shaft_place", "shaft_spacing", "level"),
}
"""Options that have an effect only with another one."""


def balanced(
    engine: Engine, options: BalanceOptions, *, speed: str | None = None, own_factor: float = 0.5
) -> Job:
    """The engine before and after; `own_factor` is the balance factor of its file.

    Weights that are sized for estimated masses say so. Raises RequestError and RemedyError.
    """
    job = _balanced(engine, options, speed=speed, own_factor=own_factor)
    return job._replace(after=with_source(engine, job.after))


def _balanced(
    engine: Engine, options: BalanceOptions, *, speed: str | None, own_factor: float
) -> Job:
    for name, parts in PARTS.items():
        given = {f"--{part.replace('_', '-')}": getattr(options, part) for part in parts}
        if getattr(options, name) is None:
            request.refuse_unused(given, without=f"--{name}")
    model = remedies.model(options.model)
    places = remedies.weights(options.weights, engine)
    radius = request.length("--radius", options.radius, engine, positive=True)
    turning = engine.speed if speed is None else request.speed(speed)
    if options.recommended:
        job = _recommended(engine, options)
        return job._replace(radius=radius, speed=turning, model=model)
    if _moves_only(options):
        job = Job(engine, engine, None, radius=radius, speed=turning, model=model)
    elif options.minimise is None:
        factor = own_factor if options.factor is None else remedies.factor(options.factor)
        after = fitting.by_factor(engine, factor=factor, weights=places, bare=options.bare)
        job = Job(engine, after, factor, radius=radius, speed=turning, model=model)
    else:
        request.refuse_unused({"--factor": options.factor}, beside="--minimise")
        best = fitting.best(
            engine,
            weights=places,
            aim=remedies.aim("--minimise", options.minimise, pitch=options.pitch_share),
            limits=remedies.limits(options.limit, engine, speed=turning, model=model),
            greatest_unbalance=remedies.unbalance(
                "--greatest-unbalance", options.greatest_unbalance, engine
            ),
            bare=options.bare,
            model=model,
        )
        job = Job(engine, best.engine, None, best, radius, turning, model=model)
    return _with_shafts(job, options)


def _moves_only(options: BalanceOptions) -> bool:
    """Whether only the balance shafts of the file are placed, and the weights stay."""
    others = (options.factor, options.minimise, options.shafts)
    return bool(options.box) and not any(others) and not (options.bare or options.recommended)


def _recommended(engine: Engine, options: BalanceOptions) -> Job:
    """The job that fits what the verdict recommends. Raises RequestError."""
    unused = {
        "--factor": options.factor,
        "--minimise": options.minimise,
        "--weights": None if options.weights == "pins" else options.weights,
        "--shafts": options.shafts,
        "--box": options.box,
    }
    request.refuse_unused(unused, beside="--recommended")
    fitted = fitting.recommended(engine, bare=options.bare)
    if fitted is None:
        raise RequestError(
            "--recommended: no primary or secondary force or couple remains that weights or "
            "balance shafts remove"
        )
    return Job(engine, fitted.after, fitted.factor, description=fitted.description)


def _with_shafts(job: Job, options: BalanceOptions) -> Job:
    """The job with its balance shafts, if any."""
    if options.shafts is None:
        return _with_moved_shafts(job, options) if options.box else job
    ratios = remedies.ratios(options.shafts)
    if options.box:
        return _with_placed_shafts(job, options, ratios)
    places = remedies.shaft_places(
        job.before,
        planes_text=options.shaft_planes,
        place=options.shaft_place,
        spacing=options.shaft_spacing,
    )
    after = fitting.with_shafts(job.after, ratios=ratios, places=places, level=options.level)
    return job._replace(after=after)


def _with_moved_shafts(job: Job, options: BalanceOptions) -> Job:
    """The job with the balance shafts of the file where they leave the least roll in their boxes.

    Raises RequestError where the file has none.
    """
    names = [shaft.name for shaft in balance_shafts(job.after)]
    if not names:
        raise RequestError(
            "--box: the engine file has no balance shafts to place; add them with --shafts, as in "
            "--shafts needed"
        )
    boxes = [remedies.box(text, job.before) for text in options.box]
    after, placings = placed(job.after, shafts=names, boxes=boxes)
    return job._replace(after=after, placings=placings)


def new_name(job: Job, options: BalanceOptions) -> str:
    """The name of the balanced engine: that of the file, and what was done to it."""
    if options.recommended:
        done = [_("balanced as recommended")]
    elif _moves_only(options):
        done = [_("balance shafts placed")]
    elif options.minimise is not None:
        done = [_("weights for least {quantity}", quantity=_(options.minimise))]
    else:
        done = [_("balance factor {factor}", factor=f"{job.factor or 0.0:.6g}")]
    if options.shafts is not None:
        done.append(_("balance shafts: {ratios}", ratios=options.shafts))
    return ", ".join((job.before.name, *done))


def _with_placed_shafts(
    job: Job, options: BalanceOptions, ratios: list[Fraction] | fitting.Wanted
) -> Job:
    """The job with its balance shafts where they leave the least roll in their boxes."""
    fixed = {
        "--shaft-place": options.shaft_place,
        "--shaft-spacing": options.shaft_spacing,
        "--level": options.level,
    }
    request.refuse_unused(fixed, beside="--box")
    along = remedies.shaft_planes(options.shaft_planes, job.before)
    boxes = [remedies.box(text, job.before) for text in options.box]
    after, placings = fitting.with_placed_shafts(
        job.after, ratios=ratios, boxes=boxes, planes=along
    )
    return job._replace(after=after, placings=placings)
