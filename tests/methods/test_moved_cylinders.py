"""Cylinders that `[[cylinders]]` puts elsewhere: their throws go with them."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.mechanics.balance import balance, total

LAYOUTS: dict[str, dict[str, Any]] = {
    "in line": {"type": "inline", "throws": ["0 deg", "180 deg", "180 deg", "0 deg"]},
    "a V with a throw for each": {
        "type": "vee",
        "banks": [
            {"bearing": "-45 deg", "cylinders": [1, 3]},
            {"bearing": "45 deg", "cylinders": [2, 4]},
        ],
        "throws": ["0 deg", "180 deg"],
        "pin_split": "30 deg",
        "bank_offset": "40 mm",
    },
    "boxer": {
        "type": "boxer",
        "banks": [{"cylinders": [1, 3]}, {"cylinders": [2, 4]}],
        "throws": ["0 deg", "180 deg"],
        "bank_offset": "40 mm",
    },
}
SIZES = {
    "stroke": "60 mm",
    "rod_length": "115 mm",
    "reciprocating_mass": "300 g",
    "rotating_mass": "300 g",
}


def made(layout: dict[str, Any], z: dict[int, float] | None = None) -> Engine:
    tree: dict[str, Any] = {
        "name": "four",
        "speed": "6000 rpm",
        "cylinder": SIZES,
        "layout": {"bore_pitch": "100 mm", **layout},
    }
    if z:
        tree["cylinders"] = [{"number": n, "z": f"{at!r} m"} for n, at in z.items()]
    return engine_of(tree)


def test_a_cylinder_that_is_moved_takes_its_throw_with_it() -> None:
    """Two rotating masses of 300 g at 30 mm, 200 mm apart and opposite each other."""
    tree = {
        "name": "twin 180, cylinder 2 moved by z",
        "firing_order": [1, 2],
        "speed": "6000 rpm",
        "cylinder": SIZES | {"reciprocating_mass": "1 mg"},
        "layout": {"type": "inline", "throws": ["0 deg", "180 deg"], "bore_pitch": "100 mm"},
        "cylinders": [{"number": 2, "z": "-150 mm"}],
    }
    engine = engine_of(tree)
    assert [throw.z for throw in engine.shafts[0].throws] == pytest.approx([0.05, -0.15])
    couple = total(balance(engine, speed=engine.speed)).couple
    speed = 6000 * np.pi / 30
    by_hand = 0.3 * 0.03 * speed**2 * 0.2
    assert np.abs(couple.forward[couple.orders == 1]) == pytest.approx(by_hand, rel=1e-5)
    assert by_hand == pytest.approx(710.61, abs=0.01)


@pytest.mark.parametrize("layout", LAYOUTS.values(), ids=[*LAYOUTS])
def test_cylinders_moved_one_by_one_are_those_of_uneven_pitches(layout: dict[str, Any]) -> None:
    count = 4 if layout["type"] == "inline" else 2
    uneven = made(layout | {"positions": [f"{70 * n + 15 * n * n} mm" for n in range(count)]})
    moved = made(layout, {cylinder.number: cylinder.z for cylinder in uneven.cylinders})
    assert [each.z for each in moved.cylinders] == pytest.approx([e.z for e in uneven.cylinders])
    throws, wanted = moved.shafts[0].throws, uneven.shafts[0].throws
    assert [(t.angle, t.z) for t in throws] == [
        (pytest.approx(t.angle), pytest.approx(t.z)) for t in wanted
    ]
    sums = [total(balance(each, speed=each.speed)) for each in (moved, uneven)]
    for name in ("force", "couple"):
        one, other = (getattr(each, name) for each in sums)
        scale = np.abs(sums[1].couple.forward).max()
        assert one.forward == pytest.approx(other.forward, abs=1e-12 * scale)
        assert one.backward == pytest.approx(other.backward, abs=1e-12 * scale)


def test_a_first_cylinder_that_points_elsewhere_is_at_top_dead_centre_at_zero() -> None:
    tree = {
        "name": "single",
        "cylinder": SIZES,
        "layout": {"type": "inline", "throws": ["0 deg"]},
        "cylinders": [{"number": 1, "bearing": "90 deg"}],
    }
    assert engine_of(tree).shafts[0].throws[0].angle == pytest.approx(np.pi / 2)
