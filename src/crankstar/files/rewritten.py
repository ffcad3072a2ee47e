"""An engine written back into the form of the file it came from.

A remedy or a search changes weights, shafts, throws or the firing order of an engine that was read
from a short file. Here the short file gets these changes: weights and bearings as `[[crankshaft]]`,
shafts without throws as `[[balance_shaft]]`, throws in its layout. Whether it then says everything
is not reasoned but tried: the new tree is read, and where it does not give the same engine, that
one is written in the explicit form.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import degrees, isclose, pi
from typing import Any

from pydantic import BaseModel

from crankstar.engine.basis import BALANCE_FACTOR, Crankshaft
from crankstar.engine.copies import throws_of_weights, with_values, wrapped
from crankstar.engine.crankshafts import balance_shaft, crankshaft
from crankstar.engine.engine import Engine
from crankstar.engine.records import Identity, Shaft
from crankstar.files.carried_tolerances import carried
from crankstar.files.errors import EngineFileError
from crankstar.files.forms import is_explicit
from crankstar.files.mistakes import Tree, copied
from crankstar.files.read import engine_of
from crankstar.files.references import unknown_scales
from crankstar.files.write import explicit, part_by_part, written

WEIGHTS = "shaft.weight.unbalance"
"""The key path of the unbalance of every weight, in the explicit form."""
CLOSE = 1e-9
"""Share by which numbers may differ that were written and read back; radians for angles."""


def rewritten(tree: Mapping[str, Any], engine: Engine) -> Tree:
    """The tree of a file for a changed engine: in its own form where that says all of it.

    >>> from crankstar.files.catalog import tree_of
    >>> from crankstar.remedy import with_counterweights
    >>> _, tree = tree_of("triple-120")
    >>> weighted = rewritten(tree, with_counterweights(engine_of(tree), factor=0.5))
    >>> weighted["layout"] == tree["layout"], len(weighted["crankshaft"][0]["weight"])
    (True, 3)
    """
    return _short(dict(tree), engine) or carried(explicit(engine), tree)


def rewritten_by_parts(tree: Mapping[str, Any], engine: Engine) -> Tree:
    """The same, without the sources of keys that it does not have: a tree to go on working with."""
    return _short(dict(tree), engine) or carried(part_by_part(engine), tree)


def _short(tree: Tree, engine: Engine) -> Tree | None:
    """The short tree with the changes of the engine, None where it cannot say them."""
    if is_explicit(tree):
        return None
    before = engine_of(tree)
    out = copied(tree)
    others = {path: own for path, own in engine.provenance.items() if path != WEIGHTS}
    _with_identity(out, before, with_values(engine, provenance=others))
    shafts = len(out.get("balance_shaft", []))
    cranks = len(before.shafts) - shafts
    if len(engine.shafts) < cranks or any(shaft.throws for shaft in engine.shafts[cranks:]):
        return None
    _with_throws(out, before.shafts[0], engine)
    relative = unknown_scales(out)
    _with_crankshafts(out, before.shafts[:cranks], engine, relative)
    if not _same(before.shafts[cranks:], engine.shafts[cranks:]):
        out["balance_shaft"] = [
            written(balance_shaft(shaft), relative) for shaft in engine.shafts[cranks:]
        ]
    _with_estimated_weights(out, engine)
    try:
        return out if _same(engine_of(out), engine) else None
    except EngineFileError:
        return None


def _with_identity(out: Tree, before: Engine, engine: Engine) -> None:
    """What the file says of the engine as a whole."""
    changed = {
        key: getattr(engine, key)
        for key in Identity.model_fields
        if getattr(engine, key) != getattr(before, key)
    }
    for key in changed:
        out.pop(key, None)
    if changed:
        own = with_values(engine, **{"firing_angles": None, **changed})
        values = written(own, frozenset(engine.relative))
        out |= {key: values[key] for key in changed if key in values}


def _with_throws(out: Tree, before: Shaft, engine: Engine) -> None:
    """The throws of a layout of one crankshaft, where they were turned against each other."""
    throws = engine.shafts[0].throws
    if len(throws) != len(before.throws) or _same(
        [throw.angle - throws[0].angle for throw in throws],
        [throw.angle - before.throws[0].angle for throw in before.throws],
    ):
        return
    layout = out["layout"]
    banks = layout.get("banks") or [{"cylinders": sorted(c.number for c in engine.cylinders)}]
    given = layout.get("throws")
    numbers = banks[0]["cylinders"]
    if given is not None and len(given) != len(numbers):
        numbers = sorted(number for bank in banks for number in bank["cylinders"])
    own = {cylinder.number: engine.throw(cylinder).angle for cylinder in engine.cylinders}
    if set(numbers) <= set(own):
        turns = [wrapped(own[number] - own[numbers[0]]) for number in numbers]
        layout["throws"] = [f"{round(degrees(turn), 12) + 0.0:.15g} deg" for turn in turns]


def _with_crankshafts(
    out: Tree, before: tuple[Shaft, ...], engine: Engine, relative: frozenset[str]
) -> None:
    """Weights, bearings and webs of the crankshafts, where they are others."""
    after = [_brief(shaft) for shaft in engine.shafts[: len(before)]]
    if _same(after, [_brief(shaft) for shaft in before]):
        return
    for above in (out, out.get("provenance", {})):
        above.pop(BALANCE_FACTOR, None)  # whose weights are among those of the crankshafts
    if not out.get("provenance", True):
        del out["provenance"]
    tables = [written(table, relative) for table in after]
    while tables and not tables[-1]:
        tables.pop()
    out.pop("crankshaft", None)
    if tables:
        out["crankshaft"] = tables


def _with_estimated_weights(out: Tree, engine: Engine) -> None:
    """The source of weights that were sized for estimated masses, by its keys in a short file."""
    source = engine.provenance.get(WEIGHTS)
    if source is None or source.status != "estimated":
        return
    text = {"status": source.status, "source": source.source}
    for table in ("crankshaft", "balance_shaft"):
        if any(shaft.get("weight") for shaft in out.get(table, [])):
            out.setdefault("provenance", {})[WEIGHTS.replace("shaft", table, 1)] = text


def _brief(shaft: Shaft) -> Crankshaft:
    """What a short file says of a crankshaft, without what it need not say."""
    table = crankshaft(shaft)
    homes = throws_of_weights(shaft)
    weights = []
    for weight, home in zip(table.weights, homes, strict=True):
        there = weight.throw is not None and shaft.throws[(home or 1) - 1].z == weight.z
        opposite = abs(wrapped(weight.angle - pi)) < CLOSE
        changes: dict[str, Any] = {"z": None} if there else {}
        weights.append(with_values(weight, **changes, **({"angle": pi} if opposite else {})))
    return with_values(table, weights=tuple(weights))


def _same(one: Any, other: Any, *, key: str = "") -> bool:
    """Whether values are the same to the rounding of numbers that were written and read back."""
    if isinstance(one, BaseModel) and isinstance(other, BaseModel):
        fields = [name for name in type(one).model_fields if name != "provenance"]
        return type(one) is type(other) and all(
            _same(getattr(one, name), getattr(other, name), key=name) for name in fields
        )
    if isinstance(one, tuple | list) and isinstance(other, tuple | list):
        return len(one) == len(other) and all(
            _same(a, b, key=key) for a, b in zip(one, other, strict=True)
        )
    if isinstance(one, float) and isinstance(other, float | int):
        turned = key in ("angle", "bearing") and abs(wrapped(one - other)) < CLOSE
        return turned or isclose(one, other, rel_tol=CLOSE, abs_tol=1e-12)
    return one == other
