"""What articulated rods put on a crank pin is that of its bobweight, and how far it is off."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run

from crankstar.files import engine_of
from crankstar.remedy.loads import bobweight, loads, slave_error

COUNT, RADIUS, ROD, KNUCKLE = 7, 0.0635, 0.25, 0.055
PISTON, END = 0.92, 0.65
RADIAL: dict[str, Any] = {
    "name": "seven-cylinder radial",
    "firing_order": [1, 3, 5, 7, 2, 4, 6],
    "speed": "2200 rpm",
    "cylinder": {
        "stroke": "127 mm",
        "rod_length": "250 mm",
        "parts": {"pin": "300 g", "rings": "120 g", "small_end": "500 g", "big_end": "650 g"},
    },
    "layout": {
        "type": "radial",
        "rows": [{"cylinders": [1, 2, 3, 4, 5, 6, 7]}],
        "knuckle_radius": "55 mm",
    },
}


def _turning() -> float:
    """The mass at the pin of all that turns with the crank once a turn, kg: by positions alone."""
    theta = np.arange(1024) * 2 * np.pi / 1024
    pin = RADIUS * np.exp(1j * theta)
    first = pin.real + np.sqrt(ROD**2 - pin.imag**2)
    master = (first - pin) / ROD
    moment = END * pin + PISTON * first
    for number in range(1, COUNT):
        axis = np.exp(2j * np.pi * number / COUNT)
        knuckle = pin + KNUCKLE * master * axis
        along, aside = (knuckle / axis).real, (knuckle / axis).imag
        piston = axis * (along + np.sqrt((ROD - KNUCKLE) ** 2 - aside**2))
        moment = moment + END * knuckle + PISTON * piston
    return float(abs(np.fft.fft(moment)[1]) / 1024 / RADIUS)


def test_slave_rods_are_a_per_cent_off_the_bobweight_of_their_pin() -> None:
    """All rotating masses and half of the reciprocating ones; m rho / 2 l of one end is lacking."""
    engine = engine_of(RADIAL)
    [pin] = loads(engine)
    counted = COUNT * (END + PISTON / 2)
    assert bobweight(pin, 0.5) == pytest.approx(counted)
    assert slave_error(engine, pin) == pytest.approx(abs(_turning() - counted), rel=1e-6)
    assert slave_error(engine, pin) == pytest.approx(END * KNUCKLE / (2 * ROD), rel=1e-6)


def test_balance_and_bobweight_say_the_same_of_a_radial_engine(tmp_path: Path, run: Run) -> None:
    path = tmp_path / "radial.json"
    path.write_text(json.dumps(RADIAL))
    said = [" ".join(run(verb, str(path)).out.split()) for verb in ("bobweight", "balance")]
    error = 1e3 * abs(_turning() - COUNT * (END + PISTON / 2))
    for each in said:
        assert "1, 2, 3, 4, 5, 6, 7 4550 6440 7770" in each
        assert f"differs by {error:.3g} g from its rotating masses" in each
        assert "0.92 %" in each
