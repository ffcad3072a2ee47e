"""The values of a search's options, read from the words of a command line or a dialog."""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction
from typing import TYPE_CHECKING, Any, TypeVar, cast

from crankstar.engine.engine import Engine
from crankstar.engine.quantities import COUPLE, FORCE
from crankstar.files import units
from crankstar.language.faults import ValueFaultError
from crankstar.language.quoting import seen
from crankstar.options.values import RequestError, bounded, listed, refusal
from crankstar.options.words import SearchWords
from crankstar.stars import question as questions
from crankstar.stars.faults import Faults, SearchError, error
from crankstar.stars.options import (
    GREATEST_BEST,
    NEIGHBOURS,
    Bound,
    Measure,
    NearValue,
    Search,
    SearchOptions,
    search_for,
)
from crankstar.stars.question import All, Best, Front, Question
from crankstar.stars.star import GREATEST_CYLINDERS

if TYPE_CHECKING:
    from crankstar.stars.answer import Answer

T = TypeVar("T")
SPELLINGS = ("neighbours", "neighbors", "adjacent")
ROLL = re.compile(r"(rms )?(roll|rolling moment)( ?\d{1,3}(\.\d)?)?", re.IGNORECASE)
"""Names of the roll, which is the same for every star."""
GREATEST_NUMBER = 10**6
"""Of weights and amplitudes."""
GREATEST_DEVIATION, GREATEST_DEVIATIONS = 60, 20


def search_of(about: int | Engine, words: SearchWords, *, speed: float | None = None) -> Search:
    """The search that the words ask for. Raises SearchError with every fault in them."""
    faults = Faults()
    return search_for(about, _options(words, faults), speed=speed, faults=faults)


def whole(search: Search, answer: Answer) -> Answer:
    """An answer that lists all that was asked for. Raises RequestError where it cannot."""
    question = search.question
    if isinstance(question.ask, questions.All) and len(answer.rows) >= question.ask.size:
        raise RequestError(
            "{stars} stars lie within these limits, more than the {most} classes that can be "
            "listed. Narrow the search, as in --limit M1=2, or ask for --best 100.",
            stars=f"{answer.stars:,}",
            most=f"{question.ask.size:,}",
        )
    if search.equivalence is None:
        return answer
    from crankstar.stars import equivalence  # what is compiled is read for a search alone

    return equivalence.equivalent(answer, search.equivalence)


def goals_of(words: SearchWords) -> SearchOptions:
    """Goals and limits for several engines, one after the other. Raises SearchError.

    >>> [measure.name for _weight, measure in goals_of(SearchWords(minimise="M2,X3")).minimise]
    ['M2', 'X3']
    """
    faults = Faults()
    options = _options(words, faults)
    if faults:
        raise SearchError(faults)
    return options


def _options(words: SearchWords, faults: Faults) -> SearchOptions:
    """The values of all words; one at fault is left out."""

    def each(
        path: str, text: str | None, read: Callable[[str], T], *, every: bool = False
    ) -> tuple[T, ...] | None:
        """What stands between commas; `every`: also where there is nothing."""
        if text is None:
            return None
        parts = [part.strip() for part in text.split(",")] if every else listed(text)
        if not parts:
            faults.add(path, "none-named")
        values: list[T] = []
        for part in parts:
            with faults.at(path):
                values.append(read(part))
        return tuple(values) if len(values) == len(parts) or not every else None

    limits: list[Bound] = []
    for text in words.limit:
        with faults.at("limit"):
            limits.append(limit(text))
    names = (words.front, words.best is not None, words.all, words.all_with is not None)
    if sum(names) > 1:
        faults.add("", "several-answers")
    ask = All() if words.all else Front() if words.front else None
    if words.best is not None:
        with faults.at("best"):
            ask = best(str(words.best))
    all_with = None
    if words.all_with is not None:
        if "=" in words.all_with:
            all_with = each("all_with", words.all_with, near_value) or None
        else:
            with faults.at("all_with"):
                all_with = order(words.all_with)
    return SearchOptions(
        cycle=words.cycle,
        gaps=each("gaps", words.gaps, gap, every=True),
        fix=each("fix", words.fix, fixed_throw, every=True) or (),
        symmetric=words.symmetric,
        minimise=each("minimise", words.minimise, weighted) or None,
        zero=each("zero", words.zero, vanishing) or (),
        limit=tuple(limits),
        mode_shape=each("mode_shape", words.mode_shape, amplitude, every=True),
        avoid_adjacent=words.avoid_adjacent,
        ask=ask,
        all_with=all_with,
    )


def order(text: str) -> tuple[int, ...]:
    """The cylinders of a firing order. Raises SearchError."""
    words = re.split(r"[-,\s]+", text.strip())
    if not all(re.fullmatch(r"\d{1,3}", word) for word in words):
        raise error("", "all-with-text", given=text)
    return tuple(map(int, words))


def weighted(text: str) -> tuple[float, Measure]:
    """A quantity with its weight. Raises SearchError.

    >>> weighted("2*M2")
    (2.0, Measure(kind='M', order=Fraction(2, 1), side=''))
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
    if ROLL.fullmatch(name):
        raise error("", "roll-alike", given=name)
    match = re.fullmatch(r"([FMTX])(\d{1,3}(?:\.5|\.0)?)([VH]?)", name)
    if match is None or (match[1] in ("T", "X") and match[3]):
        raise error("", "no-quantity", given=seen(name))
    kind, order, side = cast("tuple[Any, str, Any]", match.groups())
    return Measure(kind, Fraction(order), side)


def vanishing(text: str) -> Measure:
    """A quantity that must vanish. Raises SearchError."""
    if text in SPELLINGS:
        raise error("", "zero-neighbours")
    return _vector(text)


def limit(text: str) -> Bound:
    """A quantity and its greatest value: `M2=1.5`, `M1V=800 kN m`. Raises SearchError.

    >>> limit("M1V <= 800 kN*m")
    Bound(measure=Measure(kind='M', order=Fraction(1, 1), side='V'), greatest=800000.0, unit='N*m')
    """
    name, value = bounded(text)
    if name in SPELLINGS:
        number = fraction(value)
        if number is None or number < 0:
            raise error("", "limit-form", given=text)
        if number.denominator != 1:
            raise error("", "limit-whole", given=text)
        return Bound(NEIGHBOURS, float(number))
    if not value:
        raise error("", "limit-form", given=text)
    measured = _vector(name)
    given = amount(value, measured)
    if given is None:
        raise error("", "limit-form", given=text)
    return Bound(measured, *given)


def amount(text: str, measured: Measure) -> tuple[float, str] | None:
    """A value from 0 up and its unit: N or N*m, none for a bare number; None where it is none.

    Raises SearchError for a unit of something else.
    """
    bare = fraction(text)
    if bare is not None:
        return None if bare < 0 else (float(bare), "")
    if not re.match(r"\s*\+?[\d.]+(e[-+]?\d+)?\s*[a-z]", text, re.IGNORECASE):
        return None
    moment = measured.kind in ("M", "X")
    try:
        return units.si(text, COUPLE if moment else FORCE), "N*m" if moment else "N"
    except ValueFaultError as fault:
        raise error("", "amount", problem=fault.at(measured.name)) from None


def near_value(text: str) -> NearValue:
    """A value to as many decimals as are written: `M1=0.2673`. Raises SearchError."""
    name, _equals, value = (word.strip() for word in text.partition("="))
    if name in SPELLINGS:
        raise error("", "all-with-neighbours")
    measured = _vector(name)
    given = amount(value, measured)
    if given is None:
        raise error("", "all-with-value", given=text)
    length, unit = given
    written = re.fullmatch(r"([\d.]+)(?![eE/])\s*([A-Za-z].*)?", value)
    if written is None or not length:  # an exact value
        return NearValue(measured, length, 0.0, unit)
    last_place = 10.0 ** -len(written[1].partition(".")[2])
    return NearValue(measured, length, 0.51 * last_place * length / float(written[1]), unit)


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
    match = re.fullmatch(r"(\d{1,3})\s*=\s*(\d{1,3})", text)
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
    number = int(text) if re.fullmatch(r"\d{1,9}", text.strip()) else 0
    if not 1 <= number <= GREATEST_BEST:
        raise error("", "best", given=text, most=GREATEST_BEST)
    return Best(number)


def whole_number(text: str) -> int | None:
    """A number of cylinders; None if the word is a name or a file. Raises SearchError."""
    if not re.fullmatch(r"[-+]?\d+", text.strip()):
        return None
    if len(text) > 6 or not 2 <= int(text) <= GREATEST_CYLINDERS:
        raise error("", "cylinders", given=text, least=2, most=GREATEST_CYLINDERS)
    return int(text)


def deviations(text: str) -> list[float]:
    """By how many degrees firing intervals may leave the even one. Raises RequestError."""
    given = [fraction(part.removesuffix("deg")) for part in listed(text)]
    good = [float(part) for part in given if part is not None and 0 < part <= GREATEST_DEVIATION]
    if not given or len(good) < len(given) or len(given) > GREATEST_DEVIATIONS:
        raise refusal(
            "--uneven",
            text,
            "give up to {count} numbers of degrees above 0, up to {most}, as in 1,2,5",
            count=GREATEST_DEVIATIONS,
            most=GREATEST_DEVIATION,
        )
    return sorted(set(good))


def check_use(question: Question, *, chart: str | None, deviations: list[float] | None) -> None:
    """Refuse, before long work, an output that the answer could not give. Raises RequestError."""
    if chart == "front" and not (isinstance(question.ask, Front) and len(question.objectives) > 1):
        raise RequestError(
            "--chart front: a front has two or more objectives, as in --minimise M1,M2; or draw "
            "--chart stars"
        )
    if deviations is None:
        return
    if not any(objective.terms for objective in question.objectives):
        raise error("uneven", "needs-sum")
    even = (360 if question.stars.cycle == "two-stroke" else 720) / question.stars.cylinders
    if max(deviations) >= even:
        raise error("uneven", "deviation", given=f"{max(deviations):g}", even=f"{even:.5g}")


def fraction(text: str) -> Fraction | None:
    """A decimal number or fraction, exactly; None if it is none, or longer than a number is."""
    text = text.strip()
    form = r"[-+]?(\d{1,12}(\.\d{0,12})?|\.\d{1,12})(/\d{1,6}|[eE][-+]?\d{1,2})?"
    if not re.fullmatch(form, text) or text.endswith("/0"):
        return None
    try:
        return Fraction(text)
    except (ValueError, ZeroDivisionError):
        whole, _slash, part = text.partition("/")
        return Fraction(whole) / int(part) if part and int(part) else None
