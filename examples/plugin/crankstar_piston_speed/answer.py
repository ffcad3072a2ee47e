"""What is computed of the pistons, and how it is shown."""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

from crankstar.analysis.assumptions import Answer
from crankstar.analysis.document import Column, Document, Table
from crankstar.analysis.tried_values import Figures
from crankstar.engine.engine import Engine
from crankstar.options.refusals import RequestError
from crankstar_piston_speed.question import Question


@dataclass(frozen=True)
class PistonSpeed:
    """At a crank speed (rad/s): the mean piston speed, m/s; the acceleration, m/s^2."""

    speed: float
    mean: float
    acceleration: float


def compute(engine: Engine, question: Question) -> PistonSpeed:
    """The first piston: mean speed s omega/pi, and r omega^2 (1 + r/l) at top dead centre.

    The latter of a piston whose axis meets the crankshaft. Raises RequestError without a speed.
    """
    speed = engine.speed if question.speed is None else question.speed
    if speed is None:
        raise RequestError("piston speed needs a crank speed: give --speed or speed in the file")
    cylinder = engine.first
    radius = engine.throw(cylinder).radius
    acceleration = radius * speed**2 * (1 + radius / cylinder.rod_length)
    return PistonSpeed(speed, 2 * radius * speed / pi, acceleration)


def document(engine: Engine, result: PistonSpeed, _question: Question) -> Document:
    """One table of one row, for readers and programs alike."""
    columns = (
        Column("speed", "rpm", key="speed_rpm"),
        Column("mean piston speed", "m/s", key="mean_speed"),
        Column("acceleration at top dead centre", "m/s^2", key="acceleration"),
    )
    row = (result.speed * 30 / pi, result.mean, result.acceleration)
    table = Table("Piston speed", columns, (row,), key="piston_speed")
    return Document(f"{engine.name}: piston speed", (table,), {"engine": engine.name})


def answer(engine: Engine, question: Question) -> Answer:
    """The figures that assumptions of the file move: the mean speed, m/s."""

    def figures(each: Engine) -> Figures:
        return {("mean piston speed", None): compute(each, question).mean}

    del engine
    return Answer(figures=figures, unit=lambda _quantity, _engine: "m/s")
