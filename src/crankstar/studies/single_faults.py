"""Single faults of an engine and what each changes in what shakes its block.

A fault adds to the six freedoms of the block, order by order, its size times

    Q_k = w^2 (P_k(with it) - P_k(without)) + G_k(with it) - G_k(without)           N, N m

P_k the inertia of the moving parts at 1 rad/s, G_k the gas; both are linear in the size: the mass
of a part that is heavier, the share of a counterweight that is lost, or of its combustion that a
cylinder has not (1: it is cut). The others burn as they did. The block then moves by H(k w) Q_k: on
its mounts, or free without them (`mounted_block`).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property, reduce

import numpy as np

from crankstar import spectra
from crankstar.dynamics.mount_excitation import on_freedoms
from crankstar.dynamics.mounted_block import SIX, dynamic_stiffness, mounted_block
from crankstar.dynamics.whirl import body
from crankstar.engine.copies import with_values
from crankstar.engine.engine import Engine
from crankstar.engine.gas import Gas
from crankstar.engine.rigid_block import mass_matrix, moved
from crankstar.language.faults import EngineError
from crankstar.language.messages import MessageError
from crankstar.mechanics.excitation import Reference, Totals, part_spectra, total
from crankstar.mechanics.gas import lost_shares
from crankstar.mechanics.gas_loads import gas_over_speeds, vibrating_state
from crankstar.mechanics.gas_torque import gas_roll
from crankstar.mechanics.lacking import KEYS, is_explicit, lacking_keys
from crankstar.mechanics.mechanism import mechanism
from crankstar.mechanics.occurring_orders import check_orders
from crankstar.mechanics.operating_points import OperatingState
from crankstar.spectra import Complex, Real, Spectrum
from crankstar.studies.fault_kinds import Fault, fault_text
from crankstar.studies.part_weights import with_parts

HIGHEST = 6.0
"""The highest order where none are chosen."""
MOST_TIMES = 10.0
"""So many times its mass in the file a part may be heavier; more is a slip of the unit."""


class DiagnosisError(MessageError):
    """Faults or measurements that an engine cannot have, and why."""


@dataclass(frozen=True)
class Shaken:
    """What shakes a block at one speed, and how it moves: `push` [order, 6], `torque` [order].

    `force` and `couple` turn with the orders as `total` has them; `push` is about the centre.
    """

    engine: Engine
    speed: float
    orders: Real
    push: Complex
    torque: Complex
    state: OperatingState

    @property
    def mounted(self) -> bool:
        """Whether the block stands on mounts; else it is free."""
        return bool(self.engine.mounts)

    @cached_property
    def motion(self) -> Complex:
        """Of the six freedoms of the block, m and rad [order, 6]."""
        return np.einsum("kij,kj->ki", receptance(self.engine, self.speed * self.orders), self.push)

    def displacement(self, point: Sequence[float] | None) -> Complex:
        """Of a point (up, right, z) of the block, else of its centre of mass, m [order, axis]."""
        centre = np.array(body(self.engine).centre)
        place = centre if point is None else np.asarray(point, float)
        return self.motion @ moved(place - centre).T

    def sizes(self, point: Sequence[float] | None) -> Real:
        """Of each order: force, couple, roll, torque, velocity of the point [order, 5].

        The first two by the greatest of the turning vector (N, N m), the velocity (mm/s) by its
        rms.
        """
        push = self.push
        velocity = (self.speed * self.orders)[:, None] * np.abs(self.displacement(point))
        return np.column_stack(
            [
                _greatest(push[:, 0], push[:, 1]),
                _greatest(push[:, 4], push[:, 3]),
                np.abs(push[:, 5]),
                np.abs(self.torque),
                1e3 * np.sqrt((velocity**2).sum(axis=1) / 2),
            ]
        )


def _greatest(upward: Complex, rightward: Complex) -> Real:
    """The long half axis of the ellipse of a vector with these two waves."""
    return (np.abs(upward + 1j * rightward) + np.abs(upward - 1j * rightward)) / 2


def receptance(engine: Engine, frequencies: Real) -> Complex:
    """Motion of the freedoms of the block per push at angular frequencies [w, 6, 6].

    A free block of 40 kg moves by 1/(40 w^2) against an upward force:

    >>> from crankstar.files.catalog import load
    >>> own = {"mass": "40 kg", "inertia_up": "1 kg*m^2", "inertia_right": "1 kg*m^2"}
    >>> free = load("audi-25-tfsi", changes={"block": {**own, "inertia_z": "1 kg*m^2"}})
    >>> round(float(receptance(free, np.array([10.0]))[0, 0, 0].real) * 40 * 100, 9)
    -1.0

    Raises DiagnosisError at a resonance without damping.
    """
    if engine.mounts:
        stiff = dynamic_stiffness(mounted_block(engine), frequencies=frequencies)
    else:
        own = body(engine)
        block = engine.block
        products = (0.0, 0.0, 0.0) if block is None else block.products
        mass = mass_matrix(own.mass, inertia=own.inertia, products=products)
        stiff = -(frequencies[:, None, None] ** 2) * mass + 0j
    try:
        return np.linalg.inv(stiff)[:, :SIX, :SIX]
    except np.linalg.LinAlgError:
        raise DiagnosisError(
            "mounts without damping resonate without end at one of these frequencies; give damping "
            "or a loss factor"
        ) from None


def usual_orders(engine: Engine) -> list[float]:
    """The orders of gas and inertia up to HIGHEST: halves of a four-stroke engine, too."""
    step = 0.5 if engine.cycle == "four-stroke" else 1.0
    return [step * number for number in range(1, int(HIGHEST / step) + 1)]


def known(engine: Engine) -> Engine:
    """The engine, where forces in N and moments in N m can be told. Raises DiagnosisError."""
    if engine.relative and is_explicit(engine):
        raise DiagnosisError(
            "forces in N and moments in N m are not known; replace relative {names} in the engine "
            "file",
            names=", ".join(engine.relative),
        )
    lacking = lacking_keys(engine, 0.0, sizes=KEYS)
    if lacking and engine.gas is not None and any(own.bore is None for own in engine.cylinders):
        lacking.append("cylinder.bore")
    if lacking:
        raise DiagnosisError(
            "forces in N and moments in N m are not known; give {keys} in the engine file",
            keys=", ".join(lacking),
        )
    return engine


def with_fault(engine: Engine, fault: Fault) -> Engine:
    """The engine with the fault in its masses; combustion leaves it as it is.

    Raises DiagnosisError for a part that it has not.
    """
    if fault.kind == "weight":
        return _without_weight(engine, fault)
    numbers = [cylinder.number for cylinder in engine.cylinders]
    if fault.number not in numbers:
        raise DiagnosisError(
            "there is no cylinder {number}; give one of {numbers}",
            number=fault.number,
            numbers=", ".join(map(str, numbers)),
        )
    if fault.kind == "combustion":
        return engine
    added = [fault.size if number == fault.number else 0.0 for number in numbers]
    try:
        return with_parts(engine, {fault.kind: added})
    except EngineError:
        raise DiagnosisError(
            "{what}: that is more than it weighs in the file", what=fault_text(fault, engine)
        ) from None


def _without_weight(engine: Engine, fault: Fault) -> Engine:
    """The engine with a share of a weight lost."""
    name = fault.shaft or engine.shafts[0].name
    shafts = {shaft.name: shaft for shaft in engine.shafts}
    if name not in shafts:
        raise DiagnosisError(
            "there is no shaft {name}; give one of {names}", name=name, names=", ".join(shafts)
        )
    weights = shafts[name].weights
    if not 1 <= fault.number <= len(weights):
        raise DiagnosisError(
            "the shaft {name} has {count} weights; there is no weight {number}",
            name=name,
            count=len(weights),
            number=fault.number,
        )
    lost = weights[fault.number - 1]
    left = with_values(lost, unbalance=lost.unbalance * (1 - fault.size))
    own = (*weights[: fault.number - 1], left, *weights[fault.number :])
    changed = with_values(shafts[name], weights=own)
    return with_values(
        engine, shafts=tuple(changed if s.name == name else s for s in engine.shafts)
    )


def shaken(
    engine: Engine,
    faults: Sequence[Fault] = (),
    *,
    speed: float | None = None,
    point: str = "",
    orders: Sequence[float] = (),
) -> Shaken:
    """What shakes the block of an engine with faults, at an operating point and speed (rad/s).

    Both as `operating_state` has them. Raises DiagnosisError, and OrderError for an order that the
    engine cannot have.

    >>> from crankstar.files.catalog import load
    >>> six, cut = load("audi-25-tfsi"), [Fault("combustion", 2)]
    >>> even, uneven = (shaken(six, faults, speed=100.0, orders=[0.5]) for faults in ((), cut))
    >>> bool(abs(even.push[0, 5]) < 1e-9 < abs(uneven.push[0, 5]))  # half orders come with a cut
    True
    """
    engine = known(engine)
    state = vibrating_state(engine, point=point, speed=speed)
    assert state.speed is not None  # noqa: S101  # a VibratingState has one
    speed = state.speed
    check_orders(engine, orders, gas=True)
    _check_shares(engine, faults)
    built = reduce(with_fault, faults, engine)
    wanted = np.array(sorted({*map(float, orders or usual_orders(engine))}))
    up, right, z = body(engine).centre
    sums: Totals = total(
        part_spectra(mechanism(built), reference=Reference(z, up, right), orders=wanted.tolist())
    )
    push = speed**2 * on_freedoms(sums, wanted)
    torque = speed**2 * spectra.amplitude(spectra.selected(sums.torque, wanted))
    gas = gas_orders(engine, faults, speed=speed, point=point, orders=wanted)
    push[:, 5] += spectra.amplitude(gas_roll(gas, sums.force.sense))
    return Shaken(engine, speed, wanted, push, torque + spectra.amplitude(gas), state)


def limits(engine: Engine, fault: Fault) -> tuple[float, float]:
    """The least and the greatest size that a fault can have: kg of a part, or a share.

    A part cannot lose more than it weighs in the file.

    >>> from crankstar.files.catalog import load
    >>> limits(load("subaru-ej25"), Fault("combustion", 1))
    (0.0, 1.0)
    """
    if fault.kind in ("combustion", "weight"):
        return 0.0, 1.0
    whole = own_mass(engine, fault)
    return -whole, MOST_TIMES * whole if whole > 0 else np.inf


def own_mass(engine: Engine, fault: Fault) -> float:
    """What the part of a fault weighs in the file, kg: all that its fault takes from, or adds to.

    Without `parts` that is all that goes up and down with a piston, or hangs on its crank pin.
    """
    cylinder = next(each for each in engine.cylinders if each.number == fault.number)
    if cylinder.parts is not None:
        return cylinder.parts.piston if fault.kind == "piston" else cylinder.parts.big_end
    if fault.kind == "piston":
        return cylinder.reciprocating_mass
    if cylinder.rod is not None:
        return cylinder.rod.shares(cylinder.rod_length)[0]
    return cylinder.big_end_mass or engine.throw(cylinder).rotating_mass


def check_faults(engine: Engine, faults: Sequence[Fault]) -> None:
    """Raises DiagnosisError for faults without effect, or after which no engine would run."""
    for fault in faults:
        if fault.size == 0:
            raise DiagnosisError(
                "{what}: that changes nothing; give how much", what=fault_text(fault, engine)
            )
        with_fault(engine, fault)
        most = limits(engine, fault)[1]
        if fault.size > most:
            raise DiagnosisError(
                "{what}: that is more than {times} times what it weighs in the file; check its "
                "unit",
                what=fault_text(fault, engine),
                times=f"{MOST_TIMES:g}",
            )
    if min(lost_shares(engine, (), lost_combustion(faults)).values()) > 1 - 1e-9:
        raise DiagnosisError(
            "no cylinder would fire, and the engine would stop; leave at least one that does"
        )


def _check_shares(engine: Engine, faults: Sequence[Fault]) -> None:
    """Refuse more combustion of a chamber, or more of a weight, than there is to lose."""
    chambers = {each.number: key for key, own in engine.chambers.items() for each in own}
    lost: dict[tuple[str, int, str], float] = {}
    for fault in faults:
        if fault.kind == "combustion":
            key = (fault.kind, chambers.get(fault.number, fault.number), "")
        elif fault.kind == "weight":
            key = (fault.kind, fault.number, fault.shaft or engine.shafts[0].name)
        else:
            continue
        lost[key] = lost.get(key, 0.0) + fault.size
        if lost[key] > 1 + 1e-9:
            raise DiagnosisError(
                "{what}: together more than all of it; give each once, up to 100 %",
                what=fault_text(fault, engine),
            )


def lost_combustion(faults: Sequence[Fault]) -> dict[int, float]:
    """The share of its combustion that each cylinder with such a fault lacks, as `cycle` has it.

    >>> lost_combustion([Fault("combustion", 2, 0.2), Fault("combustion", 2, 0.3)])
    {2: 0.5}
    """
    lost: dict[int, float] = {}
    for fault in faults:
        if fault.kind == "combustion":
            lost[fault.number] = min(lost.get(fault.number, 0.0) + fault.size, 1.0)
    return lost


def fired(engine: Engine, faults: Sequence[Fault]) -> Engine:
    """The engine; with a usual cycle, where combustion is lost and the file has no gas.

    >>> from crankstar.files.catalog import load
    >>> four = load("i4")
    >>> fired(four, [Fault("combustion", 2)]).gas is None, fired(four, []).gas is None
    (False, True)
    """
    lost = engine.gas is None and lost_combustion(faults)
    return with_values(engine, gas=Gas()) if lost else engine


def gas_orders(
    engine: Engine, faults: Sequence[Fault], *, speed: float, point: str, orders: Real
) -> Spectrum:
    """The gas torque of the engine in these orders, N m; none without [gas].

    Raises DiagnosisError.
    """
    if engine.gas is None and not point and not lost_combustion(faults):
        return spectra.real_signal(orders, np.zeros(orders.size, complex))
    found = gas_over_speeds(engine, [speed], point=point, weaker=lost_combustion(faults))
    one = replace(found, forward=found.forward[0], backward=found.backward[0])
    return spectra.selected(one, orders)


def catalogue(engine: Engine, *, gas: bool = True) -> list[Fault]:
    """Every single fault of an engine, of size 1: pistons, big ends, weights, combustion.

    >>> from crankstar.files.catalog import load
    >>> sorted({fault.kind for fault in catalogue(load("audi-25-tfsi"))})
    ['big_end', 'combustion', 'piston']
    """
    numbers = [cylinder.number for cylinder in engine.cylinders]
    found = [Fault("piston", number) for number in numbers]
    pins: dict[tuple[str, int], int] = {}
    for cylinder in engine.cylinders:
        pins.setdefault((cylinder.shaft, cylinder.throw), cylinder.number)
    alone = [c.number for c in engine.cylinders if c.articulated is not None]
    found += [Fault("big_end", number) for number in sorted({*pins.values(), *alone})]
    found += [
        Fault("weight", number, shaft=shaft.name)
        for shaft in engine.shafts
        for number, weight in enumerate(shaft.weights, 1)
        if weight.unbalance > 0
    ]
    if gas and engine.gas is not None:
        found += [Fault("combustion", own[0].number) for own in engine.chambers.values()]
    return found
