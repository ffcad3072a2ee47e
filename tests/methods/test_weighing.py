"""Firing orders weighed by gas torque and by twist: against that of the engine in the order."""

from __future__ import annotations

import json
from fractions import Fraction

import numpy as np
import pytest

import crankstar
from crankstar import spectra
from crankstar.derive.firing_sums import factor, places_of
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.firing.intervals import firing
from crankstar.firing.numbering import with_order
from crankstar.firing.orders import even_orders, possible_orders
from crankstar.firing.weighing import WeighingError, even_shape, sums_of, twist_shape, weighed
from crankstar.mechanics.gas import Cycle, cycle
from crankstar.mechanics.gas_torque import gas_torque, of_one_cylinder

ORDERS = [0.5, 1.0, 1.5, 2.0, 2.5, 3.0]
UNEVEN = ["yamaha-r1-crossplane", "ducati-900ss", "yamaha-mt-07"]
EVEN = ["honda-b18c", "bmw-m52b28", "bmw-s65", "ferrari-f136", "gm-3800"]


def burning(engine: Engine) -> Cycle:
    """The cycle at 9 bar, with the charge of full load where the file has that point."""
    if engine.gas is None or not engine.gas.points:
        return cycle(engine, imep=9e5, speed=300.0)
    return cycle(engine, imep=9e5, point="full")


def computed(engine: Engine) -> tuple[dict[int, np.ndarray], np.ndarray]:
    """The spectrum of each chamber in ORDERS, and of the engine, N m."""
    found = gas_torque(burning(engine))
    rows = spectra.amplitude(spectra.selected(found.torque, ORDERS))
    whole = spectra.amplitude(spectra.selected(found.total, ORDERS))
    return dict(zip(found.numbers, rows, strict=True)), whole


@pytest.mark.parametrize("name", UNEVEN)
def test_the_weighed_torque_is_that_of_the_engine_in_each_order(name: str) -> None:
    engine = crankstar.load(name)
    found = possible_orders(engine)
    sizes = of_one_cylinder(burning(engine), ORDERS)
    weigh = weighed(found, even_shape(engine), ORDERS, sizes)
    for order, row in zip(weigh.orders, weigh.sums, strict=True):
        _each, whole = computed(with_order(engine, order.firing))
        assert np.abs(whole) == pytest.approx(row, rel=1e-9, abs=1e-9 * max(sizes))
    assert list(weigh.whole) == pytest.approx(sorted(weigh.whole))
    assert weigh.whole[0] < 0.95 * weigh.whole[-1]


@pytest.mark.parametrize("name", EVEN)
def test_the_weighed_twist_is_that_of_the_torques_along_the_crankshaft(name: str) -> None:
    engine = crankstar.load(name)
    sizes = of_one_cylinder(burning(engine), ORDERS)
    shape = twist_shape(engine)
    weigh = weighed(even_orders(engine)[:3], shape, ORDERS, sizes)
    for order, row in zip(weigh.orders, weigh.sums, strict=True):
        each, _whole = computed(with_order(engine, order.firing))
        twist = sum(shape[number] * wave for number, wave in each.items())
        assert np.abs(twist) == pytest.approx(row, rel=1e-9, abs=1e-9 * max(sizes))


@pytest.mark.parametrize("name", [*UNEVEN, *EVEN])
def test_the_firing_order_changes_half_orders_only(name: str) -> None:
    engine = crankstar.load(name)
    orders = possible_orders(engine) if name in UNEVEN else even_orders(engine)
    for shape in (even_shape(engine), twist_shape(engine)):
        rows = [sums_of(order.firing, shape, [1, 2, 3, 4]) for order in orders]
        assert rows == [pytest.approx(rows[0], abs=1e-9)] * len(rows)


@pytest.mark.parametrize("name", EVEN)
def test_even_orders_have_the_torque_of_their_frequency_alone(name: str) -> None:
    engine = crankstar.load(name)
    count = len(engine.chambers)
    for order in even_orders(engine):
        sums = sums_of(order.firing, even_shape(engine), [n / 2 for n in range(1, count + 1)])
        assert sums == pytest.approx([0.0] * (count - 1) + [count], abs=1e-9)


@pytest.mark.parametrize("name", [*UNEVEN, *EVEN])
def test_the_sums_are_the_exact_ones(name: str) -> None:
    engine = crankstar.load(name)
    places = places_of(engine)
    exact = [abs(complex(factor(places, Fraction(order)))) for order in ORDERS]
    assert sums_of(firing(engine), even_shape(engine), ORDERS) == pytest.approx(exact, abs=1e-12)


def test_a_six_has_little_twist_of_one_order_or_the_other() -> None:
    engine = crankstar.load("bmw-m52b28")
    orders = even_orders(engine)
    by_half = weighed(orders, twist_shape(engine), [0.5]).orders[0]
    by_three = weighed(orders, twist_shape(engine), [1.5]).orders[0]
    assert by_half.firing.order == (1, 5, 3, 6, 2, 4)  # the customary one
    assert by_three.firing.order == (1, 2, 4, 6, 5, 3)
    squares = [
        sum(each**2 for each in sums_of(order.firing, twist_shape(engine), [0.5, 1.5, 2.5]))
        for order in orders
    ]
    # what one order loses another one gains: half orders share the squares of the shape
    assert squares == pytest.approx([squares[0]] * len(squares))


def test_cylinders_at_one_place_cannot_twist() -> None:
    single = crankstar.load("bmw-g650")
    with pytest.raises(WeighingError):
        twist_shape(single)
    assert with_values(single, name="x").first.z == single.first.z


def test_answers_of_orders_carry_their_sums() -> None:
    engine = crankstar.load("yamaha-r1-crossplane")
    weigh = weighed(possible_orders(engine), even_shape(engine), [0.5])
    own = next(
        row[0]
        for order, row in zip(weigh.orders, weigh.sums, strict=True)
        if order.firing.order == (1, 3, 2, 4)
    )
    assert own == pytest.approx(np.sqrt(4 - 2 * np.sqrt(2)))
    assert json.dumps(weigh.whole[0])
