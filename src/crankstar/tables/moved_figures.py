"""The figure that an assumption moves most, in words: its name, its sizes, and the values tried."""

from __future__ import annotations

from crankstar.analysis.assumptions import (
    COUPLE_OF,
    FIRST_LOAD,
    H_OF,
    LOAD_OF,
    MAIN_OF,
    PIN_OF,
    WALL_OF,
    X_OF,
    Assumption,
    Moved,
)
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number, order_text, unit_text
from crankstar.language.shown_units import shown

FIGURES = {
    "force": N_("force of order {order}"),
    "couple": N_("couple of order {order}"),
    "vertical force": N_("vertical force of order {order}"),
    "horizontal force": N_("horizontal force of order {order}"),
    "vertical couple": N_("moment M_V of order {order}"),
    "horizontal couple": N_("moment M_H of order {order}"),
    "roll": N_("rolling moment of order {order}"),
    "roll with gas": N_("rolling moment with gas of order {order}"),
    "velocity": N_("velocity of order {order}, rms"),
    "vectors": N_("sum of the vector lengths of order {order}"),
    "H moment": N_("H moment of order {order}"),
    "X moment": N_("X moment of order {order}"),
    "end bending": N_("maximum bending moment in the end bearings"),
    "main bending": N_("maximum bending moment in all main bearings"),
    "share of weight": N_("peak force over the weight of the block"),
    "mean torque": N_("mean torque"),
    "brake torque": N_("brake torque"),
    "peak pressure": N_("peak pressure"),
    "torque": N_("torque of order {order}"),
    "irregularity": N_("degree of irregularity"),
    "flywheel": N_("inertia for the degree of irregularity"),
    FIRST_LOAD: N_("greatest load of order {order} on a main bearing"),
    MAIN_OF: N_("maximum load of main bearing {name}"),
    PIN_OF: N_("maximum load of crank pin {name}"),
    WALL_OF: N_("maximum side thrust in cylinder {name}"),
    "cylinder wall": N_("maximum side thrust"),
    "natural frequency": N_("first natural frequency"),
    "torsional amplitude": N_("maximum turn of the free end over the speeds"),
    "resonant amplitude": N_("torsional amplitude at the resonance of order {order}"),
    "torsional stress": N_("maximum torsional stress"),
    "torsional torque": N_("maximum torque between two masses"),
    "mount force": N_("maximum force on the ground"),
    "mount moment": N_("maximum moment on the ground"),
    "one mount": N_("maximum force in a mount"),
    "velocity at the point": N_("maximum velocity of the point"),
    "displacement at the point": N_("maximum displacement of the point"),
    "acceleration at the point": N_("maximum acceleration of the point"),
    "weighted acceleration": N_("maximum weighted acceleration of the point"),
    "transmissibility": N_("maximum transmissibility"),
    "permissible unbalance": N_("permissible residual unbalance"),
    "unbalance left": N_("unbalance left"),
    "least sum of firing orders": N_("least sum of the firing orders"),
    "least bearing load": N_("least load on a main bearing of the firing orders"),
    "least torsional stress": N_("least torsional stress of the firing orders"),
    "least force": N_("maximum force on the ground"),
    "least mounts": N_("maximum force of all mounts"),
    "least velocity": N_("maximum velocity of the point"),
    "least rms force": N_("force on the ground over the speeds, rms"),
    "least rms mounts": N_("force of all mounts over the speeds, rms"),
    "least rms velocity": N_("velocity of the point over the speeds, rms"),
    "least roll": N_("share of other freedoms in the mode of roll"),
    "sag": N_("way by which the block sits down"),
    "roll share": N_("share of roll in its mode"),
    "mount load": N_("maximum load of a mount at rest"),
    LOAD_OF: N_("vertical load of mount {name} at rest"),
    COUPLE_OF: N_("moment of order {order} with {number} cylinders"),
    H_OF: N_("greatest H moment with {number} cylinders"),
    X_OF: N_("greatest X moment with {number} cylinders"),
    "heaviest bobweight": N_("bobweight"),
    **{f"mode {number}": N_("frequency of mode {number}") for number in range(1, 13)},
}
OF_PARTS = (LOAD_OF, COUPLE_OF, H_OF, X_OF, MAIN_OF, PIN_OF, WALL_OF)
"""What is of one part of many: before its name or number."""


def figure_name(own: Moved) -> str:
    """The quantity with its order, or with the part that it is of.

    >>> figure_name(Moved("force", 2.0, "N", 1.0, 1.0, 3.0, 0.5))
    'force of order 2'
    >>> figure_name(Moved("rod angle", None, "deg", 1.0, 1.0, 3.0, 0.5))  # of another package
    'rod angle'
    """
    order = "" if own.order is None else order_text(own.order)
    begun = next((each for each in OF_PARTS if own.quantity.startswith(each)), "")
    known = FIGURES.get(begun or own.quantity)
    if known is None:  # of another package
        named = {"figure": own.quantity, "order": order}
        return _("{figure} of order {order}", **named) if order else own.quantity
    return _(
        known,
        order=order,
        number=own.quantity.rpartition(" ")[2],
        name=own.quantity.removeprefix(begun),
    )


def rounded(value: float) -> float:
    """A value to the three digits with which it is said.

    >>> rounded(1259.4)
    1260.0
    """
    return float(f"{value:.3g}")


def size_text(value: float, unit: str) -> str:
    """A value to three digits, in the unit in which it is shown.

    >>> size_text(12594.0, "N*m").replace("\N{NO-BREAK SPACE}", " ")
    '12.6 kN m'
    """
    said = shown(unit, abs(value))
    words = number(rounded(value * said.factor))
    return f"{words} {unit_text(said.unit)}" if said.unit else words


def span_text(own: Moved) -> str:
    """The values of a figure over the range of an assumption.

    >>> span_text(Moved("force", 2.0, "N", 1.0, 1.0, 3.0, 0.5))
    '1 to 3 N'
    """
    if rounded(own.low) == rounded(own.high):
        return size_text(own.high, own.unit)
    low = size_text(own.low, own.unit)
    top = size_text(own.high, own.unit)
    bare, _space, unit = low.partition(" ")
    if unit == top.partition(" ")[2]:
        low = bare
    return _("{low} to {high}", low=low, high=top)


def value_text(each: Assumption, value: float | str | None) -> str:
    """A value of an assumption with its unit.

    >>> value_text(Assumption("assumed", "gas.imep", "usual", 9.0, "bar"), 9.0)
    '9 bar'
    """
    if not isinstance(value, float):
        return "" if value is None else str(value)
    if each.status == "estimated" and not each.unit:
        return _("{factor} times", factor=number(rounded(value)))
    if each.unit == "% of a gap":
        return _("{share} % of the distance between two", share=number(value))
    if each.path.endswith(("rod_length", "rod_ratio")):
        return f"l/r = {number(rounded(value))}"
    if each.unit == "m" and "mass" in each.path:
        return _("{factor} times m", factor=number(rounded(value)))
    if each.unit == "GPa":  # a modulus, no pressure: in GPa everywhere
        return f"{number(rounded(value))} GPa"
    return size_text(value, each.unit)
