"""How a rigid engine, free in space, answers to what its moving parts do to it: shift, tilt and turn, order by order.

With M the mass of the whole engine (moving parts included), G its centre of mass, F_k, C_k the force and the couple of
order k about the plane through G (clock plane), R_k the roll about the axis through G that the block takes, w the crank
speed, I_up, I_right, I_z the moments of inertia of the engine about axes through G:

    shift_k = -F_k / (M (k w)^2)                                   m, the place of G
    tilt_k  = -(C_k.up / I_right + i C_k.right / I_up) / (k w)^2   the place of the crank axis for each unit of z from G
    turn_k  = -R_k / (I_z (k w)^2)                                 rad, clockwise seen from the front

F_k, C_k and R_k grow with w^2, so none of these depends on the speed. `tilt` is a vector of the clock plane like `shift`:
a point of the axis at z moves by shift + (z - z_G) tilt (and by i * turn * its place from G, for an axis beside G). An
up-going force in front of G turns the engine about its axis to the right, hence C.up with I_right. The response is that of
the linear theory: small motions, and moments of inertia that do not change while the parts move; products of inertia are
left out, and so is what a spinning crankshaft does as a gyroscope. The roll is `mechanism.block_roll`: crankshaft and
flywheel take the torque and turn on as they did; I_z is that of the engine without them.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from crankstar import phasor
from crankstar.balance import default_reference
from crankstar.engine import Engine
from crankstar.mechanism import Reference, block_roll, mechanism, spectra, total
from crankstar.phasor import Complex, Spectrum

MASS_TO_PISTONS = 40.0
"""Mass of an engine over that of its reciprocating parts: a V8 of 5 l, 210 kg over 8 times 0.65 kg. Only the size of the
whirl hangs on it, not the shape of its path, and the size is shown magnified."""
RADIUS_TO_REACH = 0.5
"""Radius of the estimated round bar over the greatest distance of a piston pin from its shaft."""


@dataclass(frozen=True)
class Body:
    """A rigid engine: mass, centre [up, right, z], moments of inertia about axes through it [up, right, z]; what is assumed."""

    mass: float
    centre: tuple[float, float, float]
    inertia: tuple[float, float, float]
    assumed: tuple[str, ...] = ()


@dataclass(frozen=True)
class Response:
    """The free response: `shift` (lengths), `tilt` (lengths over lengths along z), `turn` (a real signal, rad), by order."""

    body: Body
    shift: Spectrum
    tilt: Spectrum
    turn: Spectrum


def body(engine: Engine, *, along: float = 1.0) -> Body:
    """The engine as a rigid body, as its file gives it in `[block]`; what is missing there is that of a round bar, and told.

    The bar is homogeneous and lies along the crankshaft about the centre of mass. Its mass is `MASS_TO_PISTONS` reciprocating
    masses (of a rigid rod a third counts), its length the span of the cylinders and a stroke more, its radius
    `RADIUS_TO_REACH` of how far the pistons go. A round bar whirls in a circle where the couple is one. `along` is how many
    units across the crankshaft one along it is (1 but for engines whose bore pitch or stroke is not known); the body is in units
    across.
    """
    block, middle = engine.block, default_reference(engine).z
    pistons = sum(c.reciprocating_mass + (c.rod.mass / 3 if c.rod else 0.0) for c in engine.cylinders)
    mass = MASS_TO_PISTONS * pistons if block is None else block.mass
    centre = (0.0, 0.0, middle * along)
    if block is not None:
        centre = (block.up, block.right, (middle if block.z is None else block.z) * along)
    inertia = None if block is None else block.inertia
    bar = "a homogeneous round bar about the crankshaft"
    if inertia is not None:
        return Body(mass, centre, inertia)
    told = f"The engine file gives no moments of inertia in [block]: they are those of {bar}."
    if block is None:
        told = (
            f"The engine file gives no [block]: mass, centre and inertia are those of {bar}, {MASS_TO_PISTONS:g} times as heavy as "
        )
        told += "the reciprocating parts."
    return Body(mass, centre, _bar(engine, mass, along), (told,))


def _bar(engine: Engine, mass: float, along: float) -> tuple[float, float, float]:
    """The moments of inertia of the estimated bar: m (3 R^2 + L^2)/12 across, m R^2/2 along."""
    places = [cylinder.z * along for cylinder in engine.cylinders]
    strokes = [engine.throw(cylinder).radius for cylinder in engine.cylinders]
    reach = max(radius + cylinder.rod_length for radius, cylinder in zip(strokes, engine.cylinders, strict=True))
    length, radius = max(places) - min(places) + 2 * max(strokes), RADIUS_TO_REACH * reach
    across = mass * (3 * radius**2 + length**2) / 12
    return across, across, mass * radius**2 / 2


def response(engine: Engine, *, of: Body, along: float = 1.0, orders: tuple[float, ...] | None = None) -> Response:
    """The free response of an engine as a rigid body; `along` as in `body`, `of` the body that answers, in units across.

    >>> from crankstar.catalog import load
    >>> engine = load("v8-cross-plane")
    >>> found = response(engine, of=body(engine), orders=(1.0,))
    >>> float(abs(found.tilt.forward[0])) > 1e12 * float(abs(found.tilt.backward[0]))  # it whirls in a circle
    True
    """
    up, right, z = of.centre
    sums = total(spectra(mechanism(engine), reference=Reference(z / along, up, right), orders=orders))
    force, couple, roll = sums.force, phasor.scaled(sums.couple, along), block_roll(sums)
    squared = -(force.orders**2)
    about_up, about_right, about_z = of.inertia
    tilt = _apart(couple, up=1 / about_right, right=1 / about_up)
    return Response(
        of,
        shift=phasor.scaled(force, 1 / (of.mass * squared)),
        tilt=phasor.scaled(tilt, 1 / squared),
        turn=phasor.scaled(roll, 1 / (about_z * squared)),
    )


def _apart(spectrum: Spectrum, *, up: float, right: float) -> Spectrum:
    """A vector of the clock plane with its upward and its rightward part each multiplied by a factor of its own."""
    mean, rest = (up + right) / 2, (up - right) / 2

    def mixed(one: Complex, other: Complex) -> Complex:
        return mean * one + rest * np.conj(other)

    forward, backward = spectrum.forward, spectrum.backward
    return replace(spectrum, forward=mixed(forward, backward), backward=mixed(backward, forward))
