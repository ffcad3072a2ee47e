"""`crankstar balance`: what is asked for is done, what cannot be done is told in a sentence."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from crankstar import load, spectra, total
from crankstar.mechanics.balance import balance
from crankstar.mechanics.bounds import size
from crankstar.mechanics.remains import summed
from crankstar.remedy import Aim, bearing_load, without_weights

Run = Callable[..., Any]

KNOWN = """
format = 1
name = "three with everything known"
cycle = "four-stroke"
speed = "6000 rpm"
[cylinder]
stroke = "80 mm"
rod_length = "150 mm"
reciprocating_mass = "500 g"
rotating_mass = "400 g"
[layout]
type = "inline"
throws = ["0 deg", "120 deg", "240 deg"]
bore_pitch = "90 mm"
"""
NEWTON_METRES = 0.5 * 0.04 * (6000 * np.pi / 30) ** 2 * 0.09
"""m r ω² a of it at its speed."""


@pytest.fixture
def known(tmp_path: Path) -> str:
    path = tmp_path / "three.toml"
    path.write_text(KNOWN, encoding="utf-8")
    return str(path)


def left(out: str, order: str, what: str) -> list[str]:
    """The greatest value over a turn, before and now."""
    (line,) = [line for line in out.splitlines() if re.match(rf"\s*{order}\s+{what} ", line)]
    (before, now) = re.findall(r"m r\S* ω²(?: a)?\s+(\S+)\s+(\S+)", line)[0]
    return [before, now]


def test_shafts_of_given_ratios_are_added(run: Run) -> None:
    out = run("balance", "i4", "--shafts", "2, -2").out
    assert left(out, "2", "force") == ["1.0161", "0"]  # four times A_2
    assert left(out, "2", "couple") == ["0", "0"]
    assert left(out, "2", "rolling moment") == ["2.0005", "2.0005"]
    assert "balancer -2" in out


def test_shafts_alone_are_those_of_the_lowest_order_that_is_left(run: Run) -> None:
    assert re.findall(
        r"^balancer (\S+) +\S+ +(?:couple|force) ",
        run("balance", "triple-120", "--shafts").out,
        re.MULTILINE,
    ) == ["-1"]
    out = run("balance", "i4", "--shafts", "--shaft-spacing", "3", "--level").out
    assert re.findall(
        r"^balancer (\S+) +\S+ +force +\S+ +\S+ +(\S+) +(\S+)", out, re.MULTILINE
    ) == [("2", "1.9688", "1.5"), ("-2", "-1.9688", "-1.5")]
    assert left(out, "2", "rolling moment")[-1] == "0"
    assert "No primary or secondary force or couple remains." in out
    assert "balancer -2" in run("balance", "triple-120", "--shafts", "all").out


def test_the_card_says_both_ways_of_counting_a_factor(run: Run) -> None:
    rotating = ("--set", "cylinder.rotating_mass=1.2")
    out = " ".join(run("balance", "v2-90", "--factor", "0.5", *rotating).out.split())
    assert "0.5 × reciprocating, of all cylinders on the pin" in out
    assert (
        "As a share of the reciprocating mass of one of the 2 cylinders on a pin, the "
        "balance factor is 1."
    ) in out
    assert "As a share" not in run("balance", "i4").out


def test_weights_are_told_as_masses_at_a_radius(run: Run, known: str) -> None:
    out = run("balance", known, "--factor", "0.5", "--radius", "60 mm").out
    unbalance = (0.4 + 0.25) * 0.040
    assert f"{unbalance * 1000:.5g}" in out
    assert "[kg mm]" in out
    assert f"{unbalance / 0.06 * 1000:.5g}" in out
    assert "with its centre at 60 mm" in out


@pytest.mark.parametrize(
    ("where", "count"), [("pins", 3), ("webs", 6), ("ends", 2), ("-100 mm, 0 mm, 100 mm", 2)]
)
def test_weights_go_where_they_are_wanted_and_do_the_same(
    run: Run, known: str, tmp_path: Path, where: str, count: int
) -> None:
    target = tmp_path / "new.toml"
    run("balance", known, "--weights", where, "-o", str(target))
    engine = load(target)
    assert (
        len(engine.shafts[0].weights) == count
    )  # in the middle of three places there is nothing to do
    one = spectra.selected(total(balance(engine)).couple, [1.0])
    assert abs(one.forward[0]) < 1e-12
    assert abs(one.backward[0]) == pytest.approx(np.sqrt(3) / 2)


def test_best_weights_come_with_their_certificate(run: Run, known: str, tmp_path: Path) -> None:
    target = tmp_path / "best.toml"
    out = " ".join(
        run(
            *("--units", "N m", "balance", known, "--weights", "ends"),
            *("--minimise", "rms couple", "-o", str(target)),
        ).out.split()
    )
    found = re.search(
        r"Rms couple: (\S+) N m; (\S+) N m with bare crankshafts\..* bound .*: (\S+) N m", out
    )
    assert found
    value, bare, bound = (float(number) / NEWTON_METRES for number in found.groups())
    one = total(balance(load(target))).couple
    assert value == pytest.approx(
        float(np.sqrt((np.abs(one.forward) ** 2 + np.abs(one.backward) ** 2).sum())), rel=1e-4
    )
    assert bare == pytest.approx(without_weights(load(known), Aim("couple", rms=True)), rel=1e-4)
    assert value == pytest.approx(bound, rel=1e-4)


@pytest.mark.release
def test_limits_in_newtons_in_shares_and_bare_are_one_limit(run: Run, known: str) -> None:
    bare = float(without_weights(load(known), Aim("couple")))
    newtons = 0.8 * bare * NEWTON_METRES
    told = re.compile(r"Limit of peak couple: (\S+) N m of (\S+) N m, not reached")
    ask = ("--units", "N m", "balance", known, "--weights", "webs", "--minimise", "bearing")
    shown = [
        told.search(" ".join(run(*ask, *given).out.split()))
        for given in (
            ("--limit", "couple=80%"),
            ("--limit", f"couple={newtons!r} N m"),
            ("--limit", f"couple={0.8 * bare!r}"),
            ("--limit", f"couple={4 * newtons!r} N m", "--speed", "12000 rpm"),
        )
    ]
    told_of = [tuple(map(float, found.groups())) for found in shown if found]
    at_speed = [tuple(each) for each in (*told_of[:3], np.array(told_of[3]) / 4)]
    assert at_speed == [pytest.approx((at_speed[0][0], newtons), rel=1e-4)] * 4
    assert 0 < at_speed[0][0] < newtons


@pytest.mark.release
def test_a_couple_is_not_bought_with_a_force(run: Run, tmp_path: Path) -> None:
    target = tmp_path / "vr6.toml"
    out = run(
        "balance", "vw-vr6", "--weights", "ends", "--minimise", "couple", "-o", str(target)
    ).out
    assert "The rms force is kept at or below that of bare crankshafts" in " ".join(out.split())
    force = total(balance(load(target))).force
    rms = float(np.sqrt((np.abs(force.forward) ** 2 + np.abs(force.backward) ** 2).sum()))
    assert rms == pytest.approx(without_weights(load("vw-vr6"), Aim("force", rms=True)), rel=1e-6)


def test_the_proof_is_printed(run: Run) -> None:
    out = " ".join(run("balance", "v8-cross-plane", "--weights", "ends", "--prove").out.split())
    assert "u₁ = (2√10/7) m r ∠ (−π + atan 2)" in out
    assert out.count("the residual is proved to vanish") == 1
    three = run("balance", "triple-120", "--weights", "pins", "--shafts", "all", "--prove").out
    assert three.count("the residual is proved to vanish") == 4  # the crankshaft, -1, 2 and -2
    assert "proved" not in run("balance", "triple-120", "--factor", "0.3", "--prove").out


@pytest.mark.release
@pytest.mark.parametrize("name", ["vw-vr6", "napier-deltic", "i4", "harley-45"])
def test_the_command_that_the_verdict_prints_fits_what_it_recommends(
    run: Run, tmp_path: Path, name: str
) -> None:
    target = tmp_path / "fitted.toml"
    verdict = " ".join(run("verdict", name).out.split())
    command = re.search(r"what remains: crankstar (balance .*)$", verdict)
    assert command
    out = run(*command[1].split(), "-o", str(target)).out
    after, before = (summed(balance(load(engine))) for engine in (target, name))
    order = next(
        order
        for order in (1.0, 2.0)
        if size(before.force, order) > 1e-9 or size(before.couple, order) > 1e-9
    )
    for quantity in ("force", "couple"):
        assert size(getattr(after, quantity), order) < 1e-9
        assert left(out, f"{order:g}", quantity)[1] == "0"
    rest = run("verdict", str(target)).out
    assert ("what remains:" in rest) == (size(after.force, 2.0) + size(after.couple, 2.0) > 1e-9)


@pytest.mark.many(first=46)
@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--shafts", "3"], "leave the shaft out"),
        (["--shafts", "x"], "speed ratios"),
        (["--shafts", "1/0"], "speed ratios"),
        (["--shafts", ""], "speed ratios"),
        (["--shafts", "-1"], "leave the shaft out"),
        (["--shafts", "2", "--level"], "no pair of balance shafts"),
        (["--shafts", "2", "--box", "1..2"], "give up and right"),
        (["--shafts", "2", "--box", "1..x, 2"], "--box"),
        (["--shafts", "2", "--box", "2..1, 0..1"], "the smaller length first"),
        (["--shafts", "2", "--box", "1 mm..2 kg, 0..1"], "--box"),
        (["--shafts", "2", "--box", "1, 2", "--box", "1, 2"], "2 boxes for 1 balance shaft"),
        (["--shafts", "2", "--box", "1, 2", "--level"], "--level has no effect with --box"),
        (["--box", "1, 2"], "--box: the engine file has no balance shafts to place"),
        (["--shafts", "2", "--shaft-spacing", "3"], "no pair of balance shafts"),
        (["--weights", "0,1e-15"], "closer than"),
        (["--minimise", "force", "--limit", "force=1_0"], "is not known; a force is needed"),
        (["--radius", "1e-300"], "it is too small; give 1e-07 r or more"),
        (["--shafts", "2,-2", "--shaft-place", "1"], "up and right"),
        (["--shafts", "2,-2", "--shaft-place", "a, b"], "--shaft-place"),
        (["--shafts", "2,-2", "--shaft-planes", "x"], "--shaft-planes"),
        (["--shafts", "2,-2", "--shaft-planes", "1, 1"], "all different"),
        (["--shaft-spacing", "3"], "--shaft-spacing has no effect without --shafts"),
        (["--level"], "--level has no effect without --shafts"),
        (["--weights", "0"], "two planes or more"),
        (["--weights", "0, x"], "--weights"),
        (["--weights", "0, 9"], "beyond the crankshaft"),
        (["--weights", "somewhere"], "pins, webs, ends"),
        (["--factor", "310%"], "from -1 to 3"),
        (["--factor", "-1.1"], "from -1 to 3"),
        (["--factor", "nan"], "as in 0.5 or 52%"),
        (["--factor", "5 kg"], "as in 0.5 or 52%"),
        (["--factor", "0.5", "--minimise", "force"], "--factor has no effect with --minimise"),
        (["--limit", "force=1"], "--limit has no effect without --minimise"),
        (["--minimise", "noise"], "choose from force, couple"),
        (["--minimise", "force", "--limit", "force"], "give a quantity and its limit"),
        (["--minimise", "force", "--limit", "noise=3"], "choose from force, couple"),
        (["--minimise", "force", "--limit", "force=-3"], "from 0 up"),
        (["--minimise", "force", "--limit", "force=nan"], "from 0 up"),
        (
            ["--minimise", "force", "--limit", "force=500 N"],
            "masses and sizes of this engine are not known",
        ),
        (["--minimise", "force", "--limit", "force=500 kg"], "a force is needed"),
        (["--minimise", "couple", "--limit", "force=0.5"], "cannot be met with these planes"),
        (["--minimise", "couple", "--pitch-share", "2"], "from 0 (only yaw counts) to 1"),
        (
            ["--minimise", "bearing", "--pitch-share", "0.5"],
            "--pitch-share has no effect with --minimise bearing",
        ),
        (["--minimise", "couple", "--greatest-unbalance", "0"], "greater than 0"),
        (["--minimise", "couple", "--greatest-unbalance", "1e-12"], "give a larger one"),
        (["--minimise", "couple", "--greatest-unbalance", "1e-200"], "too large or too small"),
        (["--minimise", "couple", "--greatest-unbalance", "x"], "--greatest-unbalance"),
        (["--recommended", "--factor", "0.5"], "--factor has no effect with --recommended"),
        (["--recommended", "--weights", "ends"], "--weights has no effect with --recommended"),
        (["--radius", "0"], "greater than 0"),
        (["--radius", "60 mm"], "the file gives no stroke"),
    ],
)
def test_what_cannot_be_balanced_is_refused(
    refused: Callable[..., str], arguments: list[str], told: str
) -> None:
    assert told in refused("balance", "i4", *arguments)


def test_nothing_is_recommended_where_nothing_remains(refused: Callable[..., str]) -> None:
    assert "no primary or secondary force or couple" in refused("balance", "i6", "--recommended")


@pytest.mark.release
def test_standard_output_that_is_a_file_is_not_replaced(known: str, tmp_path: Path) -> None:
    log = tmp_path / "log.txt"
    log.write_text("precious\n", encoding="utf-8")
    command = f"{sys.executable} -m crankstar"
    for words in (f"balance {known} -o -", "verdict i4 -o /dev/stdout", "plot i4 crank-star -o -"):
        subprocess.run(f"{command} {words} >> {log}", shell=True, check=True)  # noqa: S602
    text = log.read_text(encoding="utf-8")
    assert text.startswith("precious\nformat = 1")
    assert "Four in line" in text
    assert "<svg" in text


def test_the_factor_of_the_file_is_kept_unless_another_is_asked_for(run: Run, known: str) -> None:
    assert (
        "rotating + 0.75 × reciprocating"
        in run("balance", known, "--set", "balance_factor=0.75").out
    )
    assert "rotating + 0.5 × reciprocating" in run("balance", known).out
    assert (
        "rotating + 0.3 × reciprocating"
        in run("balance", known, "--set", "balance_factor=0.75", "--factor", "0.3").out
    )


@pytest.mark.release
def test_what_is_left_is_told_in_newtons_where_a_speed_is_known(run: Run, known: str) -> None:
    out = run("balance", known).out
    assert "Remaining unbalance at 6000 rpm" in out
    newtons = 0.5 * 0.04 * (6000 * np.pi / 30) ** 2 * 0.09 * np.sqrt(3) / 2
    assert f"{newtons:.5g}" in next(
        line for line in out.splitlines() if re.match(r" *1 +couple ", line)
    )
    twice = run("balance", known, "--speed", "12000 rpm").out
    assert f"{4 * newtons:.5g}" in next(
        line for line in twice.splitlines() if re.match(r" *1 +couple ", line)
    )


@pytest.mark.release
def test_weights_that_make_it_worse_are_said_to(run: Run) -> None:
    assert "make the couple of order 1 larger than before" in run("balance", "napier-deltic").out
    assert "larger than before" not in run("balance", "v8-cross-plane").out


@pytest.mark.release
def test_the_longest_engine_has_room_for_weights_on_all_its_webs(run: Run, tmp_path: Path) -> None:
    count = 256
    throws = ", ".join('"0 deg"' for _ in range(count))
    file = tmp_path / "long.toml"
    layout = f'type = "inline"\nthrows = [{throws}]'
    file.write_text(
        f'format = 1\nname = "long"\ncycle = "two-stroke"\n[layout]\n{layout}\n', encoding="utf-8"
    )
    target = tmp_path / "w.toml"
    run("balance", str(file), "--weights", "webs", "-o", str(target))
    assert len(load(target).shafts[0].weights) == 2 * count
    assert "counterweights remove" in run("analyze", str(file), "--orders", "1").out


@pytest.mark.release
def test_the_card_tells_the_load_on_the_bearings(run: Run) -> None:
    """Of a flat four the middle bearing has half of each inner pin, which push together.

    Half the mass halves what goes to and fro. The side thrust, 0.0328 across, is what a circle of
    weights can still trade for it: least is half the difference.
    """
    loads = next(
        line.split()[-2:]
        for line in run("balance", "i4").out.splitlines()
        if "load on a main bearing" in line
    )
    assert loads == ["1", "0.5"]
    best = run("balance", "i4", "--weights", "webs", "--minimise", "bearing").out
    found = re.search(
        r"Greatest load on a main bearing: (\S+) m r ω²; 1 m r ω² with bare crankshafts",
        " ".join(best.split()),
    )
    assert found
    assert float(found.group(1)) == pytest.approx((1 - 0.032796) / 2, abs=1e-4)


@pytest.mark.release
def test_a_shaft_that_takes_a_force_has_its_weight_in_the_middle(run: Run) -> None:
    assert (
        len(re.findall(r"^balancer -?2 +0 ", run("balance", "i4", "--shafts").out, re.MULTILINE))
        == 2
    )
    assert (
        len(
            re.findall(
                r"^balancer -1 +-?1\.5 ", run("balance", "triple-120", "--shafts").out, re.MULTILINE
            )
        )
        == 2
    )
    assert (
        "--shaft-place and --shaft-spacing give the real place"
        in run("balance", "i4", "--shafts").out
    )
    assert (
        "--shaft-place and --shaft-spacing give the real place"
        not in run("balance", "i4", "--shafts", "--shaft-spacing", "3").out
    )


GEARED = """
format = 1
name = "geared"
[[shaft]]
name = "crank"
throw = [{ angle = "0 deg", radius = "40 mm" }]
[[shaft]]
name = "other"
speed_ratio = "-997/1000"
right = "200 mm"
throw = [{ angle = "0 deg", radius = "40 mm" }]
[[cylinders]]
number = 1
shaft = "crank"
throw = 1
rod_length = "150 mm"
reciprocating_mass = "500 g"
[[cylinders]]
number = 2
shaft = "other"
throw = 1
rod_length = "150 mm"
reciprocating_mass = "500 g"
"""


def test_peaks_of_a_period_too_long_to_follow_are_refused_and_rms_is_not(
    run: Run, refused: Callable[..., str], tmp_path: Path
) -> None:
    file = tmp_path / "geared.toml"
    file.write_text(GEARED, encoding="utf-8")
    assert "minimise the rms instead" in refused("balance", str(file), "--minimise", "force")
    assert "Rms force" in run("balance", str(file), "--minimise", "rms force").out


@pytest.mark.release
def test_weights_that_are_replaced_are_counted(run: Run, known: str, tmp_path: Path) -> None:
    weighted = str(tmp_path / "weighted.toml")
    run("balance", known, "--weights", "ends", "-o", weighted)
    out = run("balance", weighted, "--factor", "0.3", "--bare").out
    assert "2 counterweights of the file are replaced." in out
    assert "replaced" not in run("balance", weighted, "--factor", "0.3").out
    assert "replaced" not in run("balance", known).out


@pytest.mark.release
def test_loads_and_moments_are_in_newtons_at_a_speed(run: Run, known: str) -> None:
    out = run("balance", known, "--shafts", "-1", "--shaft-place", "-60 mm, 0 mm").out
    assert "m r" not in out[out.index("Balance shafts") :]
    (line,) = [line for line in out.splitlines() if "greatest load on a main bearing" in line]
    unit = 0.5 * 0.040 * (6000 * np.pi / 30) ** 2
    assert float(line.split()[-2]) == pytest.approx(bearing_load(load(known)) * unit, rel=1e-4)


@pytest.mark.release
def test_weights_that_are_best_are_not_said_to_be_wrong(run: Run) -> None:
    arguments = ("v8-cross-plane", "--weights", "webs", "--minimise", "bearing")
    assert "counterweights" not in run("balance", *arguments).out.partition("Further")[2]


def test_what_counterweights_remove_is_in_newtons_at_a_speed(run: Run, known: str) -> None:
    """Cranks 120 deg apart: sqrt(3) r w^2 a times half the pistons; forward also what turns."""
    out = " ".join(run("analyze", known).out.split())
    found = re.search(r"counterweights remove (\S+) N m; (\S+) N m remains", out)
    assert found
    unit = np.sqrt(3) * 0.040 * 0.090 * (6000 * np.pi / 30) ** 2
    assert [float(size) / unit for size in found.groups()] == pytest.approx([0.65, 0.25], rel=1e-4)


@pytest.mark.release
@pytest.mark.parametrize("verb", [["balance", "i4"], ["estimate", "toyota-2jz"]])
def test_an_engine_is_written_as_the_name_of_its_file_says(
    run: Run, verb: list[str], tmp_path: Path
) -> None:
    engines = []
    for suffix in ("toml", "json", "xlsx"):
        place = tmp_path / f"out.{suffix}"
        run(*verb, "-o", str(place))
        engines.append(load(place))
    assert json.loads((tmp_path / "out.json").read_text(encoding="utf-8"))["name"]
    forces = [total(balance(engine)).force.forward for engine in engines]
    assert forces[0] == pytest.approx(forces[1], rel=1e-12)
    assert forces[0] == pytest.approx(forces[2], rel=1e-9)
    for suffix in ("csv", "png", "xyz"):
        place = tmp_path / f"out.{suffix}"
        done = run(*verb, "-o", str(place))
        assert done.code == 2
        assert "the name must end in .toml, .json or .xlsx" in done.err
        assert not place.exists()


@pytest.mark.release
def test_a_shaft_stands_at_a_place_without_rounding_errors(run: Run, tmp_path: Path) -> None:
    file, place = tmp_path / "twin.toml", tmp_path / "out.toml"
    text = KNOWN.replace(
        'throws = ["0 deg", "120 deg", "240 deg"]', 'throws = ["0 deg", "270 deg"]'
    )
    file.write_text(text, encoding="utf-8")
    box = "-150..150 mm, -150..150 mm"
    run("balance", str(file), "--shafts", "-1", "--box", box, "-o", str(place))
    shaft = load(place).shafts[-1]
    assert abs(shaft.up) > 1e-4
    assert shaft.right == 0.0


@pytest.mark.release
def test_a_sweep_of_the_factor_of_an_engine_with_weights_says_that_they_add(run: Run) -> None:
    note = "The engine file has weights on the crankshaft; those of the balance factor are added"
    over = ("--over", "balance_factor=0..1/3", "--quantity", "force")
    run("balance", "single", "--factor", "0.5", "-o", "half.toml")
    assert note in " ".join(run("sweep", "half.toml", *over).out.split())
    assert note not in " ".join(run("sweep", "single", *over).out.split())


@pytest.mark.parametrize("planes", ["ends", "2.2,-1.3"])
def test_a_crankshaft_that_balances_itself_gets_no_weights_of_rounding(
    run: Run, planes: str
) -> None:
    told = run("balance", "i6", "--factor", "0.5", "--weights", planes).out
    assert not re.search(r"\de-\d\d", told)
    assert "No weights." in told


@pytest.mark.release
def test_an_option_without_effect_here_is_marked(run: Run) -> None:
    """No weights to take away, nothing to prove, nothing left out of the file."""
    case = str(Path(__file__).parents[1] / "cases" / "genset-four.toml")
    told = run("balance", case, "--bare", "--prove").err.splitlines()
    assert [line.partition(" ")[0] for line in told] == ["--prove", "--bare"]
    marine = str(Path(__file__).parents[1] / "cases" / "marine-seven.toml")
    assert run("torque", marine, "--estimate").err.startswith("--estimate changes nothing")
    assert not run("balance", "single", "--factor", "0.5", "--prove").err
