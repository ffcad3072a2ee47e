"""Verbs that show an engine turning: page."""

from __future__ import annotations

import shlex
from pathlib import PurePath
from typing import Annotated

from cyclopts import Parameter

from crankstar import chart_request, request
from crankstar.catalog import tree_of
from crankstar.cli.application import app
from crankstar.cli.options import EngineName, Settings
from crankstar.files import changed, engine_of
from crankstar.output import kind_of, progress, writable, write
from crankstar.request import RequestError


@app.command
def page(
    engine: EngineName,
    /,
    *,
    beside: Annotated[str | None, Parameter(help="another engine, to turn beside it at the same crank angle")] = None,
    settings: Settings = None,
    output: Annotated[str, Parameter(name=["--output", "-o"], help="the file to write, as in v8.html")],
) -> None:
    """Write one HTML file on which the engine turns, with the whole analysis; opens from disk without a network."""
    from crankstar import page as pages
    from crankstar.exhibit.library import held

    chart_request.charts()
    writable(output)
    kind_of(output, ("html", "htm"), what="a page")
    words = [engine] if beside is None else [engine, beside]
    given = [tree_of(name) for name in words]
    name, tree = given[0]
    given[0] = name, changed(tree, dict(request.setting(text) for text in settings or ()), name=name)
    engines = [engine_of(tree, name=name) for name, tree in given]
    names = [request.named(word) for word in words]
    place = "page.html" if names[0] == "-" else f"{PurePath(names[0]).stem}.html"
    told = [*(("--beside", names[1]) if beside is not None else ()), *(word for text in settings or () for word in ("--set", text))]
    try:
        pages.bundle()
        with progress("drawing") as tell:
            data = held(
                engines,
                files_given=[tree for _, tree in given],
                sources=names,
                command=shlex.join(["crankstar", "page", names[0], *told, "-o", place]),
                tell=tell,
            )
        content = pages.document(data)
    except pages.PageError as error:
        raise RequestError(str(error)) from None
    write(content, output)
