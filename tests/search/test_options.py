"""Options of a search: their values, and every fault with its option and code."""

from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

import crankstar
from crankstar import load
from crankstar.language.search_faults import SENTENCES
from crankstar.options.search import measure, search_of, whole_number
from crankstar.options.words import SearchWords
from crankstar.stars.faults import SearchError, fault, said
from crankstar.stars.options import Measure, SearchOptions, search_for
from crankstar.stars.question import All, Best, Front


def faults(about: Any, **words: Any) -> list[tuple[str, str]]:
    """Paths and codes of all faults; an engine is given by its name."""
    with pytest.raises(SearchError) as raised:
        search_of(load(about) if isinstance(about, str) else about, SearchWords(**words))
    assert all(said(each) for each in raised.value.faults)
    return [(".".join(map(str, each.path)), each.code) for each in raised.value.faults]


@pytest.mark.parametrize("name", ["M0", "T0", "M101", "M1.5", "M1V", "F2H", "neighbours"])
def test_a_quantity_is_called_by_the_name_that_was_typed(name: str) -> None:
    assert measure(name).name == name


@pytest.mark.parametrize(
    ("about", "words", "path", "code"),
    [
        ("v8-cross-plane", {}, "", "shared-pins"),
        ("boxer-6", {}, "", "not-in-line"),
        ("ducati-90", {}, "", "one-throw"),
        ("radial-9", {}, "", "one-throw"),
        ("single", {}, "", "one-cylinder"),
        ("i6", {"gaps": "1"}, "gaps", "engine-gaps"),
        ("i6", {"cycle": "two-stroke"}, "cycle", "engine-cycle"),
        (7, {"minimise": "Q3"}, "minimise", "no-quantity"),
        (7, {"minimise": "roll"}, "minimise", "roll-alike"),
        (7, {"limit": ["roll 2=1"]}, "limit", "roll-alike"),
        (7, {"minimise": "M\u00b2"}, "minimise", "no-quantity"),
        (7, {"minimise": "M0"}, "minimise", "order"),
        (7, {"minimise": "M1,M1"}, "minimise", "named-twice"),
        (7, {"minimise": "M1,M2,M3,M4,M5,M6,neighbours"}, "minimise", "too-many-objectives"),
        (7, {"minimise": "T2"}, "minimise", "needs-shape"),
        (8, {"minimise": "T2.5", "mode_shape": "8,7,6,5,4,3,2,1"}, "minimise", "half-torsion"),
        (7, {"minimise": "F1"}, "minimise", "alike-throws"),
        (7, {"minimise": "M7"}, "minimise", "alike-order"),
        (7, {"minimise": "M1.5"}, "minimise", "half-order"),
        (7, {"minimise": ""}, "minimise", "none-named"),
        (7, {"minimise": "couple"}, "minimise", "needs-engine"),
        (7, {"minimise": "0*M1", "best": "3"}, "minimise", "weight"),
        (7, {"minimise": "2*M1,M2"}, "minimise", "weights-unused"),
        (7, {"zero": ","}, "zero", "none-named"),
        (7, {"zero": "neighbours"}, "zero", "zero-neighbours"),
        (7, {"limit": ["M2"]}, "limit", "limit-form"),
        (7, {"limit": ["M2=-1"]}, "limit", "limit-form"),
        (7, {"limit": ["neighbours=1.5"]}, "limit", "limit-whole"),
        (7, {"gaps": "1,1"}, "gaps", "gap-count"),
        (7, {"gaps": ""}, "gaps", "gaps"),
        (7, {"gaps": "1,0,1,1,1,1"}, "gaps", "gaps"),
        (7, {"fix": "1"}, "fix", "fixed-form"),
        (7, {"fix": "9=2"}, "fix", "fixed-cylinder"),
        (7, {"fix": "1=9"}, "fix", "fixed-direction"),
        (7, {"fix": "1=0,1=2"}, "fix", "fixed-twice"),
        (7, {"fix": "1=0,2=0"}, "fix", "fixed-crowded"),
        (8, {"fix": "1=0,8=1", "symmetric": True}, "fix", "fixed-mirror"),
        (7, {"symmetric": True}, "symmetric", "symmetric"),
        (7, {"front": True, "best": "3"}, "", "several-answers"),
        (7, {"best": "0"}, "best", "best"),
        (7, {"best": "1.5"}, "best", "best"),
        (7, {"mode_shape": "1,2,3,4,5,6,7"}, "mode_shape", "shape-unused"),
        (7, {"mode_shape": "1,2", "minimise": "T1"}, "mode_shape", "shape-count"),
        (7, {"mode_shape": "1,x,1,1,1,1,1", "minimise": "T1"}, "mode_shape", "shape-form"),
        (7, {"mode_shape": "1,1,1,1,1,1,1", "minimise": "T1"}, "mode_shape", "shape-uniform"),
        (7, {"all_with": "1-2-3"}, "all_with", "all-with-form"),
        (7, {"all_with": "1-2-x"}, "all_with", "all-with-text"),
        (7, {"all_with": "M1=x"}, "all_with", "all-with-value"),
        (7, {"all_with": "neighbours=1"}, "all_with", "all-with-neighbours"),
    ],
)
def test_each_fault_names_its_option_and_nothing_else_is_reported(about, words, path, code):
    assert faults(about, **words) == [(path, code)]


def test_every_fault_is_reported_at_once():
    words = {"fix": "9=1", "symmetric": True, "minimise": "Q3,M0", "limit": ["M2"], "best": "0"}
    wanted = ["best", "fix", "limit", "minimise", "minimise", "symmetric"]
    assert sorted(path for path, _ in faults(7, **words)) == wanted


@pytest.mark.parametrize("text", ["1", "-3", "25", "9999999"])
def test_a_number_of_cylinders_without_stars_is_refused(text):
    with pytest.raises(SearchError) as raised:
        whole_number(text)
    assert raised.value.faults[0].code == "cylinders"
    assert whole_number("12") == 12
    assert whole_number("i4") is None


def test_a_host_writes_options_in_its_own_words():
    unused = fault("mode_shape", "shape-unused")
    assert "--minimise M1" in said(unused, lambda option: f"--{option}")
    assert "`best`, `all`" in said(fault("", "several-answers"), lambda option: f"`{option}`")
    text = SearchError([unused]).text(lambda option: f"--{option.replace('_', '-')}")
    assert text.startswith("--mode-shape: ")


def test_what_is_quoted_stays_as_it_was_written():
    raised = fault("minimise", "no-quantity", given='"M1--fix {best}"')
    assert '"M1--fix {best}"' in said(raised, lambda option: f"`{option}`")


def test_defaults_are_values():
    usual, named = search_for(7, SearchOptions()), search_of(7, SearchWords(minimise="M1,M2"))
    assert usual == named
    assert isinstance(usual.question.ask, Front)
    one = search_for(7, SearchOptions(minimise=((1.0, Measure("M", Fraction(1))),)))
    assert one.question.ask == Best(20)
    assert search_of(7, SearchWords(all=True)).question.ask == All()


def test_every_sentence_is_in_use():
    package = Path(crankstar.__file__).parent
    text = "".join(path.read_text(encoding="utf-8") for path in package.rglob("*.py"))
    assert [code for code in SENTENCES if text.count(f'"{code}"') < 2] == []
