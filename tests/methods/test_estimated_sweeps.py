"""Sweeps of estimated engines: the typical curve, and the band in which every other one lies."""

from __future__ import annotations

import csv
import json
import re
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from crankstar import cli
from crankstar.charts.drawing import svg
from crankstar.charts.sweeps import swept as chart
from crankstar.files import tree_text
from crankstar.files.box import ranges, scaled
from crankstar.files.catalog import tree_of
from crankstar.files.estimate import estimated
from crankstar.studies.best_value import best
from crankstar.studies.sweep import sweep, watched
from crankstar.tables.number_ranges import real_range
from crankstar.tables.sweep_ranges import MOST_VALUES, bands

OVER = "balance_factor=0..1/15"


@pytest.mark.release
def test_every_engine_of_the_box_lies_in_the_band(tmp_path: Path) -> None:
    tree = estimated(tree_of("triumph-675")[1]).tree
    made = sweep("triumph-675", OVER, estimate=True)
    curves = [watched(made, "couple"), watched(made, "roll")]
    found = bands(made, curves, [best(made, curve) for curve in curves])
    rng = np.random.default_rng(1)
    for case in range(4):
        factors = {path: rng.uniform(each.low, each.high) for path, each in ranges(tree).items()}
        file = tmp_path / f"{case}.toml"
        file.write_text(tree_text(scaled(tree, factors)), encoding="utf-8")
        other = sweep(str(file), OVER)
        for curve, band in zip(curves, found, strict=True):
            assert band is not None
            values = watched(other, curve.what).values
            assert np.all(values <= band.high * (1 + 1e-9))
            assert np.all(values >= band.low * (1 - 1e-9))
            assert np.all(band.low <= curve.values)
            assert np.all(curve.values <= band.high)


@pytest.mark.release
def test_the_range_at_a_value_is_that_of_the_engine_with_it() -> None:
    made = sweep("triumph-675", OVER, estimate=True)
    curve = watched(made, "couple", order=1)
    (band,) = bands(made, [curve], [best(made, curve)])
    assert band is not None
    ends = [
        float(watched(sweep_of_two_values(end), "couple", order=1).values[0]) for end in made.ends()
    ]
    assert band.cells[0] == real_range([float(curve.values[0]), *ends], float(max(band.high)))


def sweep_of_two_values(made):  # a Sweep, at its first values alone
    """The engines one by one, without a law."""
    return made.again(made.values[:2])


@pytest.mark.release
def test_a_varied_value_has_no_range_of_its_own() -> None:
    made = sweep("toyota-2jz", "cylinder.reciprocating_mass=400..600 g/15", estimate=True)
    assert len(made.ends()) == 1 + 2**5  # the others: rod (3), throw and pitch
    assert "cylinder.reciprocating_mass" not in made.engine.provenance


@pytest.mark.release
def test_a_sweep_of_two_numbers_and_a_very_fine_one_have_no_ranges() -> None:
    two = sweep("triumph-675", [OVER, "cylinder.offset=0..5 mm/4"], estimate=True)
    fine = sweep("triumph-675", f"balance_factor=0..1/{MOST_VALUES + 1}", estimate=True)
    for made in (two, fine):
        curve = watched(made, "couple")
        assert bands(made, [curve], []) == (None,)


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Callable[..., str]:
    """What a sweep of an estimated engine prints."""

    def run(*words: str) -> str:
        asked = ["sweep", "triumph-675", "--estimate", "--over", OVER, "--quantity", "couple"]
        with pytest.raises(SystemExit) as left:
            cli.main([*asked, *words])
        assert left.value.code == 0
        return capsys.readouterr().out

    return run


@pytest.mark.release
def test_every_form_of_a_sweep_has_the_same_band(run: Callable[..., str]) -> None:
    row = next(csv.DictReader(run("--csv").splitlines()))
    ends = [float(row[f"amplitude{end}"]) for end in ("_low", "", "_high")]
    first = json.loads(run("--json"))["values"][0]
    assert [first[f"couple{end}"] for end in ("_low", "", "_high")] == ends
    both = run("--over", "cylinder.offset=0..5 mm/4")
    assert "typical values, without ranges" in " ".join(both.split())


@pytest.mark.release
def test_the_band_is_drawn_and_written(run: Callable[..., str]) -> None:
    row = next(csv.DictReader(run("--csv").splitlines()))
    ends = [float(row[f"amplitude{end}"]) for end in ("_low", "", "_high")]
    assert 0 < ends[0] < ends[1] < ends[2]
    text = run()
    assert text.splitlines()[1].startswith("Estimated as of type ")
    assert "couple (estimated)" in text
    assert "Least couple: about " in text
    made = sweep("triumph-675", OVER, estimate=True)
    curve = watched(made, "couple")
    found = [best(made, curve)]
    spec = chart(made, [curve], best=found, bands=bands(made, [curve], found)).spec
    assert "the bands are the" in json.dumps(spec)
    assert '"area"' in json.dumps(spec)


@pytest.mark.release
def test_panels_of_one_and_of_two_curves_have_their_own_colours() -> None:
    made = sweep("kr250-racer", "balance_factor=0..1/3", estimate=True)
    curves = [watched(made, name) for name in ("force", "couple", "roll")]
    assert [curve.unit for curve in curves] == ["N", "N*m", "N*m"]
    drawn = svg(chart(made, curves), "x")
    colours = re.findall(r'stroke="(#[0-9a-f]{6})" stroke-width="2.4"', drawn)
    assert len(colours) == 3
    assert colours[0] == colours[1] != colours[2]
    assert ">couple<" in drawn
    assert ">rolling moment<" in drawn


def test_each_of_many_curves_has_its_own_stroke_and_one_legend_in_words() -> None:
    made = sweep("audi-25-tfsi", "balance_factor=0..1/3")
    asked = ("couple", "couple.pitch", "couple.yaw", "couple.forward", "roll", "torque")
    curves = [watched(made, name, order=order) for name in asked for order in (1, 5)]
    drawn = svg(chart(made, curves), "x")
    strokes = re.findall(r'<path[^>]*stroke="(#\w+)" stroke-width="2.4"([^>]*)', drawn)
    dashes = [re.search(r'stroke-dasharray="([\d,]+)"', more) for _colour, more in strokes]
    looks = [
        (colour, dash and dash[1]) for (colour, _more), dash in zip(strokes, dashes, strict=True)
    ]
    assert len(looks) == len(set(looks)) == len(curves)
    for words in ("pitch M_V of order 1", "couple with the crank of order 5", "rolling moment"):
        assert words in drawn
    assert drawn.count(">inertia torque of order 5<") == 1
    assert "couple.pitch" not in drawn


@pytest.mark.release
def test_a_sweep_of_a_dimension_says_that_estimates_stay_behind(run: Callable[..., str]) -> None:
    note = "they do not change with cylinder.rod_length"
    assert note not in run()
    assert note in " ".join(run("--over", "cylinder.rod_length=110..130 mm/3").split())
