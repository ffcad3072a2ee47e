"""A single fault of an engine: its record, in words, and for machines."""

from __future__ import annotations

from typing import Any, Literal, NamedTuple

from crankstar.engine.engine import Engine
from crankstar.language.messages import _
from crankstar.language.numbers import number
from crankstar.language.shown_units import quantity_text

Kind = Literal["piston", "big_end", "weight", "combustion"]


class Fault(NamedTuple):
    """A fault: its kind, the number of its cylinder or weight, the shaft of the weight.

    `size`: kg that a piston or a big end is heavier, the share of a weight or of combustion lost.
    """

    kind: Kind
    number: int
    size: float = 1.0
    shaft: str = ""


def fault_text(fault: Fault, engine: Engine) -> str:
    """A fault with its size in words.

    >>> from crankstar.files.catalog import load
    >>> fault_text(Fault("piston", 3, 0.0184), load("audi-25-tfsi"))
    'piston 3 heavier by 18.4 g'
    """
    size = quantity_text(abs(fault.size), "kg")
    share = f"{number(100 * fault.size, digits=3)} %"
    if fault.kind == "piston" and fault.size < 0:
        return _("piston {number} lighter by {size}", number=fault.number, size=size)
    if fault.kind == "piston":
        return _("piston {number} heavier by {size}", number=fault.number, size=size)
    if fault.kind == "big_end" and fault.size < 0:
        return _("big end {number} lighter by {size}", number=fault.number, size=size)
    if fault.kind == "big_end":
        return _("big end {number} heavier by {size}", number=fault.number, size=size)
    if fault.kind == "combustion" and fault.size > 0.9995:
        return _("cylinder {number} does not fire", number=fault.number)
    if fault.kind == "combustion":
        return _("cylinder {number} weak by {share}", number=fault.number, share=share)
    name = fault_name(fault, engine)
    return name if fault.size > 0.9995 else _("{what}: {share} of it", what=name, share=share)


def fault_name(fault: Fault, engine: Engine) -> str:
    """A fault in words, without its size."""
    if fault.kind == "piston":
        return _("piston {number} heavier", number=fault.number)
    if fault.kind == "big_end":
        return _("big end {number} heavier", number=fault.number)
    if fault.kind == "combustion":
        return _("cylinder {number} weak", number=fault.number)
    if len([shaft for shaft in engine.shafts if shaft.weights]) > 1:
        name = fault.shaft or engine.shafts[0].name
        return _("weight {number} of {shaft} lost", number=fault.number, shaft=name)
    return _("weight {number} lost", number=fault.number)


def fault_facts(fault: Fault) -> dict[str, Any]:
    """A fault for machines.

    >>> fault_facts(Fault("combustion", 3))
    {'kind': 'combustion', 'number': 3, 'size': 1.0}
    """
    out: dict[str, Any] = {"kind": fault.kind, "number": fault.number, "size": fault.size}
    return {**out, "shaft": fault.shaft} if fault.shaft else out
