"""The last pages of a report: where the values come from, what the signs mean, and how the report is made again."""

from __future__ import annotations

import re
from importlib.resources import files

from crankstar import __version__, description
from crankstar.answer import json_text
from crankstar.files.write import tree_text
from crankstar.report.gallery import Gallery
from crankstar.report.markup import of, paragraph, section, text
from crankstar.report.matter import Matter

CONVENTIONS = """\
The engine is seen from the front; z runs along the crankshaft, positive to the front. Bearings count clockwise from up, θ in \
the direction of rotation of the first shaft, from top dead centre of cylinder 1.
A force is what the moving parts do to the block. A couple is Σ (z − z₀) · force, in the plane in which it acts: couple up \
lifts the front. An amplitude a ∠ p stands for a cos(kθ + p).
Every order is two vectors that turn in opposite directions, forward with the crankshaft and backward against it. \
Counterweights on a crankshaft can only take away what turns with it and as fast: of the first order, what turns its way.
"""
STYLE = re.compile(r"\s*<style>(.*?)</style>", re.DOTALL)


def sources(matter: Matter, gallery: Gallery) -> str:  # noqa: ARG001 - all pages are made alike
    """Sources and notes of the engine file, and the provenance of each value."""
    engine = matter.engine
    source = paragraph(engine.source) if engine.source else paragraph("The engine file names no source.")
    notes = f"<h3>Notes</h3>{paragraph(engine.notes)}" if engine.notes else ""
    origins = of(description.origins(engine)) if engine.provenance else paragraph("It does not say where each value comes from.")
    return section("Sources", source + notes + origins, name="sources")


def conventions(matter: Matter, gallery: Gallery) -> str:  # noqa: ARG001
    """The signs in three sentences and one drawing."""
    lines = "".join(paragraph(line) for line in CONVENTIONS.splitlines())
    drawing = f'<figure class="wide">{STYLE.sub("", _frame())}<figcaption>Frame and signs.</figcaption></figure>'
    return section("Conventions", lines + drawing, name="conventions")


def again(matter: Matter, gallery: Gallery) -> str:  # noqa: ARG001
    """The command that writes this report again, and the engine file as it was read."""
    told = paragraph(f"Made by crankstar {__version__} with this command; the same engine file gives the same report to the byte.")
    command = f"<pre><code>{text(matter.command)}</code></pre>"
    file = f'<h3>The engine file</h3><pre class="file"><code>{_shown(_file(matter))}</code></pre>'
    return section("How to repeat it", told + command + file, name="again")


def _file(matter: Matter) -> str:
    """The engine file as TOML, or, where it is of a kind that TOML has no words for, as JSON."""
    try:
        return tree_text(dict(matter.tree))
    except (TypeError, ValueError):
        return json_text(dict(matter.tree))


def _shown(file: str) -> str:
    return "\n".join(text(line) for line in file.splitlines())


def frame_style() -> str:
    """The style of the drawing of the frame, which goes into the sheet of the report."""
    found = STYLE.search(_frame())
    return found.group(1) if found else ""


def _frame() -> str:
    drawing = files("crankstar.report").joinpath("frame.svg").read_text(encoding="utf-8")
    return drawing[drawing.index("<svg") :].strip()
