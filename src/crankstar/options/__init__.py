"""Options as values: what a command line or a dialog asks for, read from text.

| module, bottom to top | one line |
|---|---|
| `media` | the part of the vocabulary about films and sounds |
| `goals` | the part of the vocabulary about searches |
| `loads` | the part of the vocabulary about operating points |
| `scatter` | the part of the vocabulary about tolerances |
| `shop` | the part of the vocabulary about batches of parts, planes and faults |
| `vocabulary` | every option of every command: what it takes, what it means |
| `names` | the option that an unknown name stands for |
| `refusals` | requests that cannot be met |
| `values` | speeds, orders, angles, settings |
| `points` | points, planes and lengths of an engine, in its units |
| `ranges` | the speeds of --speeds |
| `gas` | a degree of irregularity, mean effective pressures |
| `remedies` | weights, what they minimise, balance shafts |
| `unbalances` | unbalances as a balancing machine shows them |
| `holes` | a hole that is drilled, or the slug in it |
| `numbers` | numbers of the public functions as people give them: speeds, orders, places |
| `cycles` | whether a cycle is one, of the engine beside it |
| `varied` | what a sweep varies and watches, as people give it |
| `arguments` | the arguments of the public functions as people give them |
| `forms` | the form in which a result is written |
| `words` | the options of a search as typed |
| `balancing` | the options of a balance, and the balanced engine |
| `charts` | the options of a figure |
| `search` | the values of the options of a search |
| `shapes` | a shape of torsion: straight, a mode of the engine's own, or numbers |
| `sequences` | goals of a front over stars and firing sequences, as typed |
| `readers` | what the questions of several analyses have in common |
| `sounds` | the speeds and the pipes of a sound |
| `sources` | engines as people name them, with the tree of their file |
"""
