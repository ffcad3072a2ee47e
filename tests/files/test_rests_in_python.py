"""In Python what a result rests on prints as the command line says it."""

from __future__ import annotations

import json
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
