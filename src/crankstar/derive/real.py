"""The force or couple of the real engine: the harmonic as a series and exactly, and newtons."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from math import pi

from flint import acb, arb

from crankstar.derive.algebra import enclosure, wave
from crankstar.derive.algebra.evaluation import enclosed
from crankstar.derive.algebra.formula import (
    NOUGHT,
    Decimal,
    Formula,
    Power,
    Ratio,
    Symbol,
    number,
    product,
    summed,
)
from crankstar.derive.algebra.wave import Wave
from crankstar.derive.records import Line, Step, unit_symbol
from crankstar.derive.task import Task, sides
from crankstar.engine.motion import series_coefficient
from crankstar.language.messages import _
from crankstar.mechanics.balance import unit_unbalance


def real(task: Task) -> Step:
    """The force or couple in letters, its harmonics, and its size where the file gives enough."""
    title = _("The real engine")
    if not any(task.push):
        return Step(title, (_("Nothing of this order remains, at any speed."),), ())
    counted = unit_symbol(task.bodies.harmonic)
    lines = [
        replace(line, chain=(product(counted, line.chain[-1]),), kind="plain", rows=())
        for line in sides(task, "", task.moving)
        if line.chain[-1] != NOUGHT
    ]
    words = [_size(task)]
    for symbol, (order, ratio) in _harmonics(task).items():
        if order == 1:
            continue
        formula = series(order, task.power, Symbol("lambda"))
        if formula == NOUGHT:
            words.append(
                _(
                    "The series of A_{order} begins with λ to the power {first}, beyond the power "
                    "{power} asked for.",
                    order=order,
                    first=order - 1,
                    power=task.power,
                )
            )
        else:
            cut, label = (order, task.power), _("as a series")
            lines.append(Line(symbol, (formula,), "series", label=label, series=cut))
        ball = enclosure.coefficient(ratio, order)
        lines.append(Line(symbol, (Decimal(ball, 12),), label=_exactly(task, ratio)))
    return Step(title, tuple(words), tuple(lines))


def _harmonics(task: Task) -> dict[Symbol, tuple[int, Fraction]]:
    """The harmonics that stand in the result, with their orders and rod ratios."""
    parts = task.bodies
    there = {symbol for own in task.push for key in own for symbol in key}
    out = {symbol: harmonic for symbol, harmonic in parts.values.items() if symbol in there}
    if parts.harmonic not in (None, 1) and parts.rod_ratio is not None:
        out[Symbol("A", str(parts.harmonic))] = (parts.harmonic, parts.rod_ratio)
    return out


def _exactly(task: Task, rod_ratio: Fraction) -> str:
    """The label of an exact harmonic; `assumed` where the rod length is a placeholder."""
    ratio = 1 / rod_ratio
    shown = str(ratio) if ratio.denominator < 1000 else f"{float(ratio):.6g}"
    said = task.engine.provenance
    keys = ("cylinder.rod_ratio", "cylinder.rod_length")
    if any(key in said and said[key].status == "placeholder" for key in keys):
        return _("exactly, at λ = r/l = {ratio} (assumed)", ratio=shown)
    return _("exactly, at λ = r/l = {ratio}", ratio=shown)


def series(order: int, power: int, ratio: Symbol, *, inverted: bool = False) -> Formula:
    """A_k as a sum of powers of lambda = r/l, or (inverted) of 1/L, L = l/S, S the stroke.

    Nought where it begins later.
    """
    terms: list[Formula] = []
    for exponent in range(power + 1):
        value = series_coefficient(order, exponent) / (2**exponent if inverted else 1)
        letter: Formula = ratio if exponent == 1 else Power(ratio, exponent)
        above, below = number(abs(value.numerator)), number(value.denominator)
        if value.denominator == 1 and not inverted:
            term = product(value, letter)
        elif inverted:
            term = product(1 if value > 0 else -1, Ratio(above, product(below, letter)))
        else:
            term = product(1 if value > 0 else -1, Ratio(product(above, letter), below))
        terms += [term] if value else []
    return summed(*terms, Symbol("…")) if terms else NOUGHT


def _size(task: Task) -> str:
    """The greatest value over a turn, in newtons where masses, sizes and a speed are known."""
    engine, speed = task.engine, task.speed
    needed = [("mass", _("reciprocating mass")), ("radius", _("stroke"))]
    if task.quantity == "couple":
        needed.append(("pitch", _("bore pitch")))
    missing = [word for key, word in needed if key in engine.relative]
    if speed is None:
        missing.append(_("speed"))
    if missing or speed is None:
        if task.quantity == "couple":
            return _(
                "The engine file does not give all that newton metres need. Missing: {missing}.",
                missing=", ".join(missing),
            )
        return _(
            "The engine file does not give all that newtons need. Missing: {missing}.",
            missing=", ".join(missing),
        )
    values = {"speed": f"{speed * 30 / pi:.6g}", "size": f"{_greatest(task, speed):.6g}"}
    if task.quantity == "couple":
        return _("At {speed} rpm the couple is at most {size} N m over a turn.", **values)
    return _("At {speed} rpm the force is at most {size} N over a turn.", **values)


def _greatest(task: Task, speed: float) -> float:
    """The greatest value over a turn, SI: the sum of the lengths of both vectors."""
    parts, engine = task.bodies, task.engine
    values = {symbol.name: enclosure.arb_of(value) for symbol, value in task.arms.values.items()}
    values |= {
        symbol.name: enclosure.coefficient(ratio, order)
        for symbol, (order, ratio) in parts.values.items()
    }
    lengths = sum((abs(_enclosed(own, values)) for own in task.vectors), arb(0))
    if parts.harmonic is not None and parts.rod_ratio is not None:
        lengths *= abs(enclosure.coefficient(parts.rod_ratio, parts.harmonic))
    unit = unit_unbalance(engine) * speed**2
    return float(lengths.mid()) * unit * (engine.pitch if task.quantity == "couple" else 1.0)


def _enclosed(vector: Wave, values: dict[str, arb]) -> acb:
    return acb(enclosed(wave.vector(vector), values))
