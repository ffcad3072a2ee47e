"""A capability as a record: what is asked, how it is computed, how it is told.

Hosts (command line, report, page) know an analysis by its record alone and go over all of them; the
functions behind it are loaded when they are needed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any, Generic, Literal, TypeVar, get_args

if TYPE_CHECKING:
    from crankstar.analysis.assumptions import Answer
    from crankstar.analysis.document import Audience, Document, Remarks, Table
    from crankstar.engine.engine import Engine
    from crankstar.engine.torsion import Chain

T = TypeVar("T")
Sizes = tuple[str, float | None, list[float | None], str]
"""Quantity, order, the value of each engine (None where it has none), unit."""


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
class Chart:
    """A chart: the module and name of its function, a line about it, the type of `quantity`."""

    name: str
    path: str
    about: str
    kind: str = ""

    @cached_property
    def _module(self) -> ModuleType:
        return import_module(self.path.partition(":")[0])

    @property
    def draw(self) -> Callable[..., Any]:
        """Its function, loaded on first use."""
        return getattr(self._module, self.path.partition(":")[2])

    @property
    def quantities(self) -> tuple[str, ...]:
        """The values of `quantity`."""
        return get_args(getattr(self._module, self.kind)) if self.kind else ()

    @property
    def options(self) -> tuple[str, ...]:
        """The options of its function."""
        return tuple(self.draw.__kwdefaults__ or ())

    @property
    def compares(self) -> bool:
        """Whether several engines can be drawn side by side."""
        return self.draw.__annotations__.get("engine") == "Engines"

    @property
    def of_chains(self) -> bool:
        """Whether it also draws a drive line without cylinders."""
        return "source" in self.draw.__annotations__


@dataclass(frozen=True)
class Figure:
    """A figure of a report: the name of the chart, of which quantity, and its caption.

    `shows` tells of a result whether there is something to draw; `more`: in the full report alone;
    `at_speed`: it is drawn at the speed of the report.
    """

    chart: str
    caption: str
    quantity: str | None = None
    more: bool = False
    at_speed: bool = False
    shows: Callable[[Any], bool] = bool

    @property
    def quantities(self) -> dict[str, str]:
        """Its quantity by the name of the argument; nothing where it has only one."""
        return {} if self.quantity is None else {"quantity": self.quantity}


@dataclass(frozen=True)
class Measure:
    """A number of an analysis that a sweep may watch: its name, and the unit that it has.

    `figures` are those of the answer that say how far it moves; `orders`: it is also that of one
    order; `natural`: of free vibration, which neither gas nor speed moves.
    """

    name: str
    unit: str
    figures: tuple[str, ...]
    orders: bool = False
    natural: bool = False


@dataclass(frozen=True)
class Grid:
    """Arrays of a result over named axes, as an xarray data set has them.

    `axes`: the values along each, by its name, which ends in their unit. `variables`: the names of
    their axes, the array and its unit, by name; a complex amplitude c is that of
    Re(c exp(i order theta)). `words`: what variables are, where their name does not say it.
    """

    axes: Mapping[str, Any]
    variables: Mapping[str, tuple[tuple[str, ...], Any, str]]
    words: Mapping[str, str] = field(default_factory=dict[str, str])


@dataclass(frozen=True)
class Writes:
    """The engine that an analysis makes of one: the option of its file, and what makes it.

    engine     (engine, question) -> Engine; (result) -> Engine if it is `of_result`
    refuse     (question): refuses to write an engine to which nothing is done
    more       how the analysis uses the option
    count      (question) -> how many engines there are: `engine` gives a sequence of them, each of
               several is written in a file with its number

    instead    (question) -> the option for which the engine is given in place of the document, or
               empty; `engine` is then (result, question) -> Engine
    chosen     fields of the question that only choose which engine is given

    Where the one engine is of the result, the assumptions of the document are those of that engine.
    Where the option is --output, the document itself is printed only, as text or JSON.
    """

    option: str
    engine: Later[Callable[..., Any]]
    refuse: Later[Callable[[Any], None]] | None = None
    more: str = ""
    of_result: bool = False
    count: Later[Callable[[Any], int]] | None = None
    instead: Later[Callable[[Any], str]] | None = None
    chosen: tuple[str, ...] = ()

    @property
    def name(self) -> str:
        """The name of its argument.

        >>> Writes("--save", Later("math:pi")).name
        'save'
        """
        return self.option.lstrip("-").replace("-", "_")


@dataclass(frozen=True)
class Saves:
    """Text of a result that an option writes to a file besides: its option and the file's suffix.

    text       (result) -> str
    refuse     (question): refuses to write it where there is none
    """

    option: str
    suffix: str
    text: Later[Callable[[Any], str]]
    refuse: Later[Callable[[Any], None]]

    @property
    def name(self) -> str:
        """The name of its argument."""
        return self.option.lstrip("-").replace("-", "_")


@dataclass(frozen=True)
class Onward:
    """The command that goes on from an answer: a sentence with {command}, verb and options."""

    sentence: str
    verb: str
    options: tuple[str, ...]


@dataclass(frozen=True)
class Picture:
    """The chart of a result, which -o writes where its name ends as that of a picture.

    draw       (result, question) -> Chart of `charts.grammar`
    title      of {engine}, a sentence of the catalog of messages
    more       what -o says of it
    unshown    fields of the question that it does not show
    caption    what is below it in a report and on a page, which have it only with one
    """

    draw: Later[Callable[[Any, Any], Any]]
    title: str
    more: str
    unshown: tuple[str, ...] = ()
    caption: str = ""


@dataclass(frozen=True)
class Panel:
    """A panel of the page with the figures and the tables of an analysis.

    label      what its tab says
    needs      what stands there of an engine whose file lacks what the analysis is of
    """

    label: str
    needs: str


@dataclass(frozen=True)
class Analysis:
    """A capability, by what every host needs of it.

    `name` is that of its command; `about` says in a line what it computes, `takes` of what; `doing`
    is shown while it does, `title` heads its section. All are sentences of the catalog of messages.
    `example` is what follows the command in an example: an engine of the catalog that has what it
    needs, or a file that would have it, and options.

    question   a frozen dataclass; its fields, each annotated with a Reader, are the options, and
               words that follow the engine
    needs      (engine): refuses one that lacks what is computed with, with a MessageError
    refuse     (source, question): refuses what does not go together, with a RequestError
    compute    (source, question) -> result
    document   (source, result, question) -> Document, for readers and machines
    answer     (engine, question) -> Answer: the figures that its assumptions move; whatever is of
               an engine has one
    lacks      (source, speed) -> whether its file lacks what the analysis is of, at the speed that
               is asked for (rad/s) if any; without it the analysis is told of only where it is
               asked for
    views      fields of the question as reports, pages and verdicts have them
    panel      the panel that a page has of it
    charts     what can be plotted of it
    figures    which of these a report has, and its panel
    subject    what its sentences in a verdict are about
    facts      (source, speed=) -> those sentences
    compared   (engines, names, speeds) -> tables of engines side by side
    sizes      (engines, speeds) -> the same for machines: quantity, order, of each engine, unit
    measures   what a sweep may watch
    measured   (engine, name, speed, order, alone) -> one of these in its unit, over the speeds of
               the file and `speed`, or `alone` at that speed (rad/s), of all orders or one
    natural    () -> Answer: the figures of free vibration alone
    writes     the engine that it makes, which an option writes as a file
    proved     (result) -> whether it is the best, of steps that end where `tell` gives False: the
               result is then the best so far
    grids      (result) -> Grids by the name of its attribute, for what has dimensions
    picture    what is drawn of its result, where -o names a picture
    saves      text of its result that is written besides
    onward     (engine) -> the command that goes on from it, if any, which readers are told

    `engine` tells whether it is of an engine, may be, or never is: without one the source is None,
    the words of the question come first, and `refuse` has to say what else is to be given;
    `chains` are the fields of the question that a drive line without an engine may be asked too;
    `lists` those that choose what tables list, and change no figure that is plotted;
    `of_file`: compute, lacks and facts take what was loaded, with the tree of its file, in place of
    the source;
    `estimates`: values that a file leaves out may be estimated, and results have ranges;
    `unranged`: but for these results; `ranges_itself`: its document has them, by what was loaded;
    `marks_speed`: a speed that changes nothing, since the file has no masses or sizes, is marked;
    `steps`: compute takes long, and `tell=`, to be called with the steps done and their number;
    `by_audience`: answer also takes `audience=`, as readers are shown less than machines;
    `by_result`: answer also takes `result=`, as it goes on from what was found.
    """

    name: str
    about: str
    takes: str
    doing: str
    title: str
    example: str
    question: Later[type[Any]]
    compute: Later[Callable[[Any, Any], Any]]
    document: Later[Callable[[Any, Any, Any], Document]]
    answer: Later[Callable[..., Answer]] | None = None
    lacks: Callable[[Any, float | None], bool] | None = None
    views: Mapping[str, Any] = field(default_factory=dict[str, Any])
    panel: Panel | None = None
    needs: Later[Callable[[Engine], object]] | None = None
    refuse: Later[Callable[[Engine | Chain, Any], None]] | None = None
    charts: tuple[Chart, ...] = ()
    figures: tuple[Figure, ...] = ()
    subject: str = ""
    facts: Later[Callable[..., list[str]]] | None = None
    compared: Later[Callable[..., tuple[Table, ...]]] | None = None
    sizes: Later[Callable[..., list[Sizes]]] | None = None
    measures: tuple[Measure, ...] = ()
    measured: Later[Callable[..., float]] | None = None
    natural: Later[Callable[[], Answer]] | None = None
    writes: Writes | None = None
    proved: Later[Callable[[Any], bool]] | None = None
    grids: Later[Callable[[Any], Mapping[str, Grid]]] | None = None
    picture: Picture | None = None
    saves: Saves | None = None
    onward: Later[Callable[[Engine], Onward | None]] | None = None
    engine: Literal["needed", "optional", "none"] = "needed"
    chains: tuple[str, ...] = ()
    lists: tuple[str, ...] = ()
    of_file: bool = False
    estimates: bool = False
    unranged: bool = False
    ranges_itself: bool = False
    marks_speed: bool = False
    steps: bool = False
    by_audience: bool = False
    by_result: bool = False

    @property
    def identifier(self) -> str:
        """The name of its function in Python."""
        return self.name.replace("-", "_")

    @property
    def ranged(self) -> bool:
        """Whether results have the ranges of estimated values."""
        return self.estimates and not self.unranged

    @property
    def ranges(self) -> bool:
        """Whether a host puts these ranges in, by results over them."""
        return self.ranged and not self.ranges_itself

    def tells(self, engine: Engine, speed: float | None = None, *, file: Any = None) -> bool:
        """Whether reports and verdicts have it of an engine, at a speed (rad/s) or its own.

        Of a `file` that was loaded, and not of an engine alone, where it is `of_file`.
        """
        about = file if self.of_file else engine
        return about is not None and self.lacks is not None and not self.lacks(about, speed)

    def told(self, source: Engine | Chain | None, question: Any, *, file: Any = None) -> Document:
        """The document of a source, with the values of a question; of a `file` that was loaded."""
        about = file if self.of_file else source
        return self.document.value(source, self.compute.value(about, question), question)

    def viewed(self, source: Engine, speed: float | None, *, file: Any) -> list[Table | Remarks]:
        """What views have below the heading of an engine, which they have themselves."""
        question = self.question.value(speed=speed, **self.views)
        parts = [*self.told(source, question, file=file).parts]
        return parts[1:] if getattr(parts[0], "rows", None) is None else parts

    def resting(self, source: Engine, result: Any) -> Engine:
        """The engine whose assumptions are told: the source, or the one that was made of it."""
        writes = self.writes
        made = writes is not None and writes.of_result and writes.count is None
        return writes.engine.value(result) if writes is not None and made else source

    def answered(self, engine: Engine, question: Any, result: Any, audience: Audience) -> Answer:
        """The figures that the assumptions of an engine move, of a result told to an audience."""
        more: dict[str, Any] = {"audience": audience} if self.by_audience else {}
        if self.by_result:
            more["result"] = result
        return self.answering(engine, question, **more)

    def answering(self, engine: Engine, question: Any, **more: Any) -> Answer:
        """The same, without a result."""
        assert self.answer is not None  # noqa: S101  # what is of an engine has it
        return self.answer.value(engine, question, **more)
