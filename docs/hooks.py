"""What the documents take from the program when they are built: tables of keys, the figure, the list of sources.

A page says `<!-- keys: vee -->` and gets the table of the keys that a `[layout]` of that kind can have, made from the record
that checks engine files; so the page cannot name a key that is not there, nor leave one out.
"""

from __future__ import annotations

import re
from fractions import Fraction
from html import escape
from pathlib import Path
from typing import Any, Literal, get_args, get_origin

from pydantic.fields import FieldInfo

from crankstar import engine, layouts
from crankstar.arrangement import Override, Sizes
from crankstar.engine import Record
from crankstar.files.forms import by_key, quantity_of, record_in, short_form

HERE = Path(__file__).parent


def _layout(kind: str) -> type[Record]:
    record = record_in(short_form(kind).model_fields["layout"].annotation)
    if record is None:
        raise TypeError(f"the layout {kind} has no record")
    return record


TABLES: dict[str, type[Record]] = {
    "short": short_form(None),
    "cylinder": Sizes,
    "override": Override,
    "rod": engine.Rod,
    "articulated": engine.Articulation,
    "provenance": engine.Provenance,
    **{kind: _layout(kind) for kind in layouts.LAYOUTS},
    "bank": layouts.Bank,
    "crank": layouts.Crank,
    "row": layouts.Row,
    "explicit": engine.Engine,
    "shaft": engine.Shaft,
    "throw": engine.Throw,
    "weight": engine.Weight,
    "explicit cylinder": engine.Cylinder,
}
"""By the name a marker gives it: the record of one table of an engine file."""

_BANKS = "the rows of cylinders, front bank first; see [a bank](#a-bank)"
_POSITIONS = "distances of the cylinders of a bank behind its first, where the pitch is not even"
_PITCH = "distance of neighbouring cylinders of a bank along the crankshaft; the unit `a` of normalised couples"
MEANINGS: dict[tuple[str, str], str] = {
    ("short", "layout"): "how the cylinders are arranged; one of the tables below",
    ("explicit", "shaft"): "the shafts, the reference crankshaft first; see [a shaft](#a-shaft)",
    ("explicit", "cylinders"): "the cylinders; see [a cylinder](#a-cylinder-in-the-explicit-form)",
    ("shaft", "throw"): "its crank throws; see [a throw](#a-throw)",
    ("shaft", "weight"): "its counterweights and balance weights; see [a weight](#a-weight)",
    ("bank", "name"): "by which results name it; `bank 1`, `bank 2`, ... if left out",
    ("crank", "name"): "by which results name it; `crank 1`, `crank 2`, ... if left out",
    ("crank", "banks"): "its rows of cylinders; see [a bank](#a-bank)",
    ("inline", "throws"): "from pin 1, clockwise, front to rear; if left out, evenly spaced ones as the firing order needs",
    ("inline", "positions"): "distances behind cylinder 1, where the pitch is not even",
    ("inline", "bearing"): "where the cylinders point, clockwise from up: a slanted or a lying engine",
    ("inline", "bore_pitch"): _PITCH,
    ("vee", "banks"): _BANKS,
    ("vee", "throws"): "from pin 1, clockwise: one for each pin of a bank, or one for each cylinder by its number",
    ("vee", "bore_pitch"): _PITCH,
    ("vee", "bank_offset"): "how far each bank stands in front of the next; 0 for fork-and-blade rods",
    ("vee", "pin_split"): "split pins: how far the pins of each bank are turned clockwise from those of the bank before",
    ("vee", "positions"): _POSITIONS,
    ("boxer", "banks"): "two of them, opposite each other; see [a bank](#a-bank)",
    ("boxer", "throws"): "of the first bank, from pin 1, clockwise",
    ("boxer", "bore_pitch"): _PITCH,
    ("boxer", "bank_offset"): "how far the first bank stands in front of the second",
    ("boxer", "positions"): _POSITIONS,
    ("tandem", "cranks"): "two to sixteen crankshafts, the reference crankshaft first; see [a crank](#a-crank)",
    ("tandem", "bore_pitch"): _PITCH,
    ("tandem", "bank_offset"): "how far each bank of a crankshaft stands in front of its next",
    ("tandem", "positions"): _POSITIONS,
    ("opposed", "throws"): "of the first crankshaft, from its pin 1, clockwise, one for each cylinder",
    ("opposed", "crank_distance"): "from the first crankshaft to the second",
    ("opposed", "lag"): "turn of the first crankshaft by which the second follows",
    ("opposed", "bearing"): "where the second crankshaft stands from the first, clockwise from up",
    ("opposed", "speed_ratio"): "of the second crankshaft; -1 if it turns the other way",
    ("opposed", "bore_pitch"): _PITCH,
    ("opposed", "positions"): _POSITIONS,
    ("radial", "rows"): "the stars, the front one first; see [a row](#a-row)",
    ("radial", "knuckle_radius"): "from crank pin to the knuckle pins of slave rods; if left out, all rods sit on the crank pin",
    ("radial", "slave_rod_length"): "between centres; the master's rod less the knuckle radius if left out",
    ("radial", "row_pitch"): "distance of neighbouring rows along the crankshaft; the unit `a` of normalised couples",
}
"""What the records leave to the page to say, and arguments of layouts whose docstring speaks of several at once."""

MARK = re.compile(r"^<!-- (keys|figure|sources): ?([\w. /-]*?) ?-->$", re.MULTILINE)
CITATION = re.compile(r"\[(@[\w-]+(?:; ?@[\w-]+)*)\]")


def on_page_markdown(markdown: str, **_: Any) -> str:
    """Called by mkdocs with the text of each page."""
    return filled(markdown)


def filled(markdown: str) -> str:
    """A page with its markers replaced by what they stand for."""
    makers = {"keys": table, "figure": figure, "sources": sources}
    return CITATION.sub(cited, MARK.sub(lambda found: makers[found.group(1)](found.group(2)), markdown))


def table(name: str) -> str:
    """The keys of one table of an engine file: value, default, meaning."""
    lines = ["| key | value | default | meaning |", "|---|---|---|---|"]
    for key, info in sorted(by_key(TABLES[name]).items(), key=lambda item: not item[1].is_required()):
        meaning = MEANINGS.get((name, key)) or info.description or ""
        lines.append(f"| `{key}` | {_value(info)} | {_default(info)} | {_layout_kind(info) or meaning} |")
    return "\n".join(lines).replace("`layout.type`", "`type`")


def _layout_kind(info: FieldInfo) -> str:
    choices = get_args(info.annotation) if get_origin(info.annotation) is Literal else ()
    return "names the layout" if choices and choices[0] in layouts.LAYOUTS else ""


def _value(info: FieldInfo) -> str:
    """What can be given: a quantity with its unit of example, text, a number, a list or a table of these."""
    many = "list of " if _holds(info.annotation, tuple) else ""
    quantity = quantity_of(info)
    if quantity is not None:
        kind = "a length" if quantity.dimension == "length" else quantity.dimension
        kind = kind.removeprefix("a ") + ("s" if many and not kind.endswith("crankshaft") else "")
        kind = kind.replace("length along", "lengths along") if many else kind
        return f'{many}{kind}, `["{quantity.example}", ...]`' if many else f'{kind}, `"{quantity.example}"`'
    if (choices := _choices(info.annotation)) != ():
        return many + " or ".join(f'`"{choice}"`' if isinstance(choice, str) else f"`{choice}`" for choice in choices)
    if record_in(info.annotation) is not None:
        return "tables by key path" if _holds(info.annotation, dict) else f"{many}tables" if many else "table"
    simple = {Fraction: 'ratio, `-1` or `"29/31"`', int: "whole number", float: "number", str: "text"}
    found = next((text for kind, text in simple.items() if _holds(info.annotation, kind)), "table")
    return f"{many}{found}s" if many else found


def _choices(annotation: Any) -> tuple[Any, ...]:
    if get_origin(annotation) is Literal:
        return get_args(annotation)
    return next((found for part in get_args(annotation) if (found := _choices(part)) != ()), ())


def _holds(annotation: Any, kind: type) -> bool:
    return annotation is kind or get_origin(annotation) is kind or any(_holds(part, kind) for part in get_args(annotation))


def _default(info: FieldInfo) -> str:
    if info.is_required():
        return "required"
    value = info.default
    if value is None or isinstance(value, Record) or value in ((), {}, ""):
        return "-"
    if isinstance(value, tuple):
        return "`[" + ", ".join(f"{item:g}" for item in value) + "]`"
    if isinstance(value, str):
        return f'`"{value}"`'
    return f"`{value:g}`" if isinstance(value, float) else f"`{value}`"


def figure(path: str) -> str:
    """A drawing put into the page itself, so that it takes the colours of the page."""
    drawing = (HERE / path).read_text(encoding="utf-8")
    return f'<figure markdown="0">\n{drawing[drawing.index("<svg") :].strip()}\n</figure>'


def sources(path: str) -> str:
    """A bibliography as a list, each entry with an anchor of its key."""
    lines: list[str] = []
    for key, fields in entries((HERE / path).read_text(encoding="utf-8")).items():
        parts = [fields["author"].replace(" and ", ", "), f"*{escape(fields['title'])}*"]
        parts += [escape(fields[name]) for name in ("publisher", "howpublished", "note") if name in fields]
        if "journal" in fields:
            parts.append(f"{fields['journal']} {fields['volume']}({fields['number']}), p. {fields['pages'].replace('--', '-')}")
        parts += [fields["year"]] if "year" in fields else []
        lines.append(f'* <a id="{key}"></a>**{label(key)}**: {". ".join(parts)}.')
    return "\n".join(lines)


def cited(found: re.Match[str]) -> str:
    """Keys of the bibliography in a text, `[@taylor1985; @norton]`, as links to their entries."""
    keys = [key.strip().removeprefix("@") for key in found.group(1).split(";")]
    return "(" + "; ".join(f"[{label(key)}](references.md#{key})" for key in keys) + ")"


def label(key: str) -> str:
    """How a source is called in a text: taylor1985 is Taylor 1985."""
    name, year = re.fullmatch(r"(.*?)(\d{4})?", key).groups()  # pyright: ignore[reportOptionalMemberAccess]
    shown = {"denhartog": "Den Hartog", "v8cross": "V8 cross-plane page", "kr250": "KR250 essay", "yamamoto": "V8 flat-plane page"}
    return " ".join(filter(None, (shown.get(name, name.capitalize()), year)))


def entries(bibliography: str) -> dict[str, dict[str, str]]:
    """The entries of a BibTeX file by key; every value stands in braces on a line of its own."""
    out: dict[str, dict[str, str]] = {}
    for found in re.finditer(r"^@\w+\{([\w-]+),\n(.*?)^\}", bibliography, re.MULTILINE | re.DOTALL):
        fields = re.findall(r"^\s*(\w+)\s*=\s*\{(.*)\},?$", found.group(2), re.MULTILINE)
        out[found.group(1)] = {name: value.replace("{", "").replace("}", "") for name, value in fields}
    return out
