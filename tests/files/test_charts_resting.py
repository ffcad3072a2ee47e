"""What the numbers of a figure rest on: below it, among its notes, and in its description."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.charted import foot
from tests.commands import Run
from tests.lacking import FIVE
from tests.mounted_engines import standing
from tests.search.test_fronts import found as found_stars
from tests.twisting_engines import TORSION

import crankstar
from crankstar import charts
from crankstar.analyses.diagnose.charts import suspect_chart
from crankstar.analyses.diagnose.diagnosis import diagnosed
from crankstar.analyses.diagnose.readings import Reading
from crankstar.charts import resting
from crankstar.charts.grammar import Chart
from crankstar.charts.letters import SMALL, text_width
from crankstar.dynamics.whirl import body
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.language.messages import spoken
from crankstar.page.figures import chart as page_chart
from crankstar.studies import answers
from crankstar.studies.fault_kinds import Fault
from crankstar.studies.single_faults import shaken

AUDI = "audi-25-tfsi"


def rests(chart: Chart) -> dict[str, dict[str, Any]]:
    """What a figure rests on for machines, by key path."""
    return {row["path"]: row for row in chart.spec.get("usermeta", {}).get("rests_on", ())}


def test_a_figure_says_how_far_a_missing_rotating_mass_moves_its_greatest_order() -> None:
    engine = crankstar.load(AUDI)
    chart = charts.hodograph(engine, quantity="couple", speed=engine.speed)
    found = rests(chart)["cylinder.rotating_mass"]
    assert (found["status"], found["value"], found["unit"]) == ("missing", 0.0, "kg")
    throws = engine.shafts[0].throws
    arms = abs(sum(throw.z * np.exp(1j * throw.angle) for throw in throws))
    speed = engine.speed or 0.0
    # half the reciprocating mass turns with the crank, half against it; all of the rotating with it
    size = throws[0].radius * speed**2 * arms
    mass = engine.first.reciprocating_mass
    moves = found["moves"]
    assert (moves["quantity"], moves["order"], moves["unit"]) == ("couple", 1.0, "N*m")
    assert moves["now"] == pytest.approx(mass * size, rel=1e-9)
    least, most = (
        found[end] + pin for end, pin in zip(("low", "high"), found["throw_mass"], strict=True)
    )
    assert moves["low"] == pytest.approx((mass + least) * size, rel=1e-9)
    assert moves["high"] == pytest.approx((mass + most) * size, rel=1e-9)
    assert foot(chart.spec)[0].startswith("cylinder.rotating_mass")
    assert foot(chart.spec)[-1] == "And 2 more: crankstar analyze"
    assert len([line for line in chart.notes if ": " in line]) == len(rests(chart))


def test_a_figure_rests_on_nothing_that_does_not_move_it() -> None:
    engine = crankstar.load("i4")
    star, force = charts.crank_star(engine), charts.hodograph(engine, quantity="force", order=2)
    for chart in (star, force):
        assert "cylinder.rotating_mass" not in rests(chart)
    assert (foot(star.spec), star.notes, "usermeta" in star.spec) == ([], (), False)
    assert rests(charts.hodograph(engine, quantity="couple", order=2)).keys() <= rests(force).keys()


def unverified(engine: Engine, *keys: str) -> set[str]:
    """The values of an engine file that nobody has read in a source, with these first letters."""
    return {
        path
        for path, origin in engine.provenance.items()
        if origin.status in ("unverified", "placeholder") and path.startswith(keys)
    }


LAYOUT = ("layout", "cylinder.stroke", "rotation", "shaft")
FIRING = (
    *("layout.banks", "layout.bearing", "layout.cranks.banks", "layout.cranks.lag"),
    *("layout.cranks.throws", "layout.cranks.speed_ratio", "layout.lag", "layout.pin_split"),
    *("layout.throws", "layout.speed_ratio", "layout.knuckle_radius", "firing_order", "rotation"),
    *("shaft.speed_ratio", "shaft.throw.angle"),
)  # no length along the shaft moves an angle
OF_SHAPE = {
    "crank-star": LAYOUT,  # the throws, as the layout has them: no mass, no speed
    "shaft": LAYOUT,  # throws and arms from the side
    "balance-shafts": LAYOUT,  # places and unbalances that are in the file
    "stroke-chart": FIRING,  # crank angles of firing, and the timing of the valves
    "firing-ring": FIRING,  # crank angles of firing
    "exhaust-orders": FIRING,  # equal pulses at these angles
}
"""Charts in which there is no force: key paths from which what they show comes, and why."""


ANSWERED_ALIKE = (
    "campbell",
    "torsion-modes",
    "torsion-star",
    "mount-modes",
    "mount-layout",
    "transmissibility",
)
"""Charts whose answer is that of another one."""
SLOW = ("torsion-response",)
"""Charts of which another test of the gate varies the answer."""


@pytest.mark.many(first=2)
@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=[pytest.mark.release] if name in ANSWERED_ALIKE + SLOW else [])
        for name in charts.CHARTS
    ],
)
def test_every_chart_rests_on_what_its_numbers_come_from(name: str) -> None:
    engine = standing(torsion={**TORSION}, block={"mass": "165 kg"})
    chart = charts.CHARTS[name].draw(engine)
    found = rests(chart)
    if name not in OF_SHAPE:
        assert any(row["moves"] is not None for row in found.values())
        assert foot(chart.spec)
        return
    timed = {path for path in found if path.startswith("valves.")}
    assert {*found} - timed == unverified(engine, *OF_SHAPE[name])
    assert bool(timed) == (name == "stroke-chart")
    assert all(row["moves"] is None for row in found.values())


@pytest.mark.parametrize("name", OF_SHAPE)
def test_a_drawing_names_what_of_its_shape_nobody_has_read(name: str) -> None:
    seen = set()
    for engine in map(crankstar.load, ("honda-b18c", "subaru-ej25", "v8-cross-plane")):
        paths = {path for path in rests(charts.CHARTS[name].draw(engine)) if "valves" not in path}
        assert paths == unverified(engine, *OF_SHAPE[name]), engine.name
        seen |= paths
    assert seen or name == "balance-shafts"


@pytest.mark.release
def test_charts_of_studies_rest_on_what_their_tables_do(run: Run, tmp_path: Path) -> None:
    asked = {
        "sweep": ("--over", "speed=1000..6000 rpm/5", "--quantity", "couple"),
        "tolerance": ("--typical", "--builds", "1000"),
    }
    for verb, words in asked.items():
        rows = json.loads(run(verb, AUDI, *words, "--json").out)["rests_on"]
        picture = tmp_path / f"{verb}.svg"
        said = run(verb, AUDI, *words, "-o", str(picture))
        told = {  # the tables have rolling moments too
            row["path"]
            for row in rows
            if (own := row["moves"]) and own["quantity"] != "roll" and own["effect"] > 0.1
        }
        assert told
        assert all(path in said.err for path in told), verb
        drawn = picture.read_text(encoding="utf-8")
        assert "cylinder.rotating_mass" in drawn
        assert ("With crank speed = 6000 rpm this rests on:" in drawn) == (verb == "sweep")


@pytest.mark.release
def test_a_balance_factor_that_is_swept_leaves_no_counterweight_in_doubt(run: Run) -> None:
    """Nor a rotating mass, all of which a factor balances: the couple is the same without it."""
    over = ("--over", "balance_factor=0..1/3", "--quantity", "couple")
    answer = json.loads(run("sweep", AUDI, *over, "--json").out)
    assert [row["path"] for row in answer["rests_on"]] == ["cylinder.rod_length"]
    assert answer["rests_on_at"] == "balance_factor = 1"
    masses = ("0 g", "900 g")
    light, heavy = (
        crankstar.sweep(AUDI, over[1], changes={"cylinder.rotating_mass": mass}) for mass in masses
    )
    both = [crankstar.watched(each, "couple").values for each in (light, heavy)]
    assert both[0] == pytest.approx(both[1], rel=1e-12)


@pytest.mark.release
def test_the_chart_of_a_diagnosis_rests_on_the_block_it_shakes() -> None:
    engine = standing(block={"mass": "165 kg"})
    speed = 1000 * np.pi / 30
    place = body(engine).centre
    shake = shaken(engine, [Fault("combustion", 2)], speed=speed, orders=[0.5, 1.0, 1.5])
    moved = shake.displacement(place)
    readings = [
        Reading(float(order), place, axis, 1j * order * speed * complex(moved[at, axis]), speed, at)
        for at, order in enumerate(shake.orders)
        for axis in (0, 1)
    ]
    chart = suspect_chart(diagnosed(engine, readings))
    found = rests(chart)
    assert {"block.inertia", "block.up"} <= {*found}
    assert {row["moves"]["quantity"] for row in found.values() if row["moves"]} & {"velocity"}
    assert foot(chart.spec)


def test_charts_of_a_search_rest_on_no_file() -> None:
    # sums of unit vectors over throws that are all alike: no engine file is read
    stars = found_stars("6")
    for chart in (charts.pareto_front(stars), charts.best_stars(stars, count=1)):
        assert (foot(chart.spec), chart.notes, "usermeta" in chart.spec) == ([], (), False)


def test_a_figure_without_a_speed_counts_in_its_own_unit() -> None:
    chart = charts.spectrum(crankstar.load(AUDI))
    units = {row["moves"]["unit"] for row in rests(chart).values() if row["moves"]}
    assert units == {"m*r*w^2*a", "m*r^2*w^2"}


@pytest.mark.release
@pytest.mark.parametrize("language", ["en", "ja", "ru"])
@pytest.mark.parametrize("width", [0.11, 0.18])
@pytest.mark.parametrize("name", ["spectrum", "amplitudes", "torque", "bearing-loads", "bending"])
def test_the_foot_keeps_within_the_width_of_its_figure(
    name: str, width: float, language: str
) -> None:
    engine = crankstar.load(AUDI)
    drawn = charts.CHARTS[name]
    options = {"speed": engine.speed} if "speed" in drawn.options else {}
    with spoken(language):
        made = charts.printed(
            lambda: drawn.draw(engine, **options), charts.Paper(width=width), title=name
        )
    spec = made.chart.to_dict()
    panel = spec["vconcat"][-1]
    assert panel["name"] == resting.FOOT
    rows = panel["layer"][0]["data"]["values"]
    assert all(text_width(row["text"], SMALL) <= panel["width"] for row in rows)
    steps = np.diff([row["y"] for row in rows])
    assert (steps >= SMALL).all()
    assert panel["width"] <= made.size[0]
    assert rows[-1]["y"] + SMALL / 2 <= panel["height"]
    assert len(rows) <= resting.MOST_LINES + 2


@pytest.mark.parametrize("width", [120.0, 200.0, 330.0, 600.0])
def test_the_foot_ends_with_a_sentence_or_a_whole_word(width: float) -> None:
    """Beside 8 lines at most; of a single long sentence whole words, of several whole sentences."""
    told = "With 374 g to 1050 g the sum of order 1 is 2560 to 4800.5 N m, not 1160 N m."
    several = " ".join(f"{number}: {told}" for number in range(1, 9))
    single = told.rstrip(".") + (" and so it goes on from 1000 rpm to 12345.6 rpm" * 30)
    for text in (told, several, single):
        [panel] = [resting.foot_panel([text, "And 1 more"], width=width)]
        *lines, last = [row["text"] for row in panel["layer"][0]["data"]["values"]]
        assert last == "And 1 more"
        kept = " ".join(lines)
        assert len(lines) <= resting.MOST_LINES
        assert all(text_width(line, SMALL) <= width for line in lines)
        if kept.endswith("…"):
            *whole, end = kept[:-1].split()
            assert text.split()[: len(whole)] == whole
            assert text.split()[len(whole)].rstrip(".,") == end
        else:
            assert text == kept or text.startswith(f"{kept} ")
            assert kept.endswith((".", "rpm"))
    assert " ".join(lines).endswith("…")


@pytest.mark.parametrize("name", ["bearing-loads", "bending"])
def test_what_is_left_out_is_named_in_the_picture(name: str) -> None:
    chart = charts.CHARTS[name].draw(engine_of(FIVE))
    lines = foot(chart.spec)
    assert lines[0].startswith("cylinder.rotating_mass")
    assert any(line.startswith("Not in the loads: gas") for line in lines)
    assert lines[-1].endswith("crankstar bearings")
    assert rests(chart)["gas"]["status"] == "left out"


def test_a_polygon_rests_on_its_resultant_and_a_closed_one_on_its_vectors() -> None:
    """The primary couple of an in-line five, by own phasors: m r w^2 |sum of z e^(i phi)|."""
    chart = charts.polygon(engine_of(FIVE), quantity="couple", order=1.0, speed=100.0)
    moves = rests(chart)["cylinder.rotating_mass"]["moves"]
    phases = {1: 0, 2: 144, 4: 288, 5: 432, 3: 576}  # crank angle of firing, 720/5 apart
    arms = sum(0.091 * (3 - own) * np.exp(-1j * np.radians(at)) for own, at in phases.items())
    assert (moves["quantity"], moves["order"]) == ("couple", 1.0)
    assert moves["now"] == pytest.approx(0.480 * 0.045 * 100.0**2 * abs(arms), rel=1e-9)
    closed = charts.polygon(engine_of(FIVE), quantity="force", order=1.0, speed=100.0)
    lengths = rests(closed)["cylinder.rotating_mass"]["moves"]
    assert lengths["quantity"] == "vectors"
    assert lengths["now"] == pytest.approx(5 * 0.480 * 0.045 * 100.0**2, rel=1e-9)


def test_a_figure_for_a_paper_is_worked_out_once(monkeypatch: pytest.MonkeyPatch) -> None:
    engine, asked = crankstar.load(AUDI), []
    own = answers.rests_on
    monkeypatch.setattr(answers, "rests_on", lambda *args: asked.append(args) or own(*args))
    made = charts.printed(
        lambda: charts.spectrum(engine), charts.Paper(width=0.12), title="spectrum"
    )
    assert len(asked) == 1
    assert made.chart.notes


def test_several_engines_in_a_figure_are_named() -> None:
    both = [crankstar.load(AUDI), crankstar.load("honda-b18c")]
    chart = charts.side_by_side(both, "spectrum")
    names = {row["engine"] for row in chart.spec["usermeta"]["rests_on"]}
    assert names <= {engine.name for engine in both}
    assert foot(chart.spec)[0].startswith(tuple(names))


def test_figures_of_a_page_leave_it_to_the_page() -> None:
    shown = json.dumps(page_chart(crankstar.load(AUDI), "spectrum"))
    assert resting.FOOT not in shown.replace("rests_on", "")
    assert "usermeta" not in shown


@pytest.mark.release
def test_plot_says_all_that_its_figure_rests_on(run: Run, tmp_path: Path) -> None:
    said = run("plot", AUDI, "spectrum", "-o", str(tmp_path / "s.json"))
    spec = json.loads((tmp_path / "s.json").read_text(encoding="utf-8"))
    for row in spec["usermeta"]["rests_on"]:
        assert row["path"] in said.err
    run("plot", AUDI, "spectrum", "-o", str(tmp_path / "s.html"))
    page = (tmp_path / "s.html").read_text(encoding="utf-8")
    assert '"rests_on"' in page
    assert '"embedOptions"' in page
    assert run("plot", AUDI, "crank-star", "-o", str(tmp_path / "c.svg")).err.count("\n") == 1
