"""A file that lacks one size is asked for that size, by the key that gives it."""

from __future__ import annotations

from typing import Any

import pytest

from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.files.catalog import load
from crankstar.studies.fault_kinds import Fault
from crankstar.studies.single_faults import DiagnosisError, shaken

FLAT: dict[str, Any] = {
    "name": "boxer four",
    "firing_order": [1, 3, 2, 4],
    "speed": "5000 rpm",
    "cylinder": {
        "bore": "92 mm",
        "stroke": "79 mm",
        "rod_length": "131 mm",
        "reciprocating_mass": "560 g",
        "rotating_mass": "480 g",
    },
    "layout": {
        "type": "boxer",
        "banks": [
            {"bearing": "90 deg", "cylinders": [1, 3]},
            {"bearing": "-90 deg", "cylinders": [2, 4]},
        ],
        "throws": ["0 deg", "180 deg"],
    },
}
FIVE: dict[str, Any] = {
    "name": "diesel five, no bore",
    "firing_order": [1, 2, 4, 5, 3],
    "speed": "4000 rpm",
    "cylinder": {
        "stroke": "92 mm",
        "rod_length": "150 mm",
        "reciprocating_mass": "780 g",
        "rotating_mass": "700 g",
    },
    "gas": {"ignition": "compression", "compression_ratio": 18, "imep": "14 bar"},
    "layout": {"type": "inline"},
}


def _refused(engine: Engine) -> str:
    with pytest.raises(DiagnosisError) as caught:
        shaken(engine, [Fault("piston", 1, 0.02)])
    return str(caught.value)


def test_the_pitch_is_asked_for_and_enough() -> None:
    told = _refused(engine_of(FLAT))
    assert "give layout.bore_pitch in" in told
    assert "relative" not in told
    layout = {**FLAT["layout"], "bore_pitch": "110 mm", "bank_offset": "40 mm"}
    engine = engine_of({**FLAT, "layout": layout})
    even, heavier = (shaken(engine, each) for each in ((), [Fault("piston", 1, 0.02)]))
    radius, turning = 0.0395, 5000 * 3.141592653589793 / 30
    first = heavier.sizes(None)[:, 0] - even.sizes(None)[:, 0]
    assert first[heavier.orders == 1] == pytest.approx(0.02 * radius * turning**2, rel=1e-9)


def test_the_bore_is_asked_for_with_the_pitch_where_gas_needs_it() -> None:
    assert "give layout.bore_pitch, cylinder.bore in" in _refused(engine_of(FIVE))
    assert "give layout.bore_pitch in" in _refused(engine_of({**FIVE, "gas": None}))


def test_an_explicit_file_is_told_what_its_own_key_names() -> None:
    explicit = {"shafts": "stated"}
    engine = load("man-s50mc-c")
    assert "give cylinder.reciprocating_mass, layout.bore_pitch in" in _refused(engine)
    origin = next(iter(engine.provenance.values()))
    engine = engine.model_copy(update={"provenance": dict.fromkeys(explicit, origin)})
    assert "replace relative mass, pitch in" in _refused(engine)
