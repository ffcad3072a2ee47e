"""The unit of a number on the page is that of its quantity, whatever the engine file leaves out."""

from __future__ import annotations

import pytest

from crankstar.dynamics.whirl import estimated_mass
from crankstar.engine.engine import Engine
from crankstar.files.catalog import load
from crankstar.page.exhibits import exhibit
from crankstar.page.records import Exhibit

MASS, STROKE = 0.47, 0.0734
"""kg and m that are given to an engine which has them not."""


def shown(engine: Engine) -> tuple[Exhibit, list[float]]:
    """What the page has of an engine, and the moments of inertia that its panel prints."""
    own = exhibit(engine)
    return own, [size * own.units.inertia.factor for size in own.whirl.inertia]


@pytest.mark.many(first=1)
@pytest.mark.parametrize("name", ["parallel-twin-180", "bmw-g650", "bmw-r1200"])
def test_moments_of_inertia_in_m_r2_are_those_of_a_file_with_masses_over_its_m_r2(
    name: str,
) -> None:
    """The file gives the stroke but no mass; it is read as it is, and with a mass.

    The block has in both the mass that a file without masses has: another goes by displacement.
    """
    relative = load(name)
    assert ("mass" in relative.relative, "radius" in relative.relative) == (True, False)
    whole = MASS * estimated_mass(relative)[0]
    absolute = load(
        name,
        changes={
            "cylinder.reciprocating_mass": f"{MASS} kg",
            **({} if relative.block and relative.block.mass else {"block.mass": f"{whole!r} kg"}),
        },
    )
    radius = relative.throw(relative.first).radius
    one, panel = shown(relative)
    other, expected = shown(absolute)
    assert (one.units.inertia.label, other.units.inertia.label) == ("m r²", "kg m²")
    assert panel == pytest.approx([size / (MASS * radius**2) for size in expected], rel=1e-9)


def test_a_stroke_leaves_the_inertia_about_the_axis_in_m_r2_as_it_was() -> None:
    without, axis = shown(load("i4"))
    given, along = shown(load("i4", changes={"cylinder.stroke": f"{STROKE} m"}))
    assert without.units.inertia.label == given.units.inertia.label == "m r²"
    assert along[2] == pytest.approx(axis[2], rel=1e-9)


def test_a_known_mass_with_an_unknown_radius_has_kg_r2() -> None:
    own, panel = shown(load("i4", changes={"cylinder.reciprocating_mass": f"{MASS} kg"}))
    assert own.units.inertia.label == "kg r²"
    assert panel == pytest.approx([MASS * size for size in shown(load("i4"))[1]], rel=1e-9)
