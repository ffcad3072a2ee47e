"""A Balance for the page: vectors of every order, the table of orders, the free response."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain
from typing import Literal

import numpy as np

from crankstar import spectra
from crankstar.dynamics import whirl
from crankstar.engine.engine import Engine
from crankstar.language.numbers import NEGLIGIBLE, number, wave
from crankstar.mechanics.balance import Balance, of_parts
from crankstar.mechanics.remains import Sums, ranked
from crankstar.page.records import Pair, PartForce, Row, Sum, Vectors, Whirl
from crankstar.spectra import Complex, Spectrum
from crankstar.tables.paths import shape

MINUS = "\N{MINUS SIGN}"


def vectors(spectrum: Spectrum, orders: Sequence[float]) -> Vectors:
    """A vector of the clock plane at the orders of an exhibit."""
    chosen = spectra.selected(spectrum, orders)
    return Vectors(forward=pairs(chosen.forward), backward=pairs(chosen.backward))


def pairs(values: Complex) -> tuple[Pair, ...]:
    """Complex numbers as pairs of floats."""
    return tuple((float(value.real) + 0.0, float(value.imag) + 0.0) for value in values)


def signals(spectrum: Spectrum, orders: Sequence[float]) -> tuple[Pair, ...]:
    """The amplitudes of a real signal at the orders of an exhibit."""
    return pairs(spectra.amplitude(spectra.selected(spectrum, orders)))


def sums_of(sums: Sums, orders: Sequence[float]) -> Sum:
    """The whole engine."""
    return Sum(
        force=vectors(sums.force, orders),
        couple=vectors(sums.couple, orders),
        roll=signals(sums.roll, orders),
        torque=signals(sums.torque, orders),
    )


def by_cylinder(
    engine: Engine, result: Balance, orders: Sequence[float], *, along: float
) -> tuple[PartForce, ...]:
    """What each cylinder does to the block."""
    return tuple(
        PartForce(
            number=cylinder.number,
            z=cylinder.z * along,
            force=vectors(of_parts(result, cylinder=cylinder.number).force, orders),
        )
        for cylinder in engine.cylinders
    )


def free_response(engine: Engine, orders: Sequence[float], *, along: float) -> Whirl:
    """How the engine moves if nothing holds it."""
    body = whirl.body(engine, along=along)
    response = whirl.response(engine, of=body, along=along, orders=tuple(orders))
    return Whirl(
        centre=body.centre,
        mass=body.mass,
        inertia=body.inertia,
        shift=vectors(response.shift, orders),
        tilt=vectors(response.tilt, orders),
        turn=signals(response.turn, orders),
        assumed=body.assumed,
    )


def rows(sums: Sums, orders: Sequence[float]) -> tuple[Row, ...]:
    """The table of orders: of each quantity those that remain, the greatest first, then others."""
    return (
        *_vector_rows(sums, "force", orders),
        *_vector_rows(sums, "couple", orders),
        *_signal_rows(sums, "roll", orders),
        *_signal_rows(sums, "torque", orders),
    )


def _vector_rows(
    sums: Sums, quantity: Literal["force", "couple"], orders: Sequence[float]
) -> Iterator[Row]:
    spectrum = getattr(sums, quantity)
    orders = list(chain(*ranked(spectrum, orders)))
    largest = _largest(spectrum)
    chosen = spectra.selected(spectrum, orders)
    up, right = spectra.vertical(chosen), spectra.horizontal(chosen)
    for index, order in enumerate(orders):
        path = spectra.ellipse(complex(chosen.forward[index]), complex(chosen.backward[index]))
        yield Row(
            order=order,
            label=number(order),
            quantity=quantity,
            up=_seen(wave(up[index], largest)),
            right=_seen(wave(right[index], largest)),
            path=shape(path, largest),
            greatest=_seen(number(path.semi_major, largest)),
            size=path.semi_major if path.semi_major > NEGLIGIBLE * largest else 0.0,
            remains=path.semi_major > NEGLIGIBLE * largest,
            semi_axes=(path.semi_major, path.semi_minor),
            direction=path.bearing,
        )


def _signal_rows(
    sums: Sums, quantity: Literal["roll", "torque"], orders: Sequence[float]
) -> Iterator[Row]:
    largest = max(_largest(sums.roll), _largest(sums.torque))
    spectrum = getattr(sums, quantity)
    orders = list(chain(*ranked(spectrum, orders)))
    signal = spectra.amplitude(spectra.selected(spectrum, orders))
    for order, amplitude in zip(orders, signal, strict=True):
        yield Row(
            order=order,
            label=number(order),
            quantity=quantity,
            up=_seen(wave(amplitude, largest)),
            right="",
            path="",
            greatest=_seen(number(abs(amplitude), largest)),
            size=float(abs(amplitude)) if abs(amplitude) > NEGLIGIBLE * largest else 0.0,
            remains=bool(abs(amplitude) > NEGLIGIBLE * largest),
            semi_axes=None,
            direction=None,
        )


def _seen(text: str) -> str:
    """A number with a true minus: on a page it is looked at, not copied into a program."""
    return text.replace("-", MINUS)


def _largest(spectrum: Spectrum) -> float:
    return float(np.max(np.abs(spectrum.forward) + np.abs(spectrum.backward), initial=0.0)) or 1.0
