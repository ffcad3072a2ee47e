"""The weights of a batch of pistons, pins and rods on a list, and what an engine has of them.

Columns `piston`, `pin`, `small end` and `big end`, each with its unit; `no.` names the parts of a
line. The parts of a line need not belong together, but both ends of a rod do.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from crankstar.engine.cylinder_parts import ENDS, RECIPROCATING
from crankstar.engine.engine import Engine
from crankstar.engine.quantities import MASS
from crankstar.files.columns import Columns
from crankstar.files.lists import Listed
from crankstar.language.messages import MessageError, _
from crankstar.language.shown_units import quantity_text
from crankstar.spectra import Real
from crankstar.studies.part_weights import WEIGHED

NUMBERS = ("no", "number", "nr", "name", "id", "part", "label", "serial", "set")
"""Headings of the column that names the parts of a line."""
HEADS = {
    **dict.fromkeys(("piston", "pistons", "piston mass", "piston weight"), "piston"),
    **dict.fromkeys(
        ("pin", "pins", "piston pin", "wrist pin", "gudgeon pin", "pin mass", "pin weight"), "pin"
    ),
    **dict.fromkeys(("small end", "rod small end", "small", "rod small"), "small_end"),
    **dict.fromkeys(("big end", "rod big end", "big", "rod big"), "big_end"),
    **dict.fromkeys(NUMBERS, "label"),
}
"""The parts by the headings under which people list them."""

APART = 2.0
"""Factor by which a part may differ from the middle of its batch; parts differ by a few percent."""


class MatchingError(MessageError):
    """A batch that cannot be matched to an engine, and why."""


@dataclass(frozen=True)
class Batch:
    r"""Parts by kind: what they are called, their masses in kg [item].

    >>> from crankstar.files.lists import list_of
    >>> found = batch_of(list_of("no,piston [g],pin [g]\nA,412,99\nB,413,98", name="w.csv"))
    >>> found.labels, found.masses["pin"].round(9).tolist()
    (('A', 'B'), [0.099, 0.098])
    """

    labels: tuple[str, ...]
    masses: Mapping[str, Real]

    @property
    def size(self) -> int:
        """How many there are of each kind."""
        return len(self.labels)

    @property
    def has_rods(self) -> bool:
        """Whether rods are on the list."""
        return any(end in self.masses for end in ENDS)

    @property
    def has_pistons(self) -> bool:
        """Whether pistons or pins are on the list."""
        return "piston" in self.masses or "pin" in self.masses


def batch_of(listed: Listed) -> Batch:
    """The batch of a list. Raises ListError with every mistake."""
    columns = Columns(listed, HEADS)
    weighed = [name for name in WEIGHED if name in columns]
    if not weighed and not columns.mistakes:
        columns.refuse_list(
            _(
                "it has no weights; name columns piston, pin, small end or big end with their "
                "unit, as in {example}",
                example='"piston [g]"',
            )
        )
    masses: dict[str, Real] = {}
    for name in weighed:
        found = [columns.value(row, name, MASS) for row in columns.rows]
        _check_weights(columns, name, found)
        masses[name] = np.array(found)
    labels = [str(number) for number, _row in enumerate(columns.rows, 1)]
    if "label" in columns:
        labels = [columns.text(row, "label") for row in columns.rows]
        _note_twice(columns, labels)
    columns.check()
    return Batch(tuple(labels), masses)


def _check_weights(columns: Columns, name: str, found: Sequence[float]) -> None:
    """Refuse what weighs nothing, or is far from the middle of its column; nan is noted already."""
    sound = [mass for mass in found if mass > 0]
    middle = float(np.median(sound)) if sound else 0.0
    for row, mass in zip(columns.rows, found, strict=True):
        if mass <= 0:
            columns.refuse(row, name, _("a weight must be greater than 0"))
        elif mass < middle / APART or mass > middle * APART:
            slip = _(
                "{value} is far from the middle of its column, {middle}; is there a slip in it?",
                value=quantity_text(mass, "kg"),
                middle=quantity_text(middle, "kg"),
            )
            columns.refuse(row, name, slip)


def _note_twice(columns: Columns, labels: Sequence[str]) -> None:
    """Note parts without a name, and names that stand in a line before."""
    known: set[str] = set()
    for row, label in zip(columns.rows, labels, strict=True):
        if not label:
            columns.refuse(row, "label", _("the parts of this line have no name"))
        elif label in known:
            twice = _("{name} stands twice; name each part once", name=label)
            columns.refuse(row, "label", twice)
        known.add(label)


def paired(batch: Batch) -> tuple[tuple[int, ...], Real]:
    """For each piston the pin that goes with it, and their masses together, kg [piston].

    The heaviest pin goes with the lightest piston, and so on: of all pairings this has the least
    greatest sum, the greatest least sum and the least scatter of sums, by exchange of any two pins.

    >>> parts = {"piston": np.array([0.410, 0.412, 0.411]), "pin": np.array([0.1, 0.101, 0.102])}
    >>> pins, sums = paired(Batch(("1", "2", "3"), parts))
    >>> pins, sums.round(9).tolist()
    ((2, 0, 1), [0.512, 0.512, 0.512])
    """
    none = np.zeros(batch.size)
    pistons, pins = (batch.masses.get(name, none) for name in ("piston", "pin"))
    own = np.arange(batch.size)
    if "piston" in batch.masses and "pin" in batch.masses:
        own[np.argsort(pistons, kind="stable")] = np.argsort(-pins, kind="stable")
    return tuple(own.tolist()), pistons + pins[own]


def base(engine: Engine, batch: Batch) -> dict[str, Real]:
    """What each cylinder has of the weighed parts before, kg [cylinder]; those of the file.

    Where the file has no parts the mean of the batch stands for what its masses have of them, so
    that only the differences count. Raises MatchingError.
    """
    if "mass" in engine.relative:
        raise MatchingError(
            "the engine file gives no masses, so that grams mean nothing in it; add "
            "cylinder.parts, or reciprocating_mass and rotating_mass"
        )
    _refuse_heavier(engine, batch)
    out: dict[str, Real] = {}
    for name, masses in batch.masses.items():
        found: list[float] = []
        for cylinder in engine.cylinders:
            parts = cylinder.parts
            if parts is None:
                found.append(float(masses.mean()))
                continue
            found.append(getattr(parts, name))
            if not found[-1]:
                raise MatchingError(
                    "the parts of cylinder {number} have no {part}; add it to the file, or leave "
                    "the column out",
                    number=cylinder.number,
                    part=name,
                )
        out[name] = np.array(found)
    if "big_end" in batch.masses:
        _refuse_without_ends(engine)
    return out


def _refuse_heavier(engine: Engine, batch: Batch) -> None:
    """Refuse parts that go up and down and weigh more than all that does in a file without parts.

    By a factor of APART, as masses of files are often estimates: more is another unit.
    """
    own = [cylinder.reciprocating for cylinder in engine.cylinders if cylinder.parts is None]
    up = {name: masses for name, masses in batch.masses.items() if name in RECIPROCATING}
    if not own or not up:
        return
    listed, most = sum(float(masses.mean()) for masses in up.values()), max(own)
    if listed > APART * most:
        raise MatchingError(
            "mean mass in the list, {parts}: {listed}; that is more than twice all that goes up "
            "and down with a piston in the file, {known}; check the units",
            parts=" + ".join(name.replace("_", " ") for name in up),
            listed=quantity_text(float(f"{listed:.4g}"), "kg"),
            known=quantity_text(float(f"{most:.4g}"), "kg"),
        )


def _refuse_without_ends(engine: Engine) -> None:
    """Refuse an engine on whose pins nothing hangs, since big ends have no place in it."""
    for cylinder in engine.cylinders:
        alone = cylinder.articulated is not None or cylinder.rod is not None
        on_pin = 0.0 if alone else engine.throw(cylinder).rotating_mass
        if not cylinder.rotating + on_pin > 0:
            raise MatchingError(
                "nothing hangs on the crank pin of cylinder {number} in the file; add "
                "cylinder.rotating_mass or cylinder.parts for the big ends of the list",
                number=cylinder.number,
            )
