"""The report as one HTML file without script or network, its style sheet allowed by a hash."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Callable
from functools import partial
from hashlib import sha256
from importlib.resources import files

from crankstar import __version__
from crankstar.analysis.registry import analyses as all_analyses
from crankstar.language.messages import N_, _, language
from crankstar.report import (
    analyses,
    bearings,
    front,
    gas,
    lettering,
    numbering,
    pages,
    remedies,
    sources,
    title,
    whirling,
)
from crankstar.report.gallery import Gallery
from crankstar.report.subject import Subject
from crankstar.tables.html import paragraph, text

PAGES: tuple[tuple[str, pages.Page], ...] = (
    (N_("Writing the views ..."), pages.drawings),
    (N_("Writing the crankshaft ..."), pages.crankshaft),
    (N_("Writing the strokes ..."), pages.strokes_page),
    (N_("Writing the orders ..."), pages.orders),
    (N_("Writing the vector stars and polygons ..."), pages.vectors),
    (N_("Writing the forces over the crank angle ..."), pages.over_the_turn),
    (N_("Writing gas and torque ..."), gas.gas),
)
MORE_PAGES: tuple[tuple[str, pages.Page], ...] = (
    (N_("Writing the loads on bearings ..."), bearings.bearings),
    (N_("Writing the free response ..."), whirling.free_response),
    (N_("Writing the remedies ..."), remedies.remedies),
    (N_("Writing the comparison ..."), pages.beside),
    (N_("Writing the derivations ..."), pages.derivations),
    (N_("Writing the sources ..."), sources.sources),
    (N_("Writing the conventions ..."), sources.conventions),
    (N_("Writing the command ..."), sources.again),
)
"""The sections after the first page, before and behind those of the analyses; each with its message
of progress."""


def report(subject: Subject, *, tell: Callable[[str], None] = lambda _: None) -> str:
    """The report as the text of an HTML file; `tell` is called with what is being written."""
    drawings = Gallery(subject)
    body = []
    own = [
        (record.doing, partial(analyses.section_of, record))
        for record in all_analyses()
        if record.lacks is not None
    ]
    for progress, page in (*PAGES, *own, *MORE_PAGES):
        tell(_(progress))
        body.append(page(subject, drawings))
    tell(_("Writing the verdict ..."))
    body.insert(1, title.data_section(subject) + title.verdict_section(subject))
    first = front.front(subject)
    sections = numbering.numbered("\n".join(body), figures=1)
    first = first.replace("<figcaption>", f'<figcaption id="figure-1"><b>{_figure_one()}</b> ', 1)
    first += front.contents(numbering.entries(sections))
    note = "" if subject.full else paragraph(_(SHORT), "note")
    inner = "\n".join([first + note, *(section.html for section in sections)])
    return _page(subject.engine.name, drawings.filled(inner))


def _figure_one() -> str:
    return text(_("Figure {number}.", number=1))


SHORT = N_(
    "This is the short report. `crankstar report --full` adds the derivations step by step, the "
    "tables by cylinder, the source of each value and the engine file."
)


def _page(name: str, inner: str) -> str:
    sheet = files("crankstar.report").joinpath("sheet.css").read_text(encoding="utf-8")
    rules, families = lettering.faces(inner + name)
    lettered = rules + lettering.rules_of(families)
    formulas = ""
    if "<math" in inner:  # the exact algebra is slow to load
        from crankstar.derive.documents import math_style

        formulas = math_style()
    style = f"\n{sheet}{formulas}{sources.frame_style()}\n{lettered}{_running(name)}"
    allowed = f"sha256-{b64encode(sha256(style.encode()).digest()).decode()}"
    fonts = "font-src data:; " if families or formulas else ""
    policy = (
        f"default-src 'none'; style-src '{allowed}'; img-src data:; {fonts}base-uri 'none'; "
        "form-action 'none'"
    )
    return (
        f'<!DOCTYPE html>\n<html lang="{language()}">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{text(name)}</title>\n"
        f'<meta name="generator" content="crankstar {__version__}">\n'
        f"<style>{style}</style>\n</head>\n"
        f"<body>\n<main>\n{inner}\n</main>\n</body>\n</html>\n"
    )


def _running(name: str) -> str:
    """The name at the head of every printed page, letters other than ASCII by their numbers."""
    spelt = "".join(
        letter if letter.isascii() and letter.isalnum() else f"\\{ord(letter):x} "
        for letter in name[:80]
    )
    return f'@page {{ @top-left {{ content: "{spelt}"; }} }}\n'
