"""What a hole takes away: the closed form against the integral, holes side by side, slugs."""

from __future__ import annotations

from cmath import exp
from math import pi, radians, tan

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from crankstar.engine.copies import with_values
from crankstar.files.catalog import load
from crankstar.language.messages import MessageError
from crankstar.mechanics.balance import balance, total
from crankstar.remedy import RemedyError, with_counterweights
from crankstar.remedy.drilling import (
    Drill,
    Holes,
    heavy_spots,
    holes,
    mass_of_hole,
    possible,
    unbalance_of_hole,
)
from crankstar.spectra import selected

DRILLS = st.builds(
    Drill,
    diameter=st.floats(0.004, 0.03),
    radius=st.floats(0.06, 0.15),
    deepest=st.floats(0.012, 0.03),
    tip=st.sampled_from([radians(90), radians(118), radians(135), pi]),
    density=st.floats(2700, 8000),
    slug=st.sampled_from([None, 17_000.0, 18_500.0]),
    axial=st.booleans(),
)


def integrated(depth: float, drill: Drill) -> tuple[float, float]:
    """Unbalance and mass of a hole, disk by disk along its axis (Gauss-Legendre)."""
    nodes, weights = np.polynomial.legendre.leggauss(24)
    unbalance = mass = 0.0
    cylinder_density = drill.density if drill.slug is None else drill.slug - drill.density
    cone_density = drill.density if drill.slug is None else -drill.density
    slope = tan(drill.tip / 2) if drill.tip < pi else 0.0
    cone = drill.diameter / 2 / slope if slope else 0.0
    for start, length, density, tapered in (
        (0.0, depth, cylinder_density, False),
        (depth, cone, cone_density, True),
    ):
        for node, weight in zip(nodes, weights, strict=True):
            along = length * (node + 1) / 2
            own = (length - along) * slope if tapered else drill.diameter / 2
            disk = density * pi * own**2 * weight * length / 2
            mass += disk
            unbalance += disk * (drill.radius - (0.0 if drill.axial else start + along))
    return unbalance, mass


@given(drill=DRILLS, share=st.floats(0.01, 1))
def test_the_closed_form_is_the_integral_over_cylinder_and_cone(drill: Drill, share: float) -> None:
    depth = share * drill.deepest
    unbalance, mass = integrated(depth, drill)
    assert unbalance_of_hole(depth, drill) == pytest.approx(unbalance, rel=1e-12, abs=1e-15)
    assert mass_of_hole(depth, drill) == pytest.approx(mass, rel=1e-12, abs=1e-15)


def vector(made: Holes, drill: Drill) -> complex:
    """The unbalance of all holes together, along their middle."""
    single = integrated(made.depth, drill)[0]
    return sum((single * exp(1j * angle) for angle in made.angles), 0j)


def most(count: int, drill: Drill) -> float:
    """The greatest unbalance of so many holes side by side, at any depth."""
    sizes = [0.0]
    for depth in np.linspace(0, drill.deepest, 513)[1:]:
        bottom = drill.radius - (0 if drill.axial else depth)
        step = 2 * np.arcsin(min(1.0, 0.625 * drill.diameter / bottom))
        if (count - 1) * step <= radians(120):
            turned = [exp(1j * step * (place - (count - 1) / 2)) for place in range(count)]
            sizes.append(abs(sum(turned)) * integrated(float(depth), drill)[0])
    return max(sizes)


@pytest.mark.release
@given(drill=DRILLS, share=st.floats(0.3, 3))
def test_holes_side_by_side_have_the_unbalance_that_is_asked_for(
    drill: Drill, share: float
) -> None:
    wanted = share * unbalance_of_hole(drill.deepest, drill)
    least = unbalance_of_hole(0.0, drill)
    if wanted <= max(least, 0.0) * 1.01:
        return
    try:
        made = holes(wanted, drill)
    except RemedyError:
        return
    assert vector(made, drill) == pytest.approx(wanted, rel=1e-6)
    assert made.depth <= drill.deepest * (1 + 1e-9)
    assert made.tip_depth - made.depth == pytest.approx(drill.cone)
    if made.number > 1:
        assert most(made.number - 1, drill) < wanted * (1 + 1e-6)
        bottom = drill.radius - (0 if drill.axial else made.depth)
        apart = 2 * bottom * np.sin((made.angles[1] - made.angles[0]) / 2)
        assert apart >= 1.2499 * drill.diameter


def test_one_hole_less_deep_takes_away_only_a_part_of_the_tip() -> None:
    drill = Drill(diameter=0.0127, radius=0.08, deepest=0.03)
    made = holes(20e-6, drill)
    assert (made.number, made.depth) == (1, 0.0)
    assert 0 < made.tip_depth < drill.cone
    nodes = np.linspace(0, made.tip_depth, 20_001)
    own = (made.tip_depth - nodes) * tan(drill.tip / 2)
    disks = drill.density * pi * own**2 * (drill.radius - nodes)
    assert np.trapezoid(disks, nodes) == pytest.approx(20e-6, rel=1e-5)


def test_a_slug_adds_net_of_the_steel_that_was_drilled_out() -> None:
    drill = Drill(0.0254, 0.075, 0.025, tip=pi, slug=17_000, axial=True)
    made = holes(1198.1e-6, drill)
    steel, heavy = (density * pi / 4 * 0.0254**2 * made.depth for density in (7850, 17_000))
    assert made.mass == pytest.approx(heavy - steel)
    assert (heavy - steel) * 0.075 == pytest.approx(1198.1e-6)


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"diameter": 0.0}, "greater than 0"),
        ({"deepest": 0.0}, "greater than 0"),
        ({"diameter": 0.1}, "does not fit"),
        ({"deepest": 0.079}, "reaches the crank axis"),
        ({"slug": 7000.0}, "no heavier"),
    ],
)
def test_an_impossible_drill_is_refused(changes: dict[str, float], words: str) -> None:
    drill = Drill(diameter=0.012, radius=0.08, deepest=0.03)
    with pytest.raises(RemedyError, match=words):
        possible(drill._replace(**changes))


def test_more_than_fits_beside_each_other_is_refused_with_what_fits() -> None:
    drill = Drill(diameter=0.012, radius=0.08, deepest=0.02)
    with pytest.raises(RemedyError, match="more than holes of 12 mm") as refused:
        holes(0.1, drill)
    assert isinstance(refused.value, MessageError)
    assert "100 kg mm" in str(refused.value)


@pytest.mark.many(first=2)
@pytest.mark.parametrize("factor", [0.4, 0.5, 0.56])
def test_a_crankshaft_drilled_as_said_leaves_the_machine_nothing(factor: float) -> None:
    """Weights cut for 0.5; the holes are weights of their own, taken away at the heavy spot."""
    eight = load("v8-cross-plane")
    cut = with_counterweights(eight, factor=0.5, planes=[1.5, -1.5])
    after = with_counterweights(cut, factor=factor, planes=[1.5, -1.5])
    spots = heavy_spots(cut, after)
    assert (not spots) == (factor == 0.5)
    shaft = cut.shafts[0]
    taken = [
        with_values(shaft.weights[0], unbalance=s.unbalance, angle=s.angle + pi, z=s.z, throw=None)
        for s in spots
    ]
    drilled = with_values(
        cut, shafts=(with_values(shaft, weights=(*shaft.weights, *taken)), *cut.shafts[1:])
    )
    wanted = with_counterweights(eight, factor=factor, planes=[1.5, -1.5])
    for kind in ("force", "couple"):
        one, other = (
            complex(selected(getattr(total(balance(e)), kind), 1.0).forward[0])
            for e in (drilled, wanted)
        )
        assert one == pytest.approx(other, abs=1e-9)


def test_holes_side_by_side_span_no_more_than_a_counterweight() -> None:
    """Neighbours are 46 deg apart: three span 92 deg, the fourth would be beyond 120 deg.

    Of n holes at steps s along the rim the sum is that of cos((k - (n - 1)/2) s).
    """
    drill = Drill(diameter=0.03, radius=0.06, deepest=0.012, tip=pi)
    step = 2 * np.arcsin(1.25 * drill.diameter / 2 / (drill.radius - drill.deepest))
    single = integrated(drill.deepest, drill)[0]
    three, four = (
        single * np.cos((np.arange(count) - (count - 1) / 2) * step).sum() for count in (3, 4)
    )
    assert four > 1.05 * three
    made = holes(0.999 * three, drill)
    assert np.ptp(made.angles) <= 2 * step < radians(120) < 3 * step
    assert abs(vector(made, drill)) == pytest.approx(0.999 * three, rel=1e-9)
    with pytest.raises(RemedyError):
        holes((three + four) / 2, drill)
