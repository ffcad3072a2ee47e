"""An Engine as tables: parts, dead centres, origins of its values; the engines of the catalog."""

from __future__ import annotations

from cmath import phase
from collections.abc import Iterator, Sequence
from math import degrees

from crankstar.engine import motion
from crankstar.engine.dead_centres import dead_centres
from crankstar.engine.engine import Engine
from crankstar.engine.records import Block, Shaft
from crankstar.files.catalog import Summary
from crankstar.language.messages import _, _n
from crankstar.language.numbers import number
from crankstar.tables.headings import heading, timing_lines
from crankstar.tables.table import Column, Document, Remarks, Table, Value, remarks

HIGHEST_HARMONIC = 8


def description(engine: Engine) -> Document:
    """An engine as its records."""
    return Document(engine.name, (heading(engine), *_parts(engine)), {"engine": engine.name})


def _parts(engine: Engine) -> Iterator[Table | Remarks]:
    yield from remarks(*_relative(engine))
    yield rotors(engine)
    yield cylinders(engine)
    yield from harmonics(engine)
    if engine.valves is not None:
        yield Remarks(tuple(timing_lines(engine)), _("Valve timing"))
    if engine.block is not None:
        yield Remarks((_block(engine, engine.block),), _("Block"))
    yield from remarks(
        _("Source: {text}", text=engine.source) if engine.source else "",
        _("Notes: {text}", text=engine.notes) if engine.notes else "",
    )
    if engine.provenance:
        yield origins(engine)


def _relative(engine: Engine) -> list[str]:
    """The units of what the file does not give."""
    return [
        sentence
        for name, sentence in (
            ("mass", _("The file gives no masses; they are counted in m.")),
            (
                "radius",
                _("The file gives no sizes; lengths across the crankshaft are counted in r."),
            ),
            (
                "pitch",
                _("The file gives no bore pitch; lengths along the crankshaft are counted in a."),
            ),
        )
        if name in engine.relative
    ]


def origins(engine: Engine) -> Table:
    """Where each value of the engine file comes from."""
    columns = tuple(
        Column(words, kind="text", key=key, wraps=key != "status")
        for key, words in (("value", _("value")), ("status", _("status")), ("source", _("source")))
    )
    rows = tuple((path, origin.status, origin.source) for path, origin in engine.provenance.items())
    doubtful = frozenset(
        place for place, row in enumerate(rows) if row[1] in ("unverified", "placeholder")
    )
    title = _("Sources of the values")
    return Table(title, columns, rows, key="provenance", doubtful=doubtful)


def rotors(engine: Engine) -> Table:
    """Shafts with their throws and weights, part by part."""
    across, along, mass = _lengths(engine)
    radius = engine.throw(engine.first).radius
    counted = 1 / radius if mass[1] == "m" else 1.0  # m m would be masses times metres
    lever = "m" if across[1] == "mm" and mass[1] == "kg" else "r"
    columns = (
        Column(_("shaft"), kind="text", key="shaft", wraps=True, label=True),
        Column(_("part"), kind="text", key="part", label=True),
        Column(_("bearing at θ = 0"), "deg", key="bearing_deg"),
        Column(_("radius"), across[1], key="radius"),
        Column("z", along[1], key="z"),
        Column(_("rotating mass"), mass[1], key="rotating_mass"),
        Column(_("unbalance"), f"{mass[1]}*{lever}", key="unbalance"),
    )
    rows: list[tuple[Value, ...]] = []
    for shaft in engine.shafts:
        label = _shaft_label(shaft, across)
        for place, throw in enumerate(shaft.throws, 1):
            rows.append(
                (
                    label,
                    _("throw {number}", number=place),
                    _bearing(throw.angle),
                    throw.radius * across[0],
                    throw.z * along[0],
                    throw.rotating_mass * mass[0],
                    throw.rotating_mass * throw.radius * counted,
                )
            )
        for place, weight in enumerate(shaft.weights, 1):
            name, angle = _("weight {number}", number=place), _bearing(weight.angle)
            z, unbalance = weight.z * along[0], weight.unbalance * counted
            rows.append((label, name, angle, None, z, None, unbalance))
    return Table(_("Shafts, throws and weights"), columns, tuple(rows), key="rotors")


def _shaft_label(shaft: Shaft, across: tuple[float, str]) -> str:
    values = {
        "name": shaft.name,
        "ratio": shaft.speed_ratio,
        "up": number(shaft.up * across[0]),
        "right": number(shaft.right * across[0]),
        "unit": across[1],
    }
    if shaft.up or shaft.right:
        return _("{name} (ratio {ratio}), {up} {unit} up, {right} {unit} right", **values)
    return shaft.name if shaft.speed_ratio == 1 else _("{name} (ratio {ratio})", **values)


def _bearing(angle: float) -> float:
    return round(degrees(angle), 9) + 0.0


def cylinders(engine: Engine) -> Table:
    """Cylinders with their places, sizes, masses and dead centres."""
    across, along, mass = _lengths(engine)
    centres = dead_centres(engine)
    columns = (
        Column(_("cylinder"), key="number", label=True),
        Column(_("bank"), kind="text", key="bank", wraps=True),
        Column(_("shaft, throw"), kind="text", key="throw", wraps=True),
        Column(_("bearing"), "deg", key="bearing_deg"),
        Column("z", along[1], key="z"),
        Column(_("offset"), across[1], key="offset"),
        Column(_("bore"), across[1], key="bore"),
        Column(_("rod"), across[1], key="rod_length"),
        Column(_("reciprocating mass"), mass[1], key="reciprocating_mass"),
        Column(_("top dead centre"), "deg", key="top_dead_centre_deg"),
    )
    banks = {place: name for name, numbers in engine.banks.items() for place in numbers}
    rows: list[tuple[Value, ...]] = []
    for cylinder in engine.cylinders:
        link = cylinder.articulated
        seat = f"{cylinder.shaft}, {cylinder.throw}"
        if link:
            seat = _("{seat} (slave of {master})", seat=seat, master=link.master)
        rows.append(
            (
                cylinder.number,
                banks[cylinder.number],
                seat,
                _bearing(cylinder.bearing),
                cylinder.z * along[0],
                cylinder.offset * across[0],
                None if cylinder.bore is None else cylinder.bore * across[0],
                cylinder.rod_length * across[0],
                cylinder.reciprocating_mass * mass[0],
                round(centres[cylinder.chamber or cylinder.number].angle_deg, 9) + 0.0,
            )
        )
    return Table(_("Cylinders"), columns, tuple(rows), key="cylinders")


def _block(engine: Engine, block: Block) -> str:
    """The whole engine as a rigid body."""
    across, along, mass = _lengths(engine)
    relative = engine.relative
    unit = "m r²" if "mass" in relative else "kg r²" if "radius" in relative else "kg m²"
    values = {
        "mass": f"{number(block.mass * mass[0])} {mass[1]}",
        "up": f"{number(block.up * across[0])} {across[1]}",
        "right": f"{number(block.right * across[0])} {across[1]}",
        "place": _("in the middle")
        if block.z is None
        else _("at z = {z}", z=f"{number(block.z * along[0])} {along[1]}"),
    }
    words = _(
        "The whole engine as a rigid body: mass {mass}, centre of mass {up} up, {right} right, {place}.",
        **values,
    )
    if block.inertia is None:
        return words
    vertical, right, along_z = (f"{number(size)} {unit}" for size in block.inertia)
    moments = _(
        "Moments of inertia: {yaw} in yaw, {pitch} in pitch, {roll} in roll.",
        yaw=vertical,
        pitch=right,
        roll=along_z,
    )
    return f"{words} {moments}"


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
    other = (
        Column(_("phase"), "deg", key="phase_deg")
        if first.offset
        else Column(_("series to λ⁷"), key="series", digits=10)
    )
    columns = (Column(_("order"), key="order"), Column("Aₖ", key="harmonic", digits=10), other)
    rows: list[tuple[Value, ...]] = []
    for order in range(1, min(HIGHEST_HARMONIC, exact.size - 1) + 1):
        size = complex(exact[order])
        if not size:
            continue
        if first.offset:
            rows.append((order, abs(size), round(degrees(phase(size)), 2) + 0.0))
        else:
            rows.append((order, size.real, float(motion.series(order, ratio=ratio))))
    values = {"cylinder": first.number, "ratio": number(ratio)}
    title = _(
        "Piston of cylinder {cylinder}: force m r ω² Σ Aₖ cos kψ, λ = r/l = {ratio}", **values
    )
    if first.offset:
        values["offset"] = number(first.offset / radius)
        title = _(
            "Piston of cylinder {cylinder}: force m r ω² Σ Aₖ cos(kψ + phase), λ = r/l = {ratio}, "
            "offset {offset} r",
            **values,
        )
    return (Table(title, columns, tuple(rows), key="harmonics"),)


def _lengths(engine: Engine) -> tuple[tuple[float, str], tuple[float, str], tuple[float, str]]:
    """Factor and unit for lengths across and along the crankshaft, and for masses."""
    across = (1.0, "r") if "radius" in engine.relative else (1000.0, "mm")
    along = (1.0, "a") if "pitch" in engine.relative else (1000.0, "mm")
    return across, along, (1.0, "m") if "mass" in engine.relative else (1.0, "kg")


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
