"""Options as values: what a command line or a dialog asks for, read from text.

| module, bottom to top | one line |
|---|---|
| `values` | speeds, orders, angles, points of reference, settings |
| `words` | the options of a search as typed |
| `balancing` | counterweights, balance shafts, aims and limits |
| `charts` | the options of a figure, and the format of its file |
| `search` | the values of the options of a search |
"""
