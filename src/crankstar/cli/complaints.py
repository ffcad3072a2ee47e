"""What the parser of the command line refuses, in the reader's language."""

from __future__ import annotations

from difflib import get_close_matches
from typing import TYPE_CHECKING, Literal, get_args, get_origin

from cyclopts import (
    CoercionError,
    CycloptsError,
    MissingArgumentError,
    RepeatArgumentError,
    UnknownOptionError,
    UnusedCliTokensError,
)
from cyclopts.exceptions import UnknownCommandError

from crankstar.language.messages import N_, _
from crankstar.language.quoting import one_line, seen
from crankstar.options.names import meant
from crankstar.options.refusals import refusal

if TYPE_CHECKING:
    from pydantic_core import ErrorDetails

KINDS: dict[object, str] = {
    int: N_("{option}: unable to convert {given} into a whole number."),
    float: N_("{option}: unable to convert {given} into a number."),
    bool: N_("{option}: unable to convert {given} into yes or no."),
}
"""By the type of an option, that its value is not of this type."""


def complaint(error: CycloptsError) -> str:
    """The mistake in the words of a command line, and the command that explains them."""
    from pydantic import ValidationError

    if isinstance(error.__cause__, ValidationError):
        return "\n".join(map(_wrong_word, error.__cause__.errors(include_url=False)))
    command = " ".join(["crankstar", *(error.command_chain or ())])
    return _("{mistake}\nSee: {command} --help", mistake=_mistake(error), command=command)


def _mistake(error: CycloptsError) -> str:
    match error:
        case UnknownOptionError():
            return _unknown_option(error)
        case UnknownCommandError():
            return _unknown_command(error)
        case UnusedCliTokensError():
            words = ", ".join(map(seen, error.unused_tokens or ()))
            return _("too many arguments: {words}", words=words)
        case MissingArgumentError(argument=argument) if argument is not None:
            named = [token.keyword for token in argument.tokens if token.keyword]
            name = error.keyword or (named[-1] if named else argument.name)
            return _("{option} requires an argument.", option=name)
        case RepeatArgumentError(token=token):
            return _("{option} is specified multiple times.", option=token.keyword)
        case CoercionError():
            return _no_value(error)
        case _:
            return one_line(str(error).strip(), longest=300)


def _unknown_option(error: UnknownOptionError) -> str:
    """An option that the command has not, and the one that is meant, also by another name."""
    word = (error.token.keyword or error.token.value).partition("=")[0]
    own = [name for argument in error.argument_collection for name in argument.names]
    near = meant(word, sorted(name for name in own if name.startswith("--")))
    text = _("Unknown option: {option}.", option=one_line(word, longest=60))
    return _near(text, near)


def _unknown_command(error: UnknownCommandError) -> str:
    """A command that there is not, and the one that is meant."""
    (word, *_rest) = error.unused_tokens or [""]
    known = [name for name in error.app or () if not name.startswith("-")]
    near = get_close_matches(word, known, n=1)
    text = _('Unknown command "{command}".', command=one_line(word, longest=60))
    return _near(text, f'"{near[0]}"' if near else None)


def _near(text: str, near: str | None) -> str:
    return (
        text if near is None else _("{mistake} Did you mean {option}?", mistake=text, option=near)
    )


def _no_value(error: CoercionError) -> str:
    """A value that is not of the type of its option, or not among its choices."""
    token, kind = error.token, error.target_type
    if token is None or error.argument is None:
        return one_line(str(error).strip(), longest=300)
    option = token.keyword or error.argument.name.lstrip("-").upper()
    if get_origin(kind) is Literal:
        choices = ", ".join(map(str, get_args(kind)))
        return str(refusal(option, token.value, "choose from {choices}", choices=choices))
    kind = next((each for each in KINDS if each in (kind, *get_args(kind))), None)
    if kind is None:
        return one_line(str(error).strip(), longest=300)
    return _(KINDS[kind], option=option, given=seen(token.value))


def _wrong_word(mistake: ErrorDetails) -> str:
    """What a record of options does not take."""
    option = "--" + str(mistake["loc"][0]).replace("_", "-")
    choices = mistake.get("ctx", {}).get("expected", "").replace("'", "").replace(" or ", ", ")
    if not choices:
        return f"{option}: {mistake['msg']}"
    return str(refusal(option, mistake["input"], "choose from {choices}", choices=choices))
