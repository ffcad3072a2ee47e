"""What is refused is quoted as it was typed, with its place and with what would do."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest
from tests.commands import Run

I4 = """format = 1
name = "Four"
firing_order = [1, 3, 4, 2]
cylinder = { stroke = "90 mm", rod_length = "145 mm", reciprocating_mass = "500 g" }
layout = { type = "inline", bore_pitch = "94 mm" }
"""


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["balance", "i4", "--shafts", "-"], "--shafts -: give speed ratios"),
        (["balance", "i4", "--weights", "-"], "--weights -: it can be pins"),
        (
            ["balance", "four.toml", "--radius", "1e-9 m"],
            "--radius 1e-9 m: it is too small; give 0.0001 mm or more",
        ),
        (
            ["balance", "four.toml", "--shafts", "all", "--box", "-1e9..1e9 mm, 0 mm"],
            '--box is "-1e9 mm", too large',
        ),
        (
            ["estimate", "toyota-2jz", "--set", 'cylinder.bore="1 um"'],
            "it is estimated from a bore of 0.001 mm and a stroke of 86 mm: correct cylinder.bore",
        ),
    ],
)
def test_a_wrong_option_is_told_with_what_would_do(
    refused: Callable[..., str], words: list[str], told: str
) -> None:

    Path("four.toml").write_text(I4, encoding="utf-8")
    assert told in " ".join(refused(*words).split())


RANGE = '[provenance]\n"cylinder.reciprocating_mass" = { status = "estimated", range = %s }\n'


@pytest.mark.parametrize(
    ("more", "told"),
    [
        (
            RANGE % "[1.5]",
            'provenance."cylinder.reciprocating_mass".range is [1.5]; give two multiples of the',
        ),
        (RANGE % "[]", ".range is []; give two multiples"),
        (RANGE % '["a", 2]', '.range is ["a", 2]; give multiples of the value without a unit'),
        (RANGE % '["0.9"]', ".range is [0.9]; give two multiples"),
        (
            '[[crankshaft]]\nbearings = ["141 mm", "94 mm", "0 mm", "-94 mm", "-188 mm"]\n',
            "is 0.141 m, the place of crank pin 1",
        ),
    ],
)
def test_a_wrong_value_of_a_file_is_told_with_its_unit(run: Run, more: str, told: str) -> None:

    Path("four.toml").write_text(f"{I4}{more}", encoding="utf-8")
    assert told in " ".join(run("check", "four.toml").err.split())


def test_too_many_ranges_are_named_with_what_to_do(run: Run) -> None:
    throws = "".join(
        f'[[shaft.throw]]\nangle = "{90 * n} deg"\nradius = "45 mm"\nz = "{-94 * n} mm"\n'
        for n in range(9)
    )
    cylinders = "".join(
        f'[[cylinders]]\nnumber = {n + 1}\nthrow = {n + 1}\nz = "{-94 * n} mm"\n'
        'rod_length = "145 mm"\nreciprocating_mass = "0.5 kg"\n'
        for n in range(9)
    )
    source = 'status = "estimated", range = [0.9, 1.1]'
    ranges = "".join(
        f'"cylinders[{n + 1}].reciprocating_mass" = {{ {source} }}\n' for n in range(9)
    )
    Path("nine.toml").write_text(
        f'format = 1\nname = "Nine"\n[[shaft]]\nname = "crank"\n{throws}{cylinders}'
        f"[provenance]\n{ranges}",
        encoding="utf-8",
    )
    told = " ".join(run("check", "nine.toml").err.split())
    assert "9 estimated values have a range; 8 can have one of their own. In [provenance]" in told
    assert "leave range out of some of cylinders[1].reciprocating_mass, cylinders[2]." in told


@pytest.mark.release
@pytest.mark.parametrize(
    "line",
    [
        ["balance", "i4", "--factor", "\uff10.5"],
        ["balance", "triple-120", "--minimise", "M\uff11V", "--limit", "M1H=\uff12"],
        ["sweep", "i4", "--over", "balance_factor=0..1/\uff13"],
        ["search", "\uff13", "--best", "\uff12"],
        ["compare", "i4", "i4", "--set", "\uff12:balance_factor=0.5"],
        [
            "drill",
            "--unbalance",
            "850 g*mm",
            "--at-radius",
            "60 mm",
            "--diameter",
            "\uff11\uff12 mm",
        ],
    ],
)
def test_the_digits_of_a_japanese_keyboard_are_read_everywhere(run: Run, line: list[str]) -> None:
    plain = [word.translate({0xFF10 + n: str(n) for n in range(10)}) for word in line]
    assert (run(*line).code, run(*line).out) == (0, run(*plain).out)


def test_a_limit_of_odd_letters_is_refused(refused: Callable[..., str]) -> None:
    words = ["balance", "triple-120", "--minimise", "M1V", "--limit", "M1H=\u0131nf"]
    assert "M1H=\u0131nf" in refused(*words)


@pytest.mark.parametrize(
    ("weights", "told"),
    [
        ('{ z = "9 m", unbalance = "18 g*m" }', "The weight at z = 9000 mm is more than 3 bore"),
        (
            '{ z = "9 m", unbalance = "18 g*m" }, { z = "-9 m", unbalance = "18 g*m" }',
            "The weights at z = 9000 mm, -9000 mm are more than 3 bore pitches beyond",
        ),
        ('{ z = "300 mm", unbalance = "18 g*m" }', ""),  # a damper, as of external balance
    ],
)
def test_a_weight_far_from_its_crankshaft_is_told(run: Run, weights: str, told: str) -> None:
    Path("far.toml").write_text(f"{I4}[[crankshaft]]\nweight = [{weights}]\n", encoding="utf-8")
    done = run("check", "far.toml")
    out = " ".join(done.out.split())
    assert (done.code, "good" in out, "beyond the crankshaft" in out) == (0, True, bool(told))
    assert told in out


def test_a_balance_shaft_apart_from_the_engine_is_not_told(run: Run) -> None:
    shaft = 'weight = [{ z = "9 m", angle = "0 deg", unbalance = "18 g*m" }]\n'
    Path("apart.toml").write_text(f"{I4}[[balance_shaft]]\n{shaft}", encoding="utf-8")
    done = run("check", "apart.toml")
    assert (done.code, "beyond the crankshaft" in done.out) == (0, False)
