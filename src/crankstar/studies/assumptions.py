"""What an answer rests on that an engine file does not say for certain, and how much it matters.

A value may be missing and counted as zero, left out of the model, assumed, estimated or unverified.
Each is an `Assumption`: the key path, the value that was taken, the ends between which it may lie,
and why. `moved` computes the answer's figures again at both ends and says which of them moves most:

    effect = max over figures of max(|f(low) - f|, |f(high) - f|) / F

F being the maximum of the same quantity over all orders, at least the share `MINOR` of what its
parts push together, so that what is hardly there does not lead. A value without ends (an unverified
one) is varied by `TRIAL` up and down.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from math import degrees, radians
from typing import Any, Literal, Protocol

import numpy as np

from crankstar import spectra
from crankstar.engine.basis import ROD_SOURCE
from crankstar.engine.engine import Engine
from crankstar.engine.gas import LOADS
from crankstar.engine.proportions import Look, Proportion, inferred, look_of, proportion
from crankstar.engine.weighed import EngineType
from crankstar.language.faults import EngineError
from crankstar.language.messages import N_
from crankstar.mechanics.balance import balance
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.gas_torque import gas_torque
from crankstar.mechanics.operating_points import GasError
from crankstar.mechanics.remains import MINOR, USUAL_ORDERS, pushed, sizes, summed
from crankstar.remedy.fitting import quiet_cranks
from crankstar.studies.changed_values import (
    SCALED,
    Vary,
    point_value,
    with_gas_value,
    with_rods_of,
    with_rotating_mass,
)

Status = Literal["missing", "left out", "assumed", "estimated", "unverified"]
Uses = Literal["inertia", "gas"]
TRIAL = 0.01
"""Share by which a value without ends is varied."""
SIGNIFICANT = 1e-3
"""Effect below which an assumption does not matter to an answer."""
DOUBTFUL = ("unverified", "placeholder")
"""Statuses of values of a file that nobody has read in a source."""
OF_GAS = ("gas", "drive", "valves")
"""Tables of a file that no inertia depends on."""
GAS_ENDS: Mapping[str, tuple[float, float]] = {
    "compression_ratio": (0.85, 1.15),
    "gamma": (0.97, 1.03),
    "imep": (0.7, 1.3),
    "intake_pressure": (0.9, 1.2),
    "exhaust_pressure": (0.95, 1.3),
    "crankcase_pressure": (0.97, 1.03),
    "intake_temperature": (0.9, 1.1),
    "peak_pressure": (0.8, 1.25),
    "combustion_duration": (0.75, 1.3),
    "wiebe_a": (0.73, 1.38),
    "wiebe_m": (0.5, 1.5),
}
"""Ends of what is assumed of a cycle, as multiples of the assumed value.

Those of wiebe_a are 5 and 6.9 of one another; the others are wide enough for engines of one kind.
Source: J. B. Heywood, Internal Combustion Engine Fundamentals, chapters 5 and 9, for the order of
size; the ends themselves are our judgement.
"""
START_ENDS = radians(10.0)
"""By how much the assumed start of combustion may be earlier or later, radians."""

POINT = re.compile(r"gas\.point(?:\[(\d+)\])?\.(\w+)")
"""A key of an operating point: of all, or of one counted from one."""
Figure = tuple[str, float]
"""A quantity (`force`, `couple`, `roll`) and an order."""
Figures = Mapping[Figure, float]


@dataclass(frozen=True)
class Moved:
    """The figure that an assumption moves most, in the unit of its Balance or in N m.

    `now` is its value as given, `low` and `high` the ends over the range; `trial` says that the
    value has no range and was varied by TRIAL up and down.
    """

    quantity: str
    order: float
    unit: str
    now: float
    low: float
    high: float
    effect: float
    trial: bool = False


@dataclass(frozen=True)
class Assumption:
    """A value that an answer rests on and that the engine file does not give for certain.

    `value`, `low`, `high` are in the unit `unit`, None where there is no number; `reason` is a
    sentence of the catalog of messages, to be translated where it is shown, with `values` in it.
    """

    status: Status
    path: str
    reason: str
    value: float | str | None = None
    unit: str = ""
    low: float | None = None
    high: float | None = None
    values: tuple[tuple[str, Any], ...] = ()
    moved: Moved | None = None
    vary: Vary | None = None

    @property
    def effect(self) -> float:
        """How much the answer moves at most, over its greatest value; 0 where that is not known."""
        return 0.0 if self.moved is None else self.moved.effect


def assumptions(
    engine: Engine,
    *,
    speed: float | None = None,
    gas: Cycle | None = None,
    uses: Collection[Uses] = ("inertia",),
) -> tuple[Assumption, ...]:
    """All that an answer of these `uses` rests on, what moves it most first.

    `speed` (rad/s) is that of the answer, `gas` the cycle that is part of it.

    >>> from crankstar.files.catalog import load
    >>> first = assumptions(load("audi-25-tfsi"))[0]
    >>> first.path, first.status, first.moved.quantity, first.moved.order
    ('cylinder.rotating_mass', 'missing', 'couple', 1.0)
    >>> [round(each) for each in (first.moved.now, first.moved.low, first.moved.high)]
    [418, 747, 1259]
    """
    figures = _Figures(speed, gas if "gas" in uses else None)
    found: list[Assumption] = []
    if "inertia" in uses:
        found += _inertia(engine)
    if "gas" in uses and gas is not None:
        found += _gas(engine, gas)
    found += _unverified(engine, gas=gas if "gas" in uses else None)
    return moved(engine, found, figures)


def moved(engine: Engine, found: Sequence[Assumption], figures: Results) -> tuple[Assumption, ...]:
    """The assumptions with what each moves most, the largest first; without those of no effect.

    What cannot be varied stays, behind those that can.
    """
    now = figures(engine)
    out: list[Assumption] = []
    for each in found:
        own = None if each.vary is None else _moved(engine, each, now, figures)
        if (
            own is not None
            and own.effect < SIGNIFICANT
            and each.status in ("assumed", "unverified")
        ):
            continue
        out.append(replace(each, moved=own))
    return tuple(sorted(out, key=lambda each: -each.effect))


def _moved(engine: Engine, each: Assumption, now: Figures, figures: Results) -> Moved | None:
    """The figure that one assumption moves most; None where an end is no engine."""
    vary = each.vary
    assert vary is not None  # noqa: S101  # asked before
    trial = each.low is None or each.high is None
    ends = (1 - TRIAL, 1 + TRIAL) if trial else (each.low, each.high)
    try:
        others = [figures(vary(engine, float(end))) for end in ends if end is not None]
    except (EngineError, GasError):
        return None
    tops = figures.least(engine)
    for (quantity, _order), size in (item for one in (now, *others) for item in one.items()):
        tops[quantity] = max(tops.get(quantity, 0.0), size)
    best: Moved | None = None
    for key in dict.fromkeys(key for one in (now, *others) for key in one):
        quantity, order = key
        own = now.get(key, 0.0)
        sizes_there = [one.get(key, 0.0) for one in others]
        most = max(abs(size - own) for size in sizes_there)
        effect = most / tops[quantity] if tops[quantity] else 0.0
        if best is None or effect > best.effect * (1 + 1e-9):
            low, high = min(sizes_there), max(sizes_there)
            best = Moved(
                quantity, order, figures.unit(quantity, engine), own, low, high, effect, trial
            )
    return best


class Results(Protocol):
    """The figures of an answer as a function of the engine."""

    def __call__(self, engine: Engine) -> Figures:
        """The maximum of each quantity and order."""
        ...

    def unit(self, quantity: str, engine: Engine) -> str:
        """The unit of a quantity."""
        ...

    def least(self, engine: Engine) -> dict[str, float]:
        """The least that each quantity is measured by."""
        ...


@dataclass(frozen=True)
class _Figures:
    """The maxima of force, couple and rolling moment by order, gas included where it is part."""

    speed: float | None
    gas: Cycle | None

    def __call__(self, engine: Engine) -> Figures:
        turning = engine.speed if self.speed is None else self.speed
        result = balance(engine, speed=turning)
        sums = summed(result)
        found: dict[Figure, float] = {}
        for name in ("force", "couple", "roll"):
            spectrum = getattr(sums, name)
            for order, size in zip(spectrum.orders.tolist(), sizes(spectrum).tolist(), strict=True):
                if order <= USUAL_ORDERS:
                    found[name, order] = size
        if self.gas is not None:
            found = {key: size for key, size in found.items() if key[0] != "roll"}
            found |= self._gas_roll(engine)
        return found

    def _gas_roll(self, engine: Engine) -> dict[Figure, float]:
        """The alternating gas torque by order, which the frame feels."""
        own = self.gas
        assert own is not None  # noqa: S101  # asked before
        load = (
            {}
            if _measured(engine)
            else {key: own.values[key] for key in LOADS if key in own.values}
        )
        off = [number for number, chamber in _chambers(engine) if chamber in own.off]
        again = cycle(engine, point=own.name, speed=own.speed, motored=own.motored, off=off, **load)
        total = gas_torque(again).total
        waves = np.abs(spectra.amplitude(total))
        return {
            ("roll", order): size
            for order, size in zip(total.orders.tolist(), waves.tolist(), strict=True)
            if order <= 2 * USUAL_ORDERS
        }

    def least(self, engine: Engine) -> dict[str, float]:
        """A small share of what all parts push together."""
        result = balance(engine, speed=engine.speed if self.speed is None else self.speed)
        found = {
            name: MINOR * float(pushed(getattr(result, name)).max(initial=0.0))
            for name in ("force", "couple")
        }
        return {**found, "roll": 0.0}

    def unit(self, quantity: str, engine: Engine) -> str:
        """The unit of a figure of an engine."""
        if quantity == "roll" and self.gas is not None:
            return "N*m"
        turning = engine.speed if self.speed is None else self.speed
        units = balance(engine, speed=turning).units
        return {"force": units.force, "couple": units.couple}.get(quantity, units.moment)


def _measured(engine: Engine) -> bool:
    return engine.gas is not None and engine.gas.trace is not None


def _chambers(engine: Engine) -> list[tuple[int, int]]:
    """The number of each cylinder, and that of its chamber."""
    return [(own.number, key) for key, group in engine.chambers.items() for own in group]


def _usual(part: str, kind: EngineType) -> Proportion | None:
    """A coefficient of a type, None where there is none."""
    try:
        return proportion(part, kind)
    except KeyError:
        return None


def _inertia(engine: Engine) -> Iterator[Assumption]:
    """What is missing or assumed of the masses and lengths that forces come from."""
    look = look_of(engine)
    kind = None if look is None else inferred(look)[0]
    yield from _rods(engine, kind)
    turning = any(throw.turning_mass for shaft in engine.shafts for throw in shaft.throws)
    rigid = any(cylinder.rod is not None for cylinder in engine.cylinders)
    weighted = any(shaft.weights for shaft in engine.shafts if shaft.throws)
    if not turning and not rigid and weighted:
        # what balances the pistons of a file with a balance factor would balance this too
        reason = N_("no rotating mass in the file: its counterweights are for the pistons alone")
        yield Assumption("missing", "cylinder.rotating_mass", reason, value=0.0, unit="kg")
    elif not turning and not rigid:
        yield _rotating(engine, kind, look)
    if not weighted:
        yield Assumption(
            "missing",
            "crankshaft.weight",
            N_("no counterweights in the file"),
            value=0.0,
            low=1.0,
            high=1.0,
            vary=_with_usual_weights,
        )


def _with_usual_weights(engine: Engine, _share: float) -> Engine:
    """The engine with the counterweights that remove what turns with its cranks."""
    return quiet_cranks(engine)[0]


def _rotating(engine: Engine, kind: EngineType | None, look: Look | None) -> Assumption:
    """The mass that turns with a crankpin, which a file leaves out: big end and crankpin.

    Of each cylinder, m = (1 - c) m_rod + m_pin, the coefficients of the type times bore^3; where
    the file gives no masses, over m_piston + c m_rod, which is counted as 1.
    """
    reason = N_("no rotating mass in the file (big ends, crankpins), counted as zero")
    first = engine.first
    relative = "mass" in engine.relative or look is None or first.bore is None
    names = ("rod", "small end", "crank pin", "piston group")
    found = [_usual(name, kind or "petrol") for name in names]
    if not all(found) or (relative and "mass" not in engine.relative):
        return Assumption("missing", "cylinder.rotating_mass", reason, value=0.0, unit="kg")
    rod, small, pin, piston = (each for each in found if each is not None)
    scale = 1.0 if relative else (first.bore or 0.0) ** 3
    if relative:
        scale = first.reciprocating / (piston.typical + small.typical * rod.typical)
    ends = [
        ((1 - share) * own + turning) * scale
        for share, own, turning in zip(reversed(small.sizes), rod.sizes, pin.sizes, strict=True)
    ]
    unit = "m" if relative else "kg"
    return Assumption(
        "missing", "cylinder.rotating_mass", reason, 0.0, unit, ends[0], ends[-1],
        vary=with_rotating_mass,
    )  # fmt: skip


def _rods(engine: Engine, kind: EngineType | None) -> Iterator[Assumption]:
    """Rod lengths that are assumed, l = 4 r, with the range of the type."""
    for path, origin in engine.provenance.items():
        if origin.status != "placeholder" or not origin.source.endswith(ROD_SOURCE):
            continue
        radius = engine.throw(engine.first).radius
        usual = None if kind is None else _usual("rod length", kind)
        ends = (3.2, 4.8) if usual is None else (usual.low, usual.high)
        yield Assumption(
            "assumed",
            path,
            N_("neither rod length nor l/r in the file"),
            value=engine.first.rod_length / radius,
            unit="r",
            low=ends[0],
            high=ends[1],
            vary=with_rods_of,
        )
        return


def _gas(engine: Engine, own: Cycle) -> Iterator[Assumption]:
    """What is assumed of a cycle, and what one measured trace stands for."""
    if _measured(engine):
        yield Assumption(
            "assumed", "gas.trace", N_("one measured trace is used at every speed and load")
        )
    for name in own.assumed:
        path = f"gas.{name}"
        value = own.values.get(name)
        if name == "combustion_start" and isinstance(value, float):
            yield Assumption(
                "assumed", path, N_("usual for such engines"), degrees(value), "deg",
                degrees(value - START_ENDS), degrees(value + START_ENDS),
                vary=with_gas_value(name, radians(1.0)),
            )  # fmt: skip
        elif name in GAS_ENDS and isinstance(value, float):
            low, high = (share * value for share in GAS_ENDS[name])
            unit = UNITS_OF_GAS.get(name, "")
            factor = FACTORS.get(unit, 1.0)
            yield Assumption(
                "assumed", path, N_("usual for such engines"), value / factor, unit,
                low / factor, high / factor, vary=with_gas_value(name, factor),
            )  # fmt: skip
        else:
            yield Assumption("assumed", path, N_("usual for such engines"), str(value))


UNITS_OF_GAS = {
    **dict.fromkeys(
        ("imep", "intake_pressure", "exhaust_pressure", "crankcase_pressure", "peak_pressure"),
        "bar",
    ),
    "intake_temperature": "K",
    "combustion_duration": "deg",
}
FACTORS = {"bar": 1e5, "deg": radians(1.0)}
"""From the unit that is shown to SI."""


def _unverified(engine: Engine, *, gas: Cycle | None) -> Iterator[Assumption]:
    """Values of the file that nobody has read in a source, or that are estimated."""
    for path, origin in engine.provenance.items():
        if origin.source.endswith(ROD_SOURCE) or (path.startswith(OF_GAS) and gas is None):
            continue
        point = POINT.fullmatch(path)
        if point is not None and gas is not None and not _is_of(engine, gas, point[1]):
            continue
        vary = SCALED.get(path) if point is None else point_value(point[2], gas)
        if origin.status in DOUBTFUL:
            reason = N_("a guess") if origin.status == "placeholder" else N_("not read in a source")
            yield Assumption("unverified", path, reason, vary=vary)
        elif origin.status == "estimated":
            low, high = origin.range or (None, None)
            yield Assumption(
                "estimated", path, N_("estimated by proportions of such engines"),
                1.0, "", low, high, vary=vary,
            )  # fmt: skip


def _is_of(engine: Engine, gas: Cycle, index: str | None) -> bool:
    """Whether a key of an operating point, counted from one, is of that of the cycle."""
    points = () if engine.gas is None else engine.gas.points
    own = [number for number, point in enumerate(points, 1) if point.name == gas.name]
    return bool(own) and (index is None or int(index) in own)
