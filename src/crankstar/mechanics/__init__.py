"""The excitation: what moving parts and gas do to block and crankshaft, by order.

| module, bottom to top | one line |
|---|---|
| `mechanism` | an engine, or a batch of engines, as arrays of numbers |
| `harmonics` | the motion of unit masses at pistons, rods and big ends, as harmonics |
| `excitation` | the laws: force, couple, moment and torque of every part at 1 rad/s; roll |
| `pin_loads` | what each piston pushes sideways on its cylinder, and each rod on its crank pin |
| `batches` | the sums of a whole batch of engines in bounded memory |
| `labelled` | spectra with labels: rows of amplitudes, pandas data frames, xarray data sets |
| `balance` | the labelled record of an excitation, in N and N m or in units of m r w^2 |
| `bounds` | greatest values and peaks, with what bounds them where ranges are made |
| `kinetic` | the inertia of the moving parts that the crankshaft feels, over its angle |
| `chain_inertia` | what turns beside pistons and rods: of the drive, else of the chain |
| `lacking` | what a file lacks for newtons and uneven running, key by key |
| `charge_air` | the air of a charge, its fuel, the charge pressure that a load needs |
| `friction` | friction mean effective pressure by published correlations |
| `ideal_cycles` | Otto, Diesel and limited pressure |
| `heat_release` | a finite heat release by Wiebe's function; gas exchange |
| `real_gas` | the same with gamma of the temperature and heat to the walls |
| `operating_points` | the values of an operating point, given or assumed |
| `roots` | where a function is nought |
| `gas_traces` | when valves act, and the charge that a measured pressure shows |
| `maxima` | where curves on a grid have their maxima and cross their limits |
| `pressures` | the pressure at one operating point, with the heat that gives its load |
| `gas` | the pressure in every chamber over a cycle |
| `gear_wheels` | gear wheels between crankshafts: which meshes with which, and how large |
| `central_rods` | rods of one crankpin in one plane, and where there are more than can be |
| `mass_doubts` | masses and sizes that hardly any engine has, whatever its gas and speed |
| `magnitudes` | values out of all proportion to the engine they are of |
| `stiffness_doubts` | stiffnesses of crankshafts with which hardly any engine turns |
| `usual_values` | values of combustion, oil and materials that hardly any engine has |
| `doubts` | values that hardly any engine has: slips of unit and of thought |
| `gas_torque` | gas torque of every chamber by order; the roll of the block with it |
| `external_moments` | force and moment of each order about a point, over the power |
| `guide_moments` | how the side thrusts rock and twist the frame: H and X by order |
| `gas_loads` | gas torque at many loads, and over the speed |
| `exhaust_pulses` | pulses of the exhaust with the pressure of the cycle, by order |
| `side_thrust` | how hard each piston presses on its wall over a cycle |
| `gas_pins` | what gas puts on crank pins and walls, by order |
| `phase_sums` | sums of vibrations of unknown phase: worst, typical, exceeded so often |
| `occurring_orders` | which orders an engine can have at all; the refusal of others |
| `remains` | what remains of a balance: zero, negligible or worth a cure |
"""
