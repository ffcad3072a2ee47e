"""`crankstar derive`: every format of every kind of engine, and what it says of requests that cannot be met."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable
from pathlib import Path
from xml.etree import ElementTree

import pytest
from tests.commands import Run
from tests.texts import SHORT

import crankstar
from crankstar.derive import derivation, documents
from crankstar.derive.notations import NOTATIONS
from crankstar.files import engine_of

HOSTILE = "</script><img src=x onerror=alert(1)> $\\frac{&}{%} #_^~ `*[a](b)`"
KINDS = ["single", "v8-cross-plane", "radial-9", "vw-vr6", "kr250-racer", "napier-deltic", "sinitsyn-7-first", "subaru-ej25"]


def formulas(page: str) -> list[str]:
    return re.findall(r"<math.*?</math>", page, re.DOTALL)


@pytest.mark.parametrize("name", KINDS)
def test_every_format_of_a_derivation_is_written(run: Run, name: str) -> None:
    for form, begins in (("text", ""), ("latex", "\\documentclass"), ("markdown", "# "), ("html", "<!DOCTYPE html>")):
        out = run("derive", name, "--order", "1,2", "--format", form).out
        assert out.startswith(begins)
        assert out.count("resultant") == 4


def parsed(formula: str) -> ElementTree.Element:
    """A formula as XML; our own, so that nothing in it is to be distrusted."""
    return ElementTree.fromstring(formula)  # noqa: S314


@pytest.mark.parametrize("name", crankstar.names())
def test_the_formulas_of_a_page_are_well_formed(name: str) -> None:
    engine = crankstar.load(name)
    page = documents.html([derivation(engine, order, "couple").chapter for order in (1, 2)])
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
    chapters = [derivation(engine_of(tree), order, "couple").chapter for order in (1, 2)]
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
    out = " ".join(run("derive", "v8-cross-plane", "--order", "1", "--notation", notation).out.split())
    letters = {"crankstar": "a: bore pitch", "stroke": "S: stroke", "sinitsyn": "l₀: bore pitch"}
    assert letters[notation] in out
    assert [name for name in ("stroke", "sinitsyn") if letters[name] in out] == [notation] * (notation != "crankstar")


def test_the_six_signs_are_in_the_letters_of_the_book_unless_told_otherwise(run: Run) -> None:
    assert "ΣM_I = 2√3 C_I l₀ ∠ π/6" in run("derive", "sinitsyn-6-valve", "--signs").out
    assert "ΣM_I = 2√3 C_I a ∠ π/6" in run("derive", "sinitsyn-6-valve", "--signs", "--notation", "crankstar").out


def test_a_file_appears_whole(run: Run, tmp_path: Path) -> None:
    assert run("derive", "i4", "--format", "html", "-o", "four.html").out == ""
    page = (tmp_path / "four.html").read_text(encoding="utf-8")
    assert page.rstrip().endswith("</html>")
    assert "√" not in page.split("<math")[0]


def test_what_differs_from_the_file_is_derived(run: Run) -> None:
    banks = 'layout.banks=[{bearing="-30 deg",cylinders=[1]},{bearing="30 deg",cylinders=[2]}]'
    assert "a circle" in run("derive", "v2-90", "--order", "1", "--quantity", "force").out
    narrow = run("derive", "v2-90", "--order", "1", "--quantity", "force", "--set", banks).out
    assert "an ellipse, its long axis vertical" in narrow
    assert "F_long = 1.5" in narrow.replace("3/2", "1.5")
    assert "F_short = 0.5" in narrow.replace("1/2", "0.5")


def test_another_plane_of_reference_is_a_letter(run: Run) -> None:
    out = run("derive", "triple-120", "--order", "1", "--quantity", "couple", "--reference", "0.5").out
    assert "arm a − z₀" in out
    assert "arm −a − z₀" in out
    assert re.search(r"M_up\s+= √3 a cos\(θ − π/6\)", out)


def test_decimals_are_said_to_be_decimals(run: Run) -> None:
    out = " ".join(run("derive", "vw-vr6", "--order", "2", "--quantity", "couple").out.split())
    assert "enclosed decimals, every digit certain" in out
    assert "misses the crankshaft" in out
    assert "enclosed decimals" not in run("derive", "v12-60", "--order", "2").out


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--order", "0"], "above 0 and up to 24"),
        (["--order", "-1"], "above 0 and up to 24"),
        (["--order", "25"], "above 0 and up to 24"),
        (["--order", "nan"], "above 0 and up to 24"),
        (["--order", "two"], "as in 2 or 1,2,4,6"),
        (["--order", ""], "as in 2 or 1,2,4,6"),
        (["--order", ",".join(["1"] * 25)], "up to 24 crank orders"),
        (["--quantity", "roll"], "it can be force, couple"),
        (["--format", "pdf"], "it can be text, latex, markdown, html"),
        (["--notation", "german"], "there are: crankstar, stroke, sinitsyn"),
        (["--symbolic", "gamma"], "there are: alpha, phi, n"),
        (["--symbolic", "phi"], "two parallel cylinders"),
        (["--power", "0"], "from 1 to 24"),
        (["--power", "two"], "whole number"),
        (["--reference", "x"], "z"),
    ],
)
def test_a_request_that_cannot_be_met_is_refused_in_a_sentence(
    refused: Callable[..., str], arguments: list[str], told: str
) -> None:
    assert told in refused("derive", "v8-cross-plane", *arguments)


def test_an_order_that_no_piston_has_is_nothing(run: Run) -> None:
    out = run("derive", "i4", "--order", "3", "--quantity", "force").out
    assert "There is no third-order force: no part of the engine pushes in this order." in " ".join(out.split())


def test_the_signs_of_several_crankshafts_are_refused(refused: Callable[..., str]) -> None:
    assert "one crankshaft" in refused("derive", "square-four", "--signs")
