"""The application: how a command line is read, and how the process ends whatever happens."""

from __future__ import annotations

import os
import sys
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from cyclopts import App, CycloptsError

from crankstar import __version__
from crankstar.analysis.registry import NAMES as ANALYSES
from crankstar.analysis.registry import added
from crankstar.cli.complaints import complaint, unwritable
from crankstar.cli.output import abandon, complain
from crankstar.cli.system_language import of_system
from crankstar.cli.words import (
    COMPLETION,
    refuse_files,
    spelt_out,
    told_beside,
    wanted_language,
    wanted_units,
)
from crankstar.engine.packages import PackageWarning
from crankstar.files.read_files import files_noted
from crankstar.language import spelling
from crankstar.language.messages import (
    LANGUAGES,
    N_,
    NAMES,
    MessageError,
    _,
    language,
    speak,
    spoken,
)
from crankstar.language.shown_units import shown_in
from crankstar.stars.faults import SearchError

LEAST_WIDTH = 20
"""Columns of help, at least."""
EVERYWHERE = N_(
    "Every command also takes --units (or CRANKSTAR_UNITS), the units of its results: si, us, or "
    "units with commas, as in kN, kN m; and --language (or CRANKSTAR_LANG), the language: en, ja "
    "or ru (default: that of the system)."
)
"""The options that are taken out of the words before a command is read, at the end of any help."""
VERBS = {
    "analyze": "inspect:analyze",
    "animate": "drawing:animate",
    "balance": "balancing:balance",
    "check": "files:check",
    "compare": "inspect:compare",
    "derive": "deriving:derive",
    "draw": "drawing:draw",
    "estimate": "estimating:estimate",
    "export": "exporting:export",
    "list": "inspect:list_engines",
    "new": "files:new",
    "page": "showing:page",
    "plot": "picturing:plot",
    "report": "reporting:write_report",
    "schema": "files:schema",
    "search": "searching:search",
    "serve": "serving:serve",
    "show": "inspect:show",
    "site": "siting:site",
    "sound": "sounding:sound",
    "sweep": "sweeping:sweep",
}
"""The module of this room and the function of each verb; only the one that is asked is loaded."""
app = App(
    name="crankstar",
    help="Compute how a piston engine shakes, why, and what to do about it. ENGINE is a name from "
    "the catalog or a file in TOML, JSON or Excel (.xlsx); - reads standard input.",
    version=__version__,
    help_format="plaintext",
    result_action="return_value",
    suppress_keyboard_interrupt=False,
)
app.register_install_completion_command(
    COMPLETION, help="Install completion of commands and options in this shell."
)
VERBS.update({name: f"analyses:{name}" for name in ANALYSES})
for _verb, _place in sorted(VERBS.items()):
    app.command(f"crankstar.cli.{_place}", name=_verb)


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line and exit: 0 done, 2 for a bad request or file, 130 interrupted."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors=spelling.register())  # pyright: ignore[reportAttributeAccessIssue]
    for size in ("COLUMNS", "LINES"):  # rich takes every digit for a number, also "²"
        if not os.environ.get(size, "0").isdecimal():
            del os.environ[size]
    words = list(sys.argv[1:] if arguments is None else arguments)
    with spoken(of_system(os.environ)):
        code = _code(words)
    abandon()
    sys.exit(code)


def _code(words: list[str]) -> int:
    """Run a command line, its complaints in the language it asks for. Returns the exit code."""
    try:
        wanted = wanted_language(words)
        speak(wanted or language(), named=wanted is not None)
        _doubt_encoding()
        with shown_in(wanted_units(words)), files_noted(), _packages_told():
            if not words and _gallery():
                raise SystemExit(0)
            helping = not words or bool({"--help", "-h"} & set(words))
            if helping or not (words[0].startswith("-") or words[0] in VERBS):
                _add_verbs(words)
            if helping:  # only help needs its libraries
                _prepare_help(words)
            refuse_files(words)
            code = app(spelt_out(words), exit_on_error=False, print_error=False) or 0
        if sys.stdout is not None:
            sys.stdout.flush()
    except CycloptsError as error:
        return _refuse(complaint(error))
    except MessageError as error:
        return _refuse(told_beside(error, words))
    except SearchError as error:
        return _refuse(error.in_options())
    except BrokenPipeError:
        return 0  # the reader of the pipe has all it wanted
    except SystemExit as ended:  # rich raises it for a broken pipe, cyclopts without a shell
        return 2 if ended.code and COMPLETION in words else 0
    except OSError as error:
        return _refuse(unwritable(error))
    except MemoryError:
        return _refuse(_("not enough memory for this engine; try fewer cylinders, or longer rods"))
    except KeyboardInterrupt:
        return 130
    return code


def _add_verbs(words: Sequence[str]) -> None:
    """Have the analyses of other packages as verbs too: the one that is asked, or all."""
    asked = [name for name in added().names() if words[:1] == [name]]
    for name in asked or added().usable():
        if name not in VERBS:
            VERBS[name] = f"analyses:{name}"
            app.command(f"crankstar.cli.{VERBS[name]}", name=name)


@contextmanager
def _packages_told() -> Iterator[None]:
    """Have a line on standard error for what another package adds and is skipped."""
    with warnings.catch_warnings():
        warnings.simplefilter("always", PackageWarning)
        others = warnings.showwarning

        def shown(message: Warning | str, category: type[Warning], *more: Any) -> None:
            if issubclass(category, PackageWarning):
                complain(str(message))
            else:
                others(message, category, *more)

        warnings.showwarning = shown
        yield


def _prepare_help(words: Sequence[str]) -> None:
    """Have help in the language of the context, as wide as is asked for."""
    from crankstar.cli.help import TranslatedHelp

    app.help_formatter = TranslatedHelp()
    app.help_epilogue = _(EVERYWHERE)
    if not VERBS.keys() & set(words):  # the list of verbs has a line of each
        app.resolved_commands()
    if columns := os.environ.get("COLUMNS"):  # help is endless in a column or two
        width = int(columns) if columns.isdecimal() and len(columns) < 5 else 80
        os.environ["COLUMNS"] = str(max(width, LEAST_WIDTH))


def _gallery() -> bool:
    """Serve the gallery where a bare command may open a browser; whether it was served."""
    if sys.stdout is None or not sys.stdout.isatty():
        return False
    from crankstar.cli.serving import gallery, gallery_wanted

    wanted = gallery_wanted()
    if wanted:
        gallery()
    return wanted


def _doubt_encoding() -> None:
    """Say so, in English, where standard output has no letters for the language of the context."""
    encoding = getattr(sys.stdout, "encoding", None) or "utf-8"
    try:
        NAMES[language()].encode(encoding)
    except UnicodeEncodeError:
        wanted = language()
        setting = "PYTHONIOENCODING=utf-8" if "PYTHONIOENCODING" in os.environ else "PYTHONUTF8=1"
        with spoken(LANGUAGES[0]):
            complain(
                _(
                    "crankstar: the encoding of the terminal, {encoding}, cannot show the language "
                    "{language}; set {setting}, or take --language en",
                    encoding=encoding,
                    language=wanted,
                    setting=setting,
                )
            )


def _refuse(message: str) -> int:
    complain(f"crankstar: {message}")
    return 2
