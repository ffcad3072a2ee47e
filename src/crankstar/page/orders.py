"""A Balance for the page: vectors of every order, the table of orders, the free response."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import chain
from typing import Any, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.analysis.document import Ranged
from crankstar.dynamics import whirl
from crankstar.engine.engine import Engine
from crankstar.language.numbers import NEGLIGIBLE, number, wave
from crankstar.mechanics.balance import Balance
from crankstar.mechanics.bounds import bounds_kept, greatest, length
from crankstar.mechanics.remains import Sums, ranked
from crankstar.page.records import Pair, PartForce, Quantity, Row, Sum, Vectors, Whirl
from crankstar.spectra import Complex, Spectrum
from crankstar.tables.cells import ranged_text
from crankstar.tables.number_ranges import number_range
from crankstar.tables.paths import shape

MINUS = "\N{MINUS SIGN}"
ROUNDED = 7
"""Figures of the sums at the corners of ranges, of which three are shown."""


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


def ends_of(ends: Sequence[Sums], orders: Sequence[float]) -> tuple[Sum, ...]:
    """The whole engine in the middle and at the corners of its ranges, each different one once."""
    sums = [sums_of(each, orders, digits=ROUNDED) for each in ends]
    return tuple({each.model_dump_json(): each for each in sums}.values())


def sums_of(sums: Sums, orders: Sequence[float], *, digits: int | None = None) -> Sum:
    """The whole engine; with so many figures, if `digits` says how many."""
    if digits is not None:
        whole = sums_of(sums, orders).model_dump()
        return Sum.model_validate(_rounded(whole, digits))
    return Sum(
        force=vectors(sums.force, orders),
        couple=vectors(sums.couple, orders),
        roll=signals(sums.roll, orders),
        torque=signals(sums.torque, orders),
    )


def _rounded(tree: Any, digits: int) -> Any:
    if isinstance(tree, dict):
        return {key: _rounded(value, digits) for key, value in tree.items()}
    if isinstance(tree, tuple | list):
        return tuple(_rounded(value, digits) for value in tree)
    return float(f"{tree:.{digits}g}") + 0.0


def by_cylinder(
    engine: Engine, result: Balance, orders: Sequence[float], *, along: float
) -> tuple[PartForce, ...]:
    """What each cylinder does to the block."""
    bank = {number: name for name, numbers in engine.banks.items() for number in numbers}
    own = {cylinder.number: list[int]() for cylinder in engine.cylinders}
    for row, part in enumerate(result.parts):
        if part.cylinder is not None:
            own[part.cylinder].append(row)
    return tuple(
        PartForce(
            number=cylinder.number,
            bank=bank[cylinder.number],
            z=cylinder.z * along,
            force=vectors(spectra.total(result.force[own[cylinder.number]]), orders),
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


class Scaling(NamedTuple):
    """The factors from the units of a Balance to those printed: force, couple, moments."""

    force: float = 1.0
    couple: float = 1.0
    moment: float = 1.0

    def of(self, quantity: str) -> float:
        """That of a quantity."""
        return getattr(self, quantity) if quantity in ("force", "couple") else self.moment


def rows(
    sums: Sums,
    orders: Sequence[float],
    *,
    scaling: Scaling | None = None,
    ends: Sequence[Sums] = (),
) -> tuple[Row, ...]:
    """The table of orders: of each quantity those that remain, the greatest first, then others.

    `ends` are the sums in the middle and at the corners of the ranges of an estimated engine.
    """
    return tuple(
        row
        for quantity in ("force", "couple", "roll", "torque")
        for row in _rows(sums, quantity, orders, (scaling or Scaling()).of(quantity), ends)
    )


class _Sizes(NamedTuple):
    """Vertical and horizontal amplitude, and greatest value, of an order."""

    up: complex
    right: complex
    greatest: float


def _rows(
    sums: Sums, quantity: Quantity, orders: Sequence[float], factor: float, ends: Sequence[Sums]
) -> Iterator[Row]:
    spectrum = getattr(sums, quantity)
    orders = list(chain(*ranked(spectrum, orders)))
    vector = quantity in ("force", "couple")
    largest = _largest(spectrum)
    if not vector:
        largest = max(_largest(sums.roll), _largest(sums.torque))
    chosen = spectra.selected(spectrum, orders)
    with bounds_kept():
        own, *others = [
            _sizes(spectra.selected(getattr(each, quantity), orders), vector=vector)
            for each in (sums, *ends)
        ]
    for index, order in enumerate(orders):
        sizes = own[index]
        path = spectra.ellipse(complex(chosen.forward[index]), complex(chosen.backward[index]))
        written = _written(sizes, [each[index] for each in others], factor, largest)
        remains = sizes.greatest > NEGLIGIBLE * largest
        yield Row(
            order=order,
            label=number(order),
            quantity=quantity,
            up=written[0],
            right=written[1] if vector else "",
            greatest=written[2],
            estimated=written[3],
            path=shape(path, largest) if vector and (remains or not written[3]) else "",
            size=sizes.greatest if remains else 0.0,
            remains=remains,
            semi_axes=(path.semi_major, path.semi_minor) if vector else None,
            direction=path.bearing if vector else None,
        )


def _sizes(spectrum: Spectrum, *, vector: bool) -> list[_Sizes]:
    """The amplitudes of every order of a spectrum; a signal has one, its greatest value too."""
    if not vector:
        signal = spectra.amplitude(spectrum).tolist()
        return [_Sizes(wave, 0j, length(wave)) for wave in signal]
    up, right = spectra.vertical(spectrum).tolist(), spectra.horizontal(spectrum).tolist()
    ways = zip(spectrum.forward.tolist(), spectrum.backward.tolist(), strict=True)
    most = [greatest(*each) for each in ways]
    return [_Sizes(*each) for each in zip(up, right, most, strict=True)]


def _written(
    own: _Sizes, others: Sequence[_Sizes], factor: float, largest: float
) -> tuple[str, str, str, bool]:
    """The three as they are printed, with their ranges; whether one has a range."""
    top = largest * factor
    if not others:
        waves = [wave(factor * complex(each), top) for each in own[:2]]
        return _seen(waves[0]), _seen(waves[1]), _seen(number(factor * own.greatest, top)), False
    shown: list[complex | Ranged] = []
    for place in ("up", "right"):
        waves = [factor * complex(getattr(each, place)) for each in (own, *others)]
        shown.append(number_range(waves, top))
    greatest = number_range([factor * each.greatest for each in (own, *others)], top)
    texts = [ranged_text(each) if isinstance(each, Ranged) else wave(each, top) for each in shown]
    text = ranged_text(greatest) if isinstance(greatest, Ranged) else number(greatest, top)
    ranged = any(isinstance(each, Ranged) for each in (*shown, greatest))
    return _seen(texts[0]), _seen(texts[1]), _seen(text), ranged


def _seen(text: str) -> str:
    """A number with a true minus: on a page it is looked at, not copied into a program."""
    return text.replace("-", MINUS)


def _largest(spectrum: Spectrum) -> float:
    return float(np.max(np.abs(spectrum.forward) + np.abs(spectrum.backward), initial=0.0)) or 1.0
