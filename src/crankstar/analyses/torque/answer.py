"""What answers a question of torque, and what that rests on."""

from __future__ import annotations

from dataclasses import dataclass

from crankstar.analyses.torque.question import Question
from crankstar.analysis.assumptions import Answer
from crankstar.analysis.document import Document
from crankstar.dynamics.uneven import Running, driven, flywheel_for
from crankstar.engine.engine import Engine
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.gas_loads import LoadedTorques, torques_at_loads
from crankstar.mechanics.gas_torque import HIGHEST
from crankstar.mechanics.kinetic import mean_inertia, throw_inertia
from crankstar.mechanics.lacking import lacking_keys
from crankstar.mechanics.mechanism import mechanism
from crankstar.options.refusals import RequestError
from crankstar.studies.answers import torques
from crankstar.tables.torque import Wheel, torque_document


@dataclass(frozen=True)
class Torque:
    """A cycle of an engine, how evenly it runs, the flywheel asked for, torques at loads."""

    cycle: Cycle
    running: Running | None
    wheel: Wheel | None
    loads: LoadedTorques | None
    engine: Engine


def compute(engine: Engine, asked: Question) -> Torque:
    """Raises GasError, UnevenError, RequestError where speed or masses are needed and not known."""
    found = _burnt(engine, asked)
    running = driven(engine, found, flywheel=asked.flywheel)
    if running is None and asked.flywheel is not None:
        _needing("--flywheel", engine, found)
    loads = None
    if asked.tangential:
        at = {"point": found.name, "speed": found.speed}
        loads = torques_at_loads(engine, imep=asked.tangential, **at)
    return Torque(found, running, _wheel(engine, found, asked.irregularity), loads, engine)


def _burnt(engine: Engine, asked: Question) -> Cycle:
    return cycle(
        engine,
        point=asked.point,
        speed=asked.speed,
        motored=asked.motored,
        off=asked.off,
        weaker=dict(asked.weaker),
        **asked.load,
    )


def _needing(option: str, engine: Engine, cycle: Cycle) -> None:
    """Refuse what needs speed and masses where they are not known. Raises RequestError."""
    if missing := lacking_keys(engine, cycle.speed):
        raise RequestError(
            "{option} needs {keys}: give it in the engine file or with --set",
            option=option,
            keys=", ".join(missing),
        )


def _wheel(engine: Engine, cycle: Cycle, irregularity: float | None) -> Wheel | None:
    """The flywheel for a degree of irregularity. Raises RequestError."""
    if irregularity is None:
        return None
    _needing("--irregularity", engine, cycle)
    wheel = flywheel_for(engine, cycle, irregularity=irregularity)
    return Wheel(irregularity, wheel, mean_inertia(mechanism(engine)) + throw_inertia(engine))


def document(engine: Engine, found: Torque, asked: Question) -> Document:
    """All of it as tables and sentences."""
    every = [n / 2 for n in range(1, int(2 * HIGHEST) + 1)]
    return torque_document(
        engine,
        found.cycle,
        running=found.running,
        orders=every if asked.orders == "all" else asked.orders,
        wheel=found.wheel,
        loads=found.loads,
    )


def answer(engine: Engine, asked: Question) -> Answer:
    """The figures that it says first."""
    return torques(
        engine,
        lambda each: _burnt(each, asked),
        flywheel=asked.flywheel,
        irregularity=asked.irregularity,
    )
