"""Names of vectors and of their paths over a turn: circle, line or ellipse."""

from __future__ import annotations

from fractions import Fraction
from math import degrees

from crankstar import spectra
from crankstar.language.messages import N_, _
from crankstar.language.numbers import NEGLIGIBLE

WORDS = {
    "vertical": (N_("vertical line"), N_("vertical")),
    "horizontal": (N_("horizontal line"), N_("horizontal")),
    "line": (N_("line at {bearing}°"), N_("along a line at {bearing}°")),
    "with": (N_("circle with the crank"), N_("rotating with the crankshaft")),
    "against": (N_("circle against the crank"), N_("rotating against the crankshaft")),
    "ellipse with": (
        N_("ellipse {ratio}:1 at {bearing}°, with the crank"),
        N_("on an ellipse of axis ratio {ratio}:1, major axis at {bearing}°, with the crankshaft"),
    ),
    "ellipse against": (
        N_("ellipse {ratio}:1 at {bearing}°, against the crank"),
        N_(
            "on an ellipse of axis ratio {ratio}:1, major axis at {bearing}°, against the "
            "crankshaft"
        ),
    ),
}
"""Each path as a noun, and within a sentence."""
NAMES = {
    1: (N_("Primary force"), N_("Primary couple"), N_("Primary force and couple")),
    2: (N_("Secondary force"), N_("Secondary couple"), N_("Secondary force and couple")),
}
OTHERS = (
    N_("Force of order {order}"),
    N_("Couple of order {order}"),
    N_("Force and couple of order {order}"),
)


def shape(path: spectra.Ellipse, largest: float = 0.0) -> str:
    """Circle, line or ellipse, its bearing and its sense; none beside a far larger vector.

    >>> shape(spectra.ellipse(1 + 0j, 1 + 0j)), shape(spectra.ellipse(1 + 0j, 0j))
    ('vertical line', 'circle with the crank')
    """
    if path.semi_major <= NEGLIGIBLE * largest or path.semi_major == 0:
        return _("none")
    return _worded(path, 0)


BRIEF = {
    "ellipse with": N_("on an ellipse, with the crankshaft"),
    "ellipse against": N_("on an ellipse, against the crankshaft"),
}
"""An ellipse within a sentence that leaves its axes to the tables."""


def course(path: spectra.Ellipse, *, brief: bool = False) -> str:
    """The path of a vector within a sentence: `rotating with the crankshaft`, `vertical`.

    >>> course(spectra.ellipse(1 + 0j, 0j)), course(spectra.ellipse(1 + 0j, -1 + 0j))
    ('rotating with the crankshaft', 'horizontal')
    """
    return _worded(path, 1, brief=brief)


def _worded(path: spectra.Ellipse, form: int, *, brief: bool = False) -> str:
    bearing = round(degrees(path.bearing), 2)
    bearing = 90.0 if bearing == -90 else bearing + 0.0
    ratio, way = path.semi_minor / path.semi_major, "with" if path.sense > 0 else "against"
    kind = f"ellipse {way}"
    if ratio <= NEGLIGIBLE:
        kind = {0.0: "vertical", 90.0: "horizontal"}.get(bearing, "line")
    elif 1 - ratio <= NEGLIGIBLE:
        kind = way
    if brief and kind in BRIEF:
        return _(BRIEF[kind])
    return _(WORDS[kind][form], ratio=f"{ratio:.3g}", bearing=f"{bearing:g}")


def vector_name(order: Fraction | int, *, force: bool, couple: bool) -> str:
    """Primary, secondary, or by order: force, couple, or both.

    >>> vector_name(Fraction(-1), force=False, couple=True)
    'Primary couple'
    """
    names = NAMES.get(abs(order), OTHERS)  # pyright: ignore[reportArgumentType, reportCallIssue]
    return _(names[2 if force and couple else int(couple)], order=abs(order))
