"""A question that is refused: a status and every mistake, in one shape."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from math import isfinite
from typing import Any, NamedTuple

from crankstar.language.faults import Fault, sentence, where
from crankstar.language.quoting import one_line


class Told(NamedTuple):
    """A fault of a question: where, the sentence, and its code and values where it has them."""

    path: str
    message: str
    code: str = ""
    values: Mapping[str, Any] = {}


LONGEST = 1000
"""Letters of a sentence that is sent."""
GREATEST_TOLD = 100
"""Greatest number of mistakes listed one by one for a question."""


class Refused(Exception):  # noqa: N818  # it is no error of ours
    """A question that is not answered, and why."""

    def __init__(self, status: int, problems: Iterable[tuple[Any, ...]]) -> None:
        self.status = status
        told = [Told(*problem) for problem in problems]
        self.problems = [each._replace(values=_plain(each.values)) for each in told]
        super().__init__(status, self.problems)

    def __reduce__(self) -> tuple[type[Refused], tuple[int, list[Told]]]:
        """It goes from process to process."""
        return Refused, (self.status, self.problems)

    @property
    def body(self) -> bytes:
        """The answer as JSON in ASCII, because a question may hold lone surrogates."""
        shown = [
            {
                "path": _short(problem.path),
                "code": problem.code,
                "values": dict(problem.values),
                "message": _short(problem.message),
            }
            for problem in self.problems[:GREATEST_TOLD]
        ]
        if len(self.problems) > GREATEST_TOLD:
            more = f"... and {len(self.problems) - GREATEST_TOLD} more"
            shown.append({"path": "", "code": "", "values": {}, "message": more})
        return json.dumps({"problems": shown}).encode("ascii")


def of_faults(status: int, faults: Iterable[Fault]) -> Refused:
    """A refusal with a line for each fault."""
    return Refused(
        status,
        [
            Told(
                where(f.path) if f.path else "",
                sentence(f.code, f.values, place=where(f.path), named=lambda key: f"`{key}`"),
                f.code,
                f.values,
            )
            for f in faults
        ],
    )


def refused(status: int, message: str) -> Refused:
    """A refusal of a question as a whole."""
    return Refused(status, [("", message)])


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
