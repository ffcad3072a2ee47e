"""An engine fitted with weights and balance shafts in the order in which it is done: crankshafts first, then the rest."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from math import cos
from typing import TYPE_CHECKING, Literal, NamedTuple

from crankstar.balance import default_reference
from crankstar.engine import GREATEST_SHAFTS, Engine
from crankstar.remedy import (
    GREATEST_RATIO,
    Aim,
    Best,
    Limit,
    Plane,
    RemedyError,
    best_weights,
    end_planes,
    end_webs,
    needs,
    webs,
    with_balance_shaft,
    with_counterweights,
    with_roll_cancelled,
    with_turning_cancelled,
    with_web_weights,
    without_counterweights,
    without_weights,
)

if TYPE_CHECKING:
    from crankstar.derive import Chapter

Places = Literal["pins", "webs", "ends"]
"""Where weights go that are not put into planes of one's own choice."""


Wanted = Literal["needed", "all"]
"""Which balance shafts: those of the lowest order that is left, or of the first and second."""


FACTORS = (0.5, 0.0, 1.0)
"""Balance factors that can leave nothing turning with a crankshaft: of one crankshaft half; of two that turn against each
other none where their pistons move against each other, all of the reciprocating mass where they move together."""


BELOW, BESIDE, HALF_BORE = 1.25, 0.8, 0.45
"""Recommended balance shafts: how far below the crankshaft and how far from each other, in reaches of the crank. It reaches as
far as its greatest throw and, for webs and big ends, `HALF_BORE` bores more."""


PLACE_ASSUMED = "The place of balance shafts is assumed, clear of the crank; the roll of the block follows from it."


class Fitted(NamedTuple):
    """An engine with what its verdict recommends, what that is in words, and by which balance factor if it is one of these."""

    after: Engine
    done: tuple[str, ...]
    factor: float | None

    @property
    def told(self) -> str:
        """What was done, and what of it is assumed."""
        shafts = any("balance shaft" in one for one in self.done)
        return f"Fitted with {' and '.join(self.done)}." + (f" {PLACE_ASSUMED}" if shafts else "")


@dataclass(frozen=True)
class ShaftPlaces:
    """Where balance shafts lie (m or crank radii from the crankshaft), and their weights along them.

    Without `planes` these are in the middle where a shaft takes a force there, else beyond both ends.
    """

    planes: tuple[float, ...] | None = None
    up: float = 0.0
    right: float = 0.0
    apart: float = 0.0


def by_factor(engine: Engine, *, factor: float, weights: Places | Sequence[Plane]) -> Engine:
    """The engine with counterweights of a balance factor at its pins, on its webs, or in planes. Raises RemedyError."""
    if weights == "pins":
        return with_counterweights(engine, factor=factor)
    if weights in ("webs", "ends"):
        return with_web_weights(engine, factor=factor, ends_only=weights == "ends")
    return with_counterweights(engine, factor=factor, planes=sorted({plane.z for plane in _planes(engine, weights)}, reverse=True))


def recommended(engine: Engine) -> Fitted | None:
    """The engine with what its verdict says can be done, or None where nothing of the first two orders is left.

    Where something turns with a crankshaft there are other counterweights (`quiet_cranks`), and no force and no couple of the
    first two orders is left that turns as a crankshaft does. The rest needs balance shafts; there are those of the lowest
    order that is left, as engines are built; they lie clear of the crank (`clear_places`), so that their roll is that of shafts
    which could be built.

    >>> from crankstar.catalog import load
    >>> recommended(load("v8-cross-plane")).told
    'Fitted with counterweights on all webs (balance factor 0.5).'
    >>> recommended(load("i4")).told  # doctest: +ELLIPSIS
    'Fitted with balance shafts of speed ratios 2 and -2. The place of balance shafts is assumed, clear of the crank; ...'
    """
    after, factor, done = engine, FACTORS[0], []
    cranks = {shaft.speed_ratio for shaft in engine.shafts if shaft.throws}
    if any(need.ratio in cranks for need in needs(engine)):
        after, factor = quiet_cranks(engine)
        other = "other " if any(shaft.weights for shaft in engine.shafts if shaft.throws) else ""
        how = "the end webs (by no balance factor)" if factor is None else f"all webs (balance factor {factor:g})"
        bare = not any(shaft.weights for shaft in after.shafts if shaft.throws)
        done.append("no counterweights" if bare else f"{other}counterweights on {how}")
    ratios = _wanted(after, lowest=True) if needs(after) else []
    if ratios and len(after.shafts) + len(ratios) <= GREATEST_SHAFTS:
        after = with_shafts(after, ratios="needed", places=clear_places(engine, paired=any(-ratio in ratios for ratio in ratios)))
        several = "balance shafts of speed ratios" if len(ratios) > 1 else "a balance shaft of speed ratio"
        done.append(f"{several} {' and '.join(map(str, ratios))}")
    return Fitted(after, tuple(done), factor) if done else None


def clear_places(engine: Engine, *, paired: bool) -> ShaftPlaces:
    """Where balance shafts clear the first crankshaft: on the side away from its cylinders, below it where they point both ways.

    A pair lies side by side, its shafts equally far from the middle. Lengths of the engine, to two figures.

    >>> from crankstar.catalog import load
    >>> clear_places(load("i4"), paired=True)
    ShaftPlaces(planes=None, up=-2.4, right=0.0, apart=1.5)
    """
    crank = engine.shafts[0]
    own = [cylinder for cylinder in engine.cylinders if cylinder.shaft == crank.name]
    bore = max(cylinder.bore or 2 * engine.throw(cylinder).radius for cylinder in engine.cylinders)
    reach = max(throw.radius for shaft in engine.shafts for throw in shaft.throws) + HALF_BORE * bore
    downward = sum(cos(cylinder.bearing) for cylinder in own) < -0.5 * len(own)
    away = 1 if downward else -1
    return ShaftPlaces(up=_rounded(away * BELOW * reach), apart=_rounded(BESIDE * reach) if paired else 0.0)


def _rounded(length: float) -> float:
    return float(f"{length:.2g}")


def quiet_cranks(engine: Engine) -> tuple[Engine, float | None]:
    """The engine with counterweights that leave nothing turning as a crankshaft does, and the balance factor that they follow.

    That holds for force and couple up to order 2. They stand on all webs if a balance factor does it; where none does, they stand
    on the end webs and follow none (None): where cylinder axes miss the crankshaft (VR engines), or crankshafts turn against each
    other and share unevenly (Deltic).
    """
    cranks = {shaft.speed_ratio for shaft in engine.shafts if shaft.throws}
    for factor in FACTORS:
        weighted = with_web_weights(engine, factor=factor)
        if not any(need.ratio in cranks for need in needs(weighted)):
            return weighted, factor
    bare = without_counterweights(engine)
    return reduce(lambda made, ratio: with_turning_cancelled(made, ratio=ratio), sorted(cranks), bare), None


def best(
    engine: Engine,
    *,
    weights: Places | Sequence[Plane],
    aim: Aim,
    limits: Sequence[Limit] = (),
    greatest_unbalance: float | None = None,
) -> Best:
    """The best weights in these places. Unless a limit says otherwise they must not buy a couple with a force, or the reverse.

    So where nothing is said of it, the rms of the other quantity stays at most what it is with bare crankshafts.
    """
    named = {limit.aim.quantity for limit in limits} | {aim.quantity}
    others = [Aim(other, rms=True) for other in ("force", "couple") if other not in named]
    quiet = [Limit(other, without_weights(engine, other) * (1 + 1e-9), quiet=True) for other in others]
    return best_weights(
        engine, planes=_planes(engine, weights), aim=aim, limits=[*limits, *quiet], greatest_unbalance=greatest_unbalance
    )


def _planes(engine: Engine, weights: Places | Sequence[Plane]) -> list[Plane]:
    found = {
        "pins": lambda shaft: tuple(dict.fromkeys(throw.z for throw in shaft.throws)),
        "webs": lambda shaft: webs(engine, shaft),
        "ends": lambda shaft: end_webs(engine, shaft),
    }
    if isinstance(weights, str):
        return [Plane(shaft.name, z) for shaft in engine.shafts if shaft.throws for z in found[weights](shaft)]
    return list(weights)


def with_shafts(engine: Engine, *, ratios: Sequence[Fraction] | Wanted, places: ShaftPlaces, level: bool = False) -> Engine:
    """The engine with balance shafts of these speed ratios, or with those that it needs.

    `needed` are those of the lowest order that is left, which is what engines are built with; `all` those of the first and the
    second. With `level` the two shafts of a pair are moved to the heights at which the block does not roll. Raises RemedyError.
    """
    wanted = list(ratios) if not isinstance(ratios, str) else _wanted(engine, lowest=ratios == "needed")
    twice = next((ratio for ratio in wanted if wanted.count(ratio) > 1), None)
    if twice is not None:
        raise RemedyError(
            f"a shaft of speed ratio {twice} is asked for twice; one takes the whole vector away that turns at its speed"
        )
    if places.apart and not any(-ratio in wanted for ratio in wanted):
        raise RemedyError("there is no pair of balance shafts that could lie apart; say where a single one lies with --shaft-place")
    for ratio in wanted:
        if isinstance(ratios, str) and ratio not in {need.ratio for need in needs(engine)}:
            continue  # nothing beside what the shafts before it push
        planes = _along(engine, ratio) if places.planes is None else places.planes
        aside = (places.apart / 2 if ratio > 0 else -places.apart / 2) if -ratio in wanted else 0.0
        engine = with_balance_shaft(engine, ratio=ratio, planes=planes, up=places.up, right=places.right + aside)
    if level:
        pairs = sorted({abs(ratio) for ratio in wanted if -ratio in wanted})
        if not pairs:
            raise RemedyError("there is no pair of balance shafts whose heights could be chosen; ask for two, as in 2, -2")
        for order in pairs:
            engine = with_roll_cancelled(engine, order=order)
    return engine


def _along(engine: Engine, ratio: Fraction) -> tuple[float, ...]:
    """Where the weights of a balance shaft stand: in the middle if it takes a force there, else beyond both ends."""
    couple = next((need.couple for need in needs(engine, highest=GREATEST_RATIO) if need.ratio == ratio), 1.0)
    return end_planes(engine) if couple else (default_reference(engine).z,)


def _wanted(engine: Engine, *, lowest: bool) -> list[Fraction]:
    found = [need.ratio for need in needs(engine) if need.ratio != 1]
    if not found:
        told = "nothing of the first and second order is left that one could take away"
        raise RemedyError(f"the engine needs no balance shafts: {told}")
    return [ratio for ratio in found if abs(ratio) == abs(found[0])] if lowest else found


def proofs(before: Engine, after: Engine) -> list[Chapter]:
    """For the crankshaft and each balance shaft of `after` the exact weights in its planes, and the proof that nothing is left.

    The exact weights are the least that take all of their vector away, as those of half the reciprocating mass do; weights of
    the crankshafts that leave some of it are not spoken of. Raises DerivationError.
    """
    from crankstar.derive import cure  # exact algebra is loaded only where it is asked for

    chapters: list[Chapter] = []
    bare, crank, count = without_counterweights(before), after.shafts[0], len(before.shafts)
    left, there = ([need for need in needs(one, highest=1) if need.ratio == 1] for one in (after, bare))
    if crank.weights and there and not left:
        chapters.append(cure(bare, ratio=1, planes=sorted({weight.z for weight in crank.weights}, reverse=True)).chapter)
    for place, shaft in enumerate(after.shafts[count:], count):
        # Only what turns as this shaft does adds to its vector; weights that do not would only bring their decimals.
        alike = tuple(one for one in after.shafts[count:place] if one.speed_ratio == shaft.speed_ratio)
        base = after if shaft.speed_ratio == 1 else bare
        without = base.model_copy(update={"shafts": (*base.shafts[:count], *alike)})
        chapters.append(cure(without, ratio=shaft.speed_ratio, planes=[weight.z for weight in shaft.weights]).chapter)
    return chapters
