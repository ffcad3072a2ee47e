"""The response of the engine to the excitation.

| module, bottom to top | one line |
|---|---|
| `beams` | how the forces on a crankshaft are shared among its main bearings |
| `bearings` | loads on main bearings and crank pins, the bending moment along a crankshaft |
| `bearing_variants` | main-bearing loads of many engines at once |
| `wear` | where journals and pins are pressed most and least |
| `oil_film` | the orbit of a journal in its oil, and the least film |
| `uneven` | the speed of the crankshaft over a cycle, and the flywheel that evens it |
| `uneven_doubts` | a drive inertia with which hardly any engine runs |
| `generator_angle` | how far a generator runs ahead of its mean turn and behind it |
| `load_reaction` | what a driven machine does to the frame that it is fixed to |
| `uneven_forces` | what the uneven speed changes in force and couple |
| `meshes` | what the gears between crankshafts pass on over a cycle |
| `crank_stiffness` | the torsional stiffness of a crank throw by published formulas |
| `crank_fillets` | how fillets of a crank throw concentrate stress, and what they bear |
| `torsion_system` | inertias and springs that twist: masses, sections, matrices, pendulums |
| `torsion_chain` | crankshafts, or a drive line, as such a system |
| `torsion_modes` | natural frequencies and shapes of a chain, nodes, Holzer's table |
| `torsion_shapes` | the shape of a mode as the amplitude of each cylinder |
| `torsion_excitation` | the torque of gas and moving parts on each throw; vector sums |
| `torsion_response` | forced vibration over speeds and orders, heat of dampers |
| `torsion_variable` | the same at one speed with the inertia of each crank angle |
| `torsion_criticals` | critical speeds, equilibrium amplitudes, barred speeds |
| `torsion_analysis` | all that is asked of the torsional vibration of an engine or a drive line |
| `torsion_peaks` | the maximum stress of torsion over the speeds |
| `crank_fatigue` | whether the fillets of a crankshaft bear its bending and twist for ever |
| `whirl` | shift, tilt and turn of the free rigid engine, order by order |
| `hand_arm` | the frequency weighting of vibration that goes into the hands |
| `mounted_block` | a rigid block on its mounts and its foundation: masses, springs, dampers |
| `mount_doubts` | stiffnesses of mounts on which hardly any engine stands |
| `mount_modes` | natural modes on the mounts, torque-roll axis, elastic axis |
| `mount_excitation` | what shakes a block on its mounts: inertia and gas on its six freedoms |
| `mount_response` | how it shakes: motion of its points, forces in mounts and on the ground |
| `mount_worst` | the worst of an engine on its mounts over the speeds |
| `mount_analysis` | all that is asked of an engine on its mounts |
| `sound` | the exhaust as a sound: equal pulses through plain pipes |
"""
