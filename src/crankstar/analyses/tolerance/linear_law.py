"""The exact linear law of scatter: what small independent errors make of each order's amplitude.

With errors x_s of standard deviation sigma_s and bound t_s, the two turning vectors of an order are

    f = f_0 + sum x_s F_s,    b = b_0 + sum x_s B_s

with F_s, B_s their derivatives. The mean of a complex amplitude is the nominal one, and

    rms^2  = 2 sum sigma_s^2 (|F_s|^2 + |B_s|^2)

is the mean square of its deviation: of a real signal of the amplitude c, |c - c_0|^2; of a vector
in the clock plane, the upward and the rightward component together. Each error has its share in
that sum. No engine within the bounds has more than the worst case,

    max |f| + |b|  over x_s = +- t_s,

which is the greatest of |Re(e^(-i p) f + e^(-i q) b)| over the two directions p and q: at any pair
each error takes the sign that helps, and that engine's own directions are no worse.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from crankstar.analyses.tolerance.error_sources import ErrorSource
from crankstar.analyses.tolerance.question import BEARING
from crankstar.dynamics.bearing_variants import bearing_forces, bearing_names
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import Scale, default_reference
from crankstar.mechanics.excitation import Reference, Totals, part_spectra, rolling_moment
from crankstar.mechanics.mechanism import Mechanism, mechanism
from crankstar.spectra import Complex, Real, Spectrum
from crankstar.studies.variants import ANGLES, Arrays, arrays_of, with_arrays

STENCIL = ((1.0, 8 / 12), (-1.0, -8 / 12), (2.0, -1 / 12), (-2.0, 1 / 12))
"""Steps and weights of the central difference of fourth order."""
SMALL = 1e-3
"""The step, as a share of the crank radius or in radians: law and rounding miss by 1e-12 alike."""
PLACES = frozenset({"z", "unbalance_z"})
"""The arrays of places along the crankshaft."""
AT_ONCE = 48
"""Errors whose derivatives are worked out at once."""
NOTHING = 1e-13
"""Share of what the parts push below which the change by a step is rounding."""
DIRECTIONS = 16
"""Starting directions of each of the two vectors, over half a turn and a whole one."""


class Vectors(NamedTuple):
    """Turning vectors `forward`, `backward` [..., order] of one quantity."""

    forward: Complex
    backward: Complex


class Linear(NamedTuple):
    """A quantity to first order: nominal vectors [order] and derivatives [error, order]."""

    nominal: Vectors
    rates: Vectors


QUANTITIES = ("force", "couple", "roll", "torque")


def linear(
    engine: Engine,
    errors: Sequence[ErrorSource],
    *,
    orders: Sequence[float],
    reference: Reference,
    scale: Scale,
) -> dict[str, Linear]:
    """Force, couple, rolling moment and torque to first order in the errors, in units of `scale`.

    Derivatives are central differences of fourth order; what is linear they give exactly.
    """
    machine = mechanism(engine)
    how: dict[str, Any] = {"orders": orders, "reference": reference, "scale": scale}
    return derived(machine, errors, partial(summed_parts, **how), pushed=_pushed(machine, **how))


def derived(
    machine: Mechanism,
    errors: Sequence[ErrorSource],
    sums: Callable[[Mechanism], dict[str, Vectors]],
    *,
    pushed: Mapping[str, float],
    small: frozenset[str] = frozenset(),
) -> dict[str, Linear]:
    """The quantities that `sums` gives of an engine, or of a batch, to first order in the errors.

    Changes that are rounding beside what is `pushed` of a quantity are nought. `small`: arrays
    beside those of the motion in which a quantity is straight for small steps alone.
    """
    nominal = sums(machine)
    rows: dict[str, list[Vectors]] = {name: [] for name in nominal}
    for start in range(0, len(errors), AT_ONCE):
        own = errors[start : start + AT_ONCE]
        steps = np.array([_step(error, machine, small) for error in own])
        stepped = np.concatenate([np.diag(steps * step) for step, _weight in STENCIL])
        found = sums(moved(machine, own, stepped))
        for name, parts in found.items():
            shape = (len(stepped), parts.forward.shape[-1])
            whole = Vectors(*(np.broadcast_to(part, shape) for part in parts))
            rows[name].append(_differences(whole, steps, pushed[name]))
    return {
        name: Linear(
            own,
            Vectors(*map(np.concatenate, zip(*rows[name], strict=True)))
            if errors
            else Vectors(*(np.zeros((0, part.size), complex) for part in own)),
        )
        for name, own in nominal.items()
    }


def bearing_lines(
    engine: Engine, errors: Sequence[ErrorSource], *, orders: Sequence[float], scale: Scale
) -> dict[str, Linear]:
    """The load on each main bearing to first order in the errors, by its name.

    >>> from crankstar.files.catalog import load
    >>> [*bearing_lines(load("v2-90"), [], orders=[1.0], scale=Scale(1.0, 1.0, 1.0))]
    ['bearing 1', 'bearing 2']
    """
    machine = mechanism(engine)
    names = bearing_signals(engine)
    reference = default_reference(engine)
    force = _pushed(machine, orders=orders, reference=reference, scale=scale)["force"]

    def sums(batch: Mechanism) -> dict[str, Vectors]:
        found = bearing_forces(engine, batch, orders=orders)
        return {
            name: Vectors(*(scale.force * part[..., index, :] for part in found))
            for index, name in enumerate(names)
        }

    pushed = dict.fromkeys(names, force)
    return derived(machine, errors, sums, pushed=pushed, small=PLACES)  # spans end at bearings


def bearing_signals(engine: Engine) -> tuple[str, ...]:
    """The names of the loads on main bearings, the shaft in them where several have some."""
    bearings = bearing_names(engine)
    several = len({shaft for shaft, _number in bearings}) > 1
    return tuple(
        f"{BEARING} {shaft} {number}" if several else f"{BEARING} {number}"
        for shaft, number in bearings
    )


def _step(error: ErrorSource, machine: Mechanism, small: frozenset[str]) -> float:
    """The step of an error, so that no length or angle of the motion goes by more than SMALL.

    Nor do the arrays named in `small`; in others all is linear.
    """
    own = arrays_of(machine)
    radius = float(np.min(own["links.crank_radius"]))
    steps: list[float] = []
    for name, change in error.moves.items():
        greatest = float(np.abs(change).max(initial=0.0))
        if not greatest:
            continue
        if name in ANGLES:
            steps.append(SMALL / greatest)
        elif name.startswith("links.") or name in small:
            steps.append(SMALL * radius / greatest)
        else:
            size = float(np.abs(own[name]).max(initial=0.0)) or error.bound * greatest
            steps.append(size / greatest)
    return min(steps)


def sums_with(
    machine: Mechanism,
    errors: Sequence[ErrorSource],
    sizes: Real,
    *,
    orders: Sequence[float],
    reference: Reference,
    scale: Scale,
) -> dict[str, Vectors]:
    """The sums of engines with errors of these sizes [engine, error], each [engine, order]."""
    found = summed_parts(
        moved(machine, errors, sizes), orders=orders, reference=reference, scale=scale
    )
    shape = (len(sizes), len(orders))
    return {
        name: Vectors(*(np.broadcast_to(part, shape) for part in own))
        for name, own in found.items()
    }


def moved(machine: Mechanism, errors: Sequence[ErrorSource], sizes: Real) -> Mechanism:
    """Engines with errors of these sizes [engine, error]."""
    own = arrays_of(machine)
    out: Arrays = {}
    for name in dict.fromkeys(name for error in errors for name in error.moves):
        places = [index for index, error in enumerate(errors) if name in error.moves]
        changes = np.stack([errors[place].moves[name] for place in places])
        out[name] = own[name] + sizes[:, places] @ changes
    return with_arrays(machine, own | out, len(sizes))


def summed_parts(
    machine: Mechanism, *, orders: Sequence[float], reference: Reference, scale: Scale
) -> dict[str, Vectors]:
    """The sums over all parts of each quantity [..., order], rounding left in."""
    raw = part_spectra(machine, reference=reference, orders=orders)
    return quantities(Totals(*map(_summed, raw)), scale)


def quantities(sums: Totals, scale: Scale) -> dict[str, Vectors]:
    """Force, couple, rolling moment and torque of sums at 1 rad/s, in units of a scale."""
    each = {
        "force": (sums.force, scale.force),
        "couple": (sums.couple, scale.couple),
        "roll": (rolling_moment(sums), scale.moment),
        "torque": (sums.torque, scale.moment),
    }
    return {
        name: Vectors(own.forward * factor, own.backward * factor)
        for name, (own, factor) in each.items()
    }


def _summed(spectrum: Spectrum) -> Spectrum:
    return replace(
        spectrum, forward=spectrum.forward.sum(axis=-2), backward=spectrum.backward.sum(axis=-2)
    )


def _pushed(
    machine: Mechanism, *, orders: Sequence[float], reference: Reference, scale: Scale
) -> dict[str, float]:
    """What all parts push together, of the greatest order; at an arm of a crank radius or more."""
    raw = part_spectra(machine, reference=reference, orders=orders)

    def greatest(spectrum: Spectrum) -> float:
        sizes = np.abs(spectrum.forward) + np.abs(spectrum.backward)
        return float(sizes.sum(axis=-2).max(initial=0.0))

    radius = float(np.max(machine.links.crank_radius))
    force = greatest(raw.force)
    turning = max(greatest(raw.axis_moment) + greatest(raw.torque), force * radius)
    return {
        "force": force * scale.force,
        "couple": max(greatest(raw.couple), force * radius) * scale.couple,
        "roll": turning * scale.moment,
        "torque": turning * scale.moment,
    }


def _differences(found: Vectors, steps: Real, pushed: float) -> Vectors:
    """Derivatives [error, order] from the engines of the stencil."""
    count = steps.size

    def rate(values: Complex) -> Complex:
        sums = sum(
            weight * values[index * count : (index + 1) * count]
            for index, (_step, weight) in enumerate(STENCIL)
        )
        out = np.asarray(sums) / steps[:, None]
        noise = NOTHING * pushed / steps[:, None]
        real = np.where(np.abs(out.real) > noise, out.real, 0.0)
        imag = np.where(np.abs(out.imag) > noise, out.imag, 0.0)
        return real + 1j * imag

    return Vectors(rate(found.forward), rate(found.backward))


def mean_square(vectors: Vectors) -> Real:
    """Mean square of both components over a turn, doubled: |c|^2 of a real signal [..., order]."""
    return 2 * (np.abs(vectors.forward) ** 2 + np.abs(vectors.backward) ** 2)


def amplitudes(vectors: Vectors) -> Real:
    """The greatest value over a turn [..., order]."""
    return np.abs(vectors.forward) + np.abs(vectors.backward)


def variances(own: Linear, deviations: Real) -> Real:
    """What each error, of these standard deviations [error], has in the mean square.

    [error, order].

    >>> one = np.ones((6, 1), complex) / 2  # six pistons on a line
    >>> own = Linear(Vectors(one[0] * 0, one[0] * 0), Vectors(one, one))
    >>> round(float(np.sqrt(variances(own, np.full(6, 0.001)).sum())) / 0.001, 6)  # sqrt(6)
    2.44949
    """
    return np.asarray(deviations)[:, None] ** 2 * mean_square(own.rates)


def worst(own: Linear, bounds: Real) -> Real:
    """The greatest amplitude of any engine within the bounds [order], to first order.

    From each of many pairs of directions the signs that help most, then that engine's own
    directions, until nothing is gained: no engine near it is worse.

    >>> rates = np.array([[0.5 + 0j], [0.5j]])
    >>> own = Linear(Vectors(np.array([1 + 0j]), np.array([1 + 0j])), Vectors(rates, rates))
    >>> worst(own, np.array([2.0, 0.0]))  # 2 and an error of 2 on the same line
    array([4.])
    """
    return np.array([_worst(own, bounds, index) for index in range(own.nominal.forward.size)])


def _worst(own: Linear, bounds: Real, index: int) -> float:
    first = complex(own.nominal.forward[index]), complex(own.nominal.backward[index])
    rates = np.stack([own.rates.forward[:, index], own.rates.backward[:, index]]) * bounds
    turns = np.exp(1j * np.pi * np.arange(DIRECTIONS) / DIRECTIONS)
    if np.array_equal(rates[1], np.conj(rates[0])) and first[1] == first[0].conjugate():
        p, q = turns, np.conj(turns)  # a real signal
    else:
        p, q = (each.ravel() for each in np.meshgrid(turns, np.concatenate([turns, -turns])))
    best = np.full(p.size, -1.0)
    for _round in range(60):
        along = np.real(np.conj(p)[:, None] * rates[0] + np.conj(q)[:, None] * rates[1])
        straight = np.real(np.conj(p) * first[0] + np.conj(q) * first[1])
        signs = np.sign(along) * np.where(straight < 0, -1.0, 1.0)[:, None]
        f, b = first[0] + signs @ rates[0], first[1] + signs @ rates[1]
        sizes = np.abs(f) + np.abs(b)
        if np.all(sizes <= best * (1 + 1e-12)):
            break
        best = np.maximum(best, sizes)
        p = np.where(np.abs(f) > 0, np.exp(1j * np.angle(f)), p)
        q = np.where(np.abs(b) > 0, np.exp(1j * np.angle(b)), q)
    return float(best.max())


def parted(signal: str) -> tuple[str, str]:
    """The quantity of a signal, and its component if it is one; a shaft may have a dot in its name.

    >>> parted("couple.pitch"), parted("bearing no. 2 1")
    (('couple', 'pitch'), ('bearing no. 2 1', ''))
    """
    whole, _dot, part = signal.partition(".")
    return (whole, part) if whole in QUANTITIES else (signal, "")


def named(sums: Mapping[str, Vectors], name: str, *, sense: int) -> Vectors:
    """A quantity, or a component of one: force.up, force.right, couple.pitch, couple.yaw.

    Components are real signals.
    """
    whole, part = parted(name)
    own = sums[whole]
    if not part:
        return own
    with_theta, against = (own.forward, own.backward) if sense > 0 else (own.backward, own.forward)
    if part in ("up", "pitch"):
        signal = with_theta + np.conj(against)
    else:
        signal = -1j * (with_theta - np.conj(against))
    return Vectors(signal / 2, np.conj(signal) / 2)
