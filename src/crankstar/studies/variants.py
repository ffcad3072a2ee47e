"""Many variants of one engine at once: each value's engine, and the arrays of all.

To build an engine takes far longer than to work out its sums. But bearings, places, masses and
lengths mostly depend on the number x that is varied as

    array(x) = array(x0) + slope (x - x0),

angles but for whole turns, and throws and weights as vectors (unbalance at an angle). So a few
engines are built, where nobody would look for a round number, and if all agree with such a law to
rounding, the law gives the others. The two ends, their neighbours and nought are built as well:
there an engine that cannot be is refused in its own words, and there a weight may vanish or two
pins become one. What such an engine has of its own it keeps. In all other cases every engine is
built.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from crankstar.engine.engine import Engine
from crankstar.language.messages import MessageError
from crankstar.mechanics.mechanism import Mechanism, mechanism
from crankstar.spectra import Real

Make = Callable[[float], Engine]
Make2 = Callable[[float, float], Engine]
Tell = Callable[[int, int], None]
Arrays = dict[str, np.ndarray]

FEW = 14
"""So many different numbers, or fewer, are built one by one."""
GREATEST_BUILT = 10_000
"""Engines built one by one: some twenty seconds."""
PROBES = (
    0.381966,
    0.383071,
    0.395513,
    0.476829,
    0.000723,
    0.130417,
    0.250903,
    0.618719,
    0.771377,
    0.999311,
)
"""Probes as shares of the range: two close together reveal angles that go round often.

No two distances are multiples of a third.
"""
AGREEMENT = 1e-12
"""Arrays are equal where they differ by no more than this share of the greatest value.

For angles, this many radians.
"""
STILL = 1e-14
"""What changes by no more than this share over the whole range does not change."""
ANGLES = frozenset(
    {"throw_angle", "bearing", "unbalance_angle", "links.bearing", "links.knuckle_angle"}
)


class SweepError(MessageError):
    """A sweep that cannot be, as a sentence that says what would be right."""


class OverError(SweepError):
    """Numbers that cannot be varied, or not at these values; the sentence names no option."""


class Batch(NamedTuple):
    """Engines of one structure: indices of their values [row], and arrays, [row, ...] if varied."""

    rows: np.ndarray
    machine: Mechanism


def variants(
    make: Make, values: Sequence[float] | Real, *, tell: Tell | None = None
) -> tuple[Batch, ...]:
    """The engines `make(x)` of all `values` [n] as arrays.

    One Batch for each structure among them; mostly that is one.

    Engines have one structure where shafts, gear ratios, cylinders and rods on rods, throws and
    weights are the same in number and order, and turn the same way. Arrays with a leading axis
    belong to `rows`; the others are the same for all of them. Where the engines have to be built
    one by one, `tell(done, of)` is called after each. Whatever `make` raises at one of the values
    is raised; SweepError where there are too many to be built.

    >>> from crankstar import load
    >>> def made(mass: float) -> Engine:
    ...     return load("v8-cross-plane", changes={"cylinder.rotating_mass": mass})
    >>> batch, = variants(made, np.linspace(0, 1, 100))

    The unbalance of four throws in 100 engines, and eight angles common to all:

    >>> batch.machine.unbalance.shape, batch.machine.throw_angle.shape
    ((100, 4), (8,))
    """
    numbers = np.asarray(values, float)
    different = np.unique(numbers)
    built: dict[float, Mechanism] = {}
    for number in dict.fromkeys((different[0], different[-1])):
        built[float(number)] = mechanism(make(float(number)))
    if different.size > FEW:
        batches = _lawful(make, numbers, different, built)
        if batches:
            return batches
    check_built(different.size)
    for done, number in enumerate(different.tolist(), 1):
        if number not in built:
            built[number] = mechanism(make(number))
        if tell is not None:
            tell(done, different.size)
    return grouped([built[number] for number in numbers.tolist()])


def check_built(count: int) -> None:
    """Refuse to build so many engines one by one."""
    if count > GREATEST_BUILT:
        raise SweepError(
            "here each of the {count} engines must be built by itself, which is possible for at "
            "most {most}; give fewer values",
            count=count,
            most=GREATEST_BUILT,
        )


def picked(machine: Mechanism, rows: np.ndarray) -> Mechanism:
    """Some engines of a batch."""
    return with_arrays(
        machine,
        {name: a[rows] if a.ndim > 1 else a for name, a in arrays_of(machine).items()},
        len(rows),
    )


def grouped(machines: Sequence[Mechanism]) -> tuple[Batch, ...]:
    """Engines one by one, put together with those of the same structure."""
    groups: dict[Any, list[int]] = {}
    for row, machine in enumerate(machines):
        groups.setdefault(structure_of(machine), []).append(row)
    return tuple(
        Batch(np.array(rows), _stacked([machines[row] for row in rows])) for rows in groups.values()
    )


def structure_of(machine: Mechanism) -> tuple[Any, ...]:
    """What two engines must share to be rows of the same arrays."""
    return (
        machine.links.master,
        machine.cylinder_shaft,
        machine.rotor_shaft,
        machine.ratios,
        machine.sense,
    )


def _stacked(machines: Sequence[Mechanism]) -> Mechanism:
    listed = [arrays_of(machine) for machine in machines]
    out: Arrays = {}
    for name, first in listed[0].items():
        every = np.stack([arrays[name] for arrays in listed])
        out[name] = every if np.any(every != first) else first
    return with_arrays(machines[0], out, len(machines))


def arrays_of(machine: Mechanism) -> Arrays:
    """The arrays of a machine by name, those of its rods as `links.NAME`."""
    own = {name: values for name, values in vars(machine).items() if isinstance(values, np.ndarray)}
    return own | {
        f"links.{name}": values
        for name, values in vars(machine.links).items()
        if isinstance(values, np.ndarray)
    }


def with_arrays(machine: Mechanism, arrays: Arrays, count: int) -> Mechanism:
    """The machine with these arrays; at least one gets the leading axis."""
    if all(values.ndim == 1 for values in arrays.values()):
        arrays = arrays | {
            "unbalance": np.broadcast_to(arrays["unbalance"], (count, arrays["unbalance"].size))
        }
    links = {
        name.removeprefix("links."): values
        for name, values in arrays.items()
        if name.startswith("links.")
    }
    own: dict[str, Any] = {
        name: values for name, values in arrays.items() if not name.startswith("links.")
    }
    return replace(machine, links=replace(machine.links, **links), **own)


@dataclass(frozen=True)
class Law:
    """Arrays linear in the number: at `origin`, and slopes; `vectors`: rotors taken as vectors."""

    machine: Mechanism
    origin: float
    start: Arrays
    slope: Arrays
    vectors: np.ndarray

    def at(self, numbers: Real) -> Mechanism:
        """The engines of these numbers [n]."""
        steps = (np.asarray(numbers, float) - self.origin)[:, None]
        rates = self.slope.items()
        out = {
            name: self.start[name] + steps * rate if np.any(rate) else self.start[name]
            for name, rate in rates
        }
        vector = out.pop("vector")
        if np.any(self.vectors) and vector.ndim > 1:
            out["unbalance"] = np.where(self.vectors, np.abs(vector), out["unbalance"])
            # The angle of a weight that only grows stays what it was, and needs no axis.
            ahead = np.abs(vector) * np.exp(1j * self.start["unbalance_angle"])
            if np.any(np.abs(vector - ahead) > STILL * np.abs(vector).max()):
                out["unbalance_angle"] = np.where(
                    self.vectors, np.angle(vector), out["unbalance_angle"]
                )
        return with_arrays(self.machine, out, steps.size)


def _lawful(
    make: Make, numbers: Real, different: Real, built: dict[float, Mechanism]
) -> tuple[Batch, ...]:
    """The engines of all numbers by a law, or nothing where there is none."""
    low, high = float(different[0]), float(different[-1])
    for number in {float(different[1]), float(different[-2]), *different[different == 0].tolist()}:
        built[number] = built[number] if number in built else mechanism(make(number))
    try:
        probes = {x: mechanism(make(x)) for x in (low + share * (high - low) for share in PROBES)}
    except ValueError:  # not every number between two good ones is one: a ratio of teeth
        return ()
    law = law_of(probes)
    beside = {x: built[x] for x in (float(different[1]), float(different[-2]))}
    if law is None or not all(agrees(law, x, machine) for x, machine in (probes | beside).items()):
        return ()
    if any(master >= 0 for master in law.machine.links.master) and any(
        np.any(rate) for name, rate in law.slope.items() if name.startswith("links.")
    ):
        return ()  # whether a slave rod reaches its cylinder is seen only engine by engine
    apart = [x for x, machine in built.items() if not agrees(law, x, machine)]
    ruled = np.nonzero(~np.isin(numbers, apart))[0]
    own = np.nonzero(np.isin(numbers, apart))[0]
    batches = [Batch(ruled, law.at(numbers[ruled]))] if ruled.size else []
    others = grouped([built[x] for x in numbers[own].tolist()]) if own.size else ()
    return (*batches, *(Batch(own[batch.rows], batch.machine) for batch in others))


def law_of(probes: dict[float, Mechanism]) -> Law | None:
    """The straight law through the probes, if they have one structure.

    Whether they follow it is another question.
    """
    if len({structure_of(machine) for machine in probes.values()}) > 1:
        return None
    origin = next(iter(probes))
    ordered = sorted(probes, key=lambda x: abs(x - origin))
    steps = np.array(ordered) - origin
    listed = [arrays_of(probes[x]) for x in ordered]
    for arrays in listed:
        arrays["vector"] = arrays["unbalance"] * np.exp(1j * arrays["unbalance_angle"])
    start, slope = listed[0], {}
    for name, first in start.items():
        every = np.stack([arrays[name] for arrays in listed])
        if name in ANGLES:
            every = _unwound(every, steps)
        rate = (every[-1] - first) / steps[-1]
        span = np.abs(every - first).max(axis=0)
        slope[name] = np.where(
            span > STILL * (1.0 if name in ANGLES else np.abs(every).max()), rate, 0.0
        )
    vectors = slope["unbalance"] != 0
    slope["unbalance"] = np.zeros_like(start["unbalance"])
    slope["unbalance_angle"] = np.where(vectors, 0.0, slope["unbalance_angle"])
    slope["vector"] = np.where(vectors, slope["vector"], 0.0)
    return Law(probes[origin], origin, start, slope, vectors)


def _unwound(angles: np.ndarray, steps: np.ndarray) -> np.ndarray:
    """Angles [probe, ...] without jumps of whole turns, from the two nearest probes outward.

    Each is predicted from the ones before.
    """
    out = angles.copy()
    rate = np.zeros_like(angles[0])
    for row in range(1, len(steps)):
        foretold = out[0] + rate * steps[row]
        out[row] += 2 * np.pi * np.round((foretold - out[row]) / (2 * np.pi))
        rate = (out[row] - out[0]) / steps[row]
    return out


def agrees(law: Law, number: float, machine: Mechanism) -> bool:
    """Whether an engine that was built is what the law says."""
    return alike(law.at(np.array([number])), machine, beside=law.start)


def alike(ruled: Mechanism, built: Mechanism, *, beside: Arrays) -> bool:
    """Whether a batch of one engine is the engine that was built, but for rounding.

    `beside` are arrays whose greatest values count as well for what is rounding.
    """
    if structure_of(built) != structure_of(ruled):
        return False
    own, there = arrays_of(ruled), arrays_of(built)
    for name in ("unbalance", "unbalance_angle"):
        own[name], there[name] = own[name].reshape(-1), there[name].reshape(-1)
    own["unbalance"] = own["unbalance"] * np.exp(1j * own.pop("unbalance_angle"))
    there["unbalance"] = there["unbalance"] * np.exp(1j * there.pop("unbalance_angle"))
    for name, values in there.items():
        mine = own[name].reshape(values.shape)
        apart = np.exp(1j * mine) - np.exp(1j * values) if name in ANGLES else mine - values
        scale = (
            1.0
            if name in ANGLES
            else max(float(np.abs(values).max()), float(np.abs(beside[name]).max()))
        )
        if np.abs(apart).max() > AGREEMENT * scale:
            return False
    return True
