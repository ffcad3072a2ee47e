"""The verb that writes a site of many engines: site."""

from __future__ import annotations

from functools import partial
from pathlib import Path, PurePath
from typing import Annotated

from cyclopts import Parameter

from crankstar.cli.options import option, together
from crankstar.cli.output import complain, progress
from crankstar.files.catalog import names, tree_of
from crankstar.language.messages import _, _n
from crankstar.language.quoting import one_line
from crankstar.options.forms import STANDARD_OUTPUT, named, require
from crankstar.options.values import RequestError, refusal

USUAL = "crankstar-site"


def site(
    *engines: Annotated[
        str, Parameter(help="Engines: names from the catalog, or files; default: the catalog.")
    ],
    output: Annotated[
        str | None, option("--output", f"Here a directory; default: {USUAL}.")
    ] = None,
) -> None:
    """Write engines as a site for any web host: a gallery of pictures, and a page of each."""
    place = Path(USUAL if output is None else output)
    from crankstar.site.building import build, check_place
    from crankstar.site.pages import Subject, card_of
    from crankstar.stars.interrupts import ended_once

    def subject_of(word: str) -> Subject:
        _name, tree = tree_of(word)
        name = PurePath(named(word)).stem
        subject = Subject("engine" if name == "-" else name, tree, named(word))
        card_of(subject)
        return subject

    _chart, _film, _place, *subjects = together(
        partial(require, "chart"),
        partial(require, "film"),
        lambda: _refuse_stream(output) or check_place(place),
        *(partial(subject_of, word) for word in engines or names()),
    )
    stems = [subject.name for subject in subjects]
    if twice := sorted({name for name in stems if stems.count(name) > 1}):
        raise RequestError(
            "two engines would have the page {name}; rename one of the files", name=twice[0]
        )
    with ended_once(), progress(_("Drawing")) as tell:
        build(subjects, place, tell=tell)
    complain(
        _n(
            "Wrote {count} engine into {folder}; open {index}",
            "Wrote {count} engines into {folder}; open {index}",
            len(subjects),
            count=len(subjects),
            folder=one_line(str(place)),
            index=one_line(str(place / "index.html")),
        )
    )


def _refuse_stream(output: str | None) -> None:
    if output is not None and output in STANDARD_OUTPUT:
        raise refusal("-o", "-", "name a directory")
