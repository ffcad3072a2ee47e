"""What an answer rests on: against own sums, over the catalog, and in what is printed."""

from __future__ import annotations

import json
from math import isfinite, pi

import numpy as np
import pytest
from tests.commands import Run
from tests.files.conftest import run

from crankstar.files import engine_of
from crankstar.files.catalog import load, names
from crankstar.mechanics.gas import cycle
from crankstar.studies.assumptions import Assumption, assumptions

__all__ = ["run"]


def of(found: tuple[Assumption, ...], path: str) -> Assumption:
    return next(each for each in found if each.path == path)


def primary_couple(masses: np.ndarray, turning: float, speed: float) -> float:
    """The maximum of the primary pitching couple of the in-line five, by its own phasors, N m."""
    phases = np.radians([0, 144, 216, 288, 72])
    z = 0.088 * np.array([2, 1, 0, -1, -2])
    star = abs(np.sum(z * np.exp(1j * phases)))
    return float((masses.mean() + turning) * 0.0464 * speed**2 * star)


def test_a_missing_rotating_mass_moves_the_primary_couple_as_own_phasors_say() -> None:
    engine = load("audi-25-tfsi")
    own = of(assumptions(engine), "cylinder.rotating_mass")
    assert own.moved is not None
    assert own.low is not None
    assert own.high is not None
    assert (own.status, own.value, own.moved.quantity, own.moved.order) == (
        "missing",
        0.0,
        "couple",
        1.0,
    )
    speed, masses = 6500 * pi / 30, np.full(5, 0.492)
    ends = [primary_couple(masses, each, speed) for each in (0.0, own.low, own.high)]
    # the firing order 1-2-4-5-3 with throws 144 deg apart
    assert (own.moved.now, own.moved.low, own.moved.high) == pytest.approx(ends, rel=1e-6)
    # the ranges of `crankstar estimate`: big end 182 to 529 g, crankpin 205 to 461 g
    assert (own.low, own.high) == pytest.approx((0.387, 0.990), abs=5e-4)


def test_forces_follow_the_square_of_an_unverified_speed() -> None:
    own = of(assumptions(load("audi-25-tfsi")), "speed")
    assert own.moved is not None
    assert own.moved.trial
    assert (own.moved.low, own.moved.high) == pytest.approx(
        (own.moved.now * 0.99**2, own.moved.now * 1.01**2)
    )


def test_an_assumed_rod_has_the_range_of_its_type() -> None:
    tree = {
        "name": "four",
        "speed": "6000 rpm",
        "cylinder": {"bore": "80 mm", "stroke": "80 mm", "reciprocating_mass": "500 g"},
        "layout": {"type": "inline", "throws": ["0 deg", "180 deg", "180 deg", "0 deg"]},
    }
    own = of(assumptions(engine_of(tree)), "cylinder.rod_length")
    assert own.moved is not None
    assert own.low is not None
    assert own.high is not None
    assert own.value == 4.0
    assert 2.5 < own.low < own.high < 5.5
    # secondary force of four pistons, 4 m r w^2 A2(l/r), A2 = 1/x + 1/(4 x^3) + 15/(128 x^5) + ...
    unit = 4 * 0.5 * 0.04 * (6000 * pi / 30) ** 2
    second = [unit * (1 / x + 1 / (4 * x**3) + 15 / (128 * x**5)) for x in (4.0, own.high, own.low)]
    assert (own.moved.quantity, own.moved.order) == ("force", 2.0)
    assert (own.moved.now, own.moved.low, own.moved.high) == pytest.approx(second, rel=1e-4)


def test_what_matters_most_comes_first_and_every_effect_is_a_number() -> None:
    for name in names():
        engine = load(name)
        found = assumptions(engine)
        effects = [each.effect for each in found]
        assert effects == sorted(effects, reverse=True), name
        assert all(isfinite(effect) and effect >= 0 for effect in effects), name
        assert len({each.path for each in found}) == len(found), name


def test_what_a_cycle_assumes_moves_its_torque() -> None:
    engine = load("audi-25-tfsi")
    own = cycle(engine)
    found = assumptions(engine, gas=own, uses=("inertia", "gas"))
    assert {f"gas.{name}" for name in own.assumed} - {"gas.crankcase_pressure"} <= {
        each.path for each in found
    }
    start = of(found, "gas.combustion_start")
    assert start.moved is not None
    assert start.moved.low < start.moved.now < start.moved.high


def test_a_weight_that_is_given_is_not_missing() -> None:
    paths = {
        each.path for each in assumptions(load("v8-cross-plane", changes={"balance_factor": 0.5}))
    }
    assert "crankshaft.weight" not in paths


def test_the_first_lines_of_an_analysis_say_it_and_so_does_json(run: Run) -> None:
    text = run("analyze", "audi-25-tfsi").out
    head = "\n".join(text.splitlines()[:14])
    assert "cylinder.rotating_mass" in head
    assert "747 to 1260 N m" in " ".join(head.split())
    rows = json.loads(run("analyze", "audi-25-tfsi", "--json").out)["rests_on"]
    assert rows[0]["path"] == "cylinder.rotating_mass"
    assert rows[0]["moves"]["now"] == pytest.approx(417.949, abs=1e-3)
    assert rows[0]["moves"]["high"] == pytest.approx(1258.8, abs=0.1)
