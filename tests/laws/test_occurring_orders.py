"""No order of inertia or gas is one that the engine is said not to have; others are refused."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.strategies import OF_ANY_KIND

from crankstar.files.catalog import load
from crankstar.mechanics.balance import balance
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import gas_torque
from crankstar.mechanics.occurring_orders import (
    OrderError,
    check_orders,
    foreign_orders,
    fundamental_orders,
)


@pytest.mark.parametrize("kind", OF_ANY_KIND)
@given(data=st.data())
def test_moving_parts_push_at_no_foreign_order(kind: str, data: st.DataObject) -> None:
    engine = data.draw(OF_ANY_KIND[kind])
    orders = balance(engine).force.orders.tolist()
    assert foreign_orders(engine, orders, gas=False) == []
    assert foreign_orders(engine, orders, gas=True) == []
    lowest = float(min(fundamental_orders(engine, gas=True)))
    assert foreign_orders(engine, [lowest / 2, -lowest], gas=True) == [lowest / 2, -lowest]


@pytest.mark.parametrize("name", ["audi-25-tfsi", "man-s90mc-c", "napier-deltic", "jumo-205"])
def test_gas_pushes_at_no_foreign_order(name: str) -> None:
    engine = load(name)
    orders = gas_torque(cycle(engine)).torque.orders.tolist()
    assert len(orders) > 20
    assert foreign_orders(engine, orders, gas=True) == []


def test_the_orders_that_occur_are_named() -> None:
    with pytest.raises(OrderError, match=r"order 0\.5 does not occur .* are 1, 2, 3, 4 and so on"):
        check_orders(load("man-s90mc-c"), [1, 0.5], gas=True)
    with pytest.raises(OrderError, match=r"orders 0\.3, -1 do not .* 0\.5, 1, 1\.5, 2 and so on"):
        check_orders(load("i4"), [0.3, -1, 0.5], gas=True)
    with pytest.raises(OrderError, match="orders inf, nan do not occur"):
        check_orders(load("i4"), [float("inf"), float("nan")], gas=True)
    check_orders(load("i4"), [], gas=False)
