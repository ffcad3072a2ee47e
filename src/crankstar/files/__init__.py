"""Engine files: TOML or JSON to an Engine and back, the JSON Schema, sentences for every mistake.

| module | one line |
|---|---|
| `forms` | the short and the explicit form as records |
| `mistakes` | what validation finds, as sentences |
| `read` | text and trees to Engines |
| `write` | Engines to TOML, the JSON Schema |
| `starters` | commented files to begin with |
"""

from crankstar.files.read import STANDARD_INPUT, EngineFileError, Problem, engine_of, read, tree_of
from crankstar.files.write import explicit, schema, toml

__all__ = ["STANDARD_INPUT", "EngineFileError", "Problem", "engine_of", "explicit", "read", "schema", "toml", "tree_of"]
