"""Gas torque as tables: the cycle and what is assumed, by order; gears, uneven running."""

from __future__ import annotations

from collections.abc import Sequence
from math import degrees, pi
from typing import NamedTuple

from crankstar.analysis.document import ROW_UNIT, Column, Document, Table, Value, for_each, remarks
from crankstar.dynamics.uneven import Running, load_taken, takes_work
from crankstar.engine.dead_centres import pistons
from crankstar.engine.engine import Engine
from crankstar.engine.valves import timing
from crankstar.language.messages import N_, _, _n
from crankstar.language.numbers import RPM, number, numbers_text, rpm_of
from crankstar.language.quoting import one_line
from crankstar.language.shown_units import quantity_text
from crankstar.language.written import joined
from crankstar.mechanics.doubts import point_doubts
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.gas_loads import LoadedTorques
from crankstar.mechanics.gas_torque import GasTorque, brake_torque, gas_torque
from crankstar.mechanics.lacking import running_sentence, without_running
from crankstar.tables.conditions import unverified_gas
from crankstar.tables.gas_words import (
    at_points,
    burning_words,
    cycle_state,
    state_facts,
    weaker_facts,
)
from crankstar.tables.headings import heading
from crankstar.tables.meshes import mesh_table
from crankstar.tables.torque_orders import by_order, order_tables
from crankstar.tables.torque_parts import (
    changes_table,
    side_thrust_tables,
    tangential_table,
    unchanged_sentence,
)

CORRELATIONS = {
    "spark-ignition": N_("Friction as of motored spark-ignition engines."),
    "diesel": N_("Friction as of motored Diesel engines."),
}
VALUES = {
    "compression_ratio": (N_("compression ratio"), 1.0, ""),
    "gamma": (N_("ratio of specific heats"), 1.0, ""),
    "intake_pressure": (N_("intake pressure"), 1e-5, "bar"),
    "exhaust_pressure": (N_("exhaust pressure"), 1e-5, "bar"),
    "peak_pressure": (N_("limit of pressure"), 1e-5, "bar"),
    "crankcase_pressure": (N_("crankcase pressure"), 1e-5, "bar"),
    "intake_temperature": (N_("intake temperature"), 1.0, "K"),
    "wall_temperature": (N_("wall temperature"), 1.0, "K"),
    "combustion_start": (N_("start of combustion"), 180 / pi, "deg"),
    "combustion_duration": (N_("duration of combustion"), 180 / pi, "deg"),
    "wiebe_a": (N_("Wiebe's a"), 1.0, ""),
    "wiebe_m": (N_("Wiebe's m"), 1.0, ""),
}
"""The values of a cycle that readers are told: name, factor from SI, unit."""
IGNITIONS = {
    "spark": N_("Ignition: by spark, as sizes say; gas.ignition says it for certain."),
    "compression": N_(
        "Ignition: by compression, as compression ratio, size and speed say; gas.ignition says it "
        "for certain."
    ),
}
PROCESSES = {
    "otto": N_("ideal Otto cycle"),
    "diesel": N_("ideal Diesel cycle"),
    "limited-pressure": N_("ideal cycle with limited pressure"),
    "heat-release": N_("heat release by Wiebe's function"),
}


def torque_document(
    engine: Engine,
    cycle: Cycle,
    *,
    running: Running | None = None,
    orders: Sequence[float] | None = None,
    wheel: Wheel | None = None,
    loads: LoadedTorques | None = None,
) -> Document:
    """Torque by order, what a cycle does, and how evenly the engine runs.

    `wheel` is a flywheel that was asked for, `loads` are those of handbook harmonics.
    """
    found = gas_torque(cycle)
    waves = by_order(engine, cycle, found)
    mean = brake_torque(cycle)
    turning = cycle.speed
    lacking = "" if running is not None else without_running(engine, turning)
    facts = {
        "format": 1,
        "engine": engine.name,
        **state_facts(cycle_state(cycle)),
        "speed_rpm": rpm_of(turning),
        "mean_torque": float(found.mean.sum()),
        "brake_torque": mean,
        "power": None if turning is None else float(found.mean.sum()) * turning,
        "brake_power": None if turning is None or mean is None else mean * turning,
        "imep": cycle.imep,
        "bmep": cycle.bmep,
        "peak_pressure": cycle.peak,
        "air_fuel_ratio": cycle.air_fuel_ratio,
        "charge_estimated": cycle.boosted,
        "irregularity": None if running is None else running.irregularity,
        "without_running": lacking or None,
        "flywheel": None if wheel is None else {**wheel._asdict(), "unit": "kg*m^2"},
        "off": list(cycle.off),
        "weaker": weaker_facts(cycle),
        "ignition": cycle.values["ignition"],
        "assumed": list(cycle.assumed),
        "doubts": [fault.sentence for fault in point_doubts(engine, cycle)],
        "units": {"torque": "N*m", "power": "W", "pressure": "Pa"},
    }
    gears = mesh_table(engine, cycle, running=running)
    more = [] if gears is None else [gears]
    more += side_thrust_tables(engine, cycle)
    told = [*_other_points(engine, cycle), *notes(engine, cycle), _proviso(engine, cycle)]
    told.append(running_sentence(lacking))
    pairs = [] if wheel is None else [wheel_table(wheel)]
    if running is not None:
        pairs = [running_table(running), *pairs]
        changed = changes_table(engine, running)
        more += for_each(changed, changed)
        told += [] if changed.rows else [unchanged_sentence()]
    more += [] if loads is None else [tangential_table(loads)]
    work = work_table(cycle, found)
    return Document(
        engine.name,
        (
            heading(engine),
            work,
            *order_tables(engine, waves, orders or ()),
            *pairs,
            *more,
            *remarks(*told, kind="note"),
            *remarks(*assumed_notes(engine, cycle), unverified_gas(engine), kind="assumed"),
            *remarks(*(fault.sentence for fault in point_doubts(engine, cycle)), kind="doubt"),
        ),
        facts,
    )


def load_sentence(cycle: Cycle) -> str:
    """The load at which a cycle was computed, and whether it is assumed."""
    pressure = quantity_text(cycle.imep, "Pa")
    if "imep" in cycle.assumed:
        return _("At {pressure} indicated mean effective pressure, assumed.", pressure=pressure)
    return _("At {pressure} indicated mean effective pressure.", pressure=pressure)


def charge_sentences(cycle: Cycle) -> list[str]:
    """The charge pressure that was estimated from the load, with the air-fuel ratio that it has."""
    if not cycle.boosted or cycle.air_fuel_ratio is None:
        return []
    return [
        _(
            "The charge pressure, {pressure}, is estimated from the load: with it the air-fuel "
            "ratio is {ratio}, of a charge at {temperature} K. gas.intake_pressure gives it.",
            pressure=quantity_text(cycle.values["intake_pressure"], "Pa"),
            ratio=number(float(f"{cycle.air_fuel_ratio:.3g}")),
            temperature=number(cycle.values["intake_temperature"]),
        )
    ]


class Wheel(NamedTuple):
    """A wanted degree of irregularity, and the inertia that gives it, kg m^2.

    `inertia` is that of crankshaft, flywheel and what is coupled to them, `moving` the mean one of
    pistons and rods beside it.
    """

    irregularity: float
    inertia: float
    moving: float


def wheel_table(wheel: Wheel) -> Table:
    """The flywheel for a wanted degree of irregularity."""
    return _pairs(
        "wheel",
        _("Flywheel for a degree of irregularity"),
        [
            (_("degree of irregularity"), "irregularity", wheel.irregularity, ""),
            (
                _("inertia of crankshaft, flywheel and coupled parts"),
                "inertia",
                wheel.inertia,
                "kg*m^2",
            ),
            (_("mean inertia of pistons and rods beside it"), "moving", wheel.moving, "kg*m^2"),
        ],
    )


def work_table(cycle: Cycle, found: GasTorque) -> Table:
    """Mean effective pressures, torque and power of the operating point."""
    mean, brake = float(found.mean.sum()), brake_torque(cycle)
    name = _("indicated mean effective pressure")
    if cycle.off or cycle.weaker:
        name = _("indicated mean effective pressure, mean of all cylinders")
    rows: list[tuple[Value, ...]] = [
        (name, "imep", cycle.imep, "Pa"),
        (_("peak pressure"), "peak_pressure", cycle.peak, "Pa"),
        (_("mean gas torque"), "mean_torque", mean, "N*m"),
    ]
    burning = found.mean.size > len({*cycle.off})
    if cycle.air_fuel_ratio is not None and burning:
        warm = number(cycle.values["intake_temperature"])
        name = _("air-fuel ratio (charge of {temperature} K)", temperature=warm)
        rows.insert(2, (name, "air_fuel_ratio", cycle.air_fuel_ratio, ""))
    if brake is not None:
        rows += [
            (_("friction mean effective pressure"), "friction_pressure", cycle.friction, "Pa"),
            (_("brake torque"), "brake_torque", brake, "N*m"),
        ]
        if cycle.speed is not None:
            rows.append((_("brake power"), "brake_power", brake * cycle.speed, "W"))
    title = _("One cycle")
    if cycle.speed is not None:
        title = _("One cycle at {rpm} rpm", rpm=number(cycle.speed * RPM))
    return _pairs("work", burning_words(at_points(title, cycle), cycle), rows)


def running_table(running: Running) -> Table:
    """How the speed goes over a cycle."""
    ends = running.extremes
    irregular = running.irregularity
    return _pairs(
        "running",
        _("Uneven running"),
        [
            (_("inertia of all that turns"), "inertia", running.inertia, "kg*m^2"),
            (_("fluctuation of energy"), "fluctuation", running.fluctuation, "J"),
            (_("degree of irregularity"), "irregularity", irregular, ""),
            (_("the same, linear estimate"), "linear", running.linear, ""),
            (_("least speed"), "least_rpm", ends.least * RPM, "rpm"),
            (_("crank angle of the least speed"), "least_deg", degrees(ends.least_at), "deg"),
            (_("greatest speed"), "greatest_rpm", ends.greatest * RPM, "rpm"),
            (
                _("crank angle of the greatest speed"),
                "greatest_deg",
                degrees(ends.greatest_at),
                "deg",
            ),
        ],
    )


def _pairs(key: str, title: str, rows: Sequence[tuple[Value, ...]]) -> Table:
    """Quantities one under another: in words, by name for machines, value, unit."""
    columns = (
        Column("", kind="text", label=True),
        Column("", kind="text", key="quantity", machine=True),
        Column(_("value"), ROW_UNIT, key="value"),
        Column(_("unit"), kind="unit", key="unit"),
    )
    return Table(title, columns, tuple(rows), key=key)


def _valued(name: str, value: float) -> str:
    """A value of a cycle with its name and unit."""
    words, factor, unit = VALUES[name]
    return joined(" ", filter(None, [_(words), number(value * factor), unit]))


def _other_points(engine: Engine, cycle: Cycle) -> list[str]:
    """The operating points that could have been asked for, as a sentence."""
    points = () if engine.gas is None else engine.gas.points
    names = [point.name for point in points if point.name != cycle.name]
    if not names:
        return []
    known = one_line(", ".join(names), longest=400)
    return [_("Other operating points, for --point: {points}.", points=known)]


def assumed_notes(engine: Engine, cycle: Cycle) -> list[str]:
    """What is assumed of a cycle, and what of its load is left out, as sentences."""
    lines: list[str] = []
    assumed = [_valued(name, cycle.values[name]) for name in cycle.assumed if name in VALUES]
    if assumed and (engine.gas is None or engine.gas.trace is None or cycle.values["charges"]):
        lines.append(
            _(
                "Assumed, since the file does not say: {values}. The table [gas] gives them.",
                values=joined(", ", assumed),
            )
        )
    if "ignition" in cycle.assumed:
        lines.append(_(IGNITIONS[cycle.values["ignition"]]))
    if "imep" in cycle.assumed:
        lines.append(
            _(
                "The load is assumed too: {pressure} indicated mean effective pressure in each "
                "cylinder that fires.",
                pressure=quantity_text(cycle.values.get("imep", cycle.imep), "Pa"),
            )
        )
    if (
        cycle.values["process"] == "heat-release"
        and timing(engine.valves, cycle=engine.cycle).assumed
    ):
        lines.append(_("Valve or port timing is assumed, see `crankstar strokes`."))
    if engine.drive is not None and engine.drive.load_torque and not takes_work(cycle):
        lines.append(
            _(
                "The course of the load is left out: gas and friction leave no work that the load "
                "could take."
            )
        )
    return lines


def notes(engine: Engine, cycle: Cycle) -> list[str]:
    """What a cycle is, as sentences: the process, and what the charge is."""
    lines = [*_pressure_lines(engine, cycle), *charge_sentences(cycle)]
    moving = pistons(engine)
    facing = [number for number, row in moving.place.items() if moving.crown[row] < 0]
    if facing:
        lines.append(
            _n(
                "Taken to face the other piston of its chamber, against which it moves: piston "
                "{numbers}.",
                "Taken to face the other pistons of their chambers, against which they move: "
                "pistons {numbers}.",
                len(facing),
                numbers=numbers_text(facing),
            )
        )
    known = cycle.values.get("friction_pressure") is not None
    correlation = None if known else CORRELATIONS.get(cycle.values["friction"])
    if cycle.speed is not None and correlation is not None:
        lines.append(_(correlation))
    if load_taken(engine, cycle) is not None and cycle.friction_said and cycle.friction is None:
        lines.append(
            _(
                "Friction is left out of the load, and counts with it: its correlation needs the "
                'speed. Give the speed, as in --speed "3000 rpm", or gas.friction_pressure.'
            )
        )
    return lines


def _pressure_lines(engine: Engine, cycle: Cycle) -> list[str]:
    """Where the pressure comes from."""
    lines: list[str] = []
    if engine.gas is not None and engine.gas.trace is not None:
        lines.append(_("Pressure as measured."))
        if cycle.values["charges"]:
            whence = {
                name: _("of the file")
                if getattr(engine.gas, f"{name}_pressure")
                else _("as measured")
                for name in ("intake", "exhaust")
            }
            lines.append(
                _(
                    "Without combustion a cylinder compresses a charge of {charge} ({of_charge}) "
                    "and pushes it out against {exhaust} ({of_exhaust}).",
                    charge=quantity_text(cycle.values["intake_pressure"], "Pa"),
                    of_charge=whence["intake"],
                    exhaust=quantity_text(cycle.values["exhaust_pressure"], "Pa"),
                    of_exhaust=whence["exhaust"],
                )
            )
    else:
        process = _(PROCESSES[cycle.values["process"]])
        lines.append(_("Pressure: {process}.", process=process))
    return lines


def _proviso(engine: Engine, cycle: Cycle) -> str:
    """What the rolling moment is."""
    if load_taken(engine, cycle) is not None:
        return _(
            "The block rolls by the reaction to all of the alternating torque. Where the load, "
            "such as a generator, stands on the same frame, its mean torque stays inside, and what "
            "alternates of its course acts on the frame too. Gas makes no force and no couple."
        )
    return _(
        "The block rolls by the reaction to all of the alternating torque, wherever the load "
        "stands. Only the mean torque stays inside where the load, such as a generator, stands "
        "on the same frame. Gas makes no force and no couple."
    )
