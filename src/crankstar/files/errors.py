"""An engine file that cannot be used, with every fault found in it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from crankstar.language.faults import Fault
from crankstar.language.messages import MessageError, _, _n

GREATEST_SHOWN = 20
"""Faults of one file that are written out one by one."""
SCREEN = 20
"""Lines of 80 letters, after which no further fault is begun."""


class EngineFileError(MessageError):
    """An engine file that cannot be used; `faults` have the key paths of the file."""

    def __init__(self, name: str, faults: Sequence[Fault]) -> None:
        self.name, self.faults = name, list(faults)
        count = len(self.faults)
        lines: list[str] = []
        for fault in self.faults[:GREATEST_SHOWN]:
            if sum(1 + len(line) // 80 for line in lines) < SCREEN:
                lines.append(fault.sentence)
        if count > len(lines):
            lines.append(_("... and {count} more", count=count - len(lines)))
        head = _n(
            "{name}: {count} mistake", "{name}: {count} mistakes", count, name=name, count=count
        )
        super().__init__("\n".join([head, *(f"  {line}" for line in lines)]))

    def __reduce__(self) -> tuple[Any, ...]:
        """It goes from process to process."""
        return EngineFileError, (self.name, self.faults)


def refused(name: str, code: str, **values: Any) -> EngineFileError:
    """The error of a file as a whole."""
    return EngineFileError(name, [Fault((), f"file.{code}", values)])
