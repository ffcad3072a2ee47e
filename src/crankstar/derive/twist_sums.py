"""How far an order of gas torque twists a crankshaft in a straight shape, exactly.

A mode of torsion turns cylinder j by a_j. Order k of the gas torque of alike cylinders, which fire
at theta_j, drives it by

    T_k = sum over j of a_j exp(-i k theta_j)

in that order of one cylinder. In a straight shape a_j goes evenly with the place along the
crankshaft, from 1 at the farther end through 0 in the middle: nearly the first mode of a crankshaft
whose node is in the middle. Its a_j are fractions where the cylinders stand in pitches, and T_k is
a number of a cyclotomic field: 0 if and only if its reduced polynomial is. No tolerance is used.

Source: J. P. Den Hartog, Mechanical Vibrations, section 5.4, for the star diagrams of torsion.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction

from crankstar.derive.algebra import cyclotomic, radicals
from crankstar.derive.algebra.cyclotomic import Number
from crankstar.derive.algebra.formula import Polar, Symbol, number, product, summed
from crankstar.derive.chapters import Chapter
from crankstar.derive.firing_sums import Places, degrees_of, orders_of, places_of
from crankstar.derive.records import DerivationError, Line, Step
from crankstar.engine.engine import Engine
from crankstar.firing.weighing import twist_shape
from crankstar.language.faults import listed
from crankstar.language.messages import _

Amplitudes = Mapping[int, Fraction]
FINEST = 10_000
"""Greatest denominator of an amplitude: places that are no such fraction are not exact."""
ROUNDING = 1e-9


def amplitudes_of(engine: Engine) -> Amplitudes:
    """The straight shape at each chamber, exactly. Raises DerivationError, WeighingError.

    >>> from crankstar.files.catalog import load
    >>> [str(each) for each in amplitudes_of(load("i4")).values()]
    ['1', '1/3', '-1/3', '-1']
    """
    out: dict[int, Fraction] = {}
    for cylinder, amplitude in twist_shape(engine).items():
        out[cylinder] = Fraction(amplitude).limit_denominator(FINEST)
        if abs(out[cylinder] - amplitude) > ROUNDING:
            raise DerivationError(
                "cylinder {number} stands at no fraction of the length of the crankshaft; "
                "`crankstar orders --minimise twist` computes the sums of any engine",
                number=cylinder,
            )
    return out


def twist(places: Places, amplitudes: Amplitudes, order: Fraction) -> Number:
    """T_k: what order k makes of a shape, in that order of one cylinder.

    The customary six has no order 3 in a straight shape, in which all its cylinders push at once:

    >>> from crankstar.derive.algebra import typeset
    >>> from crankstar.files.catalog import load
    >>> six = load("i6")
    >>> own = places_of(six), amplitudes_of(six)
    >>> [typeset.text(radicals.length(twist(*own, Fraction(k, 2)))) for k in (3, 6)]
    ['18/5', '0']
    """
    vectors = (
        cyclotomic.root(-order * place).times(amplitudes[cylinder])
        for cylinder, place in places.items()
    )
    return cyclotomic.total(vectors)


def twist_orders(engine: Engine, orders: Sequence[Fraction] = ()) -> Chapter:
    """Which orders of gas torque twist a crankshaft in a straight shape, and how far.

    `orders` by default all up to the first one of even firing, at least 4. Raises DerivationError,
    and WeighingError where all cylinders stand at one place.

    >>> from crankstar.derive.algebra import typeset
    >>> from crankstar.files.catalog import load
    >>> lines = twist_orders(load("i4")).steps[-1].lines
    >>> [typeset.text(line.chain[-1]) for line in lines[:4]]  # orders 0.5, 1, 1.5 and 2
    ['2√10/3', '0', '2√10/3', '0']
    """
    places, amplitudes = places_of(engine), amplitudes_of(engine)
    lines = [
        Line(
            Symbol("T", str(order)),
            (radicals.length(twist(places, amplitudes, order)),),
            label=_("order {order}", order=order),
        )
        for order in orders_of(engine, places, orders)
    ]
    words = (_("The lengths of T, counted in that order of one cylinder; 0 is exact."),)
    steps = (
        _one(places, amplitudes),
        *_together(engine, places, amplitudes),
        Step(_("All cylinders"), words, tuple(lines)),
    )
    return Chapter(engine.name, _("Twist by order"), None, {}, steps, {})


def _one(places: Places, amplitudes: Amplitudes) -> Step:
    """The law, the shape, and when each cylinder fires."""
    words = (
        _(
            "Order k of the gas torque of a cylinder drives a vibration of the crankshaft by its "
            "amplitude a there. Here the shape is straight: a goes evenly with the place along the "
            "crankshaft, 1 at the farthest cylinder and 0 in the middle of all. Order k of the "
            "engine is that of one cylinder times T, the sum of a vector a for each cylinder."
        ),
    )
    lines = [
        Line(
            Symbol(letter, str(cylinder)), (formula,), label=_("cylinder {number}", number=cylinder)
        )
        for letter in ("a", "theta")
        for cylinder, place in places.items()
        for formula in [number(amplitudes[cylinder]) if letter == "a" else degrees_of(place)]
    ]
    vectors = summed(
        *(
            Polar(Symbol("a", str(one)), product(-1, Symbol("k"), Symbol("theta", str(one))))
            for one in places
        )
    )
    law = Line(Symbol("T", "k"), (vectors,), label=_("order {order}", order="k"))
    return Step(_("One cylinder"), words, (*lines, law))


def _together(engine: Engine, places: Places, amplitudes: Amplitudes) -> list[Step]:
    """Cylinders at dead centre together, one of which fires a turn later."""
    met: dict[Fraction, list[int]] = {}
    for cylinder, place in places.items():
        met.setdefault(place % 1, []).append(cylinder)
    if engine.cycle == "two-stroke" or max(map(len, met.values())) < 2:
        return []
    words = (
        _(
            "Cylinders that are at top dead centre together fire a turn apart. In a whole order "
            "that is a whole number of turns of the vector: their amplitudes add up. In a half "
            "order it is half a turn more: they are subtracted. So whole orders do not depend on "
            "which of them fires first, and half orders do."
        ),
    )
    lines: list[Line] = []
    for numbers in (each for each in met.values() if len(each) > 1):
        named = listed(numbers)
        letters = [Symbol("a", str(one)) for one in numbers]
        turns = [places[one] // 1 for one in numbers]
        for half, label in (
            (False, _("cylinders {numbers}, whole orders", numbers=named)),
            (True, _("cylinders {numbers}, half orders", numbers=named)),
        ):
            signs = [-1 if half and (turn - turns[0]) % 2 else 1 for turn in turns]
            total = sum(sign * amplitudes[one] for sign, one in zip(signs, numbers, strict=True))
            terms = (product(sign, each) for sign, each in zip(signs, letters, strict=True))
            lines.append(Line(summed(*terms), (number(total),), label=label))
    return [Step(_("Cylinders at top dead centre together"), words, tuple(lines))]
