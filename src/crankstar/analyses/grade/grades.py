"""The permissible residual unbalance of a rotor by its balance quality grade.

    e_per = G / omega,    U_per = m e_per,    F = U omega^2

with the grade G in mm/s, the greatest service speed omega, the rotor's mass m. For a rotor whose
centre of mass lies between its bearings, at L_A and L_B from them, the bearing planes have

    U_A = U_per L_B / (L_A + L_B),    U_B = U_per L_A / (L_A + L_B),

each at least 0.3 and at most 0.7 of U_per.

Source: the method of ISO 21940-11 (before: ISO 1940-1) as makers of tools and balancing machines
publish it; the text of the standard itself was not at hand.
"""

from __future__ import annotations

from collections.abc import Sequence

GRADES = (0.4, 1.0, 2.5, 6.3, 16.0, 40.0, 100.0, 250.0, 630.0, 1600.0, 4000.0)
"""The grades of the standard, mm/s, each 2.5 times the one before."""
LEAST_SHARE, GREATEST_SHARE = 0.3, 0.7
"""Of the permissible unbalance in a bearing plane."""


def permissible(grade: float, *, mass: float, speed: float) -> float:
    """Permissible residual unbalance [kg m] by grade [mm/s], mass [kg] and speed [rad/s].

    A tool holder of 2 kg at 10000 rpm and G 6.3 may have 12 g mm.

    Source: WIDIA catalogue of tool holders, page K53, example.

    >>> round(permissible(6.3, mass=2, speed=10_000 * 3.14159265 / 30) * 1e6)
    12
    """
    return grade / 1000 * mass / speed


def shares(*, front: float, rear: float) -> tuple[float, float]:
    """Shares of the bearing planes at these distances from the centre of mass, both positive.

    >>> shares(front=0.2, rear=0.3), shares(front=0.1, rear=0.9)
    ((0.6, 0.4), (0.7, 0.3))
    """
    share = min(max(rear / (front + rear), LEAST_SHARE), GREATEST_SHARE)
    return share, round(1 - share, 12)


def grade_of(unbalance: float, *, mass: float, speed: float) -> float:
    """The grade [mm/s] whose permissible unbalance is this [kg m]: G = U omega / m.

    180 g mm on 6 kg at 5000 rpm, 30 micrometres, are G 15.7.

    >>> round(grade_of(180e-6, mass=6, speed=5000 * 3.14159265 / 30), 1)
    15.7
    """
    return 1000 * unbalance * speed / mass


def grade_met(grade: float) -> float | None:
    """The finest grade of the standard that a rotor of this quality meets; None for none.

    >>> grade_met(15.7), grade_met(16.0), grade_met(5000)
    (16.0, 16.0, None)
    """
    return next((each for each in GRADES if grade <= each * (1 + 1e-9)), None)


def grade_of_planes(
    unbalances: Sequence[float], *, mass: float, speed: float, planes: tuple[float, float]
) -> float:
    """The grade [mm/s] of residual unbalances [kg m] in the bearing planes with these shares.

    The plane that is worse for its share decides; one value alone is that of the whole rotor.

    >>> speed = 6000 * 3.14159265 / 30
    >>> worse = grade_of_planes([60e-6, 90e-6], mass=18, speed=speed, planes=(0.5, 0.5))
    >>> round(worse, 2), round(grade_of(180e-6, mass=18, speed=speed), 2)
    (6.28, 6.28)
    """
    parts = (1.0,) if len(unbalances) == 1 else planes
    return max(
        grade_of(size / share, mass=mass, speed=speed)
        for size, share in zip(unbalances, parts, strict=True)
    )
