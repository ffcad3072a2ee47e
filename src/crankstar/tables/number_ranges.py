"""The range of a number or an amplitude that rests on estimates, from its values at their ends.

An amplitude is linear in each estimated value while the others are held, and the absolute value of
what is linear is convex: over the box of ranges it is nowhere greater than at a corner. Where it is
in the middle the mean of the corners, it is itself linear (nothing cancels), and nowhere less than
at a corner. Else the mean is greater by d, and it is nowhere less than

    2 |f(middle)| - max |f(corner)|,

since the points x and 2 middle - x lie in the box together. Where d is small this is far too low:
f turns little, its part along f(middle) is linear, and what is across adds b^2 / 2 |f|, which is d
on an average and about d |f(middle)| / |f| at a corner. Twice that below the least corner is taken,
where it is higher (tests draw masses at random). A complex amplitude lies in the convex hull of
those at the corners, whose distance from zero is its lower bound; and a size that knows the
amplitudes it comes from (`mechanics.bounds.Size`) is bounded by theirs.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from crankstar.analysis.document import Ranged
from crankstar.mechanics.bounds import Size
from crankstar.tables.hulls import distances, greatest_sum

SAME = 1e-7
"""Share of the greatest value of a column below which values are the same."""
LINEAR = 1e-6
"""Share of the greatest by which the middle may lie below the mean of the corners."""


def number_range(numbers: Sequence[float | complex], top: float = 0.0) -> float | complex | Ranged:
    """A number as given with its range from those in the middle and at the corners, all in a row.

    It is the number itself where they differ by no more than SAME of the greatest, or of `top`.
    """
    if any(isinstance(each, complex) for each in numbers):
        return _complex_range([complex(each) for each in numbers], top)
    return real_range([*map(float, numbers)], top, bound=_bound(numbers))  # pyright: ignore[reportArgumentType]


def real_range(numbers: Sequence[float], top: float, *, bound: float = 0.0) -> float | Ranged:
    """The same of real numbers, sizes that are nowhere below `bound`."""
    value, middle, *corners = numbers
    least, most = min(numbers), max(numbers)
    if most - least <= SAME * max(top, abs(least), abs(most)):
        return value
    bend = sum(corners) / len(corners) - middle
    if least < 0 or bend <= LINEAR * most:
        return Ranged(value, least, most)
    far = 2 * middle - max(corners)
    near = least - 2 * bend * middle / least if least > 0 else 0.0
    low = max(0.0, far, near, bound)
    return Ranged(value, min(least, low if low > SAME * most else 0.0), most)


def _bound(numbers: Sequence[float]) -> float:
    """What sizes that know their bounds are nowhere below; 0 of others."""
    bounds = [each.bounds for each in numbers if isinstance(each, Size)]
    if len(bounds) < len(numbers) or len({each.shape for each in bounds}) > 1:
        return 0.0
    return float(greatest_sum(np.stack(bounds, axis=-1)))


def _complex_range(numbers: Sequence[complex], top: float) -> complex | Ranged:
    value = numbers[0]
    points = np.array(numbers)
    most = float(np.max(np.abs(points)))
    if float(np.max(np.abs(points - value))) <= SAME * max(top, most):
        return value
    low = float(distances(points))
    return Ranged(value, low if low > SAME * most else 0.0, most)
