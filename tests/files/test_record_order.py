"""The order of a record: what has a size by that size, a doubt among the others.

A triple and a V6: the couple of its pins by hand against the roll of its rods.
"""

from __future__ import annotations

from math import pi, sqrt
from typing import Any

import pytest

from crankstar.analysis.assumptions import Answer, Assumption, Moved
from crankstar.analysis.assumptions import moved as vary_all
from crankstar.engine.copies import with_values
from crankstar.files import engine_of
from crankstar.studies.answers import amplitudes, rests_on
from crankstar.tables.assumptions import assumption_lines, leading_lines, side_by_side

TRIPLE: dict[str, Any] = {
    "name": "triple",
    "firing_order": [1, 3, 2],
    "speed": "9000 rpm",
    "cylinder": {
        "bore": "78 mm",
        "stroke": "61 mm",
        "rod_length": "112 mm",
        "reciprocating_mass": "290 g",
        "rod": {"mass": "380 g", "centre": "32 mm"},
    },
    "layout": {"type": "inline", "bore_pitch": "90 mm"},
}


def moved(effect: float) -> Moved:
    return Moved("force", 1.0, "N", 1.0, 1.0, 1.0 + effect, effect)


def doubt(path: str, effect: float | None) -> Assumption:
    reason = f"{path} is odd"
    own = None if effect is None else moved(effect)
    return Assumption("doubtful", path, reason, 1.0, "kg", 2.0, 2.0, moved=own)


def lacking(path: str, effect: float | None) -> Assumption:
    own = None if effect is None else moved(effect)
    return Assumption("missing", path, "not there", None, "kg", 1.0, 2.0, moved=own)


def test_a_doubt_of_two_per_cent_follows_what_moves_more() -> None:
    own = engine_of(TRIPLE, name="triple")
    found = rests_on(own, amplitudes(own))
    paths = [each.path for each in found]
    assert paths[-1] == "cylinder.rod.inertia"
    assert [each.effect for each in found] == sorted((e.effect for e in found), reverse=True)
    pins = next(each for each in found if each.path == "cylinder.throw_mass")
    assert pins.moved is not None
    assert pins.high is not None
    turning = (9000 * pi / 30) ** 2 * 0.0305 * 0.09 * sqrt(3)
    assert pins.moved.high - pins.moved.now == pytest.approx(pins.high * turning, rel=1e-6)
    lines = assumption_lines(found)
    assert lines[-1].startswith("cylinder.rod.inertia is not given")


def test_a_doubt_that_moves_nothing_is_last_and_says_only_why() -> None:
    found = [lacking("a", 0.2), doubt("b", 1e-5)]
    first, last = assumption_lines(found)
    assert first.startswith("a: not there.")
    assert last == "b is odd."


def test_two_of_each_engine_that_matter_most() -> None:
    one = [doubt("a", None), lacking("b", 0.9), lacking("c", 0.5), doubt("d", 0.02)]
    other = [lacking("e", 0.8), lacking("f", 0.4), lacking("g", None)]
    first, rest = side_by_side([one, other], ["one", "other"])

    def paths(texts: tuple[str, ...]) -> list[str]:
        return [text.rstrip(".").split(" ")[0].rstrip(":") for text in texts[1:]]

    assert [paths(each.lines) for each in first] == [["a", "b"], ["e", "f"]]
    assert [paths(each.lines) for each in rest] == [["c", "d"], ["Not"]]
    assert leading_lines(one)[0][0] == "a is odd."


@pytest.mark.parametrize(
    ("turn", "told"), [(1.55, "resonant amplitude"), (9.0, "torsional amplitude")]
)
def test_a_resonance_is_told_before_the_turn_of_the_whole_shaft(turn: float, told: str) -> None:
    """0.3 to 0.45 deg is a share of 1/3 of the greater, 1 to 1.55 deg one of 0.35.

    The turn of the whole leads where it moves more than twice as much: 1 to 9 is 8/9.
    """
    engine = engine_of(TRIPLE, name="triple")
    now = {("torsional amplitude", None): 1.0, ("resonant amplitude", 9.0): 0.3}
    then = {("torsional amplitude", None): turn, ("resonant amplitude", 9.0): 0.45}
    answer = Answer(
        figures=lambda own: now if own is engine else then, unit=lambda _name, _own: "deg"
    )
    meant = Assumption(
        "doubtful",
        "x",
        "odd",
        1.0,
        "bar",
        2.0,
        2.0,
        vary=lambda own, _x: with_values(own, name="x"),
    )
    [found] = vary_all(engine, [meant], answer)
    assert found.moved is not None
    assert found.moved.quantity == told
    assert found.effect == pytest.approx({"resonant amplitude": 1 / 3}.get(told, 8 / 9))
    name = "at the resonance of order 9" if told[0] == "r" else "maximum turn of the free end over"
    assert name in assumption_lines([found])[0]
