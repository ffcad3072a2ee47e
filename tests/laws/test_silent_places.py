"""Pins that cannot stand where a file leaves them, and an inertia that no mass stands for."""

from __future__ import annotations

from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest
from scipy.linalg import eigh

import crankstar
from crankstar.analysis.assumptions import Assumption
from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.engine.engine import Engine
from crankstar.files import engine_of, tree_of
from crankstar.studies.answers import rests_on, summary

CASES = Path(__file__).parents[1] / "cases"
BOXER = """
name = "flat twin"
firing_order = [1, 2]
speed = "6000 rpm"
[cylinder]
bore = "97 mm"
stroke = "73 mm"
rod_length = "125 mm"
reciprocating_mass = "600 g"
[layout]
type = "boxer"
throws = ["0 deg"]
banks = [{ bearing = "90 deg", cylinders = [1] }, { bearing = "-90 deg", cylinders = [2] }]
"""
SIX = """
name = "six that drives"
firing_order = [1, 5, 3, 6, 2, 4]
speed = "1500 rpm"
[cylinder]
bore = "130 mm"
stroke = "150 mm"
rod_length = "245 mm"
reciprocating_mass = "4.6 kg"
[layout]
type = "inline"
bore_pitch = "160 mm"
[torsion]
bare_inertia = "0.09 kg*m^2"
stiffness = "3.2 MN*m/rad"
[drive]
inertia = "4.8 kg*m^2"
"""


def of(rows: Any, path: str) -> list[Assumption]:
    return [each for each in rows if each.path == path]


def test_opposite_pins_at_one_place_are_said_with_the_couple_of_usual_ones() -> None:
    """m r w^2 d of two opposed pistons that are d apart, 0.35 to 0.65 bores."""
    engine = engine_of(tree_of(BOXER))
    (row,) = of(rests_on(engine, summary(engine)), "layout.bank_offset")
    unit = 0.6 * 0.0365 * (6000 * np.pi / 30) ** 2
    assert row.status == "missing"
    assert row.moved is not None
    assert (row.moved.quantity, row.moved.order, row.moved.now) == ("couple", 1.0, 0.0)
    ends = [unit * share * 0.097 for share in (0.35, 0.65)]
    assert [row.moved.low, row.moved.high] == pytest.approx(ends, rel=1e-6)
    given = tree_of(BOXER)
    given["layout"]["bank_offset"] = "40 mm"
    apart = engine_of(given)
    assert of(rests_on(apart, summary(apart)), "layout.bank_offset") == []
    first = crankstar.spectra.selected(crankstar.total(crankstar.balance(apart)).couple, 1)
    size = abs(first.forward).sum() + abs(first.backward).sum()
    assert float(size) == pytest.approx(unit * 0.04, rel=1e-6)


@pytest.mark.release
def test_the_inertia_of_a_drive_that_no_disc_has_is_said_with_what_it_changes() -> None:
    """The first natural frequency is 458.6 Hz without it, and 264.8 Hz with it at the rear."""
    result = crankstar.torsion(engine_of(tree_of(SIX)))
    (row,) = of(result.rests_on, "drive.inertia")
    rest = 4.8 - 6 * 0.09
    assert (row.status, row.low) == ("left out", pytest.approx(rest))
    assert row.vary is not None
    changed = row.vary(engine_of(tree_of(SIX)), rest)
    throw = torsion_chain(engine_of(tree_of(SIX))).inertia[0]
    stiffness = np.zeros((6, 6))
    for place in range(5):
        stiffness[place : place + 2, place : place + 2] += 3.2e6 * np.array([[1, -1], [-1, 1]])
    for engine, last in ((cast("Engine", result.source), 0.0), (changed, rest)):
        masses = np.diag([throw] * 5 + [throw + last])
        by_hand = np.sqrt(np.abs(eigh(stiffness, masses, eigvals_only=True)[1])) / (2 * np.pi)
        assert crankstar.torsion(engine).modes[0].frequency == pytest.approx(by_hand, rel=1e-6)


@pytest.mark.release
def test_a_drive_whose_inertia_the_discs_have_is_not_mentioned() -> None:
    tree = tree_of(SIX)
    tree["torsion"]["disc"] = [{"name": "rotor", "inertia": "4.2 kg*m^2", "to": "rear"}]
    assert of(crankstar.torsion(engine_of(tree)).rests_on, "drive.inertia") == []


def test_a_family_rests_on_the_moments_of_its_table() -> None:
    """The greatest H moment of the seven is what its assumptions move, not the roll without gas."""
    tree = tree_of((CASES / "marine-seven.toml").read_text(encoding="utf-8"))
    result = crankstar.guide(tree, numbers="7")
    assert of(result.rests_on, "gas") == []
    moved = [each.moved for each in result.rests_on if each.moved]
    assert "roll" not in " ".join(each.quantity for each in moved)
    (most,) = {each.now for each in moved if each.quantity == "H of member 7"}
    assert most == pytest.approx(max(result.to_frame()["h_N_m"]), rel=1e-9)
