"""The middle of a report: crankshaft and strokes, orders and their vectors, derivations, another engine beside it."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from fractions import Fraction

from rich.console import Group

from crankstar import derive, description, tables
from crankstar.derive import documents
from crankstar.fault import EngineError
from crankstar.report.gallery import Gallery
from crankstar.report.markup import figure, figures, of, paragraph, section
from crankstar.report.matter import Matter, Quantity
from crankstar.stroke_table import stroke_tables
from crankstar.views import views
from crankstar.wording import number, timing_lines

BOTH: tuple[Quantity, Quantity] = ("force", "couple")
FULL = (1.0, 2.0)
"""The orders whose derivation is given step by step unless orders are named; of the others the result."""
MANY = 16
"""Pistons from which on only results are given: step by step an order of a Deltic takes ten pages."""

LEVEL = re.compile(r"(?<=<h)[23](?=>)|(?<=</h)[23](?=>)")
"""The level of a heading of a derivation, which stands in a section of the report."""

Page = Callable[[Matter, Gallery], str]
"""A section of the report."""


def looks(matter: Matter, gallery: Gallery) -> str:  # noqa: ARG001 - all pages are made alike
    """The engine from the front, the side and above, and what of its proportions is assumed."""
    captions = ("From the front.", "From the right side; the front is at the left.", "From above; the front is at the left.")
    drawn = [figure(*pair) for pair in zip(views(matter.scene, name=matter.engine.name), captions, strict=True)]
    assumed = "".join(paragraph(line, "note") for line in matter.scene.assumed)
    told = paragraph("Drawn at θ = 0 to one scale, the crankshaft in red.")
    return section("Views", told + figures(drawn, "views") + assumed, name="views")


def crankshaft(matter: Matter, gallery: Gallery) -> str:
    """Throws, cylinders, harmonics as tables, the crank star, and every shaft from the side."""
    engine = matter.engine
    drawn = [
        gallery.figure("crank-star", "The throws seen from the front; the numbers are those of the cylinders."),
        gallery.figure("shaft", "The shaft from the side, with the arms of the forces."),
    ]
    shown = Group(description.rotors(engine), description.cylinders(engine), description.harmonics(engine))
    return section("Crankshaft and cylinders", figures(drawn) + of(shown), name="crankshaft")


def strokes(matter: Matter, gallery: Gallery) -> str:
    """Strokes, valve events and exhausts."""
    try:
        shown = stroke_tables(matter.engine)
    except EngineError:
        told = "The engine file gives no firing order, and without one nobody knows which stroke a cylinder is on."
        if matter.engine.firing_order:
            told = "The crankshafts turn at different speeds; their cylinders have no common working cycle."
        lines = "".join(paragraph(line) for line in timing_lines(matter.engine)) if matter.engine.valves is not None else ""
        return section("Strokes", paragraph(told) + lines, name="strokes")
    drawn = [
        gallery.figure("stroke-chart", "When intake and exhaust are open, and when each cylinder fires."),
        gallery.figure("firing-ring", "The cylinders round the working cycle."),
    ]
    rest = Group(*shown.renderables[1:]) if isinstance(shown, Group) else shown  # the heading is on the first page
    return section("Strokes", figures(drawn) + of(rest), name="strokes")


def orders(matter: Matter, gallery: Gallery) -> str:
    """The table of orders, the spectrum, and the paths of what remains."""
    shown = tables.report(matter.shown)
    rest = Group(*shown.renderables[1:]) if isinstance(shown, Group) else shown
    drawn = [gallery.figure("spectrum", "How great force, couple and roll of each order become.", speed=matter.at)]
    paths = [
        gallery.figure(
            "hodograph", f"The path of the {quantity} of order {number(order)}.", order=order, quantity=quantity, speed=matter.at
        )
        for quantity in BOTH
        for order in matter.left(quantity)
    ]
    return section("Orders", of(rest) + figures([*drawn, *paths]), name="orders")


def vectors(matter: Matter, gallery: Gallery) -> str:
    """The vector star and the polygon of every order that matters."""
    out: list[str] = []
    for quantity in BOTH:
        for order in matter.pushing(quantity):
            asked = {"order": order, "quantity": quantity, "speed": matter.at}
            name = f"{quantity} of order {number(order)}"
            star = gallery.figure("vector-star", f"The vectors of the cylinders: {name}.", **asked)
            polygon = gallery.figure("polygon", f"The same head to tail: {_sum(matter, quantity, order)}.", **asked)
            out.append(f'<div class="pair">{star}{polygon}</div>')
    return section("Vector stars and polygons", "".join(out), name="vectors")


def _sum(matter: Matter, quantity: Quantity, order: float) -> str:
    return f"the {quantity} that remains" if order in matter.left(quantity) else "closed, nothing remains"


def over_the_turn(matter: Matter, gallery: Gallery) -> str:
    """Force, couple and roll over the crank angle."""
    drawn = [
        gallery.figure("over-turn", f"{quantity.capitalize()} over the crank angle.", quantity=quantity, speed=matter.at)
        for quantity in ("force", "couple", "torque")
        if quantity != "couple" or matter.left(quantity)
    ]
    return section("Over the crank angle", figures(drawn), name="turn")


def derivations(matter: Matter, gallery: Gallery) -> str:  # noqa: ARG001 - all pages are made alike
    """How each order comes about, exactly: step by step for those that matter most, the result of the others."""
    chapters: list[derive.Chapter] = []
    proved: list[str] = []
    for quantity in BOTH:
        for order in matter.shown.orders:
            if quantity == "couple" and not matter.pushing("couple"):
                continue
            try:
                found = derive.derivation(matter.engine, Fraction(order).limit_denominator(1000), quantity, speed=matter.at)
            except derive.DerivationError:
                continue
            if found.zero and not found.why:
                proved.append(f"{quantity} of order {number(order)}")
            whole = len(matter.engine.cylinders) <= MANY and (matter.orders or order in FULL)
            chapters.append(found.chapter if whole else replace(found.chapter, steps=found.steps[-2:-1]))
    if not chapters:
        return ""
    told = f"Proved to be exactly zero: {', '.join(proved)}." if proved else "None of these orders is exactly zero."
    if len(matter.engine.cylinders) > MANY:
        told += " Given here are the results; crankstar derive gives every step."
    shown = "".join(documents.html_parts(chapters))
    return section("Derivations", paragraph(told) + LEVEL.sub(_lower, shown), name="derivations")


def _lower(level: re.Match[str]) -> str:
    return str(int(level.group()) + 1)


def beside(matter: Matter, gallery: Gallery) -> str:
    """The other engine: every order of both, and what can be drawn on common axes."""
    other = matter.beside
    if other is None:
        return ""
    pair = [tables.analysis(one, speed=matter.speed) for one in (matter.engine, other)]
    if matter.orders:
        pair = [one._replace(orders=matter.orders, turning=matter.orders) for one in pair]
    speed = matter.at if all(one.real is not None for one in pair) else None
    drawn = [gallery.figure("spectrum", "The spectra of both.", "wide", beside=other, speed=speed)]
    for quantity in BOTH:
        if matter.pushing(quantity):
            caption = f"The path of the {quantity} of all orders."
            drawn.append(gallery.figure("hodograph", caption, "wide", beside=other, quantity=quantity, speed=speed))
    return section(f"Beside {other.name}", of(tables.comparison(pair)) + figures(drawn), name="beside")
