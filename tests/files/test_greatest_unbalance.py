"""The greatest unbalance that a request allows is above zero."""

from __future__ import annotations

import pytest

from crankstar.files.catalog import load
from crankstar.language.messages import MessageError
from crankstar.options.remedies import unbalance

pytestmark = pytest.mark.quick


def test_an_unbalance_is_read_in_that_of_the_first_cylinder_and_only_above_zero() -> None:
    engine = load(
        "i4", changes={"cylinder.stroke": "80 mm", "cylinder.reciprocating_mass": "0.5 kg"}
    )
    assert unbalance("--max-unbalance", None, engine) is None
    assert unbalance("--max-unbalance", "10 kg*mm", engine) == pytest.approx(0.01 / (0.5 * 0.04))
    for text in ("0 kg*mm", "-10 kg*mm"):
        with pytest.raises(MessageError) as caught:
            unbalance("--max-unbalance", text, engine)
        assert "--max-unbalance" in str(caught.value)
