"""What the best weights reach, and what no weights in their planes can beat."""

from __future__ import annotations

from math import degrees

from crankstar.language.messages import N_, _
from crankstar.language.written import capitalised
from crankstar.remedy import Best, Limit, aim_name, aim_text

BEARINGS = {
    "determinate": N_("Bearing loads are those of the shaft hinged at its main bearings."),
    "continuous": N_("Bearing loads are those of the shaft as one beam on its main bearings."),
}
ANGLES = 8
"""Crank angles of a peak that are named."""


def certificate(best: Best, *, speed: float | None = None) -> list[str]:
    """The value reached, its lower bound, the angles of the peak, and a sentence for each limit.

    A limit is given beside its value, with whether it binds; at a speed (rad/s) in N and N m.
    """
    aim = aim_name(best.aim)

    def told(value: float) -> str:
        return aim_text(best.aim, value, best.engine, speed, beside=best.before)

    values = {
        "aim": capitalised(aim),
        "value": told(best.value),
        "before": told(best.before),
        "bound": told(best.bound),
    }
    lines = [
        _("{aim}: {value}; {before} with the weights of the file alone.", **values)
        if best.kept
        else _("{aim}: {value}; {before} with bare crankshafts.", **values)
    ]
    if best.limits:
        lines.append(
            _("Lower bound for weights in these planes, within the limits: {bound}.", **values)
        )
    else:
        lines.append(_("Lower bound for weights in these planes: {bound}.", **values))
    lines.append(_("The bound is that of the dual convex problem."))
    if "bearing" in {best.aim.quantity, *(limit.aim.quantity for limit, _value in best.limits)}:
        lines.append(_(BEARINGS[best.model]))
    if best.angles:
        shown = ", ".join(f"{degrees(angle):.4g}" for angle in best.angles[:ANGLES])
        more = " ..." if len(best.angles) > ANGLES else ""
        lines.append(_("Crank angles of the peak: {angles} deg.", angles=shown + more))
    return lines + [_limit(best, limit, value, speed) for limit, value in best.limits]


def _limit(best: Best, limit: Limit, value: float, speed: float | None) -> str:
    if limit.implied and best.kept:
        return _(
            "The {aim} is kept at or below that with the weights of the file alone; --limit allows "
            "more.",
            aim=aim_name(limit.aim),
        )
    if limit.implied:
        return _(
            "The {aim} is kept at or below that of bare crankshafts; --limit allows more.",
            aim=aim_name(limit.aim),
        )
    values = {
        "aim": aim_name(limit.aim),
        "found": aim_text(limit.aim, value, best.engine, speed, beside=limit.at_most),
        "limit": aim_text(limit.aim, limit.at_most, best.engine, speed, beside=value),
    }
    if value > limit.at_most * (1 - 1e-5) - 1e-9:
        return _("Limit of {aim}: {found} of {limit}, reached.", **values)
    return _("Limit of {aim}: {found} of {limit}, not reached.", **values)
