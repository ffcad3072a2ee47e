"""The verbs orders and vees.

Tables, CSV, JSON, every row as an engine file, and requests that cannot be met.
"""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.commands import Run

import crankstar
from crankstar.files.catalog import load
from crankstar.firing.intervals import firing
from crankstar.firing.orders import even_orders
from crankstar.firing.vees import vees

Refused = Callable[..., str]


def test_orders_of_the_cross_plane_v8_are_listed_with_the_file_s_own_marked(run: Run) -> None:
    out = run("orders", "v8-cross-plane").out
    assert "8 orders, firing evenly every 90 deg." in out
    assert re.search(
        r"^ +2 +\* +1-8-4-3-6-5-7-2 +270-180-90-180 +90-180-270-180 +5-7 +4-3, 6-5, 2-1$",
        out,
        re.MULTILINE,
    )
    assert re.search(r"^ +3 +1-8-7-2-6-5-4-3 ", out, re.MULTILINE)


def test_a_shorter_table_has_the_file_s_own_order_all_the_same(run: Run) -> None:
    out = run("orders", "v8-flat-plane", "--top", "1").out
    assert "2 of 8 are shown" in out
    assert re.search(r"^ +2 +\* +1-8-5-4-7-2-3-6 +every 180 +every 180 ", out, re.MULTILINE)


def test_where_nothing_fires_evenly_it_is_told_why_and_the_most_even_are_offered(run: Run) -> None:
    out = run("orders", "harley-45").out
    assert "cylinder 2 is at top dead centre at 315, 675 deg." in out
    assert "The most even orders:" in out
    assert re.search(r"^ +1 +\* +1-2 +315-405 ", out, re.MULTILINE)
    assert "2 orders, none of them even." in out
    assert "No firing order meets these conditions" in run("orders", "kr250-racer-simultaneous").out


@pytest.mark.release
def test_orders_can_be_asked_for_by_their_intervals(run: Run) -> None:
    for words in (
        "315, 405",
        "315, 405 deg",
        "315 deg, 405 deg",
        "5.497787143782138 rad, 7.0685834705770345 rad",
    ):
        out = run("orders", "harley-45", "--intervals", words).out
        assert re.search(r"^ +1 +\* +1-2 +315-405 ", out, re.MULTILINE)
    assert run("orders", "i4", "--intervals", "180").out == run("orders", "i4").out
    assert (
        "1 order, none of them even"
        in run("orders", "kr250-racer-simultaneous", "--any", "--together").out
    )


def test_a_tolerance_lets_slave_rods_fire_evenly(run: Run) -> None:
    assert (
        "No firing order meets these conditions"
        in run("orders", "pratt-whitney-wasp", "--tolerance", "1 deg").out
    )
    assert re.search(
        r"^ +1 +\* +1-3-5-7-9-2-4-6-8 ",
        run("orders", "pratt-whitney-wasp", "--tolerance", "4").out,
        re.MULTILINE,
    )


@pytest.mark.release
def test_orders_within_a_tolerance_are_said_to_fire_evenly_within_it(run: Run) -> None:
    told = "4 orders with each firing within 0.2 deg of its place."
    assert told in run("orders", "vw-vr6", "--tolerance", "0.2").out
    assert told in run("orders", "vw-vr6", "--tolerance", "0.2", "--intervals", "120").out
    for name in ("radial-9", "pratt-whitney-wasp"):
        assert (
            "1 order with each firing within 4 deg of its place."
            in run("orders", name, "--tolerance", "4 deg").out
        )
    assert (
        "2 orders, firing evenly every 180 deg." in run("orders", "i4", "--tolerance", "1 deg").out
    )


def test_orders_at_given_intervals_are_said_to_have_them(run: Run) -> None:
    twin = run("orders", "i2-360", "--intervals", "0, 720").out
    assert re.search(r"^ +1 +1-2 +0-720 ", twin, re.MULTILINE)
    assert "1 order at these intervals." in twin
    common = run(
        "orders", "gm-3800", "--set", 'layout.pin_split="0 deg"', "--intervals", "90, 150"
    ).out
    assert re.search(r"^ +1 +\* +1-6-5-4-3-2 +150-90-150-90-150-90 ", common, re.MULTILINE)


def test_a_list_goes_to_a_file_of_text_or_one_without_an_ending(run: Run, tmp_path: Path) -> None:
    table = run("orders", "i4").out
    for name in ("orders.txt", "orders"):
        run("orders", "i4", "-o", name)
        assert (tmp_path / name).read_text(encoding="utf-8") == table


def test_of_a_two_stroke_engine_it_is_said_that_there_is_one_order(run: Run) -> None:
    out = run("orders", "man-s50mc-c").out
    assert re.search(r"^ +1 +\* +1-5-3-4-2-6 ", out, re.MULTILINE)
    assert "1 order, firing evenly every 60 deg." in out
    assert "so there is no other order; `crankstar search`" in " ".join(out.split())
    assert "no other order" not in run("orders", "audi-25-tfsi").out


def test_what_is_set_changes_the_orders(run: Run) -> None:
    out = run("orders", "v8-cross-plane", "--set", "firing_order=[1,8,7,2,6,5,4,3]").out
    assert re.search(r"^ +3 +\* +1-8-7-2-6-5-4-3 ", out, re.MULTILINE)


def test_orders_as_json_have_all_that_the_table_has(run: Run) -> None:
    tree = json.loads(run("orders", "v8-cross-plane", "--json", "--top", "1").out)
    assert list(tree) == ["format", "engine", "cycle_deg", "why_uneven", "row_of_file", "orders"]
    assert (tree["engine"], tree["cycle_deg"], tree["why_uneven"]) == (
        "V8, cross-plane crank, 90 deg",
        720.0,
        None,
    )
    assert [tuple(one["order"]) for one in tree["orders"]] == [
        one.firing.order for one in even_orders(load("v8-cross-plane"))
    ]
    assert tree["row_of_file"] == 2
    classic = tree["orders"][1]
    assert classic["angles_deg"] == [0, 90, 180, 270, 360, 450, 540, 630]
    assert classic["exhausts"]["odd"] == [270, 180, 90, 180]
    assert (classic["neighbours"], classic["partners"]) == ([[5, 7]], [[4, 3], [6, 5], [2, 1]])
    assert json.loads(run("orders", "v2-90", "--json").out)["why_uneven"].startswith(
        "Even firing needs"
    )


def test_a_list_without_orders_is_an_empty_list_for_machines(run: Run) -> None:
    asked = ("orders", "boxer-6", "--intervals", "90, 150")
    assert json.loads(run(*asked, "--json").out)["orders"] == []
    assert run(*asked, "--csv").out.splitlines()[0].startswith("row,order,angles_deg [deg]")
    assert "\n\n" not in run(*asked).out.rstrip()


def test_orders_as_csv_have_a_row_for_each(run: Run, tmp_path: Path) -> None:
    rows = list(csv.DictReader(io.StringIO(run("orders", "v8-cross-plane", "--csv").out)))
    assert len(rows) == 8
    assert rows[1] == {
        "row": "2",
        "order": "1-8-4-3-6-5-7-2",
        "angles_deg [deg]": "0 90 180 270 360 450 540 630",
        "intervals_deg [deg]": "90 90 90 90 90 90 90 90",
        "exhausts_odd [deg]": "270 180 90 180",
        "exhausts_even [deg]": "90 180 270 180",
        "neighbours": "5-7",
        "partners": "4-3 6-5 2-1",
    }
    run("orders", "v8-cross-plane", "-o", "orders.csv")
    run("orders", "v8-cross-plane", "-o", "orders.json")
    assert (
        list(csv.DictReader(io.StringIO((tmp_path / "orders.csv").read_text(encoding="utf-8"))))
        == rows
    )
    assert len(json.loads((tmp_path / "orders.json").read_text(encoding="utf-8"))["orders"]) == 8


@pytest.mark.release
@pytest.mark.parametrize("name", ["v8-cross-plane", "i6", "gm-3800", "boxer-6"])
def test_every_row_becomes_an_engine_file(run: Run, name: str) -> None:
    for row, one in enumerate(even_orders(load(name)), 1):
        text = run("orders", name, "--row", str(row)).out
        assert run("check", "-", stdin=text.encode()).out.startswith("standard input: good (")
        run("orders", name, "--row", str(row), "-o", "mine.toml")
        mine = crankstar.load("mine.toml")
        assert firing(mine).order == one.firing.order
        assert firing(mine).even


@pytest.mark.release
def test_a_row_of_uneven_orders_fires_as_the_table_says(run: Run) -> None:
    rows = csv.DictReader(io.StringIO(run("orders", "v4-90", "--csv").out))
    for row in list(rows)[3:]:
        run("orders", "v4-90", "--row", row["row"], "-o", "mine.toml")
        fired = firing(crankstar.load("mine.toml"))
        assert " ".join(f"{one:g}" for one in fired.intervals_deg) == row["intervals_deg [deg]"]


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["orders", "i4", "--row", "3"], "--row 3: give a number from 1 to 2"),
        (["orders", "kr250-racer-simultaneous", "--row", "1"], "--row 1: the list is empty"),
        (["orders", "i4", "--row", "1", "--csv"], "--csv has no effect with --row; leave it out"),
        (["orders", "i4", "--json", "--csv"], "--json and --csv exclude each other"),
        (["orders", "i4", "--top", "0"], "--top 0: give a number from 1 up"),
        (["orders", "i4", "--together"], "--together has no effect without --any; leave it out"),
        (
            ["orders", "i4", "--any", "--intervals", "180"],
            "--intervals has no effect with --any; leave it out",
        ),
        (
            ["orders", "i4", "--intervals", "90,90,90"],
            "--intervals 90,90,90: 3 intervals cannot be repeated to make 4",
        ),
        (
            ["orders", "i4", "--intervals", "90"],
            "the intervals 90, 90, 90, 90 deg do not make up a cycle",
        ),
        (["orders", "i4", "--intervals", "often"], "--intervals is "),
        (
            ["orders", "i4", "--intervals", ","],
            '--intervals ,: give angles with commas, as in "90, 150 deg"',
        ),
        (
            ["orders", "i4", "--tolerance", "100"],
            "the tolerance is 100 deg; give less than half of the smallest interval, 90 deg",
        ),
        (["orders", "i4", "--tolerance", "1 mm"], "--tolerance is "),
        (["vees", "7"], "a V engine of 7 cylinders cannot be searched"),
        (["vees", "8", "--bank", "270"], "a bank angle must be above 0 and at most 180 deg"),
        (["vees", "8", "--bank", "wide"], "--bank is "),
        (["vees", "8", "--star", "2"], "--star has no effect without --row; leave it out"),
        (["vees", "8", "--row", "1", "--star", "2"], "--star 2: give 1; there is only one"),
        (
            ["vees", "8", "-o", "x.svg"],
            "-o x.svg: the name must end in .txt, .csv, .json, .xlsx, .parquet",
        ),
        (["vees", "8", "--row", "1", "-o", "x.csv"], "-o x.csv: the name must end in .toml"),
        (
            ["orders", "i4", "-o", "x.html"],
            "-o x.html: the name must end in .txt, .csv, .json, .xlsx, .parquet",
        ),
        (
            ["orders", "i4", "-o", "x.toml"],
            "-o x.toml: the name must end in .txt, .csv, .json, .xlsx, .parquet",
        ),
        (
            ["orders", "i2-360", "--intervals", "0, 360"],
            "give intervals from 0 up, together 720 deg",
        ),
        (["vees", "8", "--row", "99"], "--row 99: give a number from 1 to 15"),
    ],
)
def test_what_cannot_be_met_is_refused_in_a_sentence(
    refused: Refused, words: list[str], told: str
) -> None:
    assert told in refused(*words)


def test_vees_of_six_cylinders_are_listed_best_first(run: Run) -> None:
    out = run("vees", "6", "--bank", "60 deg, 90 deg, 120 deg").out
    assert out.startswith("V6, four-stroke, firing every 120 deg\n")
    assert re.search(
        r"^ +1 +60 +60 +0, 120, 240 +1 +2 +0 +0 +0 +1\.5 +0 +1\.5 +1\.5 +0\.38718$",
        out,
        re.MULTILINE,
    )
    assert re.search(r"^ +2 +90 +30 ", out, re.MULTILINE)
    assert "8 cranks; 4 not counting mirror images and reversals, with 4 different balances." in out
    assert run("vees", "6", "--bank", "60, 90, 120").out == out


@pytest.mark.release
def test_who_asks_for_no_bank_angle_is_told_how_to_ask_for_split_pins(run: Run) -> None:
    told = 'others fire evenly with split pins: --bank "{}".'
    for cylinders, angles in (
        ("6", "60 deg, 90 deg"),
        ("8", "60 deg, 72 deg"),
        ("12", "90 deg, 72 deg"),
    ):
        assert told.format(angles) in " ".join(run("vees", cylinders).out.split())
        assert (
            "others fire evenly with split pins"
            not in run("vees", cylinders, "--bank", angles, "--top", "1").out
        )
    assert (
        "others fire evenly with split pins" not in run("vees", "6", "--greatest-split", "30").out
    )


def test_one_balance_is_not_called_balances(run: Run) -> None:
    assert (
        "2 cranks; 1 not counting mirror images and reversals, with 1 balance.\n"
        in run("vees", "6").out
    )
    assert "1 of 15 are shown; --top shows more" in run("vees", "8", "--top", "1").out


def test_stars_are_counted_as_they_are_chosen_from_and_cranks_with_their_mirror_images(
    run: Run,
) -> None:
    found = vees(cylinders=8)
    assert (len(found[0].stars), found[0].count) == (1, 2)
    assert re.search(r"^ +1 +90 +0 +0, 90, 270, 180 +1 +2 ", run("vees", "8").out, re.MULTILINE)
    first = json.loads(run("vees", "8", "--json").out)["solutions"][0]
    assert (first["stars"], first["cranks"]) == (1, 2)
    row = next(csv.DictReader(io.StringIO(run("vees", "8", "--csv").out)))
    assert (row["stars"], row["cranks"]) == ("1", "2")


def test_split_pins_can_be_limited(run: Run) -> None:
    out = run("vees", "6", "--bank", "60, 90, 120", "--greatest-split", "30 deg").out
    assert "2 different balances" in out
    assert (
        run("vees", "6", "--bank", "90", "--greatest-split", "0").out
        == "No V engine of this kind fires evenly.\n"
    )
    assert re.search(
        r"^ +\d +90 +30 ", run("vees", "6", "--greatest-split", "30").out, re.MULTILINE
    )


def test_two_stroke_vees_are_listed(run: Run) -> None:
    assert run("vees", "4", "--cycle", "two-stroke").out.startswith(
        "V4, two-stroke, firing every 90 deg\n"
    )


def test_vees_as_json_and_csv_have_every_crank(run: Run) -> None:
    found = vees(cylinders=8)
    tree = json.loads(run("vees", "8", "--json").out)
    assert [one["row"] for one in tree["solutions"]] == list(range(1, len(found) + 1))
    first = tree["solutions"][0]
    assert (first["bank_angle_deg"], first["pin_split_deg"], first["stars_deg"]) == (
        90.0,
        0.0,
        [[0.0, 90.0, 270.0, 180.0]],
    )
    assert first["couple"]["order_1"] == {"forward": pytest.approx(10**0.5), "backward": 0.0}
    assert first["counterweights_suffice"] is True
    rows = list(csv.DictReader(io.StringIO(run("vees", "8", "--csv").out)))
    assert len(rows) == len(found)
    assert rows[0]["stars_deg"] == "0-90-270-180"
    assert float(rows[0]["couple_order_1_forward [m*r*w^2*A_k*a]"]) == pytest.approx(10**0.5)


@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    "words", [["8"], ["6", "--bank", "90"], ["10", "--bank", "90"], ["4", "--cycle", "two-stroke"]]
)
def test_every_vee_becomes_an_engine_file(run: Run, words: list[str]) -> None:
    solutions = json.loads(run("vees", *words, "--json").out)["solutions"]
    for one in solutions[:6]:
        for star in range(len(one["stars_deg"])):
            run(
                "vees", *words, "--row", str(one["row"]), "--star", str(star + 1), "-o", "mine.toml"
            )
            mine = crankstar.load("mine.toml")
            assert firing(mine).even
            assert len(mine.cylinders) == int(words[0])
