"""What the page is sent of torsion is what the command says, and what the gas does."""

from __future__ import annotations

import json
import subprocess
import sys
from typing import Any

import numpy as np
import pytest
from tests.twisting_engines import CLOCKWISE, COUNTER_CLOCKWISE, FLYWHEEL, HUB, twisting

from crankstar import spectra
from crankstar.analyses.torsion.document import document as torsion_document
from crankstar.analyses.torsion.question import Question
from crankstar.dynamics.torsion_analysis import torsion
from crankstar.dynamics.torsion_modes import holzer
from crankstar.engine.engine import Engine
from crankstar.files import engine_of, explicit
from crankstar.files.catalog import load
from crankstar.language.shown_units import read_choice, shown_in
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import over_cycle
from crankstar.page.exhibits import exhibit
from crankstar.page.figures import chart
from crankstar.page.torsion import (
    MOST_STARS,
    torsion_charts,
    torsion_needs,
    torsion_numbers,
    torsion_shown,
)
from crankstar.page.torsion_records import Torsion, Vibration
from crankstar.spectra import Complex, Real

RPM = 30 / np.pi


def sent(engine: Engine) -> Torsion:
    """The record of an engine that has one."""
    shown = torsion_shown(engine)
    assert shown is not None
    return shown


def amplitudes(waves: Any) -> Complex:
    """Waves that are sent as complex numbers."""
    return np.array([[complex(*pair) for pair in wave] for wave in waves])


def over(shown: Torsion, waves: Any, theta: Real) -> Real:
    """Waves over the crank angle, as the page adds them up [wave, angle]."""
    turning = np.exp(1j * np.multiply.outer(np.array(shown.orders), theta))
    return np.real(amplitudes(waves) @ turning)


def told(engine: Engine, vibration: Vibration) -> dict[str, Any]:
    """The tables of the command at the speed of a vibration, for machines."""
    speed = vibration.speed_rpm / RPM
    found = torsion(engine, speed=speed, point=vibration.point)
    document = torsion_document(engine, found, Question()).for_machines
    return {table.key: table for table in document.tables}


@pytest.mark.release
@pytest.mark.parametrize("name", [CLOCKWISE, COUNTER_CLOCKWISE])
def test_a_vibration_is_that_of_the_command_at_its_speed(name: str) -> None:
    engine = twisting(name)
    shown = sent(engine)
    theta = np.linspace(0, 4 * np.pi, 2881)
    for vibration in shown.vibrations[:3]:
        tables = told(engine, vibration)
        peaks = {row[0]: row[1] for row in tables["sections_at_speed"].rows}
        assert len(vibration.torque) == len(vibration.peak) == len(shown.pieces)
        for piece, wave, peak in zip(shown.pieces, vibration.torque, vibration.peak, strict=True):
            assert piece is not None
            assert peak == pytest.approx(peaks[piece.name], rel=1e-9)
            (course,) = over(shown, [wave], theta)
            assert np.abs(course).max() == pytest.approx(peak, rel=2e-3)


@pytest.mark.release
def test_the_turns_of_the_throws_obey_newton_between_the_shafts() -> None:
    """J times the acceleration is the torque behind less that in front, what drives and what damps.

    Summed over the throws of the gas and inertia alone: the second road to what is sent.
    """
    engine = twisting(CLOCKWISE, damping=None)
    shown, chain = sent(engine), torsion(engine).chain
    vibration = shown.vibrations[0]
    found = torsion(engine, point=vibration.point, speed=vibration.speed_rpm / RPM).at
    assert found is not None
    turns, torque = amplitudes(vibration.turns), amplitudes(vibration.torque)
    w = np.array(shown.orders) * vibration.speed_rpm / RPM
    driving = found.driving[0, :, list(shown.masses_of_throws)].T.T
    inertia = chain.inertia[list(shown.masses_of_throws)][:, None]
    # the hub hangs on the first throw, so that its torque is that of its own twist
    signs = np.ones((len(shown.pieces), 1))
    signs[0] = -1
    own = signs * torque
    left = -inertia * w**2 * turns - (own[1:] - own[:-1]) - driving
    assert np.abs(left).max() < 1e-6 * np.abs(driving).max()


@pytest.mark.release
@pytest.mark.parametrize(("name", "place"), [(CLOCKWISE, 2), (COUNTER_CLOCKWISE, 0)])
def test_a_throw_goes_ahead_while_the_gas_pushes_it(name: str, place: int) -> None:
    """Of a stiff crank on a soft shaft to a huge flywheel the twist is the torque over stiffness.

    Positive the way the crankshaft turns, whichever that is.
    """
    heavy = {**FLYWHEEL, "inertia": "1e7 kg*m^2", "stiffness": "1 MN*m/rad", "loss_factor": 0}
    stiff = {"stiffness": "1e6 MN*m/rad", "inertia": "1e-6 kg*m^2", "loss_factor": 0}
    engine = twisting(name, **stiff, bare_inertia=None, damping=None, disc=[heavy])
    shown = sent(engine)
    vibration = shown.vibrations[place]
    theta = np.arange(720) * 4 * np.pi / 720
    torque = over_cycle(cycle(engine, point=vibration.point), 720).sum(axis=0)
    if "mass" not in engine.relative:
        moving = total(balance(engine, speed=vibration.speed_rpm / RPM)).torque
        torque += np.real(spectra.value(moving, theta))
    (turn, *_others) = over(shown, vibration.turns, theta)
    course = (torque - torque.mean()) / 1e6
    assert turn == pytest.approx(course, abs=0.01 * np.abs(course).max())


@pytest.mark.release
def test_the_torque_of_a_mode_is_that_of_its_holzer_table() -> None:
    engine = twisting(CLOCKWISE, disc=[HUB, FLYWHEEL])
    shown, found = sent(engine), torsion(engine)
    for mode, own in zip(shown.modes, found.modes, strict=True):
        rows = holzer(found.chain, speed=own.speed)
        assert mode.frequency_hz == own.frequency
        assert mode.shape == tuple(own.shape)
        assert np.abs(mode.torque) == pytest.approx([abs(row.sum) for row in rows[:-1]], rel=1e-6)
        assert shown.pieces[0]
        assert shown.pieces[0].name == "hub - throw 1"


@pytest.mark.release
def test_throws_are_sent_from_the_front_wherever_the_file_has_them() -> None:
    plain = twisting(CLOCKWISE)
    tree = explicit(plain)
    (crank,) = (shaft for shaft in tree["shaft"] if shaft.get("throw"))
    crank["throw"].reverse()
    for cylinder in tree["cylinders"]:
        cylinder["throw"] = 6 - cylinder["throw"]
    turned = engine_of(tree)
    one, other = sent(plain), sent(turned)
    assert (one.throws, other.throws) == ((0, 1, 2, 3, 4), (4, 3, 2, 1, 0))
    for engine, shown in ((plain, one), (turned, other)):
        z = [engine.shafts[0].throws[place].z for place in shown.throws]
        assert z == sorted(z, reverse=True)
        names = [shown.masses[mass] for mass in shown.masses_of_throws]
        assert names == [f"throw {n}" for n in range(1, 6)]
    ours, theirs = (amplitudes(each.vibrations[0].turns) for each in (one, other))
    assert theirs == pytest.approx(ours, rel=1e-6)


@pytest.mark.many(first=2)
@pytest.mark.parametrize(
    ("discs", "ends"),
    [
        ([FLYWHEEL], (None, "throw 5 - flywheel")),
        ([HUB, FLYWHEEL], ("hub - throw 1", "throw 5 - flywheel")),
        ([{"name": "hub", "inertia": "0.01 kg*m^2", "to": "front"}, FLYWHEEL],
         (None, "throw 5 - flywheel")),
        ([FLYWHEEL, {"name": "flange", "inertia": "0.01 kg*m^2", "to": "rear"}],
         (None, None)),
        ([{"name": "ring", "inertia": "0.01 kg*m^2", "to": "front", "damping": "9 N*m*s/rad"}],
         (None, None)),
    ],
)  # fmt: skip
def test_an_end_of_the_crank_has_the_load_of_the_shaft_on_it(
    discs: list[dict[str, Any]], ends: tuple[str | None, str | None]
) -> None:
    pieces = sent(twisting(CLOCKWISE, disc=discs)).pieces
    assert len(pieces) == 6
    assert (pieces[0] and pieces[0].name, pieces[-1] and pieces[-1].name) == ends
    assert [each and each.name for each in pieces[1:-1]] == [
        f"throw {n} - throw {n + 1}" for n in range(1, 5)
    ]


def test_operating_points_come_first_then_the_strongest_critical_speeds() -> None:
    engine = twisting(CLOCKWISE)
    shown = sent(engine)
    points = [(each.point, round(each.speed_rpm)) for each in shown.vibrations if not each.critical]
    assert points == [("full", 6500), ("most torque", 5300), ("idle", 750)]
    listed = {(each.mode, each.order): each for each in shown.criticals}
    met = [each for each in shown.vibrations if each.critical]
    assert [listed[each.critical].speed_rpm for each in met if each.critical] == [
        each.speed_rpm for each in met
    ]
    strengths = sorted((each.strength for each in shown.criticals), reverse=True)
    assert [listed[each.critical].strength for each in met if each.critical] == strengths[:4]


@pytest.mark.release
def test_every_figure_of_torsion_that_is_offered_can_be_drawn() -> None:
    engine = twisting(COUNTER_CLOCKWISE)
    keys = list(torsion_charts(engine))
    assert {key.figure for key in keys} == {
        *("torsion-modes", "campbell", "torsion-response", "torsion-star")
    }
    stars = [key for key in keys if key.figure == "torsion-star"]
    assert 3 < len(stars) <= 3 * MOST_STARS
    for key in keys:
        assert chart(engine, key.key)["$schema"]
    (star,) = [key for key in stars if (key.quantity, key.order) == ("mode-1", stars[0].order)]
    words = json.dumps(chart(engine, star.key))
    assert f"order {star.order:g}: sum" in words


def test_numbers_are_those_of_the_command_in_the_units_that_are_chosen() -> None:
    engine = twisting(CLOCKWISE)
    numbers = torsion_numbers(engine)
    assert numbers is not None
    assert (numbers.stress_unit.label, numbers.torque_unit.label) == ("MPa", "N m")
    assert numbers.stress_unit.factor == pytest.approx(1e-6, rel=1e-12)
    with shown_in(read_choice("us")):
        other = torsion_numbers(engine)
    assert other is not None
    assert other.stress_unit.factor == pytest.approx(1 / 6894.757293168, rel=1e-9)
    assert [len(each) for each in numbers.vibrations] == [2] * len(sent(engine).vibrations)


def test_without_diameters_there_is_torque_and_without_gas_the_inertia_alone() -> None:
    bare = {key: value for key, value in FLYWHEEL.items() if key != "diameter"}
    shown = sent(twisting(CLOCKWISE, diameter=None, bore=None, disc=[bare]))
    assert all(piece is None or piece.modulus is None for piece in shown.pieces)
    own = {"inertia": "0.03 kg*m^2", "stiffness": "0.6 MN*m/rad", "disc": [bare]}
    still = sent(load("i6", changes={"torsion": own}))
    assert still.vibrations == ()
    assert len(still.modes) == 6
    assert exhibit(load("i6", changes={"torsion": own})).torsion_numbers is not None


def test_of_a_crank_that_cannot_twist_the_page_says_so() -> None:
    engine = load("single", changes={"torsion": {"inertia": "0.03 kg*m^2"}})
    shown, numbers = sent(engine), torsion_numbers(engine)
    assert (shown.modes, shown.pieces, numbers and numbers.frequencies.rows) == (
        *((), (None, None), ()),
    )
    assert numbers
    assert numbers.notes[0].startswith("Nothing twists")
    assert list(torsion_charts(engine)) == []


def test_an_engine_without_the_table_is_told_what_to_give() -> None:
    engine = load("i4")
    assert torsion_shown(engine) is torsion_numbers(engine) is None
    assert list(torsion_charts(engine)) == []
    assert torsion_needs(engine) == (
        "Torsion needs the inertias and stiffnesses of the crankshaft: give the table [torsion] in "
        "the engine file."
    )
    assert torsion_needs(twisting(CLOCKWISE)) == ""


@pytest.mark.release
def test_the_page_of_an_engine_without_the_table_loads_no_linear_algebra() -> None:
    script = (
        "import sys; from crankstar.files.catalog import load\n"
        "from crankstar.page.exhibits import exhibit\n"
        "exhibit(load('i4'), relatives=False); print('scipy' in sys.modules)"
    )
    ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert ran.stdout == "False\n"
