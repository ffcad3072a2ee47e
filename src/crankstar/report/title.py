"""The data of the engine, unverified values marked, and the verdict."""

from __future__ import annotations

from collections.abc import Iterable
from math import degrees, pi
from typing import NamedTuple

from crankstar.analyses.verdict.document import verdict_rows
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _
from crankstar.language.numbers import RPM, number
from crankstar.remedy import loads
from crankstar.report.markup import section
from crankstar.report.subject import Subject
from crankstar.tables.conditions import unverified
from crankstar.tables.headings import cycle_text, firing_text, rotation_text
from crankstar.tables.html import paragraph, text, typeset

DOUBTFUL = {
    "placeholder": N_("placeholder"),
    "unverified": N_("unverified"),
    "estimated": N_("estimated"),
}
"""The states of values that are marked, the worst first."""
BESIDES = ("firing", "relatives")
"""The topics of the verdict that the front page does not have."""
LONG = 40
"""Letters from which a value has a line of its own."""
MOST_TRUSTED = 3
"""Lines of what the numbers rest on, of the most effect, on the front page; here are the others."""


class Datum(NamedTuple):
    """A line of the engine's data; `keys` are the names of the value in engine files."""

    label: str
    value: str
    keys: tuple[str, ...] = ()


def data_section(subject: Subject) -> str:
    """The data sheet of the engine."""
    engine = subject.engine
    rows = "".join(_row(engine, datum) for datum in data(subject) if datum.value)
    body = f'<dl class="data">{rows}</dl>{_doubt(subject)}'
    return section(_("Data of the engine"), body, name="data")


def _row(engine: Engine, datum: Datum) -> str:
    state = status(engine, datum.keys)
    mark = f' <span class="doubt">{text(_(DOUBTFUL[state]))}</span>' if state else ""
    long = ' class="long"' if len(datum.value) > LONG else ""
    return f"<div{long}><dt>{text(datum.label)}</dt><dd>{typeset(datum.value)}{mark}</dd></div>"


def status(engine: Engine, keys: Iterable[str]) -> str:
    """The worst state of the values with these names: placeholder, unverified, estimated, or ""."""
    named = {
        origin.status
        for path, origin in engine.provenance.items()
        if path.split(".")[-1].split("[")[0] in keys
    }
    return next((state for state in DOUBTFUL if state in named), "")


def _doubt(subject: Subject) -> str:
    lines = [paragraph(line, "doubt") for line in subject.rests_on[MOST_TRUSTED:]]
    source = _(
        "Unverified values and placeholders have no published source; see the section Sources."
    )
    if unverified(subject.engine):
        lines.append(paragraph(source, "note"))
    return "".join(lines)


def data(subject: Subject) -> list[Datum]:
    """The data sheet of an engine, without unknown lengths and masses, with ranges of estimates."""
    own = _data(subject)
    values = subject.lines(lambda each: [datum.value for datum in _data(each)])
    return [
        datum._replace(value=value, keys=datum.keys if value == datum.value else ())
        for datum, value in zip(own, values, strict=True)
    ]


def _data(subject: Subject) -> list[Datum]:
    engine = subject.engine
    count, pistons = len(engine.chambers), len(engine.cylinders)
    cylinders = str(count)
    if pistons != count:
        cylinders = _("{cylinders}, {pistons} pistons", cylinders=count, pistons=pistons)
    fires = _("not in the engine file")
    if engine.firing_order:
        fires = firing_text(engine)
    bearings = _span(degrees(cylinder.bearing) for cylinder in engine.cylinders)
    out = [
        Datum(_("Cylinders"), cylinders),
        Datum(_("Cycle"), cycle_text(engine)),
        Datum(_("Rotation"), rotation_text(engine)),
        Datum(_("Firing order"), fires, ("firing_order", "firing_angles")),
        Datum(_("Cylinder bearings"), f"{bearings} deg", ("bearing", "bank_angle")),
        *_lengths(engine),
        *_masses(engine),
    ]
    if subject.at is None:
        return [*out, Datum(_("Unit of force, at any speed"), "m r ω²")]
    own = engine.speed is not None and abs(subject.at - engine.speed) < 1e-9 * engine.speed
    speed = f"{number(subject.at * RPM)} rpm"
    return [*out, Datum(_("Speed for the forces"), speed, ("speed",) if own else ())]


def _lengths(engine: Engine) -> list[Datum]:
    throws = [engine.throw(cylinder) for cylinder in engine.cylinders]
    pairs = list(zip(engine.cylinders, throws, strict=True))
    ratio = _span(throw.radius / cylinder.rod_length for cylinder, throw in pairs)
    of_length, of_ratio = _rod_keys(engine)
    rods = Datum(_("Crank radius over rod length, λ"), ratio, of_ratio)
    if "radius" in engine.relative:
        return [rods]
    bores = [cylinder.bore for cylinder in engine.cylinders if cylinder.bore is not None]
    known = len(bores) == len(engine.cylinders)
    swept = sum(pi / 4 * (cylinder.bore or 0) ** 2 * 2 * throw.radius for cylinder, throw in pairs)
    several = (
        len({cylinder.z for cylinder in engine.cylinders}) > 1 and "pitch" not in engine.relative
    )
    bore = f"{_span(1000 * bore for bore in bores)} mm" if known else ""
    stroke = f"{_span(2000 * throw.radius for throw in throws)} mm"
    volume = f"{number(swept * 1e6)} cm³" if known else ""
    rod = f"{_span(1000 * cylinder.rod_length for cylinder in engine.cylinders)} mm"
    pitch = f"{number(1000 * engine.pitch)} mm" if several else ""
    return [
        Datum(_("Bore"), bore, ("bore",)),
        Datum(_("Stroke (twice the crank radius)"), stroke, ("stroke", "radius")),
        Datum(_("Swept volume"), volume, ("bore", "stroke", "radius")),
        Datum(_("Rod length between centres"), rod, of_length),
        rods,
        Datum(_("Bore pitch"), pitch, ("bore_pitch",)),
    ]


def _rod_keys(engine: Engine) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """The keys on which the length of rods rests, and their ratio: one is given, one derived.

    Where the provenance names neither, or both, each rests on all.
    """
    names = {path.split(".")[-1].split("[")[0] for path in engine.provenance}
    radius = ("radius", "stroke")
    match "rod_length" in names, "rod_ratio" in names:
        case True, False:
            return ("rod_length",), ("rod_length", *radius)
        case False, True:
            return ("rod_ratio", *radius), ("rod_ratio",)
    every = ("rod_length", "rod_ratio", *radius)
    return every, every


def _masses(engine: Engine) -> list[Datum]:
    """What goes up and down and what turns, as `balance` counts them, and what they are made of."""
    if "mass" in engine.relative:
        return []
    pins = loads(engine)
    hung = [pin.rotating for pin in pins]
    own = [pin.own for pin in pins]
    rods = [cylinder.rod.mass for cylinder in engine.cylinders if cylinder.rod is not None]
    of_rods = ("rod", "mass", "centre") if rods else ()
    pistons = (cylinder.reciprocating_mass for cylinder in engine.cylinders)
    return [
        Datum(
            _("Reciprocating mass per cylinder"),
            f"{_span(cylinder.reciprocating for cylinder in engine.cylinders)} kg",
            ("reciprocating_mass", *of_rods),
        ),
        Datum(
            _("Piston group, without the rod"),
            f"{_span(pistons)} kg" if rods else "",
            ("reciprocating_mass",),
        ),
        Datum(
            _("Rotating mass per throw"),
            f"{_span(hung)} kg" if any(hung) else _("not in the engine file"),
            ("rotating_mass", *of_rods),
        ),
        Datum(
            _("Crank pin and webs, at crank radius"),
            f"{_span(own)} kg" if any(own) else "",
            ("throw_mass",),
        ),
        Datum(_("Mass of a rod"), f"{_span(rods)} kg" if rods else "", ("rod", "mass")),
    ]


def _span(values: Iterable[float]) -> str:
    """One value for all, several with commas, or the least and the greatest of many.

    >>> _span([45, -45, 45]), _span([86.0, 86.0]), _span(range(5))
    ('-45, 45', '86', '0 to 4')
    """
    distinct = sorted({round(value, 9) for value in values})
    if len(distinct) > 4:
        return _("{least} to {greatest}", least=number(distinct[0]), greatest=number(distinct[-1]))
    return ", ".join(number(value) for value in distinct)


def verdict_section(subject: Subject) -> str:
    """What the verdict says besides the front page, each sentence beside its topic."""
    facts = subject.facts
    rows = "".join(
        f"<div><dt>{text(about)}</dt><dd>{typeset(sentence)}</dd></div>"
        for about, sentence in verdict_rows([fact for fact in facts if fact.about in BESIDES])
    )
    body = f'<dl class="facts">{rows}</dl>' if rows else ""
    return section(_("Firing, and engines like it"), body, name="verdict")
