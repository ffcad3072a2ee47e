"""The inverse problem: the arrangement of cranks and the firing order that shake least.

| module, bottom to top | one line |
|---|---|
| `faults` | faults of a search: path, code, values |
| `star` | all ways to set cylinders on evenly spaced throws |
| `sums` | the objectives of a star: vector sums, neighbours in succession |
| `engines` | a star as an Engine |
| `shafts` | throws with one rod or two that fire evenly: star and sequence |
| `vector_sums` | forces, couples and torsion of a shaft with its sequence, and goals |
| `sequence_engines` | a star with its sequence as an Engine, and back |
| `engine_stars` | the stars of a real engine, in newtons |
| `question` | stars, objectives and limits of a search |
| `proof` | exact zeros and equal lengths, in whole numbers |
| `descent` | uneven angles as an optimisation |
| `angles` | uneven throw angles and their cost |
| `arrays` | a question as arrays, buffers, output and state |
| `compiling` | compiled loops, the only module that imports numba |
| `arrangements` | compiled loops over one half of the shaft |
| `kernels` | compiled loops over pairs of halves |
| `halves` | a question as two halves of the shaft, in blocks |
| `results` | stars found, merged in any order |
| `regions` | where to search, and when that proves the answer |
| `work` | one range of blocks |
| `interrupts` | signals kept away from critical code |
| `progress` | how far a search has come |
| `estimates` | time and memory of a search |
| `executors` | threads and processes of this machine, a cluster |
| `checkpoint` | a search kept in a file |
| `distribution` | parts handed out, those of lost workers once more |
| `run` | a search from beginning to end |
| `answer` | stars, exact zeros, their number, proof of completeness |
| `equivalence` | stars with the same moments |
| `sequence_arrays` | records of the loops over stars and sequences |
| `sign_kernels` | compiled loops over signs, by halves |
| `sequence_kernels` | compiled loops over stars and the firing sequences of each |
| `sequence_tables` | such a question as arrays |
| `sequence_rows` | orders found, merged in any sequence |
| `sequence_work` | the stars in parts, and the work on one |
| `sequence_fronts` | the front over stars and sequences, and what beats an order |
| `uneven_sequences` | uneven angles of a star with its firing sequence |
| `options` | options of a search as values, and its question |
"""
