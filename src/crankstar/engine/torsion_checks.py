"""What must hold of a chain that twists: values for every throw, discs that hang on something."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import accumulate

from crankstar.engine.assembly import Assembly
from crankstar.engine.fillets import fillet_faults
from crankstar.engine.torsion import Chain, CrankDimensions, Disc, Pendulum, Torsion
from crankstar.engine.torsion_places import Cranks, home, is_place
from crankstar.language.faults import Fault
from crankstar.language.quoting import seen

Path = tuple[str | int, ...]


def faults(engine: Assembly) -> Iterator[Fault]:
    """What is wrong with the table [torsion] of an engine."""
    own = engine.torsion
    if own is None:
        return
    shafts = [shaft for shaft in engine.shafts if shaft.throws]
    if shafts and shafts[0] is not engine.shafts[0]:
        yield Fault(("torsion",), "torsion.not-first", {"name": seen(shafts[0].name)})
        return
    cranks = [(shaft.name, len(shaft.throws)) for shaft in shafts]
    throws = sum(count for _name, count in cranks)
    yield from _inertia_faults(own, engine, throws)
    yield from _stiffness_faults(own, throws - len(cranks))
    yield from _coupling_faults(own, cranks)
    if own.fatigue is not None and len(cranks) > 1:
        yield Fault(("torsion", "fatigue"), "torsion.fatigue-cranks", {"count": len(cranks)})
    if own.damping and len(own.damping) not in (1, throws):
        yield _wrong_length(("torsion", "damping"), len(own.damping), throws)
    yield from _hollow(own, ("torsion",), "diameter", "bore")
    if own.dimensions is not None:
        yield from _dimension_faults(own.dimensions)
    yield from fillet_faults(own, engine)
    yield from _tree_faults(own.discs, own.pendulums, ("torsion",), cranks=cranks)


def chain_faults(chain: Chain) -> Iterator[Fault]:
    """What is wrong with a drive line without cylinders."""
    if chain.discs[0].to is not None:
        yield Fault(("disc", 0, "to"), "disc.first", {"value": seen(chain.discs[0].to)})
    for name in ("stiffness", "damping", "loss_factor", "speed_ratio", "diameter", "bore"):
        if getattr(chain.discs[0], name) != Disc.model_fields[name].default:
            yield Fault(("disc", 0, name), "disc.first-shaft")
    yield from _tree_faults(chain.discs, chain.pendulums, (), cranks=())


def _wrong_length(path: Path, count: int, wanted: int) -> Fault:
    return Fault(path, "torsion.length", {"count": count, "wanted": wanted})


def _inertia_faults(own: Torsion, engine: Assembly, throws: int) -> Iterator[Fault]:
    """No inertia, two of them, one for another number of throws, or rods that weigh nothing."""
    given = [name for name in ("inertia", "bare_inertia") if getattr(own, name)]
    if not given:
        yield Fault(("torsion",), "torsion.no-inertia")
    if len(given) == 2:
        yield Fault(("torsion", "bare_inertia"), "torsion.two-inertias")
    for name in given:
        if len(getattr(own, name)) not in (1, throws):
            yield _wrong_length(("torsion", name), len(getattr(own, name)), throws)
    unknown = sorted({"mass", "radius"} & set(engine.relative))
    if "bare_inertia" in given and unknown:
        keys = {"mass": "cylinder.reciprocating_mass", "radius": "cylinder.stroke"}
        values = {"keys": ", ".join(keys[name] for name in unknown)}
        yield Fault(("torsion", "bare_inertia"), "torsion.relative", values)


def _stiffness_faults(own: Torsion, gaps: int) -> Iterator[Fault]:
    """No stiffness, two of them, or one for another number of gaps between throws."""
    gaps = max(gaps, 0)
    if own.stiffness and own.dimensions is not None and own.fatigue is None:
        yield Fault(("torsion", "dimensions"), "torsion.two-stiffnesses")
    elif gaps and not own.stiffness and own.dimensions is None:
        yield Fault(("torsion",), "torsion.no-stiffness")
    elif own.stiffness and not gaps:
        yield Fault(("torsion", "stiffness"), "torsion.one-throw")
    elif own.stiffness and len(own.stiffness) not in (1, gaps):
        yield _wrong_length(("torsion", "stiffness"), len(own.stiffness), gaps)


def _coupling_faults(own: Torsion, cranks: Cranks) -> Iterator[Fault]:
    """Crankshafts that nothing turns, or two things do; couplings of none, or to none."""
    names, turning = [name for name, _count in cranks], {name for name, _count in cranks[:1]}
    for index, each in enumerate(own.couplings):
        path = ("torsion", "coupling", index)
        others = ", ".join(seen(name) for name in names[1:]) or "-"
        if each.crankshaft not in names[1:]:
            values = {"value": seen(each.crankshaft), "names": others}
            yield Fault((*path, "crankshaft"), "coupling.crankshaft", values)
            continue
        if each.crankshaft in turning:
            values = {"value": seen(each.crankshaft)}
            yield Fault((*path, "crankshaft"), "coupling.twice", values)
        if home(f"{each.at} of {each.crankshaft}", cranks=cranks, names=()) is None:
            values = {"value": seen(each.at), "names": "front, rear, throw 1"}
            yield Fault((*path, "at"), "disc.no-such-place", values)
        on = _crank_of(each.to, own.discs, cranks)
        if on is None:
            values = {"value": seen(each.to), "names": _places(own.discs, cranks)}
            yield Fault((*path, "to"), "disc.no-such-place", values)
        elif on not in turning:
            yield Fault((*path, "to"), "coupling.still", {"value": seen(each.to), "name": seen(on)})
        if each.stiffness is None and (each.damping or each.loss_factor):
            yield Fault((*path, "stiffness"), "coupling.rigid")
        turning.add(each.crankshaft)
    slips = any(each.crankshaft not in names[1:] for each in own.couplings)
    for name in names[1:]:
        if name not in turning and not slips:
            yield Fault(("torsion", "coupling"), "coupling.missing", {"name": seen(name)})


def _crank_of(text: str, discs: Sequence[Disc], cranks: Cranks) -> str | None:
    """The crankshaft on which a place is, by way of discs; None where there is no such place."""
    names = tuple(disc.name for disc in discs)
    for _step in range(len(discs) + 1):
        found = home(text, cranks=cranks, names=names)
        if found is None:
            return None
        if found.throw is not None:
            ends = accumulate(count for _name, count in cranks)
            return next(
                name for (name, _n), end in zip(cranks, ends, strict=True) if found.throw < end
            )
        text = discs[found.disc or 0].to or ""
    return None


def _places(discs: Sequence[Disc], cranks: Cranks) -> str:
    """Where something can hang, for a reader."""
    if not cranks:
        return ", ".join(disc.name for disc in discs[-8:]) or "-"
    (_first, throws), *others = cranks
    ends = ["front", "rear", f"throw 1 ... throw {throws}"]
    ends += [f"rear of {name}" for name, _count in others]
    return ", ".join([*ends, *(disc.name for disc in discs[-8:])])


def _hollow(
    record: Torsion | Disc | CrankDimensions, path: Path, outer: str, inner: str
) -> Iterator[Fault]:
    """A bore without a diameter, or as wide as it."""
    bore, diameter = getattr(record, inner), getattr(record, outer)
    if bore is None:
        return
    if diameter is None:
        yield Fault((*path, inner), "torsion.bore-alone", {"key": outer})
    elif bore >= diameter:
        values = {"value": bore * 1e3, "outer": diameter * 1e3}
        yield Fault((*path, inner), "torsion.bore", values)


def _dimension_faults(own: CrankDimensions) -> Iterator[Fault]:
    here = ("torsion", "dimensions")
    yield from _hollow(own, here, "journal_diameter", "journal_bore")
    yield from _hollow(own, here, "pin_diameter", "pin_bore")


def _tree_faults(
    discs: Sequence[Disc], pendulums: Sequence[Pendulum], here: Path, *, cranks: Cranks
) -> Iterator[Fault]:
    """Discs of one name, on nothing, on themselves or on one that comes later."""
    names = tuple(disc.name for disc in discs)
    for index, disc in enumerate(discs):
        known = _places(discs[:index], cranks)
        path = (*here, "disc", index)
        if disc.name in names[:index]:
            yield Fault((*path, "name"), "disc.same-name", {"value": seen(disc.name)})
        elif is_place(disc.name):
            yield Fault((*path, "name"), "disc.place-name", {"value": seen(disc.name)})
        if disc.stiffness is None and disc.damping == 0 and "damping" in disc.model_fields_set:
            yield Fault((*path, "damping"), "disc.no-damping")
        if disc.stiffness is None and not disc.damping and disc.loss_factor:
            yield Fault((*path, "loss_factor"), "disc.rigid-loss")
        yield from _hollow(disc, path, "diameter", "bore")
        if disc.to is None:
            if cranks or index:
                yield Fault((*path, "to"), "disc.on-nothing", {"names": known})
            continue
        found = home(disc.to, cranks=cranks, names=names)
        values = {"value": seen(disc.to), "names": known}
        if found is None:
            yield Fault((*path, "to"), "disc.no-such-place", values)
        elif found.disc == index:
            yield Fault((*path, "to"), "disc.on-itself", values)
        elif found.disc is not None and found.disc > index:
            yield Fault((*path, "to"), "disc.on-a-later", values)
    known = _places(discs[:8], cranks)
    for index, pendulum in enumerate(pendulums):
        if home(pendulum.on, cranks=cranks, names=names) is None:
            values = {"value": seen(pendulum.on), "names": known}
            yield Fault((*here, "pendulum", index, "on"), "disc.no-such-place", values)
