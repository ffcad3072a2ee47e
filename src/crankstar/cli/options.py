"""The options that several verbs share, with their help, and the engine that they name."""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

from crankstar import request
from crankstar.catalog import load
from crankstar.engine import Engine

EngineName = Annotated[str, Parameter(help="a name from the catalog, a file, or - for standard input")]
Speed = Annotated[
    str | None,
    Parameter(
        name="--speed", allow_leading_hyphen=True, help='crank speed with its unit, as in "6000 rpm"; else the speed in the file'
    ),
]
Orders = Annotated[
    str | None,
    Parameter(name="--orders", allow_leading_hyphen=True, help="crank orders, as in 1,2,4,6 or all; else those up to 6 that occur"),
]
ReferencePoint = Annotated[
    str | None,
    Parameter(
        name="--reference",
        allow_leading_hyphen=True,
        help='point for couples and rolls: z, or z, up and right, as in "-120 mm" or "0 mm, 35 mm, 0 mm"; z as in crankstar show '
        "(else the middle of the cylinders' span, on the crank axis)",
    ),
]
Angles = Annotated[
    str | None,
    Parameter(name="--at", allow_leading_hyphen=True, help='also all orders together at these crank angles, as in "0 deg, 90 deg"'),
]
Output = Annotated[
    str | None, Parameter(name=["--output", "-o"], help="write to this file instead; it is replaced only when all went well")
]
Settings = Annotated[
    list[str] | None,
    Parameter(
        name="--set",
        help='change a value of the file, as in --set layout.bore_pitch="100 mm" --set balance_factor=0.5',
        negative=(),
    ),
]


def loaded_engine(name: str, settings: list[str] | None) -> Engine:
    """The engine of a name or file, with the values of --set."""
    return load(name, changes=dict(request.setting(text) for text in settings or []))
