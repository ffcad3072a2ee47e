"""A Table as an Apache Arrow table, which gives data frames and Parquet files; needs pyarrow."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

from crankstar.analysis.document import Table
from crankstar.tables.machine import columns

if TYPE_CHECKING:
    import pyarrow


def arrow_table(table: Table) -> pyarrow.Table:
    """The columns that machines read; `arrow_table(table).to_pandas()` is a data frame.

    Raises ImportError without pyarrow.
    """
    import pyarrow

    heads, rows = columns(table)
    body = list(zip(*rows, strict=True)) if rows else [()] * len(heads)
    return pyarrow.table({head: list(column) for head, column in zip(heads, body, strict=True)})


def parquet_bytes(table: Table) -> bytes:
    """A table as an Apache Parquet file."""
    import pyarrow.parquet

    out = io.BytesIO()
    pyarrow.parquet.write_table(arrow_table(table), out)
    return out.getvalue()
