"""The speeds of --speeds."""

from __future__ import annotations

from crankstar.options.refusals import RequestError, refusal
from crankstar.options.values import speed as read_speed
from crankstar.options.values import speeds as read_speeds


def speeds_of(text: str | None, *, beside_speed: bool = True) -> list[float]:
    """The speeds of --speeds, rad/s. Raises RequestError or SweepError.

    `beside_speed`: the verb has --speed too, which is named to who gives one speed.
    """
    if text is not None and beside_speed:
        refuse_one(text)
    return [] if text is None else read_speeds(text)


def refuse_one(text: str) -> None:
    """Refuse a text that is one speed. Raises RequestError."""
    try:
        turning = read_speed(text)
    except RequestError:
        return
    if turning is not None:
        raise refusal(
            "--speeds",
            text,
            'this is one value, which --speed takes; give two or more here, as in "600..6000 rpm '
            'by 200"',
        )
