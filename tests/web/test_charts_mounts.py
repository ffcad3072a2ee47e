"""Charts of mounts: no text on another, none cut off, on any of several engines."""

from __future__ import annotations

from typing import Any

import pytest
from playwright.sync_api import Page
from tests.files.test_mounts import BLOCK, GROUND, THREE
from tests.texts import SHORT, spoilt
from tests.web.test_charts_print import assert_clear

from crankstar import charts
from crankstar.files import engine_of

GAS = {"imep": "4 bar", "compression_ratio": 10, "speed": "900 rpm"}
MANY = [
    {"name": f"mount {place}", "right": right, "z": z, "stiffness": "150 N/mm"}
    for place, (right, z) in enumerate(
        [(side, along) for side in ("-0.4 m", "0.4 m") for along in ("-0.5 m", "0 m", "0.4 m")], 1
    )
]
KINDS: dict[str, dict[str, Any]] = {
    "three mounts": {},
    "a foundation": {"foundation": GROUND},
    "six mounts": {"mounts": MANY},
    "products of inertia": {"block": {**BLOCK, "product_up_z": "-0.9 kg*m^2", "right": "40 mm"}},
}


@pytest.mark.release
@pytest.mark.parametrize("kind", KINDS)
def test_texts_of_charts_of_mounts_are_clear(kind: str, page: Page) -> None:
    own = {"block": BLOCK, "mounts": THREE, "gas": GAS, **KINDS[kind]}
    engine = engine_of(spoilt(SHORT, **own))
    drawings = {
        "layout": charts.mount_layout_chart(engine, at=(0.3, 0.2, 0.1)),
        "modes": charts.mount_mode_chart(engine),
        "transmissibility": charts.transmissibility_chart(engine),
    }
    for quantity in ("velocity", "hand-arm", "force", "mounts"):
        drawings[quantity] = charts.mount_response_chart(engine, quantity=quantity)
    assert_clear({name: charts.svg(made, name) for name, made in drawings.items()}, page)
