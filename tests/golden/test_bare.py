"""Bare crankshafts get the weights that they got before weights of a file could be kept."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import build_bare


def test_bare_crankshafts_get_the_weights_that_they_always_got() -> None:
    kept, now = json.loads(build_bare.FILE.read_text(encoding="utf-8")), build_bare.bare(bare=True)
    assert now.keys() == kept.keys()
    for way, weights in kept.items():
        if weights is None:
            assert now[way] is None, way
            continue
        assert len(now[way]) == len(weights), way
        solver = "rms" in way  # a solver's last digits may move with its version
        for new, old in zip(now[way], weights, strict=True):
            numbers = pytest.approx(old[1:4], rel=1e-6 if solver else 1e-13, abs=1e-13)
            assert (new[0], new[1:4], new[4]) == (old[0], numbers, old[4]), way
