"""A question that is refused: a status and every mistake, in one shape."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from math import isfinite
from typing import Any

from crankstar.language.faults import Fault, sentence, where
from crankstar.language.quoting import one_line

LONGEST = 1000
"""Letters of a sentence that is sent."""
GREATEST_LISTED = 100
"""Greatest number of mistakes listed one by one for a question."""


class Refused(Exception):  # noqa: N818  # it is no error of ours
    """A question that is not answered, and why."""

    def __init__(self, status: int, faults: Iterable[Fault]) -> None:
        self.status = status
        self.faults = [fault._replace(values=_plain(fault.values)) for fault in faults]
        super().__init__(status, self.faults)

    @property
    def body(self) -> bytes:
        """The answer as JSON in ASCII, because a question may hold lone surrogates."""
        shown = self.faults[:GREATEST_LISTED]
        if len(self.faults) > GREATEST_LISTED:
            more = {"count": len(self.faults) - GREATEST_LISTED}
            shown = [*shown, Fault((), "question.more", more)]
        problems = [
            {
                "path": _short(where(fault.path)) if fault.path else "",
                "code": fault.code,
                "values": fault.values,
                "message": _short(said(fault)),
            }
            for fault in shown
        ]
        return json.dumps({"problems": problems}).encode("ascii")


def said(fault: Fault) -> str:
    """The sentence of a fault; options are fields of a question."""
    place = where(fault.path)
    return sentence(fault.code, fault.values, place=place, named=lambda key: f"`{key}`")


def refused(status: int, code: str, *path: str, **values: Any) -> Refused:
    """A refusal of a question for one reason."""
    return Refused(status, [Fault(path, code, values)])


def _plain(value: Any) -> Any:
    """A value as JSON has it, which also goes from process to process; anything else as text."""
    if isinstance(value, Mapping):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(item) for item in value]
    if (
        value is None
        or isinstance(value, str | int)
        or (isinstance(value, float) and isfinite(value))
    ):
        return value
    return one_line(str(value))


def _short(text: str) -> str:
    return one_line(text, longest=LONGEST) if text else ""
