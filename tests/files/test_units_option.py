"""Units on the command line: chosen for what is printed, and understood in what is given."""

from __future__ import annotations

import csv
from io import StringIO
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.commands import Run

from crankstar.files import engine_of, tree_of
from crankstar.mechanics.balance import balance, total
from crankstar.options.remedies import limits, unbalance

FILE = """
format = 1
name = "twin"
firing_order = [1, 2]
speed = "6000 rpm"
[cylinder]
stroke = "{stroke}"
rod_length = "{rod}"
reciprocating_mass = "{piston}"
rod = {{ mass = "{mass}", centre = "{centre}", inertia = "{inertia}" }}
[layout]
type = "inline"
bore_pitch = "{pitch}"
"""
LENGTHS = {"m": 1, "mm": 1e3, "cm": 1e2, "in": 1 / 0.0254, "ft": 1 / 0.3048}
MASSES = {"kg": 1, "g": 1e3, "t": 1e-3, "lb": 1 / 0.45359237, "oz": 16 / 0.45359237}


@pytest.mark.release
def test_every_command_takes_units_and_a_variable_stands_for_them(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    for words in (
        ("analyze", "audi-25-tfsi", "--units", "kN m"),
        ("--units=kN m", "analyze", "audi-25-tfsi"),
    ):
        assert "[kN m]" in run(*words).out
    assert "lbf ft" in run("verdict", "audi-25-tfsi", "--units", "us").out
    assert "[oz in]" in run("balance", "audi-25-tfsi", "--recommended", "--units", "us").out
    monkeypatch.setenv("CRANKSTAR_UNITS", "lb ft")
    assert "lbf ft" in run("verdict", "audi-25-tfsi").out
    assert "kN m" in run("verdict", "audi-25-tfsi", "--units", "kN m").out
    monkeypatch.setenv("CRANKSTAR_UNITS", "zork")
    refused = run("list")
    assert refused.code == 2
    assert refused.err.startswith('crankstar: CRANKSTAR_UNITS: "zork" is not known as a unit')


def test_units_of_the_wrong_kind_are_refused_and_nothing_is_written(
    run: Run, tmp_path: Path
) -> None:
    for units, said in (
        ("m/s", "measures nothing that is shown"),
        ("N, kN", "both units of force"),
        ("", "no unit is named"),
    ):
        refused = run("analyze", "i4", "--units", units, "-o", "i4.csv")
        assert refused.code == 2
        assert said in refused.err
        assert not (tmp_path / "i4.csv").exists()


@pytest.mark.release
def test_units_change_csv_and_leave_json_in_si(run: Run) -> None:
    plain = run("analyze", "audi-25-tfsi", "--json").out
    assert run("analyze", "audi-25-tfsi", "--json", "--units", "us").out == plain
    si, us = (
        list(csv.DictReader(StringIO(run("analyze", "audi-25-tfsi", "--csv", *more).out)))
        for more in ((), ("--units", "lb ft"))
    )
    assert {row["unit"] for row in us} == {"N", "lbf*ft"}
    for row, other in zip(si, us, strict=True):
        factor = 1.3558179483314004 if other["unit"] == "lbf*ft" else 1.0
        assert row["unit"] == ("N" if factor == 1.0 else "N*m")
        assert float(row["amplitude"]) == pytest.approx(float(other["amplitude"]) * factor)


@pytest.mark.release
@given(st.sampled_from(sorted(LENGTHS)), st.sampled_from(sorted(MASSES)))
def test_an_engine_is_the_same_in_whatever_units_it_is_given(length: str, mass: str) -> None:
    def engine(length: str, mass: str):
        far, heavy = LENGTHS[length], MASSES[mass]
        values = {"stroke": 0.08, "rod": 0.14, "centre": 0.04, "pitch": 0.1}
        words = {name: f"{size * far:.17g} {length}" for name, size in values.items()}
        words |= {n: f"{m * heavy:.17g} {mass}" for n, m in (("piston", 0.3), ("mass", 0.5))}
        words["inertia"] = f"{0.002 * heavy * far**2:.17g} {mass} {length}^2"
        return engine_of(tree_of(FILE.format(**words)))

    plain, other = (
        total(balance(each, speed=600.0)) for each in (engine("m", "kg"), engine(length, mass))
    )
    for name in ("force", "couple", "torque"):
        wave, same = (getattr(sums, name).forward for sums in (plain, other))
        assert same == pytest.approx(wave, rel=1e-12, abs=1e-9)


def test_limits_and_unbalances_are_read_in_all_units() -> None:
    from crankstar.files.catalog import load

    engine = load("audi-25-tfsi")
    pounds, newtons = (
        limits([text], engine, speed=600.0)[0].at_most
        for text in ("couple=100 lb ft", "couple=135.58179483314004 N m")
    )
    assert pounds == pytest.approx(newtons, rel=1e-14)
    ounces, grams = (
        unbalance("--unbalance", text, engine) for text in ("10 oz in", "7200.77887375 g mm")
    )
    assert ounces == pytest.approx(grams, rel=1e-14)


@pytest.mark.parametrize("option", ["--units", "--language", "--lang"])
def test_an_option_of_every_command_that_stands_twice_is_refused(run: Run, option: str) -> None:
    said = run("list", option, "us", f"{option}=si")
    assert (said.code, said.out) == (2, "")
    assert f"{option} stands twice; give it once" in said.err
