"""Prints the JSON Schema of the records that Python and the page exchange, for `make types`."""

from __future__ import annotations

import json
import sys
from typing import Any

from pydantic import BaseModel
from pydantic.json_schema import JsonSchemaMode, models_json_schema

from crankstar.page.records import Exhibition, Problem
from crankstar.page.workshop_records import Preset, SlidersShown, WorkshopShown
from crankstar.server import messages

SENT: tuple[type[BaseModel], ...] = (
    *(Exhibition, Problem, messages.CatalogEntry, messages.DerivationShown),
    *(messages.FittedShown, messages.SearchShown, messages.TomlShown, messages.TreeShown),
    messages.WatchedShown,
    *(Preset, SlidersShown, WorkshopShown),
)
RECEIVED: tuple[type[BaseModel], ...] = (messages.FittedQuestion, messages.SearchQuestion)


def schema() -> dict[str, Any]:
    """The definitions, and a root that has a key for each."""
    models: list[tuple[type[BaseModel], JsonSchemaMode]] = [
        *((record, "serialization") for record in SENT),
        *((record, "validation") for record in RECEIVED),
    ]
    _, made = models_json_schema(models, ref_template="#/$defs/{model}")
    names = [record.__name__ for record, _ in models]
    references = {name: {"$ref": f"#/$defs/{name}"} for name in names}
    return {"type": "object", "properties": references, "required": names, **made}


def untitled(value: Any) -> Any:
    """The schema without the titles of single keys, which would each become a type of its own."""
    if isinstance(value, dict):
        return {
            key: untitled(item)
            for key, item in value.items()
            if not (key == "title" and isinstance(item, str))
        }
    return [untitled(item) for item in value] if isinstance(value, list) else value


if __name__ == "__main__":
    sys.stdout.write(json.dumps(untitled(schema())))
