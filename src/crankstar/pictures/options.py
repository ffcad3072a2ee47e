"""The options of a drawn engine from the words of a command line."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import partial
from typing import Any

from crankstar.language.messages import N_, _
from crankstar.options import values as request
from crankstar.options.refusals import once, refusal, together
from crankstar.pictures.arrows import KINDS
from crankstar.pictures.drawings import Picture
from crankstar.pictures.films import Pace
from crankstar.pictures.palettes import PALETTES
from crankstar.pictures.panes import SIGHTS

PRINT = "print"
"""A theme of charts; drawings are printed in their light colours."""
SIDES, SQUARE = (64, 4096), 4096 * 2304
"""The least and the greatest side of a picture, px, and the most px that it has."""
SECONDS, RATES = (0.2, 60.0), (2.0, 60.0)
"""Of a turn, and pictures in a second: the least and the greatest."""
GREATEST_FILM = 3000
"""Pictures of a film."""
FASTEST_GIF = 50.0
"""Pictures of a GIF in a second: the times in it are hundredths."""


def picture(
    *, view: str | None, size: str | None, theme: str | None, arrows: str | None, orders: str | None
) -> Picture:
    """A Picture. Raises RequestError."""
    readings: dict[str, Callable[[], Any]] = {}
    if view is not None:
        readings["view"] = partial(request.choice, "--view", view, SIGHTS)
    if theme is not None:
        readings["theme"] = partial(_theme, theme)
    if size is not None:
        sides = once(partial(_size, size))
        readings |= {"width": lambda: sides()[0], "height": lambda: sides()[1]}
    if arrows is not None:
        readings["arrows"] = partial(_arrows, arrows)
    if orders is not None and orders.strip() != "all":
        readings["orders"] = lambda: tuple(request.orders(orders, []) or ())
    return Picture(**dict(zip(readings, together(*readings.values()), strict=True)))


def _theme(text: str) -> str:
    named = request.choice("--theme", text, (*PALETTES, PRINT))
    return "light" if named == PRINT else named


def _arrows(text: str) -> tuple[str, ...]:
    words = [] if text.strip() == "none" else [word.strip() for word in text.split(",")]
    if len(words) > 1 and "none" in words:
        raise request.refusal("--arrows", text, "none stands alone; leave the others out")
    return tuple(request.choice("--arrows", word, (*KINDS, "none")) for word in words)


def _size(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"\s*(\d{1,6})\s*[x×*, ]\s*(\d{1,6})\s*(?:px)?\s*", text)
    if match is None:
        raise refusal("--size", text, "give width and height in pixels, as in 720x540")
    width, height = int(match[1]), int(match[2])
    if not all(SIDES[0] <= side <= SIDES[1] for side in (width, height)):
        raise refusal(
            "--size", text, "each side has {least} to {most} pixels", least=SIDES[0], most=SIDES[1]
        )
    if width * height > SQUARE:
        raise refusal("--size", text, N_("a picture has at most as many pixels as 4096x2304"))
    return width, height


def pace(kind: str, *, seconds: float | None, rate: float | None, turns: int) -> Pace:
    """The Pace of a film of a cycle of so many turns. Raises RequestError."""
    usual = Pace()
    given = Pace(
        *together(
            lambda: usual.seconds if seconds is None else _within("--seconds", seconds, SECONDS),
            lambda: usual.rate if rate is None else _within("--frames-per-second", rate, RATES),
        )
    )
    if kind == "gif" and given.rate > FASTEST_GIF:
        raise refusal(
            "--frames-per-second",
            f"{given.rate:g}",
            "a GIF has at most {most} in a second; take .webp or .mp4",
            most=f"{FASTEST_GIF:g}",
        )
    if turns * given.seconds * given.rate > GREATEST_FILM:
        raise refusal(
            "--seconds",
            f"{given.seconds:g}",
            "the film would have more than {most} pictures; give a shorter turn, or fewer pictures "
            "in a second",
            most=GREATEST_FILM,
        )
    return given


def _within(option: str, value: float, limits: tuple[float, float]) -> float:
    if not limits[0] <= value <= limits[1]:
        raise refusal(
            option,
            f"{value:g}",
            "give a number from {least} to {most}",
            least=f"{limits[0]:g}",
            most=f"{limits[1]:g}",
        )
    return value


def angle(theta: str | None) -> float:
    """The one crank angle of a drawing, radians. Raises RequestError."""
    angles = request.angles(theta)
    if len(angles) > 1:
        raise refusal("--theta", theta, _('give one crank angle, such as "30 deg"'))
    return angles[0] if angles else 0.0
