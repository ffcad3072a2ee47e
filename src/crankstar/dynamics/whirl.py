"""The free response of a rigid engine: shift, tilt and turn, order by order.

With M the mass of the whole engine (moving parts included), G its centre of mass, F_k, C_k the
force and the couple of order k about the plane through G (clock plane), R_k the rolling moment on
the block about the axis through G, w the crank speed, I_up, I_right, I_z the moments of inertia of
the engine about axes through G:

    shift_k = -F_k / (M (k w)^2)                                    m, the place of G
    tilt_k  = -(C_k.up / I_right + i C_k.right / I_up) / (k w)^2    the place of the crank axis per
                                                                    unit of z from G
    turn_k  = -R_k / (I_z (k w)^2)                                  rad, clockwise from the front

F_k, C_k and R_k grow with w^2, so none of these depends on the speed. `tilt` is a vector of the
clock plane like `shift`: a point of the axis at z moves by shift + (z - z_G) tilt (and by i * turn
* its place from G, for an axis beside G). An upward force in front of G turns the engine about its
axis to the right, hence C.up with I_right. The theory is linear: small motions, and moments of
inertia that do not change while the parts move; products of inertia and the gyroscopic moment of
the crankshaft are left out. Crankshaft and flywheel take the torque and run on evenly
(`excitation.rolling_moment`); I_z is that of the engine without them.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import pi

import numpy as np

from crankstar import spectra
from crankstar.engine.block import BodyEstimate, inertia_in_box
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.mechanics.balance import default_reference
from crankstar.mechanics.excitation import Reference, part_spectra, rolling_moment, total
from crankstar.mechanics.mechanism import mechanism
from crankstar.spectra import Complex, Spectrum

MASS_TO_VOLUME = 70e3
"""Mass of an engine over its displacement, kg/m^3: dry, with flywheel, without a gearbox.

Engines of cars have 40 to 100 kg per litre (aluminium eights of 5 l 40 to 50, fives and sixes of
2.5 to 3 l 60 to 80, iron fours, Diesel engines and small twins up to 100), with a gearbox 70 to
130; large two-stroke engines of ships about 90. Our judgement, from weights that makers publish.
Aircraft engines are lighter than the range.
"""
MASS_TO_PISTONS = 55.0
"""The same over the mass of the reciprocating parts, where the displacement is not known.

A V8 of 5 l has 40 (210 kg over 8 times 0.65 kg), an in-line four that has been weighed (138 kg over
4 times 0.48 kg) and a V6 with its gearbox (225 kg over 6 times 0.52 kg) 72.
"""
MASS_ENDS = (0.5, 1.9)
"""Ends of an estimated mass, as multiples; the upper is that of an engine with its gearbox."""


@dataclass(frozen=True)
class Body:
    """A rigid engine: mass, centre and moments of inertia about it [up, right, z], assumptions."""

    mass: float
    centre: tuple[float, float, float]
    inertia: tuple[float, float, float]
    assumed: tuple[str, ...] = ()


@dataclass(frozen=True)
class Response:
    """The response by order: `shift` (lengths), `tilt` (per length along z), `turn` (rad, real)."""

    body: Body
    shift: Spectrum
    tilt: Spectrum
    turn: Spectrum


def body(engine: Engine, *, along: float = 1.0) -> Body:
    """The engine as a rigid body, from `[block]` of its file, else the walls of a box.

    Where `[block]` has an outer size, it is a homogeneous box. Else its mass is in the walls of the
    box about cylinders and crankcase (`outline`), thin and even: castings are where they are, and
    what is bolted on is outside. About up and right it has the mean of the two, so that a couple
    that turns in a circle makes it whirl in a circle. A mass that the file does not give is
    `estimated_mass`. `along` is the unit along the crankshaft in units across it (1 unless bore
    pitch or stroke is unknown); the body is in units across.
    """
    block, middle = engine.block, default_reference(engine).z
    given = None if block is None else block.mass
    usual, by_volume = estimated_mass(engine)
    mass = usual if given is None else given
    heavy: tuple[str, ...] = ()
    if given is None and by_volume:
        heavy = (
            _(
                "The engine file gives no mass in [block]; {factor} kg per litre of displacement "
                "is assumed, the engine without a gearbox.",
                factor=f"{MASS_TO_VOLUME / 1e3:g}",
            ),
        )
    elif given is None:
        heavy = (
            _(
                "The engine file gives no mass in [block]; {factor} times that of the "
                "reciprocating parts is assumed.",
                factor=f"{MASS_TO_PISTONS:g}",
            ),
        )
    centre = (0.0, 0.0, middle * along)
    if block is not None:
        centre = (block.up, block.right, (middle if block.z is None else block.z) * along)
    inertia = None if block is None else block.inertia
    if inertia is not None:
        return Body(mass, centre, inertia, heavy)
    if block is not None and block.sides is not None:
        up, right, length = block.sides
        own = inertia_in_box(mass, sides=(up, right, length * along))
        return Body(mass, centre, own.typical, (*heavy, _boxed(own)))
    assumed = _(
        "The engine file gives no moments of inertia in [block]; its mass is assumed in the walls "
        "of a box about cylinders and crankcase."
    )
    if block is None:
        assumed = _(
            "The engine file has no [block]; its mass is assumed in the walls of a box about "
            "cylinders and crankcase."
        )
    return Body(mass, centre, _walled(engine, mass, along), (assumed, *heavy))


def outline(engine: Engine, *, along: float = 1.0) -> tuple[float, float, float]:
    """The sides (up, right, along; units across) of the box about cylinders and crankcase.

    A cylinder reaches from the crankshaft over its rod by a bore, for piston and head; the
    crankcase is two crank radii about it. A bore that is not known in these units is a stroke.
    `along` as in `body`.
    """
    corners: list[complex] = []
    ends: list[float] = []
    for cylinder in engine.cylinders:
        radius = engine.throw(cylinder).radius
        bore = cylinder.bore if cylinder.bore and "radius" not in engine.relative else 2 * radius
        axis = np.exp(1j * cylinder.bearing)  # up + i right
        knuckle = cylinder.articulated.radius if cylinder.articulated else 0.0
        top = radius + knuckle + cylinder.rod_length + bore
        corners += [axis * (top + 0.5j * bore), axis * (top - 0.5j * bore)]
        corners += [2 * radius * (1 + 1j), -2 * radius * (1 + 1j)]
        ends += [along * cylinder.z - bore / 2, along * cylinder.z + bore / 2]
    places = np.array(corners)
    up, right = (float(np.ptp(part(places))) for part in (np.real, np.imag))
    return up, right, max(ends) - min(ends)


def estimated_mass(engine: Engine) -> tuple[float, bool]:
    """The usual mass of such an engine, and whether it follows from the displacement.

    `MASS_TO_VOLUME` times pi/4 D^2 2r of all pistons; where bore, stroke or mass have no unit,
    `MASS_TO_PISTONS` reciprocating masses (a third of a rigid rod included).
    """
    volume = 0.0
    for cylinder in engine.cylinders:
        if cylinder.bore is None:
            break
        volume += pi / 4 * cylinder.bore**2 * 2 * engine.throw(cylinder).radius
    else:
        if not {"mass", "radius"} & {*engine.relative}:
            return MASS_TO_VOLUME * volume, True
    pistons = sum(
        c.reciprocating_mass + (c.rod.mass / 3 if c.rod else 0.0) for c in engine.cylinders
    )
    return MASS_TO_PISTONS * pistons, False


def _boxed(own: BodyEstimate) -> str:
    """How far the moments of inertia of a body of that outer size may be from those of a box."""
    low, high = (
        [end / typical for end, typical in zip(ends, own.typical, strict=True)]
        for ends in (own.low, own.high)
    )
    return _(
        "Moments of inertia are estimated: a homogeneous box of the outer size of the block; by "
        "its shape they may be {low} to {high} times as large.",
        low=f"{min(low):.2g}",
        high=f"{max(high):.2g}",
    )


def _walled(engine: Engine, mass: float, along: float) -> tuple[float, float, float]:
    """The moments of inertia of the walls of the box about the engine, across their mean."""
    up, right, own = inertia_in_box(mass, sides=outline(engine, along=along)).high
    return (up + right) / 2, (up + right) / 2, own


def response(
    engine: Engine, *, of: Body, along: float = 1.0, orders: tuple[float, ...] | None = None
) -> Response:
    """The free response of an engine as a rigid body.

    `along` as in `body`, `of` the body that answers, in units across.

    >>> from crankstar.files.catalog import load
    >>> engine = load("v8-cross-plane")
    >>> free = response(engine, of=body(engine), orders=(1.0,))

    The V8 whirls in a circle:

    >>> float(abs(free.tilt.forward[0])) > 1e12 * float(abs(free.tilt.backward[0]))
    True
    """
    up, right, z = of.centre
    sums = total(
        part_spectra(mechanism(engine), reference=Reference(z / along, up, right), orders=orders)
    )
    force, couple, roll = sums.force, spectra.scaled(sums.couple, along), rolling_moment(sums)
    squared = -(force.orders**2)
    about_up, about_right, about_z = of.inertia
    tilt = _stretched(couple, up=1 / about_right, right=1 / about_up)
    return Response(
        of,
        shift=spectra.scaled(force, 1 / (of.mass * squared)),
        tilt=spectra.scaled(tilt, 1 / squared),
        turn=spectra.scaled(roll, 1 / (about_z * squared)),
    )


def whirl(engine: Engine, *, orders: tuple[float, ...] | None = None) -> Response:
    """The free response of an engine as a body of the usual mass and shape: see `response`.

    >>> from crankstar.files.catalog import load
    >>> bool(abs(whirl(load("v8-cross-plane"), orders=(1.0,)).tilt.forward[0]) > 0)
    True
    """
    return response(engine, of=body(engine), orders=orders)


def _stretched(spectrum: Spectrum, *, up: float, right: float) -> Spectrum:
    """A vector of the clock plane with its upward and its rightward part each scaled."""
    mean, rest = (up + right) / 2, (up - right) / 2

    def mixed(own: Complex, other: Complex) -> Complex:
        return mean * own + rest * np.conj(other)

    forward, backward = spectrum.forward, spectrum.backward
    return replace(spectrum, forward=mixed(forward, backward), backward=mixed(backward, forward))
