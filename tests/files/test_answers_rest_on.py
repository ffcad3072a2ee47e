"""What fault, compare, verdict and mounts print rests on, beside the numbers that they print."""

import json
import re
from math import pi
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.charted import foot
from tests.commands import Run
from tests.lacking import RUBBER

import crankstar
from crankstar import spectra
from crankstar.analyses.mounts.charts.responses import mount_response_chart
from crankstar.dynamics.mounted_block import mounted_block, settled
from crankstar.files.catalog import path_of
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import gas_torque

ROOT = Path(__file__).parents[2]
AUDI, BMW = "audi-25-tfsi", "bmw-m52b28"
V8 = crankstar.load("v8-cross-plane").name
INERTIA = """
inertia_up = "8 kg*m^2"
inertia_right = "9 kg*m^2"
inertia_z = "4 kg*m^2"
"""


@pytest.fixture
def mounted(tmp_path: Path) -> str:
    """The Audi on rubber, of its block the mass alone; other values are added with --set."""
    text = (path_of(AUDI) or Path()).read_text(encoding="utf-8")
    head, above, provenance = text.partition("[provenance]")
    block = f'[block]\nmass = "150 kg"\n{RUBBER}\n'
    path = tmp_path / "mounted.toml"
    path.write_text(f"{head}{block}{above}{provenance}", encoding="utf-8")
    return str(path)


@pytest.fixture
def still(mounted: str) -> str:
    """The same without gas, of which nothing is then to be assumed."""
    path = Path(mounted)
    before, _gas, after = path.read_text(encoding="utf-8").partition("[gas]")
    path.write_text(before + after[after.index("[block]") :], encoding="utf-8")
    return mounted


def rows_by_path(answer: Any) -> dict[str, dict[str, Any]]:
    return {row["path"]: row for row in answer["rests_on"]}


@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    ("name", "fault"),
    [
        (AUDI, ("--cut", "3")),
        ("subaru-ej25", ("--heavier", "piston.1=20g")),
        ("", ("--cut", "2", "--point", "idle", "--at", "0.1 m, 0.2 m, -0.3 m")),
    ],
)
@pytest.mark.parametrize("orders", [(), ("--orders", "1,2")])
def test_a_fault_rests_on_figures_of_its_own_table(
    name: str, fault: tuple[str, ...], orders: tuple[str, ...], mounted: str, run: Run
) -> None:
    made = run("fault", name or mounted, *fault, *orders, "--json")
    assert made.code == 0, made.err
    answer = json.loads(made.out)
    shown = {row["order"]: row["now"] for row in answer["orders"]}
    moved = [row["moves"] for row in answer["rests_on"] if row["moves"]]
    assert moved
    for each in moved:
        assert each["now"] == pytest.approx(
            shown[each["order"]][each["quantity"]], rel=1e-9, abs=1e-12
        )


@pytest.mark.release
@pytest.mark.parametrize("speed", [None, "3000 rpm"])
def test_compared_engines_name_the_speed_and_point_of_their_gas(
    speed: str | None, run: Run
) -> None:
    asked = () if speed is None else ("--speed", speed)
    answer = json.loads(run("compare", AUDI, BMW, *asked, "--json").out)
    states = {row["engine"]: row for row in answer["gas"]}
    for name in (AUDI, BMW):
        engine = crankstar.load(name)
        state = states[engine.name]
        if speed is None:
            assert state["point"] == "full"
        else:
            assert state["speed_rpm"] == pytest.approx(3000.0, rel=1e-12)
            assert state["point"] is None
            assert sum(each["share"] for each in state["points"]) == pytest.approx(1.0)
        own = [
            row
            for row in answer["amplitudes"]
            if row["quantity"] == "torque_with_gas" and row["engine"] == engine.name
        ]
        assert {row["speed_rpm"] for row in own} == {state["speed_rpm"]}
    # an engine without masses has the torque of gas alone, at the speed of the others
    found = cycle(crankstar.load(BMW), speed=state["speed_rpm"] * np.pi / 30)
    torque = gas_torque(found).total
    waves = np.abs(spectra.amplitude(torque))
    for row in own:
        if row["greatest"]:
            place = torque.orders.tolist().index(row["order"])
            assert row["greatest"] == pytest.approx(waves[place], rel=1e-9)
    assert "operating point full" in run("compare", AUDI, BMW).out
    said = run("compare", AUDI, BMW, "--speed", "3000 rpm").out
    assert said.count("At 3000 rpm, with a load between the points") == 2


def test_two_compared_engines_say_what_matters_most_on_the_first_screen(
    run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    lines = run("compare", AUDI, "honda-b18c").out.splitlines()
    screen = "\n".join(lines[:24])
    for name in (AUDI, "honda-b18c"):
        assert f"{crankstar.load(name).name} rests on:" in screen
    assert screen.index("rests on:") > screen.index("Force")
    assert "cylinder.rotating_mass" in screen
    assert "also rests on:" in "\n".join(lines[24:])


def test_engines_that_are_compared_without_masses_rest_on_figures_in_their_own_unit(
    run: Run,
) -> None:
    answer = json.loads(run("compare", AUDI, "v8-cross-plane", "--json").out)
    units = {row["unit"] for row in answer["amplitudes"] if row["quantity"] in ("force", "couple")}
    found = [row for row in answer["rests_on"] if row["moves"] is not None]
    assert {row["engine"] for row in found} == {crankstar.load(AUDI).name, V8}
    assert {
        row["moves"]["unit"] for row in found if row["moves"]["quantity"] in ("force", "couple")
    } <= units
    assert "N*m" not in {row["moves"]["unit"] for row in found}
    first = next(row for row in found if row["path"] == "cylinder.rotating_mass")
    # what turns adds to the 0.492 kg that go up and down as it does to the couple of order 1
    [now] = {
        row["greatest"]
        for row in answer["amplitudes"]
        if (row["quantity"], row["order"], row["engine"]) == ("couple", 1.0, first["engine"])
    }
    heavier = 1 + (first["high"] + first["throw_mass"][1]) / 0.492
    assert first["moves"]["now"] == pytest.approx(now, rel=1e-6)
    assert first["moves"]["high"] == pytest.approx(now * heavier, rel=1e-6)


@pytest.mark.release
def test_the_range_of_an_assumed_value_between_two_points_holds_the_number(run: Run) -> None:
    answer = json.loads(run("torque", BMW, "--speed", "3000 rpm", "--json").out)
    pressure = rows_by_path(answer)["gas.intake_pressure"]
    assert pressure["value"] == pytest.approx(1.0)  # of the point without one; idle has 0.35 bar
    moves = pressure["moves"]
    assert moves["low"] <= moves["now"] <= moves["high"]


@pytest.mark.release
def test_the_verdict_rests_on_what_is_assumed_of_block_and_mounts(mounted: str, run: Run) -> None:
    said = run("verdict", mounted).out
    rests = said[said.index("This rests on:") : said.index("\n\n")]
    for path in ("block.inertia", "block.up", "mounts.loss_factor"):
        assert path in rests
    assert "block." not in run("verdict", AUDI).out


@pytest.mark.release
def test_a_centre_of_mass_that_is_not_in_the_file_is_in_the_record(still: str, run: Run) -> None:
    found = rows_by_path(json.loads(run("mounts", still, "--json").out))
    radius = 1e3 * crankstar.load(AUDI).shafts[0].throws[0].radius
    up, right = found["block.up"], found["block.right"]
    assert (up["status"], up["value"], up["unit"]) == ("assumed", 0.0, "mm")
    assert (up["low"], up["high"]) == pytest.approx((-radius, 3 * radius))
    assert (right["low"], right["high"]) == pytest.approx((-radius, radius))
    given = json.loads(run("mounts", still, "--set", "block.up=0 mm", "--json").out)
    assert "block.up" not in rows_by_path(given)
    # by statics: three springs along up bear the weight, the moment about the crankshaft moves it
    weight, off = 150 * 9.80665, right["high"] / 1e3
    arms = np.array([[1.0, 1.0, 1.0], [-0.4, 0.4, 0.0], [0.1, 0.1, -0.4]])
    stiffness = arms @ arms.T  # of down, roll and pitch, in the stiffness of one mount
    moved = json.loads(
        run(
            "mounts", still, "--set", f"block.right={off!r} m", "--set", "block.z=0 mm", "--json"
        ).out
    )
    loads = weight * arms.T @ np.linalg.solve(stiffness, np.array([1.0, off, 0.0]))
    printed = [row["load"] for row in moved["mounts"]]
    assert printed == pytest.approx(np.abs(loads).tolist(), rel=1e-6)


@pytest.mark.release
def test_axes_of_inertia_that_are_taken_along_the_engine_are_in_the_record(
    still: str, run: Run
) -> None:
    inertia = [f"block.{line.replace(' = ', '=')}" for line in INERTIA.split("\n") if line]
    changes = [part for each in inertia for part in ("--set", each)]
    found = rows_by_path(json.loads(run("mounts", still, *changes, "--json").out))
    assert "block.inertia" not in found
    tilted = found["block.product_up_z"]
    assert (tilted["low"], tilted["high"]) == pytest.approx(
        (-0.2 * np.sqrt(8 * 4), 0.2 * np.sqrt(8 * 4))
    )
    zero = ("--set", "block.product_up_z=0 kg*m^2")
    given = json.loads(run("mounts", still, *changes, *zero, "--json").out)
    assert "block.product_up_z" not in rows_by_path(given)


@pytest.mark.release
def test_gas_that_is_not_there_is_named_on_the_first_screen(
    tmp_path: Path, run: Run, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("COLUMNS", "80")
    lines = (ROOT / "docs" / "how-to" / "mounts.md").read_text(encoding="utf-8").splitlines()
    start = lines.index('```toml title="v6-on-three.toml"')
    own = lines[start + 1 : lines.index("```", start)]
    burning, block = own.index("[gas]"), next(n for n, x in enumerate(own) if x[:7] == "[block]")
    path = tmp_path / "still.toml"
    path.write_text("\n".join([*own[:burning], *own[block:]]), encoding="utf-8")
    for verb in ("analyze", "bearings", "mounts", "verdict"):
        screen = run(verb, str(path)).out.splitlines()[:24]
        there = r"Not in the [a-z ]+: .*gas|gas: no table \[gas\] in the file"
        assert any(re.match(there, line) for line in screen)


@pytest.mark.release
def test_what_analyze_has_with_gas_is_not_listed_as_left_out(run: Run) -> None:
    """With masses the roll has a line with gas; without any the table of gas alone is there."""
    for asked in ((AUDI,), ("honda-b18c", "--set", "gas.compression_ratio=10.6")):
        out = run("analyze", *asked).out
        assert "gas included" in out
        assert "not in the rolling moment" not in out.lower()
        answer = json.loads(run("analyze", *asked, "--json").out)
        assert answer["gas_orders"]
        assert "left out" not in {row["status"] for row in answer["rests_on"]}


NO_SHARE = "gas (its share needs masses, sizes and a speed)."
"""What an engine without units says of gas."""


@pytest.mark.release
def test_gas_is_left_out_of_the_numbers_that_it_belongs_to(mounted: str, run: Run) -> None:
    assert f"Not in the rolling moment: {NO_SHARE}" in run("analyze", "i4").out
    assert f"Not in the loads: {NO_SHARE}" in run("bearings", "i4").out
    bare = crankstar.load(mounted).model_copy(update={"gas": None})
    from crankstar.analyses.mounts.figures import on_mounts
    from crankstar.studies.answers import rests_on

    [gas] = [each for each in rests_on(bare, on_mounts(bare)) if each.path == "gas"]
    assert "forced vibration" in gas.sentence


def test_nothing_is_headed_as_a_foundation_where_gas_alone_is_missing(run: Run) -> None:
    whole = ("--set", "cylinder.rotating_mass=0.8", "--set", "cylinder.throw_mass=0.5")
    known = [word for path in UNREAD for word in ("--set", f'provenance."{path}".status=published')]
    out = run("analyze", "i4", *whole, "--set", "balance_factor=0.5", *known).out
    assert f"Not in the rolling moment: {NO_SHARE}" in out
    assert "This rests on" not in out


UNREAD = ("firing_order", "cylinder.rod_ratio")
"""Of the in-line four of the catalog, what nobody has read in a source."""
WITHOUT = ("rests_on", "assumed")
"""Of an answer in JSON: what the record is, and what it was."""


@pytest.mark.many(first=1)
@pytest.mark.parametrize(
    "verb", [("analyze",), ("torque",), ("fault", "--cut", "3"), ("bearings", "--gas"), ("mounts",)]
)
@pytest.mark.parametrize("load", ["bmep", "imep"])
def test_a_choice_is_in_the_record_where_it_moves_a_printed_number_and_nowhere_else(
    verb: tuple[str, ...], load: str, mounted: str, run: Run
) -> None:
    """A brake load adds friction to what the gas does; an indicated one has it in the brake."""
    command, *options = verb
    text = Path(mounted).read_text(encoding="utf-8")
    Path(mounted).write_text(text.replace("\nbmep =", f"\n{load} ="), encoding="utf-8")
    asked = (command, mounted, *options, "--json")
    before = json.loads(run(*asked).out)
    diesel = (
        "--set",
        "gas.friction=diesel",
        "--set",
        "gas.ignition=spark",
    )  # else it implies another
    other = json.loads(run(*asked, *diesel).out)
    rows = {row["path"] for row in before["rests_on"]}
    moved = {k: v for k, v in before.items() if k not in WITHOUT} != {
        k: v for k, v in other.items() if k not in WITHOUT
    }
    assert ("gas.friction" in rows) == moved


VIEWS = {
    None: "velocity of the point",
    "displacement": "displacement of the point",
    "acceleration": "acceleration of the point",
    "hand-arm": "weighted acceleration of the point",
    "force": "force on the ground",
    "mounts": "force in a mount",
}


@pytest.mark.release
@pytest.mark.many(first=2)
@pytest.mark.parametrize("view", VIEWS)
def test_the_foot_of_a_response_names_what_it_draws(view: Any, mounted: str) -> None:
    engine = crankstar.load(mounted)
    speeds = [80.0, 200.0, 600.0]
    at = (0.1, 0.2, -0.3)
    drawn = mount_response_chart(engine, quantity=view, speeds=speeds, at=at)
    words = " ".join(foot(drawn.spec))
    assert f"the maximum {VIEWS[view]} is" in words
    now = float(re.findall(r"(?:not|;) ([\d.]+)", words)[0])
    assert now == pytest.approx(float(drawn_top(drawn.spec)), rel=6e-3)


def drawn_top(spec: Any) -> float:
    """The maximum of the lines of a chart: that of all orders, or of the mounts."""
    found: list[float] = []

    def walk(part: Any) -> None:
        if isinstance(part, dict):
            values = part.get("values")
            if isinstance(values, list) and values and "y" in values[0] and "what" in values[0]:
                found.extend(row["y"] for row in values)
            for each in part.values():
                walk(each)
        elif isinstance(part, list):
            for each in part:
                walk(each)

    walk(spec)
    return max(found)


@pytest.mark.release
@pytest.mark.parametrize(
    "block",
    [
        "",
        '[block]\nz = "0 m"\n',
        f"[block]\n{INERTIA}",
        '[block]\nlength = "500 mm"\nwidth = "400 mm"\nheight = "600 mm"\n',
    ],
)
def test_a_block_without_a_mass_has_the_estimated_one_in_the_record(
    block: str, still: str, run: Run
) -> None:
    """By statics the mounts carry m g; m is 70 kg per litre, here of 5 cylinders of 82.5 x 92.8."""
    text = Path(still).read_text(encoding="utf-8")
    Path(still).write_text(text.replace('[block]\nmass = "150 kg"\n', block), encoding="utf-8")
    answer = json.loads(run("mounts", still, "--json").out)
    row = rows_by_path(answer)["block.mass"]
    assert (row["status"], row["unit"]) == ("assumed", "kg")
    assert row["value"] == pytest.approx(70e3 * 5 * pi / 4 * 0.0825**2 * 0.0928)
    assert (row["low"], row["high"]) == pytest.approx((0.5 * row["value"], 1.9 * row["value"]))
    engine = crankstar.load(still)
    up = settled(mounted_block(engine))[1][:, 0].sum()
    assert abs(up) == pytest.approx(row["value"] * 9.80665, rel=1e-9)
    assert run("check", still).code == 0
    given = run("mounts", still, "--set", "block.mass=150 kg", "--json")
    assert "block.mass" not in rows_by_path(json.loads(given.out))
