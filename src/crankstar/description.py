"""An Engine as tables: its shafts, throws, weights and cylinders, dead centres, and where each value comes from."""

from __future__ import annotations

from cmath import phase
from collections.abc import Sequence
from math import degrees

from rich.console import Group, RenderableType
from rich.text import Text

from crankstar import motion
from crankstar.catalog import Summary
from crankstar.engine import Engine
from crankstar.firing import dead_centres
from crankstar.records import Block
from crankstar.wording import heading, number, table, timing_lines, titled

HIGHEST_HARMONIC, SMALLEST_HARMONIC = 8, 1e-12


def description(engine: Engine) -> RenderableType:
    """An engine as its records: shafts, throws, weights, cylinders, dead centres and where each value comes from."""
    blocks: list[RenderableType] = [heading(engine)]
    if engine.relative:
        unit = {"mass": "masses in m", "radius": "lengths across the crankshaft in r", "pitch": "lengths along it in a"}
        blocks.append(Text("not known, so counted in units of themselves: " + ", ".join(unit[name] for name in engine.relative)))
    blocks += [rotors(engine), cylinders(engine), harmonics(engine)]
    if engine.valves is not None:
        blocks += [Text(), *(Text(line) for line in timing_lines(engine))]
    if engine.block is not None:
        blocks.append(_block(engine, engine.block))
    for title, body in (("source", engine.source), ("notes", engine.notes)):
        if body:
            blocks.append(Text(f"{title}: {body}"))
    if engine.provenance:
        blocks.append(origins(engine))
    return Group(*blocks)


def origins(engine: Engine) -> RenderableType:
    """Where each value of the engine file comes from."""
    heads = ("value", "status", "source")
    out = table(*heads, left=heads, folded=("source",))
    for path, origin in engine.provenance.items():
        style = "yellow" if origin.status in ("unverified", "placeholder") else ""
        out.add_row(Text(path), Text(origin.status, style=style), Text(origin.source))
    return titled("Where the values come from", out)


def rotors(engine: Engine) -> RenderableType:
    """Shafts with their throws and weights, part by part."""
    across, along, mass = _lengths(engine)
    counted = 1 / engine.throw(engine.first).radius if mass[1] == "m" else 1.0  # m m would be masses times metres
    unbalance = f"unbalance\n[{mass[1]} {'m' if across[1] == 'mm' and mass[1] == 'kg' else 'r'}]"
    heads = (
        "shaft",
        "part",
        "bearing at θ = 0\n[deg]",
        f"radius\n[{across[1]}]",
        f"z\n[{along[1]}]",
        f"rotating mass\n[{mass[1]}]",
    )
    out = table(*heads, unbalance, left=("shaft", "part"))
    for shaft in engine.shafts:
        label = f"{shaft.name} (ratio {shaft.speed_ratio})" if shaft.speed_ratio != 1 else shaft.name
        if shaft.up or shaft.right:
            label += f", {number(shaft.up * across[0])} {across[1]} up, {number(shaft.right * across[0])} {across[1]} right"
        for place, throw in enumerate(shaft.throws, 1):
            size = [number(throw.radius * across[0]), number(throw.z * along[0], 1.0), number(throw.rotating_mass * mass[0])]
            out.add_row(
                Text(label),
                f"throw {place}",
                number(degrees(throw.angle), 180.0),
                *size,
                number(throw.rotating_mass * throw.radius * counted),
            )
        for place, weight in enumerate(shaft.weights, 1):
            row = [
                number(degrees(weight.angle), 180.0),
                "",
                number(weight.z * along[0], 1.0),
                "",
                number(weight.unbalance * counted),
            ]
            out.add_row(Text(label), f"weight {place}", *row)
    return titled("Shafts, throws and weights", out)


def cylinders(engine: Engine) -> RenderableType:
    """Cylinders with their places, sizes, masses and dead centres."""
    across, along, mass = _lengths(engine)
    centres = dead_centres(engine)
    heads = [
        "number",
        "bank",
        "shaft, throw",
        "bearing\n[deg]",
        f"z\n[{along[1]}]",
        f"offset\n[{across[1]}]",
        f"bore\n[{across[1]}]",
    ]
    heads += [f"rod\n[{across[1]}]", f"reciprocating\n[{mass[1]}]", "top dead centre\n[deg]"]
    out = table(*heads, left=("bank", "shaft, throw"))
    banks = {place: name for name, numbers in engine.banks.items() for place in numbers}
    for cylinder in engine.cylinders:
        link = cylinder.articulated
        seat = f"{cylinder.shaft}, {cylinder.throw}" + (f" (slave of {link.master})" if link else "")
        out.add_row(
            str(cylinder.number),
            Text(banks[cylinder.number]),
            Text(seat),
            number(degrees(cylinder.bearing), 180.0),
            number(cylinder.z * along[0], 1.0),
            number(cylinder.offset * across[0], 1.0),
            "" if cylinder.bore is None else number(cylinder.bore * across[0]),
            number(cylinder.rod_length * across[0]),
            number(cylinder.reciprocating_mass * mass[0]),
            number(centres[cylinder.chamber or cylinder.number].angle_deg, 360.0),
        )
    return titled("Cylinders", out)


def _block(engine: Engine, block: Block) -> RenderableType:
    """The whole engine as a rigid body."""
    across, along, mass = _lengths(engine)
    unit = "m r²" if "mass" in engine.relative else "kg r²" if "radius" in engine.relative else "kg m²"
    place = "the middle" if block.z is None else f"z = {number(block.z * along[0], 1.0)} {along[1]}"
    words = f"mass {number(block.mass * mass[0])} {mass[1]}, centre of mass {number(block.up * across[0], 1.0)} {across[1]} up, "
    words += f"{number(block.right * across[0], 1.0)} {across[1]} right, {place}"
    if block.inertia is not None:
        shown = ", ".join(f"{number(size)} ({name})" for name, size in zip(("up", "right", "z"), block.inertia, strict=True))
        words += f"; moments of inertia {shown} {unit}"
    return titled("Block: the whole engine as a rigid body", Text(words))


def harmonics(engine: Engine) -> RenderableType:
    """The harmonics of the first cylinder's piston, exact, and from the textbook's series in lambda where there is one."""
    first = engine.first
    radius = engine.throw(first).radius
    if first.articulated is not None:
        return Text()
    exact = motion.piston_harmonics(crank_radius=radius, rod_length=first.rod_length, offset=first.offset)
    ratio = radius / first.rod_length
    out = table("order", "Aₖ exact", "phase [deg]" if first.offset else "series to λ⁷")
    for order in range(1, min(HIGHEST_HARMONIC, exact.size - 1) + 1):
        size = complex(exact[order])
        if abs(size) < SMALLEST_HARMONIC:
            continue
        if first.offset:
            out.add_row(str(order), f"{abs(size):.10g}", f"{round(degrees(phase(size)), 2) + 0.0:.2f}")
        else:
            out.add_row(str(order), f"{size.real:.10g}", f"{float(motion.series(order, ratio=ratio)):.10g}")
    title = f"Piston of cylinder {first.number}: force m r ω² Σ Aₖ cos kψ, λ = r/l = {number(ratio)}"
    return titled(title + (f", offset {number(first.offset / radius)} r" if first.offset else ""), out)


def _lengths(engine: Engine) -> tuple[tuple[float, str], tuple[float, str], tuple[float, str]]:
    """Factor and unit for lengths across and along the crankshaft, and for masses."""
    across = (1.0, "r") if "radius" in engine.relative else (1000.0, "mm")
    along = (1.0, "a") if "pitch" in engine.relative else (1000.0, "mm")
    return across, along, (1.0, "m") if "mass" in engine.relative else (1.0, "kg")


def catalog_table(rows: Sequence[Summary]) -> RenderableType:
    """The engines of the catalog: the name by which commands know them, what they are, and where the numbers are from."""
    out = table("name", "engine", "layout", "cylinders", "cycle", left=("name", "engine", "layout", "cycle"))
    for row in rows:
        out.add_row(Text(row.name, style="bold"), Text(row.title), row.layout, str(row.cylinders), row.cycle)
    return Group(out, Text(f"{len(rows)} engine{'s' if len(rows) > 1 else ''}; crankstar analyze NAME"))
