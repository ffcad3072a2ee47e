"""A firing order that fits more than one set of turns: the record says what the next one does."""

from __future__ import annotations

from math import cos, radians
from typing import Any

import pytest

from crankstar import load
from crankstar.engine.firing_angles import firing_angles, other_angles
from crankstar.files import engine_of
from crankstar.mechanics.gas import cycle
from crankstar.studies.answers import rests_on, torques


def twin(between: float, **others: Any) -> dict[str, Any]:
    """Two in line, the second pin so many degrees behind the first."""
    return {
        "name": "twin",
        "firing_order": [1, 2],
        "speed": "3000 rpm",
        "cylinder": {
            "bore": "80 mm",
            "stroke": "70 mm",
            "rod_length": "130 mm",
            "reciprocating_mass": "400 g",
        },
        "layout": {"type": "inline", "throws": ["0 deg", f"{between} deg"], "bore_pitch": "90 mm"},
        "gas": {"compression_ratio": 10, "imep": "9 bar", "ignition": "spark"},
        **others,
    }


def pair(between: float, order: float) -> float:
    """Of two equal pulses so many degrees apart, over one of them: |1 + exp(-i k x)|."""
    return abs(2 * cos(order * radians(between) / 2))


@pytest.mark.parametrize(("throw", "even", "other"), [(90, 270, 630), (270, 450, 90)])
def test_half_orders_of_a_twin_are_those_of_its_other_turn(
    throw: int, even: int, other: int
) -> None:
    engine = engine_of(twin(throw), name="twin")
    own = firing_angles(engine)
    assert own[1] - own[0] == pytest.approx(even)
    found = rests_on(engine, torques(engine, cycle, running=False))
    [rest] = [each for each in found if each.path == "firing_angles"]
    assert (rest.status, rest.named, rest.value) == ("assumed", True, f"0, {even} deg")
    assert dict(rest.values) == {"other": f"0, {other} deg"}
    moved = rest.moved
    assert moved is not None
    assert (moved.quantity, (moved.order or 0.0) % 1) == ("roll", 0.5)
    right = pair(other, moved.order or 0.0) / pair(even, moved.order or 0.0)
    assert moved.high / moved.now == pytest.approx(right, rel=1e-6)


def test_of_even_sets_the_next_is_taken_by_its_own_count() -> None:
    """All turns of the four of a V, by trial of every one."""
    engine = engine_of(four_of_v(), name="four")
    centres: dict[int, float] = dict(enumerate(FOUR_CENTRES, 1))
    sets: list[tuple[float, list[float]]] = []
    for mask in range(8):
        angles = [0.0]
        for place, number in enumerate(engine.firing_order[1:]):
            angles.append(centres[number] + 360 * (mask >> place & 1))
        steps = [b - a for a, b in zip(angles, [*angles[1:], 720.0], strict=True)]
        if min(steps) > 0:
            sets.append((sum(each**2 for each in steps), angles))
    assert len(sets) > 2
    ranked = sorted({round(size, 6) for size, _angles in sets})
    own, other = firing_angles(engine), other_angles(engine)
    assert other is not None
    for found, right in ((own, ranked[0]), (other, ranked[1])):
        [size] = [size for size, angles in sets if angles == pytest.approx(found)]
        assert size == pytest.approx(right)


FOUR_CENTRES = 0.0, 180.0, 297.59, 117.59


def four_of_v() -> dict[str, Any]:
    """Four in line whose pins stand so that the dead centres are those of a V of 62 degrees."""
    own = twin(0, firing_order=[1, 4, 2, 3])
    throws = [f"{-each % 360} deg" for each in FOUR_CENTRES]
    return own | {"layout": {"type": "inline", "throws": throws, "bore_pitch": "90 mm"}}


@pytest.mark.parametrize("name", ["i4", "v8-cross-plane", "audi-25-tfsi"])
def test_an_order_that_fits_once_is_no_choice(name: str) -> None:
    assert other_angles(load(name)) is None


def test_angles_that_the_file_gives_are_no_choice() -> None:
    given = engine_of(twin(90, firing_angles=["0 deg", "630 deg"]), name="twin")
    assert other_angles(given) is None
    assert firing_angles(given)[1] == pytest.approx(630)
    found = rests_on(given, torques(given, cycle, running=False))
    assert not [each for each in found if each.path == "firing_angles"]
