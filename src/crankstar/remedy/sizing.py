"""A remedy sized for other masses: its weights and shafts where they are, as heavy as needed there.

What a remedy consists of is decided once, for the engine as given. Over the ranges of estimated
masses it stays the same, and each of its weights is sized for the masses at hand: where there is
nothing to cancel it is nought, and what only other masses would call for is not added.
"""

from __future__ import annotations

from cmath import phase
from collections.abc import Sequence
from typing import NamedTuple

from crankstar.engine.copies import with_shaft, with_values, with_weights
from crankstar.engine.engine import Engine
from crankstar.engine.main_bearings import end_planes
from crankstar.engine.records import Shaft, Weight
from crankstar.mechanics.balance import default_reference
from crankstar.remedy.kept import changes
from crankstar.remedy.shafts import unbalances


class Remedied(NamedTuple):
    """An engine before and after it was given weights and shafts."""

    before: Engine
    after: Engine

    @property
    def new_shafts(self) -> tuple[Shaft, ...]:
        """The shafts that were added."""
        return self.after.shafts[len(self.before.shafts) :]


def resized(like: Remedied, engine: Engine, fitted: Engine | None) -> Engine:
    """The engine with the remedy of another one: `like` it, but sized for the engine itself.

    `fitted` is the engine as it would be fitted by itself, None where it would not be.
    """
    if engine is like.before:
        return like.after
    return with_shafts_like(like, with_weights_like(like, engine, fitted or engine))


def with_weights_like(like: Remedied, engine: Engine, weighted: Engine) -> Engine:
    """The engine with those counterweights of its `weighted` copy that stand as in `like`.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.remedy import with_counterweights
    >>> twin = load("i2-360")
    >>> light, heavy = (with_counterweights(twin, factor=factor) for factor in (0.5, 0.6))
    >>> with_weights_like(Remedied(light, light), light, heavy) == light  # none were added there
    True
    """
    became, own = changes(like.before, like.after), changes(engine, weighted)
    weights: dict[str, Sequence[Weight]] = {}
    for shaft in engine.shafts:
        model = became[shaft.name]
        if not shaft.throws:
            continue
        if model.replaced:
            weights[shaft.name] = _like(
                like.after.shaft(shaft.name).weights, weighted.shaft(shaft.name).weights
            )
        else:
            added = _like(model.added, own[shaft.name].added)
            weights[shaft.name] = (*shaft.weights, *added)
    return with_weights(engine, weights)


def _like(model: Sequence[Weight], own: Sequence[Weight]) -> Sequence[Weight]:
    """For each weight of the model the one that stands as it does; nought where there is none."""
    if len(own) == len(model):
        return own
    out: list[Weight] = []
    rest = [*own]
    for weight in model:
        near = [other for other in rest if other.throw == weight.throw]
        if not near:
            out.append(with_values(weight, unbalance=0.0))
            continue
        nearest = min(near, key=lambda other: abs(other.z - weight.z))
        rest.remove(nearest)
        out.append(nearest)
    return out


def with_shafts_like(like: Remedied, engine: Engine) -> Engine:
    """The engine with the balance shafts that were added in `like`, sized for its own masses.

    One in whose plane a force acts leaves a couple that the other engine had not.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.remedy import with_balance_shaft
    >>> four = load("i4")
    >>> one = Remedied(four, with_balance_shaft(four, ratio=2, planes=[0.0]))
    >>> same, none = with_shafts_like(one, four), with_shafts_like(one, load("i6"))
    >>> same == one.after, [weight.unbalance for weight in none.shafts[-1].weights]
    (True, [0.0])
    """
    new = like.new_shafts
    for index, shaft in enumerate(new):
        left = sum(other.speed_ratio == shaft.speed_ratio for other in new[index:])
        planes = _planes(like.before, engine, shaft)
        vectors = unbalances(engine, shaft.speed_ratio, planes, couple=False)
        weights = [
            Weight(
                unbalance=abs(vector) / left, angle=phase(vector) if vector else weight.angle, z=z
            )
            for vector, weight, z in zip(
                vectors or [0j] * len(planes), shaft.weights, planes, strict=True
            )
        ]
        engine = with_shaft(engine, with_values(shaft, weights=tuple(weights)))
    return engine


def _planes(before: Engine, engine: Engine, shaft: Shaft) -> tuple[float, ...]:
    """The planes of the weights of a new shaft, in an engine of another bore pitch."""
    planes = tuple(weight.z for weight in shaft.weights)
    for usual in (end_planes, lambda of: (default_reference(of).z,)):
        if planes == usual(before):
            return usual(engine)
    return planes
