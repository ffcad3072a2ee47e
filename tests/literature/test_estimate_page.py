"""The page on estimates: its sources are listed, and predictions are what the page says."""

from __future__ import annotations

from tests.rules import test_docs as docs
from tests.scripts import script

from crankstar.engine.weighed import ENGINES

PAGE = vars(script("estimate_page"))


def test_every_engine_has_a_source_in_the_bibliography() -> None:
    known = docs.hooks.entries(docs.text_of("docs/reference/references.bib"))
    assert {engine.reference for engine in ENGINES} <= set(known)


def test_published_masses_are_predicted_as_well_as_the_page_says() -> None:
    every = PAGE["predictions"]()
    inside = sum(one.inside for one in every)
    middle = sorted(abs(one.error) for one in every)[len(every) // 2]
    assert (inside, len(every), round(100 * middle)) == (12, 17, 18)
    assert f"{inside} of {len(every)} published masses" in PAGE["errors"]()


def test_a_prediction_does_not_know_the_engine_it_predicts() -> None:
    one = next(p for p in PAGE["predictions"]() if p.engine.name == "Audi 2.5 TFSI")
    others = [
        mass / e.bore**3
        for e in ENGINES
        if e.kind == "petrol" and e.bore and e.name != one.engine.name
        if (mass := e.piston_group or (e.piston or 0) * PAGE["dressed"]())
    ]
    product = 1.0
    for k in others:
        product *= k ** (1 / len(others))
    assert abs(one.predicted / (product * 0.0825**3) - 1) < 1e-12
