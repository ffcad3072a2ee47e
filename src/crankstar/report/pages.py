"""The middle of a report: views, crankshaft, strokes, orders, vectors, derivations, comparison."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

from crankstar import derive
from crankstar.analyses.strokes.document import tables as stroke_tables
from crankstar.analysis.document import Table
from crankstar.firing.strokes import working_cycle
from crankstar.language.faults import EngineError
from crankstar.language.messages import N_, _
from crankstar.language.numbers import number
from crankstar.mechanics.operating_points import speed_beside
from crankstar.report.gallery import ACROSS, Gallery
from crankstar.report.markup import figure, figures, parts_html, section
from crankstar.report.subject import Quantity, Subject
from crankstar.report.views import SHEET, view
from crankstar.tables import analysis, comparison, engines
from crankstar.tables.conditions import conditions, unit_sentence
from crankstar.tables.headings import timing_lines
from crankstar.tables.html import paragraph
from crankstar.tables.ranges import ranged_side_by_side

BOTH: tuple[Quantity, Quantity] = ("force", "couple")
STEP_BY_STEP = (1.0, 2.0)
"""The orders that are derived step by step unless orders are named; of others the result."""
LONG_TABLE = 12
"""Rows above which a table by throw or by cylinder is in the full report only."""
MANY = 16
"""Pistons above which only results are given; the steps of an order of a Deltic take ten pages."""
CROWDED = 9
"""Pistons above which vectors take the whole width, those against the crank beside the others.

Of many they stay in a column, one star below the other: more than half a page would not hold their
numbers.
"""
LEVEL = re.compile(r"(?<=<h)[23](?=>)|(?<=</h)[23](?=>)")
"""The level of a heading of a derivation, which is in a section of the report."""
PATHS = {
    "force": N_("The path of the force of order {order}."),
    "couple": N_("The path of the couple of order {order}."),
}
ALL_PATHS = {
    "force": N_("The path of the force, all orders."),
    "couple": N_("The path of the couple, all orders."),
}
STARS = {
    "force": N_("The force vectors of order {order}."),
    "couple": N_("The couple vectors of order {order}."),
}
POLYGONS = {
    ("force", True): N_("Head to tail, with the remaining force of order {order}."),
    ("couple", True): N_("Head to tail, with the remaining couple of order {order}."),
    ("force", False): N_("Head to tail: the polygon is closed, no force of order {order} remains."),
    ("couple", False): N_(
        "Head to tail: the polygon is closed, no couple of order {order} remains."
    ),
}
CURVES = {
    "force": N_("Force over the crank angle."),
    "couple": N_("Couple over the crank angle."),
    "torque": N_("Inertia torque over the crank angle."),
}
ZERO = {"force": N_("force of order {order}"), "couple": N_("couple of order {order}")}

Page = Callable[[Subject, Gallery], str]
"""A section of the report."""


def drawings(subject: Subject, gallery: Gallery) -> str:  # noqa: ARG001 - one signature for all
    """The engine from the front, the right side and above, and the assumed proportions."""
    caption = _(
        "Third-angle projection at θ = 0, to one scale: from the front, at its right from the "
        "right side, above that from above. The crankshaft is red."
    )
    assumed = "".join(paragraph(line, "note") for line in subject.scene.assumed)
    drawn = figures([figure(view(subject.engine, SHEET), caption)], "views")
    return section(_("Views"), drawn + assumed, name="views")


def crankshaft(subject: Subject, gallery: Gallery) -> str:
    """Throws, cylinders and harmonics as tables, the crank star, and every shaft from the side."""
    drawn = [
        gallery.figure(
            "crank-star", _("The throws, seen from the front, with the numbers of the cylinders.")
        ),
        gallery.figure("shaft", _("The shaft from the side, with the lever arms of the forces.")),
    ]
    tables = parts_html(subject.parts(_rotor_tables))
    return section(_("Crankshaft and cylinders"), figures(drawn) + tables, name="crankshaft")


def _rotor_tables(subject: Subject) -> list[Table]:
    """Throws and weights; in a full report also cylinders and harmonics."""
    engine = subject.engine
    rotors = engines.rotors(engine)
    parts = [rotors] if subject.full or len(rotors.rows) <= LONG_TABLE else []
    if subject.full:
        parts += [engines.cylinders(engine), *engines.harmonics(engine)]
    return parts


def strokes_page(subject: Subject, gallery: Gallery) -> str:
    """Strokes, valve events and exhausts."""
    engine, name = subject.engine, "strokes"
    try:
        cycle = working_cycle(engine) if engine.firing_order else None
        missing = _("The engine file gives no firing order, so the strokes are unknown.")
    except EngineError:
        cycle = None
        missing = _("The crankshafts differ in speed, so the cylinders have no common cycle.")
    if cycle is None:
        lines = timing_lines(engine) if engine.valves is not None else []
        return section(_("Strokes"), "".join(map(paragraph, [missing, *lines])), name=name)
    drawn = [
        gallery.figure("stroke-chart", _("Open intake and exhaust, and ignition.")),
        gallery.figure("firing-ring", _("The cylinders around the working cycle.")),
    ]
    parts = list(stroke_tables(engine, cycle))
    tables = parts_html(parts if subject.full else parts[:1])
    return section(_("Strokes"), tables + figures(drawn), name=name)


def orders(subject: Subject, gallery: Gallery) -> str:
    """The tables of orders, the spectrum, and the paths of the remaining vectors."""
    at = subject.at
    drawn = [gallery.figure("spectrum", _("Peak force, couple and roll of each order."), speed=at)]
    paths = [(order, quantity) for quantity in BOTH for order in subject.remaining(quantity)]
    if not (subject.full or subject.orders):
        paths = sorted(paths)[:1]
    for order, quantity in paths:
        caption = _(PATHS[quantity], order=number(order))
        options = {"order": order, "quantity": quantity, "speed": at}
        drawn.append(gallery.figure("hodograph", caption, **options))
    notes = "".join(paragraph(line, "note") for line in subject.lines(_conditions))
    tables = parts_html(subject.parts(lambda each: analysis.tables(each.shown)))
    return section(_("Orders"), f"{notes}<div>{tables}</div>{figures(drawn)}", name="orders")


def _conditions(subject: Subject) -> list[str]:
    """What the numbers of the orders are counted in and about."""
    result = subject.shown.best
    return [unit_sentence(subject.engine, result), *conditions(subject.engine, result)]


def vectors(subject: Subject, gallery: Gallery) -> str:
    """The vector star and the polygon of every drawn order."""
    pairs: list[str] = []
    for quantity in BOTH:
        for order in _starred(subject, quantity):
            options = {"order": order, "quantity": quantity, "speed": subject.at}
            if CROWDED < len(subject.engine.cylinders) <= MANY:
                options |= {"kind": "wide", "canvas": ACROSS}
            named = {"order": number(order)}
            remaining = order in subject.remaining(quantity)
            star = gallery.figure("vector-star", _(STARS[quantity], **named), **options)
            caption = _(POLYGONS[quantity, remaining], **named)
            polygon = gallery.figure("polygon", caption, **options)
            pairs.append(f'<div class="pair">{star}{polygon}</div>')
    return section(_("Vector stars and polygons"), "".join(pairs), name="vectors")


def _starred(subject: Subject, quantity: Quantity) -> tuple[float, ...]:
    """The orders with a star; in a short report two of which some is left, of many pistons none."""
    if subject.full or subject.orders:
        return subject.drawn(quantity)
    left = subject.remaining(quantity)
    if len(subject.engine.cylinders) > MANY:  # each star fills half a page
        return ()
    return left[:2]


def over_the_turn(subject: Subject, gallery: Gallery) -> str:
    """Force, couple and torque over the crank angle."""
    drawn = [
        gallery.figure("over-turn", _(caption), quantity=quantity, speed=subject.at)
        for quantity, caption in CURVES.items()
        if quantity != "couple" or subject.remaining("couple")
    ]
    return section(_("Over the crank angle"), figures(drawn), name="turn")


def derivations(subject: Subject, gallery: Gallery) -> str:  # noqa: ARG001 - one signature for all
    """The exact derivation of each order: step by step, or the result alone."""
    if not (subject.full or subject.orders):
        return ""
    from crankstar.derive import documents  # the exact algebra is slow to load

    many = len(subject.engine.cylinders) > MANY
    chapters: list[derive.Chapter] = []
    zero: list[str] = []
    for quantity in BOTH:
        for order in subject.shown.orders:
            if quantity == "couple" and not subject.drawn("couple"):
                continue
            ratio = Fraction(order).limit_denominator(1000)
            try:
                result = derive.derivation(subject.engine, ratio, quantity, speed=subject.at)
            except derive.DerivationError:
                continue
            if result.zero and not result.why:
                zero.append(_(ZERO[quantity], order=number(order)))
            whole = not many and (subject.orders or order in STEP_BY_STEP)
            short = replace(result, steps=result.steps[-2:-1])
            chapters.append(result if whole else short)
    if not chapters:
        return ""
    lead = _("None of these orders is exactly zero.")
    if zero:
        lead = _("Proved to be exactly zero: {quantities}.", quantities=", ".join(zero))
    notes = [lead]
    if subject.ends:
        notes.append(
            _("Numbers here are those of the typical values; their ranges are in section Orders.")
        )
    if many:
        notes.append(_("Only the results are given; `crankstar derive` prints every step."))
    lowered = LEVEL.sub(_lower, "".join(documents.html_parts(chapters)))
    body = "".join(map(paragraph, notes)) + lowered
    return section(_("Derivations"), body, name="derivations")


def _lower(level: re.Match[str]) -> str:
    return str(int(level.group()) + 1)


def beside(subject: Subject, gallery: Gallery) -> str:
    """The other engine: the orders of both as a table and as figures on common axes."""
    other = subject.beside
    if other is None:
        return ""
    both = (subject.engine, other)
    turning = speed_beside(both, subject.speed)
    subject = replace(subject, speed=turning)
    pair = [subject.analysis_of(engine) for engine in both]
    speed = subject.at if all(engine.real is not None for engine in pair) else None
    drawn = [
        gallery.figure(
            "spectrum", _("The spectra of both engines."), "wide", beside=other, speed=speed
        )
    ]
    for quantity in BOTH:
        if subject.drawn(quantity):
            options = {"beside": other, "quantity": quantity, "speed": speed}
            drawn.append(gallery.figure("hodograph", _(ALL_PATHS[quantity]), "wide", **options))
    title = _("Comparison with {engine}", engine=other.name)
    compared = ranged_side_by_side(
        lambda each: comparison.comparison([subject.analysis_of(engine) for engine in each]),
        subject.spreads,
        both,
    )
    compared = comparison.with_shares(compared, both)
    tables = paragraph(compared.title) + parts_html(compared.parts)
    return section(title, tables + figures(drawn), name="beside")
