"""Tables as data frames and grids as data sets, their units in the names of columns and axes."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

from crankstar.mechanics.labelled import library

if TYPE_CHECKING:
    import pandas
    import xarray

    from crankstar.analysis.record import Grid


AXIS_UNITS = {"deg": "deg", "rpm": "rpm", "hz": "Hz"}
"""The unit of an axis by the end of its name."""


def with_unit(name: str, unit: str) -> str:
    """The name of a column that says its unit.

    >>> with_unit("stiffness", "kN*m/rad"), with_unit("frequency_hz", "Hz"), with_unit("order", "")
    ('stiffness_kN_m_per_rad', 'frequency_hz', 'order')
    """
    suffix = re.sub(r"[*^]", lambda sign: "_" if sign.group() == "*" else "", unit)
    suffix = suffix.replace("/", "_per_").replace("%", "percent").strip("_")
    if not suffix or name.lower().endswith(f"_{suffix.lower()}"):
        return name
    return f"{name}_{suffix}"


def frame(heads: list[str], rows: list[list[Any]], facts: Mapping[str, Any]) -> pandas.DataFrame:
    """Columns with headings such as "load [N]" as a data frame; `facts` are its attrs.

    Its attrs have the units of the columns by their names. Raises ImportError without pandas.
    """
    parts = [re.fullmatch(r"(.*?)(?: \[([^]]*)\])?", head) for head in heads]
    names = [with_unit(part[1], part[2] or "") for part in parts if part is not None]
    units = {name: part[2] for name, part in zip(names, parts, strict=True) if part and part[2]}
    table = library("pandas").DataFrame(rows, columns=names)
    table.attrs = {name: value for name, value in facts.items() if value is not None}
    table.attrs["units"] = units
    return table


def dataset(grid: Grid, facts: Mapping[str, Any]) -> xarray.Dataset:
    """A grid as a data set, units in the attrs of variables and axes. Raises ImportError."""

    def said(name: str, unit: str) -> dict[str, str]:
        own = {"units": unit, "long_name": grid.words.get(name, "")}
        return {key: text for key, text in own.items() if text}

    variables = {
        name: (axes, values, said(name, unit))
        for name, (axes, values, unit) in grid.variables.items()
    }
    axes = {
        name: (
            *(values if isinstance(values, tuple) else (name, values)),  # of another axis
            said(name, AXIS_UNITS.get(name.rpartition("_")[2], "")),
        )
        for name, values in grid.axes.items()
    }
    return library("xarray").Dataset(variables, axes, {**facts})
