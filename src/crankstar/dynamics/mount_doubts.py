"""Stiffnesses of mounts on which hardly any engine stands: slips of unit.

Alone on its mounts, still at their feet, a body of mass matrix M and stiffness K has the natural
frequencies f = sqrt(eigenvalues of M^-1 K)/2 pi, and sits down by (K^-1 W) under the weight W.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np

from crankstar.dynamics.mounted_block import SIX, MountedBlock, mounted_block, settled
from crankstar.engine.engine import Engine
from crankstar.engine.mounts import Mount
from crankstar.engine.rigid_block import gathered
from crankstar.language.faults import Fault
from crankstar.spectra import Real

MOST_SAG = 0.1
"""m: coil springs of heavy foundations give way by 25 to 60 mm. Our judgement."""
LOWEST, HIGHEST = 0.5, 100.0
"""Hz: of the slowest mode. Air springs have about 1, mounts of engines 3 to 30. Our judgement."""
UNLIKE = 300.0
"""Stiffness of a mount over that of the middle one: the unit of one is another."""
Path = tuple[str | int, ...]


def mount_doubts(engine: Engine) -> Iterator[Fault]:
    """Mounts on which a body sits down too far, or vibrates too slow or too fast.

    >>> from crankstar.files.catalog import load
    >>> at = [("left", "-0.5 m", "0 m"), ("right", "0.5 m", "0 m"), ("rear", "0 m", "-0.3 m")]
    >>> rubber = [{"name": n, "right": r, "z": z, "stiffness": "50 N/m"} for n, r, z in at]
    >>> own = {"mounts": rubber, "block": {"mass": "150 kg", "z": "0 m"}}
    >>> [fault.code for fault in mount_doubts(load("audi-25-tfsi", changes=own))]
    ['doubt.mount-sag']
    """
    if not engine.mounts:
        return
    block = mounted_block(engine)
    down = settled(block)[0]
    upper, lower = block.mounts[: block.of_block], block.mounts[block.of_block :]
    below = float(down[SIX]) if lower else 0.0
    yield from _doubts(block, ("mounts",), upper, slice(0, SIX), below - float(down[0]))
    if lower:
        path = ("foundation", "mounts")
        yield from _doubts(block, path, lower, slice(SIX, None), -below)


def _doubts(
    block: MountedBlock, path: Path, mounts: Sequence[Mount], body: slice, sag: float
) -> Iterator[Fault]:
    """The first doubt of the mounts of one body, of freedoms `body`, that sits down by `sag` m."""
    sizes = [max(each.along) for each in mounts]
    middle = sorted(sizes)[(len(sizes) - 1) // 2]
    for index, size in enumerate(sizes):
        if size and middle and not 1 / UNLIKE < size / middle < UNLIKE:
            values = _told(size, others=middle * 1e-3)
            yield Fault((*path, index, "stiffness"), "doubt.mount-unlike", values)
            return
    softest, stiffest = sizes.index(min(sizes)), sizes.index(max(sizes))
    frequency = _lowest(block, mounts, body)
    if sag > MOST_SAG:
        usual = sizes[softest] * sag / MOST_SAG * 1e-3
        values = _told(sizes[softest], sag=sag * 1e3, bound=MOST_SAG * 1e3, usual=usual)
        yield Fault((*path, softest, "stiffness"), "doubt.mount-sag", values)
    elif frequency < LOWEST:
        least = [min(filter(None, each.along), default=np.inf) for each in mounts]
        softest = least.index(min(least))
        values = _told(least[softest], frequency=frequency, bound=LOWEST)
        yield Fault((*path, softest, "stiffness"), "doubt.mount-soft", values)
    elif frequency > HIGHEST:
        usual = sizes[stiffest] * (HIGHEST / frequency) ** 2 * 1e-3
        values = _told(sizes[stiffest], frequency=frequency, bound=HIGHEST, usual=usual)
        yield Fault((*path, stiffest, "stiffness"), "doubt.mount-stiff", values)


def _lowest(block: MountedBlock, mounts: Sequence[Mount], body: slice) -> float:
    """The lowest natural frequency of a body alone on its mounts, Hz."""
    here = slice(0, block.of_block) if body.start == 0 else slice(block.of_block, None)
    arms: Real = block.arms[here, :, body]
    stiffness = gathered(arms, values=np.array([each.along for each in mounts]))
    squares = np.linalg.eigvals(np.linalg.solve(block.mass[body, body], stiffness)).real
    return float(np.sqrt(max(float(squares.min()), 0.0)) / (2 * np.pi))


def _told(stiffness: float, **values: float) -> dict[str, Any]:
    """The stiffness in N/mm, and values in three figures, what is usual in two."""
    own = {"value": stiffness * 1e-3, **values}
    return {key: float(f"{each:.{2 if key == 'usual' else 3}g}") for key, each in own.items()}
