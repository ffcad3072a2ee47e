"""Numbers, amplitudes, units and durations as an engineer writes them."""

from __future__ import annotations

import re
from collections.abc import Sequence
from math import degrees, pi
from typing import overload

import numpy as np

from crankstar.language.messages import _n
from crankstar.language.written import Number, joined

RPM = 30 / pi
"""Revolutions per minute in a radian per second."""
NEGLIGIBLE = 1e-9
"""A number smaller than this share of the largest beside it is written as 0."""


def number(value: complex, largest: float = 0.0, *, digits: int = 5) -> Number:
    """A number to five figures, if possible without an exponent; 0 if negligible to `largest`.

    Of a complex amplitude the absolute value, whose range is the amplitude's (`number_ranges`).

    >>> number(66450.2), number(66450.2, digits=4), number(1e-7)
    ('66450', '66450', '1e-07')
    """
    own = value if isinstance(value, float | complex) else float(value)
    value = abs(value) if isinstance(value, complex) else float(value)
    if abs(value) <= NEGLIGIBLE * largest or value == 0:
        own, text = 0.0, "0"
    elif 10**digits <= abs(value) < 1e9:
        text = f"{value:.0f}"
    else:
        text = f"{value:.{digits}g}"
    return Number(text, own)


@overload
def rpm_of(speed: float) -> float: ...


@overload
def rpm_of(speed: float | None) -> float | None: ...


def rpm_of(speed: float | None) -> float | None:
    """A speed (rad/s) in rpm for machines, without the rounding of the conversion; None for none.

    >>> 1500 / RPM * RPM, rpm_of(1500 / RPM), rpm_of(None)
    (1499.9999999999998, 1500.0, None)
    """
    return None if speed is None else float(f"{speed * RPM:.12g}")


def order_text(order: float) -> str:
    """A crank order or a speed ratio: a name more than a size, so that it never has a range."""
    return f"{float(order):.5g}"


def duration(seconds: float) -> str:
    """A time in rounded words: `3 s`, `4 min`, `2.5 h`, `12 days`.

    >>> duration(0.2), duration(200), duration(9000), duration(1e6), duration(1e10)
    ('1 s', '3 min', '2.5 h', '12 days', '317 years')
    """
    if seconds < 100:
        return f"{max(1, round(seconds))} s"
    if seconds < 6000:
        return f"{seconds / 60:.0f} min"
    if seconds < 172_800:
        return f"{seconds / 3600:.1f} h"
    days, years = round(seconds / 86_400), round(seconds / 31_557_600)
    if days < 1000:
        return _n("{count} day", "{count} days", days, count=days)
    return _n("{count} year", "{count} years", years, count=f"{years:,}")


def wave(value: complex, largest: float = 0.0) -> str:
    """A complex amplitude as `a ∠ p°`."""
    size = abs(complex(value))
    if size <= NEGLIGIBLE * largest or size == 0:
        return "0"
    phase = round(degrees(np.angle(value)), 2)
    phase = 0.0 if phase == 0 else 180.0 if phase == -180 else phase
    return joined("", [number(size), f" ∠ {phase:g}°"])


def bearing_text(vector: complex) -> str:
    """The bearing of a vector in degrees, in (-180, 180]."""
    bearing = round(degrees(np.angle(vector)), 3)
    return number(180.0 if bearing == -180 else bearing, 180.0)


def unit_text(unit: str) -> str:
    """A unit of a Balance in print.

    M r² ω² for m*r^2*w^2, with A2 for A_2 (fonts of figures lack small digits).

    >>> unit_text("kg*m^2"), unit_text("um")
    ('kg m²', 'µm')
    """
    if unit == "um":
        return "µm"
    plain = (
        unit.replace("w_0^2", "ω0²")
        .replace("w^2", "ω²")
        .replace("^2", "²")
        .replace("^3", "³")
        .replace("A_k", "Aₖ")
        .replace("*", " ")
    )
    return re.sub(r"_(\d+)", r"\1", plain)


def numbers_text(numbers: Sequence[int]) -> str:
    """Numbers for a label: runs of three and more as a range, long lists by their ends.

    >>> numbers_text([1, 8]), numbers_text([1, 2, 3, 5])
    ('1, 8', '1–3, 5')
    """
    runs: list[list[int]] = []
    for cylinder in sorted(numbers):
        if runs and cylinder == runs[-1][-1] + 1:
            runs[-1].append(cylinder)
        else:
            runs.append([cylinder])
    parts = [
        text
        for run in runs
        for text in ([f"{run[0]}–{run[-1]}"] if len(run) > 2 else map(str, run))
    ]
    return ", ".join(parts) if len(parts) <= 6 else f"{', '.join(parts[:3])} … {parts[-1]}"
