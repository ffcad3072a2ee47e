"""A Document as a spreadsheet (.xlsx), a sheet for each table; needs openpyxl."""

from __future__ import annotations

import io
import re

from crankstar.tables.machine import columns
from crankstar.tables.table import Document

LONGEST_NAME = 31
"""Letters that a sheet may have in its name."""


def spreadsheet_bytes(document: Document) -> bytes:
    """The tables of a document that machines read. Raises ImportError without openpyxl."""
    from openpyxl import Workbook

    book = Workbook(write_only=True)
    for table in document.tables:
        if table.key:
            sheet = book.create_sheet(re.sub(r"[\[\]:*?/\\]", " ", table.key)[:LONGEST_NAME])
            heads, rows = columns(table)
            sheet.append(heads)
            for row in rows:
                sheet.append(row)
    out = io.BytesIO()
    book.save(out)
    return out.getvalue()
