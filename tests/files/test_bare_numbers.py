"""Bare numbers beside units: no key of a file takes one in SI while its like have a unit."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any, get_args

import pytest
from tests.texts import SHORT, faults, spoilt

from crankstar.engine.engine import Engine
from crankstar.engine.layouts import LAYOUTS
from crankstar.engine.quantities import Quantity
from crankstar.engine.records import Record
from crankstar.engine.torsion import Chain
from crankstar.files import EngineFileError, bare_numbers, units
from crankstar.files.chains import chain_of
from crankstar.files.forms import quantity_of, short_form
from crankstar.language.faults import ValueFaultError

pytestmark = pytest.mark.quick


def _quantities() -> Iterator[tuple[str, Quantity]]:
    """Every key with a dimension of the explicit and the short forms and of a drive line."""
    seen: set[type[Record]] = set()

    def of(form: type[Record]) -> Iterator[tuple[str, Quantity]]:
        if form in seen:
            return
        seen.add(form)
        for name, info in form.model_fields.items():
            quantity = quantity_of(info)
            if quantity is not None:
                yield f"{form.__name__}.{name}", quantity
            for record in records_in(info.annotation):
                yield from of(record)

    for form in (Engine, Chain, *map(short_form, LAYOUTS)):
        yield from of(form)


def records_in(annotation: Any) -> Iterator[type[Record]]:
    """The records that a type holds, however deep."""
    if isinstance(annotation, type) and issubclass(annotation, Record):
        yield annotation
    for argument in get_args(annotation):
        yield from records_in(argument)


KEYS = dict(_quantities())


def test_the_walk_over_keys_with_a_dimension_meets_each_part_of_an_engine() -> None:
    assert len(KEYS) > 100
    assert {"Torsion.stiffness", "Disc.inertia", "Mount.damping", "Throw.angle"} <= KEYS.keys()


@pytest.mark.parametrize("key", KEYS)
def test_no_key_takes_a_bare_number_in_silence_beside_a_unit_of_its_own_kind(key: str) -> None:
    quantity = KEYS[key]
    bare = replace(quantity, relative_to=frozenset())
    given = bare_numbers.written([("elsewhere", quantity.example, quantity)])
    for value in (0.9, "0.9"):
        with pytest.raises(ValueFaultError) as caught:
            bare_numbers.reader(frozenset(), written=given)(value, bare)
        refused = caught.value.code
        assert refused in ("unit.bare-beside-unit", "unit.bare-beside-one", "unit.missing")
        if refused != "unit.missing":
            unit = units.unit_of(quantity.example)
            assert caught.value.values["like"] == f"0.9 {unit}"
            assert caught.value.values["absolute"] == f"0.9 {units.si_unit(quantity)}"
            for reading in ("like", "absolute"):
                assert units.si(caught.value.values[reading], bare) != 0
    assert bare_numbers.reader(frozenset(), written=given)(0, bare) == 0


STIFF = {"inertia": "0.03 kg*m^2", "stiffness": "1.2 MN*m/rad", "damping": "2 N*m*s/rad"}


@pytest.mark.parametrize(
    ("own", "place", "code"),
    [
        ({"stiffness": 0.9}, ("torsion", "stiffness"), "unit.missing"),
        ({"inertia": 0.03}, ("torsion", "inertia"), "unit.missing"),
        ({"damping": 2}, ("torsion", "damping"), "unit.missing"),
        (
            {"stiffness": ["1.2 MN*m/rad", 0.9, "1.2 MN*m/rad"]},
            ("torsion", "stiffness", 1),
            "unit.bare-beside-one",
        ),
    ],
)
def test_what_twists_has_its_unit_in_a_file_with_units(
    own: dict[str, Any], place: tuple[str | int, ...], code: str
) -> None:
    (fault,) = faults(spoilt(SHORT, torsion=STIFF | own))
    assert (fault.path, fault.code) == (place, code)


def test_a_drive_line_counts_all_its_discs_in_units_or_none() -> None:
    discs = [
        {"name": "motor", "inertia": "2 kg*m^2"},
        {"name": "fan", "inertia": 3, "to": "motor", "stiffness": "6 N*m/rad"},
    ]
    with pytest.raises(EngineFileError) as caught:
        chain_of({"name": "fan drive", "disc": discs})
    (fault,) = caught.value.faults
    assert (fault.path, fault.code) == (("disc", 1, "inertia"), "unit.bare-beside-one")
    bare = [{"name": "motor", "inertia": 2}, {**discs[1], "stiffness": 6}]
    assert chain_of({"name": "fan drive", "disc": bare}).discs[1].stiffness == 6.0


@pytest.mark.parametrize(
    ("value", "beside", "reading"),
    [
        (0.45, "0.009 kg*m^2", "0.45 kg*m^2"),  # both readings are one
        (0.091, "82 mm", "0.091 m"),  # a pitch of 91 um is none
        (0.9, "1.2 MN*m/rad", "0.9 MN*m/rad"),
    ],
)
def test_of_two_readings_only_the_one_that_can_be_meant_is_advised(
    value: float, beside: str, reading: str
) -> None:
    keys = {"kg": "Disc.inertia", "mm": "Cylinder.bore", "rad": "Torsion.stiffness"}
    quantity = next(KEYS[key] for unit, key in keys.items() if unit in beside)
    bare = replace(quantity, relative_to=frozenset())
    given = bare_numbers.written([("elsewhere", beside, quantity)])
    with pytest.raises(ValueFaultError) as caught:
        bare_numbers.reader(frozenset(), written=given)(value, bare)
    assert caught.value.code == "unit.bare-beside-one"
    assert caught.value.values["reading"] == reading
