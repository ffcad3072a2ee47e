"""Torsion of a family: the same as an engine file of each number given to the verb torsion."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run
from tests.marine import SEVEN, marine_engine

import crankstar
from crankstar.analyses.guide.engine_family import with_cylinders
from crankstar.analyses.guide.family_torsion import not_grown, with_throws
from crankstar.engine.engine import Engine
from crankstar.files import engine_of, toml

LINE: list[dict[str, Any]] = [
    {"name": "flywheel", "inertia": "6 t*m^2", "to": "rear", "stiffness": "900 MN*m/rad"},
    {"name": "propeller", "inertia": "40 t*m^2", "to": "flywheel", "stiffness": "60 MN*m/rad"},
    {"name": "damper", "inertia": "3 t*m^2", "to": "throw 1", "stiffness": "50 MN*m/rad"},
]
ALIKE: dict[str, Any] = {
    "inertia": "9 t*m^2",
    "stiffness": "1100 MN*m/rad",
    "loss_factor": 0.02,
    "disc": LINE,
}
FRONT: dict[str, Any] = {**ALIKE, "disc": [*LINE[:2], {**LINE[2], "to": "front"}]}
BARE: dict[str, Any] = {
    "bare_inertia": ["7 t*m^2"] * 7,
    "stiffness": ["900 MN*m/rad"] * 6,
    "disc": [{**LINE[0], "to": "throw 7"}],
}

RIGID: dict[str, Any] = {
    **ALIKE,
    "disc": [
        {"name": "flywheel", "inertia": "6 t*m^2", "to": "throw 7"},
        {"name": "propeller", "inertia": "40 t*m^2", "to": "flywheel", "stiffness": "60 MN*m/rad"},
    ],
}


def file_of(folder: Path, torsion: dict[str, Any], **changes: Any) -> str:
    path = folder / "engine.toml"
    path.write_text(toml(marine_engine(torsion=torsion, **changes)))
    return str(path)


@pytest.mark.release
@pytest.mark.parametrize(
    "torsion", [ALIKE, FRONT, BARE, RIGID], ids=["alike", "front", "bare", "rigid"]
)
def test_torsion_is_that_of_the_engine_written_with_as_many_cylinders(
    run: Run, tmp_path: Path, torsion: dict[str, Any]
) -> None:
    given = ("--numbers", "5,6,8", "--given", "1-4-3-2-5")
    out = run("guide", file_of(tmp_path, torsion), *given, "--json").out
    for row in json.loads(out)["members"]:
        count, order = row["cylinders"], row["x_order"]
        own = {**torsion, "disc": [{**each} for each in torsion["disc"]]}
        for name in ("bare_inertia", "stiffness"):
            if isinstance(own.get(name), list):
                own[name] = own[name][0]
        for disc in own["disc"]:
            disc["to"] = disc["to"].replace("throw 7", f"throw {count}")
        place = file_of(tmp_path, own, firing_order=row["firing_order"])
        asked = ("--orders", f"{order:g}", "--speeds", "5..500 rpm by 5")
        found = json.loads(run("torsion", place, *asked, "--json").out)
        first = found["modes"][0]
        assert row["torsion_shape"] == "mode 1"
        assert row["natural_frequency"] == pytest.approx(first["frequency_hz"])
        critical = next(each for each in found["criticals"] if each["mode"] == 1)
        assert row["torsion_sum"] == pytest.approx(critical["vector_sum"])
        ahead = sum(disc["to"] == "front" for disc in own["disc"])
        shape = first["shape"][ahead : ahead + count]
        later = {number: at for at, number in enumerate(row["firing_order"])}
        phases = [2 * np.pi * later[number] / count for number in range(1, count + 1)]
        wanted = abs(sum(a * np.exp(1j * order * p) for a, p in zip(shape, phases, strict=True)))
        assert row["torsion_sum"] == pytest.approx(wanted, abs=1e-9)


@pytest.mark.release
def test_without_a_chain_a_straight_shape_counts_and_says_so(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "seven.toml"
    place.write_text(toml(marine_engine()))
    row = json.loads(run("guide", str(place), "--numbers", "7", "--json").out)["members"][0]
    assert (row["torsion_shape"], row["natural_frequency"]) == ("straight", None)
    later = {number: at for at, number in enumerate(row["firing_order"])}
    wanted = sum(
        (4 - number) / 3 * np.exp(2j * np.pi * row["x_order"] * later[number] / 7)
        for number in range(1, 8)
    )
    assert row["torsion_sum"] == pytest.approx(abs(wanted))
    text = " ".join(run("guide", str(place), "--numbers", "7").out.split())
    assert "straight" in text
    assert "the engine file has no table [torsion]." in text


@pytest.mark.release
def test_a_chain_with_unequal_throws_is_that_of_its_own_number_alone(
    run: Run, tmp_path: Path
) -> None:
    unequal = {**ALIKE, "inertia": ["9 t*m^2"] * 6 + ["12 t*m^2"]}
    place = file_of(tmp_path, unequal)
    rows = json.loads(run("guide", place, "--numbers", "6,7", "--json").out)["members"]
    shapes = {(row["cylinders"], row["torsion_shape"]) for row in rows}
    assert shapes == {(6, "straight"), (7, "mode 1")}
    found = json.loads(run("torsion", place, "--json").out)
    assert rows[1]["natural_frequency"] == pytest.approx(found["modes"][0]["frequency_hz"])
    text = " ".join(run("guide", place, "--numbers", "6,7").out.split())
    assert "the throws differ, so that the chain fits 7 cylinders alone" in text


def test_what_hangs_between_the_ends_is_named() -> None:
    inner = {**ALIKE, "disc": [{**LINE[0], "name": "chain wheel", "to": "throw 4"}]}
    engine = marine_engine(torsion=inner)
    assert "chain wheel" in not_grown(engine, 6)
    assert with_throws(engine, 6) is None
    assert with_throws(engine, 7) is not None


def place_of(engine: Engine, folder: Path) -> str:
    path = folder / "made.toml"
    path.write_text(toml(engine))
    return str(path)


def test_a_grown_engine_can_be_written_and_read(tmp_path: Path) -> None:
    made = with_cylinders(marine_engine(torsion=ALIKE), [1, 4, 3, 2, 5])
    written = engine_of({**SEVEN, "firing_order": [1, 4, 3, 2, 5], "torsion": ALIKE})
    assert made.torsion is not None
    assert written.torsion is not None
    assert made.torsion.discs == written.torsion.discs
    again = crankstar.load(place_of(made, tmp_path))
    assert again.torsion == made.torsion
