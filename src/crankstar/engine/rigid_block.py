"""The six freedoms of a rigid block: how its points move, its mass, and the springs that hold it.

The freedoms are those in which the project counts forces and couples, about the centre of mass G:

    q = (up, right, z, yaw, pitch, roll)             m, rad

yaw carries the front to the right, pitch lifts the front, roll turns clockwise seen from the front.
A point at (u, r, z) from G moves by T q, with

        | 1 0 0   0   z  -r |   up
    T = | 0 1 0   z   0   u |   right
        | 0 0 1  -r  -u   0 |   z

so that T' F of a force F at that point is force, M_H, M_V and rolling moment with the signs of
`docs/explanation/conventions.md`. Everything else follows from T:

    M = integral of T' T dm      K = sum of T' A k A' T, A the axes of a mount, k along them

The rotations of M are I_up, I_right, I_z on the diagonal, and P_ur (yaw with pitch), P_uz (yaw with
roll), -P_rz (pitch with roll), where P_ur = integral of u r dm are the products of inertia.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from crankstar.engine.mounts import Mount
from crankstar.spectra import Real

FREEDOMS = ("up", "right", "z", "yaw", "pitch", "roll")
SINGULAR = 1e-9
"""Share of the greatest stiffness below which a freedom counts as unrestrained."""


def moved(place: Real | Sequence[float]) -> Real:
    """T of points [..., 3] given as (up, right, z) from G: [..., 3, 6].

    A yaw of 0.1 rad carries a point 2 m in front of G by 0.2 m to the right:

    >>> (moved([0, 0, 2.0]) @ [0, 0, 0, 0.1, 0, 0]).tolist()
    [0.0, 0.2, 0.0]
    """
    at = np.asarray(place, float)
    out = np.zeros((*at.shape[:-1], 3, 6))
    u, r, z = at[..., 0], at[..., 1], at[..., 2]
    out[..., 0, 0] = out[..., 1, 1] = out[..., 2, 2] = 1.0
    out[..., 0, 4], out[..., 0, 5] = z, -r
    out[..., 1, 3], out[..., 1, 5] = z, u
    out[..., 2, 3], out[..., 2, 4] = -r, -u
    return out


def mount_axes(mount: Mount) -> Real:
    """The axes of a mount as rows, each (up, right, z) [3, 3].

    The first points to `bearing` in the clock plane and leans to the front by `lean`; `twist` turns
    the other two about it, the second towards the third.

    >>> from math import pi
    >>> mount_axes(Mount(name="a", stiffness=[1.0], bearing=pi / 2)).round(9).tolist()[0]
    [0.0, 1.0, 0.0]
    """
    b, a, t = mount.bearing, mount.lean, mount.twist
    outward = np.array([np.cos(b), np.sin(b), 0.0])
    along = np.array([0.0, 0.0, 1.0])
    first = np.cos(a) * outward + np.sin(a) * along
    second = np.array([-np.sin(b), np.cos(b), 0.0])
    third = np.cos(a) * along - np.sin(a) * outward
    turned = np.cos(t) * second + np.sin(t) * third, np.cos(t) * third - np.sin(t) * second
    return np.array([first, *turned])


def held(mounts: Sequence[Mount], *, centre: Sequence[float]) -> Real:
    """What the freedoms of a block do along the axes of its mounts, [mount, axis, 6].

    >>> side = Mount(name="a", right=0.3, stiffness=[1.0])
    >>> held([side], centre=(0, 0, 0))[0, 0].tolist()  # a clockwise roll presses a mount right of G
    [1.0, 0.0, 0.0, 0.0, 0.0, -0.3]
    """
    places = np.array([[each.up, each.right, each.z] for each in mounts]) - np.asarray(centre)
    axes = np.array([mount_axes(each) for each in mounts])
    return axes @ moved(places)


def gathered(held_by: Real, *, values: Real) -> Real:
    """The matrix [..., 6, 6] of stiffnesses or dampings [..., mount, axis] of mounts.

    >>> side = Mount(name="a", right=0.3, stiffness=[100.0])
    >>> arms = held([side], centre=(0, 0, 0))
    >>> gathered(arms, values=np.array([side.along]))[5, 5].round(9).item()
    9.0
    """
    flat = held_by.reshape(-1, held_by.shape[-1])
    along = np.asarray(values)
    along = along.reshape(*along.shape[:-2], -1)
    return (flat.T * along[..., None, :]) @ flat


def mass_matrix(mass: float, *, inertia: Sequence[float], products: Sequence[float]) -> Real:
    """M of a body about its centre of mass: moments (up, right, z), products (ur, uz, rz).

    >>> mass_matrix(2.0, inertia=(3, 4, 5), products=(0.1, 0.2, 0.3))[3:, 3:].tolist()
    [[3.0, 0.1, 0.2], [0.1, 4.0, -0.3], [0.2, -0.3, 5.0]]
    """
    out = np.diag([mass] * 3 + list(inertia)).astype(float)
    up_right, up_z, right_z = products
    out[3, 4] = out[4, 3] = up_right
    out[3, 5] = out[5, 3] = up_z
    out[4, 5] = out[5, 4] = -right_z
    return out


def unrestrained(mounts: Sequence[Mount]) -> tuple[str, ...]:
    """The freedoms that mounts leave free, about their own middle; empty where they hold it.

    >>> line = [Mount(name=str(z), z=z, stiffness=[1.0]) for z in (-1.0, 0.0, 1.0)]
    >>> unrestrained(line)
    ('roll',)
    """
    places = np.array([[each.up, each.right, each.z] for each in mounts])
    middle = places.mean(axis=0)
    reach = float(np.sqrt(((places - middle) ** 2).sum(axis=1).mean())) or 1.0
    scale = np.array([1.0] * 3 + [1 / reach] * 3)
    along = np.array([each.along for each in mounts])
    stiffness = gathered(held(mounts, centre=middle), values=along) * np.outer(scale, scale)
    values, shapes = np.linalg.eigh(stiffness)
    free = shapes[:, values <= SINGULAR * max(float(values[-1]), 1e-300)]
    largest = np.argsort(-(free**2).sum(axis=1), kind="stable")[: free.shape[1]]
    return tuple(FREEDOMS[place] for place in sorted(largest))
