"""What is assumed of the gas that an engine file does not give, and what gas an answer leaves out.

Each value with its ends; a choice of two with the other one; the timing of valves and ports, as far
as the pressure depends on it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from math import degrees, radians
from typing import Any

import numpy as np

from crankstar import spectra
from crankstar.analysis.assumptions import Assumption, Moved
from crankstar.analysis.changed_values import (
    Vary,
    with_gas_choice,
    with_gas_value,
    with_valve_angle,
)
from crankstar.analysis.tried_values import Figures
from crankstar.engine.copies import with_values
from crankstar.engine.drive import Drive
from crankstar.engine.engine import Engine
from crankstar.engine.firing_angles import firing_angles, other_angles
from crankstar.engine.gas import Gas
from crankstar.engine.quantities import Cycle as Strokes
from crankstar.engine.valves import timing
from crankstar.language.messages import N_, MessageError
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.gas_torque import gas_torque, roll_with_gas
from crankstar.mechanics.operating_points import GasError
from crankstar.mechanics.remains import summed
from crankstar.studies.gas_ends import GAS_ENDS, charged, gas_ends, throttled, usual_ends

OF_TRACE = (
    *("combustion_start", "combustion_duration", "wiebe_a", "wiebe_m"),
    *("intake_pressure", "exhaust_pressure"),
)
"""What is in a measured pressure."""
CHARGE = ("intake_pressure", "exhaust_pressure", "peak_pressure")
"""What is assumed together, by the load: an engine that needs a charger for it has one."""
CHOICES: Mapping[str, tuple[str, str]] = {
    "ignition": ("spark", "compression"),
    "friction": ("spark-ignition", "diesel"),
}
"""What is assumed of a cycle without a number: one of two."""
VALVE_ENDS: Mapping[Strokes, Mapping[str, tuple[float, float]]] = {
    "four-stroke": {
        "intake_opens": (0.0, 30.0),
        "intake_closes": (40.0, 70.0),
        "exhaust_opens": (35.0, 65.0),
        "exhaust_closes": (0.0, 30.0),
    },
    "two-stroke": {
        "intake_opens": (40.0, 70.0),
        "intake_closes": (40.0, 70.0),
        "exhaust_opens": (70.0, 100.0),
        "exhaust_closes": (55.0, 100.0),
    },
}
"""Ends of the assumed timing of valves and ports, degrees: our judgement.

Of four-stroke engines those of road and industrial engines; of two-stroke ones from the ports and
the exhaust valve of a ship's engine to the ports of a small one.
"""
USUAL = N_("usual for such engines")
AT_SAME_CHARGE = N_("usual for such engines; at the same charge pressure")
ONE_HEAT = Assumption(
    "assumed", "gas",
    N_("chambers of unlike size burn the same heat for their swept volume"),
    sentence=N_(
        "Chambers of unlike size burn the same heat for their swept volume, and a load is the mean "
        "by volume; not in the file: {paths}."
    ),
)  # fmt: skip
"""How the heat is shared among chambers of which one has more than UNLIKE times another."""
UNLIKE = 1.01
LOADS = 9
"""Loads of a usual cycle at which its roll is tried: near the inertia's it has a minimum inside."""
START_ENDS = radians(10.0)
"""By how much the assumed start of combustion may be earlier or later, radians."""


def without_gas(engine: Engine, found: Cycle) -> Assumption:
    """The gas torque that the rolling moment of an answer leaves out, and what it would change.

    Of a file without a table [gas] that of the usual cycle, over the ends of its load.
    """
    reason = N_("the gas torque is not in the rolling moment")
    result = balance(engine, speed=found.speed)
    name = f"gas.point.{found.name}" if found.name and len(found.shares) == 1 else "gas"
    if result.speed is None or {"mass", "radius"} & {*engine.relative}:
        return Assumption("left out", name, reason)
    fires: tuple[tuple[str, str], ...] = ()
    runs, ends = [found], (None, None)
    if engine.gas is None:
        reason = N_("no table [gas] in the file")
        with suppress(MessageError):
            low, high = usual_ends("imep", found.values["imep"], found)
            loads = np.linspace(low, high, LOADS).tolist()
            runs += [cycle(engine, speed=found.speed, imep=load) for load in loads]
            ends = low / 1e5, high / 1e5
            fires = (("ignition", found.values["ignition"]),)
    alone = summed(result).roll
    both = roll_with_gas(total(result), gas_torque(found).total)
    wave = np.abs(spectra.amplitude(both))
    before = dict(zip(alone.orders.tolist(), np.abs(spectra.amplitude(alone)), strict=True))
    now = np.array([before.get(order, 0.0) for order in both.orders.tolist()])
    most = int(np.argmax(np.abs(wave - now)))
    top = max(float(wave.max()), float(now.max()))
    effect = float(abs(wave[most] - now[most])) / top if top else 0.0
    rolls = [roll_with_gas(total(result), gas_torque(run).total) for run in runs]
    sizes = [float(np.abs(spectra.amplitude(own))[most]) for own in rolls]
    change = Moved(
        "roll", float(both.orders[most]), "N*m", float(now[most]),
        min(sizes), max(sizes), effect,
    )  # fmt: skip
    return Assumption(
        "left out", name, reason, unit="" if ends[0] is None else "bar",
        low=ends[0], high=ends[1], values=fires, moved=change,
    )  # fmt: skip


def usual_load(own: Cycle, figures: Callable[[Engine], Figures], sentence: str) -> Assumption:
    """The usual cycle that a file without [gas] leaves out of `figures`, over its load.

    `sentence` as of an `Assumption`.
    """
    low, high = (end / 1e5 for end in usual_ends("imep", own.values["imep"], own))
    fires = own.values["ignition"]

    def vary(engine: Engine, load: float) -> Engine:
        return with_values(engine, gas=Gas(imep=load * 1e5, ignition=fires))

    return Assumption(
        "left out", "gas", N_("no table [gas] in the file"), unit="bar", low=low, high=high,
        values=(("ignition", fires),), vary=vary, figures=figures, sentence=sentence,
    )  # fmt: skip


def gas_values(engine: Engine, own: Cycle) -> Iterator[Assumption]:
    """What is assumed of a cycle, and what one measured trace stands for.

    Where the charge is kept that a run by hand would change, the reason says so.
    """
    yield from _firing(engine)
    swept = own.volumes.swept
    if swept.max() > UNLIKE * swept.min():
        yield ONE_HEAT
    for each in _gas_values(engine, own):
        ends = (each.low, each.high)
        charge = each.path.removeprefix("gas.") in CHARGE
        switched = (
            not charge
            and isinstance(each.vary, _Held)
            and any(end is not None and each.vary.switches(engine, end) for end in ends)
        )
        yield replace(each, reason=AT_SAME_CHARGE) if switched else each


def _firing(engine: Engine) -> Iterator[Assumption]:
    """The angles at which a firing order fires, where more than one set of them fits it."""
    other = other_angles(engine)
    if other is None:
        return
    own, others = (
        f"{', '.join(f'{each:.6g}' for each in angles)} deg"
        for angles in (firing_angles(engine), other)
    )

    def vary(each: Engine, _value: float) -> Engine:
        return with_values(each, firing_angles=tuple(map(radians, other)))

    yield Assumption(
        "assumed", "firing_angles", N_("the most even ones that fit the firing order"), own, "",
        1.0, 1.0, values=(("other", others),), named=True, vary=vary,
    )  # fmt: skip


def _gas_values(engine: Engine, own: Cycle) -> Iterator[Assumption]:
    if engine.gas is None:
        yield Assumption(
            "missing", "gas", N_("no table [gas] in the file: its whole cycle is assumed"),
            sentence=N_("Not in the file, a usual cycle is assumed: {paths}."),
        )  # fmt: skip
    measured = engine.gas is not None and engine.gas.trace is not None
    if measured:
        yield Assumption(
            "assumed", "gas.trace", N_("one measured trace is used at every speed and load"),
            explained=True,
        )  # fmt: skip
    values = _values_of_points(engine, own)

    def held(name: str, factor: float) -> Vary | None:
        vary = with_gas_value(name, factor)
        return vary if measured or name == "imep" else _held(own, vary)

    for name in own.assumed:
        if name in OF_TRACE and measured:
            continue  # the measured pressure has it
        path = f"gas.{name}"
        value = values.get(name)
        if name == "combustion_start" and isinstance(value, float):
            yield Assumption(
                "assumed", path, USUAL, degrees(value), "deg",
                degrees(value - START_ENDS), degrees(value + START_ENDS),
                vary=held(name, radians(1.0)),
            )  # fmt: skip
        elif name in GAS_ENDS and isinstance(value, float):
            unit = UNITS_OF_GAS.get(name, "")
            factor = FACTORS.get(unit, 1.0)
            vary = held(name, factor)
            low, high = gas_ends(engine, own, name, value, vary=vary)
            reason = USUAL
            if name == "intake_pressure" and throttled(own) < 1.0:
                reason = N_("as with the throttle open, which burns too lean for a spark")
            yield Assumption(
                "assumed", path, reason, value / factor, unit,
                low / factor, high / factor, vary=vary,
            )  # fmt: skip
        elif name in CHOICES and value in CHOICES[name]:
            yield from _choices(engine, own, name, str(value))
        else:
            yield Assumption("assumed", path, USUAL, _plain(value))
    if own.values.get("process") == "heat-release" and (own.values["charges"] or not measured):
        yield from (
            each if measured else replace(each, vary=_held(own, each.vary))
            for each in valves(engine)
        )


def _choices(engine: Engine, own: Cycle, name: str, value: str) -> Iterator[Assumption]:
    """What is assumed without a number: one of two, and a friction that counts with the load."""
    other = next(each for each in CHOICES[name] if each != value)
    usual = N_("as compression ratio, size and speed say") if name == "ignition" else USUAL
    tried = [(other, usual)]
    if name == "friction" and _rubs_with_load(engine, own):
        tried.append((value, N_("counted with the load, as the file gives no friction")))
    for choice, reason in tried:
        yield Assumption(
            "assumed", f"gas.{name}", reason, value, "", 1.0, 1.0, values=(("other", choice),),
            named=True, vary=with_gas_choice(name, choice, ignition=own.values["ignition"]),
        )  # fmt: skip


def _rubs_with_load(engine: Engine, own: Cycle) -> bool:
    """Whether an assumed friction counts with a load that alternates (`uneven.friction_apart`)."""
    from crankstar.dynamics.uneven import takes_work

    drive = engine.drive or Drive()
    alternates = bool(drive.load_torque or drive.load_exponent)
    return alternates and not own.friction_said and takes_work(own)


def valves(engine: Engine) -> Iterator[Assumption]:
    """The timing of valves or ports that a file does not give."""
    own = timing(engine.valves, cycle=engine.cycle)
    for name in own.assumed:
        yield Assumption(
            "assumed", f"valves.{name}", USUAL,
            degrees(getattr(own, name)), "deg", *VALVE_ENDS[engine.cycle][name],
            vary=with_valve_angle(name),
        )  # fmt: skip


@dataclass(frozen=True)
class _Held:
    """The change of a value that takes no charger away and adds none: then the charge stays.

    Whether an engine has one is assumed by its load alone.
    """

    own: Cycle
    vary: Vary
    kept: Mapping[str, Any]

    def switches(self, engine: Engine, value: float) -> bool:
        """Whether the charge would be that with a charger instead of without, or the other."""
        try:
            again = cycle(self.vary(engine, value), point=self.own.name, speed=self.own.speed)
        except GasError:
            return False
        return charged(again) != charged(self.own)

    def __call__(self, engine: Engine, value: float) -> Engine:
        """The changed engine."""
        changed = self.vary(engine, value)
        if not self.switches(engine, value):
            return changed
        gas = changed.gas or Gas()
        return with_values(changed, gas=with_values(gas, **{**self.kept, **_set(gas)}))


def _held(own: Cycle, vary: Vary | None) -> Vary | None:
    """The change of a value at the same charge; between two points each has a charge of its own."""
    kept = {key: own.values[key] for key in CHARGE if key in own.assumed and key in own.values}
    if vary is None or "intake_pressure" not in kept or len(own.shares) > 1:
        return vary
    return _Held(own, vary, kept)


def _set(gas: Gas) -> Mapping[str, float]:
    """What a file gives of the charge itself."""
    return {key: size for key in CHARGE if (size := getattr(gas, key)) is not None}


def _values_of_points(engine: Engine, own: Cycle) -> Mapping[str, Any]:
    """What is assumed of a cycle; between two points that of the nearer which lacks the value.

    Between points the cycle itself has values in the midst of assumed and given ones.
    """
    if len(own.shares) < 2:
        return own.values
    out = dict(own.values)
    for name, _share in sorted(own.shares, key=lambda each: each[1]):
        point = cycle(engine, point=name)
        out |= {key: point.values[key] for key in point.assumed if key in point.values}
    return out


def _plain(value: Any) -> float | str | None:
    return value if isinstance(value, float | str) else None


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
