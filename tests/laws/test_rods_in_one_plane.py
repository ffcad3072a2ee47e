"""Rods that are taken to turn in one plane, or alike, where hardly any engine has them so."""

from __future__ import annotations

import tomllib
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run
from tests.files.conftest import run

import crankstar
from crankstar.analysis.assumptions import Assumption
from crankstar.engine.engine import Engine
from crankstar.engine.proportions import proportion
from crankstar.files import engine_of
from crankstar.files.estimate import estimated
from crankstar.mechanics.doubts import doubts
from crankstar.studies.answers import amplitudes, rests_on
from crankstar.studies.assumed_masses import masses
from crankstar.studies.load_answers import bearing_peaks

__all__ = ["run"]

STAR = """
name = "nine without articulation"
firing_order = [1, 3, 5, 7, 9, 2, 4, 6, 8]
speed = "2300 rpm"
[cylinder]
bore = "155 mm"
stroke = "174 mm"
rod_ratio = 4
reciprocating_mass = "3.4 kg"
rotating_mass = "1.5 kg"
[layout]
type = "radial"
rows = [{ cylinders = [1, 2, 3, 4, 5, 6, 7, 8, 9], master = 1 }]
"""
SPEED = 2300 * np.pi / 30
BOXER = """
name = "boxer four"
firing_order = [1, 3, 2, 4]
speed = "5000 rpm"
[cylinder]
bore = "92 mm"
stroke = "79 mm"
rod_length = "131 mm"
reciprocating_mass = "560 g"
rotating_mass = "480 g"
[layout]
type = "boxer"
banks = [{ bearing = "90 deg", cylinders = [1, 3] }, { bearing = "-90 deg", cylinders = [2, 4] }]
throws = ["0 deg", "180 deg"]
"""
EIGHT = """
name = "flat-plane eight"
firing_order = [1, 8, 3, 6, 4, 5, 2, 7]
speed = "8000 rpm"
[cylinder]
bore = "92 mm"
stroke = "81 mm"
rod_length = "140 mm"
reciprocating_mass = "480 g"
rotating_mass = "450 g"
[layout]
type = "vee"
banks = [
  { bearing = "-45 deg", cylinders = [1, 2, 3, 4] },
  { bearing = "45 deg", cylinders = [5, 6, 7, 8] },
]
throws = ["0 deg", "180 deg", "180 deg", "0 deg"]
"""


def tree_of(text: str, **layout: Any) -> dict[str, Any]:
    tree = tomllib.loads(text)
    tree["layout"] |= layout
    return tree


def of(engine: Engine, path: str) -> list[Assumption]:
    return [each for each in rests_on(engine, amplitudes(engine)) if each.path == path]


def star_force(order: int, *, knuckle: float, slave: float, extra: float = 0.0) -> float:
    """The force (N) of the nine, all masses traced round a turn in the plane, master in line.

    Slave rods of the length `slave` (m); `extra` (kg) on the crankpin.
    """
    r, rod = 0.087, 0.348
    theta = np.arange(256) * 2 * np.pi / 256
    pin = r * np.exp(1j * theta)  # up + i right
    up = pin.real + np.sqrt(rod**2 - pin.imag**2)
    along = (up - pin) / rod
    total = 3.4 * up + (1.5 + extra) * pin
    for number in range(1, 9):
        axis = np.exp(1j * number * 2 * np.pi / 9)
        joint = pin + knuckle * along * axis
        seen = joint / axis
        reach = seen.real + np.sqrt(slave**2 - seen.imag**2)
        total = total + 3.4 * reach * axis + 1.5 * joint
    waves = np.fft.fft(total) / 256
    return float((abs(waves[order]) + abs(waves[-order])) * (order * SPEED) ** 2)


def force(engine: Engine, order: int) -> float:
    own = crankstar.spectra.selected(crankstar.total(crankstar.balance(engine)).force, order)
    return float(abs(own.forward).sum() + abs(own.backward).sum())


def test_nine_rods_on_one_pin_are_doubted_with_the_force_of_slave_rods(run: Run) -> None:
    engine = engine_of(tree_of(STAR))
    (fault,) = [each for each in doubts(engine) if each.code == "doubt.central-rods"]
    assert fault.values["count"] == 9
    (row,) = of(engine, "layout.knuckle_radius")
    assert (row.low, row.high) == pytest.approx((60.9, 78.3))
    assert row.vary is not None
    assert row.moved is not None
    assert row.moved.now == pytest.approx(0.0, abs=1e-6)
    assert row.moved.low > 100.0  # N m of the first order
    tried, given = row.vary(engine, 70.0), engine_of(tree_of(STAR, knuckle_radius="70 mm"))
    assert force(engine, 2) == pytest.approx(0.0, abs=1e-6)
    for order in (1, 2, 4):
        own = star_force(order, knuckle=0.07, slave=0.278)
        assert force(tried, order) == pytest.approx(own, rel=1e-9)
        assert force(given, order) == pytest.approx(own, rel=1e-9)
    Path("star.toml").write_text(STAR)
    for command in ("check", "analyze", "verdict", "bearings"):
        assert "9 rods turn about one crankpin" in " ".join(run(command, "star.toml").out.split())


@pytest.mark.parametrize("name", ["v2-90", "v8-cross-plane", "radial-9"])
def test_rods_that_can_be_where_they_are_are_not_doubted(name: str) -> None:
    assert "doubt.central-rods" not in [each.code for each in doubts(crankstar.load(name))]


def test_three_rods_in_one_plane_are_tried_on_the_one_in_the_middle() -> None:
    engine = crankstar.load("napier-lion")
    (row,) = of(engine, "layout.knuckle_radius")
    assert row.vary is not None
    links = [each.articulated for each in row.vary(engine, 50.0).cylinders]
    angles = Counter(round(np.degrees(each.angle)) for each in links if each is not None)
    assert angles == {-60: 4, 60: 4}


def test_a_boxer_without_a_pitch_has_the_couple_of_its_opposite_pins() -> None:
    """m r w^2 A_2 of two pairs whose middle is a half: 4 pistons d/2 off it, all in step."""
    engine = engine_of(tree_of(BOXER))
    (row,) = of(engine, "layout.bank_offset")
    pitch = proportion("bore pitch", "petrol").typical
    assert row.unit == "a"
    assert (row.low, row.high) == pytest.approx((0.35 / pitch, 0.65 / pitch))
    theta = np.arange(64) * 2 * np.pi / 64
    up = 0.0395 * np.cos(theta) + np.sqrt(0.131**2 - (0.0395 * np.sin(theta)) ** 2)
    size = 2 * abs(np.fft.fft(up)[2]) / 64
    whole = 4 * 0.56 * size * (2 * 5000 * np.pi / 30) ** 2 / 2
    assert row.moved is not None
    assert (row.moved.quantity, row.moved.order, row.moved.unit) == ("couple", 2.0, "N*a")
    ends = [whole * share / pitch for share in (0.35, 0.65)]
    assert (row.moved.low, row.moved.high) == pytest.approx(ends, rel=1e-6)
    given = engine_of(tree_of(BOXER, bore_pitch="113 mm"))
    (mm,) = of(given, "layout.bank_offset")
    assert mm.moved is not None
    assert (mm.moved.low, mm.moved.high) == pytest.approx(
        [whole * share * 0.092 for share in (0.35, 0.65)], rel=1e-6
    )
    peaks = rests_on(engine, bearing_peaks(engine, lambda _: None))
    (load,) = [each for each in peaks if each.path == "layout.bank_offset"]
    assert load.moved is not None
    assert load.moved.now == pytest.approx(0.0, abs=1e-6)
    assert load.moved.low > 4e3


def test_two_rods_on_a_pin_without_a_pitch_may_stand_beside_each_other() -> None:
    """The couple of order 2 is that of the pitch that is taken, in its unit."""
    (row,) = of(engine_of(tree_of(EIGHT)), "layout.bank_offset")
    (known,) = of(engine_of(tree_of(EIGHT, bore_pitch="104 mm")), "layout.bank_offset")
    assert row.moved is not None
    assert known.moved is not None
    pitch = proportion("bore pitch", "petrol").typical
    assert row.high == pytest.approx(0.3 / pitch)
    assert row.moved.high == pytest.approx(known.moved.high / (0.092 * pitch), rel=1e-6)


@pytest.mark.parametrize(
    ("text", "layout", "pins"),
    [(STAR, {}, 1), (STAR, {"knuckle_radius": "70 mm"}, 1), (EIGHT, {}, 4), (BOXER, {}, 4)],
)
def test_crankpins_have_one_mass_each_however_many_cylinders_share_them(
    text: str, layout: dict[str, Any], pins: int
) -> None:
    engine = engine_of(tree_of(text, **layout))
    (row,) = [each for each in masses(engine) if each.path == "cylinder.throw_mass"]
    kind = "aero" if text == STAR else "petrol"
    bore = engine.first.bore
    assert bore is not None
    assert row.vary is not None
    usual = proportion("crank pin", kind)
    for mass, coefficient in ((row.low, usual.low), (row.high, usual.high)):
        assert mass is not None
        throws = [each for shaft in row.vary(engine, mass).shafts for each in shaft.throws]
        whole = pins * coefficient * bore**3
        assert sum(each.throw_mass for each in throws) == pytest.approx(whole, rel=1e-9)


@pytest.mark.parametrize(("text", "pins"), [(EIGHT, 4), (BOXER, 4)])
def test_an_estimate_gives_each_crankpin_one_mass(text: str, pins: int) -> None:
    tree = tree_of(text)
    del tree["cylinder"]["rotating_mass"]
    found = estimated(tree)
    engine = engine_of(found.tree)
    whole = sum(each.throw_mass for shaft in engine.shafts for each in shaft.throws)
    usual = proportion("crank pin", found.kind).typical
    assert whole == pytest.approx(pins * usual * 0.092**3, rel=0.01)  # three digits are filled in


def test_a_master_rod_as_heavy_as_a_slave_rod_is_said() -> None:
    """The master's mass is on the crankpin: each kg adds r w^2 to the primary force."""
    engine = engine_of(tree_of(STAR, knuckle_radius="70 mm"))
    (row,) = of(engine, "cylinders.rotating_mass")
    assert (row.value, row.low, row.high) == pytest.approx((1.5, 3.0, 9.0))
    assert row.moved is not None
    assert (row.moved.quantity, row.moved.order) == ("force", 1.0)
    ends = [star_force(1, knuckle=0.07, slave=0.278, extra=mass - 1.5) for mass in (1.5, 3.0, 9.0)]
    assert (row.moved.now, row.moved.low, row.moved.high) == pytest.approx(ends, rel=1e-9)
    weighed = tree_of(STAR, knuckle_radius="70 mm")
    weighed["cylinders"] = [{"number": 1, "rotating_mass": "5 kg"}]
    known = engine_of(weighed)
    assert of(known, "cylinders.rotating_mass") == []
    own = star_force(1, knuckle=0.07, slave=0.278, extra=3.5)
    assert force(known, 1) == pytest.approx(own, rel=1e-9)


def test_slave_rods_of_the_usual_length_are_said_with_the_force_of_others() -> None:
    engine = engine_of(tree_of(STAR, knuckle_radius="70 mm"))
    (row,) = of(engine, "layout.slave_rod_length")
    assert row.vary is not None
    assert row.value == pytest.approx(278 / 87)
    for share in (0.98, 1.02):
        tried = row.vary(engine, share * 278 / 87)
        own = star_force(2, knuckle=0.07, slave=share * 0.278)
        assert force(tried, 2) == pytest.approx(own, rel=1e-9)
    given = engine_of(tree_of(STAR, knuckle_radius="70 mm", slave_rod_length="276 mm"))
    assert of(given, "layout.slave_rod_length") == []
