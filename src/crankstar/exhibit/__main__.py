"""Prints the JSON Schema of what is sent to the front-end, from which its types are made (`make types`)."""

import json
import sys

from pydantic.json_schema import models_json_schema

from crankstar.exhibit.records import Exhibition, Problem

SENT = (Exhibition, Problem)


def schema() -> dict[str, object]:
    """Definitions of all that is sent, and an Exhibition as the root."""
    _, made = models_json_schema([(record, "serialization") for record in SENT], ref_template="#/$defs/{model}")
    return {**made["$defs"]["Exhibition"], "$defs": made["$defs"]}


def untitled(value: object) -> object:
    """The schema without the titles of single keys, which would each become a type of its own."""
    if isinstance(value, dict):
        return {key: untitled(item) for key, item in value.items() if not (key == "title" and isinstance(item, str))}
    return [untitled(item) for item in value] if isinstance(value, list) else value


if __name__ == "__main__":
    sys.stdout.write(json.dumps(untitled(schema())))
