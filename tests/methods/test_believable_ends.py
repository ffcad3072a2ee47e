"""No end of an assumed value of a cycle is one that the program itself doubts."""

from __future__ import annotations

from math import cos, pi, radians, sqrt
from typing import Any

import pytest

from crankstar.analysis.assumptions import Assumption
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.mechanics.doubts import point_doubts
from crankstar.mechanics.gas import cycle
from crankstar.studies.answers import rests_on, torques
from crankstar.studies.assumed_gas import gas_values
from crankstar.tables.assumptions import assumption_lines

FOUR: dict[str, Any] = {
    "name": "four",
    "firing_order": [1, 3, 4, 2],
    "speed": "9500 rpm",
    "cylinder": {
        "bore": "67 mm",
        "stroke": "42.5 mm",
        "rod_length": "92 mm",
        "reciprocating_mass": "200 g",
    },
    "gas": {
        "compression_ratio": 13,
        "point": [
            {"name": "idle", "speed": "1200 rpm", "bmep": "0.1 bar"},
            {"name": "full", "speed": "9000 rpm", "bmep": "12 bar"},
        ],
    },
    "layout": {"type": "inline", "bore_pitch": "75 mm"},
}
TWO: dict[str, Any] = {
    **FOUR,
    "cycle": "two-stroke",
    "gas": {"bmep": "10 bar", "friction_pressure": "2 bar"},
}
SCAVENGED: dict[str, Any] = {
    **TWO,
    "gas": {"imep": "4 bar", "intake_pressure": "1.3 bar", "process": "otto"},
}


def engine_with(base: dict[str, Any], **gas: str) -> Engine:
    return engine_of({**base, "gas": {**base["gas"], **gas}}, name="four")


def values(engine: Engine, point: str = "") -> dict[str, Assumption]:
    return {each.path: each for each in gas_values(engine, cycle(engine, point=point))}


def ratio_by_hand(engine: Engine, pressure: float, point: str) -> float:
    """Air when the intake closes, 50 degrees after bottom, over fuel of 43 MJ/kg."""
    found = cycle(engine, point=point)
    r, rod, area = 0.0425 / 2, 0.092, pi / 4 * 0.067**2
    theta = radians(180 - 50)
    depth = r + rod - r * cos(theta) - sqrt(rod**2 - (r * (1 - cos(theta) ** 2) ** 0.5) ** 2)
    volume = area * depth + area * 2 * r / 12
    air = pressure * volume / (287.05 * 340.0)
    efficiency = found.imep * area * 2 * r / (air / (found.air_fuel_ratio or 1.0) * 43e6)
    assert 0.1 < efficiency < 0.5
    return air * 43e6 * efficiency / (found.imep * area * 2 * r)


def test_the_least_charge_of_an_idle_is_one_in_which_fuel_burns() -> None:
    own = values(engine_with(FOUR), "idle")["gas.intake_pressure"]
    assert own.low is not None
    low, high = 0.05, 1.0
    while high - low > 1e-5:
        middle = (low + high) / 2
        again = cycle(engine_with(FOUR, intake_pressure=f"{middle} bar"), point="idle")
        rich = (again.air_fuel_ratio or 0.0) < 0.8 * 14.7
        low, high = (middle, high) if rich else (low, middle)
    assert own.low == pytest.approx(high, rel=1e-3)
    there = engine_with(FOUR, intake_pressure=f"{own.low} bar")
    assert ratio_by_hand(there, 1e5 * own.low, "idle") == pytest.approx(0.8 * 14.7, rel=1e-2)


@pytest.mark.parametrize(
    ("base", "point", "path"),
    [
        (FOUR, "idle", "gas.intake_pressure"),
        (FOUR, "full", "gas.intake_pressure"),
        (TWO, "", "gas.intake_pressure"),
        (SCAVENGED, "", "gas.exhaust_pressure"),
        (SCAVENGED, "", "gas.gamma"),
    ],
)
def test_no_end_is_doubted(base: dict[str, Any], point: str, path: str) -> None:
    engine = engine_with(base)
    own = cycle(engine, point=point)
    assert "doubt.charge" not in {each.code for each in point_doubts(engine, own)}
    known = {each.code for each in point_doubts(engine, own)}
    row = values(engine, point)[path]
    assert row.vary is not None
    assert row.low is not None
    assert row.high is not None
    assert isinstance(row.value, float)
    assert row.low <= row.value <= row.high
    for end in (row.low, row.high):
        changed = row.vary(engine, end)
        again = cycle(changed, point=point)
        assert {each.code for each in point_doubts(changed, again)} <= known, end


@pytest.mark.release
@pytest.mark.parametrize("base", [FOUR, {**TWO, "gas": {"bmep": "10 bar"}}])
def test_a_friction_beyond_its_correlation_has_a_size(base: dict[str, Any]) -> None:
    engine = engine_with(base)
    answer = torques(engine, cycle)
    [row] = [each for each in rests_on(engine, answer) if each.path.endswith("friction_pressure")]
    usual = 0.97 + 0.15 * 7 + 0.05 * 7**2  # Barnes-Moss at 7000 rpm
    assert (row.status, row.low, row.high) == (
        "doubtful",
        pytest.approx(usual, rel=1e-9),
        pytest.approx(usual, rel=1e-9),
    )
    assert row.moved is not None
    again = engine_with(base, friction_pressure=f"{usual} bar")
    load = float(base["gas"].get("bmep", "12 bar").split()[0])
    assert cycle(again).imep / 1e5 == pytest.approx(load + usual, rel=1e-6)
    key = row.moved.quantity, row.moved.order
    assert row.moved.high == pytest.approx(torques(again, cycle).figures(again)[key], rel=1e-9)
    assert row.moved.high == row.moved.low != row.moved.now
    [line] = assumption_lines([row])
    assert "measured up to 7000 rpm, where it gives 4.47 bar, gives" in line
    assert "With 4.47 bar the" in line
