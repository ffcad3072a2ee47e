"""The response of the engine to the excitation.

| module, bottom to top | one line |
|---|---|
| `beams` | how the forces on a crankshaft are shared among its main bearings |
| `bearings` | loads on main bearings and crank pins, the bending moment along a crankshaft |
| `wear` | where journals and pins are pressed most and least |
| `uneven` | the speed of the crankshaft over a cycle, and the flywheel that evens it |
| `uneven_forces` | what the uneven speed changes in force and couple |
| `meshes` | what the gears between crankshafts pass on over a cycle |
| `whirl` | shift, tilt and turn of the free rigid engine, order by order |
| `sound` | the exhaust as a sound: equal pulses through plain pipes |
"""
