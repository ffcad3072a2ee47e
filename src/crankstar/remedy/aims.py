"""Aims for weights: their value for any weights, and the cones of a convex problem.

With unbalances u_j (m r, complex: up + i right at theta = 0) in planes z_j on shafts of speed ratio
n_j an engine does

    force  F(theta) = F0(theta) + sum n_j^2 u_j exp(i s n_j theta),      couple M(theta) the same
    times z_j - z0,

F0 and M0 without them. Every aim is the greatest of some norms of such sums, each linear in the
u_j, and so convex in them: the length at every crank angle (peak), or the root of its mean square
over the period (rms); of the force, of the couple, or of one of its components (pitch is the
couple's up, yaw its right); or the load on the main bearings.

The load is the first-order inertia force that a crankshaft hands to one of its main bearings, of
what turns and of what goes to and fro, shared as `dynamics.bearings` does. The side thrust
of the pistons is left out, which changes it by the square of crank radius over rod length, some per
cent.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.dynamics.bearings import Model, bearing_shares
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import default_reference, unit_unbalance
from crankstar.mechanics.excitation import Reference, part_spectra
from crankstar.mechanics.mechanism import mechanism
from crankstar.remedy.programme import Cone
from crankstar.spectra import Complex, Real, Spectrum

Quantity = Literal["force", "couple", "bearing"]
FINE = 720
"""Crank angles per turn in the search for local maxima."""
SIGNIFICANT = 1e-13
"""Share of the greatest vector below which an order is left out of the problem."""


class Aim(NamedTuple):
    """A quantity to minimise; `up` and `right` weigh the components of force and couple.

    `Aim("couple", up=1, right=0)` is pitch, `Aim("couple", up=0, right=1)` yaw.
    """

    quantity: Quantity
    rms: bool = False
    up: float = 1.0
    right: float = 1.0


class Plane(NamedTuple):
    """Where a weight may stand: on which shaft, and where along it."""

    shaft: str
    z: float


@dataclass(frozen=True)
class Setting:
    """An engine with bare planes, in units of m r w^2 and m r w^2 a, and the effect of weights.

    Per plane [plane]: `order` of its shaft, whether that turns `forward` (with the reference
    crankshaft), its speed ratio `squared`, and its `arm` z - z0 in a. `loads`: per main bearing the
    share of each plane [plane] and the first-order vectors (forward, backward) without weights.
    """

    force: Spectrum
    couple: Spectrum
    order: Real
    forward: tuple[bool, ...]
    squared: Real
    arm: Real
    loads: tuple[tuple[Real, complex, complex], ...]


def setting(
    engine: Engine,
    planes: Sequence[Plane],
    *,
    reference: Reference | None = None,
    model: Model = "determinate",
) -> Setting:
    """The problem of choosing weights in these planes, of an engine without any there.

    `model`: how the main bearings share what acts on a crankshaft.
    """
    reference = reference or default_reference(engine)
    unit = unit_unbalance(engine)
    parts = part_spectra(mechanism(engine), reference=reference)
    ratio = np.array([float(engine.shaft(plane.shaft).speed_ratio) for plane in planes])
    force = _with_orders(spectra.scaled(spectra.total(parts.force), 1 / unit), np.abs(ratio))
    couple = _with_orders(
        spectra.scaled(spectra.total(parts.couple), 1 / (unit * engine.pitch)), np.abs(ratio)
    )
    return Setting(
        force=force,
        couple=couple,
        order=np.abs(ratio),
        forward=tuple(bool(each > 0) for each in ratio),
        squared=ratio**2,
        arm=np.array([(plane.z - reference.z) / engine.pitch for plane in planes]),
        loads=tuple(_loads(engine, planes, spectra.scaled(parts.force, 1 / unit), model)),
    )


def _with_orders(spectrum: Spectrum, kept: Real) -> Spectrum:
    """The spectrum without the orders that are zero, but with those of the planes."""
    size = np.abs(spectrum.forward) + np.abs(spectrum.backward)
    orders = spectrum.orders[(size > SIGNIFICANT * size.max(initial=0.0))]
    return spectra.selected(spectrum, spectra.distinct(np.round(np.append(orders, kept), 12)))


def _loads(
    engine: Engine, planes: Sequence[Plane], force: Spectrum, model: Model
) -> list[tuple[Real, complex, complex]]:
    """For each main bearing its share of a weight in each plane, and its bare vectors."""
    bearing_loads: list[tuple[Real, complex, complex]] = []
    machine = mechanism(engine)
    repeats = (len(force.forward) - len(machine.rotor_shaft)) // len(machine.z)
    z = [*machine.z] * repeats + [*machine.unbalance_z]
    on = np.array([*machine.cylinder_shaft] * repeats + [*machine.rotor_shaft])
    for index, shaft in enumerate(engine.shafts):
        own = spectra.selected(force, [abs(float(shaft.speed_ratio))])
        if not shaft.throws:
            continue
        shares = bearing_shares(engine, shaft, z, model=model) * (on == index)
        own_planes = np.array([plane.shaft == shaft.name for plane in planes])
        plane_shares = bearing_shares(engine, shaft, [p.z for p in planes], model=model)
        for share, plane in zip(shares, plane_shares * own_planes, strict=True):
            ahead, behind = complex(share @ own.forward[:, 0]), complex(share @ own.backward[:, 0])
            if shaft.speed_ratio < 0:
                ahead, behind = behind, ahead
            bearing_loads.append((plane, ahead, behind))
    return bearing_loads


def with_unbalance(case: Setting, x: Real, quantity: Literal["force", "couple"]) -> Spectrum:
    """Force or couple of the engine with these weights, x [2 * planes]."""
    bare: Spectrum = getattr(case, quantity)
    forward, backward = bare.forward.copy(), bare.backward.copy()
    added = (x[0::2] + 1j * x[1::2]) * case.squared * (1.0 if quantity == "force" else case.arm)
    for vector, order, ahead in zip(added, case.order, case.forward, strict=True):
        column = int(np.argmin(np.abs(bare.orders - order)))
        (forward if ahead else backward)[column] += vector
    return replace(bare, forward=forward, backward=backward)


def measured(case: Setting, aim: Aim, x: Real) -> float:
    """The value of an aim for these weights, m r w^2, or m r w^2 a for couples."""
    if aim.quantity == "bearing":
        u = x[0::2] + 1j * x[1::2]
        return max(
            (
                float(abs(ahead + (share * case.squared) @ u)) + abs(behind)
                for share, ahead, behind in case.loads
            ),
            default=0.0,
        )
    vector = _weighted(with_unbalance(case, x, aim.quantity), aim)
    if aim.rms:
        return float(np.sqrt((np.abs(vector.forward) ** 2 + np.abs(vector.backward) ** 2).sum()))
    return spectra.peak(vector).value


def maxima(case: Setting, aim: Aim, x: Real, *, above: float) -> Real:
    """The crank angles (radians) of the local maxima of an aim above a level with these weights."""
    if aim.rms or aim.quantity == "bearing":
        return np.zeros(0)
    vector = _weighted(with_unbalance(case, x, aim.quantity), aim)
    turns = spectra.period(vector)
    theta = np.arange(FINE * turns) * (2 * np.pi / FINE)
    length = np.abs(spectra.value(vector, theta))
    local = (length >= np.roll(length, 1)) & (length >= np.roll(length, -1)) & (length > above)
    highest = spectra.peak(vector)
    return np.append(theta[local], highest.theta) if highest.value > above else theta[local]


def _weighted(spectrum: Spectrum, aim: Aim) -> Spectrum:
    """Every vector v made up * Re v + i right * Im v."""
    same, other = (aim.up + aim.right) / 2, (aim.up - aim.right) / 2
    return replace(
        spectrum,
        forward=same * spectrum.forward + other * np.conj(spectrum.backward),
        backward=same * spectrum.backward + other * np.conj(spectrum.forward),
    )


def cones(case: Setting, aim: Aim, theta: Real) -> list[Cone]:
    """The norms whose greatest is the aim: one per crank angle `theta`, bearing, or rms."""
    count = case.order.size
    if aim.quantity == "bearing":
        return [
            Cone(_pairs(share * case.squared), np.array([ahead.real, ahead.imag]), abs(behind))
            for share, ahead, behind in case.loads
        ]
    bare = _weighted(getattr(case, aim.quantity), aim)
    factor = case.squared * (1.0 if aim.quantity == "force" else case.arm)
    if aim.rms:
        return [_mean(case, aim, bare, factor)]
    turn = np.where(case.forward, 1, -1) * bare.sense * case.order
    values = spectra.value(bare, theta)
    out: list[Cone] = []
    for angle, value in zip(theta, np.atleast_1d(values), strict=True):
        phase: Complex = factor * np.exp(1j * turn * angle)
        matrix = np.zeros((2, 2 * count))
        matrix[0, 0::2], matrix[0, 1::2] = aim.up * np.real(phase), -aim.up * np.imag(phase)
        matrix[1, 0::2], matrix[1, 1::2] = aim.right * np.imag(phase), aim.right * np.real(phase)
        out.append(Cone(matrix, np.array([value.real, value.imag])))
    return out


def _pairs(factor: Real) -> Real:
    """The matrix that adds up vectors, each times a real factor."""
    matrix = np.zeros((2, 2 * factor.size))
    matrix[0, 0::2] = matrix[1, 1::2] = factor
    return matrix


def _mean(case: Setting, aim: Aim, bare: Spectrum, factor: Real) -> Cone:
    """The norm over all orders, forward and backward, each a real and an imaginary row."""
    size = bare.orders.size
    columns: list[Any] = []
    for place, ahead in enumerate(case.forward):
        column = int(np.argmin(np.abs(bare.orders - case.order[place])))
        for unit in (factor[place], 1j * factor[place]):
            empty = np.zeros(size, complex)
            column_only = empty.copy()
            column_only[column] = unit
            pushed = replace(
                bare,
                forward=column_only if ahead else empty,
                backward=empty if ahead else column_only,
            )
            columns.append(_rows(_weighted(pushed, aim)))
    return Cone(np.array(columns).T, _rows(bare))


def _rows(spectrum: Spectrum) -> Complex:
    both = np.concatenate([spectrum.forward, spectrum.backward])
    return np.concatenate([np.real(both), np.imag(both)])
