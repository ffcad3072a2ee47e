"""The table `[torsion.fatigue]`, its mistakes, and what is said of fatigue."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run
from tests.methods.test_crank_fatigue import GAS, SIX, SIZES, STEEL, TORSION
from tests.texts import codes, spoilt

from crankstar.analyses.verdict.facts import verdict
from crankstar.files import engine_of, toml, tree_of

FACTORS = {
    "pin_bending": 3.0,
    "pin_torsion": 2.0,
    "journal_bending": 3.1,
    "journal_compression": 2.9,
    "journal_torsion": 2.1,
}


def written(folder: Path, **more: Any) -> str:
    """An engine file with such a table [torsion]."""
    path = folder / "six.toml"
    path.write_text(toml(engine_of(spoilt(SIX, torsion={**TORSION, **more}, gas=GAS))))
    return str(path)


def mistakes(**torsion: Any) -> dict[str, str]:
    own = {key: value for key, value in {**TORSION, **torsion}.items() if value is not None}
    return codes(spoilt(SIX, torsion=own, gas=GAS))


def test_fatigue_is_the_same_written_and_read_back() -> None:
    own = {**STEEL, **FACTORS, "pin_recess": "1 mm", "additional_stress": "30 MPa"}
    engine = engine_of(spoilt(SIX, torsion={**TORSION, "fatigue": own}, gas=GAS))
    again = engine_of(tree_of(toml(engine)))
    assert again.torsion == engine.torsion
    assert again.torsion is not None
    assert again.torsion.fatigue is not None
    assert again.torsion.fatigue.factors == FACTORS
    assert again.torsion.fatigue.tensile_strength == pytest.approx(800e6)


@pytest.mark.parametrize(
    ("changes", "place", "code"),
    [
        (
            {"dimensions": None, "stiffness": "1 MN*m/rad"},
            "torsion.fatigue",
            "fatigue.no-dimensions",
        ),
        (
            {"fatigue": {**STEEL, "pin_fillet": "1.5 mm"}},
            "torsion.fatigue.pin_fillet",
            "fatigue.range",
        ),
        (
            {"fatigue": {**STEEL, "journal_fillet": "7 mm"}},
            "torsion.fatigue.journal_fillet",
            "fatigue.range",
        ),
        (
            {"dimensions": {**SIZES, "web_thickness": "10 mm"}},
            "torsion.dimensions.web_thickness",
            "fatigue.range",
        ),
        (
            {"dimensions": {**SIZES, "web_width": "120 mm"}},
            "torsion.dimensions.web_width",
            "fatigue.range",
        ),
        (
            {"dimensions": {**SIZES, "pin_bore": "45 mm"}},
            "torsion.dimensions.pin_bore",
            "fatigue.range",
        ),
        (
            {
                "dimensions": {
                    **SIZES,
                    "journal_diameter": "112 mm",
                    "pin_diameter": "54 mm",
                    "journal_bore": "80 mm",
                }
            },
            "torsion.dimensions.pin_diameter",
            "fatigue.overlap",
        ),
    ],
)
def test_a_throw_beyond_the_regressions_is_told_how_far_they_go(
    changes: dict[str, Any], place: str, code: str
) -> None:
    assert mistakes(**changes)[place] == code


def test_sizes_beyond_the_regressions_do_with_all_five_factors() -> None:
    thin = {"dimensions": {**SIZES, "web_thickness": "10 mm"}}
    assert mistakes(**thin, fatigue={**STEEL, **FACTORS}) == {}
    four = {name: value for name, value in FACTORS.items() if name != "pin_torsion"}
    assert mistakes(**thin, fatigue={**STEEL, **four}) != {}


@pytest.mark.release
def test_fatigue_of_an_engine_without_masses_asks_for_them_or_estimates(
    run: Run, tmp_path: Path
) -> None:
    path = tmp_path / "light.toml"
    tree = spoilt(SIX, torsion=TORSION, gas=GAS)
    del tree["cylinder"]["reciprocating_mass"], tree["cylinder"]["rotating_mass"]
    path.write_text(toml(engine_of(tree)))
    out = run("torsion", str(path), "--json").out
    assert "cylinder.reciprocating_mass" in json.loads(out)["without_fatigue"]
    guessed = json.loads(run("torsion", str(path), "--json", "--estimate").out)
    assert guessed["fatigue"][0]["acceptability"]


@pytest.mark.release
def test_torsion_has_the_fillets_of_each_throw_for_machines(run: Run, tmp_path: Path) -> None:
    out = json.loads(run("torsion", written(tmp_path), "--json").out)
    rows = out["fatigue"]
    assert [(row["throw"], row["fillet"]) for row in rows[:3]] == [
        (1, "pin"),
        (1, "journal"),
        (2, "pin"),
    ]
    assert len(rows) == 12
    for row in rows:
        assert row["acceptability"] == pytest.approx(row["strength"] / row["equivalent"])
        bending = row["factor_bending"] * row["bending"]
        if row["fillet"] == "journal":
            bending += row["factor_compression"] * row["compression"]
        assert row["fillet_bending"] == pytest.approx(bending)
        assert row["fillet_torsion"] == pytest.approx(row["factor_torsion"] * row["torsion"])


@pytest.mark.release
def test_throws_that_are_alike_stand_in_one_row_for_readers(run: Run, tmp_path: Path) -> None:
    out = run("torsion", written(tmp_path)).out
    lines = out[out.index("Fatigue of the crankshaft") :].splitlines()
    rows = [line.split()[:2] for line in lines if line.startswith("1-6")]
    assert rows == [["1-6", "pin"], ["1-6", "journal"]]


@pytest.mark.release
def test_an_engine_without_the_table_is_told_nothing_of_fatigue(run: Run, tmp_path: Path) -> None:
    path = tmp_path / "plain.toml"
    own = {key: value for key, value in TORSION.items() if key != "fatigue"}
    path.write_text(toml(engine_of(spoilt(SIX, torsion=own, gas=GAS))))
    assert "atigue" not in run("torsion", str(path)).out
    assert "fatigue" not in json.loads(run("torsion", str(path), "--json").out)


@pytest.mark.release
def test_the_verdict_says_whether_the_crankshaft_bears_its_stress() -> None:
    def said(**steel: Any) -> str:
        own = {**TORSION, "fatigue": {**STEEL, **steel}}
        facts = verdict(engine_of(spoilt(SIX, torsion=own, gas=GAS)), relatives=False)
        return [fact.sentence for fact in facts if fact.about == "torsion"][-1]

    assert "bears its stress" in said()
    weak = said(additional_stress="400 MPa")
    assert "may break by fatigue" in weak
    assert "1.15" in weak


@pytest.mark.release
def test_why_there_is_no_fatigue_is_said(run: Run, tmp_path: Path) -> None:
    wide = {"dimensions": {**SIZES, "journal_length": "90 mm"}}
    out = run("torsion", written(tmp_path, **wide)).out
    assert "Without fatigue: the webs of throw 1 do not fit" in " ".join(out.split())
    table = json.loads(run("torsion", written(tmp_path, **wide), "--json").out)
    assert "do not fit" in table["without_fatigue"]
