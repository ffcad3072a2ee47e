"""The analyses, a folder each: what is asked, what computes it, how it is told.

| module, bottom to top | one line |
|---|---|
| `bearings/` | loads on main bearings, crankpins and walls; bending of the crankshaft |
| `diagnose/` | which fault explains measured vibration |
| `fault/` | what a fault changes in what shakes the block |
| `genset/` | how evenly a generating set runs, and several on one foundation |
| `guide/` | the cylinders of an engine in rows of other numbers, with their firing orders |
| `isolate/` | the best mounts within limits |
| `marine/` | external and guide-force moments of a marine engine, and compensators |
| `mounts/` | an engine on its mounts: natural modes, vibration, what the mounts pass on |
| `strokes/` | strokes, valve events, exhaust intervals, cylinders that disturb each other |
| `torque/` | torque of gas and inertia, and how evenly the engine runs |
| `torsion/` | how a crankshaft or a drive line twists |
"""
