"""The report as one HTML file: no script, no network, a style sheet vouched for by its hash."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Callable
from hashlib import sha256
from importlib.resources import files

from crankstar import __version__
from crankstar.derive.documents import ALIGNED
from crankstar.report import cures, ending, gallery, pages, title, whirling
from crankstar.report.markup import text
from crankstar.report.matter import Matter

PAGES: tuple[tuple[str, pages.Page], ...] = (
    ("the views", pages.looks),
    ("the crankshaft", pages.crankshaft),
    ("strokes", pages.strokes),
    ("orders", pages.orders),
    ("vector stars and polygons", pages.vectors),
    ("forces over the crank angle", pages.over_the_turn),
    ("the free response", whirling.free_response),
    ("remedies", cures.remedies),
    ("the other engine", pages.beside),
    ("derivations", pages.derivations),
    ("sources", ending.sources),
    ("conventions", ending.conventions),
    ("how to repeat it", ending.again),
)
"""The sections after the first page, in their order, and how each is spoken of while it is written."""


def report(matter: Matter, *, tell: Callable[[str], None] = lambda _: None) -> str:
    """The report as the text of an HTML file; `tell` is called with what is being written."""
    with gallery.opened(matter) as drawings:
        body = []
        for name, page in PAGES:
            tell(f"writing {name} ...")
            body.append(page(matter, drawings))
        tell("writing the verdict ...")
        front = title.title(matter) + title.in_short(matter)
        tell("drawing ...")
        inner = drawings.hung("\n".join([front, *body]))
    return _page(matter.engine.name, inner)


def _page(name: str, inner: str) -> str:
    sheet = files("crankstar.report").joinpath("sheet.css").read_text(encoding="utf-8")
    style = f"\n{sheet}{ALIGNED}{ending.frame_style()}\n{_running(name)}"
    allowed = f"sha256-{b64encode(sha256(style.encode()).digest()).decode()}"
    policy = f"default-src 'none'; style-src '{allowed}'; img-src data:; base-uri 'none'; form-action 'none'"
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        f'<meta name="viewport" content="width=device-width, initial-scale=1">\n<title>{text(name)}</title>\n'
        f'<meta name="generator" content="crankstar {__version__}">\n<style>{style}</style>\n</head>\n'
        f"<body>\n<main>\n{inner}\n</main>\n</body>\n</html>\n"
    )


def _running(name: str) -> str:
    """The name at the head of every printed page; letters that mean something in a style sheet are written by their numbers."""
    spelt = "".join(letter if letter.isascii() and letter.isalnum() else f"\\{ord(letter):x} " for letter in name[:80])
    return f'@page {{ @top-left {{ content: "{spelt}"; }} }}\n'
