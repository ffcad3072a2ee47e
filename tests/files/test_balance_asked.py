"""`crankstar balance` fits what is asked for and no more, and says what it leaves."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from crankstar import load, spectra, total
from crankstar.cli.options import read_engine
from crankstar.mechanics.balance import balance
from crankstar.page.exhibits import advised, remedy_tables
from crankstar.page.figures import fitted_spread
from crankstar.remedy.fitting import recommended

Run = Callable[..., Any]

TWIN = """
name = "twin"
cycle = "four-stroke"
speed = "7000 rpm"
[cylinder]
stroke = "75 mm"
rod_length = "140 mm"
reciprocating_mass = "450 g"
rotating_mass = "380 g"
[layout]
type = "inline"
throws = ["0 deg", "0 deg"]
bore_pitch = "95 mm"
"""
TRIPLE = """
name = "three of masses not known well"
cycle = "four-stroke"
speed = "7000 rpm"
[cylinder]
stroke = "70 mm"
rod_length = "125 mm"
reciprocating_mass = "400 g"
rotating_mass = "300 g"
[layout]
type = "inline"
throws = ["0 deg", "120 deg", "240 deg"]
bore_pitch = "85 mm"
[provenance]
"cylinder.reciprocating_mass" = { status = "estimated", source = "a guess", range = [0.8, 1.25] }
"layout.bore_pitch" = { status = "estimated", source = "a guess", range = [0.9, 1.1] }
"""


@pytest.fixture
def twin(tmp_path: Path) -> str:
    path = tmp_path / "twin.toml"
    path.write_text(TWIN, encoding="utf-8")
    return str(path)


def words(out: str) -> str:
    return " ".join(out.split())


def table(out: str, title: str) -> str:
    """The table of that title."""
    return out.split(f"\n{title}\n")[1].split("\n\n")[0]


def test_shafts_alone_leave_the_crankshafts_as_they_are(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "pair.toml"
    out = run("balance", "man-s90mc-c", "--shafts", "2, -2", "-o", str(file)).out
    pair, bare = load(file), load("man-s90mc-c")
    assert [shaft.weights for shaft in pair.shafts if shaft.throws] == [()]
    first = [spectra.selected(total(balance(each)).couple, 1.0) for each in (pair, bare)]
    assert abs(first[0].forward[0]) == pytest.approx(abs(first[1].forward[0]), rel=1e-12)
    assert "The crankshafts stay as they are" in out
    assert "Bobweight" not in out
    assert "crank" not in table(out, "Weights").split("Mass:")[0]


@pytest.mark.many(first=3)
@pytest.mark.parametrize(
    "more", [["--factor", "0.5"], ["--weights", "webs"], ["--bare"], ["--minimise", "force"]]
)
def test_each_option_of_counterweights_fits_them_beside_shafts(run: Run, more: list[str]) -> None:
    out = run("balance", "single", "--shafts", "-1", *more).out
    assert re.search(r"^crank ", table(out, "Weights"), re.MULTILINE)


def test_half_the_primary_force_turns_backward_and_one_shaft_takes_it(run: Run) -> None:
    out = run("balance", "single", "--shafts", "-1").out
    assert re.search(r"^ +1  force +m r ω² +1 +0.5 +0.5 +0$", out, re.MULTILINE)


def test_counterweights_and_balance_shafts_have_a_radius_each(run: Run, twin: str) -> None:
    given = ["--factor", "0.5", "--shafts", "-1", "--radius", "60 mm"]
    one = run("balance", twin, *given).out
    two = run("balance", twin, *given, "--shaft-radius", "30 mm").out
    shaft = re.compile(r"^balancer -1 .* (\S+)$", re.MULTILINE)
    first, second = (float(shaft.findall(table(out, "Weights"))[0]) for out in (one, two))
    assert (first, second) == pytest.approx((16875 / 37.5, 16875 / 30))
    assert "at 60 mm, on balance shafts at the crank radius" in words(one)
    assert "at 60 mm, on balance shafts at 30 mm" in words(two)


def test_a_radius_of_nothing_is_refused(refused: Callable[..., str]) -> None:
    assert "--radius has no effect" in refused("balance", "i4", "--shafts", "--radius", "1.5")
    assert "--shaft-radius has no effect" in refused("balance", "i4", "--shaft-radius", "1")


def test_a_shaft_with_nothing_to_do_is_left_out_and_told(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "after.toml"
    out = run("balance", "i4", "--shafts", "-1, 2, -2", "-o", str(file)).out
    assert "No shaft of speed ratio -1 is added: it would have nothing to do." in out
    assert [str(shaft.speed_ratio) for shaft in load(file).shafts] == ["1", "2", "-2"]


@pytest.mark.release
def test_what_the_recommended_remedy_leaves_is_told_and_cured(run: Run) -> None:
    out = words(run("balance", "single", "--recommended").out)
    assert re.search(r"2 force m r ω² 0.25403 0.25403", out)
    command = re.search(r"To fit these too: crankstar (balance .*)$", out)
    assert command
    after = run(*command[1].split()).out
    assert "No primary or secondary force or couple remains." in after
    assert "would be inside" not in after


@pytest.mark.release
def test_the_greater_moment_that_the_remedy_leaves_is_named_first(run: Run) -> None:
    """Of the seven 0.8516 of order 1 is removed and A_2 5.5222 = 1.4028 of order 2 is left."""
    first, _line, rest = run("balance", "sinitsyn-7-first", "--recommended").out.partition("\n\n")
    assert "The couple of order 2 remains, and is greater than that of order 1" in words(first)
    assert re.search(r"2 couple m r ω² a 1.4028 1.4028", words(rest))
    whole = run("balance", "sinitsyn-7-first", "--recommended", "--shafts", "all").out
    assert "greater than that of order" not in words(whole)
    assert "greater than that of order" not in words(run("balance", "i4", "--recommended").out)


@pytest.mark.release
def test_a_remedy_has_one_form_over_the_ranges_of_masses(run: Run, tmp_path: Path) -> None:
    file, after = tmp_path / "three.toml", tmp_path / "once.toml"
    file.write_text(TRIPLE, encoding="utf-8")
    run("balance", str(file), "--recommended", "-o", str(after))
    out = run("balance", str(after), "--recommended").out
    weights, shafts = table(out, "Weights"), table(out, "Balance shafts")
    assert re.findall(r"^(balancer \S+) ", shafts, re.MULTILINE) == [
        "balancer -1",
        "balancer 2",
        "balancer -2",
    ]
    assert "(0 to" not in weights + shafts
    assert "to 0)" not in weights + shafts
    assert "no. 2" not in out
    # the weights of the first remedy are made: lighter and heavier pistons leave a primary couple
    assert re.search(r"^ +1  couple +N m +0 \(0 to \S+\) +0 \(0 to ", out, re.MULTILINE)


@pytest.mark.release
def test_the_tables_and_figures_of_the_page_keep_that_form_too(run: Run, tmp_path: Path) -> None:
    file = tmp_path / "three.toml"
    file.write_text(TRIPLE, encoding="utf-8")
    run("balance", str(file), "--recommended", "-o", "once.toml")
    once = read_engine("once.toml")
    engine, spread = once.engine, once.spread
    fitted = recommended(engine)
    assert fitted
    assert spread
    tables = remedy_tables(engine, advised, spread)
    (shafts,) = [each for each in tables if each.title == "Balance shafts"]
    assert "(0 to" not in str(shafts)
    assert len(shafts.rows) == 3
    drawn = fitted_spread(spread, fitted, fitted.after)
    assert drawn
    names = [shaft.name for shaft in fitted.after.shafts]
    assert all([shaft.name for shaft in each.shafts] == names for each in drawn.engines)


@pytest.mark.many(first=1)
@pytest.mark.parametrize("option", ["--shaft-planes", "--weights"])
def test_lengths_of_an_engine_without_lengths_have_no_unit(
    refused: Callable[..., str], run: Run, option: str
) -> None:
    beside = ["--shafts", "-1"] if option == "--shaft-planes" else []
    told = refused("balance", "single", *beside, option, "-200 mm, 200 mm")
    assert f'{option} is "-200 mm", but the file gives no stroke' in told
    assert 'as in "' not in told
    out = run("balance", "single", *beside, option, "-1.5, 1.5").out
    assert len(re.findall(r"^\S.* -?1\.5 .*0\.25$", table(out, "Weights"), re.MULTILINE)) == 2


def test_a_weight_far_beyond_the_engine_is_remarked(run: Run, twin: str) -> None:
    far = run("balance", twin, "--shafts", "-1", "--shaft-planes", "9 m, -0.2 m").out
    assert "A weight of balancer -1 is at z = 9000 mm, far beyond the crankshaft" in words(far)
    assert "far beyond" not in run("balance", twin, "--shafts", "-1").out


def test_what_was_just_done_is_not_advised(refused: Callable[..., str]) -> None:
    told = refused("balance", "i4", "--minimise", "roll", "--shafts", "--box", "-3..-2, -1..1")
    assert "leave --minimise out" in told


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (["--minimise", "force", "--limit", "couple=50%", "--limit", "couple=1"], "already has a"),
        (["--shafts", "--box", "-60..-120 mm, 0..1 mm"], 'as in "-120 mm..-60 mm"'),
        (["--factor", "50"], "for 50 % write 50% or 0.5"),
    ],
)
def test_slips_are_refused_with_what_was_meant(
    refused: Callable[..., str], options: list[str], told: str
) -> None:
    assert told in refused("balance", "honda-b18c", *options)


@pytest.mark.release
def test_limits_that_leave_next_to_no_room_still_have_a_best_answer(run: Run) -> None:
    out = words(
        run("balance", "kr250-racer", "--bare", "--minimise", "roll 1", "--limit", "force=100%").out
    )
    found = re.search(r"Roll of order 1: (\S+) m r² ω²; (\S+) .* limits: (\S+) m r² ω²\.", out)
    assert found
    value, bare, bound = map(float, found.groups())
    assert bound <= value <= bare
    assert value - bound < 1e-3 * bare


@pytest.mark.release
def test_a_name_does_not_pile_up_what_was_done(run: Run, twin: str, tmp_path: Path) -> None:
    half, again, other = (str(tmp_path / name) for name in ("half.toml", "again.toml", "o.toml"))
    run("balance", twin, "--factor", "0.5", "-o", half)
    run("balance", half, "--factor", "0.5", "-o", again)
    run("balance", again, "--factor", "0.6", "--shafts", "-1", "-o", other)
    assert load(again).name == "twin, balance factor 0.5"
    assert load(other).name == "twin, balance factor 0.6, balance shafts: -1"
    run("balance", again, "--shafts", "-1", "-o", other)
    assert load(other).name == "twin, balance factor 0.5, balance shafts: -1"


def test_a_limit_that_the_balance_shafts_do_not_keep_is_refused(run: Run, tmp_path: Path) -> None:
    file, place = tmp_path / "opposed.toml", tmp_path / "out.toml"
    file.write_text(TWIN.replace('"0 deg", "0 deg"', '"0 deg", "180 deg"'), encoding="utf-8")
    asked = ["balance", str(file), "--minimise", "couple", "--weights", "ends", "-o", str(place)]
    ended = run(*asked, "--limit", "yaw=0 N m", "--shafts", "needed")
    assert ended.code == 2
    assert "with the balance shafts" in ended.err
    assert not place.exists()
    run(*asked, "--limit", "yaw=0 N m")
    kept = balance(load(place))
    (yaw,) = abs(spectra.horizontal(spectra.selected(total(kept).couple, 1.0)))
    assert yaw < 1e-6


@pytest.mark.release
def test_external_moments_are_named_as_makers_of_large_engines_do(run: Run) -> None:
    by_word = run("balance", "triple-120", "--minimise", "pitch 1", "--limit", "yaw 1=1.5").out
    made = run("balance", "triple-120", "--minimise", "M1V", "--limit", "m1h <= 1.5").out
    assert made == by_word
    rows = table(made, "Remaining unbalance").splitlines()
    assert [row.split()[-1] for row in rows if "pitch M_V" in row or "yaw M_H" in row] == [
        *("0.23205", "1.5"),
        *("0.43998", "0"),
    ]
    assert "M_V" not in run("balance", "triple-120", "--minimise", "couple").out


def test_a_quantity_that_is_none_is_quoted_as_it_was_typed(run: Run) -> None:
    said = words(run("balance", "triple-120", "--minimise", "M1X").err)
    assert "--minimise M1X: choose from force," in said
    assert "roll 1, M1, M1V, M1H, F1, F1V, F1H" in said
    assert (
        "--limit F0V: give an order above 0"
        in run("balance", "triple-120", "--minimise", "M1V", "--limit", "F0V=1").err
    )
