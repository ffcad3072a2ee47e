"""What faults change in what shakes an engine, order by order."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from crankstar.analyses.fault.question import Question
from crankstar.analysis.document import (
    Audience,
    Column,
    Document,
    Remarks,
    Table,
    Value,
    for_each,
    remarks,
)
from crankstar.dynamics.whirl import body
from crankstar.engine.engine import Engine
from crankstar.language.messages import N_, _, passage
from crankstar.language.numbers import number, rpm_of
from crankstar.spectra import Real
from crankstar.studies.fault_kinds import fault_facts, fault_text
from crankstar.studies.single_faults import Shaken
from crankstar.tables.gas_words import state_facts, state_words, usual_words

AUDIENCES: tuple[Audience, Audience] = ("readers", "machines")
VISIBLE = 1e-3
"""Share of the greatest of a column from which a change is shown to readers."""


def document(engine: Engine, result: tuple[Shaken, Shaken], question: Question) -> Document:
    """What is felt with faults and without: force, couple, roll, torque, motion of a point."""
    before, after = result
    faults, point = question.faults, question.position(engine)
    readers, machines = (_changes(before, after, point, audience=each) for each in AUDIENCES)
    fresh = _fresh(before, after, point)
    lines = [
        usual_words(before.speed)
        if engine.gas is None and before.engine.gas is not None
        else state_words(engine, before.state),
        _("With: {faults}.", faults=", ".join(fault_text(fault, engine) for fault in faults)),
    ]
    if fresh:
        lines.append(
            _(
                "New orders, or more than twice what they were: {orders}.",
                orders=", ".join(f"{order:g}" for order in fresh),
            )
        )
    if not readers.rows:
        lines.append(
            _(
                "Nothing changes by more than {share} % of the greatest order.",
                share=number(100 * VISIBLE),
            )
        )
    facts: dict[str, Any] = {
        "format": 1,
        "speed_rpm": rpm_of(before.speed),
        "operating_point": before.state.point or None,
        "points": state_facts(before.state)["points"],
        "mounted": before.mounted,
        "point_mm": [round(1e3 * float(each), 6) for each in _position(before, point)],
        "faults": [fault_facts(fault) for fault in faults],
        "new_orders": fresh,
    }
    parts: list[Table | Remarks] = [*remarks(*lines), *for_each(readers, machines)]
    parts += remarks(*_notes(before, point), kind="note")
    return Document(engine.name, tuple(parts), facts)


def _notes(before: Shaken, point: Sequence[float] | None) -> list[str]:
    """What the numbers mean."""
    return [
        _velocity_of(before, point),
        _(
            "Force and couple are the greatest of the turning vector, about the centre of mass; "
            "roll and torque include the gas."
        )
        if before.engine.gas is not None
        else _(
            "Force and couple are the greatest of the turning vector, about the centre of mass; "
            "roll and torque are without gas."
        ),
        _motion_of(before, point),
    ]


def _motion_of(before: Shaken, point: Sequence[float] | None) -> str:
    """As what body the point moves; of a free one no moment moves the centre of mass."""
    if before.mounted:
        return _("The point moves as the block on its mounts does.")
    free = _("The point moves as the free block does: the file has no mounts.")
    if point is not None:
        return free
    still = _("A roll or couple turns it about this point, which it does not move; see --at.")
    return passage((free, still))


def _position(before: Shaken, point: Sequence[float] | None) -> Sequence[float]:
    """The point whose velocity is told, m (up, right, along): the centre of mass unless given."""
    return body(before.engine).centre if point is None else point


def _velocity_of(before: Shaken, point: Sequence[float] | None) -> str:
    up, right, along = (number(round(1e3 * each, 6)) for each in _position(before, point))
    if point is None:
        return _(
            "The velocity is that of the centre of mass: {up} mm up, {right} mm to the right, "
            "{along} mm along. --at names another point.",
            up=up,
            right=right,
            along=along,
        )
    return _(
        "The velocity is that of the point {up} mm up, {right} mm to the right, {along} mm along.",
        up=up,
        right=right,
        along=along,
    )


def shown_orders(
    before: Shaken, after: Shaken, point: Sequence[float] | None, *, audience: Audience
) -> list[float]:
    """The orders of which there is a row: of readers those that change, of machines all."""
    orders = before.orders.tolist()
    if audience == "machines":
        return orders
    first, then = before.sizes(point), after.sizes(point)
    changed = np.abs(then - first) > _least(before, after, point)
    return [order for order, sizes in zip(orders, changed, strict=True) if sizes.any()]


def _fresh(before: Shaken, after: Shaken, point: Sequence[float] | None) -> list[float]:
    """The orders that are new, or more than twice what they were."""
    first, then = before.sizes(point), after.sizes(point)
    least = _least(before, after, point)
    fresh = then > np.maximum(2 * first, 10 * least)
    return [k for k, sizes in zip(before.orders.tolist(), fresh, strict=True) if sizes.any()]


def _least(before: Shaken, after: Shaken, point: Sequence[float] | None) -> Real:
    """Of each column the least change that is shown to readers."""
    top = np.maximum(before.sizes(point), after.sizes(point)).max(axis=0)
    return VISIBLE * np.where(top > 0, top, 1.0)


def _changes(
    before: Shaken, after: Shaken, point: Sequence[float] | None, *, audience: Audience
) -> Table:
    """Order by order what there was and what there is."""
    pairs = np.stack([before.sizes(point), after.sizes(point)], axis=-1)
    shown = shown_orders(before, after, point, audience=audience)
    rows: list[tuple[Value, ...]] = [
        (order, *map(float, sizes.ravel()))
        for order, sizes in zip(before.orders.tolist(), pairs, strict=True)
        if order in shown
    ]
    columns = [Column(_("order"), key="order", label=True)]
    for name, key, unit in (
        (N_("force"), "force", "N"),
        (N_("couple"), "couple", "N*m"),
        (N_("roll"), "roll", "N*m"),
        (N_("torque"), "torque", "N*m"),
        (N_("velocity of the point, rms"), "velocity", "mm/s"),
    ):
        columns.append(Column(_("{quantity} before", quantity=_(name)), unit, key=f"before/{key}"))
        columns.append(Column(_("{quantity} now", quantity=_(name)), unit, key=f"now/{key}"))
    return Table(_("What changes"), tuple(columns), tuple(rows), key="orders")
