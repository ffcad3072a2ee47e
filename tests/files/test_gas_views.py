"""Gas in every verb that has it: what they print, draw and write is what `torque --json` says."""

from __future__ import annotations

import csv
import io
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run

import crankstar
from crankstar import charts
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import over_cycle
from crankstar.mechanics.side_thrust import side_thrust

CASES = Path(__file__).parents[1] / "cases"
FILE = """
name = "In-line four"
firing_order = [1, 3, 4, 2]
speed = "5000 rpm"
[cylinder]
bore = "82 mm"
stroke = "90 mm"
rod_length = "145 mm"
reciprocating_mass = "480 g"
[layout]
type = "inline"
bore_pitch = "91 mm"
[gas]
compression_ratio = 10.5
imep = "10 bar"
[[gas.point]]
name = "idle"
speed = "800 rpm"
imep = "2 bar"
intake_pressure = "0.4 bar"
[[gas.point]]
name = "full"
speed = "5500 rpm"
imep = "12 bar"
[drive]
inertia = "0.15 kg*m^2"
"""


@pytest.fixture
def four(tmp_path: Path) -> str:
    place = tmp_path / "four.toml"
    place.write_text(FILE, encoding="utf-8")
    return str(place)


def answer(run: Run, *words: str) -> Any:
    ran = run(*words, "--json")
    assert ran.code == 0, ran.err
    return json.loads(ran.out)


def printed(run: Run, *words: str) -> str:
    ran = run(*words)
    assert ran.code == 0, ran.err
    return ran.out


def refused(run: Run, *words: str) -> str:
    ran = run(*words)
    assert ran.code == 2
    assert ran.out == ""
    return ran.err


def amplitudes(told: Any, key: str = "orders", what: str = "total") -> dict[float, complex]:
    return {row["order"]: complex(*row[what]) for row in told[key]}


def rows_of(spec: Any) -> list[dict[str, Any]]:
    """All rows of data of a figure."""
    if isinstance(spec, list):
        return [row for each in spec for row in rows_of(each)]
    if not isinstance(spec, dict):
        return []
    own = spec.get("data", {}).get("values", [])
    return [*own, *(row for value in spec.values() for row in rows_of(value))]


def curve(chart: Any, name: str) -> tuple[np.ndarray, np.ndarray]:
    rows = [row for row in rows_of(chart.to_dict()) if row.get("what") == name]
    return np.array([row["x"] for row in rows]), np.array([row["y"] for row in rows])


@pytest.mark.release
def test_analyze_shows_torque_and_roll_with_gas_as_torque_does(run: Run, four: str) -> None:
    told = answer(run, "torque", four)
    own = answer(run, "analyze", four)
    for what in ("gas", "inertia", "total", "roll", "roll_on_same_mounts"):
        assert amplitudes(own, "gas_orders", what) == amplitudes(told, what=what)
    text = printed(run, "analyze", four)
    assert "Torque by order, gas at 10 bar" in text
    second = abs(amplitudes(told)[2.0])
    assert f"{second:.5g}" in text


def test_without_a_cycle_analyze_says_nothing_of_gas(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "bare.toml"
    place.write_text(FILE.partition("[gas]")[0], encoding="utf-8")
    assert "with gas" not in printed(run, "analyze", str(place))
    assert "gas_orders" not in answer(run, "analyze", str(place))


@pytest.mark.release
def test_the_roll_on_the_same_mounts_has_all_that_alternates(run: Run, four: str) -> None:
    idle, full = (answer(run, "torque", four, "--point", name) for name in ("idle", "full"))
    assert abs(amplitudes(full, what="roll")[4.0]) > 2 * abs(amplitudes(idle, what="roll")[4.0])
    for told in (idle, full):
        assert amplitudes(told, what="roll_on_same_mounts") == amplitudes(told, what="roll")


@pytest.mark.release
def test_genset_and_torque_print_one_roll_of_a_generating_set(run: Run) -> None:
    place = str(CASES / "genset-four.toml")
    told, found = (answer(run, verb, place) for verb in ("torque", "genset"))
    roll = {order: abs(each) for order, each in amplitudes(told, what="roll").items()}
    assert [roll[order] for order in (2.0, 4.0, 6.0)] == pytest.approx(
        [207.69, 293.13, 127.99], rel=1e-4
    )
    sums = {each["order"]: each["one"] for each in found["sums"] if each["quantity"] == "roll"}
    assert sums == pytest.approx({order: roll[order] for order in sums}, rel=1e-9)
    assert min(sums) == 2.0


@pytest.mark.release
@pytest.mark.parametrize("fault", [("--off", "3"), ("--weaker", "3=10%")])
def test_a_weak_cylinder_shakes_a_generating_set_in_half_orders(
    run: Run, fault: tuple[str, str]
) -> None:
    place = str(CASES / "genset-four.toml")
    told, found = (answer(run, verb, place, *fault) for verb in ("torque", "genset"))
    roll = amplitudes(told, what="roll")
    sums = {each["order"]: each["one"] for each in found["sums"] if each["quantity"] == "roll"}
    assert min(sums) == 0.5
    assert sums[0.5] == pytest.approx(abs(roll[0.5]), rel=1e-9)


@pytest.mark.release
def test_a_weak_cylinder_is_a_share_of_a_misfire(run: Run) -> None:
    place = str(CASES / "genset-four.toml")
    none, weak, off = (
        amplitudes(answer(run, "torque", place, *words), what="gas")
        for words in ((), ("--weaker", "3=25%"), ("--off", "3"))
    )
    for order in (0.5, 1.0, 2.0, 3.5):
        assert weak[order] == pytest.approx(0.75 * none[order] + 0.25 * off[order], abs=1e-9)


@pytest.mark.release
def test_a_dead_cylinder_draws_the_charge_of_the_measured_trace(run: Run) -> None:
    place = str(CASES / "v6-idle-trace.toml")
    told = answer(run, "torque", place, "--speed", "700 rpm", "--off", "3")
    gas = amplitudes(told, what="gas")
    found = [abs(gas[order]) for order in (0.5, 1.0, 1.5, 2.0, 2.5)]
    assert found == pytest.approx([19.96, 17.68, 14.50, 11.20, 8.63], rel=5e-4)
    assert abs(amplitudes(told, what="total")[3.0]) == pytest.approx(67.34, rel=1e-4)
    assert told["peak_pressure"] == pytest.approx(12.0e5, rel=1e-3)
    assert told["imep"] == pytest.approx(1.581e5, rel=1e-3)


@pytest.mark.release
def test_a_flywheel_for_an_irregularity_gives_it(run: Run, four: str) -> None:
    told = answer(run, "torque", four, "--point", "idle", "--irregularity", "1/40")
    wheel = told["flywheel"]
    assert wheel["irregularity"] == pytest.approx(0.025)
    again = answer(
        run, "torque", four, "--point", "idle", "--flywheel", f"{wheel['inertia']!r} kg*m^2"
    )
    assert again["irregularity"] == pytest.approx(0.025, rel=1e-6)


@pytest.mark.parametrize("text", ["0", "1/0", "x", "-1/50", "2", "1e-9", "nan", ""])
def test_an_irregularity_that_is_none_is_refused(run: Run, four: str, text: str) -> None:
    assert "give a share from" in refused(run, "torque", four, "--irregularity", text)


@pytest.mark.parametrize("text", ["", "5 mm", "-3 bar", "bar", ",".join(["1 bar"] * 13)])
def test_tangential_pressures_at_no_load_are_refused(run: Run, four: str, text: str) -> None:
    assert "--tangential" in refused(run, "torque", four, "--tangential", text)


@pytest.mark.release
def test_tangential_pressures_are_the_torque_of_one_cylinder(run: Run, four: str) -> None:
    """A four has order 2 four times: t_2 = 2 T_2/(4 V_d), from the printed torque."""
    told = answer(run, "torque", four, "--imep", "8 bar", "--tangential", "4 bar, 8 bar")
    row = next(row for row in told["tangential"] if row["order"] == 2.0)
    swept = np.pi / 4 * 0.082**2 * 0.09
    wanted = 2 * abs(amplitudes(told, what="gas")[2.0]) / (4 * swept)
    assert row["imep 8 bar"] == pytest.approx(wanted, rel=1e-9)
    assert row["imep 4 bar"] < row["imep 8 bar"]


@pytest.mark.release
def test_the_side_thrust_that_is_told_is_the_greatest_of_the_curve(run: Run, four: str) -> None:
    told = answer(run, "torque", four)
    engine = crankstar.load(four)
    thrust = side_thrust(engine, cycle(engine)).total
    assert [row["cylinder"] for row in told["side_thrust"]] == [1, 2, 3, 4]
    for row, values in zip(told["side_thrust"], thrust, strict=True):
        # the maximum lies between the samples of the curve
        assert row["thrust_side"] == pytest.approx(values.max(), rel=1e-3)
        assert row["other_side"] == pytest.approx(-values.min(), rel=1e-3)
        assert row["thrust_side"] >= values.max() * (1 - 1e-9)


@pytest.mark.release
def test_forces_that_the_uneven_speed_changes_are_told_at_idle_alone(run: Run, four: str) -> None:
    idle = answer(run, "torque", four, "--point", "idle")["uneven_forces"]
    assert {(row["quantity"], row["order"]) for row in idle} >= {("force", 4.0)}
    assert all(row["even"] != row["uneven"] for row in idle)
    heavy = answer(run, "torque", four, "--point", "full", "--flywheel", "10 kg*m^2")
    assert heavy["uneven_forces"] == []
    assert "changes no order of force" in printed(
        run, "torque", four, "--point", "full", "--flywheel", "10 kg*m^2"
    )


@pytest.mark.release
@pytest.mark.parametrize(
    ("quantity", "key"), [("mean_torque", "mean_torque"), ("peak_pressure", "peak_pressure")]
)
def test_a_sweep_of_the_load_is_torque_at_each_load(
    run: Run, four: str, quantity: str, key: str
) -> None:
    found = answer(run, "sweep", four, "--over", "gas.imep=4 bar..8 bar/3", "--quantity", quantity)
    for imep, row in zip((4, 6, 8), found["values"], strict=True):
        told = answer(run, "torque", four, "--imep", f"{imep} bar")
        assert row[quantity] == pytest.approx(told[key], rel=1e-9)


@pytest.mark.release
def test_a_sweep_of_the_flywheel_and_of_the_speed(run: Run, four: str) -> None:
    over = "drive.inertia=0.1 kg*m^2..0.3 kg*m^2/3"
    found = answer(run, "sweep", four, "--over", over, "--quantity", "irregularity")
    last = answer(run, "torque", four, "--flywheel", "0.3 kg*m^2")["irregularity"]
    assert found["values"][-1]["irregularity"] == pytest.approx(last, rel=1e-9)
    words = ("--over", "speed=1000 rpm..5000 rpm/3", "--quantity", "roll_with_gas", "--orders", "2")
    rolls = [
        row["roll_with_gas of order 2"] for row in answer(run, "sweep", four, *words)["values"]
    ]
    own = answer(run, "torque", four, "--speed", "3000 rpm")
    assert rolls[1] == pytest.approx(abs(amplitudes(own, what="roll")[2.0]), rel=1e-9)


def test_gas_in_a_sweep_needs_what_it_is_made_of(run: Run, four: str) -> None:
    words = ("sweep", four, "--over", "gas.imep=4 bar..8 bar/3", "--quantity")
    assert "has no orders" in refused(run, *words, "irregularity", "--orders", "2")
    assert "torque_with_gas" in refused(run, *words, "nonsense")
    bare = ("sweep", "i4", "--over", "balance_factor=0..1/3", "--quantity", "torque_with_gas")
    assert "give cylinder.bore" in refused(run, *bare)


@pytest.mark.release
def test_compare_has_the_torque_of_two_loads_side_by_side(
    run: Run, four: str, tmp_path: Path
) -> None:
    other = tmp_path / "other.toml"
    text = FILE.replace("In-line four", "Less").replace('imep = "10 bar"', 'imep = "5 bar"')
    other.write_text(text, encoding="utf-8")
    table = printed(run, "compare", four, str(other)).partition("Torque of gas and inertia")[2]
    line = next(line for line in table.splitlines() if re.match(r"2(\.0)?\s", line))
    own, less = (abs(amplitudes(answer(run, "torque", place))[2.0]) for place in (four, str(other)))
    rows = answer(run, "compare", four, str(other))["amplitudes"]
    second = [r for r in rows if r["quantity"] == "torque_with_gas" and r["order"] == 2.0]
    assert [row["greatest"] for row in second] == pytest.approx([own, less], rel=1e-12)
    assert second[1]["share"] == pytest.approx(less / own)
    numbers = [float(part) for part in line.split()]
    assert numbers[1:3] == pytest.approx([own, less], rel=1e-4)
    assert numbers[3] == pytest.approx(100 * less / own, rel=1e-3)


# Figures


def test_the_torque_that_is_drawn_is_gas_and_inertia_of_each_angle(four: str) -> None:
    engine = crankstar.load(four)
    found = charts.torque_chart(engine, speed=engine.speed)
    gas = over_cycle(cycle(engine), 720).sum(axis=0)
    x, y = curve(found, "gas")
    assert x[[0, 1, -1]].tolist() == [0.0, 1.0, 720.0]
    assert np.abs(y[:-1] - gas).max() < 1e-4 * np.abs(gas).max()
    together, inertia = (curve(found, name)[1] for name in ("together", "inertia"))
    assert np.abs(together - y - inertia).max() < 1e-4 * np.abs(gas).max()
    assert curve(found, "mean")[1] == pytest.approx(gas.mean(), rel=1e-5)


@pytest.mark.release
def test_bars_of_the_torque_stand_where_torque_has_orders(run: Run, four: str) -> None:
    told = answer(run, "torque", four)
    drawn = charts.torque_chart(crankstar.load(four), quantity="orders")
    rows = [row for row in rows_of(drawn.to_dict()) if row.get("what") == "gas"]
    assert [row["order"] for row in rows] == ["2", "4", "6", "8"]
    for row in rows:
        wanted = abs(amplitudes(told, what="gas")[float(row["order"])])
        assert row["to"] == pytest.approx(wanted, rel=1e-5)


def test_a_silent_cylinder_brings_the_half_orders_into_the_bars(four: str) -> None:
    drawn = charts.torque_chart(crankstar.load(four), quantity="orders", off=(2,))
    orders = {row["order"] for row in rows_of(drawn.to_dict()) if row.get("what") == "gas"}
    assert {"0.5", "1", "1.5"} <= orders


def test_the_area_of_the_indicator_diagram_is_the_work_of_the_cycle(four: str) -> None:
    """The drawn loop, by the trapezium rule: imep times the swept volume."""
    engine = crankstar.load(four)
    rows = [row for row in rows_of(charts.pressure_chart(engine).to_dict()) if "at" in row]
    volume = np.array([row["x"] for row in rows]) * 1e-6
    pressure = np.array([row["y"] for row in rows]) * 1e5
    work = np.sum((pressure[1:] + pressure[:-1]) / 2 * np.diff(volume))
    assert work == pytest.approx(10e5 * np.pi / 4 * 0.082**2 * 0.09, rel=2e-3)


def test_every_cylinder_has_its_row_in_firing_order(four: str) -> None:
    drawn = charts.torque_chart(crankstar.load(four), quantity="cylinders").to_dict()
    names = [row["what"] for row in rows_of(drawn) if row.get("x") == 0.0 and "what" in row]
    assert names == ["1", "3", "4", "2", "together"]


def test_loads_are_drawn_motored_and_at_each_point(four: str) -> None:
    drawn = charts.torque_chart(crankstar.load(four), quantity="loads", speed=100.0)
    names = {row["what"] for row in rows_of(drawn.to_dict()) if "what" in row}
    assert names == {"motored, 955 rpm", "idle, 800 rpm", "full, 5500 rpm"}


@pytest.mark.release
def test_amplitudes_over_the_speed_end_at_what_torque_says(run: Run, four: str) -> None:
    drawn = charts.amplitudes(crankstar.load(four), speeds=[100.0, 575.9586531581287]).to_dict()
    told = answer(run, "torque", four, "--point", "full")
    rows = [row for row in rows_of(drawn) if row.get("what") == "order 4"]
    last = [row["y"] for row in rows if row["x"] == pytest.approx(5500)]
    assert any(y == pytest.approx(abs(amplitudes(told, what="roll")[4.0]), rel=1e-5) for y in last)


def test_a_figure_says_what_its_engine_lacks() -> None:
    for draw in (charts.torque_chart, charts.pressure_chart, charts.side_thrust_chart):
        text = str(draw(crankstar.load("v8-cross-plane")).to_dict())
        assert "cylinder.bore" in text


@pytest.mark.release
def test_the_report_has_a_chapter_of_gas_where_the_file_has_a_cycle(
    run: Run, four: str, tmp_path: Path
) -> None:
    place = tmp_path / "four.html"
    run("report", four, "-o", str(place))
    page = place.read_text(encoding="utf-8")
    assert "Gas and torque" in page
    told = answer(run, "torque", four)
    assert f"{abs(amplitudes(told, what='gas')[2.0]):.5g}" in page
    run("report", "i4", "-o", str(tmp_path / "bare.html"))
    assert "Gas and torque" not in (tmp_path / "bare.html").read_text(encoding="utf-8")


@pytest.mark.release
def test_a_cylinder_that_is_off_silences_the_chamber_it_shares(run: Run) -> None:
    """Cylinders 1 and 7 of a Jumo 205 face each other in one chamber."""
    chamber = crankstar.load("jumo-205").chambers[1]
    other = max(cylinder.number for cylinder in chamber)
    assert other != 1
    told = [answer(run, "torque", "jumo-205", "--off", str(off)) for off in (1, other)]
    assert told[0]["orders"] == told[1]["orders"]
    assert told[0]["off"] == told[1]["off"] == [1]
    derived = [
        printed(run, "derive", "jumo-205", "--quantity", "gas", "--off", str(off))
        for off in (1, other)
    ]
    assert derived[0] == derived[1]


def layered(spec: Any) -> list[dict[str, Any]]:
    """All layered panels of a figure."""
    if isinstance(spec, list):
        return [panel for each in spec for panel in layered(each)]
    if not isinstance(spec, dict):
        return []
    return [spec] * ("layer" in spec) + [panel for each in spec.values() for panel in layered(each)]


def test_the_name_of_a_cylinder_stands_where_its_curve_is_low() -> None:
    engine = crankstar.load("man-s90mc-c")
    drawn = charts.torque_chart(engine, quantity="cylinders").to_dict()
    sides: dict[str, str] = {}
    for panel in layered(drawn):
        words = panel["layer"][-1]
        text = str(words["encoding"].get("text", {}).get("value", ""))
        if not text.startswith("cylinder "):
            continue
        heights = [row["y"] for row in rows_of(panel) if "what" in row]
        quarter = len(heights) // 4
        middle = slice((len(heights) - quarter) // 2, (len(heights) + quarter) // 2)
        under = {"right": slice(-quarter, None), "left": slice(quarter), "center": middle}
        sides[text] = words["mark"]["align"]
        assert max(heights[under[sides[text]]]) < 0.6 * max(heights), text
    assert len(sides) == 7
    assert sides["cylinder 1"] == "right"
    assert sides["cylinder 6"] != "right"  # the last to fire, high at the end of the cycle


def test_the_csv_of_torque_has_every_table_of_the_screen(run: Run) -> None:
    """The cycle, the running and the flywheel too, which JSON has as facts."""
    out = run("torque", str(CASES / "genset-four.toml"), "--irregularity", "0.02", "--csv").out
    rows = [*csv.DictReader(io.StringIO(out))]
    assert {row["table"] for row in rows} == {"orders", "work", "running", "wheel", "side_thrust"}
    values = {(row["table"], row["quantity"]): row["value"] for row in rows if row["quantity"]}
    assert float(values["work", "imep"]) == pytest.approx(9e5)
    assert float(values["work", "mean_torque"]) == pytest.approx(310.08, rel=1e-4)
    assert float(values["wheel", "irregularity"]) == 0.02
