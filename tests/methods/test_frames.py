"""Data frames and data sets hold the numbers of the spectra, in memory and in netCDF."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray

from crankstar import Reference, load, spectra, total
from crankstar.mechanics.balance import Balance, Grouping, balance, grouped
from crankstar.mechanics.excitation import Totals, rolling_moment
from crankstar.studies.sweep import swept

VECTORS = {"force": "force", "couple": "couple", "pitch": "couple", "yaw": "couple"}
NAMES = ("i4", "vw-vr6", "kr250-racer", "napier-deltic")


def at_speed(name: str) -> Balance:
    engine = load(name)
    return balance(engine, speed=engine.speed or 500.0, reference=Reference(0.1, 0.02, -0.03))


def key_of(quantity: str, direction: str) -> str:
    """The variable of a data set."""
    return f"{quantity}_{direction}" if quantity in ("force", "couple") else quantity


def complex_of(frame: Any) -> np.ndarray:
    return frame["amplitude"].to_numpy() * np.exp(1j * np.radians(frame["phase_deg"].to_numpy()))


def expected(sums: Totals) -> dict[tuple[str, str], np.ndarray]:
    """The complex amplitudes by quantity and direction, from the spectra."""
    out = {
        ("force", "vertical"): spectra.vertical(sums.force),
        ("force", "horizontal"): spectra.horizontal(sums.force),
        ("pitch", "vertical"): spectra.vertical(sums.couple),
        ("yaw", "horizontal"): spectra.horizontal(sums.couple),
    }
    for name in ("force", "couple"):
        spectrum = getattr(sums, name)
        out |= {(name, "forward"): spectrum.forward, (name, "backward"): spectrum.backward}
    signals = {"roll": rolling_moment(sums), "torque": sums.torque, "axis_moment": sums.axis_moment}
    return out | {(name, "axial"): spectra.amplitude(signal) for name, signal in signals.items()}


@pytest.mark.parametrize("name", NAMES)
def test_a_frame_has_one_row_for_each_amplitude_of_the_engine(name: str) -> None:
    result = at_speed(name)
    frame = result.to_frame()
    waves = expected(total(result))
    assert len(frame) == 11 * result.force.orders.size
    for (quantity, direction), values in waves.items():
        rows = frame[(frame.quantity == quantity) & (frame.direction == direction)]
        assert rows["order"].tolist() == result.force.orders.tolist()
        assert complex_of(rows) == pytest.approx(values, rel=1e-12)
        assert set(rows["unit"]) == {getattr(result.units, VECTORS.get(quantity, "moment"))}
        assert set(rows["part"]) == {"engine"}
    assert frame.attrs["reference_z"] == 0.1
    assert frame.attrs.get("speed") == result.speed


@pytest.mark.release
@pytest.mark.parametrize("by", ["cylinder", "bank", "kind", "shaft"])
def test_a_frame_by_a_label_has_the_share_of_each(by: Grouping) -> None:
    result = at_speed("napier-deltic")
    frame = result.to_frame(by=by)
    shares = grouped(result, by)
    assert len(frame) == 11 * result.force.orders.size * len(shares)
    for label, sums in shares.items():
        own = frame[frame[by].isna()] if label is None else frame[frame[by] == label]
        for (quantity, direction), values in expected(sums).items():
            rows = own[(own.quantity == quantity) & (own.direction == direction)]
            assert complex_of(rows) == pytest.approx(values, rel=1e-12)


def test_a_frame_by_part_names_each_part() -> None:
    result = at_speed("kr250-racer")
    frame = result.to_frame(by="part")
    roll = frame[(frame.quantity == "force") & (frame.direction == "backward")]
    size = result.force.orders.size
    for row, part in enumerate(result.parts):
        own = roll[row * size : (row + 1) * size]
        assert set(own["kind"]) == {part.kind}
        assert set(own["shaft"]) == {part.shaft}
        assert {number for number in own["cylinder"] if number is not None} == (
            {part.cylinder} - {None}
        )
        assert complex_of(own) == pytest.approx(result.force.backward[row], rel=1e-12)


@pytest.mark.release
@pytest.mark.parametrize("name", NAMES)
def test_a_data_set_has_part_and_order_and_survives_netcdf(name: str, tmp_path: Path) -> None:
    result = at_speed(name)
    data = result.to_xarray()
    assert dict(data.sizes) == {"part": len(result.parts), "order": result.force.orders.size}
    assert data.attrs["reference_right"] == -0.03
    assert data["roll"].attrs["units"] == result.units.moment
    file = tmp_path / "balance.nc"
    result.to_xarray(split=True).to_netcdf(file, engine="scipy")
    with xarray.open_dataset(file, engine="scipy") as read:
        assert read["kind"].values.tolist() == [part.kind for part in result.parts]
        assert read["bank"].values.tolist() == [part.bank or "" for part in result.parts]
        assert read.attrs.get("speed") == result.speed
        parts = Totals(*(getattr(result, name) for name in Totals._fields))
        for (quantity, direction), values in expected(parts).items():
            key = key_of(quantity, direction)
            assert np.array_equal(data[key].values, values)
            both = read[key].sel(component="real") + 1j * read[key].sel(component="imag")
            assert np.array_equal(both.values, values)
            assert read[key].attrs["units"] == data[key].attrs["units"]


@pytest.mark.parametrize(
    ("over", "values"), [("balance_factor", [0.0, 0.3, 1.0]), ("cylinder.rod_ratio", [3.0, 4.5])]
)
def test_a_sweep_as_frame_and_data_set_has_every_value(
    over: str, values: list[float], tmp_path: Path
) -> None:
    sweep = swept("v2-90", over=over, values=values)
    frame, data = sweep.to_frame(), sweep.to_xarray()
    column = f"{over} [{sweep.unit}]" if sweep.unit else over
    for row, value in enumerate(values):
        sums = Totals(*(spectrum[row] for spectrum in sweep.sums))
        for (quantity, direction), expected_values in expected(sums).items():
            rows = frame[
                (frame[column] == value)
                & (frame.quantity == quantity)
                & (frame.direction == direction)
            ]
            assert complex_of(rows) == pytest.approx(expected_values, rel=1e-12)
            key = key_of(quantity, direction)
            assert np.array_equal(data[key].sel({over: value}).values, expected_values)
    sweep.to_xarray(split=True).to_netcdf(tmp_path / "sweep.nc", engine="scipy")
    with xarray.open_dataset(tmp_path / "sweep.nc", engine="scipy") as read:
        assert read[over].values.tolist() == values


@pytest.mark.parametrize(("library", "method"), [("pandas", "to_frame"), ("xarray", "to_xarray")])
def test_without_the_library_one_line_says_how_to_install_it(
    library: str, method: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    import importlib

    whole = importlib.import_module

    def missing(name: str, *rest: Any) -> Any:
        if name == library:
            raise ModuleNotFoundError(name)
        return whole(name, *rest)

    monkeypatch.setattr("crankstar.mechanics.labelled.import_module", missing)
    with pytest.raises(ImportError) as error:
        getattr(at_speed("i4"), method)()
    said = f'this needs {library}; install it with: pip install "crankstar[frames]"'
    assert str(error.value) == said
