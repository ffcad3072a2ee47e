"""A capability as a record: what is asked, how it is computed, how it is told.

Hosts (command line, report, page) know an analysis by its record alone and go over all of them; the
functions behind it are loaded when they are needed.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from typing import TYPE_CHECKING, Any, Generic, TypeVar

if TYPE_CHECKING:
    from crankstar.engine.engine import Engine
    from crankstar.engine.torsion import Chain
    from crankstar.studies.assumptions import Answer
    from crankstar.tables.table import Document

T = TypeVar("T")


class Later(Generic[T]):
    """Something of a module that is loaded when it is first wanted.

    >>> Later("math:pi").value
    3.141592653589793
    """

    def __init__(self, path: str) -> None:
        self.path = path

    @cached_property
    def value(self) -> T:
        """What the path names: `module:name`."""
        module, _colon, name = self.path.partition(":")
        return getattr(import_module(module), name)

    def __repr__(self) -> str:
        return f"Later({self.path!r})"


@dataclass(frozen=True)
class Figure:
    """A figure of an analysis: its name among the charts, which quantity, and its caption.

    `shows` tells of a result whether there is something to draw; `more`: in the full report alone.
    """

    chart: str
    caption: str
    quantity: str | None = None
    more: bool = False
    shows: Callable[[Any], bool] = bool

    @property
    def quantities(self) -> dict[str, str]:
        """Its quantity by the name of the argument; nothing where it has only one."""
        return {} if self.quantity is None else {"quantity": self.quantity}


@dataclass(frozen=True)
class Analysis:
    """A capability, by what every host needs of it.

    `name` is that of its command; `about` says in a line what it computes, `takes` of what; `doing`
    is shown while it does, `title` heads its section. All are sentences of the catalog of messages.

    question   a frozen dataclass; its fields, each annotated with a Reader, are the options
    refuse     (source, question): refuses what does not go together, with a RequestError
    compute    (source, question) -> result
    document   (source, result, question) -> Document, for readers and machines
    answer     (engine, question) -> Answer: the figures that its assumptions move
    lacks      (engine) -> what its file lacks, as a sentence; empty where it can be computed
    figures    what is drawn of it

    `chains` are the fields of the question that a drive line without an engine may be asked too;
    `estimates`: values that a file leaves out may be estimated, and results have ranges.
    """

    name: str
    about: str
    takes: str
    doing: str
    title: str
    question: Later[type[Any]]
    compute: Later[Callable[[Any, Any], Any]]
    document: Later[Callable[[Any, Any, Any], Document]]
    answer: Later[Callable[[Engine, Any], Answer]]
    lacks: Callable[[Engine], bool]
    refuse: Later[Callable[[Engine | Chain, Any], None]] | None = None
    figures: tuple[Figure, ...] = ()
    chains: tuple[str, ...] = ()
    estimates: bool = False

    def told(self, source: Engine | Chain, question: Any) -> Document:
        """The document of a source, with the values of a question."""
        return self.document.value(source, self.compute.value(source, question), question)
