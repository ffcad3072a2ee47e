"""The crankshaft as a chain that twists: inertias, stiffnesses, discs, dampers and pendulums.

Of an engine (`Torsion`, the table [torsion]) or of a drive line without cylinders (`Chain`, a file
of its own). Discs hang on an end of a crankshaft, on a throw or on a disc listed before, and a
second crankshaft is coupled to what turns already, so that everything branches as a tree does.
"""

from __future__ import annotations

from fractions import Fraction
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field

from crankstar.engine.cylinder_parts import Record
from crankstar.engine.quantities import (
    Diameter,
    Line,
    Number,
    Pressure,
    ShearModulus,
    Speed,
    SpeedRatio,
    Text,
    TurningDamping,
    TurningInertia,
    TurningMass,
    TurningStiffness,
)
from crankstar.engine.torsion_places import REAR

GREATEST_DISCS = 64
GREATEST_THROWS = 256
GREATEST_CRANKSHAFTS = 16
STEEL = 80e9
"""Pa: the shear modulus that is assumed of a crankshaft."""
LOSS_FACTOR = 0.02
"""Assumed of crank elements and shafts: a dynamic magnifier of 50, for which the tables say so."""
FACTORS = (
    "pin_bending",
    "pin_torsion",
    "journal_bending",
    "journal_compression",
    "journal_torsion",
)
"""The stress concentration factors of the fillets of a crank throw."""
Formula = Literal["ker-wilson", "carter", "timoshenko"]
LossFactor = Annotated[Number, Field(ge=0, le=2)]
Concentration = Annotated[Number, Field(ge=1, le=50)]
"""How many times the nominal stress the greatest one is."""


class OneOrSeveral:
    """Marks a list that may also be written as the one value of all."""

    def __get_pydantic_json_schema__(self, schema: Any, handler: Any) -> dict[str, Any]:
        """In a file one value, or a list of them."""
        listed = handler(schema)
        return {"anyOf": [listed["items"], listed]}


def as_list(value: Any) -> Any:
    """A list of the value, unless it is one."""
    return value if isinstance(value, list | tuple | dict) or value is None else (value,)


Inertias = Annotated[
    tuple[TurningInertia, ...], BeforeValidator(as_list), OneOrSeveral(), Field(max_length=256)
]
Stiffnesses = Annotated[
    tuple[TurningStiffness, ...], BeforeValidator(as_list), OneOrSeveral(), Field(max_length=256)
]
Dampings = Annotated[
    tuple[TurningDamping, ...], BeforeValidator(as_list), OneOrSeveral(), Field(max_length=256)
]


class Disc(Record):
    """A flywheel, hub, damper ring, gear, rotor or propeller, and the shaft that it hangs on.

    >>> Disc(name="flywheel", inertia=1.2, to="rear").speed_ratio
    Fraction(1, 1)
    """

    name: Line = Field(description="by which results and other discs name it")
    inertia: TurningInertia = Field(description="about the axis that it turns on")
    to: Line | None = Field(
        default=None,
        description=(
            '"front", "rear", "throw 3" (of another crankshaft "rear of upper"), or the name of a '
            "disc listed before it"
        ),
        examples=["rear"],
    )
    stiffness: TurningStiffness | None = Field(
        default=None,
        description=(
            "of the shaft or the rubber between them; rigid if left out, or, with a damping, a "
            "ring that its fluid alone takes along"
        ),
    )
    damping: TurningDamping = Field(
        default=0.0, description="between the two, by the speed of the twist"
    )
    loss_factor: LossFactor | None = Field(
        default=None,
        description=(
            "of that shaft: damping by the twist itself; if left out that of the crankshaft, or "
            "none beside a damping"
        ),
    )
    speed_ratio: SpeedRatio = Field(
        default=Fraction(1),
        description="of a gear at `to`: turns of this disc and its shaft per turn there",
    )
    diameter: Diameter | None = Field(
        default=None, description="of its shaft where it is thinnest, for the shear stress"
    )
    bore: Diameter | None = Field(default=None, description="of a hollow shaft")
    absolute_damping: TurningDamping = Field(
        default=0.0, description="against what stands still: a propeller in water"
    )

    @property
    def is_ring(self) -> bool:
        """Whether a fluid alone takes it along."""
        return self.stiffness is None and self.damping > 0


class Pendulum(Record):
    """Masses that swing on a disc or throw as the crankshaft turns unevenly.

    >>> Pendulum(on="front", mass=0.6, radius=0.08, length=0.02).tuned_order
    2.0
    """

    on: Line = Field(description="as `to` of a disc", examples=["throw 1"])
    mass: TurningMass = Field(description="of one")
    radius: Diameter = Field(description="from the crank axis to the pivot")
    length: Diameter = Field(description="from the pivot to its centre of mass")
    count: Annotated[int, Field(strict=True, ge=1, le=100)] = Field(
        default=1, description="how many there are alike"
    )

    @property
    def tuned_order(self) -> float:
        """The order that it holds back: sqrt(R/L), at every speed."""
        return (self.radius / self.length) ** 0.5


class CrankDimensions(Record):
    """A crank throw, by which the stiffness between two throws is estimated."""

    journal_diameter: Diameter = Field(description="of the main journals", examples=["60 mm"])
    journal_bore: Diameter | None = Field(default=None, description="of hollow journals")
    journal_length: Diameter = Field(description="between the webs", examples=["28 mm"])
    pin_diameter: Diameter = Field(description="of the crank pins", examples=["48 mm"])
    pin_bore: Diameter | None = Field(default=None, description="of hollow pins")
    pin_length: Diameter = Field(description="between the webs", examples=["26 mm"])
    web_width: Diameter = Field(description="across the web", examples=["80 mm"])
    web_thickness: Diameter = Field(description="along the crankshaft", examples=["18 mm"])
    shear_modulus: ShearModulus | None = Field(
        default=None, description="of the material; 80 GPa, steel, if left out"
    )
    formula: Formula = Field(default="ker-wilson", description="published formula for the estimate")


Pendulums = Annotated[
    tuple[Pendulum, ...],
    Field(
        validation_alias="pendulum",
        serialization_alias="pendulum",
        max_length=GREATEST_DISCS,
        description="pendulum absorbers",
    ),
]


class CrankFatigue(Record):
    """Fillets and steel of a crankshaft, by which its safety against fatigue is reckoned.

    >>> own = CrankFatigue(pin_fillet=0.003, journal_fillet=0.003, tensile_strength=8e8)
    >>> own.strength_factor, own.additional_stress, own.factors
    (1.0, 10000000.0, {})
    """

    pin_fillet: Diameter = Field(
        description="radius between crank pin and web", examples=["3.5 mm"]
    )
    journal_fillet: Diameter = Field(
        description="radius between main journal and web", examples=["3.5 mm"]
    )
    pin_recess: Diameter | None = Field(
        default=None, description="depth to which the fillet of the pin is cut into the web"
    )
    journal_recess: Diameter | None = Field(
        default=None, description="depth to which that of the journal is"
    )
    tensile_strength: Pressure = Field(
        description="least that the material has", examples=["800 MPa"]
    )
    strength_factor: Annotated[Number, Field(gt=0, le=3)] = Field(
        default=1.0,
        description=(
            "of how it is made: 1.05 drop-forged or with continuous grain flow, 1 free-forged, "
            "0.93 cast steel with rolled fillets"
        ),
    )
    additional_stress: Pressure = Field(
        default=10e6,
        description=(
            "bending stress added for misalignment and for axial vibration: 10 MPa with trunk "
            "pistons, 30 MPa with crossheads"
        ),
    )
    pin_bending: Concentration | None = Field(
        default=None,
        description="stress concentration factor, instead of the one by dimensions",
        examples=[4.2],
    )
    pin_torsion: Concentration | None = Field(default=None, description="the same")
    journal_bending: Concentration | None = Field(default=None, description="the same")
    journal_compression: Concentration | None = Field(default=None, description="the same")
    journal_torsion: Concentration | None = Field(default=None, description="the same")

    @property
    def factors(self) -> dict[str, float]:
        """The stress concentration factors that are given."""
        given = {name: getattr(self, name) for name in FACTORS}
        return {name: value for name, value in given.items() if value is not None}


class Coupling(Record):
    """What turns another crankshaft: gears, a chain or a belt from what turns already.

    >>> Coupling(crankshaft="upper").at, Coupling(crankshaft="upper").to
    ('rear', 'rear')
    """

    crankshaft: Line = Field(description="name of the shaft that it turns", examples=["upper"])
    at: Line = Field(default=REAR, description='"front", "rear" or "throw 3" of that shaft')
    to: Line = Field(
        default=REAR,
        description="as `to` of a disc: on the first crankshaft, or what is coupled before",
    )
    stiffness: TurningStiffness | None = Field(
        default=None, description="by the twist of that shaft; rigid if left out"
    )
    damping: TurningDamping = Field(default=0.0, description="by the speed of the twist")
    loss_factor: LossFactor | None = Field(
        default=None, description="damping by the twist itself; as that of the crank elements"
    )


class Torsion(Record):
    """The crankshaft between front and rear, throw by throw, and all that turns with it.

    >>> Torsion(inertia=0.03, stiffness=1e6, discs=[Disc(name="flywheel", inertia=1, to="rear")])
    ... # doctest: +ELLIPSIS
    Torsion(inertia=(0.03,), bare_inertia=(), stiffness=(1000000.0,), ...
    """

    inertia: Inertias = Field(
        default=(),
        examples=["0.035 kg*m^2"],
        description=(
            "of each throw, front first (of several crankshafts one after the other), or one for "
            "all: webs, pin, big ends and half the reciprocating masses, as published"
        ),
    )
    bare_inertia: Inertias = Field(
        default=(),
        examples=["0.012 kg*m^2"],
        description=(
            "of the crankshaft alone at each throw, with its crankpin, instead of `inertia`; "
            "rods, pistons and rotating_mass are added by their exact mean"
        ),
    )
    stiffness: Stiffnesses = Field(
        default=(),
        examples=["1.2 MN*m/rad"],
        description="between neighbouring throws, front first, or one for all",
    )
    dimensions: CrankDimensions | None = Field(
        default=None,
        description="of a throw, from which the stiffness is estimated where it is not given",
    )
    fatigue: CrankFatigue | None = Field(
        default=None, description="fillets and material, for the safety against fatigue"
    )
    damping: Dampings = Field(
        default=(),
        examples=["5 N*m*s/rad"],
        description="of each throw against the block, by its speed; one for all",
    )
    loss_factor: LossFactor | None = Field(
        default=None,
        description="of the crank elements: damping by the twist itself; assumed if left out",
    )
    diameter: Diameter | None = Field(
        default=None, description="of the journals, for the shear stress; or as in `dimensions`"
    )
    bore: Diameter | None = Field(default=None, description="of hollow journals")
    shear_limit: Pressure | None = Field(
        default=None,
        description="greatest shear stress by vibration; speeds with more of it are barred",
        examples=["30 MPa"],
    )
    couplings: tuple[Coupling, ...] = Field(
        default=(),
        validation_alias="coupling",
        serialization_alias="coupling",
        max_length=GREATEST_CRANKSHAFTS,
        description="what turns each further crankshaft",
    )
    discs: tuple[Disc, ...] = Field(
        default=(),
        validation_alias="disc",
        serialization_alias="disc",
        max_length=GREATEST_DISCS,
        description="what turns with the crankshaft",
    )
    pendulums: Pendulums = ()


class Chain(Record):
    """A drive line without cylinders: discs in a row or with branches, the first one alone.

    >>> pair = [Disc(name="motor", inertia=2), Disc(name="fan", inertia=3, to="motor")]
    >>> Chain(name="fan drive", discs=pair).speed is None
    True
    """

    format: Literal[1] = Field(default=1, description="version of the file format")
    name: Line = Field(description="of the drive line, on one line")
    speed: Speed | None = Field(default=None, description="of the first disc")
    loss_factor: LossFactor | None = Field(
        default=None, description="of all shafts that do not give their own; assumed if left out"
    )
    discs: tuple[Disc, ...] = Field(
        validation_alias="disc",
        serialization_alias="disc",
        min_length=1,
        max_length=GREATEST_DISCS,
        description="each hangs on one before it, but for the first",
    )
    pendulums: Pendulums = ()
    source: Text = Field(default="", description="where the numbers come from")
    notes: Text = Field(default="", description="anything a reader should know")
