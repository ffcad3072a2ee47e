"""Requests that cannot be met: an option, a word that is not offered, an option without effect."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from typing import Any, TypeVar, cast

from crankstar.language.messages import MessageError, _, _n
from crankstar.language.quoting import one_line

T = TypeVar("T")


class RequestError(MessageError):
    """A request that cannot be met, as one sentence that says what would be right."""


class MistakesError(RequestError):
    """Several mistakes at once; carries the message of each."""

    def __init__(self, messages: Iterable[str]) -> None:
        self.messages = tuple(messages)
        text = "\n".join(self.messages)
        super().__init__(text)


def refusal(option: str, given: object, why: str, **values: object) -> RequestError:
    """The error for the value of an option: which option, what was given, what would be right."""
    return RequestError(f"{option} {one_line(str(given))}: {_(why, **values)}")


def not_compiled(error: ImportError) -> RequestError:
    """The refusal of a search where numba is not installed."""
    return RequestError(
        "searches are compiled with numba ({error}); install it with: pip install "
        '"crankstar[search]"',
        error=error,
    )


def refuse_unused(
    options: Mapping[str, object], *, beside: str = "", without: str = "", why: str = ""
) -> None:
    """Refuse options that have no effect rather than ignore them. Raises RequestError.

    `beside` or `without` which other option; or `why`, as a sentence.
    """
    unused = [
        name
        for name, value in options.items()
        if not (value is None or value is False or value == [])
    ]
    if not unused:
        return
    if why:
        raise RequestError(
            _n(
                "{options} has no effect. {why}",
                "{options} have no effect. {why}",
                len(unused),
                options=", ".join(unused),
                why=why,
            )
        )
    when = _("with {option}", option=beside) if beside else _("without {option}", option=without)
    raise RequestError(
        _n(
            "{options} has no effect {when}; leave it out",
            "{options} have no effect {when}; leave them out",
            len(unused),
            options=", ".join(unused),
            when=when,
        )
    )


def refuse_empty(options: Mapping[str, str | None]) -> None:
    """Refuse options whose text is empty, as that of an unset variable. Raises RequestError."""
    for name, text in options.items():
        if text is not None and not text.strip():
            raise refusal(name, text, "it is empty; leave it out")


def choice(option: str, text: str, choices: Collection[str]) -> str:
    """One of these words. Raises RequestError."""
    if text not in choices:
        raise refusal(option, text, "choose from {choices}", choices=", ".join(choices))
    return text


def of_row(option: str, number: int, rows: Sequence[T]) -> T:
    """The row of a list that is asked for by its number. Raises RequestError."""
    if not rows:
        raise refusal(option, number, "the list is empty")
    if not 1 <= number <= len(rows):
        why = _n(
            "give 1; there is only one",
            "give a number from 1 to {count}",
            len(rows),
            count=len(rows),
        )
        raise refusal(option, number, why)
    return rows[number - 1]


def once(reading: Callable[[], T]) -> Callable[[], T]:
    """A reading that is done once, however many others need it; its refusal is kept too.

    So what depends on the engine is read `together` with the engine itself.
    """
    kept: list[tuple[T, None] | tuple[None, MessageError]] = []

    def read() -> T:
        if not kept:
            try:
                kept.append((reading(), None))
            except MessageError as error:
                kept.append((None, error))
        value, refused = kept[0]
        if refused is not None:
            raise refused
        return cast("T", value)

    return read


def or_none(reading: Callable[[], T]) -> T | None:
    """What is read; None where it is refused, which is told besides."""
    try:
        return reading()
    except MessageError:
        return None


def beside(reading: Callable[[], T], other: Callable[[], object]) -> T:
    """What is read; where that is refused, what another reading refuses is told as well."""
    read = once(reading)
    try:
        return read()
    except MessageError:
        together(read, other)
        raise


def together(*readings: Callable[[], Any]) -> tuple[Any, ...]:
    """What each of them reads. Raises MistakesError with the message of each that fails, once."""
    try:
        return each(*readings)
    except MistakesError:
        raise
    except MessageError as error:
        raise MistakesError([str(error)]) from None


def each(*readings: Callable[[], Any]) -> tuple[Any, ...]:
    """The same, but one that fails alone raises its own error."""
    values: list[Any] = []
    errors: list[MessageError] = []
    for reading in readings:
        try:
            values.append(reading())
        except MessageError as error:
            errors.append(error)
    messages: dict[str, None] = {}
    for error in errors:
        messages |= dict.fromkeys(
            error.messages if isinstance(error, MistakesError) else [str(error)]
        )
    if len(messages) == 1:
        raise errors[0]
    if errors:
        raise MistakesError(messages)
    return tuple(values)
