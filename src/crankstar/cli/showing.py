"""The verb that writes the page on which an engine turns: page."""

from __future__ import annotations

from functools import partial
from typing import Annotated

from crankstar.cli.options import (
    EngineName,
    Estimating,
    Settings,
    command_text,
    option,
    read_engine,
    together,
)
from crankstar.cli.output import progress, writable, write_result
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.forms import form_of, named, refuse_terminal, usual_place


def page(
    engine: EngineName,
    /,
    *,
    beside: Annotated[
        list[str] | None, option("--beside", "At the same crank angle; one only.")
    ] = None,
    settings: Settings = None,
    estimate: Estimating = False,
    output: Annotated[str | None, option("--output", ".html; default: ENGINE.html.")] = None,
) -> None:
    """Write a page on which the engine turns, with the whole analysis, as one HTML file."""
    from crankstar.page import standalone as pages
    from crankstar.page.library import held

    usual = usual_place(engine, kind="html")
    names = (beside or [])[:1]
    second, _place, _form, _terminal, *given = together(
        partial(request.single, "--beside", beside),
        partial(writable, usual if output is None else output),
        partial(form_of, output, ("html", "htm")),
        partial(refuse_terminal, output, ("html",)),
        partial(read_engine, engine, settings, estimate=estimate),
        *(partial(read_engine, name, estimate=estimate) for name in names),
    )
    engines = [loaded.engine for loaded in given]
    names = [named(word) for word in (engine, second) if word is not None]
    flags = {"--estimate": [""] if estimate else None}
    options = {"--beside": names[1:], "--set": settings, **flags, "-o": [usual]}
    pages.bundle()
    with progress(_("Drawing")) as tell:
        data = held(
            engines,
            files_given=[loaded.tree for loaded in given],
            sources=names,
            command=command_text("page", names[0], options),
            tell=tell,
        )
    content = pages.document(data)
    write_result(content, output, usual)
