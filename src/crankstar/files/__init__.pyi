"""The public names of the room, each loaded on first use."""

from .changes import changed as changed, keys_of as keys_of
from .errors import EngineFileError as EngineFileError
from .read import engine_of as engine_of
from .rewritten import rewritten as rewritten, rewritten_by_parts as rewritten_by_parts
from .source import read_file as read_file, read_tree as read_tree, tree_of as tree_of
from .write import (
    explicit as explicit,
    part_by_part as part_by_part,
    schema as schema,
    toml as toml,
    tree_text as tree_text,
)
