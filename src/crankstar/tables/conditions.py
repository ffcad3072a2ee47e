"""What the numbers of an analysis are counted in and about: point, speed, units, sizes, doubts."""

from __future__ import annotations

from crankstar.engine.basis import ASSUMED_ROD_RATIO, ROD_SOURCE
from crankstar.engine.engine import Engine
from crankstar.engine.proportions import TWO_MASSES, inferred, look_of
from crankstar.language.messages import N_, _, passage
from crankstar.language.numbers import RPM, number
from crankstar.language.written import joined
from crankstar.mechanics.balance import Balance, unit_mass
from crankstar.mechanics.lacking import KEYS, SIZES, is_explicit, lacking_keys, pitch_key
from crankstar.tables.scales import scales

OF_TORQUE = ("gas", "drive")
"""Keys of what makes torque, and no force."""
UNITS = {
    "short": N_("In m r ω². For newtons, add to the file: {keys}."),
    "short or estimate": N_("In m r ω². For newtons: --estimate, or add {keys}."),
    "speed": N_('In m r ω². For newtons, add speed to the file, as in speed = "6000 rpm".'),
    "explicit": N_("In m r ω². For newtons, replace relative {keys} in the file and add speed."),
    "masses": N_("For newtons, add to the file: {keys}."),
    "explicit masses": N_("For newtons, replace relative {keys} in the file."),
    "pitch": N_("For couples in N m, add to the file: {keys}."),
    "explicit pitch": N_("For couples in N m, give real positions and take pitch out of relative."),
}
"""What to add to a file so that forces are in newtons."""


def conditions(engine: Engine, result: Balance) -> list[str]:
    """Reference point, meaning of a phase, sizes of m, r and a."""
    point = _(
        "Couples and moments about {point}; a ∠ p means a cos(kθ + p).",
        point=_point(engine, result),
    )
    return [point, unit_sizes(engine, result)]


def unit_sentence(engine: Engine, result: Balance) -> str:
    """The speed of the forces; where they are not in newtons, what the file lacks.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.balance import balance
    >>> engine = load("man-s50mc-c")
    >>> unit_sentence(engine, balance(engine)).partition("add to the file: ")[2]
    'cylinder.reciprocating_mass, layout.bore_pitch.'
    """
    if result.speed is not None:
        speed = _("Forces and moments at {speed} rpm.", speed=number(result.speed * RPM))
        return passage((speed, _pitch_sentence(engine)))
    if not {*SIZES} & {*engine.relative}:
        return _(UNITS["speed"])
    if is_explicit(engine):
        sentence = UNITS["explicit"]
        return _(sentence, keys=", ".join(engine.relative))
    keys = lacking_keys(engine, 0.0, sizes=KEYS) + (["speed"] if engine.speed is None else [])
    form = "short or estimate" if can_be_estimated(engine) else "short"
    return _(UNITS[form], keys=", ".join(keys))


def missing_sentence(engine: Engine) -> str:
    """What the file of an engine lacks for newtons, or for newton metres, at a known speed.

    >>> from crankstar.files.catalog import load
    >>> missing_sentence(load("man-s50mc-c"))
    'For newtons, add to the file: cylinder.reciprocating_mass, layout.bore_pitch.'
    """
    if not {*SIZES} & {*engine.relative}:
        return _pitch_sentence(engine)
    if is_explicit(engine):
        sentence = UNITS["explicit masses"]
        return _(sentence, keys=", ".join(engine.relative))
    return _(UNITS["masses"], keys=", ".join(lacking_keys(engine, 0.0, sizes=KEYS)))


def _pitch_sentence(engine: Engine) -> str:
    if "pitch" not in engine.relative:
        return ""
    if is_explicit(engine):
        sentence = UNITS["explicit pitch"]
        return _(sentence)
    return _(UNITS["pitch"], keys=pitch_key(engine))


def can_be_estimated(engine: Engine) -> bool:
    """Whether what an engine lacks for newtons can be estimated: its size and type are known.

    >>> from crankstar.files.catalog import load
    >>> [can_be_estimated(load(name)) for name in ("toyota-2jz", "subaru-ej25", "man-s50mc-c")]
    [True, False, False]
    """
    several = len({cylinder.z for cylinder in engine.cylinders}) > 1
    missing = {"mass", *(("pitch",) if several else ())} & {*engine.relative}
    look = look_of(engine, engine.gas)
    return look is not None and bool(missing) and inferred(look)[0] != "crosshead"


def unverified(engine: Engine) -> list[str]:
    """The key paths of values whose status is unverified or placeholder.

    Those of gas and drive are left out, for forces and couples do not hang on them.
    """
    return [path for path in _unverified(engine) if not path.startswith(OF_TORQUE)]


def unverified_gas(engine: Engine) -> str:
    """The key paths of unverified values of gas and drive as a sentence; empty without any."""
    paths = [path for path in _unverified(engine) if path.startswith(OF_TORQUE)]
    return _("Unverified: {paths}.", paths=", ".join(paths)) if paths else ""


def _unverified(engine: Engine) -> list[str]:
    statuses = ("unverified", "placeholder")
    return [path for path, origin in engine.provenance.items() if origin.status in statuses]


def assumed_sentence(engine: Engine) -> str:
    """Lengths and inertias of rods that are assumed, the file giving none; else empty.

    >>> from crankstar.files import engine_of
    >>> layout = {"type": "inline", "throws": ["0 deg", "180 deg"]}
    >>> assumed_sentence(engine_of({"name": "twin", "layout": layout}))
    'Assumed: rod length (r/l = 0.25).'
    """
    length = inertia = ""
    if _assumed_rods(engine):
        length = _("Assumed: rod length (r/l = {ratio}).", ratio=f"{1 / ASSUMED_ROD_RATIO:g}")
    if any(cylinder.rod and cylinder.rod.inertia is None for cylinder in engine.cylinders):
        inertia = _(
            "Assumed: inertia of the rod, as two masses at its ends; rods have {low} to {high} "
            "times as much.",
            low=f"{1 / TWO_MASSES[2]:.2g}",
            high=f"{1 / TWO_MASSES[0]:.3g}",
        )
    return passage(each for each in (length, inertia) if each)


def _assumed_rods(engine: Engine) -> list[str]:
    """The key paths of rod lengths that the program has assumed."""
    return [
        path
        for path, origin in engine.provenance.items()
        if origin.status == "placeholder" and origin.source.endswith(ROD_SOURCE)
    ]


def unverified_sentence(engine: Engine) -> str:
    """The key paths of unverified values, without what is assumed; empty where there are none."""
    assumed = _assumed_rods(engine)
    paths = [path for path in unverified(engine) if path not in assumed]
    return _("Unverified: {paths}.", paths=", ".join(paths)) if paths else ""


def _point(engine: Engine, result: Balance) -> str:
    """The reference point: its z, and its place in the clock plane where that matters."""
    point = result.reference
    across, along = scales(engine)[:2]
    place = joined("", ["z = ", along.text(point.z)])
    if point.up or point.right:
        return _(
            "{place}, {up} up, {right} right of the crank axis",
            place=place,
            up=across.text(point.up),
            right=across.text(point.right),
        )
    if len({cylinder.shaft for cylinder in engine.cylinders}) > 1:
        return _("{place} on the axis of shaft {name}", place=place, name=engine.shafts[0].name)
    return place


def unit_sizes(engine: Engine, result: Balance) -> str:
    """The sizes of m, r and a, as far as they are known.

    Where all cylinders are at one place a is no bore pitch, and told only if it is a unit.
    """
    first = engine.first
    across, along, mass, _unbalance = scales(engine)
    several = len({cylinder.z for cylinder in engine.cylinders}) > 1
    sizes = {
        "m": ("mass", mass.text(unit_mass(engine))),
        "r": ("radius", across.text(engine.throw(first).radius)),
        "a": ("pitch" if several else "mass", along.text(engine.pitch)),
    }
    if not several and not result.units.couple.endswith("*a"):
        del sizes["a"]
    known = [
        joined(" = ", [letter, size])
        for letter, (key, size) in sizes.items()
        if key not in engine.relative
    ]
    return _("{text}.", text=joined(", ", known)) if known else ""
