"""What the sources got wrong: each printed formula beside ours, the step where it slips, and both judged by momentum.

Bottom to top:

| module | one line |
|---|---|
| `curves` | an erratum over one turn, or over rod lengths: printed, ours, momentum |
| `reading` | `printed.toml`, what the sources print, joined with what we derive |
| `momentum` | the judge: one order of minus the rate of change of momentum, from exact places only |
| `records` | Erratum, Confirmed |

Only what is printed is data; what is right is derived when it is asked for.

>>> from crankstar.derive.typeset import text
>>> [(one.text, text(one.ours)) for one in errata("yamamoto2012")[:2]]
[('4 cos(2θ − π/4)', '0'), ('4 sin(2θ − π/4)', '−4√2 cos 2θ')]
"""

from crankstar.errata.curves import Curves, SeriesErrors, curves, series_errors
from crankstar.errata.reading import claims, confirmed, errata, sources
from crankstar.errata.records import Confirmed, ErrataError, Erratum

__all__ = [
    "Confirmed",
    "Curves",
    "ErrataError",
    "Erratum",
    "SeriesErrors",
    "claims",
    "confirmed",
    "curves",
    "errata",
    "series_errors",
    "sources",
]
