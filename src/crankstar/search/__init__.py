"""The inverse problem: which arrangement of cranks, which firing order, so that it shakes least.

| module, top to bottom | one line |
|---|---|
| `weighed` | the stars of a real engine: its places, its sums in newtons |
| `likeness` | all stars with the same moments as one |
| `angles` | uneven angles: couples against free forces and even intervals, a local optimum |
| `vees` | crank and bank together: V engines that fire evenly, with their balance |
| `orders` | firing orders on a given crank: all that fire evenly, at given intervals, or at any |
| `timetable` | every way of giving each chamber a dead centre of its own |
| `numbering` | an engine with another firing order, or with its cylinders numbered otherwise |
| `engines` | a star as an in-line Engine, with the firing order it allows |
| `findings` | the answer: stars with their sums, exact zeros, how many there are, what proves that these are all |
| `run` | a search from beginning to end: stretches handed out, gathered, proved complete |
| `hands` | who does the work: this process, processes of this machine, a cluster |
| `checkpoint` | a search kept in a file, so that it can go on after it was stopped |
| `work` | one stretch of blocks; the same wherever and whenever it is run |
| `strips` | where to look, and when what was found proves the answer complete |
| `harvest` | stars that were found, and how several finds become one |
| `halves` | a question as arrays: two halves of the shaft, blocks, how much work |
| `kernels` | compiled loops; the only user of numba |
| `arrays` | what the compiled loops work on |
| `proof` | zeros and equal lengths of many stars, decided in whole numbers |
| `question` | which stars, judged by what, within which limits, what is asked |
| `sums` | vector sums of a star: forces, couples, torsion; neighbours in succession |
| `stars` | all ways to set cylinders on evenly spaced throws, and how many there are |
"""
