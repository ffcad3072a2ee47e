"""Plain bearings and their oil as data: the sizes of specific pressures and oil films."""

from __future__ import annotations

from pydantic import Field

from crankstar.engine.cylinder_parts import Record
from crankstar.engine.quantities import Diameter, FilmThickness, Viscosity


class PlainBearing(Record):
    """The bearings of one kind of a crankshaft, all alike.

    >>> PlainBearing(diameter=0.06, length=0.02).area
    0.0012
    """

    diameter: Diameter = Field(description="of the journal or pin", examples=["60 mm"])
    length: Diameter = Field(
        description="that carries, without fillets and groove", examples=["20 mm"]
    )
    clearance: FilmThickness | None = Field(
        default=None, description="radial, half the difference of diameters", examples=["25 um"]
    )

    @property
    def area(self) -> float:
        """Diameter times length, m^2: a load over it is the specific pressure."""
        return self.diameter * self.length


class Oil(Record):
    """Main bearings and crank pins with their oil.

    >>> Oil(main=PlainBearing(diameter=0.06, length=0.02)).viscosity is None
    True
    """

    viscosity: Viscosity | None = Field(
        default=None, description="of the oil as warm as it is in the bearing", examples=["8 mPa*s"]
    )
    main: PlainBearing | None = Field(default=None, description="the main bearings")
    pin: PlainBearing | None = Field(default=None, description="the crank pins, of each rod")
