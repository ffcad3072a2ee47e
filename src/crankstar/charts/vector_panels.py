"""Vectors of cylinders with their numbers, and their sum, as a panel of a figure."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from crankstar.charts.drawing import BLUE, ORANGE, Panel
from crankstar.charts.labels import Label, gathered
from crankstar.charts.plane import (
    BAR,
    Arrow,
    Frame,
    Plane,
    Stroke,
    label_margin,
    picture,
    round_frame,
    scale_bar,
)
from crankstar.language.numbers import numbers_text
from crankstar.spectra import Complex

NEAR = 0.03
"""Share of the longest vector within which heads share a label."""


def vectors_panel(
    vectors: Complex, total: complex, numbers: Sequence[int], *, width: float, title: str
) -> Panel:
    """Vectors of cylinders, 1 up and i to the right, with their numbers, and their sum."""
    longest = float(np.abs(vectors).max())
    groups = [  # cylinders whose vectors end at one place; those without length are left out
        group
        for group in gathered(vectors.tolist(), NEAR * longest)
        if abs(vectors[group[0]]) > NEAR * longest
    ]
    words = [numbers_text([numbers[n] for n in group]) for group in groups]
    frame = _frame(vectors, total, width, max(0.6 * label_margin(words), 24.0))
    cross = [
        Stroke((complex(frame.bottom, 0), complex(frame.top, 0)), width=0.6),
        Stroke((1j * frame.left, 1j * frame.right), width=0.6),
    ]
    bar, text = scale_bar(frame, "")
    arrows = [Arrow(v, colour=BLUE) for v in sorted(vectors.tolist(), key=lambda v: -abs(v))]
    labels: list[Label] = []
    for group, said in zip(groups, words, strict=True):
        tip = complex(vectors[group[0]])
        labels.append(Label(said, tip, tip / abs(tip), colour=BLUE))
    if total:
        arrows.insert(0, Arrow(total, colour=ORANGE, width=4))
    plane = Plane(tuple(arrows), (*cross, bar), labels=tuple(labels), notes=(text,))
    return picture(plane, frame, title=title)


def _frame(vectors: Complex, total: complex, width: float, margin: float) -> Frame:
    """A square picture with all heads and the head of the sum in it."""
    ends = np.array([0j, *vectors, total])
    ups, rights = np.real(ends), np.imag(ends)
    middle = complex(ups.max() + ups.min(), rights.max() + rights.min()) / 2
    reach = max(np.ptp(ups), np.ptp(rights)) / 2 or 1.0
    own = round_frame(float(reach), width=width, margin=margin, below=BAR)
    return Frame(
        own.left + middle.imag,
        own.right + middle.imag,
        own.bottom + middle.real,
        own.top + middle.real,
        own.scale,
    )
