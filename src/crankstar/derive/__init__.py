"""Exact closed forms of inertia forces and couples, derived step by step, order by order.

Engine -> Derivation -> document.

| module, bottom to top | one line |
|---|---|
| `algebra` | exact numbers, formulas and their print |
| `records` | lines and steps, and what documents read |
| `positions` | places along the crankshaft in bore pitches and bank offsets |
| `addition` | cosines added as by hand |
| `bodies` | all parts that push in one order, exactly or in balls |
| `errata` | wrong formulas of the sources beside the right ones |
| `task` | the data and the lines that all steps share |
| `banks` | sums by cylinder, by bank, of all banks, and by crank pin |
| `resultant` | two counter-rotating vectors and their path |
| `real` | the series of the harmonic, its exact value, and newtons |
| `notations` | the letters of different schools |
| `documents` | terminal, LaTeX, Markdown and HTML |
| `chapters` | the results of derivations, as records that print |
| `expansion` | the motion of one piston, from the crank drive to A_2, A_4, A_6 |
| `steps` | one order of an engine, from one cylinder to the resultant |
| `torques` | the inertia torque by order, and the rolling moment |
| `vee_family` | V engines with the bank angle as a letter |
| `families` | closed forms in which a dimension stays a letter |
| `six_signs` | the six signs of balance of a single-shaft engine |
| `cure` | weights on a shaft, with the proof that they leave nothing |
| `exhaust` | the orders of the exhaust, and the proof of those that are zero |
| `firing_sums` | the orders of gas torque that remain, and the proof that others vanish |
| `twist_sums` | how far each order twists a crankshaft in a straight shape |

>>> from crankstar import derivation, load
>>> derivation(load("v8-cross-plane"), 2).zero
True
"""

from crankstar.engine.arguments import late

__getattr__, __dir__, __all__ = late(__name__, __file__)
