"""The best mounts within limits: stiffnesses and places that pass on or shake least.

Minimised over the speeds is one of

    force, mounts          the greatest rms force on the ground, or rms of the forces of all mounts
                           (the root of the sum of their squares)
    velocity               the greatest rms velocity of a point
    rms force, ...         the root mean square of one of these over the range of speeds, its square
                           integrated from the lowest to the highest
    roll                   what is not roll in the mode that has most of it: the sum of |e_i| of
                           the other freedoms, e_i their shares of energy (`dynamics.mount_modes`)

over the stiffness of each mount along each axis that the file gives one for (a mount with one value
keeps its axes alike, one that slides goes on sliding), and over places within so much of those of
the file. Kept to are how far the block sits down at its centre of mass, and a band in which all
natural frequencies lie.

With x these values, each scaled to 0..1 between its limits (stiffness by its logarithm), sequential
quadratic programming (scipy's SLSQP) takes min t, f_i(x) <= t at every speed i, or min f(x), from
the mounts of the file and from further starts that are spread evenly (a Halton sequence,
always the same); of mounts as good as each other those nearest to the file are taken. The speeds i
are those that are asked for and, as they move with x, those at which an order meets a natural
frequency: f_i = f(w_i(x), x), w_i kept within the range. What is found is judged as `mounts` does,
at its maximum between the speeds too, on the mounts as they are written. It is a local optimum, the
best of all starts; there is no certificate.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.linalg import eigh
from scipy.optimize import minimize
from scipy.stats import qmc

from crankstar.analyses.isolate.aims import EVEN, IsolationAim, aimed, course, mean, of_effect
from crankstar.analyses.isolate.free_values import MountLimits, fitted, free_values, given
from crankstar.dynamics.mount_analysis import MountAnalysis
from crankstar.dynamics.mount_modes import mount_modes
from crankstar.dynamics.mounted_block import MountedBlock, MountError, settled, with_mounts
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.mounts import Mount
from crankstar.language.messages import _
from crankstar.remedy.counterweights import RemedyError
from crankstar.spectra import Real

SPEEDS = 41
"""At most, of those that are asked for, evenly chosen: each costs time."""
STARTS = 6
ITERATIONS = 60
KEPT = 1e-4
"""Share by which limits are kept in the search, so that they are once values are rounded."""
NEAREST = 1e-3
"""Of the aim of the file: the cost of changing every value from one limit to the other."""
NOTHING = 1e-4
"""Of the aim of the file: two ends that differ by less are one, as where both are nought."""
ALIKE = 0.01
"""Share within which two ends count as one optimum."""
PROGRESS = Callable[[int, int], None]


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
    for number, start in enumerate(_starts(search, starts), 1):
        x = search.led(start)
        missed = search.missed(x)
        if missed < nearest:
            nearest, missing = missed, search.missing(x)
        value = search.value(x) if missed <= 0 else np.nan
        ends.append(value)
        if value == value and (best is None or value < best[0]):
            best = value, x
        if tell is not None:
            tell(number, starts)
    if best is None:
        raise RemedyError(
            "no mounts within these limits keep to the sag and the band of frequencies: the "
            "nearest that was found misses the limit of {limit} by {share} %; widen it",
            limit=missing,
            share=f"{100 * nearest:.3g}",
        )
    after = fitted(engine, search.mounts(best[1]), search.free, aim)
    now, then = (
        aimed(block, search.push, aim, found.point)
        for block in (found.block, with_mounts(found.block, after.mounts))
    )
    return Isolation(after, aim, now, then, tuple(ends))


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
        self.free = free_values(engine.mounts, limits)
        if not self.free:
            raise RemedyError(
                "nothing is free: give --stiffness, such as 50..400 N/mm, or --shift, such as 30 mm"
            )
        self.push, self.speeds = None, np.array([])
        self.damped = all(mode.damping > 0 for mode in found.modes)
        if aim != "roll":
            if found.over is None:
                raise RemedyError("without a speed nothing shakes it: give --speeds")
            self.push = of_effect(found.over.excitation)
            self.speeds = _thinned(found.asked)
            if aim.startswith("rms") and self.speeds.size > 1:
                even = np.linspace(self.speeds[0], self.speeds[-1], EVEN)
                self.speeds = np.union1d(self.speeds, even)
        self.low = np.array([each.low for each in self.free])
        self.high = np.array([each.high for each in self.free])
        self.own = np.clip(self._scaled(), 0.0, 1.0)

    def _scaled(self) -> Real:
        """The mounts of the file between the limits."""
        values = np.array([given(self.given[each.mount], each) for each in self.free])
        stiff = np.array([each.key == "stiffness" for each in self.free])
        out = (values - self.low) / (self.high - self.low)
        low, high = self.low[stiff], self.high[stiff]
        out[stiff] = np.log(values[stiff] / low) / np.log(high / low)
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
        """The rms of force or velocity at speeds and resonances, of scaled values."""
        block = self.at(x)
        speeds = np.append(self.speeds, self._met(block))
        return course(block, self.push, self.aim, self.point, speeds)

    def _met(self, block: MountedBlock) -> Real:
        """The speeds at which an order meets a natural frequency, those outside at the ends."""
        if self.push is None or self.speeds.size < 2 or not self.damped:
            return np.array([])
        natural = np.array([mode.speed for mode in mount_modes(block)])
        met = np.divide.outer(natural, self.push.orders).ravel()
        return np.clip(met, self.speeds[0], self.speeds[-1])

    def rough(self, x: Real) -> float:
        """What is minimised in the search: integrated over even speeds, or not roll."""
        sizes = course(self.at(x), self.push, self.aim, self.point, self.speeds)
        return float(sizes[0]) if self.push is None else mean(sizes, self.speeds)

    def value(self, x: Real) -> float:
        """What is minimised, of scaled values."""
        return aimed(self.at(x), self.push, self.aim, self.point)

    def kept(self, x: Real) -> Real:
        """How far each limit is kept, of it; below zero where it is missed."""
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
        bounds = [(0.0, 1.0)] * len(self.free)
        limited = self.kept(start).size > 0
        limits = [{"type": "ineq", "fun": lambda x: self.kept(x) - KEPT}] if limited else []
        options = {"maxiter": ITERATIONS, "ftol": 1e-6}
        try:
            if self.push is None or self.aim.startswith("rms"):
                size = self.rough(start) or 1.0
                ended = minimize(
                    lambda x: self.rough(x) / size + self.changed(x),
                    start,
                    method="SLSQP",
                    bounds=bounds,
                    constraints=limits,
                    options=options,
                )
                return np.clip(ended.x, 0.0, 1.0)
            size = float(self.course(start).max()) or 1.0
            rows = [{"type": "ineq", "fun": lambda xt: self.kept(xt[:-1]) - KEPT}] if limits else []
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


def _thinned(speeds: Real) -> Real:
    """At most SPEEDS of them, evenly chosen, the ends among them."""
    return speeds[np.unique(np.linspace(0, speeds.size - 1, SPEEDS).round().astype(int))]
