"""The options of a figure, and the format of its file, from the words of a command line."""

from __future__ import annotations

import sys
from pathlib import PurePath
from types import ModuleType
from typing import Any

from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.options import values as request
from crankstar.options.values import RequestError


def charts() -> ModuleType:
    """The room of the figures. Raises RequestError where vl-convert is not installed."""
    try:
        import vl_convert
    except ImportError as error:
        raise RequestError(
            _('charts need vl-convert ({error}): pip install "crankstar[charts]"', error=error)
        ) from None
    del vl_convert
    from crankstar import charts

    return charts


def suffix(place: str | None, possible: tuple[str, ...]) -> str:
    """The format of a figure by the name of its file, SVG in a pipe. Raises RequestError."""
    endings = ", ".join(f".{kind}" for kind in possible)
    if place is None or place in ("-", "/dev/stdout"):
        if sys.stdout is not None and sys.stdout.isatty():
            raise RequestError(
                _(
                    "a terminal cannot show charts; give a file with -o that ends in {endings}",
                    endings=endings,
                )
            )
        return "svg"
    found = PurePath(place).suffix.lower().removeprefix(".")
    if found not in possible:
        raise RequestError(
            _("-o {file}: must end in {endings}", file=one_line(place), endings=endings)
        )
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
    """The options of a figure by keyword. Raises RequestError for those that it does not take.

    A single engine (`alone`) is drawn at the speed of its file by default.
    """
    takes = set(figure.options)
    refused = {
        "--order": order if not {"order", "orders"} & takes else None,
        "--quantity": quantity if "quantity" not in takes else None,
        "--theta": theta if not {"theta", "angles"} & takes else None,
        "--speed": speed if "speed" not in takes else None,
        "--reference": reference if "reference" not in takes else None,
    }
    request.alone(figure.name, refused)
    out: dict[str, Any] = {}
    if order is not None:
        wanted = request.orders(order, [])
        if not wanted or ("order" in takes and len(wanted) > 1):
            values = {"order": one_line(order), "chart": figure.name}
            if "order" in takes:
                raise RequestError(
                    _("--order {order}: {chart} takes one order, such as 2", **values)
                )
            raise RequestError(_("--order {order}: {chart} takes orders, such as 1,2", **values))
        out |= {"order": wanted[0]} if "order" in takes else {"orders": wanted}
    if quantity is not None:
        if quantity not in figure.quantities:
            raise RequestError(
                _(
                    "--quantity {quantity}: {chart} shows {quantities}",
                    quantity=one_line(quantity),
                    chart=figure.name,
                    quantities=", ".join(figure.quantities),
                )
            )
        out["quantity"] = quantity
    if theta is not None:
        angles = request.angles(theta, option="--theta")
        if not angles or ("theta" in takes and len(angles) > 1) or len(angles) > GREATEST_ANGLES:
            values = {"angle": one_line(theta), "chart": figure.name}
            if "theta" in takes:
                raise RequestError(
                    _('--theta {angle}: {chart} takes one crank angle, such as "30 deg"', **values)
                )
            raise RequestError(
                _(
                    '--theta {angle}: {chart} takes up to {most} crank angles, such as "30 deg"',
                    most=GREATEST_ANGLES,
                    **values,
                )
            )
        out |= {"theta": angles[0]} if "theta" in takes else {"angles": angles}
    if "speed" in takes:
        out["speed"] = (
            request.speed(speed) if speed is not None else engine.speed if alone else None
        )
    if reference is not None:
        out["reference"] = request.reference(reference, engine)
    return out


GREATEST_ANGLES = 24
"""Panels of one figure."""
