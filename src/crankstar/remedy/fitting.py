"""An engine fitted with weights and balance shafts, counterweights first."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache, reduce
from math import cos, sqrt
from typing import Literal, NamedTuple

from crankstar.dynamics.bearings import Model
from crankstar.engine.assembly import GREATEST_SHAFTS
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _, _n, passage
from crankstar.mechanics.balance import default_reference
from crankstar.remedy import (
    GREATEST_RATIO,
    Aim,
    Best,
    Box,
    Limit,
    Placing,
    Plane,
    RemedyError,
    best_weights,
    crank_sweep,
    end_planes,
    end_webs,
    needs,
    placed,
    webs,
    with_balance_shaft,
    with_counterweights,
    with_roll_cancelled,
    with_turning_cancelled,
    with_web_weights,
    without_counterweights,
    without_weights,
)
from crankstar.remedy.clearance import SHAFT_BORE, balance_shafts, bore_of, raised
from crankstar.remedy.sizing import Remedied, resized, with_shafts_like

Places = Literal["pins", "webs", "ends"]
"""Places of weights other than given planes."""
Wanted = Literal["needed", "all"]
"""Which balance shafts: those of the lowest order that remains, or of the first and second."""
FACTORS = (0.5, 0.0, 1.0)
"""Balance factors that can cancel everything that turns with a crankshaft.

One half for one crankshaft; for two counter-rotating ones 0 where their pistons move in opposition,
1 where they move together.
"""
WORTH = 0.01
"""Share of the greatest force, or couple, left to shafts that a balance shaft removes at least."""
BELOW, BESIDE = 1.25, 0.8
"""Assumed depth of balance shafts below the crankshaft, and spacing of a pair, in crank sweeps."""


class Fitted(NamedTuple):
    """An engine with the cure that its verdict recommends, and what was changed.

    `weights` are the new counterweights: on all webs by a balance `factor`, on the end webs by none
    (None), or removed; None where they stay. `ratios` are the speed ratios of new balance shafts.
    """

    after: Engine
    weights: Literal["webs", "ends", "removed"] | None
    factor: float | None
    ratios: tuple[Fraction, ...]

    @property
    def description(self) -> str:
        """The change in sentences, with the assumption behind it."""
        sentences: list[str] = []
        if self.weights == "webs":
            factor = f"{self.factor:g}"
            sentences.append(
                _(
                    "Fitted with counterweights on all webs (balance factor {factor}).",
                    factor=factor,
                )
            )
        elif self.weights is not None:
            sentences.append(_(_WEIGHTS[self.weights]))
        if self.ratios:
            ratios = ", ".join(map(str, self.ratios))
            sentences += [
                _n(
                    "Fitted with a balance shaft of speed ratio {ratios}.",
                    "Fitted with balance shafts of speed ratios {ratios}.",
                    len(self.ratios),
                    ratios=ratios,
                ),
                _(
                    "The engine file gives no place for balance shafts: they are assumed clear of "
                    "the crank, and the rolling moment depends on their place."
                ),
            ]
        return passage(sentences)


_WEIGHTS = {
    "ends": N_("Fitted with counterweights on the end webs; no balance factor would suffice."),
    "removed": N_("Without its counterweights."),
}


@dataclass(frozen=True)
class ShaftPlaces:
    """The place of balance shafts (m or crank radii from the crankshaft) and of their weights.

    `apart` is the spacing of a pair. Without `planes` the weights are in the middle of a shaft that
    cancels a force there, else beyond both ends.
    """

    planes: tuple[float, ...] | None = None
    up: float = 0.0
    right: float = 0.0
    apart: float = 0.0


def by_factor(
    engine: Engine, *, factor: float, weights: Places | Sequence[Plane], bare: bool = False
) -> Engine:
    """The engine with counterweights of a balance factor at its pins, on its webs, or in planes.

    They stand beside those of its crankshafts, which count; `bare`: instead of them. Raises
    RemedyError.
    """
    if weights == "pins":
        return with_counterweights(engine, factor=factor, bare=bare)
    if weights in ("webs", "ends"):
        return with_web_weights(engine, factor=factor, ends_only=weights == "ends", bare=bare)
    return with_counterweights(
        engine,
        factor=factor,
        planes=sorted({plane.z for plane in _planes(engine, weights)}, reverse=True),
        bare=bare,
    )


@lru_cache(maxsize=256)  # the verdict, its tables and figures all ask for it, at every corner
def recommended(engine: Engine, *, bare: bool = False, shafts: Wanted = "needed") -> Fitted | None:
    """The engine with the cure that its verdict proposes; None where order 1 and 2 are balanced.

    Counterweights (`quiet_cranks`) cancel what turns with a crankshaft in order 1 and 2, beside
    those that it has or, with `bare`, instead of them. The rest needs balance shafts, of which
    those of the lowest remaining order are added, clear of the crank (`clear_places`), and unless
    `all` are asked for none that would remove hardly anything (`WORTH`).

    >>> from crankstar.files.catalog import load
    >>> recommended(load("v8-cross-plane")).description
    'Fitted with counterweights on all webs (balance factor 0.5).'
    >>> [str(ratio) for ratio in recommended(load("i4")).ratios]
    ['2', '-2']
    """
    after, weights, factor = engine, None, None
    cranks = {shaft.speed_ratio for shaft in engine.shafts if shaft.throws}
    if any(need.ratio in cranks for need in needs(engine)):
        after, factor = quiet_cranks(engine, bare=bare)
        weighted = any(shaft.weights for shaft in after.shafts if shaft.throws)
        weights = "removed" if not weighted else "webs" if factor is not None else "ends"
    ratios = _ratios_of(after, lowest=False) if needs(after) else []
    if shafts == "needed":
        worth = _worth(after)
        ratios = [each for each in worth if abs(each) == abs(worth[0])]
    if len(after.shafts) + len(ratios) > GREATEST_SHAFTS:
        ratios = []
    if ratios:
        paired = any(-ratio in ratios for ratio in ratios)
        alone = bool(balance_shafts(after)) or any(-ratio not in ratios for ratio in ratios)
        places = clear_places(engine, paired=paired, about_another=alone)
        after = with_shafts(after, ratios=ratios, places=places)
    return Fitted(after, weights, factor, tuple(ratios)) if weights or ratios else None


def _worth(engine: Engine) -> list[Fraction]:
    """Speed ratios of shafts that remove a share WORTH of what the engine has, or more."""
    left = [need for need in needs(engine) if need.ratio != 1]
    force = WORTH * max((abs(need.force) for need in left), default=0.0)
    couple = WORTH * max((abs(need.couple) for need in left), default=0.0)
    return [need.ratio for need in left if abs(need.force) > force or abs(need.couple) > couple]


def recommended_like(
    fitted: Fitted, before: Engine, engine: Engine, *, bare: bool = False
) -> Fitted:
    """The cure of the engine `before`, sized for the masses of another one."""
    own = recommended(engine, bare=bare)
    like = Remedied(before, fitted.after)
    return fitted._replace(after=resized(like, engine, None if own is None else own.after))


def clear_places(engine: Engine, *, paired: bool, about_another: bool = False) -> ShaftPlaces:
    """The place of balance shafts clear of the first crankshaft, away from its cylinders.

    They lie below it where cylinders point both ways; a pair lies side by side, far enough apart
    for another one between them if there is one, and below the balance shafts that the engine has
    where these would be in its way. Lengths to two figures.

    >>> from crankstar.files.catalog import load
    >>> clear_places(load("i4"), paired=True)
    ShaftPlaces(planes=None, up=-2.4, right=0.0, apart=1.5)
    """
    crank = engine.shafts[0]
    own = [cylinder for cylinder in engine.cylinders if cylinder.shaft == crank.name]
    reach = crank_sweep(engine)
    downward = sum(cos(cylinder.bearing) for cylinder in own) < -0.5 * len(own)
    away = 1 if downward else -1
    radius = SHAFT_BORE * bore_of(engine)
    apart = raised(4 * radius) if about_another else 0.0
    apart = max(apart, float(f"{BESIDE * reach:.2g}"))
    below = raised(max(BELOW * reach, reach + radius))
    sides = (apart / 2, -apart / 2) if paired else (0.0,)
    for depth, aside in sorted((away * one.up, one.right) for one in balance_shafts(engine)):
        for side in sides:
            room = sqrt(max((2 * radius) ** 2 - (aside - side) ** 2, 0.0))
            if depth - room < below < depth + room:
                below = raised(depth + room)
    return ShaftPlaces(up=away * below, apart=apart if paired else 0.0)


@lru_cache(maxsize=8)  # the record of an answer and its verdict ask the same
def quiet_cranks(engine: Engine, *, bare: bool = False) -> tuple[Engine, float | None]:
    """The engine with counterweights that cancel what turns with a crankshaft, and their factor.

    This holds for force and couple up to order 2. They are on all webs if a balance factor is
    enough, else on the end webs (factor None): where cylinder axes miss the crank axis (VR
    engines), or counter-rotating crankshafts share unevenly (Deltic). The crankshafts keep the
    weights that they have unless they are to be `bare`, or need none at all.
    """
    cranks = {shaft.speed_ratio for shaft in engine.shafts if shaft.throws}
    for factor in FACTORS:
        weighted = with_web_weights(engine, factor=factor, bare=bare)
        if not any(need.ratio in cranks for need in needs(weighted)):
            instead = with_web_weights(engine, factor=factor, bare=True)
            needless = not any(shaft.weights for shaft in instead.shafts if shaft.throws)
            return instead if needless else weighted, factor
    start = without_counterweights(engine) if bare else engine
    return reduce(
        lambda weighted, ratio: with_turning_cancelled(weighted, ratio=ratio), sorted(cranks), start
    ), None


def best(
    engine: Engine,
    *,
    weights: Places | Sequence[Plane],
    aim: Aim,
    limits: Sequence[Limit] = (),
    greatest_unbalance: float | None = None,
    bare: bool = False,
    model: Model = "determinate",
    speed: float | None = None,
) -> Best:
    """The best weights in these places, beside those of the crankshafts; `bare`: instead.

    A smaller couple must not cost a greater force, nor the reverse: unless a limit or the aim names
    the other quantity, its rms stays at most that of the crankshafts as they are, or bare. Loads on
    main bearings are shared by the `model`.
    """
    named = {limit.aim.quantity for limit in limits} | {aim.quantity}
    others = [Aim(other, rms=True) for other in ("force", "couple") if other not in named]
    implied = [
        Limit(other, without_weights(engine, other, bare=bare) * (1 + 1e-9), implied=True)
        for other in others
    ]
    return best_weights(
        engine,
        planes=_planes(engine, weights),
        aim=aim,
        limits=[*limits, *implied],
        greatest_unbalance=greatest_unbalance,
        bare=bare,
        model=model,
        speed=speed,
    )


def _planes(engine: Engine, weights: Places | Sequence[Plane]) -> list[Plane]:
    places = {
        "pins": lambda shaft: tuple(dict.fromkeys(throw.z for throw in shaft.throws)),
        "webs": lambda shaft: webs(engine, shaft),
        "ends": lambda shaft: end_webs(engine, shaft),
    }
    if isinstance(weights, str):
        return [
            Plane(shaft.name, z)
            for shaft in engine.shafts
            if shaft.throws
            for z in places[weights](shaft)
        ]
    return list(weights)


def with_shafts(
    engine: Engine,
    *,
    ratios: Sequence[Fraction] | Wanted,
    places: ShaftPlaces,
    level: bool = False,
    like: Remedied | None = None,
) -> Engine:
    """The engine with balance shafts of these speed ratios, or with those that it needs.

    `needed` are those of the lowest order that remains, as engines are built; `all` those of the
    first and the second. Shafts of the same ratio share the task equally; one beside others with
    nothing to cancel is left out. With `level` the two shafts of a pair are moved to the heights at
    which the block does not roll. Those of a remedy `like` which it is to be are sized for this
    engine. Raises RemedyError.
    """
    if like is not None:
        after = with_shafts_like(like, engine)
        new = [shaft.speed_ratio for shaft in like.new_shafts]
        return _levelled(after, new) if level else after
    wanted = (
        list(ratios)
        if not isinstance(ratios, str)
        else _ratios_of(engine, lowest=ratios == "needed")
    )
    if places.apart and not any(-ratio in wanted for ratio in wanted):
        raise RemedyError(
            "there is no pair of balance shafts to space; --shaft-place places a single shaft"
        )
    bare = engine
    for index, ratio in enumerate(wanted):
        if len(wanted) > 1 and _idle(engine, ratio):
            continue  # the shafts before it may have cancelled it
        planes = _along(engine, ratio) if places.planes is None else places.planes
        aside = (places.apart / 2 if ratio > 0 else -places.apart / 2) if -ratio in wanted else 0.0
        engine = with_balance_shaft(
            engine,
            ratio=ratio,
            planes=planes,
            up=places.up,
            right=places.right + aside,
            share=1 / wanted[index:].count(ratio),
        )
    if engine is bare:
        raise RemedyError(
            "no force or couple turns with shafts of the speed ratios {ratios}; leave them out",
            ratios=", ".join(map(str, wanted)),
        )
    return _levelled(engine, wanted) if level else engine


def _levelled(engine: Engine, ratios: Sequence[Fraction]) -> Engine:
    """The engine with its pairs of shafts at the heights at which the block does not roll."""
    pairs = sorted({abs(ratio) for ratio in ratios if -ratio in ratios})
    if not pairs:
        raise RemedyError(
            "there is no pair of balance shafts to move; give two speed ratios, such as 2, -2"
        )
    return reduce(lambda moved, order: with_roll_cancelled(moved, order=order), pairs, engine)


def _idle(engine: Engine, ratio: Fraction) -> bool:
    """Whether a shaft of a possible speed ratio would have nothing to cancel."""
    possible = 0 < abs(ratio) <= GREATEST_RATIO
    return possible and all(need.ratio != ratio for need in needs(engine, highest=GREATEST_RATIO))


def with_placed_shafts(
    engine: Engine,
    *,
    ratios: Sequence[Fraction] | Wanted,
    boxes: Sequence[Box],
    planes: tuple[float, ...] | None = None,
    like: Remedied | None = None,
    clear: bool = False,
) -> tuple[Engine, tuple[Placing, ...]]:
    """The engine with balance shafts where they leave the least roll in their boxes.

    `planes` are those of their weights; `clear` as in `placed`. Raises RemedyError.
    """
    after = with_shafts(engine, ratios=ratios, places=ShaftPlaces(planes), like=like)
    new = [shaft.name for shaft in after.shafts[len(engine.shafts) :]]
    first = None if like is None else like.after
    return placed(after, shafts=new, boxes=boxes, like=first, clear=clear)


def _along(engine: Engine, ratio: Fraction) -> tuple[float, ...]:
    """The planes of its weights: the middle if it cancels a force there, else beyond both ends."""
    couple = next(
        (need.couple for need in needs(engine, highest=GREATEST_RATIO) if need.ratio == ratio), 1.0
    )
    return end_planes(engine) if couple else (default_reference(engine).z,)


def _ratios_of(engine: Engine, *, lowest: bool) -> list[Fraction]:
    """Speed ratios of the shafts that the engine needs, of the lowest order or of both."""
    ratios = [need.ratio for need in needs(engine) if need.ratio != 1]
    if not ratios:
        raise RemedyError(
            "the engine needs no balance shafts: no first or second order remains for them"
        )
    return [ratio for ratio in ratios if abs(ratio) == abs(ratios[0])] if lowest else ratios
