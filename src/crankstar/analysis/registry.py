"""All analyses by name: those of the package, and those that other packages add.

An analysis is a folder of `crankstar.analyses` whose `__init__` holds its RECORD. Another package
adds one by an entry point of the group `crankstar.analyses` that names its record; one that cannot
be loaded is skipped.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING

from crankstar.engine.packages import Added, Words
from crankstar.language.messages import N_, MessageError, _
from crankstar.language.quoting import one_line

if TYPE_CHECKING:
    from crankstar.analysis.record import Analysis, Measure

NAMES = (
    *("torsion", "mounts", "torque", "genset", "marine", "guide", "bearings"),
    *("fault", "diagnose", "isolate", "strokes", "match", "tolerance"),
    *("bobweight", "correct", "drill", "grade", "orders", "vees", "verdict", "errata"),
)
"""The folders of `crankstar.analyses`, in the order in which hosts go over them."""


@cache
def names() -> tuple[str, ...]:
    """The names of all analyses, also of those of other packages that cannot be loaded.

    >>> names()[:2]
    ('torsion', 'mounts')
    """
    return (*NAMES, *added().names())


@cache
def analysis(name: str) -> Analysis:
    """The record of an analysis. Raises PackageError for one that cannot be loaded, or KeyError.

    >>> analysis("torsion").title
    'Torsional vibration'
    """
    if name in NAMES:
        return import_module(f"crankstar.analyses.{name}").RECORD
    return added()[name]


def analyses() -> Iterator[Analysis]:
    """The records of all analyses that can be loaded."""
    yield from map(analysis, NAMES)
    yield from map(analysis, added().usable())


@cache
def measures() -> dict[str, tuple[Analysis, Measure]]:
    """What a sweep may watch of the analyses, by name.

    >>> record, measure = measures()["mount_force"]
    >>> record.name, measure.unit
    ('mounts', 'N')
    """
    return {own.name: (record, own) for record in analyses() for own in record.measures}


@cache
def added() -> Added[Analysis]:
    """The analyses of other packages."""
    return Added("crankstar.analyses", N_("analysis"), NAMES, _checked)


def _checked(found: object, words: Words) -> Analysis:
    """A record of another package, with all that it names. Raises MessageError."""
    from dataclasses import fields

    from crankstar.analysis.reader import asked
    from crankstar.analysis.record import Analysis, Later

    if not isinstance(found, Analysis):
        raise MessageError(_("it is no Analysis of crankstar.analysis.record"))
    if found.name != words["name"]:
        other = one_line(str(found.name))
        raise MessageError(_("its record has another name, {name}", name=other))
    values = [getattr(found, field.name) for field in fields(found)]
    if all(value.value is not None for value in values if isinstance(value, Later)):
        known: Later[dict[str, object]] = Later("crankstar.options.vocabulary:OPTIONS")
        for each in (one.reader for one in asked(found.question.value)):
            if not each.follows and each.own is None and each.option not in known.value:
                raise MessageError(
                    _(
                        "its option {option} is none of crankstar; say what it takes and means, as "
                        'in Reader("{option}", ..., own=Option("text", "..."))',
                        option=one_line(each.option),
                    )
                )
    return found
