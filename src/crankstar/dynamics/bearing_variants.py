"""Main-bearing loads of many engines at once, by crank order: inertia and weights, no gas.

The law is that of `bearings`, with a crankshaft hinged at each main bearing. What varies are
masses, lengths, angles and places of the parts; the bearings stay where they are drawn.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from crankstar.dynamics.beams import cut_shares
from crankstar.engine.engine import Engine
from crankstar.engine.main_bearings import main_bearings
from crankstar.mechanics.excitation import columns_of, rotors
from crankstar.mechanics.mechanism import Mechanism
from crankstar.mechanics.pin_loads import pin_loads
from crankstar.spectra import Complex, Real


class BearingForces(NamedTuple):
    """The two turning vectors of each bearing and order at 1 rad/s, N [..., bearing, order]."""

    forward: Complex
    backward: Complex


def bearing_names(engine: Engine) -> tuple[tuple[str, int], ...]:
    """The shaft and the number of each main bearing, from the front, as `bearing_loads` has them.

    >>> from crankstar.files.catalog import load
    >>> [number for _shaft, number in bearing_names(load("i4"))]
    [1, 2, 3, 4, 5]
    """
    return tuple(
        (shaft.name, number)
        for shaft in engine.shafts
        for number, _z in enumerate(main_bearings(engine, shaft), 1)
    )


def bearing_forces(engine: Engine, machine: Mechanism, *, orders: Sequence[float]) -> BearingForces:
    """What the journals of an engine push on their bearings, its parts those of a `machine`.

    >>> from crankstar.files.catalog import load
    >>> from crankstar.mechanics.mechanism import mechanism
    >>> four = load("i4")
    >>> found = bearing_forces(four, mechanism(four), orders=[1.0])
    >>> (abs(found.forward) + abs(found.backward))[:, 0].round(3).tolist()
    [0.5, 0.0, 1.0, 0.0, 0.5]
    """
    pins = pin_loads(machine, orders=orders).pin
    turning = rotors(machine, columns_of(machine, 1, orders))
    pairs = ((pins.forward, turning.forward), (pins.backward, turning.backward))
    forces = [_joined(on_pins[..., 1:], on_shaft) for on_pins, on_shaft in pairs]  # without order 0
    places = _joined(np.asarray(machine.z)[..., None], np.asarray(machine.unbalance_z)[..., None])
    of_shaft = np.array([*machine.cylinder_shaft, *machine.rotor_shaft])
    out: list[list[Complex]] = [[], []]
    for index, shaft in enumerate(engine.shafts):
        bearings = main_bearings(engine, shaft)
        if not bearings:
            continue
        rows = np.flatnonzero(of_shaft == index)
        shares = _shares(bearings, places[..., rows, 0])
        for way, force in zip(out, forces, strict=True):
            way.append(shares @ force[..., rows, :])
    return BearingForces(*(np.concatenate(way, axis=-2) for way in out))


def _shares(bearings: Sequence[float], places: Real) -> Real:
    """Shares [..., bearing, force] of forces at places [..., force]."""
    if places.ndim == 1:
        return cut_shares(bearings, places.tolist())
    return np.stack([cut_shares(bearings, each.tolist()) for each in places])


def _joined(first: np.ndarray, second: np.ndarray) -> np.ndarray:
    """Arrays [..., part, order], their parts one after the other."""
    lead = np.broadcast_shapes(first.shape[:-2], second.shape[:-2])
    return np.concatenate(
        [np.broadcast_to(each, lead + each.shape[-2:]) for each in (first, second)], axis=-2
    )
