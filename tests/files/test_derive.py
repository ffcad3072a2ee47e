"""`crankstar derive`: every format for every kind of engine, and requests that are refused."""

from __future__ import annotations

import json
import math
import re
import tomllib
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest
from tests.catalog import EVERY_ENGINE
from tests.commands import Run
from tests.texts import SHORT

import crankstar
from crankstar.derive import derivation, documents
from crankstar.derive.algebra.formula import Symbol
from crankstar.derive.notations import NOTATIONS
from crankstar.files import engine_of

HOSTILE = "</script><img src=x onerror=alert(1)> $\\frac{&}{%} #_^~ `*[a](b)`"
KINDS = [
    "single",
    "v8-cross-plane",
    "radial-9",
    "vw-vr6",
    "kr250-racer",
    "napier-deltic",
    "sinitsyn-7-first",
    "subaru-ej25",
]


def formulas(page: str) -> list[str]:
    return re.findall(r"<math.*?</math>", page, re.DOTALL)


@pytest.mark.release
@pytest.mark.parametrize("name", KINDS)
def test_every_format_of_a_derivation_is_written(run: Run, name: str) -> None:
    for form, begins in (
        ("text", ""),
        ("latex", "\\documentclass"),
        ("markdown", "# "),
        ("html", "<!DOCTYPE html>"),
    ):
        out = run("derive", name, "--orders", "1,2", "--format", form).out
        assert out.startswith(begins)
        assert out.count("resultant") == 4


def parsed(formula: str) -> ElementTree.Element:
    """A formula as XML; our own, so that nothing in it is to be distrusted."""
    return ElementTree.fromstring(formula)  # noqa: S314


@pytest.mark.many(first=6)
@EVERY_ENGINE
def test_the_formulas_of_a_page_are_well_formed(name: str) -> None:
    engine = crankstar.load(name)
    page = documents.html([derivation(engine, order, "couple") for order in (1, 2)])
    assert len(formulas(page)) > 4
    for formula in formulas(page):
        parsed(formula)
    assert "<script" not in page
    assert "http" not in page


def test_a_hostile_name_stays_text_in_every_format() -> None:
    tree = tomllib.loads(SHORT)
    tree["name"] = HOSTILE
    for count, bank in enumerate(tree["layout"]["banks"]):
        bank["name"] = f"{HOSTILE}{count}"
    chapters = [derivation(engine_of(tree), order, "couple") for order in (1, 2)]
    page = documents.html(chapters)
    assert "<img" not in page
    assert "<script" not in page
    for formula in formulas(page):
        parsed(formula)
    latex = re.sub(r"^% .*$", "", documents.latex(chapters), flags=re.MULTILINE)
    assert "</script>" not in latex
    assert not re.search(r"(?<!\\)[%#]", latex)
    assert "<img" not in documents.markdown(chapters)


@pytest.mark.parametrize("notation", NOTATIONS)
def test_every_notation_names_the_letters_it_uses_and_no_other(run: Run, notation: str) -> None:
    out = " ".join(
        run("derive", "v8-cross-plane", "--orders", "1", "--notation", notation).out.split()
    )
    letters = {"crankstar": "a: bore pitch", "stroke": "S: stroke", "sinitsyn": "l₀: bore pitch"}
    assert letters[notation] in out
    assert [name for name in ("stroke", "sinitsyn") if letters[name] in out] == [notation] * (
        notation != "crankstar"
    )


def test_the_six_signs_are_in_the_letters_of_the_book_unless_told_otherwise(run: Run) -> None:
    assert "ΣM_I = 2√3 C_I l₀ ∠ π/6" in run("derive", "sinitsyn-6-valve", "--signs").out
    assert (
        "ΣM_I = 2√3 C_I a ∠ π/6"
        in run("derive", "sinitsyn-6-valve", "--signs", "--notation", "crankstar").out
    )


def test_a_file_appears_whole(run: Run, tmp_path: Path) -> None:
    assert run("derive", "i4", "--format", "html", "-o", "four.html").out == ""
    page = (tmp_path / "four.html").read_text(encoding="utf-8")
    assert page.rstrip().endswith("</html>")
    assert "√" not in page.split("<math")[0]


def test_what_differs_from_the_file_is_derived(run: Run) -> None:
    banks = 'layout.banks=[{bearing="-30 deg",cylinders=[1]},{bearing="30 deg",cylinders=[2]}]'
    assert "a circle" in run("derive", "v2-90", "--orders", "1", "--quantity", "force").out
    narrow = run("derive", "v2-90", "--orders", "1", "--quantity", "force", "--set", banks).out
    words = "traversed in the direction of rotation of the crank. Its major axis is vertical."
    assert words in " ".join(narrow.split())
    assert "F_long = 1.5" in narrow.replace("3/2", "1.5")
    assert "F_short = 0.5" in narrow.replace("1/2", "0.5")


def test_another_plane_of_reference_is_a_letter(run: Run) -> None:
    out = run(
        "derive", "triple-120", "--orders", "1", "--quantity", "couple", "--reference", "0.5"
    ).out
    assert "arm a − z₀" in out
    assert "arm −a − z₀" in out
    assert re.search(r"M_up\s+= √3 a cos\(θ − π/6\)", out)


@pytest.mark.release
def test_decimals_are_said_to_be_decimals(run: Run) -> None:
    out = " ".join(run("derive", "vw-vr6", "--orders", "2", "--quantity", "couple").out.split())
    assert "decimals with proved bounds, every digit certain" in out
    assert "misses the crankshaft" in out
    assert "enclosed decimals" not in run("derive", "v12-60", "--orders", "2").out


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--orders", "0"], "above 0 and up to 24"),
        (["--orders", "-1"], "above 0 and up to 24"),
        (["--orders", "25"], "above 0 and up to 24"),
        (["--orders", "nan"], "as in 2 or 1,2,4,6"),
        (["--orders", "two"], "as in 2 or 1,2,4,6"),
        (["--orders", ""], "as in 2 or 1,2,4,6"),
        (["--orders", ",".join(["1"] * 25)], "up to 24 crank orders"),
        (["--quantity", "roll"], "choose from motion, force, couple"),
        (["--format", "pdf"], "choose from text, latex, markdown, html"),
        (["--notation", "german"], "choose from crankstar, stroke, sinitsyn"),
        (["--symbolic", "gamma"], "choose from alpha, phi, n"),
        (["--symbolic", "phi"], "two parallel cylinders"),
        (["--power", "0"], "from 1 to 24"),
        (["--signs", "--orders", "2"], "--orders has no effect with --signs"),
        (
            ["--signs", "--symbolic", "alpha", "--power", "3"],
            "--power, --symbolic have no effect with --signs",
        ),
        (["--symbolic", "alpha", "--reference", "0"], "--reference has no effect with --symbolic"),
        (["--symbolic", ""], "choose from alpha, phi, n"),
        (["--symbolic", "alpha", "--quantity", "torque"], "use --quantity force"),
        (["--notation", ""], "choose from crankstar, stroke, sinitsyn"),
        (["--orders", "1e999999999"], "as in 2 or 1,2,4,6"),
        (["--orders", "1/0"], "as in 2 or 1,2,4,6"),
        (["--speed", "fast"], "--speed"),
        (["--power", "two"], "whole number"),
        (["--reference", "x"], '--reference is "x"'),
    ],
)
def test_a_request_that_cannot_be_met_is_refused_in_a_sentence(
    refused: Callable[..., str], arguments: list[str], told: str
) -> None:
    assert told in refused("derive", "v8-cross-plane", *arguments)


def test_an_order_that_no_piston_has_is_nothing(run: Run) -> None:
    out = run("derive", "i4", "--orders", "3", "--quantity", "force").out
    assert "There is no force of this order: no part of the engine exerts one." in " ".join(
        out.split()
    )


def test_the_signs_of_several_crankshafts_are_refused(refused: Callable[..., str]) -> None:
    assert "one crankshaft" in refused("derive", "square-four", "--signs")


GEARED = """
format = 1
name = "one over two balance shafts"
[[shaft]]
name = "crank"
[[shaft.throw]]
angle = "0 deg"
radius = "40 mm"
[[shaft]]
name = "balancer"
speed_ratio = 2
[[shaft.weight]]
unbalance = "0.001 kg*m"
angle = "180 deg"
[[shaft]]
name = "other"
speed_ratio = -2
[[shaft.weight]]
unbalance = "0.001 kg*m"
angle = "180 deg"
[[cylinders]]
number = 1
shaft = "crank"
throw = 1
rod_length = "160 mm"
reciprocating_mass = "0.5 kg"
"""
THREE = """
format = 1
name = "heavy in front"
speed = "6000 rpm"
[cylinder]
stroke = "80 mm"
rod_length = "150 mm"
reciprocating_mass = "0.5 kg"
[[cylinders]]
number = 1
reciprocating_mass = "0.6 kg"
[layout]
type = "inline"
throws = ["0 deg", "180 deg", "180 deg", "0 deg"]
bore_pitch = "90 mm"
"""


def test_newton_metres_are_about_the_plane_that_was_asked_for(run: Run, tmp_path: Path) -> None:
    (tmp_path / "three.toml").write_text(THREE, encoding="utf-8")
    words = ("three.toml", "--reference", "30 mm")
    told = run("derive", *words, "--orders", "2", "--quantity", "couple").out
    shown = float(re.findall(r"the couple is at most ([\d.]+) N m", told)[0])
    answer = json.loads(run("analyze", *words, "--json").out)
    second = next(one for one in answer["orders"] if one["order"] == 2)["couple"]
    assert shown == pytest.approx(
        abs(complex(*second["forward"])) + abs(complex(*second["backward"])), rel=1e-5
    )
    assert (
        "z₀: distance of the reference plane in front of the middle of the cylinders, 30 mm"
        in " ".join(told.split())
    )
    assert "a: bore pitch, 90 mm" in " ".join(told.split())


def test_another_speed_is_that_of_the_numbers(run: Run, tmp_path: Path) -> None:
    (tmp_path / "three.toml").write_text(THREE, encoding="utf-8")
    slow, fast = (
        float(
            re.findall(
                r"the force is at most ([\d.]+) N over a turn\.",
                run("derive", "three.toml", "--orders", "2", "--speed", speed).out,
            )[0]
        )
        for speed in ("3000 rpm", "6000 rpm")
    )
    assert fast == pytest.approx(4 * slow, rel=1e-4)


def test_lines_of_several_harmonics_are_still_a_line(run: Run, tmp_path: Path) -> None:
    (tmp_path / "geared.toml").write_text(GEARED, encoding="utf-8")
    told = " ".join(
        run("derive", "geared.toml", "--orders", "2", "--quantity", "force").out.split()
    )
    assert "The force acts along a straight line. The line is vertical." in told
    assert "F_up = (−2/5 + A₂) cos 2θ" in told  # twice 4 * 0.001 kg m over 0.5 kg times 40 mm
    assert "F_+ = (1/5 − 0.5 A₂) ∠ π" in told  # a length is positive: A₂ is 0.254


@pytest.mark.release
def test_moments_that_cancel_are_not_said_to_push_against_each_other(run: Run) -> None:
    told = " ".join(run("derive", "i4", "--orders", "2", "--quantity", "couple").out.split())
    assert "their moments equal and opposite at every crank angle" in told
    assert "their forces" not in told


def test_a_bank_that_is_called_like_a_direction_keeps_its_own_letter() -> None:
    found = derivation(crankstar.load("v6-60-six-throws"), 1, "couple")
    named = [
        (line.name, line.rows, line.bearing_deg)
        for step in found.steps
        for line in step.lines
        if line.kind == "signal"
    ]
    for name, rows, bearing in named:
        assert all(
            (other, along) == (rows, bearing) for letter, other, along in named if letter == name
        )
    assert {"M_bank left", "M_bank right", "M_up", "M_right"} <= {
        name.name for name, _, _ in named if isinstance(name, Symbol)
    }


def test_a_series_that_begins_later_is_not_nought(run: Run) -> None:
    told = run(
        "derive", "v8-flat-plane", "--orders", "6", "--quantity", "force", "--power", "3"
    ).out
    assert "begins with λ to the power 5" in told
    assert "A₆ = 0 " not in told


def test_balance_weights_are_said_to_be_left_out_of_the_six_signs(run: Run) -> None:
    assert "weights are left out" in run("derive", "parallel-twin-180", "--signs").out


def test_a_derivation_is_its_text() -> None:
    told = str(derivation(crankstar.load("i4"), 2))
    assert told.startswith("Four in line, flat crank: Secondary force")
    assert "F_up = 4 cos 2θ" in told


def test_the_axes_of_an_ellipse_are_added_up(run: Run) -> None:
    out = run("derive", "gm-3800", "--orders", "1", "--quantity", "couple").out
    assert "M_long = (3√2/2) a" in out
    assert "M_short = (√6/2) a" in out


@pytest.mark.parametrize(("order", "negative"), [("1", False), ("2", False), ("4", True)])
def test_vectors_counted_in_a_negative_harmonic_are_said_to_be(
    run: Run, order: str, negative: bool
) -> None:
    """A_4 of a centred crank is below zero: the force points down where the vector is up."""
    for quantity in ("force", "couple"):
        out = run("derive", "ducati-90", "--orders", order, "--quantity", quantity).out
        assert (f"A_{order} is negative" in " ".join(out.split())) == negative


FIVE = """
format = 1
name = "twin"
cycle = "four-stroke"
speed = "6000 rpm"
firing_order = [1, 2, 4, 5, 3]
source = "made up"
cylinder.stroke = "90 mm"
cylinder.rod_length = "140 mm"
cylinder.reciprocating_mass = "520 g"
cylinder.rotating_mass = "450 g"
layout = { type = "inline", bore_pitch = "88 mm" }
"""


@pytest.mark.release
def test_masses_that_are_given_stand_before_the_root_of_the_star(run: Run, tmp_path: Path) -> None:
    """The couple of the star, sqrt(50 - 22 sqrt 5)/2 m r w^2 a, times shares of the masses."""
    place = tmp_path / "five.toml"
    place.write_text(FIVE, encoding="utf-8")
    out = run("derive", str(place), "--orders", "1", "--quantity", "couple").out
    assert "no short closed form" not in out
    star = math.sqrt(50 - 22 * math.sqrt(5)) / 2
    shares = {"M_up": 97 / 52, "M_right": 45 / 52, "M_+": 71 / 52, "M_−": 1 / 2}
    end = out[out.index("The resultant") :]
    for name, share in shares.items():
        told = re.search(rf" {re.escape(name)} = \((\d*)√\(50 − 22√5\)/(\d+)\) a", end)
        assert told is not None, name
        value = int(told[1] or 1) * math.sqrt(50 - 22 * math.sqrt(5)) / int(told[2])
        assert value == pytest.approx(share * star, rel=1e-12)
    newtons = 0.52 * 0.045 * (200 * math.pi) ** 2 * 0.088
    assert f"at most {97 / 52 * star * newtons:.6g} N m" in out


@pytest.mark.release
@pytest.mark.parametrize(("quantity", "order"), [("force", "4"), ("couple", "2")])
def test_a_size_that_rests_on_estimates_says_so(
    run: Run, refused: Callable[..., str], quantity: str, order: str
) -> None:
    Path("given.toml").write_text(
        """format = 1
name = "twin"
speed = "6000 rpm"
[cylinder]
bore = "82.5 mm"
stroke = "92.8 mm"
[layout]
type = "inline"
throws = ["0 deg", "90 deg"]
"""
    )
    run("estimate", "given.toml", "-o", "guessed.toml")
    asked = ["--quantity", quantity, "--orders", order]
    told = run("derive", "guessed.toml", *asked).out
    sizes = re.findall(r"is at most ([\d.e+-]+) N", told)
    assert sizes
    assert len(sizes) == told.count("This size is estimated")
    assert all(len(size.strip("0").replace(".", "")) <= 3 for size in sizes)
    assert told.count("(estimated)") == told.count("exactly, at")
    assert "estimated" not in run("derive", "i4", *asked).out
    torque = ["--quantity", "torque", "--orders", order]
    assert "needs rods as two masses" in refused("derive", "guessed.toml", *torque)


@pytest.mark.parametrize(
    "throw", ["101.6986 deg", "1.7749754 rad", "17.25131 deg", "0.30109 rad", "77.000001 deg"]
)
def test_what_rounding_leaves_of_fine_angles_is_no_force(throw: str) -> None:
    """A boxer's pistons move in and out together, whatever its throws: nothing remains."""
    tree = {
        "name": "boxer",
        "cylinder": {"stroke": "80 mm", "rod_length": "130 mm"},
        "layout": {
            "type": "boxer",
            "throws": ["0 deg", throw],
            "banks": [
                {"bearing": "-90 deg", "cylinders": [1, 3]},
                {"bearing": "90 deg", "cylinders": [2, 4]},
            ],
            "bore_pitch": "100 mm",
        },
    }
    engine = engine_of(tree)
    for order in (1, 2):
        found = derivation(engine, order)
        text = documents.plain([found])
        assert "10⁻" not in text
        assert "Nothing of this order remains" in " ".join(text.split())


def test_a_crest_is_said_of_plain_rods_on_centred_cranks_alone() -> None:
    said = "crest where the piston is at top dead centre"
    assert said in documents.plain([derivation(crankstar.load("i4"), 2)])
    offset = crankstar.load("i4", changes={"cylinder.stroke": "80 mm", "cylinder.offset": "5 mm"})
    for engine in (crankstar.load("radial-9"), offset):
        assert said not in documents.plain([derivation(engine, 2)])


def test_the_pistons_alone_have_a_name_of_their_own_beside_rotating_masses() -> None:
    """F_up of a derivation is the whole force, from the first line that has the letter."""
    heavy = crankstar.load("ducati-90", changes={"cylinder.throw_mass": 0.2})
    found = derivation(heavy, 1)
    lines = [line for step in found.steps[:-1] for line in step.lines if line.kind == "signal"]
    names = [(line.name.below, line) for line in lines if isinstance(line.name, Symbol)]
    assert len({line.chain[-1] for below, line in names if below == "up"}) == 1
    assert any(below.startswith("pistons") for below, _line in names)


@pytest.mark.release
def test_newtons_of_a_derivation_have_what_they_rest_on(run: Run) -> None:
    """The rotating masses, which the file lacks, make the couple of order 1 two or three times."""
    asked = ("--quantity", "couple", "--orders", "1")
    out = " ".join(run("derive", "audi-25-tfsi", *asked).out.split())
    size = float(out.partition("at most ")[2].split()[0])
    assert size == pytest.approx(417.949, rel=1e-5)
    rocking = crankstar.total(crankstar.balance("audi-25-tfsi")).couple
    first = int(np.flatnonzero(rocking.orders == 1.0)[0])
    ways = abs(rocking.forward[first]) + abs(rocking.backward[first])
    assert size == pytest.approx(ways, rel=1e-5)
    record = out.partition("417.949")[2]
    assert "cylinder.rotating_mass" in record
    assert "747 to 1260" in record
    marked = run("derive", "audi-25-tfsi", *asked, "--format", "markdown").out
    assert "cylinder.rotating" in marked.partition("417.949")[2]


@pytest.mark.release
def test_a_derivation_without_newtons_has_no_record(run: Run) -> None:
    for name in ("i4", "v8-cross-plane"):
        for quantity in ("force", "couple"):
            out = run("derive", name, "--quantity", quantity, "--orders", "2").out
            assert "cylinder.rotating_mass" not in out


def test_the_torque_of_a_derivation_has_what_it_rests_on(run: Run) -> None:
    out = run("derive", "audi-25-tfsi", "--quantity", "torque", "--orders", "5").out
    assert "cylinder.rod_length:" in out.partition("14.1942")[2]
