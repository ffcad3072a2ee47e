"""The options of a balance, read from text: weights, what they minimise, balance shafts."""

from __future__ import annotations

import re
from collections.abc import Sequence
from fractions import Fraction
from math import isfinite
from typing import cast, get_args

from crankstar.dynamics.bearings import Model
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import COUPLE, FORCE, LENGTH, UNBALANCE
from crankstar.files import bare_numbers, units
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.mechanics.balance import scales, unit_unbalance
from crankstar.options.points import length, places, planes
from crankstar.options.refusals import choice, refusal, refuse_unused
from crankstar.options.values import bounded, fractions, not_positive, reading
from crankstar.remedy import Aim, Box, Limit, Plane, aim_unit, without_weights
from crankstar.remedy.counterweights import GREATEST_FACTOR, LEAST_FACTOR
from crankstar.remedy.fitting import Places, ShaftPlaces, Wanted
from crankstar.studies.ranges import dotted

HALF = 0.5
"""The balance factor where neither the file nor an option gives one."""


def weights(text: str, engine: Engine) -> list[Plane] | Places:
    """The place of counterweights: pins, all webs, end webs, or planes of every crankshaft."""
    word = text.strip().lower()
    if word in get_args(Places):
        return cast("Places", word)
    if not any(letter.isdigit() for letter in text):
        raise refusal(
            "--weights",
            text,
            'it can be pins, webs, ends, or places along the shaft as in "-200 mm, 200 mm"',
        )
    cranks = [shaft.name for shaft in engine.shafts if shaft.throws]
    return [Plane(name, z) for name in cranks for z in planes("--weights", text, engine)]


def aim(option: str, text: str, *, pitch: float | None = None) -> Aim:
    """The quantity that weights minimise; `pitch` is its share in a couple, yaw has the rest."""
    wanted = _of_order(option, text) or AIMS.get(" ".join(text.lower().split()))
    if wanted is None:
        raise refusal(
            option,
            text,
            "choose from {choices}; or one order, as in {orders}",
            choices=", ".join(AIMS),
            orders=", ".join([*(f"{name} 1" for name in ONE_ORDER), *MAKERS]),
        )
    if pitch is None:
        return wanted
    if not 0 <= pitch <= 1:
        raise refusal(
            "--pitch-share",
            f"{pitch:g}",
            "give the share of pitch from 0 (only yaw counts) to 1 (only pitch)",
        )
    if wanted not in (AIMS["couple"], AIMS["rms couple"]):
        refuse_unused({"--pitch-share": pitch}, beside=f"--minimise {text}")
    return wanted._replace(up=2 * pitch, right=2 * (1 - pitch))


AIMS = {
    "force": Aim("force"),
    "couple": Aim("couple"),
    "rms force": Aim("force", rms=True),
    "rms couple": Aim("couple", rms=True),
    "pitch": Aim("couple", up=1.0, right=0.0),
    "yaw": Aim("couple", up=0.0, right=1.0),
    "rms pitch": Aim("couple", rms=True, up=1.0, right=0.0),
    "rms yaw": Aim("couple", rms=True, up=0.0, right=1.0),
    "roll": Aim("roll"),
    "rms roll": Aim("roll", rms=True),
    "bearing": Aim("bearing"),
}
ONE_ORDER = ("force", "couple", "pitch", "yaw", "roll")
"""Quantities of which one order can be named, as in `roll 2`."""
MAKERS = {
    "M1": "couple",
    "M1V": "pitch",
    "M1H": "yaw",
    "F1": "force",
    "F1V": "vertical force",
    "F1H": "horizontal force",
}
"""One order as makers of large engines write it, and as `search` does."""
_FORCES = {
    "vertical force": Aim("force", up=1.0, right=0.0),
    "horizontal force": Aim("force", up=0.0, right=1.0),
}
_ORDER = r"(\d{1,3}(?:\.\d{1,3})?)"
_OF_ORDER = re.compile(rf"({'|'.join(ONE_ORDER)}) {_ORDER}")
_BY_MAKERS = re.compile(rf"([mf]){_ORDER}([vh]?)")


def _of_order(option: str, text: str) -> Aim | None:
    """The peak of one order, None where the text is none.

    >>> _of_order("", "M2V") == _of_order("", "pitch 2") == AIMS["pitch"]._replace(order=2.0)
    True
    """
    words = " ".join(text.lower().split())
    if (found := _OF_ORDER.fullmatch(words)) is not None:
        name, order = found[1], float(found[2])
    elif (found := _BY_MAKERS.fullmatch(words)) is not None:
        name, order = MAKERS[f"{found[1]}1{found[3]}".upper()], float(found[2])
    else:
        return None
    if not order:
        raise refusal(option, text, "give an order above 0, as in {example}", example="pitch 1")
    return {**AIMS, **_FORCES}[name]._replace(order=order)


def model(text: str | None) -> Model:
    """How main bearings share a load, by default hinged at each."""
    if text is None:
        return "determinate"
    return cast("Model", choice("--model", text, get_args(Model)))


def limits(
    texts: Sequence[str], engine: Engine, *, speed: float | None, model: Model = "determinate"
) -> list[Limit]:
    """Limits such as couple=1.5 (m r w^2 a), couple=50% (of bare crankshafts) or force="500 N".

    Newtons need a speed; a share of a bearing load is that of the `model`.
    """
    out: list[Limit] = []
    for text in texts:
        name, value = bounded(text)
        if not value:
            raise refusal(
                "--limit", text, 'give a quantity and its limit, as in couple=50% or force="500 N"'
            )
        wanted = aim("--limit", name)
        if wanted in [limit.aim for limit in out]:
            raise refusal(
                "--limit", text, "{name} already has a limit; give one", name=name.strip()
            )
        at_most = _at_most(wanted, value, text, engine, speed, model)
        out.append(Limit(wanted, at_most))
    return out


def _at_most(
    wanted: Aim, value: str, text: str, engine: Engine, speed: float | None, model: Model
) -> float:
    """A limit in the unit of its quantity."""
    percent = value.removesuffix("%").strip()
    plain = r"[-+]?(\d+(\.\d*)?|\.\d+)(e[-+]?\d{1,3})?|nan|inf"
    real = re.fullmatch(plain, percent.lower()) is None
    couple, moment = wanted.quantity == "couple", wanted.quantity in ("couple", "roll")
    if real:
        example = _("a bare number of {unit} or a share in %", unit=aim_unit(wanted))
        with reading(f"--limit {one_line(text)}", example=example):
            number = units.si(value, COUPLE if moment else FORCE)
        if {"mass", "radius", *(["pitch"] if couple else [])} & {*engine.relative}:
            raise refusal(
                "--limit",
                text,
                "the masses and sizes of this engine are not known; give a number of m r ω²",
            )
        if speed is None:
            raise refusal("--limit", text, "newtons need a speed, as in --speed '6000 rpm'")
        scale = scales(engine, None)[0]
        own = {"couple": scale.couple, "roll": scale.moment}.get(wanted.quantity, scale.force)
        number *= own / speed**2
    else:
        number = float(percent)
        if "%" in value:
            number *= without_weights(engine, wanted, model=model) / 100
    if not (isfinite(number) and number >= 0):
        raise refusal("--limit", text, "give a number from 0 up")
    return number


def factor(text: str) -> float:
    """A balance factor: a number, or a percentage. Raises RequestError.

    >>> factor("0.52") == factor("52%") == factor("52 %")
    True
    """
    typed = text.strip().removesuffix("%").strip()
    if re.fullmatch(r"[-+]?(\d{1,9}(\.\d*)?|\.\d+)", typed) is None:
        raise refusal("--factor", text, "give a share of the reciprocating mass, as in 0.5 or 52%")
    number = float(typed) / (100 if "%" in text else 1)
    if LEAST_FACTOR <= number <= GREATEST_FACTOR:
        return number
    if 10 <= number <= 100 * GREATEST_FACTOR and "%" not in text:
        raise refusal(
            "--factor",
            text,
            "that is {number} times the reciprocating mass; for {number} % write {percent} or "
            "{share}",
            number=f"{number:g}",
            percent=f"{number:g}%",
            share=f"{number / 100:g}",
        )
    raise refusal(
        "--factor",
        text,
        "give a share of the reciprocating mass from {least} to {greatest}",
        least=f"{LEAST_FACTOR:g}",
        greatest=f"{GREATEST_FACTOR:g}",
    )


def unbalance(option: str, text: str | None, engine: Engine) -> float | None:
    """An unbalance in m r of the first cylinder."""
    if text is None:
        return None
    with reading(option):
        value = bare_numbers.reader(frozenset(engine.relative))(text, UNBALANCE)
    if not value > 0:
        raise not_positive(option, text, UNBALANCE)
    return value / unit_unbalance(engine)


def ratios(text: str) -> list[Fraction] | Wanted:
    """Speed ratios of balance shafts, or that those the engine needs are wanted."""
    word = text.strip().lower()
    if word in get_args(Wanted):
        return cast("Wanted", word)
    values = fractions(text, most=8)
    if not values:
        raise refusal(
            "--shafts",
            text,
            'give speed ratios with commas, negative against the crank, as in -1 or "2, -2"; or '
            "needed, or all",
        )
    return values


def shaft_planes(text: str | None, engine: Engine) -> tuple[float, ...] | None:
    """Where the weights of balance shafts stand along them, if that is given."""
    return None if text is None else tuple(planes("--shaft-planes", text, engine))


def box(text: str, engine: Engine) -> Box:
    """The places open to a balance shaft: up and right of the crankshaft, each from .. to."""
    parts = [part.strip() for part in dotted(text, f"--box {one_line(text)}").split(",")]
    example = _('as in "-120..-60 mm, -80..80 mm"')
    if len(parts) != 2:
        raise refusal("--box", text, "give up and right, {example}", example=example)
    up, right = (_reach(part, engine, example) for part in parts)
    return Box(up, right)


def _reach(text: str, engine: Engine, example: str) -> tuple[float, float]:
    """Two lengths, or one for both; the first may have the unit of the second."""
    first, dots, second = (part.strip() for part in text.partition(".."))
    if not dots:
        second = first
    elif units.is_bare(first) and not units.is_bare(second):
        first = f"{first} {units.unit_of(second)}"
    least, most = places("--box", [first, second], [LENGTH, LENGTH], engine, example)
    if least > most:
        raise refusal(
            "--box",
            text,
            'give the smaller length first, as in "{turned}"',
            turned=f"{second}..{first}",
        )
    return least, most


def shaft_places(
    engine: Engine, *, planes_text: str | None, place: str | None, spacing: str | None
) -> ShaftPlaces:
    """Where balance shafts lie and their weights on them."""
    along = shaft_planes(planes_text, engine)
    up, right = shaft_place(place, engine)
    return ShaftPlaces(along, up, right, length("--shaft-spacing", spacing, engine) or 0.0)


def shaft_place(text: str | None, engine: Engine) -> tuple[float, float]:
    """Where balance shafts lie, up and right of the crankshaft. Raises RequestError."""
    parts = [part.strip() for part in (text or "0, 0").split(",")]
    example = _('as in "-60 mm, 0 mm"')
    if len(parts) != 2:
        raise refusal("--shaft-place", text, "give up and right, {example}", example=example)
    up, right = places("--shaft-place", parts, [LENGTH, LENGTH], engine, example)
    return up, right
