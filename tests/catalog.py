"""The engines of the catalog: of all layouts in every run, all of them in `make release`."""

from __future__ import annotations

import pytest

from crankstar.files.catalog import names

OFTEN = {
    *("single", "i2-270", "fiat-twinair", "i4", "audi-25-tfsi", "sinitsyn-7-second", "v2-90"),
    *("harley-45", "vw-vr6", "gm-3800", "v8-cross-plane", "v8-flat-plane", "boxer-2", "boxer-6"),
    *("kr250-racer", "napier-lion", "napier-deltic", "jumo-205", "radial-9"),
}
EVERY_NAME = [
    pytest.param(name, marks=[pytest.mark.release] * (name not in OFTEN)) for name in names()
]
EVERY_ENGINE = pytest.mark.parametrize("name", EVERY_NAME)
