"""A sweep over whose range another ignition is assumed says from which value on."""

import json

import numpy as np
import pytest
from tests.commands import Run

from crankstar import sweep, watched
from crankstar.tables.sweep_notes import doubt_sentences

TURNS = 6.5
"""1000/min."""
VOLUME = 5 * np.pi / 4 * 0.0825**2 * 0.0928
PISTON = 2 * 0.0928 * TURNS * 1e3 / 60
"""Mean piston speed, m/s."""
FRICTION = {
    "spark": (0.97 + 0.15 * TURNS + 0.05 * TURNS**2) * 1e5,
    "compression": (75 + 48 * TURNS + 0.4 * PISTON**2) * 1e3,
}
"""Pa: Barnes-Moss, and Millington and Hartles, as Heywood gives them."""
SPARK = 14.0
"""The greatest compression ratio of an engine that is taken to ignite by sparks."""


@pytest.mark.release
@pytest.mark.parametrize("count", [13, 49])
def test_from_which_value_on_the_engine_ignites_by_itself(count: int, run: Run) -> None:
    """The indicated torque of a brake load has the friction of the ignition in it.

    Of 49 values not all are tried.
    """
    command = ("sweep", "audi-25-tfsi", "--over", f"gas.compression_ratio=8..20/{count}")
    out = json.loads(run(*command, "--quantity", "mean_torque", "--json").out)
    values = np.linspace(8, 20, count)
    fires = ["spark" if value <= SPARK else "compression" for value in values]
    torque = [(18.608e5 + FRICTION[own]) * VOLUME / (4 * np.pi) for own in fires]
    assert [row["mean_torque"] for row in out["values"]] == pytest.approx(torque, rel=1e-6)
    after = values[values > SPARK][0]
    told = next(each for each in out["doubts"] if each.startswith("gas.ignition"))
    assert f"spark from 8 to 14, compression from {after:g} to 20, " in told
    assert "gas.friction" in told
    assert "gas.gamma" not in told  # alike for both


def test_of_two_values_two_pairs_are_named() -> None:
    over = ["gas.compression_ratio=12..16/2", "gas.gamma=1.3..1.35/2"]
    found = sweep("audi-25-tfsi", over)
    told = doubt_sentences(found, [watched(found, "mean_torque")])[0]
    first, then = (f"gas.compression_ratio = {ratio}, gas.gamma = 1.3" for ratio in (12, 16))
    assert f"spark is assumed at {first}, compression at {then}, " in told


@pytest.mark.parametrize(
    "asked", [("--quantity", "force"), ("--quantity", "mean_torque", "--set", "gas.ignition=spark")]
)
def test_where_it_does_not_matter_or_is_given_nothing_is_said(
    asked: tuple[str, ...], run: Run
) -> None:
    out = run("sweep", "audi-25-tfsi", "--over", "gas.compression_ratio=12..16/3", *asked).out
    assert "is not in the file" not in out
