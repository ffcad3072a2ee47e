"""Of two masses that turn, big ends and crankpins, each is missing on its own."""

from __future__ import annotations

from math import pi
from typing import Any

import pytest

from crankstar.analysis.assumptions import Answer, Assumption
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.remains import sizes
from crankstar.remedy.counterweights import with_counterweights
from crankstar.studies.answers import amplitudes, rests_on, summary
from crankstar.studies.load_answers import bearing_peaks
from crankstar.studies.sweep import sweep, watched
from crankstar.studies.sweep_answers import judged

MOWER: dict[str, Any] = {
    "name": "lawn-mower single",
    "firing_order": [1],
    "speed": "3060 rpm",
    "cylinder": {
        "bore": "68.3 mm",
        "stroke": "51.8 mm",
        "rod_length": "95 mm",
        "reciprocating_mass": "265 g",
    },
    "layout": {"type": "inline"},
    "crankshaft": [{"weight": [{"throw": 1, "unbalance": "7.5 g*m"}]}],
}
PISTON, ENDS, RADIUS, SPEED, UNBALANCE = 0.265, 0.13155, 0.0259, 3060 * pi / 30, 7.5e-3
PINS = "cylinder.throw_mass"


def _primary(turning: float) -> float:
    """The primary force, N, of a single: A cos t up, B sin t right, whichever is greater."""
    up = (PISTON + turning) * RADIUS - UNBALANCE
    right = turning * RADIUS - UNBALANCE
    return SPEED**2 * max(abs(up), abs(right))


def _pins(engine: Engine, answer: Answer) -> Assumption:
    return next(each for each in rests_on(engine, answer) if each.path == PINS)


def _of_loads(engine: Engine) -> Answer:
    return bearing_peaks(engine, lambda _: None)


def test_crankpins_are_missing_beside_big_ends_that_are_given() -> None:
    """In every answer that has the primary force; a bearing carries half of what it moves."""
    engine = engine_of(MOWER, changes={"cylinder.rotating_mass": "131.55 g"})
    for answer in (amplitudes(engine), summary(engine)):
        own = _pins(engine, answer)
        assert own.moved is not None
        assert own.low is not None
        assert (own.moved.quantity, own.moved.order) == ("force", 1.0)
        assert own.moved.now == pytest.approx(_primary(ENDS), rel=1e-6)
        assert own.moved.high == pytest.approx(_primary(ENDS + (own.high or 0)), rel=1e-6)
        assert own.moved.low == pytest.approx(_primary(ENDS + own.low), rel=1e-6)
    loads = _pins(engine, _of_loads(engine)).moved
    assert loads is not None
    assert loads.high > 1.5 * loads.now


def test_a_sweep_of_the_big_ends_names_the_crankpins() -> None:
    found = sweep(MOWER, "cylinder.rotating_mass=100..400 g/4")
    read = judged(found, [watched(found, "force", order=1)])
    own = _pins(read.engine, read.answer)
    assert own.moved is not None
    assert own.moved.now == pytest.approx(_primary(0.1), rel=1e-6)
    assert own.moved.high == pytest.approx(_primary(0.1 + (own.high or 0)), rel=1e-6)


def test_a_mass_that_is_given_or_balanced_by_a_factor_is_not_missing() -> None:
    """A balance factor takes up crankpins of any mass: no force depends on them."""
    both = {"cylinder.rotating_mass": "131.55 g", "cylinder.throw_mass": "200 g"}
    given = engine_of(MOWER, changes=both)
    assert PINS not in {each.path for each in rests_on(given, amplitudes(given))}
    bare = {key: value for key, value in MOWER.items() if key != "crankshaft"}
    halved = {**bare, "balance_factor": 0.5}
    engine, heavier = (
        engine_of(halved, changes={"cylinder.rotating_mass": "131.55 g", PINS: mass})
        for mass in ("0 g", "200 g")
    )
    assert PINS not in {each.path for each in rests_on(engine, amplitudes(engine))}
    forces = [total(balance(each, speed=SPEED)).force for each in (engine, heavier)]
    now, then = (sizes(each)[0] for each in forces)
    assert now == pytest.approx(then) == pytest.approx(PISTON / 2 * RADIUS * SPEED**2)


def test_weights_that_a_file_gives_say_what_they_may_leave_out() -> None:
    """Those fitted and written into a file rest on the same mass as when they are fitted."""
    bare = {key: value for key, value in MOWER.items() if key != "crankshaft"}
    engine = engine_of(bare, changes={"cylinder.rotating_mass": "131.55 g"})
    after = with_counterweights(engine, factor=0.5)
    own = _pins(after, amplitudes(after))
    assert "taken off" in own.reason
    assert own.moved is not None
    half = PISTON / 2 * RADIUS * SPEED**2
    assert own.moved.now == pytest.approx(half, rel=1e-6)
    more = (own.high or 0) * RADIUS * SPEED**2
    assert own.moved.high == pytest.approx(half + more, rel=1e-6)
