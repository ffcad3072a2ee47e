"""Each analysis as a `Document` of tables, rendered once for every reader.

| module, bottom to top | one line |
|---|---|
| `cells` | values and headings as text |
| `conversion` | a Table in the units of the context |
| `terminal` | a Document in a terminal of a given width |
| `html` | a Document as HTML |
| `machine` | a Document as JSON, a Table as CSV |
| `spreadsheet` | a Document as a spreadsheet (.xlsx) |
| `arrow` | a Table as an Apache Arrow table |
| `hulls` | how far convex hulls of amplitudes are from zero |
| `tops` | what is great in a table, beside which a difference is rounding |
| `moved_figures` | the figure that an assumption moves most, in words |
| `assumptions` | what an answer rests on, as sentences |
| `resting_derivations` | what the newtons of a derivation rest on |
| `number_ranges` | the range of a number or an amplitude that rests on estimates |
| `laid` | documents and sentences of several engines laid upon each other, with ranges |
| `ranges` | analyses of estimated engines: each number with its range |
| `estimates` | what `estimate` fills in |
| `headings` | an engine's lines: cycle, cylinders, rotation, firing order |
| `scales` | the units in which an engine is written |
| `drilling` | what to drill or which slugs to fit |
| `conditions` | speed, units and point of reference of an analysis |
| `bobweights` | the bobweight of each pin, and how far it is from that of one half |
| `paths` | names of vectors and of their paths |
| `peaks` | peaks over a turn, and what counterweights can remove |
| `by_order` | force, couple and moments of each order |
| `balance_orders` | the orders of a Balance for machines |
| `amplitudes` | amplitudes for machines, one row each |
| `mount_places` | the mounts of an engine file, as they are given |
| `engines` | an engine's parts, the sources of its values, the catalog |
| `judgements` | what firing orders are judged by, in words |
| `search_stars` | the stars of a search |
| `sequence_verdicts` | where an order stands beside a front over stars and firing orders |
| `search_sequences` | the front over crank stars and firing orders |
| `uneven_angles` | uneven angles of a star |
| `field_names` | the values of an engine file in words |
| `sweep_ranges` | the ranges of a sweep of an estimated engine |
| `sweep_notes` | what is said below a sweep |
| `sweeps` | a sweep and its best value |
| `pair_sweeps` | a sweep of two numbers, its best pairs and its front |
| `over_speeds` | amplitudes over the speed |
| `certificate` | the best weights and their lower bound |
| `cures` | what removes the remaining forces and couples |
| `gas_rolls` | the rolling moment on the block with gas, by which its remedies are judged |
| `roll_cures` | the rolling moment that is left, and what would remove it |
| `gas_words` | operating points, and what does not burn, in words |
| `torque_orders` | gas and inertia torque and the roll of the block by order |
| `torque_parts` | side thrust, uneven forces and handbook harmonics |
| `meshes` | gears between crankshafts: what each mesh passes on |
| `torque` | gas torque by order, the cycle and what is assumed, uneven running |
| `mount_points` | how the named points of a block shake |
| `turning` | what turns with the crankshaft: moving parts, weights of the file, new ones |
| `placings` | the places of balance shafts, and what they leave of the roll |
| `remedies` | the balancing sheet |
| `vector_sentences` | force and couple as sentences: what remains, and how it moves |
| `summary` | how an engine shakes, in ten lines |
| `analysis` | force, couple and moments by order, as `analyze` shows them |
| `compared_speeds` | at which speed each of several engines is computed, and why |
| `gas_comparison` | the gas torque of several engines |
| `comparison` | several engines side by side |
| `notebook` | how a notebook shows an Engine and a Balance |
"""
