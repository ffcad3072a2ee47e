"""Studies of an engine: one value varied, many variants at once.

| module, bottom to top | one line |
|---|---|
| `variants` | many variants of an engine at once, as arrays |
| `fields` | the values of an engine file by key path, and the engine as a function of one |
| `ranges` | the values of a sweep, read from text |
| `sweep` | one value of an engine file varied, and what becomes of its quantities |
| `best_value` | the least or greatest of a curve, refined between its points |
"""
