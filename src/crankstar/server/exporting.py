"""Tasks of worker processes that give a file to keep: solids, a model, tables, report, the page."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from math import radians
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

from crankstar.engine.engine import Engine
from crankstar.files.box import Spread
from crankstar.server.forms import Form
from crankstar.server.refusal import refused
from crankstar.server.tasks import Tree, engine_of, mistakes_refused, units_of

if TYPE_CHECKING:
    from crankstar.analysis.assumptions import Assumption


class _Asked(NamedTuple):
    """The engine of a question, its tree, the ranges of its estimates, the crank angle (rad)."""

    engine: Engine
    tree: Tree
    spread: Spread | None
    theta: float


def exported(
    engine: str | Tree, form: Form, theta_deg: float = 0.0, units: str | None = None
) -> bytes:
    """An engine as a file of a form; the crank angle (degrees) is that of solids.

    Raises Refused, also where a package that the form needs is not installed.
    """
    from crankstar.page import exhibits

    with mistakes_refused(), units_of(units):
        made, tree = engine_of(engine)
        asked = _Asked(made, tree, exhibits.spread_of(made, tree), radians(theta_deg))
        try:
            return _WRITERS[form](asked)
        except ImportError as error:
            raise refused(422, "question.unbuilt", "form", name=error.name or form) from None


def _solids(asked: _Asked, form: Literal["glb", "stl"]) -> bytes:
    from crankstar.exports import solids

    write = solids.glb_bytes if form == "glb" else solids.stl_bytes
    return write(asked.engine, theta=asked.theta)


def _script(asked: _Asked) -> bytes:
    from crankstar.exports.exudyn import exudyn_script

    return exudyn_script(asked.engine).encode()


def _amplitudes(asked: _Asked) -> Any:
    from crankstar.mechanics.balance import balance
    from crankstar.tables.amplitudes import amplitudes
    from crankstar.tables.ranges import ranged

    def numbers(each: Engine) -> Any:
        return amplitudes(each, balance(each, speed=each.speed))

    return ranged(numbers, asked.spread, asked.engine)


def _csv(asked: _Asked) -> bytes:
    from crankstar.tables import machine

    return machine.csv_text(next(t for t in _amplitudes(asked).tables if t.key)).encode()


def _spreadsheet(asked: _Asked) -> bytes:
    from crankstar.files.sheets import sheets_of
    from crankstar.studies.answers import amplitudes, rests_on
    from crankstar.tables import analysis
    from crankstar.tables.ranges import ranged
    from crankstar.tables.spreadsheet import spreadsheet_bytes

    def sheet(each: Engine) -> Any:
        return analysis.document(analysis.analysis(each, speed=None))

    def rests() -> Sequence[Assumption]:
        return rests_on(asked.engine, amplitudes(asked.engine, both=True))

    document = ranged(sheet, asked.spread, asked.engine, rests=rests)
    document = replace(document, parts=(*document.parts, *_amplitudes(asked).tables))
    return spreadsheet_bytes(document, sheets_of(asked.tree))


def _report(asked: _Asked) -> bytes:
    from crankstar import report

    subject = report.Subject(
        asked.engine, asked.tree, "crankstar report", spreads=(asked.spread, None)
    )
    return report.report(subject).encode()


def _page(asked: _Asked) -> bytes:
    from crankstar.page.library import held
    from crankstar.page.standalone import document

    return document(held([asked.engine], files_given=[asked.tree])).encode()


_WRITERS: dict[Form, Callable[[_Asked], bytes]] = {
    "glb": lambda asked: _solids(asked, "glb"),
    "stl": lambda asked: _solids(asked, "stl"),
    "py": _script,
    "csv": _csv,
    "xlsx": _spreadsheet,
    "report": _report,
    "page": _page,
}
