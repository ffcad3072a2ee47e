"""Torsion of the engines of the catalog against what is printed or was measured of them."""

from __future__ import annotations

import tomllib
from math import pi, sqrt

import numpy as np
import pytest
from scipy.linalg import eigh

from crankstar import load, names, torsion
from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_modes import holzer, torsion_modes
from crankstar.files.catalog import path_of

POUND_INCH = 0.1129848290276167
"""N m, and kg m^2 of a lb in s^2."""
PUBLISHED = {"mwm-6-diesel", "diesel-six-1939", "rolls-royce-six-1928"}
ESTIMATED = {"cadillac-ld8", "rover-v8-39", "ford-46-sohc"}


def per_minute(name: str) -> list[float]:
    return [mode.frequency * 60 for mode in torsion_modes(torsion_chain(load(name)))]


def test_the_diesel_six_of_1939_has_the_second_frequency_that_is_printed() -> None:
    """51 500 a minute, w^2 = 29 090 909, by Holzer's table (Rolls-Royce archive, box 132)."""
    assert per_minute("diesel-six-1939")[1] == pytest.approx(51_500, rel=5e-4)


def test_holzers_table_of_1939_is_that_of_the_program_but_for_its_rounding() -> None:
    """The article goes on with stiffnesses of three digits."""
    rows = holzer(torsion_chain(load("diesel-six-1939")), speed=sqrt(29_090_909))
    printed = [1.0, 0.5336, -0.1824, -0.8581, -1.0880, -0.8092, 0.0309]
    sums = [6.40, 9.81, 8.65, 3.15, -3.82, -8.99]
    assert [row.amplitude for row in rows] == pytest.approx(printed, abs=2e-3)
    found = [row.sum / POUND_INCH / 1e6 for row in rows[:-1]]
    assert found == pytest.approx(sums, abs=1.5e-2)
    assert abs(rows[-1].sum) < 0.06 * abs(rows[-2].sum)  # printed as nought


def test_the_first_frequency_of_1939_is_near_the_root_of_its_quadratic_not_as_printed() -> None:
    """162e-15 w^4 - 377e-8 w^2 + 11.32 = 0, three masses for seven: 1882 rad/s, printed 1800."""
    root = sqrt((377e-8 - sqrt(377e-8**2 - 4 * 162e-15 * 11.32)) / (2 * 162e-15))
    assert root == pytest.approx(1882, abs=1)
    first = per_minute("diesel-six-1939")[0] * pi / 30
    assert first == pytest.approx(root, rel=0.025)
    assert abs(first - 1800) > 3 * abs(first - root)


def test_the_crankshaft_of_1928_meets_its_third_order_where_it_was_met() -> None:
    """Measured at 3300 rpm, reckoned at 3296 by a third of the inertia at the end (Rayleigh).

    That is an upper bound of the evenly loaded shaft, which the chain of six masses stands for.
    """
    [first, *_others] = per_minute("rolls-royce-six-1928")
    effective = 0.02931 / 3 + 0.00582
    reckoned = 60 / (2 * pi) * sqrt(16_350 * (1 / 0.6911 + 1 / effective))
    assert reckoned / 3 == pytest.approx(3296, abs=1)
    assert 0.96 * 3300 < first / 3 < reckoned / 3
    critical = [each for each in torsion(load("rolls-royce-six-1928")).criticals if each.order == 3]
    assert critical[0].speed * 30 / pi == pytest.approx(first / 3)


def test_its_sixth_order_is_where_the_goshawk_met_it() -> None:
    """At 1600 rpm without slipper drive: Rolls-Royce archive, box 25, 1 March 1927."""
    assert per_minute("rolls-royce-six-1928")[0] / 6 == pytest.approx(1600, rel=0.01)


def test_the_shaft_of_1928_as_a_continuous_one_has_the_frequency_of_its_six_masses() -> None:
    """theta = cos(b x) + a sin(b x) along the shaft, x = 0 at the hub and 1 at the flywheel.

    b^2 = w^2 I/C; the hub gives C b a = -w^2 J_h, the flywheel C theta'(1) = w^2 J_f theta(1).
    """
    stiffness, inertia, hub, flywheel = 16_350.0, 0.02931, 0.00582, 0.6911

    def left(speed: float) -> float:
        wave = speed * sqrt(inertia / stiffness)  # b L
        slope = -(speed**2) * hub / (stiffness * wave)
        torque = stiffness * wave * (-np.sin(wave) + slope * np.cos(wave))
        return torque - speed**2 * flywheel * (np.cos(wave) + slope * np.sin(wave))

    speeds = np.linspace(500, 1500, 200_001)
    values = np.array([left(float(each)) for each in speeds])
    roots = speeds[np.flatnonzero(np.diff(np.sign(values)))]
    [first, *_others] = per_minute("rolls-royce-six-1928")
    assert first == pytest.approx(roots[0] * 30 / pi, rel=5e-3)


def test_the_mwm_diesel_has_the_frequencies_of_its_printed_chain() -> None:
    inertia = [0.0170, 0.0090, 0.0467, 0.0327, 0.0467, 0.0467, 0.0327, 0.0487, 2.0750]
    stiffness = [1.106e6, 1.631e6, 1.253e6, 1.253e6, 1.678e6, 1.253e6, 1.253e6, 1.976e6]
    gaps = np.diff(np.eye(9), axis=0)
    squares = eigh(gaps.T @ np.diag(stiffness) @ gaps, np.diag(inertia), eigvals_only=True)
    found = np.array(per_minute("mwm-6-diesel")) * pi / 30
    assert found == pytest.approx(np.sqrt(squares[1:]), rel=1e-9)


def test_six_engines_have_torsion_and_say_what_of_it_is_published() -> None:
    told = {}
    for name in names():
        path = path_of(name)
        assert path is not None
        tree = tomllib.loads(path.read_text(encoding="utf-8"))
        if "torsion" in tree:
            told[name] = {
                key: each["status"]
                for key, each in tree["provenance"].items()
                if key.startswith("torsion")
            }
    assert set(told) == PUBLISHED | ESTIMATED
    for name in ESTIMATED:
        assert torsion(load(name)).chain.estimated == ("torsion.stiffness",)
        assert told[name]["torsion.dimensions.journal_diameter"] == "published"
        assert told[name]["torsion.dimensions.pin_diameter"] == "published"
    for name in PUBLISHED:
        assert set(told[name].values()) <= {"published", "computed"}
