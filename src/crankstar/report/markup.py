"""Tables and sentences of the terminal as HTML, and drawings of the program as parts of a page. Every text is escaped."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from html import escape

from rich.console import Group
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from crankstar.quantity import CONTROL

NUMBER = re.compile(r"[-−+]?\d[\d.,]*(e[-+]?\d+)?([ \d.°∠–−-]*)?")
"""What stands to the right in its column."""
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


def _power(found: re.Match[str]) -> str:
    return f"{found.group(1)}·10{str(int(found.group(2))).translate(RAISED)}"


def paragraph(words: object, kind: str = "") -> str:
    """A paragraph, of a kind that the style sheet knows."""
    return f"<p{_class(kind)}>{typeset(words)}</p>" if str(words).strip() else ""


def listing(items: Sequence[object]) -> str:
    """A list with bullets."""
    return f"<ul>{''.join(f'<li>{typeset(item)}</li>' for item in items)}</ul>" if items else ""


def table(heads: Sequence[object], rows: Sequence[Sequence[object]], *, title: str = "", kinds: Sequence[str] = ()) -> str:
    """A table under its title; columns of numbers stand to the right. `kinds` are the classes of rows, one for each."""
    right = [all(NUMBER.fullmatch(str(row[place])) for row in rows if str(row[place])) for place in range(len(heads))]
    return _table(heads, rows, ["r k" if side else "k" for side in right], title=title, kinds=kinds)


def of(renderable: object) -> str:
    """What the terminal is shown as HTML: groups, lines of text, tables under their titles.

    >>> of(Group(Text("Weights", style="bold"), Text("none < one")))
    '<h3>Weights</h3><p>none &lt; one</p>'
    """
    out: list[str] = []
    title = ""
    for part in _parts(renderable):
        if isinstance(part, Table):
            out.append(_of_table(part, title))
            title = ""
        elif part.style == "bold" and "\n" not in part.plain:
            out.append(f"<h3>{text(title)}</h3>" if title else "")
            title = part.plain
        else:
            out.append(f"<h3>{text(title)}</h3>" if title else "")
            title = ""
            out += _lines(part)
    return "".join(out) + (f"<h3>{text(title)}</h3>" if title else "")


def _parts(renderable: object) -> Iterator[Text | Table]:
    """The texts and tables of a renderable, one after the other, without the blank lines."""
    if isinstance(renderable, Group):
        for part in renderable.renderables:
            yield from _parts(part)
    elif isinstance(renderable, Padding):
        yield from _parts(renderable.renderable)
    elif isinstance(renderable, Table):
        yield renderable
    elif isinstance(renderable, Text):
        if renderable.plain.strip():
            yield renderable
    else:
        yield Text(str(renderable))


def _lines(part: Text) -> list[str]:
    """Each line of a text as a paragraph, those that begin with a hyphen as a list."""
    out: list[str] = []
    items: list[str] = []
    for line in part.split("\n"):
        if line.plain.startswith("- "):
            items.append(line.plain[2:])
            continue
        doubtful = any(str(span.style) == "yellow" for span in line.spans)
        out.append(paragraph(line.plain, "doubt" if doubtful else "note" if part.style == "dim" else ""))
    return [*out, listing(items)]


def _of_table(shown: Table, title: str) -> str:
    columns = [list(column.cells) for column in shown.columns]
    rows = list(zip(*columns, strict=True))
    heads = [column.header for column in shown.columns]
    return _table(
        heads,
        rows,
        [("r " if column.justify == "right" else "") + ("k" if column.no_wrap else "") for column in shown.columns],
        title=title,
        kinds=[str(row.style or "") for row in shown.rows],
    )


def _table(
    heads: Sequence[object], rows: Sequence[Sequence[object]], sides: Sequence[str], *, title: str, kinds: Sequence[str]
) -> str:
    """`sides` are the classes of the columns: r for those that stand to the right, k for those that are kept on one line."""
    above = "".join(
        f'<th scope="col"{_class(side)}>{_cell(head)}</th>' if str(head).strip() else "<td></td>"
        for head, side in zip(heads, sides, strict=True)
    )
    body = ""
    for place, row in enumerate(rows):
        cells = "".join(f"<td{_class(side)}>{_cell(cell)}</td>" for cell, side in zip(row, sides, strict=True))
        body += f"<tr{_class(kinds[place] if place < len(kinds) else '')}>{cells}</tr>"
    above_it = f"<h3>{typeset(title)}</h3>" if title else ""  # a caption would be as narrow as the table
    label = f' role="region" tabindex="0" aria-label="{text(title or "table")}"'
    thead = f"<thead><tr>{above}</tr></thead>" if any(str(head).strip() for head in heads) else ""
    kind = "table" + (" short" if len(rows) <= SHORT else "") + (" broad" if len(heads) >= BROAD else "")
    return f'{above_it}<div class="{kind}"{label}><table>{thead}<tbody>{body}</tbody></table></div>'


def _cell(cell: object) -> str:
    return typeset(cell).replace("\n", "<br>")


def _class(kind: str) -> str:
    return f' class="{text(kind)}"' if kind else ""


def section(title: str, body: str, *, name: str) -> str:
    """A section of the report under its title; `name` is what its address ends in."""
    return f'<section id="{text(name)}"><h2>{text(title)}</h2>{body}</section>' if body else ""


def figure(drawing: str, caption: str, kind: str = "") -> str:
    """A drawing in the colours of the page with a line under it."""
    return f"<figure{_class(kind)}>{drawing}<figcaption>{typeset(caption)}</figcaption></figure>"


def figures(drawn: Sequence[str], kind: str = "") -> str:
    """Figures side by side where there is room."""
    return f'<div class="figures{f" {kind}" if kind else ""}">{"".join(drawn)}</div>' if drawn else ""
