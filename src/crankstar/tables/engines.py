"""An Engine as tables: parts, dead centres, origins of its values; the engines of the catalog."""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterator, Sequence
from math import degrees
from typing import Literal

from crankstar.analysis.document import Column, Document, Remarks, Table, Value, remarks
from crankstar.engine import motion
from crankstar.engine.dead_centres import dead_centres
from crankstar.engine.engine import Engine
from crankstar.engine.main_bearings import main_bearings, webs
from crankstar.engine.records import Block, Shaft
from crankstar.files.catalog import Summary
from crankstar.language.messages import N_, _, _n
from crankstar.language.numbers import number
from crankstar.language.shown_units import quantity_text
from crankstar.tables.assumptions import part_lines
from crankstar.tables.headings import heading, timing_lines
from crankstar.tables.mount_places import mount_places
from crankstar.tables.ranges import estimated_paths
from crankstar.tables.scales import Scale, scales

HIGHEST_HARMONIC = 8


MASSES = {
    "rotating": (N_("rotating mass"), N_("rotating mass, without the rod")),
    "reciprocating": (N_("reciprocating mass"), N_("reciprocating mass, without the rod")),
}
"""The masses that the file gives, and what they are where rods are rigid bodies."""


def description(engine: Engine) -> Document:
    """An engine as its records."""
    return Document(engine.name, (heading(engine), *_parts(engine)), {"engine": engine.name})


def _parts(engine: Engine) -> Iterator[Table | Remarks]:
    yield from remarks(*(_(words) for name, words in RELATIVE.items() if name in engine.relative))
    yield rotors(engine)
    yield supports(engine)
    yield cylinders(engine)
    yield from harmonics(engine)
    if engine.valves is not None:
        yield Remarks(tuple(timing_lines(engine)), _("Valve timing"))
    if engine.block is not None:
        yield Remarks((_block(engine, engine.block),), _("Block"))
    yield from mount_places(engine)
    yield from remarks(
        *part_lines(engine.left_out),
        _("Source: {text}", text=engine.source) if engine.source else "",
        _("Notes: {text}", text=engine.notes) if engine.notes else "",
    )
    if engine.provenance:
        yield origins(engine)


RELATIVE = {
    "mass": N_("The file gives no masses; they are counted in m."),
    "radius": N_("The file gives no sizes; lengths across the crankshaft are counted in r."),
    "pitch": N_("The file gives no bore pitch; lengths along the crankshaft are counted in a."),
}
"""The units of what the file does not give."""

ROUNDING = 1e-9
"""Metres, or bore pitches: no place."""
STATUSES = (N_("published"), N_("computed"), N_("unverified"), N_("placeholder"), N_("estimated"))
"""How far values are to be trusted, as files say it."""


def origins(engine: Engine) -> Table:
    """Where each value of the engine file comes from."""
    columns = tuple(
        Column(words, kind="text", key=key, wraps=key != "status")
        for key, words in (("value", _("value")), ("status", _("status")), ("source", _("source")))
    )
    given = [*engine.provenance.items()]
    rows = tuple((path, _(origin.status), origin.source) for path, origin in given)
    doubtful = frozenset(
        index
        for index, (_path, origin) in enumerate(given)
        if origin.status in ("unverified", "placeholder")
    )
    title = _("Sources of the values")
    return Table(title, columns, rows, key="provenance", doubtful=doubtful)


def rotors(engine: Engine) -> Table:
    """Shafts with their throws and weights, part by part."""
    across, along, mass, unbalance = scales(engine)
    columns = (
        Column(_("shaft"), kind="text", key="shaft", wraps=True, label=True),
        Column(_("part"), kind="text", key="part", label=True),
        Column(_("bearing at θ = 0"), "deg", key="bearing_deg"),
        Column(_("radius"), across.unit, key="radius"),
        Column("z", along.unit, key="z"),
        Column(_of_records(engine, "rotating"), mass.unit, key="rotating_mass"),
        Column(_("unbalance"), unbalance.unit, key="unbalance"),
    )
    rows: list[tuple[Value, ...]] = []
    for shaft in engine.shafts:
        label = _shaft_label(shaft, across)
        for index, throw in enumerate(shaft.throws, 1):
            cells = (label, _("throw {number}", number=index), _bearing(throw.angle))
            product = throw.turning_mass * throw.radius * unbalance.factor
            places = (throw.radius * across.factor, _along(throw.z, along))
            rows.append((*cells, *places, throw.turning_mass, product))
        for index, weight in enumerate(shaft.weights, 1):
            cells = (label, _("weight {number}", number=index), _bearing(weight.angle))
            product = weight.unbalance * unbalance.factor
            rows.append((*cells, None, _along(weight.z, along), None, product))
    return Table(_("Shafts, throws and weights"), columns, tuple(rows), key="rotors")


def supports(engine: Engine) -> Table:
    """Main bearings and webs of the shafts, and which of their places are assumed."""
    along = scales(engine).along
    columns = (
        Column(_("shaft"), kind="text", key="shaft", wraps=True, label=True),
        Column(_("part"), kind="text", key="part", label=True),
        Column(_("number"), key="number"),
        Column("z", along.unit, kind="list", key="z", wraps=True),
        Column(_("place"), kind="text", key="place"),
    )
    rows: list[tuple[Value, ...]] = []
    estimated = "layout.bore_pitch" in estimated_paths(engine)
    assumed = _("assumed, at the estimated bore pitch") if estimated else _("assumed")
    for shaft in engine.shafts:
        for words, places, given in (
            (_("main bearings"), main_bearings(engine, shaft), shaft.bearings),
            (_("webs"), webs(engine, shaft), shaft.webs),
        ):
            place = _("from the file") if given else assumed
            if places:
                zs = tuple(along.of(z) for z in places)
                rows.append((shaft.name, words, len(places), zs, place))
    doubtful = frozenset(index for index, row in enumerate(rows) if row[-1] == assumed)
    title = _("Main bearings and webs")
    return Table(title, columns, tuple(rows), key="supports", doubtful=doubtful)


def _shaft_label(shaft: Shaft, across: Scale) -> str:
    name = shaft.name
    if shaft.speed_ratio != 1:
        name = _("{name} (ratio {ratio})", name=name, ratio=shaft.speed_ratio)
    if not (shaft.up or shaft.right):
        return name
    up, right = across.text(shaft.up), across.text(shaft.right)
    return _("{name}, {up} up, {right} right", name=name, up=up, right=right)


def _of_records(engine: Engine, moves: Literal["rotating", "reciprocating"]) -> str:
    """The heading of the masses in the file; that of a rigid rod is in none of them."""
    rigid = any(cylinder.rod is not None for cylinder in engine.cylinders)
    return _(MASSES[moves][rigid])


def _along(z: float, along: Scale) -> float:
    """A place along the shaft in its unit; nought for what rounding left of the middle."""
    return 0.0 if abs(z) < ROUNDING else z * along.factor


def _bearing(angle: float) -> float:
    return round(degrees(angle), 9) + 0.0


def cylinders(engine: Engine) -> Table:
    """Cylinders with their places, sizes, masses and dead centres."""
    across, along, mass, _unbalance = scales(engine)
    centres = dead_centres(engine)
    ends = any(cylinder.big_end_mass for cylinder in engine.cylinders)
    columns = (
        Column(_("cylinder"), key="number", label=True),
        Column(_("bank"), kind="text", key="bank", wraps=True),
        Column(_("shaft, throw"), kind="text", key="throw", wraps=True),
        Column(_("bearing"), "deg", key="bearing_deg"),
        Column("z", along.unit, key="z"),
        Column(_("offset"), across.unit, key="offset"),
        Column(_("bore"), across.unit, key="bore"),
        Column(_("rod"), across.unit, key="rod_length"),
        Column(_of_records(engine, "reciprocating"), mass.unit, key="reciprocating_mass"),
        *([Column(_("big-end mass"), mass.unit, key="big_end_mass")] if ends else []),
        Column(_("top dead centre"), "deg", key="top_dead_centre_deg"),
    )
    banks = {place: name for name, numbers in engine.banks.items() for place in numbers}
    rows: list[tuple[Value, ...]] = []
    for cylinder in engine.cylinders:
        seat = f"{cylinder.shaft}, {cylinder.throw}"
        if cylinder.articulated:
            seat = _("{seat} (slave of {master})", seat=seat, master=cylinder.articulated.master)
        rows.append(
            (
                cylinder.number,
                banks[cylinder.number],
                seat,
                _bearing(cylinder.bearing),
                _along(cylinder.z, along),
                cylinder.offset * across.factor,
                None if cylinder.bore is None else cylinder.bore * across.factor,
                cylinder.rod_length * across.factor,
                cylinder.reciprocating_mass,
                *([cylinder.big_end_mass] if ends else []),
                round(centres[cylinder.chamber or cylinder.number].angle_deg, 9) + 0.0,
            )
        )
    return Table(_("Cylinders"), columns, tuple(rows), key="cylinders")


def _block(engine: Engine, block: Block) -> str:
    """The whole engine as a rigid body."""
    across, along, mass, _unbalance = scales(engine)
    words = _(
        "The whole engine as a rigid body: mass {mass}, centre of mass {up} up, {right} "
        "right, {place}.",
        mass=_("not given") if block.mass is None else mass.text(block.mass),
        up=across.text(block.up),
        right=across.text(block.right),
        place=_("in the middle") if block.z is None else _("at z = {z}", z=along.text(block.z)),
    )
    if block.inertia is None:
        return words
    unit = f"{mass.unit}*{'m' if across.unit == 'mm' and mass.unit == 'kg' else 'r'}^2"
    yaw, pitch, roll = (quantity_text(size, unit) for size in block.inertia)
    moments = _(
        "Moments of inertia: {yaw} in yaw, {pitch} in pitch, {roll} in roll.",
        yaw=yaw,
        pitch=pitch,
        roll=roll,
    )
    if not any(block.products):
        return f"{words} {moments}"
    across_up, along_up, along_right = (quantity_text(size, unit) for size in block.products)
    products = _(
        "Products of inertia: {up_right} of up and right, {up_z} of up and along, {right_z} of "
        "right and along.",
        up_right=across_up,
        up_z=along_up,
        right_z=along_right,
    )
    return f"{words} {moments} {products}"


def harmonics(engine: Engine) -> tuple[Table, ...]:
    """The harmonics of the first cylinder's piston; none of an articulated rod's."""
    first = engine.first
    radius = engine.throw(first).radius
    if first.articulated is not None:
        return ()
    exact = motion.piston_harmonics(
        crank_radius=radius, rod_length=first.rod_length, offset=first.offset
    )
    ratio = radius / first.rod_length
    series = Column(_("series to λ⁷"), key="series", digits=10)
    other = Column(_("phase"), "deg", key="phase_deg") if first.offset else series
    columns = (Column(_("order"), key="order"), Column("Aₖ", key="harmonic", digits=10), other)
    rows: list[tuple[Value, ...]] = []
    for order in range(1, min(HIGHEST_HARMONIC, exact.size - 1) + 1):
        size = complex(exact[order])
        if size and first.offset:
            rows.append((order, abs(size), round(degrees(phase(size)), 2) + 0.0))
        elif size:
            rows.append((order, size.real, float(motion.series(order, ratio=ratio))))
    title = N_("Piston of cylinder {cylinder}: force m r ω² Σ Aₖ cos kψ, λ = r/l = {ratio}")
    if first.offset:
        title = N_(
            "Piston of cylinder {cylinder}: force m r ω² Σ Aₖ cos(kψ + phase), λ = r/l = {ratio}, "
            "offset {offset} r"
        )
    values = {"ratio": number(ratio), "offset": number(first.offset / radius)}
    title = _(title, cylinder=first.number, **values)
    return (Table(title, columns, tuple(rows), key="harmonics"),)


def catalog(rows: Sequence[Summary]) -> Document:
    """The engines of the catalog: the name for commands, the engine, its layout."""
    columns = (
        Column(_("name"), kind="text", key="name", label=True),
        Column(_("engine"), kind="text", key="title", wraps=True),
        Column(_("layout"), kind="text", key="layout"),
        Column(_("cylinders"), key="cylinders"),
        Column(_("cycle"), kind="text", key="cycle"),
    )
    body = tuple((row.name, row.title, row.layout, row.cylinders, row.cycle) for row in rows)
    note = _n(
        "{count} engine; crankstar analyze NAME analyses it.",
        "{count} engines; crankstar analyze NAME analyses one.",
        len(rows),
        count=len(rows),
    )
    return Document("", (Table("", columns, body, notes=(note,), key="engines"),))
