"""The verb that estimates what a file leaves out: estimate."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any, get_args

from crankstar.cli.options import (
    Csv,
    EngineName,
    Json,
    Settings,
    engine_suffix,
    once,
    option,
    together,
    write_tree,
)
from crankstar.cli.output import writable_form
from crankstar.cli.tabulating import give
from crankstar.engine.quantities import VOLUME
from crankstar.engine.weighed import EngineType
from crankstar.files import changed, units
from crankstar.files.catalog import tree_of
from crankstar.options import values as request
from crankstar.options.forms import TABLES
from crankstar.options.refusals import refusal


def _volume(text: str | None) -> float | None:
    """The value of --displacement in m^3."""
    if text is None:
        return None
    with request.reading("--displacement"):
        volume = units.si(text, VOLUME)
    if volume <= 0:
        raise refusal("--displacement", text, 'give more than 0, such as "1998 cc"')
    return volume


def estimate(
    engine: EngineName,
    /,
    *,
    kind: Annotated[str | None, option("--type")] = None,
    displacement: Annotated[str | None, option("--displacement")] = None,
    settings: Settings = None,
    json: Json = False,
    csv: Csv = False,
    output: Annotated[
        str | None, option("--output", "The completed engine, in the form it was read in.")
    ] = None,
) -> None:
    """Estimate masses and lengths that a file leaves out; print them with range and source."""
    from crankstar.files.estimate import estimated
    from crankstar.tables.estimates import estimate_document

    there = once(partial(tree_of, engine))
    changes = once(partial(request.settings, settings))

    def read_tree() -> dict[str, Any]:
        name, tree = there()
        return changed(tree, changes(), name=name)

    form, wanted, volume, (name, _own), _changes, tree, _suffix = together(
        partial(writable_form, None, TABLES, json=json, csv=csv),
        lambda: kind and request.choice("--type", kind, get_args(EngineType)),
        partial(_volume, displacement),
        there,
        changes,
        read_tree,
        partial(engine_suffix, output),
    )
    result = estimated(tree, name=name, kind=wanted, displacement=volume)
    if output is not None:
        write_tree(result.tree, output)
    title = str(result.tree.get("name") or name)
    give(estimate_document(result, name=title), None, form=form)
