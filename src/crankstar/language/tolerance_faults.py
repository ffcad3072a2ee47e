"""The sentences of mistakes in the tolerances of an engine file."""

from __future__ import annotations

from crankstar.language.messages import N_, Plural

SENTENCES: dict[str, str | Plural] = {
    "tolerance.no-quantity": N_(
        "{where} is {value}; only a value with a unit, such as a mass, a length or an angle, can "
        "have a tolerance"
    ),
    "tolerance.not-a-number": N_(
        "{where} has the tolerance {value}, not a number; write it as in {example}"
    ),
    "tolerance.negative": N_(
        "{where} has the tolerance {value}; it goes both ways, so give it without a sign"
    ),
    "tolerance.unit": N_(
        "{where} has the tolerance {value}; {dimension} or a share in percent is needed, as in "
        "{example}"
    ),
    "tolerance.share-of-nothing": N_(
        "{where} is 0, of which {value} is nothing; give the tolerance with a unit"
    ),
    "tolerance.half-turn": N_(
        "{where} has the tolerance {value}, more than half a turn both ways, which is any angle; "
        "give a smaller one"
    ),
    "tolerance.too-large": N_(
        "{where} is {nominal} with the tolerance {value}; it must stay above 0, so give a "
        "smaller tolerance"
    ),
}
