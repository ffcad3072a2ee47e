"""Slips of unit in lists, spreadsheets and tolerances: each refused or doubted at its place."""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run
from tests.files.test_correcting import RUNS

from crankstar.engine.quantities import ANGLE
from crankstar.files import EngineFileError, engine_of
from crankstar.files.cells import _other_unit
from crankstar.files.columns import Columns
from crankstar.files.lists import list_of
from crankstar.files.tolerances import tolerances_of, wide

pytestmark = pytest.mark.quick
Refused = Callable[..., str]
FOUR: dict[str, Any] = {
    "name": "four",
    "firing_order": [1, 3, 4, 2],
    "cylinder": {"stroke": "90 mm", "rod_length": "145 mm", "reciprocating_mass": "480 g"},
    "layout": {"type": "inline", "bore_pitch": "96 mm"},
}


@pytest.mark.parametrize(
    ("head", "cell", "turns"),
    [
        ("at [rad]", "6.28", 6.28 / (2 * pi)),
        ("at [rad]", "40", None),
        ("at [turn]", "0.25", 0.25),
        ("at [turn]", "90", None),
        ("at [deg]", "-177", -177 / 360),
        ("at [deg]", "405", 405 / 360),
        ("at", "-177 rad", None),
    ],
)
def test_an_angle_of_a_list_is_in_degrees_beyond_a_turn(
    head: str, cell: str, turns: float | None
) -> None:
    columns = Columns(list_of(f"no,{head}\n1,{cell}\n", name="a.csv"), {"no": "no", "at": "at"})
    found = columns.value(columns.rows[0], "at", ANGLE)
    if turns is not None:
        assert found == pytest.approx(2 * pi * turns, rel=1e-12)
        return
    [mistake] = columns.mistakes
    number = cell.split()[0]
    assert f"Did you mean {number} deg?" in mistake.told
    assert mistake.told.startswith(f'line 2, column "{head}"')


def test_turns_of_a_trial_weight_are_refused(refused: Refused, tmp_path: Path) -> None:
    text = RUNS.replace("at [deg]", "at [turn]")
    (tmp_path / "runs.csv").write_text(text, encoding="utf-8")
    said = " ".join(refused("correct", "runs.csv").split())
    assert 'line 4, column "at [turn]" is 90 turn; the largest plausible value is 1 turn.' in said


@pytest.mark.parametrize(
    ("own", "beside", "other"),
    [
        ("in", "mm", True),
        ("kg", "g", True),
        ("mm", "mm", False),
        ("kg m", "kg*m", False),
        ("", "mm", False),
    ],
)
def test_a_unit_in_a_cell_is_that_beside_it(own: str, beside: str, other: bool) -> None:
    assert _other_unit(own, beside) is other


def test_a_tolerance_of_more_than_half_a_turn_is_any_angle() -> None:
    def of(bound: str) -> Any:
        throws = ["0 deg", "180 deg", f"180 deg +- {bound}", "0 deg"]
        return engine_of({**FOUR, "layout": {**FOUR["layout"], "throws": throws}})

    of("180 deg")
    for bound in ("180.1 deg", "1000 deg", "0.6 turn"):
        with pytest.raises(EngineFileError, match="more than half a turn"):
            of(bound)


@pytest.mark.parametrize(
    ("value", "share"),
    [("480 g +- 479.999 g", "100"), ("480 g +- 120 g", "25"), ("480 g +- 2 g", "")],
)
def test_a_tolerance_of_much_of_a_mass_is_doubted(
    run: Run, tmp_path: Path, value: str, share: str
) -> None:
    tree = {**FOUR, "cylinder": {**FOUR["cylinder"], "reciprocating_mass": value}}
    said = wide(tolerances_of(tree).values())
    assert len(said) == bool(share)
    place = tmp_path / "four.toml"
    lines = [f'{key} = "{each}"' for key, each in tree["cylinder"].items()]
    text = 'name = "four"\nfiring_order = [1, 3, 4, 2]\n[cylinder]\n' + "\n".join(lines)
    place.write_text(text + '\n[layout]\ntype = "inline"\nbore_pitch = "96 mm"\n', encoding="utf-8")
    told = f"cylinder.reciprocating_mass has a tolerance of {share} % of its value"
    assert (told in " ".join(run("check", str(place)).out.split())) == bool(share)
