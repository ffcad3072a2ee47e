"""The balancing shop on the command line: bobweight, drill, grade, with what they refuse."""

from __future__ import annotations

import json
import re
from itertools import pairwise
from math import pi
from pathlib import Path

import openpyxl
import pytest
from tests.commands import Run, csv_rows
from tests.files.test_parts import PARTS, tree

import crankstar
from crankstar.analyses.grade.grades import GRADES, grade_of, permissible, shares
from crankstar.engine.copies import with_values
from crankstar.engine.records import Weight
from crankstar.files import engine_of as load_tree
from crankstar.files import tree_text
from crankstar.files.catalog import load
from crankstar.mechanics.balance import balance, total
from crankstar.spectra import selected

HOLE = ("--diameter", "12.7 mm", "--at-radius", "80 mm")


@pytest.fixture
def v8(tmp_path: Path) -> str:
    """The file of a V8 with its parts."""
    place = tmp_path / "v8.toml"
    place.write_text(tree_text(tree()), encoding="utf-8")
    return str(place)


def refused(run: Run, *line: str) -> str:
    """What a command line that is refused says on standard error, on one line."""
    said = run(*line)
    assert (said.code, said.out) == (2, "")
    return " ".join(said.err.split())


def column(text: str, heading: str, *, word: str) -> list[float]:
    """The last numbers of the rows of a table that begin with a word, after its title."""
    body = text[text.index(heading) :].split("\n\n")[0]
    rows = [line.split() for line in body.splitlines()]
    return [float(row[-1]) for row in rows if row and re.fullmatch(word, row[0])]


def test_the_card_prints_what_a_balancer_adds_up(run: Run, v8: str) -> None:
    said = run("bobweight", v8).out
    body = said[said.index("Bobweight card") :].split("\n\n")[0]
    grams = {
        re.split(r"\s{2,}", line)[0]: float(line.split()[-1])
        for line in body.splitlines()
        if re.search(r"\d$", line)
    }
    up = ("piston", "piston pin", "locks", "rings", "rod, small end")
    turning = ("rod, big end", "bearing shells", "oil")
    assert [grams[name] for name in (*up, *turning)] == [
        float(PARTS[key].split()[0])
        for key in (
            *("piston", "pin", "locks", "rings", "small_end"),
            *("big_end", "bearing_shells", "oil"),
        )
    ]
    assert grams["reciprocating, total"] == sum(grams[name] for name in up) == 878
    assert grams["rotating, total"] == sum(grams[name] for name in turning) == 468
    assert column(said, "Bobweights", word=r"\d") == [2 * 468 + 0.5 * 2 * 878] * 4


def test_overbalance_and_underbalance_are_rows_of_the_card(run: Run, v8: str) -> None:
    said = run("bobweight", v8, "--factor", "50%").out
    assert column(said, "Overbalance and", word=r"-?\d") == pytest.approx(
        [936 + share * 1756 for share in (0.46, 0.48, 0.5, 0.52, 0.54)], abs=0.05
    )


@pytest.mark.release
def test_the_card_of_uneven_cylinders_has_a_column_for_each_kind(run: Run, tmp_path: Path) -> None:
    """Fork-and-blade: the blade's big end is lighter and carries no shells of its own."""
    of = tree()
    blade = {"big_end": "300 g", "bearing_shells": "10 g"}
    of["cylinders"] = [{"number": number, "parts": blade} for number in (2, 4, 6, 8)]
    place = tmp_path / "fork.toml"
    place.write_text(tree_text(of), encoding="utf-8")
    said = run("bobweight", str(place)).out
    heads = json.loads(run("bobweight", str(place), "--json").out)["parts"][0]
    assert {"mass_1_3_5_7", "mass_2_4_6_8"} <= heads.keys()
    expected = 468 + 312 + 0.5 * 2 * 878
    assert column(said, "Bobweights", word=r"\d") == [expected] * 4


def test_csv_and_json_of_the_card_agree(run: Run, v8: str) -> None:
    rows = csv_rows(run("bobweight", v8, "--csv").out, "bobweights")
    answer = json.loads(run("bobweight", v8, "--json").out)
    assert [float(row["bobweight [kg]"]) for row in rows] == pytest.approx([1.814] * 4)
    assert [row["bobweight"] for row in answer["bobweights"]] == pytest.approx([1.814] * 4)
    masses = {row["part"]: row["mass"] for row in answer["parts"]}
    assert masses["piston"] == pytest.approx(0.51)
    assert answer["factor"] == 0.5


def test_a_spreadsheet_of_the_card_has_every_table(run: Run, v8: str, tmp_path: Path) -> None:
    run("bobweight", v8, "-o", str(tmp_path / "card.xlsx"))
    book = openpyxl.load_workbook(tmp_path / "card.xlsx")
    assert {"parts", "bobweights", "overbalance"} <= set(book.sheetnames)
    cells = [row for row in book["bobweights"].iter_rows(values_only=True) if row[0] in (1, "1")]
    assert cells
    assert cells[0][-1] == pytest.approx(1814) or cells[0][-1] == pytest.approx(1.814)


def test_the_card_of_articulated_rods_says_where_they_count(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "radial.toml"
    place.write_text(run("new", "radial").out, encoding="utf-8")
    assert "Articulated rods count as" in " ".join(run("bobweight", str(place)).out.split())


def test_a_flat_crank_needs_no_bobweights_and_says_so(run: Run) -> None:
    rotating = ("--set", "cylinder.rotating_mass=1.2")
    assert "the machine shows the same with them and without" in " ".join(
        run("bobweight", "i4", *rotating).out.split()
    )
    assert "and without" not in run("bobweight", "v8-cross-plane", *rotating).out


@pytest.mark.release
def test_heavy_bobweights_have_the_prefix_that_fits(run: Run, tmp_path: Path) -> None:
    of = tree(parts={"piston": "5 t", "small_end": "2 t", "big_end": "4 t"}, stroke="2.5 m")
    of["cylinder"]["rod_length"] = "5 m"
    of["layout"]["bore_pitch"] = "1.5 m"
    place = tmp_path / "marine.toml"
    place.write_text(tree_text(of), encoding="utf-8")
    said = run("bobweight", str(place)).out
    assert column(said, "Bobweights", word=r"\d") == [15] * 4
    assert "[t]" in said
    assert "heaviest bobweight 15 t" in " ".join(run("verdict", str(place)).out.split())


def test_a_measured_unbalance_is_drilled_at_its_heavy_spot(run: Run) -> None:
    answer = json.loads(
        run("drill", "--unbalance", "1200 g*mm at 20 deg, 10 g at 350", *HOLE, "--json").out
    )
    first, second = answer["holes"]
    assert (first["at_deg"], first["count"]) == ([20.0], 1)
    area = pi / 4 * 12.7**2
    cone = 12.7 / 2 / 1.6642794823505174
    depth = first["depth_mm"]
    taken = 7.85e-3 * area * (depth * (80 - depth / 2) + cone / 3 * (80 - depth - cone / 4))
    assert taken == pytest.approx(1200, rel=1e-6)
    assert second["unbalance"] == pytest.approx(0.01 * 0.08)
    assert second["at_deg"] == [350.0]


def test_a_slug_is_fitted_opposite_the_heavy_spot(run: Run) -> None:
    answer = json.loads(
        run(
            *("drill", "--unbalance", "1200 g*mm at 20 deg", *HOLE, "--json"),
            *("--axial", "--greatest-depth", "22 mm", "--slug", "tungsten"),
        ).out
    )
    assert answer["holes"][0]["at_deg"] == [200.0]
    assert (answer["slug_kg_m3"], answer["tip_deg"]) == (17_000, 180)


def test_an_engine_with_lighter_pistons_is_drilled_until_nothing_is_left(
    run: Run, v8: str, tmp_path: Path
) -> None:
    cut = str(tmp_path / "cut.toml")
    run("balance", v8, "--weights", "ends", "-o", cut)
    assert "nothing is to be drilled" in run("drill", cut, *HOLE).out
    light = ("--set", 'cylinder.parts.piston="480 g"')
    answer = json.loads(run("drill", cut, *light, *HOLE, "--json").out)
    front, rear = answer["holes"]
    assert front["unbalance"] == pytest.approx(rear["unbalance"])
    assert (front["heavy_spot_deg"] - rear["heavy_spot_deg"]) % 360 == pytest.approx(180)
    engine = load(cut, changes={"cylinder.parts.piston": "480 g"})
    shaft = engine.shafts[0]
    removed = [
        Weight(
            unbalance=row["unbalance"],
            angle=(row["heavy_spot_deg"] + 180) * pi / 180,
            z=row["z"] / 1000,
        )
        for row in answer["holes"]
    ]
    whole = with_values(engine, shafts=(with_values(shaft, weights=(*shaft.weights, *removed)),))
    before, after = (
        abs(complex(selected(total(balance(each)).couple, 1.0).forward[0]))
        for each in (engine, whole)
    )
    assert after < 2e-3 * before  # directions are printed to a tenth of a degree


def test_permissible_unbalance_and_its_force_are_printed_by_grade(run: Run) -> None:
    said = run("grade", "--mass", "18 kg", "--speed", "6500 rpm", "--grade", "G6.3").out
    row = next(line.split() for line in said.splitlines() if line.strip().startswith("6.3"))
    omega = 6500 * pi / 30
    whole = 6.3 * 18e3 / omega
    assert [float(cell) for cell in row[1:4]] == pytest.approx([whole, whole / 2, whole / 2], 1e-4)
    assert float(row[4]) == pytest.approx(whole * 1e-6 * omega**2, 1e-4)


def test_the_bearings_share_the_unbalance_by_their_levers(run: Run) -> None:
    answer = json.loads(
        run(
            *("grade", "--mass", "18 kg", "--speed", "6500 rpm", "--grade", "6.3", "--json"),
            *("--bearing-distances", "200 mm, 300 mm"),
        ).out
    )
    (row,) = answer["permissible"]
    front, rear = row["unbalance"]["front"], row["unbalance"]["rear"]
    assert front * 200 == pytest.approx(rear * 300)
    assert front + rear == pytest.approx(row["unbalance"]["whole"])


@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    ("measured", "met"), [("60 g*mm, 60 g*mm", "6.3"), ("180 g*mm", "16"), ("0.1 oz*in", "6.3")]
)
def test_a_measured_residual_meets_a_grade(run: Run, measured: str, met: str) -> None:
    args = ("grade", "--mass", "18 kg", "--speed", "6500 rpm", "--unbalance", measured)
    assert f"it meets G {met}." in " ".join(run(*args).out.split())


def test_the_published_examples_of_grades() -> None:
    """WIDIA catalogue, page K53: 2 kg, 10000 rpm, G 6.3: 12 g mm, 6 g mm/kg. CEMB Hofmann UK,
    31 July 2013: 6 kg, 5000 rpm, 180 g mm: 30 micrometres, just within G 16."""
    assert permissible(6.3, mass=2, speed=10_000 * pi / 30) * 1e6 == pytest.approx(12, abs=0.05)
    assert grade_of(180e-6, mass=6, speed=5000 * pi / 30) == pytest.approx(15.7, abs=0.05)


def test_the_published_force_of_an_unbalanced_crankshaft() -> None:
    """Galloway Engines, Crankshaft balancing: 293 g at 3 in are 55.14 lbf at 1000 rpm, 1985.13 lbf
    at 6000 rpm."""
    force = 0.29341 * 0.0762 * (1000 * pi / 30) ** 2 / 4.4482216
    assert force == pytest.approx(55.14, rel=1e-3)
    assert 36 * force == pytest.approx(1985.13, rel=1e-3)


def test_shares_are_lever_rule_within_three_to_seven_tenths() -> None:
    assert shares(front=1, rear=1) == (0.5, 0.5)
    assert shares(front=0.05, rear=1) == (0.7, 0.3)
    assert all(b / a == pytest.approx(2.5, rel=0.03) for a, b in pairwise(GRADES))


@pytest.mark.release
@pytest.mark.parametrize(
    ("typed", "grams_mm"),
    [("38 g at 4 in", 3860.8), ("38 g @ 4in", 3860.8), ("1.3 oz at 10 cm", 3685.4)],
)
def test_a_mass_at_a_radius_is_an_unbalance_wherever_one_is_read(
    run: Run, typed: str, grams_mm: float
) -> None:
    for spot in (typed, f"{typed} at 20 deg"):
        (hole,) = json.loads(run("drill", "--unbalance", spot, *HOLE, "--json").out)["holes"]
        assert hole["unbalance"] * 1e6 == pytest.approx(grams_mm, rel=1e-4)
        assert hole["heavy_spot_deg"] == (20 if "deg" in spot else None)
    line = ("grade", "--mass", "18 kg", "--speed", "6500 rpm", "--json", "--unbalance", typed)
    (row,) = json.loads(run(*line).out)["measured"]
    assert row["unbalance"] * 1e6 == pytest.approx(grams_mm, rel=1e-4)
    weight = {"z": "10 mm", "angle": "0 deg", "unbalance": typed}
    of = {**tree(), "crankshaft": [{"weight": [weight]}]}
    engine = load_tree(of)
    assert engine.shafts[0].weights[-1].unbalance * 1e6 == pytest.approx(grams_mm, rel=1e-4)


def test_a_plane_without_unbalance_has_no_hole(run: Run) -> None:
    said = run("drill", "--unbalance", "0", *HOLE).out
    assert "nothing is to be drilled" in said
    answer = json.loads(run("drill", "--unbalance", "0 g*mm, 300 g*mm at 5", *HOLE, "--json").out)
    assert [(row["count"], row["at_deg"], row["mass_g"] > 0) for row in answer["holes"]] == [
        (0, None, False),
        (1, [5.0], True),
    ]


def test_csv_of_a_measured_unbalance_is_its_result(run: Run) -> None:
    args = ("grade", "--mass", "18 kg", "--speed", "6500 rpm", "--unbalance", "60 g*mm, 30 g*mm")
    rows = csv_rows(run(*args, "--csv").out, "measured")
    answer = json.loads(run(*args, "--json").out)
    assert [row["plane"] for row in rows] == ["front bearing", "rear bearing"]
    assert [float(row["unbalance [kg*m]"]) for row in rows] == pytest.approx([60e-6, 30e-6])
    assert float(rows[0]["grade_mm_s [mm/s]"]) == pytest.approx(answer["grade_measured"])
    allowed = permissible(6.3, mass=18, speed=6500 * pi / 30) / 2
    assert [float(row["permissible [kg*m]"]) for row in rows] == pytest.approx([allowed] * 2)


@pytest.mark.release
def test_a_card_in_american_units_is_in_grams(run: Run, v8: str) -> None:
    said = run("bobweight", v8, "--units", "us").out
    assert column(said, "Bobweights", word=r"\d") == [1814] * 4
    assert "lb/in³" in run("drill", "--unbalance", "1 oz*in", *HOLE, "--units", "us").out


@pytest.mark.parametrize("verb", ["bobweight", "drill", "balance"])
def test_a_factor_in_percent_without_its_sign_says_how_it_is_written(
    run: Run, v8: str, verb: str
) -> None:
    hole = HOLE if verb == "drill" else ()
    said = refused(run, verb, v8, "--factor", "52", *hole)
    assert said.endswith("for 52 % write 52% or 0.52")


@pytest.mark.many(first=25)
@pytest.mark.parametrize(
    ("line", "words"),
    [
        (("drill", "--unbalance", "38 at 4 in", *HOLE), "without a unit"),
        (("drill", "--unbalance", "38 g at 4 furlongs", *HOLE), "a length is needed"),
        (("drill", "--unbalance", "8 g at 4 in at 4 in", *HOLE), "an angle is needed"),
        (("drill", "--unbalance", "8 g at -4 in", *HOLE), "not a number"),
        (("grade", "--mass", "1 kg", "--speed", "9 rpm", "--unbalance", "2 g"), "add the radius"),
        (("drill", "--unbalance", "5 g*mm", *HOLE, "--greatest-depth", "1e-9 mm"), "too small"),
        (("drill",), "name an engine file"),
        (("drill", "--unbalance", "100 g*mm"), "give --diameter, --at-radius"),
        (("drill", "--unbalance", "100 g*mm", *HOLE, "--axial"), "give --greatest-depth"),
        (("drill", "--unbalance", "100 mm", *HOLE), "a length; an unbalance is needed"),
        (("drill", "--unbalance", "100", *HOLE), "write it with a unit"),
        (("drill", "--unbalance", "-5 g*mm", *HOLE), "without a sign"),
        (("drill", "--unbalance", "5 g*mm", "--diameter", "0 mm", *HOLE[2:]), "greater than 0"),
        (("drill", "--unbalance", "5 g*mm", *HOLE, "--greatest-depth", "90 mm"), "crank axis"),
        (("drill", "--unbalance", "1 kg*m", *HOLE), "more than holes of 12.7 mm"),
        (("drill", "--unbalance", "1e-300 g*mm", *HOLE), "too small for an engine"),
        (("drill", "--unbalance", "1e-300 g", *HOLE), "too small for an engine"),
        (("drill", "--unbalance", "5 g*mm", *HOLE, "--density", "1e-9 g/cm^3"), "too small"),
        (("drill", "--unbalance", "5 g*mm", *HOLE, "--slug", "7 g/cm^3"), "no heavier"),
        (("drill", "--unbalance", "999 g*mm", *HOLE, "--slug", "7.9 g/cm^3"), "0.637 % denser"),
        (("drill", "--unbalance", "5 g*mm", *HOLE, "--slug", "lead"), "or tungsten"),
        (("drill", "--unbalance", "5 g*mm", *HOLE, "--density", "7.85"), "with a unit"),
        (("drill", "--unbalance", "5 g*mm", *HOLE, "--tip", "5 deg"), "from 30 to 180 deg"),
        (("drill", "--unbalance", "5 g*mm", *HOLE, "--factor", "0.5"), "no effect"),
        (("drill", "i4", *HOLE), "in grams and millimetres"),
        (("grade",), "give the mass of the rotor"),
        (("grade", "--mass", "18 kg"), "give the greatest service speed"),
        (("grade", "--mass", "18 mm", "--speed", "1 rpm"), "a mass is needed"),
        (("grade", "--mass", "18 kg", "--speed", "9 rpm", "--grade", "fine"), "such as 6.3"),
        (("grade", "--mass", "1 kg", "--speed", "9 rpm", "--bearing-distances", "1 m"), "two"),
        (("bobweight", "i4", "--factor", "7"), "from -1 to 3"),
    ],
)
def test_each_mistake_is_one_clear_sentence(
    line: tuple[str, ...], words: str, run: Run, tmp_path: Path
) -> None:
    place = tmp_path / "out.csv"
    assert words in refused(run, *line, "-o", str(place))
    assert not place.exists()


def test_planes_beyond_the_crankshaft_are_refused(run: Run, v8: str) -> None:
    assert "beyond the crankshaft" in refused(run, "drill", v8, "--weights", "2 m, -2 m", *HOLE)


def test_a_place_that_ends_like_a_directory_is_none_for_a_file(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "cards"
    assert "it is a directory" in refused(run, "bobweight", "i4", "-o", f"{place}/")
    assert not place.exists()


def test_crank_angles_that_are_none_are_refused(run: Run) -> None:
    for line in (("analyze", "i4"), ("export", "i4", "-o", "i4.stl")):
        assert "give crank angles, such as" in refused(run, *line, "--theta", ",")


@pytest.mark.release
def test_an_unbalance_without_a_direction_is_corrected_at_the_heavy_spot(run: Run) -> None:
    hole = ("drill", "--diameter", "10 mm", "--at-radius", "70 mm", "--unbalance")
    words = "at the heavy spot that the machine shows"
    assert words in " ".join(run(*hole, "1.2 oz*in").out.split())
    assert words not in " ".join(run(*hole, "1.2 oz*in at 30 deg").out.split())


def test_a_speed_in_json_is_the_one_that_was_typed(run: Run) -> None:
    out = run("grade", "--mass", "18 kg", "--speed", "5500 rpm", "--json").out
    assert json.loads(out)["speed_rpm"] == 5500


def test_a_mass_without_a_radius_beside_one_with_a_radius_is_refused(run: Run) -> None:
    drill = ("drill", "--diameter", "12 mm", "--at-radius", "80 mm", "--unbalance")
    refused = run(*drill, "38 g at 4 in at 20 deg, 38 g at 200 deg")
    assert refused.code == 2
    assert "38 g at 200 deg" in refused.err
    both = run(*drill, "38 g at 4 in at 20 deg, 38 g at 4 in at 200 deg", "--json")
    assert both.code == 0


def test_the_radius_of_a_mass_alone_is_printed(run: Run) -> None:
    drill = ("drill", "--diameter", "12 mm", "--at-radius", "80 mm", "--unbalance")
    assert "counts at 80 mm" in run(*drill, "10 g at 200 deg").out
    assert "counts at 80 mm" not in run(*drill, "850 g*mm at 200 deg").out


def test_a_grade_says_in_which_planes_two_unbalances_are(run: Run) -> None:
    rotor = ("grade", "--mass", "20 kg", "--speed", "6000 rpm", "--unbalance")
    two, one = run(*rotor, "60 g*mm, 90 g*mm").out, run(*rotor, "150 g*mm").out
    assert "planes of the bearings" in two
    assert "planes of the bearings" not in one
    facts = [json.loads(run(*rotor, text, "--json").out) for text in ("60 g*mm, 90 g*mm", "1 g*mm")]
    assert [each["planes"] for each in facts] == ["bearings", "whole"]


def test_a_half_that_nobody_gave_is_in_the_record(run: Run, v8: str) -> None:
    """Of the card and of the holes; not where it is asked for, or in the file."""
    wide = ("--diameter", "60 mm", "--at-radius", "150 mm", "--greatest-depth", "100 mm")
    for words in (["bobweight", v8], ["drill", v8, *wide]):
        told = json.loads(run(*words, "--json").out)
        assert "balance_factor" in [each["path"] for each in told["rests_on"]]
        assert "balance_factor (half of what reciprocates" in " ".join(run(*words).out.split())
        for given in (["--factor", "0.5"], ["--set", "balance_factor=0.5"]):
            told = json.loads(run(*words, *given, "--json").out)
            assert "balance_factor" not in [each["path"] for each in told.get("rests_on", ())]


@pytest.mark.parametrize(
    "line",
    [
        ("bobweight", "--json"),
        ("drill", "--diameter", "20 mm", "--at-radius", "60 mm"),
        ("balance", "--weights", "ends"),
    ],
)
def test_a_balance_factor_of_standard_input_counts(
    run: Run, tmp_path: Path, line: tuple[str, ...]
) -> None:
    """As that of the file does; without it the answer is another."""
    text = tree_text({**tree(), "balance_factor": 0.62})
    (tmp_path / "own.toml").write_text(text, encoding="utf-8")
    verb, *options = line
    read = run(verb, "own.toml", *options).out
    assert run(verb, "-", *options, stdin=text.encode()).out == read
    assert run(verb, "own.toml", "--set", "balance_factor=0.5", *options).out != read


def test_the_card_is_a_function_of_python() -> None:
    found = crankstar.bobweight({**tree(), "balance_factor": 0.62})
    assert (found.value.factor, found.value.assumed) == (0.62, False)
    shares = [row["factor_percent"] for row in found.to_frame("overbalance").to_dict("records")]
    assert shares == [58, 60, 62, 64, 66]
    half = crankstar.bobweight(tree())
    assert "balance_factor" in [each.path for each in half.rests_on]


def test_the_card_of_python_has_the_ranges_of_estimates() -> None:
    rows = crankstar.bobweight("audi-25-tfsi", estimate=True).to_frame("bobweights")
    for row in rows.to_dict("records"):
        assert row["bobweight_low_kg"] < row["bobweight_kg"] < row["bobweight_high_kg"]
