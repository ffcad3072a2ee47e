"""Parts that an engine has and its file leaves out: first in every record, beside every remedy."""

from __future__ import annotations

import json
import tomllib
from typing import Any

import pytest
from tests.commands import Run

import crankstar
from crankstar.analyses.verdict.facts import verdict
from crankstar.files import engine_of
from crankstar.files.catalog import tree_of
from crankstar.files.sheets import sheets_of, value_of
from crankstar.files.write import toml
from crankstar.page.exhibits import in_units
from crankstar.studies.answers import amplitudes, rests_on, summary
from crankstar.studies.load_answers import bearing_peaks
from crankstar.tables.assumptions import assumption_lines, leading_lines
from crankstar.tables.cures import fitted_lines

PARTS = {
    "bmw-f800": "balance rod",
    "bmw-g650": "balance shaft",
    "bmw-r1200": "balance shaft",
    "fiat-twinair": "balance shaft",
    "ford-essex-42": "balance shaft",
    "gm-3800": "balance shaft",
    "international-vt275": "balance shaft",
    "man-s50mc-c": "second-order moment compensators",
    "mwm-6-diesel": "torsional vibration damper",
    "triumph-675": "balance shaft",
    "yamaha-mt-07": "balance shaft",
    "yamaha-r1-crossplane": "counter-rotating balance shaft",
}


def row(part: str, number: int = 1) -> dict[str, Any]:
    return {"status": "not modelled", "path": f"left_out[{number}]", "value": part, "moves": None}


def test_the_catalog_names_what_its_files_leave_out() -> None:
    named = {name: crankstar.load(name).left_out for name in crankstar.names()}
    assert {name: parts for name, parts in named.items() if parts} == {
        name: (part,) for name, part in PARTS.items()
    }


@pytest.mark.quick
def test_what_is_left_out_is_first_in_every_record() -> None:
    engine = crankstar.load("bmw-f800")
    answers = [amplitudes(engine), summary(engine), bearing_peaks(engine, lambda _each: None)]
    for answer in answers:
        found = rests_on(engine, answer)
        assert (found[0].status, found[0].value) == ("not modelled", "balance rod")
        lines = assumption_lines(found)
        first, _others = leading_lines(found)
        assert first[:2] == lines[:2]
        assert "balance rod" in lines[0]
    # a doubt on a value of the file is not before it
    short = crankstar.load("bmw-f800", changes={"cylinder.rod_ratio": 1.63})
    statuses = [each.status for each in rests_on(short, amplitudes(short))]
    assert statuses[0] == "not modelled"
    assert "doubtful" in statuses


@pytest.mark.quick
def test_a_remedy_names_what_the_engine_has_already() -> None:
    cures = [fact for fact in verdict(crankstar.load("bmw-f800")) if fact.about == "cure"]
    assert [cures[0].sentence] == fitted_lines(crankstar.load("bmw-f800"))
    assert len(cures) > 1
    assert fitted_lines(crankstar.load("i4")) == []


COMMANDS = [["analyze", "bmw-f800"], ["torque", "bmw-f800"], ["bearings", "bmw-f800"]]


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command[0])
def test_every_command_has_it_in_json(command: list[str], run: Run) -> None:
    rows = json.loads(run(*command, "--json").out)["rests_on"]
    assert {key: rows[0][key] for key in row("")} == row("balance rod")


def test_a_comparison_and_a_check_name_it(run: Run) -> None:
    rows = json.loads(run("compare", "bmw-f800", "i4", "--json").out)["rests_on"]
    assert [each["value"] for each in rows if each["status"] == "not modelled"] == ["balance rod"]
    assert "balance rod" in run("check", "bmw-f800").out
    assert "balance rod" in run("compare", "bmw-f800", "i4").out


def test_the_page_has_it_first() -> None:
    _name, tree = tree_of("bmw-f800")
    made = in_units(crankstar.load("bmw-f800"), None, tree=tree, relatives=False)
    assert "balance rod" in made["rests_on"][0]


@pytest.mark.quick
def test_files_and_spreadsheets_keep_it() -> None:
    parts = ["balance rod, below the crankshaft", "damper"]
    for count in (1, 2):
        engine = crankstar.load("i4", changes={"left_out": parts[:count]})
        assert engine.left_out == tuple(parts[:count])
        again = engine_of(tomllib.loads(toml(engine)))
        assert again.left_out == engine.left_out
        _name, tree = tree_of("i4")
        [main] = [s for s in sheets_of({**tree, "left_out": parts[:count]}) if s.name == "engine"]
        [cell] = [cells[1] for cells in main.rows if cells[0] == "left_out"]
        assert value_of(cell, None, tuple[str, ...]) == parts[:count]


def test_a_fitted_remedy_names_it(run: Run) -> None:
    out = run("balance", "bmw-f800", "--recommended").out
    assert out.index("balance rod") < out.index("-1.")  # before the shaft that is fitted
