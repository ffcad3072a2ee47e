"""What an engine file leaves out or does not give for certain, as far as an answer uses it.

Each value with its ends: those of the type of engine where statistics of such engines are known,
else what is wide enough for engines of one kind.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import replace
from math import pi
from typing import TYPE_CHECKING

from crankstar.analysis.assumptions import Answer, Assumption
from crankstar.analysis.changed_values import (
    point_value,
    with_bearings_moved,
    with_block_inertia,
    with_block_mass,
    with_block_product,
    with_block_value,
    with_disc_damping,
    with_drive_inertia,
    with_mount_loss,
    with_rear_disc,
    with_torsion_value,
)
from crankstar.analysis.scaled_values import SCALED, speed_value
from crankstar.dynamics.mount_doubts import mount_doubts
from crankstar.dynamics.uneven_doubts import uneven_doubts
from crankstar.engine.basis import ROD_SOURCE
from crankstar.engine.block import inertia_in_box
from crankstar.engine.engine import Engine
from crankstar.engine.mounts import RUBBER_LOSS_FACTOR
from crankstar.engine.torsion import LOSS_FACTOR, STEEL
from crankstar.language.faults import Fault
from crankstar.language.messages import N_
from crankstar.mechanics.chain_inertia import APART, chain_inertia
from crankstar.mechanics.doubts import OF_FLYWHEEL, doubts_of
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.gas_torque import gas_torque
from crankstar.studies.assumed_doubts import doubtful
from crankstar.studies.assumed_gas import gas_values, valves, without_gas
from crankstar.studies.assumed_masses import masses

if TYPE_CHECKING:
    from crankstar.dynamics.whirl import Body

DOUBTFUL = ("unverified", "placeholder")
"""Statuses of values of a file that nobody has read in a source."""
FLYWHEELS = {
    "running": Assumption(
        "left out",
        "drive.inertia",
        N_("no flywheel in the file"),
        sentence=N_("Not in the file, which takes away the uneven running alone: {paths}."),
    ),
    "sized": Assumption(
        "missing", "drive.inertia", N_("no flywheel beside the one that is sized"), explained=True
    ),
}
"""What is said where a file has none, by what an answer is made of."""
OF_GAS = ("gas", "drive", "valves")
"""Tables of a file that no inertia depends on."""
TIMING = frozenset({"valves", "firing"})
"""Answers that are about timing alone: no part that moves matters to them."""
POINT = re.compile(r"gas\.point(?:\[(\d+)\])?\.(\w+)")
"""A key of an operating point: of all, or of one counted from one."""
WHEEL_ENDS = (1.0, 10.0)
"""Ends of the inertia of a flywheel and what turns with it, as multiples of that of the throws.

Our judgement: from a racing clutch to the wheel of a slow engine.
"""
LOSS_ENDS = (0.5, 2.0)
"""Ends of the loss factor of shafts, as multiples: crankshafts in service lose 1 to 4 % a cycle."""
DAMPING_ENDS = (1e4, 8e4)
"""Ends of the damping of a throw against the block, N s/m^3 of piston area times r^2.

It grows with the area that is lubricated and with the square of the speed of the piston over that
of the crank, r^2. The shafts of the documents have 2e4 to 7e4; 0.8 N m s/rad, 4.8e4 of an in-line
six of 84 x 110 mm, is a loss factor of 0.02 of its first mode. The ends are our judgement.
"""
RUBBER_ENDS = (0.5, 2.5)
"""Ends of the loss factor of rubber: 0.05 of natural rubber to 0.25 of filled kinds."""
REST = 0.1
"""Share of the inertia of a drive from which it is said that a shaft that twists lacks it."""
DRIVEN = 5.0
"""High end of the damping of what is driven, over its torque by its speed: a ship's propeller.

Rules of classification give propellers 2 (a load with the square of the speed) to about 5.
"""
STEEL_ENDS = (79e9, 83e9)
"""Pa: the shear moduli of cast iron with nodules and of forged steel lie about here."""
STIFFNESS_ENDS = (0.85, 1.15)
"""Ends of the stiffness of a throw by its dimensions: empirical rules differ by as much."""
WALLED_ENDS = (0.5, 2.5)
"""Ends of moments of inertia of the walls of a box about cylinders and crankcase.

A V6 of 225 kg with its gearbox has 0.9 (roll) to 2.6 times (yaw); a body that fills the box 0.6.
Our judgement.
"""
CENTRE_OFF = 0.2
"""By how much of the span of the cylinders the centre of mass may lie off their middle."""
HEIGHTS = (-1.0, 3.0)
"""Ends of the height of a centre of mass over the crankshaft, crank radii: our judgement."""
PRODUCTS = {
    (0, 1): ("product_up_right", 0.1),
    (0, 2): ("product_up_z", 0.2),
    (1, 2): ("product_right_z", 0.1),
}
"""Ends of products of inertia in the mean of their two moments (up, right, z).

A gearbox that hangs behind an engine has most of up and z. Our judgement.
"""
SHIFT = 10.0
"""By how many per cent of the least distance between two a main bearing may lie elsewhere."""


def assumed_values(engine: Engine, answer: Answer) -> Iterator[Assumption]:
    """All that is lacking or doubtful of what an answer uses, in no order."""
    if not {*answer.uses} <= TIMING:
        yield from _not_modelled(engine)
    yield from doubtful(engine, _doubts(engine, answer))
    yield from answer.choices
    if "inertia" in answer.uses:
        yield from masses(engine, fitted="fitted" in answer.uses, given=answer.given)
    if answer.without_gas is not None:
        yield without_gas(engine, answer.without_gas)
    elif answer.gas is None and answer.gasless:
        reason = answer.why_gasless or N_("there is no gas in it")
        yield Assumption(
            "left out", "gas", reason,
            explained=bool(answer.why_gasless), sentence=answer.gasless,
        )  # fmt: skip
    if "gas" in answer.uses and answer.gas is not None:
        yield from gas_values(engine, answer.gas)
    if engine.drive is None or engine.drive.inertia is None:
        whole = chain_inertia(engine)
        told = (each for use, each in FLYWHEELS.items() if use in answer.uses)
        yield from told if whole is None else (_of_chain(whole) for _each in [*told][:1])
    if "bearings" in answer.uses:
        yield from _bearings(engine)
    if "torsion" in answer.uses:
        yield from _torsion(engine)
        yield from _driven_discs(engine, answer.gas)
    if "mounts" in answer.uses:
        yield from _mounts(engine)
    if "valves" in answer.uses and engine.firing_order:
        yield from (replace(each, vary=None) for each in valves(engine))  # they are the figure
    yield from _unverified(engine, answer)


def _doubts(engine: Engine, answer: Answer) -> list[Fault]:
    """What is doubtful of what an answer uses, of a flywheel with a size of effect if known."""
    found = doubts_of(engine, answer.uses, answer.gas)
    if "mounts" in answer.uses:
        found = (*found, *mount_doubts(engine))
    runs = not {*FLYWHEELS}.isdisjoint(answer.uses)
    uneven: tuple[Fault, ...] = ()
    if runs and answer.gas is not None:
        uneven = uneven_doubts(engine, answer.gas, generating="set" in answer.uses)
    turns = (runs and not uneven) or "torsion" in answer.uses
    return [*uneven, *(each for each in found if turns or each.code not in OF_FLYWHEEL)]


def _not_modelled(engine: Engine) -> Iterator[Assumption]:
    """Parts that the engine has and its file leaves out."""
    for number, part in enumerate(engine.left_out, 1):
        yield Assumption(
            "not modelled", f"left_out[{number}]",
            N_("the engine has it, its file does not describe it: no number includes it"), part,
        )  # fmt: skip


def _bearings(engine: Engine) -> Iterator[Assumption]:
    """Places of main bearings that are assumed beside the throws."""
    if all(shaft.bearings or not shaft.throws for shaft in engine.shafts):
        return
    yield Assumption(
        "assumed", "crankshaft.bearings",
        N_("main bearings assumed beside the throws; how far they are shifted is not known"),
        unit="% of a gap", low=-SHIFT, high=SHIFT, vary=with_bearings_moved,
    )  # fmt: skip


def _torsion(engine: Engine) -> Iterator[Assumption]:
    """What is assumed of shafts that twist: damping, modulus, stiffness by dimensions."""
    from crankstar.dynamics.torsion_chain import torsion_chain

    chain = torsion_chain(engine)
    if "torsion.loss_factor" in chain.assumed:
        low, high = (share * LOSS_FACTOR for share in LOSS_ENDS)
        yield Assumption(
            "assumed", "torsion.loss_factor", N_("usual for such shafts"),
            LOSS_FACTOR, "", low, high, vary=with_torsion_value("loss_factor"),
        )  # fmt: skip
    own = engine.torsion
    if own is not None and not own.damping and not {"mass", "radius"} & {*engine.relative}:
        low, high = (share * _swept(engine) for share in DAMPING_ENDS)
        yield Assumption(
            "missing", "torsion.damping",
            N_("no damping of the throws against the block in the file, counted as zero"),
            None, "N*m*s/rad", low, high, vary=with_torsion_value("damping"),
        )  # fmt: skip
    yield from _undriven(engine)
    if own is not None and not own.discs and (engine.drive is None or not engine.drive.inertia):
        low, high = (float(end * chain.inertia.sum()) for end in WHEEL_ENDS)
        yield Assumption(
            "missing", "torsion.disc",
            N_("no flywheel and nothing driven in the file, counted as none"),
            None, "kg*m^2", low, high, vary=with_rear_disc,
        )  # fmt: skip
    dimensions = None if own is None else own.dimensions
    if dimensions is not None and "torsion.stiffness" in chain.estimated:
        modulus = dimensions.shear_modulus or STEEL
        yield Assumption(
            "estimated", "torsion.stiffness", N_("stiffness of the throws from their dimensions"),
            1.0, "", *STIFFNESS_ENDS,
            vary=with_torsion_value("dimensions.shear_modulus", modulus),
        )  # fmt: skip
    if "torsion.dimensions.shear_modulus" in chain.assumed:
        low, high = (end / 1e9 for end in STEEL_ENDS)
        yield Assumption(
            "assumed", "torsion.dimensions.shear_modulus", N_("that of steel"),
            STEEL / 1e9, "GPa", low, high,
            vary=with_torsion_value("dimensions.shear_modulus", 1e9),
        )  # fmt: skip


def _of_chain(whole: float) -> Assumption:
    """The inertia of the drive by the masses of the chain that twists."""
    return Assumption(
        "assumed", "drive.inertia", N_("the sum of the masses of [torsion], turning as one"),
        whole, "kg*m^2", whole / APART, whole * APART, vary=with_drive_inertia,
    )  # fmt: skip


def _undriven(engine: Engine) -> Iterator[Assumption]:
    """The inertia of the drive that no mass of the shaft that twists stands for."""
    own, drive = engine.torsion, engine.drive
    if own is None or drive is None or drive.inertia is None:
        return
    throws = sum(len(shaft.throws) for shaft in engine.shafts)
    bare = sum(own.bare_inertia) * (throws if len(own.bare_inertia) == 1 else 1)
    rest = drive.inertia - bare - sum(disc.inertia * disc.speed_ratio**2 for disc in own.discs)
    if rest > REST * drive.inertia:
        yield Assumption(
            "left out", "drive.inertia",
            N_("the masses of [torsion] are less; the rest is at no place of the shaft"),
            unit="kg*m^2", low=float(rest), high=float(rest), vary=with_rear_disc,
        )  # fmt: skip


def _driven_discs(engine: Engine, gas: Cycle | None) -> Iterator[Assumption]:
    """The damping of what a crankshaft drives behind an elastic shaft, which a file leaves out.

    A load whose torque goes with the square of the speed has dT/dw = 2 T/w, a propeller in an
    uneven wake up to DRIVEN times T/w, a clutch or a generator less than T/w.
    """
    own = engine.torsion
    if own is None or gas is None or gas.speed is None or {"mass", "radius"} & {*engine.relative}:
        return
    mean = float(gas_torque(gas).mean.sum())
    for index, disc in enumerate(own.discs):
        carries = any(other.to == disc.name for other in own.discs)
        damped = disc.damping or disc.loss_factor is not None or disc.absolute_damping
        in_front = (disc.to or "").startswith("front")
        if disc.stiffness is None or carries or damped or in_front or mean <= 0:
            continue
        most = DRIVEN * mean / gas.speed / float(disc.speed_ratio) ** 2
        yield Assumption(
            "missing", f"torsion.disc[{index + 1}].absolute_damping",
            N_("no damping of what is driven in the file, counted as zero"),
            0.0, "N*m*s/rad", 0.0, most, vary=with_disc_damping(index),
        )  # fmt: skip


def _swept(engine: Engine) -> float:
    """Piston area times the square of the crank radius, m^4: all cylinders over all throws.

    A bore that the file does not give is taken as large as the stroke.
    """
    throws = sum(len(shaft.throws) for shaft in engine.shafts)
    radii = [engine.throw(cylinder).radius for cylinder in engine.cylinders]
    sizes = [
        pi / 4 * (cylinder.bore or 2 * radius) ** 2 * radius**2
        for cylinder, radius in zip(engine.cylinders, radii, strict=True)
    ]
    return sum(sizes) / throws


def _mounts(engine: Engine) -> Iterator[Assumption]:
    """What is assumed of the block and of the rubber on which it stands."""
    from crankstar.dynamics.whirl import MASS_ENDS, body, estimated_mass

    block = engine.block
    own = body(engine)
    if block is None or block.mass is None:
        low, high = (share * own.mass for share in MASS_ENDS)
        reason = N_("usual for its reciprocating masses, without a gearbox")
        if estimated_mass(engine)[1]:
            reason = N_("usual for its displacement, without a gearbox")
        yield Assumption(
            "assumed", "block.mass", reason,
            own.mass, "kg", low, high, vary=with_block_mass,
        )  # fmt: skip
    yield from _centre_of_mass(engine, own)
    if block is None or block.inertia is None:
        low, most = WALLED_ENDS[0], 3 * [WALLED_ENDS[1]]
        reason = N_("moments of inertia estimated, of a box about cylinders and crankcase")
        if block is not None and block.sides is not None:
            box = inertia_in_box(own.mass, sides=block.sides)
            reason = N_("moments of inertia estimated, of a box of its size")
            low = min(end / mid for end, mid in zip(box.low, box.typical, strict=True))
            most = [end / mid for end, mid in zip(box.high, box.typical, strict=True)]
        yield Assumption(
            "estimated", "block.inertia", reason,
            1.0, "", low, max(most), vary=with_block_inertia(own.mass, own.inertia, most),
        )  # fmt: skip
    if any(mount.assumed for mount in engine.mounts):
        low, high = (share * RUBBER_LOSS_FACTOR for share in RUBBER_ENDS)
        yield Assumption(
            "assumed", "mounts.loss_factor", N_("usual for rubber"),
            RUBBER_LOSS_FACTOR, "", low, high, vary=with_mount_loss,
        )  # fmt: skip


def _centre_of_mass(engine: Engine, own: Body) -> Iterator[Assumption]:
    """Where the centre of mass of the block is assumed, and its axes."""
    block, radius = engine.block, engine.throw(engine.first).radius
    given = set() if block is None else block.model_fields_set
    places = [cylinder.z for cylinder in engine.cylinders]
    off = CENTRE_OFF * (max(places) - min(places) or 2 * radius)
    middle = own.centre[2]
    ends = {
        "up": (N_("at the height of the crankshaft"), 0.0, *(end * radius for end in HEIGHTS)),
        "right": (N_("in the plane of the crankshaft"), 0.0, -radius, radius),
        "z": (N_("in the middle of the cylinders"), middle, middle - off, middle + off),
    }
    for name, (reason, value, low, high) in ends.items():
        if name not in given or (name == "z" and block is not None and block.z is None):
            yield Assumption(
                "assumed", f"block.{name}", reason, 1e3 * value, "mm", 1e3 * low, 1e3 * high,
                vary=with_block_value(name, mass=own.mass, factor=1e-3),
            )  # fmt: skip
    for (one, other), (name, share) in PRODUCTS.items():
        if name not in given:
            end = share * (own.inertia[one] * own.inertia[other]) ** 0.5
            yield Assumption(
                "assumed", f"block.{name}", N_("its principal axes along those of the engine"),
                0.0, "kg*m^2", -end, end, vary=with_block_product(name, own.mass, own.inertia),
            )  # fmt: skip


def _unverified(engine: Engine, answer: Answer) -> Iterator[Assumption]:
    """Values of the file that nobody has read in a source, or that are estimated."""
    gas = answer.gas if "gas" in answer.uses else None
    for path, origin in engine.provenance.items():
        if origin.source.endswith(ROD_SOURCE) or (path.startswith(OF_GAS) and gas is None):
            continue
        point = POINT.fullmatch(path)
        if point is not None and gas is not None and not _is_of(engine, gas, point[1]):
            continue
        vary = speed_value(gas) if path == "speed" else SCALED.get(path)
        if point is not None:
            vary = point_value(point[2], gas, int(point[1]) if point[1] else None)
        if origin.status in DOUBTFUL:
            reason = N_("a guess") if origin.status == "placeholder" else N_("not read in a source")
            yield Assumption("unverified", path, reason, vary=vary)
        elif origin.status == "estimated":
            low, high = origin.range or (None, None)
            yield Assumption(
                "estimated", path, N_("estimated by proportions of such engines"),
                1.0, "", low, high, vary=vary,
            )  # fmt: skip


def _is_of(engine: Engine, gas: Cycle, index: str | None) -> bool:
    """Whether a key of an operating point, counted from one, is of that of the cycle."""
    points = () if engine.gas is None else engine.gas.points
    names = {name for name, _share in gas.shares}
    own = [number for number, point in enumerate(points, 1) if point.name in names]
    return bool(own) and (index is None or int(index) in own)
