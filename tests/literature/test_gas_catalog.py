"""The cycles of the catalog give the power and the torque that their sources publish.

The numbers are those of the sources that the files name, in the units of the source: power in kW,
PS or hp, torque in N m, kgf m or lbf ft. The files hold mean effective pressures computed from
them, so that a slip in a swept volume, a cycle or a unit shows here.
"""

from __future__ import annotations

from math import pi

import pytest

import crankstar
from crankstar.mechanics.doubts import doubts
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import gas_torque

KW, PS, HP = 1e3, 735.49875, 745.69987
KGFM, LBFFT = 9.80665, 1.3558179
POWER = {
    ("bmw-g650", "full"): (35 * KW, 6500),
    ("bmw-f800", "full"): (62.5 * KW, 8000),
    ("yamaha-mt-07", "full"): (75 * PS, 9000),
    ("ducati-900ss", "full"): (80 * HP, 7500),
    ("fiat-twinair", "full"): (62.5 * KW, 5500),
    ("triumph-675", "full"): (92 * KW, 12500),
    ("suzuki-hayabusa", "full"): (146 * KW, 9800),
    ("yamaha-r1-crossplane", "full"): (182 * HP, 12500),
    ("audi-25-tfsi", "full"): (250 * KW, 6500),
    ("bmw-m52b28", "full"): (190.3 * HP, 5300),
    ("bmw-s65", "full"): (309 * KW, 8300),
    ("ferrari-f136", "full"): (570 * PS, 9000),
    ("merlin", "full"): (1260 * HP, 3000),
    ("pratt-whitney-wasp", "full"): (600 * HP, 2250),
    ("international-vt275", "full"): (200 * HP, 2700),
    ("napier-deltic", "full"): (2000 * HP, 2000),
    ("jumo-205", "full"): (610 * HP, 2200),
    ("kr250-production", "full"): (33.5 * KW, 10000),
    ("man-s50mc-c", "full"): (9480 * KW, 127),
    ("man-s90mc-c", "full"): (34230 * KW, 76),
}
TORQUE = {
    ("bmw-g650", "most torque"): (60, 5000),
    ("bmw-f800", "most torque"): (8.7 * KGFM, 5800),
    ("yamaha-mt-07", "most torque"): (68, 6500),
    ("ducati-900ss", "most torque"): (77, 6500),
    ("fiat-twinair", "most torque"): (145, 1900),
    ("triumph-675", "most torque"): (72, 11750),
    ("suzuki-hayabusa", "most torque"): (155, 7200),
    ("yamaha-r1-crossplane", "most torque"): (85 * LBFFT, 10000),
    ("audi-25-tfsi", "most torque"): (450, 5300),
    ("bmw-m52b28", "most torque"): (280, 3950),
    ("bmw-s65", "most torque"): (400, 3900),
    ("ferrari-f136", "most torque"): (540, 6000),
    ("international-vt275", "most torque"): (440 * LBFFT, 1850),
    ("kr250-production", "most torque"): (3.7 * KGFM, 8000),
}
ROUNDED = {"man-s50mc-c": 2e-3, "man-s90mc-c": 2e-3}
"""What the rounding of a published mean effective pressure makes; 1e-4 of others."""


@pytest.mark.many(first=32)
@pytest.mark.parametrize(("name", "point"), [*POWER, *TORQUE])
def test_each_cycle_gives_the_published_power_or_torque(name: str, point: str) -> None:
    computed = cycle(crankstar.load(name), point=point)
    assert computed.speed is not None
    assert computed.friction is not None
    places = computed.volumes
    swept = float(places.swept[[*places.kind]].sum())
    brake = float(gas_torque(computed).mean.sum()) - computed.friction * swept / places.cycle
    if (name, point) in POWER:
        power, rpm = POWER[name, point]
        wanted = power / (rpm * pi / 30)
    else:
        wanted, rpm = TORQUE[name, point]
    assert computed.speed == pytest.approx(rpm * pi / 30)
    assert brake == pytest.approx(wanted, rel=ROUNDED.get(name, 1e-4))
    # the law of the mean effective pressure, on the other road
    assert brake == pytest.approx((computed.bmep or 0.0) * swept / places.cycle)


@pytest.mark.parametrize("name", sorted({name for name, _point in POWER}))
def test_each_engine_with_gas_has_a_sensible_cycle_at_every_load(name: str) -> None:
    engine = crankstar.load(name)
    assert engine.gas is not None
    points = [point.name for point in engine.gas.points]
    assert points[0] == "full"
    assert len(points) >= 2
    assert [fault.code for fault in doubts(engine)] == []
    peaks = [cycle(engine, point=point).peak for point in points]
    assert 35e5 < peaks[0] < 200e5
    assert min(peaks) == peaks[-1]


def test_the_slow_marine_engines_reach_the_published_peak() -> None:
    for name in ("man-s50mc-c", "man-s90mc-c"):
        computed = cycle(crankstar.load(name), point="full")
        assert computed.peak / 1e5 == pytest.approx(150, abs=5)  # marinegyaan.com, 19 bar
        assert 19.8e5 < computed.imep < 20.3e5
