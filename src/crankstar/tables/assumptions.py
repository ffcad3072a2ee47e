"""What an answer rests on as sentences and as rows for machines, what matters most first."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from math import inf
from typing import Any

from crankstar.analysis.assumptions import SIGNIFICANT, TOLD, UNMOVED, Assumption, Moved
from crankstar.analysis.document import Remarks
from crankstar.language.messages import N_, _, passage
from crankstar.language.numbers import number
from crankstar.tables.moved_figures import figure_name, rounded, size_text, span_text, value_text

PAIRED = 2
"""Sentences on each of two engines that find room on the first screen; on each of more, one."""
MOST_TOLD = 5
"""Sentences of their own, at most, beside those on choices of two; the others are named."""


def assumption_lines(found: Sequence[Assumption], *, most: int = MOST_TOLD) -> list[str]:
    """The sentences on what an answer rests on, of at `most` so many with ranges one each.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.studies.answers import amplitudes, rests_on
    >>> engine = load("audi-25-tfsi")
    >>> print(assumption_lines(rests_on(engine, amplitudes(engine)))[1])
    cylinder.rotating_mass: no rotating mass in the file (big ends, crankpins), counted as zero. \
With 182 g to 529 g, and a throw_mass of 205 g to 461 g, the couple of order 1 is 747 to 1260 N m, \
not 418 N m.
    """
    return [line for line, _of in _told(found, most)]


def assumption_sentence(each: Assumption) -> str:
    """The sentence on one assumption, however little it moves.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.studies.answers import amplitudes, rests_on
    >>> engine = load("i4")
    >>> assumption_sentence(rests_on(engine, amplitudes(engine))[-1])
    'Unverified: firing_order.'
    """
    sized = each.moved is not None or _is_doubt(each)
    return _line(each) if sized else assumption_lines([each])[0]


def leading_lines(found: Sequence[Assumption]) -> tuple[list[str], int]:
    """The first of these sentences and those on what is not there at all, as on a first screen.

    With them how many assumptions they are not about; nothing of none.
    """
    lines = _told(found)
    parts = [each for each in lines if _is_part(each[1])]
    others = lines[len(parts) :]
    kept = [*parts, *others[:1], *(each for each in others[1:] if _is_absent(each[1]))]
    return [line for line, _of in kept], len(found) - sum(len(of) for _line, of in kept)


def part_lines(names: Sequence[str]) -> list[str]:
    """The sentence on parts that an engine has and its file leaves out; none of none.

    >>> part_lines(["balance rod", "balance shaft"])
    ['The engine has these parts, which its file leaves out and no number includes: balance rod, \
balance shaft.']
    """
    return [_(OTHERS["not modelled"], paths=part_names(names))] if names else []


def part_names(names: Sequence[str]) -> str:
    """Parts that a file leaves out, usual ones in the reader's language."""
    return ", ".join(_(name) if name in PARTS else name for name in names)


PARTS = (
    N_("balance rod"),
    N_("balance shaft"),
    N_("balance shafts"),
    N_("counter-rotating balance shaft"),
    N_("second-order moment compensators"),
    N_("torsional vibration damper"),
)
"""What engines of the catalog have besides their files."""


def _is_part(found: Sequence[Assumption]) -> bool:
    return all(each.status == "not modelled" for each in found)


def _is_absent(found: Sequence[Assumption]) -> bool:
    """Whether these are what is missing or left out, and nobody knows how much it matters."""
    return all(each.status in FIRST and each.moved is None for each in found)


def _told(
    found: Sequence[Assumption], count: int = MOST_TOLD
) -> list[tuple[str, list[Assumption]]]:
    """The sentences, each with the assumptions that it is about.

    Parts that are not modelled and doubts of no known size stand first, then all by its effect; a
    doubt has a sentence whatever its effect is.
    """
    doubtful = [each for each in found if each.status == "doubtful" and each.moved is None]
    parts = _together(found, "not modelled")
    large = [each for each in found if each not in doubtful]
    least = TOLD - UNMOVED  # a trial of a per cent mostly moves a per cent
    large = [
        each
        for each in large
        if (each.effect >= least and _is_seen(each)) or _lifts(each) or _is_doubt(each)
    ]
    most = [each for each in large if not each.named and not _is_doubt(each)][:count]
    told = [each for each in large if each.named or _is_doubt(each) or each in most]
    lines = [*parts, *((_line(each), [each]) for each in doubtful)]
    rest = [each for each in found if each not in (*told, *doubtful)]
    whole = [line for status in FIRST for line in _together(rest, status)]
    small = [each for each in rest if each.moved is not None]
    least = max((each.effect for each in small), default=0.0)
    last = [each for each in told[1:] if not _is_doubt(each) and each.effect < least]
    lines += [(_line(each), [each]) for each in told[:1]]
    lines += whole  # of what is not there at all nobody knows how much it matters
    lines += [(_line(each), [each]) for each in told[1:] if each not in last]
    if small:
        lines.append((_("Of less effect: {paths}.", paths=_paths(small)), small))
    lines += [(_line(each), [each]) for each in last]
    lines += [line for status in LAST for line in _together(rest, status)]
    return lines


def _is_seen(each: Assumption) -> bool:
    """Whether the figure that it moves most is another one in the digits that are printed."""
    own = each.moved
    return own is None or own.trial or span_text(own) != size_text(own.now, own.unit)


FIRES = {"spark": N_("spark ignition"), "compression": N_("compression ignition")}
"""How a usual cycle is ignited."""


def _doubted(each: Assumption) -> str:
    """A doubt, with what may be meant and the figure that it moves most, where that is known."""
    reason = _ended(each.reason)
    if each.moved is None or each.effect < SIGNIFICANT:
        return reason
    words = _words(each, each.moved)
    if each.low != each.high:
        ends = {"low": value_text(each, each.low), "high": value_text(each, each.high)}
        between = _("With {low} to {high} the {figure} is {sizes}, not {now}.", **words | ends)
        return passage([reason, between])
    meant = value_text(each, each.high)
    return passage(
        [reason, _("With {meant} the {figure} is {sizes}, not {now}.", meant=meant, **words)]
    )


def _ended(reason: str) -> str:
    """A reason as a sentence; of a question the mark is its end."""
    return (
        reason
        if reason.endswith(("?", "\N{FULLWIDTH QUESTION MARK}", ".", "。"))
        else _("{reason}.", reason=reason)
    )


def _together(found: Sequence[Assumption], status: str) -> list[tuple[str, list[Assumption]]]:
    """A sentence on all of a status of which it is not known how much they move, by their kinds."""
    own = [each for each in found if each.moved is None and each.status == status]
    kinds: dict[str, list[Assumption]] = {}
    for each in own:
        kinds.setdefault(each.sentence or OTHERS[status], []).append(each)
    return [(_(kind, paths=_paths(alike)), alike) for kind, alike in kinds.items()]


def _is_doubt(each: Assumption) -> bool:
    return each.status == "doubtful"


def _lifts(each: Assumption) -> bool:
    return each.moved is not None and bool(each.moved.lifting)


def _paths(found: Sequence[Assumption]) -> str:
    return ", ".join(dict.fromkeys(map(_named, found)))


OTHERS = {
    "not modelled": N_(
        "The engine has these parts, which its file leaves out and no number includes: {paths}."
    ),
    "missing": N_("Not in the file, counted as zero: {paths}."),
    "left out": N_("Not in these numbers: {paths}."),
    "assumed": N_("Assumed: {paths}."),
    "estimated": N_("Estimated: {paths}."),
    "unverified": N_("Unverified: {paths}."),
}
"""Sentences for those of which it is not known how much they move, by status."""
FIRST = ("missing", "left out")
"""Of these the sentences that stand behind the first of all, on the first screen."""
LAST = ("assumed", "estimated", "unverified")
"""Of these those that stand behind all others."""


def _line(each: Assumption) -> str:
    """One assumption with what it moves most, and the mounts that lift off in its range.

    With the ends that were meant and make no engine.
    """
    own = each.moved
    said = [_doubted(each) if _is_doubt(each) else _moving(each)]
    names = "" if own is None else ", ".join(own.lifting)
    if names:
        said.append(_("Somewhere in that range a mount lifts off: {names}.", names=names))
    for far, reason in () if own is None else own.beyond:
        end = value_text(each, each.low if far < float(each.low or 0) else each.high)
        meant = {"end": end, "far": value_text(each, far), "reason": reason}
        said.append(_("Beyond {end} the file makes no engine; at {far}: {reason}.", **meant))
    return passage(said)


def _words(each: Assumption, own: Moved) -> dict[str, str]:
    """What sentences on the figure that an assumption moves most are made of."""
    return {
        "path": each.path,
        "reason": _(each.reason),
        "figure": figure_name(own),
        "sizes": span_text(own),
        "now": size_text(own.now, own.unit),
    }


def _moving(each: Assumption) -> str:
    """One assumption with what it moves most."""
    own = each.moved
    assert own is not None  # noqa: S101  # asked before
    words = _words(each, own)
    if not _is_seen(each):
        unseen = _("No figure moves in its first three digits.")
        if each.status != "assumed" or each.value is None:
            return passage([_("{path}: {reason}.", **words), unseen])
        value = value_text(each, each.value)
        return passage([_("{path}: {value} assumed, {reason}.", **words, value=value), unseen])
    if own.trial and not own.now:
        size = size_text(own.high, own.unit)
        return _(
            "{path}: {reason}. A per cent of it makes the {figure} {size}.", **words, size=size
        )
    if own.trial:
        share = max(abs(own.low - own.now), abs(own.high - own.now)) / (abs(own.now) or inf)
        return _(
            "{path}: {reason}. Each per cent of it moves the {figure} by {share} %.",
            **words,
            share=number(100 * share, digits=2),
        )
    if each.named:
        return _with_other(each, words)
    if each.status == "left out" and "ignition" in dict(each.values) and each.low is not None:
        ends = {"low": value_text(each, each.low), "high": value_text(each, each.high)}
        ignition = _(FIRES[dict(each.values)["ignition"]])
        if not own.now:  # what is not computed is not zero
            return _(
                "{path}: {reason}. With a usual cycle ({ignition}, imep {low} to {high}) the "
                "{figure} is {sizes}.",
                **words | ends,
                ignition=ignition,
            )
        return _(
            "{path}: {reason}. With a usual cycle ({ignition}, imep {low} to {high}) the {figure} "
            "is {sizes}, not {now}.",
            **words | ends,
            ignition=ignition,
        )
    if "lacks" in dict(each.values):
        return _with_lacking(each, own, words)
    if each.status == "left out" and each.low == each.high:
        return _("{path}: {reason}. With it the {figure} is {sizes}, not {now}.", **words)
    if each.path == "crankshaft.weight":
        factor = dict(each.values)["factor"]
        if factor is None:
            return _(
                "{path}: {reason}. With two on the end webs the {figure} is {sizes}, not {now}.",
                **words,
            )
        return _(
            "{path}: {reason}. With usual ones (all rotating masses and {share} % of the "
            "reciprocating masses) the {figure} is {sizes}, not {now}.",
            **words,
            share=number(100 * factor),
        )
    return _between(each, own, words)


def _with_lacking(each: Assumption, own: Moved, words: Mapping[str, str]) -> str:
    """What is left out for want of a bore or a speed, with what usual ones would change."""
    words = {**words, "low": value_text(each, each.low), "high": value_text(each, each.high)}
    of_bore = dict(each.values)["lacks"] == "cylinder.bore"
    words["kind"] = str(dict(each.values)["kind"])
    if not own.now:  # what is not computed is not zero
        return (
            _(
                "{path}: {reason}. With a bore of {low} to {high} (type {kind}) the {figure} is "
                "{sizes}, not in these numbers.",
                **words,
            )
            if of_bore
            else _(
                "{path}: {reason}. With a speed of {low} to {high} (type {kind}) the {figure} is "
                "{sizes}, not in these numbers.",
                **words,
            )
        )
    if of_bore:
        return _(
            "{path}: {reason}. With a bore of {low} to {high} (type {kind}) the {figure} is "
            "{sizes}, not {now}.",
            **words,
        )
    return _(
        "{path}: {reason}. With a speed of {low} to {high} (type {kind}) the {figure} is {sizes}, "
        "not {now}.",
        **words,
    )


def _with_other(each: Assumption, words: Mapping[str, str]) -> str:
    """One of two choices with what the other one moves most."""
    words = {**words, "value": str(each.value), "other": dict(each.values)["other"]}
    if words["other"] == words["value"]:
        return _(
            "{path}: {value} assumed, {reason}. Given, so that the load takes the brake torque, "
            "the {figure} is {sizes}, not {now}.",
            **words,
        )
    if each.path == "gas.friction":
        return _(
            "{path}: {value} assumed, {reason}. With {other} and the same ignition the {figure} is "
            "{sizes}, not {now}.",
            **words,
        )
    return _(
        "{path}: {value} assumed, {reason}. With {other} the {figure} is {sizes}, not {now}.",
        **words,
    )


def _between(each: Assumption, own: Moved, words: Mapping[str, str]) -> str:
    """One assumption with what it moves most between the ends of its range."""
    words = {**words, "low": value_text(each, each.low), "high": value_text(each, each.high)}
    pins = dict(each.values).get("pins")
    if pins is not None:
        return _(
            "{path}: {reason}. With {low} to {high}, and a throw_mass of {least} to {most}, the "
            "{figure} is {sizes}, not {now}.",
            **words,
            least=value_text(each, pins[0]),
            most=value_text(each, pins[1]),
        )
    at_an_end = rounded(own.now) in (rounded(own.low), rounded(own.high))
    if each.status == "assumed" and each.value is not None and at_an_end:
        return _(
            "{path}: {value} assumed, {reason}. From {low} to {high} the {figure} is {sizes}; "
            "{now} as assumed.",
            **words,
            value=value_text(each, each.value),
        )
    if each.status == "assumed" and each.value is not None:
        return _(
            "{path}: {value} assumed, {reason}. From {low} to {high} the {figure} is {sizes}, not "
            "{now}.",
            **words,
            value=value_text(each, each.value),
        )
    if at_an_end and own.low < own.high:
        return _(
            "{path}: {reason}. With {low} to {high} the {figure} is {sizes}; {now} as it is.",
            **words,
        )
    return _("{path}: {reason}. With {low} to {high} the {figure} is {sizes}, not {now}.", **words)


def _named(each: Assumption) -> str:
    """The key path, with the value that is assumed, or the reason where it says what to do."""
    if each.status == "not modelled":
        return part_names([str(each.value)])
    if each.explained:
        return f"{each.path} ({_(each.reason)})"
    value = value_text(each, each.value) if each.status == "assumed" else ""
    return f"{each.path} ({value})" if value else each.path


def assumption_facts(found: Sequence[Assumption]) -> dict[str, Any]:
    """The same for machines, under `rests_on`."""
    return {"rests_on": [_object(each) for each in found]} if found else {}


def _object(each: Assumption) -> Mapping[str, Any]:
    own = each.moved
    moves = None
    if own is not None:
        moves = {
            "quantity": own.quantity,
            "order": own.order,
            "unit": own.unit,
            "now": own.now,
            "low": own.low,
            "high": own.high,
            "effect": own.effect,
            "trial": own.trial,
            **({"lifting": list(own.lifting)} if own.lifting else {}),
            **({"no_engine_at": [end for end, _why in own.beyond]} if own.beyond else {}),
        }
    return {
        "status": each.status,
        "path": each.path,
        "reason": each.reason,
        "value": each.value,
        "unit": each.unit,
        **({"low": None, "high": None} if each.named else {"low": each.low, "high": each.high}),
        **({"other": dict(each.values)["other"]} if each.named else {}),
        **({"lacks": lacks} if (lacks := dict(each.values).get("lacks")) else {}),
        **({"throw_mass": list(pins)} if (pins := dict(each.values).get("pins")) else {}),
        "moves": moves,
    }


def assumption_remarks(
    found: Sequence[Assumption], *, of: str = "", at: str = ""
) -> tuple[Remarks, ...]:
    """The sentences as a part of a Document; none where nothing is.

    Of one engine by name, or at some values of many.

    Where nothing but what is left out or not modelled is among them, nothing rests on it, and they
    have no head.
    """
    lines = assumption_lines(found)
    if not lines:
        return ()
    if of:
        head = [_("{name} rests on:", name=of)]
    else:
        bare = all(each.status in ("left out", "not modelled") for each in found)
        head = [_("With {values} this rests on:", values=at)] if at else [_("This rests on:")]
        head = [] if bare else head
    return (Remarks((*head, *lines), kind="doubt"),)


def side_by_side(
    found: Sequence[Sequence[Assumption]], names: Sequence[str]
) -> tuple[tuple[Remarks, ...], tuple[Remarks, ...]]:
    """What matters most of each engine, for the first screen, and for the end the rest of it.

    On the first screen are the largest effect of all and a speed that is not that of the file, too;
    what is not there at all, of no known size, gives way to what has one.
    """
    first, rest = [], []
    most = PAIRED if len(names) <= 2 else 1
    largest = max((each.effect for own in found for each in own), default=0.0)
    for own, name in zip(found, names, strict=True):
        told = _told(own)
        count = most + any(each.status == "not modelled" for each in own)
        first_ones = sorted(range(len(told)), key=lambda place: _is_absent(told[place][1]))[:count]
        leads = [
            index in first_ones
            or any(each.path == "speed" or each.effect == largest > 0 for each in of)
            for index, (_line, of) in enumerate(told)
        ]
        leading, others = (
            [line for (line, _of), lead in zip(told, leads, strict=True) if lead is wanted]
            for wanted in (True, False)
        )
        if leading:
            head = _("{name} rests on:", name=name)
            first.append(Remarks((head, *leading), kind="doubt"))
        if others:
            head = _("{name} also rests on:", name=name)
            rest.append(Remarks((head, *others), kind="doubt"))
    return tuple(first), tuple(rest)
