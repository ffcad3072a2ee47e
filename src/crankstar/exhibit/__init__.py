"""What the page shows of an engine, as records that are sent to it.

| module | one line |
|---|---|
| `library` | all that a file or a notebook must have with it, packed |
| `exhibits` | Engine -> Exhibit, Exhibition; the engine with what the verdict recommends |
| `figures` | a figure as a compiled Vega specification, a derivation as HTML, by key |
| `keys` | which figures and derivations an engine has |
| `numbers` | vectors of every order, the table of orders, the free response |
| `tellings` | tables made for the terminal as plain records |
| `scene` | Engine -> Scene: what stands where |
| `gears` | gear wheels between shafts |
| `crankshafts` | pins, webs, rods side by side, weights on webs |
| `proportions` | bores, lengths and radii that a drawing needs, given or assumed |
| `records` | Exhibition, Exhibit and what they consist of |
"""

from crankstar.exhibit.exhibits import exhibit, exhibition, fitted

__all__ = ["exhibit", "exhibition", "fitted"]
