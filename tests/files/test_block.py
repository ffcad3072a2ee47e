"""The `[block]` table of an engine file: read, written, shown, and every mistake in it told."""

from __future__ import annotations

import json
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.commands import Run
from tests.texts import EXPLICIT, SHORT, spoilt, told

import crankstar
from crankstar.engine.records import Block
from crankstar.files import engine_of, toml, tree_of

GIVEN = {
    "mass": "165 kg",
    "up": "112 mm",
    "right": "-3 mm",
    "z": "15 mm",
    "inertia_up": "9.6 kg*m^2",
    "inertia_right": "10.4 kg*m^2",
    "inertia_z": "4.1 kg*m^2",
}


@pytest.mark.parametrize("text", [SHORT, EXPLICIT])
def test_both_forms_take_a_block_and_give_it_back(text: str) -> None:
    engine = engine_of(spoilt(text, block=GIVEN))
    block = engine.block
    assert block is not None
    assert (block.mass, block.up, block.right, block.z) == pytest.approx(
        (165.0, 0.112, -0.003, 0.015)
    )
    assert block.inertia == pytest.approx((9.6, 10.4, 4.1))
    assert engine_of(tree_of(toml(engine))).block == block
    assert engine_of(json.loads(json.dumps(crankstar.files.explicit(engine)))).block == block


def test_a_block_may_be_a_mass_alone_or_left_out() -> None:
    block = engine_of(spoilt(SHORT, block={"mass": "165 kg"})).block
    assert block is not None
    assert block.inertia is None
    assert block.z is None
    assert "block" not in toml(engine_of(tree_of(SHORT)))


def test_an_engine_without_masses_counts_its_block_in_its_own() -> None:
    tree = spoilt(SHORT, block={"mass": 40.0})
    del tree["cylinder"]["reciprocating_mass"]
    del tree["cylinder"]["rotating_mass"]
    block = engine_of(tree).block
    assert block is not None
    assert block.mass == 40.0


@pytest.mark.parametrize(
    ("changes", "path", "sentence"),
    [
        ({"mass": "0 kg"}, "block.mass", "must be greater than 0"),
        ({"mass": "-3 kg"}, "block.mass", "must be greater than 0"),
        ({"mass": "165 mm"}, "block.mass", "mass"),
        ({"inertia_z": "0 kg*m^2"}, "block.inertia_z", "must be greater than 0"),
        ({"inertia_z": "nan kg*m^2"}, "block.inertia_z", ""),
        ({"inertia_up": None}, "block.inertia_up", "give all three, or none"),
        ({"inertia_z": "21 kg*m^2"}, "block.inertia_z", "at most the sum of the two others"),
        (
            {"inertia_up": "15 kg*m^2"},
            "block.inertia_up",
            "more than inertia_right, inertia_z together (14.5)",
        ),
        ({"wieght": "3 kg"}, "block.wieght", "is not a key"),
    ],
)
@pytest.mark.parametrize("text", [SHORT, EXPLICIT])
def test_what_no_engine_has_is_refused_where_it_stands(
    text: str, changes: dict[str, Any], path: str, sentence: str
) -> None:
    table = {key: value for key, value in (GIVEN | changes).items() if value is not None}
    ((where, message),) = told(spoilt(text, block=table)).items()
    assert where == path
    assert sentence in message


def test_moments_of_inertia_to_three_figures_may_miss_the_sum_by_rounding() -> None:
    assert engine_of(spoilt(SHORT, block=GIVEN | {"inertia_up": "14.51 kg*m^2"})).block is not None


def test_show_tells_of_the_block(run: Run) -> None:
    said = run(
        "show", "audi-25-tfsi", "--set", "block.mass='183 kg'", "--set", "block.up='90 mm'"
    ).out
    assert "The whole engine as a rigid body: mass 183 kg" in said
    assert "mass 183 kg, centre of mass 90 mm up, 0 mm right, in the middle" in said


SIZES = st.floats(1e-3, 1e3).map(lambda size: float(f"{size:.6g}"))
PLACES = st.floats(-2, 2).map(lambda place: round(place, 6))


@st.composite
def blocks(draw: st.DrawFn) -> Block:
    """Any block that a body could be: moments of inertia are sums of two of three shares."""
    inertia: dict[str, float] = {}
    if draw(st.booleans()):
        one, two, three = draw(SIZES), draw(SIZES), draw(SIZES)
        inertia = {"inertia_up": one + two, "inertia_right": two + three, "inertia_z": three + one}
    z = draw(st.none() | PLACES)
    place = {"up": draw(PLACES), "right": draw(PLACES), "z": z}
    mass = 6.0 + draw(SIZES)  # more than the moving parts of the V8
    return Block.model_validate({"mass": round(mass, 6), **place, **inertia})


@pytest.mark.release
@given(blocks())
def test_any_block_is_the_same_written_and_read_back(block: Block) -> None:
    engine = engine_of(tree_of(SHORT)).model_copy(update={"block": block})
    again = engine_of(tree_of(toml(engine))).block
    assert again is not None
    for name in Block.model_fields:
        value = getattr(block, name)
        assert getattr(again, name) == (
            None if value is None else pytest.approx(value, rel=1e-12, abs=1e-12)
        )
