"""`crankstar derive --quantity gas`: the proof, what is left, and what cannot be asked."""

from __future__ import annotations

import json

import numpy as np
import pytest
from tests.commands import Run


@pytest.mark.release
def test_derive_prints_the_proof_and_what_is_left(run: Run) -> None:
    shown = run("derive", "bmw-s65", "--quantity", "gas").out
    assert "(1 − z⁸)/(1 − z)" in shown
    whole, first = shown.index("All cylinders"), shown.index("Bank bank 1")
    assert "S_1/2 = 0" in shown[whole:first]
    assert "S_1/2 = √(4 − 2√2)" in shown[first:]
    told = run("torque", "bmw-s65", "--json").out
    gas = {row["order"]: np.hypot(*row["gas"]) for row in json.loads(told)["orders"]}
    assert [order for order in gas if gas[order] > 0 and order < 9] == [4.0, 8.0]


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("pratt-whitney-wasp", "--quantity", "gas"), "all alike"),
        (("i4", "--quantity", "gas", "--orders", "1/3"), "multiples of 1/2"),
        (("i4", "--quantity", "gas", "--off", "7"), "no cylinder has the number 7"),
        (("i4", "--off", "2"), "no effect without --quantity gas"),
        (("i4", "--quantity", "gas", "--power", "3"), "--power"),
    ],
)
def test_a_wrong_request_of_gas_orders_is_told(
    arguments: tuple[str, ...], words: str, run: Run
) -> None:
    result = run("derive", *arguments)
    assert result.code == 2
    assert words in " ".join(result.err.split())
