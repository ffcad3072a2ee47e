"""Units of results: the choice, its factors against pint, and every printed quantity read back."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cache
from typing import Any

import pint
import pytest
from hypothesis import given
from hypothesis import strategies as st

from crankstar.analyses.verdict.facts import verdict
from crankstar.analysis.document import ROW_UNIT, Column, Document, Remarks, Table
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.files.catalog import load, names
from crankstar.language import shown_units
from crankstar.language.numbers import unit_text
from crankstar.language.shown_units import (
    PREFIXED,
    UnitsError,
    choice_text,
    quantity_text,
    read_choice,
    shown,
    shown_in,
)
from crankstar.remedy.fitting import recommended
from crankstar.tables import analysis
from crankstar.tables.cells import cell, heading
from crankstar.tables.conversion import in_units
from crankstar.tables.engines import description
from crankstar.tables.machine import columns
from crankstar.tables.remedies import Job, balancing_sheet

REGISTRY: pint.UnitRegistry = pint.UnitRegistry()
CHOICES = ["si", "us", "N, N m, kg, mm, g mm", "kN, kN m, t, m, kg m", "lb, lb ft, oz in", "kgf"]
DIGITS = 6e-5
"""Relative error of a number that is printed to five figures."""
NUMBER = r"-?\d+(?:\.\d+)?(?:e[-+]\d+)?"
UNIT = (
    r"(?:MN|kN|N|kgf|lbf)(?: m| ft| a)?\b|(?:kg|g|oz)(?: m²| mm| m| in|\b)|lb in²|lb\b"
    r"|t\b|mm\b|in\b|m\b"
)


@cache
def factor(unit: str) -> float:
    """A printed unit in SI, by pint; a relative length counts as 1."""
    words = {"in": "inch", "a": "", "r": "", "in²": "inch**2", "m²": "m**2"}
    words |= {"lb/in³": "lb/inch**3", "g/cm³": "g/cm**3"}
    product = "*".join(filter(None, (words.get(word, word) for word in unit.split())))
    return float(REGISTRY.Quantity(1.0, product).to_base_units().magnitude)


def si(number: float, unit: str) -> float:
    return number * factor(unit)


def is_physical(unit: str) -> bool:
    return bool(shown_units.dimension(unit)[0])


@pytest.mark.parametrize("choice", CHOICES)
def test_every_factor_is_that_of_pint(choice: str) -> None:
    for unit in (unit for units in PREFIXED.values() for unit in units):
        for largest in (0.0, 3.0, 9.99, 10.0, 4e4, 7e8):
            with shown_in(read_choice(choice)):
                said = shown(unit, largest)
            factor = said.factor * si(1.0, unit_text(said.unit))
            assert factor == pytest.approx(si(1.0, unit_text(unit)), rel=1e-14), (unit, largest)


@pytest.mark.parametrize("unit", ["N/mm", "N*s/m", "mm/s", "m/s^2", "mm/rad", "um"])
@pytest.mark.parametrize("choice", ["us", "kgf", "cm", "lbf, ft"])
def test_what_is_counted_per_length_follows_a_chosen_length(unit: str, choice: str) -> None:
    with shown_in(read_choice(choice)):
        said = shown(unit, 3.0)
    own, now = (
        REGISTRY.Quantity(1.0, each.replace("in", "inch").replace("lbf", "pound_force"))
        for each in (unit, said.unit)
    )
    assert said.factor == pytest.approx(own.to(now).magnitude, rel=1e-12)
    assert shown(unit, 3.0) == (unit, 1.0)


def test_the_unit_without_a_choice_is_the_largest_of_which_there_are_ten() -> None:
    forces = {9_999.0: "9999 N", 10_000.0: "10 kN", 9.9e6: "9900 kN", 1e7: "10 MN", 0.0: "0 N"}
    assert {force: quantity_text(force, "N") for force in forces} == forces
    assert quantity_text(9550.0, "kg") == "9550 kg"
    assert quantity_text(0.0123, "kg*m") == "12.3 kg mm"
    assert quantity_text(0.65, "kg") == "650 g"


@given(
    st.sampled_from([units[0] for units in PREFIXED.values()]),
    st.floats(1e-6, 1e9, allow_subnormal=False),
    st.sampled_from(CHOICES),
)
def test_a_printed_quantity_is_the_quantity(unit: str, value: float, choice: str) -> None:
    with shown_in(read_choice(choice)):
        words = quantity_text(value, unit)
    number, printed = words.split(" ", 1)
    assert si(float(number), printed) == pytest.approx(si(value, unit_text(unit)), rel=DIGITS)


@pytest.mark.parametrize(
    ("text", "choice"),
    [
        ("kN", {"force": ("kN",)}),
        ("kN m", {"moment": ("kN*m",)}),
        ("kN, kN m", {"force": ("kN",), "moment": ("kN*m",)}),
        ("g mm", {"unbalance": ("g*mm",)}),
        ("kg m", {"unbalance": ("kg*m",)}),
        ("oz in", {"unbalance": ("oz*in",)}),
        ("oz-in", {"unbalance": ("oz*in",)}),
        ("lb ft", {"moment": ("lbf*ft",)}),
        ("lb", {"force": ("lbf",), "mass": ("lb",)}),
        ("lb, N", {"force": ("N",), "mass": ("lb",)}),
        ("in", {"length": ("in",)}),
        ("deg", {"angle": ("deg",)}),
        ("SI", {}),
        ("si, kN", {"force": ("kN",)}),
    ],
)
def test_a_choice_has_one_unit_for_each_dimension(
    text: str, choice: dict[str, tuple[str, ...]]
) -> None:
    assert read_choice(text) == choice


def test_the_american_units_are_pounds_feet_inches_and_ounce_inches() -> None:
    us = read_choice("us")
    assert [us[name] for name in ("force", "moment", "length", "unbalance", "density")] == [
        ("lbf",),
        ("lbf*ft",),
        ("in",),
        ("oz*in",),
        ("lb/in^3",),
    ]
    assert read_choice("us, kN m") == {**us, "moment": ("kN*m",)}


def test_american_masses_are_grams_as_on_a_bobweight_card_and_pounds_from_ten_on() -> None:
    with shown_in(read_choice("us")):
        assert [quantity_text(mass, "kg") for mass in (0.65, 2.0114, 4.5, 4.6)] == [
            "650 g",
            "2011.4 g",
            "4500 g",
            "10.141 lb",
        ]
        assert shown("kg", 1e4, prefixed=False).unit == "g"
        assert quantity_text(7850, "kg/m^3") == "0.2836 lb/in³"
    assert quantity_text(7850, "kg/m^3") == "7.85 g/cm³"


@pytest.mark.parametrize("text", [*CHOICES, "us, kN", "us, lb"])
def test_the_text_of_a_choice_names_it_again(text: str) -> None:
    chosen = read_choice(text)
    assert read_choice(choice_text(chosen)) == chosen


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("zork", '"zork" is not known as a unit'),
        ("m/s", '"m/s" measures nothing that is shown'),
        ("N, kN", "N and kN are both units of force"),
        ("N m, lb ft", "N m and lbf ft are both units of moment"),
        ("rad", '"rad": the unit of angle is always deg'),
        ("Hz", '"Hz": the unit of rotational speed is always rpm'),
        ("si, us", "si and us exclude each other"),
        (" , ", "no unit is named"),
        ("9" * 999, "is not known as a unit"),
    ],
)
def test_a_choice_that_cannot_be_is_refused_in_one_sentence(text: str, said: str) -> None:
    with pytest.raises(UnitsError, match=re.escape(said)) as caught:
        read_choice(text)
    assert "\n" not in str(caught.value)
    if "choose" in str(caught.value):
        assert all(unit in str(caught.value) for unit in ("kN m", "lbf ft", "oz in", "g mm", "in"))


@given(st.text(max_size=40))
def test_any_text_is_a_choice_or_a_sentence(text: str) -> None:
    sentence = ""
    try:
        units = read_choice(text)
    except UnitsError as error:
        units, sentence = {}, str(error)
    assert sentence.isprintable()
    assert all(is_physical(unit) for chosen in units.values() for unit in chosen)


def test_units_are_converted_once_however_often_they_are_asked_for() -> None:
    table = Table("", (Column("force", "N"), Column("z", "mm")), ((25_000.0, 12e3), (3.0, None)))
    for choice in CHOICES:
        with shown_in(read_choice(choice)):
            once = in_units(table)
            assert in_units(once) == once


def test_what_has_no_known_size_keeps_its_unit_and_relative_lengths_their_force() -> None:
    with shown_in(read_choice("kN, kN m")):
        assert quantity_text(5.6569, "m*r*w^2") == "5.6569 m r ω²"
        assert quantity_text(2000.0, "N*a") == "2 kN a"
        assert quantity_text(3.0, "m") == "3 m"


def test_a_row_with_its_own_unit_has_it_converted() -> None:
    heads = (Column("unit", kind="unit"), Column("now", ROW_UNIT), Column("order"))
    rows = (("N", 25_000.0, 1.0), ("N*m", 12.0, 2.0), ("m*r*w^2", 3.0, 1.0), ("N", 50.0, 2.0))
    shown_table = in_units(Table("", heads, rows))
    assert shown_table.rows == (
        ("kN", 25.0, 1.0),
        ("N*m", 12.0, 2.0),
        ("m*r*w^2", 3.0, 1.0),
        ("kN", 0.05, 2.0),
    )
    assert cell(shown_table.columns[0], "N*m") == "N m"
    assert heading(shown_table.columns[1]) == ("now", "")


def test_files_for_programs_keep_their_units_until_others_are_named() -> None:
    table = Table("", (Column("force", "N", key="force"),), ((25_000.0,),))
    assert columns(table) == (["force [N]"], [[25_000.0]])
    with shown_in(read_choice("kN")):
        assert columns(table) == (["force [kN]"], [[25.0]])


# -- every engine, every choice: what is printed is the record


def sized(name: str) -> Engine:
    """An engine of the catalog whose unknown sizes are 1 m and 1 kg: a large one."""
    return with_values(load(name), relative=())


@cache
def documents(name: str) -> tuple[Document, ...]:
    engine = sized(name)
    fitted = recommended(engine)
    shown_analysis = analysis.analysis(engine, speed=300.0)
    balanced = [] if fitted is None else [Job(engine, fitted.after, fitted.factor, speed=300.0)]
    return (
        description(engine),
        analysis.document(shown_analysis, angles=[0.0, 1.0]),
        *map(balancing_sheet, balanced),
    )


def amounts(value: Any) -> list[float]:
    if isinstance(value, tuple):
        return [each for item in value for each in amounts(item)]
    return [abs(value)] if isinstance(value, int | float | complex) else []


def read_back(words: str) -> list[float]:
    return [abs(float(each)) for each in re.findall(NUMBER, words.split("∠")[0].replace(",", " "))]


def compare(own: Table, printed: Table) -> int:
    """Compare each cell that has a unit; how many were compared."""
    count = 0
    for row, shown_row in zip(own.rows, printed.rows, strict=True):
        units = (
            dict(zip((c.kind for c in own.columns), row, strict=True)),
            dict(zip((c.kind for c in printed.columns), shown_row, strict=True)),
        )
        for column, value, now, given_ in zip(
            own.columns, row, printed.columns, shown_row, strict=True
        ):
            before, after = column.unit, heading(now)[1].strip("[]")
            if column.unit == ROW_UNIT:
                before, after = str(units[0]["unit"]), unit_text(str(units[1]["unit"]))
            if column.kind == "unit":
                continue
            if not is_physical(before):
                assert cell(column, value) == cell(now, given_)
                continue
            expected = [si(each, unit_text(before)) for each in amounts(value)]
            found = [si(each, after) for each in read_back(cell(now, given_))]
            assert found == pytest.approx(expected, rel=DIGITS, abs=1e-300), (column, value)
            count += len(found)
    return count


@pytest.mark.release
@pytest.mark.parametrize("choice", CHOICES)
def test_every_printed_cell_of_every_engine_is_its_record(choice: str) -> None:
    count = 0
    for name in names():
        for document in documents(name):
            for table in document.tables:
                with shown_in(read_choice(choice)):
                    printed = in_units(table)
                units = {c.unit for c in printed.columns if is_physical(c.unit)}
                by_dimension = {shown_units.dimension(unit) for unit in units}
                assert len(units) == len(by_dimension), "a table mixes units of one dimension"
                count += compare(table, printed)
    assert count > 3000


def quantities(sentences: Iterable[str]) -> list[float]:
    text = "\n".join(sentences)
    return [
        si(float(number), unit)
        for number, unit in re.findall(rf"(?<![\w.])({NUMBER}) ({UNIT})", text)
    ]


def sentences(name: str) -> list[str]:
    engine = sized(name)
    said = [fact.sentence for fact in verdict(engine, speed=300.0, relatives=False)]
    shown_analysis = analysis.analysis(engine, speed=300.0)
    for part in analysis.document(shown_analysis).parts:
        said += part.lines if isinstance(part, Remarks) else part.notes
    return said


@pytest.mark.release
def test_every_quantity_in_a_sentence_is_the_same_in_all_units() -> None:
    count = 0
    for name in names()[::2]:
        plain = quantities(sentences(name))
        for choice in ("us", "kN, kN m, t, m, kg m"):
            with shown_in(read_choice(choice)):
                converted = quantities(sentences(name))
            assert converted == pytest.approx(plain, rel=2 * DIGITS, abs=1e-12), name
        count += len(plain)
    assert count > 200
