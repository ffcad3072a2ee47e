"""Questions that tests of the search ask."""

from __future__ import annotations

from math import pi
from typing import Any

from tests import exhaustive

from crankstar.engine.basis import Basis, Sizes
from crankstar.engine.engine import Engine
from crankstar.engine.layouts import inline
from crankstar.stars.question import All, Best, FunctionObjective, Question
from crankstar.stars.star import Stars
from crankstar.stars.sums import Limit, couple, neighbours, of


def space(cylinders: int, cycle: Any = "two-stroke", **more: Any) -> Stars:
    return Stars(cylinders, cycle, exhaustive.halves(cylinders), **more)


def front(cylinders: int, cycle: Any = "two-stroke") -> Question:
    stars = space(cylinders, cycle)
    return Question(stars, (of(couple(stars, 1)), of(couple(stars, 2))))


def every_kind() -> dict[str, Question]:
    """A cut front, the best, a cut list, one with a function, a four-stroke question."""
    ten, eight, four = space(10), space(8), space(10, "four-stroke")
    return {
        "front": front(11),
        "front of neighbours": Question(eight, (of(couple(eight, 2)), neighbours())),
        "best": Question(ten, (of(couple(ten, 1)),), ask=Best(30)),
        "list": Question(
            ten, (of(couple(ten, 1)),), limits=(Limit(couple(ten, 2), 2.0),), ask=All(40)
        ),
        "judge": Question(
            eight,
            (of(couple(eight, 1)),),
            limits=(Limit(couple(eight, 2), 2.0),),
            functions=(FunctionObjective("ends", lambda star: abs(star[0] - star[7])),),
        ),
        "four-stroke": Question(four, (of(couple(four, 2)), neighbours())),
    }


def seven(factor: float | None) -> Engine:
    """An in-line seven, two-stroke, counterweights by a balance factor, 105 rpm."""
    sizes = Sizes(stroke=2.4, rod_length=2.46, reciprocating_mass=5500.0, rotating_mass=6800.0)
    basis = Basis(
        name="seven",
        cycle="two-stroke",
        firing_order=(1, 7, 2, 5, 4, 3, 6),
        speed=105 * pi / 30,
        balance_factor=factor,
        cylinder=sizes,
    )
    return inline(basis, positions=(0.0, 1.02, 2.04, 3.06, 4.08, 5.6, 6.62))
