"""The engines of the catalog: of all layouts in every run of the tests, all of them in the long."""

from __future__ import annotations

import pytest

from crankstar.files.catalog import names

OFTEN = {
    *("single", "i2-270", "bmw-f800", "fiat-twinair", "triumph-675", "i4", "yamaha-r1-crossplane"),
    *("audi-25-tfsi", "toyota-2jz", "sinitsyn-7-second", "man-s90mc-c", "sinitsyn-8-two-stroke"),
    *("v2-90", "harley-45", "v4-90", "vw-vr6", "gm-3800", "v8-cross-plane", "v8-flat-plane"),
    *("bmw-s65", "merlin", "boxer-2", "bmw-r1200", "subaru-ej25", "boxer-6", "square-four"),
    *("kr250-racer", "brough-golden-dream", "napier-lion", "napier-deltic", "jumo-205"),
    *("radial-9", "pratt-whitney-wasp"),
}
EVERY_NAME = [
    pytest.param(name, marks=[pytest.mark.long] * (name not in OFTEN)) for name in names()
]
EVERY_ENGINE = pytest.mark.parametrize("name", EVERY_NAME)
