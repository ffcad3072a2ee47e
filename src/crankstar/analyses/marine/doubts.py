"""What is missing in a marine analysis, and what in it hardly any engine has, as sentences."""

from __future__ import annotations

from collections.abc import Iterator

from crankstar.analyses.marine.marine_analysis import MarineAnalysis
from crankstar.language.messages import _
from crankstar.language.numbers import number, order_text, unit_text
from crankstar.language.shown_units import shown
from crankstar.language.written import joined
from crankstar.mechanics.doubts import GREATEST_IMEP, point_doubts
from crankstar.mechanics.lacking import KEYS, lacking_keys
from crankstar.tables.torque import charge_sentences

LEAST_RATED = 1e5
"""Pa, of the brake mean effective pressure of any rating: no more than friction takes."""


def power_text(power: float) -> str:
    """A power (W) in kW, or in the unit that is chosen."""
    said = shown("kW", 0.0, prefixed=False)
    size = number(float(f"{power / 1e3 * said.factor:.5g}"))
    return joined(" ", [size, unit_text(said.unit)])


def doubts(found: MarineAnalysis, bracing: tuple[float, float] | None) -> list[str]:
    """What is missing, and what is hardly right."""
    lines = [missing_guide(found)]
    guide = found.guide
    if guide is not None and not guide.with_inertia:
        lines.append(
            _(
                "Guide-force moments are those of gas alone: without {keys} there is no inertia.",
                keys=", ".join(lacking_keys(found.engine, found.cycle and found.cycle.speed)),
            )
        )
    if guide is not None and not guide.pitch_known:
        lines.append(_("X needs the distance of the cylinders: give layout.bore_pitch."))
    if found.cycle is not None:
        lines += charge_sentences(found.cycle)
        lines += [fault.sentence for fault in point_doubts(found.engine, found.cycle)]
    return [*lines, missing_units(found), *_strange(found, bracing)]


def _strange(found: MarineAnalysis, bracing: tuple[float, float] | None) -> Iterator[str]:
    """A power, compensators and top bracings that hardly any engine has."""
    pressure = found.mean_pressure
    if (
        found.power is not None
        and pressure is not None
        and not LEAST_RATED <= pressure <= GREATEST_IMEP
    ):
        yield _(
            "The power, {power}, is a brake mean effective pressure of {value} bar, at which no "
            "engine is rated: see --rated-power.",
            power=power_text(found.power),
            value=number(float(f"{pressure / 1e5:.2g}")),
        )
    if found.strained:
        yield _(
            "A compensator of order {order} pushes with more than all cylinders together: its arm "
            "is too short.",
            order=order_text(found.strained[0].order),
        )
    radius = max(found.engine.throw(each).radius for each in found.engine.cylinders)
    if bracing is not None and "radius" not in found.engine.relative and bracing[0] < radius:
        yield _(
            "Top bracings at {height} m over the crankshaft are no higher than its crank pins, "
            "{radius} m: is the unit right?",
            height=number(bracing[0]),
            radius=number(radius),
        )


def missing_guide(found: MarineAnalysis) -> str:
    """Why guide-force moments are not told, as a sentence; empty where they are."""
    reason = found.without_guide.rstrip(".")
    return _("Without guide-force moments: {reason}.", reason=reason) if reason else ""


def missing_units(found: MarineAnalysis) -> str:
    """Why moments are not in N m, as a sentence; empty where they are."""
    if found.after.units.couple == "N*m":
        return ""
    return _(
        "The file lacks what it takes for N m: {keys}; moments are in units of the first cylinder.",
        keys=", ".join(lacking_keys(found.engine, found.speed, sizes=KEYS)),
    )
