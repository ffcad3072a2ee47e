"""The second road: the excitation is minus the rate of change of the bodies' momentum.

The bodies are placed by plane geometry in a right-handed frame (x right, y up, z to the viewer in
front of the engine), each by itself, in long doubles, and differentiated spectrally over the common
period of all shafts. Nothing here is taken from the package but the records of the engine.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from math import lcm
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from crankstar.engine.engine import Engine
from crankstar.engine.records import Cylinder, Shaft
from crankstar.mechanics.excitation import Reference

FINEST = 8192
"""Steps in a turn of the reference shaft."""
PI = np.arctan2(np.longdouble(0), np.longdouble(-1))
"""pi as a long double: second derivatives of doubles would be too noisy."""
RESOLVED = max(1e-12, 1e6 * float(np.finfo(np.longdouble).eps))
"""A grid is fine enough when every spectrum ends below this share of its greatest."""

NOISE = 64 * float(np.finfo(np.longdouble).eps)
"""What is below this share of the greatest coefficient is rounding of the samples."""

Array = NDArray[Any]
"""Of long doubles."""


@dataclass(frozen=True)
class Body:
    """A rigid body: where it belongs, its mass, its centre relative to its shaft (N, 2).

    The place of that; inertia and turn.
    """

    kind: str
    shaft: str
    cylinder: int | None
    mass: float
    centre: Array
    axis: tuple[float, float]
    z: float
    inertia: float
    counter_clockwise: Array


class Push(NamedTuple):
    """Force, moment about the reference (N, 3) and crankshaft torque (N,) of a body."""

    force: Array
    moment: Array
    torque: Array


class Road(NamedTuple):
    """The crank angles, the bodies, and what each does."""

    theta: Array
    bodies: list[Body]
    pushes: list[Push]


class Rate:
    """d/d(theta) of periodic samples, through their spectrum."""

    def __init__(self, turns: int, count: int) -> None:
        self.factor = 1j * np.arange(count // 2 + 1, dtype=np.longdouble) / turns
        self.factor[-1] = 0.0
        self.count = count

    def __call__(self, samples: Array) -> Array:
        spectrum = np.fft.rfft(samples, axis=0)
        size = np.abs(spectrum)
        spectrum[size < NOISE * size.max(axis=0)] = (
            0  # else rounding, multiplied by the highest orders, drowns slow shafts
        )
        return np.fft.irfft(spectrum.T * self.factor, self.count).T

    def rest(self, samples: Array) -> float:
        """The greatest coefficient in the last quarter of the spectrum: the error of the grid."""
        return float(self.spectrum(samples)[3 * self.count // 8 :].max())

    def spectrum(self, samples: Array) -> Array:
        return np.abs(np.fft.rfft(samples, axis=0)).reshape(self.count // 2 + 1, -1).max(axis=1)


def direction(bearing: Array) -> Array:
    """Unit vectors (x, y) at a bearing, clockwise from up."""
    return np.stack([np.sin(bearing), np.cos(bearing)], axis=-1)


def pin_of(engine: Engine, shaft: Shaft, angle: float, theta: Array) -> Array:
    clockwise = 1 if engine.rotation == "clockwise" else -1
    above, below = shaft.speed_ratio.as_integer_ratio()
    return direction(angle + clockwise * theta * above / below)


def placed(engine: Engine, cylinder: Cylinder, theta: Array) -> tuple[Array, Array, Array]:
    """A cylinder's big-end pin and piston pin relative to its shaft, and the bearing of its rod."""
    shaft = next(s for s in engine.shafts if s.name == cylinder.shaft)
    if cylinder.articulated is None:
        throw = shaft.throws[cylinder.throw - 1]
        pin = throw.radius * pin_of(engine, shaft, throw.angle, theta)
    else:
        link = cylinder.articulated
        below, _, leaning = placed(
            engine, next(c for c in engine.cylinders if c.number == link.master), theta
        )
        pin = below + link.radius * direction(leaning + link.angle)
    along = direction(np.array(cylinder.bearing, np.longdouble))
    clockwise_of = np.array([along[1], -along[0]])
    # Circle of the rod about the pin cut with the cylinder axis, the crossing farther out.
    to_axis = cylinder.offset * clockwise_of - pin
    b = to_axis @ along
    c = np.sum(to_axis**2, axis=1) - cylinder.rod_length**2
    travel = -b + np.sqrt(b**2 - c)
    piston = cylinder.offset * clockwise_of + travel[:, None] * along
    leaning = cylinder.bearing + np.arcsin((piston - pin) @ clockwise_of / cylinder.rod_length)
    return pin, piston, leaning


def bodies_of(engine: Engine, theta: Array) -> Iterator[Body]:
    """Every body that has a mass."""
    axes = {shaft.name: (shaft.right, shaft.up) for shaft in engine.shafts}
    still = np.zeros_like(theta)
    for cylinder in engine.cylinders:
        pin, piston, leaning = placed(engine, cylinder, theta)
        label, axis, z = (cylinder.shaft, cylinder.number), axes[cylinder.shaft], cylinder.z
        yield Body("piston", *label, cylinder.reciprocating_mass, piston, axis, z, 0.0, still)
        yield Body("big end", *label, cylinder.big_end_mass, pin, axis, z, 0.0, still)
        if cylinder.rod:
            centre = pin + cylinder.rod.centre * direction(leaning)
            yield Body(
                "rod",
                *label,
                cylinder.rod.mass,
                centre,
                axis,
                z,
                cylinder.rod.turning_inertia(cylinder.rod_length),
                cylinder.bearing - leaning,
            )
    for shaft in engine.shafts:
        for throw in shaft.throws:
            centre = throw.radius * pin_of(engine, shaft, throw.angle, theta)
            yield Body(
                "throw",
                shaft.name,
                None,
                throw.rotating_mass,
                centre,
                axes[shaft.name],
                throw.z,
                0.0,
                still,
            )
        for weight in shaft.weights:
            arm = 0.05  # any: only mass times radius counts
            centre = arm * pin_of(engine, shaft, weight.angle, theta)
            yield Body(
                "weight",
                shaft.name,
                None,
                weight.unbalance / arm,
                centre,
                axes[shaft.name],
                weight.z,
                0.0,
                still,
            )


def pushed(body: Body, rate: Rate, reference: Reference, w: float) -> tuple[Push, float]:
    """The negative rates of change of momentum, angular momentum and kinetic energy.

    Also the share that the grid did not resolve.
    """
    velocity = np.zeros((len(body.centre), 3), np.longdouble)
    velocity[:, :2] = w * rate(body.centre)
    momentum = body.mass * velocity
    arm = np.zeros_like(velocity)
    arm[:, :2] = body.centre + np.array(body.axis) - np.array([reference.right, reference.up])
    arm[:, 2] = body.z - reference.z
    angular = np.cross(arm, momentum)
    spin = w * rate(body.counter_clockwise)
    angular[:, 2] += body.inertia * spin
    energy = body.mass * np.sum(velocity**2, axis=1) / 2 + body.inertia * spin**2 / 2
    push = Push(-w * rate(momentum), -w * rate(angular), -rate(energy))
    most = rate.spectrum(push.force).max()
    resolved = (
        most,
        most * np.abs(arm).max() + rate.spectrum(push.moment).max(),
        most * np.abs(body.centre).max(),
    )
    return push, max(
        rate.rest(samples) / whole for samples, whole in zip(push, resolved, strict=True)
    )


def road(engine: Engine, *, reference: Reference, speed: float) -> Road:
    """The bodies of an engine and their excitation, on a grid fine enough to resolve it."""
    turns = lcm(*(shaft.speed_ratio.denominator for shaft in engine.shafts))
    steps = 64
    while True:
        count = steps * turns
        theta = np.arange(count, dtype=np.longdouble) * (2 * PI * turns / count)
        bodies, rate = [body for body in bodies_of(engine, theta) if body.mass], Rate(turns, count)
        pushes, rests = zip(*(pushed(body, rate, reference, speed) for body in bodies), strict=True)
        if max(rests) < RESOLVED or steps >= FINEST:
            return Road(theta, bodies, list(pushes))
        steps *= 2
