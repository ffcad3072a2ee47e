"""Families of engines: their formulas against the Balance of engines of the family."""

from __future__ import annotations

from math import copysign, radians
from typing import Any

import numpy as np
import pytest

from crankstar import load, spectra, total
from crankstar.derive import DerivationError, family
from crankstar.derive.algebra import typeset
from crankstar.derive.algebra.evaluation import value
from crankstar.derive.chapters import Chapter
from crankstar.engine.engine import Engine
from crankstar.engine.motion import piston_harmonics
from crankstar.mechanics.balance import balance

ORDERS, ANGLES = (1, 2, 4, 6), (0.2, 1.3, 4.0)
VEES = ["v2-90", "harley-45", "v8-flat-plane", "v8-cross-plane", "v12-60", "merlin", "ferrari-f136"]


def bare(engine: Engine, **changes: Any) -> Engine:
    """The engine with other angles, without rotating parts or a firing order that may not fit."""
    return engine.model_copy(update={"firing_order": (), **changes})


def opened(engine: Engine, half: float) -> Engine:
    """A V engine with another bank angle, its first cylinder at top dead centre at theta = 0."""
    old = engine.first.bearing
    (shaft,) = engine.shafts
    by = copysign(half, old) - old
    throws = tuple(
        throw.model_copy(update={"angle": throw.angle + by, "rotating_mass": 0.0})
        for throw in shaft.throws
    )
    cylinders = tuple(
        c.model_copy(update={"bearing": copysign(half, c.bearing)}) for c in engine.cylinders
    )
    return bare(
        engine,
        shafts=(shaft.model_copy(update={"throws": throws, "weights": ()}),),
        cylinders=cylinders,
    )


def assert_says(
    chapter: Chapter, engine: Engine, order: int, quantity: str, **letters: float
) -> None:
    """The closed form comes to what the engine does, at several crank angles."""
    one = spectra.selected(getattr(total(balance(engine)), quantity), [order])
    forward, backward = complex(one.forward[0]), complex(one.backward[0])
    first = engine.first
    scale = piston_harmonics(crank_radius=engine.throw(first).radius, rod_length=first.rod_length)[
        order
    ].real
    checked = 0
    for line in chapter.steps[-1].lines:
        for theta in ANGLES if line.kind == "signal" else ():
            vector = forward * np.exp(1j * engine.sense * order * theta) + backward * np.exp(
                -1j * engine.sense * order * theta
            )
            wanted = (vector * np.exp(-1j * radians(line.bearing_deg))).real
            for formula in line.chain:
                found = scale * value(formula, {**chapter.symbols, **letters, "theta": theta})
                assert found == pytest.approx(wanted, abs=1e-13 * len(engine.cylinders)), (
                    typeset.text(formula)
                )
                checked += 1
    assert checked


@pytest.mark.many(first=5)
@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
@pytest.mark.parametrize("name", VEES)
def test_a_v_engine_of_any_bank_angle_does_what_its_family_says(name: str, rotation: str) -> None:
    engine = load(name).model_copy(update={"rotation": rotation, "firing_order": ()})
    for half in (0.3, 0.9):
        for order in ORDERS:
            for quantity in ("force", "couple"):
                chapter = family(engine, order, quantity, symbol="alpha")
                assert_says(chapter, opened(engine, half), order, quantity, alpha=half)


def test_a_v_twin_draws_an_ellipse_with_the_squares_of_cosine_and_sine() -> None:
    up, right = family(load("harley-45"), 1, "force", symbol="alpha").steps[-1].lines
    assert typeset.text(up.chain[-1]).startswith("2 cos² α cos(θ")
    assert typeset.text(right.chain[-1]).startswith("2 sin² α sin(θ")


@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
@pytest.mark.parametrize("phase", [0.5, 2.0, 3.0])
def test_a_twin_of_any_crank_phase_does_what_its_family_says(phase: float, rotation: str) -> None:
    engine = load("i2-360")
    (shaft,) = engine.shafts
    front, rear = shaft.throws
    behind = rear.model_copy(
        update={"angle": front.angle - phase * (1 if rotation == "clockwise" else -1)}
    )
    turned = bare(
        engine, rotation=rotation, shafts=(shaft.model_copy(update={"throws": (front, behind)}),)
    )
    for order in ORDERS:
        for quantity in ("force", "couple"):
            assert_says(
                family(engine, order, quantity, symbol="phi"), turned, order, quantity, phi=phase
            )


@pytest.mark.parametrize(
    "name", ["triple-120", "sinitsyn-6-loop", "sinitsyn-7-first", "sinitsyn-8-two-stroke", "single"]
)
def test_a_row_on_evenly_spaced_cranks_has_only_the_orders_its_number_divides(name: str) -> None:
    engine = load(name)
    for order in (1, 2, 4, 6, 8):
        chapter = family(engine, order, "force", symbol="n")
        assert_says(chapter, engine, order, "force", n=len(engine.cylinders))
        left = value(chapter.steps[-1].lines[-1].chain[-1], {"theta": 0.0})
        assert left == (len(engine.cylinders) if order % len(engine.cylinders) == 0 else 0)


@pytest.mark.parametrize(
    ("name", "order", "quantity", "symbol", "told"),
    [
        ("i4", 1, "force", "alpha", "half the angle between two banks"),
        ("v2-90", 1, "force", "phi", "cranks of two parallel cylinders"),
        ("v8-cross-plane", 1, "force", "n", "evenly spaced"),
        ("i4", 1, "force", "n", "evenly spaced"),
        ("triple-120", 1, "couple", "n", "numbering"),
        ("vw-vr6", 1, "force", "alpha", "misses the crankshaft"),
        ("square-four", 1, "force", "phi", "several"),
        ("v2-90", 0, "force", "alpha", "from 1 to 24"),
        ("v2-90", 1.5, "force", "alpha", "whole orders"),
        ("v2-90", 1, "roll", "alpha", "no symbolic form"),
        ("v2-90", 1, "force", "beta", "alpha, phi, n"),
    ],
)
def test_an_engine_outside_the_family_is_told_why(
    name: str, order: Any, quantity: Any, symbol: str, told: str
) -> None:
    with pytest.raises(DerivationError, match=told):
        family(load(name), order, quantity, symbol=symbol)


def test_an_odd_order_of_a_family_is_said_to_be_absent() -> None:
    assert (
        "no harmonic of order 3"
        in family(load("v2-90"), 3, "force", symbol="alpha").steps[-1].words[0]
    )


@pytest.mark.parametrize("rotation", ["clockwise", "counter-clockwise"])
def test_the_cosines_of_one_pin_add_up_as_they_are_written(rotation: str) -> None:
    for name in ("v2-90", "v8-cross-plane"):  # the first cylinder on the left, and on the right
        engine = load(name).model_copy(update={"rotation": rotation, "firing_order": ()})
        for order in ORDERS:
            for line in family(engine, order, "force", symbol="alpha").steps[1].lines[:2]:
                for theta in ANGLES:
                    written, added = (
                        value(formula, {"theta": theta, "alpha": 0.7}) for formula in line.chain
                    )
                    assert written == pytest.approx(added, abs=1e-14)
