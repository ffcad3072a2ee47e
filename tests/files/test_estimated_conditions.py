"""An estimated bore or speed: its effect stands in the record, and no range is promised."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run

FIVE = """name = "five, no bore"
firing_order = [1, 2, 4, 5, 3]
speed = "3000 rpm"
[cylinder]
stroke = "93 mm"
rod_length = "150 mm"
reciprocating_mass = "700 g"
rotating_mass = "600 g"
[layout]
type = "inline"
bore_pitch = "88 mm"
[gas]
bmep = "14 bar"
compression_ratio = 18
"""
THREE = """name = "three without a speed"
firing_order = [1, 3, 2]
[cylinder]
bore = "71 mm"
stroke = "84 mm"
rod_length = "137 mm"
reciprocating_mass = "330 g"
rotating_mass = "300 g"
[layout]
type = "inline"
bore_pitch = "78 mm"
[gas]
imep = "12 bar"
compression_ratio = 10.5
"""
MARKED = "is marked and given with its range"


def _record(run: Run, *words: str) -> dict[str, dict[str, Any]]:
    """What an answer rests on, by key path."""
    told: dict[str, Any] = json.loads(run(*words, "--estimate", "--json").out)
    return {row["path"]: row for row in told["rests_on"]}


@pytest.mark.release
def test_a_gas_torque_goes_with_the_square_of_an_estimated_bore(run: Run, tmp_path: Path) -> None:
    """At a mean pressure every order is p A r: over the range of the bore it is in D^2."""
    place = tmp_path / "five.toml"
    place.write_text(FIVE)
    own = _record(run, "analyze", str(place))["cylinder.bore"]
    moved = own["moves"]
    assert (own["status"], moved["quantity"], moved["order"]) == ("estimated", "roll with gas", 2.5)
    for end in ("low", "high"):
        assert moved[end] / moved["now"] == pytest.approx(own[end] ** 2, rel=1e-3)
    wide = own["high"] ** 2 - 1
    assert moved["effect"] == pytest.approx(wide / own["high"] ** 2, rel=1e-3)


def test_an_inertia_torque_goes_with_the_square_of_an_estimated_speed(
    run: Run, tmp_path: Path
) -> None:
    """And what moves most stands first among what has a size."""
    place = tmp_path / "three.toml"
    place.write_text(THREE.replace('[gas]\nimep = "12 bar"\ncompression_ratio = 10.5\n', ""))
    moved = _record(run, "analyze", str(place))["speed"]["moves"]
    low, high = (moved[end] / moved["now"] for end in ("low", "high"))
    assert (low, high) == (pytest.approx(1 / 1.2**2, rel=1e-3), pytest.approx(1.2**2, rel=1e-3))


@pytest.mark.release
@pytest.mark.parametrize("verb", ["torque", "analyze"])
@pytest.mark.parametrize(("text", "path"), [(FIVE, "cylinder.bore"), (THREE, "speed")])
def test_no_range_is_promised_of_a_bore_or_a_speed(
    text: str, path: str, verb: str, run: Run, tmp_path: Path
) -> None:
    """Their effect stands in the record, and that is said."""
    place = tmp_path / "engine.toml"
    place.write_text(text)
    plain = " ".join(run(verb, str(place), "--estimate").out.split())
    assert f"The effect of {path} is listed below." in plain
    assert f" {path}: estimated by proportions" in plain
    assert MARKED not in plain


@pytest.mark.release
def test_the_range_of_masses_beside_an_estimated_speed_is_promised(
    run: Run, tmp_path: Path
) -> None:
    """For the masses alone, and there it is."""
    place = tmp_path / "engine.toml"
    place.write_text(THREE.replace('rotating_mass = "300 g"\n', ""))
    plain = " ".join(run("analyze", str(place), "--estimate").out.split())
    masses = "cylinder.rotating_mass, cylinder.throw_mass"
    assert f"What rests on {masses} {MARKED}. The effect of speed is listed below." in plain
    assert "(estimated)" in plain
