"""`crankstar draw --orders`: orders that an engine does not have."""

from __future__ import annotations

from tests.commands import Run


def test_a_drawing_says_of_which_orders_there_is_nothing(run: Run) -> None:
    assert "None of orders 1, 999." in run("draw", "i4", "--orders", "1,2,999", "-o", "x.svg").err
    assert "None of" not in run("draw", "i4", "--orders", "2", "-o", "x.svg").err
    assert "None of" not in run("draw", "i4", "--orders", "9", "--arrows", "none").err
