"""The verb that writes the page on which an engine turns: page."""

from __future__ import annotations

import shlex
from pathlib import PurePath
from typing import Annotated

from cyclopts import Parameter

from crankstar.cli.application import app
from crankstar.cli.options import EngineName, Settings, output
from crankstar.cli.output import kind_of, progress, writable, write
from crankstar.files import changed, engine_of
from crankstar.files.catalog import tree_of
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.values import RequestError


@app.command
def page(
    engine: EngineName,
    /,
    *,
    beside: Annotated[
        str | None, Parameter(help="Another engine, at the same crank angle beside it.")
    ] = None,
    settings: Settings = None,
    output: Annotated[str, output("File to write, such as v8.html.")],
) -> None:
    """Write a page on which the engine turns, with the whole analysis, as one HTML file."""
    from crankstar.page import standalone as pages
    from crankstar.page.library import held

    writable(output)
    kind_of(output, ("html", "htm"), what="a page")
    words = [engine] if beside is None else [engine, beside]
    given = [tree_of(name) for name in words]
    name, tree = given[0]
    given[0] = (
        name,
        changed(tree, dict(request.setting(text) for text in settings or ()), name=name),
    )
    engines = [engine_of(tree, name=name) for name, tree in given]
    names = [request.named(word) for word in words]
    place = "page.html" if names[0] == "-" else f"{PurePath(names[0]).stem}.html"
    options = [
        *(("--beside", names[1]) if beside is not None else ()),
        *(word for text in settings or () for word in ("--set", text)),
    ]
    try:
        pages.bundle()
        with progress(_("drawing")) as tell:
            data = held(
                engines,
                files_given=[tree for _, tree in given],
                sources=names,
                command=shlex.join(["crankstar", "page", names[0], *options, "-o", place]),
                tell=tell,
            )
        content = pages.document(data)
    except pages.PageError as error:
        raise RequestError(str(error)) from None
    write(content, output)
