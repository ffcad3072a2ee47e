"""Estimated masses: what is filled in, and the ranges of what rests on them."""

from __future__ import annotations

import csv
import io
import json
import random
import tomllib
from collections.abc import Callable
from math import pi
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run

from crankstar import files
from crankstar.analyses.verdict.document import verdict_document
from crankstar.analyses.verdict.facts import verdict
from crankstar.analysis.document import Document, Ranged
from crankstar.engine import proportions
from crankstar.engine.engine import Engine
from crankstar.engine.weighed import ENGINES
from crankstar.files import engine_of
from crankstar.files.box import ranges, scaled, spread
from crankstar.files.catalog import load, names, tree_of
from crankstar.files.errors import EngineFileError
from crankstar.files.estimate import estimated
from crankstar.files.write import toml, tree_text
from crankstar.mechanics.balance import balance
from crankstar.tables import analysis, machine
from crankstar.tables.balance_orders import answer
from crankstar.tables.ranges import ranged

SIZED = [name for name in names() if load(name).first.bore and name[:3] != "man"]
SAMPLE = ("toyota-2jz", "kr250-racer", "pratt-whitney-wasp", "ford-coyote")


def tree_for(name: str) -> dict[str, Any]:
    """The completed tree of a catalog engine."""
    return estimated(tree_of(name)[1], name=name).tree


def numbers(engine: Engine) -> Document:
    """All orders of an engine, as `analyze --json` gives them."""
    return answer(engine, balance(engine, speed=engine.speed))


@pytest.mark.many(first=23)
@pytest.mark.parametrize("name", SIZED)
def test_an_engine_with_a_bore_gives_newtons(name: str) -> None:
    engine = engine_of(tree_for(name))
    assert balance(engine, speed=engine.speed).units.force == "N"


@pytest.mark.release
def test_what_a_file_gives_is_kept() -> None:
    for name in SIZED:
        before, after = tree_of(name)[1], tree_for(name)
        for table in ("cylinder", "layout"):
            given = before.get(table, {})
            kept = {key: after[table][key] for key in given} if given else {}
            bare = {key for key in given if isinstance(given[key], int | float)}
            assert {k: v for k, v in kept.items() if k not in bare} == {
                k: v for k, v in given.items() if k not in bare
            }


@pytest.mark.parametrize("name", ["bmw-m52b28", "kr250-racer", "subaru-ej25", "ford-coyote"])
def test_an_estimated_file_has_nothing_left_to_estimate(name: str) -> None:
    """The big end of a rod with its mass is in the rod, and is not counted again on the pin."""
    once = estimated(tree_of(name)[1]).tree
    again = estimated(once).tree
    assert again == once


def test_the_big_end_of_a_given_rod_is_not_estimated_beside_it() -> None:
    tree = dict(tree_of("bmw-m52b28")[1])
    rod = {"mass": "600 g", "centre": "40 mm", "inertia": "0.002 kg*m^2"}
    tree["cylinder"] = {**tree["cylinder"], "reciprocating_mass": "400 g", "rod": rod}
    filled = estimated(tree).tree["cylinder"]
    assert "rotating_mass" not in filled
    assert filled["rod"] == rod
    assert filled["throw_mass"]  # the crank pin is the crankshaft's


def test_bare_numbers_keep_their_proportion_to_the_unit() -> None:
    tree = tree_of("parallel-twin-180")[1]
    tree["cylinder"]["rotating_mass"] = 0.4
    before = balance(engine_of(tree)).force.forward
    done = estimated(tree)
    after = engine_of(done.tree).first
    own = engine_of(done.tree)
    assert own.shafts[0].throws[0].rotating_mass == pytest.approx(
        0.4 * after.reciprocating_mass, rel=1e-3
    )
    assert before.size


def test_the_explicit_form_is_completed_too() -> None:
    bare = load("napier-deltic")
    tree = tree_for("napier-deltic")
    engine = engine_of(tree)
    mass = engine.first.reciprocating_mass
    unit = balance(bare)
    real = balance(engine, speed=engine.speed)
    radius = bare.throw(bare.first).radius
    factor = mass * radius * (engine.speed or 0) ** 2
    assert abs(real.force.forward).max() == pytest.approx(
        factor * abs(unit.force.forward).max(), rel=1e-6
    )


def test_masses_are_those_of_the_law() -> None:
    bore = 0.086
    filled = {value.path: value for value in estimated(tree_of("toyota-2jz")[1]).filled}
    groups = [
        e.piston_group / e.bore**3
        for e in ENGINES
        if e.kind == "petrol" and e.bore and e.piston_group
    ]
    dressed = [
        e.piston * proportions.dressed() / e.bore**3
        for e in ENGINES
        if e.kind == "petrol" and e.bore and e.piston and not e.piston_group
    ]
    every = groups + dressed
    mean = 1.0
    for k in every:
        mean *= k ** (1 / len(every))
    found = filled["cylinder.reciprocating_mass"]
    assert found.typical == pytest.approx(mean * bore**3, rel=1e-3)
    assert found.low <= min(every) * bore**3 * 1.0001
    assert found.high >= max(every) * bore**3 * 0.9999


def test_displacement_gives_bore_and_stroke() -> None:
    tree = estimated(tree_of("i4")[1], displacement=1.998e-3).tree
    engine = engine_of(tree)
    bore, stroke = engine.first.bore or 0, 2 * engine.throw(engine.first).radius
    assert 4 * pi / 4 * bore**2 * stroke == pytest.approx(1.998e-3, rel=2e-3)
    assert (engine.speed or 0) * stroke / pi == pytest.approx(16.0, rel=2e-3)


def test_a_bore_alone_gives_the_stroke_and_a_stroke_the_bore() -> None:
    for key in ("bore", "stroke"):
        tree = tree_of("i4")[1]
        tree["cylinder"][key] = "86 mm"
        engine = engine_of(estimated(tree).tree)
        other = (
            (engine.first.bore or 0) if key == "stroke" else 2 * engine.throw(engine.first).radius
        )
        assert 0.06 < other < 0.11
        assert balance(engine, speed=engine.speed).units.force == "N"


@pytest.mark.parametrize(
    ("name", "options", "message"),
    [
        ("i4", {}, "there is no bore, stroke or displacement"),
        ("man-s90mc-c", {}, "no masses of engines of type crosshead"),
        ("toyota-2jz", {"displacement": 3e-3}, "which the displacement would contradict"),
    ],
)
def test_what_cannot_be_estimated_is_refused(
    name: str, options: dict[str, Any], message: str
) -> None:
    with pytest.raises(EngineFileError, match=message):
        estimated(tree_of(name)[1], name=name, **options)


@pytest.mark.parametrize("own", ["bore", "stroke"])
def test_either_size_contradicts_a_displacement(own: str) -> None:
    tree = tree_of("i4")[1]
    tree["cylinder"] = {**tree["cylinder"], own: "80 mm"}
    with pytest.raises(EngineFileError, match="which the displacement would contradict"):
        estimated(tree, name="i4", displacement=2e-3)


def within(number: Any, shown: Any, place: str = "") -> int:
    """Assert that a tree's numbers lie in the ranges of a ranged tree; how many have one."""
    count = 0
    if isinstance(shown, dict):
        for key, value in shown.items():
            if key.endswith(("_low", "_high", "_estimated")) or key in ("estimated", "phase_deg"):
                continue
            if f"{key}_low" in shown:
                size = amplitude(number[key])
                low, high = shown[f"{key}_low"], shown[f"{key}_high"]
                slack = 1e-9 * (abs(low) + abs(high))
                assert low - slack <= size <= high + slack, (place, key, low, size, high)
                assert low - slack <= amplitude(value) <= high + slack
                count += 1
            else:
                count += within(number[key], value, f"{place}.{key}")
    elif isinstance(shown, list) and not is_row(shown):
        assert len(shown) == len(number), place
        for one, other in zip(number, shown, strict=True):
            count += within(one, other, place)
    elif isinstance(shown, float) or is_row(shown):
        scale = 1e-6 * 1e5
        assert number == pytest.approx(shown, rel=1e-6, abs=scale), place
    return count


def is_row(value: Any) -> bool:
    """Whether it is a vector."""
    return isinstance(value, list) and all(isinstance(one, int | float) for one in value)


def amplitude(value: Any) -> float:
    """The size of a number, a wave or a vector."""
    if isinstance(value, dict):
        return value["amplitude"]
    return abs(complex(*value)) if isinstance(value, list) else value


@pytest.mark.release
@pytest.mark.parametrize("name", SAMPLE)
def test_any_masses_within_the_ranges_stay_within_what_is_shown(name: str) -> None:
    tree = tree_for(name)
    ends = spread(tree)
    assert ends is not None
    shown = machine.tree(ranged(numbers, ends, ends.engine))
    own = ranges(tree)
    chance = random.Random(name)  # noqa: S311
    for _turn in range(10):
        factors = {path: chance.uniform(r.low, r.high) for path, r in own.items()}
        other = machine.tree(numbers(engine_of(scaled(tree, factors))))
        assert within(other["orders"], shown["orders"]) > 4


@pytest.mark.release
def test_a_cancelling_sum_has_a_range_from_nought() -> None:
    """Weights fitted to the typical masses leave a force at all others."""
    tree = tree_for("kr250-racer")
    explicit = toml(engine_of(tree | {"balance_factor": 0.5}))
    fixed = tomllib.loads(explicit)
    ends = spread(fixed)
    assert ends is not None
    document = ranged(numbers, ends, ends.engine)
    shown = machine.tree(document)
    chance = random.Random(3)  # noqa: S311
    own = ranges(fixed)
    for _turn in range(10):
        factors = {path: chance.uniform(r.low, r.high) for path, r in own.items()}
        other = machine.tree(numbers(engine_of(scaled(fixed, factors))))
        within(other["orders"], shown["orders"])


@pytest.mark.release
def test_ranges_are_no_wider_than_masses_alone_can_make_them() -> None:
    """One mass without cancellation: force is proportional to it, and so are both ends."""
    tree = tree_for("napier-deltic")
    ends = spread(tree)
    assert ends is not None
    document = ranged(numbers, ends, ends.engine)
    (one,) = ranges(tree).values()
    cells = [c for table in document.tables for row in table.rows for c in row]
    found = [cell for cell in cells if isinstance(cell, Ranged)]
    assert found
    for cell in found:
        size = abs(cell.value)
        assert cell.low == pytest.approx(one.low * size, rel=1e-9, abs=1e-6)
        assert cell.high == pytest.approx(one.high * size, rel=1e-9, abs=1e-6)


@pytest.mark.release
@pytest.mark.parametrize("form", ["layout", "explicit"])
def test_the_inertia_of_a_rod_moves_with_its_mass_and_centre(form: str) -> None:
    """Roads: the file scaled, and I m' b' (l - b') / m b (l - b) of the engine read from it."""
    tree = tree_for("honda-b18c")
    if form == "explicit":
        tree = tomllib.loads(toml(engine_of(tree)))
    before = engine_of(tree).first
    factors = {"cylinder.rod.mass": 1.3, "cylinder.rod.centre": 0.9, "cylinder.rod.inertia": 1.1}
    after = engine_of(scaled(tree, factors)).first
    assert before.rod is not None
    assert after.rod is not None
    mass, centre = 1.3 * before.rod.mass, 0.9 * before.rod.centre
    two = mass * centre * (before.rod_length - centre)
    assert before.rod.inertia is not None
    own = before.rod.mass * before.rod.centre * (before.rod_length - before.rod.centre)
    assert after.rod.mass == pytest.approx(mass)
    assert after.rod.centre == pytest.approx(centre)
    assert after.rod.inertia == pytest.approx(1.1 * before.rod.inertia * two / own)


def test_a_rod_named_in_no_place_is_left_as_it_is() -> None:
    source = {"status": "estimated", "range": [0.5, 2.0], "moves_with": "cylinder.rod"}
    tree = {"cylinder": {"rod": {"inertia": 3.0}}, "provenance": {"cylinder.rod.inertia": source}}
    assert scaled(tree, {"cylinder.rod.inertia": 2.0})["cylinder"]["rod"] == {"inertia": 6.0}


@pytest.mark.release
def test_a_file_written_gives_the_same_ranges_again(tmp_path: Path) -> None:
    for explicit in (False, True):
        tree = tree_for("gm-3800")
        place = tmp_path / "engine.toml"
        place.write_text(toml(engine_of(tree)) if explicit else tree_text(tree))
        again = tree_of(place)[1]
        ends, own = spread(again), spread(tree)
        assert ends is not None
        assert own is not None
        assert ranges(again) == ranges(tree)
        first = machine.tree(ranged(numbers, own, own.engine))["orders"]
        second = machine.tree(ranged(numbers, ends, ends.engine))["orders"]
        assert json.dumps(first)[:500] == json.dumps(second)[:500] or explicit
        high = [row["force"]["greatest_high"] for row in first if "greatest_high" in row["force"]]
        other = [row["force"]["greatest_high"] for row in second if "greatest_high" in row["force"]]
        assert high == pytest.approx(other, rel=1e-6)


@pytest.mark.release
def test_a_value_that_is_set_is_no_longer_estimated(run: Run) -> None:
    run("estimate", "toyota-2jz", "-o", "whole.toml")
    text = run("analyze", "whole.toml", "--set", "cylinder.reciprocating_mass=450 g").out
    assert "cylinder.reciprocating_mass" not in text.split("What rests")[0]
    assert "cylinder.rod.mass" in text.split("What rests")[0]


@pytest.mark.release
@pytest.mark.parametrize(
    ("verb", "form"),
    [
        *(("analyze", form) for form in ("json", "csv", "txt")),
        *(
            pytest.param(verb, form, marks=pytest.mark.release)
            for verb in ("analyze", "compare")
            for form in ("json", "csv", "xlsx", "parquet", "txt")
            if verb == "compare" or form in ("xlsx", "parquet")
        ),
    ],
)
def test_nothing_estimated_is_written_without_its_mark(run: Run, form: str, verb: str) -> None:
    engines = ["toyota-2jz"] + ["merlin"] * (verb == "compare")
    run(verb, *engines, "--estimate", "--speed", "3000 rpm", "-o", f"out.{form}")
    content = Path(f"out.{form}")
    if form == "json":
        tree = json.loads(content.read_text())
        assert {row["path"] for row in tree["estimated"]} >= {"cylinder.rod.mass"}
        assert "_estimated" in content.read_text()
    elif form == "csv":
        heads = next(csv.reader(io.StringIO(content.read_text())))
        assert {"amplitude", "amplitude_low", "amplitude_estimated"} <= {*heads} or (
            {"greatest", "greatest_low", "greatest_estimated"} <= {*heads}
        )
    elif form == "xlsx":
        import openpyxl

        book = openpyxl.load_workbook(content)
        heads = [str(c.value) for sheet in book for c in next(iter(sheet.rows))]
        assert any(head.endswith("_estimated") for head in heads)
    elif form == "parquet":
        import pyarrow.parquet

        heads = pyarrow.parquet.read_table(content).column_names
        assert any(head.endswith("_estimated") for head in heads)
    else:
        assert "Estimated as of type " in content.read_text()
        assert "(estimated)" in content.read_text()


@pytest.mark.release
def test_sentences_give_the_range_of_each_number() -> None:
    ends = spread(tree_for("bmw-m52b28"))
    assert ends is not None
    document = ranged(
        lambda engine: verdict_document(engine, verdict(engine, relatives=False)), ends, ends.engine
    )
    (table,) = document.tables
    force = next(str(row[-1]) for row in table.rows if row[0] == "force")
    assert force.startswith("No primary or secondary force. Force of order 6: about ")
    assert "estimated) N, vertical." in force
    assert not any("\ue000" in str(cell) for row in table.rows for cell in row)


def test_without_estimates_tables_are_as_before() -> None:
    engine = load("subaru-ej25")
    whole = analysis.document(analysis.analysis(engine, speed=None))
    assert (
        ranged(lambda e: analysis.document(analysis.analysis(e, speed=None)), None, engine) == whole
    )


def test_estimate_prints_value_range_and_source(run: Run) -> None:
    text = run("estimate", "toyota-2jz").out
    line = next(line for line in text.splitlines() if "cylinder.reciprocating_mass" in line)
    assert [word for word in ("468 g", "374 g", "612 g", "bore^3") if word not in line] == []
    tree = json.loads(run("estimate", "i4", "--displacement", "1998 cc", "--json").out)
    assert tree["type"] == "petrol"
    row = next(row for row in tree["filled"] if row["path"] == "cylinder.bore")
    assert row["unit"] == "m"
    assert row["low"] < row["estimated_value"] < row["high"]


def test_types_and_displacements_are_checked(refused: Callable[..., str]) -> None:
    assert "--type" in refused("estimate", "i4", "--type", "steam")
    assert "--displacement" in refused("estimate", "i4", "--displacement", "2 kg")
    assert "--displacement" in refused("estimate", "i4", "--displacement", "0 l")


@pytest.mark.parametrize(
    ("entry", "said"),
    [
        ('"layout.throws" = { status = "estimated", range = [0.8, 1.2] }', "only these may have"),
        ('"firing_order" = { status = "estimated", range = [0.8, 1.2] }', "only these may have"),
        ('"layout" = { status = "estimated", range = [0.8, 1.2] }', "only these may have"),
        (
            '"cylinder.reciprocating_mass" = { status = "estimated", range = ["1 kg", "2 kg"] }',
            "give multiples of the value without a unit, such as [0.9, 1.1]",
        ),
        ('"cylinder.reciprocating_mass" = { status = "estimated", range = [1.2, 0.8] }', "lowest"),
        ('"cylinder.reciprocating_mass" = { status = "estimated", range = [2, 3] }', "with 1"),
        ('"cylinder.reciprocating_mass" = { status = "estimated", range = [0.5] }', "range"),
        (
            '"cylinder.bore" = { status = "estimated", range = [1, 2], moves_with = ["x"] }',
            "moves_with",
        ),
        *(
            (
                f'"cylinder.bore" = {{ status = "estimated", range = [1, 2], {with_} }}',
                f"{with_.replace(' =', ' is')}; name another key of [provenance]",
            )
            for with_ in (
                f'moves_with = "{key}"'
                for key in ("cylinder.bore", "cylinder.rod", "cylinder.stroke", "moon")
            )
        ),
    ],
)
@pytest.mark.parametrize("form", ["short", "explicit"])
def test_odd_ranges_are_mistakes_of_the_file(entry: str, said: str, form: str, run: Run) -> None:
    _name, tree = tree_of("audi-25-tfsi")
    tree = tree if form == "short" else files.explicit(load("i4"))
    text = tree_text({key: value for key, value in tree.items() if key != "provenance"})
    Path("odd.toml").write_text(f"{text}\n[provenance]\n{entry}\n", encoding="utf-8")
    for verb in ("analyze", "check"):
        ended = run(verb, "odd.toml")
        assert ended.code == 2
        assert said in " ".join((ended.out + ended.err).split())


def test_a_range_written_as_text_is_a_range() -> None:
    tree = tree_of("audi-25-tfsi")[1]
    mass = {"status": "estimated", "range": "0.8, 1.25"}
    weighed = {**tree["cylinder"], "reciprocating_mass": "450 g"}
    made = {**tree, "cylinder": weighed, "provenance": {"cylinder.reciprocating_mass": mass}}
    assert ranges(made)["cylinder.reciprocating_mass"][:2] == (0.8, 1.25)


TOO_WIDE = 'provenance."cylinders[1].rod_length".range is too wide: at 0.8 times the value '


@pytest.mark.many(first=2)
@pytest.mark.parametrize(
    ("rod", "radius", "said"),
    [
        ([0.8, 1.3], [0.9, 1.0], TOO_WIDE),
        ([0.9, 1.3], [0.9, 1.1], "provenance: the ranges are too wide: at the ends of several "),
        ([0.9, 1.3], [0.9, 1.0], ""),
    ],
)
def test_ranges_that_reach_no_engine_are_named(
    rod: list[float], radius: list[float], said: str, run: Run
) -> None:
    """A rod of 95 mm turns with a crank of 80 mm, neither alone with one of 88, nor one of 76."""
    changes = {"cylinder.stroke": "160 mm", "cylinder.rod_length": "95 mm"}
    tree = files.explicit(load("audi-25-tfsi", changes=changes))
    entries = {"cylinders[1].rod_length": rod, "shaft[1].throw[1].radius": radius}
    tree["provenance"] = {
        path: {"status": "estimated", "range": ends} for path, ends in entries.items()
    }
    Path("wide.toml").write_text(tree_text(tree), encoding="utf-8")
    for verb in ("check", "analyze"):
        ended = run(verb, "wide.toml")
        assert ended.code == (2 if said else 0)
        words = " ".join((ended.out + ended.err).split())
        assert said in words
        assert ("too short to turn with crank radius" in words) == bool(said)


@pytest.mark.release
@pytest.mark.parametrize(("bore", "outside"), [("40 mm", True), ("86 mm", False), ("250 mm", True)])
def test_an_engine_beyond_those_that_were_weighed_is_told(
    bore: str, outside: bool, run: Run, tmp_path: Path
) -> None:
    """Bores of the engines with weighed parts: 69.85 to 150 mm."""
    own = {"name": "one", "layout": {"type": "inline", "throws": [0]}}
    own["cylinder"] = {"bore": bore, "stroke": bore, "rod_ratio": 3.6}
    (tmp_path / "one.json").write_text(json.dumps(own), encoding="utf-8")
    said = "the masses are estimated from engines with bores of 69.85 to 150 mm"
    shown = run("estimate", "one.json")
    assert (said in " ".join(shown.out.split())) == outside
    weighed = [e.bore for e in ENGINES if e.bore and (e.piston or e.piston_group or e.rod)]
    assert (min(weighed), max(weighed)) == (0.06985, 0.15)
    whole = " ".join(run("analyze", "one.json", "--estimate").out.split())
    assert (said in whole) == outside
