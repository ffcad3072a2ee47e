"""An analysis as a record, what reads its question, and all of them by name.

| module, bottom to top | one line |
|---|---|
| `record` | what every host needs of a capability |
| `registry` | all analyses by name, those of other packages too |
| `reader` | how one value of a question is read |
| `readers` | the quantities that several analyses are asked for |
"""
