"""Which orders of gas torque an engine has, exactly, relative to one of its cylinders.

Alike cylinders give the same torque at their own firing angles theta_j, so that order k of the
engine is order k of one cylinder times

    S_k = sum over j of exp(-i k theta_j)

Where N cylinders fire every C/N, C the angle of a cycle, that is a geometric sum with
z = exp(-i k C/N): N where z = 1, and (1 - z^N)/(1 - z) = 0 elsewhere, for an order k completes
whole periods in a cycle and z^N = 1. So only multiples of 2 pi N/C remain: of N/2 in four strokes,
of N in two. Where firing is uneven, and for a bank or a part of the cylinders, S_k is a number of a
cyclotomic field: zero if and only if its reduced polynomial is, else of closed length. No tolerance
is used.

Cylinders that are off still compress. With c_k the order of one that fires, m_k that of one that
is off, the engine has c_k S_k - (c_k - m_k) D_k, D_k the sum over those that are off: where S_k = 0
the factor of |c_k - m_k| is |D_k|.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from fractions import Fraction

from crankstar.derive.algebra import cyclotomic, radicals
from crankstar.derive.algebra.cyclotomic import Number
from crankstar.derive.algebra.formula import (
    Degrees,
    Formula,
    Polar,
    Power,
    Ratio,
    Symbol,
    number,
    product,
    summed,
)
from crankstar.derive.chapters import Chapter
from crankstar.derive.exhaust import part_of_turn
from crankstar.derive.records import DerivationError, Line, Step
from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder
from crankstar.firing.exhaust_orders import checked
from crankstar.language.faults import listed
from crankstar.language.messages import _, _n
from crankstar.mechanics.gas import chambers_of

Places = Mapping[int, Fraction]
"""The firing angle of each cylinder, turns."""
USUAL = 4
"""Orders up to this one are shown, and up to the first of even firing."""
GREATEST = Fraction(24)


def places_of(engine: Engine) -> Places:
    """The firing angles of an engine with alike cylinders, exactly. Raises DerivationError."""
    fired = checked(engine, highest=1.0)
    shapes = {
        tuple(sorted(_shape(engine, piston) for piston in pistons))
        for pistons in engine.chambers.values()
    }
    if len(shapes) > 1 or any(cylinder.articulated for cylinder in engine.cylinders):
        raise DerivationError(
            "this closed form needs cylinders that are all alike in bore, stroke and rod; "
            "`crankstar torque` computes those of any engine"
        )
    return {
        cylinder: part_of_turn(cylinder, angle)
        for cylinder, angle in zip(fired.order, fired.angles_deg, strict=True)
    }


def _shape(engine: Engine, cylinder: Cylinder) -> tuple[float, ...]:
    """What must be alike of two cylinders whose gas gives the same torque."""
    radius = engine.throw(cylinder).radius
    return cylinder.bore or 0.0, cylinder.rod_length, radius, cylinder.offset


def factor(places: Places, order: Fraction, cylinders: Collection[int] = ()) -> Number:
    """S_k over these cylinders, or all: what order k is of that of one cylinder.

    >>> from crankstar.derive.algebra import typeset
    >>> from crankstar.files.catalog import load
    >>> twin = places_of(load("i2-270"))
    >>> [typeset.text(radicals.length(factor(twin, Fraction(k)))) for k in (1, 2)]
    ['√2', '0']
    """
    chosen = cylinders or places
    return cyclotomic.total(cyclotomic.root(-order * places[cylinder]) for cylinder in chosen)


def gas_orders(
    engine: Engine, orders: Sequence[Fraction] = (), *, off: Collection[int] = ()
) -> Chapter:
    """Which orders of gas torque remain, with the factor of each: of the engine and its banks.

    `orders` by default all up to the first one of even firing, at least 4; `off` are cylinders that
    do not fire. Raises DerivationError.

    >>> from crankstar.derive.algebra import typeset
    >>> from crankstar.files.catalog import load
    >>> lines = gas_orders(load("ducati-90")).steps[2].lines
    >>> [typeset.text(line.chain[-1]) for line in lines[:4]]  # orders 0.5, 1, 1.5 and 2
    ['√(2 − √2)', '√2', '√(2 + √2)', '0']
    """
    places = places_of(engine)
    wanted = orders_of(engine, places, orders)
    cycle = cycle_of(engine)
    off = chambers_of(engine, off)
    whole = [_line(places, order) for order in wanted]
    words = (_("The lengths of S, counted in that order of one cylinder; 0 is exact."),)
    steps = [
        _one(places, 1 / cycle),
        _even(cycle, len(places)) if _is_even(places, cycle) else _uneven(places, cycle),
        Step(_("All cylinders"), words, tuple(whole)),
        *_banks(engine, places, wanted),
    ]
    if off:
        steps.append(_off(places, wanted, off))
    return Chapter(engine.name, _("Gas torque by order"), None, {}, tuple(steps), {})


def cycle_of(engine: Engine) -> Fraction:
    """The turns of a working cycle."""
    return Fraction(engine.cycle_angle).limit_denominator(1000) / 360


def orders_of(engine: Engine, places: Places, orders: Sequence[Fraction]) -> list[Fraction]:
    """The orders that are asked for, else all up to the first one of even firing, at least 4.

    Raises DerivationError for one that gas torque does not have.
    """
    cycle = cycle_of(engine)
    step, count = 1 / cycle, len(places)
    wanted = [*orders] or [step * n for n in range(1, int(max(USUAL, count / cycle) / step) + 1)]
    wrong = next((k for k in wanted if (k / step).denominator != 1 or not 0 < k <= GREATEST), None)
    if wrong is not None:
        raise DerivationError(
            "gas torque has no order {order}: its orders are multiples of {step} up to {greatest}",
            order=wrong,
            step=step,
            greatest=GREATEST,
        )
    return wanted


def _line(places: Places, order: Fraction, cylinders: Collection[int] = ()) -> Line:
    name = Symbol("S", str(order))
    length = radicals.length(factor(places, order, cylinders))
    return Line(name, (length,), label=_("order {order}", order=order))


def _is_even(places: Places, cycle: Fraction) -> bool:
    """Whether the firing angles are an N-th part of the cycle apart, exactly."""
    first = min(places.values())
    parts = sorted((place - first) % cycle for place in places.values())
    return parts == [n * cycle / len(places) for n in range(len(places))]


def _one(places: Places, step: Fraction) -> Step:
    """The law, and when each cylinder fires."""
    words = (
        _(
            "The gas in one cylinder gives a torque of the orders k = {step}, {second}, ... Alike "
            "cylinders give the same one, each from its own firing angle. So order k of the engine "
            "is that of one cylinder times S, the sum of one unit vector for each cylinder.",
            step=step,
            second=2 * step,
        ),
    )
    lines = [
        Line(
            Symbol("theta", str(cylinder)),
            (degrees_of(place),),
            label=_("cylinder {number}", number=cylinder),
        )
        for cylinder, place in places.items()
    ]
    law = Line(Symbol("S", "k"), (_vectors([*places]),), label=_("order {order}", order="k"))
    return Step(_("One cylinder"), words, (*lines, law))


def degrees_of(place: Fraction) -> Formula:
    """A part of a turn in degrees."""
    return Degrees(number(place * 360))


def _vectors(cylinders: Sequence[int]) -> Formula:
    """Unit vectors at minus k times the firing angles."""
    angles = (product(-1, Symbol("k"), Symbol("theta", str(one))) for one in cylinders)
    return summed(*(Polar(number(1), angle) for angle in angles))


def _even(cycle: Fraction, count: int) -> Step:
    """The geometric sum of even firing."""
    first, z = Fraction(count) / cycle, Symbol("z")
    terms = [number(1), z, Power(z, 2)][:count]
    more = [] if count <= len(terms) else [Symbol("…"), Power(z, count - 1)]
    if count == len(terms) + 1:
        more = [Power(z, count - 1)]
    raised = z if count == 1 else Power(z, count)
    closed = Ratio(summed(number(1), product(-1, raised)), summed(number(1), product(-1, z)))
    turned = product(-1, Symbol("k"), degrees_of(cycle / count))
    sums = (summed(*terms, *more), closed) if count > 1 else (number(1),)
    lines = (
        Line(z, (Polar(number(1), turned),), label=_("from one firing to the next")),
        Line(Symbol("S", "k"), sums, label=_("geometric sum")),
    )
    words = (
        _n(
            "One cylinder fires every {interval} deg.",
            "{count} cylinders fire every {interval} deg, so that each vector is the one before "
            "times z.",
            count,
            count=count,
            interval=cycle * 360 / count,
        ),
        _(
            "Over a cycle of {cycle} deg an order completes whole periods, so that z to the power "
            "of {count} is 1. Where z itself is not 1 the sum is therefore 0, exactly. z is 1 for "
            "multiples of {first} only, and there S is {count}: every other order of the gas "
            "torque vanishes, at every load and speed.",
            cycle=cycle * 360,
            count=count,
            first=first,
        ),
    )
    return Step(_("Even firing"), words, lines)


def _uneven(places: Places, cycle: Fraction) -> Step:
    """What uneven firing leaves, before it is computed."""
    ordered = sorted(place % cycle for place in places.values())
    following = [*ordered[1:], ordered[0] + cycle]
    gaps = [(b - a) * 360 for a, b in zip(ordered, following, strict=True)]
    words = (
        _(
            "The cylinders fire at intervals of {intervals} deg, so that the vectors close to no "
            "regular polygon: S is computed order by order. Each is a number made of roots of "
            "unity, and whether it is 0 is decided without a tolerance.",
            intervals="-".join(str(gap) for gap in gaps),
        ),
    )
    return Step(_("Uneven firing"), words)


def _banks(engine: Engine, places: Places, wanted: Sequence[Fraction]) -> list[Step]:
    """The factor of each bank that has a part of the cylinders."""
    chamber = {each.number: each.chamber or each.number for each in engine.cylinders}
    steps: list[Step] = []
    for name, numbers in engine.banks.items():
        own = tuple(dict.fromkeys(chamber[one] for one in numbers))
        if 1 < len(own) < len(places):
            lines = tuple(_line(places, order, own) for order in wanted)
            words = (
                _(
                    "Cylinders {numbers}: what they give to their part of the crankshaft.",
                    numbers=listed(own),
                ),
            )
            steps.append(Step(_("Bank {name}", name=name), words, lines))
    return steps


def _off(places: Places, wanted: Sequence[Fraction], off: Collection[int]) -> Step:
    """What comes up where cylinders do not fire."""
    words = (
        _n(
            "Cylinder {numbers} does not fire. What it lacks is the difference between a cylinder "
            "that fires and one that is only turned: in that difference S is counted here, and "
            "where S of all cylinders is 0 it is all that there is of an order.",
            "Cylinders {numbers} do not fire. What they lack is the difference between a cylinder "
            "that fires and one that is only turned: in that difference S is counted here, and "
            "where S of all cylinders is 0 it is all that there is of an order.",
            len(set(off)),
            numbers=listed(sorted(set(off))),
        ),
    )
    lines = tuple(_line(places, order, sorted(set(off))) for order in wanted)
    return Step(_("Cylinders that are off"), words, lines)
