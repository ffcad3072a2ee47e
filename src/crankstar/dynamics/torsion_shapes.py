"""The shape of a mode as the amplitude of each cylinder: what weighs their gas torque in it.

A mode turns the throw of cylinder j by a_j. The first modes of a drive line may turn the whole
crankshaft as one against a propeller, a gearbox or a soft damper ring; the first in which the
crankshaft itself twists is the one that a firing order is chosen for.
"""

from __future__ import annotations

import numpy as np

from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_modes import Mode, torsion_modes
from crankstar.dynamics.torsion_system import TorsionError
from crankstar.engine.engine import Engine

TWISTED = 0.5
"""Share of the largest amplitude by which those of a crankshaft differ where it twists."""


def cylinder_shape(engine: Engine, *, mode: int | None = None) -> tuple[Mode, dict[int, float]]:
    """A mode of an engine with a table [torsion], and its amplitude at each cylinder by number.

    1 at the largest of them, which is positive; without a number the first mode in which the
    crankshaft twists. Raises TorsionError where there is none.

    >>> from crankstar.files.catalog import load
    >>> disc = {"name": "flywheel", "inertia": "1 kg*m^2", "to": "rear", "stiffness": "1 MN*m/rad"}
    >>> own = {"inertia": "0.02 kg*m^2", "stiffness": "0.6 MN*m/rad", "disc": [disc]}
    >>> found, shape = cylinder_shape(load("audi-25-tfsi", changes={"torsion": own}))
    >>> found.number, [round(each, 2) for each in shape.values()]
    (1, [1.0, 0.9, 0.71, 0.44, 0.13])
    """
    chain = torsion_chain(engine)
    modes = torsion_modes(chain)
    shapes = [chain.at_cylinders(each.shape) for each in modes]
    if mode is None:
        twisting = (n for n, shape in enumerate(shapes) if np.ptp(shape) > TWISTED * _most(shape))
        place = next(twisting, None)
        if place is None:
            raise TorsionError("in no mode does the crankshaft itself twist")
    elif 1 <= mode <= len(modes):
        place = mode - 1
    else:
        raise TorsionError(
            "there is no mode {mode}; the chain has {count}", mode=mode, count=len(modes)
        )
    shape = shapes[place]
    if not _most(shape):
        raise TorsionError("mode {mode} leaves all cylinders still", mode=place + 1)
    largest = shape[np.argmax(np.abs(shape))]
    numbers = (cylinder.number for cylinder in engine.cylinders)
    return modes[place], dict(zip(numbers, (shape / largest).tolist(), strict=True))


def _most(shape: np.ndarray) -> float:
    return float(np.abs(shape).max(initial=0.0))
