"""The units in which results are shown: a choice of the context, beside that of the language.

Records stay in SI. A dimension without a chosen unit has its SI unit with the prefix that fits the
greatest value beside it. Where several values are read together, as in a table, all have one unit.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from functools import lru_cache
from typing import NamedTuple

from crankstar.language.alike import in_turn
from crankstar.language.messages import N_, MessageError, _
from crankstar.language.numbers import number, unit_text
from crankstar.language.quoting import seen
from crankstar.language.units import as_weight, measured, spelt
from crankstar.language.written import joined

PREFIXED = {
    "force": ("N", "kN", "MN"),
    "moment": ("N*m", "kN*m", "MN*m"),
    "mass": ("g", "kg", "t"),
    "length": ("mm", "m"),
    "unbalance": ("g*mm", "kg*mm", "kg*m"),
    "moment of inertia": ("kg*m^2",),
    "density": ("g/cm^3",),
    "angle": ("deg",),
    "rotational speed": ("rpm",),
    "pressure": ("bar",),
    "power": ("kW", "MW"),
}
"""The SI units of each dimension, smallest first."""
NAMES = {
    "force": N_("force"),
    "moment": N_("moment"),
    "mass": N_("mass"),
    "length": N_("length"),
    "unbalance": N_("unbalance"),
    "moment of inertia": N_("moment of inertia"),
    "density": N_("density"),
    "angle": N_("angle"),
    "rotational speed": N_("rotational speed"),
    "pressure": N_("pressure"),
    "power": N_("power"),
}
"""The dimensions as readers know them."""
OTHERS = {
    "force": ("kgf", "lbf"),
    "moment": ("kgf*m", "lbf*ft", "lbf*in"),
    "mass": ("lb", "oz"),
    "length": ("cm", "in", "ft"),
    "unbalance": ("g*cm", "oz*in"),
    "moment of inertia": ("kg*cm^2", "lb*in^2"),
    "density": ("kg/m^3", "lb/in^3"),
    "pressure": ("kPa", "MPa", "psi"),
    "power": ("W", "hp", "PS"),
}
"""Units outside PREFIXED that a refusal names; any unit of the dimension is understood."""
Choice = Mapping[str, tuple[str, ...]]
"""The units, smallest first, of each dimension that has chosen ones."""
SYSTEMS: dict[str, Choice] = {
    "si": {},
    "us": {
        "force": ("lbf",),
        "moment": ("lbf*ft",),
        "mass": ("g", "lb"),
        "length": ("in",),
        "unbalance": ("oz*in",),
        "moment of inertia": ("lb*in^2",),
        "density": ("lb/in^3",),
        "pressure": ("psi",),
        "power": ("hp",),
    },
}
"""Sets of units by their short names; what a set leaves out has an SI prefix.

American crankshaft shops weigh pistons and bobweights in grams.
"""
LARGER = 10.0
"""How many of a unit the greatest value must reach for it to be preferred to a smaller one."""
FIXED = ("angle", "rotational speed")
"""Dimensions that have one unit everywhere: sentences and crank angles name it."""
_RELATIVE = ("a", "r")
"""Factors of a unit that stand for a size which the engine file does not give."""

_choice: ContextVar[Choice] = ContextVar("units", default=SYSTEMS["si"])


class UnitsError(MessageError):
    """A choice of units that cannot be met, as one sentence that names those that fit."""


class Shown(NamedTuple):
    """The unit in which values are shown, and the factor from the unit that they have."""

    unit: str
    factor: float


@contextmanager
def shown_in(choice: Choice) -> Iterator[None]:
    """Have results in these units while the context lasts."""
    token = _choice.set(choice)
    try:
        yield
    finally:
        _choice.reset(token)


def show_in(choice: Choice) -> None:
    """Have results in these units from now on, in a process or thread that begins."""
    _choice.set(choice)


def choice() -> Choice:
    """The units chosen in the context."""
    return _choice.get()


def read_choice(text: str) -> Choice:
    """The choice that a text names: a system, units with commas, or both. Raises UnitsError.

    A pound is a unit of mass and of force, and with a length one of moment.

    >>> read_choice("kN, kN m"), read_choice("lb ft")
    ({'force': ('kN',), 'moment': ('kN*m',)}, {'moment': ('lbf*ft',)})
    """
    words = [word.strip() for word in text.split(",") if word.strip()]
    if not words:
        raise UnitsError("no unit is named; {fit}", fit=_fitting())
    systems = [word.lower() for word in words if word.lower() in SYSTEMS]
    if len(systems) > 1:
        raise UnitsError(
            "{first} and {second} exclude each other; name one of them",
            first=systems[0],
            second=systems[1],
        )
    named: dict[str, str] = {}
    for word in words:
        if word.lower() in SYSTEMS:
            continue
        for dimension, unit in _of_word(word):
            if dimension in named:
                raise UnitsError(
                    "{first} and {second} are both units of {dimension}; name one of them",
                    first=unit_text(named[dimension]),
                    second=unit_text(unit),
                    dimension=_(NAMES[dimension]),
                )
            named[dimension] = unit
    if named.get("mass") in ("lb", "lbs", "pound"):
        named = {"force": "lbf", **named}
    chosen = {dimension: (unit,) for dimension, unit in named.items()}
    return {**(SYSTEMS[systems[0]] if systems else {}), **chosen}


def choice_text(choice: Choice) -> str:
    """The text that names a choice: a system, its units with commas, or both.

    >>> choice_text({}), choice_text(SYSTEMS["us"])
    ('si', 'us')
    >>> choice_text(read_choice("kN, kN m")), choice_text(read_choice("us, kN"))
    ('kN, kN m', 'us, kN')
    """
    system = next(
        (name for name in SYSTEMS if name != "si" and SYSTEMS[name].keys() <= choice.keys()), ""
    )
    own = SYSTEMS[system] if system else {}
    units = [unit for name, chosen in choice.items() if chosen != own.get(name) for unit in chosen]
    return ", ".join(filter(None, (system, *map(unit_text, units)))) or "si"


def _of_word(word: str) -> Iterator[tuple[str, str]]:
    """The dimension of a unit and the unit. Raises UnitsError."""
    unit = spelt(word)
    try:
        dimension = _dimension(unit)
    except ValueError:
        raise UnitsError(
            "{unit} is not known as a unit; {fit}", unit=seen(word), fit=_fitting()
        ) from None
    if dimension == "unbalance" and unit.startswith(("lb", "pound", "ft*", "in*")):
        dimension, unit = "moment", as_weight(unit)
    if dimension is None:
        raise UnitsError(
            "{unit} measures nothing that is shown; {fit}", unit=seen(word), fit=_fitting()
        )
    if dimension in FIXED and unit not in PREFIXED[dimension]:
        raise UnitsError(
            "{unit}: the unit of {dimension} is always {fixed}",
            unit=seen(word),
            dimension=_(NAMES[dimension]),
            fixed=PREFIXED[dimension][0],
        )
    yield dimension, unit


def _fitting() -> str:
    """The systems and the units that can be chosen."""
    lists = [
        f"{_(name)}: {', '.join(map(unit_text, (*PREFIXED[key], *OTHERS.get(key, ()))))}"
        for key, name in NAMES.items()
        if key not in FIXED
    ]
    return _(
        "choose from {systems}, or {units}", systems=", ".join(SYSTEMS), units="; ".join(lists)
    )


@lru_cache(maxsize=256)
def _dimension(unit: str) -> str | None:
    """The dimension of a unit, None if results have none of it. Raises ValueError."""
    dimensions = measured(unit).dimensions
    named = ((name, measured(units[0]).dimensions) for name, units in PREFIXED.items())
    return next((name for name, own in named if own == dimensions), None)


@lru_cache(maxsize=256)
def dimension(unit: str) -> tuple[str, str]:
    """The dimension of a Column's unit, and the relative length that it is multiplied with.

    Both are empty where the unit is not converted: m r w^2 and its like, a lone m (the relative
    mass), a unit that nothing else is shown in.

    >>> dimension("N*m"), dimension("N*a"), dimension("m*r*w^2")
    (('moment', ''), ('force', 'a'), ('', ''))
    """
    head, _star, tail = unit.rpartition("*")
    known, relative = (head, tail) if tail in _RELATIVE else (unit, "")
    if known in ("", "m"):
        return "", ""
    try:
        name = _dimension(known)
    except ValueError:
        return "", ""
    return (name, relative) if name else ("", "")


_QUOTIENTS = {
    "N/mm": ("N", "", "mm"),
    "N*s/m": ("N", "*s", "m"),
    "mm/s": ("mm", "/s", ""),
    "m/s^2": ("m", "/s^2", ""),
    "mm/rad": ("mm", "/rad", ""),
    "um": ("um", "", ""),
    "N*m/kW": ("N*m", "", "kW"),
}
"""Units that follow others chosen outside SI: what is above, the rest, what below."""
_PARTS = {"N": "force", "N*m": "moment", "kW": "power"}
"""The dimensions of these parts; all others are lengths."""
FREQUENCY, STRESS = "Hz", "MPa"
"""A frequency is no speed of rotation; a stress is shown as a pressure only where one is chosen."""


def shown(unit: str, largest: float, *, prefixed: bool = True) -> Shown:
    """The unit for values that are counted in `unit`, `largest` being the greatest of them.

    `prefixed`: of several chosen units the one that fits, without any SI with the prefix that fits.
    Else the first of the chosen ones, or SI as it is, so that programs always find the same.

    >>> shown("N", 25_000.0), shown("m*r*w^2", 25_000.0)
    (Shown(unit='kN', factor=0.001), Shown(unit='m*r*w^2', factor=1.0))

    What is counted per another or in a small part of one follows units that are not of SI:

    >>> with shown_in(read_choice("us")):
    ...     shown("N/mm", 200.0).unit, shown("um", 3.0).unit, shown("m/s^2", 1.0).unit
    ...     unit, factor = shown("N*m/kW", 60.0)
    ('lbf/in', 'in', 'in/s^2')
    >>> unit, round(factor * 1000, 3)  # N m of 0.737562 lbf ft, kW of 1.341022 hp
    ('lbf*ft/hp', 550.0)
    """
    if unit in _QUOTIENTS:
        return _quotient(unit)
    name, relative = dimension(unit)
    chosen = choice().get(name, ())
    if unit == FREQUENCY or (unit == STRESS and not chosen):
        return Shown(unit, 1.0)
    if not name or not (chosen or prefixed):
        return Shown(unit, 1.0)
    own = unit.removesuffix(f"*{relative}") if relative else unit
    fitting = _prefixed(own, largest, chosen or PREFIXED[name]) if prefixed else chosen[0]
    wanted = in_turn(("unit", name), fitting)
    end = f"*{relative}" if relative else ""
    same = spelt(wanted) == own
    return Shown(f"{wanted}{end}", 1.0 if same else _ratio(own, wanted))


def _quotient(unit: str) -> Shown:
    """The unit for one of _QUOTIENTS."""
    above, rest, below = _QUOTIENTS[unit]
    above = _foreign(_PARTS.get(above, "length"), above)
    below = _foreign(_PARTS.get(below, "length"), below) if below else ""
    wanted = f"{above}{rest}/{below}" if below else f"{above}{rest}"
    return Shown(wanted, 1.0 if wanted == unit else _ratio(unit, wanted))


def _foreign(name: str, otherwise: str) -> str:
    """The chosen unit of a dimension if it is not of SI."""
    chosen = choice().get(name, ())
    return chosen[0] if chosen and chosen[0] not in PREFIXED[name] else otherwise


def _prefixed(unit: str, largest: float, units: tuple[str, ...]) -> str:
    size = abs(largest) * measured(unit).factor
    fitting = (each for each in units[:0:-1] if size >= LARGER * measured(each).factor * (1 - 1e-9))
    return next(fitting, units[0])


@lru_cache(maxsize=256)
def _ratio(unit: str, wanted: str) -> float:
    return float(f"{measured(unit).factor / measured(wanted).factor:.15g}")


def quantity_text(value: complex, unit: str, *, beside: float = 0.0) -> str:
    """A value, or the size of a complex amplitude, with its unit as it is shown.

    0 where it is negligible to `beside`.

    >>> quantity_text(25_321.0, "N"), quantity_text(5.6569, "m*r*w^2")
    ('25.321 kN', '5.6569 m r ω²')
    """
    said = shown(unit, max(abs(value), abs(beside)))
    words = number(value * said.factor, beside * said.factor)
    return joined(" ", filter(None, [words, unit_text(said.unit)]))
