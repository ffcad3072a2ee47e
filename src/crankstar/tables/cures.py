"""What would remove the primary and secondary forces and couples that an engine is left with."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.language.alike import as_given, in_turn, of_any
from crankstar.language.messages import N_, _
from crankstar.language.shown_units import quantity_text
from crankstar.mechanics.balance import Balance, balance
from crankstar.mechanics.bounds import length, size
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.remains import EQUAL, Sums, summed
from crankstar.remedy import Need, bobweight, loads, needs
from crankstar.remedy.fitting import quiet_cranks
from crankstar.remedy.shafts import ZERO
from crankstar.tables.assumptions import part_names
from crankstar.tables.bobweights import lacks_rotating
from crankstar.tables.paths import vector_name
from crankstar.tables.scales import scales

COURSES = {
    "pair": N_("{vector}: removed by {cure}."),
    "with": N_("{vector}, rotating with the crankshaft: removed by {cure}."),
    "against": N_("{vector}, rotating against the crankshaft: removed by {cure}."),
    "crank": N_("{vector}, rotating with crankshaft {name}: removed by {cure}."),
}
CURES = {
    "pair": (
        N_("balance shafts at {ratio} and {minus} times crank speed (Lanchester)"),
        N_(
            "balance shafts at {ratio} and {minus} times crank speed, with opposite weights at "
            "their ends"
        ),
    ),
    "shaft": (
        N_("a balance shaft at {ratio} times crank speed"),
        N_("a balance shaft at {ratio} times crank speed, with opposite weights at its ends"),
    ),
    "bare": (N_("counterweights"), N_("counterweights (two on the end webs are enough)")),
    "weighted": (N_("other counterweights"),) * 2,
}
"""What removes a force, and what removes a couple alone."""
LEFT = {
    "": N_("no primary force or couple"),
    "force": N_("a primary force of {force}, rotating against the crankshaft"),
    "couple": N_("a primary couple of {couple}, rotating against the crankshaft"),
    "force couple": N_(
        "a primary force of {force} and a primary couple of {couple}, rotating against the "
        "crankshaft"
    ),
}


def cure_lines(engine: Engine, remaining: Sequence[Need]) -> list[str]:
    """A sentence for each vector that remains, or for a pair of shafts that remove two.

    What remains for other masses alone needs a cure that the engine as given has no use for.

    >>> from crankstar.files.catalog import load
    >>> cure_lines(load("i4"), needs(load("i4")))
    ['Secondary force: removed by balance shafts at 2 and -2 times crank speed (Lanchester).']
    """
    cranks = {shaft.speed_ratio: shaft for shaft in reversed(engine.shafts) if shaft.throws}
    told = in_turn("cures", tuple(need.ratio for need in remaining))
    by_ratio = {need.ratio: need for need in remaining if need.ratio in told}
    out: list[str] = []
    for need in by_ratio.values():
        other = by_ratio.get(-need.ratio)
        course, cure = "with" if need.ratio > 0 else "against", "shaft"
        if need.ratio in cranks:
            weighted = any(shaft.weights for shaft in cranks.values())
            course = "crank" if len(cranks) > 1 else "with"
            cure = "weighted" if weighted else "bare"
        elif other is not None and -need.ratio not in cranks and _alike(need, other):
            if need.ratio < 0:
                continue
            course = cure = "pair"
        removed_by = _(CURES[cure][not need.force], ratio=need.ratio, minus=-need.ratio)
        name = cranks[need.ratio].name if course == "crank" else ""
        vector = vector_name(need.ratio, force=bool(need.force), couple=bool(need.couple))
        out.append(_(COURSES[course], vector=vector, name=name, cure=removed_by))
    return out


def fitted_lines(engine: Engine) -> list[str]:
    """That the engine has parts already which may do what a remedy does, but not in its file.

    >>> from crankstar.files.catalog import load
    >>> fitted_lines(load("bmw-f800")), fitted_lines(load("i4"))
    (['The engine already has, outside its file: balance rod.'], [])
    """
    if not engine.left_out:
        return []
    parts = part_names(engine.left_out)
    return [_("The engine already has, outside its file: {parts}.", parts=parts)]


def none_remains(engine: Engine, *, zero: float = ZERO) -> str:
    """That nothing of the first two orders needs a cure; empty where something does.

    What is balanced for estimated masses is said to be so for these alone.
    """
    own = [need.ratio for need in needs(engine, zero=zero)]
    if as_given("needs", bool(own)):
        return ""
    if of_any("needs", own):
        return _(
            "With the estimated masses no primary or secondary force or couple remains; other "
            "masses leave what the ranges say. Weigh the parts before weights are made."
        )
    return _("No primary or secondary force or couple remains.")


def _alike(need: Need, other: Need) -> bool:
    """Whether two vectors that turn against each other are as long as each other."""
    pairs = ((abs(need.force), abs(other.force)), (abs(need.couple), abs(other.couple)))
    return all(abs(a - b) <= EQUAL * max(a, b) for a, b in pairs)


class Left(NamedTuple):
    """What counterweights leave of the first order, in words, and their factor, if they have one.

    `weighted`: whether there are any; an engine may be better without those it has.
    """

    words: str
    factor: float | None
    weighted: bool


def left_by_counterweights(
    engine: Engine, *, speed: float | None = None, reference: Reference | None = None
) -> Left | None:
    """What remains with the counterweights that remove what turns with the crankshafts.

    In newtons at `speed` (rad/s), couples about the `reference` point or the middle of the
    cylinders. None where they do not better the engine as it is.
    """
    cranks = {shaft.speed_ratio for shaft in engine.shafts if shaft.throws}
    if not any(need.ratio in cranks for need in needs(engine, highest=1)):
        return None
    fitted, factor = quiet_cranks(engine)
    if not _better(summed(balance(engine)), summed(balance(fitted))):
        return None
    weighted = any(shaft.weights for shaft in fitted.shafts if shaft.throws)
    after = balance(fitted, speed=speed, reference=reference)
    return Left(_left(after), factor, weighted)


def proposal(engine: Engine, *, speed: float | None = None) -> str:
    """The counterweights that remove what turns with the crankshafts, and what then remains."""
    found = left_by_counterweights(engine, speed=speed)
    if found is None:
        return ""
    left, factor, weighted = found
    if not weighted:
        return _("Without its counterweights the engine has {left}.", left=left)
    if factor is None:
        return _("Counterweights on the end webs leave {left}.", left=left)
    if lacks_rotating(engine):  # a bobweight would stand for the pistons alone
        return _(
            "Counterweights with a balance factor of {factor} leave {left}.",
            factor=f"{factor:g}",
            left=left,
        )
    heaviest = max(bobweight(pin, factor) for pin in loads(engine))
    return _(
        "Counterweights with a balance factor of {factor} (heaviest bobweight {bobweight}) leave "
        "{left}.",
        factor=f"{factor:g}",
        bobweight=scales(engine).mass.text(heaviest),
        left=left,
    )


def _better(before: Sums, after: Sums) -> bool:
    """Whether the first order is smaller in force or couple, and larger in neither."""
    pairs = [
        (size(getattr(before, name), 1.0), size(getattr(after, name), 1.0))
        for name in ("force", "couple")
    ]
    kept = all(new <= old * (1 + 1e-6) + 1e-9 for old, new in pairs)
    return kept and any(new < old * (1 - 1e-6) - 1e-9 for old, new in pairs)


def _left(result: Balance) -> str:
    """What remains of the first order, which turns against the crankshaft."""
    sums = summed(result)
    vectors = {
        name: length(complex(spectra.selected(getattr(sums, name), [1.0]).backward[0]))
        for name in ("force", "couple")
    }
    values = {
        name: quantity_text(vector, getattr(result.units, name)) for name, vector in vectors.items()
    }
    sentence = LEFT[" ".join(name for name in vectors if vectors[name])]
    return _(sentence, **values)
