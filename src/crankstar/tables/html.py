"""A Document as HTML, for the report and for notebooks. Every text is escaped."""

from __future__ import annotations

import re
from collections.abc import Sequence
from html import escape

from crankstar.analysis.document import Document, Remarks, Table
from crankstar.language.quoting import CONTROL
from crankstar.tables.cells import cells, heading
from crankstar.tables.conversion import in_units

MINUS = re.compile(r"(?<![\w.\])°-])-(?=\d)")
"""A hyphen that is a sign; the one in 1-5-3 or V6-60 is none."""
POWER = re.compile(r"(?<![\w.])(-?\d+(?:\.\d+)?)e([-+]\d{2,})(?!\w)")
"""A number with an exponent, as programs write it."""
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
BROAD = 8
"""Columns from which on a table is set in smaller letters, so that it fits a page."""
SHORT = 9
"""Rows of a table that is kept on one page."""


def text(words: object) -> str:
    """Words as they are shown: escaped, with what is not printable marked."""
    return escape(CONTROL.sub("?", str(words)))


def typeset(words: object) -> str:
    """Words with numbers as they are printed: a minus is no hyphen, and powers of ten stand raised.

    >>> typeset("2 ∠ -90° of 1-5-3, 7.4e-05")
    '2 ∠ −90° of 1-5-3, 7.4·10⁻⁵'
    """
    return MINUS.sub("−", POWER.sub(_power, text(words)))


def _power(match: re.Match[str]) -> str:
    return f"{match.group(1)}·10{str(int(match.group(2))).translate(RAISED)}"


def kind_of(kind: str) -> str:
    """The attribute that gives an element its class, or nothing."""
    return f' class="{text(kind)}"' if kind else ""


def paragraph(words: object, kind: str = "") -> str:
    """A paragraph, of a kind that the style sheet knows."""
    return f"<p{kind_of(kind)}>{typeset(words)}</p>" if str(words).strip() else ""


def listing(items: Sequence[object]) -> str:
    """A list with bullets."""
    return f"<ul>{''.join(f'<li>{typeset(item)}</li>' for item in items)}</ul>" if items else ""


def document_html(document: Document) -> str:
    """The parts of a document, under its title."""
    head = f"<h2>{text(document.title)}</h2>" if document.title else ""
    return head + "".join(map(part_html, document.for_readers.parts))


def part_html(part: Table | Remarks) -> str:
    """A table, or remarks as paragraphs or a list.

    >>> part_html(Remarks(("none < one",), "Weights"))
    '<h3>Weights</h3><p>none &lt; one</p>'
    """
    if isinstance(part, Table):
        return _table(part)
    above = f"<h3>{typeset(part.title)}</h3>" if part.title else ""
    if part.kind == "list":
        return above + listing(part.lines)
    kind = {"text": "", "assumed": "doubt"}.get(part.kind, part.kind)
    return above + "".join(paragraph(line, kind) for line in part.lines)


def _table(table: Table) -> str:
    table = in_units(table.readable)
    # A caption would be as narrow as the table.
    above = f"<h3>{typeset(table.title)}</h3>" if table.title else ""
    notes = "".join(map(paragraph, table.notes))
    if not table.rows:
        return above + notes
    sides = [
        kind_of(("" if column.left else "r ") + ("" if column.wraps else "k"))
        for column in table.columns
    ]
    heads = "".join(
        f'<th scope="col"{side}>{"<br>".join(map(typeset, filter(None, heading(column))))}</th>'
        if any(heading(column))
        else "<td></td>"
        for column, side in zip(table.columns, sides, strict=True)
    )
    body = "".join(
        f"<tr{kind_of('doubt' if index in table.doubtful else '')}>"
        + "".join(f"<td{side}>{typeset(cell)}</td>" for cell, side in zip(row, sides, strict=True))
        + "</tr>"
        for index, row in enumerate(cells(table))
    )
    kind = "table" + (" short" if len(table.rows) <= SHORT else "")
    kind += " broad" if len(table.columns) >= BROAD else ""
    label = f' role="region" tabindex="0" aria-label="{text(table.title or "table")}"'
    above_body = (
        f"<thead><tr>{heads}</tr></thead>" if any(map(any, map(heading, table.columns))) else ""
    )
    inner = f"<table>{above_body}<tbody>{body}</tbody></table>"
    return f'{above}<div class="{kind}"{label}>{inner}</div>{notes}'
