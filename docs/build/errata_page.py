"""The page of errata, part by part; formulas and plots are derived when the page is built."""

from __future__ import annotations

from html import escape
from itertools import groupby

from crankstar import charts
from crankstar.derive.algebra import typeset
from crankstar.derive.algebra.formula import Formula
from crankstar.derive.errata import Erratum, confirmed, curves, errata, series_errors, sources

NAMES = {key: name.removeprefix("V8 ") for key, name in sources().items()}
SIDES = {"up": "up", "right": "to the right", "along": "along the bank", "": ""}
LOWERED = "₀₁₂₃₄₅₆₇₈₉"


def page(source: str) -> str:
    """The errors of one source, results with plots first, then steps; then what is correct."""
    own = errata(source)
    parts = [
        _results(list(group))
        for _, group in groupby(
            (one for one in own if one.drawn), key=lambda one: (one.group, one.place)
        )
    ]
    steps = [one for one in own if one.kind == "step"]
    lines = [one for one in own if one.kind in ("line", "angle")]
    if steps:
        parts.append(_listed("Steps", "correct is", steps))
    if lines:
        parts.append(_listed("Misprints", "it must be", lines))
    told = [one.words for one in confirmed() if one.source == source]
    parts.append(
        "\n".join([f"### Correct: {NAMES[source]}", "", *(f"* {words}" for words in told)])
    )
    return "\n\n".join(parts)


def _results(group: list[Erratum]) -> str:
    """The components of one sum: heading, source, formulas side by side, the slip, the plots."""
    first = group[0]
    series = first.kind == "series"
    head = f"### {_heading(first)}: {NAMES[first.source]}"
    about = [f"Printed in {first.place} [@{first.source}]."]
    about.append(
        "L is rod length over stroke."
        if series
        else f"The unit is {_math(first.unit)}."
        if first.unit
        else ""
    )
    if first.letter:
        about.append("By its arms, the page has the even bank in front by b.")
    rows = ["| | printed | correct |", "|---|---|---|"]
    for one in group:
        printed = _math(one.printed) if one.printed is not None else one.text
        subject = f"A{LOWERED[one.order]}" if series else SIDES[one.component] or "clockwise"
        rows.append(f"| {_anchor(one)}{subject} | {printed} | {_math(one.ours)} |")
    slips = dict.fromkeys((one.step, one.slip) for one in group)
    words = [f"The error is in our step “{step}”: {slip}" for step, slip in slips]
    figures = "\n".join(_figure(one) for one in group)
    return "\n\n".join(
        [
            head,
            " ".join(about),
            "\n".join(rows),
            *words,
            f'<div class="errata" markdown="0">\n{figures}\n</div>',
        ]
    )


def _heading(one: Erratum) -> str:
    title = one.title if one.kind != "series" else f"series of A{LOWERED[one.order]}"
    return title[0].upper() + title[1:]


def _listed(head: str, lead: str, wrong: list[Erratum]) -> str:
    """Wrong steps as a list, each reason once."""
    out = [f"### {head}: {NAMES[wrong[0].source]}", ""]
    told = ""
    for one in wrong:
        words = "The same." if one.slip == told else one.slip
        told = one.slip
        subject = (
            f"{one.title}, {SIDES[one.component]} ({one.place})"
            if one.kind == "step"
            else one.place
        )
        printed = _math(one.printed) if one.kind == "step" and one.printed is not None else one.text
        out.append(
            f"* {_anchor(one)}{subject[0].upper() + subject[1:]}: printed {printed}; {lead} "
            f"{_math(one.ours)}. {words}"
        )
    return "\n".join(out)


def _anchor(one: Erratum) -> str:
    return f'<a id="{one.id}"></a>'


def _math(formula: Formula) -> str:
    """A formula as MathML, with its text for what cannot show it."""
    shown = escape(typeset.text(formula), quote=True)
    return f'<math alttext="{shown}">{typeset.mathml(formula)}</math>'


def _figure(one: Erratum) -> str:
    """The plot of an erratum, with the colours of the page for its text."""
    return f'<figure class="erratum">{drawing(one).replace(charts.GREY, "currentColor")}</figure>'


def drawing(one: Erratum) -> str:
    """The plot of an erratum as SVG."""
    if one.kind == "series":
        errors = series_errors(one)
        chart = charts.over_rods(ratio=errors.ratio, printed=errors.printed, ours=errors.ours)
        error = "the error of the printed and of the correct series over the rod length"
        title = f"{_heading(one)}: {error}"
        return charts.svg(chart, title)
    found = curves(one)
    unit = " ".join(
        filter(None, (typeset.text(one.unit) if one.unit is not None else "", one.letter))
    )
    named = {"force": "force", "couple": "couple", "roll": "couple", "": ""}[one.quantity]
    axis = f"{named} {SIDES[one.component]}".strip() + f" ({unit})"
    chart = charts.judged(
        theta=found.theta,
        printed=found.printed,
        ours=found.ours,
        momentum=found.momentum,
        axis=axis,
    )
    return charts.svg(
        chart, f"{_heading(one)}, {axis}: printed, correct and from momentum, over one turn"
    )
