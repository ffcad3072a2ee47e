"""The figures and derivations of an exhibit by key: compiled Vega specifications, and HTML with MathML."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

from crankstar import fitting
from crankstar.engine import Engine
from crankstar.exhibit.keys import BEFORE_AND_AFTER
from crankstar.quantity import one_line


class NoSuchKeyError(ValueError):
    """A key that no figure or derivation of an engine has, as one sentence."""


CHOSEN_BY = {"order", "quantity"}
"""The options that a key may have."""


def chart(engine: Engine, key: str) -> dict[str, Any]:
    """The figure of that key as a Vega specification, with the signal `theta` (degrees) but no slider for it.

    Raises NoSuchKeyError, or ChartError where the figure cannot be drawn.
    """
    import vl_convert

    from crankstar.charts import swiftly

    with swiftly():
        made = _before_and_after(engine) if key == BEFORE_AND_AFTER else _single(engine, key)
        drawn = made.to_dict(validate=False)
    for parameter in drawn.get("params", ()):
        parameter.pop("bind", None)
    return vl_convert.vegalite_to_vega(drawn)


def _before_and_after(engine: Engine) -> Any:
    from crankstar.charts import side_by_side

    found = fitting.recommended(engine)
    if found is None:
        raise NoSuchKeyError(f"{BEFORE_AND_AFTER}: weights and shafts would take nothing of the first two orders from this engine")
    named = ((engine, "as it is"), (found.after, "with weights and shafts"))
    pair = [one.model_copy(update={"name": name}) for one, name in named]
    return side_by_side(pair, "spectrum", speed=engine.speed)


def _single(engine: Engine, key: str) -> Any:
    from crankstar.charts import CHARTS

    figure, *options = key.split(":")
    asked: dict[str, Any] = {name: value for name, _, value in (part.partition("=") for part in options)}
    known = CHARTS.get(figure)
    if (
        known is None
        or not asked.keys() <= set(known.options) & CHOSEN_BY
        or asked.get("quantity", "force") not in (*known.quantities, "force")
    ):
        raise NoSuchKeyError(f"{one_line(key, longest=60)}: there is no such figure; there are: {', '.join(CHARTS)}")
    if "order" in asked:
        asked["order"] = _order(key, asked["order"])
    if "speed" in known.options:
        asked["speed"] = engine.speed
    return known.draw(engine, **asked)


def _order(key: str, text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise NoSuchKeyError(f"{one_line(key, longest=60)}: the order is not a number") from None


def derivation(engine: Engine, key: str) -> str:
    """The derivation of that key (`force:2`) as HTML with MathML; every text in it is escaped, and no style is inline.

    Raises NoSuchKeyError, or DerivationError where it cannot be derived.
    """
    from crankstar import derive
    from crankstar.derive.documents import html_part

    quantity, _, order = key.partition(":")
    try:
        wanted = Fraction(order) if len(order) < 20 and "e" not in order.lower() else Fraction(0)
    except (ValueError, ZeroDivisionError):
        wanted = Fraction(0)
    if quantity not in ("force", "couple") or wanted <= 0:
        raise NoSuchKeyError(f"{one_line(key, longest=60)}: there is no such derivation; ask for one as in force:2")
    return html_part(derive.derivation(engine, wanted, quantity=quantity).chapter)
