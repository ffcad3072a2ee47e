"""A remedy for roll is judged by what remains with gas at the operating point."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from crankstar.analyses.verdict.facts import verdict
from crankstar.analysis.document import Document, Table
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.files import read_file
from crankstar.mechanics.gas import cycle
from crankstar.options.balancing import BalanceOptions, balanced
from crankstar.remedy.fitting import recommended
from crankstar.report.front import _rolling
from crankstar.report.subject import Subject
from crankstar.tables.gas_rolls import gas_roll_of
from crankstar.tables.remedies import balancing_sheet
from crankstar.tables.roll_cures import roll_left

CASES = Path(__file__).parents[1] / "cases"
SPEED = 1500 * np.pi / 30


def genset(changes: dict[str, str] | None = None) -> Engine:
    """The generating set of the case, with other values."""
    return read_file(CASES / "genset-four.toml", changes=changes or {})


def travel(engine: Engine, angle: np.ndarray) -> np.ndarray:
    """The way of a centred piston from top dead centre, m."""
    radius, rod = engine.throw(engine.first).radius, engine.first.rod_length
    return radius * (1 - np.cos(angle)) + rod - np.sqrt(rod**2 - (radius * np.sin(angle)) ** 2)


def amplitudes(engine: Engine) -> tuple[complex, complex]:
    """Order 2 of the roll of inertia and of gas of an in-line four, from energy and work alone.

    Torque of inertia -dE/dtheta, E = 1/2 m (w dx/dtheta)^2, and of gas (p - p0) A dx/dtheta;
    the block feels both reversed, four cylinders of a four-stroke order 2 in phase.
    """
    found = cycle(engine, speed=SPEED)
    count = found.pressure.shape[-1]
    angle = 4 * np.pi * np.arange(count) / count  # from the dead centre at which it fires
    step = 4 * np.pi / count

    def slope(values: np.ndarray) -> np.ndarray:
        waves = np.fft.rfft(values) * 1j * np.fft.rfftfreq(count, step / (2 * np.pi))
        return np.fft.irfft(waves, n=count)

    rate = slope(travel(engine, angle))
    energy = 0.5 * engine.first.reciprocating * (SPEED * rate) ** 2
    area = np.pi / 4 * (engine.first.bore or 0) ** 2
    gas = (found.pressure[0] - found.crankcase) * area * rate

    def second(torque: np.ndarray) -> complex:
        return -4 * 2 / count * complex(np.fft.rfft(torque)[4])

    return second(-slope(energy)), second(gas)


def remaining(sheet: Document) -> Table:
    """The table of what remains."""
    (table,) = (part for part in sheet.parts if isinstance(part, Table) and part.key == "remaining")
    return table


def rolls(sheet: Document) -> dict[str, tuple[float, float]]:
    """The rolling moments of order 2 before and now, by the words before and after `with`."""
    rows = [row for row in remaining(sheet).rows if "rolling moment" in str(row[1])]
    return {str(row[1]): (float(str(row[3])), float(str(row[4]))) for row in rows if row[0] == 2.0}


def test_shafts_that_level_the_inertia_treble_the_roll_at_load() -> None:
    engine = genset()
    inertia, gas = amplitudes(engine)
    assert (abs(inertia), abs(gas)) == pytest.approx((424.36, 631.85), rel=1e-4)
    job = balanced(engine, BalanceOptions(shafts="2, -2", level=True))
    sheet = balancing_sheet(job)
    found = rolls(sheet)
    assert found["rolling moment without gas"] == pytest.approx((abs(inertia), 0.0), rel=1e-6)
    expected = (abs(inertia + gas), abs(gas))
    assert expected == pytest.approx((207.69, 631.85), rel=1e-4)
    assert found["rolling moment with gas"] == pytest.approx(expected, rel=1e-5)
    note, _gas = remaining(sheet).notes
    assert "207.69 N m to 631.85 N m" in note


def test_a_roll_that_shrinks_with_gas_has_no_warning() -> None:
    engine = genset({"speed": "3000 rpm"})
    job = balanced(engine, BalanceOptions(shafts="2, -2", level=True))
    sheet = balancing_sheet(job)
    before, now = rolls(sheet)["rolling moment with gas"]
    assert now < before
    assert not [note for note in remaining(sheet).notes if "grows" in note]


def test_without_gas_the_table_and_the_sentence_leave_it_out_openly() -> None:
    engine = with_values(genset(), gas=None)
    sheet = balancing_sheet(balanced(engine, BalanceOptions(shafts="2, -2", level=True)))
    assert set(rolls(sheet)) == {"rolling moment without gas"}
    (note,) = remaining(sheet).notes
    assert "gas" in note
    assert "without gas" in roll_left(engine, speed=None)
    (told,) = (fact.sentence for fact in verdict(engine, relatives=False) if fact.about == "roll")
    assert "without gas" in told


def test_shafts_against_the_inertia_of_a_ship_engine_are_no_remedy() -> None:
    engine = read_file(CASES / "marine-seven.toml")
    found = gas_roll_of(engine, speed=None)
    assert found is not None
    assert found.largest == 7.0
    assert abs(found.at(7.0)) == pytest.approx(583.1e3, rel=1e-3)
    assert abs(found.at(7.0) - found.gas_at(7.0)) == pytest.approx(11.123e3, rel=1e-3)
    told = roll_left(engine, speed=None)
    assert told.endswith("no remedy at this load.")
    assert "583.11 kN m, without gas 11.123 kN m" in told


def test_the_summary_of_an_engine_with_gas_has_both_rolls() -> None:
    told = [fact.sentence for fact in verdict(genset(), relatives=False) if fact.about == "roll"]
    assert "1500 rpm: largest at order 4, 293.13 N m" in told[0]
    assert "order 2, 424.36 N m" in told[1]


SINGLE = CASES / "single-on-wheels.toml"
BEFORE, AFTER = "174.53 N m", "753.04 N m"
"""Order 1 of its roll with gas, without and with the shaft that cures its primary force."""


def test_a_shaft_off_the_axis_adds_its_force_times_its_arm() -> None:
    engine = read_file(SINGLE)
    fitted = recommended(engine)
    assert fitted is not None
    rolls = [gas_roll_of(each, speed=None) for each in (engine, fitted.after)]
    (before, after) = [each.at(1.0) for each in rolls if each is not None]
    (shaft,) = (each for each in fitted.after.shafts if not each.throws)
    (weight,) = shaft.weights
    speed = engine.speed or 0.0
    assert abs(after - before) == pytest.approx(weight.unbalance * speed**2 * abs(shaft.up))
    assert (abs(before), abs(after)) == pytest.approx((174.53, 753.04), abs=0.006)


def test_verdict_and_report_have_the_roll_before_and_after_the_remedy() -> None:
    engine = read_file(SINGLE)
    facts = verdict(engine, relatives=False)
    (grown,) = (fact.sentence for fact in facts if fact.about == "remedied")
    fitted = recommended(engine)
    assert fitted is not None
    sheet, _gas = remaining(
        balancing_sheet(balanced(engine, BalanceOptions(recommended=True)))
    ).notes
    assert BEFORE in sheet
    assert AFTER in sheet
    left = roll_left(fitted.after, speed=None, before=engine)
    for sentence in (grown, left):
        assert sheet in sentence
        assert sentence.index(BEFORE) < sentence.index(AFTER)


def test_a_verdict_whose_remedy_reduces_the_roll_has_no_warning() -> None:
    facts = verdict(genset({"speed": "3000 rpm"}), relatives=False)
    assert not [fact for fact in facts if fact.about == "remedied"]


def test_the_front_page_has_both_values_of_the_roll() -> None:
    subject = Subject(read_file(SINGLE), {}, "")
    (line,) = _rolling(subject)
    assert line.index(BEFORE) < line.index(AFTER)
