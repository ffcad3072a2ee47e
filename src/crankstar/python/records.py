"""The records that an engine file can have, under one name: `crankstar.records`."""

from __future__ import annotations

from crankstar.engine.block import Block, BlockPoint
from crankstar.engine.cylinder_parts import Articulation, Parts, Rod
from crankstar.engine.drive import Drive
from crankstar.engine.engine import Engine
from crankstar.engine.gas import Gas, Load, Trace
from crankstar.engine.mounts import FootReceptance, Foundation, Mount, Stiffening
from crankstar.engine.oil import Oil, PlainBearing
from crankstar.engine.provenance import Provenance
from crankstar.engine.records import Cylinder, Shaft, Throw, Valves, Weight
from crankstar.engine.torsion import (
    Chain,
    Coupling,
    CrankDimensions,
    CrankFatigue,
    Disc,
    Pendulum,
    Torsion,
)

__all__ = [
    "Articulation",
    "Block",
    "BlockPoint",
    "Chain",
    "Coupling",
    "CrankDimensions",
    "CrankFatigue",
    "Cylinder",
    "Disc",
    "Drive",
    "Engine",
    "FootReceptance",
    "Foundation",
    "Gas",
    "Load",
    "Mount",
    "Oil",
    "Parts",
    "Pendulum",
    "PlainBearing",
    "Provenance",
    "Rod",
    "Shaft",
    "Stiffening",
    "Throw",
    "Torsion",
    "Trace",
    "Valves",
    "Weight",
]
