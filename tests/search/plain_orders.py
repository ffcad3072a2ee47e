"""The plain road to a front over firing orders: every permutation, judged by its angles alone.

Nothing here knows of stars, classes or signs: an order that fires evenly has an angle for each
cylinder, and with it the dead centre. Of a V engine those orders are kept whose pins fit.
"""

from __future__ import annotations

from functools import cache
from itertools import permutations
from typing import Any

import numpy as np

SAME = 1e-9


@cache
def angles(cylinders: int, cycle_deg: int, bank_deg: float) -> tuple[np.ndarray, np.ndarray]:
    """All orders that begin with cylinder 1 [o, n], and when each cylinder fires, degrees [o, n].

    bank_deg: 0 in line, else the angle by which the odd numbers stand clockwise of the even ones.
    """
    rest = np.array(list(permutations(range(2, cylinders + 1))), np.int8)
    orders = np.column_stack([np.ones(len(rest), np.int8), rest])
    fires = np.argsort(orders, axis=1) * (cycle_deg / cylinders)
    if bank_deg:
        apart = (fires[:, 1::2] - fires[:, 0::2] + bank_deg) % 360
        keep = (np.minimum(apart, 360 - apart) < 1e-6).all(axis=1)
        orders, fires = orders[keep], fires[keep]
    return orders, fires


def shaking(
    kind: str, order: int, fires: np.ndarray, places: np.ndarray, bank_deg: float
) -> np.ndarray:
    """The greatest force or couple of an order, each piston pushing along its own axis [o]."""
    bearings = np.zeros(fires.shape[1])
    if bank_deg:
        bearings = np.radians(bank_deg / 2) * np.where(np.arange(fires.shape[1]) % 2, -1, 1)
    arms = places if kind == "M" else np.ones(len(places))
    turn = 1j * order * np.radians(fires)
    ways = [np.abs((np.exp(1j * bearings) * np.exp(sign * turn) / 2) @ arms) for sign in (-1, 1)]
    return ways[0] + ways[1]


def torsion(order: float, fires: np.ndarray, shape: np.ndarray) -> np.ndarray:
    """The sum of the amplitudes, each turned by its firing angle [o]."""
    return np.abs(np.exp(-1j * order * np.radians(fires)) @ shape)


def neighbours(orders: np.ndarray, *, vee: bool) -> np.ndarray:
    """How many firings are followed by one next to it in the same bank [o]."""
    apart = np.abs(orders.astype(int) - np.roll(orders, -1, axis=1))
    return (apart == (2 if vee else 1)).sum(axis=1).astype(float)


def front(values: np.ndarray) -> list[tuple[tuple[float, ...], int]]:
    """The values that none betters, and how many orders have each, in ascending order."""
    points: list[Any] = []
    left = values[np.lexsort(np.round(values, 7).T[::-1])]
    while len(left):
        best = left[left.sum(axis=1).argmin()]
        same = (np.abs(left - best) <= SAME).all(axis=1)
        points.append((tuple(float(v) for v in best), int(same.sum())))
        left = left[~(left >= best - SAME).all(axis=1)]
    return sorted(points, key=lambda point: tuple(round(v, 7) for v in point[0]))
