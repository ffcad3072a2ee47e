"""Bad input: each mistake has one clear sentence with the place, the value and a right value."""

from __future__ import annotations

import datetime
import io
import json
import os
import re
import sys
import tomllib
from pathlib import Path
from typing import Any

import pytest
from tests.texts import EXPLICIT, SHORT, check_sentences, codes, faults, problems, spoilt, told

import crankstar
from crankstar.files import EngineFileError, engine_of, read_file, tree_of
from crankstar.language.faults import where
from crankstar.tables.notebook import balance_html, engine_html

pytestmark = pytest.mark.quick

STARTLING = [
    "\x1b[31mred",
    "\u202eright to left",
    "\u200b",
    "a\u200fb",
    "\x00",
    "\x9b1m",
    "a\u2028b",
    "\ufeff",
    "\U000e0041",
]
ODD = [
    True,
    {},
    {"a": 1},
    [],
    [[]],
    [1],
    datetime.date(2020, 1, 1),
    datetime.time(12),
    10**30,
    10**400,
    10**5000,
    -1.5,
    "",
    "x",
]
ARTICULATED = {"master": 1, "radius": "20 mm", "angle": "40 deg"}


def refusal(path: Path | str, **arguments: Any) -> EngineFileError:
    """What reading a file that cannot be used raises."""
    with pytest.raises(EngineFileError) as caught:
        read_file(path, **arguments)
    check_sentences(caught.value)
    return caught.value


@pytest.mark.parametrize("text", [SHORT, EXPLICIT])
def test_the_files_that_are_spoilt_below_are_good(text: str) -> None:
    assert problems(text) == []


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("this is = = not toml", "line 1, column 6): this is = = not toml"),
        ("<html><body>\x7f</body></html>", "is a page (HTML)"),
        (
            'name = "x"\n[cylinder]\nstroke = 82.5 mm\n',
            'stands in quotation marks, as in "82.5 mm"',
        ),
        ("[layout]\nthrows = [0 deg, 90 deg]\n", 'as in "0 deg"'),
        ('name = "x"\nname = "y"\n', "the same key or table stands twice"),
        ('name = "\x1b[31m"', "is not TOML"),
        ('name = "\\ud800"', "is not TOML"),
    ],
)
def test_what_is_not_toml_is_told_with_line_and_column(text: str, words: str) -> None:
    ((place, message),) = problems(text)
    assert place == ""
    assert words in message


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (
            '{"name": "x", ',
            "is not JSON: Expecting property name enclosed in double quotes: line 1 column 15",
        ),
        ('{"name": "x"} {}', "Extra data: line 1 column 15"),
        ("[1, 2, 3]", "is JSON, but not an object"),
        ("null", "is JSON, but not an object"),
        ("[" * 100_000, "nested too deeply"),
        ('{"name": "x", "name": "y"}', 'has the key "name" twice'),
        ('{"layout": {"type": "vee", "type": "vee"}}', 'has the key "type" twice'),
    ],
)
def test_what_is_not_json_is_told_with_line_and_column(text: str, words: str) -> None:
    ((_, message),) = problems(text)
    assert words in message


@pytest.mark.parametrize(
    ("key", "place", "told_of"),
    [
        ("strok", "cylinder.strok", "stroke"),
        ("rod_lenght", "cylinder.rod_lenght", "rod_length"),
        ("Bore", "cylinder.Bore", "bore"),
    ],
)
def test_an_unknown_key_is_told_with_the_one_that_was_meant(
    key: str, place: str, told_of: str
) -> None:
    text = SHORT.replace(f"{told_of} =", f"{key} =")
    assert told(text) == {place: f'is not a key of an engine file; did you mean "{told_of}"?'}


@pytest.mark.parametrize(("head", "place"), [("[layout]", "layout.cylinders"), ("", "cylinders")])
def test_a_number_of_cylinders_is_told_what_sets_it(head: str, place: str) -> None:
    text = SHORT.replace(head, f"{head}\ncylinders = 8\n", 1)
    assert told(text) == {
        place: "cannot set the number of cylinders; there are as many as firing_order, or "
        "layout.throws, lists"
    }


def test_a_key_with_letters_exchanged_is_told_as_that_one() -> None:
    wanted = 'is not a key of an engine file; did you mean "wiebe_a"?'
    assert told(f"{SHORT}\n[gas]\nwiebea_ = 5\n")["gas.wiebea_"] == wanted


def test_an_unknown_key_deep_inside_is_told_with_its_place() -> None:
    text = SHORT.replace('bearing = "-45', 'baering = "-45')
    assert told(text) == {
        "layout.banks[2].baering": 'is not a key of an engine file; did you mean "bearing"?'
    }


@pytest.mark.parametrize(
    ("key", "fault"),
    [
        ("cylinder.bor", ("provenance.misspelt", '"cylinder.bore"')),
        ("layout.bank[1].bearing", ("provenance.misspelt", '"layout.banks.bearing"')),
        ("moonphase", ("provenance.unknown", None)),
    ],
)
def test_a_source_of_a_value_that_no_file_has_is_refused(
    key: str, fault: tuple[str, str | None]
) -> None:
    (only,) = faults(spoilt(SHORT, provenance={key: {"status": "published"}}))
    assert only.path == ("provenance", key)
    assert (only.code, only.values.get("meant")) == fault


@pytest.mark.parametrize(
    ("text", "key"),
    [
        (SHORT, "layout.banks[1].bearing"),
        (SHORT, "cylinders.reciprocating_mass"),
        (EXPLICIT, "shaft[1].throw[2].angle"),
        (EXPLICIT, "layout.throws"),  # an explicit file made from a layout
    ],
)
def test_a_source_may_stand_beside_any_value_of_the_file(text: str, key: str) -> None:
    assert problems(spoilt(text, provenance={key: {"status": "published"}})) == []


@pytest.mark.parametrize("order", ["x", 5, {"a": 1}, [1, "b"], [0]])
def test_an_order_that_is_none_does_not_ask_for_throws_as_well(order: object) -> None:
    tree = {"name": "six", "firing_order": order, "layout": {"type": "inline"}}
    assert all(place.startswith("firing_order") for place in codes(tree))
    assert "layout.throws" in codes(tree | {"firing_order": [], "speed": "x"})


@pytest.mark.parametrize(
    ("order", "wanted"),
    [
        ([1, 5, 3, 6, 2, 4, 4], ["has cylinder 4 more than once"]),
        ([1, 4, 2], ["misses cylinder 3; each of 1, 2, 3, 4 must fire"]),
        ([1, 1, 3], ["has cylinder 1 more than once", "misses cylinder 2"]),
        ([], ["give it, or a firing_order"]),
    ],
)
def test_an_order_from_which_throws_should_follow_is_told_what_it_lacks(
    order: list[int], wanted: list[str]
) -> None:
    tree = {"layout": {"type": "inline"}, "cylinder": {"rod_ratio": 3.5}, "firing_order": order}
    said = " ".join(problem.message for problem in problems(tree))
    assert [words for words in wanted if words not in said] == []


def test_a_key_in_the_wrong_table_is_told_where_it_belongs() -> None:
    assert told(SHORT + 'speed = "6000 rpm"\n')["layout.speed"] == (
        "is not a key of this table; it belongs at the top of the file, above the first [table]"
    )
    assert codes('stroke = "82.5 mm"\n' + SHORT)["stroke"] == "key.belongs-in"
    bearings = '[oil.main]\ndiameter = "60 mm"\nlength = "20 mm"\nwidth = "20 mm"\n'
    assert codes(SHORT + bearings)["oil.main.width"] == "key.unknown"


def test_tables_of_a_list_are_called_by_one_name_only() -> None:
    assert (
        told(EXPLICIT.replace("shaft.throw", "shaft.throws"))["shaft[1].throws"]
        == 'is not a key of an engine file; did you mean "throw"?'
    )
    assert (
        told(EXPLICIT.replace("[[shaft", "[[shafts"))["shafts"]
        == 'is not a key of an engine file; did you mean "shaft"?'
    )


def test_a_key_like_no_other_is_told_with_all_that_there_are() -> None:
    message = told("xyzzy = 1\n" + SHORT)["xyzzy"]
    assert message.startswith(
        "is not a key of an engine file; there are: balance_factor, balance_shaft, "
        "block, crankshaft, cycle, cylinder, cylinders,"
    )


@pytest.mark.parametrize("value", [82.5, "82.5", 146, "146"])
def test_a_size_without_a_unit_is_refused_where_metres_cannot_be_meant(value: object) -> None:
    (fault,) = faults(spoilt(SHORT, cylinder__stroke=value))
    assert fault.sentence == (
        f"cylinder.stroke is {value} m; the largest plausible value is 5 m. "
        f"Did you mean {value} mm?"
    )


@pytest.mark.parametrize(
    ("place", "value", "unit"),
    [
        ("layout__throws__1", 90, "rad"),
        ("layout__banks__0__bearing", "45", "rad"),
        ("cylinder__reciprocating_mass", 650, "kg"),
        ("layout__bore_pitch", 105.5, "m"),
        ("speed", 6000, "rad/s"),
        ("speed", 628.3, "rad/s"),
    ],
)
def test_a_number_without_a_unit_is_refused_where_si_cannot_be_meant(
    place: str, value: object, unit: str
) -> None:
    (fault,) = faults(spoilt(SHORT, **{place: value}))
    implausible = unit in ("rad", "m")
    assert fault.code == ("unit.implausible" if implausible else "unit.missing")
    assert not implausible or fault.values["unit"] == unit


@pytest.mark.parametrize("value", ["0.0825 m", "8.25 cm", "3.248 in"])
def test_a_size_is_in_any_unit_of_length(value: str) -> None:
    assert told(spoilt(SHORT, cylinder__stroke=value)) == {}


@pytest.mark.parametrize("value", [0.0825, "0.0825"])
def test_a_size_in_metres_needs_no_unit_where_no_other_size_has_one(value: object) -> None:
    tree = spoilt(SHORT, cylinder__stroke=value)
    (fault,) = faults(tree)
    assert fault.code == "unit.bare-beside-one"
    assert fault.values["like"] == "0.0825 mm"
    assert fault.values["absolute"] == fault.values["reading"] == "0.0825 m"
    bare = {"type": "inline", "throws": ["0 deg", "180 deg"], "bore_pitch": 0.1}
    sizes = {"bore": 0.086, "stroke": value, "rod_length": "0.14", "reciprocating_mass": "650 g"}
    assert engine_of({"name": "x", "cylinder": sizes, "layout": bare}).cylinders[0].bore == 0.086


@pytest.mark.parametrize(
    ("value", "kind"),
    [
        ("82 kg", "a mass"),
        ("82 deg", "an angle"),
        ("82 m^2", "an area"),
        ("82 cm3", "a volume"),
        ("82 s", "a time"),
        ("82 m/s", "a speed along a line"),
        ("82 rpm", "a rotational speed"),
        ("82 kg/s", "a damping"),
        ("82 kg*s", "another kind of quantity"),
    ],
)
def test_a_stroke_of_another_dimension_is_told_as_what_it_is(value: str, kind: str) -> None:
    wanted = f'is "{value}", {kind}; a length is needed, such as "82.5 mm"'
    assert told(spoilt(SHORT, cylinder__stroke=value)) == {"cylinder.stroke": wanted}


@pytest.mark.parametrize("written", ["nan", "inf", "-inf"])
def test_toml_numbers_that_are_none_are_refused(written: str) -> None:
    text = SHORT.replace('"82.5 mm"', written)
    said = f'is {written}, which is not finite; a length is needed, such as "82.5 mm"'
    assert told(text) == {"cylinder.stroke": said}


@pytest.mark.parametrize("written", ["NaN", "Infinity", "-Infinity"])
def test_json_numbers_that_are_none_are_refused(written: str) -> None:
    text = json.dumps(tomllib.loads(SHORT)).replace('"82.5 mm"', written)
    assert list(told(text)) == ["cylinder.stroke"]


@pytest.mark.parametrize(
    "value",
    [
        "nan mm",
        "inf mm",
        "-inf mm",
        "NaN",
        "infinity m",
        "",
        "   ",
        "mm",
        "mm 3",
        "--3 mm",
        "0x10 mm",
    ],
)
def test_texts_that_hold_no_number_are_refused(value: str) -> None:
    message = told(spoilt(SHORT, cylinder__stroke=value))["cylinder.stroke"]
    assert message.startswith(f'is "{value}", ')
    assert message.endswith('; a length is needed, such as "82.5 mm"')


@pytest.mark.parametrize(
    "value", ["1e400 mm", "1e999 mm", "1e300 m", "1e6 m", "1e-9 m", "1e-300 mm"]
)
@pytest.mark.parametrize("key", ["bore", "stroke", "rod_length"])
def test_sizes_no_engine_can_have_are_refused(key: str, value: str) -> None:
    """The first of a file as well, by which its bare numbers are judged."""
    tree = spoilt(SHORT, **{f"cylinder__{key}": value})
    tree["cylinder"] = {key: value, **tree["cylinder"]}
    assert told(tree)[f"cylinder.{key}"].startswith(f'is "{value}", too ')


@pytest.mark.parametrize("value", ["0 mm", "-82.5 mm", 0, 0.0, -0.0, -0.0825])
@pytest.mark.parametrize("key", ["bore", "stroke", "rod_length"])
def test_zero_and_negative_sizes_are_refused(key: str, value: object) -> None:
    message = told(spoilt(SHORT, **{f"cylinder__{key}": value}))[f"cylinder.{key}"]
    assert message == f'is {json.dumps(value)}; it must be greater than 0, such as "82.5 mm"'


def test_a_negative_mass_is_refused_and_an_engine_without_any_as_well() -> None:
    place = "cylinder.reciprocating_mass"
    assert told(spoilt(SHORT, cylinder__reciprocating_mass="-1 g")) == {
        place: 'is "-1 g"; it must be at least 0, such as "650 g"'
    }
    assert told(spoilt(SHORT, cylinder__reciprocating_mass="0 g"))[place].startswith(
        "is 0, and no other cylinder has a reciprocating mass"
    )


def in_line(*positions: str) -> dict[str, Any]:
    """A file with three cylinders in line at these distances behind the first."""
    throws = ["0 deg", "120 deg", "240 deg"]
    return {
        "name": "three",
        "cycle": "two-stroke",
        "layout": {"type": "inline", "throws": throws, "positions": list(positions)},
        "cylinder": {"stroke": "80 mm", "reciprocating_mass": "500 g"},
    }


def test_cylinder_1_is_the_frontmost_whatever_the_positions() -> None:
    places = [c.z for c in engine_of(in_line("10 mm", "110 mm", "240 mm")).cylinders]
    assert places == pytest.approx([0.115, 0.015, -0.115])
    assert codes(in_line("0 mm", "-100 mm", "-200 mm")) == {
        "layout.positions[2]": "layout.position-descending"
    }
    assert codes(in_line("-10 mm", "100 mm", "200 mm")) == {
        "layout.positions[1]": "layout.position-negative"
    }
    assert codes(in_line("0 mm", "200 mm", "100 mm")) == {
        "layout.positions[3]": "layout.position-descending"
    }


def needed(message: str) -> float:
    """The length that a sentence says would do, m."""
    found = re.search(r"at least ([\d.]+) m is needed$", message)
    assert found
    return float(found.group(1)) * (1 + 1e-5)  # it is written with six figures


@pytest.mark.parametrize(
    ("rod", "offset"),
    [("41.28 mm", "0 mm"), ("80 mm", "60 mm"), ("80 mm", "-60 mm"), ("1 mm", "0 mm")],
)
def test_a_rod_shorter_than_crank_radius_and_offset_is_refused(rod: str, offset: str) -> None:
    (fault,) = faults(spoilt(SHORT, cylinder__rod_length=rod, cylinder__offset=offset))
    assert fault.path == ("cylinder", "rod_length")
    assert fault.code == "rod.too-short" + "-with-offset" * (offset != "0 mm")
    assert fault.values["radius"] == pytest.approx(0.04125)
    enough = needed(fault.sentence)
    longer = f"{enough} m"
    assert faults(spoilt(SHORT, cylinder__rod_length=longer, cylinder__offset=offset)) == []


def test_a_rod_too_short_for_one_cylinder_is_told_where_the_file_says_so() -> None:
    other = [{"number": 7, "bore": "80 mm"}, {"number": 5, "rod_length": "20 mm"}]
    assert list(told(spoilt(SHORT, cylinders=other))) == ["cylinders[2].rod_length"]
    assert list(told(spoilt(EXPLICIT, cylinders__1__rod_length="20 mm"))) == [
        "cylinders[2].rod_length"
    ]
    assert list(told(spoilt(SHORT, cylinders=other[:1], cylinder__rod_length="20 mm"))) == [
        "cylinder.rod_length"
    ]


@pytest.mark.parametrize("ratio", [1e9, 1e300])
def test_a_rod_longer_than_any_is_refused(ratio: float) -> None:
    told_of = told(spoilt(SHORT, cylinder__rod_length=None, cylinder__rod_ratio=ratio))
    assert list(told_of) == ["cylinder.rod_ratio"]
    assert "at most 1e+06" in told_of["cylinder.rod_ratio"]


@pytest.mark.parametrize("length", ["1 mm", "46 mm", "68.5 mm"])
def test_a_slave_rod_that_cannot_reach_its_cylinder_is_refused(length: str) -> None:
    tree = spoilt(
        EXPLICIT,
        cylinders__1__throw=1,
        cylinders__1__rod_length=length,
        cylinders__1__articulated=ARTICULATED,
    )
    tree["cylinders"][1]["articulated"] = {**ARTICULATED, "radius": "30 mm", "angle": "90 deg"}
    ((place, message),) = told(tree).items()
    assert place == "cylinders[2].rod_length"
    assert "articulated rod is too short to reach its cylinder over the whole turn" in message
    assert (
        told(
            spoilt(
                EXPLICIT, cylinders__1=tree["cylinders"][1] | {"rod_length": f"{needed(message)} m"}
            )
        )
        == {}
    )


@pytest.mark.parametrize("throw", [0, -1, 3, 10_000, 10**30])
def test_a_throw_that_is_not_there_is_refused(throw: int) -> None:
    ((place, message),) = told(spoilt(EXPLICIT, cylinders__1__throw=throw)).items()
    assert place == "cylinders[2].throw"
    assert message.startswith(f"is {throw}"[:40])


def test_the_throws_that_are_there_are_told() -> None:
    assert (
        "has throws 1 to 2; " in told(spoilt(EXPLICIT, cylinders__1__throw=3))["cylinders[2].throw"]
    )
    assert (
        "has no throws; "
        in told(spoilt(EXPLICIT, cylinders__1__shaft="balance shaft"))["cylinders[2].throw"]
    )


def test_a_shaft_that_is_not_there_is_refused() -> None:
    message = told(spoilt(EXPLICIT, cylinders__1__shaft="krank"))["cylinders[2].shaft"]
    assert message == 'is "krank", and there is no such shaft; there are: crank, balance shaft'


@pytest.mark.parametrize("master", [0, 7, -1])
def test_a_master_that_is_not_there_is_refused(master: int) -> None:
    tree = spoilt(
        EXPLICIT, cylinders__1__throw=1, cylinders__1__articulated={**ARTICULATED, "master": master}
    )
    ((place, message),) = told(tree).items()
    assert place == "cylinders[2].articulated.master"
    assert message.startswith(f"is {master}")


def test_a_rod_articulated_on_itself_is_refused() -> None:
    tree = spoilt(EXPLICIT, cylinders__1__articulated={**ARTICULATED, "master": 2})
    assert "cylinder 2 is articulated on itself" in told(tree)["cylinders[2].articulated.master"]
    short = spoilt(SHORT, cylinders=[{"number": 3, "articulated": {**ARTICULATED, "master": 3}}])
    assert "cylinder 3 is articulated on itself" in told(short)["cylinders[1].articulated.master"]


def test_rods_articulated_in_a_loop_are_refused_once() -> None:
    tree = spoilt(
        EXPLICIT,
        cylinders__0__articulated={**ARTICULATED, "master": 2},
        cylinders__1__articulated=ARTICULATED,
    )
    (fault,) = faults(tree)
    assert fault.path == ("cylinders", 0, "articulated", "master")
    assert (fault.code, fault.values["numbers"]) == ("rod.articulated-in-loop", [1, 2, 1])


def chain(count: int) -> dict[str, Any]:
    tree = spoilt(EXPLICIT)
    one = tree["cylinders"][0]
    link = {"articulated": {**ARTICULATED, "radius": "0.1 mm"}}
    rest = [
        one | {"number": number} | {"articulated": link["articulated"] | {"master": number - 1}}
        for number in range(2, count + 1)
    ]
    return tree | {"cylinders": [one, *rest]}


@pytest.mark.release
def test_a_long_loop_and_a_long_chain_of_rods_are_refused_in_short() -> None:
    tree = chain(256)
    assert len(problems(tree)) == 248
    tree["cylinders"][0] |= {"articulated": {**ARTICULATED, "master": 256}}
    (fault,) = faults(tree)
    assert fault.code == "rod.articulated-in-loop"
    assert "(257 in all)" in fault.sentence
    assert problems(chain(8)) == []


def test_a_slave_on_another_throw_than_its_master_is_refused() -> None:
    message = told(spoilt(EXPLICIT, cylinders__1__articulated=ARTICULATED))["cylinders[2]"]
    assert (
        message
        == 'works on shaft "crank" throw 2, its master on "crank" throw 1; they must be the same'
    )


def test_a_master_of_a_row_that_is_not_in_it_is_refused() -> None:
    layout = {
        "type": "radial",
        "knuckle_radius": 0.3,
        "rows": [{"cylinders": [1, 2, 3], "master": 4}],
    }
    wanted = "is 4, and there is no such cylinder in the row; there are: 1, 2, 3"
    assert told({"name": "star", "layout": layout}) == {"layout.rows[1].master": wanted}


def test_duplicate_cylinder_numbers_are_refused() -> None:
    assert codes(spoilt(EXPLICIT, cylinders__1__number=1)) == {
        "cylinders[1].number": "cylinder.number-repeated",
        "cylinders[2].number": "cylinder.number-repeated",
    }
    twice = faults(SHORT.replace("[2, 4, 6, 8]", "[2, 4, 6, 7]"))
    fault = next(fault for fault in twice if fault.path == ("layout",))
    assert fault.code == "layout.number-repeated"
    assert fault.values == {"number": 7, "times": 2}
    longer = faults(SHORT.replace("[2, 4, 6, 8]", "[2, 4, 6, 8, 8]"))
    assert [fault.code for fault in longer] == ["layout.number-repeated"]


def test_two_shafts_of_one_name_are_refused() -> None:
    assert codes(spoilt(EXPLICIT, shaft__1__name="crank"))["shaft[2].name"] == "shaft.name-repeated"


@pytest.mark.parametrize(
    ("order", "messages"),
    [
        ([1, 8, 4, 3, 6, 5, 7], ["misses cylinder 2; each of 1, 2, 3, 4, 5, 6, 7, 8 must fire"]),
        ([1, 8, 4, 3, 6, 5], ["misses cylinders 2, 7; each of 1, 2, 3, 4, 5, 6, 7, 8 must fire"]),
        ([1, 8, 4, 3, 6, 5, 7, 2, 2], ["has cylinder 2 more than once; each fires once a cycle"]),
        (
            [1, 8, 4, 3, 6, 5, 7, 2, 9],
            ["has cylinder 9, and there is no such cylinder; there are: 1, 2, 3, 4, 5, 6, 7, 8"],
        ),
        (
            [1, 1, 4, 3, 6, 5, 7, 9],
            [
                "has cylinder 1 more than once; each fires once a cycle",
                "has cylinder 9, and there is no such cylinder; there are: 1, 2, 3, 4, 5, 6, 7, 8",
                "misses cylinders 2, 8; each of 1, 2, 3, 4, 5, 6, 7, 8 must fire",
            ],
        ),
    ],
)
def test_a_firing_order_with_missing_repeated_or_foreign_cylinders_is_refused(
    order: list[int], messages: list[str]
) -> None:
    assert problems(spoilt(SHORT, firing_order=order)) == [
        ("firing_order", message) for message in messages
    ]


def test_an_impossible_order_is_refused_with_the_table_of_dead_centres() -> None:
    (fault,) = faults(spoilt(SHORT, firing_order=[1, 2, 3, 4, 5, 6, 7, 8]))
    assert (fault.path, fault.code) == (("firing_order",), "firing_order.unfit")
    assert fault.values["order"] == "1-2-3-4-5-6-7-8"
    assert (fault.values["cycle"], fault.values["centres"]) == (
        720,
        {1: 0, 2: 270, 3: 270, 4: 180, 5: 90, 6: 0, 7: 180, 8: 90},
    )


def test_an_order_for_the_mirror_image_is_told_so() -> None:
    swapped = (
        SHORT.replace('"-45 deg"', '"@"')
        .replace('"45 deg"', '"-45 deg"')
        .replace('"@"', '"45 deg"')
    )
    (fault,) = faults(swapped)
    assert fault.code.startswith("firing_order.unfit-other-banks")
    assert fault.values["banks"] == {"1, 3, 5, 7": "+45", "2, 4, 6, 8": "-45"}
    (fault,) = faults('rotation = "counter-clockwise"\n' + SHORT)
    assert fault.code.endswith("rotation")
    assert fault.values["rotation"] == "clockwise"


def test_cylinders_that_would_have_to_fire_together_are_told() -> None:
    message = told(spoilt(SHORT, cycle="two-stroke"))["firing_order"]
    assert "Cylinders 1 and 6; 2 and 3; 4 and 7; 5 and 8 are at dead centre together" in message


@pytest.mark.parametrize(
    ("angles", "place", "words"),
    [
        (
            ["0 deg", "170 deg"],
            "firing_angles[2]",
            "is 170 deg; cylinder 2 is at top dead centre at 180 deg",
        ),
        (["0 deg"], "firing_angles", "has 1 angle, but firing_order has 2 cylinders"),
        (["360 deg", "180 deg"], "firing_angles", "must ascend within one cycle of 360 deg"),
        (["0 deg", "1e300 deg"], "firing_angles[2]", "too large for an engine"),
        ("0 deg", "firing_angles", "a list is needed"),
    ],
)
def test_firing_angles_off_the_dead_centres_are_refused(
    angles: object, place: str, words: str
) -> None:
    assert words in told(spoilt(EXPLICIT, firing_order=[1, 2], firing_angles=angles))[place]


@pytest.mark.parametrize("ratio", [0, 0.0, -0.0, "0", "0/1", "0.0"])
def test_a_speed_ratio_of_zero_is_refused(ratio: object) -> None:
    spoilt_tree = spoilt(EXPLICIT, shaft__1__speed_ratio=ratio)
    assert codes(spoilt_tree) == {"shaft[2].speed_ratio": "ratio.zero"}


@pytest.mark.parametrize(
    "ratio",
    [
        "1/0",
        "x",
        "",
        "--1",
        "1/2/3",
        "1e3",
        True,
        [1],
        {"a": 1},
        float("nan"),
        float("inf"),
        "9" * 400,
    ],
)
def test_what_is_no_ratio_is_refused(ratio: object) -> None:
    message = told(spoilt(EXPLICIT, shaft__1__speed_ratio=ratio))["shaft[2].speed_ratio"]
    assert 'a whole number or a ratio of teeth is needed, such as "29/31"' in message


@pytest.mark.parametrize("ratio", [0.333333, 1e-30, 1e300, 1001, "1/1001", "1234/999", 10**400])
def test_ratios_that_no_two_gears_have_are_refused(ratio: object) -> None:
    message = told(spoilt(EXPLICIT, shaft__1__speed_ratio=ratio))["shaft[2].speed_ratio"]
    assert "not a ratio of two numbers of teeth up to 1000; write it as one" in message


@pytest.mark.parametrize("ratio", [51, -1000, "1/51"])
def test_shafts_that_race_or_creep_are_refused(ratio: object) -> None:
    assert (
        "at most 50 times faster or slower"
        in told(spoilt(EXPLICIT, shaft__1__speed_ratio=ratio))["shaft[2].speed_ratio"]
    )


@pytest.mark.parametrize("ratio", ["31/29", "-29 / 31", "2:1", 2, -0.5, 1 / 3, "1.5"])
def test_ratios_of_teeth_are_taken(ratio: object) -> None:
    assert told(spoilt(EXPLICIT, shaft__1__speed_ratio=ratio)) == {}


def test_shafts_that_are_never_back_at_the_start_are_refused() -> None:
    tree = spoilt(EXPLICIT, shaft__1__speed_ratio="997/991")
    tree["shaft"].append({"name": "third", "speed_ratio": "983/977"})
    (fault,) = faults(tree)
    assert (fault.path, fault.code) == (("shaft",), "shaft.period-too-long")
    assert fault.values["turns"] == 968207


def test_a_reference_crankshaft_that_is_geared_or_elsewhere_is_refused() -> None:
    for ratio in (-1, 2):
        geared = codes(spoilt(EXPLICIT, shaft__0__speed_ratio=ratio))
        assert geared["shaft[1].speed_ratio"] == "shaft.reference-ratio"
    assert codes(spoilt(EXPLICIT, shaft__0__up="3 mm"))["shaft[1]"] == "shaft.reference-place"


@pytest.mark.parametrize("content", [b"", b"  \n\t \r\n ", b"\xef\xbb\xbf"])
def test_an_empty_file_is_told_how_to_begin(tmp_path: Path, content: bytes) -> None:
    file = tmp_path / "empty.toml"
    file.write_bytes(content)
    assert "`crankstar new vee` writes" in str(refusal(file)) or content.startswith(b"\xef")


def test_a_file_of_100_mb_is_refused_before_it_is_read(tmp_path: Path) -> None:
    file = tmp_path / "large.toml"
    with file.open("wb") as handle:
        handle.truncate(100_000_000)
    assert "is larger than 1 MB; an engine file has a few kB" in str(refusal(file))


@pytest.mark.parametrize(
    "content",
    [
        bytes(range(256)) * 10,
        b"\x7fELF\x02\x01\x01\x00",
        SHORT.encode("utf-16"),
        SHORT.encode("utf-16-le"),
        SHORT.encode("utf-32"),
        'name = "Wörter"'.encode("latin-1"),
        b'name = "a\x00b"',
    ],
)
def test_a_binary_file_is_refused(tmp_path: Path, content: bytes) -> None:
    file = tmp_path / "binary.toml"
    file.write_bytes(content)
    assert "is not a text file in UTF-8; an engine file is TOML or JSON" in str(refusal(file))


@pytest.mark.parametrize("before", ["\ufeff", ""])
def test_a_byte_order_mark_and_windows_line_ends_are_no_mistake(
    tmp_path: Path, before: str
) -> None:
    file = tmp_path / "windows.toml"
    file.write_bytes((before + SHORT.replace("\n", "\r\n")).encode())
    assert read_file(file).name == "V8, cross-plane, 90 deg"


def test_a_file_that_is_not_there_is_told(tmp_path: Path) -> None:
    assert "there is no such file; `crankstar list`" in str(refusal(tmp_path / "none.toml"))
    with pytest.raises(EngineFileError, match="did you mean v8-flat-plane"):
        crankstar.load("v8-flatplane")


def test_a_directory_is_told_as_one(tmp_path: Path) -> None:
    assert "is a directory; name a file in it" in str(refusal(tmp_path))


def test_devices_and_pipes_are_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe")
    for path in (tmp_path / "pipe", Path("/dev/zero")):
        assert "is not a regular file; use - to read standard input" in str(refusal(path))


def test_a_file_that_may_not_be_read_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refused(*_: object) -> None:
        raise PermissionError(13, "Permission denied")

    (tmp_path / "secret.toml").write_text(SHORT)
    monkeypatch.setattr(Path, "open", refused)
    assert "cannot be read (Permission denied); " in str(refusal(tmp_path / "secret.toml"))


def test_links_that_lead_nowhere_and_names_no_file_can_have_are_told(tmp_path: Path) -> None:
    (tmp_path / "loop.toml").symlink_to("loop.toml")
    assert "Too many levels of symbolic links" in str(refusal(tmp_path / "loop.toml"))
    assert "File name too long" in str(refusal("a/" * 5000))
    assert "File name too long" in str(refusal("a" * 5000 + ".toml"))
    assert "is not a name a file can have" in str(refusal("a\0b.toml"))
    assert "Not a directory" in str(refusal(Path(__file__) / "x.toml"))


@pytest.mark.parametrize(
    "name",
    [
        "",
        " ",
        "no-such-engine",
        "\x1b[31m",
        "\u202e",
        "[bold]x[/]",
        "../catalog/single",
        "a\0b",
        "\ud800",
        "n" * 10**6,
    ],
)
def test_a_name_that_is_no_engine_is_told_without_its_controls(name: str) -> None:
    with pytest.raises(EngineFileError) as caught:
        crankstar.load(name)
    check_sentences(caught.value)
    assert len(str(caught.value)) < 500


def test_standard_input_is_read_up_to_the_greatest_file_and_may_be_closed(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    for content, words in (
        (SHORT.encode(), ""),
        (b"", "is empty"),
        (b"x" * 1_000_001, "is larger than 1 MB"),
        (b"\xff", "UTF-8"),
    ):
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(content)))
        if words:
            assert words in str(refusal("-"))
        else:
            assert read_file("-").name == "V8, cross-plane, 90 deg"
    monkeypatch.setattr(sys, "stdin", None)
    assert "standard input: 1 mistake\n  standard input is closed" in str(refusal("-"))


@pytest.mark.parametrize("text", STARTLING)
@pytest.mark.parametrize("place", ["name", "source", "notes"])
def test_control_characters_in_a_text_are_refused_and_not_repeated(place: str, text: str) -> None:
    assert "contains the control character U+" in told(spoilt(SHORT, **{place: text}))[place]


@pytest.mark.many(first=9)
@pytest.mark.parametrize("text", [*STARTLING, "a\n  fake: message", "k" * 900_000])
def test_control_characters_in_keys_and_values_are_not_repeated(text: str) -> None:
    assert problems({text: 1, **spoilt(SHORT)})
    assert problems(spoilt(SHORT, cylinder__stroke=f"82 {text}"))
    assert problems(spoilt(SHORT, layout__type=text))
    assert problems(spoilt(SHORT, cycle=text))
    assert problems(spoilt(SHORT, provenance={text: {"status": "x"}}))
    assert problems(spoilt(EXPLICIT, cylinders__0__shaft=text))
    assert problems(spoilt(EXPLICIT, shaft__1__speed_ratio=text))


def test_half_a_character_is_refused() -> None:
    for place in ("name", "cylinder__stroke", "cycle"):
        assert problems(spoilt(SHORT, **{place: "\ud800"}))
    assert problems({"\ud800": 1, **spoilt(SHORT)})
    assert problems('{"name": "\\ud800"}')


@pytest.mark.parametrize(
    "name", ["a\nb", "a\tb", "n" * 201, "n" * 1_000_000, "", "  ", 8, 8.5, True, [], {}, None]
)
def test_a_name_that_does_not_fit_on_a_line_is_refused(name: object) -> None:
    assert list(told(spoilt(SHORT, name=name))) == ["name"]


def test_markup_in_a_name_is_only_text() -> None:
    name = "[bold]V8[/] [link=http://x]y[/link] <script>alert(1)</script> & :smile:"
    engine = engine_of(spoilt(SHORT, name=name))
    assert engine.name == name
    for html in (engine_html(engine), balance_html(crankstar.balance(engine))):
        assert "<script>" not in html
    assert "&lt;script&gt;" in engine_html(engine)
    assert "[bold]V8[/] [link=http://x]y[/link]" in engine_html(engine)


def test_several_mistakes_of_all_kinds_are_told_at_once() -> None:
    tree = spoilt(
        SHORT,
        cycle="5-stroke",
        cylinder__stroke="0 mm",
        cylinder__reciprocating_mass="5 mm",
        layout__bank_ofset="21 mm",
        firing_order=[1, 1, 4, 3, 6, 5, 7, 9],
    )
    assert [place for place, _ in problems(tree)] == [
        "cycle",
        "cylinder.stroke",
        "cylinder.reciprocating_mass",
        "layout.bank_ofset",
        "firing_order",
        "firing_order",
        "firing_order",
    ]


def test_a_wrong_table_does_not_hide_the_mistakes_of_another() -> None:
    tree = spoilt(
        SHORT,
        cylinders=[{"number": 11}],
        valves={"intake_opens": "900 deg", "manifolds": [[1, 2, 3, 4, 5, 6, 7], [9]]},
        block={"mass": "90 kg", "inertia_right": "3 kg*m^2"},
        firing_order=[1, 1, 4, 3, 6, 5, 7, 2],
    )
    assert [place for place, _ in problems(tree)] == [
        "cylinders[1].number",
        "firing_order",
        "firing_order",
        "valves.intake_opens",
        "valves.manifolds[2]",
        "valves.manifolds",
        "block.inertia_up",
        "block.inertia_z",
    ]


def test_a_misspelt_layout_does_not_hide_the_mistakes_in_it() -> None:
    tree = {
        "format": 1,
        "name": "three",
        "firing_order": [1, 3, 2],
        "cylinder": {"stroke": "80"},
        "layout": {"type": "in-line", "throws": ["0 deg", "120 deg", "90"], "bore_pich": "1 mm"},
    }
    assert {place for place, _ in problems(tree)} == {
        "layout.type",
        "layout.throws[3]",
        "layout.bore_pich",
        "cylinder.stroke",
    }


def test_a_wrong_unit_does_not_hide_a_wrong_index() -> None:
    tree = spoilt(
        EXPLICIT,
        cylce="two-stroke",
        shaft__1__speed_ratio=0,
        shaft__1__weight__0__angle=135,
        cylinders__0__rod_length="146",
        cylinders__1__number=1,
        cylinders__1__throw=5,
    )
    assert {place for place, _ in problems(tree)} == {
        "cylce",
        "shaft[2].speed_ratio",
        "shaft[2].weight[1].angle",
        "cylinders[1].rod_length",
        "cylinders[1].number",
        "cylinders[2].number",
        "cylinders[2].throw",
    }


def test_what_a_mistake_hides_is_not_made_up() -> None:
    assert list(told(spoilt(EXPLICIT, cylinders__1__number="two", firing_order=[1, 2]))) == [
        "cylinders[2].number"
    ]
    assert list(told(spoilt(EXPLICIT, cylinders__1__throw="two"))) == ["cylinders[2].throw"]
    assert list(told(spoilt(EXPLICIT, cylinders__1__shaft=2))) == ["cylinders[2].shaft"]
    assert list(
        told(spoilt(EXPLICIT, cylinders__0__rod_length="x", cylinders__1__rod_length="x"))
    ) == ["cylinders[1].rod_length", "cylinders[2].rod_length"]
    assert list(told(spoilt(SHORT, cylinder__stroke="82 kg"))) == ["cylinder.stroke"]


@pytest.mark.release
def test_a_file_of_a_hundred_mistakes_and_more_is_told_in_short() -> None:
    with pytest.raises(EngineFileError) as caught:
        engine_of({f"k{number}": 1 for number in range(5000)} | spoilt(SHORT))
    assert len(caught.value.faults) == 5000
    lines = str(caught.value).split("\n")
    assert sum(1 + len(line) // 80 for line in lines) <= 24
    assert lines[-1] == f"  ... and {5000 - len(lines) + 2} more (crankstar check lists all)"
    assert len(caught.value.listed().split("\n")) == 1002


@pytest.mark.parametrize(
    ("tree", "place"),
    [
        (
            {"name": "x", "firing_order": list(range(1, 100_001)), "layout": {"type": "inline"}},
            "firing_order",
        ),
        ({"name": "x", "layout": {"type": "inline", "throws": [0] * 100_000}}, "layout.throws"),
        (
            {
                "name": "x",
                "shaft": [{"name": "a", "throw": [{"angle": 0, "radius": 0.04}] * 100_000}],
                "cylinders": [],
            },
            "shaft[1].throw",
        ),
        ({"name": "x", "shaft": [{"name": "a"}], "cylinders": [{}] * 100_000}, "cylinders"),
        (
            {
                "name": "x",
                "layout": {"type": "inline"},
                "provenance": dict.fromkeys(map(str, range(100_000)), 1),
            },
            "provenance",
        ),
    ],
)
def test_a_hundred_thousand_of_anything_are_refused_where_they_are(
    tree: dict[str, Any], place: str
) -> None:
    ((path, message),) = problems(tree)
    assert path == place
    assert (
        message
        == "has 100000 entries, and the file more than 20000 values; no engine needs so many"
    )


@pytest.mark.release
def test_more_cylinders_throws_and_shafts_than_any_engine_has_are_refused() -> None:
    at_most = "; at most {} are allowed"
    crank, cylinder = spoilt(EXPLICIT)["shaft"][0], spoilt(EXPLICIT)["cylinders"][0]
    assert told(spoilt(EXPLICIT, cylinders=[cylinder] * 257))["cylinders"].endswith(
        at_most.format(256)
    )
    assert told(spoilt(EXPLICIT, shaft__0__throw=crank["throw"] * 129))["shaft[1].throw"].endswith(
        at_most.format(256)
    )
    assert told(spoilt(EXPLICIT, shaft=[crank] * 17))["shaft"].endswith(at_most.format(16))
    banks = [{"cylinders": list(range(1 + 256 * i, 257 + 256 * i))} for i in range(32)]
    assert told({"name": "x", "layout": {"type": "vee", "banks": banks, "throws": [0] * 256}})[
        "cylinders"
    ].endswith(at_most.format(256))


@pytest.mark.parametrize(
    "text",
    [
        "a = " + "[" * 10_000 + "]" * 10_000,
        '{"a": ' + "[" * 100_000 + "]" * 100_000 + "}",
        ".".join(["a"] * 5000) + " = 1",
        "[" + ".".join(["a"] * 2000) + "]\nx = 1",
        "[[shaft]]\nname = " + "[" * 200 + "]" * 200,
    ],
)
def test_deep_nesting_is_refused(text: str) -> None:
    ((_, message),) = problems(text)
    assert "is nested too deeply" in message


@pytest.mark.parametrize("text", ["a = " + "9" * 5000, '{"a": ' + "9" * 5000 + "}"])
def test_a_number_of_thousands_of_digits_is_refused(text: str) -> None:
    ((_, message),) = problems(text)
    assert "holds a number of thousands of digits; " in message


@pytest.mark.many(first=11)
@pytest.mark.parametrize(
    "odd", ODD, ids=repr if sys.version_info >= (3, 14) else lambda value: type(value).__name__
)
def test_values_of_odd_types_are_refused_everywhere(odd: object) -> None:
    tree = tomllib.loads(SHORT)
    for table, key in [
        (tree, "firing_order"),
        (tree, "cylinder"),
        (tree, "layout"),
        *((tree["cylinder"], key) for key in tree["cylinder"]),
    ]:
        kept, table[key] = table[key], odd
        if not (odd in ([], {}) and key in ("firing_order", "cylinder")):
            assert problems(tree) or key == "rotating_mass"
        table[key] = kept
    for place in (
        "shaft",
        "cylinders",
        "shaft__0",
        "shaft__0__throw",
        "shaft__0__throw__0",
        "cylinders__0",
        "cylinders__0__number",
    ):
        assert problems(spoilt(EXPLICIT, **{place: odd})), place
    assert problems(spoilt(EXPLICIT, cylinders__1__articulated=odd))
    assert problems(spoilt(EXPLICIT, cylinders__1__rod=odd))
    assert problems(spoilt(EXPLICIT, relative=odd)) or odd == []
    assert problems(spoilt(EXPLICIT, provenance=odd)) or odd == {}


@pytest.mark.parametrize("tree", [None, [], "x", 3, True])
def test_a_tree_that_is_no_table_is_refused(tree: Any) -> None:
    with pytest.raises(EngineFileError, match="a table of keys is needed"):
        engine_of(tree)


@pytest.mark.parametrize(
    ("kind", "message"),
    [
        ("veee", 'is "veee"; did you mean "vee"?'),
        ("Radial", 'is "Radial"; did you mean "radial"?'),
        ("V", 'is "V"; it can be inline, vee, boxer, tandem, opposed, radial'),
        (8, "is 8; it can be inline, vee, boxer, tandem, opposed, radial"),
        (["vee"], "is a list; it can be inline, vee, boxer, tandem, opposed, radial"),
    ],
)
def test_a_layout_that_is_not_there_is_refused(kind: object, message: str) -> None:
    assert told(spoilt(SHORT, layout__type=kind))["layout.type"] == message


@pytest.mark.parametrize(
    ("number", "shown"), [(2, "2"), ("1", '"1"'), (True, "true"), (1.5, "1.5")]
)
def test_another_format_is_refused(number: object, shown: str) -> None:
    assert told(spoilt(SHORT, format=number)) == {"format": f"is {shown}; it can be 1"}


def test_a_missing_layout_and_a_missing_type_are_told() -> None:
    assert told(SHORT.replace('type = "vee"', "")) == {
        "layout.type": "is missing; it can be inline, vee, boxer, tandem, opposed, radial"
    }
    assert "say how the cylinders are arranged" in told('name = "x"')["layout"]
    assert told("")["name"] == 'is missing; give it, as in name = "V8, cross-plane, 90 deg"'
    assert told(spoilt(SHORT, layout=[{}]))["layout"].startswith("is a list; a table is needed")


def test_a_mixture_of_both_forms_is_refused() -> None:
    assert codes(SHORT + '[[shaft]]\nname = "crank"\n')["shaft"] == "form.mixed"


def test_a_list_that_is_missing_or_too_short_is_told_with_an_example() -> None:
    tree = spoilt(SHORT)
    del tree["layout"]["throws"]
    assert told(tree) == {"layout.throws": 'is missing; give it, as in throws = ["90 deg"]'}
    assert told(spoilt(SHORT, layout__throws=["0 deg", "90 deg"])) == {
        "layout.throws": "has 2 angles; give 4 (one for each pin) or 8 (one for each cylinder)"
    }
    assert told(spoilt(SHORT, layout__throws=[])) == {
        "layout.throws": "has 0 entries; at least 1 is needed"
    }
    assert told(spoilt(SHORT, layout__banks=[])) == {
        "layout.banks": "has 0 entries; at least 1 is needed"
    }
    assert told(spoilt(SHORT, firing_order="1-8-4-3-6-5-7-2")) == {
        "firing_order": 'is "1-8-4-3-6-5-7-2"; a list is needed, such as [1, 3, 4, 2]'
    }
    assert told(spoilt(SHORT, cylinders={"number": 1})) == {
        "cylinders": "is a table; a list of tables is needed, each of them headed [[cylinders]]"
    }


def test_an_override_of_a_cylinder_that_is_not_there_or_twice_is_refused() -> None:
    (fault,) = faults(spoilt(SHORT, cylinders=[{"number": 9, "bore": "80 mm"}]))
    assert (fault.path, fault.code) == (("cylinders", 0, "number"), "override.no-such-cylinder")
    assert fault.values == {"value": 9, "numbers": [1, 2, 3, 4, 5, 6, 7, 8]}
    twice = codes(spoilt(SHORT, cylinders=[{"number": 1, "bore": "80 mm"}] * 2))
    assert twice["cylinders[2].number"] == "override.repeated"


def test_two_strokes_on_one_pin_are_refused() -> None:
    (fault,) = faults(spoilt(SHORT, cylinders=[{"number": 1, "stroke": "80 mm"}]))
    assert (fault.path, fault.code) == (("cylinders",), "layout.strokes-on-a-pin")
    assert fault.values["numbers"] == [1, 2]


def test_a_unit_where_lengths_are_only_ratios_is_refused() -> None:
    tree = spoilt(SHORT)
    del tree["cylinder"]["stroke"]
    assert codes(tree)["the file"] == "unit.several-radius"
    del tree["cylinder"]["bore"]
    assert codes(tree)["cylinder.rod_length"] == "unit.unknown-radius"
    relative = codes(spoilt(EXPLICIT, relative=["mass"]))
    assert relative["cylinders[1].reciprocating_mass"] == "unit.relative-mass"


@pytest.mark.parametrize(
    ("value", "good"), [(1e9, False), (1e-9, False), (-5, False), (3.5, True), ("3.5", True)]
)
def test_a_bare_ratio_out_of_all_proportion_is_refused(value: object, good: bool) -> None:
    tree = {
        "name": "x",
        "cylinder": {"rod_length": value},
        "layout": {"type": "inline", "throws": [0]},
    }
    assert (told(tree) == {}) == good


@pytest.mark.parametrize(
    "speed",
    ["0 rpm", "-5 rpm", 6000, "6000", "6000 mm", "1e400 rpm", "1e6 rpm", "1e-9 rpm", "fast", []],
)
def test_a_speed_that_is_none_is_refused(speed: object) -> None:
    assert 'such as "6000 rpm"' in told(spoilt(SHORT, speed=speed))["speed"]


def test_other_values_by_key_path_are_checked_like_the_file() -> None:
    tree = tree_of(SHORT)
    assert engine_of(
        tree, changes={"layout.bore_pitch": "100 mm", "name": "other"}
    ).pitch == pytest.approx(0.1)
    assert tree == tree_of(SHORT)
    for path, place in [
        ("a.b.c", "a"),
        ("layout.throws.0", "layout.throws.0"),
        ("cylinder.stroke.x", "cylinder.stroke.x"),
        ("", '""'),
        ("layout.throws[5]", "layout.throws[5]"),
        ("layout.throws[0]", "layout.throws[0]"),
        ("layout[1]", "layout[1]"),
        ("\x1b[31m", r'"\u001b[31m"'),
        ("x" * 1000, "x" * 57 + "..."),
    ]:
        with pytest.raises(EngineFileError) as caught:
            engine_of(tree, changes={path: 1})
        check_sentences(caught.value)
        assert where(caught.value.faults[0].path) == place


def test_null_in_json_is_a_key_left_out() -> None:
    tree = spoilt(SHORT, speed=None, cylinder__bore=None, cylinders=None)
    assert problems(json.dumps(tree)) == []
    dimensionless = {
        "name": "x",
        "cylinder": {"stroke": None, "rod_ratio": 4},
        "layout": {"type": "inline", "throws": [0]},
    }
    assert engine_of(tree_of(json.dumps(dimensionless))).relative == ("mass", "radius")
    assert list(told(json.dumps(spoilt(SHORT, name=None)))) == ["name"]
