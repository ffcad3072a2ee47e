"""The gallery: engines as small turning pictures, by layout and number of cylinders, with a search.

All engines are shown without a script; with one, those are hidden that are not wanted, and on the
server an engine file can be dropped. Style and script are files of their own.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from html import escape
from importlib.resources import files
from typing import NamedTuple

from crankstar.language.messages import N_, NAMES, _, _n, language
from crankstar.site.miniatures import SIZE, Look

LAYOUTS = {
    "inline": N_("In line"),
    "vee": N_("V"),
    "boxer": N_("Boxer"),
    "tandem": N_("Tandem"),
    "opposed": N_("Opposed pistons"),
    "radial": N_("Radial"),
    "explicit": N_("Other layouts"),
}
CYCLES = {"four-stroke": N_("four-stroke"), "two-stroke": N_("two-stroke")}
STYLE = "gallery.css"


class Card(NamedTuple):
    """An engine of a gallery: name, title, layout, cylinders, cycle, the page it leads to."""

    name: str
    title: str
    layout: str
    cylinders: int
    cycle: str
    page: str


class Gallery(NamedTuple):
    """What a gallery is made of: cards, where their pictures, style and script are, what it says.

    `policy` is its Content-Security-Policy, empty where a server sends it; `live`: pictures stand
    still until they are seen, and engine files can be opened.
    """

    cards: Sequence[Card]
    picture: Callable[[str, Look], str]
    style: str
    script: str
    policy: str = ""
    live: bool = False


def style() -> str:
    """The style of a gallery as CSS."""
    return (files("crankstar.site") / STYLE).read_text(encoding="utf-8")


def html(gallery: Gallery) -> str:
    """The gallery as a page, its engines by title."""
    title = _("Engines")
    policy = (
        f'<meta http-equiv="Content-Security-Policy" content="{escape(gallery.policy)}">'
        if gallery.policy
        else ""
    )
    about = _("Piston engines that turn, and how they shake: choose one.")
    own, others = (_own(), _languages()) if gallery.live else ("", "")
    ordered = sorted(gallery.cards, key=lambda card: card.title.casefold())
    cards = "\n".join(_card(card, gallery) for card in ordered)
    none = _("No engine matches. Type fewer words, or take all layouts.")
    return f"""<!DOCTYPE html>
<html lang="{language()}">
<head>
<meta charset="utf-8">
{policy}
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="crankstar">
<meta name="description" content="{escape(about)}">
<title>crankstar · {escape(title)}</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="{escape(gallery.style)}">
<script defer src="{escape(gallery.script)}"></script>
</head>
<body{" data-live" * gallery.live}>
<header>
{others}
<h1>{escape(title)}</h1>
<p>{escape(about)}</p>
</header>
<main>
<form class="filters" role="search" hidden>
{_filters(gallery.cards)}
{own}
</form>
<div class="mistakes" role="alert" hidden></div>
<ul class="cards">
{cards}
</ul>
<p class="none" hidden>{escape(none)}</p>
</main>
</body>
</html>
"""


def _filters(cards: Sequence[Card]) -> str:
    """The search, the choices of layout and cylinders, and how many engines are left."""
    layouts = [name for name in LAYOUTS if any(card.layout == name for card in cards)]
    counts = sorted({card.cylinders for card in cards})
    return "\n".join(
        (
            _labelled(_("Search"), '<input type="search" name="words" autocomplete="off">'),
            _labelled(
                _("Layout"), _select("layout", [(name, _(LAYOUTS[name])) for name in layouts])
            ),
            _labelled(_("Cylinders"), _select("cylinders", [(str(n), str(n)) for n in counts])),
            _labelled(_("Engines"), f'<output aria-live="polite">{len(cards)}</output>'),
        )
    )


def _labelled(label: str, field: str) -> str:
    return f"<label><span>{escape(label)}</span> {field}</label>"


def _select(name: str, choices: Sequence[tuple[str, str]]) -> str:
    options = [("", _("All")), *choices]
    inner = "".join(f'<option value="{value}">{escape(text)}</option>' for value, text in options)
    return f'<select name="{name}">{inner}</select>'


def _languages() -> str:
    """The same gallery in each language."""
    present, label = {language(): ' aria-current="true"'}, _("Language")
    links = " ".join(
        f'<a href="?lang={code}" lang="{code}" hreflang="{code}"{present.get(code, "")}>{name}</a>'
        for code, name in NAMES.items()
    )
    return f'<nav class="languages" aria-label="{escape(label)}">{links}</nav>'


def _own() -> str:
    """How an engine file of one's own is opened."""
    hint = _("or drop an engine file (TOML or JSON) anywhere")
    button = _("Open a file …")
    return (
        f'<div class="own"><button type="button">{escape(button)}</button>'
        f'<input type="file" accept=".toml,.json" hidden><span>{escape(hint)}</span></div>'
    )


def _card(card: Card, gallery: Gallery) -> str:
    """An engine: its picture, title and facts, in one link."""
    facts = _n(
        "{layout}, {count} cylinder, {cycle}",
        "{layout}, {count} cylinders, {cycle}",
        card.cylinders,
        layout=_(LAYOUTS.get(card.layout, LAYOUTS["explicit"])),
        count=card.cylinders,
        cycle=_(CYCLES.get(card.cycle, card.cycle)),
    )
    words = f"{card.name} {card.title} {card.layout} {facts} {card.cycle}".lower()
    return (
        f'<li data-layout="{escape(card.layout)}" data-cylinders="{card.cylinders}" '
        f'data-words="{escape(words)}"><a href="{escape(card.page)}">'
        f"{_picture(card.name, gallery)}"
        f'<span class="title">{escape(card.title)}</span>'
        f'<span class="facts">{escape(facts)}</span></a></li>'
    )


def _picture(name: str, gallery: Gallery) -> str:
    """The picture of an engine in the colours of the reader's system; it turns if that is liked."""

    def source(theme: str, *, turning: bool) -> str:
        return escape(gallery.picture(name, Look(theme, turning)))  # pyright: ignore[reportArgumentType]

    size = f'width="{SIZE[0]}" height="{SIZE[1]}" alt="" loading="lazy" decoding="async"'
    dark, calm = "(prefers-color-scheme: dark)", "(prefers-reduced-motion: reduce)"
    still = source("light", turning=False)
    if gallery.live:
        return (
            f'<picture><source media="{dark}" srcset="{source("dark", turning=False)}" '
            f'data-turning="{source("dark", turning=True)}"><img src="{still}" '
            f'data-turning="{source("light", turning=True)}" {size}></picture>'
        )
    return (
        f'<picture><source media="{calm} and {dark}" srcset="{source("dark", turning=False)}">'
        f'<source media="{calm}" srcset="{still}">'
        f'<source media="{dark}" srcset="{source("dark", turning=True)}">'
        f'<img src="{source("light", turning=True)}" {size}></picture>'
    )
