"""What cannot be answered: a status and every mistake of the question, in the same shape whatever was wrong."""

from __future__ import annotations

import json
from collections.abc import Iterable

from crankstar.quantity import one_line

Told = tuple[str, str]
"""Where in the question, and what would be right."""
LONGEST = 1000
"""Letters of a sentence that is sent."""
GREATEST_TOLD = 100
"""Mistakes of one question that are told one by one."""


class Refused(Exception):  # noqa: N818  # it is no error of ours
    """A question that is not answered, and why."""

    def __init__(self, status: int, problems: Iterable[Told]) -> None:
        self.status = status
        self.problems = [(str(path), str(message)) for path, message in problems]
        super().__init__(status, self.problems)

    def __reduce__(self) -> tuple[type[Refused], tuple[int, list[Told]]]:
        """It goes from process to process."""
        return Refused, (self.status, self.problems)

    @property
    def body(self) -> bytes:
        """The answer as JSON, in ASCII: what was asked may hold half letters that cannot be written otherwise."""
        shown = [{"path": _short(path), "message": _short(message)} for path, message in self.problems[:GREATEST_TOLD]]
        if len(self.problems) > GREATEST_TOLD:
            shown.append({"path": "", "message": f"... and {len(self.problems) - GREATEST_TOLD} more"})
        return json.dumps({"problems": shown}).encode("ascii")


def refused(status: int, message: str) -> Refused:
    """A refusal of a question as a whole."""
    return Refused(status, [("", message)])


def _short(text: str) -> str:
    return one_line(text, longest=LONGEST) if text else ""
