"""A Document written as asked for: tables for readers, JSON, CSV, a spreadsheet or Parquet."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import PurePath
from typing import TYPE_CHECKING

from crankstar.cli.output import STANDARD_OUTPUT, display, write, write_bytes
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.options.values import RequestError

if TYPE_CHECKING:
    from crankstar.tables.table import Document

FORMS = ("csv", "json", "xlsx", "parquet", "txt")
"""The forms a document can be written in, as the ends of file names; txt is for readers."""
NEEDED = {
    "xlsx": ("openpyxl", 'pip install "crankstar[spreadsheet]"'),
    "parquet": ("pyarrow", 'pip install "crankstar[parquet]"'),
}
"""The library that a form needs, and how it is installed."""


def form_of(place: str | None, *, json: bool = False, csv: bool = False) -> str:
    """The form that is asked for, else that of the file's name, else txt. Raises RequestError."""
    if json and csv:
        raise RequestError(_("--json and --csv exclude each other"))
    if json or csv:
        return "json" if json else "csv"
    if place in STANDARD_OUTPUT:
        return "txt"
    form = PurePath(place or "").suffix.lower().removeprefix(".") or "txt"
    if form not in FORMS:
        names = ", ".join(f".{name}" for name in FORMS)
        raise RequestError(
            _("-o {file}: the name must end in {names}", file=one_line(place or ""), names=names)
        )
    library, install = NEEDED.get(form, ("", ""))
    if library and find_spec(library) is None:
        raise RequestError(
            _(
                "a .{form} file needs {library}: {install}",
                form=form,
                library=library,
                install=install,
            )
        )
    return form


def give(document: Document, place: str | None, *, form: str, beside: Sequence[str] = ()) -> None:
    """Write a document in one of FORMS to a file or to standard output.

    CSV and Parquet hold its first table for machines; CSV repeats the facts `beside` in each row.
    """
    if form == "txt":
        display(document, place)
        return
    from crankstar.tables import machine

    table = next((table for table in document.tables if table.key), None)
    facts = {name: document.facts[name] for name in beside}
    if form == "json":
        write(machine.json_text(machine.tree(document)), place)
    elif form == "xlsx":
        from crankstar.tables.spreadsheet import spreadsheet_bytes

        write_bytes(spreadsheet_bytes(document), place)
    elif table is not None and form == "parquet":
        from crankstar.tables.arrow import parquet_bytes

        write_bytes(parquet_bytes(table), place)
    else:
        write("" if table is None else machine.csv_text(table, facts), place)
