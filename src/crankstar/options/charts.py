"""The options of a figure from the words of a command line."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import partial
from types import ModuleType
from typing import Any, get_args

from crankstar.engine.engine import Engine
from crankstar.engine.quantities import Quantity
from crankstar.engine.torsion import Chain
from crankstar.files import units
from crankstar.language.messages import N_, _
from crankstar.options import points
from crankstar.options import values as request
from crankstar.options.forms import PICTURES, form_of, refuse_terminal, require
from crankstar.options.refusals import refusal, together

GREATEST_ANGLES = 24
"""Panels of one figure."""


def charts() -> ModuleType:
    """The room of the figures. Raises RequestError where vl-convert is not installed."""
    require("chart")
    from crankstar import charts

    return charts


def suffix(path: str | None, possible: tuple[str, ...] = PICTURES) -> str:
    """The format of a figure by the name of its file, SVG without one. Raises RequestError."""
    refuse_terminal(path, possible)
    return form_of(path, possible)


def options(
    figure: Any,
    engine: Engine | Chain | None,
    *,
    orders: str | None,
    quantity: str | None,
    model: str | None,
    theta: str | None,
    speed: str | None,
    reference: str | None,
    speeds: str | None = None,
    gas: bool = False,
    point: str | None = None,
    off: str | None = None,
    at: str | None = None,
    alone: bool = True,
) -> dict[str, Any]:
    """The options of a figure by keyword. Raises RequestError for those that it does not take.

    A single engine (`alone`) is drawn at the speed of its file by default. Where the figure or the
    engine is refused itself (None), what would be wrong in any is refused.
    """
    takes: set[str] = set() if figure is None else set(figure.options)
    given = {
        "--orders": (orders, {"order", "orders"}),
        "--quantity": (quantity, {"quantity"}),
        "--model": (model, {"model"}),
        "--theta": (theta, {"theta", "angles"}),
        "--speed": (speed, {"speed"}),
        "--speeds": (speeds, {"speeds"}),
        "--reference": (reference, {"reference"}),
        "--gas": ("" if gas else None, {"gas"}),
        "--point": (point, {"point"}),
        "--off": (off, {"off"}),
        "--at": (at, {"at"}),
    }
    unused = {
        option: text for option, (text, names) in given.items() if figure and not names & takes
    }
    texts = {
        option: text
        for option, (text, _names) in given.items()
        if text is not None and option not in unused
    }
    readers: dict[str, Callable[[str], dict[str, Any]]] = {
        "--orders": partial(_orders, figure),
        "--quantity": partial(_quantity, figure),
        "--model": lambda text: {"model": _model(text)},
        "--theta": partial(_angles, figure),
        "--speed": lambda text: {"speed": request.speed(text)},
        "--speeds": lambda text: {"speeds": request.speeds(text)},
        "--reference": partial(_reference, engine),
        "--gas": lambda _text: {},
        "--point": lambda text: {"point": text},
        "--off": lambda text: {"off": request.cylinders_off(text)},
        "--at": partial(_at, engine),
    }
    chart = "" if figure is None else figure.name
    _used, *read = together(
        partial(request.refuse_unused, unused, beside=_("the chart {chart}", chart=chart)),
        *(partial(readers[option], text) for option, text in texts.items()),
    )
    out: dict[str, Any] = {}
    for own in read:
        out |= own
    if "speed" in takes and speed is None:
        at_point = "point" in takes and ("gas" not in takes or gas or point is not None)
        out["speed"] = engine.speed if engine and alone and not at_point else None
    if "gas" in takes and (gas or point is not None or off is not None):
        out["gas"] = True
    return out


def _orders(figure: Any, text: str) -> dict[str, Any]:
    """The one order of a figure, or its several."""
    wanted = request.orders(text, [])
    if figure is None:
        return {}
    if "order" in figure.options and (not wanted or len(wanted) > 1):
        raise refusal("--orders", text, "{chart} takes one order, such as 2", chart=figure.name)
    if not wanted:
        raise refusal("--orders", text, "{chart} takes orders, such as 1,2", chart=figure.name)
    return {"order": wanted[0]} if "order" in figure.options else {"orders": wanted}


def _quantity(figure: Any, text: str) -> dict[str, Any]:
    """The quantity of a figure, of those that it has."""
    return {"quantity": figure and request.choice("--quantity", text, figure.quantities)}


def _reference(engine: Engine | Chain | None, text: str) -> dict[str, Any]:
    """The point of reference of an engine."""
    if isinstance(engine, Chain):
        return {}
    return {"reference": points.reference(text, engine)}


def _at(engine: Engine | Chain | None, text: str) -> dict[str, Any]:
    """The point of the block of an engine."""
    return {"at": points.block_point(text, engine)} if isinstance(engine, Engine) else {}


def _angles(figure: Any, theta: str) -> dict[str, Any]:
    """The one crank angle of a figure, or its several."""
    angles = request.angles(theta)
    if figure is None:
        return {}
    most = 1 if "theta" in figure.options else GREATEST_ANGLES
    if not 1 <= len(angles) <= most:
        raise refusal(
            "--theta",
            theta,
            N_('{chart} takes up to {most} crank angles, such as "30 deg"')
            if most > 1
            else N_('{chart} takes one crank angle, such as "30 deg"'),
            chart=figure.name,
            most=most,
        )
    return {"theta": angles[0]} if "theta" in figure.options else {"angles": angles}


def _model(text: str) -> str:
    """The model of a shaft on its bearings."""
    from crankstar.dynamics.bearings import Model

    return request.choice("--model", text, get_args(Model))


def paper(
    suffix: str,
    *,
    theme: str | None,
    width: str | None,
    height: str | None,
    dpi: float | None,
    font_size: str | None,
) -> Any:
    """The paper of a figure. Raises RequestError, also for sizes that the form does not have.

    The suffix is empty where it is refused itself.
    """
    from crankstar.charts.paper import Paper
    from crankstar.charts.themes import THEMES

    texts = {"--width": width, "--height": height, "--font-size": font_size}
    sized = suffix in ("svg", "png", "pdf", "")
    resolution = {"--dpi": dpi and f"{dpi:g}"}
    readings: dict[str, Callable[[], Any]] = {}
    if theme is not None:
        readings["theme"] = partial(request.choice, "--theme", theme, THEMES)
    if width is not None:
        readings["width"] = partial(_side, "--width", width)
    if height is not None:
        readings["height"] = partial(_side, "--height", height)
    if dpi is not None:
        readings["dpi"] = partial(_within, "--dpi", dpi, DPI)
    if font_size is not None:
        readings["font_size"] = lambda: _within("--font-size", _points(font_size), LETTERS)
    _sized, _resolved, *read = together(
        partial(request.refuse_unused, {} if sized else texts, beside=f".{suffix}"),
        partial(
            request.refuse_unused, {} if suffix in ("png", "") else resolution, beside=f".{suffix}"
        ),
        *readings.values(),
    )
    given: dict[str, Any] = dict(zip(readings, read, strict=True))
    drawn = Paper(**given)
    side = max(drawn.width or 0.0, drawn.height or 0.0)
    if suffix == "png" and side / INCH * drawn.dpi > MOST_PIXELS:
        raise refusal(
            "--dpi",
            f"{drawn.dpi:g}",
            "a picture of this size has at most {most} dots per inch",
            most=f"{int(MOST_PIXELS * INCH / side)}",
        )
    return drawn


def _within(option: str, value: float, limits: tuple[float, float]) -> float:
    """A number between these two. Raises RequestError."""
    if not limits[0] <= value <= limits[1]:
        raise refusal(
            option,
            f"{value:g}",
            "give a number from {least} to {most}",
            least=f"{limits[0]:g}",
            most=f"{limits[1]:g}",
        )
    return value


def _points(text: str) -> float:
    """The size of letters in points, with their unit or without."""
    match = re.fullmatch(r"\s*(\d+(?:\.\d*)?)\s*(pt|points?)?\s*", text)
    if match is None:
        raise refusal("--font-size", text, 'give a number of points, such as 9 or "9 pt"')
    return float(match[1])


def _side(option: str, text: str) -> float:
    """A side of a picture, m."""
    with request.reading(option):
        side = 0.0 if units.is_bare(text) else units.si(text, PAGE)
    if not SIDES[0] <= side <= SIDES[1]:
        raise refusal(option, text, "give a length from 20 mm to 2 m, such as 120 mm or 5 in")
    return side


PAGE = Quantity("length", "120 mm")
"""A side of a picture."""
INCH, MOST_PIXELS = 0.0254, 12_000
"""Metres; the most pixels of a side that is given."""
DPI, LETTERS, SIDES = (36.0, 2400.0), (8.0, 72.0), (0.02, 2.0)
"""The least and the greatest resolution, letters (pt) and side of a picture (m)."""
