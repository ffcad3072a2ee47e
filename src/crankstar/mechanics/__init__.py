"""The excitation: force, couple, moment and torque of the moving parts, by order.

| module, bottom to top | one line |
|---|---|
| `mechanism` | an engine, or a batch of engines, as arrays of numbers |
| `harmonics` | the motion of unit masses at pistons, rods and big ends, as harmonics |
| `excitation` | the laws: force, couple, moment and torque of every part at 1 rad/s; roll |
| `pin_loads` | what each piston pushes sideways on its cylinder, and each rod on its crank pin |
| `batches` | the sums of a whole batch of engines in bounded memory |
| `labelled` | spectra with labels: rows of amplitudes, pandas data frames, xarray data sets |
| `balance` | the labelled record of an excitation, in N and N m or in units of m r w^2 |
| `bounds` | greatest values and peaks, with what bounds them where ranges are made |
| `remains` | what remains of a balance: zero, negligible or worth a cure |
"""
