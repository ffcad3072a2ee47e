"""What is asked of faults, and how they are typed."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, NamedTuple

from crankstar.analysis.reader import Reader
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import MASS
from crankstar.files import units
from crankstar.options import readers
from crankstar.options import values as request
from crankstar.options.gas import gas_orders, share
from crankstar.options.refusals import RequestError, each, refusal

if TYPE_CHECKING:
    from crankstar.studies.fault_kinds import Fault

HEAVIER = {"piston": "piston", "big_end": "big_end", "big-end": "big_end", "rod": "big_end"}
"""The parts that may be heavier by their names."""
OPTIONS = ("cut", "weaker", "heavier", "lost_weight")
"""The fields that name faults, cylinders first."""


class Heavier(NamedTuple):
    """A part that is heavier: `piston` or `big_end`, the number of its cylinder, by how many kg."""

    part: str
    cylinder: int
    mass: float


class Lost(NamedTuple):
    """A weight that is lost: its number, the share that is lost, its shaft or the first one."""

    number: int
    share: float
    shaft: str


def _cut(text: str) -> list[int]:
    """Numbers of cylinders, each once. Raises RequestError."""
    parts = request.listed(text)
    if not parts or any(not part.isdecimal() or len(part) > 4 for part in parts):
        raise refusal("--cut", text, "give numbers of cylinders, as in 2,3")
    return [int(part) for part in dict.fromkeys(parts)]


def _heavier(texts: Sequence[str]) -> list[Heavier]:
    """Raises RequestError."""
    out: list[Heavier] = []
    for text in texts:
        match = re.fullmatch(r"\s*([a-z_-]+)[.\s](\d{1,4})\s*=\s*(.+)", text, re.IGNORECASE)
        part = None if match is None else HEAVIER.get(match[1].lower())
        if match is None or part is None:
            raise refusal(
                "--heavier", text, "give a part, its cylinder and a mass, as in piston.3=20g"
            )
        if units.is_bare(match[3]):
            raise refusal("--heavier", text, "write the mass with a unit, such as 20g")
        with request.reading("--heavier"):
            mass = units.si(match[3], MASS)
        out.append(Heavier(part, int(match[2]), mass))
    return out


def _lost(texts: Sequence[str]) -> list[Lost]:
    """Raises RequestError."""
    out: list[Lost] = []
    for text in texts:
        match = re.fullmatch(r"\s*(?:(.+)\.)?(\d{1,4})\s*(?:=\s*(.+))?", text)
        if match is None:
            raise refusal("--lost-weight", text, "give the number of a weight, as in 2 or 2=30%")
        whole = match[3] is None
        size = 1.0 if whole else share("--lost-weight", text, match[3].strip())
        out.append(Lost(int(match[2]), size, match[1] or ""))
    return out


@dataclass(frozen=True)
class Question:
    """Which faults, at which speed (rad/s) and point, where on the block (m), of which orders."""

    cut: Annotated[Sequence[int], Reader("--cut", _cut)] = ()
    weaker: Annotated[Sequence[tuple[int, float]], readers.WEAKER] = ()
    heavier: Annotated[Sequence[Heavier], Reader("--heavier", _heavier)] = ()
    lost_weight: Annotated[Sequence[Lost], Reader("--lost-weight", _lost)] = ()
    speed: Annotated[float | None, readers.SPEED] = None
    point: Annotated[str, readers.POINT] = ""
    at: Annotated[tuple[float, float, float] | None, readers.AT] = None
    orders: Annotated[
        Sequence[float] | None, Reader("--orders", gas_orders, "Default: up to 6, with halves.")
    ] = None

    @property
    def faults(self) -> list[Fault]:
        """All of them, cylinders first."""
        return [fault for option in OPTIONS for fault in self.faults_of(option)]

    def faults_of(self, option: str) -> list[Fault]:
        """Those of one of OPTIONS."""
        from crankstar.studies.fault_kinds import Fault

        if option == "cut":
            return [Fault("combustion", number) for number in self.cut]
        if option == "weaker":
            return [Fault("combustion", number, lost) for number, lost in self.weaker]
        if option == "heavier":
            return [
                Fault("piston" if own.part == "piston" else "big_end", own.cylinder, own.mass)
                for own in self.heavier
            ]
        return [Fault("weight", own.number, own.share, own.shaft) for own in self.lost_weight]

    def position(self, engine: Engine) -> tuple[float, float, float] | None:
        """The point of the block whose velocity is computed, the first of the file unless named.

        Up, right, along; m. None is the centre of mass.
        """
        points = () if engine.block is None else engine.block.points
        return points[0].place if self.at is None and points else self.at


def refuse(engine: Engine, question: Question) -> None:
    """Refuse no faults, and what an engine cannot have.

    Raises RequestError, DiagnosisError, GasError.
    """
    from crankstar.mechanics.occurring_orders import check_orders
    from crankstar.mechanics.operating_points import operating_state
    from crankstar.studies.single_faults import check_faults, fired

    def check_all() -> None:
        if not question.faults:
            raise RequestError(
                "name a fault: --cut 3, --weaker 3=20%, --heavier piston.3=20g or --lost-weight 2"
            )
        check_faults(engine, question.faults)
        gas = fired(engine, question.faults).gas is not None or bool(question.point)
        check_orders(engine, question.orders or (), gas=gas)

    each(
        *(
            lambda option=option: check_faults(engine, question.faults_of(option))
            for option in OPTIONS
        ),
        lambda: operating_state(engine, point=question.point),
        check_all,
    )
