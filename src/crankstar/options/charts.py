"""The options of a figure from the words of a command line."""

from __future__ import annotations

import re
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
from crankstar.options.values import refusal

GREATEST_ANGLES = 24
"""Panels of one figure."""


def charts() -> ModuleType:
    """The room of the figures. Raises RequestError where vl-convert is not installed."""
    require("chart")
    from crankstar import charts

    return charts


def suffix(place: str | None, possible: tuple[str, ...] = PICTURES) -> str:
    """The format of a figure by the name of its file, SVG without one. Raises RequestError."""
    refuse_terminal(place, possible)
    return form_of(place, possible)


def options(
    figure: Any,
    engine: Engine | Chain,
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

    A single engine (`alone`) is drawn at the speed of its file by default.
    """
    takes = set(figure.options)
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
    unused = {option: text for option, (text, names) in given.items() if not names & takes}
    request.refuse_unused(unused, beside=_("the chart {chart}", chart=figure.name))
    out: dict[str, Any] = {}
    if orders is not None:
        wanted = request.orders(orders, [])
        if "order" in takes and (not wanted or len(wanted) > 1):
            raise refusal(
                "--orders", orders, "{chart} takes one order, such as 2", chart=figure.name
            )
        if not wanted:
            raise refusal(
                "--orders", orders, "{chart} takes orders, such as 1,2", chart=figure.name
            )
        out |= {"order": wanted[0]} if "order" in takes else {"orders": wanted}
    if quantity is not None:
        out["quantity"] = request.choice("--quantity", quantity, figure.quantities)
    if model is not None:
        out["model"] = _model(model)
    if theta is not None:
        out |= _angles(figure, theta)
    if "speed" in takes:
        at_point = "point" in takes and ("gas" not in takes or gas or point is not None)
        own = engine.speed if alone and not at_point else None
        out["speed"] = own if speed is None else request.speed(speed)
    if speeds is not None:
        out["speeds"] = request.speeds(speeds)
    if reference is not None and isinstance(engine, Engine):
        out["reference"] = points.reference(reference, engine)
    if at is not None and isinstance(engine, Engine):
        out["at"] = points.block_point(at, engine)
    if "gas" in takes and (gas or point is not None or off is not None):
        out["gas"] = True
    if point is not None:
        out["point"] = point
    if off is not None:
        out["off"] = request.cylinders_off(off)
    return out


def _angles(figure: Any, theta: str) -> dict[str, Any]:
    """The one crank angle of a figure, or its several."""
    angles = request.angles(theta)
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
    """The paper of a figure. Raises RequestError, also for sizes that the form does not have."""
    from crankstar.charts.paper import Paper
    from crankstar.charts.themes import THEMES

    sized = suffix in ("svg", "png", "pdf")
    texts = {"--width": width, "--height": height, "--font-size": font_size}
    request.refuse_unused({} if sized else texts, beside=f".{suffix}")
    resolution = {"--dpi": dpi and f"{dpi:g}"}
    request.refuse_unused({} if suffix == "png" else resolution, beside=f".{suffix}")
    given: dict[str, Any] = {}
    if theme is not None:
        given["theme"] = request.choice("--theme", theme, THEMES)
    for name, text in (("width", width), ("height", height)):
        if text is not None:
            given[name] = _side(f"--{name}", text)
    letters = None if font_size is None else _points(font_size)
    for name, value, limits in (("dpi", dpi, DPI), ("font_size", letters, LETTERS)):
        if value is None:
            continue
        if not limits[0] <= value <= limits[1]:
            raise refusal(
                f"--{name.replace('_', '-')}",
                f"{value:g}",
                "give a number from {least} to {most}",
                least=f"{limits[0]:g}",
                most=f"{limits[1]:g}",
            )
        given[name] = value
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
