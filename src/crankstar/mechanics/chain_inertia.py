"""The inertia that turns, beside pistons and rods: of `[drive]`, else the sum of `[torsion]`.

    J = sum of the bare throws + sum of J_disc n^2        n the speed ratio of each disc

That is what `drive.inertia` means: the crankshaft with its crankpins, flywheel and what is coupled
to them, without pistons, rods and rotating_mass. Throws that are given with their moving parts
(`torsion.inertia`) count without the mean of these. The chain is taken to turn as one.
"""

from __future__ import annotations

from crankstar.engine.engine import Engine
from crankstar.mechanics.kinetic import carried_inertias

APART = 1.2
"""Factor by which the sum of the chain and the inertia of the drive may differ."""


def chain_inertia(engine: Engine) -> float | None:
    """The sum of the masses of `[torsion]`, kg m^2, without the moving parts.

    None without discs, of several crankshafts, and where the moving parts are in its throws and are
    not known.

    >>> from crankstar.files.catalog import load
    >>> wheel = {"name": "flywheel", "inertia": "0.2 kg*m^2", "to": "rear"}
    >>> wheel["stiffness"] = "9 MN*m/rad"
    >>> own = {"bare_inertia": "0.01 kg*m^2", "stiffness": "0.4 MN*m/rad", "disc": [wheel]}
    >>> round(chain_inertia(load("audi-25-tfsi", changes={"torsion": own})), 9)
    0.25
    """
    own = engine.torsion
    if own is None or not own.discs or len(engine.shafts) > 1:
        return None
    throws = sum(len(crank.throws) for crank in engine.shafts)
    given = own.bare_inertia or own.inertia
    whole = sum(given) * (throws if len(given) == 1 else 1)
    if not own.bare_inertia:
        if {"mass", "radius"} & {*engine.relative}:
            return None
        whole -= float(carried_inertias(engine).sum())
    return max(whole, 0.0) + sum(disc.inertia * disc.speed_ratio**2 for disc in own.discs)


def turning_inertia(engine: Engine) -> float | None:
    """That of the drive of the file, else of its chain, kg m^2; None where neither is known.

    >>> from crankstar.files.catalog import load
    >>> turning_inertia(load("audi-25-tfsi", changes={"drive": {"inertia": "0.3 kg*m^2"}}))
    0.3
    """
    given = None if engine.drive is None else engine.drive.inertia
    return chain_inertia(engine) if given is None else given
