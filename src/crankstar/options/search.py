"""The values of a search's options, read from the words of a command line or a dialog."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import TypeVar

from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.quoting import one_line, seen
from crankstar.options.values import RequestError
from crankstar.options.words import SearchWords
from crankstar.search.faults import SearchError, SearchFault, error, fault
from crankstar.search.options import (
    GREATEST_BEST,
    NEIGHBOURS,
    Measure,
    NearValue,
    Search,
    SearchOptions,
    search_for,
)
from crankstar.search.question import All, Best, Front, Question
from crankstar.search.stars import GREATEST_CYLINDERS

T = TypeVar("T")
SPELLINGS = ("neighbours", "neighbors", "adjacent")
GREATEST_NUMBER = 10**6
"""Of weights and amplitudes."""
GREATEST_DEVIATION, GREATEST_DEVIATIONS = 60, 20


def search_of(about: int | Engine, words: SearchWords, *, speed: float | None = None) -> Search:
    """The search that the words ask for. Raises SearchError with every fault in them."""
    reader = _Reader()
    options = reader.options(words)
    return search_for(about, options, speed=speed, faults=reader.faults)


class _Reader:
    """Reads words; faults are gathered, and a word at fault is left out."""

    def __init__(self) -> None:
        self.faults: list[SearchFault] = []

    def options(self, words: SearchWords) -> SearchOptions:
        """The values of all words."""
        minimise = self._each("minimise", words.minimise, weighted)
        if minimise is not None and not _parts(words.minimise):
            self.faults.append(fault("minimise", "none-named"))
        if words.zero is not None and not _parts(words.zero):
            self.faults.append(fault("zero", "none-named"))
        return SearchOptions(
            cycle=words.cycle,
            pitch=self._each("pitch", words.pitch, gap, every=True),
            fix=self._each("fix", words.fix, fixed_throw, every=True) or (),
            symmetric=words.symmetric,
            minimise=minimise or None,
            zero=self._each("zero", words.zero, vanishing) or (),
            limit=tuple(
                bound for text in words.limit for bound in self._tried("limit", limit, text)
            ),
            mode_shape=self._each("mode_shape", words.mode_shape, amplitude, every=True),
            avoid_adjacent=words.avoid_adjacent,
            ask=self._ask(words),
            all_with=self._all_with(words.all_with),
        )

    def _tried(self, path: str, read: Callable[[str], T], text: str) -> Iterator[T]:
        try:
            yield read(text)
        except SearchError as raised:
            self.faults += [each._replace(path=path) for each in raised.faults]

    def _each(
        self, path: str, text: str | None, read: Callable[[str], T], *, every: bool = False
    ) -> tuple[T, ...] | None:
        """What stands between commas; `every`: also where there is nothing."""
        if text is None:
            return None
        parts = [part.strip() for part in text.split(",")] if every else _parts(text)
        values = tuple(value for part in parts for value in self._tried(path, read, part))
        return values if len(values) == len(parts) or not every else None

    def _ask(self, words: SearchWords) -> Front | Best | All | None:
        names = ("front", "best", "all", "all_with")
        named = tuple(name for name in names if getattr(words, name) not in (None, False))
        if len(named) > 1:
            self.faults.append(SearchFault("", "several-answers", {"options": named}))
        if words.best is not None:
            return next(self._tried("best", best, str(words.best)), None)
        return All() if words.all else Front() if words.front else None

    def _all_with(self, text: str | None) -> tuple[int, ...] | tuple[NearValue, ...] | None:
        if text is None:
            return None
        if "=" in text:
            return self._each("all_with", text, near_value) or None
        words = re.split(r"[-,\s]+", text.strip())
        if all(re.fullmatch(r"\d{1,3}", word, re.ASCII) for word in words):
            return tuple(map(int, words))
        self.faults.append(fault("all_with", "all-with-text", given=text))
        return None


def weighted(text: str) -> tuple[float, Measure]:
    """A quantity with its weight. Raises SearchError.

    >>> weighted("2*M2")
    (2.0, Measure(kind='M', order=Fraction(2, 1)))
    """
    times, star, name = text.rpartition("*")
    weight = fraction(times) if star else Fraction(1)
    if weight is None or not 0 < weight <= GREATEST_NUMBER:
        raise error("", "weight", given=text)
    return float(weight), measure(name)


def measure(text: str) -> Measure:
    """A quantity by its name. Raises SearchError."""
    name = text.strip()
    if name in SPELLINGS:
        return NEIGHBOURS
    if name == "couple":
        return Measure("couple")
    match = re.fullmatch(r"([FMT])(\d{1,3}(?:\.5|\.0)?)", name, re.ASCII)
    if match is None:
        raise error("", "no-quantity", given=seen(name))
    return Measure(match[1], Fraction(match[2]))  # pyright: ignore[reportArgumentType]


def vanishing(text: str) -> Measure:
    """A quantity that must vanish. Raises SearchError."""
    if text in SPELLINGS:
        raise error("", "zero-neighbours")
    return _vector(text)


def limit(text: str) -> tuple[Measure, float]:
    """A quantity and its greatest value: `M2=1.5`. Raises SearchError."""
    name, equals, value = re.sub("<=|≤", "=", text).partition("=")
    number = fraction(value)
    if not equals or number is None or number < 0:
        raise error("", "limit-form", given=text)
    if name.strip() in SPELLINGS:
        if number.denominator != 1:
            raise error("", "limit-whole", given=text)
        return NEIGHBOURS, float(number)
    return _vector(name), float(number)


def near_value(text: str) -> NearValue:
    """A value to as many decimals as are written: `M1=0.2673`. Raises SearchError."""
    name, _equals, value = (word.strip() for word in text.partition("="))
    number = fraction(value)
    if name in SPELLINGS:
        raise error("", "all-with-neighbours")
    if number is None or number < 0:
        raise error("", "all-with-value", given=text)
    rounded = value.replace(".", "").isdigit() and number != 0
    off = 0.51 * 10.0 ** -len(value.partition(".")[2]) if rounded else 0.0
    return NearValue(_vector(name), float(number), off)


def _vector(text: str) -> Measure:
    """A quantity that is a vector sum. Raises SearchError."""
    named = measure(text)
    if not named.order:
        raise error("", "no-quantity", given=seen(text.strip()))
    return named


def gap(text: str) -> Fraction:
    """A gap between two cylinders in pitches. Raises SearchError."""
    number = fraction(text)
    if number is None or not 0 < number <= 1000:
        raise error("", "gaps", given=text)
    return number


def fixed_throw(text: str) -> tuple[int, int]:
    """A cylinder and the direction of its throw: `4=3`. Raises SearchError."""
    match = re.fullmatch(r"(\d{1,3})\s*=\s*(\d{1,3})", text, re.ASCII)
    if match is None:
        raise error("", "fixed-form", given=text)
    return int(match[1]), int(match[2])


def amplitude(text: str) -> Fraction:
    """An amplitude of a mode shape. Raises SearchError."""
    number = fraction(text)
    if number is None or abs(number) > GREATEST_NUMBER:
        raise error("", "shape-form", given=text)
    return number


def best(text: str) -> Best:
    """A list of so many of the best. Raises SearchError."""
    number = int(text) if re.fullmatch(r"\d{1,9}", text.strip(), re.ASCII) else 0
    if not 1 <= number <= GREATEST_BEST:
        raise error("", "best", given=text, most=GREATEST_BEST)
    return Best(number)


def whole_number(text: str) -> int | None:
    """A number of cylinders; None if the word is a name or a file. Raises SearchError."""
    if not re.fullmatch(r"[-+]?\d+", text.strip(), re.ASCII):
        return None
    if len(text) > 6 or not 2 <= int(text) <= GREATEST_CYLINDERS:
        raise error("", "cylinders", given=text, least=2, most=GREATEST_CYLINDERS)
    return int(text)


def deviations(text: str) -> list[float]:
    """By how many degrees firing intervals may leave the even one. Raises RequestError."""
    given = [fraction(part.removesuffix("deg")) for part in _parts(text)]
    good = [float(part) for part in given if part is not None and 0 < part <= GREATEST_DEVIATION]
    if not given or len(good) < len(given) or len(given) > GREATEST_DEVIATIONS:
        wrong = _(
            "{given}: give up to {count} numbers of degrees above 0, up to {most}, as in 1,2,5",
            given=one_line(text),
            count=GREATEST_DEVIATIONS,
            most=GREATEST_DEVIATION,
        )
        raise RequestError(f"--uneven: {wrong}")
    return sorted(set(good))


def check_use(question: Question, *, chart: str | None, deviations: list[float] | None) -> None:
    """Refuse, before long work, an output that the answer could not give. Raises RequestError."""
    if chart == "front" and not (isinstance(question.ask, Front) and len(question.objectives) > 1):
        wrong = _(
            "a front has two or more objectives, as in --minimise M1,M2; or draw --chart stars"
        )
        raise RequestError(f"--chart front: {wrong}")
    if deviations is None:
        return
    if not any(objective.terms for objective in question.objectives):
        raise error("uneven", "needs-sum")
    even = (360 if question.stars.cycle == "two-stroke" else 720) / question.stars.cylinders
    if max(deviations) >= even:
        raise error("uneven", "deviation", given=f"{max(deviations):g}", even=f"{even:.5g}")


def _parts(text: str | None) -> list[str]:
    return [part.strip() for part in (text or "").split(",") if part.strip()]


def fraction(text: str) -> Fraction | None:
    """A decimal number or fraction, exactly; None if it is none, or longer than a number is."""
    text = text.strip()
    form = r"[-+]?(\d{1,12}(\.\d{0,12})?|\.\d{1,12})(/\d{1,6}|[eE][-+]?\d{1,2})?"
    if not re.fullmatch(form, text, re.ASCII) or text.endswith("/0"):
        return None
    try:
        return Fraction(text)
    except (ValueError, ZeroDivisionError):
        whole, _slash, part = text.partition("/")
        return Fraction(whole) / int(part) if part and int(part) else None
