"""What the functions about the gas refuse: what contradicts itself, and numbers that are none."""

from collections.abc import Callable
from math import inf, nan
from typing import Any

import numpy as np
import pytest
from tests.commands import Run

import crankstar

FIVE = crankstar.load("audi-25-tfsi")
CYCLE = crankstar.cycle(FIVE, imep=10e5)
TOGETHER: list[tuple[dict[str, Any], tuple[str, ...]]] = [
    ({"imep": 1e6, "bmep": 9e5}, ("--imep", "10 bar", "--bmep", "9 bar")),
    ({"imep": 1e6, "motored": True}, ("--imep", "10 bar", "--motored")),
    ({"off": [1], "motored": True}, ("--off", "1", "--motored")),
    ({"weaker": {2: 0.3}, "motored": True}, ("--weaker", "2=30%", "--motored")),
    ({"off": [1, 2], "weaker": {2: 0.3}}, ("--off", "1,2", "--weaker", "2=30%")),
]


@pytest.mark.parametrize(("asked", "options"), TOGETHER)
def test_options_that_contradict_each_other_are_refused_alike(
    asked: dict[str, Any], options: tuple[str, ...], run: Run
) -> None:
    """By the cycle, the analysis and its command, with one sentence."""
    with pytest.raises(ValueError, match=r"leave|give one") as by_cycle:
        crankstar.cycle(FIVE, **asked)
    with pytest.raises(ValueError, match=r"leave|give one") as by_torque:
        crankstar.torque(FIVE, **asked)
    told = run("torque", "audi-25-tfsi", *options)
    assert str(by_cycle.value) == str(by_torque.value)
    assert told.err.strip().replace("--", "") == f"crankstar: {by_cycle.value}"


def test_what_does_not_contradict_itself_adds_up() -> None:
    """Of five equal chambers one is off and one lacks 30 %: the mean pressure falls by 1.3 fifths.

    To what compression alone does in a chamber, which is that of the motored engine.
    """
    asked: Any = {"off": 1, "weaker": {"2": "30%"}}
    motored = crankstar.cycle(FIVE, motored=True).imep
    found = crankstar.cycle(FIVE, imep=10e5, **asked)
    own = np.pi / 4 * 0.0825**2 * 0.0928
    turns = crankstar.gas_torque(CYCLE).mean * 4 * np.pi / own  # of each chamber
    assert turns == pytest.approx(np.full(5, 10e5), rel=1e-6)
    lost = crankstar.gas_torque(found).mean * 4 * np.pi / own
    assert lost[2:] == pytest.approx(np.full(3, 10e5), rel=1e-6)
    silent = lost[0]
    assert abs(silent - motored) < 0.02 * 10e5
    assert lost[1] == pytest.approx(0.7 * 10e5 + 0.3 * silent, rel=1e-6)
    assert found.off == (1,)
    assert found.weaker == {2: 0.3}


def gas(**asked: Any) -> Any:
    return crankstar.gas_torque(CYCLE, **asked)


def thrust(**asked: Any) -> Any:
    return crankstar.side_thrust(FIVE, CYCLE, **asked)


def wheel(**asked: Any) -> Any:
    return crankstar.flywheel_for(FIVE, CYCLE, **asked)


def burnt(**asked: Any) -> Any:
    return crankstar.cycle(FIVE, **asked)


def searched(**asked: Any) -> Any:
    return crankstar.search(5, **asked)


VALUES: list[tuple[Callable[..., Any], dict[str, Any]]] = [
    *((gas, {"highest": each}) for each in (1e9, inf, nan, -1, 0)),
    *((thrust, {"samples": each}) for each in (0, -3, 10**9)),
    *((wheel, {"irregularity": each}) for each in (0, nan, 2, "x")),
    *((burnt, {"weaker": each}) for each in ({1: nan}, {1: 2})),
]
TYPES: list[tuple[Callable[..., Any], dict[str, Any]]] = [
    (gas, {"highest": "2"}),
    (thrust, {"samples": 3.5}),
    (burnt, {"off": 1.5}),
    (burnt, {"off": [True]}),
    (burnt, {"motored": 1}),
    (burnt, {"weaker": [(1, 0.2)]}),
    (searched, {"limit": 5}),
    (searched, {"minimise": 5}),
]


@pytest.mark.parametrize(("function", "asked"), VALUES)
def test_numbers_that_cannot_be_are_named(function: Callable[..., Any], asked: Any) -> None:
    with pytest.raises(ValueError, match=rf"{next(iter(asked))}|cannot lack"):
        function(**asked)


@pytest.mark.parametrize(("function", "asked"), TYPES)
def test_what_is_no_such_thing_is_named(function: Callable[..., Any], asked: Any) -> None:
    with pytest.raises(TypeError, match=f"^{next(iter(asked))} takes .*, not "):
        function(**asked)


def test_a_degree_of_irregularity_may_be_a_fraction() -> None:
    assert wheel(irregularity="1/50") == wheel(irregularity=0.02) > 0


def test_an_order_as_text_is_quoted() -> None:
    asked: Any = "2"
    with pytest.raises(ValueError, match='The order is "2"; give a crank order'):
        crankstar.derivation("i4", asked)


def test_the_cycle_of_another_engine_is_refused() -> None:
    """Its chambers are other ones; masses are none of a cycle.

    The greatest side thrust of gas is p A tan(beta) at the greatest of its samples.
    """
    others: list[Any] = [
        "honda-b18c",
        crankstar.load("audi-25-tfsi", changes={"cylinder.bore": "80 mm"}),
    ]
    for other in others:
        with pytest.raises(ValueError, match="the cycle is of an engine whose chambers are not"):
            crankstar.side_thrust(other, CYCLE)
    light = crankstar.load("audi-25-tfsi", changes={"cylinder.reciprocating_mass": "1 g"})
    found = crankstar.side_thrust(light, CYCLE, samples=3600)
    theta = found.theta
    radius, rod = 0.0464, FIVE.first.rod_length
    beta = np.arcsin(radius * np.sin(theta) / rod)
    fires = CYCLE.volumes.fires[0]
    force = (np.interp((theta - fires) % (4 * np.pi), np.arange(3601) * 4 * np.pi / 3600,
        np.append(CYCLE.pressure[0], CYCLE.pressure[0, 0])) - CYCLE.crankcase)  # fmt: skip
    own = force * np.pi / 4 * 0.0825**2 * np.tan(beta)
    assert found.gas[0].max() == pytest.approx(own.max(), rel=1e-6)
