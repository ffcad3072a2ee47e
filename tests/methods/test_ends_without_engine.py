"""An end of a range with which there is no engine: no figure falls back to one without gas.

A two-stroke of 160 bar cannot compress to more: with gamma 1.4 and a ratio of 17 its charge has at
most 160/17^1.4 bar, by hand, and at that charge compression alone takes all.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from crankstar.analyses.genset.answer import answer as genset
from crankstar.analyses.genset.question import Question as Genset
from crankstar.analyses.marine.answer import answer as marine
from crankstar.analyses.marine.question import Question as Marine
from crankstar.analyses.mounts.figures import on_mounts
from crankstar.analyses.torsion.figures import twist
from crankstar.analysis.assumptions import Answer, Assumption, moved
from crankstar.analysis.tried_values import Tried
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.language.messages import MessageError
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.operating_points import GasError
from crankstar.studies.answers import amplitudes, compared, outlook, rests_on, torques
from crankstar.studies.load_answers import bearing_peaks
from crankstar.tables.assumptions import assumption_facts, assumption_lines

RATIO, GAMMA, PEAK, NOW = 17.0, 1.4, 160.0, 2.68186
SHIP: dict[str, Any] = {
    "name": "ship",
    "cycle": "two-stroke",
    "firing_order": [1, 7, 2, 5, 4, 3, 6],
    "speed": "105 rpm",
    "cylinder": {
        "bore": "600 mm",
        "stroke": "2400 mm",
        "rod_length": "2460 mm",
        "reciprocating_mass": "5200 kg",
        "rotating_mass": "3000 kg",
    },
    "gas": {"imep": "19 bar", "peak_pressure": f"{PEAK} bar", "process": "limited-pressure"},
    "layout": {"type": "inline", "bore_pitch": "1020 mm"},
}
ROOMS: dict[str, Any] = {
    "torsion": {"inertia": "30000 kg*m^2", "stiffness": "1000 MN*m/rad"},
    "block": {"mass": "400 t"},
    "mounts": [
        {"name": name, "right": f"{right} m", "z": f"{z} m", "stiffness": "80 kN/mm"}
        for name, right, z in (("left", -2, 1), ("right", 2, 1), ("rear", 0, -4))
    ],
}
LIMIT = PEAK / RATIO**GAMMA


def ship(**gas: str) -> Engine:
    return engine_of({**SHIP, **ROOMS, "gas": {**SHIP["gas"], **gas}}, name="ship")


def of(found: tuple[Assumption, ...], path: str) -> Assumption:
    return next(each for each in found if each.path == path)


ANSWERS: dict[str, Callable[[Engine], Answer]] = {
    "analyze": lambda own: amplitudes(own, both=True),
    "outlook": outlook,
    "compare": compared,
    "torque": lambda own: torques(own, cycle),
    "genset": lambda own: genset(own, Genset()),
    "marine": lambda own: marine(own, Marine()),
    "torsion": twist,
    "mounts": on_mounts,
    "bearings": lambda own: bearing_peaks(own, cycle),
}


@pytest.mark.parametrize("name", ANSWERS)
def test_no_figure_falls_back_to_none(name: str) -> None:
    made = ANSWERS[name](ship())
    assert made.figures(ship(intake_pressure=f"{LIMIT - 0.01} bar"))
    with pytest.raises(GasError, match="compression alone"):
        made.figures(ship(intake_pressure=f"{LIMIT + 0.05} bar"))


@pytest.mark.release
def test_a_range_ends_at_the_last_value_that_makes_an_engine() -> None:
    own = ship()
    found = of(rests_on(own, outlook(own)), "gas.intake_pressure")
    assert found.moved is not None
    assert found.low == pytest.approx(0.9 * NOW, rel=1e-4)
    assert found.high is not None
    assert LIMIT - 0.01 * (1.2 - 0.9) * NOW <= found.high <= LIMIT
    order = found.moved.order
    assert order is not None
    sizes = [
        outlook(other).figures(other)["roll", order]
        for share in np.linspace(0.9, found.high / NOW, 4).tolist()
        for other in [ship(intake_pressure=f"{share * NOW} bar", exhaust_pressure="2.438058 bar")]
    ]
    assert found.moved.low == pytest.approx(min(sizes), rel=0.01)
    assert found.moved.high == pytest.approx(max(sizes), rel=0.01)
    [(far, why)] = found.moved.beyond
    assert far == pytest.approx(1.2 * NOW, rel=1e-4)
    assert why.startswith("peak_pressure is 160 bar, less than compression alone, 169.9 bar")
    said = assumption_facts([found])["rests_on"][0]
    assert (said["high"], said["moves"]["no_engine_at"]) == (found.high, [far])


def test_a_sentence_gives_the_end_and_says_why() -> None:
    own = ship(intake_pressure="2.8 bar")
    found = of(rests_on(own, outlook(own)), "gas.compression_ratio")
    assert found.high is not None
    assert found.high == pytest.approx((PEAK / 2.8) ** (1 / GAMMA), abs=0.01 * 0.3 * RATIO)
    [line] = assumption_lines([found])
    assert f"From 14.4 to {found.high:.3g} the rolling moment of order 7 is" in line
    assert f"Beyond {found.high:.3g} the file makes no engine; at 19.5: peak_pressure is" in line


def test_every_end_of_torque_has_a_size() -> None:
    """The ratio of heats is nowhere taken for more than 1.42: a thicker charge alone ends it."""
    for charge, known in ((2.8, 1.42), (2.95, np.log(PEAK / 2.95) / np.log(RATIO))):
        own = ship(intake_pressure=f"{charge} bar")
        rows = rests_on(own, torques(own, cycle))
        ratio, gamma = (of(rows, f"gas.{name}") for name in ("compression_ratio", "gamma"))
        assert ratio.moved is not None
        assert ratio.high == pytest.approx((PEAK / charge) ** (1 / GAMMA), abs=0.003 * RATIO)
        assert gamma.moved is not None
        assert gamma.high == pytest.approx(known, abs=0.01 * 0.06 * GAMMA)
        assert bool(gamma.moved.beyond) is (charge > 2.9)


LOW = (0.0, 0.5)


def of_size(engine: Engine, *, bad: Callable[[float], bool], value: float | None) -> Assumption:
    """The record of x in [0, 4] of the figure (1 + x)^2, where some x are no engine.

    Of one that is not given x is in [0.5, 4].
    """
    given: list[float] = []

    def vary(own: Engine, x: float) -> Engine:
        if bad(x):
            raise MessageError("too much")
        given.append(x)
        return own

    answer = Answer(
        figures=lambda _own: {("size", None): (1.0 + (given[-1] if given else value or 0.0)) ** 2},
        unit=lambda _quantity, _own: "N",
    )
    row = Assumption("assumed", "x", "usual", value, "", LOW[value is None], 4.0, vary=vary)
    [found] = moved(engine, [row], answer)
    return found


@pytest.mark.parametrize(
    ("least", "most", "value"), [(-1.0, 2.5, 1.0), (0.7, 9.0, 1.0), (0.7, 2.5, 1.0), (0.7, 9, None)]
)
def test_both_ends_and_a_value_that_is_not_given(
    least: float, most: float, value: float | None
) -> None:
    found = of_size(ship(), bad=lambda x: not least <= x <= most, value=value)
    ends = max(least, LOW[value is None]), min(most, 4.0)
    assert (found.low, found.high) == pytest.approx(ends, abs=0.04)
    assert found.moved is not None
    assert len(found.moved.beyond) == (least > 0) + (most < 4)
    assert (found.moved.low, found.moved.high) == pytest.approx(
        ((1 + (found.low or 0)) ** 2, (1 + (found.high or 0)) ** 2)
    )


@pytest.mark.parametrize("value", [None, 1.0])
def test_without_any_other_engine_there_is_no_size(value: float | None) -> None:
    found = of_size(ship(), bad=lambda x: x != 1, value=value)
    assert (found.moved, found.low, found.high) == (None, LOW[value is None], 4.0)


def test_ends_that_are_engines_are_as_before() -> None:
    own = ship()
    tried = Tried(
        at=lambda _x: own,
        figures=lambda _own: {("size", None): 1.0},
        now={("size", None): 1.0},
        ends=(0.0, 4.0),
        value=1.0,
    )
    assert (tried.ends, tried.beyond, sorted(tried.known)) == ((0.0, 4.0), [], [0.0, 1.0, 4.0])


def test_a_mass_beyond_that_of_the_block_ends_a_range_and_refuses_nothing() -> None:
    """With estimated big ends the pistons and rods weigh more than the whole engine."""
    master: dict[str, Any] = {"number": 1, "shaft": "crank", "throw": 1}
    master |= {"rod_length": "250 mm", "reciprocating_mass": "1 kg"}
    slave = master | {"number": 2, "rod_length": "200 mm", "reciprocating_mass": "0 kg"}
    slave |= {"articulated": {"master": 1, "radius": "50 mm", "angle": "0 deg"}}
    tree = {
        "name": "light",
        "speed": "100 rpm",
        "shaft": [{"name": "crank", "throw": [{"angle": "0 deg", "radius": "125 mm"}]}],
        "cylinders": [master, slave],
        "block": {"mass": "1.5 kg"},
    }
    engine = engine_of(tree)
    rests = rests_on(engine, amplitudes(engine, speed=engine.speed))
    (rotating,) = [each for each in rests if each.path == "cylinder.rotating_mass"]
    assert rotating.moved is not None
    ((end, why),) = rotating.moved.beyond
    assert rotating.high == pytest.approx(0.5, rel=1e-2)  # kg, beside the piston of 1 kg
    assert end > 0.5
    assert "block.mass is 1.5 kg" in why
