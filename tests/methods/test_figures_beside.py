"""Figures of two engines on the page: one scale for both, each at its own speed."""

from __future__ import annotations

import json
import re
from typing import Any

import pytest

from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.files.catalog import load
from crankstar.page.figures import chart

CROSS, FLAT = "v8-cross-plane", "v8-flat-plane"
FIGURES = [
    "over-turn:quantity=force",
    "over-turn:quantity=couple",
    "over-turn:quantity=roll",
    "hodograph:quantity=force",
    "hodograph:order=2:quantity=force",
    "vector-star:order=1:quantity=couple",
    "polygon:order=1:quantity=couple",
    "spectrum",
]


def scales(figure: dict[str, Any]) -> list[tuple[float, float]]:
    """The domains of the axes of a figure, without that of the crank angle."""
    found = re.findall(r'"domain": \[(-?[\d.e-]+), (-?[\d.e-]+)\]', json.dumps(figure))
    return sorted({(float(low), float(high)) for low, high in found} - {(0.0, 360.0)})


@pytest.mark.release
def test_a_figure_that_stands_beside_another_has_its_scale() -> None:
    one, other = load(CROSS), load(FLAT)
    for key in FIGURES:
        pair = [scales(chart(one, key, beside=other)), scales(chart(other, key, beside=one))]
        alone = [scales(chart(each, key)) for each in (one, other)]
        assert pair[0], key
        assert pair[0] == pair[1], key
        reach = [max(high for _low, high in each) for each in (*pair, *alone)]
        assert reach[0] == pytest.approx(max(reach[2:]), rel=1e-9), key


@pytest.mark.release
def test_each_engine_beside_another_is_drawn_at_its_own_speed() -> None:
    slow = load("audi-25-tfsi")
    assert slow.speed
    fast = with_values(slow, name="fast", speed=2 * slow.speed)

    def reach(engine: Engine, beside: Engine | None = None) -> float:
        figure = chart(engine, "over-turn:quantity=couple", beside=beside)
        return max(high for _low, high in scales(figure))

    assert reach(fast) == pytest.approx(4 * reach(slow), rel=1e-9)
    assert reach(slow, fast) == pytest.approx(reach(fast), rel=1e-9)
    assert reach(fast, slow) == pytest.approx(reach(fast), rel=1e-9)


def test_engines_counted_in_different_units_keep_their_own_scales() -> None:
    known, relative = load("audi-25-tfsi"), load("i4")
    key = "over-turn:quantity=couple"
    assert chart(known, key, beside=relative) == chart(known, key)
    assert chart(relative, key, beside=known) == chart(relative, key)
