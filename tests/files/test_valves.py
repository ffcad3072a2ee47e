"""The `[valves]` table of an engine file: read, written, assumed, and every mistake in it told."""

from __future__ import annotations

import json
from math import degrees, radians
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.commands import Run
from tests.texts import EXPLICIT, SHORT, spoilt, told

import crankstar
from crankstar.engine.records import Valves
from crankstar.engine.valves import ASSUMED, EVENTS, timing
from crankstar.files import engine_of, toml, tree_of
from crankstar.firing.strokes import exhaust_groups, working_cycle

GIVEN = {
    "intake_opens": "12 deg",
    "exhaust_opens": "61 deg",
    "manifolds": [[1, 3], [5, 7], [2, 4, 6, 8]],
}


@pytest.mark.parametrize("text", [SHORT, EXPLICIT])
def test_both_forms_take_valves_and_give_them_back(text: str) -> None:
    engine = engine_of(spoilt(text, valves={**GIVEN, "manifolds": []}))
    assert engine.valves is not None
    assert degrees(engine.valves.intake_opens or 0) == pytest.approx(12)
    assert engine.valves.intake_closes is None
    again = engine_of(tree_of(toml(engine))).valves
    assert again is not None
    for name in EVENTS:
        assert getattr(again, name) == pytest.approx(getattr(engine.valves, name))


ANGLES = st.none() | st.floats(radians(20), radians(80)).map(lambda angle: round(angle, 6))
ORDERS = st.permutations(range(1, 9)).map(tuple)
SPLITS = st.builds(lambda order, at: (order[:at], order[at:]), ORDERS, st.integers(1, 7))


@pytest.mark.release
@given(st.builds(Valves, **dict.fromkeys(EVENTS, ANGLES), manifolds=st.just(()) | SPLITS))
def test_any_valves_are_the_same_written_and_read_back(valves: Valves) -> None:
    engine = engine_of(tree_of(SHORT)).model_copy(update={"valves": valves})
    again = engine_of(tree_of(toml(engine))).valves
    assert again is not None
    assert again.manifolds == valves.manifolds
    for name in EVENTS:
        assert (getattr(again, name) or 0.0) == pytest.approx(
            getattr(valves, name) or 0.0, rel=1e-13
        )


def test_what_is_assumed_is_never_written() -> None:
    text = toml(engine_of(spoilt(SHORT, valves=GIVEN)))
    assert "closes" not in text
    assert "manifolds = [[1, 3], [5, 7], [2, 4, 6, 8]]" in text
    assert "valves" not in toml(engine_of(tree_of(SHORT)))


@pytest.mark.parametrize("cycle", ASSUMED)
def test_what_is_assumed_is_marked_and_is_an_engine_that_runs(cycle: Any) -> None:
    found = timing(None, cycle=cycle)
    assert found.assumed == EVENTS
    assert (
        told(
            spoilt(
                SHORT,
                cycle="four-stroke",
                valves={name: f"{getattr(found, name)} rad" for name in EVENTS},
            )
        )
        == {}
    )
    assert timing(Valves(exhaust_opens=0.5), cycle=cycle).assumed == (
        "intake_opens",
        "intake_closes",
        "exhaust_closes",
    )


def test_manifolds_take_the_place_of_banks() -> None:
    groups = exhaust_groups(engine_of(spoilt(SHORT, valves=GIVEN)))
    assert [group.chambers for group in groups] == [(1, 3), (5, 7), (2, 4, 6, 8)]
    assert [group.name for group in groups][:2] == ["manifold 1, 3", "manifold 5, 7"]


@pytest.mark.parametrize(
    ("valves", "place", "words"),
    [
        (
            {"exhaust_opens": "200 deg"},
            "exhaust_opens",
            "is 200 deg; it must lie between -180 and 180 deg, such as 50 deg",
        ),
        (
            {"exhaust_opens": 60},
            "exhaust_opens",
            "is 60 rad; the largest plausible value is 6.2832 rad. Did you mean 60 deg?",
        ),
        ({"exhaust_opens": "60 mm"}, "exhaust_opens", 'is "60 mm", a length; an angle is needed'),
        ({"exhaust_opens": True}, "exhaust_opens", "is true; an angle is needed"),
        (
            {"exhaust_open": "60 deg"},
            "exhaust_open",
            'is not a key of an engine file; did you mean "exhaust_opens"?',
        ),
        (
            {"intake_opens": "100 deg", "intake_closes": "170 deg"},
            "intake_closes",
            "keeps the intake open for 450 deg, from 10 to 360 deg are possible",
        ),
        (
            {"exhaust_closes": "-170 deg", "exhaust_opens": "-9 deg"},
            "exhaust_closes",
            "keeps the exhaust open for 1 deg, ",
        ),
        (
            {"intake_closes": "-180 deg", "intake_opens": "-15 deg"},
            "intake_closes",
            "keeps the intake open for -15 deg",
        ),
        ({"exhaust_closes": "-179 deg", "exhaust_opens": None}, None, ""),
        ({"intake_opens": "-180 deg"}, None, ""),
        ({"intake_opens": "-180 deg", "intake_closes": "9 deg"}, "intake_closes", "open for 9 deg"),
        (
            {"exhaust_closes": "130 deg", "intake_opens": "60 deg"},
            "intake_opens",
            "keeps intake and exhaust open together for 190",
        ),
        (
            {"manifolds": [[1, 3, 5, 7], [2, 4, 6, 9]]},
            "manifolds[2]",
            "has cylinder 9, and there is no such cylinder; there are:",
        ),
        (
            {"manifolds": [[1, 3, 5, 7], [2, 4, 6, 8, 1]]},
            "manifolds",
            "has cylinder 1 more than once; each leads into one",
        ),
        (
            {"manifolds": [[1, 3, 5, 7]]},
            "manifolds",
            "misses cylinders 2, 4, 6, 8; each leads into one manifold, a pipe",
        ),
        (
            {"manifolds": [[1, 3, 5, 7], [2, 4, 6, 8], []]},
            "manifolds[3]",
            "has no cylinders; name those whose exhausts meet in it",
        ),
        (
            {"manifolds": [[1, "x"]]},
            "manifolds[1][2]",
            'is "x"; a whole number is needed, such as 1',
        ),
        ({"manifolds": [1, 2]}, "manifolds[1]", "is 1; a list is needed, such as [1]"),
        ({"manifolds": 3}, "manifolds", "is 3; a list is needed, such as [[1, 4], [2, 3]]"),
    ],
)
def test_every_mistake_is_told_with_its_place_and_what_would_be_right(
    valves: dict[str, Any], place: str | None, words: str
) -> None:
    found = told(
        spoilt(SHORT, valves={key: value for key, value in valves.items() if value is not None})
    )
    if place is None:
        assert found == {}
    else:
        assert words in found[f"valves.{place}"]


def test_the_ports_of_a_two_stroke_engine_are_about_bottom_dead_centre() -> None:
    found = told(spoilt(EXPLICIT, valves={"exhaust_opens": "-80 deg"}))
    assert (
        "keeps the exhaust open for 5 deg (exhaust_closes is assumed to be 85 deg)"
        in found["valves.exhaust_opens"]
    )
    assert (
        told(spoilt(EXPLICIT, valves={"exhaust_opens": "89 deg", "exhaust_closes": "50 deg"})) == {}
    )
    engine = engine_of(
        spoilt(
            EXPLICIT,
            firing_order=[1, 2],
            valves={"exhaust_opens": "89 deg", "exhaust_closes": "50 deg"},
        )
    )
    one = working_cycle(engine).chambers[0]
    assert (one.exhaust.start_deg, one.exhaust.end_deg) == pytest.approx((91, 230))
    assert one.blow_down.end_deg == pytest.approx(120)


def test_an_intake_that_closes_before_bottom_dead_centre_is_a_miller_cycle() -> None:
    engine = crankstar.load("i4", changes={"valves.intake_closes": "-30 deg"})
    one = working_cycle(engine).chambers[0]
    assert one.intake.end_deg == pytest.approx(510)


@pytest.mark.release
def test_strokes_are_printed_with_what_is_assumed(run: Run) -> None:
    out = run("strokes", "v8-cross-plane").out
    assert "Exhaust opens 50 deg (assumed) before bottom" in out
    assert "270-180-90-180" in out
    assert "Neighbours that fire in succession: 5-7 (90 deg)." in out
    assert "4-3 (90 deg), 6-5 (90 deg), 2-1 (90 deg)" in out
    own = run("strokes", "v8-cross-plane", "--set", 'valves.exhaust_opens="60 deg"').out
    assert "Exhaust opens 60 deg before bottom" in own
    joined = run(
        "strokes", "v8-cross-plane", "--set", "valves.manifolds=[[1,2],[3,4],[5,6],[7,8]]"
    ).out
    assert "manifold 1, 2" in joined
    assert "bank" not in joined


def test_strokes_as_json_are_those_of_the_working_cycle(run: Run) -> None:
    answer = json.loads(run("strokes", "v8-cross-plane", "--json").out)
    found = working_cycle(crankstar.load("v8-cross-plane"))
    assert answer["cycle_deg"] == 720
    assert answer["assumed"] == list(EVENTS)
    assert answer["timing_deg"]["exhaust_opens"] == pytest.approx(
        degrees(found.timing.exhaust_opens)
    )
    assert [one["exhaust_open"] for one in answer["cylinders"]] == [
        [one.exhaust.start_deg, one.exhaust.end_deg % 720] for one in found.chambers
    ]
    assert answer["neighbours_in_succession"] == [[5, 7]]
    odd = next(group for group in answer["exhausts"] if group["name"] == "bank odd")
    assert odd["intervals_deg"] == [270, 180, 90, 180]
    disturbed = {"blowing": 7, "disturbed": 5, "exhaust_open_deg": 50.0, "both_open_deg": 0.0}
    assert any(disturbed.items() <= row.items() for row in answer["disturbances"])


def test_an_engine_without_a_firing_order_is_told_that_it_has_no_strokes(refused: Any) -> None:
    assert (
        "napier-lion: firing_order is missing, and the stroke of each cylinder depends on it"
        in refused("strokes", "napier-lion")
    )


def test_show_tells_the_valves_of_a_file_and_what_is_assumed(run: Run) -> None:
    assert "valves:" not in run("show", "i4").out
    out = run(
        "show",
        "i4",
        "--set",
        'valves.exhaust_opens="60 deg"',
        "--set",
        "valves.manifolds=[[1,4],[2,3]]",
    ).out
    assert (
        "Exhaust opens 60 deg before bottom and closes 15 deg (assumed) after top dead centre."
        in out
    )
    assert "Exhaust manifolds join cylinders 1, 4; 2, 3." in out


def test_valves_have_nothing_to_sweep(refused: Any) -> None:
    assert "has no effect on the inertia forces" in refused(
        "sweep", "i4", "--over", "valves.exhaust_opens=0..90 deg"
    )


def test_the_angles_of_a_record_are_radians() -> None:
    assert timing(Valves(intake_opens=radians(10)), cycle="four-stroke").intake_opens == radians(10)
