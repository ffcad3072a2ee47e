"""Exact closed forms and step-by-step derivations of the inertia forces and couples of an engine, order by order.

Bottom to top:

| module | one line |
|---|---|
| `documents` | chapters for the terminal, as LaTeX, Markdown, HTML |
| `cure` | what weights on a shaft take away, in closed form, and the proof that nothing is left |
| `notations` | the letters of this project, of the V8 pages, of Sinitsyn |
| `families` | closed forms with a dimension left open: bank angle, crank phase, number of cylinders |
| `six_signs` | the six signs of balance |
| `steps` | Engine -> Derivation: from one cylinder to the resultant |
| `pins` | the same sum pin by pin |
| `task` | what every step knows, and the lines they have in common |
| `resultant` | closed forms of the whole engine, their ellipse, the force of the real engine |
| `gather` | cosines added up as by hand: in phase, in pairs that cancel, in closed polygons |
| `records` | Derivation, Chapter, Step, Line |
| `bodies` | what each part does in one order, exactly or in balls |
| `positions` | places along the crankshaft as linear forms in the bore pitch a and the bank offset b |
| `wave` | signals whose amplitude is a linear form of exact numbers; as few cosines as there can be |
| `enclosure` | harmonics of any rod to fifty digits, with a proved bound |
| `radical` | exact numbers in the shortest form: radicals, arctangents, else enclosed decimals |
| `typeset` | formulas in text, LaTeX and MathML |
| `formula` | formulas as trees that can be evaluated |
| `cyclotomic` | the fields Q(zeta_N): exact arithmetic, exact zeros, also of whole batches |
| `meant` | doubles as the rational numbers they were meant to be |

>>> from crankstar import load
>>> derivation(load("v8-cross-plane"), 2).zero
True
"""

from crankstar.derive.cure import Cure, cure
from crankstar.derive.families import family
from crankstar.derive.records import Chapter, Derivation, DerivationError, Line, Step
from crankstar.derive.six_signs import Sign, signs, signs_chapter
from crankstar.derive.steps import derivation

__all__ = [
    "Chapter",
    "Cure",
    "Derivation",
    "DerivationError",
    "Line",
    "Sign",
    "Step",
    "cure",
    "derivation",
    "family",
    "signs",
    "signs_chapter",
]
