"""LaTeX takes the derivations of every engine of the catalog, and of one with a hostile name."""

from __future__ import annotations

from pathlib import Path

import pytest
from tests.latex import compiled

import crankstar
from crankstar.derive import derivation, documents, family, signs_chapter
from crankstar.derive.notations import NOTATIONS
from crankstar.language.messages import LANGUAGES, spoken

ORDERS = (1, 2, 4, 6)
HOSTILE = "{\\undefined}%$&#_^~<> 直列 Ω é ß"


@pytest.mark.release
@pytest.mark.parametrize("name", crankstar.names())
def test_latex_takes_the_derivations_of_every_engine(name: str, tmp_path: Path) -> None:
    engine = crankstar.load(name)
    chapters = [
        derivation(engine, order, quantity) for order in ORDERS for quantity in ("force", "couple")
    ]
    result = compiled(documents.latex(chapters), tmp_path)
    assert result.ok, str(result)
    assert result.pages >= 2


@pytest.mark.release
@pytest.mark.parametrize("notation", NOTATIONS.values(), ids=NOTATIONS)
def test_latex_takes_every_notation_signs_and_families(
    notation: documents.Notation, tmp_path: Path
) -> None:
    twin = crankstar.load("v2-90")
    chapters = [
        signs_chapter(crankstar.load("sinitsyn-7-first")),
        family(twin, 2, "couple", symbol="alpha"),
    ]
    chapters += [
        family(crankstar.load("parallel-twin-180"), 1, "couple", symbol="phi"),
        derivation(twin, 2),
    ]
    chapters += [family(crankstar.load("triple-120"), 3 * k, "force", symbol="n") for k in (2, 4)]
    result = compiled(documents.latex(chapters, notation), tmp_path)
    assert result.ok, str(result)


@pytest.mark.release
def test_latex_takes_a_hostile_name(tmp_path: Path) -> None:
    engine = crankstar.load("v8-flat-plane")
    cylinders = tuple(c.model_copy(update={"bank": f"{HOSTILE}{c.bank}"}) for c in engine.cylinders)
    hostile = engine.model_copy(update={"name": HOSTILE, "cylinders": cylinders})
    result = compiled(documents.latex([derivation(hostile, 2)]), tmp_path)
    assert result.ok, str(result)


def test_sums_of_the_six_signs_keep_their_sigma_in_latex() -> None:
    written = documents.latex([signs_chapter(crankstar.load("sinitsyn-7-first"))])
    assert "\\Sigma\\mathrm{P}_{R} &=" in written
    assert "?" not in written


@pytest.mark.parametrize("language", LANGUAGES)
def test_page_of_a_derivation_names_its_language(language: str) -> None:
    with spoken(language):
        page = documents.html([derivation(crankstar.load("i4"), 2)])
    assert f'<html lang="{language}">' in page
