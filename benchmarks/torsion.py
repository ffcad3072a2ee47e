"""Speed of torsional vibration: `make bench` prints it.

A V16 with damper, flywheel and generator: modes, the response in 24 half orders at 200 speeds, its
peaks, and the inertia of each crank angle at one speed; warm, medians.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from gas import seconds

import tables
from crankstar.dynamics.torsion_chain import torsion_chain
from crankstar.dynamics.torsion_excitation import excitation
from crankstar.dynamics.torsion_modes import torsion_modes
from crankstar.dynamics.torsion_response import response
from crankstar.dynamics.torsion_variable import variable_response
from crankstar.files import engine_of
from crankstar.mechanics.gas import cycle

V16: dict[str, Any] = {
    "name": "V16",
    "firing_order": [1, 9, 4, 12, 2, 10, 3, 11, 8, 16, 5, 13, 7, 15, 6, 14],
    "cylinder": {
        "bore": "170 mm",
        "stroke": "190 mm",
        "rod_length": "350 mm",
        "reciprocating_mass": "9 kg",
        "rotating_mass": "6 kg",
    },
    "layout": {
        "type": "vee",
        "bore_pitch": "230 mm",
        "banks": [
            {"bearing": "-22.5 deg", "cylinders": list(range(1, 9))},
            {"bearing": "22.5 deg", "cylinders": list(range(9, 17))},
        ],
        "throws": [f"{angle} deg" for angle in (0, 180, 90, 270, 270, 90, 180, 0)],
    },
    "gas": {"imep": "18 bar", "compression_ratio": 13, "intake_pressure": "2.5 bar"},
    "torsion": {
        "bare_inertia": "0.9 kg*m^2",
        "stiffness": "12 MN*m/rad",
        "damping": "30 N*m*s/rad",
        "disc": [
            {"name": "hub", "inertia": "0.8 kg*m^2", "to": "front", "stiffness": "9 MN*m/rad"},
            {"name": "ring", "inertia": "2.2 kg*m^2", "to": "hub", "damping": "900 N*m*s/rad"},
            {"name": "flywheel", "inertia": "12 kg*m^2", "to": "rear", "stiffness": "20 MN*m/rad"},
            {
                "name": "generator",
                "inertia": "40 kg*m^2",
                "to": "flywheel",
                "stiffness": "1 MN*m/rad",
            },
        ],
    },
}


def main() -> None:
    """Print the table."""
    engine = engine_of(V16)
    chain = torsion_chain(engine)
    push = excitation(chain, engine, cycle(engine), orders=[n / 2 for n in range(1, 25)])
    speeds = np.linspace(60.0, 190.0, 200)
    found = response(chain, push, speeds=speeds)
    rows: list[tables.Row] = []
    for what, work, budget in (
        ("modes of a V16 with damper and generator", lambda: torsion_modes(chain), "-"),
        ("its response, 24 orders at 200 speeds", lambda: response(chain, push, speeds=speeds), 20),
        (
            "peak torque of its shafts at these",
            lambda: response(chain, push, speeds=found.speeds).peak,
            "-",
        ),
        (
            "inertia of each crank angle, one speed",
            lambda: variable_response(chain, push, speed=150.0),
            "-",
        ),
    ):
        took = 1e3 * seconds(work, times=10)
        rows.append((what, f"{took:.3g} ms", f"{budget} ms" if budget == 20 else "-"))
    tables.show("torsion", rows)


if __name__ == "__main__":
    main()
