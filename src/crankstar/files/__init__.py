"""Engine files: TOML or JSON to an Engine and back, the JSON Schema, sentences for every mistake.

| module | one line |
|---|---|
| `forms` | the short and the explicit form as records |
| `mistakes` | what validation finds, as sentences |
| `read` | text and trees to Engines |
| `write` | Engines to TOML, the JSON Schema |
| `starters` | commented files to begin with |
"""

from crankstar.files.read import STANDARD_INPUT, EngineFileError, Problem, changed, engine_of, keys_of, read, read_tree, tree_of
from crankstar.files.write import explicit, part_by_part, schema, toml, tree_text

__all__ = [
    "STANDARD_INPUT",
    "EngineFileError",
    "Problem",
    "changed",
    "engine_of",
    "explicit",
    "keys_of",
    "part_by_part",
    "read",
    "read_tree",
    "schema",
    "toml",
    "tree_of",
    "tree_text",
]
