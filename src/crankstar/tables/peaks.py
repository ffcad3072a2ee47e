"""The peaks of all orders over a turn, and what crank counterweights can remove of the first."""

from __future__ import annotations

from math import degrees

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import NEGLIGIBLE, bearing_text, number, unit_text
from crankstar.mechanics.balance import Balance
from crankstar.mechanics.remains import Sums, remains, sizes
from crankstar.spectra import Spectrum


def peak_lines(engine: Engine, result: Balance, sums: Sums, plain: Sums) -> list[str]:
    """A line for each peak, and for the first order of force and couple; `plain`: in m r w^2."""
    both = any(shaft.throws and shaft.speed_ratio == -1 for shaft in engine.shafts)
    lines = [
        _vector_line(result, sums, "force"),
        _vector_line(result, sums, "couple"),
        *_moment_lines(result, sums),
    ]
    for name, unit in (("force", "m r ω²"), ("couple", "m r ω² a")):
        lines.append(_removable(name, getattr(plain, name), unit, both=both))
    return [line for line in lines if line]


def _vector_line(result: Balance, sums: Sums, name: str) -> str:
    spectrum = getattr(sums, name)
    force = name == "force"
    if not remains(spectrum, getattr(result, name)):
        return _("No force of any order.") if force else _("No couple of any order.")
    top = spectra.peak(spectrum)
    values = {
        "size": number(top.value),
        "unit": unit_text(getattr(result.units, name)),
        "angle": number(round(degrees(top.theta), 9)),
        "bearing": bearing_text(top.vector),
    }
    if force:
        return _("Peak force: {size} {unit} at θ = {angle} deg, bearing {bearing} deg.", **values)
    return _("Peak couple: {size} {unit} at θ = {angle} deg, bearing {bearing} deg.", **values)


def _moment_lines(result: Balance, sums: Sums) -> list[str]:
    unit = unit_text(result.units.moment)
    if not remains(sums.torque, result.torque):
        return [_("No inertia torque of any order.")]
    torque, roll = (number(spectra.peak(one).value) for one in (sums.torque, sums.roll))
    return [
        _("Peak inertia torque: {size} {unit}.", size=torque, unit=unit),
        _("Peak rolling moment: {size} {unit}.", size=roll, unit=unit),
    ]


def _removable(name: str, spectrum: Spectrum, unit: str, *, both: bool) -> str:
    """First order: counterweights cancel the vector that turns with their crankshaft.

    `both`: a second crankshaft turns at the same speed the other way.
    """
    first = spectra.selected(spectrum, [1.0])
    forward, backward = abs(complex(first.forward[0])), abs(complex(first.backward[0]))
    least = NEGLIGIBLE * float(sizes(spectrum).max(initial=0.0))
    force = name == "force"
    values = {"forward": number(forward), "backward": number(backward), "unit": unit}
    if max(forward, backward) <= least:
        return ""
    if forward <= least:
        return _against(force, values, both=both)
    if backward <= least:
        if force:
            return _("Primary force: counterweights remove all of it ({forward} {unit}).", **values)
        return _("Primary couple: counterweights remove all of it ({forward} {unit}).", **values)
    if both:
        if force:
            return _(
                "Primary force: counterweights on both crankshafts remove {forward} and {backward} "
                "{unit}, all of it.",
                **values,
            )
        return _(
            "Primary couple: counterweights on both crankshafts remove {forward} and {backward} "
            "{unit}, all of it.",
            **values,
        )
    if force:
        return _(
            "Primary force: counterweights remove {forward} {unit}; {backward} {unit} remains, "
            "rotating against the crankshaft.",
            **values,
        )
    return _(
        "Primary couple: counterweights remove {forward} {unit}; {backward} {unit} remains, "
        "rotating against the crankshaft.",
        **values,
    )


def _against(force: bool, values: dict[str, str], *, both: bool) -> str:
    if both:
        if force:
            return _(
                "Primary force: counterweights on the crankshaft that turns the other way remove "
                "all of it ({backward} {unit}).",
                **values,
            )
        return _(
            "Primary couple: counterweights on the crankshaft that turns the other way remove all "
            "of it ({backward} {unit}).",
            **values,
        )
    if force:
        return _(
            "Primary force: {backward} {unit} rotates against the crankshaft; no crank "
            "counterweight can remove it.",
            **values,
        )
    return _(
        "Primary couple: {backward} {unit} rotates against the crankshaft; no crank counterweight "
        "can remove it.",
        **values,
    )
