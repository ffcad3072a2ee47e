"""The numbers of an engine that its workshop changes directly: which, between what limits.

Only what its layout has and its file can say is there. A control is a key path as `crankstar sweep`
takes it, `layout.bank_angle` included, and the keys that it sets.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from math import degrees
from typing import Any

from crankstar.engine.engine import Engine
from crankstar.engine.quantities import ANGLE
from crankstar.files import units
from crankstar.files.crank_layouts import bank_angle_deg
from crankstar.files.forms import is_explicit
from crankstar.files.plus_minus import nominal
from crankstar.language.messages import _
from crankstar.page.workshop_records import Control, Setting
from crankstar.studies.numeric_keys import BANK_ANGLE

GREATEST_TO_BALANCE = 3
"""Cylinders up to which a balance factor is worth a slider in every engine."""
BANK_SNAPS = (15.0, 30.0, 45.0, 60.0, 72.0, 75.0, 90.0, 120.0, 180.0)
SPLIT_SNAPS = (-60.0, -30.0, -18.0, 0.0, 18.0, 30.0, 60.0)
PIN_SNAPS = (0.0, 72.0, 76.0, 90.0, 120.0, 144.0, 180.0, 240.0, 270.0, 285.0, 360.0)
_NUMBER = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*(\S.*?)?\s*", re.DOTALL)


def controls(engine: Engine, tree: Mapping[str, Any]) -> tuple[Control, ...]:
    """The direct controls of an engine, as its file `tree` says it.

    >>> from crankstar.files.catalog import load, tree_of
    >>> [each.key for each in controls(load("v2-90"), tree_of("v2-90")[1])][:2]
    ['layout.bank_angle', 'layout.pin_split']
    """
    if is_explicit(tree):
        return tuple(_speed(tree))
    layout = tree["layout"]
    return (
        *_bank_angle(engine, layout),
        *_pin_split(layout),
        *_second_pin(layout),
        *_lags(layout),
        *_balance_factor(engine, tree),
        *_rod(tree),
        *_lengths(tree),
        *_speed(tree),
    )


def _bank_angle(engine: Engine, layout: Mapping[str, Any]) -> Iterator[Control]:
    banks = layout.get("banks", ())
    if layout["type"] != "vee" or len(banks) != 2:
        return
    if not all("bearing" in bank for bank in banks):
        return
    between = bank_angle_deg(engine, layout)
    middle, sign = _degrees(banks[1]["bearing"]) + between / 2, 1.0 if between > 0 else -1.0
    yield Control(
        key=BANK_ANGLE,
        label=_("Bank angle"),
        help=_("between the two banks, about the middle between them"),
        value=round(abs(between), 9),
        unit="deg",
        low=0,
        high=180,
        step=1,
        snaps=BANK_SNAPS,
        sets=tuple(
            Setting(path=f"layout.banks[{place}].bearing", factor=half * sign, added=middle)
            for place, half in ((1, 0.5), (2, -0.5))
        ),
        swept=True,
    )


def _pin_split(layout: Mapping[str, Any]) -> Iterator[Control]:
    banks = layout.get("banks", ())
    shared = len(layout.get("throws", ())) == len(banks[0]["cylinders"]) if banks else False
    if layout["type"] != "vee" or len(banks) != 2 or not shared:
        return
    if any("pin_angle" in bank for bank in banks):
        return
    yield Control(
        key="layout.pin_split",
        label=_("Pin offset"),
        help=_("split pins: how far the second bank's are turned clockwise; 0 is one shared pin"),
        value=_degrees(layout.get("pin_split", 0)),
        unit="deg",
        low=-90,
        high=90,
        step=1,
        snaps=SPLIT_SNAPS,
        sets=(_setting("layout.pin_split"),),
        swept=True,
    )


def _second_pin(layout: Mapping[str, Any]) -> Iterator[Control]:
    throws = layout.get("throws", ())
    if layout["type"] != "inline" or len(throws) != 2:
        return
    yield Control(
        key="layout.throws[2]",
        label=_("Crank pin 2 from pin 1"),
        help=_("clockwise; 0° both pistons rise together, 180° they take turns"),
        value=(_degrees(throws[1]) - _degrees(throws[0])) % 360,
        unit="deg",
        low=0,
        high=360,
        step=1,
        snaps=PIN_SNAPS,
        sets=(_setting("layout.throws[2]", added=_degrees(throws[0])),),
        swept=_degrees(throws[0]) == 0,
    )


def _lags(layout: Mapping[str, Any]) -> Iterator[Control]:
    if layout["type"] == "opposed":
        where = [("layout.lag", layout.get("lag", 0), 40)]
    else:
        where = [
            (f"layout.cranks[{number}].lag", crank.get("lag", 0), 360)
            for number, crank in enumerate(layout.get("cranks", ()), 1)
            if number == 2
        ]
    for path, value, high in where:
        yield Control(
            key=path,
            label=_("Lag of the second crankshaft"),
            help=_("turn of the first crankshaft by which the second follows"),
            value=_degrees(value),
            unit="deg",
            low=0,
            high=high,
            step=1,
            snaps=PIN_SNAPS if high == 360 else (),
            sets=(_setting(path),),
            swept=True,
        )


def _balance_factor(engine: Engine, tree: Mapping[str, Any]) -> Iterator[Control]:
    given = tree.get("balance_factor")
    weighted = any(table.get("weight") for table in tree.get("crankshaft", ()))
    if given is None and (len(engine.cylinders) > GREATEST_TO_BALANCE or weighted):
        return
    yield Control(
        key="balance_factor",
        label=_("Balance factor"),
        help=_("share of the reciprocating mass that the counterweights balance"),
        value=0.0 if given is None else float(given),
        unit="",
        low=0,
        high=1,
        step=0.01,
        snaps=(0.0, 0.25, 0.5, 0.75, 1.0),
        sets=(_setting("balance_factor"),),
        swept=True,
    )


def _rod(tree: Mapping[str, Any]) -> Iterator[Control]:
    cylinder = tree.get("cylinder", {})
    length, stroke = _parsed(cylinder.get("rod_length")), _parsed(cylinder.get("stroke"))
    if length is None:
        ratio = float(cylinder.get("rod_ratio", 4.0))
        yield Control(
            key="cylinder.rod_ratio",
            label=_("Rod ratio"),
            help=_("connecting rod over crank radius, l/r"),
            value=ratio,
            unit="",
            low=min(2.0, ratio),
            high=max(8.0, ratio),
            step=0.05,
            snaps=(),
            sets=(_setting("cylinder.rod_ratio"),),
            swept=True,
        )
    elif stroke is not None and stroke[1] == length[1]:
        radius = stroke[0] / 2
        yield _number(
            "cylinder.rod_length",
            _("Connecting rod"),
            _("between centres; the crank radius is half the stroke"),
            length,
            low=min(2 * radius, length[0]),
            high=max(6 * radius, length[0]),
            swept=True,
        )


def _lengths(tree: Mapping[str, Any]) -> Iterator[Control]:
    """Stroke, bore, and places along the crankshaft, as far as the file gives them."""
    listed: Sequence[tuple[str, str, str, bool]] = (
        ("cylinder.stroke", _("Stroke"), _("twice the crank radius"), False),
        ("cylinder.bore", _("Bore"), _("cylinder diameter"), False),
        ("layout.bore_pitch", _("Bore pitch"), _("between neighbouring cylinders"), True),
        ("layout.bank_offset", _("Bank offset"), _("first bank in front of the second"), True),
    )
    for path, label, about, swept in listed:
        table, key = path.split(".")
        value = _parsed(tree.get(table, {}).get(key))
        if value is None or not value[0]:
            continue
        size = abs(value[0])
        yield _number(path, label, about, value, low=0.5 * size, high=2 * size, swept=swept)


def _number(
    path: str,
    label: str,
    about: str,
    value: tuple[float, str],
    *,
    low: float,
    high: float,
    swept: bool,
) -> Control:
    return Control(
        key=path,
        label=label,
        help=about,
        value=value[0],
        unit=value[1],
        low=float(f"{low:.3g}"),
        high=float(f"{high:.3g}"),
        step=float(f"{(high - low) / 200:.1g}"),
        snaps=(),
        sets=(_setting(path),),
        swept=swept and value[0] > 0,
    )


def _speed(tree: Mapping[str, Any]) -> Iterator[Control]:
    value = _parsed(tree.get("speed"))
    if value is None:
        return
    about = _("at which forces are quoted")
    low, high = 0.1 * value[0], 2 * value[0]
    yield _number("speed", _("Speed"), about, value, low=low, high=high, swept=False)


def _setting(path: str, *, added: float = 0.0) -> Setting:
    return Setting(path=path, factor=1.0, added=added)


def _degrees(value: Any) -> float:
    """An angle of a file in degrees; a bare number is in radians."""
    angle = units.without_tolerance(value, ANGLE) if isinstance(value, str) else float(value)
    return round(degrees(angle), 9) + 0.0 if angle else 0.0


def _parsed(value: Any) -> tuple[float, str] | None:
    """A number and its unit as a file gives them, None where it does not."""
    value = nominal(value)
    if isinstance(value, int | float) and not isinstance(value, bool):
        return float(value), ""
    match = _NUMBER.fullmatch(value) if isinstance(value, str) else None
    return (float(match[1]), match[2] or "") if match else None
