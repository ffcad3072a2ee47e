"""A Balance and an Engine as tables: what an engineer reads at a glance, in a terminal or a notebook.

An amplitude a with a phase p stands for `a cos(k theta + p)`, theta the crank angle from top dead centre of cylinder 1.
Normalised numbers are counted in m r w^2 A_k (force) and m r w^2 A_k a (couple), A_k being the harmonic of the first
cylinder's piston, so that they are the sums of the textbook's vector stars.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from math import degrees, pi
from textwrap import fill
from typing import NamedTuple

import numpy as np
from rich.console import Group, RenderableType
from rich.text import Text

from crankstar import motion, phasor
from crankstar.answer import GREATEST_DEFAULT_ORDER, orders_present
from crankstar.balance import Balance, Grouping, balance, grouped, total
from crankstar.engine import Engine
from crankstar.firing import firing
from crankstar.mechanism import Reference, Totals, block_roll
from crankstar.phasor import Spectrum
from crankstar.quantity import CONTROL
from crankstar.wording import NEGLIGIBLE, bearing_text, firing_sentence, heading, number, shape, table, titled, unit_text, wave

COLUMN = 18
"""Letters in a column of a comparison."""


class Analysis(NamedTuple):
    """An engine with its Balance, normalised, and in newtons at a speed where that can be; the orders to show.

    `turning` are the orders for roll and torque, which has more of them than force and couple.
    """

    engine: Engine
    normalised: Balance
    real: Balance | None
    orders: tuple[float, ...]
    turning: tuple[float, ...]


def analysis(engine: Engine, *, speed: float | None, reference: Reference | None = None) -> Analysis:
    """What `analyze` shows: at `speed` (rad/s), else at the engine's own."""
    speed = engine.speed if speed is None else speed
    normalised = balance(engine, reference=reference)
    real = balance(engine, speed=speed, reference=reference) if speed is not None else None
    if real is not None and real.units == normalised.units:
        real = None
    wanted = orders_present(normalised)
    return Analysis(engine, normalised, real, wanted, tuple(sorted({*wanted, *_torque_orders(normalised)})))


def _torque_orders(result: Balance) -> list[float]:
    sums = total(result)
    sizes = np.maximum(np.abs(phasor.amplitude(sums.torque)), np.abs(phasor.amplitude(sums.roll)))
    present = (sizes > NEGLIGIBLE * sizes.max(initial=0.0)) & (sums.torque.orders <= GREATEST_DEFAULT_ORDER)
    return sums.torque.orders[present].tolist()


def report(shown: Analysis, *, wide: bool = True, angles: Sequence[float] = (), by: Grouping | None = None) -> RenderableType:
    """The whole answer of `analyze`; `angles` (radians) and `by` add the sums at crank angles and the shares of groups."""
    sums = _summed(shown.normalised)
    real = _summed(shown.real) if shown.real else None
    blocks: list[RenderableType] = [heading(shown.engine), _conditions(shown)]
    blocks.append(_vectors("force", shown, sums.force, real.force if real else None, wide=wide))
    blocks.append(_vectors("couple", shown, sums.couple, real.couple if real else None, wide=wide))
    blocks.append(_turning(shown, sums, real))
    if by is not None:
        blocks.append(_shares(shown, by))
    if angles:
        blocks.append(_moments_in_time(shown, real or sums, angles))
    blocks.append(_remarks(shown, sums, real))
    return Group(*blocks)


def _conditions(shown: Analysis) -> RenderableType:
    """What the numbers are counted in, about which point, at what speed, and what is not certain."""
    engine = shown.engine
    lines = [f"couples and rolls about {_point(shown)}; an amplitude a ∠ p means a cos(kθ + p)"]
    units = unit_sizes(engine)
    if shown.real is not None and shown.real.speed is not None:
        lines.append(f"forces at {number(shown.real.speed * 30 / pi)} rpm" + units)
    elif "mass" in engine.relative or "radius" in engine.relative:
        missing = " and ".join(name for key, name in (("mass", "masses"), ("radius", "sizes")) if key in engine.relative)
        lines.append(f"no {missing} known: results in units of m r ω², the same at every speed{units}")
    else:
        lines.append(f'results in units of m r ω²{units}; for newtons say at what speed, as in --speed "6000 rpm"')
    text = Text("\n".join(lines), style="dim")
    doubtful = unverified(engine)
    if doubtful:
        text.append(f"\nunverified: {', '.join(doubtful)} (crankstar show tells where each value comes from)", style="yellow")
    return text


def unverified(engine: Engine) -> list[str]:
    """The key paths of the values that nobody vouches for."""
    return [path for path, origin in engine.provenance.items() if origin.status in ("unverified", "placeholder")]


def _point(shown: Analysis) -> str:
    """The reference point in words: its z, and its axis where there is more than one, or it is off that of the crankshaft."""
    engine, point = shown.engine, shown.normalised.reference
    along, across = ("a" if "pitch" in engine.relative else "mm"), ("r" if "radius" in engine.relative else "mm")
    scale = {"mm": 1000.0, "a": 1.0, "r": 1.0}
    place = f"z = {number(point.z * scale[along])} {along}"
    if point.up or point.right:
        up, right = number(point.up * scale[across]), number(point.right * scale[across])
        return f"{place}, {up} {across} up, {right} {across} right of the crank axis"
    several = len({cylinder.shaft for cylinder in engine.cylinders}) > 1
    return f"{place} on the axis of shaft {engine.shafts[0].name}" if several else place


def unit_sizes(engine: Engine) -> str:
    """How much m, r and a are, as far as they are known."""
    first = engine.first
    known = [("m", first.reciprocating_mass, "kg", "mass"), ("r", engine.throw(first).radius * 1000, "mm", "radius")]
    if len({cylinder.z for cylinder in engine.cylinders}) > 1:
        known.append(("a", engine.pitch * 1000, "mm", "pitch"))
    said = [f"{letter} = {number(size)} {unit}" for letter, size, unit, key in known if key not in engine.relative]
    return f" ({', '.join(said)})" if said else ""


def harmonic(engine: Engine, order: float) -> complex:
    """A_k of the first cylinder's piston, so that `Re(A_k exp(i k theta))` has its phase; zero where it has none."""
    first = engine.first
    if order != int(order) or first.articulated is not None:
        return 0j
    found = motion.piston_harmonics(crank_radius=engine.throw(first).radius, rod_length=first.rod_length, offset=first.offset)
    size = complex(found[int(order)]) if order < found.size else 0j
    if abs(size) < motion.TAIL * 10:
        return 0j
    return size if engine.sense > 0 else size.conjugate()


def _vectors(quantity: str, shown: Analysis, plain: Spectrum, real: Spectrum | None, *, wide: bool) -> RenderableType:
    """Order by order: up and right, the path over a turn, its greatest value; in a narrow terminal only what matters most."""
    unit = "m r ω² Aₖ" if quantity == "force" else "m r ω² Aₖ a"
    actual = f"[{unit_text(getattr(shown.real.units, quantity))}]" if real is not None and shown.real is not None else ""
    factors = [harmonic(shown.engine, order) for order in shown.orders]
    picked = _divided(phasor.selected(plain, shown.orders), np.array([factor or 1.0 for factor in factors]))
    largest = _largest(picked)
    heads = ["order", "Aₖ", "up", "right", "path over a turn", "greatest", actual]
    rows: list[list[str]] = []
    for row, (order, factor) in enumerate(zip(shown.orders, factors, strict=True)):
        path = phasor.ellipse(complex(picked.forward[row]), complex(picked.backward[row]))
        up, right = phasor.vertical(picked)[row], phasor.horizontal(picked)[row]
        greatest = number(path.semi_major, largest)
        cells = [number(order), _harmonic_text(factor), wave(up, largest), wave(right, largest), shape(path, largest), greatest]
        rows.append([*cells, "" if real is None else "0" if greatest == "0" else number(_size(real, order))])
    left_out = ({6} if real is None else set()) | (set() if wide else {1, 5} if real is not None else {1})
    kept = [place for place in range(len(heads)) if place not in left_out]
    out = table(*(heads[place] for place in kept), left=["path over a turn"])
    for cells in rows:
        out.add_row(*(cells[place] for place in kept), style="dim" if cells[5] == "0" else None)
    return titled(f"{quantity.capitalize()} on the block, in {unit}" + (f", and in {actual.strip('[]')}" if actual else ""), out)


def _divided(spectrum: Spectrum, factors: np.ndarray) -> Spectrum:
    """The spectrum with the complex amplitude of each order, up or right, divided by a factor."""
    turn = factors if spectrum.sense > 0 else np.conj(factors)
    return replace(spectrum, forward=spectrum.forward / turn, backward=spectrum.backward / np.conj(turn))


def _harmonic_text(factor: complex) -> str:
    if factor == 0:
        return "-"
    if abs(factor.imag) <= NEGLIGIBLE * abs(factor):
        return number(factor.real)
    return number(abs(factor))


def _size(spectrum: Spectrum, order: float) -> float:
    one = phasor.selected(spectrum, [order])
    return abs(complex(one.forward[0])) + abs(complex(one.backward[0]))


def _largest(spectrum: Spectrum, *, otherwise: float = 1.0) -> float:
    return float(np.max(np.abs(spectrum.forward) + np.abs(spectrum.backward), initial=0.0)) or otherwise


def _turning(shown: Analysis, sums: Totals, real: Totals | None) -> RenderableType:
    """Roll and inertia torque: real signals, so amplitude and phase are all there is."""
    plain, actual = _turning_signals(sums), _turning_signals(real) if real is not None else {}
    heads = ["order"]
    for name in plain:
        heads += [name, "[N m]"] if real is not None else [name]
    out = table(*heads)
    largest = max(_largest(signal, otherwise=0.0) for signal in plain.values()) or 1.0
    for order in shown.turning:
        cells = [number(order)]
        for name, signal in plain.items():
            cells.append(wave(phasor.amplitude(phasor.selected(signal, order))[0], largest))
            if real is not None:
                cells.append("0" if cells[-1] == "0" else number(_size(actual[name], order)))
        out.add_row(*cells)
    unit = "m r² ω²" + (", and in N m" if real is not None else "")
    title = "Roll, clockwise, of the whole; of the block when a flywheel takes the torque; inertia torque on the crankshaft"
    return titled(f"{title}; in {unit}", out)


def _turning_signals(sums: Totals) -> dict[str, Spectrum]:
    return {"roll": sums.roll, "roll of the block": block_roll(sums), "torque": sums.torque}


def _summed(result: Balance) -> Totals:
    """The sums of a Balance in which what is nothing beside the parts it was added up from is zero."""

    def quiet(name: str, whole: Spectrum) -> Spectrum:
        parts = getattr(result, name)
        pushed = (np.abs(parts.forward) + np.abs(parts.backward)).sum(axis=0)
        heard = np.abs(whole.forward) + np.abs(whole.backward) > NEGLIGIBLE * pushed
        return replace(whole, forward=whole.forward * heard, backward=whole.backward * heard)

    sums = total(result)
    return Totals(*(quiet(name, getattr(sums, name)) for name in Totals._fields))


def _shares(shown: Analysis, by: Grouping) -> RenderableType:
    """The greatest force, couple and roll of each order for every group of parts: who pushes, before the sums cancel."""
    result = shown.real or shown.normalised
    units = [unit_text(unit) for unit in result.units]
    heads = [f"{name} {number(order)}" for name in ("force", "couple", "roll") for order in shown.orders]
    out = table(by, *heads, left=[by])
    for label, sums in grouped(result, by).items():
        cells = [number(_size(getattr(sums, name), order)) for name in ("force", "couple", "roll") for order in shown.orders]
        out.add_row("of the shafts" if label is None else str(label), *cells)
    return titled(f"Greatest value of each order by {by}, force in {units[0]}, couple in {units[1]}, roll in {units[2]}", out)


def _moments_in_time(shown: Analysis, sums: Totals, angles: Sequence[float]) -> RenderableType:
    """Force, couple, roll and torque of all orders together at given crank angles."""
    units = [unit_text(unit) for unit in (shown.real or shown.normalised).units]
    out = table("θ [deg]", "force up", "right", "in all", "couple up", "right", "in all", "roll", "torque")
    tops = {name: phasor.peak(getattr(sums, name)).value for name in Totals._fields}
    for angle in angles:
        cells = [number(degrees(angle), 360.0)]
        for name in ("force", "couple"):
            vector = complex(phasor.value(getattr(sums, name), angle))
            cells += [number(part, tops[name]) for part in (vector.real, vector.imag, abs(vector))]
        cells += [number(complex(phasor.value(getattr(sums, name), angle)).real, tops[name]) for name in ("roll", "torque")]
        out.add_row(*cells)
    return titled(f"All orders together at these crank angles, force in {units[0]}, couple in {units[1]}, roll in {units[2]}", out)


def _remarks(shown: Analysis, sums: Totals, real: Totals | None) -> Text:
    """The peaks over a turn, and what a crank counterweight could take away."""
    text = Text("\n")
    units = shown.real.units if shown.real else shown.normalised.units
    for name in ("force", "couple"):
        top = phasor.peak(getattr(real or sums, name))
        if top.value > NEGLIGIBLE * _pushed(getattr(shown.real or shown.normalised, name)):
            at = f"at {number(degrees(top.theta))} deg, towards bearing {bearing_text(top.vector)} deg"
            text.append(f"Peak {name} of all orders: {number(top.value)} {unit_text(getattr(units, name))} {at}.\n")
        else:
            text.append(f"No {name} of any order.\n")
    torque = phasor.peak((real or sums).torque).value
    some = torque > NEGLIGIBLE * _pushed((shown.real or shown.normalised).torque)
    text.append(
        f"Peak inertia torque: {number(torque)} {unit_text(units.roll)}.\n" if some else "No inertia torque of any order.\n"
    )
    for name in ("force", "couple"):
        text.append(_removable(name, getattr(sums, name), both=_both_ways(shown.engine)))
    text.rstrip()
    return text


def _pushed(parts: Spectrum) -> float:
    """What the parts push all together, without regard to direction: the measure of what is nothing beside it."""
    return float((np.abs(parts.forward) + np.abs(parts.backward)).sum(axis=0).max(initial=0.0))


def _both_ways(engine: Engine) -> bool:
    """Whether a crankshaft turns against the first as fast as that."""
    return any(shaft.throws and shaft.speed_ratio == -1 for shaft in engine.shafts)


def _removable(name: str, spectrum: Spectrum, *, both: bool) -> str:
    """First order: the forward vector is what counterweights on the crankshaft can cancel.

    With `both` there is a crankshaft that turns as fast the other way, whose counterweights can cancel the backward vector.
    """
    first = phasor.selected(spectrum, [1.0])
    forward, backward = abs(complex(first.forward[0])), abs(complex(first.backward[0]))
    scale = NEGLIGIBLE * _largest(spectrum)
    if forward <= scale and backward <= scale:
        return f"First-order {name}: none.\n"
    other = "on a crankshaft that turns the other way"
    undone = f"counterweights {other} can take it away"
    if both and forward <= scale:
        return f"First-order {name}: {number(backward)} turning against the first crankshaft; {undone}.\n"
    if both and backward > scale:
        halves = (
            f"the {number(forward)} that turns with the first crankshaft and, {other}, the {number(backward)} that turns with that"
        )
        return f"First-order {name}: crank counterweights can take away {halves}.\n"
    if forward <= scale:
        return f"First-order {name}: {number(backward)} turning against the crankshaft; no crank counterweight can remove it.\n"
    left = f"leaving {number(backward)} turning against it" if backward > scale else "leaving nothing"
    return f"First-order {name}: crank counterweights can take away the {number(forward)} that turns with the crankshaft, {left}.\n"


def orders(result: Balance) -> RenderableType:
    """The orders of a Balance as it is counted: forward and backward vectors and roll."""
    wanted = orders_present(result)
    sums = Totals(*(phasor.selected(spectrum, wanted) for spectrum in total(result)))
    heads = ["order"]
    for name in ("force", "couple"):
        unit = unit_text(getattr(result.units, name))
        heads += [f"{name}\nforward [{unit}]", f"{name}\nbackward [{unit}]", f"{name} path"]
    out = table(*heads, f"roll\n[{unit_text(result.units.roll)}]", left=["force path", "couple path"])
    for row, order in enumerate(wanted):
        cells = [number(order)]
        for spectrum in (sums.force, sums.couple):
            pair = complex(spectrum.forward[row]), complex(spectrum.backward[row])
            cells += [*(wave(value, _largest(spectrum)) for value in pair), shape(phasor.ellipse(*pair), _largest(spectrum))]
        out.add_row(*cells, wave(phasor.amplitude(sums.roll)[row], _largest(sums.roll)))
    return titled("" if result.speed is None else f"at {number(result.speed * 30 / pi)} rpm", out)


def comparison(shown: Sequence[Analysis]) -> RenderableType:
    """Several engines side by side: the greatest value of each order of every quantity, and the peaks over a turn."""
    real = all(one.real is not None for one in shown)
    results = [one.real if real and one.real else one.normalised for one in shown]
    sums = [_summed(result) for result in results]
    signals = [{"force": one.force, "couple": one.couple, **_turning_signals(one)} for one in sums]
    out = table("", *(fill(CONTROL.sub("?", one.engine.name), COLUMN) for one in shown), left=[""])
    for name in signals[0]:
        plane = name in ("force", "couple")
        wanted = sorted({order for one in shown for order in (one.orders if plane else one.turning)})
        units = dict.fromkeys(unit_text(getattr(result.units, name if plane else "roll")) for result in results)
        scales = [
            max(_largest(one[other], otherwise=0.0) for other in one if plane == (other in ("force", "couple"))) for one in signals
        ]
        for order in wanted:
            row = [number(_size(one[name], order), scale) for one, scale in zip(signals, scales, strict=True)]
            out.add_row(f"{name}, order {number(order)} [{' or '.join(units)}]", *row)
        tops = [number(phasor.peak(one[name]).value) for one in signals]
        out.add_row(f"{name}, peak of all orders", *tops, style="bold", end_section=True)
    fires = [firing_sentence(firing(one.engine)) if one.engine.firing_order else "no order given" for one in shown]
    out.add_row("firing", *(fill(text, COLUMN, break_on_hyphens=True) for text in fires))
    if real:
        out.add_row("speed [rpm]", *(number(result.speed * 30 / pi) if result.speed else "" for result in results))
    out.add_row("unverified values", *(str(len(unverified(one.engine)) or "") for one in shown))
    return titled("Greatest value of each order" + ("" if real else ", each engine in its own m r ω²"), out)
