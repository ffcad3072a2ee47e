"""The path of a vector over a turn, named: circle, line or ellipse."""

from __future__ import annotations

from math import degrees

from crankstar import spectra
from crankstar.language.messages import _
from crankstar.language.numbers import NEGLIGIBLE


def shape(path: spectra.Ellipse, largest: float = 0.0) -> str:
    """Circle, line or ellipse, its bearing and its sense; none beside a far larger vector.

    >>> shape(spectra.ellipse(1 + 0j, 1 + 0j)), shape(spectra.ellipse(1 + 0j, 0j))
    ('vertical line', 'circle with the crank')
    """
    if path.semi_major <= NEGLIGIBLE * largest or path.semi_major == 0:
        return _("none")
    bearing = round(degrees(path.bearing), 2)
    bearing = 90.0 if bearing == -90 else bearing + 0.0
    if path.semi_minor <= NEGLIGIBLE * path.semi_major:
        if bearing == 0:
            return _("vertical line")
        if bearing == 90:
            return _("horizontal line")
        return _("line at {bearing}°", bearing=f"{bearing:g}")
    if path.semi_major - path.semi_minor <= NEGLIGIBLE * path.semi_major:
        return _("circle with the crank") if path.sense > 0 else _("circle against the crank")
    values = {"ratio": f"{path.semi_minor / path.semi_major:.3g}", "bearing": f"{bearing:g}"}
    if path.sense > 0:
        return _("ellipse {ratio}:1 at {bearing}°, with the crank", **values)
    return _("ellipse {ratio}:1 at {bearing}°, against the crank", **values)


def course(path: spectra.Ellipse) -> str:
    """The path of a vector within a sentence: `rotating with the crankshaft`, `vertical`.

    >>> course(spectra.ellipse(1 + 0j, 0j)), course(spectra.ellipse(1 + 0j, -1 + 0j))
    ('rotating with the crankshaft', 'horizontal')
    """
    bearing = round(degrees(path.bearing), 2)
    values = {"bearing": f"{90.0 if bearing == -90 else bearing + 0.0:g}"}
    if path.semi_minor <= NEGLIGIBLE * path.semi_major:
        if bearing == 0:
            return _("vertical")
        return _("horizontal") if abs(bearing) == 90 else _("along a line at {bearing}°", **values)
    if path.semi_major - path.semi_minor <= NEGLIGIBLE * path.semi_major:
        if path.sense > 0:
            return _("rotating with the crankshaft")
        return _("rotating against the crankshaft")
    values["ratio"] = f"{path.semi_minor / path.semi_major:.3g}"
    if path.sense > 0:
        return _("on an ellipse {ratio}:1 at {bearing}°, with the crankshaft", **values)
    return _("on an ellipse {ratio}:1 at {bearing}°, against the crankshaft", **values)
