"""Figures, one function each, made with Altair: arrays in, a chart out, and a chart as an SVG that needs no browser.

Altair and vl-convert are loaded when a figure is asked for; they come with `pip install "crankstar[charts]"`.
"""

from crankstar.charts.compared import over_rods, over_turn
from crankstar.charts.drawing import GREY, svg

__all__ = ["GREY", "over_rods", "over_turn", "svg"]
