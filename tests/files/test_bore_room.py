"""A bore that a file lacks has room beside its neighbours in the row."""

from __future__ import annotations

from typing import Any

import pytest

from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.proportions import inferred, look_of, proportion, row_pitch
from crankstar.files import engine_of
from crankstar.files.catalog import load, names
from crankstar.files.estimate import estimated
from crankstar.studies.gas_alone import usual_bores

DIESEL: dict[str, Any] = {
    "name": "in-line four Diesel 2.0",
    "firing_order": [1, 3, 4, 2],
    "speed": "4000 rpm",
    "cylinder": {
        "stroke": "95.5 mm",
        "rod_length": "144 mm",
        "reciprocating_mass": "790 g",
        "rotating_mass": "640 g",
    },
    "layout": {"type": "inline", "bore_pitch": "88 mm"},
    "gas": {"ignition": "compression", "compression_ratio": 16.5, "bmep": "14 bar"},
}


def bare(engine: Engine) -> Engine:
    """The engine without its bores."""
    return with_values(
        engine, cylinders=tuple(with_values(own, bore=None) for own in engine.cylinders)
    )


def test_the_bore_of_a_real_engine_is_within_what_is_said_of_it() -> None:
    """Those with usual proportions of stroke, and those that only their pitch tells."""
    seen = 0
    for name in names():
        engine = load(name)
        bore, pitch = engine.first.bore, row_pitch(engine)
        if bore is None or pitch is None or "radius" in engine.relative:
            continue
        without = bare(engine)
        look = look_of(without, without.gas)
        assert look is not None
        stroke = proportion("stroke", inferred(look)[0])
        if not stroke.low <= look.stroke / bore <= stroke.high:
            continue
        low, high = usual_bores(without) or (0.0, 0.0)
        assert low <= 1e3 * bore <= high, name
        assert high <= 1e3 * pitch / 1.05 + 1e-9, name
        seen += 1
    assert seen >= 9


def test_where_the_stroke_says_too_much_the_pitch_says_it() -> None:
    """The engine has 81 mm; by its stroke alone 82.8 to 120 mm were said."""
    low, high = usual_bores(engine_of(DIESEL)) or (0.0, 0.0)
    assert low == pytest.approx(88 / 1.35)
    assert high == pytest.approx(88 / 1.05)
    assert low < 81 < high
    filled = {each.path: each for each in estimated(DIESEL).filled}["cylinder.bore"]
    assert (1e3 * filled.low, 1e3 * filled.high) == pytest.approx((low, high), rel=1e-2)
    assert 79e-3 < filled.typical < 83e-3


def test_a_displacement_is_kept_where_the_pitch_limits_the_bore() -> None:
    """2 l in four bores of 70 mm pitch: no wider than 66.7 mm, with the stroke that makes 2 l."""
    tree = {**DIESEL, "layout": {"type": "inline", "bore_pitch": "70 mm"}}
    tree["cylinder"] = {"rod_ratio": 3.5}
    found = {each.path: each for each in estimated(tree, displacement=2e-3).filled}
    bore, stroke = found["cylinder.bore"], found["cylinder.stroke"]
    assert bore.high <= 0.070 / 1.05 + 1e-6
    volume = 4 * 3.141592653589793 / 4 * bore.typical**2 * stroke.typical
    assert volume == pytest.approx(2e-3, rel=2e-2)


@pytest.mark.parametrize(
    ("layout", "order", "pitch"),
    [
        ({"type": "inline", "positions": ["0 mm", "90 mm", "200 mm", "290 mm"]}, [1, 3, 4, 2], 90),
        (
            {
                "type": "vee",
                "banks": [
                    {"bearing": "-45 deg", "cylinders": [1, 3]},
                    {"bearing": "45 deg", "cylinders": [2, 4]},
                ],
                "throws": ["0 deg", "180 deg"],
                "bore_pitch": "100 mm",
                "bank_offset": "20 mm",
            },
            [1, 2, 3, 4],
            100,
        ),
        (
            {
                "type": "boxer",
                "banks": [
                    {"bearing": "-90 deg", "cylinders": [1, 2]},
                    {"bearing": "90 deg", "cylinders": [3, 4]},
                ],
                "throws": ["0 deg", "180 deg"],
                "bore_pitch": "110 mm",
                "bank_offset": "40 mm",
            },
            [1, 4, 3, 2],
            110,
        ),
        ({"type": "inline"}, [1, 3, 4, 2], None),
    ],
)
def test_cylinders_of_a_row_limit_each_other(
    layout: dict[str, Any], order: list[int], pitch: float | None
) -> None:
    """Not those across, on the same pin with rods side by side; nothing without a pitch."""
    tree = {**DIESEL, "layout": layout, "firing_order": order}
    found = row_pitch(engine_of(tree))
    assert (found and 1e3 * found) == (pitch and pytest.approx(pitch))


@pytest.mark.parametrize("name", ["radial-9", "pratt-whitney-wasp"])
def test_the_cylinders_of_a_star_limit_nothing_along_the_shaft(name: str) -> None:
    assert row_pitch(load(name)) is None


def test_cylinders_one_behind_the_other_limit_nothing() -> None:
    """They stand at one place of the shaft, as pistons of one tandem rod do."""
    first = load("audi-25-tfsi")
    cylinders = tuple(with_values(own, z=0.0) for own in first.cylinders)
    assert row_pitch(with_values(first, cylinders=cylinders)) is None
