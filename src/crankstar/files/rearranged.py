"""An engine file with another number of cylinders, another crank or another firing order.

What belongs together changes together: throws, banks and firing order fit each other, and what was
made for the old crank is left out and named. Each answer has the alternatives beside it.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from contextlib import suppress
from itertools import islice
from math import degrees, isclose
from typing import Any, NamedTuple

from crankstar.engine.copies import wrapped
from crankstar.engine.engine import Engine
from crankstar.files.changes import keys_of
from crankstar.files.crank_layouts import Kind, bank_angle_deg, kind_of, layouts_for
from crankstar.files.errors import EngineFileError
from crankstar.files.forms import is_explicit
from crankstar.files.mistakes import Tree, copied
from crankstar.files.read import engine_of
from crankstar.firing.intervals import Firing, firing
from crankstar.firing.orders import (
    SAME_PLACE,
    Order,
    even_orders,
    place_of,
    possible_orders,
    unevenness,
)
from crankstar.firing.rows import CUSTOMARY
from crankstar.firing.timetable import OrderError
from crankstar.language.faults import EngineError, Fault
from crankstar.language.messages import _, _n
from crankstar.language.numbers import number

MOST_ORDERS = 8
MOST_CRANKS = 12
FEW = 8
"""Cylinders up to which every possible firing order of an uneven crank is looked at."""
NEARLY = 0.08
"""Share of the mean interval by which the intervals of nearly even firing differ from it."""
OF_THE_OLD_CRANK = (
    "crankshaft",
    "torsion",
    "balance_shaft",
    "block",
    "mounts",
    "foundation",
    "cylinders",
    "notes",
    "left_out",
)
"""Tables that another number of cylinders makes untrue."""
NAMES = {
    "inline": "In-line {count}",
    "vee": "V{count}",
    "boxer": "Boxer {count}",
    "opposed": "Opposed-piston {count}",
    "tandem": "Tandem {count}",
    "radial": "Radial {count}",
}
SINGLE = "Single"


class Offer(NamedTuple):
    """An engine file that is one click away, in few words; `chosen`: it is the present one."""

    label: str
    tree: Tree
    chosen: bool = False


class Rearranged(NamedTuple):
    """An engine file, how many cylinders it may have instead, its cranks and firing orders.

    `fewer` and `more` are numbers of cylinders, None at an end and where the form has no layout.
    """

    tree: Tree
    cylinders: int
    fewer: int | None
    more: int | None
    sentences: tuple[str, ...]
    cranks: tuple[Offer, ...]
    orders: tuple[Offer, ...]


def rearranged(tree: Mapping[str, Any], *, cylinders: int | None = None) -> Rearranged:
    """The file as it is, or with another number of cylinders, with all that goes with it.

    `cylinders` counts combustion chambers. Raises EngineFileError, and EngineError for a number
    that the layout cannot have.

    >>> from crankstar.files.catalog import tree_of
    >>> five = rearranged(tree_of("i4")[1], cylinders=5)
    >>> five.tree["firing_order"], five.tree["layout"]["throws"][:2], five.more
    ([1, 2, 4, 5, 3], ['0 deg', '-144 deg'], 6)
    """
    given = copied(dict(tree))
    engine = engine_of(given)
    count = len(engine.chambers)
    if is_explicit(given):
        if cylinders not in (None, count):
            raise EngineError([Fault(("cylinders",), "workshop.explicit")])
        said = _(
            "The explicit form lists every part; a layout is needed to change the number of "
            "cylinders."
        )
        return Rearranged(given, count, None, None, (said,), (), _orders(engine, given))
    wanted = count if cylinders is None else cylinders
    kind = kind_of(given["layout"], engine.cycle)
    if wanted != count and not _possible(wanted, count, kind):
        values = {"value": wanted, "step": kind.step, "greatest": kind.greatest}
        raise EngineError([Fault(("cylinders",), "workshop.cylinders", values)])
    if wanted == count:
        chosen, sentences = given, ()
    else:
        chosen, sentences = _resized(given, engine, wanted)
    own = engine_of(chosen)
    return Rearranged(
        tree=chosen,
        cylinders=wanted,
        fewer=_next(wanted, count, kind, -1),
        more=_next(wanted, count, kind, 1),
        sentences=(_said(own, chosen), *sentences),
        cranks=_cranks(own, chosen),
        orders=_orders(own, chosen),
    )


def _possible(wanted: int, count: int, kind: Kind) -> bool:
    return (wanted - count) % kind.step == 0 and 0 < wanted <= kind.greatest


def _next(wanted: int, count: int, kind: Kind, way: int) -> int | None:
    """The next number of cylinders up or down, of a longer engine than any the greatest."""
    other = wanted + way * kind.step
    if way < 0 and other > kind.greatest:
        other -= -(-(other - kind.greatest) // kind.step) * kind.step
    return other if _possible(other, count, kind) else None


def _resized(tree: Tree, engine: Engine, count: int) -> tuple[Tree, tuple[str, ...]]:
    """The file with so many cylinders and a firing order; what was left out, in a sentence."""
    first = None
    for layout in layouts_for(engine, tree["layout"], count=count):
        made = with_best_order(_laid_out(tree, layout))
        first = first or made
        if made.get("firing_order"):
            first = made
            break
    if first is None:
        raise EngineError([Fault(("cylinders",), "workshop.no-crank", {"value": count})])
    left = [key for key in OF_THE_OLD_CRANK if key in tree and key != "notes"]
    text = _("Left out, as they belong to the old crankshaft: {keys}.", keys=", ".join(left))
    return first, ((text,) if left else ())


def _laid_out(tree: Tree, layout: Tree) -> Tree:
    """The file with a layout for other cylinders, without what belongs to the old ones."""
    out = _without(tree, "firing_order", "firing_angles", *OF_THE_OLD_CRANK) | {"layout": layout}
    if isinstance(out.get("valves"), dict):
        out["valves"] = _without(out["valves"], "manifolds")
    out = _with_sources(out, "layout", "firing_order", "firing_angles", *OF_THE_OLD_CRANK)
    out["name"] = _name(engine_of(out), layout)
    out["source"] = f"changed from {tree.get('name', '')}"
    return out


def _without(tree: Mapping[str, Any], *keys: str) -> Tree:
    return {key: value for key, value in tree.items() if key not in keys}


def _with_sources(tree: Tree, *gone: str) -> Tree:
    """The tree without the sources of tables and keys that are other now."""
    sources = tree.get("provenance")
    if not isinstance(sources, dict):
        return tree
    kept = {path: source for path, source in sources.items() if keys_of(path)[0] not in gone}
    return {**tree, "provenance": kept} if kept else _without(tree, "provenance")


def _name(engine: Engine, layout: Mapping[str, Any]) -> str:
    """What an engine of a layout is called: V6, 60 deg."""
    count = len(engine.chambers)
    if count == 1:
        return SINGLE
    if layout["type"] != "vee":
        return NAMES[layout["type"]].format(count=count)
    banks = len(layout["banks"])
    if banks != 2:
        return f"{'W' if banks > 2 else 'In-line '}{count}"
    return f"V{count}, {abs(bank_angle_deg(engine, layout)):.4g} deg"


def with_best_order(tree: Tree) -> Tree:
    """The file with the best firing order of its crank: the customary one, else the most even."""
    engine = engine_of(tree)
    orders = _possible_orders(engine)
    if not orders:
        return tree
    in_line = len({cylinder.bearing for cylinder in engine.cylinders}) == 1
    usual = CUSTOMARY.get((engine.cycle, len(engine.chambers))) if in_line else None
    best = next((order for order in orders if order.firing.order == usual), orders[0])
    return _with_order(tree, best.firing)


def _possible_orders(engine: Engine) -> tuple[Order, ...]:
    """Even orders, else all that are possible of a few cylinders, else the nearest to even."""
    with suppress(OrderError, EngineError):
        if even := even_orders(engine):
            return even
        if len(engine.chambers) <= FEW:
            return possible_orders(engine) or possible_orders(engine, together=True)
        return even_orders(engine, tolerance_deg=unevenness(engine) + SAME_PLACE)
    return ()


def _with_order(tree: Tree, fired: Firing) -> Tree:
    """The file that fires so, with angles where the order alone would leave a choice."""
    out = _with_sources(_without(tree, "firing_angles"), "firing_order", "firing_angles")
    out["firing_order"] = list(fired.order)
    with suppress(EngineFileError):
        own = firing(engine_of(out)).intervals_deg
        if all(isclose(a, b, abs_tol=1e-3) for a, b in zip(own, fired.intervals_deg, strict=True)):
            return out
    out["firing_angles"] = [f"{angle:.9g} deg" for angle in fired.angles_deg]
    return out


def _orders(engine: Engine, tree: Tree) -> tuple[Offer, ...]:
    """The firing orders of the crank, the most even first, and the present one."""
    orders = _possible_orders(engine)
    with suppress(EngineError):
        own = place_of(engine, orders) if engine.firing_order else None
        some = [*orders[:MOST_ORDERS]]
        if own is not None and own >= MOST_ORDERS:
            some = [orders[own], *some[:-1]]
        return tuple(
            Offer(
                _order_text(order.firing),
                _with_order(tree, order.firing),
                own is not None and order is orders[own],
            )
            for order in some
        )
    return ()


def _order_text(fired: Firing) -> str:
    order = "-".join(map(str, fired.order))
    if _is_even(fired, NEARLY):
        return order
    angles = "-".join(number(angle, digits=4) for angle in fired.intervals_deg)
    return f"{order} ({angles}°)"


def _is_even(fired: Firing, share: float = 0.005) -> bool:
    """Whether the intervals differ from their mean by no more than a share of it."""
    mean = fired.cycle_deg / len(fired.order)
    return all(abs(angle - mean) <= share * mean for angle in fired.intervals_deg)


def _cranks(engine: Engine, tree: Tree) -> tuple[Offer, ...]:
    """The present crank and others for as many cylinders, each with a firing order."""
    own = _shape(engine)
    banks = _bank_text(engine, tree["layout"])
    offers = {own: Offer(_crank_label(engine, tree["layout"], banks), tree, chosen=True)}
    tables = layouts_for(engine, tree["layout"], count=len(engine.chambers))
    for layout in islice(tables, MOST_CRANKS + 2):
        with suppress(EngineFileError):
            plain = _without(tree, "firing_order", "firing_angles") | {"layout": layout}
            plain = _with_sources(plain, "layout", "firing_order", "firing_angles")
            other = engine_of(plain)
            if _shape(other) not in offers:
                made = with_best_order(plain)
                offers[_shape(other)] = Offer(_crank_label(other, layout, banks), made)
    return tuple(islice(offers.values(), MOST_CRANKS))


def _shape(engine: Engine) -> tuple[Any, ...]:
    """What is alike of engines that are one but for how they are drawn."""
    pins = [throw for shaft in engine.shafts for throw in shaft.throws]
    first = engine.first.bearing
    turns = tuple(round(degrees(wrapped(pin.angle - pins[0].angle)), 3) % 360 for pin in pins)
    back = tuple(round(-turn, 3) % 360 for turn in turns)
    axes = tuple(
        round(abs(degrees(wrapped(cylinder.bearing - first))), 3) for cylinder in engine.cylinders
    )
    return min(turns, back), axes


def _said(engine: Engine, tree: Tree) -> str:
    """One sentence on what the engine is: cylinders, crank, firing order."""
    count = len(engine.chambers)
    crank = _crank_text(engine, tree["layout"])
    if not engine.firing_order:
        return _n(
            "{count} cylinder, {crank}, without a firing order.",
            "{count} cylinders, {crank}, without a firing order.",
            count,
            count=count,
            crank=crank,
        )
    fired = firing(engine)
    order = "-".join(map(str, fired.order))
    if count == 1:
        return _("One cylinder, {crank}.", crank=crank)
    values = {"count": count, "crank": crank, "order": order}
    mean = number(fired.cycle_deg / count, digits=4)
    if _is_even(fired):
        return _(
            "{count} cylinders, {crank}, firing order {order}, evenly every {interval}°.",
            **values,
            interval=mean,
        )
    if _is_even(fired, NEARLY):
        return _(
            "{count} cylinders, {crank}, firing order {order}, nearly evenly every {interval}°.",
            **values,
            interval=mean,
        )
    return _(
        "{count} cylinders, {crank}, firing order {order}, unevenly at {intervals}°.",
        **values,
        intervals="-".join(number(angle, digits=4) for angle in fired.intervals_deg),
    )


def _crank_label(engine: Engine, layout: Mapping[str, Any], banks: str) -> str:
    """The crank in fewer words: its throws, and the bank angle where it is another one."""
    own = _bank_text(engine, layout)
    parts = [", ".join(_degree_texts(_throw_angles(engine, layout)))]
    parts += [own] if own != banks else []
    return "; ".join([*parts, *_split_text(engine, layout)])


def _crank_text(engine: Engine, layout: Mapping[str, Any]) -> str:
    """The crank in few words: where its throws stand, how the banks stand, whether pins split."""
    angles = _throw_angles(engine, layout)
    throws = _("throws at {angles}", angles=", ".join(_degree_texts(angles)))
    parts = [throws if len(angles) > 1 else _("one throw"), _bank_text(engine, layout)]
    return ", ".join(filter(None, [*parts, *_split_text(engine, layout)]))


def _is_vee(layout: Mapping[str, Any]) -> bool:
    return layout["type"] == "vee" and len(layout["banks"]) == 2


def _bank_text(engine: Engine, layout: Mapping[str, Any]) -> str:
    if not _is_vee(layout):
        return ""
    return _("banks {angle}°", angle=number(abs(bank_angle_deg(engine, layout)), digits=4))


def _split_text(engine: Engine, layout: Mapping[str, Any]) -> list[str]:
    """How far pins are split, if two banks share a list of throws and have pins of their own."""
    pins = len(engine.shafts[0].throws)
    if not _is_vee(layout) or not pins == len(engine.cylinders) > len(layout.get("throws", ())):
        return []
    first, second = (
        next(c for c in engine.cylinders if c.number == bank["cylinders"][0])
        for bank in layout["banks"]
    )
    split = abs(degrees(wrapped(engine.throw(second).angle - engine.throw(first).angle)))
    return [_("pins split by {angle}°", angle=number(split, digits=4))]


def _throw_angles(engine: Engine, layout: Mapping[str, Any]) -> list[float]:
    """Where the throws of the file stand from the first, degrees."""
    given = layout.get("throws")
    pins = engine.shafts[0].throws
    if layout["type"] in ("vee", "boxer") and given and len(given) < len(pins):
        numbers = layout["banks"][0]["cylinders"]
        own = {cylinder.number: engine.throw(cylinder) for cylinder in engine.cylinders}
        pins = tuple(own[number_] for number_ in numbers)
    return [degrees(wrapped(pin.angle - pins[0].angle)) for pin in pins]


def _degree_texts(angles: Iterable[float]) -> list[str]:
    return [f"{number(round(angle, 6) + 0.0, digits=4)}°" for angle in angles]
