"""An option with a value that changes nothing in a call is refused, or marked: none is ignored."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.commands import Run
from tests.files.test_machine_tables import FOUR

SPEED = "--speed=2000 rpm"
ASKED = (
    ("analyze FILE", SPEED, "--orders=2", "--reference=40 mm", "--by=cylinder", "--theta=20 deg"),
    ("analyze i4", SPEED),
    ("verdict i4", SPEED),
    ("verdict FILE", SPEED),
    ("compare FILE i4", SPEED, "--orders=2"),
    ("balance i4", SPEED, "--factor=0.4"),
    ("balance FILE", SPEED, "--factor=0.4", "--weights=ends", "--shafts=2, -2"),
    ("bearings i4", SPEED),
    ("bearings FILE", SPEED, "--orders=2", "--model=continuous", "--off=1"),
    ("bobweight FILE", "--factor=0.4"),
    ("derive FILE", SPEED, "--power=4"),
    ("fault FILE --cut 1", SPEED, "--orders=0.5"),
    ("genset FILE", SPEED, "--irregularity=0.02"),
    ("marine FILE", SPEED, "--orders=2"),
    ("mounts FILE", SPEED, "--speeds=1000..2000 rpm/3"),
    ("sweep i4 --over cylinder.rod_ratio=3..4/3", SPEED, "--orders=2"),
    ("sweep FILE --over speed=1000..3000/3", SPEED),
    ("tolerance FILE", SPEED, "--orders=2"),
    ("torque FILE", SPEED, "--orders=2", "--irregularity=0.02", "--off=1", "--weaker=1=20 %"),
    ("torsion FILE", SPEED, "--speeds=1000..2000 rpm/3", "--orders=2", "--modes=2", "--holzer=1"),
)


@pytest.mark.release
@pytest.mark.parametrize("asked", ASKED, ids=lambda asked: asked[0])
def test_an_option_with_a_value_has_an_effect_or_says_that_it_has_none(
    run: Run, tmp_path: Path, asked: tuple[str, ...]
) -> None:
    (tmp_path / "four.toml").write_text(FOUR, encoding="utf-8")
    command, *options = asked
    words = command.replace("FILE", "four.toml").split()
    words = [f"{word[:-2]} rpm/3" if word.endswith("3000/3") else word for word in words]
    plain = run(*words)
    assert plain.code == 0
    for option in options:
        name, _equals, value = option.partition("=")
        there = run(*words, name, value)
        marked = f"{name} changes nothing" in there.err
        assert there.code == 2 or marked or there.out != plain.out, option


def test_a_speed_without_masses_is_marked_with_what_is_missing(run: Run) -> None:
    told = run("analyze", "i4", "--speed", "3000 rpm").err
    assert told.startswith("--speed changes nothing here")
    assert "cylinder.reciprocating_mass, cylinder.stroke" in told
    assert not run("analyze", "audi-25-tfsi", "--speed", "3000 rpm").err


@pytest.mark.parametrize("verb", ["torque", "genset"])
@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("--off", "3", "--weaker", "3=10%"), "cylinder 3 is --off"),
        (("--weaker", "3=10%", "--weaker", "3=20%"), "cylinder 3 stands twice"),
    ],
)
def test_what_a_cylinder_lacks_is_given_once(
    run: Run, verb: str, words: tuple[str, ...], said: str
) -> None:
    ran = run(verb, "audi-25-tfsi", *words)
    assert (ran.code, ran.out) == (2, "")
    assert said in ran.err


@pytest.mark.parametrize("quantity", ["motion", "gas", "twist", "motion,gas"])
@pytest.mark.parametrize("symbol", ["phi", "n"])
def test_a_symbol_beside_what_has_no_orders_is_refused(
    run: Run, quantity: str, symbol: str
) -> None:
    ran = run("derive", "i4", "--quantity", quantity, "--symbolic", symbol)
    assert (ran.code, ran.out) == (2, "")
    assert "--symbolic" in ran.err


@pytest.mark.parametrize(
    ("quantity", "option"),
    [
        ("force", "--reference=0.5"),
        ("force,motion", "--reference=0.5"),
        ("gas,twist", "--reference=0.5"),
        ("gas,twist", "--power=4"),
        ("motion,gas", "--speed=1000 rpm"),
    ],
)
def test_an_option_of_other_quantities_is_refused(run: Run, quantity: str, option: str) -> None:
    name, _equals, value = option.partition("=")
    ran = run("derive", "i4", "--quantity", quantity, name, value)
    assert (ran.code, ran.out) == (2, "")
    assert name in ran.err


def test_a_notation_that_is_used_anyway_is_marked(run: Run) -> None:
    for words in (("--signs", "--notation", "sinitsyn"), ("--notation", "crankstar")):
        assert "--notation changes nothing" in run("derive", "i4", *words).err
    assert not run("derive", "i4", "--signs").err
