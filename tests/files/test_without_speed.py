"""A torque without a speed is that of gas alone: the record says so first, and how much it is."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run

import crankstar
from crankstar import spectra
from crankstar.mechanics.gas import cycle
from crankstar.studies.gas_results import roll_of

FOUR: dict[str, Any] = {
    "name": "four",
    "firing_order": [1, 3, 4, 2],
    "cylinder": {
        "bore": "86 mm",
        "stroke": "86 mm",
        "rod_length": "146 mm",
        "reciprocating_mass": "500 g",
        "rotating_mass": "500 g",
    },
    "layout": {"type": "inline", "bore_pitch": "94 mm"},
    "gas": {"imep": "9 bar"},
}


def roll(rpm: float) -> float:
    """At a speed, of the ignition that is assumed without one: a low speed alone says Diesel."""
    changes = {"speed": f"{rpm} rpm", "gas.ignition": "spark"}
    engine = crankstar.load("four.json", changes=changes)
    own = spectra.selected(roll_of(engine, cycle(engine)), [2.0])
    return float(np.abs(spectra.amplitude(own))[0])


@pytest.mark.parametrize("verb", ["torque", "genset"])
def test_a_missing_speed_says_what_inertia_would_change(verb: str, run: Run) -> None:
    Path("four.json").write_text(json.dumps(FOUR))
    rests = json.loads(run(verb, "four.json", "--json").out)["rests_on"]
    first = rests[0]
    assert (first["status"], first["path"], first["unit"]) == ("missing", "speed", "rpm")
    assert (first["moves"]["quantity"], first["moves"]["order"]) == ("roll", 2)
    assert "\nNot in these numbers: gas.\n" in run("verdict", "four.json").out  # in m r ω² alone
    ends = [roll(first[end]) for end in ("low", "high")]
    assert first["moves"]["low"] <= min(ends) * (1 + 1e-9)
    assert first["moves"]["high"] == pytest.approx(max(ends), rel=1e-9)


def test_missing_masses_are_not_in_a_torque(run: Run) -> None:
    tree = json.loads(json.dumps(FOUR))
    del tree["cylinder"]["reciprocating_mass"], tree["cylinder"]["rotating_mass"]
    Path("four.json").write_text(json.dumps(tree))
    rests = json.loads(run("torque", "four.json", "--json").out)["rests_on"]
    [rest] = [each for each in rests if each["path"] == "cylinder.reciprocating_mass"]
    assert rest["status"] == "left out"


@pytest.mark.release
def test_compared_at_an_assumed_speed_forces_go_with_its_square(run: Run) -> None:
    """Of two engines without a speed; the greatest of what moves is a force of inertia."""
    for name in ("one", "two"):
        Path(f"{name}.json").write_text(json.dumps({**FOUR, "name": name}))
    answer = json.loads(run("compare", "one.json", "two.json", "--json").out)
    rests = [each for each in answer["rests_on"] if each["path"] == "speed"]
    assert len(rests) == 2
    for rest in rests:
        moves = rest["moves"]
        assert (rest["status"], moves["quantity"], moves["order"]) == ("assumed", "force", 2)
        for end in ("low", "high"):
            assert moves[end] / moves["now"] == pytest.approx(
                (rest[end] / rest["value"]) ** 2, rel=1e-9
            )
    assert answer["rests_on"][0]["path"] == "speed"


@pytest.mark.release
@pytest.mark.parametrize("quantity", ["peak_pressure", "mean_torque"])
def test_a_speed_is_not_missed_in_what_does_not_depend_on_it(quantity: str, run: Run) -> None:
    Path("four.json").write_text(json.dumps(FOUR))
    words = ["sweep", "four.json", "--over", "gas.imep=6..9 bar/3", "--quantity", quantity]
    answer = json.loads(run(*words, "--json").out)
    assert "speed" not in {each["path"] for each in answer.get("rests_on", ())}
    fast = json.loads(run(*words, "--speed", "6000 rpm", "--json").out)
    slow, quick = ([row[quantity] for row in each["values"]] for each in (answer, fast))
    assert slow == pytest.approx(quick, rel=1e-12)


SEVEN: dict[str, Any] = {
    "name": "seven",
    "cycle": "two-stroke",
    "firing_order": [1, 7, 2, 5, 4, 3, 6],
    "cylinder": {
        "bore": "600 mm",
        "stroke": "2400 mm",
        "rod_ratio": 2.2,
        "reciprocating_mass": "5500 kg",
        "rotating_mass": "3200 kg",
    },
    "layout": {"type": "inline", "bore_pitch": "1020 mm"},
    "gas": {"imep": "19 bar", "intake_pressure": "3.6 bar", "ignition": "compression"},
}


@pytest.mark.release
def test_a_missing_speed_is_in_the_record_of_guide_forces_and_of_what_analyze_says(
    run: Run,
) -> None:
    Path("seven.json").write_text(json.dumps(SEVEN))
    for words, quantity, order in (
        (["marine"], "X moment", 3),
        (["guide", "--numbers", "5,7"], "X of member 5", None),
        (["analyze"], "roll with gas", 7),
    ):
        verb, *others = words
        rests = json.loads(run(verb, "seven.json", *others, "--json").out)["rests_on"]
        [rest] = [each for each in rests if each["path"] == "speed"]
        moves = rest["moves"]
        assert (moves["quantity"], moves["order"]) == (quantity, order), verb
        if verb != "marine":
            continue
        tables = [
            json.loads(run("marine", "seven.json", "--speed", f"{rest[end]} rpm", "--json").out)
            for end in ("low", "high")
        ]
        sizes = [
            each["x"]["amplitude"]
            for table in tables
            for each in table["guide"]
            if each["order"] == 3
        ]
        assert moves["low"] <= min(sizes) * (1 + 1e-9)
        assert moves["high"] == pytest.approx(max(sizes), rel=1e-9)
