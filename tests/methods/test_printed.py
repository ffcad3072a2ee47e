"""An independent parser reads every printed derivation; each equation must be true as printed.

In text, LaTeX and MathML, for any formula, and for every line of the derivations of every engine of
the catalog and of random engines: each member of a chain of equations is the Balance.
"""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Iterable, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from flint import acb, arb
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from tests import printed
from tests.catalog import EVERY_ENGINE, OFTEN
from tests.exactly import MP, evaluated, orders_of, short_engines, snapped
from tests.judged import Judged, lines
from tests.strategies import OF_ANY_KIND, RELEASE

from crankstar import spectra
from crankstar.derive import (
    Chapter,
    Derivation,
    DerivationError,
    Line,
    derivation,
    documents,
    family,
    inertia_torque,
    signs_chapter,
)
from crankstar.derive.algebra import cyclotomic, enclosure, evaluation, formula, typeset
from crankstar.derive.algebra.formula import Decimal, Formula, Symbol
from crankstar.derive.cure import cure
from crankstar.derive.errata import errata
from crankstar.derive.notations import CRANKSTAR, SINITSYN, STROKE, Notation, notated
from crankstar.derive.records import Quantity
from crankstar.derive.torques import in_harmonics, torque_harmonic
from crankstar.engine.engine import Engine
from crankstar.files import catalog, tree_of
from crankstar.files.read import engine_of
from crankstar.mechanics.balance import balance
from crankstar.mechanics.excitation import Totals, rolling_moment
from crankstar.remedy import end_webs

# -- any formula

NAMES = ("a", "b", "b_1", "A_2", "A′_4", "theta", "lambda", "psi")
RATIONALS = st.builds(
    lambda above, below: formula.number(Fraction(above, below)),
    st.integers(-60, 60),
    st.sampled_from([1, 1, 2, 3, 8, 1001]),
)
DECIMALS = st.builds(
    lambda n, scale, digits: Decimal(arb(n) * arb(2) ** scale, digits),
    st.integers(-5000, 5000).filter(bool),
    st.sampled_from([-10, -10, -20, -40]),
    st.integers(3, 12),
)
SYMBOLS = st.sampled_from(NAMES).map(lambda name: Symbol(*name.split("_")))
LEAVES = st.one_of(
    RATIONALS,
    DECIMALS,
    SYMBOLS,
    st.just(formula.Pi()),
    st.builds(formula.Degrees, RATIONALS | DECIMALS),
)


def grown(parts: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    """Formulas made of formulas, as they are written and as the algebra makes them."""
    several = st.lists(parts, min_size=1, max_size=4).map(tuple)
    return st.one_of(
        st.builds(formula.Sum, several),
        st.builds(formula.Product, several),
        several.map(lambda made: formula.summed(*made)),
        several.map(lambda made: formula.product(*made)),
        st.builds(formula.Root, parts),
        st.builds(formula.Power, parts, st.integers(-2, 4)),
        st.builds(formula.Ratio, parts, parts),
        st.builds(formula.Applied, st.sampled_from(["cos", "sin", "atan"]), parts),
        st.builds(formula.Polar, parts, parts),
        parts.map(formula.negative),
        parts.map(lambda part: formula.Product((formula.number(-1), part))),
    )


TREES = st.recursive(LEAVES, grown, max_leaves=16)
VALUES = {name: (37 + 11 * place) / 64 for place, name in enumerate(NAMES)}


def readings(tree: Formula) -> dict[str, list[printed.Token]]:
    """The tokens of a formula in each kind of print."""
    mathml = ET.fromstring(f"<math>{typeset.mathml(tree)}</math>")  # noqa: S314
    return {
        typeset.text(tree): printed.from_text(typeset.text(tree)),
        typeset.latex(tree): printed.from_latex(typeset.latex(tree)),
        typeset.mathml(tree): printed.from_mathml(mathml),
    }


def ball(value: Any, digits: int = 14) -> acb:
    """A number in sixty digits as a ball some digits wide."""
    number = MP.mpc(value)
    real, imaginary = (arb(MP.nstr(part, 60)) for part in (number.real, number.imag))
    wide = arb(0, max(1.0, float(abs(number)))) * arb(10) ** -digits
    return acb(real + wide, imaginary + wide)


@pytest.mark.release
@settings(max_examples=500)
@given(TREES)
def test_any_formula_read_back_from_its_print_is_the_formula(tree: Formula) -> None:
    try:
        truth = evaluated(tree, {name: MP.mpf(value) for name, value in VALUES.items()})
    except (ValueError, ZeroDivisionError):
        assume(False)
    assume(MP.isfinite(truth) and abs(truth) < 1e100)
    with cyclotomic.precision(50):
        values = {name: acb(value) for name, value in VALUES.items()}
        for shown, tokens in readings(tree).items():
            assert printed.value(tokens, values).overlaps(ball(truth)), shown


@pytest.mark.parametrize(
    ("shown", "tree"),
    [
        ("−(a + b)", formula.product(-1, formula.Sum((Symbol("a"), Symbol("b"))))),
        (
            "a − (b − a)",
            formula.Sum(
                (
                    Symbol("a"),
                    formula.product(
                        -1, formula.Sum((Symbol("b"), formula.product(-1, Symbol("a"))))
                    ),
                )
            ),
        ),
        ("√(2a)", formula.Root(formula.product(2, Symbol("a")))),
        ("cos(θ) a", formula.product(formula.cosine(formula.THETA), Symbol("a"))),
        (
            "(1 + √2)/4 · a",
            formula.product(
                formula.Ratio(
                    formula.Sum((formula.number(1), formula.Root(formula.number(2)))),
                    formula.number(4),
                ),
                Symbol("a"),
            ),
        ),
    ],
)
def test_brackets_stand_where_a_reader_needs_them(shown: str, tree: Formula) -> None:
    assert typeset.text(tree) == shown


@pytest.mark.parametrize(
    ("text", "truth"),
    [("2a/3b", 2 / 9), ("−a²", -1), ("cos 2θ b", 1.0), ("√2 b", 4.242640687), ("6/2 · 3", 9)],
)
def test_the_reader_reads_as_people_do(text: str, truth: float) -> None:
    values = {"a": acb(1), "b": acb(3), "theta": acb(0)}
    assert abs(complex(printed.value(printed.from_text(text), values)) - truth) < 1e-9


@pytest.mark.parametrize("text", ["2 3", "(a", "a −", "cos (", "cos⁻¹ a", "a + − b"])
def test_the_reader_refuses_what_cannot_be_read(text: str) -> None:
    with pytest.raises(printed.UnreadableError):
        printed.value(printed.from_text(text), {"a": acb(1), "b": acb(3)})


# -- every line of a derivation

THETA = 0.7


class Letters(dict[str, Any]):
    """Values of letters; one that has none gets a number of its own."""

    def __missing__(self, name: str) -> Any:
        self[name] = arb(0 if "left" in name or name == "…" else 100 + hash_of(name)) / 128
        return self[name]


def hash_of(name: str) -> int:
    return sum(ord(char) * (place + 1) for place, char in enumerate(name)) % 97


def in_text(line: Line) -> list[list[printed.Token]]:
    members = re.split(r"\s+=\s", documents.equations(line))
    return [printed.from_text(shown) for shown in members[line.name is not None :]]


def in_latex(line: Line) -> list[list[printed.Token]]:
    inner = documents.aligned(line).removeprefix("\\begin{aligned}\n")
    rows = inner.removesuffix("\n\\end{aligned}").split(" \\\\\n")
    members: list[str] = []
    for row in rows:
        _, _, right = row.partition("&")
        if right.startswith("="):
            members.append(right[1:])
        else:
            members[-1] += right
    return [printed.from_latex(shown) for shown in members]


def in_mathml(line: Line) -> list[list[printed.Token]]:
    members: list[list[printed.Token]] = []
    for row in ET.fromstring(documents.chain(line)).iter("mtr"):  # noqa: S314
        _, equals, right = row
        if equals.find("mo") is not None:
            members.append([])
        members[-1] += printed.from_mathml(right)
    return members


def untrue(lines: Iterable[Line], letters: Mapping[str, arb]) -> list[str]:
    """Lines of which a member, as it is printed, is not its formula, or not the first member."""
    out: list[str] = []
    for line in lines:
        trees = [near(evaluation.enclosed(tree, letters)) for tree in line.chain]
        for read in (in_text, in_latex, in_mathml):
            members = [printed.value(tokens, letters) for tokens in read(line)]
            assert len(members) == len(trees)
            for place, member in enumerate(members):
                if not (member.overlaps(trees[place]) and member.overlaps(trees[0])):
                    out.append(
                        f"{read.__name__}, {line.label}, {place}: {documents.equations(line)}"
                    )
    return out


def near(value: Any) -> acb:
    """A ball around a value that rounding in the letters cannot leave."""
    wide = arb(0, 1e-9 * max(1.0, float(abs(acb(value)).mid())))
    return acb(value) + acb(wide, wide)


def unlike_the_balance(judged: Judged, letters: Mapping[str, arb]) -> list[str]:
    """Lines of which a member, as it is printed, is not what the Balance has for these parts."""
    out: list[str] = []
    for _, line in lines(judged.told):
        if line.kind not in ("signal", "forward", "backward") or not line.rows:
            continue
        truth = (
            judged.signal(line.bearing_deg, line.rows, THETA)
            if line.kind == "signal"
            else judged.vector(line.kind, line.rows)
        )
        for read in (in_text, in_latex, in_mathml):
            for tokens in read(line):
                member = printed.value(tokens, letters) * judged.told.scale
                if not (member - acb(complex(truth))).overlaps(around(judged.allowed)):
                    out.append(f"{read.__name__}, {line.label}: {documents.equations(line)}")
    return out


def around(radius: float) -> acb:
    return acb(arb(0, radius), arb(0, radius))


def checked(engine: Engine, order: Fraction | float, quantity: Any) -> Derivation:
    told = derivation(engine, order, quantity)
    with cyclotomic.precision(50):
        letters = Letters({name: arb(value) for name, value in told.symbols.items()})
        letters["theta"] = arb(THETA)
        assert unlike_the_balance(Judged.of(engine, told), letters) == []
        assert untrue((line for _, line in lines(told)), letters) == []
    return told


def flat_six(**layout: Any) -> Engine:
    """A flat six whose left bank is written at -90 deg, its banks a part of the pitch apart."""
    banks = [
        {"name": "right", "bearing": "-90 deg", "cylinders": [1, 3, 5]},
        {"name": "left", "bearing": "90 deg", "cylinders": [2, 4, 6]},
    ]
    described = {"type": "vee", "banks": banks, "throws": ["0 deg", "120 deg", "60 deg"]}
    tree = {
        "format": 1,
        "name": "flat six",
        "cylinder": {"rod_ratio": 4},
        "layout": described | {"bank_offset": 0.3} | layout,
    }
    return engine_of(tree)


@pytest.mark.parametrize("order", [1, 2, 4])
@pytest.mark.parametrize("quantity", ["force", "couple"])
def test_a_bank_that_lies_at_minus_90_degrees_keeps_its_brackets(order: int, quantity: Any) -> None:
    checked(flat_six(), order, quantity)


def test_the_share_of_a_whole_bank_to_the_right_is_printed_in_brackets() -> None:
    told = checked(flat_six(), 1, "couple")
    right = [line for _, line in lines(told) if line.label == "right"]
    assert "= −(" in documents.equations(right[0]).replace("\n", " ")


@pytest.mark.release
@pytest.mark.parametrize("name", ["boxer-6", "v8-cross-plane", "audi-25-tfsi", "napier-lion"])
def test_derivations_of_a_few_engines_are_true_as_they_are_printed(name: str) -> None:
    for order in (1, 2):
        for quantity in ("force", "couple"):
            checked(catalog.load(name), order, quantity)


@pytest.mark.release
@EVERY_ENGINE
def test_derivations_of_the_catalog_are_true_as_they_are_printed(name: str) -> None:
    for order in (1, 2, 4, 6, 8):
        for quantity in ("force", "couple"):
            checked(catalog.load(name), order, quantity)


@pytest.mark.release
@settings(max_examples=15)
@given(st.data(), short_engines(), st.sampled_from(["force", "couple"]))
def test_derivations_of_engines_with_short_numbers_are_true_as_they_are_printed(
    data: Any, engine: Engine, quantity: Any
) -> None:
    checked(engine, data.draw(orders_of(engine)), quantity)


@pytest.mark.release
@settings(max_examples=200)
@given(st.data(), st.sampled_from(sorted(OF_ANY_KIND)), st.sampled_from(["force", "couple"]))
def test_derivations_of_any_engine_are_true_as_they_are_printed(
    data: Any, kind: str, quantity: Any
) -> None:
    engine = data.draw(OF_ANY_KIND[kind])
    if data.draw(st.booleans()):
        engine = snapped(engine, data.draw(st.sampled_from([4, 8, 12, 24, 14, 360])))
    try:
        checked(engine, data.draw(orders_of(engine)), quantity)
    except DerivationError as error:
        assume("too near to locking" not in str(error))
        raise


# -- families, the six signs, cures, errata, notations


def letters_for(chapter: Chapter, **values: float) -> Letters:
    letters = Letters({name: arb(value) for name, value in chapter.symbols.items()})
    letters |= {name: arb(value) for name, value in values.items()}
    letters["theta"] = arb(THETA)
    return letters


def lines_of(chapter: Chapter) -> list[Line]:
    return [line for step in chapter.steps for line in step.lines]


@pytest.mark.parametrize(
    ("name", "symbol"),
    [
        ("v8-cross-plane", "alpha"),
        ("v2-90", "alpha"),
        ("v12-60", "alpha"),
        ("parallel-twin-180", "phi"),
        ("triple-120", "n"),
        ("sinitsyn-7-first", "n"),
    ],
)
@pytest.mark.parametrize("order", [1, 2, 4])
@pytest.mark.parametrize("quantity", ["force", "couple"])
def test_families_are_true_as_they_are_printed(
    name: str, symbol: str, order: int, quantity: Any
) -> None:
    if (symbol, quantity) == ("n", "couple"):
        return
    engine = catalog.load(name)
    chapter = family(engine, order, quantity, symbol=symbol)
    with cyclotomic.precision(50):
        letters = letters_for(chapter, alpha=0.6, phi=1.1, n=len(engine.cylinders))
        assert untrue(lines_of(chapter), letters) == []


@pytest.mark.parametrize(
    "name", ["sinitsyn-6-valve", "sinitsyn-7-first", "v8-cross-plane", "gm-3800", "vw-vr6"]
)
@pytest.mark.parametrize("notation", [CRANKSTAR, SINITSYN], ids=lambda own: own.name)
def test_the_six_signs_are_true_as_they_are_printed(name: str, notation: Notation) -> None:
    chapter = notated(signs_chapter(catalog.load(name)), notation)
    with cyclotomic.precision(50):
        assert untrue(lines_of(chapter), letters_for(chapter)) == []


@pytest.mark.many(first=4)
@pytest.mark.parametrize("notation", [STROKE, SINITSYN], ids=lambda own: own.name)
@pytest.mark.parametrize("name", ["v8-flat-plane", "audi-25-tfsi", "boxer-6", "v2-90"])
def test_other_notations_are_true_as_they_are_printed(name: str, notation: Notation) -> None:
    lines: tuple[tuple[int, Quantity], ...] = ((2, "force"), (1, "couple"), (4, "force"))
    for order, quantity in lines:
        chapter = notated(derivation(catalog.load(name), order, quantity), notation)
        with cyclotomic.precision(50):
            assert untrue(lines_of(chapter), letters_for(chapter)) == []


@pytest.mark.parametrize("name", ["v8-cross-plane", "sinitsyn-7-first", "vw-vr6", "triple-120"])
def test_cures_are_true_as_they_are_printed(name: str) -> None:
    engine = catalog.load(name)
    planes = end_webs(engine, engine.shafts[0])
    for ratio in (1, -1):
        try:
            chapter = cure(engine, ratio=ratio, planes=planes).chapter
        except DerivationError:
            continue
        with cyclotomic.precision(50):
            assert untrue(lines_of(chapter), letters_for(chapter)) == []


def false_torques(engine: Engine, order: int) -> list[str]:
    """Printed torques that the Balance does not have; DerivationError where there is no form."""
    chapter, result = inertia_torque(engine, order), balance(engine)
    first = engine.first
    ratio = Fraction(first.rod_length / engine.throw(first).radius).limit_denominator(10**6)
    harmonic = torque_harmonic(ratio, order)
    torque = spectra.amplitude(spectra.selected(result.torque, [order]))[:, 0]
    whole = Totals(result.force, result.couple, result.axis_moment, result.torque)
    roll = spectra.amplitude(spectra.selected(rolling_moment(whole), [order]))[:, 0]
    allowed = 1e-12 * len(engine.cylinders) * max(1.0, float(np.abs(result.torque.forward).max()))
    out: list[str] = []
    with cyclotomic.precision(50):
        letters = letters_for(chapter)
        out += untrue(lines_of(chapter), letters)
        for line in lines_of(chapter):
            if line.kind not in ("torque", "roll"):
                continue
            amplitude = (torque if line.kind == "torque" else roll)[list(line.rows)].sum()
            truth = float((amplitude * np.exp(1j * order * THETA)).real)
            for read in (in_text, in_latex, in_mathml):
                for tokens in read(line):
                    member = printed.value(tokens, letters) * harmonic
                    if not (member - truth).overlaps(around(allowed)):
                        out.append(f"{read.__name__}, {line.label}: {documents.equations(line)}")
    return out


@pytest.mark.release
def test_torques_of_the_catalog_are_true_as_printed_or_refused() -> None:
    refused: dict[str, str] = {}
    tried = catalog.names() if RELEASE else sorted(OFTEN)
    for name in tried:
        engine = catalog.load(name)
        try:
            assert [false_torques(engine, order) for order in (1, 2, 3, 4, 6)] == [[]] * 5, name
        except DerivationError as error:
            refused[name] = str(error)
    assert all(sentence.endswith(".") for sentence in refused.values())
    assert len(refused) < 0.42 * len(tried)
    assert {"napier-deltic", "radial-9", "vw-vr6"} <= set(refused)


@pytest.mark.release
@given(
    st.lists(st.integers(0, 23), min_size=1, max_size=5),
    st.sampled_from([1.25, 3, 3.7, 8]),
    st.sampled_from(["clockwise", "counter-clockwise"]),
    st.integers(-6, 12),
    st.integers(1, 8),
)
def test_torques_of_random_engines_are_true_as_they_are_printed(
    throws: list[int], ratio: float, rotation: str, bearing: int, order: int
) -> None:
    layout = {
        "type": "inline",
        "bearing": f"{15 * bearing} deg",
        "throws": [f"{15 * throw} deg" for throw in throws],
    }
    tree = {"format": 1, "name": "any", "rotation": rotation, "cylinder": {"rod_ratio": ratio}}
    assert false_torques(engine_of(tree | {"layout": layout}), order) == []


@pytest.mark.many(first=5)
@pytest.mark.parametrize("order", range(1, 9))
def test_a_torque_harmonic_is_its_sum_of_products_and_its_series(order: int) -> None:
    ratio = Fraction(6)
    letters = {f"A_{n}": enclosure.coefficient(ratio, n) for n in range(2, 40)} | {
        "…": arb(0),
        "lambda": arb(1) / 6,
    }
    with cyclotomic.precision(30):
        exact = torque_harmonic(ratio, order)
        products = evaluation.enclosed(in_harmonics(order), letters)
        assert abs(products - exact) < arb(10) ** -9
        line = next(
            line
            for line in lines_of(inertia_torque(catalog.load("single"), order, power=17))
            if line.kind == "series"
        )
        assert abs(evaluation.enclosed(line.chain[0], letters) - exact) < arb(10) ** -11


def test_the_series_of_the_torque_is_that_of_the_textbooks() -> None:
    """lambda/4 sin - 1/2 sin 2 - 3 lambda/4 sin 3 - lambda^2/4 sin 4: signs turned."""
    single = catalog.load("single")
    first = {}
    for order in (1, 2, 3, 4):
        chapter = inertia_torque(single, order)
        (line,) = (line for line in lines_of(chapter) if line.kind == "series")
        first[order] = line.series[0]
    expected = {1: (1, "-1/4"), 2: (0, "1/2"), 3: (1, "3/4"), 4: (2, "1/4")}
    assert first == {order: (power, Fraction(value)) for order, (power, value) in expected.items()}


def test_errata_are_printed_as_they_are() -> None:
    letters = Letters({"theta": arb(THETA)})
    with cyclotomic.precision(50):
        for erratum in errata():
            trees = [erratum.ours, *([erratum.printed] if erratum.printed is not None else [])]
            trees += [erratum.unit] if erratum.unit is not None else []
            assert untrue([Line(None, (tree,)) for tree in trees], letters) == [], erratum.id
            for tree in trees:
                for shown, tokens in readings(tree).items():
                    truth = near(evaluation.enclosed(tree, letters))
                    assert printed.value(tokens, letters).overlaps(truth), shown


@pytest.mark.parametrize("ratio", [2, 4, 10, 40])
@pytest.mark.parametrize("order", [2, 4, 8, 12, 24])
def test_every_printed_digit_of_a_harmonic_is_true(ratio: int, order: int) -> None:
    ball = enclosure.coefficient(Fraction(ratio), order)
    with cyclotomic.precision(50):
        for tokens in readings(Decimal(ball, 12)).values():
            read = printed.value(tokens, {}).real
            assert read.overlaps(ball)
            assert read.rad() < abs(ball) * arb("1e-11")


def test_results_alone_are_printed_whole_though_another_says_the_same() -> None:
    chapters = [derivation(catalog.load("audi-25-tfsi"), order) for order in (4, 6)]
    results = [replace(chapter, steps=chapter.steps[-2:-1]) for chapter in chapters]
    ((said,),) = {result.steps[0].words for result in results}
    for page in documents.html_parts(results):
        assert said in page
        assert "<math" in page


def test_a_product_in_the_place_of_a_letter_is_multiplied_out_in_front() -> None:
    """2 x with 3 y for x is 6 y, also below a root and beside what has no letters."""
    x, y, three = Symbol("x"), Symbol("y"), formula.number(3)
    names = {"x": formula.product(3, y)}
    assert formula.renamed(formula.product(2, x), names) == formula.product(6, y)
    under = formula.Root(formula.summed(x, three))
    assert formula.renamed(under, names) == formula.Root(
        formula.summed(formula.product(3, y), three)
    )
    assert formula.renamed(formula.Power(x, 2), {"x": y}) == formula.Power(y, 2)
    assert formula.renamed(formula.Applied("cos", x), {"x": y}) == formula.Applied("cos", y)


SLAVE = """
name = "slave of a long rod at half speed"
cycle = "two-stroke"
[[shaft]]
name = "one"
throw = [{ angle = "0 deg", radius = "125 mm" }]
[[shaft]]
name = "two"
speed_ratio = "1/2"
throw = [{ angle = "0 deg", radius = "125 mm" }]
[[cylinders]]
number = 1
shaft = "one"
throw = 1
rod_length = "127.5 mm"
reciprocating_mass = "1 kg"
[[cylinders]]
number = 2
shaft = "two"
throw = 1
offset = "62.5 mm"
rod_length = "937.5 mm"
reciprocating_mass = "0 kg"
[[cylinders]]
number = 4
shaft = "two"
throw = 1
rod_length = "438.058473459602 mm"
reciprocating_mass = "0 kg"
big_end_mass = "2 kg"
[cylinders.articulated]
master = 2
radius = "62.5 mm"
angle = "57.2957795130823 deg"
"""


def test_an_amplitude_of_no_certain_digit_is_printed_by_its_places() -> None:
    """The eighth harmonic of a slave's big end, 5e-10 of a unit: an interval a seventh as wide."""
    told = checked(engine_of(tree_of(SLAVE)), Fraction(4), "force")
    shown = str([documents.equations(line) for _, line in lines(told)])
    assert "0.000000000…" in shown
    assert "+/-" not in shown
