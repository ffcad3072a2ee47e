"""A family of engines: the same cylinder unit in rows of 5 to 12, each with the best firing order.

Each member has the cylinders of one engine, at its pitch, on a crankshaft with evenly spaced throws
as the firing order needs; gas and speed are those of the engine, so that the power is in proportion
to the number of cylinders. Of all crank stars the search takes the one that is best by its goals,
with proof; a given order stands beside it. Engines whose chain or gear drive stands in the middle
have a wider gap there.

Counterweights, balance shafts, block and mounts of the engine are its own and are left out; of its
table [torsion] the chain is that of as many throws (`family_torsion`).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import pi
from typing import Literal

import numpy as np

from crankstar.analyses.guide.family_torsion import Twist, not_grown, twist, with_throws
from crankstar.analyses.guide.published_orders import Published, backwards
from crankstar.analyses.guide.question import ChainDrive
from crankstar.analyses.marine.marine_analysis import MarineAnalysis, marine
from crankstar.engine.copies import with_values, wrapped
from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder, Throw
from crankstar.language.faults import Fault
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.mechanics.guide_moments import MarineError
from crankstar.remedy.end_weights import NothingToShareError
from crankstar.stars.answer import answer_to
from crankstar.stars.engine_stars import star_of, stars_of, with_star
from crankstar.stars.faults import SearchError
from crankstar.stars.options import SearchOptions, search_for
from crankstar.stars.question import Best
from crankstar.stars.star import Star, Stars

Chosen = Literal["best", "given", "published"]
OF_FAMILY = {"alike-order": "family-alike-order", "alike-throws": "family-alike-throws"}
"""Faults of one search, and of the same search among others."""


@dataclass(frozen=True)
class Member:
    """An engine of a family with a firing order: its moments, and why this order.

    `found` is None where no order keeps the limits: there is no engine then. `h` and `x` are the
    greatest guide-force moments and their orders; `twist` is the torsion of the order of X, and
    `without_chain` says why it is by a straight shape; `published` is where this order, or its
    mirror image, was read.
    """

    cylinders: int
    chosen: Chosen
    order: tuple[int, ...]
    found: MarineAnalysis | None
    h: tuple[float, float] | None
    x: tuple[float, float] | None
    twist: Twist | None
    without_chain: str = ""
    published: Published | None = None


def engine_family(
    engine: Engine,
    *,
    numbers: Sequence[int],
    given: Sequence[Sequence[int]] = (),
    published: Sequence[Published] = (),
    options: SearchOptions | None = None,
    drive: ChainDrive | None = None,
    point: str = "",
    speed: float | None = None,
    horizontal_share: float | None = None,
) -> tuple[Member, ...]:
    """The members with these numbers of cylinders, the best of each and then other known orders.

    Orders are known that are `given`, that of the engine, and those `published`, without mirror
    images of others. `options` are goals and limits of the
    search, by default least M1 and M2 together.
    Weights at the ends are left out where there is no first-order moment to be shared. Raises
    MarineError for an engine that is not a row of alike cylinders, RemedyError for weights at the
    ends of one that does not stand up, SearchError for goals that cannot be.

    >>> from crankstar.files.catalog import load
    >>> five, seven = engine_family(load("man-s90mc-c"), numbers=[5, 7])
    >>> "-".join(map(str, seven.order)), round(seven.found.after.moment(2), 4)
    ('1-7-2-5-4-3-6', 0.5235)
    """
    asked = {"point": point, "speed": speed, "horizontal_share": horizontal_share}
    members: list[Member] = []
    for count in numbers:
        orders = _known([*given, engine.firing_order], published, count)
        known = [with_cylinders(engine, order, drive=drive) for order in orders]
        plain = with_cylinders(engine, range(1, count + 1), drive=drive)
        best, why = _best(plain, known, options, speed=speed), not_grown(engine, count)
        if best is None:
            members.append(Member(count, "best", (), None, None, None, None))
        else:
            members.append(member(best, "best", asked, why))
        members += [
            member(one, orders[one.firing_order], asked, why) for one in known if one is not best
        ]
    return tuple(replace(each, published=_source(each.order, published)) for each in members)


def best_orders(
    engine: Engine,
    numbers: Sequence[int],
    *,
    options: SearchOptions | None = None,
    drive: ChainDrive | None = None,
    speed: float | None = None,
) -> list[tuple[int, ...]]:
    """The best firing order of each number of cylinders that has one. Raises as `engine_family`.

    >>> from crankstar.files.catalog import load
    >>> best_orders(load("man-s90mc-c"), [5, 7])
    [(1, 5, 2, 3, 4), (1, 7, 2, 5, 4, 3, 6)]
    """
    plain = [with_cylinders(engine, range(1, count + 1), drive=drive) for count in numbers]
    found = [_best(each, [], options, speed=speed) for each in plain]
    return [tuple(each.firing_order) for each in found if each is not None]


def _known(
    given: Sequence[Sequence[int]], published: Sequence[Published], count: int
) -> dict[tuple[int, ...], Chosen]:
    """The orders of so many cylinders that are known, and by what."""
    orders: dict[tuple[int, ...], Chosen] = {
        tuple(order): "given" for order in given if len(order) == count
    }
    for each in published:
        if len(each.order) == count and backwards(each.order) not in orders:
            orders.setdefault(each.order, "published")
    return orders


def _source(order: tuple[int, ...], published: Sequence[Published]) -> Published | None:
    """Where an order was read, or else its mirror image."""
    same = {each.order: each for each in reversed(published)}
    return same.get(order) or (same.get(backwards(order)) if order else None)


def with_cylinders(
    engine: Engine, order: Sequence[int], *, drive: ChainDrive | None = None
) -> Engine:
    """An engine with as many of its cylinders in a row as fire in this order, evenly.

    Raises MarineError for an engine that is not a row of alike cylinders on one crankshaft.

    >>> from crankstar.files.catalog import load
    >>> five = with_cylinders(load("man-s90mc-c"), [1, 4, 3, 2, 5])
    >>> five.firing_order, [round(cylinder.z, 6) for cylinder in five.cylinders]
    ((1, 4, 3, 2, 5), [2.0, 1.0, 0.0, -1.0, -2.0])
    """
    first, throw, pitch = _unit(engine)
    count = len(order)
    if sorted(order) != list(range(1, count + 1)):
        raise MarineError(
            "{order} is no firing order; give each cylinder from 1 on once",
            order="-".join(map(str, order)),
        )
    places = [(count - 1) / 2 * pitch - index * pitch for index in range(count)]
    if drive is not None and count >= drive.cylinders:
        half = drive.wider / 2
        places = [z + half if index < count // 2 else z - half for index, z in enumerate(places)]
    step = engine.sense * (2 if engine.cycle == "four-stroke" else 1) * 2 * pi / count
    fires = {number: index for index, number in enumerate(order)}
    top = first.bearing
    throws = tuple(
        with_values(throw, angle=wrapped(top - fires[number] * step), z=places[number - 1])
        for number in range(1, count + 1)
    )
    cylinders = tuple(
        with_values(first, number=number, throw=number, z=places[number - 1], chamber=None)
        for number in range(1, count + 1)
    )
    shaft = with_values(
        engine.shaft(first.shaft),
        throws=throws,
        weights=(),
        bearings=(),
        bearing_count=None,
        webs=(),
    )
    return with_values(
        engine,
        name=one_line(_("{engine}, {count} cylinders", engine=engine.name, count=count)),
        shafts=(shaft,),
        cylinders=cylinders,
        firing_order=tuple(order),
        firing_angles=None,
        valves=engine.valves and with_values(engine.valves, manifolds=()),
        block=None,
        torsion=with_throws(engine, count),
        mounts=(),
        foundation=None,
        oil=None,
        provenance={},
    )


def _unit(engine: Engine) -> tuple[Cylinder, Throw, float]:
    """The cylinder and throw that all have, and their distance. Raises MarineError."""
    shafts = {cylinder.shaft for cylinder in engine.cylinders}
    own = {
        (
            cylinder.bearing,
            cylinder.bore,
            cylinder.rod_length,
            cylinder.offset,
            round(cylinder.reciprocating, 9),
            round(engine.throw(cylinder).radius, 9),
            round(engine.throw(cylinder).turning_mass, 9),
        )
        for cylinder in engine.cylinders
    }
    shared = len({cylinder.throw for cylinder in engine.cylinders}) < len(engine.cylinders)
    strange = any(cylinder.articulated or cylinder.chamber for cylinder in engine.cylinders)
    if len(shafts) > 1 or len(own) > 1 or shared or strange or len(engine.cylinders) < 2:
        raise MarineError(
            "a family is made of one row of alike cylinders, each on a throw of its own; "
            "{engine} is another engine",
            engine=engine.name,
        )
    places = sorted(cylinder.z for cylinder in engine.cylinders)
    return engine.first, engine.throw(engine.first), float(np.min(np.diff(places)))


def _best(
    engine: Engine, known: Sequence[Engine], options: SearchOptions | None, *, speed: float | None
) -> Engine | None:
    """The engine with the best star; None where no star keeps the limits. Raises SearchError.

    One of those that are known, if its star is of the class of the best: as good, seen from the
    other end or turning the other way.
    """
    asked = SearchOptions(ask=Best(1)) if options is None else options
    pace = engine.speed if speed is None else speed
    try:
        question = search_for(engine, asked, speed=pace).question
    except SearchError as error:
        count = len(engine.cylinders)
        raise SearchError([_of_family(fault, count) for fault in error.faults]) from None
    rows = answer_to(question).rows
    if not rows:
        return None
    stars = stars_of(engine)
    alike = {_from_first(star, stars) for star in stars.same(rows[0].star)}
    for one in known:
        own = star_of(one, stars)
        if own is not None and _from_first(own, stars) in alike:
            return one
    return with_values(with_star(engine, stars, rows[0].star), name=engine.name)


def _of_family(fault: Fault, cylinders: int) -> Fault:
    """A fault that hangs on the number of cylinders, which it then names."""
    code = OF_FAMILY.get(fault.code)
    if code is None:
        return fault
    return fault._replace(code=code, values={**fault.values, "cylinders": cylinders})


def _from_first(star: Star, stars: Stars) -> Star:
    """A star turned so that cylinder 1 has direction 0."""
    return tuple((direction - star[0]) % stars.directions for direction in star)


def member(engine: Engine, chosen: Chosen, asked: Mapping[str, object], why: str = "") -> Member:
    """A member with its moments; `asked` are options of `marine`, `why` is its `without_chain`.

    >>> from crankstar.files.catalog import load
    >>> five = member(with_cylinders(load("man-s90mc-c"), [1, 4, 3, 2, 5]), "given", {})
    >>> five.cylinders, five.order
    (5, (1, 4, 3, 2, 5))
    """
    try:
        found = marine(engine, **asked)  # pyright: ignore[reportArgumentType]
    except NothingToShareError:
        found = marine(engine, **{**asked, "horizontal_share": None})
    guide = found.guide
    h = x = order = None
    if guide is not None:
        top = int(np.argmax(np.abs(guide.h)))
        h = float(guide.orders[top]), float(abs(guide.h[top]))
        if guide.pitch_known:
            top = int(np.argmax(np.abs(guide.x)))
            order, size = float(guide.orders[top]), float(abs(guide.x[top]))
            x = order, size
    count, fires = len(engine.cylinders), tuple(engine.firing_order)
    return Member(count, chosen, fires, found, h, x, twist(engine, order), why)
