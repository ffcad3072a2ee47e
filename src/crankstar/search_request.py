"""What the words of `crankstar search` ask for: stars, objectives, limits, the answer wanted; or all that is wrong with them."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from math import inf
from typing import Any

from crankstar.engine import Engine
from crankstar.quantity import one_line, seen
from crankstar.request import RequestError
from crankstar.search import likeness as likenesses
from crankstar.search import weighed
from crankstar.search.likeness import Likeness
from crankstar.search.question import GREATEST_LIST, All, Best, Front, Question
from crankstar.search.stars import SearchError, Stars
from crankstar.search.sums import Limit, Objective, VectorSum, check_torsion, couple, force, neighbours, of, torsion
from crankstar.star_request import fraction, star_of, stars_of

GREATEST_ORDER = 100
GREATEST_BEST, USUAL_BEST = 10_000, 20
NEIGHBOURS = ("neighbours", "neighbors", "adjacent")
EXAMPLE = "as in M1,M2 (couples), F1 (forces), T3 (torsion, with --mode-shape), neighbours"


@dataclass(frozen=True)
class Wish:
    """The words of the command line, as they were given."""

    minimise: str | None = None
    zero: str | None = None
    limit: tuple[str, ...] = ()
    pitch: str | None = None
    fix: str | None = None
    mode_shape: str | None = None
    symmetric: bool = False
    avoid_adjacent: bool = False
    front: bool = False
    best: str | None = None
    all: bool = False
    all_with: str | None = None


@dataclass(frozen=True)
class Request:
    """A question, the engine it is about if there is one, and which stars of the answer are wanted."""

    question: Question
    engine: Engine | None = None
    likeness: Likeness | None = None


def request(cylinders: int | Engine, cycle: str | None, wish: Wish, *, speed: float | None = None) -> Request:
    """The question that the words ask. Raises RequestError with every mistake in them."""
    engine = cylinders if isinstance(cylinders, Engine) else None
    faults: list[str] = []
    try:
        stars = stars_of(cylinders, cycle, pitch=wish.pitch, fix=wish.fix, symmetric=wish.symmetric, faults=faults)
    except SearchError as error:
        raise RequestError("\n".join([*faults, str(error)])) from None
    maker = _Maker(stars, engine, speed, _shape(wish, stars, faults))
    objectives = _all_of(_usual(maker) if wish.minimise is None else wish.minimise, maker, "--minimise", faults)
    asked_for = [wish.minimise, wish.zero, *wish.limit, wish.all_with]
    if wish.mode_shape is not None and not any("T" in (text or "") for text in asked_for):
        faults.append("--mode-shape: nothing here asks for torsion; name an order of it, as in --minimise M1,M2,T3")
    limits = [Limit(vector, 0.0) for vector in _sums(wish.zero, maker, "--zero", faults)]
    most = 0.0 if wish.avoid_adjacent else inf
    for text in wish.limit:
        found = _limit(text, maker, faults)
        if isinstance(found, Limit):
            limits.append(found)
        elif found is not None:
            most = min(most, found)
    likeness = _likeness(wish, stars, maker, objectives, faults)
    ask = _ask(wish, objectives, faults)
    if faults:
        raise RequestError("\n".join(dict.fromkeys(faults)))
    plain = tuple(objective for _, objective in objectives)
    if likeness is not None:
        asked = likenesses.question(stars, likeness, plain)
        return Request(replace(asked, limits=(*asked.limits, *limits), neighbours_at_most=most), engine, likeness)
    if isinstance(ask, Best):
        plain = (_together(objectives),)
    return Request(Question(stars, plain, tuple(limits), most, ask), engine)


@dataclass(frozen=True)
class _Maker:
    """Makes objectives and sums from their names."""

    stars: Stars
    engine: Engine | None
    speed: float | None
    shape: tuple[Fraction, ...] | None

    def vector(self, name: str) -> VectorSum:
        """The vector sum of a name. Raises ValueError with what is wrong."""
        match = re.fullmatch(r"([FMT])(\d{1,3}(?:\.5|\.0)?)", name, re.ASCII)
        if match is None:
            raise ValueError(f"there is no {seen(name)}; name what is meant, {EXAMPLE}")
        order = Fraction(match[2])
        if not 0 < order <= GREATEST_ORDER:
            raise ValueError(f"{name}: the order can be from 1 to {GREATEST_ORDER}")
        if match[1] == "T":
            check_torsion(self.stars, order)
            if self.shape is None:
                raise ValueError(f'{name}: needs the mode shape, as in --mode-shape "1, 0.8, 0.3, -0.3, -0.8, -1"')
            return torsion(self.stars, order=order, shape=self.shape)
        if order.denominator != 1:
            raise ValueError(f"{name}: inertia has whole orders only; torsion (T) has halves")
        return self._known(match[1], int(order))

    def _known(self, letter: str, order: int) -> VectorSum:
        if self.engine is None:
            return force(self.stars, order) if letter == "F" else couple(self.stars, order)
        make = weighed.force_of if letter == "F" else weighed.couple_of
        found = make(self.engine, self.stars, order, speed=self.speed)
        if found.scale == 0:
            raise ValueError(f"{letter}{order}: the pistons of {self.engine.name} make no inertia force of order {order}")
        return found

    def objective(self, name: str) -> Objective:
        """The objective of a name. Raises ValueError with what is wrong."""
        if name in NEIGHBOURS:
            return neighbours()
        if name == "couple":
            if self.engine is None:
                raise ValueError("couple: all orders together need an engine, for its rod ratio; name orders, as in M1,M2")
            return weighed.rms_couple(self.engine, self.stars, speed=self.speed)
        vector = self.vector(name)
        _settled(vector)
        return of(vector)


def _usual(maker: _Maker) -> str:
    """What is made least if nothing is said: the first two couples, if they tell stars apart."""
    telling: list[str] = []
    for name in ("M1", "M2"):
        with suppress(ValueError):
            telling += [name] if _tells(maker.vector(name)) else []
    return ",".join(telling) or "neighbours"


def _tells(vector: VectorSum) -> bool:
    """Whether a sum is not equally long for all stars."""
    return len(set(vector.turns)) > 1 and len(set(vector.weights)) > 1


def _settled(vector: VectorSum) -> None:
    """Refuses a sum that is equally long for all stars: it tells none from another."""
    if not _tells(vector):
        number = len(set(vector.turns)) == 1
        why = "all throws stand alike to this order" if number else "the throws are evenly spaced"
        raise ValueError(f"{vector.name} is the same for every star, for {why}; leave it out")


def whole(option: str, text: str | None, *, most: int = GREATEST_LIST) -> int | None:
    """A whole number from 1 up. Raises RequestError."""
    if text is None:
        return None
    if not re.fullmatch(r"\d{1,9}", text.strip(), re.ASCII) or not 1 <= int(text) <= most:
        raise RequestError(f"{option} {one_line(text)}: give a whole number from 1 to {most}")
    return int(text)


def check_use(question: Question, *, chart: str | None, deviations: Sequence[float] | None) -> None:
    """Refuses, before long work is begun, what could not be made of the answer. Raises RequestError."""
    if chart == "front" and not (isinstance(question.ask, Front) and len(question.objectives) > 1):
        raise RequestError("--chart front: a front is of two or more objectives, as in --minimise M1,M2; or draw --chart stars")
    if deviations is None:
        return
    if not any(objective.terms for objective in question.objectives):
        raise RequestError("--uneven: needs a couple, force or torsion in --minimise, which other angles can make less")
    even = (360 if question.stars.cycle == "two-stroke" else 720) / question.stars.cylinders
    if max(deviations) >= even:
        raise RequestError(f"--uneven: firing intervals of {even:.5g} deg can differ by less than that; give smaller numbers")


def deviations(text: str) -> list[float]:
    """By how many degrees firing intervals may leave the even one. Raises RequestError."""
    given = [fraction(part.removesuffix("deg")) for part in _each(text)]
    if not given or len(given) > 20 or any(part is None or not 0 < part <= 60 for part in given):
        raise RequestError(f"--uneven {one_line(text)}: give up to 20 numbers of degrees above 0, up to 60, as in 1,2,5")
    return sorted({float(part) for part in given if part is not None})


def _each(text: str | None) -> list[str]:
    return [part.strip() for part in (text or "").split(",") if part.strip()]


def _tried(make: Callable[[], Any], option: str, faults: list[str]) -> Any:
    """What is made, or None and the fault told."""
    try:
        return make()
    except SearchError as error:
        faults += [f"{option}: {fault}" for fault in error.faults]
    except ValueError as error:
        faults.append(f"{option}: {error}" if option else str(error))
    return None


def _all_of(text: str, maker: _Maker, option: str, faults: list[str]) -> list[tuple[float, Objective]]:
    """Objectives with their weights: `M1, 2*M2, neighbours`."""
    out: list[tuple[float, Objective]] = []
    for part in _each(text):
        times, star, name = part.rpartition("*")
        weight = fraction(times) if star else Fraction(1)
        if weight is None or not 0 < weight <= 10**6:
            faults.append(f"{option} {one_line(part)}: the weight must be a number greater than 0, as in 2*M2")
            continue
        objective = _tried(lambda name=name: maker.objective(name.strip()), option, faults)
        if objective is not None:
            out.append((float(weight), objective))
    names = [objective.name for _, objective in out]
    faults += [
        f"{option}: {name} is named {names.count(name)} times; once will do"
        for name in dict.fromkeys(names)
        if names.count(name) > 1
    ]
    if not _each(text):
        faults.append(f"{option}: name what is to be made least, {EXAMPLE}")
    if len(out) > 6:
        faults.append(f"{option}: has {len(out)} objectives; up to 6 can be weighed against each other")
    return out


def _sums(text: str | None, maker: _Maker, option: str, faults: list[str]) -> list[VectorSum]:
    if text is not None and not _each(text):
        faults.append(f"{option}: name what is to vanish, as in M2")
    if any(name in NEIGHBOURS for name in _each(text)):
        faults.append(f"{option} neighbours: use --avoid-adjacent for that")
    named = [name for name in _each(text) if name not in NEIGHBOURS]
    found = [_tried(lambda name=name: maker.vector(name), option, faults) for name in named]
    return [vector for vector in found if vector is not None]


def _limit(text: str, maker: _Maker, faults: list[str]) -> Limit | float | None:
    """A limit such as M2=1.5, or neighbours=1."""
    name, equals, value = (part.strip() for part in re.sub("<=|≤", "=", text).partition("="))
    number = fraction(value)
    if not equals or number is None or number < 0:
        faults.append(f"--limit {one_line(text)}: give what and at most how much (from 0 up), as in M2=1.5 or neighbours=1")
        return None
    if name in NEIGHBOURS:
        if number.denominator != 1:
            faults.append(f"--limit {one_line(text)}: neighbours are counted; give a whole number")
        return float(number)
    vector = _tried(lambda: maker.vector(name), "--limit", faults)
    return None if vector is None else Limit(vector, float(number))


def _shape(wish: Wish, stars: Stars, faults: list[str]) -> tuple[Fraction, ...] | None:
    """The mode shape: an amplitude for each cylinder."""
    if wish.mode_shape is None:
        return None
    given = [fraction(part) for part in wish.mode_shape.split(",")]
    if any(part is None or abs(part) > 10**6 for part in given):
        faults.append(f"--mode-shape {one_line(wish.mode_shape)}: give an amplitude for each cylinder, as in 1,0.5,-0.5,-1")
    elif len(given) != stars.cylinders:
        faults.append(f"--mode-shape: has {len(given)} amplitudes for {stars.cylinders} cylinders; give one for each")
    elif len(set(given)) == 1:
        faults.append("--mode-shape: is the same at every cylinder, which is no vibration; give the amplitudes of a mode")
    else:
        return tuple(part for part in given if part is not None)
    return tuple(Fraction(place) for place in range(stars.cylinders))  # what is wrong is told; the rest is read on


def _ask(wish: Wish, objectives: Sequence[tuple[float, Objective]], faults: list[str]) -> Front | Best | All:
    """Which answer is wanted; where nothing says so, a front of several objectives and the best by one."""
    wanted = [name for name, on in (("--front", wish.front), ("--best", wish.best is not None), ("--all", wish.all)) if on]
    if wish.all_with is not None:
        wanted.append("--all-with")
    if len(wanted) > 1:
        faults.append(f"{' and '.join(wanted)}: ask for one of them")
    best = _tried(lambda: whole("--best", wish.best, most=GREATEST_BEST), "", faults)
    if wish.all or wish.all_with is not None:
        return All()
    if wish.best is not None or (len(objectives) == 1 and not wish.front):
        return Best(best or USUAL_BEST)
    if any(weight != 1 for weight, _ in objectives):
        faults.append("--minimise: weights tell only in a list of the best; add --best 20, or leave the weights out")
    return Front()


def _together(objectives: Sequence[tuple[float, Objective]]) -> Objective:
    """One objective of several: the root of the sum of squares of the weighted sums, and the weight of each pair of neighbours."""
    if len(objectives) == 1 and objectives[0][0] == 1:
        return objectives[0][1]
    terms = tuple((weight * inner, vector) for weight, objective in objectives for inner, vector in objective.terms)
    beside = sum(weight * objective.neighbours for weight, objective in objectives)
    named = [objective.name if weight == 1 else f"{weight:g}*{objective.name}" for weight, objective in objectives]
    kinds = {objective.unit for _, objective in objectives if objective.terms}
    return Objective(" & ".join(named), terms, beside, kinds.pop() if len(kinds) == 1 else "")


def _likeness(
    wish: Wish, stars: Stars, maker: _Maker, objectives: Sequence[tuple[float, Objective]], faults: list[str]
) -> Likeness | None:
    """What --all-with asks: the stars with the same sums as a firing order, or with given values."""
    text = wish.all_with
    if text is None:
        return None
    if "=" in text:
        return _near(text, maker, faults)
    vectors = tuple(vector for _, objective in objectives for _, vector in objective.terms)
    if not vectors:
        faults.append("--all-with: needs a force, couple or torsion in --minimise, in which the stars are to be alike")
        return None
    star = star_of(text, stars)
    if star is None:
        order = "-".join(map(str, range(1, stars.cylinders + 1)))
        faults.append(
            f"--all-with {one_line(text)}: give a firing order of {order} in any order, or values, as in M1=0.2673,M2=1.0056"
        )
        return None
    return Likeness(vectors, star)


def _near(text: str, maker: _Maker, faults: list[str]) -> Likeness | None:
    """Values with as many decimals as are meant."""
    vectors: list[VectorSum] = []
    near: list[tuple[float, float]] = []
    for part in _each(text):
        name, _, value = (word.strip() for word in part.partition("="))
        number = fraction(value)
        if name in NEIGHBOURS:
            faults.append(
                f"--all-with {name}: stars are alike by their sums; add --limit neighbours=1 for those with so few neighbours"
            )
            continue
        vector = _tried(lambda name=name: maker.vector(name), "--all-with", faults)
        if number is None or number < 0:
            faults.append(f"--all-with {one_line(part)}: give a value from 0 up, as in M1=0.2673")
        elif vector is not None:
            plain = value.replace(".", "").isdigit() and number != 0
            vectors.append(vector)
            near.append((float(number), 0.51 * 10.0 ** -len(value.partition(".")[2]) if plain else 0.0))
    return Likeness(tuple(vectors), None, tuple(near)) if len(vectors) == len(_each(text)) else None
