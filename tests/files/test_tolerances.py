"""Tolerances in engine files: how they are written, what they may not be, how they are kept."""

from __future__ import annotations

import io
import json
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import openpyxl
import pytest
from tests.commands import Run, csv_rows
from tests.spoilt import TREES
from tests.texts import check_sentences

import crankstar
from crankstar.analyses.tolerance.scatter import scatter_of
from crankstar.files import (
    EngineFileError,
    changed,
    engine_of,
    explicit,
    schema,
    tree_of,
    tree_text,
)
from crankstar.files.catalog import tree_of as tree_named
from crankstar.files.plus_minus import parted
from crankstar.files.rewritten import rewritten
from crankstar.files.sheets import sheets_of
from crankstar.files.tolerances import tolerance_faults, tolerances_of, without_tolerances
from crankstar.files.typical_tolerances import typical
from crankstar.files.workbook import workbook_bytes, workbook_tree
from crankstar.remedy.counterweights import with_counterweights
from crankstar.studies.fields import Source

SIX = """
format = 1
name = "six"
cycle = "four-stroke"
firing_order = [1, 5, 3, 6, 2, 4]
speed = "6000 rpm"
notes = "pistons 650 g +- 2 g"
[cylinder]
stroke = "90 mm ± 0.02 mm"
rod_length = "150 mm +- 0.05 mm"
reciprocating_mass = "650 g +- 3 g"
rotating_mass = "500 +- 2 g"
[layout]
type = "inline"
bore_pitch = "100 mm +/- 0.05 %"
throws = ["0 deg", "240 deg +- 0.2", "120 deg", "120 deg", "240 deg", "0 deg"]
"""
HALF = SIX.replace(" ± 0.02 mm", "").replace(" +- 0.05 mm", "").replace("650 g +- 3 g", "650 g")
PLAIN = HALF.replace("500 +- 2 g", "500 g").replace(" +/- 0.05 %", "").replace(" +- 0.2", "")
BOUNDS = {
    "cylinder.stroke": 2e-5,
    "cylinder.rod_length": 5e-5,
    "cylinder.reciprocating_mass": 0.003,
    "cylinder.rotating_mass": 0.002,
    "layout.bore_pitch": 5e-5,
    "layout.throws[2]": 0.2 * 3.14159265358979 / 180,
}


def bounds(tree: dict) -> dict[str, float]:
    return {path: own.bound for path, own in tolerances_of(tree).items()}


def test_a_tolerance_is_read_beside_the_engine() -> None:
    tree = tree_of(SIX)
    assert bounds(tree) == pytest.approx(BOUNDS)
    assert engine_of(tree) == engine_of(tree_of(PLAIN))
    assert engine_of(tree).notes == "pistons 650 g +- 2 g"
    assert without_tolerances(tree_of(PLAIN)) == tree_of(PLAIN)


@pytest.mark.parametrize(
    ("text", "bound"),
    [
        ("650 g +- 2 g", 0.002),
        ("650 g±2 g", 0.002),
        ("650 ± 2 g", 0.002),
        ("650 g +- 2", 0.002),
        ("0.65 kg +/- 2 g", 0.002),
        ("650 g +- 0.5 %", 0.00325),
        ("650 g + - 2 g", 0.002),
        ("650 g +- 1e-3 kg", 0.001),
        ("23 oz +- 0.1 oz", 0.1 * 0.028349523125),
        ("650 g +- 0 g", 0.0),
    ],
)
def test_a_tolerance_may_be_written_in_many_ways(text: str, bound: float) -> None:
    tree = changed(tree_of(SIX), {"cylinder.reciprocating_mass": text})
    assert bounds(tree)["cylinder.reciprocating_mass"] == pytest.approx(bound)
    engine_of(tree)


BAD = {
    "cylinder.stroke": [
        ("90 mm +- 2 g", "unit"),
        ("90 mm +- 3 foo", "unit"),
        ("90 mm +- 90 mm", "too-large"),
        ("90 mm +- 120 %", "too-large"),
        ("90 mm +- -1 mm", "negative"),
        ("90 mm +- \u22121 mm", "negative"),
        ("90 mm +- little", "not-a-number"),
        ("90 mm +-", "not-a-number"),
    ],
    "cylinder.offset": [("0 mm +- 5 %", "share-of-nothing")],
    "cylinder.rod_ratio": [("3.5 +- 0.1", "no-quantity")],
    "firing_order": [("1 +- 2", "no-quantity")],
    "layout.throws[2]": [("240 deg +- 2 mm", "unit"), ("240 deg +- ", "not-a-number")],
    "cylinder.reciprocating_mass": [("650 g +- 700 g", "too-large")],
}


@pytest.mark.parametrize(
    ("path", "text", "code"),
    [(path, text, code) for path, each in BAD.items() for text, code in each],
)
def test_a_tolerance_that_cannot_be_is_one_sentence(path: str, text: str, code: str) -> None:
    tree = changed(tree_of(SIX), {path: text})
    if path == "cylinder.rod_ratio":
        del tree["cylinder"]["rod_length"]
    with pytest.raises(EngineFileError) as error:
        engine_of(tree, name="FILE")
    check_sentences(error.value)
    assert [fault.code for fault in error.value.faults] == [f"tolerance.{code}"]
    assert error.value.faults[0].sentence.startswith(path)


@pytest.mark.parametrize(
    "text", ["90 mm + 1 mm", "90 mm +2 -1", "90 mm +- 1 +- 1", "+- 3 mm", "+-"]
)
def test_other_texts_are_refused_as_values(text: str) -> None:
    with pytest.raises(EngineFileError) as error:
        engine_of(changed(tree_of(SIX), {"cylinder.stroke": text}), name="FILE")
    check_sentences(error.value)
    assert len(error.value.faults) == 1


def test_a_mass_of_nothing_may_lie_on_either_side() -> None:
    tree = changed(tree_of(SIX), {"cylinder.throw_mass": "0 g +- 5 g"})
    assert bounds(tree)["cylinder.throw_mass"] == pytest.approx(0.005)
    engine_of(tree)


def test_an_engine_without_masses_has_bare_tolerances() -> None:
    tree = changed(tree_named("i4")[1], {"cylinder.rotating_mass": "0.6 +- 0.01"})
    assert engine_of(tree).shafts[0].throws[0].rotating_mass == 0.6
    assert bounds(tree) == {"cylinder.rotating_mass": 0.01}
    with pytest.raises(EngineFileError):
        engine_of(changed(tree, {"cylinder.rotating_mass": "0.6 +- 2 g"}))


def test_options_have_no_tolerances(refused) -> None:
    assert "--speed" in refused("analyze", "i4", "--speed", "6000 rpm +- 5 rpm")


@pytest.mark.release
def test_every_command_works_with_a_file_that_has_tolerances(run: Run, tmp_path: Path) -> None:
    place, plain = tmp_path / "six.toml", tmp_path / "plain.toml"
    place.write_text(SIX)
    plain.write_text(PLAIN)
    for words in (
        ("analyze", "FILE", "--csv"),
        ("bearings", "FILE", "--csv"),
        ("bobweight", "FILE"),
        ("strokes", "FILE"),
        ("sweep", "FILE", "--over", "cylinder.reciprocating_mass=600..700 g/3", "--csv"),
        ("estimate", "FILE", "--type", "petrol"),
    ):
        each = [
            run(*(str(own) if word == "FILE" else word for word in words)).out.replace(own.name, "")
            for own in (place, plain)
        ]
        assert each[0] == each[1], words


def test_files_keep_their_tolerances() -> None:
    tree = tree_of(SIX)
    assert bounds(tree_of(tree_text(tree))) == pytest.approx(BOUNDS)
    book = workbook_tree(workbook_bytes(sheets_of(tree)), "book.xlsx")
    assert bounds(book) == pytest.approx(BOUNDS)
    assert engine_of(book) == engine_of(tree)
    weighted = rewritten(tree, with_counterweights(engine_of(tree), factor=0.5))
    assert bounds(weighted) == pytest.approx(BOUNDS)


def test_the_explicit_form_keeps_what_it_can_say() -> None:
    tree = tree_of(SIX)
    whole = explicit(engine_of(tree))
    from crankstar.files.carried_tolerances import carried

    parts = carried(whole, tree)
    assert engine_of(parts) == engine_of(whole)
    own = bounds(parts)
    assert own["cylinders[6].reciprocating_mass"] == pytest.approx(0.003)
    assert own["shaft[1].throw[3].radius"] == pytest.approx(1e-5)
    assert own["shaft[1].throw[3].rotating_mass"] == pytest.approx(0.002)
    assert len(own) == 6 * 4
    heavier = with_counterweights(engine_of(parts), factor=0.5)
    assert bounds(rewritten(parts, heavier)) == pytest.approx(own)


def test_a_spreadsheet_may_have_the_tolerance_beside_the_unit() -> None:
    book = openpyxl.Workbook()
    page: Any = book.active
    page.title = "engine"
    for row in (
        ("key", "value", "unit"),
        ("name", "six", None),
        ("cycle", "four-stroke", None),
        ("firing_order", "1-5-3-6-2-4", None),
        ("layout.type", "inline", None),
        ("layout.bore_pitch", "100 ± 0.05", "mm"),
        ("cylinder.stroke", "90 mm +- 0.1 mm", "mm"),
        ("cylinder.reciprocating_mass", "650 +- 0.5 %", "g"),
    ):
        page.append(row)
    out = io.BytesIO()
    book.save(out)
    tree = workbook_tree(out.getvalue(), "book.xlsx")
    assert bounds(tree) == pytest.approx(
        {"layout.bore_pitch": 5e-5, "cylinder.stroke": 1e-4, "cylinder.reciprocating_mass": 0.00325}
    )
    assert engine_of(tree).first.reciprocating_mass == pytest.approx(0.65)


def test_a_fault_of_a_spreadsheet_names_its_cell() -> None:
    book = openpyxl.Workbook()
    page: Any = book.active
    page.title = "engine"
    for row in (
        ("key", "value", "unit"),
        ("name", "one", None),
        ("layout.type", "inline", None),
        ("layout.throws", 0, "deg"),
        ("cylinder.stroke", "90 mm +- 95 mm", None),
    ):
        page.append(row)
    out = io.BytesIO()
    book.save(out)
    with pytest.raises(EngineFileError, match="engine!B5"):
        engine_of(workbook_tree(out.getvalue(), "book.xlsx"), name="book.xlsx")


@pytest.mark.release
def test_the_schema_allows_tolerances() -> None:
    tree = json.loads(json.dumps(tree_of(SIX)))
    jsonschema.validate(tree, schema())


@pytest.mark.release
def test_tolerances_spoilt_at_random_give_an_engine_or_sentences() -> None:
    pieces = [
        "+-",
        "±",
        "+/-",
        "2",
        "g",
        "mm",
        "deg",
        "%",
        "-1",
        "0",
        "1e9",
        "1e999",
        "nan",
        "x",
        "",
    ]
    for seed in range(120):
        chance = random.Random(seed)  # noqa: S311
        tree = chance.choice(TREES)
        paths = [(keys, text) for keys, text in _texts(tree, ()) if keys[0] != "provenance"]
        keys, text = chance.choice(paths)
        new = " ".join([text, "+-" * (seed % 2), *(chance.choice(pieces) for _ in range(3))])
        spoilt = _put(tree, keys, new)
        try:
            engine_of(spoilt, name="FILE")
        except EngineFileError as error:
            check_sentences(error)
        else:
            assert not tolerance_faults(spoilt)
            assert all(own.bound >= 0 for own in tolerances_of(spoilt).values())


def _texts(value: Any, path: tuple[Any, ...]) -> Any:
    if isinstance(value, dict):
        for key, item in value.items():
            yield from _texts(item, (*path, key))
    elif isinstance(value, list):
        for place, item in enumerate(value):
            yield from _texts(item, (*path, place))
    elif isinstance(value, str):
        yield path, value


def _put(value: Any, path: Any, new: str) -> Any:
    if not path:
        return new
    if isinstance(value, dict):
        return {k: _put(v, path[1:], new) if k == path[0] else v for k, v in value.items()}
    return [_put(v, path[1:], new) if k == path[0] else v for k, v in enumerate(value)]


def test_the_sign_is_looked_for_in_short_texts_only() -> None:
    assert parted("1 " * 500 + "+- 2") is None
    assert parted(None) is None
    assert parted(3.5) is None


@pytest.mark.release
def test_machines_get_what_python_computes(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "six.toml"
    place.write_text(SIX)
    out = json.loads(run("tolerance", str(place), "--builds", "2000", "--seed", "7", "--json").out)
    found = crankstar.tolerance(str(place), builds=2000, seed=7).value
    assert (out["format"], out["builds"], out["seed"]) == (1, 2000, 7)
    assert out["speed_rpm"] == pytest.approx(6000)
    assert len(out["orders"]) == len(found.rows)
    for row, own in zip(out["orders"], found.rows, strict=True):
        assert (row["signal"], row["order"]) == (own.signal, own.order)
        assert row["rms"] == pytest.approx(own.rms)
        assert row["worst"] == pytest.approx(own.worst)
        assert row["exceeded_by_5_percent"] == pytest.approx(own.one_in_20)
        shares = {
            each["tolerance"]: each["share"]
            for each in out["shares"]
            if (each["signal"], each["order"]) == (own.signal, own.order)
        }
        assert shares == pytest.approx(own.shares)
    assert {row["path"]: row["bound"] for row in out["tolerances"]} == pytest.approx(BOUNDS)
    table = run("tolerance", str(place), "--builds", "2000", "--seed", "7", "--csv").out
    rows = csv_rows(table, "orders")
    assert [float(row["rms"]) for row in rows] == pytest.approx([own.rms for own in found.rows])


@pytest.mark.release
def test_readers_get_sentences_and_what_is_left_out(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "six.toml"
    place.write_text(SIX)
    out = run("tolerance", str(place), "--builds", "5000").out
    assert "5 % have more than" in out
    assert "Which tolerance matters" in out
    assert "Bearing loads, gas and the twist of the crankshaft are left out" in out
    verdict = run("verdict", str(place)).out
    assert "as built" in verdict
    assert "5 % have more than" in verdict
    assert "as built" not in run("verdict", "i6").out


@pytest.mark.release
def test_published_tolerances_are_marked_as_assumed(run: Run) -> None:
    given = ("honda-b18c", "--estimate", "--typical", "--builds", "2000")
    out = json.loads(run("tolerance", *given, "--json").out)
    assert out["assumed"] == {
        "cylinder.reciprocating_mass": "lada2107",
        "cylinder.rod.mass": "fiat-elearn",
    }
    assert "cylinder.rod.mass" in out["estimated"]
    said = run("tolerance", *given).out
    assert "Assumed: cylinder.reciprocating_mass" in said
    assert "Estimated as of type " in said


def test_a_spreadsheet_and_a_picture_are_written(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "six.toml"
    place.write_text(SIX)
    run("tolerance", str(place), "--builds", "2000", "-o", "out.xlsx")
    book = openpyxl.load_workbook(tmp_path / "out.xlsx")
    assert {"orders", "shares", "tolerances", "engine"} <= set(book.sheetnames)
    run("tolerance", str(place), "--builds", "2000", "-o", "out.svg", "--quantity", "force,roll")
    picture = (tmp_path / "out.svg").read_text()
    assert "as drawn" in picture
    assert "layout.throws[2]" in picture


@pytest.mark.release
def test_bearing_loads_are_told_and_drawn_where_they_are_asked_for(
    run: Run, tmp_path: Path
) -> None:
    place = tmp_path / "six.toml"
    place.write_text(SIX)
    line = ("tolerance", str(place), "--builds", "1000", "--quantity", "bearing", "--orders", "1")
    said = run(*line).out
    assert said.count("load on main bearing 7") >= 1
    assert "hinged at each main bearing" in " ".join(said.split())
    assert "Bearing loads, gas" not in said
    rows = json.loads(run(*line, "--json").out)["orders"]
    assert [row["signal"] for row in rows] == [f"bearing {number}" for number in range(1, 8)]
    assert {row["unit"] for row in rows} == {"N"}
    run(*line, "-o", "out.svg")
    assert "load on main bearing 1" in (tmp_path / "out.svg").read_text()


@pytest.mark.many(first=11)
@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("i4",), "has no tolerances"),
        (("i4", "--typical"), "has no masses"),
        (("merlin", "--typical", "--set", "cylinder.reciprocating_mass=3 kg"), "car engines"),
        (("i4", "--builds", "10"), "--builds 10"),
        (("i4", "--seed", "-1"), "--seed -1"),
        (("i4", "--distribution", "flat"), "normal, uniform"),
        (("i4", "--quantity", "noise"), "--quantity noise"),
        (("i4", "--quantity", "force,bearing", "--reference", "0"), "--reference has no effect"),
        (("i4", "--orders", "-1"), "--orders"),
        (("i4", "--orders", "0.5,2"), "order 0.5 does not occur in"),
        (("i4", "--set", "cylinder.rotating_mass=0.5 +- 2 g"), "cylinder.rotating_mass"),
        (("i4", "--set", "speed=3000 rpm +- 1 %"), "no force"),
        (("i4", "--theme", "dark"), "--theme"),
    ],
)
def test_questions_that_cannot_be_are_one_sentence(refused, words, told) -> None:
    assert told in refused("tolerance", *words)


def test_published_tolerances_stand_only_for_what_the_file_does_not_give() -> None:
    tree = tree_of(PLAIN)
    both = ["cylinder.reciprocating_mass", "cylinder.rotating_mass"]
    assert [*typical(tree, engine_of(tree))] == both
    given = changed(tree, {"cylinder.rotating_mass": "500 g +- 1 g"})
    assert [*typical(given, engine_of(given), tolerances_of(given))] == both[:1]
    parts = {"piston": "500 g +- 1 g", "small_end": "150 g", "big_end": "500 g"}
    weighed = changed(tree, {"cylinder.parts": parts})
    assert [*typical(weighed, engine_of(weighed), tolerances_of(weighed))] == both[1:]
    whole = explicit(engine_of(tree))
    rows = [
        scatter_of(Source("six", own), assume="typical", count=1000, orders=[1]).of("force", 1)
        for own in (tree, whole)
    ]
    assert rows[0].rms == pytest.approx(rows[1].rms, rel=1e-9)


def test_a_published_tolerance_stands_beside_the_mass_that_it_is_of(
    run: Run, tmp_path: Path
) -> None:
    tree = tree_of(PLAIN)
    parts = {"piston": "500 g", "small_end": "150 g", "big_end": "480 g", "oil": "20 g"}
    weighed = {key: value for key, value in tree.items() if key != "cylinder"}
    weighed["cylinder"] = {"stroke": "90 mm", "rod_length": "150 mm", "parts": parts}
    for own in (tree, weighed):
        assert typical(own, engine_of(own))["cylinder.rotating_mass"].tolerance.value == (
            pytest.approx(0.5)
        )
    whole = explicit(engine_of(tree))
    found = [own.tolerance.value for own in typical(whole, engine_of(whole)).values()]
    assert found == pytest.approx([0.65, 0.5] * 6)
    (tmp_path / "six.toml").write_text(tree_text(weighed), encoding="utf-8")
    said = run("tolerance", "six.toml", "--typical", "--builds", "1000").out.split("\n")
    (line,) = [each for each in said if each.startswith("cylinder.rotating_mass") and "±" in each]
    assert "500 g" in line
    assert "0 kg" not in line
    own = {"cylinder.reciprocating_mass": "650 g", "cylinder.rotating_mass": "400 g"}
    vee = crankstar.load("v8-cross-plane", changes=own)
    assert typical(tree, vee)["cylinder.rotating_mass"].tolerance.value == pytest.approx(0.4)


@pytest.mark.release
def test_standard_input_is_read_once(run: Run, tmp_path: Path) -> None:
    words = ("tolerance", "-", "--builds", "1000", "--reference", "10 mm", "-o", "out.xlsx")
    assert run(*words, stdin=SIX.encode()).code == 0
    assert "engine" in openpyxl.load_workbook(tmp_path / "out.xlsx").sheetnames


@pytest.mark.release
def test_a_throw_that_is_set_takes_its_weights_along(run: Run, tmp_path: Path) -> None:
    engine = with_counterweights(engine_of(tree_of(SIX)), factor=0.5)
    place = tmp_path / "six.toml"
    place.write_text(tree_text(explicit(engine)))
    setting = ("--set", "shaft[1].throw[2].angle=200 deg +- 0.1 deg")
    out = run("tolerance", str(place), *setting, "--builds", "1000", "--orders", "1", "--json").out
    turned = crankstar.load(place, changes={"shaft[1].throw[2].angle": "200 deg"})
    sums = crankstar.total(crankstar.balance(turned, speed=turned.speed, orders=[1]))
    nominal = abs(sums.force.forward[0]) + abs(sums.force.backward[0])
    assert json.loads(out)["orders"][0]["nominal"] == pytest.approx(nominal)


def test_python_asks_as_the_command_does(tmp_path: Path) -> None:
    """A result with frames, the reference as z, and what is refused."""
    place = tmp_path / "six.toml"
    place.write_text(SIX)
    found = crankstar.tolerance(place, builds=1000, orders=[1], reference=-0.12)
    assert found.value.reference == crankstar.Reference(-0.12)
    rows = found.to_frame("orders").to_dict("records")
    assert {row["order"] for row in rows} == {1.0}
    [force] = [row for row in rows if row["signal"] == "force"]
    assert force["rms"] == pytest.approx(found.value.of("force", 1).rms)
    with pytest.raises(ValueError, match="from 1000 to 1000000"):
        crankstar.tolerance(place, builds=10)
    with pytest.raises(ValueError, match="take published ones with typical"):
        crankstar.tolerance("audi-25-tfsi")


def test_a_picture_looks_as_it_is_asked_to_and_a_table_does_not(
    run: Run, refused: Callable[..., str], tmp_path: Path
) -> None:
    place = tmp_path / "six.toml"
    place.write_text(SIX)
    line = ("tolerance", str(place), "--builds", "1000")
    run(*line, "-o", str(tmp_path / "p.svg"), "--width", "150 mm", "--theme", "print")
    assert 'width="150mm"' in (tmp_path / "p.svg").read_text(encoding="utf-8")[:400]
    assert "a table" in refused(*line, "--theme", "dark")
