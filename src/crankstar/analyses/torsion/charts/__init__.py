"""The charts of torsional vibration.

| module, bottom to top | one line |
|---|---|
| `words` | what charts of torsion say, and why there are none |
| `mode_shapes` | the shapes of torsional modes along the chain |
| `campbell_diagrams` | natural frequencies and orders over the speed |
| `responses` | torsional vibration over the speed |
| `stars` | the vectors of the cylinders of an order in a mode |
"""
