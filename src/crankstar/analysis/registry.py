"""All analyses by name: those of the package, and those that other packages add.

An analysis is a folder of `crankstar.analyses` whose `__init__` holds its RECORD. Another package
adds one by an entry point of the group `crankstar.analyses` that names its record.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from importlib.metadata import EntryPoints

    from crankstar.analysis.record import Analysis, Measure

NAMES = (
    *("torsion", "mounts", "torque", "genset", "marine", "guide", "bearings"),
    *("fault", "diagnose", "isolate"),
)
"""The folders of `crankstar.analyses`, in the order in which hosts go over them."""
GROUP = "crankstar.analyses"


@cache
def names() -> tuple[str, ...]:
    """The names of all analyses.

    >>> names()[:2]
    ('torsion', 'mounts')
    """
    return (*NAMES, *sorted(_added().names))


@cache
def analysis(name: str) -> Analysis:
    """The record of an analysis. Raises KeyError for a name that none has.

    >>> analysis("torsion").title
    'Torsional vibration'
    """
    if name in NAMES:
        return import_module(f"crankstar.analyses.{name}").RECORD
    return _added()[name].load()


def analyses() -> Iterator[Analysis]:
    """The records of all analyses."""
    return map(analysis, names())


@cache
def measures() -> dict[str, tuple[Analysis, Measure]]:
    """What a sweep may watch of the analyses, by name.

    >>> record, measure = measures()["mount_force"]
    >>> record.name, measure.unit
    ('mounts', 'N')
    """
    return {own.name: (record, own) for record in analyses() for own in record.measures}


def _added() -> EntryPoints:
    """The entry points of other packages, which are slow to find."""
    from importlib.metadata import entry_points

    return entry_points(group=GROUP)
