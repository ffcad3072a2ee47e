"""In Python what a result rests on prints as the command line says it."""

from __future__ import annotations

import json
import re
from math import pi
from pathlib import Path

import pytest
from tests.commands import Run
from tests.files.test_balance_rests_on import MOWER

import crankstar

BARE = {**MOWER, "cylinder": {**MOWER["cylinder"], "rotating_mass": "0 g", "throw_mass": "0 g"}}


@pytest.fixture
def mower(tmp_path: Path) -> str:
    path = tmp_path / "mower.json"
    path.write_text(json.dumps(BARE))
    return str(path)


def test_assumptions_print_as_the_sentences_of_the_command_line(mower: str, run: Run) -> None:
    found = crankstar.torque(mower).rests_on
    said = " ".join(run("torque", mower).out.split())
    lines = str(found).splitlines()
    assert lines == [repr(each) for each in found]
    assert len(str(found)) < 200 * len(found)
    assert "_Held" not in str(found)
    for each, line in zip(found, lines, strict=True):
        assert each.path in said
        assert each.path in line
    assert sum(" ".join(line.split()) in said for line in lines) >= 5
    html = found._repr_html_()
    assert html.count("<p") == len(found)


def test_a_balance_says_what_it_rests_on(mower: str, run: Run) -> None:
    """A crankpin of the high end of its range is in the primary force as it is by hand."""
    result = crankstar.balance(crankstar.load(mower))
    said = " ".join(run("analyze", mower).out.split())
    [own] = [each for each in result.rests_on if each.path == "cylinder.rotating_mass"]
    assert str(own) in said
    assert own.moved is not None
    pins = dict(own.values)["pins"]
    force = (0.265 + (own.high or 0) + pins[1]) * 0.0259 * (3060 * pi / 30) ** 2
    assert own.moved.high == pytest.approx(force, rel=1e-6)
    relative = crankstar.balance(mower, units="relative").rests_on
    again = next(each for each in relative if each.path == own.path)
    assert again.moved is not None
    assert again.moved.high == pytest.approx(1 + ((own.high or 0) + pins[1]) / 0.265, rel=1e-6)
    second = crankstar.balance(mower, orders=[2]).rests_on
    assert own.path not in {each.path for each in second}


def test_an_engine_is_not_changed_by_keys_of_its_short_file() -> None:
    engine = crankstar.load("audi-25-tfsi")
    with pytest.raises(ValueError, match=re.escape("cylinders[1].bore")):
        crankstar.torque(engine, changes={"cylinder.stroke": "90 mm"})
    assert crankstar.torque(engine, changes={"cylinders[1].bore": "80 mm"}).to_frame().size


@pytest.mark.release
def test_a_chart_writes_itself_as_its_name_says(tmp_path: Path) -> None:
    chart = crankstar.torsion("cadillac-ld8").plot("campbell")
    chart.save(tmp_path / "campbell.svg", title="Campbell")
    assert (tmp_path / "campbell.svg").read_text(encoding="utf-8").startswith("<svg")
    with pytest.raises(ValueError, match="svg"):
        chart.save(tmp_path / "campbell.doc")


def test_orders_that_cancel_drive_no_mode() -> None:
    """Of a V8 the gas torques of half its orders cancel at every mode; rounding is no torque."""
    torques = crankstar.torsion("cadillac-ld8").criticals.to_frame()["torque_N_m"].dropna()
    assert (torques == 0).any()
    assert (torques[torques > 0] > 1e-9 * torques.max()).all()


@pytest.mark.release
def test_no_sentence_says_of_a_figure_what_it_is_already() -> None:
    """Diesel friction moved the force in a mount from 14 N to 14 N, in the digits printed."""
    places = [("left", "-0.4 m", "0.1 m"), ("right", "0.4 m", "0.1 m"), ("rear", "0 m", "-0.3 m")]
    rubber = [{"name": n, "right": r, "z": z, "stiffness": "90 N/mm"} for n, r, z in places]
    own = {"mounts": rubber, "block": {"mass": "180 kg"}}
    found = crankstar.mounts("audi-25-tfsi", changes=own, speeds="800..6000 rpm/50", at="-120 mm")
    said = str(found.rests_on)
    assert "gas.friction" in said
    moved = re.findall(r"is ([\d.]+ \w+(?: m)?)(?:, not|;) ([\d.]+ \w+(?: m)?)(?:\.| as)", said)
    assert moved
    assert not [sizes for sizes in moved if sizes[0] == sizes[1]]
