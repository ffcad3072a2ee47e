"""The workshop of the page: an engine with what can be changed in it, and layouts to begin with."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from math import degrees
from typing import Any, NamedTuple

from crankstar.engine.copies import wrapped
from crankstar.engine.engine import Engine
from crankstar.files import catalog, engine_of
from crankstar.files.forms import is_explicit
from crankstar.files.mistakes import Tree
from crankstar.files.rearranged import Offer, rearranged, with_best_order
from crankstar.language.messages import N_, _
from crankstar.page.controls import controls
from crankstar.page.workshop_records import OfferShown, Pin, Preset, WorkshopShown


def workshop(tree: Mapping[str, Any], *, cylinders: int | None = None) -> WorkshopShown:
    """An engine as it is, or with another number of cylinders, and what can be changed in it.

    Raises EngineFileError, and EngineError for a number that its layout cannot have.
    """
    made = rearranged(tree, cylinders=cylinders)
    engine = engine_of(made.tree)
    return WorkshopShown(
        tree=made.tree,
        cylinders=made.cylinders,
        fewer=made.fewer,
        more=made.more,
        sentences=made.sentences,
        cranks=_offers(made.cranks),
        orders=_offers(made.orders),
        controls=controls(engine, made.tree),
        pins=tuple(pins(engine, made.tree)),
    )


def _offers(offers: Sequence[Offer]) -> tuple[OfferShown, ...]:
    return tuple(OfferShown(**offer._asdict()) for offer in offers)


def pins(engine: Engine, tree: Mapping[str, Any]) -> Iterator[Pin]:
    """The throws of the first crankshaft that the file can turn, each with its key path.

    Of a star on one pin, and of a file whose throws follow from its firing order, only the latter
    has any: they are written into it where one is turned.
    """
    shaft = engine.shafts[0]
    if is_explicit(tree):
        for index, throw in enumerate(shaft.throws, 1):
            bearing = degrees(throw.angle)
            path = f"shaft[1].throw[{index}].angle"
            yield _pin(path, str(index), bearing, bearing, fixed=False)
        return
    layout = tree["layout"]
    table, before = layout, "layout"
    if layout["type"] == "tandem":
        table, before = layout["cranks"][0], "layout.cranks[1]"
    numbers = _numbers_of_pins(engine, table)
    if layout["type"] == "radial" or len(numbers) < 2:
        return
    own = {cylinder.number: engine.throw(cylinder).angle for cylinder in engine.cylinders}
    base = own[numbers[0]]
    for index, number in enumerate(numbers, 1):
        angle = degrees(wrapped(own[number] - base))
        label = str(index) if len(numbers) <= len(shaft.throws) else str(number)
        path = f"{before}.throws[{index}]"
        yield _pin(path, label, angle, degrees(own[number]), fixed=index == 1)


def _pin(path: str, label: str, angle: float, bearing: float, *, fixed: bool) -> Pin:
    return Pin(
        path=path,
        label=label,
        angle_deg=round(angle, 9) + 0.0,
        bearing_deg=round(bearing, 9) + 0.0,
        fixed=fixed,
    )


def _numbers_of_pins(engine: Engine, table: Mapping[str, Any]) -> list[int]:
    """A cylinder on each throw of a list, in its order."""
    banks = table.get("banks")
    given = table.get("throws", (0,))
    if banks is None:
        return [cylinder.number for cylinder in engine.cylinders][: len(engine.chambers)]
    first = [*banks[0]["cylinders"]]
    if len(given) == len(first):
        return first
    return sorted(number for bank in banks for number in bank["cylinders"])


Make = Callable[[], Tree]


class _Usual(NamedTuple):
    """A usual layout: a label, what it is listed under, and what makes its engine file."""

    label: str
    group: str
    make: Make


IN_LINE, VEE, FLAT, OTHERS = N_("In line"), N_("V"), N_("Boxer"), N_("Radial and others")


def _of_catalog(name: str) -> Tree:
    return catalog.tree_of(name)[1]


def _with_count(name: str, count: int) -> Tree:
    return rearranged(_of_catalog(name), cylinders=count).tree


def _turned(name: str, title: str, **layout: Any) -> Tree:
    """An engine of the catalog with other values in its layout."""
    tree = _of_catalog(name)
    changed = ("firing_order", "notes", "left_out")
    plain = {key: value for key, value in tree.items() if key not in changed}
    sources = {
        path: source
        for path, source in tree.get("provenance", {}).items()
        if not path.startswith(("firing_order", "layout"))
    }
    titled = {**plain, "name": title, "layout": {**tree["layout"], **layout}}
    return with_best_order({**titled, "provenance": sources})


def _two(angle: float) -> Tree:
    """A parallel twin whose second pin stands so far from the first, degrees."""
    return _turned(
        "i2-360", f"Parallel twin, {angle:g} deg", throws=["0 deg", f"{360 - angle:g} deg"]
    )


def _vee_two(angle: float) -> Tree:
    banks = _of_catalog("v2-90")["layout"]["banks"]
    turned = [
        {**bank, "bearing": f"{sign * angle / 2:g} deg"}
        for bank, sign in zip(banks, _signs(banks), strict=True)
    ]
    return _turned("v2-90", f"V-twin, {angle:g} deg", banks=turned)


def _signs(banks: Sequence[Mapping[str, Any]]) -> list[int]:
    return [-1 if str(bank["bearing"]).startswith("-") else 1 for bank in banks]


def _at_bank_angle(name: str, count: int, angle: float, split: float | None) -> Tree:
    """A V engine of so many cylinders at a bank angle: the first crank with this pin split."""
    for offer in rearranged(_with_count(name, count)).cranks:
        layout = offer.tree["layout"]
        axes = [float(str(bank["bearing"]).split()[0]) for bank in layout["banks"]]
        own = abs(float(str(layout.get("pin_split", "0")).split()[0]))
        if abs(abs(axes[0] - axes[1]) - angle) < 1e-3 and (split is None or own == split):
            return {**offer.tree, "name": f"V{count}, {angle:g} deg"}
    raise LookupError(name, count, angle)


USUAL: dict[str, _Usual] = {
    "single": _Usual(N_("Single"), IN_LINE, partial(_of_catalog, "single")),
    "twin-180": _Usual(N_("Twin 180°"), IN_LINE, partial(_two, 180)),
    "twin-270": _Usual(N_("Twin 270°"), IN_LINE, partial(_of_catalog, "i2-270")),
    "twin-360": _Usual(N_("Twin 360°"), IN_LINE, partial(_of_catalog, "i2-360")),
    "triple": _Usual(N_("Triple"), IN_LINE, partial(_of_catalog, "triple-120")),
    "i4": _Usual(N_("Four"), IN_LINE, partial(_of_catalog, "i4")),
    "i5": _Usual(N_("Five"), IN_LINE, partial(_with_count, "i4", 5)),
    "i6": _Usual(N_("Six"), IN_LINE, partial(_of_catalog, "i6")),
    "v2-45": _Usual(N_("V2 45°"), VEE, partial(_vee_two, 45)),
    "v2-60": _Usual(N_("V2 60°"), VEE, partial(_vee_two, 60)),
    "v2-90": _Usual(N_("V2 90°"), VEE, partial(_of_catalog, "v2-90")),
    "v4": _Usual(N_("V4 90°"), VEE, partial(_of_catalog, "v4-90")),
    "v6-60": _Usual(N_("V6 60°"), VEE, partial(_of_catalog, "v6-60-six-throws")),
    "v6-90": _Usual(N_("V6 90°, split"), VEE, partial(_with_count, "v8-cross-plane", 6)),
    "v8-cross": _Usual(N_("V8 cross"), VEE, partial(_of_catalog, "v8-cross-plane")),
    "v8-flat": _Usual(N_("V8 flat"), VEE, partial(_of_catalog, "v8-flat-plane")),
    "v10": _Usual(N_("V10 72°"), VEE, partial(_at_bank_angle, "v8-cross-plane", 10, 72, 0)),
    "v10-90": _Usual(N_("V10 90°"), VEE, partial(_with_count, "v8-cross-plane", 10)),
    "v12": _Usual(N_("V12 60°"), VEE, partial(_of_catalog, "v12-60")),
    "boxer-2": _Usual(N_("Boxer 2"), FLAT, partial(_of_catalog, "boxer-2")),
    "boxer-4": _Usual(N_("Boxer 4"), FLAT, partial(_with_count, "boxer-6", 4)),
    "boxer-6": _Usual(N_("Boxer 6"), FLAT, partial(_of_catalog, "boxer-6")),
    "radial-5": _Usual(N_("Radial 5"), OTHERS, partial(_with_count, "radial-9", 5)),
    "radial-7": _Usual(N_("Radial 7"), OTHERS, partial(_with_count, "radial-9", 7)),
    "radial-9": _Usual(N_("Radial 9"), OTHERS, partial(_of_catalog, "radial-9")),
    "square-four": _Usual(N_("Square four"), OTHERS, partial(_of_catalog, "square-four")),
}
"""Layouts to begin with, by their key."""


def presets() -> tuple[Preset, ...]:
    """The usual layouts, each with its engine file and what a small picture shows."""
    return tuple(_presets())


def _presets() -> Iterator[Preset]:
    for key, usual in USUAL.items():
        tree = usual.make()
        engine = engine_of(tree)
        axes = dict.fromkeys(round(degrees(c.bearing), 3) for c in engine.cylinders)
        pins = [throw for shaft in engine.shafts for throw in shaft.throws]
        yield Preset(
            key=key,
            label=_(usual.label),
            group=_(usual.group),
            tree=tree,
            cylinders=len(engine.chambers),
            axes_deg=tuple(axes),
            throws_deg=tuple(round(degrees(wrapped(pin.angle)), 3) + 0.0 for pin in pins),
            radial=tree["layout"]["type"] == "radial",
            shafts=len(engine.shafts),
        )
