"""The page on Sinitsyn's engines agrees with the claims; its weights and shafts cancel all."""

from __future__ import annotations

import re
from functools import lru_cache
from html import unescape
from itertools import permutations
from math import degrees, radians
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np
import pytest
from tests.claims import CLAIMS
from tests.scripts import script

import crankstar
from crankstar import spectra
from crankstar.derive.algebra import cyclotomic
from crankstar.mechanics.balance import balance, total

ROOT = Path(__file__).parents[2]
MARKED = re.compile(r"^<!-- sinitsyn: ([\w-]+) -->$", re.MULTILINE)
VECTOR = re.compile(r"([\d.]+) at (−?[\d.]+)°")
FINE = 1e-12


PAGE = script("sinitsyn_page")
SCHEMES: dict[str, Any] = PAGE.SCHEMES
CLAIMED = dict(zip(SCHEMES, CLAIMS["sinitsyn"], strict=True))
"""By the part of the page: what the claims say of the engine."""
EVERY = pytest.mark.parametrize("part", SCHEMES)


@lru_cache
def about(part: str) -> str:
    """A part of the page as it is generated, without its drawings."""
    return re.sub(r"<svg.*?</svg>", "", PAGE.page(part), flags=re.DOTALL)


def row(part: str, head: str) -> str:
    return next(line for line in about(part).splitlines() if line.startswith(f"| {head} |"))


def moments(part: str) -> dict[str, complex]:
    """M_R, M_I and M_II as the page prints them."""
    found = {}
    for name, cell in zip(
        ("M_R", "M_I", "M_II"), row(part, "moment").split(" | ")[1:], strict=True
    ):
        printed = VECTOR.search(cell)
        assert printed is not None or cell.split(" |")[0].endswith("</math>")
        length, angle = printed.groups() if printed else ("0", "0")
        found[name] = float(length) * np.exp(1j * radians(float(angle.replace("−", "-"))))
    return found


def claimed(part: str, key: str) -> float:
    value = CLAIMED[part].get(key, CLAIMED[part].get(f"least_{key}", 0))
    return 2 * 3**0.5 if value == "2*sqrt(3)" else float(value)


# Sums


@EVERY
def test_the_moments_printed_on_the_page_are_those_of_the_claims(part: str) -> None:
    found = moments(part)
    for key in ("M_I", "M_II"):
        assert abs(found[key]) == pytest.approx(claimed(part, key), abs=5e-5)
        if f"{key}_deg" in CLAIMED[part]:
            assert degrees(np.angle(found[key])) == pytest.approx(
                CLAIMED[part][f"{key}_deg"], abs=5e-3
            )
    assert found["M_R"] == found["M_I"]


@EVERY
def test_the_page_says_of_the_order_that_was_claimed(part: str) -> None:
    order = CLAIMED[part].get("order", CLAIMED[part].get("orders", [None])[0])
    assert f"Firing order **{'-'.join(map(str, order))}**" in about(part)


@EVERY
def test_all_forces_are_zero_and_said_to_be(part: str) -> None:
    assert row(part, "force").count('<math alttext="0">') == 3


@EVERY
def test_the_sums_are_those_of_the_balance(part: str) -> None:
    engine = crankstar.load(SCHEMES[part].file)
    sums = total(balance(engine))
    for order, key in ((1, "M_I"), (2, "M_II")):
        harmonic = {1: 1.0, 2: CLAIMS["series"]["A"]["2"]}[order]
        vector = complex(spectra.selected(sums.couple, order).forward[0]) / harmonic
        assert 2 * vector == pytest.approx(PAGE.sums(SCHEMES[part].file)[key], abs=FINE)


def test_the_closed_forms_are_on_the_page() -> None:
    assert 'alttext="2√3 P_R l₀ ∠ π/6"' in about("6-valve")
    assert 'alttext="2√3 C_II l₀ ∠ −π/6"' in about("6-loop")
    assert 'alttext="√(20 − 14√2) C_I l₀ ∠ 3π/8"' in about("8-two-stroke")
    assert "x³ − 98x² + 2107x − 1477 = 0" in about("7-first")
    for part in ("7-first", "7-second"):  # the equation is that of the numbers that stand before it
        one = PAGE.sums(SCHEMES[part].file)
        line = next(line for line in about(part).splitlines() if "two roots of" in line)
        digits = re.search(r"x³ − (\d+)x² \+ (\d+)x − (\d+) = 0", line)
        assert digits is not None
        square, linear, last = map(int, digits.groups())
        roots = np.roots([1, -square, linear, -last])
        for key in ("M_I", "M_II"):
            assert np.abs(roots - abs(one[key]) ** 2).min() < 1e-9


def test_the_second_scheme_of_seven_is_smaller_by_what_is_claimed() -> None:
    said = re.search(r"are ([\d.]+) times smaller, .* is ([\d.]+) times smaller", about("7-second"))
    assert said is not None
    ratios = CLAIMED["7-second"]["smaller_than_first_scheme"]
    assert [float(one) for one in said.groups()] == [ratios["M_I"], ratios["M_II"]]


# What is printed


@pytest.mark.parametrize("part", ["7-first", "7-second"])
def test_what_is_quoted_is_what_the_claims_quote(part: str) -> None:
    printed = CLAIMED[part]["printed"]
    for one, key in zip(SCHEMES[part].printed, ("M_I", "M_II"), strict=True):
        assert (float(one.length), float(one.angle)) == (printed[key], printed[f"{key}_deg"])
        assert one.value == printed[key]


def test_the_verdicts() -> None:
    """As the errata have it: two angles are cut."""
    found = {
        (part, one.sums): PAGE.verdict(one, moment(part, one))
        for part in SCHEMES
        for one in SCHEMES[part].printed
    }
    cut = {key: words for key, words in found.items() if words != "correct"}
    assert cut == {
        ("7-first", "M_R and M_I"): "correct; the angle is cut, not rounded to −71°",
        ("7-second", "M_II"): "correct; the angle is cut, not rounded to −39°",
    }
    one = SCHEMES["7-first"].printed[0]
    assert PAGE.verdict(one, 0.86 * np.exp(-1.2j)) == "the length is wrong"
    assert PAGE.verdict(one, 0.85 * np.exp(1.2j)) == "the angle is wrong"


def moment(part: str, one: Any) -> complex:
    return PAGE.sums(SCHEMES[part].file)["M_II" if one.sums == "M_II" else "M_I"]


# Other orders


@EVERY
def test_the_order_backwards_is_the_mirror_image(part: str) -> None:
    file = SCHEMES[part].file
    order = crankstar.load(file).firing_order
    backwards = crankstar.load(file, changes={"firing_order": [order[0], *reversed(order[1:])]})
    for key, value in PAGE.sums_of(backwards).items():
        assert value == pytest.approx(PAGE.sums(file)[key].conjugate(), abs=FINE)


@EVERY
def test_other_orders_have_the_same_sums_and_are_named(part: str) -> None:
    for other in SCHEMES[part].others:
        relation = PAGE.relation(SCHEMES[part].file, other)
        mirrored = "mirror" in other
        assert relation == ("mirrored" if mirrored else "same")
        order = "-".join(map(str, crankstar.load(other).firing_order))
        assert order in about(part).split("Mirrored")[1 if mirrored else 0]


def test_an_engine_with_other_sums_is_not_taken_for_the_same() -> None:
    with pytest.raises(ValueError, match="has other sums"):
        PAGE.relation("sinitsyn-7-first", "sinitsyn-7-second")


def test_which_neighbours_fire_in_succession() -> None:
    assert PAGE.neighbours((1, 5, 3, 6, 2, 4, 7)) == []
    assert PAGE.neighbours((1, 6, 3, 4, 5, 2, 7)) == [(3, 4), (4, 5)]
    assert PAGE.neighbours((1, 3, 5, 7, 6, 4, 2)) == [
        (7, 6),
        (2, 1),
    ]  # also from the last to the first


# Searches


def test_the_unfinished_problem() -> None:
    found, said = PAGE.search(8, without=2), CLAIMED["8-two-stroke"]
    assert (found.stars, found.without) == (said["stars"], said["with_M_II_zero"])
    assert found.least == pytest.approx(said["least_M_I"], abs=5e-5)
    assert sorted(found.orders) == sorted(map(tuple, said["orders"]))
    assert (
        f"Of the {said['stars']} stars of eight cranks {said['with_M_II_zero']} have no"
        in about("8-two-stroke")
    )
    assert f"among them is {said['least_M_I']}" in about("8-two-stroke")


def test_stars_symmetric_in_the_second_order_do_worse() -> None:
    """Four pairs of opposite cranks, as arms 7, 5, 3, 1 in the four planes, in both directions."""
    least = min(
        abs(
            sum(
                arm * sign * np.exp(1j * np.pi * plane / 4)
                for arm, sign, plane in zip((7, 5, 3, 1), signs, planes, strict=True)
            )
        )
        for planes in permutations(range(4))
        for signs in np.array(np.meshgrid(*[[1, -1]] * 4)).reshape(4, -1).T
    )
    assert PAGE.search(8, without=2).least_symmetric == pytest.approx(least, abs=FINE)


def test_the_double_cross_of_the_chapter_reaches_5_5009_in_eight_stars() -> None:
    """1-8 against 2-7 and 3-6 against 4-5 in the second order, every star of them tried here.

    A crank of a pair, or its fellow, has one of the two angles with that vector of order 2.
    """
    moments: dict[tuple[int, ...], list[float]] = {}
    for quarter in (1, -1):
        doubled = (0, 4, 2 * quarter, -2 * quarter)  # of 1-8, 2-7, 3-6, 4-5, in eighths of a turn
        for halves in np.array(np.meshgrid(*[[0, 4]] * 4)).reshape(4, -1).T:
            front = (np.array(doubled) // 2 + halves) % 8
            star = [*front, *(front[::-1] + 4) % 8]
            if star[0] == 0 and len(set(star)) == 8:
                arms = np.arange(3.5, -4, -1)
                assert abs(np.exp(2j * np.pi * 2 * np.array(star) / 8) @ arms) < FINE
                size = float(abs(np.exp(2j * np.pi * np.array(star) / 8) @ arms))
                moments.setdefault(doubled, []).append(size)
    assert [len(sizes) for sizes in moments.values()] == [8, 8]
    found = PAGE.search(8, without=2)
    assert found.first_orders == 8
    assert found.least_double_cross == pytest.approx(min(map(min, moments.values())), abs=FINE)
    assert found.least_double_cross == pytest.approx((84 - 38 * 2**0.5) ** 0.5, abs=FINE)
    assert "reaches 5.5009" in about("8-two-stroke")


def test_the_loop_scavenged_six_is_the_best() -> None:
    found = PAGE.search(6, without=1)
    assert found.least == pytest.approx(2 * 3**0.5)
    assert sorted(found.orders) == sorted(
        tuple(CLAIMED["6-loop"][key]) for key in ("order", "mirror")
    )


def test_no_star_of_seven_is_free_of_moments() -> None:
    stars = np.array([[0, *rest] for rest in permutations(range(1, 7))])
    for order in (1, 2):
        whole = np.zeros((len(stars), 7), dtype=int)
        for cylinder in range(7):
            np.add.at(whole, (np.arange(len(stars)), order * stars[:, cylinder] % 7), 3 - cylinder)
        assert not cyclotomic.vanishing(whole).any()


# Cures


def left(engine: crankstar.Engine) -> float:
    """The greatest force or couple of the first and second order."""
    sums = total(balance(engine))
    return max(
        float(abs(vector[0]))
        for quantity in (sums.force, sums.couple)
        for order in (1, 2)
        for spectrum in [spectra.selected(quantity, order)]
        for vector in (spectrum.forward, spectrum.backward)
    )


@pytest.mark.many(first=5)
@EVERY
def test_weights_and_mechanisms_leave_nothing(part: str) -> None:
    engine = PAGE.cured(SCHEMES[part].file)
    assert left(engine) < FINE
    assert len(engine.shafts) == 1 + 2 * len(PAGE.mechanisms(SCHEMES[part].file))


@pytest.mark.many(first=2)
@pytest.mark.parametrize("part", [part for part in SCHEMES if part != "8-four-stroke"])
def test_without_any_one_of_the_weights_something_is_left(part: str) -> None:
    engine = PAGE.cured(SCHEMES[part].file)
    for number, shaft in enumerate(engine.shafts):
        for place in range(len(shaft.weights)):
            fewer = shaft.model_copy(
                update={"weights": shaft.weights[:place] + shaft.weights[place + 1 :]}
            )
            shafts = (*engine.shafts[:number], fewer, *engine.shafts[number + 1 :])
            assert left(engine.model_copy(update={"shafts": shafts})) > 1e-3


@pytest.mark.many(first=2)
@EVERY
def test_the_exact_weights_are_those_on_the_engine(part: str) -> None:
    file = SCHEMES[part].file
    engine, cures = PAGE.cured(file), PAGE.cures(file)
    harmonic = CLAIMS["series"]["A"]["2"]
    found = {
        "crank" if shaft.throws else str(shaft.speed_ratio): shaft.weights
        for shaft in engine.shafts
        if shaft.weights
    }
    assert found.keys() == cures.keys()
    for key, one in cures.items():
        assert one.proved
        unit = harmonic if key.endswith("2") else 1.0
        for weight, amount in zip(found[key], one.unbalance, strict=True):
            assert weight.unbalance * np.exp(1j * weight.angle) == pytest.approx(
                unit * complex(amount), abs=FINE
            )


@EVERY
def test_the_weights_on_the_page_make_up_the_moments_on_the_page(part: str) -> None:
    """From the text alone: unbalance times distance is M_R, or half of M_I or M_II over w^2.

    Its direction is opposite to that of the moment.
    """
    printed = moments(part)
    lines = [line for line in about(part).splitlines() if "exactly 0, proved" in line]
    assert len(lines) == len(PAGE.cures(SCHEMES[part].file))
    for line in lines:
        where, _, unbalance, front, rear, _ = line.strip("| ").split(" | ")
        plain = unescape(re.sub(r"<math.*?</math>", "", unbalance))
        decimal = re.search(r"[\d.]+", plain.replace("<br>", "")) or re.search(
            r'alttext="([\d.]+)…', unbalance
        )
        assert decimal is not None
        size = float(decimal.group(decimal.lastindex or 0))
        speed = int(re.search(r"(\d)×", where).group(1)) if "×" in where else 1  # pyright: ignore[reportOptionalMemberAccess]
        apart = 2 * float(re.search(r"±([\d.]+)", where).group(1))  # pyright: ignore[reportOptionalMemberAccess]
        want = printed["M_R"] if "webs" in where else printed["M_II" if speed == 2 else "M_I"] / 2
        want = want.conjugate() if "against" in where else want
        angles = [float(angle.removesuffix("°").replace("−", "-")) for angle in (front, rear)]
        assert abs(angles[0] - angles[1]) == pytest.approx(180, abs=0.011)
        push = size * apart * speed**2 * np.exp(1j * radians(angles[0]))
        assert push == pytest.approx(-want, abs=5e-5 * apart * speed**2 + 1e-3 * abs(want))


def test_the_shafts_may_lie_anywhere() -> None:
    """They push no force, so that even the roll of the engine stays as it was."""
    engine = PAGE.cured("sinitsyn-7-first")
    moved = [
        shaft if shaft.throws else shaft.model_copy(update={"right": 7.0, "up": -5.0})
        for shaft in engine.shafts
    ]
    other = engine.model_copy(update={"shafts": tuple(moved)})
    assert left(other) < FINE
    bare = total(balance(PAGE.weighted("sinitsyn-7-first"))).axis_moment
    for one in (engine, other):
        rolled = total(balance(one)).axis_moment
        for order in (1, 2, 3, 4):
            assert spectra.amplitude(spectra.selected(rolled, order)) == pytest.approx(
                spectra.amplitude(spectra.selected(bare, order)), abs=FINE
            )


# The page


def test_every_part_has_its_place_on_the_page() -> None:
    text = (ROOT / "docs" / "explanation" / "sinitsyn.md").read_text(encoding="utf-8")
    assert sorted(MARKED.findall(text)) == sorted(["table", "forces", *SCHEMES])
    heads = [
        re.sub(r"[^\w -]", "", head.lower()).replace(" ", "-")
        for head in re.findall(r"^## (.*)$", text, re.MULTILINE)
    ]
    assert {scheme.anchor for scheme in SCHEMES.values()} <= set(heads)


def test_the_table_has_a_row_for_every_engine() -> None:
    lines = PAGE.page("table").splitlines()[2:]
    assert len(lines) == len(SCHEMES)
    for line, scheme in zip(lines, SCHEMES.values(), strict=True):
        assert "‑".join(map(str, crankstar.load(scheme.file).firing_order)) in line


def test_the_markers_are_filled() -> None:
    filled = script("hooks").filled("<!-- sinitsyn: table -->\n")
    assert filled.strip() == PAGE.page("table")


def drawings_of(part: str) -> list[str]:
    return re.findall(r"<svg.*?</svg>", PAGE.page(part), flags=re.DOTALL)


def told(drawing: str) -> str:
    """All that is written in a drawing but its title."""
    return " ".join(
        "".join(text.itertext())
        for text in ElementTree.fromstring(drawing).iterfind(".//{*}text")  # noqa: S314
    )


@EVERY
def test_drawings_show_what_their_titles_say_and_the_resultants_of_the_page(part: str) -> None:
    drawings, found = drawings_of(part), PAGE.sums(SCHEMES[part].file)
    for order, key in ((1, "M_I"), (2, "M_II")):
        star = next(
            one for one in drawings if f"<title>Star of the vectors of order {order}," in one
        )
        assert f"Force of order {order}," in told(star)
        polygon = next(one for one in drawings if f"<title>Moment polygon of order {order}," in one)
        assert f"Couple polygon of order {order}," in told(polygon)
        angle = round(degrees(np.angle(found[key])), 2)
        said = f"resultant {abs(found[key]):.5g} " if found[key] else "closed"
        assert said in told(polygon)
        assert not found[key] or f"{angle:g}° from crank 1".replace("-", "−") in told(polygon)
    for ratio in PAGE.mechanisms(SCHEMES[part].file):
        shafts = next(
            one for one in drawings if f"<title>Two-shaft mechanism at {ratio} times" in one
        )
        assert re.findall(r"(with|against) the crank", told(shafts)) == ["with", "against"]
        dots = [
            one
            for one in ElementTree.fromstring(shafts).iterfind("circle")  # noqa: S314
            if one.get("r") == "11"
        ]
        for number, way in enumerate((ratio, -ratio)):
            for dot, amount in zip(
                dots[2 * number :], PAGE.cures(SCHEMES[part].file)[str(way)].unbalance, strict=False
            ):
                right, down = (
                    float(dot.get("cx", "")) - (95, 295)[number],
                    float(dot.get("cy", "")) - 146,
                )
                assert np.angle(complex(-down, right) / complex(amount)) == pytest.approx(
                    0, abs=1e-3
                )
            assert [
                dot.get("fill") == PAGE.WEIGHT for dot in dots[2 * number : 2 * number + 2]
            ] == [True, False]
            front = round(
                degrees(np.angle(complex(PAGE.cures(SCHEMES[part].file)[str(way)].unbalance[0]))), 2
            )
            assert f"the crank front {front:g}°".replace("-", "−") in told(shafts)


def test_the_example_of_force_polygons_closes_in_both_orders() -> None:
    for order, drawing in zip((1, 2), drawings_of("forces"), strict=True):
        assert f"Force polygon of order {order}," in told(drawing)
        assert "closed" in told(drawing)


@EVERY
def test_drawings_take_the_colours_of_the_page(part: str) -> None:
    drawings = drawings_of(part)
    assert len(drawings) == 6 + len(PAGE.mechanisms(SCHEMES[part].file))
    for drawing in drawings:
        assert "#808080" not in drawing
        assert "currentColor" in drawing
        title = ElementTree.fromstring(drawing).find("{*}title")  # noqa: S314 (made by us)
        assert title is not None
        assert title.text
