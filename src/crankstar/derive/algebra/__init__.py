"""Exact numbers, and formulas as trees with their print.

| module, bottom to top | one line |
|---|---|
| `rational` | doubles as the short fractions behind them |
| `cyclotomic` | the fields Q(zeta_N): exact arithmetic and exact zeros, also in batches |
| `formula` | formulas as trees |
| `evaluation` | their values, in floats or in balls |
| `styles` | a fraction, a root or a power in text, LaTeX and MathML |
| `digits` | the digits of a number that are certain |
| `typeset` | formulas in print |
| `radicals` | exact numbers in their shortest form |
| `enclosure` | harmonics of any rod to fifty digits with a proved bound |
| `wave` | signals of one order, in as few cosines as possible |
"""
