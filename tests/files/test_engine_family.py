"""A family of engines: the same as engine files, the best of all orders, the verb guide."""

from __future__ import annotations

import csv
import io
import json
from itertools import pairwise, permutations
from math import hypot
from pathlib import Path
from typing import Any

import numpy as np
import openpyxl
import pytest
from tests.commands import Run
from tests.marine import SEVEN, WEIGHTED, marine_engine

import crankstar
from crankstar.analyses.guide.engine_family import ChainDrive, engine_family, with_cylinders
from crankstar.analyses.marine.marine_analysis import marine
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.files import toml
from crankstar.mechanics.external_moments import external_moments
from crankstar.mechanics.guide_moments import MarineError
from crankstar.options.search import goals_of
from crankstar.options.words import SearchWords
from crankstar.remedy.counterweights import RemedyError

FOUR_STROKE = {"cycle": "four-stroke", "firing_order": [1, 2, 4, 6, 7, 5, 3]}


def both(engine: Engine) -> float:
    found = external_moments(engine, speed=10.0)
    return hypot(found.moment(1), found.moment(2))


@pytest.mark.many(first=5)
@pytest.mark.parametrize("order", [(1, 4, 3, 2, 5), (1, 8, 3, 4, 7, 2, 5, 6)])
@pytest.mark.parametrize("changes", [{}, FOUR_STROKE, {"rotation": "counter-clockwise"}])
def test_a_member_is_the_engine_of_a_file_with_that_order(
    order: tuple[int, ...], changes: dict[str, object]
) -> None:
    made = with_cylinders(marine_engine(**changes), order)
    written = marine_engine(**{**changes, "firing_order": list(order)})
    one, other = (marine(engine) for engine in (made, written))
    assert made.firing_order == written.firing_order
    for left, right in zip(made.cylinders, written.cylinders, strict=True):
        assert left.z == pytest.approx(right.z)
    assert one.power == pytest.approx(other.power)
    scale = abs(other.before.vertical).max()
    assert one.before.vertical == pytest.approx(other.before.vertical, abs=1e-9 * scale)
    assert one.guide is not None
    assert other.guide is not None
    assert one.guide.x == pytest.approx(other.guide.x, abs=1e-6 * abs(other.guide.x).max())


@pytest.mark.many(first=1)
@pytest.mark.parametrize("drive", [None, ChainDrive(5, 0.6)])
@pytest.mark.parametrize("count", [5, 6])
def test_the_best_is_the_least_of_all_orders(count: int, drive: ChainDrive | None) -> None:
    engine = marine_engine()
    [member, *_rest] = engine_family(engine, numbers=[count], drive=drive)
    every = [
        both(with_cylinders(engine, (1, *rest), drive=drive))
        for rest in permutations(range(2, count + 1))
    ]
    assert member.found is not None
    assert both(member.found.engine) == pytest.approx(min(every))
    assert member.order == member.found.engine.firing_order


def test_a_known_order_of_the_class_of_the_best_is_the_best() -> None:
    given = [(1, 5, 3, 4, 2, 6)]
    members = engine_family(marine_engine(), numbers=[6, 7], given=given)
    assert [(member.order, member.chosen) for member in members] == [
        ((1, 5, 3, 4, 2, 6), "best"),
        ((1, 7, 2, 5, 4, 3, 6), "best"),
    ]


def test_a_wider_gap_stands_in_the_middle_from_its_number_up() -> None:
    engine, drive = marine_engine(), ChainDrive(6, 0.6)
    five, six = (
        with_cylinders(engine, range(1, count + 1), drive=drive).cylinders for count in (5, 6)
    )
    gaps = [[a.z - b.z for a, b in pairwise(row)] for row in (five, six)]
    assert gaps[0] == pytest.approx([1.02] * 4)
    assert gaps[1] == pytest.approx([1.02, 1.02, 1.62, 1.02, 1.02])


def test_limits_that_none_keeps_leave_a_row_without_an_engine() -> None:
    goals = goals_of(SearchWords(minimise="M2", limit=["M1=1 N m", "M2=1 N m"], best="1"))
    five, twelve = engine_family(marine_engine(), numbers=[5, 12], options=goals)
    assert five.found is None
    assert twelve.found is not None


def test_weights_at_the_ends_are_refused_where_cylinders_lean() -> None:
    """They were left out without a word, and the page said that they were there."""
    upright = marine_engine()
    leaning = with_values(
        upright,
        cylinders=tuple(with_values(each, bearing=0.3) for each in upright.cylinders),
        firing_order=(),
    )
    with pytest.raises(RemedyError, match="upright cylinders"):
        engine_family(leaning, numbers=[5], horizontal_share=0.5)


@pytest.mark.release
def test_what_weights_at_the_ends_take_away_is_nought(run: Run, tmp_path: Path) -> None:
    """Rounding was printed, 1e-17 of the rest."""
    asked = ("guide", written(tmp_path), "--numbers", "5", "--json")
    for way, left, gone in (("vertical", "m1v", "m1h"), ("horizontal", "m1h", "m1v")):
        [row, *_others] = json.loads(run(*asked, "--first-order", way).out)["members"]
        assert row[left] > 0
        assert row[gone] == 0


def test_a_gap_of_nothing_is_refused_as_it_was_written(run: Run, tmp_path: Path) -> None:
    asked = ("guide", written(tmp_path), "--numbers", "5", "--chain-drive", "3: 0 mm")
    code, _out, err = run(*asked)
    assert code == 2
    assert "--chain-drive 0 mm: it must be greater than 0" in err


def test_only_a_row_of_alike_cylinders_has_a_family() -> None:
    for name in ("harley-45", "square-four", "single", "jumo-205"):
        with pytest.raises(MarineError, match="one row of alike cylinders"):
            with_cylinders(crankstar.load(name), [1, 2, 3])
    with pytest.raises(MarineError, match="each cylinder from 1 on once"):
        with_cylinders(marine_engine(), [1, 3, 3])


def written(folder: Path) -> str:
    path = folder / "seven.toml"
    path.write_text(toml(marine_engine()))
    return str(path)


@pytest.mark.release
def test_the_verb_gives_the_page_of_a_guide(run: Run, tmp_path: Path) -> None:
    place = written(tmp_path)
    asked = ("--numbers", "5..7", "--given", "1-3-5-4-2", "--first-order", "equal")
    out = json.loads(run("guide", place, *asked, "--json").out)
    assert out["format"] == 1
    assert [row["cylinders"] for row in out["members"]] == [5, 5, 6, 7, 7]
    seven = out["members"][-2]
    found = marine(marine_engine(), horizontal_share=0.5)
    assert seven["firing_order"] == SEVEN["firing_order"]
    assert (seven["m1v"], seven["m1h"]) == pytest.approx((found.after.moment(1),) * 2)
    assert seven["unbalance"] == pytest.approx(found.unbalance(found.after.moment(2)))
    assert found.guide is not None
    assert (seven["x_order"], seven["x"]) == pytest.approx((4, abs(found.guide.x).max()))
    assert (seven["h_order"], seven["h"]) == pytest.approx((7, abs(found.guide.h).max()))
    rows = list(csv.DictReader(io.StringIO(run("guide", place, *asked, "--csv").out)))
    assert len(rows) == 5
    book = tmp_path / "guide.xlsx"
    run("guide", place, *asked, "-o", str(book))
    assert "members" in openpyxl.load_workbook(book).sheetnames
    text = " ".join(run("guide", place, *asked).out.split())
    assert "Best: by M1,M2, of all crank stars with evenly spaced throws, with proof" in text
    assert "Vector sum by a straight shape: of the order of X, 1 at the end cylinders" in text


def turning(engine: Engine, order: int) -> float:
    """The greatest moment of an order over a turn, whichever way it points."""
    found = external_moments(engine, orders=[order])
    angles = np.linspace(0, 2 * np.pi, 721)[:, None] * order
    sides = [
        np.real(each[None] * np.exp(1j * angles))[:, 0]
        for each in (found.vertical, found.horizontal)
    ]
    return float(np.hypot(*sides).max())


@pytest.mark.release
def test_the_best_is_by_squares_of_moments_with_all_that_rotates(run: Run, tmp_path: Path) -> None:
    """Brute force over all orders of five cylinders, with big ends that nothing balances."""
    engine = marine_engine(**WEIGHTED)
    [member, *_rest] = engine_family(engine, numbers=[5])
    sums: dict[tuple[int, ...], float] = {
        order: hypot(*(turning(with_cylinders(engine, order), each) for each in (1, 2)))
        for order in ((1, *rest) for rest in permutations(range(2, 6)))
    }
    assert sums[member.order] == pytest.approx(min(sums.values()), rel=1e-4)
    assert max(sums.values()) > 1.05 * min(sums.values())
    place = tmp_path / "weighted.toml"
    place.write_text(toml(engine))
    text = " ".join(run("guide", str(place), "--numbers", "5").out.split())
    assert "the root of the sum of their squares counts" in text
    assert "the greatest value over a turn. M1 holds" in text
    assert "M1 holds rotating masses and those of throws" in text
    assert "--first-order changes the moments only, once the order is chosen" in text
    second = " ".join(run("guide", str(place), "--numbers", "5", "--minimise", "M2").out.split())
    assert "M1 holds" not in second
    asked = ("--numbers", "5", "--minimise", "M2,neighbours")
    mixed = " ".join(run("guide", str(place), *asked).out.split())
    assert "the greatest value over a turn, moments in N m." in mixed
    assert "root of the sum" not in second


@pytest.mark.release
def test_without_masses_and_pitch_the_page_is_in_their_units(run: Run) -> None:
    out = run("guide", "man-s90mc-c", "--numbers", "6,7")
    assert "1-7-2-5-4-3-6" in out.out
    assert "in units of the first cylinder" in " ".join(out.out.split())


def test_a_row_that_no_order_fills_is_told(run: Run, tmp_path: Path) -> None:
    asked = ("--numbers", "5", "--limit", "M1=1 N m", "--limit", "M2=1 N m")
    out = " ".join(run("guide", written(tmp_path), *asked).out.split())
    assert "none keeps the limits" in out


@pytest.mark.parametrize(
    ("options", "said"),
    [
        (("--numbers", "5..99"), "give numbers of cylinders from 2 to 14"),
        (("--numbers", "7..5"), "give numbers of cylinders from 2 to 14"),
        (("--given", "1-2-2"), "give a firing order"),
        (("--given", "1-2", "--numbers", "5,6"), "engines of 2 cylinders are not listed"),
        (("--chain-drive", "600 mm"), "give a number of cylinders, a colon"),
        (("--chain-drive", "9: 0 mm"), "greater than 0"),
        (("--chain-drive", "13: 600 mm"), "give a number up to 12, or see --numbers"),
        (("--chain-drive", "8: 600 mm", "--numbers", "5..7"), "has so many cylinders; give a num"),
        (("--chain-drive", "0: 600 mm"), "from how many cylinders up; give 2 or more"),
        (("--chain-drive", "1: 600 mm"), "from how many cylinders up; give 2 or more"),
        (("--numbers", "2,5", "--minimise", "M2"), "M2 is the same for every star of 2 cylinders"),
        (("--numbers", "4", "--minimise", "F1"), "F1 is the same for every star of 4 cylinders"),
        (("--minimise", "Q1"), "There is no quantity"),
        (("--minimise", "X1.5"), "whole orders"),
        (("--minimise", "M1,T3"), "--minimise T3: torsion needs the mode shape of one number"),
        (("--limit", "T4=1"), "--limit T4: torsion needs the mode shape of one number of cyl"),
        (("--first-order", "some"), "give vertical, equal"),
    ],
)
def test_what_cannot_be_asked_is_one_sentence(
    run: Run, tmp_path: Path, options: tuple[str, ...], said: str
) -> None:
    refused = run("guide", written(tmp_path), *options)
    assert refused.code == 2
    assert said in " ".join(refused.err.split())


@pytest.mark.release
@pytest.mark.parametrize("changes", [{}, FOUR_STROKE], ids=["two-stroke", "four-stroke"])
def test_published_orders_are_those_of_the_catalog_with_their_source(
    run: Run, tmp_path: Path, changes: dict[str, Any]
) -> None:
    place = tmp_path / "seven.toml"
    place.write_text(toml(marine_engine(**changes)))
    asked = ("guide", str(place), "--numbers", "5..8")
    rows = json.loads(run(*asked, "--json").out)["members"]
    text = " ".join(run(*asked).out.split())
    found = {tuple(row["firing_order"]): row for row in rows if row["published"]}
    for order, row in found.items():
        engine = crankstar.load(row["published"])
        origin = engine.provenance["firing_order"]
        assert origin.status == "published"
        assert engine.cycle == changes.get("cycle", "two-stroke")
        assert order in (engine.firing_order, (1, *reversed(engine.firing_order[1:])))
        words = "-".join(map(str, order))
        own = f"{words} is published in {origin.source} ({row['published']} of the catalog)."
        assert own in text
        assert (f"The mirror image of {own}" in text) == (order != engine.firing_order)
    # by hand from the catalog: no order of an unverified file, one of each pair of mirror images
    two = {(1, 5, 3, 4, 2, 6), (1, 7, 2, 5, 4, 3, 6), (1, 5, 3, 6, 2, 4, 7)}
    four = {(1, 2, 4, 5, 3), (1, 5, 3, 6, 2, 4), (1, 3, 7, 5, 8, 6, 2, 4), (1, 5, 7, 3, 8, 4, 2, 6)}
    four |= {(1, 2, 4, 6, 7, 5, 3), (1, 3, 2, 7, 5, 6, 4)}
    assert {*found} == (four if changes else two)


@pytest.mark.release
def test_a_published_order_has_the_moments_of_the_same_order_given(
    run: Run, tmp_path: Path
) -> None:
    asked = ("guide", written(tmp_path), "--numbers", "7", "--json")
    first = json.loads(run(*asked).out)["members"][1]
    same = json.loads(run(*asked, "--given", "1-5-3-6-2-4-7").out)["members"][1]
    assert (first.pop("chosen"), same.pop("chosen")) == ("published", "given")
    assert first == same


def test_all_that_is_wrong_is_told_at_once(run: Run, tmp_path: Path) -> None:
    wrong = {
        "--numbers": "5..7",
        "-o": "x.foo",
        "--given": "1-2",
        "--chain-drive": "8: 600 mm",
        "--minimise": "Q1",
        "--first-order": "some",
    }
    words = [word for pair in wrong.items() for word in pair]
    told = run("guide", written(tmp_path), *words).err
    assert [option for option in [*wrong][1:] if option not in told] == []
    assert "--numbers:" not in told


@pytest.mark.release
def test_a_rotating_mass_that_the_engine_cancels_is_missing_from_its_family(run: Run) -> None:
    """A six cancels what it lacks; the five of the same cylinders shows it."""
    tree = json.loads(json.dumps(SIX))
    Path("six.json").write_text(json.dumps(tree))
    rests = json.loads(run("guide", "six.json", "--numbers", "5,6", "--json").out)["rests_on"]
    [rest] = [each for each in rests if each["path"] == "cylinder.rotating_mass"]
    assert (rest["moves"]["quantity"], rest["moves"]["order"]) == ("couple of member 5", 1)
    low, high = rest["low"], rest["high"]
    now = engine_family(crankstar.load("six.json"), numbers=[5])[0]
    assert now.found is not None
    assert rest["moves"]["now"] == pytest.approx(now.found.after.moment(1), rel=1e-9)
    assert 0 < low < high
    tree["cylinder"]["rotating_mass"] = "2000 kg"
    Path("full.json").write_text(json.dumps(tree))
    rests = json.loads(run("guide", "full.json", "--numbers", "5,6", "--json").out)["rests_on"]
    assert not [each for each in rests if each["path"] == "cylinder.rotating_mass"]


SIX: dict[str, Any] = {
    "name": "six",
    "cycle": "two-stroke",
    "speed": "100 rpm",
    "firing_order": [1, 5, 3, 4, 2, 6],
    "cylinder": {
        "bore": "500 mm",
        "stroke": "2000 mm",
        "rod_length": "2000 mm",
        "reciprocating_mass": "3000 kg",
    },
    "layout": {"type": "inline", "bore_pitch": "900 mm"},
    "gas": {"imep": "19 bar", "ignition": "compression"},
}
