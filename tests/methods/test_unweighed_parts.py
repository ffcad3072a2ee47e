"""Parts of a cylinder that a file does not weigh: what they move, against files that have them."""

from __future__ import annotations

from typing import Any

import pytest
from tests.commands import Run
from tests.files.conftest import run

from crankstar.analysis.assumptions import Assumption
from crankstar.engine.engine import Engine
from crankstar.engine.proportions import dressed
from crankstar.files import engine_of
from crankstar.studies.answers import amplitudes, bobweights, rests_on
from crankstar.studies.assumed_masses import OF_PISTON, masses
from crankstar.tables.assumptions import assumption_lines

__all__ = ["run"]
NAMES = ("force", "couple", "roll")
PARTS = {"piston": 0.42, "rings": 0.038, "small_end": 0.17, "big_end": 0.43}


def eight(**changes: Any) -> Engine:
    """A V8 by its weighed parts, in kg, without a piston pin."""
    parts = {**PARTS, **changes.pop("parts", {})}
    sizes = {"bore": "101.6 mm", "stroke": "88.4 mm", "rod_length": "145 mm"}
    weighed = {name: f"{mass} kg" for name, mass in parts.items() if mass}
    banks = [
        {"bearing": "45 deg", "cylinders": [1, 3, 5, 7]},
        {"bearing": "-45 deg", "cylinders": [2, 4, 6, 8]},
    ]
    layout = {
        "type": "vee", "banks": banks, "bore_pitch": "111.76 mm",
        "throws": ["0 deg", "90 deg", "-90 deg", "180 deg"],
    }  # fmt: skip
    return engine_of(
        {
            "name": "V8", "speed": "6000 rpm", "firing_order": [1, 8, 4, 3, 6, 5, 7, 2],
            "cycle": "four-stroke", "cylinder": {**sizes, "parts": weighed}, "layout": layout,
            **changes,
        }
    )  # fmt: skip


def of(found: tuple[Assumption, ...], part: str) -> Assumption:
    return next(each for each in found if each.path == f"cylinder.parts.{part}")


def rods(**parts: float) -> float:
    """The bobweight of two cylinders on a pin, kg, by the rule of the shops."""
    own = {**PARTS, **parts}
    turning = own["big_end"] + own.get("bearing_shells", 0.0)
    going = own["piston"] + own.get("pin", 0.0) + own["rings"] + own["small_end"]
    return 2 * (turning + 0.5 * going)


def test_a_bobweight_without_a_piston_pin_says_what_the_pin_makes_it() -> None:
    engine = eight()
    assert engine.first.reciprocating == pytest.approx(0.628)
    found = rests_on(engine, bobweights(engine, factor=0.5))
    pin, shells = of(found, "pin"), of(found, "bearing_shells")
    assert found[0] == pin
    assert pin.moved is not None
    assert shells.moved is not None
    assert pin.moved.now == pytest.approx(rods())
    assert pin.moved.low == pytest.approx(rods(pin=0.2 * 0.42))
    assert pin.moved.high == pytest.approx(rods(pin=0.4 * 0.42))
    assert pin.moved.low < rods(pin=0.130) < pin.moved.high
    assert shells.moved.high == pytest.approx(rods(bearing_shells=0.12 * 0.43))
    assert shells.moved.low == pytest.approx(rods())


def test_pins_and_rings_together_hold_what_weighed_engines_have() -> None:
    low, high = (sum(own) for own in zip(*OF_PISTON.values(), strict=True))
    for group, piston in ((0.8318, 0.5839), (0.5306, 0.3836), (97.25, 67.25)):
        assert low < group / piston - 1 < high
    assert low < dressed() - 1 < high


@pytest.mark.parametrize("part", ["pin", "rings", "small_end", "big_end", "bearing_shells"])
@pytest.mark.parametrize("factor", [None, 0.3])
def test_forces_with_a_part_are_those_of_a_file_that_has_it(
    part: str, factor: float | None
) -> None:
    """Counterweights of a balance factor are cut for what the file then has."""
    bare = {"big_end": 0.0, "bearing_shells": 0.04} if part == "big_end" else {part: 0.0}
    more = {} if factor is None else {"balance_factor": factor}
    engine = eight(parts=bare, **more)
    own = of(tuple(masses(engine)), part)
    assert own.high
    assert own.vary is not None
    with_it = eight(parts={**bare, part: own.high}, **more)
    expected = amplitudes(with_it).figures(with_it)
    changed = amplitudes(engine).figures(own.vary(engine, own.high))
    before = amplitudes(engine).figures(engine)
    scale = {name: max(v for key, v in expected.items() if key[0] == name) for name in NAMES}
    for key, size in expected.items():
        assert changed[key] == pytest.approx(size, rel=1e-9, abs=1e-9 * scale[key[0]])
    moves = max(abs(expected[key] - before[key]) / scale[key[0]] for key in expected)
    turns = part in ("big_end", "bearing_shells")
    assert (moves < 1e-9) == (turns and factor is not None)  # a balance factor removes all of it


def test_parts_that_are_weighed_are_not_missing() -> None:
    engine = eight(parts={"pin": 0.13, "bearing_shells": 0.045})
    assert not [each for each in rests_on(engine, amplitudes(engine)) if ".parts." in each.path]


def test_a_part_beside_which_nothing_tells_its_mass_counts_as_zero() -> None:
    engine = eight(parts={"piston": 0.0, "rings": 0.0, "pin": 0.13, "bearing_shells": 0.04})
    found = rests_on(engine, amplitudes(engine))
    assert of(found, "piston").moved is not None
    assert of(found, "rings").moved is None
    assert any("counted as zero: cylinder.parts.rings" in each for each in assumption_lines(found))


def test_a_bobweight_is_not_said_to_have_the_mass_of_the_crank(run: Run) -> None:
    """throw_mass turns in the balancing machine too: it is in no bobweight."""
    engine = eight(parts={"pin": 0.13, "big_end": 0.0})
    found = rests_on(engine, bobweights(engine, factor=0.5))
    own = next(each for each in found if each.path == "cylinder.rotating_mass")
    assert own.moved is not None
    assert own.low is not None
    assert own.moved.low == pytest.approx(2 * (own.low + 0.5 * 0.758))
    assert not any("throw_mass" in each or "crankpin" in each for each in assumption_lines(found))
    printed = run("bobweight", "bmw-f800", "--set", 'cylinder.reciprocating_mass="400 g"').out
    assert "throw_mass" not in printed
