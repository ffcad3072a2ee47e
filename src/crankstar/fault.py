"""What is wrong with an engine: each fault with its place, and the words to say it in."""

from __future__ import annotations

import re
from typing import NamedTuple

from crankstar.quantity import one_line, seen


class Fault(NamedTuple):
    """One thing wrong with an engine: where (keys and indices, as in an engine file), what, and what would be right.

    `cylinder` is the number of the one cylinder it is about, since a short file lists its cylinders in another way.
    """

    path: tuple[str | int, ...]
    message: str
    cylinder: int | None = None


class EngineError(ValueError):
    """An engine that cannot be; carries every fault found, not only the first."""

    def __init__(self, faults: list[Fault]) -> None:
        self.faults = faults
        super().__init__("\n".join(f"{where(fault.path)}: {fault.message}" for fault in faults))


def where(path: tuple[str | int, ...]) -> str:
    """A key path as text, indices counting from one.

    >>> where(("shaft", 0, "throw", 2, "radius")), where(("provenance", "cylinder.bore"))
    ('shaft[1].throw[3].radius', 'provenance."cylinder.bore"')
    """
    text = ""
    for key in path:
        text += f"[{key + 1}]" if isinstance(key, int) else f"{'.' if text else ''}{_key(key)}"
    return text or "the file"


def _key(key: str) -> str:
    """A key as TOML writes it: quoted where it holds anything but letters, digits, - and _."""
    return one_line(key, longest=60) if re.fullmatch(r"[A-Za-z0-9_-]+", key) else seen(key)


def counted(count: int, name: str) -> str:
    """A number of things: `1 angle`, `2 angles`."""
    return f"{count} {name}" + ("" if count == 1 else "s")


def cylinders(numbers: list[int]) -> str:
    """Cylinders by their numbers: `cylinder 3`, `cylinders 3, 4`."""
    return f"cylinder{'' if len(numbers) == 1 else 's'} {listed(numbers)}"


def listed(numbers: list[int]) -> str:
    """Numbers with commas, the middle of a long row left out."""
    if len(numbers) > 12:
        return ", ".join(map(str, numbers[:10])) + f", ... ({len(numbers)} in all)"
    return ", ".join(map(str, numbers))
