"""Weights, main bearings, webs and balance shafts of a short file, put on the engine of its layout.

A weight is placed from the pin of its throw, as throws are from pin 1: it turns with them wherever
a layout turns them.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from crankstar.engine.basis import BalanceShaft, Basis, Crankshaft, CrankWeight
from crankstar.engine.copies import checked, throws_of_weights, with_values, wrapped
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft, Weight
from crankstar.language.faults import EngineError, Fault

_SUPPORT = ("bearings", "bearing_count", "webs", "bending_stiffness", "bearing_stiffness")


def equipped(engine: Engine, basis: Basis) -> Engine:
    """The engine of a layout with what its file says of its crankshafts, and its balance shafts.

    Raises EngineError.

    >>> from crankstar.engine.layouts import inline
    >>> weights = (CrankWeight(throw=1, unbalance=0.5), CrankWeight(throw=2, unbalance=0.5))
    >>> cranks = (Crankshaft(weights=weights, bearing_count=3),)
    >>> twin = inline(Basis(name="twin", crankshafts=cranks), throws=(0.0, 3.0))
    >>> [(round(weight.angle, 4), weight.z) for weight in twin.shafts[0].weights]
    [(3.1416, 0.5), (-0.1416, -0.5)]
    """
    if not basis.crankshafts and not basis.balance_shafts:
        return engine
    faults: list[Fault] = []
    if len(basis.crankshafts) > len(engine.shafts):
        values = {"size": len(basis.crankshafts), "count": len(engine.shafts)}
        faults.append(Fault(("crankshaft",), "crankshaft.too-many", values))
    shafts: list[Shaft] = []
    for index, (shaft, crankshaft) in enumerate(
        zip(engine.shafts, basis.crankshafts, strict=False)
    ):
        here = ("crankshaft", index, "weight")
        wrong = [
            _weight_faults((*here, index), shaft, weight)
            for index, weight in enumerate(crankshaft.weights)
        ]
        faults += [fault for own in wrong for fault in own]
        good = [w for w, own in zip(crankshaft.weights, wrong, strict=True) if not own]
        shafts.append(_with(shaft, with_values(crankshaft, weights=tuple(good))))
    shafts += engine.shafts[len(shafts) :]
    shafts += [_balancing(shaft) for shaft in basis.balance_shafts]
    try:
        whole = with_values(engine, shafts=tuple(shafts))
    except EngineError as error:
        own = [_in_file(fault, len(engine.shafts)) for fault in error.faults]
        raise EngineError([*faults, *own]) from None
    if faults:
        raise EngineError(faults)
    return whole


def _balancing(shaft: BalanceShaft) -> Shaft:
    """A shaft without throws, its weights turned by the phase of its gear."""
    values = {key: getattr(shaft, key) for key in BalanceShaft.model_fields if key != "phase"}
    if shaft.phase:
        turned = (with_values(own, angle=wrapped(own.angle + shaft.phase)) for own in shaft.weights)
        values["weights"] = tuple(turned)
    return checked(Shaft, values)


def _in_file(fault: Fault, cranks: int) -> Fault:
    """A fault of a shaft with the path that a short file has for it."""
    key, index, *rest = (*fault.path, "", "")
    if key != "shaft" or not isinstance(index, int):
        return fault
    crank = index < cranks
    place = ("crankshaft", index) if crank else ("balance_shaft", index - cranks)
    return fault._replace(path=(*place, *rest[:-2]))


def _weight_faults(
    here: tuple[str | int, ...], shaft: Shaft, weight: CrankWeight
) -> Sequence[Fault]:
    count = len(shaft.throws)
    if weight.throw is not None and weight.throw > count:
        values = {"value": weight.throw, "count": count}
        return [Fault((*here, "throw"), "weight.no-such-throw", values)]
    if weight.throw is None and weight.z is None:
        return [Fault(here, "weight.no-place")]
    return []


def _with(shaft: Shaft, crankshaft: Crankshaft) -> Shaft:
    """The shaft of a layout with what its file says of it."""
    weights = tuple(_placed(shaft, weight) for weight in crankshaft.weights)
    values: dict[str, Any] = {key: getattr(crankshaft, key) for key in _SUPPORT}
    return with_values(shaft, **values, weights=(*shaft.weights, *weights))


def _placed(shaft: Shaft, weight: CrankWeight) -> Weight:
    z = weight.z
    if z is None:
        z = shaft.throws[(weight.throw or 1) - 1].z
    still = Weight(unbalance=weight.unbalance, angle=0.0, z=z, throw=weight.throw)
    (throw,) = throws_of_weights(with_values(shaft, weights=(still,)))
    pin = shaft.throws[(throw or 1) - 1].angle
    return with_values(still, angle=wrapped(pin + weight.angle))


def crankshaft(shaft: Shaft) -> Crankshaft:
    """What a short file would have to say of a crankshaft: the other way round."""
    weights = tuple(
        CrankWeight(
            unbalance=weight.unbalance,
            angle=wrapped(weight.angle - shaft.throws[(throw or 1) - 1].angle),
            z=weight.z,
            throw=weight.throw,
        )
        for weight, throw in zip(shaft.weights, throws_of_weights(shaft), strict=True)
    )
    return Crankshaft(weights=weights, **{key: getattr(shaft, key) for key in _SUPPORT})


def balance_shaft(shaft: Shaft) -> BalanceShaft:
    """A shaft without throws as a short file gives it."""
    own = (key for key in BalanceShaft.model_fields if key != "phase")
    return BalanceShaft(**{key: getattr(shaft, key) for key in own})
