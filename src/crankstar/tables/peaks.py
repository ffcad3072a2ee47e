"""The peaks of all orders over a turn, and what crank counterweights can remove of the first."""

from __future__ import annotations

from cmath import phase
from math import degrees, radians

import numpy as np

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.language.alike import as_given, of_any
from crankstar.language.messages import N_, _
from crankstar.language.numbers import NEGLIGIBLE, bearing_text, number
from crankstar.language.shown_units import quantity_text
from crankstar.mechanics import bounds
from crankstar.mechanics.balance import Balance
from crankstar.mechanics.remains import Sums, pushed, remains, sizes
from crankstar.spectra import Peak, Spectrum
from crankstar.tables.paths import vector_name

FELT = 1e-6
"""A peak smaller than this beside what all parts push is not worth a line."""
NONE = {
    "force": N_("No force of any order."),
    "couple": N_("No couple of any order."),
    "torque": N_("No inertia torque of any order."),
}
PEAKS = {
    "force": N_("Peak force: {size} at θ = {angle} deg, bearing {bearing} deg."),
    "couple": N_("Peak couple: {size} at θ = {angle} deg, bearing {bearing} deg."),
    "torque": N_("Peak inertia torque: {size}."),
    "roll": N_("Peak rolling moment: {size}."),
}
TURNING = {
    "force": N_("Peak force: {size}; its crank angle and bearing depend on what is estimated."),
    "couple": N_("Peak couple: {size}; its crank angle and bearing depend on what is estimated."),
}
APART = radians(30)
"""Peaks further apart than this over the ranges of estimates have no crank angle to tell."""
REMOVABLE = {
    "all": N_("{vector}: counterweights remove all of it ({forward})."),
    "part": N_(
        "{vector}: counterweights remove {forward}; {backward} remains, rotating "
        "against the crankshaft."
    ),
    "none": N_(
        "{vector}: {backward} rotates against the crankshaft; no crank counterweight can remove it."
    ),
    "both": N_(
        "{vector}: counterweights on both crankshafts remove {forward} and {backward}, all of it."
    ),
    "other": N_(
        "{vector}: counterweights on the counter-rotating crankshaft remove all of it ({backward})."
    ),
}
"""What counterweights cancel of a vector that turns forward and backward."""


def peak_lines(engine: Engine, result: Balance, sums: Sums) -> list[str]:
    """A line for each peak, and for the first order of force and couple."""
    counter = any(shaft.throws and shaft.speed_ratio == -1 for shaft in engine.shafts)
    names = ["force", "couple", "torque"]
    names += of_any("peaks", ["roll"] * remains(sums.torque))
    peaks = [_peak(result, sums, name) for name in names]
    first = [_removable(result, sums, name, counter=counter) for name in ("force", "couple")]
    return [line for line in (*peaks, *first) if line]


def part_peaks(result: Balance, sums: Sums) -> dict[str, tuple[float, float, str]]:
    """The peak of each part over a turn: its size, the crank angle (radians), its unit.

    Vertical and horizontal force, pitch M_V and yaw M_H, rolling moment; a part that is rounding
    error beside the other of its vector is 0.
    """
    units = result.units
    out: dict[str, tuple[float, float, str]] = {}
    for name, parts, unit in (
        ("force", ("vertical", "horizontal"), units.force),
        ("couple", ("pitch", "yaw"), units.couple),
    ):
        whole: Spectrum = getattr(sums, name)
        waves = (spectra.vertical(whole), spectra.horizontal(whole))
        tops = [bounds.peak(spectra.real_signal(whole.orders, wave)) for wave in waves]
        least = NEGLIGIBLE * max(top.value for top in tops)
        for part, top in zip(parts, tops, strict=True):
            out[part] = (top.value if top.value > least else 0.0, top.theta, unit)
    roll = bounds.peak(sums.roll)
    out["roll"] = (roll.value, roll.theta, units.moment)
    return out


def _peak(result: Balance, sums: Sums, name: str) -> str:
    spectrum = getattr(sums, name)
    if name in NONE and not of_any(("peak", name), [True] * remains(spectrum)):
        return _(NONE[name])
    top = bounds.peak(spectrum)
    if name in NONE:
        felt = top.value > FELT * float(pushed(getattr(result, name)).max(initial=0.0))
        if not of_any(("felt", name), [True] * felt):
            return ""
    unit = getattr(result.units, name, result.units.moment)
    size = quantity_text(top.value, unit)
    if name in TURNING and _is_apart(name, top):
        return _(TURNING[name], size=size)
    return _(
        PEAKS[name],
        size=size,
        angle=number(round(degrees(top.theta), 9)),
        bearing=bearing_text(top.vector),
    )


def _is_apart(name: str, top: Peak) -> bool:
    """Whether anywhere in the ranges of estimates the peak is at quite another angle."""
    own = np.exp(1j * np.array([top.theta, phase(top.vector) if top.vector else 0.0]))
    given = as_given(("peak at", name), own)
    apart = bool(np.abs(np.angle(own / given)).max() > APART)
    return bool(of_any(("apart", name), [True] * apart))


def _removable(result: Balance, sums: Sums, name: str, *, counter: bool) -> str:
    """First order: counterweights cancel the vector that turns with their crankshaft.

    `counter`: a second crankshaft turns at the same speed the other way.
    """
    spectrum = getattr(sums, name)
    first = spectra.selected(spectrum, [1.0])
    forward, backward = (bounds.length(complex(way[0])) for way in (first.forward, first.backward))
    least = NEGLIGIBLE * float(sizes(spectrum).max(initial=0.0))
    kind = "both" if counter else "part"
    if max(forward, backward) <= least:
        kind = ""
    elif forward <= least:
        kind = "other" if counter else "none"
    elif backward <= least:
        kind = "all"
    kind = as_given(("removable", name), kind)
    if not kind:
        return ""
    unit = getattr(result.units, name)
    return _(
        REMOVABLE[kind],
        vector=vector_name(1, force=name == "force", couple=name == "couple"),
        forward=quantity_text(forward, unit, beside=backward),
        backward=quantity_text(backward, unit, beside=forward),
    )
