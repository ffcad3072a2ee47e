"""The verb marine: its tables and what it says, JSON, CSV, Excel; questions that cannot be."""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import openpyxl
import pytest
from tests.commands import Run
from tests.marine import marine_engine

import crankstar
from crankstar import load
from crankstar.analyses.marine.marine_analysis import marine
from crankstar.files import toml
from crankstar.mechanics.external_moments import external_moments


def written(folder: Path, **changes: Any) -> str:
    """An engine file of the seven."""
    path = folder / "seven.toml"
    path.write_text(toml(marine_engine(**changes)))
    return str(path)


def test_machines_get_what_python_computes(run: Run, tmp_path: Path) -> None:
    asked = ("--compensate", "2: 4.5 m", "--node", "-28 m", "--bracing", "5 m, 6 m")
    out = json.loads(run("marine", written(tmp_path), *asked, "--json").out)
    found = marine(marine_engine(), compensate={2: (4.5,)}, node=-28.0)
    assert out["format"] == 1
    assert (out["node"], out["bracing"]) == (-28, [5, 6])
    assert found.power is not None
    assert out["power_kw"] == pytest.approx(found.power / 1e3)
    by_order = {row["order"]: row for row in out["moments"]}
    for order in (1, 2, 4):
        assert by_order[order]["vertical"]["amplitude"] == pytest.approx(found.after.moment(order))
        assert by_order[order]["vertical_before"] == pytest.approx(found.before.moment(order))
    assert by_order[2]["at_node"]["amplitude"] == 0
    [one] = out["compensators"]
    assert one["unbalance"] == pytest.approx(found.compensators[0].unbalance)
    assert one["z"] == 4500
    guide = {row["order"]: row for row in out["guide"]}
    assert found.guide is not None
    place = found.guide.orders.tolist().index(7)
    assert guide[7]["h"]["amplitude"] == pytest.approx(abs(found.guide.h[place]))
    assert guide[7]["bracing_h"] == pytest.approx(abs(found.guide.h[place]) / 5)
    assert guide[4]["bracing_x"] == pytest.approx(abs(found.guide.bimoment[3]) / 30)


@pytest.mark.release
def test_readers_are_told_what_is_counted_and_left_out(run: Run, tmp_path: Path) -> None:
    out = " ".join(run("marine", written(tmp_path), "--first-order", "equal").out.split())
    for said in (
        "External moments at 104 rpm",
        "they are the same about any point",
        "make 50 % of the first-order moment horizontal",
        "X is the bimoment over the rod length, 2.46 m",
        "Axial vibration, and what the propeller does, are left out.",
    ):
        assert said in out
    out = " ".join(run("marine", "man-s90mc-c").out.split())
    assert "Guide-force moments are those of gas alone" in out
    assert "give layout.bore_pitch" in out
    assert "in units of the first cylinder" in out
    out = " ".join(run("marine", "i4").out.split())
    assert "Without guide-force moments: the engine file has no table [gas]." in out
    assert "forces of orders 2, 4 remain, so that the moments of these orders differ" in out
    out = " ".join(run("marine", "man-s50mc-c").out.split())
    assert "a force of order 6 remains, so that the moment of this order differs" in out
    assert "X is the bimoment" not in out


def test_without_a_speed_the_greatest_of_those_asked_for_counts(run: Run, tmp_path: Path) -> None:
    place = written(tmp_path, speed=None, gas=None)
    out = json.loads(run("marine", place, "--speeds", "52 rpm, 104 rpm", "--json").out)
    assert out["speed_rpm"] == pytest.approx(104)
    assert out["speeds"][1]["m2v"] == pytest.approx(out["moments"][1]["vertical"]["amplitude"])


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("i4", "--speeds", "52 rpm, 104 rpm"), "--speeds has no effect. The file lacks"),
        (
            ("i4", "--rated-power", "9 kW", "--speeds", "1 rpm, 2 rpm"),
            "--speeds, --rated-power hav",
        ),
        (("i4", "--bracing", "5 m, 8 m"), "--bracing has no effect. Without guide-force moments:"),
    ],
)
def test_an_option_without_effect_is_refused_and_why(
    run: Run, words: tuple[str, ...], said: str
) -> None:
    ran = run("marine", *words)
    assert ran.code == 2
    assert said in " ".join(ran.err.split())


def test_rounding_is_no_force(run: Run) -> None:
    out = json.loads(run("marine", "v8-cross-plane", "--json").out)
    assert out["moments"][-1]["force_horizontal"] == 0
    assert out["moments"][-1]["force_vertical"] > 0


@pytest.mark.release
def test_without_masses_compensators_are_counted_in_those_of_the_engine(run: Run) -> None:
    asked = ("--compensate", "2: 4.5", "--node", "-20")
    out = json.loads(run("marine", "man-s90mc-c", *asked, "--json").out)
    [one] = out["compensators"]
    second = next(row for row in out["moments"] if row["order"] == 2)
    assert one["z"] == 4.5
    assert one["force"]["amplitude"] == pytest.approx(second["vertical_before"] / 24.5)
    assert 2 * one["unbalance"] * 2**2 == pytest.approx(one["force"]["amplitude"])


@pytest.mark.release
def test_the_engine_that_is_saved_has_the_moments_that_were_shown(run: Run, tmp_path: Path) -> None:
    saved = str(tmp_path / "quiet.toml")
    asked = ("--compensate", "2: 4.5 m, -4.5 m", "--first-order", "0.3", "--save", saved)
    shown = json.loads(run("marine", written(tmp_path), *asked, "--json").out)
    again = json.loads(run("marine", saved, "--json").out)
    assert "compensators of order 2" in crankstar.load(saved).name
    one, other = ({row["order"]: row for row in each["moments"]} for each in (shown, again))
    for order in (1, 2, 4):
        for side in ("vertical", "horizontal"):
            wanted = one[order][side]["amplitude"]
            assert other[order][side]["amplitude"] == pytest.approx(wanted, abs=0.01)


def test_the_csv_has_a_row_for_each_order(run: Run, tmp_path: Path) -> None:
    out = run("marine", written(tmp_path), "--csv").out
    rows = list(csv.DictReader(io.StringIO(out)))
    moments = [row for row in rows if row["table"] == "moments"]
    assert [float(row["order"]) for row in moments] == [1, 2, 4, 6]


@pytest.mark.release
def test_the_csv_has_every_table_that_is_printed(run: Run, tmp_path: Path) -> None:
    asked = ("--speeds", "60 rpm, 90 rpm", "--bracing", "5 m, 8 m", "--compensate", "2: 4 m")
    place = written(tmp_path)
    told = json.loads(run("marine", place, *asked, "--json").out)
    rows = list(csv.DictReader(io.StringIO(run("marine", place, *asked, "--csv").out)))
    lines = {
        name: [row for row in rows if row["table"] == name]
        for name in ("moments", "compensators", "guide", "speeds")
    }
    assert {name: len(told[name]) for name in lines} == {
        name: len(each) for name, each in lines.items()
    }
    assert float(lines["speeds"][1]["m2v [N*m]"]) == told["speeds"][1]["m2v"]
    assert float(lines["guide"][6]["bracing_h [N]"]) == told["guide"][6]["bracing_h"]
    weight = lines["compensators"][0]
    assert float(weight["unbalance [kg*m]"]) == told["compensators"][0]["unbalance"]
    assert weight["unbalance [N*m/kW]"] == ""


def told(run: Run, *asked: str) -> tuple[list[float], list[float]]:
    """The orders of external moments and of guide-force moments that readers get."""
    out = run("marine", *asked).out
    parts = re.split(
        r"^(External moments|Guide-force moments)(?: at .*)?$", out, flags=re.MULTILINE
    )
    found = dict(zip(parts[1::2], parts[2::2], strict=True))
    return tuple(  # pyright: ignore[reportReturnType]
        list(
            dict.fromkeys(
                float(row[1])
                for row in re.finditer(r"^ +(\d+(?:\.5)?)  +\S", found.get(name, ""), re.MULTILINE)
            )
        )
        for name in ("External moments", "Guide-force moments")
    )


@pytest.mark.release
def test_orders_choose_the_rows_of_both_tables(run: Run, tmp_path: Path) -> None:
    place = written(tmp_path)
    assert told(run, place, "--orders", "8,12,13") == ([8, 12, 13], [8, 12, 13])
    out = json.loads(run("marine", place, "--orders", "13,8", "--json").out)
    assert [row["order"] for row in out["guide"]] == [8, 13]
    found = marine(marine_engine()).guide
    assert found is not None
    eighth = found.orders.tolist().index(8)
    assert out["guide"][0]["x"]["amplitude"] == pytest.approx(abs(found.x[eighth]))
    assert told(run, place, "--orders", "10") == ([10], [10])


@pytest.mark.release
def test_all_orders_are_all_that_do_not_vanish(run: Run, tmp_path: Path) -> None:
    external, guide = told(run, written(tmp_path), "--orders", "all")
    assert guide == [float(order) for order in range(1, 25)]
    assert {1, 2, 4, 6, 8} <= {*external}
    usual = told(run, written(tmp_path))
    assert 8 not in usual[0]
    assert 8 not in usual[1]


@pytest.mark.release
def test_a_row_that_says_nothing_is_left_out(run: Run) -> None:
    assert told(run, "man-s90mc-c")[1][0] == 7
    assert told(run, "man-s90mc-c", "--orders", "all")[0] == [1, 2, 4, 6, 8, 10, 12, 16, 18]
    assert all(order % 7 == 0 for order in told(run, "man-s90mc-c", "--orders", "all")[1])


@pytest.mark.release
def test_from_which_share_orders_are_told_is_said(run: Run, tmp_path: Path) -> None:
    place, said = written(tmp_path), "those of guide-force moments from 1 % of the greatest"
    assert said in " ".join(run("marine", place).out.split())
    assert said not in " ".join(run("marine", place, "--orders", "all").out.split())
    alone = " ".join(run("marine", "i4").out.split())
    assert "Orders of external moments are told from 0.1 % of the greatest" in alone
    assert "those of guide-force" not in alone


@pytest.mark.release
@pytest.mark.parametrize("verb", ["marine", "guide"])
def test_the_unbalance_is_in_the_units_that_are_chosen(run: Run, tmp_path: Path, verb: str) -> None:
    asked = (verb, written(tmp_path), *(() if verb == "marine" else ("--numbers", "7")))
    key = "moments" if verb == "marine" else "members"
    plain = json.loads(run(*asked, "--json").out)[key][-1]
    assert json.loads(run("--units", "us", *asked, "--json").out)[key][-1] == plain
    rows = csv.DictReader(io.StringIO(run("--units", "us", *asked, "--csv").out))
    told = [row for row in rows if any(row[name] for name in row if name.startswith("unbalance"))]
    chosen = told[-1]
    horsepower = 550 * 12 * 0.0254 * 0.45359237 * 9.80665
    feet = 12 * 0.0254 * 0.45359237 * 9.80665
    own = next(float(chosen[name]) for name in chosen if name.startswith("unbalance"))
    assert plain["unbalance"] * 1e-3 * horsepower / feet == pytest.approx(own)
    assert plain["compensator"] == chosen["compensator"]
    assert "[N m/kW]" in run("--units", "kN m", *asked).out
    out = run("--units", "us", *asked).out
    assert "[lbf ft/hp]" in out
    assert "kW" not in out
    assert "[N m/kW]" in run(*asked).out


@pytest.mark.release
def test_a_workbook_has_a_sheet_for_each_table(run: Run, tmp_path: Path) -> None:
    book = tmp_path / "seven.xlsx"
    run("marine", written(tmp_path), "--speeds", "60..110 rpm by 10", "-o", str(book))
    assert {"moments", "guide", "speeds"} <= {*openpyxl.load_workbook(book).sheetnames}


def test_moments_over_speeds_go_with_their_square(run: Run, tmp_path: Path) -> None:
    place = written(tmp_path)
    out = json.loads(run("marine", place, "--speeds", "52 rpm, 104 rpm", "--json").out)
    slow, fast = out["speeds"]
    for name in ("m1v", "m2v", "m4v"):
        assert fast[name] == pytest.approx(4 * slow[name])
    assert fast["m1h"] == 0


@pytest.mark.release
def test_an_estimated_engine_has_ranges(run: Run) -> None:
    out = json.loads(run("marine", "audi-25-tfsi", "--estimate", "--json").out)
    first = out["moments"][0]
    assert first["vertical_low"] < first["vertical"]["amplitude"] < first["vertical_high"]
    plain = " ".join(run("marine", "audi-25-tfsi", "--estimate").out.split())
    assert "What rests on them is marked" in plain


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--first-order", "most"), "give vertical, equal, horizontal"),
        (("--first-order", "1.5"), "give vertical, equal, horizontal"),
        (("--compensate", "2 6 m"), "give the order, a colon"),
        (("--compensate", "1"), "--compensate 1: give the order, a colon"),
        (("--compensate", "2:"), "--compensate 2:: give the order, a colon"),
        (("--compensate", "9: 6 m"), "compensators are made for orders 1 to 8"),
        (("--compensate", "2: 6 kg"), 'a length is needed, such as "105.5 mm", as in "2: 6 m, -6'),
        (("--compensate", "2: 4 m", "--save", "x.txt"), "--save x.txt: the name must end in .toml"),
        (("--compensate", "2: 4 m", "--save", "no/x.toml"), "Name another file with --save"),
        (("--compensate", "2: 6"), "write it with a unit"),
        (("--compensate", "2: 1 m, 2 m, 3 m"), "give one place or two that differ"),
        (("--compensate", "2: 1 m, 1 m"), "give one place or two that differ"),
        (("--compensate", "2: 0 m"), "no arm"),
        (("--compensate", "2: 4 m", "--compensate", "2: 5 m"), "give each order once"),
        (("--compensate", "3: 1 m, -1 m"), "no vertical moment of order 3"),
        (("--compensate", "0: 6 m, -6 m"), "orders 1 to "),
        (("--phase-error", "3 deg"), "--phase-error"),
        (("--compensate", "2: 4 m, -4 m", "--phase-error", "400 deg"), "up to 180 deg"),
        (("--node", "25"), "write it with a unit"),
        (("--bracing", "5 m"), "give the height over the crankshaft and the distance"),
        (("--bracing", "5 m, 0 m"), "greater than 0"),
        (("--rated-power", "12 kg"), "a power is needed"),
        (("--rated-power", "0 kW"), "greater than 0"),
        (("--rated-power", "12"), "12"),
        (("--save", "quiet.toml"), "give --first-order or --compensate"),
        (("--point", "full"), "full"),
        (
            ("--orders", "0.3,2,0.5"),
            "orders 0.3, 0.5 do not occur in two-stroke seven; those that do are 1, 2, 3, 4 and",
        ),
    ],
)
def test_what_cannot_be_is_one_sentence(
    run: Run, tmp_path: Path, options: tuple[str, ...], said: str
) -> None:
    refused = run("marine", written(tmp_path), *options)
    assert refused.code == 2
    assert said in " ".join(refused.err.split())
    assert "Traceback" not in refused.err
    assert not (tmp_path / "quiet.toml").exists()


def test_a_saved_engine_never_replaces_what_is_read(
    refused: Callable[..., str], tmp_path: Path
) -> None:
    own = written(tmp_path)
    before = Path(own).read_text()
    asked = ("marine", own, "--first-order", "equal", "--save", own)
    assert "would be lost" in refused(*asked)
    assert Path(own).read_text() == before


@pytest.mark.release
@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--rated-power", "1 W"), "The power, 0.001 kW, is a brake mean effective pressure of"),
        (("--rated-power", "90 MW"), "at which no engine is rated: see --rated-power"),
        (
            ("--node", "-25 m", "--compensate", "2: -24.999999 m"),
            "A compensator of order 2 pushes with more than all cylinders together",
        ),
        (("--bracing", "1 mm, 8 m"), "are no higher than its crank pins, 1.2 m"),
    ],
)
def test_what_hardly_any_engine_has_is_doubted(
    run: Run, tmp_path: Path, options: tuple[str, ...], said: str
) -> None:
    place = written(tmp_path)
    assert said in " ".join(run("marine", place, *options).out.split())
    sane = ("--rated-power", "14 MW", "--bracing", "5 m, 8 m", "--compensate", "2: 4 m, -4 m")
    out = " ".join(run("marine", place, *sane).out.split())
    assert "is rated" not in out
    assert "its arm is too short" not in out
    assert "crank pins" not in out


def test_the_mean_pressure_of_the_power_is_that_of_the_cycle() -> None:
    found = marine(marine_engine())
    assert found.cycle is not None
    assert found.mean_pressure == pytest.approx(found.cycle.bmep, rel=1e-3)
    slow = marine(marine_engine(), speed=2.0, rated_power=found.power)
    assert slow.mean_pressure == pytest.approx(found.mean_pressure)


def test_all_that_is_wrong_is_told_at_once(run: Run, tmp_path: Path) -> None:
    wrong = {
        "-o": "x.foo",
        "--speed": "2 m",
        "--orders": "x",
        "--rated-power": "2 m",
        "--compensate": "2",
        "--node": "2 kg",
        "--save": "x.txt",
        "--phase-error": "400 deg",
        "--bracing": "5 m",
        "--first-order": "most",
    }
    words = [word for pair in wrong.items() for word in pair]
    told = run("marine", written(tmp_path), *words).err
    assert [option for option in wrong if option not in told] == []
    assert len(told.splitlines()) == len(wrong)
    unknown = run("marine", "no-such-engine", *words).err
    assert "no-such-engine" in unknown
    assert "--compensate" not in unknown  # whose units are those of the engine
    assert "--rated-power" in unknown


@pytest.mark.release
def test_moments_over_the_speeds_are_computed_whatever_orders_are_asked_for(run: Run) -> None:
    """Not asked for is not zero: M_4V goes with the square of the speed like the others."""
    own = ("--set", "cylinder.reciprocating_mass=9 t", "--set", "layout.bore_pitch=1.6 m")
    speeds = ("--speeds", "60..105 rpm by 15")

    def rows(*more: str) -> list[dict[str, float]]:
        return json.loads(run("marine", "man-s90mc-c", *own, *speeds, *more, "--json").out)[
            "speeds"
        ]

    whole, some = rows(), rows("--orders", "1,2")
    assert min(row["m4v"] for row in some) > 0
    for one, other in zip(some, whole, strict=True):
        assert one == pytest.approx(other)
    more = rows("--orders", "6")
    assert more[-1]["m6v"] > 0
    assert more[-1]["m4v"] == pytest.approx(whole[-1]["m4v"])


def test_a_moment_that_is_not_computed_is_no_number() -> None:
    engine = load("man-s90mc-c")
    found = external_moments(engine, orders=[1.0, 2.0])
    assert np.isnan(found.moment(4))
    assert found.moment(2) == pytest.approx(external_moments(engine).moment(2))
    assert external_moments(engine).moment(3) == 0  # computed, and none


def test_a_moment_about_the_node_is_computed_in_every_row() -> None:
    """Of an order that is told about the middle, and is small beside a force at a far node."""
    uneven = [{"number": 1, "reciprocating_mass": "1.2 kg"}]
    heavy = load("i4", changes={"cylinder.reciprocating_mass": "1 kg", "cylinders": uneven})
    found = marine(heavy, node=-40.0)
    assert found.at_node is not None
    about = external_moments(heavy, about=-40.0, orders=found.after.orders.tolist())
    for order in found.after.orders.tolist():
        assert found.at_node[1].moment(order) == pytest.approx(about.moment(order))
        assert not np.isnan(found.before.moment(order))
