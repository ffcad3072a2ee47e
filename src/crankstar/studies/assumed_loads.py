"""What an answer leaves out of the load of an engine: its reaction, its course, its exponent."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from crankstar import spectra
from crankstar.analysis.assumptions import Assumption, Moved
from crankstar.engine.drive import Drive
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.gas_torque import added


def of_load(
    engine: Engine, found: Cycle | None, *, on_frame: bool = False, running: bool = False
) -> Iterator[Assumption]:
    """What is left out of the load in the rolling moment of a cycle, and in uneven running.

    The reaction on the block unless that is a frame with what is driven (`on_frame`); of an engine
    that is driven the course, and where `running` is told the exponent. `engine` and `found` are as
    the figures have them, with their faults.

    >>> from crankstar import cycle, load
    >>> course = {"load_torque": [2, 0], "load_angle": ["0 deg", "360 deg"], "load_exponent": 2}
    >>> five = load("audi-25-tfsi", changes={"drive": course})
    >>> both = cycle(five, imep="9 bar"), cycle(five, motored=True)
    >>> for each in both:
    ...     print([(own.path, own.moved is None) for own in of_load(five, each, running=True)])
    [('drive.load_torque', False)]
    [('drive.load_torque', True), ('drive.load_exponent', True)]
    """
    from crankstar.dynamics.uneven import takes_work

    drive = engine.drive or Drive()
    if found is None or not (drive.load_torque or drive.load_exponent):
        return
    if takes_work(found):
        if drive.load_torque and not on_frame:
            yield _reaction(engine, found)
        return
    if drive.load_torque:
        reason = N_("gas and friction leave no work that the load could take")
        yield Assumption("left out", "drive.load_torque", reason, explained=True)
    if drive.load_exponent and running:
        reason = N_("the engine is driven, by a torque that is taken as steady")
        yield Assumption("left out", "drive.load_exponent", reason, explained=True)


def of_load_on_shaft(engine: Engine, found: Cycle | None) -> Iterator[Assumption]:
    """The course of the load, which does not twist the crankshaft of a cycle: it has no place.

    >>> from crankstar import cycle, load
    >>> course = {"load_torque": [2, 0], "load_angle": ["0 deg", "360 deg"]}
    >>> five = load("audi-25-tfsi", changes={"drive": course})
    >>> [own.path for own in of_load_on_shaft(five, cycle(five, imep="9 bar"))]
    ['drive.load_torque']
    """
    if found is not None and engine.drive is not None and engine.drive.load_torque:
        reason = N_("gas and inertia alone twist the shafts; where the load acts is not said")
        yield Assumption("left out", "drive.load_torque", reason, explained=True)


def _reaction(engine: Engine, found: Cycle) -> Assumption:
    """The reaction of a load with a course, which a file does not say the frame of."""
    from crankstar.dynamics.load_reaction import load_reaction
    from crankstar.studies.gas_results import roll_of

    reaction = load_reaction(engine, found)
    assert reaction is not None  # noqa: S101  # its load has a course, and takes work
    roll = roll_of(engine, found)
    both = added(roll, reaction)
    alone, sizes = (
        np.abs(spectra.amplitude(spectra.selected(each, both.orders))) for each in (roll, both)
    )
    most = int(np.argmax(np.abs(sizes - alone)))
    top = max(float(sizes.max()), float(alone.max()))
    change = Moved(
        "roll", float(both.orders[most]), "N*m", float(alone[most]),
        float(sizes[most]), float(sizes[most]),
        float(abs(sizes[most] - alone[most])) / top if top else 0.0,
    )  # fmt: skip
    return Assumption(
        "left out", "drive.load_torque",
        N_(
            "its reaction is not in the rolling moment; it acts on the block only where the driven "
            "machine is fixed to the same frame"
        ),
        moved=change,
    )  # fmt: skip
