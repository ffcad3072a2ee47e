"""The renderers: what they write of one and the same table."""

from __future__ import annotations

import csv
import io
import json

import numpy as np
import openpyxl
import pytest

from crankstar import load, spectra, total
from crankstar.analysis.document import Column, Document, Table
from crankstar.mechanics.balance import balance
from crankstar.mechanics.excitation import rolling_moment
from crankstar.tables.arrow import arrow_table, parquet_bytes
from crankstar.tables.balance_orders import answer
from crankstar.tables.html import document_html
from crankstar.tables.machine import columns, csv_text, json_text, tree
from crankstar.tables.spreadsheet import spreadsheet_bytes

NAMES = ("i4", "vw-vr6", "audi-25-tfsi", "kr250-racer", "napier-deltic")


@pytest.mark.many(first=2)
@pytest.mark.parametrize("name", NAMES)
def test_json_has_torque_rolling_moment_rotation_and_amplitudes(name: str) -> None:
    engine = load(name)
    result = balance(engine, speed=engine.speed)
    found = json.loads(json_text(tree(answer(engine, result))))
    assert found["format"] == 2
    assert found["rotation"] == engine.rotation
    sums = total(result)
    signals = {"roll": rolling_moment(sums), "torque": sums.torque, "axis_moment": sums.axis_moment}
    for row in found["orders"]:
        for key, signal in signals.items():
            expected = spectra.amplitude(spectra.selected(signal, [row["order"]]))[0]
            assert complex(*row[key]) == pytest.approx(complex(expected), rel=1e-12)
        for name_ in ("force", "couple"):
            forward, backward = (complex(*row[name_][way]) for way in ("forward", "backward"))
            whole = {"vertical": spectra.vertical, "horizontal": spectra.horizontal}
            one = spectra.selected(getattr(sums, name_), [row["order"]])
            for way, part in whole.items():
                wave = row[name_][way]
                value = wave["amplitude"] * np.exp(1j * np.radians(wave["phase_deg"]))
                assert value == pytest.approx(complex(part(one)[0]), abs=1e-9 * abs(value) + 1e-12)
            assert row[name_]["greatest"] == pytest.approx(abs(forward) + abs(backward))


@pytest.mark.release
def test_csv_spreadsheet_and_arrow_hold_the_same_rows() -> None:
    engine = load("vw-vr6")
    document = answer(engine, balance(engine))
    table = next(document.tables)
    heads, rows = columns(table)
    read = list(csv.reader(io.StringIO(csv_text(table))))
    assert read[0] == heads
    assert [[float(one) for one in row] for row in read[1:]] == rows
    sheet = openpyxl.load_workbook(io.BytesIO(spreadsheet_bytes(document)))["orders"]
    first, *body = sheet.iter_rows(values_only=True)
    assert list(first) == heads
    for ours, theirs in zip(rows, body, strict=True):
        assert theirs == pytest.approx(ours, rel=1e-14)
    arrow = arrow_table(table)
    assert arrow.column_names == heads
    assert arrow.column(0).to_pylist() == [row[0] for row in rows]
    assert parquet_bytes(table)[:4] == b"PAR1"


def test_text_in_html_is_escaped_and_text_in_csv_is_no_formula() -> None:
    table = Table("a < b", (Column("name", kind="text", key="name"),), (("=1+1 <script>",),))
    assert "<script>" not in document_html(Document("<x>", (table,)))
    assert csv_text(table).splitlines()[1].startswith("'=1+1")


def test_a_row_that_does_not_fit_its_columns_is_refused() -> None:
    with pytest.raises(ValueError, match="does not fit"):
        Table("", (Column("one"),), ((1.0, 2.0),))


def test_a_sheet_for_readers_has_units_both_parts_of_a_vector_and_the_notes() -> None:
    columns = (Column("part", kind="text"), Column("force", "N", kind="vector"))
    table = Table("Forces", columns, (("piston", 3.0 - 4.0j),), notes=("Up is away from it.",))
    sheet = openpyxl.load_workbook(io.BytesIO(spreadsheet_bytes(Document("", (table,)))))["Forces"]
    heads, row, *rest = sheet.iter_rows(values_only=True)
    assert heads == ("part", "force [N], up", "force [N], right")
    assert row == ("piston", 3, -4)
    assert [cells[0] for cells in rest if cells[0]] == ["Up is away from it."]
