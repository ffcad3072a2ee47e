"""Speed of an engine on its mounts: `make bench` prints it.

A six on six mounts: its modes, the response in 24 half orders at 300 speeds, and what is asked of
it: motion of a point, forces in the mounts and on the ground; warm, medians.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from gas import seconds

import tables
from crankstar.dynamics.mount_excitation import mount_excitation
from crankstar.dynamics.mount_modes import mount_modes
from crankstar.dynamics.mount_response import MountResponse, mount_response, peak, rms
from crankstar.dynamics.mounted_block import mounted_block
from crankstar.files import engine_of

SIX: dict[str, Any] = {
    "name": "six",
    "firing_order": [1, 5, 3, 6, 2, 4],
    "cylinder": {
        "bore": "128 mm",
        "stroke": "155 mm",
        "rod_length": "250 mm",
        "reciprocating_mass": "3.6 kg",
        "rotating_mass": "2.4 kg",
    },
    "layout": {"type": "inline", "bore_pitch": "160 mm"},
    "gas": {"imep": "16 bar", "compression_ratio": 16},
    "block": {
        "mass": "1100 kg",
        "up": "180 mm",
        "inertia_up": "160 kg*m^2",
        "inertia_right": "170 kg*m^2",
        "inertia_z": "55 kg*m^2",
    },
    "mounts": [
        {
            "name": f"{side} {z}",
            "right": f"{side * 350} mm",
            "z": f"{z} mm",
            "stiffness": ["900 N/mm", "400 N/mm", "400 N/mm"],
            "bearing": f"{-side * 40} deg",
            "loss_factor": 0.1,
            "damping": "200 N*s/m",
            "rubber": [{"frequency": "50 Hz", "factor": 1.3}],
        }
        for side in (-1, 1)
        for z in (-500, 0, 450)
    ],
}


def asked(found: MountResponse) -> None:
    """What a table over speeds tells."""
    point = (0.5, 0.0, 0.4)
    for each in (found.displacement(point), found.velocity(point), found.ground_force):
        rms(each[..., :3])
        peak(each[..., :3], orders=found.orders)
    _ = found.transmissibility


def main() -> None:
    """Print the table."""
    engine = engine_of(SIX)
    block = mounted_block(engine)
    speeds = np.linspace(60.0, 260.0, 300)
    push = mount_excitation(block, engine, speeds=speeds, orders=[n / 2 for n in range(1, 25)])
    found = mount_response(block, push)
    rows: list[tables.Row] = []
    for what, work, budget in (
        ("modes of a six on six mounts that stiffen", lambda: mount_modes(block), "-"),
        ("response, 24 orders at 300 speeds", lambda: mount_response(block, push), "30 ms"),
        (
            "with motion, forces, transmissibility",
            lambda: asked(MountResponse(block, push, found.motion)),
            "-",
        ),
    ):
        took = 1e3 * seconds(work, times=10)
        rows.append((what, f"{took:.3g} ms", budget))
    tables.show("mounts", rows)


if __name__ == "__main__":
    main()
