"""The engine: records and their checks, quantities, kinematics, layouts, changed copies.

| module, bottom to top | one line |
|---|---|
| `packages` | what other packages add by entry points; what cannot be loaded is told |
| `quantities` | types of values: physical quantities with their units, printable text |
| `cylinder_parts` | the base of all records; a rod, and the parts of a cylinder as weighed |
| `provenance` | where a value comes from, and its range if it is estimated |
| `gas` | the gas in the cylinders: a cycle by few numbers or a measured trace, and loads |
| `drive` | flywheel and load |
| `oil` | sizes of main bearings and crank pins, and their oil |
| `torsion_places` | places of what twists, by name: ends, throws, discs |
| `torsion` | the crankshaft as it twists: inertias, stiffnesses, discs, dampers, pendulums |
| `block` | the whole engine as one rigid body: mass, centre, inertia |
| `mounts` | what the block stands on: mounts, a foundation on springs of its own |
| `records` | the frozen records: shafts, throws, weights, cylinders, rods, valves |
| `assembly` | shafts and cylinders put together, and what follows without motion |
| `basis` | what a layout needs besides angles: name, cycle, firing order, sizes |
| `main_bearings` | main bearings and webs of a crankshaft, given or assumed |
| `valves` | valve and port timing, given or assumed |
| `gas_checks` | loads, traces and drives that can be |
| `fillets` | fillets of a crank throw as ratios, and where they are known |
| `torsion_checks` | chains that can twist |
| `rigid_block` | the six freedoms of a rigid block: how it moves, its mass, its springs |
| `mount_checks` | mounts that hold a block, bodies that can be |
| `checks` | sizes, numbers and references that must fit each other |
| `copies` | changed copies of records, each checked again |
| `motion` | exact motion of pins, rods and pistons, and its harmonics |
| `dead_centres` | top and bottom dead centres of each chamber |
| `firing_angles` | the crank angles at which a firing order fires |
| `volumes` | the volume of each chamber over its working cycle, and its rate |
| `engine` | the Engine: an assembly that passed every check |
| `arguments` | what is no Engine, no number, no list of planes is refused with what to write |
| `crankshafts` | weights, bearings and balance shafts that a short file gives its crankshafts |
| `arrangement` | cylinder places to an Engine: sizes, pins, counterweights |
| `banks` | banks of cylinders and cranks as an engine file gives them |
| `added_layouts` | layouts that other packages add, checked |
| `layouts` | in-line, vee, boxer, radial, tandem, opposed pistons |
| `weighed` | engines whose masses are published |
| `proportions` | masses and lengths that an engine of a type usually has |
"""
