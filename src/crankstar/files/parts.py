"""The parts of a cylinder as weighed, added up to the masses that its file leaves out.

A `parts` table gives `reciprocating_mass` and `rotating_mass`; beside a rod as a rigid body, whose
two ends hang on scales, its mass and its centre of mass:

    m = m_big + m_small,    b = l m_small / m,

b from the big end, l the rod length. A mass that is given besides must agree with the parts.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from crankstar.engine.basis import ASSUMED_ROD_RATIO
from crankstar.engine.cylinder_parts import ENDS, RECIPROCATING, ROTATING
from crankstar.engine.quantities import LENGTH, MASS, Quantity
from crankstar.files import units
from crankstar.files.forms import is_explicit
from crankstar.files.mistakes import Path, Tree
from crankstar.language.faults import Fault, ValueFaultError

NEAR = 1e-3
"""Share by which a mass given besides may differ from its parts: rounding."""
NEAR_CENTRE = 5e-3
"""The same of a centre of mass, as a share of the rod length."""
DIFFERENT = ("parts", "rod", "stroke", "rod_length", "rod_ratio")
"""What of one cylinder changes what its parts come to."""


def with_sums(tree: Tree) -> tuple[Tree, list[Fault]]:
    """The tree with the masses that its parts come to, and the faults of masses given besides.

    >>> parts = {"piston": "500 g", "small_end": "150 g", "big_end": "420 g"}
    >>> whole, faults = with_sums({"cylinder": {"parts": parts}})
    >>> whole["cylinder"]["reciprocating_mass"], whole["cylinder"]["rotating_mass"], faults
    ('0.65 kg', '0.42 kg', [])
    """
    return _explicit(tree) if is_explicit(tree) else _short(tree)


def tells_mass(table: Mapping[str, Any]) -> bool:
    """Whether a table of a cylinder has parts that go up and down."""
    return any(name in _parts(table) for name in RECIPROCATING)


def tells_rotating(table: Mapping[str, Any]) -> bool:
    """Whether a table of a cylinder has parts that turn with the crank pin."""
    return any(name in _parts(table) for name in ROTATING)


class _Sum(NamedTuple):
    """A sum of parts: its key, in kg or the file's own unit of mass, as a file writes it.

    Where a part is mistaken it only stands in for the mass, and says nothing of others.
    """

    key: str
    total: float
    text: str | float
    sure: bool = True


def _short(tree: Tree) -> tuple[Tree, list[Fault]]:
    base = _table(tree.get("cylinder"))
    faults: list[Fault] = []
    out = dict(tree)
    if _parts(base):
        whole, more = _completed(base, base, ("cylinder",))
        out["cylinder"], faults = whole, [*faults, *more]
    others = tree.get("cylinders")
    if not isinstance(others, list):
        return out, faults
    out["cylinders"] = [*others]
    for index, own in enumerate(others):
        if not isinstance(own, dict):
            continue
        both = {**base, **own, "parts": {**_parts(base), **_parts(own)}}
        given = {"reciprocating_mass", "rotating_mass"} & own.keys()
        if both["parts"] and (given or any(key in own for key in DIFFERENT)):
            only = {key: both[key] for key in both if key in own or key not in _MASSES}
            whole, more = _completed(own, only, ("cylinders", index))
            out["cylinders"][index], faults = whole, [*faults, *more]
    return out, faults


_MASSES = ("reciprocating_mass", "rotating_mass")


def _explicit(tree: Tree) -> tuple[Tree, list[Fault]]:
    cylinders = tree.get("cylinders")
    if not isinstance(cylinders, list) or not any(_parts(own) for own in cylinders):
        return tree, []
    out = {**tree, "cylinders": [*cylinders]}
    faults: list[Fault] = []
    pins: dict[tuple[Any, Any], list[_Sum | None]] = {}
    for index, own in enumerate(cylinders):
        if not isinstance(own, dict):
            continue
        slave = isinstance(own.get("articulated"), dict)
        turning = None
        if _parts(own):
            whole, more = _completed(own, own, ("cylinders", index), on_throw=not slave)
            turning = next((s for s in _sums(own) if s.key == "rotating_mass"), None)
            if slave and turning is not None:
                faults += _contradictions(("cylinders", index), own, [turning], "big_end_mass")
                whole.setdefault("big_end_mass", turning.text)
            out["cylinders"][index], faults = whole, [*faults, *more]
        if not slave:
            pins.setdefault((own.get("shaft"), own.get("throw")), []).append(turning)
    return _on_throws(out, pins, faults)


def _on_throws(
    tree: Tree, pins: Mapping[tuple[Any, Any], list[_Sum | None]], faults: list[Fault]
) -> tuple[Tree, list[Fault]]:
    """The explicit tree with the rotating masses of the throws whose cylinders all have parts."""
    key = "shaft" if "shaft" in tree else "shafts"
    shafts = tree.get(key)
    if not isinstance(shafts, list):
        return tree, faults
    out = {**tree, key: [*shafts]}
    for index, shaft in enumerate(shafts):
        throws = shaft.get("throw") if isinstance(shaft, dict) else None
        if not isinstance(throws, list):
            continue
        own = [*throws]
        for number, throw in enumerate(throws, 1):
            sums = pins.get((shaft.get("name"), number), [])
            known = [each for each in sums if each is not None]
            if not known or len(known) < len(sums) or not isinstance(throw, dict):
                continue
            total = sum(each.total for each in known)
            bare = all(isinstance(each.text, float) for each in known)
            sure = all(each.sure for each in known)
            whole = _Sum("rotating_mass", total, total if bare else f"{total:.12g} kg", sure)
            where: Path = (key, index, "throw", number - 1)
            faults = [*faults, *_contradictions(where, throw, [whole])]
            own[number - 1] = {"rotating_mass": whole.text, **throw}
        out[key][index] = {**shaft, "throw": own}
    return out, faults


def _completed(
    own: Mapping[str, Any], both: Mapping[str, Any], path: Path, *, on_throw: bool = False
) -> tuple[Tree, list[Fault]]:
    """The table of a cylinder with its sums; `both`: with what [cylinder] says besides.

    `on_throw`: what turns is said where the throw is.
    """
    sums = [each for each in _sums(both) if not on_throw or each.key != "rotating_mass"]
    sums = [each for each in sums if each.key != "rotating_mass" or "articulated" not in own]
    out = {**{each.key: each.text for each in sums}, **own}
    faults = [*_contradictions(path, own, sums)]
    rod = both.get("rod")
    if isinstance(rod, dict):
        whole, more = _rod(rod, both, path)
        out["rod"] = whole
        faults += [] if _mistaken(both) else more
    return out, faults


def _sums(both: Mapping[str, Any]) -> list[_Sum]:
    """What the parts come to, the ends of a rod as a rigid body left to it."""
    parts = _parts(both)
    apart = ENDS if isinstance(both.get("rod"), dict) else ()
    out: list[_Sum] = []
    for key, names in (("reciprocating_mass", RECIPROCATING), ("rotating_mass", ROTATING)):
        given = [name for name in names if name in parts and name not in apart]
        if given:
            total = sum(abs(_si(parts[name], MASS) or 0.0) for name in given)
            bare = not any(isinstance(parts[name], str) for name in given)
            text = total if bare else f"{total:.12g} kg"
            out.append(_Sum(key, total, text, not _mistaken(both)))
    return out


def _contradictions(
    path: Path, table: Mapping[str, Any], sums: Sequence[_Sum], name: str = ""
) -> Iterator[Fault]:
    """The masses of a table that are not what its parts come to."""
    for key, total, _text, sure in sums:
        given = _si(table.get(name or key), MASS)
        if sure and given is not None and abs(given - total) > NEAR * max(given, total):
            values = {"given": _grams(given), "total": _grams(total)}
            code = "reciprocating" if key == "reciprocating_mass" else "rotating"
            yield Fault((*path, name or key), f"parts.{code}", values)


def _rod(rod: Mapping[str, Any], both: Mapping[str, Any], path: Path) -> tuple[Tree, list[Fault]]:
    """The rod as a rigid body with mass and centre from its two ends."""
    parts = _parts(both)
    small, big = (_si(parts.get(name), MASS) for name in ENDS)
    if small is None and big is None:
        return dict(rod), []
    small, big = (None if end is None else abs(end) for end in (small, big))
    if small is None or big is None or small + big <= 0:
        missing = "small_end" if small is None else "big_end"
        return dict(rod), [Fault((*path, "parts", missing), "parts.end-missing")]
    mass, length = small + big, _rod_length(both)
    bare = not any(isinstance(parts[name], str) for name in ENDS)
    out: Tree = {"mass": mass if bare else f"{mass:.12g} kg", **rod}
    faults = []
    given = _si(rod.get("mass"), MASS)
    if given is not None and abs(given - mass) > NEAR * max(given, mass):
        values = {"given": _grams(given), "total": _grams(mass)}
        faults.append(Fault((*path, "rod", "mass"), "parts.rod-mass", values))
    if length is None:
        return out, faults
    centre = length[0] * small / mass
    out.setdefault("centre", f"{centre:.12g} m" if length[1] else centre)
    place = _si(rod.get("centre"), LENGTH)
    if place is not None and abs(place - centre) > NEAR_CENTRE * length[0]:
        unit, factor = ("mm", 1000.0) if length[1] else ("crank radii", 1.0)
        values = {
            "given": f"{place * factor:.5g} {unit}",
            "centre": f"{centre * factor:.5g} {unit}",
        }
        faults.append(Fault((*path, "rod", "centre"), "parts.rod-centre", values))
    return out, faults


def _rod_length(both: Mapping[str, Any]) -> tuple[float, bool] | None:
    """The rod length, and whether it has a unit; None where it cannot be read."""
    own = both.get("rod_length")
    if own is not None:
        length = _si(own, LENGTH)
        return None if length is None else (length, isinstance(own, str))
    stroke = both.get("stroke")
    radius = 1.0 if stroke is None else (_si(stroke, LENGTH) or 0.0) / 2
    ratio = both.get("rod_ratio", ASSUMED_ROD_RATIO)
    if not isinstance(ratio, int | float) or isinstance(ratio, bool) or not radius:
        return None
    return radius * ratio, isinstance(stroke, str)


def _mistaken(both: Mapping[str, Any]) -> bool:
    """Whether a part cannot be read, so that the sum says nothing."""
    return any(
        name not in (*RECIPROCATING, *ROTATING) or (_si(value, MASS) or -1.0) < 0
        for name, value in _parts(both).items()
        if value != 0
    )


def _table(value: Any) -> Mapping[str, Any]:
    return value if isinstance(value, dict) else {}


def _parts(table: Any) -> Mapping[str, Any]:
    return _table(_table(table).get("parts"))


def _si(value: Any, quantity: Quantity) -> float | None:
    """A value in SI, or as it is in units of itself; None where it is none."""
    if value is None:
        return None
    try:
        return units.si(value, quantity)
    except ValueFaultError:
        return None


def _grams(mass: float) -> str:
    return f"{1000 * mass:.6g} g"
