"""The words of a command line before they are parsed: what the parser cannot be told.

Two options belong to every command and hold before its others are read, since refusals are in that
language and those units; a lone hyphen is a file to us and an option to the parser; --shafts may
stand without a value; and no file may be written that is read or written under another name.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from contextlib import suppress
from itertools import pairwise

from crankstar.cli.output import LOST, OutputError, is_file, writable
from crankstar.files.read_files import STANDARD_INPUT
from crankstar.language.messages import LANGUAGES, MessageError
from crankstar.language.quoting import one_line, seen
from crankstar.language.shown_units import SYSTEMS, Choice, UnitsError, read_choice
from crankstar.options.forms import STANDARD_OUTPUT
from crankstar.options.refusals import RequestError, refuse_empty
from crankstar.options.vocabulary import OPTIONS

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


def wanted_language(words: list[str]) -> str | None:
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


def wanted_units(words: list[str]) -> Choice:
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
    for index, word in enumerate(words):
        option, equals, value = word.partition("=")
        if option in names:
            value = value if equals else "".join(words[index + 1 : index + 2])
            del words[index : index + (1 if equals else 2)]
            return option, value
    return variable, os.environ.get(variable) or None


def spelt_out(arguments: Sequence[str]) -> list[str]:
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
    for place in [index for index, word in enumerate(words) if word == "--shafts"][:1]:
        following = words[place + 1] if place + 1 < len(words) else "-o"
        if following.startswith("-") and following != "-" and not following[1:2].isdigit():
            words.insert(place + 1, NEEDED)
    return words


def _takes_words(option: str) -> bool:
    """Whether what follows it is no file, so that a hyphen there is not standard input."""
    known = OPTIONS.get(option)
    return known is not None and known.takes != "nothing" and option not in FILES


def refuse_files(words: Sequence[str]) -> None:
    """Refuse empty names, and to write on a file that the command reads, or twice on one.

    Raises OutputError, RequestError.
    """
    parts, written = _written(words)
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


def _written(words: Sequence[str]) -> tuple[list[str], list[tuple[str, str]]]:
    """The words, options apart from their values, and those that name a file to write."""
    apart = [re.sub("^-o(?=[^=])", "-o=", word) for word in words]
    parts = [part for word in apart for part in word.split("=", 1) if _may_be_a_file(part)]
    return parts, [(option, place) for option, place in pairwise(parts) if option in WRITTEN]


def told_beside(error: MessageError, words: Sequence[str]) -> str:
    """What is wrong with a command line, and besides which of its files cannot be written.

    A verb finds that out when it writes, unless it takes long.
    """
    told = [str(error)]
    if not isinstance(error, OutputError):
        for option, place in _written(words)[1]:
            if os.path.isdir(place):  # noqa: PTH112  # Path.is_dir raises of impossible names
                continue  # some write into one
            try:
                writable(place, option=option)
            except OutputError as other:
                told += [] if str(other) in told[0] else [str(other)]
    return "\n".join(told)


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
