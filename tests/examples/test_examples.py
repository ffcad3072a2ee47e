"""Every script in examples/ runs, and gives the numbers a textbook knows."""

from __future__ import annotations

import runpy
import subprocess
import sys
from collections.abc import Callable
from math import pi, sqrt
from pathlib import Path
from typing import Any

import numpy as np
import pytest

FOLDER = Path(__file__).parents[2] / "examples"
A2 = 0.254025042307
"""The second harmonic at l/r = 4."""


def result(name: str) -> Any:
    return runpy.run_path(str(FOLDER / f"{name}.py"))["main"]()


def which_v8_buzzes() -> None:
    found = result("which_v8_buzzes")
    assert found["v8-flat-plane"] == pytest.approx((4 * sqrt(2), 0, 0))
    assert found["v8-cross-plane"] == pytest.approx((0, sqrt(10), 0))


def kr250_balance_factor() -> None:
    """Source: the essay's table, with A_2 = 1/4.

    Exactly, each piston has A_2 - 1/4 more at the dead centres, less at 90 deg.
    """
    table = {
        ("kr250-racer", 0.5): (0.5, -0.5 - 1j, 0.5),
        ("kr250-racer", 0.75): (0.5, -0.5 - 1.5j, 0.5),
        ("kr250-racer-simultaneous", 0.5): (1.5, -0.5, -0.5),
        ("kr250-racer-simultaneous", 0.75): (1.0, -0.5, 0.0),
    }
    more = 2 * (A2 - 0.25)
    found = result("kr250_balance_factor")
    for case, (top, middle, bottom) in table.items():
        assert found[case] == pytest.approx(
            np.array([top + more, middle - more, bottom + more]), abs=1e-9
        )
    assert abs(found["kr250-racer", 0.5][1]) == pytest.approx(1.12, abs=0.005)
    assert abs(found["kr250-racer", 0.75][1]) == pytest.approx(1.58, abs=0.005)


def v_twin_bank_angle() -> None:
    found = result("v_twin_bank_angle")
    assert found["forward"] == pytest.approx(np.ones(13))
    assert found["backward"] == pytest.approx(
        abs(np.cos(np.radians(found["bank_angle_deg"]))), abs=1e-12
    )
    assert found["backward"][6] == 0  # 90 deg


def read_own_file() -> None:
    mass, radius, ratio, pitch, speed = 0.310, 0.0353, 0.0353 / 0.125, 0.078, 9000 * pi / 30
    found = result("read_own_file")
    second = (
        ratio + ratio**3 / 4 + 15 * ratio**5 / 128
    )  # the textbook's series, to 5 parts in a million
    assert found["force 1"] == 0
    assert found["force 2"] == pytest.approx(2 * mass * radius * speed**2 * second, rel=1e-4)
    assert found["couple 1"] == pytest.approx(mass * radius * speed**2 * pitch)
    assert found["interval"] == pytest.approx(180)


def crossplane_four() -> None:
    found = result("crossplane_four")
    assert list(found["flat"].values()) == pytest.approx([4, 0, 0, 0])
    assert list(found["cross-plane"].values()) == pytest.approx(
        [0, sqrt(10), sqrt(10) / 2, sqrt(10) / 2]
    )


def radial_master_rod() -> None:
    found = result("radial_master_rod")
    assert list(found["all rods on the crank pin"].values()) == pytest.approx([4.5, 0, 0])
    articulated = found["slave rods on a master"]
    assert articulated["forward 1"] == pytest.approx(4.5, rel=1e-4)
    assert articulated["force 2"] == pytest.approx(
        9 * 0.25 * 1 / (4 - 1), rel=0.06
    )  # n lambda rho/(l - rho), the first term


def best_two_stroke_eight() -> None:
    found = result("best_two_stroke_eight")
    assert found["stars"] == 5040
    assert found["without second-order couple"] == 96
    assert found["smallest"] == "√(20 − 14√2)"
    assert found["orders"] == ["1-7-3-5-4-6-2-8", "1-8-2-6-4-5-3-7"]


CHECKS: dict[str, Callable[[], None]] = {
    check.__name__: check
    for check in (
        which_v8_buzzes,
        kr250_balance_factor,
        v_twin_bank_angle,
        read_own_file,
        crossplane_four,
        radial_master_rod,
        best_two_stroke_eight,
    )
}


def test_every_example_is_covered() -> None:
    assert {path.stem for path in FOLDER.glob("*.py")} == set(CHECKS)


@pytest.mark.parametrize("name", CHECKS)
def test_the_example_gives_the_numbers_a_textbook_knows(name: str) -> None:
    CHECKS[name]()


@pytest.mark.many(first=1)
@pytest.mark.parametrize("name", CHECKS)
def test_the_example_prints_something_when_it_is_run(name: str, tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, str(FOLDER / f"{name}.py")],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        check=True,
    )
    assert len(done.stdout.splitlines()) > 1
    assert done.stderr == ""
