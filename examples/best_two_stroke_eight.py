"""A problem left open by the textbook: a two-stroke eight without second-order couple.

Of these, the one with the least first-order couple.

All 5040 ways to number eight cranks at eighths of a turn are tried. Whether a couple is zero is
decided in whole numbers, for all of them at once; the smallest that remains is given in closed
form. Arms are counted in half bore pitches, from the middle.
"""

from __future__ import annotations

from fractions import Fraction
from itertools import permutations

import numpy as np

from crankstar.derive.algebra.cyclotomic import root, total, vanishing
from crankstar.derive.algebra.radicals import length
from crankstar.derive.algebra.typeset import text

CYLINDERS = 8


def main() -> dict[str, object]:
    """The number of stars without second-order couple; the least first-order couple among them.

    Also the firing orders with it.
    """
    seats = np.array(
        [(0, *rest) for rest in permutations(range(1, CYLINDERS))]
    )  # of each cylinder, in eighths of a turn
    arms = CYLINDERS - 1 - 2 * np.arange(CYLINDERS)
    good = seats[vanishing(sums(2 * seats, arms))]
    turning = np.exp(2j * np.pi * good / CYLINDERS) @ arms
    least = np.abs(turning).min()
    best = good[np.isclose(np.abs(turning), least)]
    orders = sorted("-".join(str(cylinder + 1) for cylinder in np.argsort(star)) for star in best)
    star = best[0]
    exact = total(
        root(Fraction(int(seat), CYLINDERS)).times(Fraction(int(arm), 2))
        for seat, arm in zip(star, arms, strict=True)
    )
    found = {
        "stars": len(seats),
        "without second-order couple": len(good),
        "smallest": text(length(exact)),
        "orders": orders,
    }
    print(
        f"{found['stars']} stars, {found['without second-order couple']} of them without "
        "second-order couple"
    )
    print(
        f"smallest first-order couple among them: {found['smallest']} = {least / 2:.4f} "
        f"(in P_R a), of {', '.join(orders)}"
    )
    return found


def sums(seats: np.ndarray, arms: np.ndarray) -> np.ndarray:
    """The couple of each star as a sum of roots of unity: arms by eighth of a turn."""
    out = np.zeros((len(seats), CYLINDERS), dtype=int)
    for cylinder, arm in enumerate(arms):
        np.add.at(out, (np.arange(len(seats)), seats[:, cylinder] % CYLINDERS), arm)
    return out


if __name__ == "__main__":
    main()
