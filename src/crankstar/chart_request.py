"""What the words of a command line ask of a figure: which options it takes, and as what it is written."""

from __future__ import annotations

import sys
from pathlib import PurePath
from types import ModuleType
from typing import Any

from crankstar import request
from crankstar.engine import Engine
from crankstar.quantity import one_line
from crankstar.request import RequestError


def charts() -> ModuleType:
    """The figures, with what they need to be drawn. Raises RequestError where that is not installed."""
    try:
        import altair
        import vl_convert
    except ImportError as error:
        raise RequestError(f'figures are drawn with Altair and vl-convert ({error}): pip install "crankstar[charts]"') from None
    del altair, vl_convert
    from crankstar import charts

    return charts


def suffix(place: str | None, possible: tuple[str, ...]) -> str:
    """As what a figure is written: by the name of its file; into a pipe as SVG. Raises RequestError."""
    named = ", ".join(f".{one}" for one in possible)
    if place is None or place in ("-", "/dev/stdout"):
        if sys.stdout is not None and sys.stdout.isatty():
            raise RequestError(f"a figure cannot be shown in a terminal; name a file with -o that ends in {named}")
        return "svg"
    found = PurePath(place).suffix.lower().removeprefix(".")
    if found not in possible:
        raise RequestError(f"-o {one_line(place)}: is not the name of a figure; let it end in {named}")
    return found


def options(
    figure: Any,
    engine: Engine,
    *,
    order: str | None,
    quantity: str | None,
    theta: str | None,
    speed: str | None,
    reference: str | None,
    alone: bool = True,
) -> dict[str, Any]:
    """The options of a figure by keyword; what it does not take is refused. Raises RequestError.

    `alone`: one engine is drawn, and at the speed of its file unless another is given; engines side by side are not.
    """
    takes = set(figure.options)
    said = {
        "--order": order if not {"order", "orders"} & takes else None,
        "--quantity": quantity if "quantity" not in takes else None,
        "--theta": theta if not {"theta", "angles"} & takes else None,
        "--speed": speed if "speed" not in takes else None,
        "--reference": reference if "reference" not in takes else None,
    }
    request.alone(figure.name, said)
    out: dict[str, Any] = {}
    if order is not None:
        wanted = request.orders(order, [])
        if not wanted or ("order" in takes and len(wanted) > 1):
            what = "one order" if "order" in takes else "orders"
            raise RequestError(f"--order {one_line(order)}: {figure.name} takes {what}, as in 2")
        out |= {"order": wanted[0]} if "order" in takes else {"orders": wanted}
    if quantity is not None:
        if quantity not in figure.quantities:
            raise RequestError(f"--quantity {one_line(quantity)}: {figure.name} can show {', '.join(figure.quantities)}")
        out["quantity"] = quantity
    if theta is not None:
        angles = request.angles(theta, option="--theta")
        if not angles or ("theta" in takes and len(angles) > 1) or len(angles) > GREATEST_ANGLES:
            what = "one crank angle" if "theta" in takes else f"up to {GREATEST_ANGLES} crank angles"
            raise RequestError(f'--theta {one_line(theta)}: {figure.name} takes {what}, as in "30 deg"')
        out |= {"theta": angles[0]} if "theta" in takes else {"angles": angles}
    if "speed" in takes:
        out["speed"] = request.speed(speed) if speed is not None else engine.speed if alone else None
    if reference is not None:
        out["reference"] = request.reference(reference, engine)
    return out


GREATEST_ANGLES = 24
"""Panels of one figure."""
