"""Parts of the documents built by the program: tables of keys, the figure, sources, errata.

A page says `<!-- keys: vee -->` and gets the table of the keys that a `[layout]` of that kind can
have, made from the record that checks engine files; so the page cannot name a key that is not
there, nor leave one out.
"""

from __future__ import annotations

import os
import re
import shlex
from contextlib import redirect_stderr
from dataclasses import MISSING
from fractions import Fraction
from functools import lru_cache
from html import escape
from io import StringIO
from pathlib import Path
from runpy import run_path
from tempfile import TemporaryDirectory
from typing import Any, Literal, get_args, get_origin

from pydantic.fields import FieldInfo

from crankstar.engine import engine, gas, layouts, mounts, oil, records, torsion
from crankstar.engine.basis import BalanceShaft, Crankshaft, CrankWeight, Override, Sizes
from crankstar.engine.records import Record
from crankstar.files.forms import by_key, quantity_of, record_in, short_form
from crankstar.files.units import text

HERE = Path(__file__).parent
DOCS = HERE.parent


def _layout(kind: str) -> type[Record]:
    record = record_in(short_form(kind).model_fields["layout"].annotation)
    if record is None:
        raise TypeError(f"the layout {kind} has no record")
    return record


TABLES: dict[str, type[Record]] = {
    "short": short_form(None),
    "cylinder": Sizes,
    "override": Override,
    "crankshaft": Crankshaft,
    "crank weight": CrankWeight,
    "balance shaft": BalanceShaft,
    "rod": records.Rod,
    "parts": records.Parts,
    "articulated": records.Articulation,
    "valves": records.Valves,
    "block": records.Block,
    "block point": records.BlockPoint,
    "gas": records.Gas,
    "operating point": gas.OperatingPoint,
    "trace": gas.Trace,
    "drive": records.Drive,
    "oil": records.Oil,
    "plain bearing": oil.PlainBearing,
    "torsion": records.Torsion,
    "crank dimensions": torsion.CrankDimensions,
    "crank fatigue": torsion.CrankFatigue,
    "coupling": torsion.Coupling,
    "disc": torsion.Disc,
    "pendulum": torsion.Pendulum,
    "chain": torsion.Chain,
    "mount": mounts.Mount,
    "stiffening": mounts.Stiffening,
    "foot": mounts.FootReceptance,
    "foundation": mounts.Foundation,
    "provenance": records.Provenance,
    **{kind: _layout(kind) for kind in layouts.LAYOUTS},
    "bank": layouts.Bank,
    "crank": layouts.Crank,
    "row": layouts.Row,
    "explicit": engine.Engine,
    "shaft": records.Shaft,
    "throw": records.Throw,
    "weight": records.Weight,
    "explicit cylinder": records.Cylinder,
}
"""By the name a marker gives it: the record of one table of an engine file."""

SECTIONS: dict[type[Record], str] = {
    layouts.Bank: "[a bank](#a-bank)",
    layouts.Crank: "[a crank](#a-crank)",
    layouts.Row: "[a row](#a-row)",
    Crankshaft: "[a crankshaft](#crankshaft)",
    CrankWeight: "[its weights](#crankshaft)",
    BalanceShaft: "[a balance shaft](#balance_shaft)",
    records.Valves: "[valves](#valves)",
    records.Gas: "[gas](#gas)",
    records.Drive: "[drive](#drive)",
    records.Oil: "[oil](#oil)",
    oil.PlainBearing: "[bearings](#oil)",
    records.BlockPoint: "[points](#block)",
    records.Torsion: "[torsion](#torsion)",
    torsion.CrankDimensions: "[dimensions](#torsion)",
    torsion.CrankFatigue: "[fatigue](#torsion)",
    torsion.Coupling: "[couplings](#torsion)",
    torsion.Disc: "[discs](#torsion)",
    torsion.Pendulum: "[pendulums](#torsion)",
    mounts.Mount: "[mounts](#mounts)",
    mounts.Stiffening: "[rubber](#mounts)",
    mounts.FootReceptance: "[foot](#mounts)",
    mounts.Foundation: "[foundation](#foundation)",
    records.Shaft: "[a shaft](#a-shaft)",
    records.Throw: "[a throw](#a-throw)",
    records.Weight: "[a weight](#a-weight)",
    records.Cylinder: "[a cylinder](#a-cylinder-in-the-explicit-form)",
}
"""Where the page describes the tables that other tables hold."""

MARK = re.compile(
    r"^<!-- (keys|options|figure|sources|errata|sinitsyn|kr250|gears|left out|orders|estimate|"
    r"plot|draw|search|sweep|tolerance|glossary|commands|analyses): ?([^\n]*?) ?-->$"
    r"(?:(?:(?!^<!-- ).)*?^<!-- end -->$)?",
    re.MULTILINE | re.DOTALL,
)
"""A marker, with what `tables` has put between it and its end for readers of the text."""
GALLERY = "<!-- here: the gallery -->"
UNDRAWN = "CRANKSTAR_UNDRAWN"
"""The variable of the environment that leaves drawings out of the documents."""
CITATION = re.compile(r"\[(@[\w-]+(?:; ?@[\w-]+)*)\]")


def on_config(config: Any) -> Any:
    """Called by mkdocs before it builds: formulas between dollars, and in fences of kind `math`."""
    mathematics = run_path(str(HERE / "mathematics.py"))
    config.markdown_extensions.append(mathematics["Mathematics"]())
    fence = {"name": "math", "class": "math", "format": mathematics["fence"]}
    config.mdx_configs.setdefault("pymdownx.superfences", {})["custom_fences"] = [fence]
    return config


def on_page_markdown(markdown: str, *, page: Any, **_: Any) -> str:
    """Called by mkdocs with the text of each page."""
    return filled(markdown, page.file.src_uri)


def filled(markdown: str, place: str = "index.md") -> str:
    """A page with its markers replaced by what they stand for; `place` is its path in docs/."""
    written = MARK.sub(lambda mark: made(*mark.groups()), markdown).replace(GALLERY, gallery())
    up = "../" * place.count("/")
    return CITATION.sub(lambda found: cited(found, up), written)


def gallery() -> str:
    """A link to the engines of the catalog, where `make site` puts them beside the documents."""
    place = os.environ.get("CRANKSTAR_GALLERY")
    words = "All engines of the catalog, turning"
    return f'<p><a href="{place}/index.html">{words}</a></p>' if place else ""


def made(kind: str, argument: str) -> str:
    """What stands for a marker on the built page."""
    makers = {
        "keys": table,
        "options": option_table,
        "figure": figure,
        "sources": sources,
        "errata": errata,
        "sinitsyn": sinitsyn,
        "kr250": kr250,
        "gears": gears,
        "left out": left_out,
        "estimate": estimate,
        "orders": orders,
        "plot": plot,
        "draw": draw,
        "search": search,
        "sweep": sweep,
        "tolerance": tolerance,
        "glossary": glossary,
        "commands": commands,
        "analyses": functions,
    }
    return makers[kind](argument)


def table(name: str) -> str:
    """The keys of one table of an engine file: value, default, meaning."""
    lines = ["| key | value | default | meaning |", "|---|---|---|---|"]
    for key, info in sorted(
        by_key(TABLES[name]).items(), key=lambda item: not item[1].is_required()
    ):
        inner = SECTIONS.get(record_in(info.annotation) or Record)
        meaning = (info.description or "") + (f"; see {inner}" if inner else "")
        lines.append(f"| `{key}` | {_value(info)} | {_default(info)} | {meaning} |")
    return "\n".join(lines).replace("`layout.type`", "`type`")


def option_table(_words: str) -> str:
    """Every option of the command line: what it takes, what it means, in which commands."""
    from crankstar import cli
    from crankstar.options.vocabulary import OPTIONS

    commands: dict[str, list[str]] = {name: [] for name in OPTIONS}
    for command in sorted(name for name in cli.app if not name.startswith("-")):
        for argument in cli.app[command].assemble_argument_collection():
            for name in {*argument.names} & set(OPTIONS):
                commands[name].append(f"`{command}`")
    lines = ["| option | takes | meaning | commands |", "|---|---|---|---|"]
    for name, option in OPTIONS.items():
        meaning = option.meaning.replace("|", "\\|")
        lines.append(f"| `{name}` | {option.takes} | {meaning} | {', '.join(commands[name])} |")
    return "\n".join(lines)


def _value(info: FieldInfo) -> str:
    """The type of a value: a quantity with its example unit, text, a number, a list, a table."""
    many = "list of lists of " if _holds(info.annotation, tuple[tuple[int, ...], ...]) else ""
    many = many or ("list of " if _holds(info.annotation, tuple) else "")
    quantity = quantity_of(info)
    if quantity is not None:
        kind = "a length" if quantity.dimension == "length" else quantity.dimension
        kind = kind.removeprefix("a ") + ("s" if many and not kind.endswith("crankshaft") else "")
        kind = kind.replace("stiffnesss", "stiffnesses").replace(
            "moment of inertias", "moments of inertia"
        )
        kind = kind.replace("length along", "lengths along") if many else kind
        return (
            f'{many}{kind}, `["{quantity.example}", ...]`'
            if many
            else f'{kind}, `"{quantity.example}"`'
        )
    if (choices := _choices(info.annotation)) != ():
        return many + " or ".join(
            f'`"{choice}"`' if isinstance(choice, str) else f"`{choice}`" for choice in choices
        )
    if record_in(info.annotation) is not None:
        return (
            "tables by key path"
            if _holds(info.annotation, dict)
            else f"{many}tables"
            if many
            else "table"
        )
    simple = {
        Fraction: 'ratio, `-1` or `"29/31"`',
        bool: "`true` or `false`",
        int: "whole number",
        float: "number",
        str: "text",
    }
    found = next((text for kind, text in simple.items() if _holds(info.annotation, kind)), "table")
    return f"{many}{found}s" if many else found


def _choices(annotation: Any) -> tuple[Any, ...]:
    if get_origin(annotation) is Literal:
        return get_args(annotation)
    return next((found for part in get_args(annotation) if (found := _choices(part)) != ()), ())


def _holds(annotation: Any, kind: Any) -> bool:
    return (
        annotation == kind
        or get_origin(annotation) is kind
        or any(_holds(part, kind) for part in get_args(annotation))
    )


def _default(info: FieldInfo) -> str:
    if info.is_required():
        return "required"
    value = info.default
    if value is None or isinstance(value, Record) or value in ((), {}, ""):
        return "-"
    if isinstance(value, bool):
        return f"`{str(value).lower()}`"
    if isinstance(value, tuple):
        return "`[" + ", ".join(f"{item:g}" for item in value) + "]`"
    if isinstance(value, str):
        return f'`"{value}"`'
    quantity = quantity_of(info)
    if quantity is not None and value:
        return f'`"{text(float(value), quantity)}"`'
    return f"`{value:g}`" if isinstance(value, float) else f"`{value}`"


def figure(path: str) -> str:
    """A drawing put into the page itself, so that it takes the colours of the page."""
    drawing = (DOCS / path).read_text(encoding="utf-8")
    return f'<figure markdown="0">\n{drawing[drawing.index("<svg") :].strip()}\n</figure>'


def glossary(_: str) -> str:
    """The terms of the field, alphabetically."""
    from crankstar.language.glossary import terms

    lines = ["| term, symbol | Japanese, Russian | meaning |", "|---|---|---|"]
    for term in sorted(terms(), key=lambda term: term.term.lower()):
        others = [word for word in term.also if "{" not in word and word not in term.term]
        also = f"; also: {', '.join(others)}" if others else ""
        symbol = f"<br>{term.symbol}" if term.symbol else ""
        cells = (f"**{term.term}**{symbol}", f"{term.japanese}<br>{term.russian}")
        meaning = term.meanings["en"]
        lines.append(f"| {' | '.join(cells)} | {meaning}{also} |")
    return "\n".join(lines)


@lru_cache
def commands(_: str) -> str:
    """Every command with its arguments and options, from the help of the program itself."""
    return run_path(str(HERE / "commands_page.py"))["page"]()


@lru_cache
def functions(_: str) -> str:
    """The Python function of every analysis, its arguments as its question has them."""
    from crankstar.analysis.registry import NAMES, analysis
    from crankstar.python.functions import arguments_of, meaning_of

    parts: list[str] = []
    for name in NAMES:
        record = analysis(name)
        fields = arguments_of(record)
        words = [
            one.name if one.default is MISSING else f"{one.name}={one.default!r}" for one in fields
        ]
        first = {"needed": ["engine"], "optional": ["engine=None"], "none": []}[record.engine]
        call = ", ".join([*first, *words])
        lines = [f"### crankstar.{name}", "", f"`{name}({call})`", "", record.about, ""]
        lines += ["| argument | meaning |", "|---|---|"]
        for one in fields:
            text = meaning_of(one).replace("|", "\\|")
            lines.append(f"| `{one.name}` | {text} |")
        figures = ", ".join(f"`{chart.name}`" for chart in record.charts)
        lines += ["", f"Figures: {figures}."] if figures else []
        parts.append("\n".join(lines))
    return "\n\n".join(parts)


@lru_cache
def search(what: str) -> str:
    """The result of a search: a table by the script in this folder, or `crankstar search WORDS`."""
    if "--chart" in what:
        return drawn(f"search {what}", kind="chart wide")
    return run_path(str(HERE / "search_page.py"))["page"](what)


@lru_cache
def errata(source: str) -> str:
    """What is wrong in one source, with formulas and plots, made by the script beside this one."""
    return run_path(str(HERE / "errata_page.py"))["page"](source)


@lru_cache
def sinitsyn(part: str) -> str:
    """A part of the page on Sinitsyn's engines, made by the script beside this one."""
    return run_path(str(HERE / "sinitsyn_page.py"))["page"](part)


@lru_cache
def estimate(part: str) -> str:
    """A part of the page on estimates, made by the script beside this one."""
    return run_path(str(HERE / "estimate_page.py"))["page"](part)


@lru_cache
def kr250(part: str) -> str:
    """A part of the page on the Kawasaki KR250, made by the script beside this one."""
    return run_path(str(HERE / "kr250_page.py"))["page"](part)


@lru_cache
def gears(part: str) -> str:
    """Gears between crankshafts and torque at low speed, by the script beside this one."""
    return run_path(str(HERE / "gears_page.py"))["page"](part)


def left_out(part: str) -> str:
    """A part of the page on what the model leaves out."""
    return run_path(str(HERE / "left_out_page.py"))["page"](part)


@lru_cache
def orders(part: str) -> str:
    """A part of the page on firing orders, made by the script beside this one."""
    return run_path(str(HERE / "orders_page.py"))["page"](part)


@lru_cache
def plot(words: str) -> str:
    """What `crankstar plot WORDS` draws."""
    return drawn(f"plot {words}")


@lru_cache
def draw(words: str) -> str:
    """What `crankstar draw WORDS` draws."""
    return drawn(f"draw {words}", kind="chart wide")


@lru_cache
def sweep(words: str) -> str:
    """What `crankstar sweep WORDS` draws."""
    return drawn(f"sweep {words}")


@lru_cache
def tolerance(words: str) -> str:
    """What `crankstar tolerance WORDS` draws."""
    return drawn(f"tolerance {words}")


def drawn(command: str, *, kind: str = "chart") -> str:
    """What a command draws, with the colours of the page for its text, and the command under it.

    The gate builds the documents without drawings, which take half the time (`UNDRAWN`).
    """
    caption = f"<figcaption><code>crankstar {escape(command)}</code></figcaption>"
    if os.environ.get(UNDRAWN):
        return f'<figure class="{kind}" markdown="0">{caption}</figure>'
    from crankstar.charts import GREY
    from crankstar.cli import app

    with TemporaryDirectory() as folder, redirect_stderr(StringIO()):
        place = Path(folder) / "drawing.svg"
        words = [_file(word, Path(folder)) for word in shlex.split(command)]
        words += ["--output", str(place)]
        app(words, exit_on_error=False, print_error=False)
        drawing = place.read_text(encoding="utf-8")
    shown = drawing.replace(GREY, "currentColor")
    return f'<figure class="{kind}" markdown="0">{shown}{caption}</figure>'


def _file(word: str, folder: Path) -> str:
    """A word of a command; the engine file of a page that it names is put into a folder."""
    if not word.endswith(".toml"):
        return word
    title = re.compile(rf'^```toml title="{re.escape(word)}"\n(.*?)^```$', re.MULTILINE | re.DOTALL)
    pages = (page.read_text(encoding="utf-8") for page in sorted(DOCS.rglob("*.md")))
    [content] = [text for page in pages for text in title.findall(page)]
    place = folder / word
    place.write_text(content, encoding="utf-8")
    return str(place)


def sources(path: str) -> str:
    """A bibliography as a list, each entry with an anchor of its key."""
    lines: list[str] = []
    for key, fields in entries((DOCS / path).read_text(encoding="utf-8")).items():
        parts = [fields["author"].replace(" and ", ", "), f"*{escape(fields['title'])}*"]
        parts += [
            escape(fields[name]) for name in ("publisher", "howpublished", "note") if name in fields
        ]
        if "journal" in fields:
            parts.append(
                f"{fields['journal']} {fields['volume']}({fields['number']}), p. "
                f"{fields['pages'].replace('--', '-')}"
            )
        parts += [fields["year"]] if "year" in fields else []
        lines.append(f'* <a id="{key}"></a>**{label(key)}**: {". ".join(parts)}.')
    return "\n".join(lines)


def cited(found: re.Match[str], up: str) -> str:
    """Keys of the bibliography in a text, `[@taylor1985; @norton]`, as links to their entries."""
    keys = [key.strip().removeprefix("@") for key in found.group(1).split(";")]
    return (
        "(" + "; ".join(f"[{label(key)}]({up}reference/references.md#{key})" for key in keys) + ")"
    )


def label(key: str) -> str:
    """How a source is called in a text: taylor1985 is Taylor 1985."""
    name, year = re.fullmatch(r"(.*?)(\d{4})?", key).groups()  # pyright: ignore[reportOptionalMemberAccess]
    shown = {
        "denhartog": "Den Hartog",
        "v8cross": "V8 cross-plane page",
        "kr250": "KR250 essay",
        "yamamoto": "V8 flat-plane page",
    }
    return " ".join(filter(None, (shown.get(name, name.capitalize()), year)))


def entries(bibliography: str) -> dict[str, dict[str, str]]:
    """The entries of a BibTeX file by key; every value stands in braces on a line of its own."""
    out: dict[str, dict[str, str]] = {}
    for found in re.finditer(r"^@\w+\{([\w-]+),\n(.*?)^\}", bibliography, re.MULTILINE | re.DOTALL):
        fields = re.findall(r"^\s*(\w+)\s*=\s*\{(.*)\},?$", found.group(2), re.MULTILINE)
        out[found.group(1)] = {
            name: value.replace("{", "").replace("}", "") for name, value in fields
        }
    return out
