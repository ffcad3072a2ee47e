"""Both forms of an engine file, TOML and JSON, starter files, the JSON Schema: all agree."""

from __future__ import annotations

import copy
import json
import re
import tomllib
from collections.abc import Iterator
from typing import Any

import jsonschema
import pytest
import tomli_w
from hypothesis import given
from tests.strategies import OF_ANY_KIND
from tests.texts import EXPLICIT, SHORT, problems, spoilt, told

import crankstar
from crankstar.engine.engine import Engine
from crankstar.engine.firing_angles import unfit
from crankstar.engine.layouts import LAYOUTS
from crankstar.engine.records import Cylinder, Record, Rod, Shaft, Throw, Weight
from crankstar.files import engine_of, explicit, schema, toml, tree_of
from crankstar.files.catalog import path_of
from crankstar.files.forms import by_key, quantity_of, record_in, short_form
from crankstar.files.starters import STARTERS
from crankstar.firing.intervals import firing
from crankstar.mechanics.balance import balance, total
from crankstar.remedy.loads import loads
from crankstar.tables.analysis import analysis, document
from crankstar.tables.engines import cylinders
from crankstar.tables.html import document_html

CATALOG = {
    name: path.read_text(encoding="utf-8") for name in crankstar.names() if (path := path_of(name))
}
FILES = {
    **CATALOG,
    **{f"new {kind}": text for kind, text in STARTERS.items()},
    "short": SHORT,
    "explicit": EXPLICIT,
}
SCHEMA = schema()
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)


def alike(one: Any, other: Any, *, share: float = 1e-13) -> bool:
    """Whether two trees or records are equal but for the last digits of their numbers."""
    if isinstance(one, Record) and isinstance(other, Record):
        return type(one) is type(other) and alike(dict(one), dict(other), share=share)
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(
            alike(one[key], other[key], share=share) for key in one
        )
    if isinstance(one, list | tuple) and isinstance(other, list | tuple):
        return len(one) == len(other) and all(
            alike(a, b, share=share) for a, b in zip(one, other, strict=True)
        )
    if isinstance(one, float) and isinstance(other, float):
        return one == pytest.approx(other, rel=share, abs=share)
    return one == other


def rewritten(engine: Engine) -> Engine:
    """The engine written in the explicit form and read back."""
    return engine_of(tree_of(toml(engine)))


@pytest.mark.release
@pytest.mark.parametrize("kind", OF_ANY_KIND)
def test_an_engine_of_any_kind_is_the_same_written_and_read_back(kind: str) -> None:
    @given(OF_ANY_KIND[kind])
    def same(engine: Engine) -> None:
        if unfit(engine):  # what Python may build, and a file may not say
            engine = engine.model_copy(update={"firing_order": (), "firing_angles": None})
        assert alike(rewritten(engine), engine)
        assert engine_of(tree_of(json.dumps(explicit(engine)))) == rewritten(engine)
        assert toml(rewritten(rewritten(engine))) == toml(rewritten(engine))

    same()


@pytest.mark.many(first=27)
@pytest.mark.parametrize("text", FILES.values(), ids=FILES)
def test_a_file_is_the_same_engine_in_both_forms_and_both_languages(text: str) -> None:
    engine = engine_of(tree_of(text))
    assert alike(rewritten(engine), engine)
    assert engine_of(tree_of(json.dumps(tomllib.loads(text)))) == engine
    assert (
        engine_of(tree_of(json.dumps(tomllib.loads(text), indent=2).replace("\n", "\r\n")))
        == engine
    )
    assert engine_of(tree_of(tomli_w.dumps(tomllib.loads(text)))) == engine


def test_reading_leaves_the_tree_as_it_was() -> None:
    for text in (SHORT, EXPLICIT):
        tree = tree_of(text)
        before = copy.deepcopy(tree)
        engine_of(tree, changes={"name": "other"})
        assert tree == before


def test_the_explicit_form_is_what_it_says() -> None:
    engine = engine_of(tree_of(EXPLICIT))
    assert [shaft.name for shaft in engine.shafts] == ["crank", "balance shaft"]
    assert engine.shafts[1] == Shaft(
        name="balance shaft",
        speed_ratio=-1,  # pyright: ignore[reportArgumentType]
        right=0.1,
        weights=(Weight(unbalance=0.02, angle=engine.shafts[1].weights[0].angle, z=0.17),),
    )
    assert engine.cylinders[1] == Cylinder(
        number=2, shaft="crank", throw=2, z=-0.05, rod_length=0.146, reciprocating_mass=0.65
    )
    assert engine.throw(engine.cylinders[0]) == Throw(
        angle=0.0, radius=0.04, z=0.05, rotating_mass=1.0
    )


def test_the_short_form_is_what_it_says() -> None:
    engine = engine_of(tree_of(SHORT))
    assert (engine.relative, engine.pitch) == ((), 0.1055)
    assert [cylinder.rod_length for cylinder in engine.cylinders] == pytest.approx([0.146] * 8)
    assert [cylinder.bore for cylinder in engine.cylinders] == pytest.approx([0.0875] * 8)
    assert [throw.radius for throw in engine.shafts[0].throws] == pytest.approx([0.04125] * 4)
    assert [throw.rotating_mass for throw in engine.shafts[0].throws] == pytest.approx([1.4] * 4)
    by_number = {cylinder.number: cylinder for cylinder in engine.cylinders}
    assert by_number[1].z - by_number[2].z == pytest.approx(0.021)
    assert by_number[1].z - by_number[3].z == pytest.approx(0.1055)


@pytest.mark.parametrize(
    ("key", "value", "number"),
    [
        ("bore", "80 mm", 0.08),
        ("rod_length", "150 mm", 0.15),
        ("offset", "1 mm", 0.001),
        ("reciprocating_mass", "655 g", 0.655),
        ("bearing", "30 deg", 0.5235987755982988),
        ("z", "1 mm", 0.001),
        ("bank", "odd one", "odd one"),
    ],
)
def test_an_override_changes_one_cylinder_and_no_other(
    key: str, value: str, number: object
) -> None:
    plain = engine_of(spoilt(SHORT, firing_order=[]))
    changed = engine_of(spoilt(SHORT, firing_order=[], cylinders=[{"number": 7, key: value}]))
    for before, after in zip(plain.cylinders, changed.cylinders, strict=True):
        assert getattr(after, key) == (
            pytest.approx(number) if after.number == 7 else getattr(before, key)
        )
        assert after.model_copy(update={key: getattr(before, key)}) == before


def test_an_override_of_what_turns_changes_its_pin() -> None:
    heavier = engine_of(spoilt(SHORT, cylinders=[{"number": 7, "rotating_mass": "800 g"}]))
    assert [throw.rotating_mass for throw in heavier.shafts[0].throws] == pytest.approx(
        [1.4, 1.4, 1.4, 0]
    )
    ends = [cylinder.big_end_mass for cylinder in heavier.cylinders]
    assert ends == pytest.approx([0, 0, 0, 0, 0, 0, 0.8, 0.7])  # each turns in its own place
    assert [load.rotating for load in loads(heavier)] == pytest.approx([1.4, 1.4, 1.4, 1.5])
    shown, alike = (cylinders(engine) for engine in (heavier, engine_of(spoilt(SHORT))))
    column = [each.key for each in shown.columns].index("big_end_mass")
    assert [row[column] for row in shown.rows] == pytest.approx(ends)
    assert "big_end_mass" not in [each.key for each in alike.columns]
    longer = engine_of(
        spoilt(SHORT, cylinders=[{"number": number, "stroke": "90 mm"} for number in (7, 8)])
    )
    assert [throw.radius for throw in longer.shafts[0].throws] == pytest.approx(
        [0.04125, 0.04125, 0.04125, 0.045]
    )
    other_ratio = engine_of(spoilt(SHORT, cylinders=[{"number": 7, "rod_ratio": 4}]))
    assert [c.rod_length for c in other_ratio.cylinders if c.number == 7] == pytest.approx([0.165])


def test_a_bank_without_a_name_takes_none_that_is_taken() -> None:
    tree = spoilt(EXPLICIT, cylinders__1__bank="bank 1")
    assert engine_of(tree).banks == {"bank 2": (1,), "bank 1": (2,)}
    assert [part.bank for part in balance(engine_of(tree)).parts[:2]] == ["bank 2", "bank 1"]
    assert engine_of(spoilt(EXPLICIT)).banks == {"bank 1": (1, 2)}


def test_overrides_can_give_a_rigid_rod_and_an_articulation() -> None:
    rod = {"mass": "0.6 kg", "centre": "40 mm", "inertia": "0.002 kg*m^2"}
    link = {"master": 1, "radius": "30 mm", "angle": "-90 deg"}
    tree = spoilt(
        SHORT,
        firing_order=[],
        cylinders=[{"number": 2, "rod": rod, "articulated": link, "rod_length": "116 mm"}],
    )
    second = next(cylinder for cylinder in engine_of(tree).cylinders if cylinder.number == 2)
    assert second.rod == Rod(mass=0.6, centre=0.04, inertia=0.002)
    assert second.articulated is not None
    assert (second.articulated.master, second.articulated.radius) == (1, 0.03)


def test_an_engine_without_sizes_and_masses_is_counted_in_its_own() -> None:
    bare = {
        "name": "three",
        "cycle": "two-stroke",
        "firing_order": [1, 3, 2],
        "layout": {"type": "inline"},
    }
    engine = engine_of(bare)
    assert engine.relative == ("mass", "radius", "pitch")
    assert {throw.radius for throw in engine.shafts[0].throws} == {1.0}
    assert {cylinder.reciprocating_mass for cylinder in engine.cylinders} == {1.0}
    assert [cylinder.z for cylinder in engine.cylinders] == [1, 0, -1]
    assert engine.provenance["cylinder.rod_length"].status == "placeholder"
    assert balance(engine, speed=100.0).units.force == "m*r*w^2"


@pytest.mark.parametrize(
    ("stroke", "mass", "pitch"), [("80 mm", "0.5 kg", "90 mm"), ("2 m", "3 t", "1.5 m")]
)
def test_sizes_do_not_change_what_is_counted_in_them(stroke: str, mass: str, pitch: str) -> None:
    layout = {"type": "inline", "throws": ["0 deg", "120 deg", "240 deg"]}
    bare = engine_of({"name": "three", "cylinder": {"rod_ratio": 3.5}, "layout": layout})
    sized = engine_of(
        {
            "name": "three",
            "cylinder": {"stroke": stroke, "rod_ratio": 3.5, "reciprocating_mass": mass},
            "layout": {**layout, "bore_pitch": pitch},
        }
    )
    for one, other in zip(total(balance(bare)), total(balance(sized)), strict=True):
        assert one.forward[:6] == pytest.approx(other.forward[:6], abs=1e-12)
        assert one.backward[:6] == pytest.approx(other.backward[:6], abs=1e-12)


def test_what_is_declared_relative_is_counted_in_itself() -> None:
    tree = {
        "name": "x",
        "cylinder": {"stroke": "80 mm", "rod_length": "160 mm"},
        "layout": {"type": "inline", "throws": [0, 3.1]},
    }
    engine = engine_of(tree)
    assert engine.relative == ("mass", "pitch")
    assert {cylinder.rod_length for cylinder in engine.cylinders} == {0.16}


@pytest.mark.parametrize("kind", STARTERS)
def test_every_starter_loads_fires_and_analyzes(kind: str) -> None:
    engine = engine_of(tree_of(STARTERS[kind]))
    assert len(firing(engine).intervals_deg) == len(engine.chambers)
    assert engine.relative == ()
    assert "Force on the block" in document_html(document(analysis(engine, speed=None)))


def test_there_is_a_starter_for_every_layout_and_for_the_explicit_form() -> None:
    assert set(STARTERS) == {*LAYOUTS, "explicit"}


OPTION = re.compile(r"^# (?:[a-z_]+ = .*|\[\[?[a-z]+\]\]?.*|\".*)$", re.MULTILINE)
TOGETHER = ("# [", "# number", "# reciprocating_mass", '# "')
"""Options of a starter that need each other, and [[cylinders]] and [provenance]."""
ELSEWHERE = {
    "pin_split": "the firing order does not fit turned pins",
    "articulated": "needs the throw of its master",
}


@pytest.mark.many(first=5)
@pytest.mark.parametrize("kind", STARTERS)
def test_every_option_of_a_starter_is_right_when_it_is_uncommented(kind: str) -> None:
    text = STARTERS[kind]
    options = OPTION.findall(text)
    assert len(options) >= 3
    for line in options:
        if not line.startswith(TOGETHER) and not any(word in line for word in ELSEWHERE):
            head = table_above(text, line)
            whole = text.replace(line, line[2:]).replace(head, head[2:])
            assert problems(whole) == [], line


def table_above(text: str, line: str) -> str:
    """The commented-out table in which a commented-out option stands; itself where in none."""
    before = text[: text.index(line)].rpartition("\n\n")[2]
    return before.partition("\n")[0] if before.startswith("# [") else line


@pytest.mark.parametrize("kind", LAYOUTS)
def test_the_tables_at_the_end_of_a_starter_are_right_when_they_are_uncommented(kind: str) -> None:
    text = STARTERS[kind]
    for line in OPTION.findall(text):
        text = text.replace(line, line[2:]) if line.startswith(TOGETHER) else text
    engine = engine_of(tree_of(text))
    assert engine.first.reciprocating_mass == pytest.approx(0.655)
    assert engine.provenance["cylinder.bore"].status == "published"


@pytest.mark.parametrize("text", FILES.values(), ids=FILES)
def test_the_schema_accepts_every_file_in_both_forms(text: str) -> None:
    tree = tomllib.loads(text)
    VALIDATOR.validate(tree)
    VALIDATOR.validate(explicit(engine_of(tree)))


def tables(value: Any) -> Iterator[dict[str, Any]]:
    """Every table in a tree, the tree itself first."""
    if isinstance(value, dict):
        yield value
    for item in (
        value.values() if isinstance(value, dict) else value if isinstance(value, list) else ()
    ):
        yield from tables(item)


@pytest.mark.many(first=6)
@pytest.mark.parametrize("name", ["short", "explicit", *(f"new {kind}" for kind in STARTERS)])
def test_the_schema_refuses_an_unknown_key_in_any_table(name: str) -> None:
    tree = tomllib.loads(FILES[name])
    for table in tables(tree):
        table["zzz"] = 1
        assert not VALIDATOR.is_valid(tree)
        assert problems(tree)
        del table["zzz"]
    assert VALIDATOR.is_valid(tree)


@pytest.mark.parametrize(
    "changes",
    [
        {"cylinder__stroke": True},
        {"cylinder__stroke": []},
        {"cylinder__stroke": -1},
        {"firing_order": [1.5]},
        {"firing_order": "1-2"},
        {"cycle": "six-stroke"},
        {"layout__type": "veee"},
        {"layout__banks": []},
        {"name": 3},
        {"format": 2},
        {"balance_factor": 3},
    ],
)
def test_what_the_schema_refuses_the_reader_refuses(changes: dict[str, Any]) -> None:
    tree = spoilt(SHORT, **changes)
    assert not VALIDATOR.is_valid(tree)
    assert told(tree)


def records(record: type[Record]) -> Iterator[type[Record]]:
    """A record and those in it."""
    yield record
    for info in by_key(record).values():
        inner = record_in(info.annotation)
        if inner is not None:
            yield from records(inner)


ALL = {
    record.__name__: record
    for model in (Engine, *map(short_form, LAYOUTS))
    for record in records(model)
}


@pytest.mark.release
def test_the_schema_is_a_schema_and_says_which_kind() -> None:
    jsonschema.Draft202012Validator.check_schema(SCHEMA)
    assert SCHEMA["$schema"] == "https://json-schema.org/draft/2020-12/schema"
    assert json.loads(json.dumps(SCHEMA)) == SCHEMA
    assert set(SCHEMA["$defs"]) == set(ALL)


@pytest.mark.parametrize("name", ALL)
def test_the_schema_has_every_key_with_its_meaning_and_its_unit(name: str) -> None:
    record, definition = ALL[name], SCHEMA["$defs"][name]
    keys = by_key(record)
    assert list(definition["properties"]) == list(keys)
    assert definition["additionalProperties"] is False
    by_parts = {"reciprocating_mass"} if "parts" in keys else set[str]()
    by_parts |= {"mass", "centre"} if name == "Rod" else set()  # which the cylinder requires
    needed = {key for key, info in keys.items() if info.is_required()}
    assert set(definition.get("required", ())) == needed - by_parts
    for key, info in keys.items():
        described = definition["properties"][key]
        assert described["description"].strip(), key
        quantity = quantity_of(info)
        if quantity is not None:
            assert f'"x-dimension": "{quantity.dimension}"' in json.dumps(described)
            assert json.dumps(quantity.example) in json.dumps(described)
