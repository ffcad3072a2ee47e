"""The free response: the paths of both ends of the crankshaft of an unmounted engine."""

from __future__ import annotations

from collections.abc import Sequence
from math import pi
from typing import NamedTuple

import numpy as np

from crankstar import spectra
from crankstar.analysis.document import Column, Table, Value
from crankstar.language.alike import as_given, of_any
from crankstar.language.messages import N_, _
from crankstar.language.numbers import NEGLIGIBLE, number
from crankstar.page.orders import free_response as free
from crankstar.page.proportions import proportions
from crankstar.page.records import Pair, Vectors, Whirl
from crankstar.report.gallery import Gallery
from crankstar.report.markup import figure, figures, parts_html, section
from crankstar.report.subject import Subject
from crankstar.spectra import Complex, Spectrum
from crankstar.tables.html import paragraph, text
from crankstar.tables.paths import shape

SIDE, MARGIN = 180.0, 40.0
"""px of the drawing of a path, and around it."""
SAMPLES = 721
INK = 'fill="currentColor"'
FRONT, REAR = N_("The path of the front end."), N_("The path of the rear end.")


class End(NamedTuple):
    """An end of the crankshaft: a heading, a caption, its motion order by order."""

    name: str
    caption: str
    motion: Spectrum


def free_response(subject: Subject, gallery: Gallery) -> str:  # noqa: ARG001 - all pages are made alike
    """The paths of the front and the rear end, with the estimates of mass and inertia."""
    ends = _ends(subject)
    size = max(high - low for low, high in zip(subject.scene.low, subject.scene.high, strict=True))
    greatest = max(spectra.peak(end.motion).value for end in ends)
    lead = paragraph(
        _(
            "The paths of the ends of the crankshaft, seen from the front, if the engine were "
            "unmounted: the sum of these orders. The paths are the same at every speed."
        )
    )
    sentences = subject.lines(lambda each: _whirl(each).assumed)
    assumed = "".join(paragraph(line, "doubt") for line in sentences)
    if greatest < NEGLIGIBLE * size:
        rest = paragraph(_("The engine is at rest: these orders have no force and no couple."))
        return section(_("Free response"), rest + assumed, name="whirl")
    scale, unit = (1e6, "µm") if subject.scene.length_unit == "m" else (1e3, "r / 1000")
    drawn = [figure(_path(end, greatest, scale, unit), end.caption) for end in ends]
    paths = parts_html(subject.parts(lambda each: [_table(each, scale, unit)]))
    return section(_("Free response"), lead + figures(drawn) + paths + assumed, name="whirl")


def _whirl(subject: Subject) -> Whirl:
    """The free response of the drawn orders."""
    along = proportions(subject.engine).along
    return free(subject.engine, subject.shown.orders, along=along)


def _ends(subject: Subject) -> list[End]:
    """The motion of the front and the rear end."""
    whirl, shaft = _whirl(subject), subject.scene.shafts[0]
    return [
        End(_("front end"), _(FRONT), _motion(subject, whirl, shaft.z_to)),
        End(_("rear end"), _(REAR), _motion(subject, whirl, shaft.z_from)),
    ]


def _table(subject: Subject, scale: float, unit: str) -> Table:
    """The path of each end, order by order."""
    ends = _ends(subject)
    greatest = max(spectra.peak(end.motion).value for end in ends)
    rows: list[tuple[Value, ...]] = [
        (order, *_paths(ends, order, scale, greatest)) for order in subject.shown.orders
    ]
    peaks = [cell for end in ends for cell in ("", spectra.peak(end.motion).value * scale)]
    rows.append((_("all"), *peaks))
    columns = [Column(_("order"))]
    for end in ends:
        columns += [Column(end.name, kind="text"), Column(_("greatest"), unit)]
    return Table(_("Paths by order"), tuple(columns), tuple(rows))


def _motion(subject: Subject, whirl: Whirl, z: float) -> Spectrum:
    """The motion of the crank axis at z: shift + (z - z of the centre) tilt + i turn * offset."""
    up, right, along = whirl.centre
    orders, sense = np.array(subject.shown.orders), subject.engine.sense
    shift, tilt = _vectors(whirl.shift), _vectors(whirl.tilt)
    turn = spectra.real_signal(orders, _complex(whirl.turn))
    aside = 1j * complex(-up, -right)
    mates = (turn.forward, turn.backward) if sense > 0 else (turn.backward, turn.forward)
    forward, backward = (
        shift[way] + (z - along) * tilt[way] + aside * mate for way, mate in enumerate(mates)
    )
    return Spectrum(orders, forward, backward, sense)


def _vectors(given: Vectors) -> tuple[Complex, Complex]:
    return _complex(given.forward), _complex(given.backward)


def _complex(pairs: Sequence[Pair]) -> Complex:
    return np.array([complex(*pair) for pair in pairs])


def _paths(ends: Sequence[End], order: float, scale: float, greatest: float) -> list[Value]:
    """Path and greatest value of each end."""
    out: list[Value] = []
    for end in ends:
        motion = spectra.selected(end.motion, [order])
        path = spectra.ellipse(complex(motion.forward[0]), complex(motion.backward[0]))
        moves, name = path.semi_major > NEGLIGIBLE * greatest, (end.name, order)
        moved = of_any(("moved", *name), [True] * moves)
        words = _("none") if not moved else ""  # of what other masses move the range says enough
        if as_given(("moves", *name), moves):
            words = shape(path, greatest)
        out += [words, path.semi_major * scale if moves else 0.0]
    return out


def _path(end: End, greatest: float, scale: float, unit: str) -> str:
    """The path as a drawing with equal scales, a dot where it is at theta = 0."""
    turns = spectra.period(end.motion)
    run = np.asarray(spectra.value(end.motion, np.linspace(0, 2 * pi * turns, SAMPLES * turns)))
    middle, reach = SIDE / 2 + MARGIN, SIDE / 2 / greatest
    x, y = middle + np.imag(run) * reach, middle - np.real(run) * reach
    line = "L".join(f"{a:.1f} {b:.1f}" for a, b in zip(x, y, strict=True))
    whole = SIDE + 2 * MARGIN
    ends = f"H{whole - MARGIN + 8:g}M{middle:g} {whole - MARGIN + 8:g}V{MARGIN - 8:g}"
    axes = f"M{MARGIN - 8:g} {middle:g}{ends}"
    label = f"{number(float(f'{greatest * scale:.2g}'))} {unit}"
    long = float(f"{greatest * scale:.2g}") / scale * reach
    bar = f"M{middle:g} {whole - 14:g}h{long:g}m0 -3v6M{middle:g} {whole - 17:g}v6"
    size = f'width="{whole:g}" height="{whole:g}" viewBox="0 0 {whole:g} {whole:g}"'
    return (
        f'<svg role="img" xmlns="http://www.w3.org/2000/svg" {size} '
        f'font-family="sans-serif" font-size="12">'
        f"<title>{text(end.caption)}</title>"
        f'<path d="{axes}" fill="none" stroke="currentColor" stroke-opacity="0.35"/>'
        f'<text x="{middle:g}" y="{MARGIN - 14:g}" text-anchor="middle" {INK}>{_("up")}</text>'
        f'<text x="{whole - 4:g}" y="{middle - 6:g}" text-anchor="end" {INK}>{_("right")}</text>'
        f'<path d="M{line}" fill="none" stroke="#d1382a" stroke-width="1.6"/>'
        f'<circle cx="{x[0]:.1f}" cy="{y[0]:.1f}" r="4" fill="#d1382a"/>'
        f'<path d="{bar}" fill="none" stroke="currentColor"/>'
        f'<text x="{middle - 6:g}" y="{whole - 10:g}" text-anchor="end" {INK}>{text(label)}</text>'
        "</svg>"
    )
