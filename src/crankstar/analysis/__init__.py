"""An analysis as a record, what reads its question, and all of them by name.

| module, bottom to top | one line |
|---|---|
| `document` | an analysis as tables of values and the remarks around them |
| `tried_values` | the figures of an answer at values within a range |
| `changed_masses` | how the masses of pistons and crankpins are changed, with their weights |
| `changed_rods` | how rods are put beside one another, on knuckle pins, of another length |
| `changed_values` | how one value of an engine is changed |
| `scaled_values` | the same by a factor, with what was estimated by it |
| `assumptions` | what an answer rests on, and how much each of it matters |
| `record` | what every host needs of a capability |
| `registry` | all analyses by name, those of other packages too |
| `reader` | how one value of a question is read |
| `frames` | tables as data frames, grids as data sets |
"""
