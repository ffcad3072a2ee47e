"""Values out of all proportion to their engine are asked about; those of real engines are not."""

from __future__ import annotations

from typing import Any

import pytest

import crankstar
from crankstar.files import engine_of, tree_of
from crankstar.files.catalog import load
from crankstar.mechanics.magnitudes import magnitude_doubts
from crankstar.mechanics.mass_doubts import rod_doubts
from crankstar.studies.assumed_doubts import doubtful

pytestmark = pytest.mark.quick

TWIN = """
name = "twin"
firing_order = [1, 2]
speed = "3000 rpm"
[cylinder]
bore = "80 mm"
stroke = "80 mm"
rod_length = "140 mm"
reciprocating_mass = "500 g"
rotating_mass = "400 g"
[cylinder.rod]
mass = "600 g"
centre = "40 mm"
[block]
mass = "150 kg"
up = "0.1 m"
[[block.points]]
name = "grip"
z = "1 m"
[[balance_shaft]]
up = "0.1 m"
weight = [{ unbalance = "9.9 g*m", angle = "180 deg", z = "0.1 m" }]
[[crankshaft]]
weight = [{ unbalance = "9.9 g*m", angle = "180 deg", z = "0.1 m" }]
[layout]
type = "inline"
throws = ["0 deg", "0 deg"]
positions = ["0 mm", "100 mm"]
"""


def doubts(*changes: tuple[str, str]) -> dict[str, Any]:
    text = TWIN
    for old, new in changes:
        assert old in text
        text = text.replace(old, new, 1)
    return {fault.code: fault for fault in magnitude_doubts(engine_of(tree_of(text)))}


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ('"500 g"', '"0.5 g"', "doubt.piston-light"),
        ('"400 g"', '"400 kg"', "doubt.turning-mass"),
        ('rod_length = "140 mm"', 'rod_length = "1400 mm"', "doubt.rod-long"),
        ('centre = "40 mm"', 'centre = "400 mm"', "doubt.rod-centre"),
        ('centre = "40 mm"', 'centre = "-40 mm"', "doubt.rod-centre"),
        ('positions = ["0 mm", "100 mm"]', 'positions = ["0 mm", "0 mm"]', "doubt.same-place"),
        ("9.9 g*m", "9.9 kg*m", "doubt.unbalance"),
        ('name = "grip"\nz = "1 m"', 'name = "grip"\nz = "900 m"', "doubt.far"),
        ('mass = "150 kg"\nup = "0.1 m"', 'mass = "150 kg"\nup = "-100 m"', "doubt.far"),
    ],
)
def test_a_slip_of_unit_is_asked_about(old: str, new: str, code: str) -> None:
    assert doubts() == {}
    assert list(doubts((old, new))) == [code]


def test_a_slip_is_told_where_the_file_has_it() -> None:
    first, second = TWIN.split("[[crankshaft]]")
    text = f"{first}[[crankshaft]]{second.replace('9.9 g*m', '9.9 kg*m')}"
    paths = [fault.path for fault in magnitude_doubts(engine_of(tree_of(text)))]
    assert paths == [("crankshaft", 0, "weight", 0, "unbalance")]
    (far,) = doubts(('up = "0.1 m"\nweight', 'up = "100 m"\nweight')).values()
    assert far.path == ("balance_shaft", 0, "up")
    assert (far.values["value"], far.values["size"]) == (100.0, 0.22)


@pytest.mark.parametrize("name", crankstar.names())
def test_no_engine_of_the_catalog_is_out_of_proportion(name: str) -> None:
    assert list(magnitude_doubts(crankstar.load(name))) == []


@pytest.mark.parametrize(
    ("changes", "paths"),
    [
        ({"cylinder.rotating_mass": "600 kg"}, ["cylinder.rotating_mass"]),
        ({"cylinder.rod_length": "80 mm"}, ["cylinder.rod_ratio"]),
        ({"cylinders": [{"number": 2, "rod_length": "80 mm"}]}, ["cylinders[2].rod_ratio"]),
        (
            {"cylinders": [{"number": 2, "reciprocating_mass": "0.65 g"}]},
            ["cylinders[2].reciprocating_mass"],
        ),
    ],
)
def test_a_doubt_names_all_cylinders_only_where_they_have_the_value_alike(
    changes: dict[str, Any], paths: list[str]
) -> None:
    engine = load("audi-25-tfsi", changes=changes)
    found = doubtful(engine, [*magnitude_doubts(engine), *rod_doubts(engine)])
    assert [each.path for each in found] == paths
