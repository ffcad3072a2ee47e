"""Spectra over crank order: periodic vectors in the clock plane, and their greatest values.

| module, bottom to top | one line |
|---|---|
| `spectrum` | a periodic vector as pairs of turning vectors by order |
| `greatest` | the greatest length of periodic vectors over their period |
"""

from crankstar.spectra.greatest import Peak, peak, peaks, tops
from crankstar.spectra.spectrum import (
    ROUNDING,
    Complex,
    Ellipse,
    Real,
    Spectrum,
    amplitude,
    checked,
    distinct,
    ellipse,
    horizontal,
    over_period,
    period,
    real_signal,
    scaled,
    selected,
    shifted,
    stacked,
    total,
    turned,
    value,
    vertical,
)

__all__ = [
    "ROUNDING",
    "Complex",
    "Ellipse",
    "Peak",
    "Real",
    "Spectrum",
    "amplitude",
    "checked",
    "distinct",
    "ellipse",
    "horizontal",
    "over_period",
    "peak",
    "peaks",
    "period",
    "real_signal",
    "scaled",
    "selected",
    "shifted",
    "stacked",
    "tops",
    "total",
    "turned",
    "value",
    "vertical",
]
