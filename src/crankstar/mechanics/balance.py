"""Engine -> Balance: force, couple, moment and torque of every part of an engine, with its labels.

Laws and signs are those of `excitation`. Numbers are in N and N m at a speed, or, without one, in
units of m r w^2 with m and r of the first cylinder.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Any, Literal, NamedTuple, get_args

from crankstar import spectra
from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.quoting import given
from crankstar.mechanics import labelled
from crankstar.mechanics.excitation import Reference, Totals, part_spectra
from crankstar.mechanics.mechanism import mechanism
from crankstar.spectra import Spectrum

if TYPE_CHECKING:
    import pandas
    import xarray

Kind = Literal["piston", "rod", "big end", "throw", "weight"]
Grouping = Literal["kind", "cylinder", "bank", "shaft"]


class Units(NamedTuple):
    """The units of the numbers in a Balance."""

    force: str
    couple: str
    moment: str


class Part(NamedTuple):
    """The part in a row of a Balance; `cylinder` and `bank` are None for parts of a shaft."""

    kind: Kind
    shaft: str
    cylinder: int | None = None
    bank: str | None = None


@dataclass(frozen=True)
class Balance:
    """Spectra [..., part, order] of the excitation of the block by the moving parts.

    `force` (units.force) and `couple` (units.couple) in the clock plane, `axis_moment` (about the
    crank axis) and `torque` (units.moment) as real signals.

    >>> from crankstar.files.catalog import load
    >>> result = balance(load("i4"))
    >>> len(result.parts), result.units.force
    (8, 'm*r*w^2')
    """

    parts: tuple[Part, ...]
    force: Spectrum
    couple: Spectrum
    axis_moment: Spectrum
    torque: Spectrum
    reference: Reference
    units: Units
    speed: float | None

    def to_frame(self, *, by: Grouping | Literal["part"] | None = None) -> pandas.DataFrame:
        """The amplitudes as a tidy pandas data frame: one row an amplitude.

        Columns part ("engine", or what `by` divides it into), order, quantity (force, pitch, yaw,
        roll, torque, axis_moment; couple as turning vectors), direction (vertical, horizontal,
        forward, backward; axial), amplitude, phase_deg and unit: the signal is amplitude *
        cos(order * theta + phase). attrs: speed (rad/s) and the reference point. `by="part"` has a
        row for every part, with its kind, shaft, cylinder and bank. Raises ImportError without
        pandas.

        >>> from crankstar.files.catalog import load
        >>> table = balance(load("v8-cross-plane")).to_frame()
        >>> first = table.query("quantity == 'pitch' and order == 1")
        >>> print(first[["amplitude", "unit"]].round(4).to_string(index=False))
         amplitude      unit
            3.1623 m*r*w^2*a
        """
        if by == "part":
            sums = Totals(*(getattr(self, name) for name in Totals._fields))
            labels = {name: [getattr(p, name) for p in self.parts] for name in Part._fields}
        elif by is None:
            sums, labels = total(self), {"part": ["engine"]}
        else:
            shares = grouped(self, by)
            sums = Totals(*map(spectra.stacked, zip(*shares.values(), strict=True)))
            labels = {by: [*shares]}
        return labelled.frame(labelled.columns(sums, self.units._asdict(), labels), self._facts)

    def to_xarray(self, *, split: bool = False) -> xarray.Dataset:
        """The amplitudes as an xarray data set with the dimensions part and order.

        Variables force_vertical, force_horizontal, force_forward, force_backward, pitch, yaw,
        couple_forward, couple_backward, roll, torque and axis_moment, complex: the signal is
        Re(c exp(i order theta)); attrs units. Of the set: speed (rad/s) and reference_z,
        reference_up, reference_right. `split` gives real and imaginary part along a last dimension
        component, which netCDF can hold. Raises ImportError
        without xarray.

        >>> from crankstar.files.catalog import load
        >>> sums = balance(load("v8-cross-plane")).to_xarray().sum("part")
        >>> print(abs(complex(sums.pitch.sel(order=1))).__round__(4))
        3.1623
        """
        parts = {
            "kind": [part.kind for part in self.parts],
            "shaft": [part.shaft for part in self.parts],
            "cylinder": [part.cylinder or 0 for part in self.parts],
            "bank": [part.bank or "" for part in self.parts],
        }
        return labelled.dataset(
            Totals(*(getattr(self, name) for name in Totals._fields)),
            self.units._asdict(),
            dimensions=["part"],
            labels={name: ("part", values) for name, values in parts.items()},
            facts=self._facts,
            split=split,
        )

    @property
    def _facts(self) -> dict[str, Any]:
        point = {f"reference_{name}": place for name, place in self.reference._asdict().items()}
        return {"speed": self.speed, **point}


def default_reference(engine: Engine) -> Reference:
    """The middle of the cylinders' span, on the reference crank axis."""
    places = [cylinder.z for cylinder in engine.cylinders]
    return Reference((min(places) + max(places)) / 2)


def balance(
    engine: Engine,
    *,
    speed: float | None = None,
    reference: Reference | None = None,
    orders: Sequence[float] | None = None,
) -> Balance:
    """The Balance of an engine: at `speed` (rad/s) in N and N m, without one in units of m r w^2.

    `orders` keeps only those.

    An engine whose masses or sizes are not known is always counted in these units.

    >>> from crankstar.files.catalog import load
    >>> second = spectra.selected(total(balance(load("v8-flat-plane"))).force, 2)

    The force moves along a horizontal line of amplitude 4 sqrt(2) A_2:

    >>> print(abs(spectra.vertical(second)), abs(spectra.horizontal(second)).round(6))
    [0.] [1.436983]
    """
    reference = reference or default_reference(engine)
    raw = spectra_of(engine, reference, None if orders is None else tuple(orders))
    scale, units = scales(engine, speed)
    return Balance(
        parts=parts(engine),
        force=spectra.scaled(raw.force, scale.force),
        couple=spectra.scaled(raw.couple, scale.couple),
        axis_moment=spectra.scaled(raw.axis_moment, scale.moment),
        torque=spectra.scaled(raw.torque, scale.moment),
        reference=reference,
        units=units,
        speed=speed if units.force == "N" else None,
    )


@lru_cache(maxsize=160)  # figures and sheets of an estimated engine want those of every corner
def spectra_of(
    engine: Engine, reference: Reference, orders: tuple[float, ...] | None = None
) -> Totals:
    """The spectra of all parts at 1 rad/s, in SI units; kept, as several analyses want them."""
    out = part_spectra(mechanism(engine), reference=reference, orders=orders)
    out.force.orders.setflags(write=False)  # those of every Balance of this engine
    return out


class Scale(NamedTuple):
    """Factors from SI units at 1 rad/s to the units of a Balance."""

    force: float
    couple: float
    moment: float


def scales(engine: Engine, speed: float | None) -> tuple[Scale, Units]:
    """Factors to N and N m at a speed (rad/s), else to m r w^2 and its like; with their names."""
    known = {"mass", "radius"}.isdisjoint(engine.relative)
    if speed is not None and known:
        squared = speed**2
        if "pitch" in engine.relative:
            return Scale(squared, squared / engine.pitch, squared), Units("N", "N*a", "N*m")
        return Scale(squared, squared, squared), Units("N", "N*m", "N*m")
    radius = engine.throw(engine.first).radius
    force = 1 / unit_unbalance(engine)
    return Scale(force, force / engine.pitch, force / radius), Units(
        "m*r*w^2", "m*r*w^2*a", "m*r^2*w^2"
    )


def unit_unbalance(engine: Engine) -> float:
    """The unit of unbalance, m r of the first cylinder, kg m."""
    return unit_mass(engine) * engine.throw(engine.first).radius


def of_one_piston(engine: Engine, *, speed: float | None = None) -> Scale:
    """Force m r w^2, couple m r w^2 a, moment m r^2 w^2 of the first piston, as a Balance has them.

    >>> from crankstar.files.catalog import load
    >>> of_one_piston(load("i4"))
    Scale(force=1.0, couple=1.0, moment=1.0)
    """
    one, first = unit_unbalance(engine), engine.throw(engine.first).radius
    scale, _units = scales(engine, speed)
    return Scale(one * scale.force, one * engine.pitch * scale.couple, one * first * scale.moment)


def unit_mass(engine: Engine) -> float:
    """The unit of mass, m, kg: what goes up and down in the first cylinder.

    The piston and its share of a rod as a rigid body, which counts for nothing where the rod's
    centre of mass lies beyond the big end; the mass of the rod where nothing goes up and down.
    """
    first = engine.first
    largest = max(first.reciprocating, first.reciprocating_mass)
    return largest or (first.rod.mass if first.rod else 1.0)


def parts(engine: Engine) -> tuple[Part, ...]:
    """The part in each row of a Balance, in order."""
    bank = {number: name for name, numbers in engine.banks.items() for number in numbers}
    moving: list[Part] = []
    kinds: list[Kind] = ["piston"]
    if any(cylinder.rod for cylinder in engine.cylinders):
        kinds.append("rod")
    if any(cylinder.big_end_mass for cylinder in engine.cylinders):
        kinds.append("big end")
    for kind in kinds:
        moving += [Part(kind, c.shaft, c.number, bank[c.number]) for c in engine.cylinders]
    turning = [Part("throw", shaft.name) for shaft in engine.shafts for _ in shaft.throws]
    weights = [Part("weight", shaft.name) for shaft in engine.shafts for _ in shaft.weights]
    return (*moving, *turning, *weights)


def total(result: Balance) -> Totals:
    """The sum over the whole engine, rounding errors set to zero.

    >>> from crankstar.files.catalog import load
    >>> second = spectra.selected(total(balance(load("i4"))).force, [2.0])
    >>> round(float(spectra.peak(second).value), 4)
    1.0161
    """
    return of_parts(result)


def of_parts(result: Balance, **wanted: object) -> Totals:
    """The sum over the parts with these labels: `kind=`, `cylinder=`, `bank=`, `shaft=`.

    >>> from crankstar.files.catalog import load
    >>> front = of_parts(balance(load("v8-flat-plane")), cylinder=1).force
    >>> round(float(spectra.peak(spectra.selected(front, [1.0])).value), 6)
    1.0

    Raises ValueError for another label, and for a cylinder or bank that no part has.
    """
    _check_labels(result, wanted.items())
    rows = [
        row
        for row, part in enumerate(result.parts)
        if all(getattr(part, key) == value for key, value in wanted.items())
    ]
    return Totals(*(spectra.total(getattr(result, name)[rows, :]) for name in Totals._fields))


def grouped(result: Balance, by: Grouping) -> dict[object, Totals]:
    """The sums by one label, in order of first appearance; None collects parts without it.

    >>> from crankstar.files.catalog import load
    >>> list(grouped(balance(load("v4-90")), "bank"))[:2]
    ['left', 'right']

    Raises ValueError for another label.
    """
    _check_labels(result, [(by, None)])
    labels = dict.fromkeys(getattr(part, by) for part in result.parts)
    return {label: of_parts(result, **{by: label}) for label in labels}


def _check_labels(result: Balance, wanted: Iterable[tuple[str, object]]) -> None:
    """Raises ValueError for labels and values that no part has.

    Of a kind there may be none, and a shaft may carry nothing.
    """
    for label, value in wanted:
        if label not in Part._fields:
            raise ValueError(
                _(
                    "{label} is no label of a part; give one of {labels}",
                    label=given(label),
                    labels=", ".join(Part._fields),
                )
            )
        values = (
            [*get_args(Kind)]
            if label == "kind"
            else [*dict.fromkeys(getattr(p, label) for p in result.parts)]
        )
        if label != "shaft" and value is not None and value not in values:
            raise ValueError(
                _(
                    "no part has the {label} {value}; give one of {values}",
                    label=label,
                    value=given(value),
                    values=", ".join(str(each) for each in values if each is not None),
                )
            )
