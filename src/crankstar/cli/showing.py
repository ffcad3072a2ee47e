"""The verb that writes the page on which an engine turns: page."""

from __future__ import annotations

from functools import partial
from pathlib import PurePath
from typing import Annotated

from cyclopts import Parameter

from crankstar.cli.application import app
from crankstar.cli.options import EngineName, Settings, changed_tree, command_text, output, together
from crankstar.cli.output import progress, writable, write
from crankstar.files import engine_of
from crankstar.files.catalog import tree_of
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.forms import form_of


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
    form_of(output, ("html", "htm"))
    given = together(
        partial(changed_tree, engine, settings),
        *(partial(tree_of, name) for name in [beside] if name is not None),
    )
    engines = [engine_of(tree, name=name) for name, tree in given]
    names = [request.named(word) for word in (engine, beside) if word is not None]
    place = "page.html" if names[0] == "-" else f"{PurePath(names[0]).stem}.html"
    options = {"--beside": names[1:], "--set": settings, "-o": [place]}
    pages.bundle()
    with progress(_("Drawing")) as tell:
        data = held(
            engines,
            files_given=[tree for _, tree in given],
            sources=names,
            command=command_text("page", names[0], options),
            tell=tell,
        )
    content = pages.document(data)
    write(content, output)
