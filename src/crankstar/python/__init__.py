"""The Python interface: a function for each analysis, and results that are frames and figures.

| module, bottom to top | one line |
|---|---|
| `resting` | what a result rests on: assumptions that print as sentences |
| `results` | what a function gives: its numbers, tables, arrays, figures |
| `records` | the records of an engine file |
| `sums` | forces, couples and bearing loads at the speed of the file |
| `derivations` | the derivation of an order, with what it rests on |
| `searches` | the search for crank stars, and what it found |
| `functions` | the function of each analysis, its arguments read as people write them |
| `analyses` | the functions of the analyses, with their types in a stub |
| `public` | the other functions, with the types that they read in a stub |
"""
