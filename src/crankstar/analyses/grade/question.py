"""What is asked of the balance quality of a rotor."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from typing import Annotated, NamedTuple

from crankstar.analysis.reader import Reader, is_given
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import LENGTH, MASS
from crankstar.options import readers
from crankstar.options import values as request
from crankstar.options.refusals import RequestError, refusal
from crankstar.options.unbalances import Measured, measured


class Rotor(NamedTuple):
    """A rotor: mass [kg], greatest service speed [rad/s], shares of its front and rear bearing."""

    mass: float
    speed: float
    planes: tuple[float, float]


def _grade(text: str) -> float:
    """A balance quality grade in mm/s: 6.3, G6.3 or G 6.3. Raises RequestError."""
    number = text.strip().lower().removeprefix("g").strip().removesuffix("mm/s").strip()
    try:
        value = float(number)
    except ValueError:
        value = -1.0
    if not 0.01 <= value <= 10_000:
        raise refusal("--grade", text, "give a balance quality grade in mm/s, such as 6.3 or G6.3")
    return value


def _distances(text: str) -> tuple[float, float]:
    """Distances of the two bearings from the centre of mass."""
    parts = request.listed(text)
    example = "210 mm, 260 mm"
    if len(parts) != 2:
        raise refusal(
            "--bearing-distances",
            text,
            'give two, front and rear, as in "{example}"',
            example=example,
        )
    front, rear = (request.size("--bearing-distances", part, quantity=LENGTH) for part in parts)
    return front, rear


@dataclass(frozen=True)
class Question:
    """A rotor of a mass (kg) at a speed (rad/s), its bearings at distances (m) from its centre.

    Which unbalance a grade (mm/s) permits, and which grade the measured one meets: of the whole, or
    in the planes of the bearings.
    """

    mass: Annotated[float | None, readers.size("--mass", MASS)] = None
    speed: Annotated[float | None, readers.SPEED] = None
    grade: Annotated[float | None, Reader("--grade", _grade, "Default: the usual ones.")] = None
    bearing_distances: Annotated[
        tuple[float, float] | None, Reader("--bearing-distances", _distances)
    ] = None
    unbalance: Annotated[
        Sequence[Measured] | None,
        Reader("--unbalance", partial(measured, most=2), "Which grade does it meet?"),
    ] = None


def refuse(engine: Engine | None, question: Question) -> None:
    """Refuse a rotor without mass or speed. Raises RequestError."""
    if not is_given(question, "mass"):
        raise RequestError('give the mass of the rotor, as in --mass "28 kg"')
    if not is_given(question, "speed") and (engine is None or engine.speed is None):
        raise RequestError('give the greatest service speed, as in --speed "6000 rpm"')
