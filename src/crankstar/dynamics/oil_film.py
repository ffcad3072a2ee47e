"""The oil film of a plain bearing under a load that turns and changes: orbit and least film.

Booth's mobility method for a short bearing. The centre of the journal is at e from that of the
bearing, epsilon = e/c with the radial clearance c; under the load F on the journal, which turns
with the mean speed w_m of journal and bearing,

    d(epsilon)/dt = |F| (c/R)^2/(mu L D) M  +  w_m x epsilon

with the mobility M of a film that ruptures, xi along the load and eta across it, of epsilon:

    M_xi  = (1 - xi)^(5/2) / (pi (L/D)^2),   M_eta = -4 eta (1 - xi)^(3/2) / (pi^2 (L/D)^2)

L, D = 2R length and diameter of the bearing, mu the viscosity of the oil where it is warm. The
least film is c (1 - |epsilon|). A short bearing has L/D up to about 0.7; elasticity, the oil supply
and grooves are left out. Beside the numerical film of a short bearing the closed M is within 10 %.

Source: J. F. Booker, Dynamically Loaded Journal Bearings: Mobility Method of Solution, ASME Journal
of Basic Engineering 87 (1965); P. K. Goenka, ASME Journal of Tribology 106 (1984).
"""

from __future__ import annotations

from dataclasses import dataclass
from math import pi

import numpy as np

from crankstar import spectra
from crankstar.language.messages import MessageError
from crankstar.spectra import Complex, Real, Spectrum

SAMPLES = 720
"""Of a turn in the answer."""
MOST_CYCLES = 40
CLOSED = 1e-5
"""Change of epsilon from one cycle to the next below which the orbit has closed."""
START = 0.3
"""The eccentricity at which the integration begins."""


class OilFilmError(MessageError):
    """An orbit that cannot be computed, and why."""


@dataclass(frozen=True)
class Orbit:
    """The journal in its bearing over a cycle [angle]: `epsilon` = e/c, up + i right of the clock.

    `theta` in radians; `least` is the least film (m) and `least_theta` its crank angle.
    """

    theta: Real
    epsilon: Complex
    clearance: float

    @property
    def film(self) -> Real:
        """The thickness of the film where it is thinnest, m [angle]."""
        return self.clearance * (1 - np.abs(self.epsilon))

    @property
    def least(self) -> float:
        """The least film of the cycle, m."""
        return float(self.film.min())

    @property
    def least_theta(self) -> float:
        """The crank angle of the least film, radians."""
        return float(self.theta[int(np.argmin(self.film))])


def mobility(epsilon: complex, *, length_ratio: float) -> complex:
    """M of a short bearing; epsilon and M along the load (real) and across it (imaginary).

    At the centre a journal goes with its load: (4/pi) for a bearing of half its diameter.

    >>> round(mobility(0j, length_ratio=0.5).real * pi, 12)
    4.0
    """
    left = 1 - epsilon.real
    along = left**2.5 / pi
    across = -4 * epsilon.imag * left**1.5 / pi**2
    return complex(along, across) / length_ratio**2


def orbit(
    load: Spectrum,
    *,
    speed: float,
    mean_speed: float | Real,
    diameter: float,
    length: float,
    clearance: float,
    viscosity: float,
) -> Orbit:
    """The orbit of a journal under a load (N) on it, once it repeats with the load.

    `speed` (rad/s) is that of the reference crankshaft, `mean_speed` that of journal and bearing,
    positive clockwise: half the speed of a main journal; of a crank pin, whose bearing swings with
    the rod, values at equal steps over the period of the load. SI. Raises OilFilmError.

    Under a steady load the journal comes to rest aside of it, and the film is as thick as the
    Ocvirk number says:

    >>> steady = Spectrum(np.array([0.0]), np.array([-2000.0 + 0j]), np.array([0j]))
    >>> sizes = {"diameter": 0.05, "length": 0.025, "clearance": 25e-6, "viscosity": 0.01}
    >>> found = orbit(steady, speed=300.0, mean_speed=150.0, **sizes)
    >>> bool(np.ptp(np.abs(found.epsilon)) < 1e-4), bool(0 < found.least < 25e-6)
    (True, True)
    """
    from scipy.integrate import solve_ivp

    turns = spectra.period(load)
    cycle = 2 * pi * turns
    rate = (2 * clearance / diameter) ** 2 / (viscosity * length * diameter * speed)
    ratio = length / diameter
    grid = np.linspace(0.0, cycle, SAMPLES * turns + 1)
    around = np.atleast_1d(np.asarray(mean_speed, float)) / speed
    around = np.interp(grid, np.linspace(0.0, cycle, around.size + 1), [*around, around[0]])
    force = spectra.value(load, grid)
    up, right = np.real(force), np.imag(force)
    if not np.abs(force).max() > 0:
        raise OilFilmError("there is no load on this bearing, and so no orbit")

    def slope(theta: float, state: Real) -> list[float]:
        here = complex(state[0], state[1])
        size = abs(here)
        if size >= 1:  # a trial step beyond the wall: back
            here *= (1 - 1e-9) / size
        push = complex(np.interp(theta, grid, up), np.interp(theta, grid, right))
        way = push / abs(push) if push else 1 + 0j
        moved = abs(push) * rate * mobility(here / way, length_ratio=ratio) * way
        moved += 1j * float(np.interp(theta, grid, around)) * here
        return [moved.real, moved.imag]

    first = START * complex(force[0]) / abs(force).max()
    state = [first.real, first.imag]
    for _ in range(MOST_CYCLES):
        found = solve_ivp(
            slope, (0.0, cycle), state, method="LSODA", t_eval=grid, rtol=1e-7, atol=1e-9
        )
        if not found.success:
            break
        moved = abs(complex(*found.y[:, -1]) - complex(*state))
        state = found.y[:, -1].tolist()
        if moved < CLOSED:
            epsilon = found.y[0, :-1] + 1j * found.y[1, :-1]
            return Orbit(grid[:-1], epsilon, clearance)
    raise OilFilmError("the orbit does not close: is the load far too great for the bearing?")
