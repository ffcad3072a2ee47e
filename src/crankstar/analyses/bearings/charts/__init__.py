"""The charts of loads on bearings.

| module, bottom to top | one line |
|---|---|
| `polar_diagrams` | the load on each main bearing or crank pin as a polar diagram |
| `bending` | the bending moment along the crankshaft |
"""
