"""What a crankshaft that twists rests on: damping is judged where it works, by own matrices."""

from __future__ import annotations

from math import degrees, pi, sin
from typing import Any

import numpy as np
import pytest

from crankstar.analyses.torsion.figures import twist
from crankstar.analysis.assumptions import Assumption
from crankstar.dynamics.torsion_analysis import torsion
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.mechanics.doubts import torsion_doubts
from crankstar.studies.answers import rests_on
from crankstar.studies.assumed_values import assumed_values

BARE, SHAFT, REAR, FLYWHEEL = 0.009, 1.2e6, 1.6e6, 0.45
SIX: dict[str, Any] = {
    "name": "six",
    "firing_order": [1, 5, 3, 6, 2, 4],
    "speed": "3600 rpm",
    "cylinder": {
        "bore": "84 mm",
        "stroke": "110 mm",
        "rod_length": "205 mm",
        "reciprocating_mass": "900 g",
        "rotating_mass": "800 g",
    },
    "layout": {"type": "inline", "bore_pitch": "102 mm"},
    "gas": {"compression_ratio": 6, "imep": "8.5 bar"},
    "torsion": {
        "bare_inertia": f"{BARE} kg*m^2",
        "stiffness": f"{SHAFT} N*m/rad",
        "disc": [
            {
                "name": "flywheel",
                "inertia": f"{FLYWHEEL} kg*m^2",
                "to": "rear",
                "stiffness": f"{REAR} N*m/rad",
            }
        ],
    },
}


def engine_with(**torsion_values: Any) -> Engine:
    return engine_of({**SIX, "torsion": {**SIX["torsion"], **torsion_values}})


def of(found: tuple[Assumption, ...], path: str) -> Assumption:
    return next(each for each in found if each.path == path)


def resonance(order: float, *, loss: float, damping: float = 0.0) -> float:
    """The amplitude (deg) of the free end where an order meets the first mode, by own matrices.

    (K (1 + i eta) - w^2 M + i w C) q = T, the order's torque on each throw as of the response of
    the program, at k W = w_1 by the eigenvalues of M^-1 K.
    """
    engine = engine_with()
    carried = 0.0128073  # bare, the rotating mass at r, half the reciprocating mass at r
    assert pytest.approx(carried, rel=3e-3) == BARE + (0.8 + 0.45) * 0.055**2
    inertia = torsion(engine).chain.inertia
    assert inertia[:6] == pytest.approx(carried, rel=1e-3)
    mass, stiff = np.diag(inertia), np.zeros((7, 7))
    for place, own in enumerate([SHAFT] * 5 + [REAR]):
        stiff[place : place + 2, place : place + 2] += own * np.array([[1, -1], [-1, 1]])
    lost = np.diag([damping] * 6 + [0.0])
    w = np.sort(np.sqrt(np.abs(np.linalg.eigvals(np.linalg.solve(mass, stiff)))))[1]
    at = torsion(engine, speeds=[w / order]).response
    assert at is not None
    torque = at.driving[0, at.orders.tolist().index(order)]
    dynamic = stiff * (1 + 1j * loss) - w**2 * mass + 1j * w * lost
    return degrees(abs(np.linalg.solve(dynamic, torque)[0]))


@pytest.mark.release
@pytest.mark.parametrize("path", ["torsion.loss_factor", "torsion.damping"])
def test_damping_moves_the_amplitude_at_the_strongest_resonance_as_own_matrices_say(
    path: str,
) -> None:
    engine = engine_with()
    own = of(rests_on(engine, twist(engine)), path)
    assert own.moved is not None
    assert own.low is not None
    assert own.high is not None
    assert (own.moved.quantity, own.moved.order) == ("resonant amplitude", 9.0)
    assert own.moved.now == pytest.approx(resonance(9.0, loss=0.02), rel=1e-3)
    for end, size in ((own.low, own.moved.high), (own.high, own.moved.low)):
        if path == "torsion.damping":
            wanted = resonance(9.0, loss=0.02, damping=end)
        else:
            wanted = resonance(9.0, loss=end)
        assert size == pytest.approx(wanted, rel=1e-3)


def test_the_maximum_stress_of_the_answer_is_that_of_the_analysis() -> None:
    engine = engine_with(diameter="58 mm")
    found = torsion(engine).response
    assert found is not None
    figures = twist(engine).figures(engine)
    modulus = pi * 0.058**3 / 16
    crank = found.peak[:, :5].max()  # the flywheel's own shaft has no diameter
    assert figures["torsional stress", None] == pytest.approx(crank / modulus / 1e6, rel=1e-5)
    assert ("torsional torque", None) not in figures
    without = twist(engine_with()).figures(engine_with())
    assert without["torsional torque", None] == pytest.approx(found.peak.max(), rel=1e-5)


def test_a_damping_that_is_left_out_is_in_the_record_as_missing() -> None:
    """Its ends are 1e4 and 8e4 N s/m^3 of piston area times r^2, here 5.54 cm^2 by (55 mm)^2."""
    engine = engine_with()
    own = of(tuple(assumed_values(engine, twist(engine))), "torsion.damping")
    swept = pi / 4 * 0.084**2 * 0.055**2
    assert (own.status, own.unit) == ("missing", "N*m*s/rad")
    assert (own.low, own.high) == pytest.approx((1e4 * swept, 8e4 * swept))
    assert own.low is not None
    assert own.high is not None
    assert own.low < 0.8 < own.high  # that of the old six of the documents


@pytest.mark.parametrize("given", ["0 N*m*s/rad", "0.8 N*m*s/rad"])
def test_a_damping_of_the_file_is_not_missing(given: str) -> None:
    engine = engine_with(damping=given)
    paths = {each.path for each in assumed_values(engine, twist(engine))}
    assert "torsion.damping" not in paths
    assert "torsion.loss_factor" in paths


def chain_frequency(stiffness: float) -> float:
    """Of six equal masses in a row, both ends free: 2 sqrt(k/J) sin(pi/12), over 2 pi."""
    inertia = BARE + (0.8 + 0.45) * 0.055**2
    return 2 * (stiffness / inertia) ** 0.5 * sin(pi / 12) / (2 * pi)


@pytest.mark.quick
@pytest.mark.parametrize(
    ("stiffness", "code"),
    [
        ("1.2 N*m/rad", "doubt.soft-crank"),
        ("1.2 kN*m/rad", "doubt.soft-crank"),
        ("0.13 MN*m/rad", ""),  # of a light six of 1928
        ("1.2 MN*m/rad", ""),
        ("1200 MN*m/rad", "doubt.stiff-crank"),
    ],
)
def test_a_stiffness_with_which_no_crankshaft_vibrates_is_doubted(
    stiffness: str, code: str
) -> None:
    found = [*torsion_doubts(engine_with(stiffness=stiffness))]
    assert [fault.code for fault in found] == ([code] if code else [])
    if not code:
        return
    [fault] = found
    assert fault.path == ("torsion", "stiffness")
    size = fault.values["value"]
    assert fault.values["frequency"] == pytest.approx(chain_frequency(size), rel=6e-3)
    bound = 20 / (2 * pi * 0.055) if "soft" in code else 3200 / (2 * 5 * 0.102)
    assert fault.values["bound"] == pytest.approx(bound, rel=6e-3)


@pytest.mark.quick
def test_a_bare_stiffness_without_any_size_is_doubted_by_its_frequency() -> None:
    own = {"name": "six", "firing_order": [1, 5, 3, 6, 2, 4], "layout": {"type": "inline"}}
    engine = engine_of({**own, "torsion": {"inertia": 0.035, "stiffness": 1.2}})
    [fault] = torsion_doubts(engine)
    assert (fault.code, fault.values["bound"]) == ("doubt.soft-crank", 2.0)
    wanted = 2 * (1.2 / 0.035) ** 0.5 * sin(pi / 12) / (2 * pi)
    assert fault.values["frequency"] == pytest.approx(wanted, rel=6e-3)


@pytest.mark.quick
def test_a_disc_on_a_shaft_softer_than_any_drive_line_is_doubted() -> None:
    disc = {**SIX["torsion"]["disc"][0], "stiffness": "1.6 N*m/rad"}
    [fault] = torsion_doubts(engine_with(disc=[disc]))
    assert (fault.code, fault.path) == ("doubt.soft-disc", ("torsion", "disc", 0, "stiffness"))
    assert fault.values["frequency"] == pytest.approx((1.6 / 0.45) ** 0.5 / (2 * pi), rel=6e-3)
    assert "torsion.disc[1].stiffness" in fault.sentence
