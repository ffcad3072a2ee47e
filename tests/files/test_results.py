"""What the function of an analysis gives: numbers, frames, arrays, figures, and its JSON."""

from __future__ import annotations

import copy
import inspect
import json
import math
import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from tests.commands import Run

import crankstar
from crankstar.analysis.frames import with_unit

TWISTING: dict[str, Any] = {
    "inertia": "0.01 kg*m^2",
    "stiffness": "0.6 MN*m/rad",
    "disc": [{"name": "wheel", "inertia": "0.2 kg*m^2", "to": "rear", "stiffness": "1 MN*m/rad"}],
}
PLACES = (("left", "-0.4 m", "0 m"), ("right", "0.4 m", "0 m"), ("rear", "0 m", "-0.3 m"))
RUBBER = [{"name": n, "right": r, "z": z, "stiffness": "90 N/mm"} for n, r, z in PLACES]
CHANGES: dict[str, Any] = {"torsion": TWISTING, "mounts": RUBBER, "block": {"mass": "150 kg"}}


@pytest.fixture(scope="module")
def five() -> Any:
    return crankstar.load("audi-25-tfsi", changes=CHANGES)


@pytest.fixture(scope="module")
def twisting(five: Any) -> Any:
    return crankstar.torsion(five, speeds="2000..6500 rpm/10", orders="2.5,5")


@pytest.mark.many(first=3)
@pytest.mark.parametrize("name", ["genset", "torque", "marine", "torsion", "mounts", "bearings"])
def test_every_analysis_gives_what_its_command_prints(name: str, five: Any, run: Run) -> None:
    Path("five.toml").write_text(crankstar.files.toml(five), encoding="utf-8")
    printed = json.loads(run(name, "five.toml", "--json").out)
    result = getattr(crankstar, name)("five.toml")
    assert json.loads(json.dumps(result.to_dict())) == printed
    first, *_others = result.tables.values()
    assert len(result.to_frame()) == len(first.rows)
    assert result.rests_on
    assert "<table" in result._repr_html_()
    assert name in repr(result)


@pytest.mark.release
def test_columns_carry_their_units(twisting: Any) -> None:
    table = twisting.criticals.to_frame()
    assert {"speed_rpm", "torque_N_m", "equilibrium_deg"} <= {*table.columns}
    rows = twisting.to_dict()["criticals"]
    assert table["speed_rpm"].tolist() == [row["speed_rpm"] for row in rows]
    assert table.attrs["units"]["torque_N_m"] == "N*m"
    assert twisting.modes.to_frame()["frequency_hz"][0] == pytest.approx(
        twisting.modes[0].speed / (2 * math.pi)
    )
    assert with_unit("frequency_hz", "Hz") == "frequency_hz"
    assert with_unit("damping", "N*m*s/rad") == "damping_N_m_s_per_rad"


def test_the_torque_of_the_array_swings_as_far_as_the_table_says(twisting: Any) -> None:
    """The peak of the sum of all orders, from the complex amplitudes, sampled finely."""
    data = twisting.response.to_xarray()
    assert data.torque.dims == ("speed_rpm", "order", "section")
    assert data.torque.attrs == {"units": "N*m"}
    angles = np.arange(2880) * math.radians(720 / 2880)
    turning = np.exp(1j * np.outer(data.order.values, angles))
    peaks = np.abs(np.real(np.einsum("sox,oa->sxa", data.torque.values, turning))).max(axis=(0, 2))
    table = twisting.greatest.to_frame()
    column = next(name for name in table.columns if name.startswith("torque"))
    assert peaks == pytest.approx(table[column].to_numpy(), rel=1e-4)


def test_the_force_in_a_mount_is_that_of_its_deflection(five: Any) -> None:
    """Along up, of a mount alone under its weight: k (1 + i eta) times how far it gives."""
    result = crankstar.mounts(five, speeds="1000..6000 rpm/6", at=(0.0, 0.0, 0.0))
    data = result.over.to_xarray()
    assert {"displacement", "velocity", "force"} == {*data.data_vars}
    rate = data.speed_rpm * math.pi / 30 * data.order
    assert np.allclose(data.velocity, 1j * rate * data.displacement)
    assert [*data.mount.values] == ["left", "right", "rear"]
    assert data.displacement.sel(axis="up").shape == (data.sizes["speed_rpm"], data.sizes["order"])


@pytest.mark.release
def test_parts_are_records_and_rows(twisting: Any) -> None:
    assert twisting.criticals[0] == twisting.value.criticals[0]
    assert len([*twisting.modes]) == len(twisting.modes)
    assert twisting.greatest[0].keys() == twisting.to_dict()["greatest"][0].keys()
    assert copy.copy(twisting).modes[0].number == copy.deepcopy(twisting).modes[0].number == 1
    assert pickle.loads(pickle.dumps(twisting)).to_dict() == twisting.to_dict()  # noqa: S301
    assert {twisting: 1}[twisting] == 1
    assert {"criticals", "greatest", "to_frame", "chain"} <= {*dir(twisting)}
    with pytest.raises(AttributeError, match="the result of torsion has no 'nothing'"):
        twisting.nothing  # noqa: B018
    with pytest.raises(ValueError, match='no table "nothing"; there are: masses, sections'):
        twisting.to_frame("nothing")
    with pytest.raises(ValueError, match="greatest has no dimensions"):
        twisting.greatest.to_xarray()
    with pytest.raises(ValueError, match="genset has no array"):
        crankstar.genset("audi-25-tfsi").to_xarray()


@pytest.mark.release
def test_a_figure_is_that_of_the_question(twisting: Any) -> None:
    own = twisting.plot("response")
    assert own.to_dict() == twisting.plot("torsion-response").to_dict()
    assert "2.5" in json.dumps(own.to_dict())
    speeds = json.dumps(twisting.plot("campbell", orders=[7.5]).to_dict())
    assert "7.5" in speeds
    with pytest.raises(ValueError, match='no figure "nothing"; there are: torsion-modes, campbell'):
        twisting.plot("nothing")


@pytest.mark.release
def test_a_figure_that_would_show_something_else_is_refused(five: Any) -> None:
    """The figures of torsion know no misfire; a number of modes only chooses what is listed."""
    dead = crankstar.torsion(five, off=[3], speeds="2000..3000 rpm/3")
    with pytest.raises(ValueError, match="torsion-response would not show off;"):
        dead.plot("response")
    listed = crankstar.torsion(five, modes=2, speed="3000 rpm", speeds="2000..3000 rpm/3")
    assert listed.plot("campbell").to_dict()["$schema"]


def test_estimates_have_ranges_and_a_drive_line_has_modes() -> None:
    table = crankstar.genset("toyota-1uz-fe", estimate=True).to_frame("sums")
    assert {"one_low", "one_high", "one_estimated"} <= {*table.columns}
    assert (table["one_low"].to_numpy() <= table["one_high"].to_numpy()).all()
    discs = [
        {"name": "motor", "inertia": "2 kg*m^2"},
        {"name": "fan", "inertia": "3 kg*m^2", "to": "motor", "stiffness": "6 kN*m/rad"},
    ]
    drive = crankstar.torsion({"name": "fan drive", "disc": discs})
    assert drive.modes[0].speed == pytest.approx(math.sqrt(6e3 * (1 / 2 + 1 / 3)))
    shapes = drive.shapes.to_xarray()
    assert shapes["shape"].sel(mode=1).values == pytest.approx([1, -2 / 3])
    with pytest.raises(TypeError, match="mounts takes an engine, not a drive line"):
        crankstar.mounts({"name": "fan drive", "disc": discs})


def test_its_signature_is_what_may_be_asked() -> None:
    signature = inspect.signature(crankstar.torsion)
    assert [*signature.parameters] == [
        *("engine", "point", "speed", "speeds", "orders", "modes", "holzer"),
        *("off", "weaker", "changes", "estimate"),
    ]
    assert "modes: How many modes" in (crankstar.torsion.__doc__ or "")
    call: Any = crankstar.torsion
    for wrong in (2.5, True, "many"):
        with pytest.raises(TypeError, match="modes takes a whole number"):
            call("cadillac-ld8", modes=wrong)
    with pytest.raises(TypeError, match="torsion takes engine by position; give the others by"):
        call("cadillac-ld8", "6000 rpm")
    with pytest.raises(ValueError, match=r"^holzer 50: there are 4 modes"):
        crankstar.torsion("cadillac-ld8", holzer=50)


def test_the_pressures_of_the_array_make_its_torque() -> None:
    """Mean torque of a chamber: the work of its pressure over the volume, over the cycle angle."""
    found = crankstar.torque("audi-25-tfsi")
    torque, pressure = found.to_xarray(), found.to_xarray("pressure").pressure
    assert torque.torque.dims == ("chamber", "order")
    assert pressure.dims == ("chamber", "theta_deg")
    assert float(pressure.max()) == pytest.approx(found.to_dict()["peak_pressure"], rel=2e-5)
    assert float(torque["mean"].sum()) == pytest.approx(found.to_dict()["mean_torque"], rel=1e-12)
    whole = np.abs(torque.torque.sum("chamber").sel(order=2.5).item())
    [row] = [row for row in found.to_dict()["orders"] if row["order"] == 2.5]
    assert whole == pytest.approx(abs(complex(*row["gas"])), rel=1e-9)


@pytest.mark.release
def test_the_loads_of_the_array_are_as_great_as_the_table_says() -> None:
    """Every degree misses a maximum by less than 1 % of it; orders add up to the same load."""
    found = crankstar.bearings("audi-25-tfsi", gas=True, speed="3000 rpm")
    for part in ("bearings", "pins", "guides"):
        data = found.to_xarray(part)
        assert data.vertical.dims[1] == "theta_deg"
        assert data.theta_deg.size == 720
        most = np.hypot(data.vertical, data.horizontal).max("theta_deg").values
        listed = [row["peak"]["value"] for row in found.to_dict()[part]]
        assert most == pytest.approx(listed, rel=1e-2)
        assert (most <= np.array(listed) * (1 + 1e-9)).all()
    orders = found.orders.to_xarray()
    turning = np.exp(1j * orders.order * math.radians(33.0))
    there = (orders.vertical * turning).sum("order").values.real
    assert there == pytest.approx(found.to_xarray().vertical.sel(theta_deg=33.0).values, rel=1e-9)


def test_the_arrays_of_a_torque_say_what_was_asked_and_what_they_are() -> None:
    """The spectra are those of the table by order; gas and inertia add up to both together."""
    found = crankstar.torque("audi-25-tfsi", off=[2], point="most torque")
    data, waves = found.to_xarray(), found.to_xarray("spectra")
    assert list(data.attrs["off"]) == [2]
    assert (data.attrs["point"], data.attrs["speed_rpm"]) == ("most torque", 5300.0)
    assert data.torque.attrs == {"units": "N*m", "long_name": "gas torque"}
    assert (waves.gas + waves.inertia).values == pytest.approx(waves.together.values, rel=1e-9)
    whole = data.torque.sum("chamber").sel(order=2.5).item()
    assert waves.gas.sel(order=2.5).item() == pytest.approx(whole, rel=1e-9)
    assert {one.attrs["units"] for one in waves.data_vars.values()} == {"N*m"}
    assert waves["roll"].attrs["long_name"] == "rolling moment on the block"
    assert found.to_xarray("pressure").theta_deg.attrs["units"] == "deg"
    motored = crankstar.torque("audi-25-tfsi", motored=True).to_xarray()
    assert motored.attrs["motored"] == 1
    assert "off" not in motored.attrs
    weak = crankstar.torque("audi-25-tfsi", weaker={3: 0.25, 5: 0.5}).to_xarray()
    assert weak.attrs["weaker"] == "3=0.25, 5=0.5"


def test_speeds_of_arrays_are_those_that_were_asked_for() -> None:
    """1500 rpm by way of radians per second is 1499.9999999999998, which nobody finds."""
    six = Path(__file__).parents[1] / "cases" / "torsion-six.toml"
    data = crankstar.torsion(six, speeds="500..1500 rpm by 500").to_xarray()
    assert {500.0, 1000.0, 1500.0} <= {*data.speed_rpm.values.tolist()}
    assert data.attrs["speed_rpm"] == 1500.0
