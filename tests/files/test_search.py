"""`crankstar search`: tables, files of every kind, rows that become engines, refusals."""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import pyarrow.parquet
import pytest
from tests import exhaustive

from crankstar import cli, load
from crankstar.cli import search_job
from crankstar.mechanics.balance import balance, total
from crankstar.options import search as options
from crankstar.options.search import search_of
from crankstar.options.words import SearchWords
from crankstar.spectra import horizontal, vertical
from crankstar.stars.answer import answer_to
from crankstar.stars.question import All
from crankstar.tables.machine import columns
from crankstar.tables.search_stars import search_stars

Run = Callable[..., Any]
SEVEN = ("search", "7", "--cycle", "two-stroke")


def table(out: str) -> list[list[str]]:
    """Rows of the table: those that begin with their number."""
    lines = [line.split() for line in out.splitlines()]
    return [
        words
        for words in lines
        if words and words[0].isdigit() and len(words) > 3 and "-" in words[1]
    ]


def test_the_front_of_seven_with_its_counts_and_proof(run: Run) -> None:
    out = run(*SEVEN).out
    assert "720 stars; 360 not counting mirror images, 192 not counting reversals either." in out
    assert "Proved complete" in out
    found = [(words[1], float(words[2]), float(words[3])) for words in table(out)]
    wanted = [(0.0765, 9.149), (0.2673, 1.0056), (2.1937, 0.8223), (3.7808, 0.0765)]
    assert [values for _, *values in found] == [pytest.approx(point, abs=5e-4) for point in wanted]
    for order, one, two in found:
        star = directions([int(word) for word in order.split("-")])
        row = (
            exhaustive.lengths(star, exhaustive.arms(7), 1, 7),
            exhaustive.lengths(star, exhaustive.arms(7), 2, 7),
        )
        assert (one, two) == (
            pytest.approx(float(row[0][0]), abs=1e-4),
            pytest.approx(float(row[1][0]), abs=1e-4),
        )


def directions(order: list[int]) -> Any:
    """The star of a two-stroke firing order."""
    import numpy as np

    return np.array([[order.index(number) for number in range(1, len(order) + 1)]])


@pytest.mark.release
def test_exact_values_stand_beside_their_numbers(run: Run) -> None:
    out = run(
        "search", "8", "--cycle", "two-stroke", "--minimise", "M1", "--zero", "M2", "--best", "3"
    ).out
    assert "√(20 − 14√2) = 0.44834" in out
    out = run("search", "6", "--cycle", "two-stroke", "--minimise", "M2", "--zero", "M1").out
    assert "2√3 = 3.4641" in out


def test_all_stars_with_the_moments_of_one(run: Run) -> None:
    by_order = run(*SEVEN, "--all-with", "1-7-2-5-4-3-6").out
    by_values = run(*SEVEN, "--all-with", "M1=0.2673,M2=1.0056").out
    assert table(by_order) == table(by_values)
    assert "Stars: 2; classes: 1." in by_order


def test_contradictions_are_proved(run: Run) -> None:
    out = run("search", "6", "--cycle", "two-stroke", "--zero", "M1,M2").out
    assert "Proved: no star keeps these limits" in out


@pytest.mark.many(first=1)
@pytest.mark.parametrize("kind", ["csv", "json", "parquet"])
def test_results_are_written_with_all_rows(run: Run, tmp_path: Path, kind: str) -> None:
    place = tmp_path / f"eight.{kind}"
    run(
        "search",
        "8",
        "--cycle",
        "two-stroke",
        "--minimise",
        "M1",
        "--zero",
        "M2",
        "--all",
        "-o",
        str(place),
    )
    if kind == "csv":
        read = list(csv.DictReader(io.StringIO(place.read_text(encoding="utf-8"))))
        values, stars = (
            [float(row["M1 [m*r*w^2*a]"]) for row in read],
            [int(row["stars"]) for row in read],
        )
        assert {"|sum z exp(i 1 phi)| [a]", "|sum z exp(i 2 phi)| [a]"} <= read[0].keys()
    elif kind == "json":
        tree = json.loads(place.read_text(encoding="utf-8"))
        values, stars = (
            [row["M1"] for row in tree["rows"]],
            [row["stars"] for row in tree["rows"]],
        )
        assert tree["counts"]["found"] == 96
        assert tree["certificate"]["complete"] is True
    else:
        read = pyarrow.parquet.read_table(place).to_pydict()
        values, stars = read["M1 [m*r*w^2*a]"], read["stars"]
    assert sum(stars) == 96
    assert min(values) == pytest.approx((20 - 14 * 2**0.5) ** 0.5, abs=1e-12)


def test_a_row_becomes_an_engine_that_has_these_moments(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "better.toml"
    out = run(*SEVEN, "--row", "2", "-o", str(place)).out
    engine = load(str(place))
    first = total(balance(engine)).couple
    assert 2 * abs(first.backward[first.orders == 1][0]) == pytest.approx(0.26725, abs=1e-4)
    assert engine.firing_order == (1, 7, 2, 5, 4, 3, 6)
    assert not out


def test_a_row_of_a_real_engine_keeps_its_pistons(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "better.toml"
    run("search", "audi-25-tfsi", "--minimise", "M1,M2", "--row", "1", "-o", str(place))
    before, after = load("audi-25-tfsi"), load(str(place))
    assert [c.reciprocating_mass for c in after.cylinders] == [
        c.reciprocating_mass for c in before.cylinders
    ]
    assert [c.z for c in after.cylinders] == pytest.approx([c.z for c in before.cylinders])


BALANCED_SEVEN = """
format = 1
name = "seven"
cycle = "two-stroke"
firing_order = [1, 7, 2, 5, 4, 3, 6]
balance_factor = 0.5
speed = "105 rpm"

[cylinder]
stroke = "2400 mm"
rod_length = "2460 mm"
reciprocating_mass = "5500 kg"
rotating_mass = "6800 kg"

[layout]
type = "inline"
positions = ["0 mm", "1020 mm", "2040 mm", "3060 mm", "4080 mm", "5600 mm", "6620 mm"]
"""


@pytest.mark.release
def test_counterweights_turn_with_the_throws_of_a_row(run: Run, tmp_path: Path) -> None:
    (tmp_path / "seven.toml").write_text(BALANCED_SEVEN)
    third = json.loads(run("search", "seven.toml", "--json").out)["rows"][2]
    run("search", "seven.toml", "--row", "3", "-o", "new.toml")
    orders = json.loads(run("analyze", "new.toml", "--json").out)["orders"]
    greatest = [order["couple"]["greatest"] for order in orders[:2]]
    assert [third["M1"], third["M2"]] == pytest.approx(greatest, rel=1e-9)
    assert third["M1"] == pytest.approx(914e3, rel=1e-3)


@pytest.mark.release
def test_the_pistons_alone_are_named_and_all_parts_stand_beside(run: Run, tmp_path: Path) -> None:
    text = BALANCED_SEVEN + '[[cylinders]]\nnumber = 1\nreciprocating_mass = "6000 kg"\n'
    (tmp_path / "seven.toml").write_text(text.replace("balance_factor", "# balance_factor"))
    out = run("search", "seven.toml").out
    assert "M1 (pistons): the search leaves out" in " ".join(out.split())
    (first, *_rest) = json.loads(run("search", "seven.toml", "--json").out)["rows"]
    run("search", "seven.toml", "--row", "1", "-o", "new.toml")
    orders = json.loads(run("analyze", "new.toml", "--json").out)["orders"]
    assert first["M1"] == pytest.approx(orders[0]["couple"]["greatest"], rel=1e-9)
    assert first["M1 (pistons)"] < first["M1"]


@pytest.mark.release
@pytest.mark.parametrize("chart", ["front", "stars"])
def test_pictures_of_the_front_and_of_the_winners(run: Run, tmp_path: Path, chart: str) -> None:
    place = tmp_path / "picture.svg"
    run(*SEVEN, "--chart", chart, "-o", str(place))
    text = place.read_text(encoding="utf-8")
    assert text.startswith("<svg")
    assert "1-7-2-5-4-3-6" in text


@pytest.mark.release
def test_the_answer_is_the_same_with_two_workers_and_from_a_checkpoint(
    run: Run, tmp_path: Path
) -> None:
    alone = run("search", "11", "--cycle", "two-stroke", "--workers", "1").out
    assert (
        run("search", "11", "--cycle", "two-stroke", "--workers", "2", "--checkpoint", "kept").out
        == alone
    )
    assert (
        run("search", "11", "--cycle", "two-stroke", "--workers", "1", "--checkpoint", "kept").out
        == alone
    )
    assert (tmp_path / "kept").exists()


@pytest.mark.many(first=15)
@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("1",), "2 to 24"),
        (("-3",), "2 to 24"),
        (("nosuch",), "no such engine"),
        (("v8-cross-plane",), "--minimise M1,M2,twist searches"),
        (("20", "--judge", "stress"), "--judge has no effect without an engine"),
        (("i6", "--speed", "90 rpm", "--bank", "90"), "--speed has no effect with --bank; leave"),
        (("mwm-6-diesel", "--judge", "stress"), "shear stress of torsion needs the diameter"),
        (("7", "--cycle", "three"), "two-stroke"),
        (("7", "--minimise", "Q3"), '--minimise: There is no quantity "Q3"'),
        (("7", "--limit", "M2"), "--limit: M2"),
        (("7", "--gaps", "1,1"), "--gaps: 2 gaps"),
        (("7", "--fix", "9=2"), "--fix: There is no cylinder 9"),
        (("7", "--front", "--best", "3"), "--front, --best"),
        (("7", "--row", "1.9"), "--row"),
        (("7", "--workers", "1.9"), "--workers"),
        (("7", "--workers", "0"), "1 to 1024"),
        (("7", "--checkpoint", ""), '--checkpoint "": it is empty'),
        (("6", "--why", ""), '--why "": it is empty; leave it out'),
        (("7", "--judge", " "), '--judge " ": it is empty'),
        (("i6", "--bank", ""), '--bank "": it is empty'),
        (("6", "--orders", ""), '--orders "": it is empty'),
        (("6", "--bank", "90", "--minimise", ""), "--minimise: Name at least one quantity"),
        (("6", "--bank", "90", "--zero", ""), "--zero: Name at least one quantity"),
        (("6", "--bank", "120", "--minimise", ""), "--minimise: Name at least one quantity"),
        (("6", "--bank", "x", "--minimise", "M9x"), "--minimise: M9x: with the firing order"),
        (("6", "--bank", "90", "--minimise", "M9x"), "bank angles that are multiples of 120"),
        (("i6", "--judge", ","), "--judge ,: choose from stress, bearings"),
        (("7", "--csv", "--json"), "--json and --csv exclude each other"),
        (("7", "--csv", "-o", "x.json"), "the name ends in .json; leave --csv out"),
        (("7", "--checkpoint", "same.csv", "-o", "same.csv"), "this is the checkpoint"),
        (("7", "--minimise", "neighbours", "--row", "1", "--uneven", "5"), "--uneven: Name"),
        (("8", "--row", "1", "--uneven", "5,90"), "up to 60"),
        (("12", "--row", "1", "--uneven", "60"), "--uneven: A deviation of 60 deg"),
        (("7", "--mode-shape", "1,2,3,4,5,6,7"), "--minimise M1,M2,T3"),
        (("7", "--zero", "neighbours"), "--avoid-adjacent"),
        pytest.param(("11", "--all"), "more than the 200,000 classes", marks=pytest.mark.release),
        (("7", "--scheduler", "\x1b[31mtcp://x"), "No dask scheduler answers"),
        (("7", "--row", "99"), "has 4 rows"),
        (("7", "-o", "nosuch/x.csv"), "no such directory"),
        (("7", "-o", "x.doc"), "must end in"),
        (("7", "--chart", "pie", "-o", "x.svg"), "front"),
        (("7", "--minimise", "M1", "--chart", "front", "-o", "x.svg"), "two or more objectives"),
        (("7", "--set", "a=b"), "--set"),
        (("22", "--cycle", "two-stroke"), "Fix at least 3 throws"),
    ],
)
def test_what_cannot_be_searched_is_refused(
    refused: Callable[..., str], words: tuple[str, ...], told: str
) -> None:
    assert told in " ".join(refused("search", *words).split())


def test_a_row_behind_the_last_is_refused(refused: Callable[..., str]) -> None:
    assert refused("search", "6", "--row", "500").endswith("the answer has 1 row\n")


def test_more_stars_than_can_be_listed_are_refused(
    refused: Callable[..., str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(options, "All", partial(All, size=50))
    told = refused("search", "7", "--cycle", "two-stroke", "--all")
    assert "more than the 50 classes" in " ".join(told.split())


def test_every_mistake_is_told_at_once(refused: Callable[..., str]) -> None:
    words = ("--fix", "9=1", "--symmetric", "--minimise", "Q3,M0", "--limit", "M2", "--best", "0")
    said = refused("search", "7", *words).splitlines()
    assert len(said) == 6
    for option in ("fix", "symmetric", "minimise", "limit", "best"):
        assert any(f"--{option}" in line for line in said), said


@pytest.mark.release
@pytest.mark.parametrize(
    ("spoil", "told"),
    [
        (lambda whole: whole, ""),
        (lambda whole: whole[: len(whole) // 2], "1 damaged line was passed over"),
        (lambda whole: whole[:100] + b"\n\0" + whole[100:], "2 damaged lines were passed over"),
        (lambda _whole: b"", "held no whole line; the search starts at the beginning"),
        (lambda whole: whole[:20], "held no whole line"),
    ],
)
@pytest.mark.parametrize("options", [[], ["--bank", "120"]])
def test_what_is_damaged_in_a_checkpoint_is_told(
    capsys: pytest.CaptureFixture[str],
    tmp_path: Path,
    options: list[str],
    spoil: Callable[[bytes], bytes],
    told: str,
) -> None:
    file = tmp_path / "kept"
    answers: list[str] = []
    for written in (None, spoil):
        if written is not None:
            file.write_bytes(written(file.read_bytes()))
        with pytest.raises(SystemExit) as ended:
            cli.main(["search", "6", *options, "--checkpoint", str(file)])
        assert ended.value.code == 0
        printed = capsys.readouterr()
        answers.append(printed.out)
    assert answers[0] == answers[1]
    assert told in printed.err
    assert bool(told) == bool(printed.err)


def test_a_checkpoint_of_another_search_is_refused(run: Run, refused: Callable[..., str]) -> None:
    run(*SEVEN, "--checkpoint", "kept")
    assert "another search" in refused("search", "8", "--checkpoint", "kept")


@pytest.mark.parametrize(
    ("place", "said"),
    [
        ("none/kept", "Name another file with --checkpoint"),
        (".", "it is a directory"),
        ("other", "not a checkpoint of a search"),
    ],
)
def test_a_checkpoint_that_cannot_be_is_refused_before_anything_is_compiled(
    refused: Callable[..., str],
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    place: str,
    said: str,
) -> None:
    monkeypatch.setattr(search_job.estimates, "estimate", lambda _: pytest.fail("compiled"))
    (tmp_path / "other").write_text("engine = 1\n")
    told = " ".join(refused("search", "7", "--checkpoint", place).split())
    assert said in told
    assert place == "other" or not (tmp_path / place).is_file()


def test_rows_name_their_units() -> None:
    from fractions import Fraction

    from crankstar.stars.answer import answer_to
    from crankstar.stars.question import Question
    from crankstar.stars.star import Stars
    from crankstar.stars.sums import couple, of

    stars = Stars(5, "two-stroke", tuple(Fraction(2 - j) for j in range(5)))
    found = search_stars(answer_to(Question(stars, (of(couple(stars, 1)), of(couple(stars, 2))))))
    heads, body = columns(next(found.tables))
    assert "M1 [m*r*w^2*a]" in heads
    assert all(len(row) == len(heads) for row in body)


@pytest.mark.release
def test_the_row_of_a_point_is_the_star_with_the_fewest_neighbours(run: Run) -> None:
    (row,) = table(run("search", "12", "--cycle", "two-stroke").out)
    assert row[2:6] == ["0", "0", "0", "36"]


@pytest.mark.release
def test_all_with_lists_nothing_but_what_was_asked(run: Run) -> None:
    out = run("search", "11", "--all-with", "1-2-3-4-5-6-7-8-9-10-11").out
    assert len(table(out)) == 1
    assert "Proved: no star keeps" in run("search", "7", "--all-with", "M1=100").out
    out = run(*SEVEN, "--all-with", "M1=1/3").out
    assert "Proved: no star keeps" in out


def test_a_list_by_several_objectives_shows_each(run: Run) -> None:
    out = run(*SEVEN, "--minimise", "M1,2*M2", "--best", "1").out
    ((_, _, together, one, two, *_),) = table(out)
    assert float(together) == pytest.approx(
        (float(one) ** 2 + 4 * float(two) ** 2) ** 0.5, rel=1e-4
    )


def test_an_engine_is_found_among_the_rows(run: Run) -> None:
    assert (
        "The engine as it is (1-2-4-5-3), row 1"
        in run("search", "audi-25-tfsi", "--minimise", "couple").out
    )


@pytest.mark.release
def test_couples_are_counted_with_their_harmonic_where_it_is_not_known(run: Run) -> None:
    out = run(*SEVEN).out
    assert re.search(r"\[m r ω² a\] +\[m r ω² A2 a\]", out)
    assert "A2" not in run("search", "man-s90mc-c").out


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["7"], "succession. stars: how many have these values; classes: these without mirror"),
        (["2"], "stars: how many have these values"),
        (["2", "--minimise", "twist"], "2 cylinders, four-stroke: Pareto front of twist"),
        (["2", "--minimise", "twist"], "Fired evenly: 1 star, with 1 firing order on each;"),
    ],
)
def test_columns_and_counts_are_told_in_words(run: Run, words: list[str], told: str) -> None:
    assert told in " ".join(run("search", *words).out.split())


@pytest.mark.parametrize("cylinders", ["2", "3", "4"])
def test_few_cylinders_need_no_options(run: Run, cylinders: str) -> None:
    for cycle in ("two-stroke", "four-stroke"):
        assert table(run("search", cylinders, "--cycle", cycle).out)


def test_uneven_angles_are_shown_and_written(run: Run, tmp_path: Path) -> None:
    out = run(*SEVEN, "--row", "2", "--uneven", "2,5", "-o", "uneven.toml").out
    assert "local optimum" in " ".join(out.split())
    engine = load(str(tmp_path / "uneven.toml"))
    result = total(balance(engine))
    first = 2 * abs(result.couple.backward[result.couple.orders == 1][0])
    row = next(line.split() for line in out.splitlines() if re.match(r" +5 +\d", line))
    assert first == pytest.approx(float(row[1]), rel=1e-3)


@pytest.mark.parametrize("count", [0, 2])
def test_a_stopped_search_writes_what_it_has_and_nothing_over_a_file_where_it_has_nothing(
    count: int, capsys: pytest.CaptureFixture[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = answer_to(search_of(4, SearchWords(cycle="two-stroke")).question)
    part = replace(
        whole, rows=whole.rows[:count], certificate=replace(whole.certificate, interrupted=True)
    )
    monkeypatch.setattr(search_job, "answer_of", lambda *_, **__: part)
    file = tmp_path / "x.csv"
    file.write_text("old", encoding="utf-8")
    with pytest.raises(SystemExit) as left:
        cli.main(["search", "4", "--cycle", "two-stroke", "-o", str(file)])
    assert left.value.code == 130
    assert (file.read_text(encoding="utf-8") == "old") == (count == 0)
    assert ("was not written" in capsys.readouterr().err) == (count == 0)


MARINE = """
format = 1
name = "Marine seven"
cycle = "two-stroke"
speed = "76 rpm"
firing_order = [1, 7, 2, 5, 4, 3, 6]
cylinder = {bore = "900 mm", stroke = "3188 mm", rod_length = "3270 mm", \
reciprocating_mass = "14 t", rotating_mass = "9 t"}
layout = {type = "inline", bore_pitch = "1602 mm"}
"""


@pytest.fixture
def marine(tmp_path: Path) -> str:
    (tmp_path / "marine.toml").write_text(MARINE, encoding="utf-8")
    return "marine.toml"


@pytest.mark.parametrize(
    ("limit", "told"),
    [
        ("M2=1200 kN*m", "M2 ≤ 1.2 MN m"),
        ("M2 <= 1.2 MN m", "M2 ≤ 1.2 MN m"),
        ("M2=1200000", "M2 ≤ 1.2 MN m"),
        ("M2V=1200 kNm", "M2V ≤ 1.2 MN m"),
        ('M2="1200 kN m"', "M2 ≤ 1.2 MN m"),
        ("M2 <= '1.2 MN m'", "M2 ≤ 1.2 MN m"),
    ],
)
def test_a_limit_may_have_a_unit_and_is_told_in_that_of_the_table(
    run: Run, marine: str, limit: str, told: str
) -> None:
    out = run("search", marine, "--limit", limit).out
    assert f"; limits: {told}\n" in out
    assert [words[1] for words in table(out)] == ["1-7-2-5-4-3-6", "1-6-2-4-5-3-7", "1-5-2-4-6-3-7"]
    words = " ".join(out.split())
    assert "M1 0.99423 MN m, M2" in words  # as in the table, whose greatest value is 14 MN m
    assert f"all stars with {told} were searched" in words


@pytest.mark.parametrize(
    ("about", "limit", "told"),
    [
        ("marine.toml", "M1=800 kg", 'M1 is "800 kg", a mass; a couple is needed'),
        ("marine.toml", "M1=-8 kN m", 'as in M2=1.5 or M2="800 kN m"'),
        ("marine.toml", "M2H=1", "M2H: the pistons of Marine seven do not act"),
        ("man-s90mc-c", "M1=800 kN m", "give a number of m r ω² a"),
        ("7", "M1=800 kN m", "without an engine there are no newtons"),
        ("7", "M1H=1", "needs an engine"),
        ("7", "T3V=1", "There is no quantity"),
    ],
)
def test_a_limit_that_cannot_be_is_refused(
    refused: Callable[..., str], marine: str, about: str, limit: str, told: str
) -> None:
    assert marine
    assert told in " ".join(refused("search", about, "--limit", limit).split())


def test_a_fault_of_two_options_is_told_once(refused: Callable[..., str]) -> None:
    told = refused("search", "7", "--minimise", "roll", "--limit", "roll=1")
    assert told.startswith("crankstar: --limit, --minimise: roll: the roll does not depend")
    assert told.count("roll does not depend") == 1


@pytest.mark.release
@pytest.mark.parametrize("weights", [False, True])
def test_vertical_and_horizontal_moments_are_those_that_analyze_finds(
    run: Run, marine: str, tmp_path: Path, weights: bool
) -> None:
    names = ["M1V", "M2V", "M1H"]
    if weights:  # which differ between throws: only what the pistons do is searched
        assert run("balance", marine, "--weights", "ends", "-o", "weighted.toml").code == 0
        marine, names = "weighted.toml", names[:2]
    asked = ("search", marine, "--minimise", ",".join(names))
    row = json.loads(run(*asked, "--json").out)["rows"][1]
    run(*asked, "--row", "2", "-o", "second.json")
    made = load(str(tmp_path / "second.json"))
    turned = total(balance(made, speed=made.speed)).couple
    for name in names:
        component = (vertical if name.endswith("V") else horizontal)(turned)
        size = float(abs(component[turned.orders == int(name[1])][0]))
        assert row[name] == pytest.approx(size, rel=1e-9)


@pytest.mark.release
def test_the_row_of_a_search_or_of_orders_is_written_as_its_name_says(run: Run) -> None:
    for words in (("orders", "i6"), ("search", "7")):
        for name in ("row.toml", "row.json", "row.xlsx"):
            assert run(*words, "--row", "2", "-o", name).err.endswith(f" {name}\n")
            assert run("check", name).code == 0


def test_an_estimated_engine_is_searched_in_newtons_and_says_so(
    run: Run, refused: Callable[..., str]
) -> None:
    out = run("search", "toyota-2jz", "--estimate", "--limit", "M1=10 kN m").out
    assert "[N m]" in out
    assert "Results are for these typical values, without ranges." in " ".join(out.split())
    assert "has no effect without an engine" in refused("search", "7", "--estimate")


@pytest.mark.release
@pytest.mark.parametrize("unit", ["rpm", "RPM", "Rpm"])
def test_revolutions_per_minute_are_read_in_any_case(run: Run, unit: str) -> None:
    assert (
        "at 6000 rpm" in run("analyze", "toyota-2jz", "--estimate", "--speed", f"6000 {unit}").out
    )
