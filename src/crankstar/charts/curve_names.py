"""The results of a sweep in the words of the field."""

from __future__ import annotations

from collections.abc import Sequence

from crankstar.language.messages import N_, _
from crankstar.studies.sweep import Curve

NAMES = {
    "force": N_("force"),
    "force.up": N_("vertical force"),
    "force.right": N_("horizontal force"),
    "force.forward": N_("force with the crank"),
    "force.backward": N_("force against the crank"),
    "couple": N_("couple"),
    "couple.up": N_("pitch M_V"),
    "couple.right": N_("yaw M_H"),
    "couple.pitch": N_("pitch M_V"),
    "couple.yaw": N_("yaw M_H"),
    "couple.forward": N_("couple with the crank"),
    "couple.backward": N_("couple against the crank"),
    "roll": N_("rolling moment"),
    "axis_moment": N_("moment about the crank axis"),
    "torque": N_("inertia torque"),
    "torque_with_gas": N_("torque of gas and inertia"),
    "roll_with_gas": N_("rolling moment with gas"),
    "mean_torque": N_("mean gas torque"),
    "peak_pressure": N_("peak pressure"),
    "irregularity": N_("degree of irregularity"),
    "torsion_frequency": N_("first torsional frequency"),
    "torsion_stress": N_("greatest shear stress of torsional vibration"),
    "torsion_amplitude": N_("torsional vibration of the free end"),
    "mount_mode_1": N_("first mode on the mounts"),
    "mount_mode_2": N_("second mode on the mounts"),
    "mount_mode_3": N_("third mode on the mounts"),
    "mount_mode_4": N_("fourth mode on the mounts"),
    "mount_mode_5": N_("fifth mode on the mounts"),
    "mount_mode_6": N_("sixth mode on the mounts"),
    "mount_roll_mode": N_("mode of roll on the mounts"),
    "mount_roll_share": N_("share of roll in its mode"),
    "mount_force": N_("net force of the mounts on the ground, rms"),
    "mount_velocity": N_("velocity of the point on the mounts, rms"),
}
"""By what is watched."""


def names_of(curves: Sequence[Curve]) -> str:
    """What several curves are, for a title: each quantity once, the order if it is the same."""
    orders = {curve.order for curve in curves}
    same = next(iter(orders)) if len(orders) == 1 else None
    named = [curve_name(curve._replace(order=same)) for curve in curves]
    return ", ".join(dict.fromkeys(named))


def curve_name(curve: Curve) -> str:
    """What a curve is, with its order.

    >>> from crankstar.studies.sweep import swept, watched
    >>> curve_name(watched(swept("i4", over="balance_factor", values=[0, 1]), "roll", order=2))
    'rolling moment of order 2'
    """
    name = _(NAMES[curve.what])
    if curve.order is None:
        return name
    return _("{quantity} of order {order}", quantity=name, order=f"{curve.order:g}")
