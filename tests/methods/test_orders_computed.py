"""An order that was not computed is not taken for zero, nor is what is no order."""

from __future__ import annotations

import math
from typing import Any

import pytest

import crankstar
from crankstar import spectra
from crankstar.dynamics.bearings import bearing_loads
from crankstar.mechanics.batches import totals
from crankstar.mechanics.mechanism import mechanism
from crankstar.mechanics.pin_loads import pin_loads
from crankstar.studies.sweep import sweep

I4 = crankstar.load("i4")


def test_an_order_that_was_not_computed_is_refused_with_those_there_are() -> None:
    some = crankstar.total(crankstar.balance(I4, orders=[1, 4]))
    words = "^order 2 was not computed; there are the orders 1, 4$"
    for spectrum in (*some, spectra.scaled(some.force, 2.0), spectra.turned(some.couple, 1.0)):
        with pytest.raises(ValueError, match=words):
            spectra.selected(spectrum, [1, 2])
    with pytest.raises(ValueError, match=r"there are the orders 0, 1$"):
        spectra.selected(pin_loads(mechanism(I4), orders=[1]).guide, 2)
    swept = sweep(I4, "speed=1000..2000 rpm/3", orders=[1])
    with pytest.raises(ValueError, match=r"there are the orders 1$"):
        spectra.selected(swept.sums.force, 2)


def test_an_order_that_no_part_has_is_zero() -> None:
    whole = crankstar.total(crankstar.balance(I4))
    third = spectra.selected(whole.force, 3)
    assert (third.orders.tolist(), abs(third.forward[0])) == ([3.0], 0.0)
    assert spectra.selected(bearing_loads(I4).load, 1.5).forward.any().item() is False
    assert spectra.selected(sweep(I4, "speed=1000..2000 rpm/3").sums.force, 3).orders == [3.0]


@pytest.mark.parametrize("order", [math.nan, -2, math.inf, -math.inf])
def test_what_is_no_order_is_refused(order: float) -> None:
    force: Any = crankstar.total(crankstar.balance(I4)).force
    calls: list[Any] = [
        lambda: spectra.selected(force, order),
        lambda: spectra.selected(force, [1, order]),
        lambda: totals(mechanism(I4), orders=[1, order]),
        lambda: pin_loads(mechanism(I4), orders=[order]),
    ]
    for call in calls:
        with pytest.raises(ValueError, match="is no crank order; give numbers above 0"):
            call()
