"""Exact closed forms of inertia forces and couples, derived step by step, order by order.

Engine -> Derivation -> document.

| module, bottom to top | one line |
|---|---|
| `algebra` | exact numbers, formulas and their print |
| `records` | lines and steps, and what documents read |
| `positions` | places along the crankshaft in bore pitches and bank offsets |
| `addition` | cosines added as by hand |
| `bodies` | all parts that push in one order, exactly or in balls |
| `errata` | wrong formulas of the sources beside the right ones |
| `task` | the data and the lines that all steps share |
| `banks` | sums by cylinder, by bank, of all banks, and by crank pin |
| `resultant` | two counter-rotating vectors and their path |
| `real` | the series of the harmonic, its exact value, and newtons |
| `notations` | the letters of different schools |
| `documents` | terminal, LaTeX, Markdown and HTML |
| `chapters` | the results of derivations, as records that print |
| `expansion` | the motion of one piston, from the crank drive to A_2, A_4, A_6 |
| `steps` | one order of an engine, from one cylinder to the resultant |
| `torques` | the inertia torque by order, and the rolling moment |
| `vee_family` | V engines with the bank angle as a letter |
| `families` | closed forms in which a dimension stays a letter |
| `six_signs` | the six signs of balance of a single-shaft engine |
| `cure` | weights on a shaft, with the proof that they leave nothing |
| `exhaust` | the orders of the exhaust, and the proof of those that are zero |
| `firing_sums` | the orders of gas torque that remain, and the proof that others vanish |
| `twist_sums` | how far each order twists a crankshaft in a straight shape |

>>> from crankstar import derivation, load
>>> derivation(load("v8-cross-plane"), 2).zero
True
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from crankstar.derive.chapters import Chapter, Derivation
    from crankstar.derive.expansion import motion_chapter
    from crankstar.derive.families import family
    from crankstar.derive.firing_sums import gas_orders
    from crankstar.derive.records import DerivationError, Line, Step
    from crankstar.derive.six_signs import Sign, signs, signs_chapter
    from crankstar.derive.steps import derivation
    from crankstar.derive.torques import inertia_torque
    from crankstar.derive.twist_sums import twist_orders

_LATE = {
    "motion_chapter": "expansion",
    "family": "families",
    "gas_orders": "firing_sums",
    "Chapter": "chapters",
    "Derivation": "chapters",
    "DerivationError": "records",
    "Line": "records",
    "Step": "records",
    "Sign": "six_signs",
    "signs": "six_signs",
    "signs_chapter": "six_signs",
    "derivation": "steps",
    "inertia_torque": "torques",
    "twist_orders": "twist_sums",
}
__all__ = [
    "Chapter",
    "Derivation",
    "DerivationError",
    "Line",
    "Sign",
    "Step",
    "derivation",
    "family",
    "gas_orders",
    "inertia_torque",
    "motion_chapter",
    "signs",
    "signs_chapter",
    "twist_orders",
]


def __getattr__(name: str) -> Any:
    """Names are loaded when they are asked for: a search needs the exact algebra alone."""
    if name not in _LATE:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_LATE[name]}"), name)
