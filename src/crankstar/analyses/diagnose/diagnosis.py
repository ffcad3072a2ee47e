"""The likeliest fault of an engine from measured vibration: amplitude and phase by order.

The engine as its file has it would move by y_0; what was measured is y. Each fault of the
catalogue adds a column a to the difference d = y - y_0, times its size s, which is real. A reading
is as uncertain as it is great, and so is the model: each row is divided by

    e = hypot(|y|, |y_0|, FLOOR max |y|)    or by the error that the list gives for it,

so that a small difference of great readings does not hide what small readings show. Least squares
with these complex rows give

    s = Re(a* d)/(a* a),    explained = 1 - |d - s a|^2/|d|^2,
    standard error of s = |d - s a| / (sqrt(2 n - 1) |a|)  for n rows,

or, where it is greater, the error sqrt(sum a_i^2 r_i^2 2n/(2n - 1)) / |a|^2 over the 2n real rows
with their residuals r, which does not rest on the e. Where the list gives the errors it is at least
1/|a|, what these make of it however small the residuals are. s is kept within what there can be
(`single_faults.limits`): shares from 0 to 1, masses of either sign that leave something of the
part. A fault is a cause where it explains most, or where its size is CERTAIN times its error and no
two faults explain much more: of noisy readings the best fault may explain little and be sure. Rows
are velocities; where the vibration before the fault was measured too, it stands for y_0, and errors
of the model cancel. Two faults cannot be told apart where the cosine of the angle between their
columns is ALIKE or more. Pairs are tried as well, and told where they explain much more.

Source of the second error: H. White, Econometrica 48 (1980) 817, with the factor of degrees of
freedom of J. G. MacKinnon and H. White, J. Econometrics 29 (1985) 305.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Literal, NamedTuple

import numpy as np
from scipy.optimize import lsq_linear

from crankstar.analyses.diagnose.readings import Reading
from crankstar.dynamics.whirl import body
from crankstar.engine.engine import Engine
from crankstar.engine.rigid_block import moved
from crankstar.mechanics.gas_loads import vibrating_state
from crankstar.mechanics.operating_points import OperatingState
from crankstar.spectra import Complex, Real
from crankstar.studies.fault_kinds import Fault
from crankstar.studies.single_faults import (
    DiagnosisError,
    Shaken,
    catalogue,
    known,
    limits,
    own_mass,
    shaken,
)

ALIKE = 0.995
"""Cosine of the angle between two columns from which two faults cannot be told apart."""
EXPLAINS = 0.7
"""Share that a fault must explain for it to be a cause, however great its error."""
CERTAIN = 5.0
"""Errors that the size of a fault must have for it to be a cause."""
FLOOR = 0.1
"""Share of the greatest reading below which readings are as uncertain as at it."""
NOTHING = 0.02
"""Share of the vibration below which the difference counts as none."""
NEXT_TO_NOTHING = 1e-4
"""The same where it is rounding, whatever its pattern."""
FEW = 4
"""Readings below which many faults explain them."""
SOMETHING = 1e-9
"""Share that a fault explains above which its size is more than rounding."""
MOST_IN_PAIRS = 64
"""Faults of which pairs are tried."""
MUCH_MORE = 0.5
"""Share of what a single fault leaves that a pair must explain to be told."""


class Suspect(NamedTuple):
    """A fault of its likeliest size, the share of the difference it explains, the rows it gives.

    `error` is the standard error of the size of a single fault, as what it leaves says.
    """

    faults: tuple[Fault, ...]
    explained: float
    rows: Complex
    error: float = 0.0

    @property
    def rounded(self) -> tuple[Fault, ...]:
        """The faults as told to readers: the size of a single one rounded to its error.

        >>> Suspect((Fault("piston", 3, 0.0092968),), 0.8, np.zeros(1), 0.032).rounded[0].size
        0.009
        """
        if len(self.faults) != 1 or not 0 < self.error < np.inf:
            return self.faults
        fault = self.faults[0]
        last = 1 - int(np.floor(np.log10(float(f"{self.error:.2g}"))))
        return (fault._replace(size=round(fault.size, last)),)

    @property
    def certainty(self) -> float:
        """The size of a single fault over its error."""
        return abs(self.faults[0].size) / self.error if self.error > 0 else np.inf

    @property
    def has_size(self) -> bool:
        """Whether it is a fault at all: of a size that is more than rounding, and explains some."""
        return self.explained > SOMETHING and all(fault.size for fault in self.rounded)


@dataclass(frozen=True)
class Diagnosis:
    """Suspects, the likeliest first; the best pair; what cannot be told apart from the first.

    `difference` are the measured rows less those without a fault (m/s), `share` its size over that
    of the measured vibration.
    """

    engine: Engine
    readings: tuple[Reading, ...]
    difference: Complex
    share: float
    suspects: tuple[Suspect, ...]
    pair: Suspect | None
    alike: tuple[Suspect, ...]
    point: str = ""

    @property
    def states(self) -> list[OperatingState]:
        """The operating points and speeds of the readings."""
        speeds = sorted({each.speed for each in self.readings})
        return [vibrating_state(self.engine, point=self.point, speed=speed) for speed in speeds]

    @property
    def found(self) -> bool:
        """Whether some single fault explains what was measured."""
        if not self.suspects:
            return False
        first = self.suspects[0]
        certain = first.has_size and self.pair is None and first.certainty >= CERTAIN
        return first.explained >= EXPLAINS or certain

    @property
    def healthy(self) -> bool:
        """Whether the engine without a fault explains it: little differs, and in no pattern."""
        return self.share < NEXT_TO_NOTHING or (self.share < NOTHING and not self.found)


def rows_of(found: dict[float, Shaken], readings: Sequence[Reading]) -> Complex:
    """The velocities of readings, m/s, by what shakes the block at each speed."""
    out = np.zeros(len(readings), complex)
    for at, each in enumerate(readings):
        own = found[each.speed]
        centre = np.array(body(own.engine).centre)
        row = moved(np.array(each.place) - centre)[each.axis]
        order = int(np.argmin(np.abs(own.orders - each.order)))
        out[at] = 1j * each.order * each.speed * (row @ own.motion[order])
    return out


def expected(
    engine: Engine, readings: Sequence[Reading], faults: Sequence[Fault] = (), *, point: str = ""
) -> Complex:
    """What would be measured of an engine with faults, m/s [reading]."""
    orders = sorted({each.order for each in readings})
    found = {
        speed: shaken(engine, faults, speed=speed, point=point, orders=orders)
        for speed in sorted({each.speed for each in readings})
    }
    return rows_of(found, readings)


def diagnosed(
    engine: Engine, readings: Sequence[Reading], *, before: Sequence[Reading] = (), point: str = ""
) -> Diagnosis:
    """The likeliest single faults by what was measured, and the best pair of them.

    `before` is what was measured in the same places without the fault. Raises DiagnosisError.

    >>> from crankstar.files.catalog import load
    >>> five = load("audi-25-tfsi")
    >>> places = [(0.2, 0.1, 0.3), (-0.1, -0.2, -0.3)]
    >>> lines = [Reading(k, p, a, 0j, 300.0, 0) for k in (1, 2) for p in places for a in (0, 1)]
    >>> heard = expected(five, lines, [Fault("piston", 2, 0.02)])
    >>> lines = [each._replace(velocity=v) for each, v in zip(lines, heard, strict=True)]
    >>> first = diagnosed(five, lines).suspects[0]
    >>> first.faults[0].number, round(first.faults[0].size, 9)
    (2, 0.02)
    """
    known(engine)
    measured = np.array([each.velocity for each in readings])
    healthy = expected(engine, readings, point=point)
    start = _matching(readings, before) if before else healthy
    difference = measured - start
    errors, given = _errors(readings, before, measured, start)
    faults = catalogue(engine)
    columns = np.array(
        [expected(engine, readings, [fault], point=point) - healthy for fault in faults]
    )
    size = float(np.linalg.norm(difference))
    whole = max(float(np.linalg.norm(measured)), float(np.linalg.norm(start)))
    share = size / whole if whole else 0.0
    suspects = [
        _suspect(engine, difference, [fault], [column], errors, least=1.0 if given else 0.0)
        for fault, column in zip(faults, columns, strict=True)
        if np.linalg.norm(column) > 0
    ]
    suspects.sort(key=lambda each: (-round(each.explained, 6), _doubtful(engine, each.faults[0])))
    return Diagnosis(
        engine,
        tuple(readings),
        difference,
        share,
        tuple(suspects),
        _pair(engine, difference, faults, columns, suspects, errors),
        _alike(suspects, errors),
        point,
    )


def _errors(
    readings: Sequence[Reading], before: Sequence[Reading], measured: Complex, start: Complex
) -> tuple[Real, bool]:
    """What the difference of each reading is uncertain by, and whether the lists give it.

    Else it is, up to a common factor, the size of the reading and of what it is compared with.
    """
    if all(each.error > 0 for each in (*readings, *before)):
        own = np.array([each.error for each in readings])
        earlier = np.abs(_matching(readings, before, of="error")) if before else 0.0
        return np.hypot(own, earlier), True
    sizes = np.hypot(np.abs(measured), np.abs(start))
    floor = FLOOR * float(sizes.max(initial=0.0))
    return np.hypot(sizes, floor) if floor else np.ones(len(readings)), False


def _matching(
    readings: Sequence[Reading],
    before: Sequence[Reading],
    *,
    of: Literal["velocity", "error"] = "velocity",
) -> Complex:
    """What was measured before in the same places and orders. Raises DiagnosisError."""
    known_before: dict[tuple[object, ...], complex] = {}
    for each in before:
        key = (each.order, each.place, each.axis, each.speed)
        if known_before.setdefault(key, getattr(each, of)) != getattr(each, of):
            raise DiagnosisError(
                "line {line} of the measurement before has another value than a line above it in "
                "the same place, direction, order and speed; leave one out",
                line=each.line,
            )
    out: list[complex] = []
    for each in readings:
        key = (each.order, each.place, each.axis, each.speed)
        if key not in known_before:
            raise DiagnosisError(
                "line {line} of the measurement has none before it in the same place, direction, "
                "order and speed",
                line=each.line,
            )
        out.append(known_before[key])
    return np.array(out)


def _suspect(
    engine: Engine,
    difference: Complex,
    faults: Sequence[Fault],
    columns: Sequence[Complex],
    errors: Real,
    *,
    least: float = 0.0,
) -> Suspect:
    """Faults of the sizes with which they explain most, within what there can be.

    `least` is the error of a row over `errors`, at least.
    """
    rows = np.array(columns).T
    weighed, wanted = rows / errors[:, None], difference / errors
    real = np.concatenate([np.real(weighed), np.imag(weighed)])
    aim = np.concatenate([np.real(wanted), np.imag(wanted)])
    sizes = np.linalg.lstsq(real, aim, rcond=None)[0]
    lowest, most = np.array([limits(engine, fault) for fault in faults]).T
    if (np.clip(sizes, lowest, most) != sizes).any() and len(faults) > 1:
        sizes = lsq_linear(real, aim, bounds=(lowest, most)).x
    sizes = np.clip(sizes, lowest, most)
    left = aim - real @ sizes
    whole = float(aim @ aim)
    share = 1 - float(left @ left) / whole if whole else 0.0
    sized = tuple(
        fault._replace(size=float(size)) for fault, size in zip(faults, sizes, strict=True)
    )
    return Suspect(sized, share, rows @ sizes, _size_error(real, left, least))


def _size_error(real: Real, left: Real, least: float) -> float:
    """The standard error of the size of a single fault, by its real rows and what it leaves.

    No smaller than that of rows whose error is `least`.
    """
    count, faults = real.shape
    freedom = max(count - faults, 1)
    square = float(np.vdot(real, real)) or 1.0
    usual = float(left @ left) / freedom / square
    own = float(((real[:, 0] * left) ** 2).sum()) * count / freedom / square**2
    return max(usual, own, least**2 / square) ** 0.5


def _pair(
    engine: Engine,
    difference: Complex,
    faults: Sequence[Fault],
    columns: Complex,
    suspects: Sequence[Suspect],
    errors: Real,
) -> Suspect | None:
    """The best pair, where it explains MUCH_MORE of what the best single fault leaves."""
    best: Suspect | None = None
    if len(faults) > MOST_IN_PAIRS:
        return None
    for one, other in combinations(range(len(faults)), 2):
        if abs(_cosine(columns[one] / errors, columns[other] / errors)) >= ALIKE:
            continue
        both = [faults[one], faults[other]], [columns[one], columns[other]]
        pair = _suspect(engine, difference, *both, errors)
        if best is None or pair.explained > best.explained + 1e-9:
            best = pair
    single = suspects[0].explained if suspects else 0.0
    if best is None or 1 - best.explained > (1 - MUCH_MORE) * (1 - single):
        return None
    return best if best.explained >= EXPLAINS and single < 1 - NOTHING**2 else None


def _doubtful(engine: Engine, fault: Fault) -> float:
    """How doubtful a fault is among those that explain as much: parts of a weight, great masses."""
    if fault.kind == "weight":
        return 1 - fault.size
    if fault.kind == "combustion":
        return 0.0
    whole = own_mass(engine, fault)
    return min(abs(fault.size) / whole, 1.0) if whole > 0 else 1.0


def _alike(suspects: Sequence[Suspect], errors: Real) -> tuple[Suspect, ...]:
    """Those whose vibration has the same pattern as that of the first."""
    if not suspects:
        return ()
    first = suspects[0].rows / errors
    return tuple(
        each
        for each in suspects[1:]
        if np.linalg.norm(each.rows) > 0 and _cosine(first, each.rows / errors) >= ALIKE
    )


def _cosine(one: Complex, other: Complex) -> float:
    sizes = float(np.linalg.norm(one) * np.linalg.norm(other))
    return float(np.real(np.vdot(one, other))) / sizes if sizes else 0.0
