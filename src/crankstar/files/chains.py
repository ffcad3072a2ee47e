"""A drive line without cylinders, read from a file of its own: name, speed, discs, pendulums."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from pydantic import ValidationError

from crankstar.engine.torsion import Chain
from crankstar.engine.torsion_checks import chain_faults
from crankstar.files import bare_numbers
from crankstar.files.errors import EngineFileError
from crankstar.files.mistakes import Tree, faults_of, mended
from crankstar.files.references import written_units
from crankstar.language.faults import Fault

_OF_ENGINES = {"layout", "cylinder", "cylinders", "shaft", "shafts", "torsion"}


def is_chain(tree: Mapping[str, Any]) -> bool:
    """Whether a tree is a drive line: discs, and nothing that an engine has.

    >>> is_chain({"name": "fan drive", "disc": []}), is_chain({"disc": [], "layout": {}})
    (True, False)
    """
    return "disc" in tree and not _OF_ENGINES & tree.keys()


def is_drive_line(tree: Mapping[str, Any]) -> bool:
    """Whether a tree has discs and nothing but what a drive line has.

    >>> is_drive_line({"disc": [], "speed": "60 rpm"}), is_drive_line({"disc": [], "layuot": {}})
    (True, False)
    """
    return is_chain(tree) and tree.keys() <= Chain.model_fields.keys() | _WRITTEN


_WRITTEN = {"disc", "pendulum"}
"""Keys that stand for fields of another name."""


def chain_of(tree: Tree, *, name: str = "the chain") -> Chain:
    """The chain of a tree. Raises EngineFileError with every mistake in it.

    >>> shaft = {"name": "fan", "inertia": "3 kg*m^2", "to": "motor", "stiffness": "6 N*m/rad"}
    >>> discs = [{"name": "motor", "inertia": "2 kg*m^2"}, shaft]
    >>> chain_of({"name": "fan drive", "disc": discs}).discs[1].stiffness
    6.0
    """
    # of mended copies, whose numbers are bare
    context = {"reader": bare_numbers.reader(frozenset())}
    strict = {"reader": bare_numbers.reader(frozenset(), written=written_units(tree, Chain))}
    try:
        chain = Chain.model_validate(tree, context=strict, by_alias=True, by_name=False)
    except ValidationError as error:
        faults = faults_of(error, Chain, tree)
        faults += _behind(mended(tree, error, Chain, number=9000), faults, context)
        raise EngineFileError(name, faults) from None
    faults = list(chain_faults(chain))
    if faults:
        raise EngineFileError(name, faults)
    return chain


def _behind(tree: Tree, known: list[Fault], context: Mapping[str, Any]) -> list[Fault]:
    """The faults of a mended copy in discs of which nothing is known yet."""
    try:
        chain = Chain.model_validate(tree, context=context, by_alias=True, by_name=False)
    except ValidationError:
        return []
    places = {fault.path[:2] for fault in known}
    return [fault for fault in chain_faults(chain) if fault.path[:2] not in places]
