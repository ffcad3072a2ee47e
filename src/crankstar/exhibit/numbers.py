"""A Balance as the page needs it: vectors of every order for arrows, the table of orders, the free response."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

import numpy as np

from crankstar import phasor, whirl
from crankstar.answer import GREATEST_DEFAULT_ORDER, SIGNIFICANT, orders_present
from crankstar.balance import Balance, of_parts, total
from crankstar.engine import Engine
from crankstar.exhibit.records import Pair, PartForce, Row, Sum, Vectors, Whirl
from crankstar.mechanism import Totals, block_roll
from crankstar.phasor import Complex, Spectrum
from crankstar.wording import NEGLIGIBLE, number, shape, wave


def summed(result: Balance) -> Totals:
    """The sums of a Balance, the roll being that of the block; what is nothing beside its parts is zero."""

    def quiet(whole: Spectrum, parts: Spectrum) -> Spectrum:
        pushed = (np.abs(parts.forward) + np.abs(parts.backward)).sum(axis=0)
        heard = np.abs(whole.forward) + np.abs(whole.backward) > NEGLIGIBLE * pushed
        return phasor.scaled(whole, heard)

    sums = total(result)
    return Totals(
        force=quiet(sums.force, result.force),
        couple=quiet(sums.couple, result.couple),
        roll=quiet(block_roll(sums), result.roll),
        torque=quiet(sums.torque, result.torque),
    )


MINUS = "\N{MINUS SIGN}"
HEARD = 1e-3
"""Share of the greatest order from which an order above the usual ones is not left out."""


def orders_shown(result: Balance, sums: Totals) -> tuple[float, ...]:
    """The orders of a page: those at which a part pushes, those in which the block rolls though no part pushes, and high ones.

    A centred piston has no roll of its own; the block rolls because a flywheel takes up the torque. An order above the usual
    ones is there if it is heard: in the sum of the engine, as where many cylinders leave no lower one, or in what a part does.
    """
    rolls = np.abs(sums.roll.forward) + np.abs(sums.roll.backward)
    usual = sums.roll.orders <= GREATEST_DEFAULT_ORDER
    left = (rolls > SIGNIFICANT * rolls.max(initial=0.0)) & usual
    for spectrum in (sums.force, sums.couple, sums.roll, result.force):
        sizes = (np.abs(spectrum.forward) + np.abs(spectrum.backward)).reshape(-1, usual.size).max(axis=0, initial=0.0)
        left |= (sizes > HEARD * sizes.max(initial=0.0)) & ~usual
    return tuple(sorted({*orders_present(result), *sums.roll.orders[left].tolist()}))


def vectors(spectrum: Spectrum, orders: Sequence[float]) -> Vectors:
    """A vector of the clock plane at the orders of an exhibit."""
    one = phasor.selected(spectrum, orders)
    return Vectors(forward=pairs(one.forward), backward=pairs(one.backward))


def pairs(values: Complex) -> tuple[Pair, ...]:
    """Complex numbers as pairs of floats."""
    return tuple((float(value.real) + 0.0, float(value.imag) + 0.0) for value in values)


def signals(spectrum: Spectrum, orders: Sequence[float]) -> tuple[Pair, ...]:
    """The amplitudes of a real signal at the orders of an exhibit."""
    return pairs(phasor.amplitude(phasor.selected(spectrum, orders)))


def sums_of(sums: Totals, orders: Sequence[float]) -> Sum:
    """The whole engine."""
    return Sum(
        force=vectors(sums.force, orders),
        couple=vectors(sums.couple, orders),
        roll=signals(sums.roll, orders),
        torque=signals(sums.torque, orders),
    )


def by_cylinder(engine: Engine, result: Balance, orders: Sequence[float], *, along: float) -> tuple[PartForce, ...]:
    """What each cylinder does to the block."""
    return tuple(
        PartForce(
            number=cylinder.number, z=cylinder.z * along, force=vectors(of_parts(result, cylinder=cylinder.number).force, orders)
        )
        for cylinder in engine.cylinders
    )


def free_response(engine: Engine, orders: Sequence[float], *, along: float) -> Whirl:
    """How the engine moves if nothing holds it."""
    body = whirl.body(engine, along=along)
    found = whirl.response(engine, of=body, along=along, orders=tuple(orders))
    return Whirl(
        centre=body.centre,
        mass=body.mass,
        inertia=body.inertia,
        shift=vectors(found.shift, orders),
        tilt=vectors(found.tilt, orders),
        turn=signals(found.turn, orders),
        assumed=body.assumed,
    )


def rows(sums: Totals, orders: Sequence[float]) -> tuple[Row, ...]:
    """The table of orders: what is printed, and the ellipse."""
    out = []
    for quantity in ("force", "couple"):
        one = phasor.selected(getattr(sums, quantity), orders)
        largest = _largest(getattr(sums, quantity))
        up, right = phasor.vertical(one), phasor.horizontal(one)
        for index, order in enumerate(orders):
            path = phasor.ellipse(complex(one.forward[index]), complex(one.backward[index]))
            out.append(
                Row(
                    order=order,
                    label=number(order),
                    quantity=quantity,
                    up=_seen(wave(up[index], largest)),
                    right=_seen(wave(right[index], largest)),
                    path=shape(path, largest),
                    greatest=_seen(number(path.semi_major, largest)),
                    semi_axes=(path.semi_major, path.semi_minor),
                    direction=path.bearing,
                    turning=_turning(path, one.sense),
                )
            )
    for quantity in ("roll", "torque"):
        signal = getattr(sums, quantity)
        largest = max(_largest(sums.roll), _largest(sums.torque))
        for order, size in zip(orders, phasor.amplitude(phasor.selected(signal, orders)), strict=True):
            told = {"up": _seen(wave(size, largest)), "right": "", "path": "", "greatest": _seen(number(abs(size), largest))}
            out.append(
                Row(order=order, label=number(order), quantity=quantity, semi_axes=None, direction=None, turning=None, **told)
            )
    return tuple(out)


def _seen(text: str) -> str:
    """A number with a true minus: on a page it is looked at, not copied into a program."""
    return text.replace("-", MINUS)


def _turning(path: phasor.Ellipse, sense: int) -> Literal[-1, 0, 1]:
    """The way an ellipse is run through seen from the front: 1 clockwise, -1 counter-clockwise, 0 a line or nothing."""
    turning = path.sense * sense
    return 0 if turning == 0 else 1 if turning > 0 else -1


def _largest(spectrum: Spectrum) -> float:
    return float(np.max(np.abs(spectrum.forward) + np.abs(spectrum.backward), initial=0.0)) or 1.0
