"""The application: how a command line is read, and how the process ends whatever happens."""

from __future__ import annotations

import os
import re
import sys
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from itertools import pairwise
from typing import Any

from cyclopts import App, CycloptsError

from crankstar import __version__
from crankstar.analysis.registry import NAMES as ANALYSES
from crankstar.analysis.registry import added
from crankstar.cli.complaints import complaint, unwritable
from crankstar.cli.output import LOST, OutputError, abandon, complain, is_file
from crankstar.cli.system_language import of_system
from crankstar.engine.packages import PackageWarning
from crankstar.files.read_files import STANDARD_INPUT, files_noted
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
from crankstar.language.quoting import one_line, seen
from crankstar.language.shown_units import SYSTEMS, Choice, UnitsError, read_choice, shown_in
from crankstar.options.forms import STANDARD_OUTPUT
from crankstar.options.refusals import RequestError, refuse_empty
from crankstar.options.vocabulary import OPTIONS
from crankstar.stars.faults import SearchError

COMPLETION = "--install-completion"
NEEDED = "needed"
"""What --shafts means without speed ratios."""
FILES = ("--before", "--beside", "--checkpoint", "--engine-file", "--output", "--save")
"""Options that take a file."""
WRITTEN = ("-o", "--output", "--engine-file", "--save")
"""Options that take a file which is written."""
NAMING = (*WRITTEN, "--before", "--point")
"""Options that name something, which an empty text does not."""
LANGUAGE = ("--language", "--lang")
"""The option of the language, and its short name."""
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
    "bobweight": "workshop:bobweight",
    "check": "files:check",
    "compare": "inspect:compare",
    "correct": "correcting:correct",
    "derive": "deriving:derive",
    "draw": "drawing:draw",
    "drill": "workshop:drill",
    "errata": "deriving:errata",
    "estimate": "estimating:estimate",
    "export": "exporting:export",
    "grade": "workshop:grade",
    "list": "inspect:list_engines",
    "match": "matching:match",
    "new": "files:new",
    "orders": "firing:orders",
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
    "tolerance": "tolerances:tolerance",
    "vees": "firing:vees",
    "verdict": "inspect:verdict",
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
VERBS |= {name: f"analyses:{name}" for name in ANALYSES}
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
        wanted = _language(words)
        speak(wanted or language(), named=wanted is not None)
        _doubt_encoding()
        with shown_in(_units(words)), files_noted(), _packages_told():
            if not words and _gallery():
                raise SystemExit(0)
            helping = not words or bool({"--help", "-h"} & set(words))
            if helping or not (words[0].startswith("-") or words[0] in VERBS):
                _add_verbs(words)
            if helping:  # only help needs its libraries
                _prepare_help(words)
            _refuse_source(words)
            code = app(_spelt_out(words), exit_on_error=False, print_error=False) or 0
        if sys.stdout is not None:
            sys.stdout.flush()
    except CycloptsError as error:
        return _refuse(complaint(error))
    except MessageError as error:
        return _refuse(str(error))
    except SearchError as error:
        return _refuse(error.text(lambda option: f"--{option.replace('_', '-')}"))
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


def _language(words: list[str]) -> str | None:
    """The language of --language, taken out of the words, else of its variable, if any.

    Raises RequestError.
    """
    asked, wanted = _taken(words, LANGUAGE, "CRANKSTAR_LANG")
    if wanted is not None and wanted not in LANGUAGES:
        raise RequestError(
            "{option} {language}: the languages are {languages}",
            option=asked,
            language=seen(wanted),
            languages=", ".join(LANGUAGES),
        )
    return wanted


def _doubt_encoding() -> None:
    """Say so, in English, where standard output has no letters for the language of the context."""
    encoding = getattr(sys.stdout, "encoding", None) or "utf-8"
    try:
        NAMES[language()].encode(encoding)
    except UnicodeEncodeError:
        wanted = language()
        with spoken(LANGUAGES[0]):
            complain(
                _(
                    "crankstar: the encoding of the terminal, {encoding}, cannot show the language "
                    "{language}; set PYTHONUTF8=1, or take --language en",
                    encoding=encoding,
                    language=wanted,
                )
            )


def _units(words: list[str]) -> Choice:
    """The units of --units, which is taken out of the words, or of CRANKSTAR_UNITS, or SI."""
    asked, text = _taken(words, ("--units",), "CRANKSTAR_UNITS")
    try:
        return SYSTEMS["si"] if text is None else read_choice(text)
    except UnitsError as error:
        raise RequestError(f"{asked}: {error}") from None


def _taken(words: list[str], names: Sequence[str], variable: str) -> tuple[str, str | None]:
    """An option for all commands, taken out of the words, or its variable: which, and its value.

    Raises RequestError where it stands twice.
    """
    given = [word for word in words if word.partition("=")[0] in names]
    if len(given) > 1:
        raise RequestError("{option} stands twice; give it once", option=given[1].partition("=")[0])
    for place, word in enumerate(words):
        option, equals, value = word.partition("=")
        if option in names:
            value = value if equals else "".join(words[place + 1 : place + 2])
            del words[place : place + (1 if equals else 2)]
            return option, value
    return variable, os.environ.get(variable) or None


def _spelt_out(arguments: Sequence[str]) -> list[str]:
    """Arguments in the form that the parser needs.

    It would take a lone hyphen, a file name, for an option; --shafts must have a value.
    """
    if COMPLETION in arguments and "-" in arguments:
        raise RequestError(
            "{option} writes a file that the shell reads when it starts; name one, or leave -o out",
            option=COMPLETION,
        )
    pairs = zip(["", *arguments], arguments, strict=False)
    named = {"-o": "/dev/stdout", "--output": "/dev/stdout"}
    words = [
        word if word != "-" or _takes_words(before) else named.get(before, STANDARD_INPUT)
        for before, word in pairs
    ]
    if words.count(STANDARD_INPUT) > 1:
        raise RequestError("- is standard input, which can be read only once; name a file instead")
    for place in [place for place, word in enumerate(words) if word == "--shafts"][:1]:
        following = words[place + 1] if place + 1 < len(words) else "-o"
        if following.startswith("-") and following != "-" and not following[1:2].isdigit():
            words.insert(place + 1, NEEDED)
    return words


def _takes_words(option: str) -> bool:
    """Whether what follows it is no file, so that a hyphen there is not standard input."""
    known = OPTIONS.get(option)
    return known is not None and known.takes != "nothing" and option not in FILES


def _refuse_source(words: Sequence[str]) -> None:
    """Refuse empty names, and to write on a file that the command reads, or twice on one.

    Raises OutputError, RequestError.
    """
    apart = [re.sub("^-o(?=[^=])", "-o=", word) for word in words]
    parts = [part for word in apart for part in word.split("=", 1) if _may_be_a_file(part)]
    written = [(option, place) for option, place in pairwise(parts) if option in WRITTEN]
    for option, name in pairwise(parts):
        if option in NAMING:
            refuse_empty({option: name})
    _refuse_twice(written)
    for option, place in written:
        if not (is_file(place) or option in ("--engine-file", "--save")):
            continue
        real = os.path.realpath(place)
        if [os.path.realpath(part) for part in parts].count(real) > 1:
            raise OutputError(LOST, file=one_line(place), option=option)


def _refuse_twice(written: Sequence[tuple[str, str]]) -> None:
    """Refuse two options that name one file. Raises RequestError."""
    seen_at: dict[str, str] = {}
    for option, place in written:
        other = seen_at.setdefault(os.path.realpath(place), option)
        if other != option and place not in STANDARD_OUTPUT:
            raise RequestError(
                "{first} and {second} name the same file, {file}; name another with one of them",
                first=other,
                second=option,
                file=one_line(place),
            )


def _may_be_a_file(text: str) -> bool:
    with suppress(UnicodeEncodeError):
        return b"\0" not in os.fsencode(text)
    return False


def _refuse(message: str) -> int:
    complain(f"crankstar: {message}")
    return 2
