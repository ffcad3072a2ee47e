"""The command line of an analysis as it is read: the engine, the question, the form."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict
from functools import partial
from os.path import realpath
from typing import Any, NamedTuple, cast

from crankstar.analysis.reader import Asked, asked, being_read, readings
from crankstar.analysis.record import Analysis, Saves, Writes
from crankstar.cli.options import (
    Looks,
    engine_suffix,
    mark_load,
    mark_speed,
    numbered,
    once,
    read_engine,
    together,
)
from crankstar.cli.output import writable
from crankstar.engine.engine import Engine
from crankstar.engine.torsion import Chain
from crankstar.language.messages import _
from crankstar.options.forms import ENGINES, PICTURES, TABLES, form_of, suffix_of
from crankstar.options.refusals import refusal, refuse_unused
from crankstar.options.sources import Loaded

LOOKS = Looks()
"""How a picture looks where no option says so."""


class CommandLine(NamedTuple):
    """A command line as it was read: the engine or drive line if any, the question, the form."""

    loaded: Loaded | None
    question: Any
    form: str

    @property
    def source(self) -> Engine | Chain | None:
        """The engine or drive line."""
        return None if self.loaded is None else self.loaded.source

    @property
    def tree(self) -> Mapping[str, Any] | None:
        """That of its file."""
        return None if self.loaded is None else self.loaded.tree

    def about(self, record: Analysis) -> Loaded | Engine | Chain | None:
        """What an analysis computes of."""
        return self.loaded if record.of_file else self.source


def read_line(record: Analysis, options: dict[str, Any]) -> CommandLine:
    """All of a command line. Raises MessageError with every error of it."""
    fields = asked(record.question.value)
    settings = options.get("settings")
    load = once(partial(_loaded, record, options))

    def source() -> Engine | Chain | None:
        found = load()
        return None if found is None else found.source

    reading = readings(record.question.value, _over_speeds(options, fields), source)
    form, loaded, *values = together(
        partial(_form, record, options, being_read(record.question.value, reading)),
        load,
        *reading.values(),
        *_refusals(record, options, reading, source),
    )
    question = record.question.value(**dict(zip(reading, values, strict=False)))
    line = CommandLine(loaded, question, form)
    if record.marks_speed and isinstance(line.source, Engine):
        mark_speed(options.get("speed"), line.source)
    if isinstance(line.source, Engine) and not getattr(question, "speeds", None):
        point, at = (getattr(question, name, None) for name in ("point", "speed"))
        if point or at is not None:
            mark_load(settings, line.source, point=point or "", speed=at)
    return line


def _refusals(
    record: Analysis,
    options: dict[str, Any],
    reading: Mapping[str, Callable[[], Any]],
    source: Callable[[], Engine | Chain | None],
) -> Iterator[Callable[[], None]]:
    """What refuses values that do not go together, and a file that cannot be written."""
    question = being_read(record.question.value, reading)
    refuse, writes = record.refuse, record.writes
    if options.get("engine") is None:
        of_files = {"--set": options.get("settings"), "--estimate": options.get("estimate")}
        yield partial(refuse_unused, of_files, without="ENGINE")
    if (output := options.get("output")) is not None and not only_printed(record):
        yield partial(writable, output)
    if writes is not None and writes.instead is None and options.get(writes.name) is not None:
        yield partial(_engine_places, writes, options, question)
        if writes.refuse is not None:
            yield partial(writes.refuse.value, question)
    if record.saves is not None and options.get(record.saves.name) is not None:
        yield partial(record.saves.refuse.value, question)
        yield partial(_saved_place, record.saves, options)
    if record.picture is not None:
        yield partial(_refuse_looks, options)
        if suffix_of(options.get("output")) in PICTURES:
            fields = {one.name: one.reader.option for one in asked(record.question.value)}
            unshown = {fields[name]: options.get(name) for name in record.picture.unshown}
            yield partial(refuse_unused, unshown, beside=_("a picture"))
    if refuse is not None:
        yield lambda: refuse.value(cast("Any", source()), question)
    yield lambda: _refuse_of_chain(record, options, source())


def _refuse_looks(options: dict[str, Any]) -> None:
    """Refuse how a picture looks, of a table altogether. Raises RequestError."""
    kind = suffix_of(options.get("output") or "").removeprefix(".")
    looks = options.get("looks", LOOKS)
    if kind not in PICTURES or options.get("json") or options.get("csv"):
        looks.refuse(_("a table"))
        return
    from crankstar.options import charts as chart_request

    if chart_request.charts():
        chart_request.paper(kind, **asdict(looks))


def _saved_place(saves: Saves, options: dict[str, Any]) -> None:
    """Refuse a file of text that cannot be written, or that the document would replace."""
    place, output = options[saves.name], options.get("output")
    if suffix_of(place) != saves.suffix:
        raise refusal(saves.option, place, "the name must end in .{suffix}", suffix=saves.suffix)
    _refuse_same(saves.option, place, output)
    writable(place, option=saves.option)


def _refuse_same(option: str, path: str, output: str | None) -> None:
    """Refuse one file for two things. Raises RequestError."""
    if output is not None and realpath(path) == realpath(output):
        raise refusal(option, path, "it is read or written besides and would be lost; name another")


def _engine_places(writes: Writes, options: dict[str, Any], question: Any) -> None:
    """Refuse files of engines that cannot be written, or that the document would replace."""
    output = None if writes.name == "output" else options.get("output")
    count = 1 if writes.count is None else writes.count.value(question)
    for place in numbered(options[writes.name], count):
        _refuse_same(spelt(writes), place, output)
        engine_suffix(place, option=spelt(writes))


def _refuse_of_chain(
    record: Analysis, options: dict[str, Any], source: Engine | Chain | None
) -> None:
    """Refuse what a drive line without cylinders cannot be asked. Raises RequestError."""
    if isinstance(source, Chain):
        fields = asked(record.question.value)
        others = [one for one in fields if one.name not in record.chains]
        unused = {one.reader.option: options.get(one.name) for one in others}
        unused["--estimate"] = options.get("estimate")
        refuse_unused(unused, beside=_("a drive line without cylinders"))


def _forms(record: Analysis) -> tuple[str, ...]:
    """The forms in which an analysis is written."""
    return TABLES if record.picture is None else (*TABLES, *PICTURES)


def _loaded(record: Analysis, options: dict[str, Any]) -> Loaded | None:
    """What is named, if anything. Raises MessageError where it lacks what is computed with."""
    name, settings = options.get("engine"), options.get("settings")
    estimate = bool(options.get("estimate"))
    if name is None:
        return None
    chains, ranged = bool(record.chains), record.ranged
    found = read_engine(
        name, settings, estimate=estimate, speed=options.get("speed"), chains=chains, ranged=ranged
    )
    if record.needs is not None and isinstance(found.source, Engine):
        record.needs.value(found.source)
    return found


def _over_speeds(options: dict[str, Any], fields: Sequence[Asked]) -> dict[str, Any]:
    """The options; a range that is given as one speed is one of speeds, where those are asked."""
    speed = options.get("speed")
    ranged = speed is not None and ".." in speed and options.get("speeds") is None
    if ranged and any(one.name == "speeds" for one in fields):
        return {**options, "speed": None, "speeds": speed}
    return options


def _form(record: Analysis, options: dict[str, Any], question: Any) -> str:
    """The form of what is written. Raises RequestError."""
    flags = {name: bool(options.get(name)) for name in ("json", "csv")}
    output = None if only_printed(record) else options.get("output")
    for_engine = "" if record.writes is None else instead(record.writes, question)
    if for_engine:
        refuse_unused({f"--{name}": given for name, given in flags.items()}, beside=for_engine)
        return form_of(output, ENGINES)
    return form_of(output, _forms(record), **flags)


def only_printed(record: Analysis) -> bool:
    """Whether -o names the engine that it makes, and not its document."""
    writes = record.writes
    return writes is not None and writes.name == "output" and writes.instead is None


def instead(writes: Writes, question: Any) -> str:
    """The option for which an engine is given in place of the document."""
    return "" if writes.instead is None else writes.instead.value(question)


def spelt(writes: Writes) -> str:
    """The option of a file as it is named in a refusal."""
    return "-o" if writes.option == "--output" else writes.option
