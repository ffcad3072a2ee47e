"""Vectors of several kinds in polar diagrams to one scale, each with its name at its head."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from crankstar.charts.canvas import half_width
from crankstar.charts.drawing import BLUE, GREEN, VERMILION, Panel, figure
from crankstar.charts.grammar import Chart
from crankstar.charts.labels import Label
from crankstar.charts.letters import SMALL
from crankstar.charts.plane import Arrow, Plane, picture
from crankstar.charts.polar_grid import ground, polar_grid, values

COLOURS = (BLUE, VERMILION, GREEN)
"""Of the vectors of a panel, in their order."""


class Named(NamedTuple):
    """A vector `up + i*right`: an angle of 0 points up, 90 deg to the right."""

    name: str
    vector: complex


class Diagram(NamedTuple):
    """A panel: its title and its vectors."""

    title: str
    vectors: tuple[Named, ...]


def polar_vectors(
    diagrams: Sequence[Diagram], *, title: str, subtitle: Sequence[str] = ()
) -> Chart:
    """Panels of vectors, two in a row, all to one scale."""
    return figure(diagram_panels(diagrams), title=title, subtitle=subtitle)


def diagram_panels(diagrams: Sequence[Diagram]) -> list[list[Panel]]:
    """The panels of vectors, two in a row, all to one scale."""
    reach = max((abs(each.vector) for panel in diagrams for each in panel.vectors), default=0.0)
    panels = [_panel(panel, reach) for panel in diagrams]
    return [panels[at : at + 2] for at in range(0, len(panels), 2)]


def _panel(diagram: Diagram, reach: float) -> Panel:
    grid = polar_grid(reach, side=half_width())
    strokes = list(ground(grid, ()))
    arrows: list[Arrow] = []
    labels: list[Label] = []
    for index, each in enumerate(diagram.vectors):
        if abs(each.vector) <= 1e-9 * reach:
            continue
        colour = COLOURS[index % len(COLOURS)]
        arrows.append(Arrow(each.vector, colour=colour))
        way = each.vector / abs(each.vector)
        labels.append(Label(each.name, each.vector, way, colour=colour, size=SMALL))
    plane = Plane(
        strokes=tuple(strokes),
        arrows=tuple(arrows),
        labels=tuple(labels),
        notes=tuple(values(grid, [stroke for stroke in strokes if not stroke.faint])),
    )
    return picture(plane, grid.frame, theta=0.0, title=diagram.title)
