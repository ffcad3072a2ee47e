"""What answers a question of the best mounts, and what that rests on."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple, cast

from crankstar.analyses.isolate.aims import IsolationAim, aimed
from crankstar.analyses.isolate.free_values import MountLimits
from crankstar.analyses.isolate.isolation import STARTS, Isolation, isolated
from crankstar.analyses.isolate.question import Question
from crankstar.analyses.mounts.figures import on_mounts
from crankstar.analysis.assumptions import Answer, Uses
from crankstar.analysis.tried_values import Figures
from crankstar.dynamics.mount_analysis import MountAnalysis, mounts
from crankstar.dynamics.mount_excitation import mount_excitation
from crankstar.dynamics.mount_modes import mount_modes
from crankstar.dynamics.mount_worst import ROLL, roll_mode
from crankstar.dynamics.mounted_block import mounted_block, settled
from crankstar.engine.engine import Engine
from crankstar.studies.answer_parts import narrowed

UNITS = {
    "force": ("N", 1.0),
    "velocity": ("mm/s", 1e3),
    "rms force": ("N", 1.0),
    "mounts": ("N", 1.0),
    "rms mounts": ("N", 1.0),
    "rms velocity": ("mm/s", 1e3),
    "roll": ("%", 100.0),
}
"""The unit of an aim, and how many of it are in SI."""
AIM_OF = "least "
"""Before an aim: what is minimised, as a quantity of an answer."""
STILL: tuple[Uses, ...] = ("inertia", "mounts")
"""What modes are made of."""


class Isolated(NamedTuple):
    """The best mounts, their limits, and the engine on its mounts before and after."""

    best: Isolation
    limits: MountLimits
    before: MountAnalysis
    after: MountAnalysis


def compute(
    engine: Engine, question: Question, *, tell: Callable[[int, int], None] | None = None
) -> Isolated:
    """The best mounts; `tell` is called after each start. Raises MountError, RemedyError."""
    limits = MountLimits(question.stiffness, question.shift, question.sag, question.frequencies)
    before = _mounted(engine, question)
    best = isolated(
        engine,
        before,
        aim=cast("IsolationAim", question.minimise),
        limits=limits,
        starts=question.starts or STARTS,
        tell=tell,
    )
    return Isolated(best, limits, before, _mounted(best.engine, question))


def _mounted(engine: Engine, question: Question) -> MountAnalysis:
    return mounts(engine, point=question.point, speeds=question.speeds, at=question.at)


def best_engine(result: Isolated) -> Engine:
    """The engine on the best mounts."""
    return result.best.engine


def answer(engine: Engine, question: Question) -> Answer:
    """What the mounts are judged by: the aim first, how far the block sits down, and its modes."""
    aim = cast("IsolationAim", question.minimise)
    found = _mounted(engine, question)
    speeds = None if aim == "roll" or found.over is None else found.asked
    name, (unit, factor) = f"{AIM_OF}{aim}", UNITS[aim]

    def judged(each: Engine) -> tuple[dict[str, float], str]:
        block = mounted_block(each)
        own = None
        if speeds is not None:
            own = mount_excitation(block, each, speeds=speeds, point=question.point)
        modes = mount_modes(block)
        share = float(modes[roll_mode(modes)].energy[ROLL])
        told = {
            name: factor * aimed(block, own, aim, found.point),
            "sag": -1e3 * float(settled(block)[0][0]),
            "roll share": 100 * share,
            **{f"mode {number}": mode.frequency for number, mode in enumerate(modes, 1)},
        }
        return told, "" if own is None else own.without_gas

    def figures(each: Engine) -> Figures:
        return {(quantity, None): size for quantity, size in judged(each)[0].items()}

    if speeds is None:
        whole = Answer(figures=figures, unit=lambda _quantity, _engine: "", uses=STILL)
    else:
        own = on_mounts(
            engine, point=question.point, speeds=question.speeds, at=question.at, judged=judged
        )
        whole = narrowed(own, [*judged(engine)[0]])
    units = {name: unit, "sag": "mm", "roll share": "%"}
    return replace(whole, unit=lambda quantity, _engine: units.get(quantity, "Hz"), aims=(name,))
