"""The best mounts within limits: stiffnesses and places that pass on or shake least.

Minimised over the speeds is one of

    force, mounts          the greatest rms force on the ground, or rms of the forces of all mounts
                           (the root of the sum of their squares)
    velocity               the greatest rms velocity of a point
    rms force, ...         the root mean square of one of these over the speeds
    roll                   what is not roll in the mode that has most of it: the sum of |e_i| of
                           the other freedoms, e_i their shares of energy (`dynamics.mount_modes`)

over the stiffness of each mount along each axis that the file gives one for (a mount with one value
keeps its axes alike, one that slides goes on sliding), and over places within so much of those of
the file. Kept to are how far the block sits down at its centre of mass, and a band in which all
natural frequencies lie.

With x these values, each scaled to 0..1 between its limits (stiffness by its logarithm), sequential
quadratic programming (scipy's SLSQP) takes min t, f_i(x) <= t at every speed i, or min f(x), from
the mounts of the file and from further starts that are spread evenly (a Halton sequence,
always the same); of mounts as good as each other those nearest to the file are taken. What is found
is a local optimum, the best of all starts; there is no certificate.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal, NamedTuple

import numpy as np
from scipy.linalg import eigh
from scipy.optimize import minimize
from scipy.stats import qmc

from crankstar.dynamics.mount_analysis import MountAnalysis
from crankstar.dynamics.mount_excitation import MountExcitation
from crankstar.dynamics.mount_modes import mount_modes
from crankstar.dynamics.mount_response import mount_response, rms
from crankstar.dynamics.mount_worst import ROLL, roll_mode
from crankstar.dynamics.mounted_block import MountedBlock, MountError, settled, with_mounts
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.mounts import Mount
from crankstar.engine.records import Provenance
from crankstar.language.messages import _
from crankstar.remedy.counterweights import RemedyError
from crankstar.spectra import Real

IsolationAim = Literal[
    "force", "mounts", "velocity", "rms force", "rms mounts", "rms velocity", "roll"
]
SPEEDS = 41
"""At most, of those of the analysis, evenly chosen: enough for the course, each costs time."""
STARTS = 6
ITERATIONS = 60
KEPT = 1e-4
"""Share by which a limit may be missed: less than a mount is made to."""
FIGURES = 5
"""Of a stiffness, and decimals of a place in metres: finer than any mount is made."""
NEAREST = 1e-3
"""Of the aim of the file: the cost of changing every value from one limit to the other."""
NOTHING = 1e-4
"""Of the aim of the file: two ends that differ by less are one, as where both are nought."""
ALIKE = 0.01
"""Share within which two ends count as one optimum."""
PLACES = ("up", "right", "z")
PROGRESS = Callable[[int, int], None]


class MountLimits(NamedTuple):
    """What the mounts may be: N/m, metres each way (up, right, z), metres, hertz; None is free.

    `stiffness` None leaves that of the file; `shift` noughts leave the places.
    """

    stiffness: tuple[float, float] | None = None
    shift: tuple[float, float, float] = (0.0, 0.0, 0.0)
    sag: float | None = None
    frequencies: tuple[float, float] | None = None


@dataclass(frozen=True)
class Isolation:
    """The best mounts found: the engine with them, the aim before and after, N, m/s or a share.

    `ends` are the values that the starts led to, the first that of the mounts of the file; nan
    where they led to none within the limits.
    """

    engine: Engine
    aim: IsolationAim
    before: float
    after: float
    ends: tuple[float, ...]

    @property
    def agreeing(self) -> int:
        """How many starts ended at the best value, within `ALIKE`."""
        ends = np.array(self.ends)
        return int(np.sum(ends <= self.after * (1 + ALIKE) + NOTHING * self.before))


class _Free(NamedTuple):
    """A value that is free: of which mount, which key, which axis; its limits."""

    mount: int
    key: str
    axis: int
    low: float
    high: float


def isolated(
    engine: Engine,
    found: MountAnalysis,
    *,
    aim: IsolationAim,
    limits: MountLimits,
    starts: int = STARTS,
    tell: PROGRESS | None = None,
) -> Isolation:
    """An engine on the best mounts within limits; `found` is how it stands, at which speeds.

    `tell(done, of)` is called after each start. Raises RemedyError where nothing is free or no
    mounts within the limits keep to the band and the sag.

    Beside the centre of mass, roll and bounce are apart where stiffness times distance is the same
    on both sides:

    >>> from crankstar.dynamics.mount_analysis import mounts
    >>> from crankstar.files.catalog import load
    >>> at = [("left", "-0.2 m", "0 m"), ("right", "0.4 m", "0 m"), ("rear", "0 m", "-0.3 m")]
    >>> rubber = [{"name": n, "right": r, "z": z, "stiffness": "90 N/mm"} for n, r, z in at]
    >>> own = {"mounts": rubber, "block": {"mass": "160 kg", "z": "0 m"}}
    >>> five = load("audi-25-tfsi", changes=own)
    >>> wide = MountLimits(stiffness=(2e4, 4e5))
    >>> best = isolated(five, mounts(five), aim="roll", limits=wide, starts=1)
    >>> left, right, _rear = (each.along[0] for each in best.engine.mounts)
    >>> round(left / right, 2), best.after < 1e-4 < best.before
    (2.0, True)
    """
    search = _Search(engine, found, aim, limits)
    ends: list[float] = []
    best: tuple[float, Real] | None = None
    nearest, missing = np.inf, ""
    for place, start in enumerate(_starts(search, starts), 1):
        x = search.led(start)
        missed = search.missed(x)
        if missed < nearest:
            nearest, missing = missed, search.missing(x)
        value = search.value(x) if missed <= KEPT else np.nan
        ends.append(value)
        if value == value and (best is None or value < best[0]):
            best = value, x
        if tell is not None:
            tell(place, starts)
    if best is None:
        raise RemedyError(
            "no mounts within these limits keep to the sag and the band of frequencies: the "
            "nearest that was found misses the limit of {limit} by {share} %; widen it",
            limit=missing,
            share=f"{100 * nearest:.3g}",
        )
    after = _fitted(engine, search.mounts(best[1]), search.free, aim)
    return Isolation(
        after, aim, aimed(found.block, search.push, aim, found.point), best[0], tuple(ends)
    )


def _starts(search: _Search, count: int) -> list[Real]:
    """The mounts of the file, and others spread evenly between the limits."""
    spread = qmc.Halton(len(search.free), scramble=False).random(count)
    return [search.own, *spread[1:]]  # its first is the corner of all that is least


class _Search:
    """The values that are free, and what they do."""

    def __init__(
        self, engine: Engine, found: MountAnalysis, aim: IsolationAim, limits: MountLimits
    ) -> None:
        self.aim: IsolationAim = aim
        self.limits, self.given = limits, engine.mounts
        self.block, self.point = found.block, found.point
        self.free = _free(engine.mounts, limits)
        if not self.free:
            raise RemedyError(
                "nothing is free: give --stiffness, such as 50..400 N/mm, or --shift, such as 30 mm"
            )
        self.push = None
        if aim != "roll":
            self.push = thinned(found, aim)
            if self.push is None:
                raise RemedyError("without a speed nothing shakes it: give --speeds")
        self.low = np.array([each.low for each in self.free])
        self.high = np.array([each.high for each in self.free])
        self.own = np.clip(self._scaled(), 0.0, 1.0)

    def _scaled(self) -> Real:
        """The mounts of the file between the limits."""
        given = np.array([_given(self.given[each.mount], each) for each in self.free])
        stiff = np.array([each.key == "stiffness" for each in self.free])
        out = (given - self.low) / (self.high - self.low)
        low, high = self.low[stiff], self.high[stiff]
        out[stiff] = np.log(given[stiff] / low) / np.log(high / low)
        return out

    def mounts(self, x: Real) -> tuple[Mount, ...]:
        """The mounts of scaled values."""
        values: dict[tuple[int, str], list[float]] = {}
        for each, share in zip(self.free, x.tolist(), strict=True):
            if each.key == "stiffness":
                size = each.low * (each.high / each.low) ** share
                own = values.setdefault(
                    (each.mount, "stiffness"), [*self.given[each.mount].stiffness]
                )
                own[each.axis] = size
            else:
                values[(each.mount, each.key)] = [each.low + share * (each.high - each.low)]
        changes: list[dict[str, Any]] = [{} for _mount in self.given]
        for (place, key), own in values.items():
            changes[place][key] = tuple(own) if key == "stiffness" else own[0]
        return tuple(
            with_values(mount, **more) for mount, more in zip(self.given, changes, strict=True)
        )

    def at(self, x: Real) -> MountedBlock:
        """The block on the mounts of scaled values."""
        return with_mounts(self.block, self.mounts(x))

    def course(self, x: Real) -> Real:
        """The rms of force or velocity at each speed, of scaled values."""
        return _course(self.at(x), self.push, self.aim, self.point)

    def value(self, x: Real) -> float:
        """What is minimised, of scaled values."""
        return aimed(self.at(x), self.push, self.aim, self.point)

    def kept(self, x: Real) -> Real:
        """How far each limit is kept, of it; below nought where it is missed."""
        block, out = self.at(x), []
        if self.limits.sag is not None:
            out.append(1.0 + float(settled(block)[0][0]) / self.limits.sag)
        if self.limits.frequencies is not None:
            low, high = self.limits.frequencies
            least, greatest = _ends(block)
            if low:
                out.append(least / low - 1.0)
            out.append(1.0 - greatest / high)
        return np.array(out)

    def missed(self, x: Real) -> float:
        """The greatest share by which a limit is missed."""
        return max(0.0, -float(self.kept(x).min(initial=0.0)))

    def missing(self, x: Real) -> str:
        """The limit that is missed most, in words; empty where all are kept."""
        kept, names = self.kept(x), [_("sag")] if self.limits.sag is not None else []
        if self.limits.frequencies is not None:
            lowest = [_("lowest frequency")] if self.limits.frequencies[0] else []
            names += [*lowest, _("highest frequency")]
        return names[int(kept.argmin())] if kept.min(initial=0.0) < 0 else ""

    def changed(self, x: Real) -> float:
        """What a change costs, of the value of the file: the least of those as good is taken."""
        return NEAREST * float(np.mean((x - self.own) ** 2))

    def led(self, start: Real) -> Real:
        """Where a start leads, within the limits of the values."""
        size = self.value(start) or 1.0
        bounds = [(0.0, 1.0)] * len(self.free)
        limits = [{"type": "ineq", "fun": self.kept}] if self.kept(start).size else []
        options = {"maxiter": ITERATIONS, "ftol": 1e-6}
        try:
            if self.push is None or self.aim.startswith("rms"):
                ended = minimize(
                    lambda x: self.value(x) / size + self.changed(x),
                    start,
                    method="SLSQP",
                    bounds=bounds,
                    constraints=limits,
                    options=options,
                )
                return np.clip(ended.x, 0.0, 1.0)
            rows = [{"type": "ineq", "fun": lambda xt: self.kept(xt[:-1])}] if limits else []
            top = {"type": "ineq", "fun": lambda xt: xt[-1] - self.course(xt[:-1]) / size}
            ended = minimize(
                lambda xt: xt[-1] + self.changed(xt[:-1]),
                np.append(start, 1.0),
                method="SLSQP",
                bounds=[*bounds, (0.0, None)],
                constraints=[top, *rows],
                options=options,
            )
        except MountError:  # undamped mounts that resonate at one of the speeds
            return start
        return np.clip(ended.x[:-1], 0.0, 1.0)


def _ends(block: MountedBlock) -> tuple[float, float]:
    """The lowest and the highest natural frequency, Hz."""
    if block.stiffens:
        modes = mount_modes(block)
        return modes[0].frequency, modes[-1].frequency
    squares = eigh(block.stiffness, block.mass, eigvals_only=True)
    return tuple(np.sqrt(np.maximum(squares[[0, -1]], 0.0)) / (2 * np.pi))


def _free(mounts: Sequence[Mount], limits: MountLimits) -> tuple[_Free, ...]:
    """Every stiffness and place that is free."""
    out: list[_Free] = []
    for index, mount in enumerate(mounts):
        if limits.stiffness is not None and limits.stiffness[0] < limits.stiffness[1]:
            out += [
                _Free(index, "stiffness", axis, *limits.stiffness)
                for axis, value in enumerate(mount.stiffness)
                if value
            ]
        out += [
            _Free(index, key, 0, getattr(mount, key) - by, getattr(mount, key) + by)
            for key, by in zip(PLACES, limits.shift, strict=True)
            if by
        ]
    return tuple(out)


def _given(mount: Mount, free: _Free) -> float:
    """The value that the file gives."""
    return mount.stiffness[free.axis] if free.key == "stiffness" else getattr(mount, free.key)


def aimed(
    block: MountedBlock, push: MountExcitation | None, aim: IsolationAim, point: Sequence[float]
) -> float:
    """What is minimised, of a block that is shaken so: N, m/s or a share; `push` None for roll."""
    course = _course(block, push, aim, point)
    if aim.startswith("rms"):
        return float(np.sqrt(np.mean(course**2)))
    return float(course.max())


def _course(
    block: MountedBlock, push: MountExcitation | None, aim: IsolationAim, point: Sequence[float]
) -> Real:
    """The rms of force or velocity at each speed; of decoupling, what is not roll."""
    if push is None:
        modes = mount_modes(block)
        energy = np.abs(modes[roll_mode(modes)].energy)
        return np.array([float(energy.sum() - energy[ROLL])])
    own = mount_response(block, push)
    if aim.endswith("force"):
        return rms(own.ground_force[..., :3])
    if aim.endswith("mounts"):
        each = own.mount_force[:, :, : block.of_block]
        return rms(each.reshape(*each.shape[:2], -1))
    return rms(own.velocity(point))


def thinned(found: MountAnalysis, aim: IsolationAim) -> MountExcitation | None:
    """What shakes it at fewer speeds, without the orders that do nothing; None without a speed.

    A mean is that over the speeds that are asked for, whatever is critical between them.
    """
    if found.over is None:
        return None
    push, every = found.over.excitation, np.arange(found.over.speeds.size)
    rows = np.searchsorted(found.over.speeds, found.asked) if aim.startswith("rms") else every
    kept = rows[
        np.unique(np.linspace(0, rows.size - 1, min(rows.size, SPEEDS)).round().astype(int))
    ]
    there = np.abs(push.push).max(axis=(0, 2)) > 0
    return replace(
        push,
        speeds=push.speeds[kept],
        orders=push.orders[there],
        inertia=push.inertia[there],
        gas=push.gas[kept][:, there],
    )


def _fitted(
    engine: Engine, mounts: tuple[Mount, ...], free: Sequence[_Free], aim: IsolationAim
) -> Engine:
    """The engine on other mounts, checked, with the source of their values."""
    was_set = {f"mounts[{each.mount + 1}].{each.key}" for each in free}
    sources = {
        path: source
        for path, source in engine.provenance.items()
        if not any(path == own or path.startswith(f"{own}[") for own in was_set)
    }
    text = f"crankstar isolate: least {aim} within limits; a local optimum"
    sources |= {path: Provenance(status="computed", source=text) for path in sorted(was_set)}
    rounded = tuple(_rounded(mount) for mount in mounts)
    return with_values(engine, mounts=rounded, provenance=sources)


def _rounded(mount: Mount) -> Mount:
    """A mount with stiffnesses to five figures and places to a hundredth of a millimetre."""
    stiffness = tuple(float(f"{each:.{FIGURES}g}") for each in mount.stiffness)
    places = {key: round(getattr(mount, key), FIGURES) for key in PLACES}
    return with_values(mount, stiffness=stiffness, **places)
