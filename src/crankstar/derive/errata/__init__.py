"""Errata of the sources: each printed formula beside the derived one, both judged by momentum.

Only the printed formulas are data (`printed.toml`); the right ones are derived on demand.

| module, bottom to top | one line |
|---|---|
| `records` | Erratum, Confirmed |
| `momentum` | one order of the rate of change of momentum, from exact places only |
| `reading` | the wrong formulas as printed, joined with the derived ones |
| `curves` | an erratum over one turn, or over rod lengths |

>>> from crankstar.derive.algebra.typeset import text
>>> [(erratum.text, text(erratum.ours)) for erratum in errata("yamamoto2012")[:2]]
[('4 cos(2θ − π/4)', '0'), ('4 sin(2θ − π/4)', '−4√2 cos 2θ')]
"""

from crankstar.derive.errata.curves import Curves, SeriesErrors, curves, series_errors
from crankstar.derive.errata.reading import confirmed, errata, sources
from crankstar.derive.errata.records import Confirmed, ErrataError, Erratum

__all__ = [
    "Confirmed",
    "Curves",
    "ErrataError",
    "Erratum",
    "SeriesErrors",
    "confirmed",
    "curves",
    "errata",
    "series_errors",
    "sources",
]
