"""The file of --checkpoint as a search begins: what of it is whole, in a sentence if not all is."""

from __future__ import annotations

from pathlib import Path

from crankstar.cli.output import complain
from crankstar.language.messages import _, _n
from crankstar.language.quoting import one_line
from crankstar.stars.checkpoint import Asked, Checkpoint, opened


def kept(path: str | None, question: Asked) -> Checkpoint | None:
    """The checkpoint of a search, if it has a file. Raises SearchError as `opened`."""
    if path is None:
        return None
    found = opened(Path(path), question)
    if found.damaged is None:
        complain(
            _(
                "crankstar: {file} held no whole line; the search starts at the beginning",
                file=one_line(path),
            )
        )
    elif found.damaged:
        complain(
            _n(
                "crankstar: {file}: {count} damaged line was passed over; what is missing is "
                "searched again",
                "crankstar: {file}: {count} damaged lines were passed over; what is missing is "
                "searched again",
                found.damaged,
                file=one_line(path),
                count=found.damaged,
            )
        )
    return found
