"""What is wrong with a command line or a file that cannot be written, in the reader's language."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from cyclopts import CycloptsError, UnknownOptionError, UnusedCliTokensError

from crankstar.language.messages import N_, _
from crankstar.language.quoting import one_line, seen
from crankstar.options.names import meant
from crankstar.options.refusals import refusal

if TYPE_CHECKING:
    from pydantic_core import ErrorDetails

PARSED = (
    N_('Command "{command}" parameter {parameter} requires an argument.'),
    N_('Invalid value for {parameter}: unable to convert "{value}" into a whole number.'),
    N_('Invalid value for {parameter}: unable to convert "{value}" into a number.'),
    N_('Invalid value for {parameter}: unable to convert "{value}" into yes or no.'),
    N_('Invalid value "{value}" for {parameter}. Choose from: {choices}. Did you mean "{near}"?'),
    N_('Invalid value "{value}" for {parameter}. Choose from: {choices}.'),
    N_('Unknown command "{value}". Did you mean "{near}"? Available commands: {choices}'),
    N_('Unknown command "{value}". Available commands: {choices}'),
    N_("Parameter {parameter} specified multiple times."),
)
"""What the parser of command lines says, with the kinds of values in plain words."""
KINDS = {"int": "a whole number", "float": "a number", "bool": "yes or no"}


def complaint(error: CycloptsError) -> str:
    """The mistake in the words of a command line, and the command that explains them."""
    from pydantic import ValidationError

    if isinstance(error.__cause__, ValidationError):
        return "\n".join(map(_wrong_word, error.__cause__.errors(include_url=False)))
    if isinstance(error, UnknownOptionError):
        text = _unknown_option(error)
    elif isinstance(error, UnusedCliTokensError):
        text = _(
            "too many arguments: {words}", words=", ".join(map(seen, error.unused_tokens or ()))
        )
    else:
        text = _translated(one_line(str(error).strip(), longest=300))
    command = " ".join(["crankstar", *(error.command_chain or ())])
    return _("{mistake}\nSee: {command} --help", mistake=text, command=command)


def _unknown_option(error: UnknownOptionError) -> str:
    """An option that the command has not, and the one that is meant, also by another name."""
    word = (error.token.keyword or error.token.value).partition("=")[0]
    own = [name for argument in error.argument_collection for name in argument.names]
    near = meant(word, sorted(name for name in own if name.startswith("--")))
    text = _("Unknown option: {option}.", option=one_line(word, longest=60))
    return (
        text if near is None else _("{mistake} Did you mean {option}?", mistake=text, option=near)
    )


def _wrong_word(mistake: ErrorDetails) -> str:
    """What a record of options does not take."""
    option = "--" + str(mistake["loc"][0]).replace("_", "-")
    choices = mistake.get("ctx", {}).get("expected", "").replace("'", "").replace(" or ", ", ")
    if not choices:
        return f"{option}: {mistake['msg']}"
    return str(refusal(option, mistake["input"], "choose from {choices}", choices=choices))


def unwritable(error: OSError) -> str:
    """A file, or standard output, that could not be written."""
    reason = error.strerror or error
    if error.filename is None:
        return _(
            "standard output or a temporary file (TMPDIR) cannot be written ({reason}); free some "
            "space, or name a file with -o",
            reason=reason,
        )
    return _(
        "{file} cannot be written ({reason}); free some space, or name another file with -o",
        file=one_line(str(error.filename)),
        reason=reason,
    )


def _translated(text: str) -> str:
    """What the parser says, translated where its sentence is known."""
    for kind, words in KINDS.items():
        text = re.sub(rf"into {kind}\b\.?$", f"into {words}.", text)
    for sentence in PARSED:
        pattern = re.sub(r"\\{(\w+)\\}", r"(?P<\1>.+?)", re.escape(sentence))
        if match := re.fullmatch(pattern, text):
            return _(sentence, **match.groupdict())
    return text
