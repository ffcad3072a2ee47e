"""The shape of torsion that an option names: straight, a mode of the engine's own, or numbers."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from crankstar.engine.engine import Engine
from crankstar.firing.weighing import Shape, twist_shape
from crankstar.options.values import RequestError, fractions, refusal

if TYPE_CHECKING:
    from crankstar.dynamics.torsion_modes import Mode

STRAIGHT = "straight"
MODE = re.compile(r"mode(?:\s*(\d{1,3}))?", re.IGNORECASE)
"""`mode 2`; without a number the first in which the crankshaft twists."""


def mode_shape(text: str | None, engine: Engine) -> tuple[Mode | None, Shape]:
    """The amplitude of each chamber, and the mode where it is one of the engine's own [torsion].

    Without a text the first mode in which the crankshaft twists where the engine has that table,
    else straight. Raises RequestError, and WeighingError where all chambers stand at one place.

    >>> from crankstar.files.catalog import load
    >>> [round(each, 3) for each in mode_shape(None, load("i4"))[1].values()]
    [1.0, 0.333, -0.333, -1.0]
    >>> mode_shape("1, 0.5, 0, -1", load("i4"))[1][2]
    0.5
    """
    words = "" if text is None else text.strip()
    own = mode_asked(words) if words else engine.torsion is not None
    if own:
        return _own(engine, words or "mode")
    if not words or words.lower() == STRAIGHT:
        return None, twist_shape(engine)
    parts = fractions(words, most=200)
    if len(parts) != len(engine.chambers):
        raise refusal(
            "--mode-shape",
            words,
            "give {count} numbers with commas, one for each cylinder",
            count=len(engine.chambers),
        )
    return None, dict(zip(engine.chambers, map(float, parts), strict=True))


def mode_asked(text: str) -> bool:
    """Whether a text names a mode of the engine's own.

    >>> mode_asked("mode 2"), mode_asked("1,0,-1")
    (True, False)
    """
    return MODE.fullmatch(text.strip()) is not None


def _own(engine: Engine, text: str) -> tuple[Mode, Shape]:
    """A mode of the table [torsion]; of a chamber with several pistons their mean amplitude."""
    from crankstar.dynamics.torsion_shapes import cylinder_shape
    from crankstar.dynamics.torsion_system import TorsionError

    match = MODE.fullmatch(text.strip())
    number = match and match.group(1)
    try:
        mode, amplitudes = cylinder_shape(engine, mode=int(number) if number else None)
    except TorsionError as error:
        raise RequestError(f"--mode-shape {text}: {error}") from None
    return mode, {
        chamber: sum(amplitudes[piston.number] for piston in pistons) / len(pistons)
        for chamber, pistons in engine.chambers.items()
    }
