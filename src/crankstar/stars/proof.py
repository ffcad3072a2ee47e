"""Whether sums of many stars vanish, and which are equally long, decided in whole numbers.

A sum of w_j exp(i 2 pi t_j) with rational w and t is a polynomial in the root of unity of order D,
the common denominator of the turns, and so is the square of its length, the product with its
conjugate. `derive.cyclotomic` reduces them to coefficients that are unique: here for all stars at
once, in whole numbers.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import lcm

import numpy as np

from crankstar.derive.algebra import cyclotomic
from crankstar.stars.star import Star
from crankstar.stars.sums import VectorSum


def vanishing(vector: VectorSum, stars: Sequence[Star]) -> np.ndarray:
    """Of each star, whether the sum is exactly zero [stars]."""
    return cyclotomic.vanishing(_coefficients(vector, stars))


def squares(vector: VectorSum, stars: Sequence[Star]) -> np.ndarray:
    """Whole numbers, equal for two stars if and only if their sums are equally long [stars, k]."""
    plain = _coefficients(vector, stars)
    order = plain.shape[1]
    out = np.zeros_like(plain)
    for shift in range(order):
        out[:, shift] = (plain * np.roll(plain, shift, axis=1)).sum(axis=1)
    return out @ cyclotomic.reduction(order).astype(out.dtype)


def alike(vectors: Sequence[VectorSum], stars: Sequence[Star]) -> np.ndarray:
    """Numbers of classes of stars for which all sums are equally long, from 0 [stars]."""
    if not stars or not vectors:
        return np.zeros(len(stars), np.int64)
    keys = np.hstack([squares(vector, stars) for vector in vectors])
    known: dict[tuple[int, ...], int] = {}
    return np.array([known.setdefault(tuple(row), len(known)) for row in keys.tolist()])


def _coefficients(vector: VectorSum, stars: Sequence[Star]) -> np.ndarray:
    """The weights merged by their power of the root of unity, as Python integers [stars, D]."""
    order = lcm(*(turn.denominator for turn in vector.turns))
    whole = lcm(*(weight.denominator for weight in vector.weights))
    weights = [int(weight * whole) for weight in vector.weights]
    powers = np.array([int(turn * order) for turn in vector.turns])
    places = powers[np.array(stars, np.int64).reshape(-1, len(weights))]
    out = np.zeros((len(places), order), _kind(weights))
    rows = np.arange(len(places))
    for cylinder, weight in enumerate(weights):
        out[rows, places[:, cylinder]] += weight
    return out


def _kind(weights: Sequence[int]) -> type:
    """64 bits where products of sums of the weights, and what reducing adds, stay far below them.

    Else Python integers.
    """
    return np.int64 if sum(abs(weight) for weight in weights) < 2**20 else object
