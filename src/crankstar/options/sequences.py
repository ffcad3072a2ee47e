"""The front over stars and firing sequences that the options of a search ask for."""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING

from crankstar.engine.engine import Engine
from crankstar.options.search import SPELLINGS, amplitude, fraction, gap, limit, measure, order
from crankstar.options.shapes import STRAIGHT, mode_asked, mode_shape
from crankstar.options.values import choice, degrees, listed, refuse_unused
from crankstar.options.words import TWIST, SearchWords, SequenceWords, sequence_options
from crankstar.stars.faults import Faults, SearchError, error
from crankstar.stars.options import GREATEST_ORDER, Measure
from crankstar.stars.sequence_engines import shaft_of_engine
from crankstar.stars.shafts import Fired, Shaft, shaft_of
from crankstar.stars.vector_sums import (
    NEIGHBOURS,
    NOTHING,
    Cap,
    Goal,
    OrderSum,
    SequenceQuestion,
    couple,
    force,
    shape_of,
    straight,
    torsion,
)

if TYPE_CHECKING:
    from crankstar.dynamics.torsion_modes import Mode
    from crankstar.studies.judged_orders import Judge

MOST_ORDERS = 12
MOST_WAYS = 256
"""Orders of each row that are kept to be judged, mirror images apart."""
USUAL_GOALS = ("M1", "M2", TWIST)


@dataclass(frozen=True)
class Sequences:
    """A question over stars and sequences, the engine it is about, the order to judge.

    `mode`: that of the engine's own that gives the shape; `judges`: what is computed of each row.
    """

    question: SequenceQuestion
    engine: Engine | None = None
    why: Fired | None = None
    mode: Mode | None = None
    judges: tuple[Judge, ...] = ()


def sequences_of(about: int | Engine, words: SearchWords, more: SequenceWords) -> Sequences:
    """What the words ask for. Raises SearchError with its faults, RequestError of `judges_of`.

    >>> sequences_of(8, SearchWords(), SequenceWords(bank="90")).question.goals[2].name
    'twist'
    """
    engine = about if isinstance(about, Engine) else None
    faults = Faults()
    shaft = _shaft(about, words, more, faults) or _in_line(about)
    if shaft is None:
        raise SearchError(faults)
    asked = _Asked(shaft, words, more, faults, engine)
    goals, caps, why = asked.goals(), asked.caps(), None
    few = asked.neighbours_at_most()
    if more.why is not None:
        with faults.at("why"):
            why = shaft.fired_in(order(more.why))
    if faults:
        raise SearchError(faults)
    judges = judges_of(more.judge)
    size = {"size": MOST_WAYS} if judges else {}
    question = SequenceQuestion(shaft, tuple(goals), tuple(caps), few, **size)
    return Sequences(question, engine, why, asked.mode, judges)


def check_words(words: SearchWords, more: SequenceWords) -> None:
    """Refuse words of a search of stars alone beside those of sequences. Raises RequestError."""
    refuse_unused(
        {
            "--fix": words.fix,
            "--symmetric": words.symmetric,
            "--best": words.best,
            "--all": words.all,
            "--all-with": words.all_with,
        },
        beside=sequence_options(words, more),
    )


def judges_of(text: str | None) -> tuple[Judge, ...]:
    """What each row is judged by. Raises RequestError."""
    if text is None:
        return ()
    from crankstar.studies.judged_orders import JUDGES  # late: a search of stars needs no gas

    named = dict.fromkeys(choice("--judge", each, JUDGES) for each in listed(text) or [text])
    return tuple(judge for judge in JUDGES if judge in named)


def _shaft(
    about: int | Engine, words: SearchWords, more: SequenceWords, faults: Faults
) -> Shaft | None:
    if isinstance(about, Engine):
        if words.cycle not in (None, about.cycle):
            faults.add("cycle", "engine-cycle", engine=about.name, own=about.cycle)
        if words.gaps is not None:
            faults.add("gaps", "engine-gaps")
        if more.bank is not None:
            faults.add("bank", "engine-bank")
        with faults.at():
            return shaft_of_engine(about)
        return None
    gaps: tuple[Fraction, ...] | None = None
    bank: float | None = None
    if words.gaps is not None:
        with faults.at("gaps"):
            gaps = tuple(map(gap, words.gaps.split(",")))
    if more.bank is not None:
        angles = degrees("--bank", more.bank)
        if len(angles) != 1:
            faults.add("bank", "sequence-bank", given=more.bank)
        bank = angles[0]
    with faults.at():
        return shaft_of(about, bank_angle_deg=bank, cycle=words.cycle or "four-stroke", gaps=gaps)
    return None


def _in_line(about: int | Engine) -> Shaft | None:
    """One on which the other words can be read where that which is asked for cannot be."""
    with suppress(SearchError):
        return None if isinstance(about, Engine) else shaft_of(about, cycle="four-stroke")
    return None


class _Asked:
    """Goals and caps that the words name, on a shaft."""

    def __init__(
        self,
        shaft: Shaft,
        words: SearchWords,
        more: SequenceWords,
        faults: Faults,
        engine: Engine | None = None,
    ) -> None:
        self.shaft, self.words, self.more, self.faults = shaft, words, more, faults
        self.shape: Sequence[Fraction] = straight(shaft)
        self.mode: Mode | None = None
        text = words.mode_shape
        own = engine is not None and engine.torsion is not None
        if mode_asked(text or "") or (text is None and own):
            with faults.at("mode_shape"):
                self._own(engine, text)
        elif text is not None and text.strip() != STRAIGHT:
            with faults.at("mode_shape"):
                given = tuple(amplitude(part.strip()) for part in text.split(","))
                self.shape = shape_of(shaft, given)
        if len(set(self.shape)) == 1:
            faults.add("mode_shape", "shape-uniform")

    def _own(self, engine: Engine | None, text: str | None) -> None:
        """The shape of a mode of the engine's own table [torsion]. Raises SearchError."""
        if engine is None:
            raise error("", "shape-needs-engine", given=text or "")
        self.mode, shape = mode_shape(text, engine)
        given = tuple(Fraction(f"{shape[number]:.6f}") for number in sorted(shape))
        self.shape = shape_of(self.shaft, given)

    def goals(self) -> list[Goal]:
        """The goals, by default those of the first two couples that differ, and the twist."""
        out: list[Goal] = []
        names = self._names("minimise", self.words.minimise) or list(USUAL_GOALS)
        for name in names:
            with self.faults.at("minimise"):
                if name == TWIST or name in SPELLINGS:
                    out.append(self._twist() if name == TWIST else NEIGHBOURS)
                    continue
                one = self._sum(name)
                alike = self._alike(one)
                if alike and self.words.minimise is not None:
                    raise error("", alike, name=one.name)
                if not alike:
                    out.append(Goal(one.name, (one,)))
        if TWIST not in names and self.more.crank_orders is not None:
            self.faults.add("orders", "orders-unused")
        torsions = any(one.kind == "T" for goal in out for one in goal.sums)
        if self.words.mode_shape is not None and not torsions and not self.faults:
            self.faults.add("mode_shape", "shape-unused")
        return out

    def caps(self) -> list[Cap]:
        """The limits on what the star decides, and what must vanish."""
        out: list[Cap] = []
        for name in self._names("zero", self.words.zero):
            with self.faults.at("zero"):
                out.append(Cap(self._sum(name)))
        for text in self.words.limit:
            with self.faults.at("limit"):
                bound = limit(text)
                if bound.measure.kind == "neighbours":
                    continue
                if bound.unit:
                    raise error("", "unit-needs-engine", name=bound.measure.name, unit="m r ω² a")
                out.append(Cap(self._of(bound.measure), bound.greatest))
        return out

    def _names(self, path: str, text: str | None) -> list[str]:
        """What stands between the commas of an option; nothing, which is a fault, without any."""
        names = listed(text or "")
        if text is not None and not names:
            self.faults.add(path, "none-named")
        return names

    def neighbours_at_most(self) -> int | None:
        """How many neighbours may fire in succession; None where any number may."""
        most = [0] if self.words.avoid_adjacent else []
        for text in self.words.limit:
            with suppress(SearchError):  # noted as a fault among the caps
                bound = limit(text)
                if bound.measure.kind == "neighbours":
                    most.append(int(bound.greatest))
        return min(most, default=None)

    def _twist(self) -> Goal:
        """The largest torsion of the orders asked for."""
        step = 2 if self.shaft.cycle == "four-stroke" else 1
        text = self.more.crank_orders
        usual = [Fraction(2 * n + 1, 2) if step == 2 else Fraction(n + 1) for n in range(3)]
        orders = usual if text is None else [fraction(part) for part in listed(text)]
        wanted = [each for each in orders if each is not None and 0 < each <= GREATEST_ORDER]
        if not 0 < len(wanted) == len(orders) <= MOST_ORDERS:
            raise error("orders", "sequence-orders", given=text or "", most=MOST_ORDERS)
        sums = tuple(torsion(self.shaft, each, self.shape) for each in dict.fromkeys(wanted))
        return Goal(TWIST, sums)

    def _sum(self, name: str) -> OrderSum:
        """The sum of a name, perhaps with a weight of one. Raises SearchError."""
        try:
            return self._of(measure(name))
        except SearchError as raised:
            if any(each.code in ("no-quantity", "roll-alike") for each in raised.faults):
                raise error("", "no-goal", given=name) from None
            raise

    def _of(self, wanted: Measure) -> OrderSum:
        name = wanted.name
        if wanted.kind not in ("F", "M", "T") or wanted.side:
            raise error("", "no-goal", given=name)
        if not 0 < wanted.order <= GREATEST_ORDER:
            raise error("", "order", name=name, most=GREATEST_ORDER)
        if wanted.kind == "T":
            return torsion(self.shaft, wanted.order, self.shape)
        if wanted.order.denominator != 1:
            raise error("", "half-order", name=name)
        return (force if wanted.kind == "F" else couple)(self.shaft, int(wanted.order))

    def _alike(self, one: OrderSum) -> str:
        """The fault of a sum that is the same for every star; empty where it differs."""
        if one.scale < NOTHING:
            return "goal-balanced"
        if one.kind != "T" and one.order % self.shaft.classes == 0:
            return "alike-order"
        if one.kind == "F" and (self.shaft.rods == 1 or self.shaft.room == 1):
            return "alike-throws"
        return ""
