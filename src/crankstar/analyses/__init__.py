"""The analyses, a folder each: what is asked, what computes it, how it is told.

| module, bottom to top | one line |
|---|---|
| `bobweight/` | the card of a crankshaft for its balancer: parts, bobweights, overbalance |
| `correct/` | what to add or to drill in two planes of a rotor |
| `drill/` | which holes to drill, and which slugs to fit |
| `errata/` | the errors of published sources, each formula beside the correct one |
| `grade/` | the unbalance that may remain by ISO 21940-11 |
| `match/` | weighed pistons, pins and rods matched to the cylinders |
| `orders/` | the firing orders that a crank can fire |
| `tolerance/` | how engines built to their tolerances scatter |
| `vees/` | the V angles and splits of pins at which a V engine fires evenly |
| `verdict/` | what an engine does and what would cure it, in sentences |
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
