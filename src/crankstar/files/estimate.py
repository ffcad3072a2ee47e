"""Masses and lengths that a file leaves out, estimated from its bore, stroke or displacement.

`estimated` fills them in the tree of a file, each with a source of status `estimated` that gives
its range (`box`); what the file gives is kept.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from inspect import signature
from math import pi
from typing import Any, NamedTuple

from crankstar.engine.block import inertia_in_box
from crankstar.engine.engine import Engine
from crankstar.engine.gas import said_ignition
from crankstar.engine.layouts import LAYOUTS
from crankstar.engine.proportions import (
    TWO_MASSES,
    Look,
    Proportion,
    bores_in,
    fastest,
    inferred,
    is_radial,
    pins_of_cylinder,
    piston_speed,
    proportion,
    rod_inertia,
    row_pitch,
)
from crankstar.engine.quantities import INERTIA, LENGTH, MASS
from crankstar.engine.weighed import EngineType
from crankstar.files import units
from crankstar.files.box import ROD
from crankstar.files.errors import refused
from crankstar.files.filling import Bond, Filled, Filling
from crankstar.files.forms import is_explicit
from crankstar.files.mistakes import Tree, copied
from crankstar.files.parts import tells_rotating
from crankstar.files.read import engine_of
from crankstar.files.references import absolute
from crankstar.language.faults import ValueFaultError
from crankstar.language.messages import _

RODS = {"mass": MASS, "centre": LENGTH, "inertia": INERTIA}
"""What a rod as a rigid body has."""


SIDES = ("height", "width", "length")
INERTIAS = ("inertia_up", "inertia_right", "inertia_z")
"""The keys of a block that go together: up, right, z."""
STANDING = ("block", "mounts", "foundation")
"""Tables of what moves on the mounts: no layout depends on them."""
STANDS = re.compile(rf"({'|'.join(STANDING)})\b")
"""Begins the key path of a value of one of these."""


class Estimate(NamedTuple):
    """A file completed: its type, the key of what tells it ("" if named), what was filled in."""

    tree: Tree
    kind: EngineType
    reason: str
    filled: tuple[Filled, ...]


def estimated(
    tree: Tree,
    *,
    name: str = "the engine",
    kind: EngineType | None = None,
    displacement: float | None = None,
    speed: object = None,
) -> Estimate:
    """The tree with masses, lengths and speed that it leaves out; `displacement` [m^3] of it all.

    A `speed` that an analysis is asked for, however it is given, stands for that of the file.

    Raises EngineFileError where a file gives neither sizes nor displacement, or is no engine.
    """
    tree = copied(tree)
    explicit = is_explicit(tree)
    rod = _incomplete_rod(tree)
    bore, stroke = (None, None) if explicit else (_length(tree, "bore"), _length(tree, "stroke"))
    laid_out = _laid_out(tree, name)
    first = laid_out.first
    if explicit and "radius" not in laid_out.relative:
        bore, stroke = first.bore, 2 * laid_out.throw(first).radius
    chambers = len({c.chamber or c.number for c in laid_out.cylinders})
    if bore is None and stroke is None and displacement is None:
        raise refused(name, "nothing-to-estimate-from")
    if explicit and (displacement is not None or (bore is None and "mass" in laid_out.relative)):
        raise refused(name, "explicit-without-bore")
    if displacement is not None and (bore is not None or stroke is not None):
        raise refused(name, "displacement-and-sizes")
    opposed = chambers < len(laid_out.cylinders)
    square = (displacement or 0.0) / len(laid_out.cylinders) * 4 / pi
    guess = bore or stroke or square ** (1 / 3)
    look = Look(
        bore=bore or guess,
        stroke=stroke or guess,
        cycle=laid_out.cycle,
        cylinders=chambers,
        radial=is_radial(laid_out),
        opposed=opposed,
        speed=fastest(laid_out, laid_out.gas),
        ignition=said_ignition(laid_out.gas)[0],
    )
    reason = ""
    if kind is None:
        kind, reason = inferred(look)
    filling = Filling(tree, kind)
    if explicit:  # its masses are known: the stroke stands for the bore in what depends on neither
        bore, stroke = look.bore, look.stroke
    else:
        bore, stroke = _sizes(filling, laid_out, bore, stroke, displacement)
    try:
        _lengths(filling, laid_out, bore, stroke)
        _masses(filling, laid_out, bore, rod)
        _block(filling)
    except KeyError:
        raise refused(name, "no-proportions", kind=kind) from None
    except ValueFaultError as error:
        sizes = {key: units.text(own, LENGTH) for key, own in (("bore", bore), ("stroke", stroke))}
        mistake = error.at(_("an estimated value"))
        raise refused(name, "no-estimate", mistake=mistake, **sizes) from None
    if laid_out.speed is None and speed is None:
        speeds = piston_speed(kind)
        source = f"mean piston speed of {speeds[1]:g} m/s, {_type(kind)}"
        if explicit and first.bore is None and reason:
            source += ", found with a bore equal to the stroke: the file has no bore"
        filling.fill("speed", [pi * v / stroke for v in speeds], source)
    if not filling.table("provenance"):
        del filling.tree["provenance"]
    engine_of(filling.tree, name=name)
    return Estimate(filling.tree, kind, reason, tuple(filling.filled))


def _block(filling: Filling) -> None:
    """The moments of inertia of a block whose mass and outer size are given."""
    table = filling.tree.get("block")
    if not isinstance(table, dict) or set(INERTIAS) & table.keys():
        return
    needed = {key: table.get(key) for key in ("mass", *SIDES)}
    if not all(isinstance(value, str) for value in needed.values()):
        return
    mass = units.si(needed["mass"], MASS)
    sides = [units.si(needed[key], LENGTH) for key in SIDES]
    if mass <= 0 or min(sides) <= 0:  # reading the file says what is wrong
        return
    own = inertia_in_box(mass, sides=sides)
    source = "a homogeneous box of that mass and outer size; an ellipsoid in it, or its walls alone"
    for key, *sizes in zip(INERTIAS, own.low, own.typical, own.high, strict=True):
        filling.fill(f"block.{key}", sizes, source)


def _type(kind: str) -> str:
    return f"engines of type {kind}"


def _length(tree: Tree, key: str) -> float | None:
    """Bore or stroke of all cylinders in metres; None where it is not given with a unit."""
    table = tree.get("cylinder")
    value = table.get(key) if isinstance(table, dict) else None
    if not isinstance(value, str):
        return value if isinstance(value, float) and key == "stroke" else None
    try:
        return units.without_tolerance(value, LENGTH)
    except ValueFaultError:
        return None  # reading the file says what is wrong


def _incomplete_rod(tree: Tree) -> Mapping[str, Any]:
    """What a short file gives of a rod as a rigid body, taken out where that is not the whole.

    A rod with a mistake in it is left: reading the file tells that.
    """
    table = tree.get("cylinder")
    rod = table.get("rod") if isinstance(table, dict) else None
    whole = {key for key in RODS if isinstance(rod, dict) and isinstance(rod.get(key), str)}
    if table is None or rod is None or not whole or "parts" in table:
        return {}
    if rod.keys() != whole or whole == RODS.keys():
        return {}
    try:
        for key, quantity in RODS.items():
            units.without_tolerance(rod.get(key, units.text(1.0, quantity)), quantity)
    except ValueFaultError:
        return {}
    del table["rod"]
    return rod


def _laid_out(tree: Tree, name: str) -> Engine:
    """The engine as far as the file gives it. Raises EngineFileError.

    Without what stands on its mounts, whose masses have units where those of the parts may not yet:
    the file is read as a whole once it is complete.
    """
    tree = {key: value for key, value in tree.items() if key not in STANDING}
    if isinstance(sources := tree.get("provenance"), dict):
        tree["provenance"] = {
            key: source for key, source in sources.items() if not STANDS.match(str(key))
        }
    if not is_explicit(tree) and _length(tree, "bore") and "stroke" not in tree["cylinder"]:
        # a bore alone has no unit to be counted in
        tree = {**tree, "cylinder": {**tree["cylinder"], "stroke": tree["cylinder"]["bore"]}}
    return engine_of(tree, name=name)


def _sizes(
    filling: Filling,
    laid_out: Engine,
    bore: float | None,
    stroke: float | None,
    displacement: float | None,
) -> tuple[float, float]:
    """Bore and stroke, each from the other by their ratio, or both from the displacement.

    V = n pi/4 D^2 S, S = s D: D = (4 V / (n pi s))^(1/3). A bore pitch of the file limits the bore.
    """
    if bore is not None and stroke is not None:
        return bore, stroke
    ratio = proportion("stroke", filling.kind)
    shares, volume = ratio.sizes, 4 * (displacement or 0.0) / (len(laid_out.cylinders) * pi)
    said = f"stroke/bore {ratio.typical:.3g}, {_type(filling.kind)}"
    pitch = row_pitch(laid_out)

    def room(bores: list[float], source: str) -> str:
        """Fill in the bore; where it comes from."""
        least, usual, most = sorted(bores)
        own = bores_in((least, usual, most), pitch, filling.kind)
        if pitch is not None and own != (least, usual, most):
            source += f", with room at a bore pitch of {1e3 * pitch:.6g} mm"
        filling.fill("cylinder.bore", list(own), source)
        return source

    if displacement is not None:
        bores = [(volume / s) ** (1 / 3) for s in shares]
        source = room(bores, f"displacement {displacement * 1e6:.6g} cm3, {said}")
        low, bore, high = (
            filling.filled[-1].low,
            filling.filled[-1].typical,
            filling.filled[-1].high,
        )
        filling.fill("cylinder.stroke", [volume / each**2 for each in (high, bore, low)], source)
        return bore, filling.filled[-1].typical
    if bore is not None:
        filling.fill("cylinder.stroke", [bore * share for share in shares], said)
        return bore, filling.filled[-1].typical
    stroke = stroke or 0.0  # one of the three is given
    room([stroke / share for share in shares], said)
    return filling.filled[-1].typical, stroke


def _lengths(filling: Filling, laid_out: Engine, bore: float, stroke: float) -> None:
    """Rod length and bore pitch where they are not given; bare lengths in their units."""
    tree, kind = filling.tree, filling.kind
    pitch = None
    if not is_explicit(tree):
        cylinder = tree["cylinder"]
        if "radius" in laid_out.relative:
            absolute(tree, {"radius": stroke / 2})
        if not {"rod_length", "rod_ratio"} & cylinder.keys():
            ratio = proportion("rod length", kind)
            source = f"l/r {ratio.typical:.3g}, {_type(kind)}"
            filling.fill(
                "cylinder.rod_length", [stroke / 2 * share for share in ratio.sizes], source
            )
        rows = [(c.shaft, c.bearing) for c in laid_out.cylinders]
        several = any(rows.count(row) > 1 for row in rows)
        takes = "bore_pitch" in signature(LAYOUTS[tree["layout"]["type"]]).parameters
        if "pitch" in laid_out.relative and several and takes:
            ratio = proportion("bore pitch", kind)
            source = f"bore pitch/bore {ratio.typical:.3g}, {_type(kind)}"
            pitches = [bore * share for share in ratio.sizes]
            pitch = pitches[1]
            absolute(tree, {"pitch": pitch})
            filling.fill("layout.bore_pitch", pitches, source)


def _masses(filling: Filling, laid_out: Engine, bore: float, given: Mapping[str, Any]) -> None:
    """Piston group, rod as a rigid body and crank pin; the big end where the piston has a mass.

    `given`: what the file gives of a rod as a rigid body, whose other values are filled in.
    """
    tree, kind = filling.tree, filling.kind
    cylinder = {} if is_explicit(tree) else tree["cylinder"]
    known = "mass" not in laid_out.relative
    turning = "rotating_mass" in cylinder or tells_rotating(cylinder)
    if known and not given and (turning or is_explicit(tree) or kind == "crosshead"):
        return
    rods = proportion("rod", kind)
    share = proportion("small end", kind)
    pins = proportion("crank pin", kind)
    groups = proportion("piston group", kind)
    cube = bore**3
    about = f"{{part}} {{k:.3g}} kg/m3 x bore^3, {_type(kind)}"
    shared = pins_of_cylinder(laid_out)
    pin_masses = [shared * k * cube for k in pins.sizes]
    pin_text = about.format(part="crank pin", k=pins.typical)
    if shared < 1:
        pin_text += f", shared by {1 / shared:.3g} cylinders"
    has_pins = not any(c.articulated for c in laid_out.cylinders)
    if is_explicit(tree):
        masses = [g + s * r for g, r, s in zip(groups.sizes, rods.sizes, share.sizes, strict=True)]
        text = about.format(part="piston group and small end", k=masses[1])
        absolute(tree, {"mass": masses[1] * cube})
        filling.mark("cylinders.reciprocating_mass", [m * cube for m in masses], text)
        return
    if known and not given and "rod" not in cylinder:
        ends = [(1 - s) * r * cube for s, r in zip(reversed(share.sizes), rods.sizes, strict=True)]
        text = about.format(part="big end", k=ends[1] / cube)
        if has_pins:
            filling.fill("cylinder.rotating_mass", ends, text)
            if "throw_mass" not in cylinder:
                filling.fill("cylinder.throw_mass", pin_masses, pin_text)
        return
    if not known:
        text = about.format(part="piston group", k=groups.typical)
        absolute(tree, {"mass": groups.typical * cube})
        filling.fill("cylinder.reciprocating_mass", [k * cube for k in groups.sizes], text)
    if "rod" not in cylinder:
        text = about.format(part="rod", k=rods.typical)
        _rod(filling, [k * cube for k in rods.sizes], text, share, given)
    if has_pins and not {"rotating_mass", "throw_mass"} & cylinder.keys():
        filling.fill("cylinder.throw_mass", pin_masses, pin_text)


def _rod(
    filling: Filling,
    masses: Sequence[float],
    source: str,
    share: Proportion,
    given: Mapping[str, Any],
) -> None:
    """Mass, centre of mass and moment of inertia of the rod.

    Its inertia moves with that of two masses at its ends, m b (l - b) with the centre at b, and is
    that over q. It enters forces as I - m b (l - b) = m b (l - b) (1/q - 1), which is not linear in
    b: between the ends of b it lies up to m (db/2)^2 |1/q - 1| off a straight line, so that the
    ends of 1/q are further from 1 by the factor `bow`.
    """
    cylinder = filling.tree["cylinder"]
    engine = engine_of({**filling.tree, "cylinder": {**cylinder}})
    length = engine.first.rod_length
    ends = [f.typical for f in filling.filled if f.path == "cylinder.rod_length"]
    filling.table("cylinder", "rod").update(given)
    if "mass" in given:
        masses = [units.without_tolerance(given["mass"], MASS)] * 3
    else:
        filling.fill("cylinder.rod.mass", masses, source)
    if "centre" in given:
        own = units.without_tolerance(given["centre"], LENGTH) / length
        if 0 < own < 1:  # else reading the file says what is wrong
            share = share._replace(low=own, typical=own, high=own)
    else:
        said = f"small end {share.typical:.3g} of the rod, all types"
        bond = Bond("cylinder.rod_length" if ends else "")
        filling.fill("cylinder.rod.centre", [length * s for s in share.sizes], said, bond)
    if "inertia" in given:
        return
    least = min(c * (1 - c) for c in share.sizes)
    bow = 1 + ((share.high - share.low) / 2) ** 2 / least
    typical = rod_inertia(mass=masses[1], rod_length=length, small_end=share.typical)[1]
    lengths = [1.0] * 3
    if ends:
        ratio = proportion("rod length", filling.kind)
        lengths = [size / ratio.typical for size in ratio.sizes]
    whole = [
        rod_inertia(mass=m, rod_length=length * size, small_end=c)
        for m, size in zip(masses, lengths, strict=True)
        for c in share.sizes
    ]
    low, high = min(each[0] for each in whole), max(each[2] for each in whole)
    filling.fill(
        "cylinder.rod.inertia",
        [low, typical, high],
        f"two masses at the ends over {TWO_MASSES[1]} (ICEF2002, 19 rods)",
        Bond(ROD, tuple((1 - bow * (1 - 1 / q)) * TWO_MASSES[1] for q in TWO_MASSES[::-2])),
    )
