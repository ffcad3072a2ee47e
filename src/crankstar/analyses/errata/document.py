"""The errata of the sources: each printed formula beside the true one."""

from __future__ import annotations

from collections.abc import Sequence

from crankstar.analyses.errata.answer import Errata
from crankstar.analyses.errata.question import Question
from crankstar.analysis.document import Column, Document, Table
from crankstar.derive.algebra.typeset import text
from crankstar.derive.errata import Erratum, sources
from crankstar.language.messages import N_, _

TITLES = {
    N_("{source}: results"): ("result", "series", "angle"),
    N_("{source}: steps"): ("step",),
    N_("{source}: lines that do not follow"): ("line",),
}
"""Titles of the tables, and the kinds of errata under each."""


def document(_engine: None, found: Errata, _asked: Question) -> Document:
    """The printed and the true formula, source by source."""
    return errata_document(found.errata)


def errata_document(errata: Sequence[Erratum]) -> Document:
    """The printed and the true formula, source by source: results, steps, lines."""
    parts: list[Table] = []
    for source in dict.fromkeys(erratum.source for erratum in errata):
        name = f"{sources()[source]} ({source})"
        for title, kinds in TITLES.items():
            rows = tuple(
                (
                    f"{erratum.title}, {erratum.component}"
                    if erratum.component in ("up", "right")
                    else erratum.title,
                    erratum.text,
                    text(erratum.ours),
                )
                for erratum in errata
                if erratum.source == source and erratum.kind in kinds
            )
            if rows:
                parts.append(
                    Table(_(title, source=name), _columns(), rows, key=f"{source} {kinds[0]}")
                )
    return Document("", tuple(parts))


def _columns() -> tuple[Column, ...]:
    heads = {"of": _("formula"), "printed": _("printed"), "true": _("correct formula")}
    return tuple(Column(head, kind="text", key=key, wraps=True) for key, head in heads.items())
