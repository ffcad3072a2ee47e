"""What the workshop of the page is sent: what can be changed, offers, sliders with their curves."""

from __future__ import annotations

from typing import Any

from pydantic import Field

from crankstar.page.unit_records import Shown


class Setting(Shown):
    """A key of the engine file that a control sets: to `factor` times its value, and `added`."""

    path: str
    factor: float
    added: float


class Control(Shown):
    """A number of an engine that is changed directly, in `unit` ("" for a bare number)."""

    key: str = Field(description="its key path, as crankstar sweep --over takes it")
    label: str
    help: str
    value: float
    unit: str
    low: float
    high: float
    step: float
    snaps: tuple[float, ...] = Field(description="values that a drag comes to rest at")
    sets: tuple[Setting, ...]
    swept: bool = Field(description="whether its slider has curves")


class OfferShown(Shown):
    """An engine file one click away."""

    label: str
    tree: dict[str, Any]
    chosen: bool = Field(description="whether it is the present one")


class Pin(Shown):
    """A crank throw that can be turned: its key path, and the throws of its list as they stand."""

    path: str
    label: str
    angle_deg: float = Field(description="what the file says: from pin 1 of its list, clockwise")
    bearing_deg: float = Field(description="of the pin at theta = 0, clockwise from up")
    fixed: bool = Field(description="whether the others are counted from it")


class WorkshopShown(Shown):
    """An engine on the bench: how many cylinders it may have, its cranks, orders, controls."""

    tree: dict[str, Any]
    cylinders: int
    fewer: int | None = Field(description="the next smaller number of cylinders")
    more: int | None = Field(description="the next greater number of cylinders")
    sentences: tuple[str, ...] = Field(description="what was decided, and what was left out")
    cranks: tuple[OfferShown, ...]
    orders: tuple[OfferShown, ...]
    controls: tuple[Control, ...]
    pins: tuple[Pin, ...] = Field(description="of the first crankshaft, from front to rear")


class SliderCurve(Shown):
    """What an engine leaves over the range of a slider, at the `values` of its `Slider`."""

    label: str
    what: str = Field(description="as crankstar sweep --watch takes it")
    order: float | None
    unit: str
    results: tuple[float, ...]
    present: float = Field(description="at the present value of the slider")


class Slider(Shown):
    """The curves of a control."""

    key: str
    present: float = Field(description="the value of the engine")
    values: tuple[float, ...]
    curves: tuple[SliderCurve, ...]
    range: str = Field(description="the same as crankstar sweep --over takes it")


class SlidersShown(Shown):
    """The curves behind the sliders of an engine."""

    sliders: tuple[Slider, ...]


class Preset(Shown):
    """A usual layout: its engine file, and what a small picture of it shows."""

    key: str
    label: str
    group: str
    tree: dict[str, Any]
    cylinders: int
    axes_deg: tuple[float, ...] = Field(description="bearings of the cylinder axes, each once")
    throws_deg: tuple[float, ...] = Field(description="bearings of the crank pins at theta = 0")
    radial: bool
    shafts: int
