"""The Engine: an assembly of shafts and cylinders that is always valid."""

from __future__ import annotations

from pydantic import model_validator

from crankstar.engine import checks
from crankstar.engine.assembly import Assembly
from crankstar.engine.firing_angles import unfit
from crankstar.engine.motion import unreachable
from crankstar.language.faults import EngineError


class Engine(Assembly):
    """A piston engine: shafts with throws and weights, cylinders on them.

    Always valid: an impossible one raises, also where only the motion shows it.

    `relative` names what is not known and therefore counted in its own unit: masses in the first
    cylinder's reciprocating mass, lengths across the crankshaft in its crank radius, lengths along
    it in bore pitches.

    >>> from crankstar.engine.records import Cylinder, Shaft, Throw
    >>> crank = Shaft(name="crank", throws=(Throw(angle=0.0, radius=0.04),))
    >>> piston = Cylinder(number=1, shaft="crank", throw=1, rod_length=0.14, reciprocating_mass=0.5)
    >>> single = Engine(
    ...     name="single", cycle="four-stroke", shafts=(crank,), cylinders=(piston,)
    ... )
    >>> single.throw(single.first).radius
    0.04
    """

    def __hash__(self) -> int:
        """The same for equal engines; where their values come from has no part in it."""
        return hash(tuple(value for name, value in self if name != "provenance"))

    @model_validator(mode="after")
    def _possible(self) -> Engine:
        faults = list(checks.faults(self)) or unreachable(self) or unfit(self)
        if faults:
            raise EngineError(faults)
        return self
