"""What is asked of the gas: irregularity, mean effective pressures, weak cylinders."""

from __future__ import annotations

import re
from collections.abc import Collection, Sequence
from fractions import Fraction
from typing import Any

from crankstar.engine.engine import Engine
from crankstar.engine.quantities import INERTIA, PRESSURE
from crankstar.files import units
from crankstar.options import values as request
from crankstar.options.refusals import RequestError, each, refusal

MOST_LOADS = 12
"""Columns of a table of harmonics."""
LEAST_SHARE = 0.001
"""Of a combustion or a weight: less would not be felt."""
LEAST_IRREGULARITY, GREATEST_IRREGULARITY = 1e-4, 1.0


def degree_of_irregularity(text: str | None) -> float | None:
    """The share of --irregularity, as a number or a fraction. Raises RequestError."""
    if text is None:
        return None
    try:
        value = float(Fraction(text.replace(" ", "")))
    except (ValueError, ZeroDivisionError, OverflowError):
        value = 0.0
    if not LEAST_IRREGULARITY <= value <= GREATEST_IRREGULARITY:
        raise refusal(
            "--irregularity", text, "give a share from 1/10000 to 1, such as 1/50 or 0.02"
        )
    return value


def inertia(text: str) -> float:
    """The inertia of what turns, above zero, kg m^2. Raises RequestError."""
    return request.positive("--flywheel", text, quantity=INERTIA)


def gas_orders(text: str | None) -> list[float] | None:
    """The orders of --orders up to those of a cycle, None without. Raises RequestError.

    >>> gas_orders("0.5,2"), gas_orders(None)
    ([0.5, 2.0], None)
    """
    from crankstar.mechanics.gas_torque import HIGHEST

    wanted = request.orders(text, [n / 2 for n in range(1, int(2 * HIGHEST) + 1)])
    if wanted and max(wanted) > HIGHEST:
        raise refusal("--orders", text or "", "give orders up to {highest}", highest=f"{HIGHEST:g}")
    return wanted


def mean_pressures(text: str | None) -> tuple[float, ...]:
    """The pressures of --tangential, Pa, each once. Raises RequestError."""
    parts = request.listed(text)
    if text is not None and not 1 <= len(parts) <= MOST_LOADS:
        raise refusal(
            "--tangential",
            text,
            'give one to {most} pressures with commas, such as "4 bar, 8 bar"',
            most=MOST_LOADS,
        )
    out: list[float] = []
    for part in parts:
        with request.reading("--tangential"):
            value = units.si(part, PRESSURE)
        if value <= 0:
            raise request.not_positive("--tangential", part, PRESSURE)
        out.append(value)
    return tuple(dict.fromkeys(out))


def share(option: str, text: str, value: str) -> float:
    """A share of a combustion or a weight, from LEAST_SHARE to 1. Raises RequestError."""
    match = re.fullmatch(r"(\d+(?:\.\d*)?|\.\d+)\s*(%?)", value)
    found = -1.0 if match is None else float(match[1]) / (100 if match[2] else 1)
    if not LEAST_SHARE <= found <= 1:
        raise refusal(
            option,
            text,
            "give a share from {least} to 1, such as 0.2 or 20%",
            least=f"{LEAST_SHARE:g}",
        )
    return found


def weaker_cylinders(texts: Sequence[str] | None) -> list[tuple[int, float]]:
    """Cylinders and the share of their combustion that they lack. Raises RequestError.

    >>> weaker_cylinders(["3=20%"])
    [(3, 0.2)]
    """
    found: list[tuple[int, float]] = []
    for text in texts or ():
        name, _equals, value = (part.strip() for part in text.partition("="))
        if not name.isdecimal() or len(name) > 4 or not value:
            raise refusal("--weaker", text, "give a cylinder and what it lacks, as in 3=20%")
        found.append((int(name), share("--weaker", text, value)))
    return found


def refuse_strange(engine: Engine, question: Any) -> None:
    """Refuse the point and the cylinders of a question that the engine has not. Raises GasError.

    The fields are `point`, `off` and `weaker`.
    """
    from crankstar.mechanics.gas import chambers_of
    from crankstar.mechanics.operating_points import operating_state

    each(
        lambda: operating_state(engine, point=question.point),
        lambda: chambers_of(engine, question.off),
        lambda: chambers_of(engine, [number for number, _lost in question.weaker]),
    )


def refuse_together(
    load: Collection[str] = (),
    *,
    motored: bool = False,
    off: Collection[int] = (),
    weaker: Sequence[tuple[int, float]] = (),
) -> None:
    """Refuse what `mechanics.gas.check_together` does, and a cylinder weaker twice.

    Raises RequestError.

    >>> refuse_together(off=[1, 2], weaker=[(3, 0.1)])
    """
    from crankstar.mechanics.gas import check_together
    from crankstar.mechanics.operating_points import GasError

    numbers = [number for number, _lost in weaker]
    try:
        check_together(
            load, motored=motored, off=off, weaker=numbers,
            named=lambda name: f"--{name.replace('_', '-')}",
        )  # fmt: skip
    except GasError as error:
        raise RequestError(str(error)) from None
    if twice := [number for number in numbers if numbers.count(number) > 1]:
        raise RequestError(
            "--weaker: cylinder {number} stands twice; give once what it lacks", number=twice[0]
        )
