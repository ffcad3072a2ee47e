"""Engine files: TOML or JSON to an Engine and back, the JSON Schema, every fault of a file.

| module, bottom to top | one line |
|---|---|
| `plus_minus` | a value and its tolerance, as texts |
| `units` | text with a unit to an SI number, and back |
| `bare_numbers` | numbers without a unit: what they are counted in, and which are refused |
| `forms` | the short and the explicit form as records |
| `errors` | the error of a file |
| `mistakes` | validation errors as faults; a corrected copy of a tree |
| `sheets` | a tree of keys as the form of a spreadsheet, and back |
| `cells` | the cells of that form to a tree, with every fault |
| `workbook` | that form in an .xlsx file, written and read |
| `read_files` | the files that a command has read, so that it overwrites none |
| `traces` | a measured pressure from the CSV file that an engine file names |
| `kinds` | what a file is that is no engine file, or no list |
| `lists` | a list of values with headings: CSV or spreadsheet |
| `columns` | the columns of a list read as values, every mistake told at once |
| `vibrations` | amplitudes of vibration in a list |
| `parts` | the weighed parts of a cylinder added up to its masses |
| `references` | what bare numbers count in, before and after a change |
| `changes` | values of a tree set by key path |
| `tolerances` | how far each value may be off |
| `typical_tolerances` | tolerances of pistons and rods as published |
| `chains` | a drive line without cylinders from a file of its own |
| `read` | a tree of keys to an Engine, with every fault at once |
| `source` | a file to its text, its tree of keys and its Engine |
| `box` | the ranges of estimated values, and engines at their ends |
| `filling` | values filled in, each with its source and range |
| `estimate` | masses and lengths that a file leaves out |
| `write` | Engines to TOML, the JSON Schema |
| `carried_tolerances` | tolerances carried into the engine part by part |
| `rewritten` | a changed engine in the form of the file it came from |
| `crank_layouts` | layouts for another number of cylinders: the cranks of each kind |
| `rearranged` | a file with another number of cylinders, crank or firing order |
| `starters` | commented files to begin with |
| `catalog` | the engines of the package, and a file or engine by its name |
"""

from crankstar.engine.arguments import late

__getattr__, __dir__, __all__ = late(__name__, __file__)
