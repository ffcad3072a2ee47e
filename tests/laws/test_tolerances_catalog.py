"""Every engine of the catalog with a tolerance on every value: law and random engines agree."""

from __future__ import annotations

from typing import Any

import pytest

from crankstar.analyses.tolerance.scatter import ScatterError, scatter_of
from crankstar.engine.records import Record
from crankstar.files import engine_of, explicit
from crankstar.files.catalog import names, tree_of
from crankstar.files.forms import field_at, form_of, quantity_of
from crankstar.studies.fields import Source

SMALL = 1e-3


def toleranced(tree: dict[str, Any]) -> dict[str, Any]:
    """The tree with a tolerance of a thousandth behind every value that may have one."""
    form = form_of(tree)
    return {key: _with(item, form, (key,)) for key, item in tree.items() if key != "provenance"}


def _with(value: Any, form: type[Record], path: tuple[str | int, ...]) -> Any:
    if isinstance(value, dict):
        return {key: _with(item, form, (*path, key)) for key, item in value.items()}
    if isinstance(value, list):
        return [_with(item, form, (*path, place)) for place, item in enumerate(value)]
    info = field_at(form, path)
    if info is None or quantity_of(info) is None or isinstance(value, bool):
        return value
    if isinstance(value, int | float):
        return f"{value} +- {SMALL}"
    number, _space, unit = value.partition(" ")
    return f"{value} +- 0.1 %" if float(number) else f"{value} +- {SMALL} {unit}"


@pytest.mark.many(first=5)
@pytest.mark.parametrize("form", ["short", "explicit"])
@pytest.mark.parametrize("name", names())
def test_law_and_random_engines_agree(name: str, form: str) -> None:
    _shown, tree = tree_of(name)
    tree = toleranced(explicit(engine_of(tree)) if form == "explicit" else tree)
    try:
        found = scatter_of(Source(name, tree), count=4000)
    except ScatterError:
        assert form == "short"  # which may give angles of a single throw, or numbers alone
        return
    scattering = [row for row in found.rows if row.rms > 0]
    assert scattering
    for row in scattering:
        assert row.rms_found == pytest.approx(row.rms, rel=0.08), (row.signal, row.order)
        assert row.worst >= row.nominal
        assert row.half_of <= row.one_in_20 <= row.one_in_100
        assert sum(row.shares.values()) == pytest.approx(1)
