"""The figures of an exhibit by key as Vega-Lite, its derivations as HTML."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from fractions import Fraction
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.files.box import Spread
from crankstar.language.messages import MessageError, _, language
from crankstar.language.quoting import one_line
from crankstar.page.keys import BEFORE_AND_AFTER
from crankstar.page.told import pictured
from crankstar.remedy import fitting

if TYPE_CHECKING:
    from crankstar.derive.records import Quantity


class NoSuchKeyError(MessageError):
    """A key that no figure or derivation of an engine has."""


CHOSEN_BY = {"order", "orders", "quantity"}
"""The options of keys."""


WIDTH = 300.0
"""px of a panel that stands alone, so that its letters can be read on a telephone."""


def chart(
    engine: Engine,
    key: str,
    *,
    tree: Mapping[str, Any] | None = None,
    spread: Spread | None = None,
    beside: Engine | None = None,
) -> dict[str, Any]:
    """The figure as Vega-Lite, with the parameter `theta` (degrees) but without its slider.

    With a `spread` of the engine, an estimated one, its ranges are drawn. Its scale is one with
    that of the same figure of the engine `beside` it, where both are counted in the same unit.
    `tree` is that of the engine file, for what is found of it.
    Raises NoSuchKeyError, or ChartError where the figure cannot be drawn.
    """
    if key == BEFORE_AND_AFTER:
        made = _before_and_after(engine, spread)
    else:
        made = _pictured(engine, key, tree or {}) or _single(engine, key, spread, beside)
    drawn = made.to_dict()
    if "params" in drawn:
        drawn["params"] = [
            {"name": param["name"], "value": param["value"]} for param in drawn["params"]
        ]
    return drawn


def fitted_spread(spread: Spread | None, fitted: fitting.Fitted, after: Engine) -> Spread | None:
    """The fitted engine `after` over the ranges, each engine with weights for its own masses."""
    if spread is None:
        return None
    first, *others = (
        fitting.recommended_like(fitted, spread.engine, each).after for each in spread.ends
    )
    return Spread(after, first, tuple(others))


def _before_and_after(engine: Engine, spread: Spread | None) -> Any:
    from crankstar.charts import Canvas, drawn_on, over_ranges, side_by_side

    fitted = fitting.recommended(engine)
    if fitted is None:
        raise NoSuchKeyError(
            "{key}: this engine needs no counterweights or balance shafts", key=BEFORE_AND_AFTER
        )
    before = with_values(engine, name=_("as it is"))
    after = with_values(fitted.after, name=_("with weights and shafts"))
    own = spread and spread._replace(engine=before)
    beside = over_ranges([own, fitted_spread(spread, fitted, after)])
    with beside, drawn_on(Canvas(rests=False)):
        return side_by_side([before, after], "spectrum", speed=engine.speed)


def _pictured(engine: Engine, key: str, tree: Mapping[str, Any]) -> Any:
    from crankstar.charts import Canvas, drawn_on

    with drawn_on(Canvas(WIDTH)):
        return pictured(engine, key, tree)


def _single(engine: Engine, key: str, spread: Spread | None, beside: Engine | None) -> Any:
    from crankstar.charts import CHARTS, Canvas, ChartError, draw, drawn_on, over_ranges

    figure, *options = key.split(":")
    pairs = (part.partition("=") for part in options)
    asked: dict[str, Any] = {name: value for name, _equals, value in pairs}
    known = CHARTS.get(figure)
    if (
        known is None
        or not asked.keys() <= set(known.options) & CHOSEN_BY
        or asked.get("quantity", "force") not in (*known.quantities, "force")
    ):
        raise NoSuchKeyError(
            "{key}: there is no such figure; there are: {figures}",
            key=one_line(key, longest=60),
            figures=", ".join(CHARTS),
        )
    if "order" in asked:
        asked["order"] = _order(key, asked["order"])
    if "orders" in asked:
        asked["orders"] = [_order(key, asked["orders"])]
    if "speed" in known.options:
        asked["speed"] = engine.speed
    with over_ranges([spread]):
        if beside is not None and known.compares:
            with suppress(ChartError), drawn_on(Canvas(WIDTH, alone=True, rests=False)):
                return draw(figure, [engine, beside], **asked)
        with drawn_on(Canvas(WIDTH, rests=False)):
            return draw(figure, engine, **asked)


def _order(key: str, text: str) -> float:
    try:
        return float(text)
    except ValueError:
        shown = one_line(key, longest=60)
        raise NoSuchKeyError("{key}: the order is not a number", key=shown) from None


def derivation(engine: Engine, key: str) -> str:
    """The derivation of that key (`force:2`) as HTML with MathML.

    Every text in it is escaped, and no style is inline.

    Raises NoSuchKeyError, or DerivationError where it cannot be derived.
    """
    quantity, _colon, order = key.partition(":")
    try:
        wanted = Fraction(order) if len(order) < 20 and "e" not in order.lower() else Fraction(0)
    except (ValueError, ZeroDivisionError):
        wanted = Fraction(0)
    if (quantity != "force" and quantity != "couple") or wanted <= 0:
        raise NoSuchKeyError(
            "{key}: there is no such derivation; a key is like force:2",
            key=one_line(key, longest=60),
        )
    return _derived(_exerting(engine, wanted), wanted, quantity, language())


@lru_cache(maxsize=64)
def _derived(engine: Engine, order: Fraction, quantity: Quantity, _language: str) -> str:
    """A derivation as HTML in the language of the context, which is this one."""
    from crankstar import derive
    from crankstar.derive.documents import html_parts

    return html_parts([derive.derivation(engine, order, quantity=quantity)])[0]


def _exerting(engine: Engine, order: Fraction) -> Engine:
    """The engine without weights on crankshafts that exert nothing of this order.

    What is derived of it is the same, and the same as of the engine before it got them.
    """
    shafts = tuple(
        with_values(shaft, weights=())
        if shaft.throws and abs(shaft.speed_ratio) != order
        else shaft
        for shaft in engine.shafts
    )
    return engine if shafts == engine.shafts else with_values(engine, shafts=shafts)
