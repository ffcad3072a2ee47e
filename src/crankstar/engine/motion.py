"""Exact motion of pins, rods and pistons, and its harmonics, exact and as series in lambda.

One cylinder, its axis up, the crank turned clockwise by psi from it: the crank pin is at Q = r
exp(i psi). The piston pin P stays on the axis, offset e to the clockwise side, at rod length l from
Q:

    P = Q.up + sqrt(l^2 - (Q.right - e)^2) + i e

An articulated rod is the same with Q on a knuckle pin of its master's rod: Q = Qm + k exp(i kappa)
(Pm - Qm)/lm, so the motion of a group of rods on one crank pin is a chain, worked out rod by rod
together with its first two derivatives by psi. Harmonics are Fourier coefficients of samples of
these exact accelerations; they fall off geometrically, so that the number of samples that machine
precision needs is known beforehand and checked afterwards.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from fractions import Fraction
from functools import lru_cache
from math import acosh, asin, comb
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from crankstar.engine.assembly import Assembly
from crankstar.engine.checks import MINIMUM_CLEARANCE
from crankstar.language.faults import Fault
from crankstar.spectra import Complex, Real

PRECISION = 1e-16
TAIL = 1e-15
"""A harmonic smaller than this share of the greatest is rounding error."""
GREATEST_SAMPLES = 1 << 15
DEPTH = 0.8
"""How deep harmonics are read off, as a share of the strip in which the motion is analytic."""
NOISE = 1e-13
"""A harmonic smaller than this share of the greatest, both read off there, is rounding error."""
SHORT = 1e-12
"""Share of the crank radius by which rounding may shorten a rod that just reaches."""
TOO_SHORT = "a rod is too short to reach its cylinder over the whole turn; check the engine first"


@dataclass(frozen=True)
class Linkage:
    """The rods of an engine as arrays [..., cylinder], lengths in m, angles in radians.

    Leading axes are a batch.

    `master` holds for each cylinder the index of the one that carries its knuckle pin, -1 on a
    crank pin; `bearing` is measured from the cylinder at the root of its group, so it is zero for a
    plain rod.
    """

    crank_radius: Real
    rod_length: Real
    offset: Real
    bearing: Real
    knuckle_radius: Real
    knuckle_angle: Real
    master: tuple[int, ...]


class Path(NamedTuple):
    """A point in the clock plane (m) or a rod's direction, and two derivatives by psi.

    [..., cylinder, sample].
    """

    place: Complex
    first: Complex
    second: Complex


class Rods(NamedTuple):
    """Where the rods are: big-end pins, piston pins, and unit vectors from the one to the other."""

    big_end: Path
    piston: Path
    direction: Path


def linkage(engine: Assembly) -> Linkage:
    """The rods of an engine, in the order of its cylinders."""
    place = {cylinder.number: index for index, cylinder in enumerate(engine.cylinders)}
    links = [cylinder.articulated for cylinder in engine.cylinders]
    master = tuple(-1 if link is None else place[link.master] for link in links)
    bearing = np.array([cylinder.bearing for cylinder in engine.cylinders])
    return Linkage(
        crank_radius=np.array([engine.throw(cylinder).radius for cylinder in engine.cylinders]),
        rod_length=np.array([cylinder.rod_length for cylinder in engine.cylinders]),
        offset=np.array([cylinder.offset for cylinder in engine.cylinders]),
        bearing=bearing - bearing[list(roots(master))],
        knuckle_radius=np.array([0.0 if link is None else link.radius for link in links]),
        knuckle_angle=np.array([0.0 if link is None else link.angle for link in links]),
        master=master,
    )


def chain(master: tuple[int, ...], index: int) -> list[int]:
    """A cylinder's masters, from the one whose rod sits on the crank pin down to itself."""
    chain = [index]
    while master[chain[0]] >= 0:
        chain.insert(0, master[chain[0]])
    return chain


def roots(master: tuple[int, ...]) -> tuple[int, ...]:
    """For each cylinder the index of the one whose rod sits on the crank pin."""
    return tuple(chain(master, index)[0] for index in range(len(master)))


def rods(links: Linkage, psi: ArrayLike) -> Rods:
    """The exact motion at crank angles `psi`, radians clockwise from the cylinder axis.

    The axis is that of the cylinder at the root of a chain of rods. The angles are those of all
    cylinders [sample], or of each [cylinder, sample], the same along a chain.

    Raises ValueError with a sentence where a rod cannot reach its cylinder.
    """
    shape = np.broadcast_shapes(*(np.shape(getattr(links, name)) for name in ARRAYS))
    turning = np.exp(1j * np.asarray(psi, float))
    if all(index < 0 for index in links.master):
        pin = np.broadcast_to(links.crank_radius, shape)[..., None] * turning
        return _reached(links, slice(None), Path(pin, 1j * pin, -pin))
    blank = np.zeros((*shape, turning.shape[-1]), complex)
    out = Rods(*(Path(*(blank.copy() for _ in Path._fields)) for _ in Rods._fields))
    for level in _levels(links.master):
        at = list(level)
        master = [links.master[index] for index in at]
        if master[0] < 0:
            own = turning if turning.ndim == 1 else turning[at]
            pin = np.broadcast_to(links.crank_radius, shape)[..., at, None] * own
            joint = Path(pin, 1j * pin, -pin)
        else:
            arm = _picked(links.knuckle_radius * np.exp(1j * links.knuckle_angle), shape, at)
            joint = Path(
                *(
                    o[..., master, :] + arm * d[..., master, :]
                    for o, d in zip(out.big_end, out.direction, strict=True)
                )
            )
        for whole, part in zip(out, _reached(links, at, joint), strict=True):
            for target, values in zip(whole, part, strict=True):
                target[..., at, :] = values
    return out


ARRAYS = ("crank_radius", "rod_length", "offset", "bearing", "knuckle_radius", "knuckle_angle")
"""The arrays of a Linkage."""


def _picked(values: Real | Complex, shape: tuple[int, ...], at: list[int] | slice) -> Complex:
    return np.broadcast_to(values, shape)[..., at, None]


@lru_cache(maxsize=256)
def _levels(master: tuple[int, ...]) -> tuple[tuple[int, ...], ...]:
    """Cylinder indices by distance from the crank pin: plain rods and masters first."""
    depth = [len(chain(master, index)) - 1 for index in range(len(master))]
    return tuple(
        tuple(i for i, d in enumerate(depth) if d == level) for level in range(max(depth) + 1)
    )


def _reached(links: Linkage, at: list[int] | slice, joint: Path) -> Rods:
    """From the big-end pins to the piston pins of the same cylinders."""
    shape = (
        joint.place.shape[:-1]
        if isinstance(at, slice)
        else np.broadcast_shapes(*(np.shape(getattr(links, n)) for n in ARRAYS))
    )
    axis = np.exp(1j * _picked(links.bearing, shape, at))
    offset, length = _picked(links.offset, shape, at), _picked(links.rod_length, shape, at)
    along = [part / axis for part in joint]
    across = along[0].imag - offset
    squared = length**2 - across**2
    if np.any(squared <= 0):
        raise ValueError(TOO_SHORT)
    height = np.sqrt(squared)
    # s^2 = l^2 - y^2, so s s' = -y y' and s s'' = -(y'^2 + y y'') - s'^2
    rate = -across * along[1].imag / height
    bend = -(along[1].imag ** 2 + across * along[2].imag + rate**2) / height
    piston = Path(
        axis * (along[0].real + height + 1j * offset),
        axis * (along[1].real + rate),
        axis * (along[2].real + bend),
    )
    return Rods(
        joint, piston, Path(*((p - q) / length for p, q in zip(piston, joint, strict=True)))
    )


def samples(links: Linkage) -> int:
    """Samples over a turn that give the harmonics of the plain rods to machine precision.

    The motion is analytic up to where the rod would be square to the axis, sin psi = (l - |e|)/r,
    that is up to an imaginary psi of acosh((l - |e|)/r); its harmonics fall as exp(-k acosh(...)).
    """
    plain = np.array(links.master) < 0
    shape = np.broadcast_shapes(
        links.rod_length.shape, links.offset.shape, links.crank_radius.shape
    )
    steep = np.broadcast_to((links.rod_length - np.abs(links.offset)) / links.crank_radius, shape)[
        ..., plain
    ]
    highest = -np.log(PRECISION) / acosh(max(float(np.min(steep)), MINIMUM_CLEARANCE))
    return min(GREATEST_SAMPLES, 1 << int(np.ceil(np.log2(2 * highest + 16))))


def resolved(links: Linkage) -> Rods:
    """The motion over one turn [..., cylinder, N], so fine that its harmonics are exact."""
    count = samples(links)
    while True:
        moved = rods(links, np.arange(count) * (2 * np.pi / count))
        if all(index < 0 for index in links.master) or count >= GREATEST_SAMPLES:
            return moved
        spectrum = np.abs(np.fft.fft(moved.piston.second, axis=-1))
        tail = spectrum[..., 3 * count // 8 : 5 * count // 8 + 1].max()
        if tail <= 4 * TAIL * spectrum.max():
            return moved
        count *= 2


def unreachable(engine: Assembly) -> list[Fault]:
    """The articulated rods that cannot reach their cylinders over a whole turn.

    Plain rods are checked by the engine itself; a slave's knuckle pin has to be followed round.
    """
    links = linkage(engine)
    if all(index < 0 for index in links.master):
        return []
    arrays = tuple(tuple(map(float, getattr(links, name))) for name in ARRAYS)
    faults: list[Fault] = []
    for index, (cylinder, reach) in enumerate(
        zip(engine.cylinders, _reaches(links.master, arrays), strict=True)
    ):
        if cylinder.rod_length < MINIMUM_CLEARANCE * reach:
            values = {
                "value": cylinder.rod_length,
                "unit": engine.across,
                "least": MINIMUM_CLEARANCE * reach,
            }
            path = ("cylinders", index, "rod_length")
            faults.append(Fault(path, "rod.slave-too-short", values, cylinder.number))
    return faults


@lru_cache(maxsize=64)
def _reaches(master: tuple[int, ...], arrays: tuple[tuple[float, ...], ...]) -> tuple[float, ...]:
    """How far each big end of a slave goes from the axis of its cylinder; 0 of other rods.

    Kept by geometry: an engine is checked anew for each mass that is tried.
    """
    links = Linkage(master=master, **dict(zip(ARRAYS, map(np.array, arrays), strict=True)))
    psi = np.arange(720) * (2 * np.pi / 720)
    out: list[float] = []
    for index, own in enumerate(master):
        out.append(0.0)
        if own < 0:
            continue
        way = parted(links, chain(master, index))
        # However long the rod is, its big end goes the same way.
        offset = float(links.offset[index])
        long_enough = 10 * (
            np.sum(way.crank_radius + way.rod_length + way.knuckle_radius) + abs(offset)
        )
        try:
            moved = rods(replace(way, rod_length=np.append(way.rod_length[:-1], long_enough)), psi)
        except ValueError:
            continue  # its master's rod is too short, which is told of that
        axis = np.exp(1j * links.bearing[index])
        out[-1] = float(np.max(np.abs((moved.big_end.place[-1] / axis).imag - offset)))
    return tuple(out)


def parted(links: Linkage, chain: list[int]) -> Linkage:
    """The rods of one chain only, from the crank pin outward."""
    return Linkage(
        **{name: getattr(links, name)[..., chain] for name in ARRAYS},
        master=tuple(range(-1, len(chain) - 1)),
    )


def piston_harmonics(*, crank_radius: float, rod_length: float, offset: float = 0.0) -> Complex:
    """Exact coefficients A_k [k = 0, 1, ...] of a piston's inertia force, in units of m r w^2.

    The force on the block along the cylinder axis is `m r w^2 Re(sum A_k exp(i k psi))`, psi the
    crank angle clockwise from the axis. Lengths in any one unit. A_k is real for a centred crank,
    where only orders 1, 2, 4, 6, ... appear. Raises ValueError for a rod that is too short.

    >>> np.round(piston_harmonics(crank_radius=1, rod_length=4)[[1, 2, 4]].real, 12).tolist()
    [1.0, 0.254025042307, -0.004098111172]
    """
    length, miss = rod_length / crank_radius, offset / crank_radius
    if length - abs(miss) < 1 - SHORT:
        raise ValueError(TOO_SHORT)
    strip = acosh(max(length - abs(miss), MINIMUM_CLEARANCE))
    depth = DEPTH * strip
    count = 1 << int(np.ceil(np.log2(-np.log(PRECISION) / (strip - depth) + 16)))
    # On psi - i depth the k-th harmonic of the piston's place is exp(k depth) times as large, so
    # that high ones do not drown in the rounding of the first.
    psi = np.arange(count) * (2 * np.pi / count) - 1j * depth
    across = np.sin(psi) - miss
    place = np.cos(psi) - across**2 / (np.sqrt(length**2 - across**2) + length)
    raised = np.fft.fft(place)[: count // 2] / count
    raised[np.abs(raised) < NOISE * np.abs(raised[1])] = 0
    if offset == 0:
        raised = raised.real + 0j
    k = np.arange(count // 2)
    return 2 * k**2 * raised * np.exp(-k * depth)


def first_harmonic(engine: Assembly, order: float) -> complex:
    """The actual A_k of the first cylinder's piston, `Re(A_k exp(i k psi))`.

    psi is the angle of its crank from the cylinder axis, in the direction of rotation. A_1 is 1 for
    a centred crank only. Zero where the piston has no such harmonic, or moves on an
    articulated rod.
    """
    first = engine.first
    if order != int(order) or first.articulated is not None:
        return 0j
    harmonics = piston_harmonics(
        crank_radius=engine.throw(first).radius, rod_length=first.rod_length, offset=first.offset
    )
    size = complex(harmonics[int(order)]) if order < harmonics.size else 0j
    return size if engine.sense > 0 else size.conjugate()


def series_coefficient(order: int, power: int) -> Fraction:
    """The exact coefficient of lambda**power in A_k of a centred crank, lambda = r/l.

    From sqrt(1 - x) = sum C(1/2, j) (-x)^j with x = lambda^2 sin^2 psi, and sin^(2j) as a sum of
    cosines. Source: any textbook; both V8 pages of the founding documents misprint it (docs,
    errata).

    >>> [str(series_coefficient(2, p)) for p in (1, 3, 5, 7)]
    ['1', '1/4', '15/128', '35/512']
    """
    if order == 1:
        return Fraction(int(power == 0))
    if order % 2 or power % 2 == 0 or order < 0:
        return Fraction(0)
    half, j = order // 2, (power + 1) // 2
    if order == 0 or j < half:
        return Fraction(0)
    binomial = Fraction(1)
    for step in range(j):
        binomial *= (Fraction(1, 2) - step) / (step + 1)
    cosine = Fraction(2 * (-1) ** half * comb(2 * j, j - half), 4**j)
    return order**2 * binomial * (-1) ** j * cosine


def series(order: int, *, ratio: ArrayLike, highest_power: int = 7) -> Real:
    """A_k of a centred crank from its series in `ratio`, lambda = r/l, to lambda**highest_power.

    >>> float(series(2, ratio=0.25, highest_power=1))
    0.25
    """
    lam = np.asarray(ratio, float)
    return sum(
        (float(series_coefficient(order, p)) * lam**p for p in range(highest_power + 1)),
        np.zeros_like(lam),
    )


def dead_centre(*, crank_radius: float, rod_length: float, offset: float = 0.0) -> float:
    """The angle psi of top dead centre, radians: crank and rod in line, sin psi = e/(r + l)."""
    return asin(offset / (crank_radius + rod_length))
