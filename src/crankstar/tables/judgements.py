"""What firing orders are judged by, in words: stress, bearing load, the mode that twists."""

from __future__ import annotations

from typing import TYPE_CHECKING

from crankstar.analysis.document import Column
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number, unit_text
from crankstar.language.shown_units import quantity_text
from crankstar.studies.judged_orders import UNITS, Judge

if TYPE_CHECKING:
    from crankstar.dynamics.torsion_modes import Mode

JUDGED = {"stress": N_("shear stress"), "bearings": N_("load on a main bearing")}
JUDGEMENTS = {
    "stress": N_(
        "shear stress: the greatest of torsion over the cycle, all orders with their phases, over "
        "the speeds of the engine."
    ),
    "bearings": N_(
        "load on a main bearing: the greatest over the cycle, of gas and inertia, on any of them."
    ),
}


def judge_column(judge: Judge) -> Column:
    """The column of what orders are judged by."""
    return Column(_(JUDGED[judge]), UNITS[judge], key=judge, fixed=judge == "stress")


def judge_text(judge: Judge, value: float) -> str:
    """What an order is judged by, in words: shear stress 102.9 MPa."""
    size = quantity_text(value, UNITS[judge])
    if judge == "stress":  # a pressure may be shown in bar, a stress is not
        size = f"{number(value)} {unit_text('MPa')}"
    return _("{name} {value}", name=_(JUDGED[judge]), value=size)


def mode_sentence(mode: Mode) -> str:
    """Which mode of the engine's own gives the cylinders their amplitudes."""
    return _(
        "Amplitudes of the cylinders: mode {mode} of the crankshaft, {frequency} Hz, 1 at the "
        "largest.",
        mode=mode.number,
        frequency=number(mode.frequency, digits=4),
    )
