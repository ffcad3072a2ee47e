"""`--estimate` on commands that balance, draw and report: ranges hold, nothing lacks its mark."""

from __future__ import annotations

import csv
import json
import random
import re
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run
from tests.files.test_estimate import tree_for

from crankstar import bearing_loads, bending_moment, spectra
from crankstar.analyses.bearings import RECORD
from crankstar.analyses.bearings.question import Question
from crankstar.analysis.document import Document, Ranged
from crankstar.charts.resting import FOOT
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.files.box import ranges, scaled, spread
from crankstar.language.messages import _
from crankstar.language.numbers import number
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.remains import summed
from crankstar.options.balancing import BalanceOptions, balanced
from crankstar.remedy.counterweights import without_counterweights
from crankstar.tables.laid import sentence
from crankstar.tables.ranges import ranged
from crankstar.tables.remedies import balancing_sheet


def variants(tree: dict[str, Any], *, count: int) -> list[Engine]:
    """Engines anywhere in the ranges of a tree."""
    own, chance = ranges(tree), random.Random(7)  # noqa: S311
    return [
        engine_of(scaled(tree, {path: chance.uniform(r.low, r.high) for path, r in own.items()}))
        for _turn in range(count)
    ]


def assert_within(shown: Document, other: Document) -> int:
    """Assert that the numbers of the tables lie in the ranges shown; how many have one."""
    count = 0
    for table, like in zip(shown.tables, other.tables, strict=True):
        for row, own in zip(table.rows, like.rows, strict=True):
            for column, cell, value in zip(table.columns, row, own, strict=True):
                if not isinstance(cell, Ranged) or column.unit == "deg":
                    continue
                assert isinstance(value, int | float | complex)
                slack = 1e-9 * (abs(cell.low) + abs(cell.high))
                size = abs(value) if isinstance(cell.value, complex) else value
                assert cell.low - slack <= size.real <= cell.high + slack, (column, cell, value)
                count += 1
    return count


@pytest.mark.release
@pytest.mark.parametrize("model", ["determinate", "continuous"])
def test_bearing_loads_of_any_masses_lie_in_the_ranges(model: Any) -> None:
    tree = tree_for("kr250-racer")
    ends = spread(tree)
    assert ends is not None

    def sheet(engine: Engine) -> Document:
        return RECORD.told(engine, Question(model=model)).for_machines

    shown = ranged(sheet, ends, ends.engine)
    for engine in variants(tree, count=5):
        assert assert_within(shown, sheet(engine)) > 20


@pytest.mark.release
@pytest.mark.parametrize(
    ("name", "options"),
    [("bmw-m52b28", {"factor": "0.6"}), ("gm-3800", {}), ("ford-coyote", {"weights": "ends"})],
)
def test_weights_sized_for_any_masses_lie_in_the_ranges(name: str, options: Any) -> None:
    tree = tree_for(name)
    ends = spread(tree)
    assert ends is not None

    def sheet(engine: Engine) -> Document:
        return balancing_sheet(balanced(engine, BalanceOptions(**options)))

    shown = ranged(sheet, ends, ends.engine)
    for engine in variants(tree, count=5):
        assert assert_within(shown, sheet(engine)) > 5


@pytest.mark.release
def test_angles_at_the_cut_are_not_a_range_of_a_whole_turn(run: Run) -> None:
    run("bearings", "bmw-m52b28", "--estimate", "-o", "loads.json")
    tree = json.loads(Path("loads.json").read_text())
    angles = [row["peak"]["bearing_deg"] for row in tree["bearings"]]
    assert [round(angle, 6) for angle in angles] == [0, 180, 180, 0, 180, 180, 0]
    assert not any("bearing_deg_low" in row["peak"] for row in tree["bearings"])
    assert all(row["peak"]["value_estimated"] for row in tree["bearings"])


@pytest.mark.release
@pytest.mark.parametrize("form", ["json", "csv", "xlsx", "parquet", "txt"])
def test_bearing_loads_are_written_with_their_marks(run: Run, form: str) -> None:
    run("bearings", "kr250-racer", "--estimate", "-o", f"out.{form}")
    place = Path(f"out.{form}")
    if form == "json":
        assert json.loads(place.read_text())["estimated"]
    elif form == "xlsx":
        import openpyxl

        cells = [c.value for sheet in openpyxl.load_workbook(place) for c in sheet[1]]
        assert any(str(cell).endswith("_estimated") for cell in cells)
    elif form == "parquet":
        import pyarrow.parquet

        heads = pyarrow.parquet.read_table(place).column_names
        assert any(head.endswith("_estimated") for head in heads)
    elif form == "csv":
        heads = next(csv.reader(place.read_text().splitlines()))
        assert any(head.startswith("greatest_low") for head in heads)
        assert any(head.endswith("_estimated") for head in heads)
    else:
        assert "(estimated)" in place.read_text()


@pytest.mark.release
@pytest.mark.parametrize(
    ("engine", "options", "path"),
    [
        ("bmw-m52b28", ["--factor", "0.6"], "crankshaft.weight.unbalance"),
        ("subaru-ej25", ["--set", "cylinder.bore=99.5 mm", "--shafts", "all"], "balance_shaft"),
    ],
)
def test_weights_that_balance_writes_say_they_are_estimated(
    run: Run, engine: str, options: list[str], path: str
) -> None:
    run("balance", engine, "--estimate", *options, "-o", "after.toml")
    sources = tomllib.loads(Path("after.toml").read_text())["provenance"]
    marked = {key for key, source in sources.items() if source["status"] == "estimated"}
    assert "cylinder.throw_mass" in marked
    assert any(key.startswith(path) for key in marked), marked
    again = run("analyze", "after.toml").out
    assert "weight.unbalance" in again.split("What rests")[0]


def test_weights_of_an_engine_without_estimates_carry_no_such_source(run: Run) -> None:
    run("balance", "v8-cross-plane", "-o", "after.toml")
    assert "estimated" not in Path("after.toml").read_text()


@pytest.mark.release
def test_the_explicit_form_of_a_balanced_engine_says_so_too(run: Run) -> None:
    run("estimate", "kr250-racer", "-o", "whole.toml")
    run("show", "whole.toml", "--explicit", "-o", "parts.toml")
    run("balance", "parts.toml", "--shafts", "1", "-o", "after.toml")
    sources = tomllib.loads(Path("after.toml").read_text())["provenance"]
    assert sources["shaft.weight.unbalance"]["status"] == "estimated"


@pytest.mark.release
def test_a_balance_of_estimated_masses_says_what_its_ranges_are(run: Run) -> None:
    text = " ".join(run("balance", "bmw-m52b28", "--estimate").out.split())
    assert "Each range is that of engines whose weights and shafts are sized for" in text
    assert "Each range is" not in run("balance", "bmw-m52b28").out


def drawn(run: Run, *words: str) -> dict[str, Any]:
    """A chart of `plot` as Vega-Lite."""
    run("plot", *words, "-o", "chart.json")
    return json.loads(Path("chart.json").read_text())


def panels(spec: Any) -> list[Any]:
    """The panels of a chart, in order, without what it rests on."""
    if isinstance(spec, list):
        return [panel for item in spec for panel in panels(item)]
    if spec.get("name") == FOOT:
        return []
    if "layer" in spec:
        return [spec]
    return panels(spec.get("vconcat") or spec.get("hconcat") or [])


def layers(panel: Any, mark: str) -> list[Any]:
    """The rows of the layers of a panel with that mark."""
    return [
        row
        for layer in panel["layer"]
        if layer.get("mark", {}).get("type") == mark
        for row in layer["data"]["values"]
    ]


@pytest.mark.release
def test_every_mass_keeps_force_within_the_band_over_the_crank_angle(run: Run) -> None:
    chart = drawn(run, "kr250-racer", "over-turn", "--quantity", "force", "--estimate")
    band = layers(panels(chart)[0], "area")
    angles = np.radians([row["x"] for row in band])
    low, high = (np.array([row[key] for row in band]) for key in ("y", "y2"))
    assert (high > low).any()
    unit = 1000.0 if "kN" in json.dumps(chart) else 1.0
    for engine in variants(tree_for("kr250-racer"), count=8):
        force = total(balance(engine, speed=engine.speed)).force
        curve = np.real(spectra.value(force, angles)) / unit
        slack = 1e-9 * np.abs(high).max()
        assert (low - slack <= curve).all()
        assert (curve <= high + slack).all()


@pytest.mark.release
def test_every_mass_keeps_the_orders_within_the_whiskers(run: Run) -> None:
    chart = drawn(run, "bmw-m52b28", "spectrum", "--estimate")
    whiskers = layers(panels(chart)[2], "rule")
    assert {row["order"] for row in whiskers} >= {"3", "6"}
    for engine in variants(tree_for("bmw-m52b28"), count=8):
        roll = summed(balance(engine, speed=engine.speed)).roll
        for row in whiskers:
            (size,) = np.abs(spectra.amplitude(spectra.selected(roll, float(row["order"]))))
            assert row["from"] * (1 - 1e-9) <= size <= row["to"] * (1 + 1e-9)


@pytest.mark.release
@pytest.mark.parametrize(
    ("chart", "words"),
    [
        ("over-turn", "the band is the range"),
        ("hodograph", "the path is that of the typical values"),
        ("vector-star", "the vectors are those of the typical values"),
        ("forces", "Estimated masses or lengths"),
        ("bearing-loads", "greatest loads have their ranges"),
        ("bending", "peaks have their ranges"),
        pytest.param("spectrum", "thin line is the range", marks=pytest.mark.release),
        pytest.param("polygon", "a resultant has its range", marks=pytest.mark.release),
        ("balance-shafts", "unbalances that rest on them are marked"),
        ("shaft", "Estimated bore pitch: arms are 0.923 to 1.1 times as long."),
    ],
)
def test_charts_of_estimated_engines_say_so_under_the_title(
    run: Run, chart: str, words: str
) -> None:
    engine = "bmw-m52b28" if chart != "forces" else "kr250-racer"
    estimated = " ".join(drawn(run, engine, chart, "--estimate")["title"]["subtitle"])
    assert words in estimated
    assert "stimated" not in json.dumps(drawn(run, engine, chart))


@pytest.mark.release
def test_a_resultant_has_the_range_of_any_masses(run: Run) -> None:
    chart = drawn(run, "vw-vr6", "polygon", "--orders", "1", "--quantity", "couple", "--estimate")
    texts = [" ".join(panel["title"]["text"]) for panel in panels(chart)]
    match = re.search(r"resultant ([\d.]+) \(([\d.]+) to ([\d.]+)\) N m", texts[0])
    assert match is not None, texts
    typical, low, high = map(float, match.groups())
    assert low < typical < high
    for engine in variants(tree_for("vw-vr6"), count=8):
        couple = spectra.selected(total(balance(engine, speed=engine.speed)).couple, 1.0)
        assert low * 0.995 <= abs(couple.forward[0]) <= high * 1.005


@pytest.mark.release
@pytest.mark.parametrize("chart", ["bearing-loads", "bending"])
def test_peaks_on_the_crankshaft_have_the_range_of_any_masses(run: Run, chart: str) -> None:
    heads = [
        " ".join(panel["title"]["text"])
        for panel in panels(drawn(run, "bmw-m52b28", chart, "--estimate"))
    ]
    ends = [
        list(map(float, found.groups()))
        for head in heads
        if (found := re.search(r"([\d.]+) \(([\d.]+) to ([\d.]+)\) at", head))
    ]
    assert len(ends) == len(heads)
    for engine in variants(tree_for("bmw-m52b28"), count=4):
        if chart == "bearing-loads":
            sizes = spectra.peaks(bearing_loads(engine, speed=engine.speed).load) / 1000  # in kN
        else:
            bare = without_counterweights(engine)
            models: tuple[Any, ...] = (None, "determinate", "continuous")
            bent = [bending_moment(bare, speed=engine.speed, model=model) for model in models]
            sizes = [spectra.peaks(each.moment).max() for each in bent]
        for (typical, low, high), size in zip(ends, sizes, strict=True):
            assert low < typical < high
            assert low * 0.995 <= size <= high * 1.005


@pytest.mark.release
def test_shafts_sized_for_estimated_masses_are_marked(run: Run) -> None:
    run("balance", "honda-b18c", "--estimate", "--shafts", "needed", "-o", "b18c.toml")
    heads = [" ".join(panel.get("title", {}).get("text", [])) for panel in panels(
        drawn(run, "b18c.toml", "balance-shafts"))]  # fmt: skip
    assert [bool(re.search(r"unbalance \d+ g mm \(estimated\) at", head)) for head in heads] == [
        False,
        True,
        True,
    ]


@pytest.mark.release
def test_engines_side_by_side_have_their_own_ranges(run: Run) -> None:
    chart = drawn(
        run, "bmw-m52b28", "spectrum", "--beside", "vw-vr6", "--speed", "5000 rpm", "--estimate"
    )
    rolls = [panel for panel in panels(chart) if "rolling" in json.dumps(panel)]
    ends = [layers(panel, "rule") for panel in rolls]
    assert len(ends) == 2
    assert ends[0] != ends[1]
    assert all(rows for rows in ends)


def shares(run: Run, *arguments: str) -> list[str]:
    """The shares of force that `compare` prints."""
    text = run("compare", *arguments, "--estimate", "--orders", "2,4").out
    force = text[text.index("Force") : text.index("Couple")]
    return re.findall(r"^ *(?:2|4|peak)  .*?  (\S[^)]*\)?)$", force, re.MULTILINE)


@pytest.mark.release
def test_the_same_estimated_parts_move_together_in_a_comparison(run: Run) -> None:
    """Force follows r^2 A_k w^2: another stroke has another share, whatever the masses are."""
    same = shares(run, "honda-b18c", "honda-b18c", "--set", '2:cylinder.stroke="80 mm"')
    assert same[0].split()[-1] == "83.81"
    assert all("to" not in share for share in same)
    others = shares(run, "honda-b18c", "yamaha-r1-crossplane")
    assert any("to" in share for share in others)


@pytest.mark.release
def test_the_report_marks_what_rests_on_estimates_from_the_first_page(run: Run) -> None:
    run("report", "bmw-m52b28", "--estimate", "-o", "report.html")
    text = re.sub(r"<[^>]+>", " ", Path("report.html").read_text())
    text = " ".join(text.split())
    front = text[: text.index("Contents")]
    assert "Masses or lengths of this engine are estimated" in front
    assert re.search(r"Force of order 6: about 10\.4 \(7\.79 to 15\.8, estimated\) N", front)
    assert "about 0.436 (0.349 to 0.57, estimated) kg" in text
    assert "the band is the range" in text
    assert "--estimate" in text[text.index("Reproduction") :]
    spectra_of = text[text.index("Peak force, couple") :]
    assert "thin line is the range" in spectra_of


@pytest.mark.release
def test_a_report_without_estimates_says_nothing_of_them(run: Run) -> None:
    run("report", "triple-120", "-o", "report.html")
    assert "stimated" not in Path("report.html").read_text().replace("estimated bar", "")


@pytest.mark.release
def test_figures_of_a_report_are_in_the_chosen_units(run: Run) -> None:
    run("report", "subaru-ej25", "--units", "us", "-o", "report.html")
    drawings = re.findall(r"<svg.*?</svg>", Path("report.html").read_text(), re.DOTALL)
    words = " ".join(re.sub(r"<[^>]+>", " ", drawing) for drawing in drawings)
    assert "lbf ft" in words
    assert "N m" not in words


def test_numbers_keep_their_range_where_words_differ_at_a_corner() -> None:
    said = "Force {force} N, up. Couple {couple} N m, to the {side}."
    own = _(said, force=number(2.0), couple=number(5.0), side="left")
    like = [
        _(said, force=number(size), couple=number(2 * size), side=side)
        for size, side in ((2.5, "left"), (1.0, "left"), (4.0, "right"))
    ]
    assert sentence(own, like) == (
        "Force about 2 (1 to 4, estimated) N, up. Couple about 5 (2 to 8, estimated) N m, "
        "to the left (estimated)."
    )


def test_a_sentence_that_others_lack_is_marked_once() -> None:
    own = _("A weight of {mass} g, at the front.", mass=number(2.0))
    assert sentence(own, ["", ""]) == "A weight of 2 g, at the front (estimated)."


def spans_of(text: str) -> list[list[float]]:
    """The typical value, the least and the greatest of every range in a text."""
    found = re.findall(r"([\d.e+-]+) \(([\d.e+-]+) to ([\d.e+-]+)", text)
    return [[float(part) for part in parts] for parts in found]


@pytest.mark.release
@pytest.mark.parametrize("name", ["kr250-racer", "vw-vr6", "triumph-675", "bmw-m52b28"])
def test_a_roll_has_one_range_in_words_and_in_the_table(run: Run, name: str) -> None:
    """And masses drawn at random leave no roll beyond it."""
    out = re.sub(r"\s+", " ", run("analyze", name, "--estimate", "--units", "N, N m").out)
    said = re.search(r"Roll without gas of order (\d+): about ([^)]*)", out)
    assert said is not None
    moments = out[out.index("Moments about the crank axis") :]
    row = re.search(rf" {said[1]} ([\d.]+ \([^)]*)\) ∠", moments)
    assert row is not None
    (span,) = spans_of(said[2])
    assert [span] == spans_of(row[1])
    told = re.sub(r"\s+", " ", run("verdict", name, "--estimate", "--units", "N, N m").out)
    assert span in spans_of(told[told.index("largest at order") :])
    typical, low, high = span
    assert low < typical < high
    for engine in variants(tree_for(name), count=20):
        roll = summed(balance(engine, speed=engine.speed)).roll
        size = abs(spectra.amplitude(spectra.selected(roll, [float(said[1])])))[0]
        assert low * 0.995 <= size <= high * 1.005
