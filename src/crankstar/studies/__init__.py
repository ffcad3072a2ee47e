"""Studies of an engine: one or two values varied, many variants at once, tolerances.

| module, bottom to top | one line |
|---|---|
| `variants` | many variants of an engine at once, as arrays |
| `grids` | engines over two of their numbers at once |
| `numeric_keys` | the key paths of the numbers of a file, and why one cannot be varied |
| `fields` | the values of an engine file by key path, and the engine as a function of some |
| `ranges` | the values of a sweep, read from text |
| `sums` | the sums of batches of engines, over speeds and closed ranges |
| `study` | what is varied, in which units and about which point |
| `gas_results` | torque, roll, pressure and irregularity of each engine of a sweep |
| `assumed_rods` | what is assumed of where rods stand, of their length and of master rods |
| `assumed_masses` | what a file leaves out of the masses that inertia forces come from |
| `gas_ends` | between which ends a value lies that is assumed of a cycle |
| `assumed_gas` | what is assumed of gas and valves, and what gas an answer leaves out |
| `assumed_loads` | what of the load that an engine drives an answer leaves out |
| `gas_alone` | what a file lacks for its gas or the inertia beside it: a bore, masses, a speed |
| `assumed_doubts` | doubts, tried at what may be meant |
| `assumed_values` | what an engine file leaves out or does not give for certain, with its range |
| `figures_by_order` | figures of an answer by order, and their units |
| `answer_parts` | answers about fewer quantities, and several as one |
| `response_answers` | what shakes a block with faults, by figures |
| `answers` | the figures of each analysis, of which the record says how far they may move |
| `load_answers` | the maximum loads of bearings and pins, with what gas would change |
| `chart_answers` | the figures of what charts alone show |
| `judged_orders` | firing orders by the stress and the bearing loads that they make |
| `sweep` | one or two values of an engine file varied, and what becomes of its quantities |
| `sweep_answers` | what the results of a sweep rest on, at one of its values |
| `sweep_doubts` | values of a sweep at which hardly any engine runs, or fires otherwise |
| `best_value` | the least or greatest of a curve, refined between its points |
| `best_pair` | the best pair of two values, and the pairs that none beats in two results |
| `part_weights` | an engine with other weights of its pistons, pins and rods |
| `fault_kinds` | a fault of an engine as a record, in words, for machines |
| `single_faults` | faults of an engine, and what each changes in what shakes its block |
"""
