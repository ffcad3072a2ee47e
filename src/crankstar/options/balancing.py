"""The options of `crankstar balance` as they are typed, and the balanced engine they ask for."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from typing import get_args

from pydantic import BaseModel, ConfigDict, Field

from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.options import points, remedies
from crankstar.options import values as request
from crankstar.options.refusals import RequestError, together
from crankstar.options.vocabulary import meaning
from crankstar.remedy import balance_shafts, fitting, placed, without_weights
from crankstar.remedy.aim_names import aim_name, aim_text
from crankstar.remedy.kept import with_source
from crankstar.remedy.sizing import Remedied, with_weights_like
from crankstar.tables.remedies import Job

KEPT = 1e-6
"""What a limit may be exceeded by, of it and in its unit."""


class BalanceOptions(BaseModel):
    """The options of a balance as they are typed: a factor or best weights, balance shafts."""

    model_config = ConfigDict(extra="forbid", frozen=True)

    factor: str | None = Field(default=None, description=meaning("--factor"))
    bare: bool = Field(default=False, description=meaning("--bare"))
    weights: str | None = Field(
        default=None,
        description=meaning("--weights", "Default: pins; none where only shafts are asked for."),
    )
    minimise: str | None = Field(
        default=None,
        description=meaning(
            "--minimise",
            "Instead of a factor, find the weights for one of force, couple, pitch, yaw, roll, "
            "each also with rms in front or an order behind, as in pitch 1 (M1V; M1H is yaw 1), or "
            "bearing (the greatest load on a main bearing).",
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
    shaft_radius: str | None = Field(default=None, description=meaning("--shaft-radius"))
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
    engine: Engine,
    options: BalanceOptions,
    *,
    speed: str | None = None,
    own_factor: float | None = None,
    like: Job | None = None,
) -> Job:
    """The engine before and after; `own_factor` is the balance factor of its file, if any.

    With `like` it is the remedy of that job, sized for the masses of this engine. Weights that are
    sized for estimated masses say so. Raises RequestError and RemedyError.
    """
    if like is not None and engine is like.before:
        return like
    job = _balanced(engine, options, speed=speed, own_factor=own_factor, like=like)
    return job._replace(after=with_source(engine, job.after))


def readings(
    options: BalanceOptions, engine: Callable[[], Engine], *, speed: str | None = None
) -> Iterator[Callable[[], object]]:
    """What refuses the options, one by one, before anything is computed.

    The engine is read by those that depend on it.
    """
    shafts, radius = options.shafts, options.radius
    yield partial(request.speed, speed)
    for name, parts in PARTS.items():
        given = {f"--{part.replace('_', '-')}": getattr(options, part) for part in parts}
        if getattr(options, name) is None:
            yield partial(request.refuse_unused, given, without=f"--{name}")
    for name, text in (("--radius", radius), ("--shaft-radius", options.shaft_radius)):
        yield lambda name=name, text=text: points.length(name, text, engine(), positive=True)
    yield partial(remedies.model, options.model)
    if options.recommended:
        yield from _beside_recommended(options)
        return
    if options.factor is not None:
        yield partial(remedies.factor, options.factor)
    if options.weights is not None:
        weights = options.weights
        yield lambda: remedies.weights(weights, engine())
    if options.minimise is not None:
        yield from _of_aim(options, options.minimise, engine, speed)
    if not fits_weights(options):
        yield partial(request.refuse_unused, {"--radius": radius}, without="--weights")
    if shafts is not None:
        yield partial(remedies.ratios, shafts)
        yield lambda: remedies.shaft_planes(options.shaft_planes, engine())
    if options.box:
        fixed = {
            "--shaft-place": options.shaft_place,
            "--shaft-spacing": options.shaft_spacing,
            "--level": options.level,
        }
        yield partial(request.refuse_unused, fixed if shafts is not None else {}, beside="--box")
        for text in options.box:
            yield lambda text=text: remedies.box(text, engine())
    elif shafts is not None:
        yield lambda: remedies.shaft_place(options.shaft_place, engine())
        yield lambda: points.length("--shaft-spacing", options.shaft_spacing, engine())


def _beside_recommended(options: BalanceOptions) -> Iterator[Callable[[], object]]:
    """What refuses the options that the recommended remedy does not take."""
    unused = {
        "--factor": options.factor,
        "--minimise": options.minimise,
        "--weights": options.weights,
        "--shafts": None if options.shafts in get_args(fitting.Wanted) else options.shafts,
        **{f"--{part.replace('_', '-')}": getattr(options, part) for part in PARTS["shafts"]},
    }
    yield partial(request.refuse_unused, unused, beside="--recommended")
    yield partial(_refuse_box, options)


def _refuse_box(options: BalanceOptions) -> None:
    if options.box:
        raise RequestError(
            "--box: --recommended places its shafts itself; name them to place them, as in "
            "--factor 0.5 --shafts -1 --box"
        )


def _of_aim(
    options: BalanceOptions, minimise: str, engine: Callable[[], Engine], speed: str | None
) -> Iterator[Callable[[], object]]:
    """What refuses the aim of weights, and its limits."""

    def limits() -> object:
        model = remedies.model(options.model)
        at = engine().speed if speed is None else request.speed(speed)
        return remedies.limits(options.limit, engine(), speed=at, model=model)

    yield partial(request.refuse_unused, {"--factor": options.factor}, beside="--minimise")
    yield partial(remedies.aim, "--minimise", minimise, pitch=options.pitch_share)
    yield limits
    unbalance = options.greatest_unbalance
    yield lambda: remedies.unbalance("--greatest-unbalance", unbalance, engine())


def _balanced(
    engine: Engine,
    options: BalanceOptions,
    *,
    speed: str | None,
    own_factor: float | None,
    like: Job | None,
) -> Job:
    if like is None:
        together(*readings(options, lambda: engine, speed=speed))
    job = Job(
        engine,
        engine,
        radius=points.length("--radius", options.radius, engine, positive=True),
        shaft_radius=points.length("--shaft-radius", options.shaft_radius, engine, positive=True),
        speed=engine.speed if speed is None else request.speed(speed),
        model=remedies.model(options.model),
    )
    if options.recommended:
        job = _recommended(job, options, like)
    else:
        if fits_weights(options):
            job = _with_weights(job, options, own_factor)
            if like is not None:
                after = with_weights_like(Remedied(like.before, like.after), engine, job.after)
                job = job._replace(after=after)
        job = _with_shafts(job, options, like)
        if like is None:
            _check_limits(job)
    if not balance_shafts(job.after):
        request.refuse_unused({"--shaft-radius": options.shaft_radius}, without="--shafts")
    return job


def fits_weights(options: BalanceOptions) -> bool:
    """Whether counterweights are asked for: by an option of theirs, or by none of another remedy.

    >>> fits_weights(BalanceOptions()), fits_weights(BalanceOptions(shafts="-1"))
    (True, False)
    """
    asked = any(text is not None for text in (options.factor, options.weights, options.minimise))
    return asked or options.bare or not (options.shafts is not None or options.box)


def _with_weights(job: Job, options: BalanceOptions, own_factor: float | None) -> Job:
    """The job with counterweights of a balance factor, or with those that minimise an aim."""
    engine = job.before
    places = remedies.weights("pins" if options.weights is None else options.weights, engine)
    if options.minimise is None:
        factor = remedies.HALF if own_factor is None else own_factor
        if options.factor is not None:
            factor = remedies.factor(options.factor)
        after = fitting.by_factor(engine, factor=factor, weights=places, bare=options.bare)
        return job._replace(after=after, factor=factor)
    best = fitting.best(
        engine,
        weights=places,
        aim=remedies.aim("--minimise", options.minimise, pitch=options.pitch_share),
        limits=remedies.limits(options.limit, engine, speed=job.speed, model=job.model),
        greatest_unbalance=remedies.unbalance(
            "--greatest-unbalance", options.greatest_unbalance, engine
        ),
        bare=options.bare,
        model=job.model,
        speed=job.speed,
    )
    return job._replace(after=best.engine, best=best)


def _recommended(job: Job, options: BalanceOptions, like: Job | None) -> Job:
    """The job that fits what the verdict recommends. Raises RequestError."""
    shafts = "all" if options.shafts == "all" else "needed"
    first = job.before if like is None else like.before
    fitted = fitting.recommended(first, bare=options.bare, shafts=shafts)
    if fitted is None:
        raise RequestError(
            "--recommended: no primary or secondary force or couple remains that weights or "
            "balance shafts remove"
        )
    fitted = fitting.recommended_like(fitted, first, job.before, bare=options.bare)
    return job._replace(after=fitted.after, factor=fitted.factor, description=fitted.description)


def _check_limits(job: Job) -> None:
    """Refuse balance shafts with which a limit is not kept, beside the best weights."""
    if job.best is None or len(job.after.shafts) == len(job.before.shafts):
        return
    for limit, _value in job.best.limits:
        now = without_weights(job.after, limit.aim, bare=False, model=job.model)
        if not limit.implied and now > limit.at_most * (1 + KEPT) + KEPT:
            raise RequestError(
                "--limit: with the balance shafts the {aim} is {found}, over its limit of {limit}; "
                "leave --shafts out, or the limit",
                aim=aim_name(limit.aim),
                found=aim_text(limit.aim, now, job.before, job.speed),
                limit=aim_text(limit.aim, limit.at_most, job.before, job.speed),
            )


def _with_shafts(job: Job, options: BalanceOptions, like: Job | None) -> Job:
    """The job with its balance shafts, if any."""
    if options.shafts is None:
        return _with_moved_shafts(job, options, like) if options.box else job
    ratios = remedies.ratios(options.shafts)
    if options.box:
        job = _with_placed_shafts(job, options, ratios, like)
    else:
        places = remedies.shaft_places(
            job.before,
            planes_text=options.shaft_planes,
            place=options.shaft_place,
            spacing=options.shaft_spacing,
        )
        after = fitting.with_shafts(
            job.after, ratios=ratios, places=places, level=options.level, like=_remedied(like)
        )
        job = job._replace(after=after)
    fitted = {shaft.speed_ratio for shaft in job.after.shafts[len(job.before.shafts) :]}
    idle = () if isinstance(ratios, str) else dict.fromkeys(r for r in ratios if r not in fitted)
    return job._replace(idle=tuple(idle))


def _with_moved_shafts(job: Job, options: BalanceOptions, like: Job | None) -> Job:
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
    first = None if like is None else like.after
    after, placings = placed(job.after, shafts=names, boxes=boxes, like=first, clear=True)
    return job._replace(after=after, placings=placings)


def new_name(job: Job, options: BalanceOptions) -> str:
    """The name of the balanced engine: that of the file, and what was done to it, said once."""
    name = job.before.name
    done: list[str] = []
    if options.recommended:
        done.append(_("balanced as recommended"))
    elif options.minimise is not None:
        done.append(_("weights for least {quantity}", quantity=_(options.minimise)))
    elif job.factor is not None:
        done.append(_("balance factor {factor}", factor=f"{job.factor:.6g}"))
        name = _without_factor(name)
    elif options.shafts is None:
        done.append(_("balance shafts placed"))
    if options.shafts is not None:
        done.append(_("balance shafts: {ratios}", ratios=options.shafts))
    return one_line(", ".join((name, *(words for words in done if f", {words}" not in name))))


def _without_factor(name: str) -> str:
    """The name of a balanced engine without its factor: its weights count in the new one."""
    said = re.escape(", " + _("balance factor {factor}", factor="=")).replace("=", r"-?[\d.]+")
    return re.sub(said, "", name)


def _remedied(job: Job | None) -> Remedied | None:
    return None if job is None else Remedied(job.before, job.after)


def _with_placed_shafts(
    job: Job, options: BalanceOptions, ratios: list[Fraction] | fitting.Wanted, like: Job | None
) -> Job:
    """The job with its balance shafts where they leave the least roll in their boxes."""
    along = remedies.shaft_planes(options.shaft_planes, job.before)
    boxes = [remedies.box(text, job.before) for text in options.box]
    after, placings = fitting.with_placed_shafts(
        job.after, ratios=ratios, boxes=boxes, planes=along, like=_remedied(like), clear=True
    )
    return job._replace(after=after, placings=placings)
