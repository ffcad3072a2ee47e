"""The records that the page is sent; the types of the front end are generated from them.

Lengths, masses and speeds are in the engine's own units (SI, or relative to the first cylinder
where it has no sizes), angles in radians unless a name says degrees. A vector of the clock plane is
a pair `[up, right]` seen from the front; a point is `[up, right, z]`. Vectors of order k are
`forward exp(i k theta) + backward exp(-i k theta)` with the exponents' sign reversed for an engine
that turns counter-clockwise (`sense` -1); signals are `Re((real + i imaginary) exp(i k theta))`.
"""

from __future__ import annotations

from typing import Any, Literal

from pydantic import Field

from crankstar.engine.quantities import Unknown
from crankstar.language.glossary import Term
from crankstar.page.cycle_records import Exhaust, StrokeColours, StrokeWindow, Torque
from crankstar.page.mount_records import MountNumbers, Mounts
from crankstar.page.torsion_records import Torsion, TorsionNumbers
from crankstar.page.unit_records import Pair, Shown, Table, Unit, Units, UnitsOffered

Quantity = Literal["force", "couple", "roll", "torque"]
Point = tuple[float, float, float]


class Web(Shown):
    """A crank web (cheek): a plate square to the shaft between a journal and a pin."""

    z_from: float
    z_to: float
    throw: int = Field(description="index of the throw whose pin it carries")


class ThrowShown(Shown):
    """A crank throw: its pin at bearing `angle` at theta = 0."""

    angle: float
    radius: float
    z: float
    pin_radius: float
    pin_from: float
    pin_to: float
    cylinders: tuple[int, ...] = Field(
        description="numbers of the cylinders whose rods work on this pin, masters and plain rods"
    )


class WeightShown(Shown):
    """A counterweight, drawn as a segment of a disc.

    Opposite a pin on a web, or an eccentric on a balance shaft.
    """

    angle: float
    z: float
    unbalance: float
    inner_radius: float
    outer_radius: float
    half_angle: float = Field(description="half the sector it covers, radians")
    thickness: float


class ShaftShown(Shown):
    """A shaft along z at `up`, `right`.

    It turns `speed_ratio` times for each turn of the first shaft, negative the other way.
    """

    name: str
    kind: Literal["crankshaft", "balance shaft"]
    speed_ratio: float
    up: float
    right: float
    z_from: float
    z_to: float
    journal_radius: float
    throws: tuple[ThrowShown, ...]
    webs: tuple[Web, ...]
    weights: tuple[WeightShown, ...]


class GearShown(Shown):
    """A gear wheel on a shaft, so that one sees which shafts turn together and how."""

    shaft: int = Field(description="index of its shaft")
    radius: float
    z: float
    thickness: float
    teeth: int


class CylinderShown(Shown):
    """A cylinder, its piston and its rod, with the dimensions that their motion depends on.

    The crank pin of shaft `shaft` stands at bearing `throw_angle` at theta = 0; `master` is the
    index in the list of cylinders of the one whose rod carries this rod's knuckle pin, -1 for a rod
    on the crank pin.
    """

    number: int
    shaft: int
    throw: int
    throw_angle: float
    crank_radius: float
    bearing: float
    z: float
    offset: float
    rod_length: float
    master: int
    knuckle_radius: float
    knuckle_angle: float
    rod: Literal["plain", "fork", "blade", "master", "slave"]
    rod_z: float = Field(description="where its rod runs along z: beside others on the same pin")
    rod_width: float
    bore: float
    pin_height: float = Field(description="from the piston pin to the crown, along the axis")
    skirt: float = Field(description="from the piston pin to the lower edge of the piston")
    bore_from: float = Field(
        description="lower end of the cylinder bore, from the shaft axis along the cylinder axis"
    )
    bore_to: float = Field(description="upper end of the bore, where the head begins")
    chamber: int


class Scene(Shown):
    """The engine as things that can be drawn."""

    length_unit: str = Field(description='"m", or "crank radii" where the engine has no sizes')
    low: Point = Field(description="lower corner [up, right, z] of the box that all parts stay in")
    high: Point
    shafts: tuple[ShaftShown, ...]
    gears: tuple[GearShown, ...]
    cylinders: tuple[CylinderShown, ...]
    assumed: tuple[str, ...] = Field(
        description="proportions that are not in the engine file, as sentences"
    )


class Vectors(Shown):
    """A vector of the clock plane over the crank angle.

    A pair [up, right] for each order of the exhibit.
    """

    forward: tuple[Pair, ...]
    backward: tuple[Pair, ...]


class Sum(Shown):
    """Force, couple, rolling moment and torque on the crankshaft for each order.

    Pairs of signals are [real, imaginary].
    """

    force: Vectors
    couple: Vectors
    roll: tuple[Pair, ...]
    torque: tuple[Pair, ...]


class PartForce(Shown):
    """The force of one cylinder (its piston and rod) on the block, at its place along z."""

    number: int
    bank: str = Field(description="the name of its bank")
    z: float
    force: Vectors


class Whirl(Shown):
    """The free response of the rigid engine: how the block moves, order by order.

    `shift` is the displacement of the centre of mass, `tilt` the displacement of the crank axis for
    each unit of z away from the centre of mass, `turn` the roll angle of the block (a signal,
    clockwise, radians). Multiply as for forces. Lengths are in the scene's unit. Independent of
    speed.
    """

    centre: Point
    mass: float
    inertia: tuple[float, float, float] = Field(
        description="of the block about axes through its centre of mass: up, right, z"
    )
    shift: Vectors
    tilt: Vectors
    turn: tuple[Pair, ...]
    assumed: tuple[str, ...] = Field(
        description="sentences on estimates of mass, centre and inertia; empty if all are given"
    )


class Row(Shown):
    """A row of the table of orders: numbers as they are printed, and the ellipse of the vector."""

    order: float
    label: str
    quantity: Quantity
    up: str
    right: str
    estimated: bool = Field(description="whether the numbers rest on estimates and have ranges")
    path: str = Field(
        description="shape of the path as a phrase: none, circle with the crank, horizontal line"
    )
    greatest: str
    size: float = Field(description="greatest as a number, 0 where nothing remains of the order")
    remains: bool = Field(
        description="whether anything remains of the order; if estimated, other masses may differ"
    )
    semi_axes: Pair | None = Field(
        description="of the ellipse (vectors only), in the unit of the quantity"
    )
    direction: float | None = Field(description="bearing of its long axis, radians")


class Fact(Shown):
    """A sentence of the verdict and what it is about."""

    subject: str = Field(description="force, couple, roll, ... whatever the language")
    about: str
    sentence: str


class LoadShown(Shown):
    """The load on a main bearing, or of the rods on a crank pin, at the orders of `Bearings`."""

    on: Literal["bearing", "pin"]
    name: str
    speed_ratio: float = Field(description="turns of its shaft for each turn of the first")
    load: Vectors
    peak: float = Field(description="the greatest length over the turn")
    peak_theta: float = Field(description="the crank angle at which it is so long, radians")


class Bearings(Shown):
    """What journals push on their bearings and rods on their pins, without gas or with it.

    Drawn to one scale, so that their unit says nothing.
    """

    orders: tuple[float, ...]
    model: str = Field(description="how the bearings share the load, as a sentence")
    loads: tuple[LoadShown, ...]


class BearingNumbers(Shown):
    """The numbers of `Bearings`, in the units that are shown, with the ranges of estimates."""

    bearing_unit: str
    pin_unit: str
    greatest: tuple[str, ...] = Field(
        description="of each load the greatest over a turn, and its crank angle"
    )
    estimated: bool = Field(description="whether the numbers rest on estimates and have ranges")
    tables: tuple[Table, ...]
    about: tuple[str, ...] = Field(description="which gas is in them, as sentences; empty without")


class ChartKey(Shown):
    """A figure of an engine: the `key` that it is requested by, and the properties to choose by."""

    key: str
    figure: str = Field(description="name of the figure, as in crankstar plot")
    label: str
    quantity: str | None = None
    order: float | None = None


class PanelShown(Shown):
    """A panel with what an analysis has found of an engine, as its command prints it."""

    key: str
    label: str
    needs: str = Field(description="what stands there of an engine that has nothing of it")
    figures: tuple[str, ...] = Field(description="names of the figures in it")


class DerivationKey(Shown):
    """A derivation of an engine, requested by its `key`."""

    key: str
    label: str
    quantity: Literal["force", "couple"]
    order: float


class Scale(Shown):
    """Sizes of the first cylinder in the engine's own units.

    Lengths, forces and couples of two engines that differ in units are compared after division by
    these: in crank radii, m r ω², m r ω² times the bore pitch, and m r² ω².
    """

    length: float = Field(description="crank radius, in units.length")
    force: float = Field(description="m r ω², in units.force")
    couple: float = Field(description="m r ω² times the bore pitch, in units.couple")
    roll: float = Field(description="m r² ω², in units.roll")


class Exhibit(Shown):
    """One engine on the page; its figures and derivations are requested by their keys."""

    format: Literal[1] = 1
    name: str
    file: dict[str, Any] = Field(description="the engine file as a tree, as it was given")
    cycle_deg: float
    turns: int = Field(
        description="turns of the first shaft after which all shafts and the firing repeat"
    )
    weight_throws: tuple[tuple[int | None, ...], ...] = Field(
        description="shaft by shaft, the number of the throw with which each weight turns"
    )
    relative: tuple[Unknown, ...] = Field(
        description="what is not known, and so counted in its own unit"
    )
    sense: Literal[-1, 1] = Field(
        description="1 if the first shaft turns clockwise seen from the front"
    )
    speed_rpm: float | None = Field(description="of the engine file; null where it gives none")
    units: Units
    scale: Scale
    heading: tuple[str, ...] = Field(description="lines under the name: layout, firing, units")
    rests_on: tuple[str, ...] = Field(
        description="sentences on what is missing, assumed or unverified, what matters most first"
    )
    estimated: tuple[str, ...] = Field(description="key paths of estimated values")
    can_estimate: bool = Field(description="whether masses that are missing can be estimated")
    ends: tuple[Sum, ...] = Field(
        description="the sums in the middle and at the corners of the ranges of estimated values"
    )
    reference_z: float
    couple_length: float = Field(
        description="the length that couples are counted in along z, in the unit of the scene"
    )
    orders: tuple[float, ...]
    total: Sum
    cylinders: tuple[PartForce, ...]
    whirl: Whirl
    whirl_ends: tuple[Whirl, ...] = Field(
        description="the same in the middle and at the corners of the ranges of estimated values"
    )
    bearings: Bearings
    bearing_numbers: BearingNumbers
    gas_bearings: Bearings | None = Field(
        description="the loads with the gas of its first operating point; null where it has none"
    )
    gas_bearing_numbers: BearingNumbers | None
    scene: Scene
    table: tuple[Row, ...]
    verdict: tuple[Fact, ...]
    strokes: tuple[Table, ...]
    stroke_windows: tuple[StrokeWindow, ...]
    torque: Torque | None = Field(description="null where its gas cannot be computed")
    torque_unit: Unit
    gas_needs: str = Field(description="what its gas torque needs, a sentence; else empty")
    exhaust: Exhaust | None = Field(description="as a sound; null without a firing order")
    torsion: Torsion | None = Field(description="null without the table [torsion]")
    torsion_numbers: TorsionNumbers | None
    torsion_needs: str = Field(description="what torsion needs, a sentence; else empty")
    mounts: Mounts | None = Field(description="null without [[mounts]]")
    mount_numbers: MountNumbers | None
    charts: tuple[ChartKey, ...]
    derivations: tuple[DerivationKey, ...]
    told: dict[str, tuple[Table, ...]] = Field(
        description="what analyses print that have a panel of their own, by its key"
    )
    remedies: tuple[Table, ...] = Field(
        description="weights, shafts and remaining unbalance of a fitted engine; else empty"
    )


class Problem(Shown):
    """One fault of an engine file: its key path, and what would be right."""

    path: str
    code: str = Field(default="", description="which fault")
    values: dict[str, Any] = Field(default={}, description="the values of its sentence")
    message: str


class Exhibition(Shown):
    """The contents of a page: one engine or two, each also with weights and shafts."""

    engines: tuple[Exhibit, ...] = Field(min_length=1, max_length=2)
    fitted: tuple[Exhibit | None, ...] = Field(
        description="each engine with weights and balance shafts, where they help"
    )
    stroke_colours: StrokeColours
    panels: tuple[PanelShown, ...] = Field(description="of `told` of the engines")
    units: tuple[UnitsOffered, ...] = Field(
        default=(), description="the choices of units that are offered by name"
    )
    glossary: tuple[Term, ...] = Field(
        default=(), description="the terms that the page explains where they stand"
    )
    sources: tuple[str, ...] = Field(
        default=(), description="names or files of the engines on the command line"
    )
    command: str = ""
    version: str
