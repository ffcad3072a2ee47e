"""Aims for weights: their value for any weights, and the cones of a convex problem.

With unbalances u_j (m r, complex: up + i right at theta = 0) in planes z_j on shafts of speed ratio
n_j at the places P_j (up + i right of the reference point) an engine does

    force  F(theta) = F0(theta) + sum n_j^2 u_j exp(i s n_j theta),      couple M(theta) the same
    times z_j - z0,
    roll   R(theta) = R0(theta) + sum Im(conj(P_j) n_j^2 u_j exp(i s n_j theta)),

F0, M0 and R0 without them; R is clockwise. A weight on a shaft through the reference point does not
change the roll. Every aim is the greatest of some norms of such sums, each linear in the
u_j, and so convex in them: the length at every crank angle (peak), or the root of its mean square
over the period (rms); of the force, of the couple, or of one of its components (pitch is the
couple's up, yaw its right); of the roll; of one order of any of these; or the load on the main
bearings. A component of one order is a wave, and its amplitude the length of one complex number
that is linear in the u_j.

The load is the first-order force that a crankshaft hands to one of its main bearings: what its
rods push on their pins, the side thrust of the pistons with it, and what turns, shared as
`dynamics.bearings` does.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, NamedTuple, get_args

import numpy as np

from crankstar import spectra
from crankstar.dynamics.bearings import Model, bearing_shares, shaft_forces
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import default_reference, scales, unit_unbalance
from crankstar.mechanics.bounds import bounded
from crankstar.mechanics.excitation import Reference, part_spectra, rolling_moment, total
from crankstar.mechanics.mechanism import mechanism
from crankstar.mechanics.pin_loads import pin_loads
from crankstar.remedy.programme import Cone
from crankstar.remedy.rolling import roll_of
from crankstar.spectra import Complex, Real, Spectrum

Quantity = Literal["force", "couple", "roll", "bearing"]
FINE = 720
"""Crank angles per turn in the search for local maxima."""
SIGNIFICANT = 1e-13
"""Share of the greatest vector below which an order is left out of the problem."""


class Aim(NamedTuple):
    """A quantity to minimise; `up` and `right` weigh the components of force and couple.

    `Aim("couple", up=1, right=0)` is pitch, `Aim("couple", up=0, right=1)` yaw, with `order=1` the
    external moments M1V and M1H of makers of large engines. `order`: the peak of one order alone,
    None for all together.
    """

    quantity: Quantity
    rms: bool = False
    up: float = 1.0
    right: float = 1.0
    order: float | None = None

    @property
    def peaky(self) -> bool:
        """Whether it is a peak over the crank angle; the amplitude of a wave is not."""
        wave = self.order is not None and not (self.quantity != "roll" and self.up and self.right)
        return not (self.rms or self.quantity == "bearing" or wave)

    @property
    def possible(self) -> bool:
        """Whether there is such a quantity."""
        shares = np.array([self.up, self.right])
        one_order = self.order is None or (
            0 < self.order < np.inf and not self.rms and self.quantity != "bearing"
        )
        sized = np.isfinite(shares).all() and shares.min() >= 0 and shares.max() > 0
        return self.quantity in get_args(Quantity) and one_order and bool(sized)


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
    `roll` is a signal in m r^2 w^2, `rolled` [plane, 2] the amplitudes that a unit unbalance up and
    one to the right add to it at the order of the plane.
    """

    force: Spectrum
    couple: Spectrum
    order: Real
    forward: tuple[bool, ...]
    squared: Real
    arm: Real
    loads: tuple[tuple[Real, complex, complex], ...]
    roll: Spectrum
    rolled: Complex


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
        loads=tuple(_loads(engine, planes, model)),
        roll=_with_orders(
            spectra.scaled(rolling_moment(total(parts)), 1 / _moment(engine)), np.abs(ratio)
        ),
        rolled=_rolled(engine, planes, reference),
    )


def _moment(engine: Engine) -> float:
    """The unit of moments at 1 rad/s: m r w^2 times the crank radius, kg m^2."""
    return 1 / scales(engine, None)[0].moment


def _rolled(engine: Engine, planes: Sequence[Plane], reference: Reference) -> Complex:
    """The roll [plane, 2] of unit unbalances up and right in these planes."""
    unit = unit_unbalance(engine) / _moment(engine)
    out = np.zeros((len(planes), 2), complex)
    for row, plane in enumerate(planes):
        shaft = engine.shaft(plane.shaft)
        place = complex(shaft.up - reference.up, shaft.right - reference.right)
        square = float(shaft.speed_ratio) ** 2
        for column, way in enumerate((1.0, 1j)):
            force = square * unit * way
            out[row, column] = roll_of(
                engine, force=complex(force), ratio=shaft.speed_ratio, place=place
            )
    return out


def _with_orders(spectrum: Spectrum, kept: Real) -> Spectrum:
    """The spectrum without the orders that are zero, but with those of the planes."""
    size = np.abs(spectrum.forward) + np.abs(spectrum.backward)
    orders = spectrum.orders[(size > SIGNIFICANT * size.max(initial=0.0))]
    wanted = spectra.distinct(np.round(np.append(orders, kept), 12))
    return replace(spectra.selected(spectrum, wanted), complete=True)


def _loads(
    engine: Engine, planes: Sequence[Plane], model: Model
) -> list[tuple[Real, complex, complex]]:
    """For each main bearing its share of a weight in each plane, and its bare vectors."""
    out: list[tuple[Real, complex, complex]] = []
    machine = mechanism(engine)
    pushed = pin_loads(machine)
    for index, shaft in enumerate(engine.shafts):
        if not shaft.throws:
            continue
        places, forces = shaft_forces(machine, pushed, index)
        own = spectra.scaled(
            spectra.selected(forces, [abs(float(shaft.speed_ratio))]), 1 / unit_unbalance(engine)
        )
        shares = bearing_shares(engine, shaft, places, model=model)
        own_planes = np.array([plane.shaft == shaft.name for plane in planes])
        plane_shares = bearing_shares(engine, shaft, [p.z for p in planes], model=model)
        for share, plane in zip(shares, plane_shares * own_planes, strict=True):
            ahead, behind = complex(share @ own.forward[:, 0]), complex(share @ own.backward[:, 0])
            if shaft.speed_ratio < 0:
                ahead, behind = behind, ahead
            out.append((plane, ahead, behind))
    return out


def with_unbalance(case: Setting, x: Real, quantity: Literal["force", "couple"]) -> Spectrum:
    """Force or couple of the engine with these weights, x [2 * planes]."""
    bare: Spectrum = getattr(case, quantity)
    forward, backward = bare.forward.copy(), bare.backward.copy()
    added = (x[0::2] + 1j * x[1::2]) * case.squared * (1.0 if quantity == "force" else case.arm)
    for vector, order, ahead in zip(added, case.order, case.forward, strict=True):
        column = int(np.argmin(np.abs(bare.orders - order)))
        (forward if ahead else backward)[column] += vector
    return replace(bare, forward=forward, backward=backward)


def _rolling(case: Setting, x: Real) -> Spectrum:
    """The roll of the engine with these weights, a signal."""
    amplitude = spectra.amplitude(case.roll).copy()
    added = (case.rolled * x.reshape(-1, 2)).sum(axis=1)
    for moment, order in zip(added, case.order, strict=True):
        amplitude[int(np.argmin(np.abs(case.roll.orders - order)))] += moment
    return spectra.real_signal(case.roll.orders, amplitude)


def _vector(case: Setting, aim: Aim, x: Real) -> Spectrum:
    """What a peak or an rms is taken of, with these weights."""
    if aim.quantity == "roll":
        whole = _rolling(case, x)
    else:
        whole = _weighted(with_unbalance(case, x, aim.quantity), aim)  # pyright: ignore[reportArgumentType]
    return whole if aim.order is None else spectra.selected(whole, aim.order)


def measured(case: Setting, aim: Aim, x: Real) -> float:
    """The value of an aim for these weights: m r w^2, of couples m r w^2 a, of roll m r^2 w^2."""
    if aim.quantity == "bearing":
        u = x[0::2] + 1j * x[1::2]
        return max(
            (
                float(abs(ahead + (share * case.squared) @ u)) + abs(behind)
                for share, ahead, behind in case.loads
            ),
            default=0.0,
        )
    vector = _vector(case, aim, x)
    if aim.order is not None:
        return float(abs(vector.forward[0]) + abs(vector.backward[0]))
    if aim.rms:
        return float(np.sqrt((np.abs(vector.forward) ** 2 + np.abs(vector.backward) ** 2).sum()))
    return spectra.peak(vector).value


def bearing_load(engine: Engine, *, model: Model = "determinate") -> float:
    """The greatest first-order load on a main bearing with the present weights, m r w^2."""
    case = setting(engine, [], model=model)
    rows = [(ahead, behind) for _shares, ahead, behind in case.loads]
    return bounded(measured(case, Aim("bearing"), np.zeros(0)), rows)


def maxima(case: Setting, aim: Aim, x: Real, *, above: float) -> Real:
    """The crank angles (radians) of the local maxima of an aim above a level with these weights."""
    if not aim.peaky:
        return np.zeros(0)
    vector = _vector(case, aim, x)
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
    if aim.quantity == "roll":
        return _roll_cones(case, aim, theta)
    bare, factor = _weighted(getattr(case, aim.quantity), aim), influence(case, aim)
    if aim.order is not None:
        bare = spectra.selected(bare, aim.order)
    if not aim.peaky:
        mean = _mean(case, aim, bare, factor)
        if aim.rms:
            return [mean]
        # the amplitude of a wave is sqrt(2) times its rms
        return [Cone(np.sqrt(2) * mean.matrix, np.sqrt(2) * mean.shift)]
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


def influence(case: Setting, aim: Aim) -> Real:
    """What a unit unbalance in each plane [plane] changes of the force, the couple or the roll."""
    if aim.quantity == "roll":
        whole = np.abs(case.rolled).max(axis=1, initial=0.0)
    else:
        whole = case.squared * (1.0 if aim.quantity == "force" else case.arm)
    return whole if aim.order is None else whole * (np.abs(case.order - aim.order) < 1e-9)


def _roll_cones(case: Setting, aim: Aim, theta: Real) -> list[Cone]:
    """The norms of the roll: at each crank angle, or of the amplitude of an order, or the rms."""
    orders, bare = case.roll.orders, spectra.amplitude(case.roll)
    own = case.order[:, None] == orders  # [plane, order]
    moved = (case.rolled[:, :, None] * own[:, None, :]).reshape(-1, orders.size)  # [x, order]
    if aim.peaky:
        turns = np.exp(1j * orders[:, None] * theta)
        rows, shifts = np.real(moved @ turns), np.real(bare @ turns)
        return [Cone(row[None, :], shift[None]) for row, shift in zip(rows.T, shifts, strict=True)]
    if aim.order is not None:
        kept = np.abs(orders - aim.order) < 1e-9
    else:
        kept = np.ones(orders.size, bool)
    share = (
        1.0 if aim.order is not None else np.sqrt(0.5)
    )  # a wave of amplitude 1 has rms sqrt(1/2)
    columns = share * moved[:, kept]
    shift = share * bare[kept]
    return [
        Cone(
            np.concatenate([np.real(columns), np.imag(columns)], axis=1).T,
            np.concatenate([np.real(shift), np.imag(shift)]),
        )
    ]


def _pairs(factor: Real) -> Real:
    """The matrix that adds up vectors, each times a real factor."""
    matrix = np.zeros((2, 2 * factor.size))
    matrix[0, 0::2] = matrix[1, 1::2] = factor
    return matrix


def _mean(case: Setting, aim: Aim, bare: Spectrum, factor: Real) -> Cone:
    """The norm over all orders, forward and backward, each a real and an imaginary row."""
    size = bare.orders.size
    columns: list[Any] = []
    for index, ahead in enumerate(case.forward):
        column = int(np.argmin(np.abs(bare.orders - case.order[index])))
        for unit in (factor[index], 1j * factor[index]):
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
