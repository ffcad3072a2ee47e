"""What would remove the primary and secondary forces and couples that an engine is left with."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import number
from crankstar.mechanics.balance import balance
from crankstar.mechanics.remains import EQUAL, Sums, size, summed
from crankstar.remedy import Need, bobweight, loads, needs
from crankstar.remedy.fitting import quiet_cranks


def cure_lines(engine: Engine, found: Sequence[Need]) -> list[str]:
    """A sentence for each vector that remains, or for a pair of shafts that remove two.

    >>> from crankstar.files.catalog import load
    >>> cure_lines(load("i4"), needs(load("i4")))
    ['Secondary force: balance shafts at 2 and -2 times crank speed (Lanchester) remove it.']
    """
    cranks = {shaft.speed_ratio: shaft.name for shaft in reversed(engine.shafts) if shaft.throws}
    by_ratio = {need.ratio: need for need in found}
    out: list[str] = []
    for need in found:
        other = by_ratio.get(-need.ratio)
        paired = other is not None and _alike(need, other)
        if paired and not {need.ratio, -need.ratio} & set(cranks):
            if need.ratio > 0:
                out.append(_pair(need))
        elif need.ratio in cranks:
            out.append(_on_crank(engine, need, cranks))
        else:
            out.append(_single(need))
    return out


def _alike(need: Need, other: Need) -> bool:
    """Whether two vectors that turn against each other are as long as each other."""
    pairs = ((abs(need.force), abs(other.force)), (abs(need.couple), abs(other.couple)))
    return all(abs(one - two) <= EQUAL * max(one, two) for one, two in pairs)


def vector_name(ratio: Fraction, *, force: bool, couple: bool) -> str:
    """Primary, secondary, or by order: force, couple, or both.

    >>> vector_name(Fraction(-1), force=False, couple=True)
    'Primary couple'
    """
    order = abs(ratio)
    names = {
        1: (_("Primary force"), _("Primary couple"), _("Primary force and couple")),
        2: (_("Secondary force"), _("Secondary couple"), _("Secondary force and couple")),
    }
    if order.denominator == 1 and int(order) in names:
        return names[int(order)][2 if force and couple else 1 if couple else 0]
    if force and couple:
        return _("Force and couple of order {order}", order=order)
    return (
        _("Couple of order {order}", order=order)
        if couple
        else _("Force of order {order}", order=order)
    )


def _values(need: Need) -> dict[str, object]:
    name = vector_name(need.ratio, force=bool(need.force), couple=bool(need.couple))
    return {"vector": name, "ratio": need.ratio, "minus": -need.ratio}


def _pair(need: Need) -> str:
    if need.force:
        return _(
            "{vector}: balance shafts at {ratio} and {minus} times crank speed (Lanchester) remove "
            "it.",
            **_values(need),
        )
    return _(
        "{vector}: balance shafts at {ratio} and {minus} times crank speed, with opposite weights "
        "at their ends, remove it.",
        **_values(need),
    )


def _on_crank(engine: Engine, need: Need, cranks: dict[Fraction, str]) -> str:
    values = _values(need)
    if len(cranks) > 1:
        return _(
            "{vector} rotating with crankshaft {name}: counterweights on that crankshaft remove it.",
            name=cranks[need.ratio],
            **values,
        )
    weighted = any(shaft.weights for shaft in engine.shafts if shaft.throws)
    if weighted:
        return _("{vector} rotating with the crankshaft: other counterweights remove it.", **values)
    if need.force:
        return _("{vector} rotating with the crankshaft: counterweights remove it.", **values)
    return _(
        "{vector} rotating with the crankshaft: counterweights on the end webs remove it.", **values
    )


def _single(need: Need) -> str:
    values = _values(need)
    if need.ratio > 0:
        if need.force:
            return _(
                "{vector} rotating with the crankshaft: a balance shaft at {ratio} times crank "
                "speed removes it.",
                **values,
            )
        return _(
            "{vector} rotating with the crankshaft: a balance shaft at {ratio} times crank speed, "
            "with opposite weights at its ends, removes it.",
            **values,
        )
    if need.force:
        return _(
            "{vector} rotating against the crankshaft: a balance shaft at {ratio} times crank "
            "speed removes it.",
            **values,
        )
    return _(
        "{vector} rotating against the crankshaft: a balance shaft at {ratio} times crank speed, "
        "with opposite weights at its ends, removes it.",
        **values,
    )


def proposal(engine: Engine) -> str:
    """The counterweights that remove what turns with the crankshafts, and what then remains.

    Nothing where the engine as it is cannot be bettered by them.
    """
    cranks = {shaft.speed_ratio for shaft in engine.shafts if shaft.throws}
    if not any(need.ratio in cranks for need in needs(engine, highest=1)):
        return ""
    fitted, factor = quiet_cranks(engine)
    before, after = summed(balance(engine)), summed(balance(fitted))
    if not _better(before, after):
        return ""
    left = _left(after)
    if factor is None:
        if not left:
            return _("Counterweights on the end webs leave no primary force or couple.")
        return _("Counterweights on the end webs leave {left}.", left=left)
    scale, unit = (1.0, "m") if "mass" in engine.relative else (1000.0, "g")
    heaviest = number(scale * max(bobweight(pin, factor) for pin in loads(engine)))
    values = {"factor": f"{factor:g}", "bobweight": f"{heaviest} {unit}", "left": left}
    if not left:
        return _(
            "Counterweights with a balance factor of {factor} (heaviest bobweight {bobweight}) "
            "leave no primary force or couple.",
            **values,
        )
    return _(
        "Counterweights with a balance factor of {factor} (heaviest bobweight {bobweight}) leave "
        "{left}.",
        **values,
    )


def _better(before: Sums, after: Sums) -> bool:
    """Whether the first order is smaller in force or couple, and larger in neither."""
    pairs = [
        (size(getattr(before, name), 1.0), size(getattr(after, name), 1.0))
        for name in ("force", "couple")
    ]
    kept = all(new <= old * (1 + 1e-6) + 1e-9 for old, new in pairs)
    return kept and any(new < old * (1 - 1e-6) - 1e-9 for old, new in pairs)


def _left(sums: Sums) -> str:
    """What remains of the first order, which turns against the crankshaft."""
    force, couple = (
        abs(complex(spectra.selected(getattr(sums, name), [1.0]).backward[0]))
        for name in ("force", "couple")
    )
    values = {"force": number(force), "couple": number(couple)}
    if force and couple:
        return _(
            "a primary force of {force} m r ω² and a primary couple of {couple} m r ω² a, rotating "
            "against the crankshaft",
            **values,
        )
    if force:
        return _("a primary force of {force} m r ω², rotating against the crankshaft", **values)
    if couple:
        return _("a primary couple of {couple} m r ω² a, rotating against the crankshaft", **values)
    return ""
