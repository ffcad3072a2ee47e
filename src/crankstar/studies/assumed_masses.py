"""What is missing, assumed or estimated of the masses and lengths that inertia forces come from."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

import numpy as np

from crankstar.analysis.assumptions import Assumption
from crankstar.analysis.changed_masses import by_factor, with_part, with_turning_masses
from crankstar.engine.cylinder_parts import ENDS
from crankstar.engine.engine import Engine
from crankstar.engine.proportions import (
    Look,
    Proportion,
    dressed,
    inferred,
    look_of,
    pins_of_cylinder,
    proportion,
)
from crankstar.engine.records import Cylinder
from crankstar.engine.weighed import EngineType
from crankstar.language.messages import N_
from crankstar.remedy.fitting import quiet_cranks
from crankstar.studies.assumed_rods import rods

CROSSHEAD = ((0.3, 0.65, 1.0), (0.3, 0.75, 1.2))
"""Big end of the rod, and crank throw, of an engine with crossheads in its reciprocating mass.

No masses of such parts are published engine by engine: our judgement, and so is said.
"""

ENDS_KEY, PINS_KEY = "cylinder.rotating_mass", "cylinder.throw_mass"
"""The two keys of what turns at a crankpin: what hangs on it, and the crank's own."""
OF_PISTON = {"pin": (0.2, 0.4), "rings": (0.06, 0.12)}
"""Piston pin and rings over the bare piston.

Together with the locks they are 0.38 to 0.45 of it in the engines of which both were weighed
(`dressed`). How much of that is which is our judgement.
"""
SHELLS = (0.0, 0.12)
"""Bearing shells over the big end of a rod: none of rolling bearings. Our judgement."""
PARTS = {
    "piston": N_("no piston in the file, counted as zero; the range is usual for its bore"),
    "pin": N_(
        "no piston pin in the file, counted as zero; the range is a judgement by the mass of the "
        "piston"
    ),
    "rings": N_(
        "no piston rings in the file, counted as zero; the range is a judgement by the mass of the "
        "piston"
    ),
    "small_end": N_(
        "no small end of the rod in the file, counted as zero; the range is usual for its big end "
        "or its piston"
    ),
    "big_end": N_(
        "no big end of the rod in the file, counted as zero; the range is usual for its small end"
    ),
    "bearing_shells": N_(
        "no bearing shells beside the big end in the file, counted as zero; the range is a "
        "judgement by the mass of the big end"
    ),
}
"""Parts that engines have, where a file weighs others; locks and oil are hardly anything."""


def _usual(part: str, kind: EngineType) -> Proportion | None:
    """A coefficient of a type, None where there is none."""
    try:
        return proportion(part, kind)
    except KeyError:
        return None


def masses(
    engine: Engine, *, fitted: bool = False, given: Collection[str] = ()
) -> Iterator[Assumption]:
    """What is missing or assumed of the masses and lengths that forces come from.

    Weights that were `fitted` to the engine as it is balance no crankpins that it lacks. What is
    `given`, as the crank's own mass beside a bobweight or a value that is swept, is not missing,
    and says nothing about what else turns.
    """
    look = look_of(engine, engine.gas)
    kind = None if look is None else inferred(look)[0]
    yield from rods(engine, kind)
    yield from _unweighed(engine, kind)
    yield from _turning(engine, kind, look, fitted=fitted, given=given)
    if not any(shaft.weights for shaft in engine.shafts if shaft.throws):
        yield _weights(engine)


def _unweighed(engine: Engine, kind: EngineType | None) -> Iterator[Assumption]:
    """The parts that every engine has and that a file which weighs the others leaves out."""
    unit = "m" if "mass" in engine.relative else "kg"
    for name, reason in PARTS.items():
        own = [each for each in engine.cylinders if _lacks(each, name)]
        if not own:
            continue
        ends = _usual_part(own[0], name, None if unit == "m" else kind or "petrol")
        yield Assumption(
            "missing", f"cylinder.parts.{name}", reason, 0.0, unit, *(ends or (None, None)),
            vary=ends and with_part(name, {each.number for each in own}),
        )  # fmt: skip


def _lacks(cylinder: Cylinder, name: str) -> bool:
    """Whether a part counts as zero beside others that move as it does.

    A rigid rod has its ends itself; where nothing turns, the record is on the rotating mass.
    """
    parts = cylinder.parts
    if parts is None or getattr(parts, name):
        return False
    if name == "bearing_shells":
        return bool(parts.big_end)
    if name in ENDS and cylinder.rod is not None:
        return False
    return bool(parts.rotating if name == "big_end" else parts.reciprocating)


def _usual_part(
    cylinder: Cylinder, name: str, kind: EngineType | None
) -> tuple[float, float] | None:
    """The least and the greatest usual mass of a part beside the others, None where not known.

    In kg, or in the unit of those others: a share c of a rod is its small end, s = b c / (1 - c).
    """
    parts = cylinder.parts
    assert parts is not None  # noqa: S101  # it lacks one of them
    if name == "bearing_shells":
        return SHELLS[0] * parts.big_end, SHELLS[1] * parts.big_end
    if name in OF_PISTON:
        low, high = OF_PISTON[name]
        return (low * parts.piston, high * parts.piston) if parts.piston else None
    if name == "piston":
        usual = None if kind is None else _usual("piston group", kind)
        if usual is None or cylinder.bore is None:
            return None
        scale = cylinder.bore**3 / dressed()
        return usual.low * scale, usual.high * scale
    share = proportion("small end", "petrol")
    ends = share.low / (1 - share.low), share.high / (1 - share.high)
    if name == "big_end":
        return (parts.small_end / ends[1], parts.small_end / ends[0]) if parts.small_end else None
    if parts.big_end:
        return ends[0] * parts.big_end, ends[1] * parts.big_end
    rod = proportion("rod over piston group", "petrol")
    group = dressed() * parts.piston
    return (share.low * rod.low * group, share.high * rod.high * group) if group else None


def _weights(engine: Engine) -> Assumption:
    """The counterweights that a file leaves out: usual ones remove what turns with its cranks."""
    usual, factor = quiet_cranks(engine)

    def vary(each: Engine, _share: float) -> Engine:
        return usual if each is engine else quiet_cranks(each)[0]

    return Assumption(
        "missing", "crankshaft.weight", N_("no counterweights in the file"), 0.0, "",
        1.0, 1.0, values=(("factor", factor),), vary=vary,
    )  # fmt: skip


def _turning(
    engine: Engine,
    kind: EngineType | None,
    look: Look | None,
    *,
    fitted: bool,
    given: Collection[str],
) -> Iterator[Assumption]:
    """The big ends and the crankpins that a file leaves out, of one cylinder.

    On the crankpin m = (1 - c) m_rod, of the crank's own m_pin: the coefficients of the type times
    bore^3; where the file gives no masses or no bore, by its reciprocating mass, over
    m_piston + c m_rod. Each of the two is missing where the file does not give it, whether or not
    it gives the other. Counterweights stay as the file gives them, and balance a crankpin only as
    far as its mass is in the file; those of a `balance_factor` go along, so that no force rests on
    it.
    """
    throws = [throw for shaft in engine.shafts for throw in shaft.throws]
    rigid = any(cylinder.rod is not None for cylinder in engine.cylinders)
    weighted = any(shaft.weights for shaft in engine.shafts if shaft.throws)
    no_ends = not rigid and not any(throw.rotating_mass for throw in throws)
    no_ends = no_ends and ENDS_KEY not in given
    no_pins = PINS_KEY not in given and not any(throw.throw_mass for throw in throws)
    if not no_ends and not no_pins:
        return
    unit = "m" if "mass" in engine.relative else "kg"
    path = ENDS_KEY if no_ends else PINS_KEY
    weights = "fitted" if fitted else "of the file" if weighted else ""
    reason = _turning_reason(engine, kind, ends=no_ends, pins=no_pins, weights=weights)
    ends, pins = _usual_turning(engine, kind, look)
    if not no_ends:
        yield Assumption(
            "missing", path, reason, 0.0, unit, pins[0], pins[-1],
            vary=lambda each, mass: with_turning_masses(each, None, mass),
        )  # fmt: skip
        return

    def vary(each: Engine, mass: float) -> Engine:
        pin = float(np.interp(mass, ends[:: len(ends) - 1], pins[:: len(pins) - 1]))
        return with_turning_masses(each, mass, pin)

    found = Assumption(
        "missing", path, reason, 0.0, unit, ends[0], ends[-1],
        vary=lambda each, mass: with_turning_masses(each, mass, None),
    )  # fmt: skip
    if not no_pins:
        yield found
        return
    bare = _turning_reason(engine, kind, ends=True, pins=False, weights=weights)
    along = (("pins", (pins[0], pins[-1])),)
    yield replace(found, values=along, vary=vary, alone=replace(found, reason=bare))


def _usual_turning(
    engine: Engine, kind: EngineType | None, look: Look | None
) -> tuple[Sequence[float], Sequence[float]]:
    """The big ends and the crankpins of a cylinder as engines of a type have them, ascending.

    Cylinders that share a crankpin share its mass. In kg, or in the unit of masses of an engine
    that has none.
    """
    first, share = engine.first, pins_of_cylinder(engine)
    if kind == "crosshead":
        ends, pins = ([part * first.reciprocating for part in own] for own in CROSSHEAD)
        return ends, [share * own for own in pins]
    names = ("rod", "small end", "crank pin", "piston group")
    rod, small, pin, piston = (proportion(name, kind or "petrol") for name in names)
    if "mass" in engine.relative or look is None or first.bore is None:
        scale = first.reciprocating / (piston.typical + small.typical * rod.typical)
    else:
        scale = first.bore**3
    ends = [
        (1 - part) * own * scale for part, own in zip(reversed(small.sizes), rod.sizes, strict=True)
    ]
    return ends, [share * own * scale for own in pin.sizes]


def _turning_reason(
    engine: Engine, kind: EngineType | None, *, ends: bool, pins: bool, weights: str
) -> str:
    """What is said of big ends and crankpins that are missing, beside `weights` of which kind."""
    if not ends and weights == "fitted":
        return N_(
            "no mass of the crankpins in the file: the new counterweights balance none of it, but "
            "do where the file gives it"
        )
    if not ends and weights and not by_factor(engine):
        return N_(
            "no mass of the crankpins in the file, counted as zero: right only if their unbalance "
            "is taken off that of the counterweights"
        )
    if kind == "crosshead" and not ends:
        return N_(
            "no mass of the crankpins in the file, counted as zero; the range is a judgement by "
            "the reciprocating mass"
        )
    if kind == "crosshead" and pins and not by_factor(engine):
        return N_(
            "no rotating mass in the file (big ends, crankpins), counted as zero; the range is a "
            "judgement by the reciprocating mass"
        )
    if not ends:
        return N_("no mass of the crankpins in the file, counted as zero")
    if by_factor(engine):
        return N_("no rotating mass in the file: balance_factor balances the pistons alone")
    if not pins:
        return N_("no rotating mass in the file (big ends), counted as zero")
    if weights:
        return N_(
            "no rotating mass in the file (big ends, crankpins), counted as zero beside its "
            "counterweights"
        )
    return N_("no rotating mass in the file (big ends, crankpins), counted as zero")
