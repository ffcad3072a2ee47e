"""The weights that crankshafts have already: kept, added to, taken away again.

New weights take over what those of the file leave. With U and V the sum of the unbalances u and of
the moments z u that the pins need, and U0 and V0 those of the weights that are there, the new
weights have the sum U - U0 and the moment V - V0. A weight of the file relieves the new weights of
its own throw; one beyond the main bearings (vibration damper, flywheel) relieves those of all
throws.
"""

from __future__ import annotations

from cmath import exp
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from crankstar.engine.copies import throws_of_weights, with_values, with_weights
from crankstar.engine.engine import Engine
from crankstar.engine.main_bearings import main_bearings, webs
from crankstar.engine.records import Provenance, Shaft, Weight
from crankstar.files.rewritten import WEIGHTS

SIZED = "sized for estimated masses"
"""The source of weights that rest on estimates."""


class Changes(NamedTuple):
    """Weights of one shaft: of the file and still there, new, of the file and no longer there."""

    kept: tuple[Weight, ...]
    added: tuple[Weight, ...]
    replaced: tuple[Weight, ...]


class Group(NamedTuple):
    """Places of new weights (z) that the weights of some throws relieve; all throws: None."""

    places: tuple[float, ...]
    throws: tuple[int, ...] | None


def with_source(before: Engine, after: Engine) -> Engine:
    """`after` with a source for its weights that says they rest on estimates, where they do.

    They do where `before` has estimated values and `after` has other weights.
    """
    estimated = any(origin.status == "estimated" for origin in before.provenance.values())
    if not estimated or after.shafts == before.shafts:
        return after
    source = Provenance(status="estimated", source=SIZED)
    return with_values(after, provenance={**after.provenance, WEIGHTS: source})


def changes(before: Engine, after: Engine) -> dict[str, Changes]:
    """What became of the weights of every shaft of `after`, by its name.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.remedy import with_counterweights
    >>> twin = load("parallel-twin-180")  # its file gives two counterweights
    >>> crank = changes(twin, with_counterweights(twin, factor=0.7))["crank"]
    >>> len(crank.kept), len(crank.added), len(crank.replaced)
    (2, 2, 0)
    """
    own = {shaft.name: shaft.weights for shaft in before.shafts}
    out: dict[str, Changes] = {}
    for shaft in after.shafts:
        old = list(own.get(shaft.name, ()))
        kept: list[Weight] = []
        added: list[Weight] = []
        for weight in shaft.weights:
            if weight in old:
                old.remove(weight)
                kept.append(weight)
            else:
                added.append(weight)
        out[shaft.name] = Changes(tuple(kept), tuple(added), tuple(old))
    return out


def without_added(before: Engine, after: Engine) -> Engine:
    """`after` without its new weights, those of `before` again where they were replaced.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.remedy import with_counterweights
    >>> twin = load("parallel-twin-180")
    >>> without_added(twin, with_counterweights(twin, factor=0.7)) == twin
    True
    """
    own = {shaft.name: shaft.weights for shaft in before.shafts}
    return with_weights(after, {shaft.name: own.get(shaft.name, ()) for shaft in after.shafts})


def vectors(weights: Sequence[Weight]) -> list[complex]:
    """Their unbalances, up + i right at theta = 0."""
    return [weight.unbalance * exp(1j * weight.angle) for weight in weights]


def relief(engine: Engine, shaft: Shaft, groups: Sequence[Group]) -> list[complex]:
    """What the weights of a shaft take over from new ones at the places of all groups, in order.

    The sum of the relief is the sum of the weights and, where the places differ, its moment theirs.
    A weight between the main bearings relieves the places of its own throw by the law of the lever;
    what is then missing in sum and moment is spread over all places as the least unbalances.
    """
    places = [place for group in groups for place in group.places]
    taken = [0j] * len(places)
    own = vectors(shaft.weights)
    numbers = throws_of_weights(shaft)
    for vector, weight, number in zip(own, shaft.weights, numbers, strict=True):
        at = _group(engine, shaft, groups, weight, number)
        if at is None:
            continue
        first = sum(len(group.places) for group in groups[:at])
        for step, share in enumerate(_lever(groups[at].places, weight.z)):
            taken[first + step] += share * vector
    force = sum(own) - sum(taken)
    moment = sum(u * weight.z for u, weight in zip(own, shaft.weights, strict=True)) - sum(
        u * place for u, place in zip(taken, places, strict=True)
    )
    rest = least_weights(force=force, moment=moment, planes=places)
    return [part + more for part, more in zip(taken, rest, strict=True)]


def _group(
    engine: Engine, shaft: Shaft, groups: Sequence[Group], weight: Weight, throw: int | None
) -> int | None:
    """The group that a weight relieves by itself; None beyond the main bearings and the webs."""
    inside = (*main_bearings(engine, shaft), *webs(engine, shaft))
    within = max(inside) >= weight.z >= min(inside)
    return next(
        (
            index
            for index, group in enumerate(groups)
            if within and group.throws is not None and throw in group.throws
        ),
        None,
    )


def _lever(places: Sequence[float], z: float) -> tuple[float, ...]:
    """The shares of a weight at z on one place or on two, front first; beyond them, all on one."""
    if len(places) == 1:
        return (1.0,)
    front, rear = places
    share = float(np.clip((z - rear) / (front - rear), 0.0, 1.0))
    return share, 1.0 - share


def least_weights(*, force: complex, moment: complex, planes: Sequence[float]) -> list[complex]:
    """Unbalances u_j in planes z_j with sum u_j = force, sum z_j u_j = moment, least sum |u_j|^2.

    They are the pseudo-inverse of the two conditions; z and the moment count from one point. Where
    all planes are one, the force alone is met.
    """
    places = np.array(planes, float)
    middle = float(np.mean(places))  # with moments about it, both conditions count alike
    reach = float(np.max(np.abs(places - middle)))
    if not reach:
        return [force / places.size] * places.size
    conditions = np.array([np.ones(places.size), (places - middle) / reach])
    wanted = np.array([force, (moment - middle * force) / reach])
    return [complex(unbalance) for unbalance in np.linalg.pinv(conditions) @ wanted]
