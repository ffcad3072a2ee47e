"""The formulas of `printed.toml`, as the sources print them, joined with the derived ones."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from importlib.resources import files
from math import degrees
from typing import Any

from crankstar.derive import Derivation, derivation
from crankstar.derive.algebra import cyclotomic, wave
from crankstar.derive.algebra.evaluation import value
from crankstar.derive.algebra.formula import (
    THETA,
    Applied,
    Degrees,
    Formula,
    Pi,
    Power,
    Ratio,
    Symbol,
    angle,
    number,
    product,
    square_root,
    summed,
)
from crankstar.derive.bodies import bodies
from crankstar.derive.errata.records import Confirmed, ErrataError, Erratum
from crankstar.engine.engine import Engine
from crankstar.engine.motion import series_coefficient
from crankstar.files.catalog import load
from crankstar.language.messages import _
from crankstar.mechanics.balance import parts

LENGTH = Symbol("L")
"""Rod length over stroke, in which both V8 pages write their series."""
BEARINGS = {"up": 0.0, "right": 90.0}


def errata(source: str | None = None) -> tuple[Erratum, ...]:
    """Every wrong formula of the sources, or of one of them by its key in the bibliography.

    Raises ErrataError where there is no such source.

    >>> [erratum.id for erratum in errata("sinitsyn")]
    ['sinitsyn-7-first-angle', 'sinitsyn-7-second-angle']
    """
    if source is None:
        return _all()
    if source not in sources():
        raise ErrataError(
            _("No such source has errata; choose from {sources}.", sources=", ".join(sources()))
        )
    return tuple(erratum for erratum in _all() if erratum.source == source)


def sources() -> dict[str, str]:
    """The sources: how each is called, by its key in the bibliography."""
    return _data()["names"]


def confirmed() -> tuple[Confirmed, ...]:
    """Statements of the sources that are true: a short list.

    >>> confirmed()[0].words
    'There is no first-order force.'
    """
    return tuple(Confirmed(**{**entry, "size": size(entry["size"])}) for entry in _data()["true"])


@lru_cache(maxsize=1)
def _data() -> dict[str, Any]:
    return tomllib.loads(
        files("crankstar.derive.errata").joinpath("printed.toml").read_text(encoding="utf-8")
    )


@lru_cache(maxsize=1)
def _all() -> tuple[Erratum, ...]:
    data = _data()
    out = [erratum for entry in data["erratum"] for erratum in _judged(entry, data["slips"])]
    out += [_series(entry, data["slips"]["series"]) for entry in data["series"]]
    out += [_line(entry) for entry in data["misprint"]]
    out += [_angle(entry) for entry in data["angle"]]
    return tuple(out)


def _judged(entry: Mapping[str, Any], slips: Mapping[str, Any]) -> Iterator[Erratum]:
    """The components of one sum, each printed and derived."""
    engine = load(entry["engine"], changes=entry.get("changes", {}))
    order, quantity, letter = entry["order"], entry["quantity"], entry.get("letter", "")
    cylinders = tuple(entry.get("cylinders", ()))
    derived = derivation(engine, order, "force" if quantity == "roll" else quantity)
    for item in entry["formulas"]:
        component = item["component"]
        slip = slips[item.get("slip", entry["slip"])]
        yield Erratum(
            id=f"{entry['id']}-{component}" if component else entry["id"],
            **_given(entry),
            kind=entry.get("kind", "result"),
            title=entry["title"],
            text=item["printed"],
            printed=formula_of(item["terms"], order) if "terms" in item else None,
            ours=_roll(engine, order)
            if quantity == "roll"
            else _derived(engine, derived, component, cylinders),
            slip=slip["words"],
            step=slip["step"],
            unit=_unit(quantity, order, letter),
            quantity=quantity,
            component=component,
            cylinders=cylinders,
            letter=letter,
            scale=derived.symbols[letter] if letter else 1.0,
            points=tuple((float(at), Fraction(size)) for at, size in item.get("points", ())),
        )


def _given(entry: Mapping[str, Any]) -> dict[str, Any]:
    """The source of an erratum, the place in it, and the order of an engine that it is about."""
    names = ("source", "place", "engine", "changes", "order")
    return {name: entry[name] for name in names if name in entry}


def formula_of(terms: Sequence[Mapping[str, Any]], order: int = 0) -> Formula:
    """A printed formula from its terms.

    >>> from crankstar.derive.algebra.typeset import text
    >>> text(formula_of([{"amplitude": "2", "letter": "b", "function": "sin", "phase": "-1/8"}], 2))
    '2b sin(2θ − π/4)'
    """
    return summed(*(_term(term, order) for term in terms))


def _term(term: Mapping[str, Any], order: int) -> Formula:
    factors: list[Formula] = [number(Fraction(term["amplitude"]))]
    if "letter" in term:
        factors.append(Symbol(term["letter"]))
    function = term.get("function", "")
    if function == "pi":
        factors.append(Pi())
    elif function == "atan":
        factors.append(Applied("atan", number(Fraction(term["argument"]))))
    elif function:
        variable = (
            Symbol(term["variable"])
            if "variable" in term
            else product(term.get("order", order), THETA)
        )
        factors.append(Applied(function, summed(variable, angle(Fraction(term.get("phase", "0"))))))
    return product(*factors)


def size(text: str) -> Formula:
    """A number such as 0, 1/2, 2*sqrt(3)."""
    factor, _, root = text.removesuffix(")").rpartition("sqrt(")
    if "sqrt" not in text:
        return number(Fraction(text))
    return product(Fraction(factor.rstrip("*") or 1), square_root(Fraction(root)))


def _unit(quantity: str, order: int, letter: str) -> Formula:
    """M r w^2 A_k, times the length in which a couple is counted; the essay calls m r w^2 P."""
    factors: list[Formula] = [Symbol("m"), Symbol("r"), Power(Symbol("omega"), 2)]
    if order > 1:
        factors.append(Symbol("A", str(order)))
    if quantity == "roll" or (quantity == "couple" and not letter):
        factors.append(LENGTH)
    return product(*factors)


def _derived(
    engine: Engine, derived: Derivation, component: str, cylinders: tuple[int, ...]
) -> Formula:
    """The closed form that our derivation comes to, for the whole engine or for some cylinders."""
    if not cylinders:
        own = derived.up if component == "up" else derived.right
        if derived.quantity == "couple" and set(derived.symbols) == {
            "a"
        }:  # counted in the pitch, as the essay's P L
            own = dict.fromkeys([()], next(iter(own.values()))) if own else {}
        return wave.signal(own, derived.order)
    rows = tuple(row for row, part in enumerate(parts(engine)) if part.cylinder in cylinders)
    bearing = BEARINGS.get(component)
    if bearing is None:
        bearing = next(
            round(degrees(c.bearing), 9) for c in engine.cylinders if c.number == cylinders[0]
        )
    lines = [
        line
        for step in derived.steps
        for line in step.lines
        if line.kind == "signal" and line.rows == rows
    ]
    return next(line.chain[-1] for line in lines if round(line.bearing_deg, 9) == bearing)


def _roll(engine: Engine, order: int) -> Formula:
    """The clockwise moment of upward forces about the middle between the crankshafts.

    Counted in the distance between them.

    The pushes of the parts are those of the derivation; masses on a shaft have only its own arm,
    since what they push along their crank goes through it.
    """
    places = {shaft.name: shaft.right for shaft in engine.shafts}
    low, high = min(places.values()), max(places.values())
    arms = {
        name: Fraction(round(1e6 * (0.5 - (place - low) / (high - low))), 10**6)
        for name, place in places.items()
    }
    moving = bodies(engine, Fraction(order)).moving
    return wave.signal(
        wave.joined(wave.scaled(body.push.up, {(): arms[body.shaft]}) for body in moving),
        Fraction(order),
    )


def _series(entry: Mapping[str, Any], slip: Mapping[str, str]) -> Erratum:
    """A printed series of A_k beside the true one of as many terms."""
    printed = [(power, Fraction(factor)) for power, factor in entry["terms"]]
    return Erratum(
        **_given(entry),
        id=entry["id"],
        kind="series",
        title=f"series of A{entry['order']}",
        text=entry["printed"],
        printed=_powers(printed),
        ours=_powers(true_series(entry["order"], len(printed))),
        slip=f"{entry['words']} {slip['words']}",
        step=slip["step"],
    )


def true_series(order: int, terms: int) -> list[tuple[int, Fraction]]:
    """The first powers of 1/L that occur in A_k, L = l/(2r), with their exact coefficients.

    >>> [(power, str(factor)) for power, factor in true_series(4, 2)]
    [(3, '-1/32'), (5, '-3/512')]
    """
    powers = range(order - 1, order - 1 + 2 * terms, 2)
    return [(power, series_coefficient(order, power) / 2**power) for power in powers]


def _powers(terms: Sequence[tuple[int, Fraction]]) -> Formula:
    out: list[Formula] = []
    for power, factor in terms:
        letter: Formula = LENGTH if power == 1 else Power(LENGTH, power)
        below = product(factor.denominator, letter)
        out.append(product(1 if factor > 0 else -1, Ratio(number(abs(factor.numerator)), below)))
    return summed(*out)


def _line(entry: Mapping[str, Any]) -> Erratum:
    """A line that does not follow from the one before it."""
    return Erratum(
        **_given(entry),
        id=entry["id"],
        kind="line",
        title=entry["place"].rpartition(", ")[2],
        text=entry["printed"],
        printed=formula_of(entry["terms"]),
        ours=_closed(entry["equals"]) if entry.get("closed") else formula_of(entry["equals"]),
        slip=entry["words"],
    )


def _closed(terms: Sequence[Mapping[str, Any]]) -> Formula:
    """Cosines of one order added up exactly."""
    pieces = [
        cyclotomic.root(Fraction(term["phase"])).times(Fraction(term["amplitude"]))
        for term in terms
    ]
    return wave.signal(wave.joined({(): piece} for piece in pieces), Fraction(terms[0]["order"]))


def _angle(entry: Mapping[str, Any]) -> Erratum:
    """A phase in degrees beside that of the derived couple."""
    derived = derivation(load(entry["engine"]), entry["order"], "couple")
    (amount,) = derived.up.values()
    turn = wave.turn_of(amount)
    ours = wave.bearing(amount) if turn is None else Degrees(number(360 * turn))
    rounded = f"{degrees(value(ours)):.0f}°".replace("-", "−")
    return Erratum(
        **_given(entry),
        id=entry["id"],
        kind="angle",
        title=entry["place"].rpartition(", ")[2],
        text=entry["printed"],
        printed=Degrees(number(Fraction(entry["degrees"]))),
        ours=ours,
        slip=f"{entry['words']} Rounded it is {rounded}.",
        quantity="couple",
    )
