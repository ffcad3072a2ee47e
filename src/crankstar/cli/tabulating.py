"""A Document written as asked for: tables for readers, JSON, CSV, a spreadsheet or Parquet."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from crankstar.cli.output import display, working, write, write_bytes
from crankstar.language.messages import _, language, spoken

if TYPE_CHECKING:
    from crankstar.analysis.assumptions import Answer, Assumption
    from crankstar.analysis.document import Document
    from crankstar.engine.engine import Engine

MACHINE = ("json", "csv", "parquet")
"""Forms of tables that programs read."""


@contextmanager
def words_for(form: str) -> Iterator[None]:
    """Have words in the reader's language, or in English in a form that programs read."""
    with spoken("en" if form in MACHINE else language()):
        yield


def resting_on(
    form: str, engine: Engine, answer: Callable[[], Answer]
) -> Callable[[], Sequence[Assumption]] | None:
    """What an answer rests on, to be computed once it stands; None in a form of tables alone."""
    if form in ("csv", "parquet"):
        return None

    def rests() -> Sequence[Assumption]:
        from crankstar.studies.answers import rests_on

        with working(_("Trying what is assumed ...")):
            return rests_on(engine, answer())

    return rests


def give(
    document: Document, path: str | None, *, form: str, tree: Mapping[str, Any] | None = None
) -> None:
    """Write a document in a form of TABLES to a file or to standard output.

    CSV and Parquet hold its tables for machines, of several each under the one before; a
    spreadsheet also the engine file `tree`.
    """
    if form == "txt":
        display(document, path)
        return
    from crankstar.tables import machine

    keyed = [table for table in document.for_machines.tables if table.key]
    filled = [table for table in keyed if table.rows]
    table = machine.stacked(filled) if len(filled) > 1 else next(iter([*filled, *keyed]), None)
    if form == "json":
        write(machine.json_text(machine.tree(document)), path)
    elif form == "xlsx":
        from crankstar.files.sheets import sheets_of
        from crankstar.tables.spreadsheet import spreadsheet_bytes

        engine = [] if tree is None else sheets_of(tree)
        write_bytes(spreadsheet_bytes(document, engine), path)
    elif table is not None and form == "parquet":
        from crankstar.tables.arrow import parquet_bytes

        write_bytes(parquet_bytes(table), path)
    else:
        write("" if table is None else machine.csv_text(table), path)
