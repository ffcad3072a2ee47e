"""Words that do not rest on estimated masses carry no mark."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run
from tests.files.test_estimate_one_range import TWIN

import crankstar
from crankstar.engine.gas import Gas
from crankstar.engine.proportions import inferred, look_of
from crankstar.language.messages import _
from crankstar.language.numbers import number
from crankstar.mechanics.operating_points import ignition
from crankstar.tables.laid import sentence, sentences

SHAFTS = (
    "Secondary couple: removed by balance shafts at 2 and -2 times crank speed, with opposite "
    "weights at their ends."
)
"""The remedy of a twin whose first order is balanced."""


@pytest.fixture
def quiet(run: Run, monkeypatch: pytest.MonkeyPatch) -> str:
    """A file of the twin, balanced in the first order for estimated masses: others leave some."""
    monkeypatch.setenv("COLUMNS", "300")
    Path("twin.toml").write_text(TWIN)
    shafts = ["--factor", "0.5", "--shafts", "-1"]
    run("balance", "twin.toml", "--estimate", *shafts, "-o", "quiet.toml")
    return "quiet.toml"


@pytest.mark.release
@pytest.mark.parametrize("words", [["verdict"], ["analyze"], ["balance", "--factor", "0.5"]])
def test_a_remedy_that_any_masses_need_is_not_marked(
    run: Run, quiet: str, words: list[str]
) -> None:
    verb, *options = words
    assert SHAFTS in re.sub(r"\s+", " ", run(verb, quiet, *options).out)


@pytest.mark.release
def test_a_comparison_of_stars_and_rods_that_are_known_is_not_marked(run: Run) -> None:
    """Masses and bore pitch are estimated; m, r and a are the units of what is compared."""
    told = run("verdict", "bmw-m52b28", "--estimate").out
    compared = told[told.index("comparison") :]
    assert compared.count("Compared with") > 2
    assert "estimated" not in compared
    known = run("verdict", "bmw-m52b28").out
    assert known[known.index("comparison") :].partition("\n\n")[0] in told


@pytest.mark.release
def test_a_comparison_has_the_range_of_an_estimated_rod(run: Run) -> None:
    Path("twin.toml").write_text(TWIN)
    told = re.sub(r"\s+", " ", run("verdict", "twin.toml", "--estimate").out)
    ducati = told[told.index("Compared with ducati-90") :].partition(". Compared")[0]
    assert "primary force 1.414 against 1 m r ω²" in ducati
    assert re.search(r"secondary couple about [\d.]+ \([\d.]+ to [\d.]+, estimated\)", ducati)
    assert ducati.count("estimated") == 1


def test_parts_of_a_sentence_that_others_lack_are_marked_once() -> None:
    own = _("Force {force} N, removed by shafts, with opposite weights.", force=number(2.0))
    removed = "Force {force} N, removed by weights."
    like = [_(removed, force=number(size)) for size in (2.5, 1.0)]
    assert sentence(own, like) == (
        "Force about 2 (1 to 2.5, estimated) N, removed by shafts, with opposite weights "
        "(estimated)."
    )


def test_a_sentence_is_found_where_other_masses_say_more_before_it() -> None:
    said = "The force is {force} N."
    own = [_(said, force=number(2.0)), "It is vertical."]
    like = [["A couple remains.", _(said, force=number(3.0)), "It is vertical."]] * 2
    assert sentences(own, like) == (
        "The force is about 2 (2 to 3, estimated) N.",
        "It is vertical.",
    )


@pytest.mark.parametrize("suffix", ["py", "stl"])
def test_an_exported_engine_is_said_to_be_estimated(run: Run, suffix: str) -> None:
    Path("twin.toml").write_text(TWIN)
    told = run("export", "twin.toml", "--estimate", "-o", f"model.{suffix}").err
    assert re.match(
        rf"Wrote model\.{suffix}\n(?:Shapes .*\n)?"
        r"Estimated as of type [a-z-]+: cylinder\.rod_length, .*throw_mass\.",
        told,
    )
    known = run("export", "bmw-r1200", "-o", f"known.{suffix}").err
    assert known.startswith(f"Wrote known.{suffix}\n")
    assert "Estimated" not in known


@pytest.mark.release
def test_the_same_engine_from_a_spreadsheet_has_the_share_of_itself(run: Run) -> None:
    """A spreadsheet lists the sources of values in another order."""
    Path("twin.toml").write_text(TWIN)
    run("estimate", "twin.toml", "-o", "whole.toml")
    run("show", "whole.toml", "-o", "whole.xlsx")
    out = run("compare", "whole.toml", "whole.xlsx", "--orders", "4").out
    row = next(line for line in out.splitlines() if line.split()[:1] == ["4"])
    assert row.split()[-1] == "100"


@pytest.mark.release
@pytest.mark.parametrize(
    ("gas", "speed", "kind"),
    [
        ({}, None, "petrol"),
        ({}, "4000 rpm", "diesel-car"),
        ({"ignition": "spark"}, "4000 rpm", "petrol"),
        ({"ignition": "compression"}, None, "diesel-car"),
        ({"process": "diesel"}, "9000 rpm", "diesel-car"),
        ({"friction": "diesel"}, "2200 rpm", "diesel"),
        ({"compression_ratio": 18}, None, "diesel-car"),
        ({"point": [{"name": "full", "speed": "9000 rpm", "imep": "12 bar"}]}, None, "motorcycle"),
    ],
)
def test_estimate_and_record_know_one_type_of_engine_by_size_speed_and_ignition(
    gas: dict[str, Any], speed: str | None, kind: str, run: Run
) -> None:
    tree: dict[str, Any] = {
        "name": "four",
        "firing_order": [1, 3, 4, 2],
        "cylinder": {"bore": "85 mm", "stroke": "95 mm"},
        "layout": {"type": "inline"},
        "gas": {"imep": "9 bar", **gas},
    }
    if "point" in gas:
        del tree["gas"]["imep"]
    if speed is not None:
        tree["speed"] = speed
    Path("four.json").write_text(json.dumps(tree))
    found = json.loads(run("estimate", "four.json", "--json").out)
    assert found["type"] == kind
    assert f"as of type {kind}" in run("analyze", "four.json", "--estimate").out
    engine = crankstar.load("four.json")
    look = look_of(engine, engine.gas)
    assert look is not None
    assert inferred(look)[0] == kind


@pytest.mark.parametrize(
    ("bore", "stroke", "changed", "reason"),
    [
        ("80 mm", "90 mm", {"speed": "3000 rpm"}, "a low rated speed and a low piston speed"),
        ("80 mm", "90 mm", {"speed": "4200 rpm"}, "a piston speed as of cars"),
        ("80 mm", "90 mm", {"speed": "5000 rpm"}, "a rated speed as of cars"),
        ("80 mm", "90 mm", {}, "a bore as of cars"),
        ("400 mm", "450 mm", {"gas": {"ignition": "spark"}}, "though the file says spark"),
        ("400 mm", "450 mm", {"speed": "500 rpm"}, "at a low piston speed"),
    ],
)
def test_the_reason_for_a_type_is_what_decided(
    run: Run, bore: str, stroke: str, changed: dict[str, Any], reason: str
) -> None:
    tree = {
        "name": "four",
        "firing_order": [1, 3, 4, 2],
        "cylinder": {"bore": bore, "stroke": stroke, "reciprocating_mass": "1 kg"},
        "layout": {"type": "inline", "bore_pitch": "1000 mm"},
        "gas": {"ignition": "compression"},
        **changed,
    }
    Path("four.json").write_text(json.dumps(tree))
    assert reason in " ".join(run("estimate", "four.json").out.split())


@pytest.mark.parametrize("linked", [True, False])
def test_a_star_is_one_type_and_ignites_as_it_does_with_slave_rods_or_without(
    run: Run, *, linked: bool
) -> None:
    """Of a bore of 130 mm and a piston speed of 10.3 m/s, which only a star has with a spark."""
    rows = [{"cylinders": [1, 2, 3, 4, 5, 6, 7], "master": 1}]
    tree: dict[str, Any] = {
        "name": "seven",
        "firing_order": [1, 3, 5, 7, 2, 4, 6],
        "speed": "2200 rpm",
        "cylinder": {"bore": "130 mm", "stroke": "140 mm", "reciprocating_mass": "2.4 kg"},
        "layout": {"type": "radial", "rows": rows}
        | ({"knuckle_radius": "55 mm"} if linked else {}),
    }
    Path("seven.json").write_text(json.dumps(tree))
    assert json.loads(run("estimate", "seven.json", "--json").out)["type"] == "aero"
    told = " ".join(run("analyze", "seven.json").out.split())
    assert "With a usual cycle (spark ignition, imep" in told
    engine = crankstar.load("seven.json")
    assert ignition(engine, Gas())[0] == ignition(engine, Gas(imep=9e5))[0] == "spark"


@pytest.mark.parametrize(
    ("bore", "stroke", "rpm", "cylinders", "kind", "fires"),
    [
        (90, 78, 4500, 1, "motorcycle", "spark"),
        (90, 78, 4500, 4, "diesel-car", "compression"),
        (90, 78, 5500, 1, "petrol", "spark"),
        (130, 150, 1900, 6, "diesel", "compression"),
        (80, 80, 2400, 1, "diesel", "compression"),
    ],
)
def test_what_ignites_a_cycle_is_what_the_type_of_an_estimate_has(
    run: Run, bore: int, stroke: int, rpm: int, cylinders: int, kind: str, fires: str
) -> None:
    """A table of gas that says nothing of ignition changes neither."""
    tree: dict[str, Any] = {
        "name": "some",
        "speed": f"{rpm} rpm",
        "cylinder": {"bore": f"{bore} mm", "stroke": f"{stroke} mm", "reciprocating_mass": "1 kg"},
        "layout": {"type": "inline", "throws": [0] * cylinders, "bore_pitch": "200 mm"},
    }
    for gas in ({}, {"gas": {"imep": "9 bar"}}):
        Path("some.json").write_text(json.dumps({**tree, **gas}))
        assert json.loads(run("estimate", "some.json", "--json").out)["type"] == kind
        engine = crankstar.load("some.json")
        assert ignition(engine, engine.gas or Gas()) == (fires, False)
