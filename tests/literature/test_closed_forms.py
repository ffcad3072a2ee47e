"""The closed forms printed in the sources, where they are right, follow from the derivation.

They appear in the same or an equal form.
"""

from __future__ import annotations

from fractions import Fraction
from math import atan, cos, pi, sin, sqrt

import pytest

from crankstar import derivation, load
from crankstar.derive import signs
from crankstar.derive.algebra import typeset
from crankstar.derive.algebra.evaluation import value
from crankstar.derive.algebra.formula import has_decimal
from crankstar.derive.algebra.typeset import text
from crankstar.derive.algebra.wave import bearing, length, turn_of
from crankstar.derive.chapters import Derivation
from crankstar.derive.records import Line, Quantity

pytestmark = pytest.mark.quick


def resultant(found: Derivation) -> dict[str, Line]:
    return {
        line.label: line
        for line in next(step for step in found.steps if step.title == "The resultant").lines
    }


def closed(name: str, order: int, quantity: Quantity) -> tuple[str, str]:
    lines = resultant(derivation(load(name), order, quantity))
    return text(lines["up"].chain[-1]), text(lines["right"].chain[-1])


@pytest.mark.many(first=10)
@pytest.mark.parametrize(
    ("name", "order", "quantity", "up", "right"),
    [
        ("v8-flat-plane", 1, "force", "0", "0"),
        ("v8-flat-plane", 2, "force", "0", "−4√2 cos 2θ"),
        ("v8-flat-plane", 4, "force", "4√2 cos 4θ", "0"),
        ("v8-flat-plane", 6, "force", "0", "−4√2 cos 6θ"),
        ("v8-flat-plane", 1, "couple", "0", "0"),
        ("v8-flat-plane", 2, "couple", "2√2 b cos 2θ", "0"),
        ("v8-cross-plane", 1, "force", "0", "0"),
        ("v8-cross-plane", 2, "force", "0", "0"),
        ("v8-cross-plane", 4, "force", "4√2 cos 4θ", "0"),
        ("v8-cross-plane", 6, "force", "0", "0"),
        ("v8-cross-plane", 1, "couple", "√10 a cos(θ + atan 2)", "√10 a cos(θ − atan(1/2))"),
        ("v8-cross-plane", 2, "couple", "0", "0"),
    ],
)
def test_the_v8s_have_these_closed_forms(
    name: str, order: int, quantity: Quantity, up: str, right: str
) -> None:
    assert closed(name, order, quantity) == (up, right)


@pytest.mark.many(first=1)
@pytest.mark.parametrize("theta", [0.0, 0.7, 2.0, 5.1])
def test_the_couple_that_the_cross_plane_page_prints_is_ours_in_another_form(theta: float) -> None:
    """The page: -sqrt(10) a cos(t - pi/4 - atan 3) up, and its sine towards the first bank."""
    lines = resultant(derivation(load("v8-cross-plane"), 1, "couple"))
    letters = {"theta": theta, "a": 1.0, "b": 0.2}
    assert value(lines["up"].chain[-1], letters) == pytest.approx(
        -sqrt(10) * cos(theta - pi / 4 - atan(3)), abs=1e-14
    )
    assert value(lines["right"].chain[-1], letters) == pytest.approx(
        -sqrt(10) * sin(theta - pi / 4 - atan(3)), abs=1e-14
    )


@pytest.mark.parametrize("quantity", ["force", "couple"])
def test_the_cross_plane_page_is_right_by_bank_and_by_pin(quantity: Quantity) -> None:
    titles = [step.title for step in derivation(load("v8-cross-plane"), 4, quantity).steps]
    assert "Bank by bank" in titles
    assert "The other way, pin by pin" in titles


def test_each_bank_of_the_cross_plane_cancels_in_named_pairs() -> None:
    step = next(
        step
        for step in derivation(load("v8-cross-plane"), 1, "force").steps
        if step.title == "Bank by bank"
    )
    told = "Cylinders {}, {} cancel: their forces are equal and opposite at every crank angle."
    assert [line.note for line in step.lines] == [
        f"{told.format(1, 7)} {told.format(3, 5)}",
        f"{told.format(2, 8)} {told.format(4, 6)}",
    ]


def test_sinitsyns_six_has_its_components_five_three_and_one() -> None:
    step = next(
        step
        for step in derivation(load("sinitsyn-6-valve"), 1, "couple").steps
        if step.title == "All cylinders"
    )
    assert list(map(text, step.lines[0].chain[1:])) == [
        "5a cos θ + 3a cos(θ + 2π/3) + a cos(θ − 2π/3)",
        "2√3 a cos(θ + π/6)",
    ]


SIX_SIGNS = {
    "sinitsyn-6-valve": ["0", "2√3 a ∠ π/6", "0", "2√3 a ∠ π/6", "0", "0"],
    "sinitsyn-6-loop": ["0", "0", "0", "0", "0", "2√3 a"],
    "sinitsyn-7-first": ["0", "0.8516350… a", "0", "0.8516350… a", "0", "5.522229… a"],
    "sinitsyn-7-second": ["0", "0.2672537… a", "0", "0.2672537… a", "0", "1.005598… a"],
    "sinitsyn-8-four-stroke-1": ["0", "0", "0", "0", "0", "0"],
    "sinitsyn-8-two-stroke": ["0", "√(20 − 14√2) a", "0", "√(20 − 14√2) a", "0", "0"],
}


@pytest.mark.parametrize("name", SIX_SIGNS)
def test_sinitsyns_engines_have_these_six_signs(name: str) -> None:
    found = signs(load(name))
    assert [sign.letter + sign.below for sign in found] == ["PR", "MR", "PI", "MI", "PII", "MII"]
    for sign, told in zip(found, SIX_SIGNS[name], strict=True):
        assert sign.exact
        if told == "0":
            assert sign.zero
            continue
        assert sign.along is not None
        ((key, amount),) = sign.along.items()
        assert [symbol.name for symbol in key] == ["a"]
        assert told.startswith(f"{text(length(amount))} a")
        if "∠" in told:
            assert turn_of(amount) == Fraction(1, 12)


def test_the_seven_of_sinitsyn_has_its_angles_and_no_radicals() -> None:
    """Printed: 70 deg for the first order, 57 for the second, both against the rotation."""
    moments = {sign.letter + sign.below: sign.along for sign in signs(load("sinitsyn-7-first"))}
    for name, printed in (("MI", -70), ("MII", -57)):
        along = moments[name]
        assert along is not None
        (amount,) = along.values()
        found = bearing(amount)
        assert has_decimal(found)
        assert int(value(found) * 180 / pi) == printed
    told = derivation(load("sinitsyn-7-first"), 1, "couple").steps[-2].words
    assert any("root of x³ − 98x² + 2107x − 1477 = 0" in words for words in told)


def test_the_real_force_has_the_series_of_the_pages_corrected() -> None:
    from crankstar.derive.notations import STROKE, notated

    chapter = notated(derivation(load("v8-flat-plane"), 4, "force", power=5), STROKE)
    series = next(line for step in chapter.steps for line in step.lines if line.kind == "series")
    assert text(series.chain[0]) == "−1/(32L³) − 3/(512L⁵) + …"
    assert typeset.latex(series.chain[0]).startswith("-\\frac{1}{32L^{3}}")
