"""Changed copies and engines of layouts: pistons, dead centres and firings by a second road."""

from __future__ import annotations

from math import degrees, pi, radians

import numpy as np
import pytest
from tests import newton

from crankstar.engine.basis import Basis, Sizes
from crankstar.engine.copies import (
    turned_on,
    with_banks_mirrored,
    with_rotation_reversed,
    with_values,
)
from crankstar.engine.engine import Engine
from crankstar.engine.firing_angles import firing_angles
from crankstar.engine.layouts import Row, radial
from crankstar.files import engine_of, explicit
from crankstar.files.catalog import load
from crankstar.options.sources import loaded
from crankstar.remedy.counterweights import with_counterweights

ROTATIONS = ("clockwise", "counter-clockwise")


def star(rotation: str, *, master: int = 3, offset: float = 0.0) -> Engine:
    """A radial five with knuckle pins, whose first cylinder has a slave rod unless it is master."""
    return radial(
        Basis(
            name="five",
            rotation=rotation,  # pyright: ignore[reportArgumentType]
            cylinder=Sizes(stroke=0.12, rod_length=0.24, offset=offset),
        ),
        rows=(Row(cylinders=(1, 2, 3, 4, 5), bearing=0.3, master=master),),
        knuckle_radius=0.05,
    )


def distances(engine: Engine, number: int, theta: np.ndarray) -> np.ndarray:
    """How far a piston pin is from its shaft at crank angles in the direction of rotation."""
    cylinder = next(c for c in engine.cylinders if c.number == number)
    return np.hypot(*newton.placed(engine, cylinder, theta.astype(np.longdouble))[1].T)


@pytest.mark.many(first=1)
@pytest.mark.parametrize("rotation", ROTATIONS)
@pytest.mark.parametrize("master", [1, 3, 4])
def test_the_first_cylinder_of_a_layout_begins_at_its_dead_centre(
    rotation: str, master: int
) -> None:
    theta = np.linspace(-pi, pi, 20_001)
    away = distances(star(rotation, master=master), 1, theta)
    assert abs(theta[away.argmax()]) < 1e-3


@pytest.mark.many(first=1)
@pytest.mark.parametrize("rotation", ROTATIONS)
def test_pistons_of_a_mirrored_star_are_mirror_images_at_the_mirrored_crank(rotation: str) -> None:
    engine = star(rotation, offset=0.011)
    mirrored = with_banks_mirrored(engine)
    # where its pin is, both counted clockwise, is where the other's is, to the other side
    apart = engine.shafts[0].throws[0].angle + mirrored.shafts[0].throws[0].angle
    theta = np.linspace(0, 2 * pi, 25, dtype=np.longdouble)
    other = -theta - engine.sense * apart
    for one, image in zip(engine.cylinders, mirrored.cylinders, strict=True):
        right, up = newton.placed(engine, one, theta)[1].T
        across, height = newton.placed(mirrored, image, other)[1].T
        assert np.allclose((across, height), (-right, up), rtol=0, atol=1e-12)


@pytest.mark.many(first=3)
@pytest.mark.parametrize("name", ["v8-cross-plane", "harley-45", "kr250-racer", "audi-25-tfsi"])
@pytest.mark.parametrize("ahead", [0.0, 0.7])
def test_a_reversed_engine_fires_when_the_other_would_run_backwards(
    name: str, ahead: float
) -> None:
    loaded = load(name)
    written = tuple(radians(angle) for angle in firing_angles(loaded))
    engine = turned_on(with_values(loaded, firing_angles=written), ahead)
    backwards = with_rotation_reversed(engine)
    fires, then = (
        dict(zip(e.firing_order, firing_angles(e), strict=True)) for e in (engine, backwards)
    )
    assert fires.keys() == then.keys()
    cycle = engine.cycle_angle
    for number, angle in fires.items():
        assert (then[number] + angle + cycle / 2) % cycle == pytest.approx(cycle / 2, abs=1e-6)


def test_a_weight_set_together_with_its_throw_stands_where_it_is_set() -> None:
    engine = with_values(with_counterweights(load("i4"), factor=0.5), firing_order=())
    tree = explicit(engine)
    own = "shaft[1].weight[2].angle"
    changed = engine_of(tree, changes={"shaft[1].throw[2].angle": "30 deg", own: "77 deg"})
    (shaft,) = changed.shafts
    assert degrees(shaft.throws[1].angle) == pytest.approx(30)
    assert degrees(shaft.weights[1].angle) == pytest.approx(77)
    for place in (0, 2, 3):
        assert shaft.weights[place].angle == pytest.approx(engine.shafts[0].weights[place].angle)
    assert loaded(tree, {"shaft[1].throw[2].angle": "30 deg", own: "77 deg"}).source == changed
