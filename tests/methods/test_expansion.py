"""From the crank drive to A_2, A_4, A_6: each printed line is true, and A_k is that of the motion.

The printed formulas are read back from text, LaTeX and MathML. Exact lines hold at any angle;
series are compared with what they stand for at a lambda so small that a wrong last coefficient
would be seen.
"""

from __future__ import annotations

import io
import re
from contextlib import redirect_stdout, suppress
from fractions import Fraction

import numpy as np
import pytest
from flint import acb, arb
from tests import printed
from tests.methods.test_printed import in_latex, in_mathml, in_text

from crankstar import cli, load
from crankstar.derive import Line, documents, motion_chapter
from crankstar.derive.algebra import cyclotomic, typeset
from crankstar.derive.algebra.formula import Symbol
from crankstar.derive.expansion import cosine_coefficients, place_coefficients, root_coefficients
from crankstar.derive.notations import CRANKSTAR, NOTATIONS, STROKE, Notation, notated
from crankstar.engine.engine import Engine
from crankstar.engine.motion import piston_harmonics, series_coefficient

READERS = (in_text, in_latex, in_mathml)
HIGHEST = 8


def exact_place(psi: arb, ratio: arb, radius: arb) -> acb:
    """x by plane geometry: the pin, and the rod by Pythagoras."""
    rod = radius / ratio
    return acb(radius * psi.cos() + (rod**2 - (radius * psi.sin()) ** 2).sqrt())


def harmonic(order: int, ratio: arb) -> acb:
    """A_k by the second derivative of the place, without any series: an integral of x cos k psi."""

    def at(psi: acb, _: bool) -> acb:
        return (1 - (ratio * psi.sin()) ** 2).sqrt() / ratio * (order * psi).cos()

    return acb.integral(at, 0, 2 * arb.pi()) / arb.pi() * order**2


def values(ratio: arb, notation: Notation) -> dict[str, arb | acb]:
    """The letters of the chapter at psi = 0.7, r = 1.25, m = 0.5, omega = 3."""
    psi, radius, mass, omega = arb("0.7"), arb("1.25"), arb("0.5"), arb(3)
    letters: dict[str, arb | acb] = {
        "psi": psi,
        "lambda": ratio,
        "r": radius,
        "l": radius / ratio,
        "u": (ratio * psi.sin()) ** 2,
        "m": mass,
        "omega": omega,
        "…": arb(0),
        "x": exact_place(psi, ratio, radius),
    }
    for k in range(2, HIGHEST + 1, 2):
        letters[f"A_{k}"] = harmonic(k, ratio)
        letters[f"x_{k}"] = letters[f"A_{k}"] / k**2
    own = arb.pi()
    place = acb.integral(lambda psi, _: (1 - (ratio * psi.sin()) ** 2).sqrt() / ratio, 0, own) / own
    letters["x_0"] = place
    letters["F"] = mass * omega**2 * acceleration(psi, ratio, radius)
    if notation is STROKE:
        letters |= {"M": mass, "S": 2 * radius, "L": 1 / (2 * ratio)}
    return letters


def acceleration(psi: arb, ratio: arb, radius: arb) -> acb:
    """-x'' by psi, from x = r cos psi + s, s s' = -y y', s s'' = -(y'^2 + y y'') - s'^2."""
    y, first, second = radius * psi.sin(), radius * psi.cos(), -radius * psi.sin()
    s = ((radius / ratio) ** 2 - y**2).sqrt()
    slope = -y * first / s
    return acb(radius * psi.cos() + (first**2 + y * second + slope**2) / s)


def named(line: Line) -> str:
    assert line.name is not None
    return typeset.text(line.name)


def every_line(engine: Engine, notation: Notation, *, power: int = 7) -> list[Line]:
    chapter = notated(motion_chapter(engine, power=power), notation)
    return [line for step in chapter.steps for line in step.lines]


@pytest.mark.many(first=1)
@pytest.mark.parametrize("notation", NOTATIONS.values(), ids=list(NOTATIONS))
def test_every_exact_line_is_true_as_printed(notation: Notation) -> None:
    with cyclotomic.precision(40):
        letters = values(arb(1) / 4, notation)
        exact = [line for line in every_line(load("i4"), notation) if line.kind == "plain"]
        assert len(exact) >= 16
        for line in exact:
            assert line.name is not None
            left = printed.value(printed.from_text(typeset.text(line.name)), letters)
            for read in READERS:
                (tokens,) = read(line)
                off = printed.value(tokens, letters) - left
                assert off.overlaps(acb(arb(0, 1e-20), arb(0, 1e-20))), named(line)


@pytest.mark.many(first=7)
@pytest.mark.parametrize("notation", NOTATIONS.values(), ids=list(NOTATIONS))
@pytest.mark.parametrize("power", [1, 3, 7, 15])
def test_every_series_is_what_it_stands_for_to_its_last_term(
    notation: Notation, power: int
) -> None:
    """At lambda = 1e-4 the first term left out is 1e-8 of the last one written, or less."""
    with cyclotomic.precision(200):
        ratio = arb(1) / 10**4
        letters = values(ratio, notation)
        lines = [x for x in every_line(load("i4"), notation, power=power) if x.kind == "series"]
        assert len(lines) == 3 + 2 * min((power + 1) // 2, HIGHEST // 2)
        for line in lines:
            assert line.name is not None
            left = printed.value(printed.from_text(typeset.text(line.name)), letters)
            terms = (power + 1) // 2
            last = min(2 * terms, HIGHEST) if named(line) in ("x", "F") else 2 * terms
            # Of F and x the next harmonic, of a series the next power, is left out.
            least = ratio ** (last + (1 if named(line) != "√(1 − u)" else 2)) * 10
            scale = abs(letters["r"]) if named(line) == "x" else 1
            for read in READERS:
                (tokens,) = read(line)
                assert abs(printed.value(tokens, letters) - left) < least * 100 * scale, named(line)


def test_the_printed_series_at_a_real_rod_ratio_is_the_harmonic_of_the_motion() -> None:
    exact = np.real(piston_harmonics(crank_radius=1, rod_length=4))
    with cyclotomic.precision(60):
        letters = values(arb(1) / 4, CRANKSTAR)
        lines = every_line(load("i4"), CRANKSTAR, power=23)
        harmonics = [line for line in lines if line.series]
        for line in harmonics:
            order = int(named(line).translate(str.maketrans("₂₄₆₈", "2468")).removeprefix("A"))
            for read in READERS:
                (tokens,) = read(line)
                printed_value = complex(printed.value(tokens, letters)).real
                assert printed_value == pytest.approx(exact[order], rel=1e-11)
        assert len(harmonics) == HIGHEST // 2


def test_every_printed_decimal_is_the_harmonic_of_the_motion() -> None:
    engine = load("audi-25-tfsi")
    radius, rod = engine.throw(engine.first).radius, engine.first.rod_length
    exact = np.real(piston_harmonics(crank_radius=radius, rod_length=rod))
    out = io.StringIO()
    with redirect_stdout(out), suppress(SystemExit):
        cli.main(["derive", "audi-25-tfsi", "--quantity", "motion"])
    decimals = re.findall(r"A([₂₄₆₈]) = (−?)(0\.\d+)…", out.getvalue())
    assert len(decimals) == HIGHEST // 2
    for figure, sign, digits in decimals:
        order = int(figure.translate(str.maketrans("₂₄₆₈", "2468")))
        value = float(digits) * (-1 if sign else 1)
        assert value == pytest.approx(exact[order], rel=1e-9)


def test_the_coefficients_are_those_of_the_motion_for_every_power() -> None:
    """By flint's power series and polynomials here, by binomials there."""
    for order in range(2, 25, 2):
        powers = dict(place_coefficients(order, 12))
        for power in range(1, 24):
            there = Fraction(series_coefficient(order, power), order**2)
            assert powers.get(power, 0) == there


def test_the_root_squared_is_what_stands_under_it() -> None:
    root = root_coefficients(12)
    squared = [sum(root[i] * root[n - i] for i in range(n + 1)) for n in range(13)]
    assert squared == [1, -1, *[0] * 11]


@pytest.mark.parametrize("half", range(1, 13))
def test_powers_of_the_sine_are_these_cosines(half: int) -> None:
    for psi in np.linspace(0.1, 3, 7):
        cosines = sum(
            float(value) * np.cos(2 * k * psi) for k, value in enumerate(cosine_coefficients(half))
        )
        assert cosines == pytest.approx(np.sin(psi) ** (2 * half), abs=1e-13)


@pytest.mark.release
def test_a_whole_derivation_starts_before_the_second_harmonic() -> None:
    def titles(*words: str) -> list[str]:
        out = io.StringIO()
        with redirect_stdout(out), suppress(SystemExit):
            cli.main(["derive", "i4", *words])
        return re.findall(r"^[^\s\d].*: (.+)$", out.getvalue(), re.MULTILINE)

    assert titles()[0] == "The motion of one piston"
    assert titles("--quantity", "motion") == ["The motion of one piston"]
    assert "The motion of one piston" not in titles("--orders", "2")
    assert "The motion of one piston" not in titles("--quantity", "force")


def test_an_offset_cylinder_gets_no_harmonics_of_a_centred_crank() -> None:
    engine = load("vw-vr6")
    assert engine.first.offset
    last = motion_chapter(engine).steps[-1]
    assert not any("…" in documents.equations(line) for line in last.lines)
    assert any("misses the crank" in words for words in last.words)


def test_letters_of_the_chapter_are_all_explained() -> None:
    for notation in NOTATIONS.values():
        shown = documents.markdown([motion_chapter(load("i4"))], notation)
        told = set(re.findall(r"^\* \$(.+?)\$:", shown, re.MULTILINE))
        assert {"x", r"\psi", r"\lambda", "l", "u"} <= told, notation.name
    assert Symbol("x", "2").name == "x_2"
