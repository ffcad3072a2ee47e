"""The form in which a result is written: by an option, else by the name of its file."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence
from importlib.util import find_spec
from pathlib import PurePath

from crankstar.files.read_files import STANDARD_INPUT
from crankstar.language.quoting import one_line
from crankstar.options.refusals import RequestError, refusal

STANDARD_OUTPUT = (None, "-", "/dev/stdout", "/dev/fd/1", "/proc/self/fd/1")
"""Standard output is written to in place: another program may write to the same file."""
TABLES = ("txt", "csv", "json", "xlsx", "parquet")
"""Forms of a Document, as file names end; txt is for readers."""
PICTURES = ("svg", "png", "pdf", "html")
ENGINES = ("toml", "json", "xlsx")
"""Forms of an engine file."""
DERIVATIONS = {"txt": "text", "tex": "latex", "md": "markdown", "html": "html"}
"""Formats of a derivation by how file names end."""
EXTRAS = {
    "xlsx": ("openpyxl", "spreadsheet"),
    "parquet": ("pyarrow", "parquet"),
    "glb": ("trimesh", "solids"),
    "stl": ("trimesh", "solids"),
    "chart": ("vl_convert", "charts"),
    "film": ("PIL", "film"),
    "mp4": ("imageio_ffmpeg", "film"),
}
"""The library that a form needs, and the extra of this package that brings it."""


def named(engine: str) -> str:
    """The name of an engine in a command for others: a file without its directory, printable.

    >>> named("v8-cross-plane"), named("/home/me/v8.toml"), named("/dev/stdin")
    ('v8-cross-plane', 'v8.toml', '-')
    """
    return "-" if engine == STANDARD_INPUT else one_line(PurePath(engine).name)


def form_of(
    path: str | None, forms: Sequence[str], *, json: bool = False, csv: bool = False
) -> str:
    """One of these forms: the one that is asked for, else by the suffix of the file's name.

    The first one is for standard output; if that is text, also for a name without suffix. Raises
    RequestError.
    """
    if json and csv:
        raise RequestError("--json and --csv exclude each other")
    flag = "json" if json else "csv" if csv else ""
    piped, suffix = path in STANDARD_OUTPUT, suffix_of(path)
    if flag and suffix in forms and suffix not in ("txt", flag):
        raise refusal(
            "-o", path, "the name ends in .{suffix}; leave --{flag} out", suffix=suffix, flag=flag
        )
    if flag and suffix in (*PICTURES, "toml"):
        raise refusal("-o", path, "the name must end in {names}", names=f".{flag}")
    form = flag or suffix or (forms[0] if piped or forms[0] in ("txt", "toml", "json") else "")
    if form not in forms:
        names = ", ".join(f".{name}" for name in forms)
        raise refusal("-o", path, "the name must end in {names}", names=names)
    require(form)
    return form


def suffix_of(path: str | None) -> str:
    """How the name of a file ends, without the dot; empty for standard output.

    >>> suffix_of("four.TEX"), suffix_of("four"), suffix_of("-")
    ('tex', '', '')
    """
    named_file = "" if path is None or path in STANDARD_OUTPUT else path
    return PurePath(named_file).suffix.lower().removeprefix(".")


def format_of(path: str | None, formats: Mapping[str, str], *, asked: str | None) -> str:
    """One of these formats by suffix: the one that is asked for, else by the name of the file.

    A name that ends otherwise than what is written is refused. Raises RequestError.
    """
    if asked is None:
        return formats[form_of(path, tuple(formats))]
    own = next(suffix for suffix, name in formats.items() if name == asked)
    if suffix_of(path) not in ("", own):
        raise refusal("-o", path, "the name must end in {names}", names=f".{own}")
    return asked


def usual_place(engine: str, *what: str, kind: str) -> str:
    """The file in which a picture, a page or a report of an engine is kept where none is named.

    >>> usual_place("/home/me/v8.toml", "spectrum", kind="svg"), usual_place("-", kind="html")
    ('v8-spectrum.svg', 'engine.html')
    """
    stem = PurePath(named(engine)).stem
    return f"{'-'.join(('engine' if stem == '-' else stem, *what))}.{kind}"


def refuse_terminal(path: str | None, kinds: Sequence[str]) -> None:
    """Refuse to fill a terminal with a picture or a page. Raises RequestError."""
    if path in STANDARD_OUTPUT[1:3] and sys.stdout is not None and sys.stdout.isatty():
        raise RequestError(
            "a terminal cannot show this; name a file with -o that ends in {endings}",
            endings=", ".join(f".{kind}" for kind in kinds),
        )


def require(form: str) -> None:
    """Refuse a form whose library is not installed. Raises RequestError."""
    library, extra = EXTRAS.get(form, ("", ""))
    if library and find_spec(library) is None:
        raise RequestError(
            '{form}: this needs {library}; install it with: pip install "crankstar[{extra}]"',
            form=form,
            library=library,
            extra=extra,
        )
