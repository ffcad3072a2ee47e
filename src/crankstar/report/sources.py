"""The last pages of a report: sources, conventions, and the command that writes it again."""

from __future__ import annotations

import re

from crankstar import __version__
from crankstar.files.write import tree_text
from crankstar.language.messages import N_, _
from crankstar.report import frame
from crankstar.report.gallery import Gallery
from crankstar.report.markup import figure, parts_html, section
from crankstar.report.subject import Subject
from crankstar.tables import engines
from crankstar.tables.html import paragraph, text
from crankstar.tables.machine import json_text

CONVENTIONS = (
    N_(
        "The engine is seen from the front; z points to the front along the crankshaft. Bearings "
        "are clockwise from up. The crank angle θ is measured from top dead centre of cylinder 1 "
        "in the direction of rotation of the first shaft."
    ),
    N_(
        "Forces and couples act on the block. A couple is Σ (z − z₀) · force in the plane in which "
        "it acts: a couple up lifts the front. An amplitude a ∠ p means a cos(kθ + p)."
    ),
    N_(
        "Each order is the sum of two rotating vectors: forward, with the crankshaft, and "
        "backward, against it. Counterweights on the crankshaft balance only the forward vector "
        "of the first order."
    ),
)
MOST_ORIGINS = 8
"""Sources of values that a short report lists."""
STYLE = re.compile(r"\s*<style>(.*?)</style>", re.DOTALL)


def sources(subject: Subject, gallery: Gallery) -> str:  # noqa: ARG001 - one signature for all
    """Sources and notes of the engine file, and the provenance of each value."""
    engine = subject.engine
    source = paragraph(engine.source or _("The engine file names no source."))
    heading = _("Notes")
    notes = f"<h3>{text(heading)}</h3>{paragraph(engine.notes)}" if engine.notes else ""
    origins = paragraph(_("The engine file gives no source for single values."))
    if engine.provenance and not subject.full and len(engine.provenance) > MOST_ORIGINS:
        origins = paragraph(
            _("The engine file gives {count} sources of values.", count=len(engine.provenance))
        )
    elif engine.provenance:
        origins = parts_html([engines.origins(engine)])
    return section(_("Sources"), source + notes + origins, name="sources")


def conventions(subject: Subject, gallery: Gallery) -> str:  # noqa: ARG001
    """The signs in three paragraphs, in a full report with a drawing."""
    lines = "".join(paragraph(_(line)) for line in CONVENTIONS)
    shown = (
        figure(STYLE.sub("", frame.drawing()), _("Frame and signs."), "wide")
        if subject.full
        else ""
    )
    return section(_("Conventions"), lines + shown, name="conventions")


def again(subject: Subject, gallery: Gallery) -> str:  # noqa: ARG001
    """The command that writes this report again, and the engine file as it was read."""
    made = paragraph(
        _(
            "Written by crankstar {version} with this command. The same engine file gives the same "
            "report, byte for byte.",
            version=__version__,
        )
    )
    command = f"<pre><code>{text(subject.command)}</code></pre>"
    file = f'<pre class="file"><code>{_shown(_file(subject))}</code></pre>'
    heading = _("The engine file")
    listing = f"<h3>{text(heading)}</h3>{file}" if subject.full else ""
    return section(_("Reproduction"), f"{made}{command}{listing}", name="again")


def _file(subject: Subject) -> str:
    """The engine file as TOML, or as JSON where TOML cannot hold it."""
    try:
        return tree_text(dict(subject.tree))
    except (TypeError, ValueError):
        return json_text(dict(subject.tree))


def _shown(file: str) -> str:
    return "\n".join(text(line) for line in file.splitlines())


def frame_style() -> str:
    """The style of the drawing of the frame, for the style sheet of the report."""
    match = STYLE.search(frame.drawing())
    return match.group(1) if match else ""
