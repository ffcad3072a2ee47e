"""What lies between the ends of a range: resonances and extremes, against own sums and grids."""

from __future__ import annotations

from math import pi
from typing import Any

import numpy as np
import pytest
from tests.mounted_engines import MOUNTS, standing

from crankstar.analyses.mounts.figures import on_mounts
from crankstar.analysis.assumptions import Answer, Assumption
from crankstar.analysis.changed_masses import with_turning_masses
from crankstar.analysis.tried_values import Tried, Tuning
from crankstar.dynamics.mount_analysis import mounts
from crankstar.dynamics.mounted_block import borne, mounted_block, settled
from crankstar.dynamics.whirl import body
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.files.catalog import load
from crankstar.studies.answers import amplitudes, rests_on, summary
from crankstar.studies.fault_kinds import Fault
from crankstar.studies.response_answers import felt
from crankstar.studies.single_faults import shaken
from crankstar.tables.assumptions import assumption_facts, assumption_lines

PLACES = {"left": (0.04, -0.32, 0.11), "right": (0.04, 0.31, 0.09), "rear": (-0.02, 0.0, -0.48)}
RATES, LOSS = (150e3, 90e3, 80e3), 0.1
MISFIRE = [Fault("combustion", 3)]


def plain(**changes: Any) -> Engine:
    """The in-line five on three mounts of plain rubber, its block of 165 kg not known further."""
    own = [
        {
            "name": name, "up": f"{up} m", "right": f"{right} m", "z": f"{z} m",
            "stiffness": [f"{rate} N/m" for rate in RATES], "loss_factor": LOSS,
        }
        for name, (up, right, z) in PLACES.items()
    ]  # fmt: skip
    return standing(mounts=own, block={"mass": "165 kg", **changes})


def of(engine: Engine, answer: Answer, path: str) -> Assumption:
    return next(each for each in rests_on(engine, answer) if each.path == path)


def ends(own: Assumption) -> tuple[float, float]:
    assert own.low is not None
    assert own.high is not None
    return own.low, own.high


def arm(place: tuple[float, float, float], centre: np.ndarray) -> np.ndarray:
    """Motion of a point by up, right, z, yaw, pitch, roll: each turn lifts by its cross product."""
    up, right, z = np.array(place) - centre
    # clockwise from the front turns up to the right; yaw turns the front to the right; pitch, up
    return np.array([[1, 0, 0, 0, z, -right], [0, 1, 0, z, 0, up], [0, 0, 1, -right, -up, 0]])


@pytest.mark.release
def test_the_velocity_at_a_resonance_inside_a_range_is_that_of_own_matrices() -> None:
    engine, speed = plain(), 1300 * pi / 30
    own = of(engine, felt(engine, MISFIRE, speed=speed), "block.inertia")
    assert own.moved is not None
    assert (own.moved.quantity, own.value) == ("velocity", 1.0)
    order = own.moved.order
    assert order is not None
    now = shaken(engine, MISFIRE, speed=speed, orders=[order])
    block = body(engine)
    arms = [arm(place, np.array(block.centre)) for place in PLACES.values()]
    stiff = (1 + 1j * LOSS) * sum(each.T @ np.diag(RATES) @ each for each in arms)
    inertia = np.array(block.inertia)

    def velocity(share: float) -> float:
        mass = np.diag([*[165.0] * 3, *(share * inertia)])
        w = order * speed
        motion = np.linalg.solve(stiff - w**2 * mass, now.push[0])[:3]
        return float(1e3 * w * np.sqrt((np.abs(motion) ** 2).sum() / 2))

    low, high = ends(own)
    grid = np.array([velocity(x) for x in np.linspace(low, high, 2001)])
    assert velocity(1.0) == pytest.approx(own.moved.now, rel=1e-9)
    assert max(grid[0], grid[-1], own.moved.now) < 0.9 * grid.max()  # the ends do not show it
    assert own.moved.high == pytest.approx(grid.max(), rel=0.02)
    assert own.moved.low == pytest.approx(grid.min(), rel=0.02)


@pytest.mark.release
@pytest.mark.parametrize("rpm", [650, 900])
def test_every_range_on_mounts_holds_what_a_dense_grid_holds(rpm: float) -> None:
    engine, speed = plain(), rpm * pi / 30
    hidden = 0
    for answer in (felt(engine, MISFIRE, speed=speed), on_mounts(engine, speeds=[speed])):
        for own in rests_on(engine, answer):
            if own.vary is None or own.moved is None or own.moved.trial or own.effect < 0.01:
                continue
            key = (own.moved.quantity, own.moved.order)
            values = np.linspace(*ends(own), 100)
            grid = [answer.figures(own.vary(engine, x)).get(key, 0.0) for x in values.tolist()]
            top = max(map(abs, grid))
            assert own.moved.low <= min(grid) + 0.05 * top, own.path
            assert own.moved.high >= max(grid) - 0.05 * top, own.path
            hidden += max(grid) > 1.05 * max(grid[0], grid[-1], own.moved.now)
    assert hidden


@pytest.mark.parametrize("damping", [0.005, 0.05])
def test_the_peak_of_an_oscillator_is_found_however_narrow(damping: float) -> None:
    engine = load("i4")
    mass, goal, at = 2.0, 30.0, {"x": 0.0}

    def figures(_engine: Engine) -> dict[tuple[str, float | None], float]:
        stiffness = 1e3 * at["x"]
        return {("force", 1.0): abs(1 / (stiffness * (1 + 2j * damping) - mass * goal**2))}

    def vary(value: float) -> Engine:
        at["x"] = value
        return engine

    tried = Tried(at=vary, figures=figures, now={}, ends=(1.0, 4.0), value=None)
    natural = Tuning(lambda _engine: [(1e3 * at["x"] / mass) ** 0.5], [1.0], (goal, goal))
    tried.add_meetings([natural])
    stiffness = 1e3 * np.linspace(1, 4, 100001)
    truth = np.abs(1 / (stiffness * (1 + 2j * damping) - mass * goal**2)).max()
    assert max(size for _x, size in tried.sizes(("force", 1.0))) == pytest.approx(truth, rel=0.01)


def test_a_couple_that_vanishes_inside_a_range_is_found() -> None:
    engine = load("audi-25-tfsi")
    found = amplitudes(engine)

    # counterweights of half of what the range reaches: the rotating couple passes through its least
    def figures(each: Engine) -> dict[tuple[str, float | None], float]:
        own = found.figures(each)["couple", 1.0]
        return {("couple", 1.0): abs(own - 1000.0)}

    tried = Tried(
        at=lambda mass: with_turning_masses(engine, mass, None),
        figures=figures,
        now=figures(engine),
        ends=(0.2, 1.2),
        value=None,
    )
    tried.add_extremes(("couple", 1.0), top=1000.0)
    assert min(size for _x, size in tried.sizes(("couple", 1.0))) < 1e-6


@pytest.mark.parametrize("jump", [0.3, 0.67, 1.42, 1.9])
def test_both_sides_of_a_jump_are_found(jump: float) -> None:
    """1 - 0.3 x falls to a jump of 0.5, and falls again."""
    engine, at, key = load("i4"), {"x": 1.0}, ("force", 1.0)

    def vary(value: float) -> Engine:
        at["x"] = value
        return engine

    def figures(_each: Engine) -> dict[tuple[str, float | None], float]:
        return {key: 1 - 0.3 * at["x"] + 0.5 * (at["x"] > jump)}

    tried = Tried(at=vary, figures=figures, now={}, ends=(0.0, 2.0), value=None)
    tried.add_extremes(key, top=1.0)
    tried.add_jump(key, top=1.0)
    sizes = [size for _x, size in tried.sizes(key)]
    assert max(sizes) == pytest.approx(max(1.0, 1.5 - 0.3 * jump), abs=0.3 * 0.02)
    assert min(sizes) == pytest.approx(min(1 - 0.3 * jump, 0.9), abs=0.3 * 0.02)


def test_a_curve_without_a_jump_is_tried_only_a_little_more() -> None:
    engine, at, key = load("i4"), {"x": 1.0}, ("force", 1.0)

    def vary(value: float) -> Engine:
        at["x"] = value
        return engine

    for curve in (np.exp, np.square, lambda x: 1 / (1.05 - x), lambda x: abs(x - 0.4)):
        tried = Tried(
            at=vary,
            figures=lambda _each, curve=curve: {key: float(curve(at["x"]))},
            now={},
            ends=(0.0, 1.0),
            value=None,
        )
        top = max(size for _x, size in tried.sizes(key))
        tried.add_extremes(key, top=top)
        before = len(tried.known)
        tried.add_jump(key, top=top)
        assert len(tried.known) <= before + 6


def test_what_turns_in_the_middle_of_a_range_has_its_crankpins_too() -> None:
    engine = load("audi-25-tfsi")
    own = of(engine, amplitudes(engine), "cylinder.rotating_mass")
    assert own.vary is not None
    low, high = ends(own)
    pins = dict(own.values)["pins"]
    throw = own.vary(engine, (low + high) / 2).shafts[0].throws[0]
    assert throw.turning_mass == pytest.approx((low + high) / 2 + sum(pins) / 2, rel=1e-12)


def test_the_load_of_each_mount_follows_the_centre_of_mass_by_moments() -> None:
    engine = plain(up="90 mm", right="0 mm")
    block = mounted_block(engine)
    loads = borne(block, settled(block)[1])
    weight, centre = 165 * 9.80665, block.body.centre
    places = np.array([*PLACES.values()])
    assert loads.sum() == pytest.approx(weight)
    # moments of the vertical forces alone: next to nothing is along the crankshaft
    moment = (loads * (places[:, 2] - centre[2])).sum()
    assert moment == pytest.approx(0.0, abs=1e-3 * weight)
    figures = on_mounts(engine).figures(engine)
    found = [figures[f"load of mount {name}", None] for name in PLACES]
    assert found == pytest.approx(loads.tolist())


@pytest.mark.release
def test_a_mount_that_lifts_off_in_the_range_of_the_centre_is_named() -> None:
    near = [{**each, "z": "-50 mm"} if each["name"] == "rear" else each for each in MOUNTS]
    engine = standing(mounts=near, block={"mass": "165 kg", "up": "0 mm", "right": "0 mm"})
    found = rests_on(engine, on_mounts(engine))
    own = next(each for each in found if each.path == "block.z")
    assert own.vary is not None
    assert own.moved is not None
    block = mounted_block(engine)
    names = np.array([each.name for each in block.mounts])
    now = borne(block, settled(block)[1])
    pulling = set()
    for value in np.linspace(*ends(own), 41).tolist():
        moved = mounted_block(own.vary(engine, value))
        pulling |= {*names[(now > 0) & (borne(moved, settled(moved)[1]) < 0)].tolist()}
    assert pulling
    assert {*own.moved.lifting} == pulling
    line = next(line for line in assumption_lines(found) if line.startswith("block.z"))
    assert all(name in line.split("lifts off")[1] for name in pulling)
    rows = {row["path"]: row for row in assumption_facts(found)["rests_on"]}
    assert {*rows["block.z"]["moves"]["lifting"]} == pulling


def test_a_usual_cycle_of_a_file_without_gas_moves_no_force_on_its_mounts() -> None:
    engine = plain()
    still = with_values(engine, gas=None, drive=None)
    answer = summary(still)
    before = answer.figures(still)["mount force", None]
    burning = answer.figures(with_values(still, gas=engine.gas))
    assert burning["mount force", None] == before


@pytest.mark.release
def test_a_place_that_is_put_in_has_the_figures_that_its_range_has() -> None:
    """The point is the centre of mass where none is named: it moves along, as in a run by hand."""
    engine, speed = plain(), 900 * pi / 30
    answer = on_mounts(engine, speeds=[speed])
    [right] = [each for each in rests_on(engine, answer) if each.path == "block.right"]
    assert right.vary is not None
    moved = right.vary(engine, 40.0)
    assert answer.figures(moved) == on_mounts(moved, speeds=[speed]).figures(moved)
    over = mounts(moved, speeds=[speed]).over
    assert over is not None
    own = over.velocity(body(moved).centre)[0]
    size = 1e3 * float(np.sqrt((np.abs(own) ** 2).sum() / 2))
    assert answer.figures(moved)["velocity at the point", None] == pytest.approx(size, rel=1e-9)
