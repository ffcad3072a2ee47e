"""Options of a search as values, and the question that they ask about an engine or a number.

The command line, the API and the page's dialog fill the same record; a fault names its field.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from math import inf
from typing import Literal, NamedTuple

from crankstar.engine.engine import Engine
from crankstar.engine.quantities import Cycle
from crankstar.language.numbers import unit_text
from crankstar.stars import engine_stars, equivalence
from crankstar.stars.equivalence import Equivalence
from crankstar.stars.faults import Faults, SearchError, error
from crankstar.stars.question import All, Best, Front, Question
from crankstar.stars.star import Star, Stars
from crankstar.stars.sums import (
    Limit,
    Objective,
    Side,
    VectorSum,
    check_torsion,
    couple,
    force,
    neighbours,
    of,
    torsion,
    twisting,
)

GREATEST_ORDER = 100
GREATEST_OBJECTIVES = 6
GREATEST_BEST, USUAL_BEST = 10_000, 20


class Measure(NamedTuple):
    """A quantity of a star: a couple (M), force (F), torsion (T), or guide-force moment (X).

    Each of an order; or one without.

    side: of a force or couple only what acts vertically (V) or horizontally (H), as in the external
    moments M1V and M1H; else its greatest value over a turn.
    """

    kind: Literal["F", "M", "T", "X", "couple", "neighbours"]
    order: Fraction = Fraction(0)
    side: Side = ""

    @property
    def name(self) -> str:
        """As it is written: `M1`, `M1V`, `T1.5`, `neighbours`."""
        if self.kind not in ("F", "M", "T", "X"):
            return self.kind
        return f"{self.kind}{float(self.order):g}{self.side}"


NEIGHBOURS = Measure("neighbours")
USUAL = (Measure("M", Fraction(1)), Measure("M", Fraction(2)))
"""Minimised where nothing else is named, as far as they differ between stars."""


class Bound(NamedTuple):
    """A quantity and its greatest value in N or N*m, without a `unit` in that of the answer."""

    measure: Measure
    greatest: float
    unit: str = ""


class NearValue(NamedTuple):
    """A length that a sum is to have, by how much it may differ, and the unit as in a Bound."""

    measure: Measure
    length: float
    off: float
    unit: str = ""


@dataclass(frozen=True)
class SearchOptions:
    """What a search is to find, and among which stars.

    cycle: that of the engine, else four-stroke. gaps: those between cylinders from the front, in
    pitches. fix: cylinders with the directions of their throws. minimise: quantities with weights;
    by default the couples M1 and M2. zero, limit: quantities that must vanish, or be at most so
    great. mode_shape: amplitude of a torsional mode at each cylinder. ask: by default a front of
    several objectives, or the best by one. all_with: all stars with the moments of this firing
    order, or with these values.
    """

    cycle: Cycle | None = None
    gaps: tuple[Fraction, ...] | None = None
    fix: tuple[tuple[int, int], ...] = ()
    symmetric: bool = False
    minimise: tuple[tuple[float, Measure], ...] | None = None
    zero: tuple[Measure, ...] = ()
    limit: tuple[Bound, ...] = ()
    mode_shape: tuple[Fraction, ...] | None = None
    avoid_adjacent: bool = False
    ask: Front | Best | All | None = None
    all_with: tuple[int, ...] | tuple[NearValue, ...] | None = None


@dataclass(frozen=True)
class Search:
    """A question, the engine if it is about one, and which stars of the answer are wanted."""

    question: Question
    engine: Engine | None = None
    equivalence: Equivalence | None = None


def search_for(
    about: int | Engine,
    options: SearchOptions,
    *,
    speed: float | None = None,
    faults: Faults | None = None,
) -> Search:
    """The search that options ask for, of an in-line engine or of a number of cylinders.

    faults: what is wrong already with how the options were written. Raises SearchError with every
    fault.

    >>> search_for(7, SearchOptions()).question.objectives[1].name
    'M2'
    """
    faults = Faults() if faults is None else faults
    stars = _stars(about, options, faults)
    if stars is None:
        raise SearchError(faults)
    engine = about if isinstance(about, Engine) else None
    return _Questioner(stars, engine, speed, options, faults).search()


def _stars(about: int | Engine, options: SearchOptions, faults: Faults) -> Stars | None:
    """The stars among which to search, options at fault left out; None where there are none."""
    stars = None
    with faults.at():
        if isinstance(about, Engine):
            if options.cycle not in (None, about.cycle):
                faults.add("cycle", "engine-cycle", engine=about.name, own=about.cycle)
            if options.gaps is not None:
                faults.add("gaps", "engine-gaps")
            stars = engine_stars.stars_of(about)
        else:
            places = _positions(about, options.gaps, faults)
            stars = Stars(about, options.cycle or "four-stroke", places)
        for change in (
            {"symmetric": options.symmetric},
            {"fixed": tuple(sorted(set(options.fix)))},
        ):
            with faults.at():
                stars = replace(stars, **change)
    return stars


def _positions(
    cylinders: int, gaps: tuple[Fraction, ...] | None, faults: Faults
) -> tuple[Fraction, ...]:
    """Positions in pitches, measured from the middle."""
    if gaps is not None and len(gaps) != cylinders - 1:
        wrong = {"given": len(gaps), "cylinders": cylinders, "wanted": cylinders - 1}
        faults.add("gaps", "gap-count", **wrong)
        gaps = None
    places = [Fraction(0)]
    for gap in gaps or (Fraction(1),) * (cylinders - 1):
        places.append(places[-1] - gap)
    middle = (places[0] + places[-1]) / 2
    return tuple(place - middle for place in places)


class _Questioner:
    """Makes the question of some options about some stars."""

    def __init__(
        self,
        stars: Stars,
        engine: Engine | None,
        speed: float | None,
        options: SearchOptions,
        faults: Faults,
    ) -> None:
        self.stars, self.engine, self.speed = stars, engine, speed
        self.options, self.faults = options, faults
        self.shape = self._shape()

    def search(self) -> Search:
        """The search. Raises SearchError with every fault."""
        options, faults = self.options, self.faults
        weighted = list(self._objectives())
        objectives = tuple(objective for _weight, objective in weighted)
        limits: list[Limit] = []
        for path, bounds in (
            ("zero", [Bound(name, 0.0) for name in options.zero]),
            ("limit", options.limit),
        ):
            for bound in bounds:
                with faults.at(path):
                    if bound.measure != NEIGHBOURS:
                        limits.append(Limit(self.counted(bound), bound.greatest))
        at_most = [bound.greatest for bound in options.limit if bound.measure == NEIGHBOURS]
        at_most += [0.0] if options.avoid_adjacent else []
        wanted = self._equivalence(objectives)
        ask = self._ask(weighted)
        if faults:
            raise SearchError(faults)
        if wanted is not None:
            limits = [*equivalence.question(self.stars, wanted, objectives).limits, *limits]
        elif isinstance(ask, Best):
            objectives = (_combined(weighted),)
        least = min(at_most, default=inf)
        question = Question(self.stars, objectives, tuple(limits), least, ask)
        return Search(question, self.engine, wanted)

    def counted(self, wanted: Bound | NearValue) -> VectorSum:
        """The vector sum of a value, once it is counted in the unit of that. Raises SearchError."""
        vector = self.vector(wanted.measure)
        if wanted.unit in ("", vector.unit):
            return vector
        values = {"name": wanted.measure.name, "unit": unit_text(vector.unit)}
        if wanted.measure.kind == "T":
            raise error("", "torsion-unit", **values)
        if self.engine is None:
            raise error("", "unit-needs-engine", **values)
        raise error("", "unit-needs-newtons", engine=self.engine.name, **values)

    def vector(self, measure: Measure) -> VectorSum:
        """The vector sum of a quantity. Raises SearchError."""
        name, order = measure.name, measure.order
        if not 0 < order <= GREATEST_ORDER:
            raise error("", "order", name=name, most=GREATEST_ORDER)
        if measure.kind == "T":
            check_torsion(self.stars, order)
            if self.shape is None:
                known = [fault for fault in self.faults if "mode_shape" in fault.path]
                raise SearchError(known) if known else error("", "needs-shape", name=name)
            return torsion(self.stars, order=order, shape=self.shape)
        if measure.kind == "X":
            if self.engine is None:
                return twisting(self.stars, order)
            return engine_stars.twisting_of(self.engine, self.stars, order, speed=self.speed)
        if order.denominator != 1:
            raise error("", "half-order", name=name)
        if self.engine is None:
            if measure.side == "H":
                raise error("", "horizontal-needs-engine", name=name)
            vector = (force if measure.kind == "F" else couple)(self.stars, int(order))
            return replace(vector, name=name)
        of_engine = engine_stars.force_of if measure.kind == "F" else engine_stars.couple_of
        at = {"speed": self.speed, "side": measure.side}
        vector = of_engine(self.engine, self.stars, int(order), **at)
        if vector.scale == 0:
            code = "no-side" if measure.side else "no-force"
            raise error("", code, name=name, engine=self.engine.name)
        return vector

    def _objective(self, measure: Measure) -> Objective:
        """The objective of a quantity. Raises SearchError where it is the same for every star."""
        if measure == NEIGHBOURS:
            return neighbours()
        if measure.kind == "couple":
            if self.engine is None:
                raise error("", "needs-engine")
            return engine_stars.rms_couple(self.engine, self.stars, speed=self.speed)
        vector = self.vector(measure)
        for alike, code in ((vector.turns, "alike-order"), (vector.weights, "alike-throws")):
            if len(set(alike)) == 1:
                raise error("", code, name=measure.name)
        return of(vector)

    def _objectives(self) -> Iterator[tuple[float, Objective]]:
        """Objectives with their weights, by default the first couples that differ."""
        if self.options.minimise is None:
            usual: list[Objective] = []
            for measure in USUAL:
                with suppress(SearchError):
                    usual.append(self._objective(measure))
            yield from ((1.0, objective) for objective in usual or [neighbours()])
            return
        for weight, measure in self.options.minimise:
            with self.faults.at("minimise"):
                yield weight, self._objective(measure)
        names = [measure.name for _weight, measure in self.options.minimise]
        for name in dict.fromkeys(names):
            if names.count(name) > 1:
                self.faults.add("minimise", "named-twice", name=name, count=names.count(name))
        if len(names) > GREATEST_OBJECTIVES:
            wrong = {"count": len(names), "most": GREATEST_OBJECTIVES}
            self.faults.add("minimise", "too-many-objectives", **wrong)

    def _shape(self) -> tuple[Fraction, ...] | None:
        shape, options = self.options.mode_shape, self.options
        if shape is None:
            return None
        measures = [measure for _weight, measure in options.minimise or ()]
        measures += [*options.zero, *(bound.measure for bound in options.limit)]
        measures += [
            value.measure for value in options.all_with or () if not isinstance(value, int)
        ]
        if not any(measure.kind == "T" for measure in measures):
            self.faults.add("mode_shape", "shape-unused")
        if len(shape) != self.stars.cylinders:
            wrong = {"given": len(shape), "cylinders": self.stars.cylinders}
            self.faults.add("mode_shape", "shape-count", **wrong)
            return None
        if len(set(shape)) == 1:
            self.faults.add("mode_shape", "shape-uniform")
            return None
        return shape

    def _ask(self, weighted: list[tuple[float, Objective]]) -> Front | Best | All:
        ask = self.options.ask
        if self.options.all_with is not None:
            return All()
        if isinstance(ask, Best) and not 1 <= ask.size <= GREATEST_BEST:
            self.faults.add("best", "best", given=ask.size, most=GREATEST_BEST)
        if ask is None:
            ask = Best(USUAL_BEST) if len(weighted) == 1 else Front()
        if isinstance(ask, Front) and any(weight != 1 for weight, _objective in weighted):
            self.faults.add("minimise", "weights-unused")
        return ask

    def _equivalence(self, objectives: Iterable[Objective]) -> Equivalence | None:
        """Which sums are to be as long as those of a firing order, or how long."""
        wanted = self.options.all_with
        if wanted is None:
            return None
        with self.faults.at("all_with"):
            values = [value for value in wanted if not isinstance(value, int)]
            if values:
                sums = tuple(self.counted(value) for value in values)
                return Equivalence(sums, None, tuple((each.length, each.off) for each in values))
            sums = tuple(vector for objective in objectives for _, vector in objective.terms)
            if not sums:
                raise error("", "all-with-sums")
            star = star_of_order([n for n in wanted if isinstance(n, int)], self.stars)
            if star is None:
                order, most = "-".join(map(str, wanted)), self.stars.cylinders
                raise error("", "all-with-form", given=order, cylinders=most)
            return Equivalence(sums, star)


def star_of_order(firing_order: list[int], stars: Stars) -> Star | None:
    """The star of a firing order; None if it is not an order of these cylinders."""
    if sorted(firing_order) != list(range(1, stars.cylinders + 1)):
        return None
    step = stars.step or 1
    at = {number: index * step % stars.directions for index, number in enumerate(firing_order)}
    return tuple(at[number] for number in range(1, stars.cylinders + 1))


def _combined(objectives: list[tuple[float, Objective]]) -> Objective:
    """One objective of several: the root of the sum of squares of the weighted sums.

    The weight of each pair of neighbours in succession is added.
    """
    if len(objectives) == 1 and objectives[0][0] == 1:
        return objectives[0][1]
    terms = tuple(
        (weight * own, vector)
        for weight, objective in objectives
        for own, vector in objective.terms
    )
    names = [
        objective.name if weight == 1 else f"{weight:g}*{objective.name}"
        for weight, objective in objectives
    ]
    units = {objective.unit for _weight, objective in objectives if objective.terms}
    cost = sum(weight * objective.neighbours for weight, objective in objectives)
    return Objective(" & ".join(names), terms, cost, units.pop() if len(units) == 1 else "")
