"""The inertia of the drive by the masses of the chain that twists, where the file leaves it out."""

from __future__ import annotations

from typing import Any

import pytest

from crankstar.dynamics.uneven import driven
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.mechanics.chain_inertia import chain_inertia, turning_inertia
from crankstar.mechanics.doubts import doubts
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.lacking import without_running

SET: dict[str, Any] = {
    "name": "generating set",
    "firing_order": [1, 5, 3, 6, 2, 4],
    "speed": "1500 rpm",
    "cylinder": {
        "bore": "131 mm",
        "stroke": "154 mm",
        "rod_length": "248 mm",
        "reciprocating_mass": "4.1 kg",
        "rotating_mass": "3.4 kg",
    },
    "layout": {"type": "inline", "bore_pitch": "162 mm"},
    "gas": {"ignition": "compression", "compression_ratio": 17, "bmep": "20 bar"},
    "drive": {"load_exponent": -1},
    "torsion": {
        "bare_inertia": "0.12 kg*m^2",
        "stiffness": "3.2 MN*m/rad",
        "disc": [
            {"name": "flywheel", "inertia": "2.2 kg*m^2", "to": "rear", "stiffness": "4 MN*m/rad"},
            {
                "name": "generator",
                "inertia": "6.5 kg*m^2",
                "to": "flywheel",
                "stiffness": "0.35 MN*m/rad",
            },
        ],
    },
}
SUM = 6 * 0.12 + 2.2 + 6.5


def made(**more: Any) -> Engine:
    return engine_of({**SET, **more})


def with_drive(inertia: float) -> Engine:
    return made(drive={"load_exponent": -1, "inertia": f"{inertia} kg*m^2"})


def test_the_sum_of_the_chain_stands_for_the_drive() -> None:
    """The set runs as that of a file with the sum of the masses."""
    bare, given = made(), with_drive(SUM)
    assert turning_inertia(bare) == pytest.approx(9.42)
    assert without_running(bare, bare.speed) == ""
    one, other = (driven(each, cycle(each)) for each in (bare, given))
    assert one is not None
    assert other is not None
    assert one.irregularity == pytest.approx(other.irregularity, rel=1e-9)


def test_a_geared_disc_counts_by_the_square_of_its_ratio() -> None:
    discs = [SET["torsion"]["disc"][0], {**SET["torsion"]["disc"][1], "speed_ratio": 2}]
    geared = made(torsion={**SET["torsion"], "disc": discs})
    assert chain_inertia(geared) == pytest.approx(6 * 0.12 + 2.2 + 4 * 6.5)


def test_throws_with_their_moving_parts_count_without_them() -> None:
    """Of a long rod half the reciprocating mass and all that turns move with the pin."""
    radius = 0.077
    moving = 3.4 * radius**2 + 4.1 * radius**2 / 2 * (1 + (radius / 0.248) ** 2 / 4)
    chain = {key: value for key, value in SET["torsion"].items() if key != "bare_inertia"}
    whole = made(torsion={**chain, "inertia": f"{0.12 + moving:.9f} kg*m^2"})
    assert chain_inertia(whole) == pytest.approx(SUM, rel=1e-3)


@pytest.mark.parametrize(("inertia", "doubted"), [(3.0, 1), (6.7, 1), (9.4, 0), (30, 1)])
def test_a_drive_that_is_not_its_chain_is_doubted(inertia: float, doubted: int) -> None:
    engine = with_drive(inertia)
    found = [each for each in doubts(engine) if each.path == ("drive", "inertia")]
    assert [each.code for each in found] == ["doubt.drive-chain"] * doubted
    if doubted:
        assert (found[0].values["value"], found[0].values["chain"]) == (inertia, 9.42)


def test_a_set_without_chain_and_drive_still_lacks_it() -> None:
    tree = {key: value for key, value in SET.items() if key != "torsion"}
    bare = engine_of(tree)
    assert turning_inertia(bare) is None
    assert "inertia of crankshaft, flywheel and rotor" in without_running(bare, bare.speed)
