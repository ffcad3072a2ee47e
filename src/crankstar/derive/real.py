"""The force or couple of the real engine: the harmonic as a series and exactly, and newtons."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from fractions import Fraction

from flint import acb, arb

from crankstar.derive.algebra import enclosure, wave
from crankstar.derive.algebra.evaluation import enclosed
from crankstar.derive.algebra.formula import (
    NOUGHT,
    UNIT,
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
from crankstar.derive.records import Line, Quantity, Series, Step, unit_symbol
from crankstar.derive.task import Task, sides
from crankstar.engine.engine import Engine
from crankstar.engine.motion import series_coefficient
from crankstar.language.messages import N_, _
from crankstar.language.numbers import RPM
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
    words = [size(task.engine, task.quantity, task.speed, _greatest(task))]
    for symbol, (order, ratio) in _harmonics(task).items():
        if order == 1:
            continue
        if order > task.power + 1:
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
            powers = range(1, task.power + 1)
            lines.append(series_line(symbol, [(p, series_coefficient(order, p)) for p in powers]))
        ball = enclosure.coefficient(ratio, order)
        lines.append(Line(symbol, (Decimal(ball, 12),), label=exactly(task.engine, ratio)))
    return Step(title, tuple(words), tuple(lines))


def _harmonics(task: Task) -> dict[Symbol, tuple[int, Fraction]]:
    """The harmonics that stand in the result, with their orders and rod ratios."""
    parts = task.bodies
    there = {symbol for own in task.push for key in own for symbol in key}
    out = {symbol: harmonic for symbol, harmonic in parts.values.items() if symbol in there}
    if parts.harmonic not in (None, 1) and parts.rod_ratio is not None:
        out[Symbol("A", str(parts.harmonic))] = (parts.harmonic, parts.rod_ratio)
    return out


def exactly(engine: Engine, rod_ratio: Fraction) -> str:
    """The label of an exact harmonic; `assumed` or `estimated` where the rod length is."""
    ratio = 1 / rod_ratio
    shown = str(ratio) if ratio.denominator < 1000 else f"{float(ratio):.6g}"
    said = engine.provenance
    keys = ("cylinder.rod_ratio", "cylinder.rod_length")
    status = {said[key].status for key in keys if key in said}
    if "placeholder" in status:
        return _("exactly, at λ = r/l = {ratio} (assumed)", ratio=shown)
    if "estimated" in status:
        return _("exactly, at λ = r/l = {ratio} (estimated)", ratio=shown)
    return _("exactly, at λ = r/l = {ratio}", ratio=shown)


def series_line(symbol: Symbol, powers: Iterable[tuple[int, Fraction]]) -> Line:
    """A harmonic as a series in lambda, its coefficients by power."""
    terms = tuple((power, value) for power, value in powers if value)
    formula = series(terms, Symbol("lambda"))
    return Line(symbol, (formula,), "series", label=_("as a series"), series=terms)


def series(powers: Series, ratio: Symbol, *, inverted: bool = False) -> Formula:
    """A sum of powers of lambda = r/l, or (inverted) of 1/L, L = l/S, S the stroke."""
    terms: list[Formula] = []
    for power, factor in powers:
        value = factor / 2**power if inverted else factor
        letter: Formula = Power(ratio, power) if power > 1 else ratio if power else UNIT
        above, below = number(abs(value.numerator)), number(value.denominator)
        if inverted:
            term = Ratio(above, product(below, letter))
        else:
            term = product(above, letter) if below == UNIT else Ratio(product(above, letter), below)
        terms.append(product(1 if value > 0 else -1, term))
    return summed(*terms, Symbol("…"))


def size(engine: Engine, quantity: Quantity, speed: float | None, greatest: float) -> str:
    """The greatest value over a turn, in newtons where masses, sizes and a speed are known.

    `greatest` is that value at 1 rad/s. A derivation is of one engine: where values are estimated
    it is that of the typical ones, and says so.
    """
    needed = [("mass", _("reciprocating mass")), ("radius", _("stroke"))]
    if quantity == "couple":
        needed.append(("pitch", _("bore pitch")))
    missing = [word for key, word in needed if key in engine.relative]
    if speed is None:
        missing.append(_("speed"))
    if missing or speed is None:
        sentence = N_("For newton metres the engine file lacks: {missing}.")
        if quantity == "force":
            sentence = N_("For newtons the engine file lacks: {missing}.")
        return _(sentence, missing=", ".join(missing))
    guessed = any(source.status == "estimated" for source in engine.provenance.values())
    value = greatest * speed**2
    told = _(
        _SIZES[quantity],
        speed=f"{speed * RPM:.6g}",
        size=f"{float(f'{value:.3g}') if guessed else value:.6g}",
    )
    doubt = _("This size is estimated; its range stands in the analysis.")
    return f"{told} {doubt}" if guessed else told


_SIZES: dict[Quantity, str] = {
    "force": N_("At {speed} rpm the force is at most {size} N over a turn."),
    "couple": N_("At {speed} rpm the couple is at most {size} N m over a turn."),
    "torque": N_("At {speed} rpm the torque is at most {size} N m over a turn."),
}


def _greatest(task: Task) -> float:
    """The greatest value over a turn at 1 rad/s, SI: the sum of the lengths of both vectors."""
    parts, engine = task.bodies, task.engine
    values = {symbol.name: enclosure.arb_of(value) for symbol, value in task.arms.values.items()}
    values |= {
        symbol.name: enclosure.coefficient(ratio, order)
        for symbol, (order, ratio) in parts.values.items()
    }
    lengths = sum((abs(_enclosed(own, values)) for own in task.vectors), arb(0))
    if parts.harmonic is not None and parts.rod_ratio is not None:
        lengths *= abs(enclosure.coefficient(parts.rod_ratio, parts.harmonic))
    unit = unit_unbalance(engine)
    return float(lengths.mid()) * unit * (engine.pitch if task.quantity == "couple" else 1.0)


def _enclosed(vector: Wave, values: dict[str, arb]) -> acb:
    return acb(enclosed(wave.vector(vector), values))
