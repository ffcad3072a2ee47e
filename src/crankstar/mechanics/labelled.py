"""Spectra with their labels: rows of amplitudes, pandas data frames, xarray data sets.

One law for all of them: an amplitude c of order k stands for the signal

    Re(c exp(i k theta)) = |c| cos(k theta + phase),

theta the angle of the reference crankshaft. A force has a vertical and a horizontal amplitude;
those of a couple are pitch, M_V, and yaw, M_H. Both are given once more as the two vectors that
turn forward and backward, whose phase is their bearing at theta = 0 (clockwise from up). Roll,
torque and the moment about the axis are axial. Every one of them adds up over the parts.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.language.messages import _
from crankstar.mechanics.excitation import Totals, rolling_moment
from crankstar.spectra import Complex

if TYPE_CHECKING:
    import pandas
    import xarray

VECTORS = {"force": ("force", "force"), "couple": ("pitch", "yaw")}
"""The vector quantities, and what their vertical and horizontal amplitudes are called."""
AXIAL = "axial"


class Wave(NamedTuple):
    """The complex amplitudes [..., order] of a quantity in a direction, and their unit."""

    quantity: str
    direction: str
    unit: str
    amplitude: Complex

    @property
    def name(self) -> str:
        """Quantity and direction: force_vertical, pitch, couple_forward, roll."""
        both = self.quantity in VECTORS
        return f"{self.quantity}_{self.direction}" if both else self.quantity


def waves(sums: Totals, units: Mapping[str, str]) -> Iterator[Wave]:
    """Every quantity in every direction; `units` by the names force, couple and moment."""
    for vector, (upward, rightward) in VECTORS.items():
        spectrum, unit = getattr(sums, vector), units[vector]
        yield Wave(upward, "vertical", unit, spectra.vertical(spectrum))
        yield Wave(rightward, "horizontal", unit, spectra.horizontal(spectrum))
        yield Wave(vector, "forward", unit, spectrum.forward)
        yield Wave(vector, "backward", unit, spectrum.backward)
    signals = {"roll": rolling_moment(sums), "torque": sums.torque, "axis_moment": sums.axis_moment}
    for quantity, signal in signals.items():
        yield Wave(quantity, AXIAL, units["moment"], spectra.amplitude(signal))


def columns(
    sums: Totals, units: Mapping[str, str], labels: Mapping[str, Any] | None = None
) -> dict[str, Any]:
    """The columns of a tidy table: one row an amplitude.

    `labels` name the rows of the leading axis, if the spectra have one. Then order, quantity,
    direction, amplitude, phase_deg (0 where the amplitude is) and unit.
    """
    every = [*waves(sums, units)]
    orders = sums.force.orders
    count = every[0].amplitude.size // max(orders.size, 1)
    each = count * orders.size
    out: dict[str, Any] = {
        name: np.tile(np.repeat(_column(values), orders.size), len(every))
        for name, values in (labels or {}).items()
    }
    amplitude = np.concatenate([wave.amplitude.reshape(-1) for wave in every])
    out["order"] = np.tile(orders, count * len(every))
    for name in ("quantity", "direction"):
        out[name] = np.repeat(_column([getattr(wave, name) for wave in every]), each)
    out["amplitude"] = np.abs(amplitude)
    out["phase_deg"] = np.where(amplitude == 0, 0.0, np.degrees(np.angle(amplitude)) + 0.0)
    out["unit"] = np.repeat(_column([wave.unit for wave in every]), each)
    return out


def _column(values: Any) -> np.ndarray:
    """An array that keeps texts, and None, as they are."""
    array = np.asarray(values)
    return array if array.dtype.kind in "fiu" else np.array([*values, None], object)[:-1]


def frame(columns: Mapping[str, Any], facts: Mapping[str, Any]) -> pandas.DataFrame:
    """Columns as a pandas data frame with `facts` as its attrs. Raises ImportError."""
    table = library("pandas").DataFrame(dict(columns))
    table.attrs = {name: value for name, value in facts.items() if value is not None}
    return table


def dataset(
    sums: Totals,
    units: Mapping[str, str],
    *,
    dimensions: Sequence[str],
    labels: Mapping[str, Any],
    facts: Mapping[str, Any],
    split: bool = False,
) -> xarray.Dataset:
    """Spectra as an xarray data set with the leading `dimensions`, and order.

    A variable is `force_vertical`, `pitch`, ..., `roll`, complex, with its unit in attrs; `split`
    gives real numbers with a last dimension component, real and imag, as netCDF needs. Raises
    ImportError.
    """
    variables: dict[str, Any] = {}
    for wave in waves(sums, units):
        values = wave.amplitude
        dims: tuple[str, ...] = (*dimensions, "order")
        if split:
            values = np.stack([np.real(values), np.imag(values)], axis=-1)
            dims = (*dims, "component")
        variables[wave.name] = (dims, values, {"units": wave.unit})
    coords: dict[str, Any] = {"order": sums.force.orders, **labels}
    if split:
        coords["component"] = ["real", "imag"]
    attrs = {name: value for name, value in facts.items() if value is not None}
    return library("xarray").Dataset(variables, coords, attrs)


def library(name: str) -> Any:
    """The library, pandas or xarray. Raises ImportError with the command that installs it."""
    try:
        return import_module(name)
    except ImportError:
        raise ImportError(
            _(
                'this needs {library}; install it with: pip install "crankstar[{extra}]"',
                library=name,
                extra="frames",
            )
        ) from None
