"""The first page of a report: the engine, its data with what nobody vouches for marked, and the verdict."""

from __future__ import annotations

from collections.abc import Iterable
from math import degrees, pi
from typing import NamedTuple

from crankstar.engine import Engine
from crankstar.firing import firing
from crankstar.report.markup import paragraph, section, text, typeset
from crankstar.report.matter import Matter
from crankstar.verdict import verdict
from crankstar.wording import firing_sentence, number

UNSURE = ("placeholder", "unverified")
"""The states of a value that are marked, the worse first."""
LONG = 40
"""Letters of a value that takes a line of its own."""


class Datum(NamedTuple):
    """A line of the engine's data; `keys` are the names under which an engine file gives the value."""

    label: str
    value: str
    keys: tuple[str, ...] = ()


def title(matter: Matter) -> str:
    """The head of the report, with the data of the engine."""
    engine = matter.engine
    beside = f"<p>beside {text(matter.beside.name)}</p>" if matter.beside is not None else ""
    rows = "".join(_row(engine, one) for one in data(matter) if one.value)
    return (
        f'<header><p class="kind">Inertia forces of a piston engine</p><h1>{text(engine.name)}</h1>{beside}</header>'
        f'<section id="data"><h2 class="hidden">Data of the engine</h2><dl class="data">{rows}</dl>{_unsure(engine)}</section>'
    )


def _row(engine: Engine, one: Datum) -> str:
    state = status(engine, one.keys)
    mark = f' <span class="doubt">{state}</span>' if state else ""
    long = ' class="long"' if len(one.value) > LONG else ""
    return f"<div{long}><dt>{text(one.label)}</dt><dd>{typeset(one.value)}{mark}</dd></div>"


def status(engine: Engine, keys: Iterable[str]) -> str:
    """The worst state among the values with these names: placeholder, unverified, or nothing to be said."""
    named = {origin.status for path, origin in engine.provenance.items() if path.split(".")[-1].split("[")[0] in keys}
    return next((state for state in UNSURE if state in named), "")


def _unsure(engine: Engine) -> str:
    if not any(origin.status in UNSURE for origin in engine.provenance.values()):
        return ""
    return paragraph("Values marked unverified or placeholder are not from a source; the last pages tell of each.", "note")


def data(matter: Matter) -> list[Datum]:
    """What a data sheet gives of an engine; lengths and masses that are not known are left out."""
    engine = matter.engine
    count = len(engine.chambers)
    pistons = f", {len(engine.cylinders)} pistons" if len(engine.cylinders) != count else ""
    fires = firing_sentence(firing(engine)).removeprefix("fires ") if engine.firing_order else "no firing order given"
    out = [
        Datum("Cylinders", f"{count}{pistons}"),
        Datum("Cycle", f"{engine.cycle}, {engine.rotation} from the front"),
        Datum("Firing order", fires, ("firing_order", "firing_angles")),
        Datum("Cylinder bearings", f"{_span(degrees(one.bearing) for one in engine.cylinders)} deg", ("bearing", "bank_angle")),
        *_lengths(engine),
        *_masses(engine),
    ]
    if matter.at is not None:
        own = engine.speed is not None and abs(matter.at - engine.speed) < 1e-9 * engine.speed
        out.append(Datum("Speed for the forces", f"{number(matter.at * 30 / pi)} rpm", ("speed",) if own else ()))
    else:
        out.append(Datum("Unit of force, at any speed", "m r ω²"))
    return out


def _lengths(engine: Engine) -> list[Datum]:
    throws = [engine.throw(cylinder) for cylinder in engine.cylinders]
    pairs = list(zip(engine.cylinders, throws, strict=True))
    ratio = _span(throw.radius / cylinder.rod_length for cylinder, throw in pairs)
    rods = Datum("Crank radius over rod length, λ", ratio, ("rod_length", "rod_ratio", "radius", "stroke"))
    if "radius" in engine.relative:
        return [rods]
    bores = [cylinder.bore for cylinder in engine.cylinders if cylinder.bore is not None]
    known = len(bores) == len(engine.cylinders)
    swept = sum(pi / 4 * (cylinder.bore or 0) ** 2 * 2 * throw.radius for cylinder, throw in pairs)
    several = len({cylinder.z for cylinder in engine.cylinders}) > 1 and "pitch" not in engine.relative
    return [
        Datum("Bore", f"{_span(1000 * bore for bore in bores)} mm" if known else "", ("bore",)),
        Datum("Stroke (twice the crank radius)", f"{_span(2000 * throw.radius for throw in throws)} mm", ("stroke", "radius")),
        Datum("Swept volume", f"{number(swept * 1e6)} cm³" if known else "", ("bore", "stroke", "radius")),
        Datum("Rod between centres", f"{_span(1000 * one.rod_length for one in engine.cylinders)} mm", ("rod_length", "rod_ratio")),
        rods,
        Datum("Bore pitch", f"{number(1000 * engine.pitch)} mm" if several else "", ("bore_pitch",)),
    ]


def _masses(engine: Engine) -> list[Datum]:
    if "mass" in engine.relative:
        return []
    reciprocating = [cylinder.reciprocating_mass for cylinder in engine.cylinders]
    rotating = [throw.rotating_mass for shaft in engine.shafts for throw in shaft.throws]
    rods = [cylinder.rod.mass for cylinder in engine.cylinders if cylinder.rod is not None]
    return [
        Datum("Reciprocating mass of a cylinder", f"{_span(reciprocating)} kg", ("reciprocating_mass",)),
        Datum("Rotating mass of a throw", f"{_span(rotating)} kg" if any(rotating) else "none given", ("rotating_mass",)),
        Datum("Mass of a rod", f"{_span(rods)} kg" if rods else "", ("rod", "mass")),
    ]


def _span(values: Iterable[float]) -> str:
    """One value for all, several with commas, or the least and the greatest of many.

    >>> _span([45, -45, 45]), _span([86.0, 86.0]), _span(range(5))
    ('-45, 45', '86', '0 to 4')
    """
    found = sorted({round(value, 9) for value in values})
    if len(found) > 4:
        return f"{number(found[0])} to {number(found[-1])}"
    return ", ".join(number(value) for value in found)


def in_short(matter: Matter) -> str:
    """The verdict: the facts by what they are about."""
    out: list[str] = []
    before = ""
    for fact in verdict(matter.engine):
        about = fact.about if fact.about != before else ""
        out.append(f"<div><dt>{text(about)}</dt><dd>{typeset(fact.sentence)}</dd></div>")
        before = fact.about
    return section("Verdict", f'<dl class="facts">{"".join(out)}</dl>', name="verdict")
