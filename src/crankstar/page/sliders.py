"""The curves behind the sliders: what an engine leaves over the range of a number, by sweeping it.

The numbers are those of `crankstar sweep ENGINE --over RANGE --watch WHAT` for the same file. The
present value is one of the values that are swept, so that its result is exact, too.
"""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from typing import Any

import numpy as np

from crankstar.files import EngineFileError, changed, engine_of
from crankstar.files.crank_layouts import ONE
from crankstar.language.faults import EngineError
from crankstar.language.messages import N_, MessageError, _
from crankstar.language.numbers import unit_text
from crankstar.language.shown_units import shown
from crankstar.mechanics.remains import NEGLIGIBLE
from crankstar.page.controls import controls
from crankstar.page.workshop_records import Control, Slider, SliderCurve
from crankstar.studies.fields import Source
from crankstar.studies.sweep import Curve, Sweep, sweep_of, watched

POINTS = 61
MOST_CURVES = 3
WATCHED = (
    (N_("Primary force"), "force", 1.0),
    (N_("Secondary force"), "force", 2.0),
    (N_("Primary couple"), "couple", 1.0),
    (N_("Secondary couple"), "couple", 2.0),
    (N_("Rolling moment"), "roll", None),
)
"""What the verdict speaks of first: a name, and what a sweep watches."""
VARIES = 0.005
"""Share of its greatest value by which a curve must vary to be drawn."""


def sliders(tree: Mapping[str, Any], *, name: str = "the engine") -> tuple[Slider, ...]:
    """The curves of every control of an engine that is swept; one that cannot be is left out.

    Raises EngineFileError where the tree is no engine.

    >>> from crankstar.files.catalog import tree_of
    >>> first = sliders(tree_of("v2-90")[1])[0]
    >>> first.range, first.curves[0].label, round(first.curves[0].present, 6)
    ('layout.bank_angle=0..180 deg/61', 'Primary force', 1.0)
    """
    engine = engine_of(dict(tree), name=name)
    listed: list[Slider] = []
    for control in controls(engine, tree):
        if control.swept:
            with suppress(EngineFileError, EngineError, MessageError):
                listed.append(_slider(control, tree, name))
    return tuple(listed)


def _slider(control: Control, tree: Mapping[str, Any], name: str) -> Slider:
    given = {} if control.key.startswith("layout.bank_angle") else _given(control)
    values = np.linspace(control.low, control.high, POINTS)
    near = np.abs(values - control.value) < ONE * (control.high - control.low)
    every = np.unique(np.append(values[~near], control.value))
    made = sweep_of(
        Source(name, changed(dict(tree), given, name=name)),
        [(control.key, every, control.unit)],
        speed="file",
    )
    unit = f" {control.unit}" if control.unit else ""
    return Slider(
        key=control.key,
        present=control.value,
        values=tuple(every.tolist()),
        curves=tuple(_curves(made, int(np.searchsorted(every, control.value)))),
        range=f"{control.key}={control.low:g}..{control.high:g}{unit}/{POINTS}",
    )


def _given(control: Control) -> dict[str, Any]:
    """The number as a key of the file, so that there is one to sweep."""
    unit = f" {control.unit}" if control.unit else ""
    return {control.key: f"{control.value!r}{unit}" if unit else control.value}


def _curves(made: Sweep, index: int) -> list[SliderCurve]:
    """What varies over the range and is not negligible, at most MOST_CURVES, the greatest first."""
    found = [(label, watched(made, what, order=order)) for label, what, order in WATCHED]
    kinds = {curve.what: 0.0 for _label, curve in found}
    for _label, curve in found:
        kinds[curve.what] = max(kinds[curve.what], float(curve.values.max()))
    kept = [
        (label, curve)
        for label, curve in found
        if curve.values.max() > 100 * NEGLIGIBLE * kinds[curve.what] > 0
    ]
    varied = [each for each in kept if np.ptp(each[1].values) > VARIES * each[1].values.max()]
    return [_curve(_(label), curve, index) for label, curve in (varied or kept)[:MOST_CURVES]]


def _curve(label: str, curve: Curve, index: int) -> SliderCurve:
    unit = shown(curve.unit, float(curve.values.max()))
    results = curve.values * unit.factor
    return SliderCurve(
        label=label,
        what=curve.what,
        order=curve.order,
        unit=unit_text(unit.unit),
        results=tuple(results.tolist()),
        present=float(results[index]),
    )
