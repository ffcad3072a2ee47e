"""The verb that writes the page on which an engine turns: page."""

from __future__ import annotations

from functools import partial
from typing import Annotated

from crankstar.cli.application import app
from crankstar.cli.options import EngineName, Settings, changed_tree, command_text, option, together
from crankstar.cli.output import progress, writable, write_result
from crankstar.files import engine_of
from crankstar.files.catalog import tree_of
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.forms import form_of, refuse_terminal, usual_place


@app.command
def page(
    engine: EngineName,
    /,
    *,
    beside: Annotated[
        list[str] | None, option("--beside", "At the same crank angle; one only.")
    ] = None,
    settings: Settings = None,
    output: Annotated[str | None, option("--output", ".html; default: ENGINE.html.")] = None,
) -> None:
    """Write a page on which the engine turns, with the whole analysis, as one HTML file."""
    from crankstar.page import standalone as pages
    from crankstar.page.library import held

    usual = usual_place(engine, kind="html")
    writable(usual if output is None else output)
    form_of(output, ("html", "htm"))
    refuse_terminal(output, ("html",))
    second = request.single("--beside", beside)
    given = together(
        partial(changed_tree, engine, settings),
        *(partial(tree_of, name) for name in [second] if name is not None),
    )
    engines = [engine_of(tree, name=name) for name, tree in given]
    names = [request.named(word) for word in (engine, second) if word is not None]
    options = {"--beside": names[1:], "--set": settings, "-o": [usual]}
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
    write_result(content, output, usual)
