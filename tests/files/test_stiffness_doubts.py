"""Doubts on stiffnesses of mounts, crankshafts and couplings, by closed forms and slips of unit."""

from __future__ import annotations

from math import pi
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run
from tests.laws.test_torsion_crankshafts import pair

from crankstar.analyses.mounts.figures import mounted_modes
from crankstar.dynamics.mount_doubts import mount_doubts
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.files import EngineFileError, toml
from crankstar.files.catalog import load
from crankstar.language.faults import Fault
from crankstar.mechanics.doubts import doubts
from crankstar.mechanics.stiffness_doubts import beam_doubts, twist_doubts
from crankstar.studies.assumed_values import assumed_values

pytestmark = pytest.mark.quick

MASS, G = 180.0, 9.80665
BORE = 0.0825
"""m: of the engine of the catalog."""
CORNERS = [(right, along) for right in (-0.3, 0.3) for along in (-0.25, 0.25)]


def on_four(*stiffnesses: Any, **more: Any) -> Engine:
    """A block on four mounts about its centre of mass, all alike, or each with its own."""
    each = stiffnesses * (4 if len(stiffnesses) == 1 else 1)
    mounts = [
        {"name": f"{place}", "right": f"{place[0]} m", "z": f"{place[1]} m", "stiffness": own}
        for place, own in zip(CORNERS, each, strict=True)
    ]
    inertias = {f"inertia_{name}": "20 kg*m^2" for name in ("up", "right", "z")}
    block = {"mass": f"{MASS} kg", "z": "0 m", **inertias}
    return load("audi-25-tfsi", changes={"mounts": mounts, "block": block, **more})


def told(engine: Engine) -> Fault | None:
    """The one doubt of the mounts, if there is one."""
    found = [*mount_doubts(engine)]
    assert len(found) < 2
    return found[0] if found else None


@pytest.mark.parametrize("stiffness", ["60 N/mm", "200 N/mm", "800 N/mm", "60 kN/m"])
def test_mounts_of_engines_are_not_doubted(stiffness: str) -> None:
    assert told(on_four(stiffness)) is None


@pytest.mark.parametrize("newtons", [200.0, 3000.0])
def test_newtons_per_metre_are_doubted_by_the_sag(newtons: float) -> None:
    """Four springs under the weight: m g/4k, level, since the centre of mass is in their middle."""
    found = told(on_four(f"{newtons} N/m"))
    assert found is not None
    assert (found.code, found.path) == ("doubt.mount-sag", ("mounts", 0, "stiffness"))
    assert found.values["sag"] == pytest.approx(1e3 * MASS * G / (4 * newtons), rel=5e-3)
    assert found.values["value"] == pytest.approx(newtons / 1e3)
    assert found.values["usual"] == pytest.approx(MASS * G / (4 * 0.1) / 1e3, rel=5e-2)


def test_stiff_upright_and_too_soft_sideways_is_doubted_by_the_lowest_mode() -> None:
    """Sideways sqrt(4k/m); the turn about the upright axis, with arms of 0.3 and 0.25 m."""
    found = told(on_four(*[["200 N/mm", "80 N/m", "80 N/m"]] * 4))
    assert found is not None
    assert (found.code, found.path) == ("doubt.mount-soft", ("mounts", 0, "stiffness"))
    turn = 4 * 80 * (0.3**2 + 0.25**2) / 20.0
    lowest = min(4 * 80 / MASS, turn) ** 0.5 / (2 * pi)
    assert found.values["frequency"] == pytest.approx(lowest, rel=5e-3)
    assert found.values["value"] == pytest.approx(0.08)


def test_a_slip_to_the_stiff_side_is_doubted_by_the_lowest_mode() -> None:
    """Up and sideways sqrt(4k/m), and of the turns the slowest, by k and arms again."""
    found = told(on_four("200 kN/mm"))
    assert found is not None
    assert (found.code, found.path) == ("doubt.mount-stiff", ("mounts", 0, "stiffness"))
    k = 2e8
    squares = [4 * k / MASS, *(4 * k * arm / 20.0 for arm in (0.3**2, 0.25**2, 0.3**2 + 0.25**2))]
    assert found.values["frequency"] == pytest.approx(min(squares) ** 0.5 / (2 * pi), rel=5e-3)
    wanted = 2e5 * (100 / found.values["frequency"]) ** 2
    assert found.values["usual"] == pytest.approx(wanted, rel=5e-2)


@pytest.mark.parametrize("wrong", ["150 N/m", "150 kN/mm"])
def test_one_mount_in_another_unit_is_doubted_by_the_others(wrong: str) -> None:
    found = told(on_four("150 N/mm", "120 N/mm", wrong, "150 N/mm"))
    assert found is not None
    assert (found.code, found.path) == ("doubt.mount-unlike", ("mounts", 2, "stiffness"))
    assert found.values["others"] in (120.0, 150.0)


def test_the_mounts_of_a_foundation_bear_both() -> None:
    """Their sag is that of both weights on four springs."""
    ground = [
        {"name": f"below {place}", "right": f"{place[0]} m", "z": f"{place[1]} m"}
        | {"stiffness": "5 N/mm"}
        for place in CORNERS
    ]
    inertias = {f"inertia_{name}": "80 kg*m^2" for name in ("up", "right", "z")}
    base = {"mass": "900 kg", "mounts": ground, **inertias}
    found = told(on_four("200 N/mm", foundation=base))
    assert found is not None
    path = ("foundation", "mounts", 0, "stiffness")
    assert (found.code, found.path) == ("doubt.mount-sag", path)
    assert found.values["sag"] == pytest.approx(1e3 * (MASS + 900) * G / 20e3, rel=5e-3)


def test_doubted_mounts_are_told_by_check_and_by_the_answers(run: Run, tmp_path: Path) -> None:
    place = tmp_path / "soft.toml"
    soft = with_values(on_four("200 N/m"), gas=None)
    place.write_text(toml(soft), encoding="utf-8")
    said = " ".join(run("check", str(place)).out.split())
    assert "mounts[1].stiffness is 0.2 N/mm: what stands on these mounts sits down by 2210" in said
    rests = assumed_values(soft, mounted_modes())
    assert [each.status for each in rests if each.path == "mounts[1].stiffness"] == ["doubtful"]


@pytest.mark.parametrize(
    ("beam", "support", "codes"),
    [
        ("400 kN*m^2", "500 kN/mm", []),
        ("40 kN*m^2", "5 MN/mm", []),
        ("400 N*m^2", "500 kN/mm", ["doubt.crank-beam"]),
        ("400 kN*m^2", "500 N/mm", ["doubt.crank-support"]),
        ("400 MN*m^2", "500 MN/mm", ["doubt.crank-beam", "doubt.crank-support"]),
    ],
)
def test_a_crankshaft_as_a_beam_is_compared_with_shafts_of_steel(
    run: Run, tmp_path: Path, beam: str, support: str, codes: list[str]
) -> None:
    own = {"bearing_count": 6, "bending_stiffness": beam, "bearing_stiffness": support}
    engine = load("audi-25-tfsi", changes={"crankshaft": [own]})
    found = [*beam_doubts(engine)]
    assert [fault.code for fault in found] == codes
    assert [fault.code for fault in doubts(engine) if "crank-" in fault.code] == codes
    for fault in found:
        if fault.code == "doubt.crank-beam":
            d = fault.values["diameter"] / 1e3
            own_beam = engine.shafts[0].bending_stiffness
            assert 206e9 * pi * d**4 / 64 == pytest.approx(own_beam, rel=2e-2)
            low, high = fault.values["low"], fault.values["high"]
            assert (low, high) == pytest.approx((250 * BORE, 2500 * BORE), rel=3e-2)
    place = tmp_path / "beam.toml"
    place.write_text(toml(engine), encoding="utf-8")
    said = " ".join(run("check", str(place)).out.split())
    assert said.count("is the unit right?") == len(codes)
    rests = run("bearings", str(place), "--model", "continuous", "--json").out
    assert all(fault.sentence.split(" is ")[0] in rests for fault in found)


@pytest.mark.parametrize(("stiffness", "doubted"), [(0.2, True), (20.0, False), (20e3, False)])
def test_a_coupling_softer_than_any_drive_line_is_doubted_as_a_disc_is(
    stiffness: float, doubted: bool
) -> None:
    """sqrt(k/J)/2 pi, J the 0.05 kg m^2 of the one throw that it turns."""
    coupling = [{"crankshaft": "other", "stiffness": f"{stiffness} N*m/rad"}]
    table = {"inertia": "0.05 kg*m^2", "coupling": coupling}
    engine = pair("1", torsion=table)
    assert engine.torsion is not None
    found = [*twist_doubts(engine, engine.torsion)]
    assert [fault.path for fault in found] == [("torsion", "coupling", 0, "stiffness")] * doubted
    for fault in found:
        wanted = (stiffness / 0.05) ** 0.5 / (2 * pi)
        assert fault.values["frequency"] == pytest.approx(wanted, rel=5e-3)
        assert "torsion.coupling[1].stiffness" in fault.sentence
        assert any(each.code == "doubt.soft-disc" for each in doubts(engine))


def test_a_stiffness_between_throws_where_none_has_a_neighbour_says_to_leave_it_out() -> None:
    table = {"inertia": "0.05 kg*m^2", "stiffness": "1 MN*m/rad"}
    table |= {"coupling": [{"crankshaft": "other"}]}
    with pytest.raises(EngineFileError, match="and none has two: leave it out"):
        pair("1", torsion=table)
