"""What is asked of strokes: nothing beyond the engine."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Question:
    """The strokes of all cylinders."""
