"""`crankstar plot`, `sweep` and `verdict`.

Files of every kind, tables, sentences, and what is refused.
"""

from __future__ import annotations

import csv
import io
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.charted import rows_drawn
from tests.lacking import FIVE, RUBBER

from crankstar.charts import CHARTS
from crankstar.charts.sweeps import swept as chart
from crankstar.files import tree_text
from crankstar.studies.best_value import best
from crankstar.studies.sweep import sweep as swept
from crankstar.studies.sweep import watched

Run = Callable[..., Any]
BEGINS = {
    "svg": b"<svg",
    "png": b"\x89PNG",
    "pdf": b"%PDF",
    "html": b"<!DOCTYPE html>",
    "json": b"{",
}


@pytest.mark.many(first=3)
@pytest.mark.parametrize("kind", BEGINS)
def test_a_chart_is_written_as_its_suffix_says(run: Run, tmp_path: Path, kind: str) -> None:
    place = tmp_path / f"star.{kind}"
    run("plot", "i4", "crank-star", "--theta", "30 deg", "-o", str(place))
    assert place.read_bytes().startswith(BEGINS[kind])
    if kind == "json":
        (parameter,) = json.loads(place.read_text(encoding="utf-8"))["params"]
        assert parameter["value"] == 30


TWISTING = ("torsion-modes", "campbell", "torsion-response", "torsion-star")
MOUNTED = ("mount-layout", "mount-modes", "mount-response", "transmissibility")
"""Charts of what not every engine file has."""


@pytest.mark.many(first=5)
@pytest.mark.parametrize("chart", CHARTS)
def test_every_chart_is_drawn_into_a_pipe(run: Run, tmp_path: Path, chart: str) -> None:
    engine = "cadillac-ld8" if chart in TWISTING else "gm-3800"
    if chart in MOUNTED:
        file = tmp_path / "mounted.toml"
        block = '\n[block]\nmass = "150 kg"\n'
        file.write_text(f"{tree_text(FIVE)}{block}{RUBBER}", encoding="utf-8")
        engine = str(file)
    assert run("plot", engine, chart, "-o", "-").out.startswith("<svg")


@pytest.mark.many(first=1)
@pytest.mark.parametrize("chart", [*TWISTING, *MOUNTED])
def test_a_chart_of_what_the_file_lacks_is_refused(run: Run, tmp_path: Path, chart: str) -> None:
    place = tmp_path / "nothing.svg"
    refused = run("plot", "gm-3800", chart, "-o", str(place))
    assert (refused.code, refused.out, place.exists()) == (2, "", False)


@pytest.mark.release
def test_several_engines_are_drawn_side_by_side(run: Run) -> None:
    out = run(
        "plot",
        "i4",
        "hodograph",
        "--beside",
        "v8-flat-plane",
        "--beside",
        "v8-cross-plane",
        "--quantity",
        "force",
        "-o",
        "-",
    ).out
    assert out.count("V8, flat-plane crank") >= 1
    assert out.count("V8, cross-plane crank") >= 1


@pytest.mark.many(first=10)
@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["i4", "staar", "-o", "x.svg"], "chart staar: choose from crank-star"),
        (["i4", "spectrum", "-o", "x.bmp"], "must end in .svg"),
        (["i4", "spectrum", "-o", "x"], "must end in .svg"),
        (["i4", "spectrum", "-o", "/nowhere/x.svg"], "cannot be written"),
        (
            ["i4", "spectrum", "--theta", "3 deg", "-o", "x.svg"],
            "--theta has no effect with the chart spectrum",
        ),
        (
            ["i4", "crank-star", "--orders", "2", "-o", "x.svg"],
            "--orders has no effect with the chart crank-star",
        ),
        (["i4", "vector-star", "--orders", "1,2", "-o", "x.svg"], "takes one order"),
        (["i4", "vector-star", "--orders", "0", "-o", "x.svg"], "numbers above 0"),
        (["i4", "vector-star", "--quantity", "roll", "-o", "x.svg"], "choose from force, couple"),
        (["i4", "forces", "--theta", "3 furlongs", "-o", "x.svg"], "--theta"),
        (["i4", "hodograph", "--theta", "1 deg, 2 deg", "-o", "x.svg"], "takes one crank angle"),
        (["i4", "crank-star", "--beside", "i6", "-o", "x.svg"], "shows one engine"),
        (["i4", "hodograph", "--beside", "i7", "-o", "x.svg"], "there is no such engine"),
        (["nothing", "hodograph", "-o", "x.svg"], "there is no such engine"),
        (["i4", "mount-response", "-o", "x.svg"], "give [[mounts]]"),
        (["i4", "campbell", "-o", "x.svg"], "give the table [torsion]"),
        (["i4", "torque", "--set", "speed=6000 rpm", "-o", "x.svg"], "give cylinder.bore"),
    ],
)
def test_what_cannot_be_drawn_is_refused(
    refused: Callable[..., str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    arguments: list[str],
    told: str,
) -> None:
    monkeypatch.chdir(tmp_path)
    assert told in refused("plot", *arguments)
    assert list(tmp_path.iterdir()) == []


def test_chart_and_engine_may_be_given_the_other_way_round(run: Run) -> None:
    usual, other = (
        run("plot", *words, "-o", "-").out for words in (("i4", "crank-star"), ("crank-star", "i4"))
    )
    assert usual == other
    assert "<svg" in other


@pytest.mark.release
def test_a_sweep_finds_the_balance_factor_of_a_single(run: Run) -> None:
    out = run(
        "sweep", "single", "--over", "balance_factor=0..1", "--quantity", "force", "--orders", "1"
    ).out
    assert "Least force of order 1: 0.5 m r ω² at balance_factor = 0.5." in out
    assert re.search(r"^\s+0\.5 +0\.5$", out, re.MULTILINE)
    few = run(
        "sweep", "single", "--over", "balance_factor=0..1/5", "--quantity", "force", "--orders", "1"
    ).out
    assert "force of order 1: █▇▅▇█" in few  # eighths of the greatest: 1, 3/4, 1/2, 3/4, 1


@pytest.mark.release
def test_a_sweep_finds_where_a_right_angled_twin_is_free(run: Run) -> None:
    out = run(
        "sweep",
        "v2-90",
        "--over",
        "balance_factor=0..1",
        "--quantity",
        "force.forward,force.backward",
        "--orders",
        "1",
    ).out
    assert "Least force.forward of order 1: 0 m r ω² at balance_factor = 0.5." in out
    assert "force.backward of order 1" in out


@pytest.mark.release
def test_a_sweep_as_csv_and_as_a_chart(run: Run, tmp_path: Path) -> None:
    over = "layout.banks[1].bearing=0..90 deg/7"
    run("sweep", "harley-45", "--over", over, "--quantity", "force", "-o", str(tmp_path / "s.csv"))
    rows = list(csv.reader(io.StringIO((tmp_path / "s.csv").read_text(encoding="utf-8"))))
    names = "engine,layout.banks[1].bearing [deg],order,quantity,direction,amplitude,unit"
    assert rows[0] == names.split(",")
    assert [float(row[1]) for row in rows[1:]] == [0, 15, 30, 45, 60, 75, 90]
    assert {tuple(row[2:5]) for row in rows[1:]} == {("", "force", "greatest")}
    assert {row[6] for row in rows[1:]} == {"m*r*w^2"}
    assert run("sweep", "harley-45", "--over", over, "--csv").out == (tmp_path / "s.csv").read_text(
        encoding="utf-8"
    )
    run(
        "sweep",
        "harley-45",
        "--over",
        over,
        "--quantity",
        "force,roll",
        "-o",
        str(tmp_path / "s.json"),
    )
    written = json.loads((tmp_path / "s.json").read_text(encoding="utf-8"))
    values = [[row["layout.banks[1].bearing"], row["force"]] for row in written["values"]]
    made = swept("harley-45", over)
    curves = [watched(made, what) for what in ("force", "roll")]
    drawn = chart(made, curves, best=[best(made, curve) for curve in curves]).to_dict()
    points = drawn["vconcat"][0]["layer"][0]["data"]["values"]
    expected = [[float(row[1]), pytest.approx(float(row[5]))] for row in rows[1:]]
    assert values == expected
    assert [[p["x"], p["y"]] for p in points] == expected
    assert len(rows_drawn(drawn)) == 2  # forces and rolls have different units


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["--over", "cylinder.bor=1..2 mm"], "is not a field of the engine"),
        (["--over", "name=1..2"], "name is not the path of a single number"),
        (["--over", "balance_factor"], "give a field of the engine file and its values"),
        (["--over", "balance_factor=0..3"], "balance_factor"),
        (["--over", "balance_factor=0..1 mm"], "is a plain number"),
        (["--over", "layout.bank_offset=0..1/9999999"], "from 2 to 20000"),
        (["--over", "balance_factor=0..1", "--quantity", "noise"], "cannot be computed in a sweep"),
        (["--over", "balance_factor=0..1", "--quantity", ","], "at least one quantity"),
        (["--over", "balance_factor=0..1", "--orders", "0"], "numbers above 0"),
        (["--over", "balance_factor=0..1", "--orders", "all"], "omit --orders"),
        (["--over", "balance_factor=0..1", "--speed", "3"], "--speed"),
        (["--over", "balance_factor=0..1", "-o", "/nowhere/x.svg"], "cannot be written"),
    ],
)
def test_what_cannot_be_swept_is_refused(
    refused: Callable[..., str], arguments: list[str], told: str
) -> None:
    assert told in refused("sweep", "v8-cross-plane", *arguments)


@pytest.mark.release
def test_the_verdict_on_a_cross_plane_eight(run: Run) -> None:
    out = " ".join(run("verdict", "v8-cross-plane").out.split())
    assert "Force of order 4: 0.023182 m r ω², vertical." in out
    assert "Primary couple: 3.1623 m r ω² a, rotating with the crankshaft." in out
    assert "5 main bearings" in out
    own = "v8-flat-plane, pistons only, each in its own m, r and a"
    assert f"{own}: primary couple 3.162 against 0 m r ω² a" in out


def test_what_an_engine_is_called_stays_text_in_a_page(run: Run, tmp_path: Path) -> None:
    name = "A</script><script>alert(1)</script><img src=x onerror=alert(2)> & <b>"
    file = tmp_path / "x.toml"
    file.write_text(
        f'format = 1\nname = "{name}"\n[layout]\ntype = "inline"\nthrows = ["0 deg", "180 deg"]\n',
        encoding="utf-8",
    )
    for words in (
        ["plot", str(file), "crank-star"],
        ["plot", str(file), "polygon"],
        ["sweep", str(file), "--over", "balance_factor=0..1"],
    ):
        run(*words, "-o", str(tmp_path / "x.html"))
        page = (tmp_path / "x.html").read_text(encoding="utf-8")
        assert "<script>alert" not in page
        assert "<img src=x" not in page
        assert "\\u003cimg src=x" in page
    run("plot", str(file), "crank-star", "-o", str(tmp_path / "x.svg"))
    assert "<img" not in (tmp_path / "x.svg").read_text(encoding="utf-8")


@pytest.mark.release
def test_a_roll_of_a_high_order_is_not_denied(run: Run) -> None:
    eight = " ".join(run("verdict", "sinitsyn-8-two-stroke").out.split())
    assert "Rolling moment" in eight
    assert "largest at order 8" in eight
    kr = " ".join(run("verdict", "kr250-racer").out.split())
    assert "Moment of the forces about the crank axis: largest at order 1, 1.6544 m r² ω²" in kr
