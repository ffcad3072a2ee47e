"""Text with a unit to SI and back.

What is understood, what is refused, and that nothing is lost on the way.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, Literal, get_args

import annotated_types
import pint
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import BaseModel

from crankstar.engine.engine import Engine
from crankstar.engine.quantities import (
    ANGLE,
    COUPLE,
    FORCE,
    LEAST,
    LENGTH,
    POSITION,
    SPEED,
    Quantity,
)
from crankstar.files import bare_numbers, units
from crankstar.language.faults import ValueFaultError
from crankstar.language.units import ANGLES, DEFINITIONS, definitions, measured

pytestmark = pytest.mark.quick

SIZE = replace(LENGTH, least=LEAST)
MASS = Quantity("mass", "650 g", frozenset({"mass"}))
INERTIA = Quantity("moment of inertia", "0.002 kg*m^2", frozenset({"mass", "radius"}))
UNBALANCE = Quantity("unbalance", "0.02 kg*m", frozenset({"mass", "radius"}))
QUANTITIES = [ANGLE, LENGTH, POSITION, SPEED, MASS, INERTIA, UNBALANCE]
INCH, POUND = 0.0254, 0.45359237
"""Metres, kilograms: exact by the international agreement of 1959."""
GRAVITY = 9.80665
"""m/s^2: the standard value of the third General Conference on Weights and Measures, 1901."""
TURN = 2 * math.pi

UNITS = [
    (
        LENGTH,
        {
            "m": 1,
            "mm": 1e-3,
            "cm": 1e-2,
            "um": 1e-6,
            "in": INCH,
            "inch": INCH,
            "inches": INCH,
            "ft": 12 * INCH,
        },
    ),
    (
        LENGTH,
        {
            "metre": 1,
            "millimetre": 1e-3,
            "millimeter": 1e-3,
            "centimetre": 1e-2,
            "foot": 12 * INCH,
            "feet": 12 * INCH,
        },
    ),
    (
        MASS,
        {
            "kg": 1,
            "g": 1e-3,
            "grams": 1e-3,
            "mg": 1e-6,
            "t": 1e3,
            "lb": POUND,
            "lbs": POUND,
            "oz": POUND / 16,
        },
    ),
    (
        ANGLE,
        {
            "rad": 1,
            "deg": TURN / 360,
            "degrees": TURN / 360,
            "turn": TURN,
            "rev": TURN,
            "\u00b0": TURN / 360,
        },
    ),
    (
        SPEED,
        {
            "rpm": TURN / 60,
            "rad/s": 1,
            "rev/min": TURN / 60,
            "rev/s": TURN,
            "Hz": TURN,
            "deg/s": TURN / 360,
        },
    ),
    (
        SPEED,
        {
            "/min": TURN / 60,
            " 1/min": TURN / 60,
            "r/min": TURN / 60,
            "min^-1": TURN / 60,
            "min-1": TURN / 60,
        },
    ),
    (
        INERTIA,
        {
            "kg*m^2": 1,
            "kg m^2": 1,
            "kg m2": 1,
            "kg\u00b7m\u00b2": 1,
            "g*m^2": 1e-3,
            "kg*mm^2": 1e-6,
            "lb*in^2": POUND * INCH**2,
        },
    ),
    (
        UNBALANCE,
        {
            "kg*m": 1,
            "kg m": 1,
            "g*mm": 1e-6,
            "g mm": 1e-6,
            "kg\u22c5mm": 1e-3,
            "oz*in": POUND / 16 * INCH,
            "oz in": POUND / 16 * INCH,
            "oz-in": POUND / 16 * INCH,
            "g cm": 1e-5,
        },
    ),
    (
        FORCE,
        {
            "N": 1,
            "kN": 1e3,
            "MN": 1e6,
            "kgf": GRAVITY,
            "lbf": POUND * GRAVITY,
            "lb": POUND * GRAVITY,
            "ozf": POUND / 16 * GRAVITY,
        },
    ),
    (
        COUPLE,
        {
            "N m": 1,
            "Nm": 1,
            "kN m": 1e3,
            "kN\u00b7m": 1e3,
            "MN m": 1e6,
            "kgf m": GRAVITY,
            "lbf ft": POUND * GRAVITY * 12 * INCH,
            "lb ft": POUND * GRAVITY * 12 * INCH,
            "lb-ft": POUND * GRAVITY * 12 * INCH,
            "ft lb": POUND * GRAVITY * 12 * INCH,
            "in-lb": POUND * GRAVITY * INCH,
            "oz in": POUND / 16 * GRAVITY * INCH,
        },
    ),
]
EACH = [(quantity, unit, factor) for quantity, factors in UNITS for unit, factor in factors.items()]


@pytest.mark.parametrize(("quantity", "unit", "factor"), EACH, ids=[unit for _, unit, _ in EACH])
def test_every_unit_is_what_it_is(quantity: Quantity, unit: str, factor: float) -> None:
    for number in ("2", "-1.5", "+.25", "3.", "1e-1", "2E+0"):
        for text in (f"{number} {unit}", f"{number}{unit}", f"  {number}   {unit} "):
            assert units.si(text, quantity) == pytest.approx(float(number) * factor, rel=1e-15)


@pytest.mark.release
def test_pint_reads_every_product_of_two_units_alike() -> None:
    registry: pint.UnitRegistry = pint.UnitRegistry(None)  # pyright: ignore[reportArgumentType]
    registry.load_definitions(DEFINITIONS.strip().splitlines())
    names = [name for name in definitions() if len(name) <= 12]  # no longer one is read
    single = [name + end for name in names for end in ("", "s", "ss", "^2", "^-3", "x")]
    kinds: dict[str, object] = {}
    for unit in [*single, *(f"{a}{sign}{b}" for a in names for b in names for sign in ("*", "/"))]:
        try:
            base: Any = registry.Quantity(1.0, registry.parse_units(unit)).to_base_units()
        except AttributeError:  # what pint raises for an unknown unit is one
            with pytest.raises(ValueError, match=re.escape(unit[:2])):
                measured(unit)
            continue
        dimensions, factor = measured(unit)
        assert factor == pytest.approx(base.magnitude, rel=1e-15), unit
        assert kinds.setdefault(str(base.units), dimensions) == dimensions, unit
    assert len(set(kinds.values())) == len(kinds)


def test_the_unit_of_every_example_is_known() -> None:
    assert [units.si(quantity.example, quantity) for quantity in QUANTITIES] == pytest.approx(
        [math.pi / 2, 0.0825, 0.1055, 100 * TURN, 0.65, 0.002, 0.02]
    )


@given(st.sampled_from(EACH), st.floats(1e-3, 10, allow_subnormal=False), st.sampled_from([1, -1]))
def test_a_number_with_a_unit_is_the_number_times_the_unit(
    each: tuple[Quantity, str, float], number: float, sign: int
) -> None:
    quantity, unit, factor = each
    assert units.si(f"{sign * number!r} {unit}", quantity) == pytest.approx(
        sign * number * factor, rel=1e-14
    )


@given(
    st.sampled_from(QUANTITIES),
    st.floats(1e-6, 90, allow_subnormal=False),
    st.sampled_from([1, -1, 0]),
)
def test_what_is_written_is_read_back(quantity: Quantity, number: float, sign: int) -> None:
    value = sign * number
    text = units.text(value, quantity)
    assert units.si(text, quantity) == pytest.approx(value, rel=1e-14)
    assert re.fullmatch(r"[-+.\de]+ [a-z/*^2]+", text)


@pytest.mark.parametrize(
    ("value", "quantity", "text"),
    [
        (0.0825, LENGTH, "82.5 mm"),
        (0.65, MASS, "650 g"),
        (2.5, MASS, "2.5 kg"),
        (-0.25 * TURN, ANGLE, "-90 deg"),
        (100 * TURN, SPEED, "6000 rpm"),
        (0.0, LENGTH, "0 mm"),
        (0.002, INERTIA, "0.002 kg*m^2"),
    ],
)
def test_a_value_is_written_in_the_unit_a_reader_expects(
    value: float, quantity: Quantity, text: str
) -> None:
    assert units.text(value, quantity, digits=12) == text


@pytest.mark.parametrize(
    "value", ["\u0663 mm", "\uff18\uff12 mm", "82\u00a0mm", "82\u2009mm", "\u221282 mm", "82\tmm"]
)
def test_numbers_and_blanks_of_other_scripts_are_read(value: str) -> None:
    assert abs(units.si(value, LENGTH)) in (0.003, 0.082)


@pytest.mark.parametrize(
    ("value", "quantity", "message"),
    [
        ("82 kg", LENGTH, 'is "82 kg", a mass; a length is needed, such as "82.5 mm"'),
        ("5 m^2", LENGTH, 'is "5 m^2", an area; a length is needed, such as "82.5 mm"'),
        ("5 m m", LENGTH, 'is "5 m m", an area; a length is needed, such as "82.5 mm"'),
        (
            "5 kg*m",
            INERTIA,
            'is "5 kg*m", an unbalance; a moment of inertia is needed, such as "0.002 kg*m^2"',
        ),
        (
            "5 zork",
            MASS,
            'is "5 zork", whose unit "zork" is not known; a mass is needed, such as "650 g"',
        ),
        (
            "6000 rpn",
            SPEED,
            (
                'is "6000 rpn", whose unit "rpn" is not known; a '
                'rotational speed is needed, such as "6000 rpm"'
            ),
        ),
        (
            "82,5 mm",
            LENGTH,
            'is "82,5 mm"; write numbers with a decimal point and no other commas, as in "82.5 mm"',
        ),
        (
            "6,000 rpm",
            SPEED,
            (
                'is "6,000 rpm"; write numbers with a decimal point and no other commas, as '
                'in "6000 rpm"'
            ),
        ),
        ("mm", LENGTH, 'is "mm", not a number with a unit; a length is needed, such as "82.5 mm"'),
        (82.5, LENGTH, "is 82.5 m; the largest plausible value is 5 m. Did you mean 82.5 mm?"),
        (90, ANGLE, "is 90 rad; the largest plausible value is 6.2832 rad. Did you mean 90 deg?"),
        (
            "1 km",
            LENGTH,
            'is "1 km", whose unit "km" is not known; a length is needed, such as "82.5 mm"',
        ),
        (
            "101 m",
            LENGTH,
            'is "101 m", too large for an engine; a length is needed, such as "82.5 mm"',
        ),
        (
            "1e-5 mm",
            SIZE,
            'is "1e-5 mm", too small for an engine; a length is needed, such as "82.5 mm"',
        ),
        (float("nan"), MASS, 'is nan; a mass is needed, such as "650 g"'),
        (float("-inf"), MASS, 'is -inf; a mass is needed, such as "650 g"'),
        (True, MASS, 'is true; a mass is needed, such as "650 g"'),
        (None, MASS, 'is null; a mass is needed, such as "650 g"'),
        ([1], MASS, 'is a list; a mass is needed, such as "650 g"'),
        pytest.param(
            10**5000,
            MASS,
            'is a number of thousands of digits; a mass is needed, such as "650 g"',
            id="digits",
        ),
        (
            "9" * 2000,
            MASS,
            f'is "{"9" * 57}...", not a number with a unit; a mass is needed, such as "650 g"',
        ),
    ],
)
def test_what_is_refused_is_refused_in_one_sentence(
    value: object, quantity: Quantity, message: str
) -> None:
    with pytest.raises(ValueError, match=r".") as caught:
        units.si(value, quantity)
    assert str(caught.value).removeprefix("the value ") == message


def understood(value: object, quantity: Quantity) -> tuple[float, str]:
    """The number a value stands for, or the sentence that refuses it."""
    try:
        return units.si(value, quantity), ""
    except ValueError as error:
        return 0.0, str(error).removeprefix("the value ")


@pytest.mark.release
@given(
    st.sampled_from(QUANTITIES),
    st.text(max_size=80) | st.from_regex(r"[-+]?[0-9.]{0,4}(e[0-9]{1,4})? ?[a-z*/^0-9 ]{0,12}"),
)
def test_any_text_at_all_gives_a_finite_number_or_a_sentence(quantity: Quantity, text: str) -> None:
    number, message = understood(text, quantity)
    assert math.isfinite(number)
    assert not message or (message.startswith("is ") and ";" in message and message.isprintable())


@given(
    st.sampled_from(QUANTITIES),
    st.integers() | st.floats() | st.none() | st.booleans() | st.lists(st.integers(), max_size=2),
)
def test_anything_but_text_gives_a_finite_number_or_a_sentence(
    quantity: Quantity, value: object
) -> None:
    number, message = understood(value, quantity)
    assert math.isfinite(number)
    assert not message or message.startswith("is ")


def test_a_place_may_be_as_near_to_nought_as_rounding_brings_it() -> None:
    assert units.si("-6.9e-15 mm", POSITION) == pytest.approx(-6.9e-18)
    assert bare_numbers.reader(frozenset({"radius", "pitch"}))(-6.9e-18, POSITION) == -6.9e-18
    with pytest.raises(ValueError, match="too small for an engine"):
        units.si("6.9e-15 mm", SIZE)


def measured_sizes(of: type[BaseModel], seen: set[type]) -> Iterator[tuple[str, Quantity]]:
    """Every field of a record, and of those in it, that is a quantity not below nought."""
    seen.add(of)
    for name, field in of.model_fields.items():
        yield from ((f"{of.__name__}.{name}", each) for each in sizes_in(field, field.annotation))
        for record in records_in(field.annotation):
            if record not in seen:
                yield from measured_sizes(record, seen)


def records_in(kind: Any) -> Iterator[type[BaseModel]]:
    """The records that a type names."""
    if isinstance(kind, type) and issubclass(kind, BaseModel):
        yield kind
    for inner in get_args(kind):
        yield from records_in(inner)


def sizes_in(field: Any, kind: Any) -> Iterator[Quantity]:
    """The quantities of a field, its own or inside its type, that are not below nought."""
    own = [*getattr(field, "metadata", ()), *getattr(kind, "__metadata__", ())]
    flat = [*own, *(one for each in own for one in getattr(each, "metadata", ()))]
    signed = not any(isinstance(each, annotated_types.Ge | annotated_types.Gt) for each in flat)
    yield from (each for each in flat if isinstance(each, Quantity) and not signed)
    for inner in get_args(kind):
        yield from sizes_in(None, inner)


def test_no_size_of_an_engine_may_be_next_to_nothing() -> None:
    found = dict(measured_sizes(Engine, set()))
    dimensions = {each.dimension for each in found.values()}
    assert {"stiffness", "damping", "torsional stiffness", "moment of inertia"} <= dimensions
    assert {"torsional damping", "bending stiffness", "unbalance", "temperature"} <= dimensions
    for key, quantity in found.items():
        unit = units.si_unit(quantity)
        assert units.si(f"0 {unit}", quantity) == 0, key
        with pytest.raises(ValueError, match="too small for an engine"):
            units.si(f"1e-300 {unit}", quantity)


def test_what_is_not_known_is_counted_in_itself() -> None:
    read = bare_numbers.reader(frozenset({"radius"}))
    assert read(4, LENGTH) == read("4", LENGTH) == 4
    assert read("0 mm", LENGTH) == 0
    assert read("650 g", MASS) == 0.65
    cases: tuple[tuple[Any, Literal["unknown", "relative"], str], ...] = (
        ("82.5 mm", "unknown", "unit.unknown-radius"),
        (1e9, "unknown", "unit.bare-out-of-range"),
        ("1 mm", "relative", "unit.relative-radius"),
    )
    for value, because, code in cases:
        with pytest.raises(ValueFaultError) as error:
            bare_numbers.reader(frozenset({"radius"}), because=because)(value, LENGTH)
        assert error.value.code == code


@pytest.mark.parametrize("text", ["0..360 deg by 10", "0...90", "10 … 20 deg", "1.5 .. 2 deg"])
def test_a_range_where_one_value_is_wanted_is_told_as_such(text: str) -> None:
    with pytest.raises(ValueFaultError) as error:
        units.si(text, Quantity("angle", "90 deg"))
    assert 'a range; one value is needed, such as "90 deg"' in error.value.at("--theta")


@pytest.mark.parametrize(
    ("typed", "degrees"),
    [
        ("90度", 90),
        ("９０ 度", 90),
        ("１２０°", 120),
        ("９０．５ deg", 90.5),
        ("－３０　deg", -30),
        ("120 град", 120),
        ("120 град.", 120),
        ("21 градус", 21),
        ("2.5 Градуса", 2.5),
        ("1.5 рад", math.degrees(1.5)),
        ("2 оборота", 720),
        ("0.5回転", 180),
    ],
)
def test_an_angle_is_read_as_japanese_and_russian_readers_type_it(
    typed: str, degrees: float
) -> None:
    assert math.degrees(units.si(typed, ANGLE)) == pytest.approx(degrees, abs=1e-12)


def test_full_width_digits_are_digits_in_every_quantity() -> None:
    assert units.si("８２．５ ｍｍ", LENGTH) == pytest.approx(0.0825)
    assert units.si("６５０ g", Quantity("mass", "650 g")) == pytest.approx(0.65)


def test_a_unit_of_angles_measures_nothing_else() -> None:
    with pytest.raises(ValueFaultError) as refused:
        units.si("90 度", LENGTH)
    assert refused.value.code == "unit.unknown"


def test_the_page_knows_the_units_of_angles_that_files_know() -> None:
    source = (Path(__file__).parents[2] / "web/src/angle.ts").read_text(encoding="utf-8")
    rows = dict(re.findall(r"^  (\w+): (1|360|180 / Math\.PI),$", source, re.MULTILINE))
    factors = {"deg": "1", "rad": "180 / Math.PI", "turn": "360"}
    assert {word: rows.get(word) for word in ANGLES} == {
        word: factors[unit] for word, unit in ANGLES.items()
    }
