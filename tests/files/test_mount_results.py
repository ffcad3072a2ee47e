"""Mounts in verdict, comparison, show, report and sweep: they say what `mounts` computes."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run
from tests.files.test_mounts import BLOCK, GROUND, THREE
from tests.texts import SHORT, spoilt

import crankstar
from crankstar.dynamics.mount_response import rms
from crankstar.files import EngineFileError, engine_of, toml
from crankstar.studies.variants import SweepError
from crankstar.tables.sweep_notes import notes
from crankstar.tables.sweeps import facts

RPM = 30 / np.pi
GAS = {
    "imep": "4 bar",
    "compression_ratio": 10,
    "point": [{"name": "idle", "speed": "700 rpm"}, {"name": "full", "speed": "6000 rpm"}],
}
GRIPS = [
    {"name": "left grip", "up": "500 mm", "right": "350 mm", "z": "200 mm"},
    {"name": "seat", "up": "400 mm", "z": "-600 mm"},
]


def mounted(**more: Any) -> crankstar.Engine:
    return engine_of(spoilt(SHORT, **{"block": BLOCK, "mounts": THREE, "gas": GAS, **more}))


def written(folder: Path, **more: Any) -> str:
    place = folder / "mounted.toml"
    place.write_text(toml(mounted(**more)), encoding="utf-8")
    return str(place)


def said(run: Run, *words: str) -> str:
    ran = run(*words)
    assert ran.code == 0, ran.err
    return " ".join(ran.out.split())


@pytest.mark.release
def test_the_verdict_tells_roll_mode_worst_force_and_worst_shake(run: Run, tmp_path: Path) -> None:
    found = crankstar.mounts(mounted())
    over = found.over
    assert over is not None
    roll = max(found.modes, key=lambda mode: mode.energy[5])
    text = said(run, "verdict", written(tmp_path))
    ends = (found.modes[0].frequency, found.modes[-1].frequency)
    assert f"Roll on the mounts: {roll.frequency:.4g} Hz, all six modes" in text
    assert f"between {ends[0]:.4g} and {ends[1]:.4g} Hz." in text
    for size, factor, words in (
        (rms(over.ground_force[..., :3]), 1.0, "greatest at {rpm:.0f} rpm: {size:.4g} N rms"),
        (rms(over.velocity(found.point)), 1e3, "most at {rpm:.0f} rpm: {size:.4g} mm/s rms"),
    ):
        place = int(np.argmax(size))
        assert words.format(rpm=over.speeds[place] * RPM, size=size[place] * factor) in text


@pytest.mark.release
def test_the_order_of_the_verdict_is_the_strongest_at_the_worst_speed() -> None:
    found = crankstar.mounts(mounted())
    over = found.over
    assert over is not None
    place = int(np.argmax(rms(over.ground_force[..., :3])))
    alone = {
        order: float(rms(over.ground_force[place : place + 1, index : index + 1, :3])[0])
        for index, order in enumerate(over.orders)
    }
    strongest = max(alone, key=alone.__getitem__)
    facts = [f.sentence for f in crankstar.verdict(mounted()).facts if f.about == "mounts"]
    assert f"most of it of order {strongest:g}." in facts[1]


def test_without_mounts_the_verdict_says_nothing_of_them() -> None:
    assert not [
        fact for fact in crankstar.verdict(crankstar.load("i4")).facts if fact.about == "mounts"
    ]


@pytest.mark.release
def test_the_first_named_point_is_the_one_that_is_told(run: Run, tmp_path: Path) -> None:
    own = mounted(block={**BLOCK, "points": GRIPS})
    found = crankstar.mounts(own)
    assert found.point == pytest.approx((0.5, 0.35, 0.2))
    facts = [fact.sentence for fact in crankstar.verdict(own).facts if fact.about == "mounts"]
    assert any("The point left grip shakes" in each for each in facts)
    place = written(tmp_path, block={**BLOCK, "points": GRIPS})
    out = json.loads(run("mounts", place, "--at", "seat", "--json").out)
    assert out["point"] == pytest.approx([0.4, 0.0, -0.6])
    again = engine_of(crankstar.files.tree_of(toml(own)))
    assert again.block == own.block


def test_two_points_of_one_name_are_a_fault() -> None:
    with pytest.raises(EngineFileError) as refusal:
        mounted(block={**BLOCK, "points": [GRIPS[0], GRIPS[0]]})
    [fault] = refusal.value.faults
    assert (fault.path, fault.code) == (("block", "points", 1, "name"), "block.point-twice")


@pytest.mark.release
def test_compare_tells_modes_force_and_shake_of_both(run: Run, tmp_path: Path) -> None:
    place = written(tmp_path)
    rows = json.loads(run("compare", place, place, "--json").out)["amplitudes"]
    found = crankstar.mounts(mounted())
    assert found.over is not None
    force = float(rms(found.over.ground_force[..., :3]).max())
    own = [row["greatest"] for row in rows if row["quantity"] == "mount_force"]
    assert own == pytest.approx([force, force])
    assert "On its mounts" in said(run, "compare", place, "i4")
    assert "On its mounts" not in said(run, "compare", "i4", "i6")


def test_show_lists_mounts_with_how_far_they_are_to_be_trusted(run: Run, tmp_path: Path) -> None:
    guess = {"status": "placeholder", "source": "a guess"}
    place = written(
        tmp_path,
        foundation=GROUND,
        block={**BLOCK, "points": GRIPS},
        provenance={"mounts[2].stiffness": guess},
    )
    text = run("show", place).out
    table = text.partition("\nMounts\n")[2].partition("\n\n")[0]
    lines = {line.split()[0]: line for line in table.splitlines() if line.strip()}
    assert "placeholder" in lines["right"]
    assert "loss factor assumed" in lines["left"]
    assert "placeholder" not in lines["rear"]
    assert "foundation: -0.5 m" in text
    assert "left grip" in text


@pytest.mark.release
def test_a_sweep_of_stiffness_and_place_is_each_engine_by_itself() -> None:
    made = crankstar.sweep(mounted(), "mounts[1].stiffness[1]=60..240 N/mm/3")
    curves = {
        what: crankstar.watched(made, what)
        for what in ("mount_mode_2", "mount_roll_mode", "mount_force", "mount_velocity")
    }
    for place, value in enumerate((60e3, 150e3, 240e3)):
        stiff = THREE[0] | {"stiffness": [f"{value} N/m", *THREE[0]["stiffness"][1:]]}
        single = crankstar.mounts(mounted(mounts=[stiff, *THREE[1:]]))
        assert single.over is not None
        wanted = {
            "mount_mode_2": single.modes[1].frequency,
            "mount_roll_mode": max(single.modes, key=lambda mode: mode.energy[5]).frequency,
            "mount_force": rms(single.over.ground_force[..., :3]).max(),
            "mount_velocity": 1e3 * rms(single.over.velocity(single.point)).max(),
        }
        for what, size in wanted.items():
            assert curves[what].values[place] == pytest.approx(size), what
    assert [curve.unit for curve in curves.values()] == ["Hz", "Hz", "N", "mm/s"]
    moved = crankstar.watched(
        crankstar.sweep(mounted(), "mounts[3].z=-400..-200 mm/2"), "mount_force"
    )
    assert moved.values[0] != moved.values[1]


def test_a_sweep_of_the_speed_takes_the_mounts_at_each_speed() -> None:
    made = crankstar.sweep(mounted(), "speed=700..6000 rpm/3")
    curve = crankstar.watched(made, "mount_force", order=1.5)
    found = crankstar.mounts(mounted(), speeds=np.array([700.0, 3350.0, 6000.0]) / RPM)
    over = found.over
    assert over is not None
    asked = np.searchsorted(over.speeds, found.asked)
    place = over.orders.tolist().index(1.5)
    wanted = np.sqrt((np.abs(over.ground_force[asked, place, :3]) ** 2).sum(axis=-1) / 2)
    assert curve.values == pytest.approx(wanted)


@pytest.mark.parametrize("speed", [None, 2000 / RPM])
def test_a_sweep_at_one_speed_tells_vibration_at_this_speed(speed: float | None) -> None:
    """Without a speed it is the maximum over those of the file; both are said."""
    how: dict[str, Any] = {} if speed is None else {"speed": speed}
    made = crankstar.sweep(mounted(), "mounts[3].z=-400..-300 mm/2", **how)
    curve = crankstar.watched(made, "mount_force")
    moved = [THREE[0], THREE[1], THREE[2] | {"z": "-400 mm"}]
    over = crankstar.mounts(mounted(mounts=moved), speeds=[*how.values()]).value.over
    sizes = rms(over.ground_force[..., :3])
    assert (len(sizes) == 1) is (speed is not None)
    assert curve.values[0] == pytest.approx(sizes.max(), rel=1e-6)
    assert facts(made, [curve])["maximum_over_speeds"] is (speed is None)
    at = "the maximum over the speeds of the file" if speed is None else "that at 2000 rpm"
    lines = " ".join(line for part in notes(made, [curve]) for line in part.lines)
    assert f"Forced vibration is {at}." in lines


def test_a_sweep_of_mounts_says_what_is_missing() -> None:
    with pytest.raises(SweepError, match="mounts"):
        crankstar.watched(crankstar.sweep("i4", "balance_factor=0..1/2"), "mount_force")
    made = crankstar.sweep(mounted(), "balance_factor=0..1/2")
    with pytest.raises(SweepError, match="has no orders"):
        crankstar.watched(made, "mount_mode_1", order=2)
    still = engine_of(spoilt(SHORT, block=BLOCK, mounts=THREE))
    with pytest.raises(SweepError, match="needs a speed"):
        crankstar.watched(crankstar.sweep(still, "balance_factor=0..1/2"), "mount_velocity")


@pytest.mark.release
def test_the_report_has_a_chapter_on_the_mounts(run: Run, tmp_path: Path) -> None:
    place = written(tmp_path)
    ran = run("report", place, "-o", str(tmp_path / "report.html"))
    assert ran.code == 0, ran.err
    text = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert "On its mounts" in text
    assert "The mounts from the front, from above and from the side." in text
    assert "Force on the ground over the speed." in text


@pytest.mark.release
def test_an_estimated_engine_on_mounts_has_ranges(run: Run, tmp_path: Path) -> None:
    guessed = spoilt(SHORT, block=BLOCK, mounts=THREE, gas=GAS)
    for key in ("rod_length", "reciprocating_mass", "rotating_mass"):
        guessed["cylinder"].pop(key, None)
    place = tmp_path / "guessed.json"
    place.write_text(json.dumps(guessed), encoding="utf-8")
    text = said(run, "verdict", str(place), "--estimate")
    part = text.partition("shakes most at")[2].partition("rms")[0]
    assert " to " in part or "estimated" in part


@pytest.mark.release
def test_points_of_block_and_frame_are_told_with_their_worst(run: Run, tmp_path: Path) -> None:
    below = [{"name": "bar end", "up": "300 mm", "right": "-400 mm"}]
    more = {"block": {**BLOCK, "points": GRIPS}, "foundation": {**GROUND, "points": below}}
    place = written(tmp_path, **more)
    out = json.loads(run("mounts", place, "--speed", "2000 rpm", "--json").out)
    found = crankstar.mounts(mounted(**more), speed=2000 / RPM)
    over, at = found.over, found.at
    assert over is not None
    assert at is not None
    names = [row["name"] for row in out["points"]]
    assert names == ["left grip", "seat", "foundation: bar end"]
    for row, there, own, of in zip(
        out["points"],
        out["points_at_speed"],
        [(0.5, 0.35, 0.2), (0.4, 0.0, -0.6), (0.3, -0.4, 0.0)],
        [0, 0, 1],
        strict=True,
    ):
        weighted = rms(over.hand_arm(own, of=of))
        assert row["hand_arm_rms"] == pytest.approx(weighted.max())
        assert row["hand_arm_rpm"] == pytest.approx(over.speeds[np.argmax(weighted)] * RPM)
        assert row["velocity_rms"] == pytest.approx(1e3 * rms(over.velocity(own, of=of)).max())
        assert there["acceleration_rms"] == pytest.approx(rms(at.acceleration(own, of=of))[0])
    assert "W_h of ISO 5349-1" in said(run, "mounts", place)
    assert "foundation: bar end" in run("mounts", place).out
    again = engine_of(crankstar.files.tree_of(toml(mounted(**more))))
    assert again.foundation == mounted(**more).foundation
