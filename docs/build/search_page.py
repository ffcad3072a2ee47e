"""The tables of explanation/search.md: proven fronts, all eights without secondary couple."""

from __future__ import annotations

from fractions import Fraction
from functools import lru_cache

from crankstar.derive.algebra import radicals as radical
from crankstar.derive.algebra.typeset import text
from crankstar.engine.quantities import Cycle
from crankstar.files.catalog import load
from crankstar.options.sequences import SequenceWords, sequences_of
from crankstar.options.words import SearchWords
from crankstar.stars.answer import Answer, AnswerRow, answer_to
from crankstar.stars.engines import firing_order
from crankstar.stars.question import All, Question
from crankstar.stars.sequence_engines import fired_of_engine
from crankstar.stars.sequence_fronts import SequenceFront, beaten, sequence_front
from crankstar.stars.shafts import Fired
from crankstar.stars.star import Stars
from crankstar.stars.sums import Limit, VectorSum, couple, of

NO_BREAK = "\u2060-\u2060"
SPACE = "\u00a0"
SHOWN = 12
MAKERS = (
    "suzuki-hayabusa",
    "honda-b18c",
    "audi-25-tfsi",
    "rolls-royce-six-1928",
    "diesel-six-1939",
    "mwm-6-diesel",
    "toyota-2jz",
    "bmw-m52b28",
    "man-s50mc-c",
    "man-s90mc-c",
    "gm-l76",
    "rover-v8-39",
    "ford-coyote",
    "ford-46-sohc",
    "cadillac-ld8",
    "toyota-1uz-fe",
    "bmw-s65",
    "porsche-cayenne-48",
    "ferrari-f136",
    "merlin",
)
"""Engines of the catalog whose orders are placed on their fronts."""
FOURS = 4
"""Cylinders of engines whose throws are all in phase in order 2."""
MOST = 14
"""Greatest number of cylinders whose front is searched whenever the page is built."""


def evenly_spaced(cylinders: int, cycle: Cycle) -> Stars:
    """The stars of cylinders at equal pitch."""
    return Stars(cylinders, cycle, tuple(Fraction(cylinders - 1, 2) - j for j in range(cylinders)))


@lru_cache
def front(cylinders: int) -> Answer:
    """The (M1, M2) front of a two-stroke engine."""
    stars = evenly_spaced(cylinders, "two-stroke")
    return answer_to(Question(stars, (of(couple(stars, 1)), of(couple(stars, 2)))))


@lru_cache
def eight() -> Answer:
    """All stars of a two-stroke eight without second-order couple, by the first."""
    stars = evenly_spaced(8, "two-stroke")
    return answer_to(
        Question(stars, (of(couple(stars, 1)),), limits=(Limit(couple(stars, 2), 0),), ask=All())
    )


def page(what: str) -> str:
    """The table of a marker: `fronts`, `eight` or `makers`."""
    return {"fronts": fronts, "eight": without_second, "makers": makers}[what]()


@lru_cache
def judged(name: str) -> tuple[SequenceFront, Fired]:
    """The front of an engine of the catalog, and its own star and firing order."""
    engine = load(name)
    sums = "M1" if len(engine.cylinders) == FOURS else "M1,M2"
    goals = SearchWords(minimise=f"{sums},twist,neighbours", mode_shape="straight")
    front = sequence_front(sequences_of(engine, goals, SequenceWords()).question)
    own = fired_of_engine(engine, front.question.shaft)
    if own is None:
        raise ValueError(f"{name} does not fire evenly")
    return front, own


def makers() -> str:
    """Where orders of engines in the catalog stand on their fronts."""
    lines = ["| engine | firing order | M1 | M2 | twist | neighbours | on the front |"]
    lines.append("|---|---|---|---|---|---|---|")
    for name in MAKERS:
        front, own = judged(name)
        values, better = beaten(front, own)
        order = NO_BREAK.join(map(str, front.question.shaft.firing_order(own)))
        where = "yes"
        if not any(not which for _, which in better):
            place, which = better[0]
            point = front.points[place].values
            goals = front.question.goals
            less = ", ".join(f"{goals[q].name} {_number(point[q])}" for q in which)
            where = f"no: {less} is possible, the rest no worse"
        sums = list(map(_number, values[:-1]))
        if len(sums) < FOURS - 1:
            sums.insert(1, "0")
        cells = [f"`{name}`", order, *sums, f"{values[-1]:g}", where]
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def fronts() -> str:
    """The most useful points of each front: the ends, and the one nearest to zero."""
    lines = [
        (
            "| cylinders | stars | points | M1, M2 at the smallest M1 | nearest to zero | its "
            "firing order | at the smallest M2 |"
        ),
        "|---|---|---|---|---|---|---|",
    ]
    for cylinders in range(3, MOST + 1):
        found = front(cylinders)
        stars = found.question.stars
        nearest = min(found.rows, key=lambda row: row.values[0] ** 2 + row.values[1] ** 2)
        first, last = found.rows[0], found.rows[-1]
        cells = [
            str(cylinders),
            f"{stars.count:,}",
            str(len(found.rows)),
            _pair(first),
            f"**{_pair(nearest)}**",
            _order(stars, nearest),
            _pair(last),
        ]
        lines.append(f"| {' | '.join(cells)} |")
    return "\n".join(lines)


def without_second() -> str:
    """The eights without secondary couple by their primary couple, each value once."""
    found = eight()
    stars = found.question.stars
    one = couple(stars, 1)
    by_value: dict[str, list[AnswerRow]] = {}
    for row in found.rows:
        by_value.setdefault(_exact(one, row), []).append(row)
    lines = [
        (
            "| M1 exactly | M1 | stars | classes | fewest neighbours in succession | a firing "
            "order with them |"
        ),
        "|---|---|---|---|---|---|",
    ]
    shown = list(by_value.items())[:SHOWN]
    for form, group in shown:
        calm = min(group, key=lambda row: row.neighbours)
        many = sum(row.stars for row in group)
        lines.append(
            f"| {form} | {_number(group[0].values[0])} | {many} | {len(group)} | "
            f"{calm.neighbours} | {_order(stars, calm)} |"
        )
    return "\n".join(lines)


def _pair(row: AnswerRow) -> str:
    return f",{SPACE}".join(map(_number, row.values))


def _exact(vector: VectorSum, row: AnswerRow) -> str:
    return text(radical.length(vector.exact(row.star))).replace(" ", SPACE)


def _order(stars: Stars, row: AnswerRow) -> str:
    return NO_BREAK.join(map(str, firing_order(stars, row.star)))


def _number(value: float) -> str:
    return "0" if value == 0 else f"{value:.4f}" if value >= 0.001 else f"{value:.2g}"
