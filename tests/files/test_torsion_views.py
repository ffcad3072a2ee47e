"""Torsion in every verb that has it: what they print, draw and write is what `torsion` says."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run
from tests.methods.test_torsion_charts import tree
from tests.twisting import pushes, row

import crankstar
from crankstar.dynamics.torsion_analysis import torsion
from crankstar.dynamics.torsion_criticals import stresses
from crankstar.dynamics.torsion_peaks import maximum_stress, torsion_peak
from crankstar.dynamics.torsion_response import response
from crankstar.files import changed, engine_of
from crankstar.studies.variants import SweepError

RPM = 30 / np.pi
FAN = """
name = "fan drive"
speed = "3000 rpm"
[[disc]]
name = "motor"
inertia = "2 kg*m^2"
[[disc]]
name = "fan"
inertia = "3 kg*m^2"
to = "motor"
stiffness = "6 kN*m/rad"
"""


def own(changes: dict[str, Any] | None = None) -> crankstar.Engine:
    return engine_of(changed(tree(), changes or {}, name="six"), name="six")


@pytest.fixture
def six(tmp_path: Path) -> str:
    place = tmp_path / "six.toml"
    place.write_text(crankstar.files.toml(own()), encoding="utf-8")
    return str(place)


def answer(run: Run, *words: str) -> Any:
    ran = run(*words, "--json")
    assert ran.code == 0, ran.err
    return json.loads(ran.out)


def printed(run: Run, *words: str) -> str:
    ran = run(*words)
    assert ran.code == 0, ran.err
    return ran.out


@pytest.mark.release
@pytest.mark.parametrize("kind", ["torsion-modes", "campbell"])
def test_plot_draws_drive_lines(run: Run, tmp_path: Path, kind: str) -> None:
    place = tmp_path / "fan.toml"
    place.write_text(FAN, encoding="utf-8")
    ran = run("plot", str(place), kind, "-o", str(tmp_path / "x.svg"))
    assert ran.code == 0, ran.err
    assert "fan drive" in (tmp_path / "x.svg").read_text(encoding="utf-8")


def test_other_charts_do_not_draw_drive_lines(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "fan.toml"
    place.write_text(FAN, encoding="utf-8")
    ran = run("plot", str(place), "torsion-response", "-o", str(tmp_path / "x.svg"))
    assert ran.code == 2
    assert not (tmp_path / "x.svg").exists()


@pytest.mark.release
def test_the_verdict_names_mode_and_critical_speed_of_torsion(run: Run, six: str) -> None:
    told = answer(run, "torsion", six)
    first = told["modes"][0]["frequency_hz"]
    top = max(told["criticals"], key=lambda each: each["equilibrium_deg"])
    said = " ".join(printed(run, "verdict", six).split())
    assert f"torsion First torsional mode: {first:.4g} Hz." in said
    place = f"order {top['order']:g} with mode {top['mode']}, at {top['speed_rpm']:.0f} rpm."
    assert place in said


def test_the_verdict_without_the_table_says_nothing_of_torsion() -> None:
    assert not [
        fact for fact in crankstar.verdict(crankstar.load("i6")).facts if fact.about == "torsion"
    ]


@pytest.mark.release
def test_compare_has_first_frequencies_and_critical_speeds(run: Run, six: str) -> None:
    rows = answer(run, "compare", six, six)["amplitudes"]
    told = answer(run, "torsion", six)
    own_rows = [row for row in rows if row["quantity"].startswith("torsion")]
    first = [row["greatest"] for row in own_rows if row["quantity"] == "torsion_frequency"]
    assert first == pytest.approx([told["modes"][0]["frequency_hz"]] * 2)
    top = max(told["criticals"], key=lambda each: each["equilibrium_deg"])
    speeds = [row["greatest"] for row in own_rows if row["quantity"] == "torsion_critical"]
    assert speeds == pytest.approx([top["speed_rpm"]] * 2)
    text = printed(run, "compare", six, six)
    assert f"{told['modes'][1]['frequency_hz']:.4g}" in text


@pytest.mark.release
def test_compare_leaves_out_engines_without_the_table(run: Run, six: str) -> None:
    text = printed(run, "compare", six, "i6")
    table = text.partition("\nTorsion\n")[2].partition("\n\n")[0]
    assert "in-line six" in table
    assert "Six in line" not in table
    assert "Torsion" not in printed(run, "compare", "i4", "i6")
    rows = answer(run, "compare", six, "i6")["amplitudes"]
    told = [row for row in rows if row["quantity"].startswith("torsion")]
    assert {row["engine"] for row in told} == {"in-line six"}
    assert f"{told[0]['greatest']:.4g}" in table


@pytest.mark.release
def test_a_sweep_of_the_flywheel_gives_the_first_frequency_of_each() -> None:
    made = crankstar.sweep(own(), "torsion.disc[2].inertia=0.05..0.45 kg*m^2/3")
    curve = crankstar.watched(made, "torsion_frequency")
    for value, found in zip([0.05, 0.25, 0.45], curve.values, strict=True):
        single = own({"torsion.disc[2].inertia": f"{value} kg*m^2"})
        assert found == pytest.approx(torsion(single).modes[0].frequency)
    assert curve.unit == "Hz"
    assert np.all(np.diff(curve.values) < 0)


@pytest.mark.release
def test_a_sweep_gives_the_maximum_stress_and_the_free_end() -> None:
    made = crankstar.sweep(own(), "torsion.disc[2].inertia=0.1..0.3 kg*m^2/2")
    stress = crankstar.watched(made, "torsion_stress")
    free = crankstar.watched(made, "torsion_amplitude")
    single = own({"torsion.disc[2].inertia": "0.3 kg*m^2"})
    found = torsion(single)
    assert found.response is not None
    assert stress.values[1] == pytest.approx(float(stresses(found.response)[0].max()) / 1e6)
    assert free.values[1] == pytest.approx(np.degrees(found.response.peak_turn(0)).max())
    assert (stress.unit, free.unit) == ("MPa", "deg")


def test_a_sweep_of_the_speed_takes_each_speed_alone() -> None:
    made = crankstar.sweep(own(), "speed=3000..6000 rpm/4")
    curve = crankstar.watched(made, "torsion_amplitude", order=4.5)
    speeds = np.array([3000.0, 4000, 5000, 6000]) / RPM
    found = torsion(own(), speeds=speeds).response
    assert found is not None
    asked = np.searchsorted(found.speeds, speeds)
    wanted = np.degrees(np.abs(found.turns[asked, found.orders.tolist().index(4.5), 0]))
    assert curve.values == pytest.approx(wanted)


@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    ("engine", "what", "order", "words"),
    [
        ("i4", "torsion_frequency", None, r"give the table \[torsion\]"),
        (own(), "torsion_frequency", 2.0, "has no orders"),
        (own(), "torsion_stress", 0.25, "orders go from 0.5 to 24"),
    ],
)
def test_a_sweep_of_torsion_says_what_is_missing(
    engine: Any, what: str, order: float | None, words: str
) -> None:
    made = crankstar.sweep(engine, "balance_factor=0..1/2")
    with pytest.raises(SweepError, match=words):
        crankstar.watched(made, what, order=order)


@pytest.mark.parametrize("seed", range(8))
def test_the_maximum_stress_is_found_without_the_peaks_of_all_speeds(seed: int) -> None:
    inertias, stiffnesses = [1.0, 0.4, 0.7, 2.0, 0.3], [2e4, 5e4, 1e4, 7e4]
    chain = row(inertias, stiffnesses, loss_factor=0.05)
    orders = np.arange(1, 25) / 2
    speeds = np.linspace(5.0, 300.0, 60)
    found = response(chain, pushes(chain, seed, orders), speeds=speeds)
    modulus = np.array([1e-6, np.nan, 3e-6, 2e-6])
    wanted = float(np.nanmax(found.peak / modulus))
    assert maximum_stress(found, modulus) == pytest.approx(wanted, rel=1e-12)


@pytest.mark.release
@pytest.mark.parametrize("what", ["torsion_stress", "peak_pressure"])
def test_a_sweep_of_an_estimated_engine_has_ranges(run: Run, tmp_path: Path, what: str) -> None:
    """What is computed engine by engine has its ends from the engines at the corners."""
    guessed = tree()
    for key in ("rod_length", "reciprocating_mass", "rotating_mass"):
        del guessed["cylinder"][key]
    guessed["torsion"]["inertia"] = "0.0075 kg*m^2"
    del guessed["torsion"]["bare_inertia"]
    place = tmp_path / "guessed.json"
    place.write_text(json.dumps(guessed), encoding="utf-8")
    over = ("--over", "torsion.disc[2].inertia=0.1..0.2 kg*m^2/2", "--quantity", what)
    said = printed(run, "sweep", str(place), "--estimate", *over)
    assert "estimated" in said
    if what == "torsion_stress":
        assert " to " in said.partition("Least")[2]


@pytest.mark.release
def test_the_report_has_a_chapter_on_torsion(run: Run, six: str, tmp_path: Path) -> None:
    place = tmp_path / "six.html"
    ran = run("report", six, "-o", str(place))
    assert ran.code == 0, ran.err
    page = place.read_text(encoding="utf-8")
    chapter = page.partition('<section id="torsion"')[2].partition("</section>")[0]
    told = answer(run, "torsion", six)
    assert f"{told['modes'][0]['frequency_hz']:.6g}" in chapter
    assert chapter.count("<svg") == 4
    assert "order 4.5" in chapter
    order = [page.index(f'<section id="{name}"') for name in ("gas", "torsion", "bearings")]
    assert order == sorted(order)


@pytest.mark.parametrize("name", ["mwm-6-diesel", "rover-v8-39"])
def test_the_peak_of_stress_is_that_of_the_whole_response(name: str) -> None:
    """The quick road, which leaves out what cannot be the greatest, beside every refined peak."""
    changes = {"torsion.diameter": "80 mm"} if name == "mwm-6-diesel" else {}
    engine = crankstar.load(name, changes=changes)
    found = torsion(engine)
    assert found.response is not None
    modulus = np.array([each.modulus or np.nan for each in found.chain.sections])
    wanted = float(np.nanmax(found.response.peak / modulus))
    assert torsion_peak(engine) == pytest.approx(wanted, rel=1e-9)
