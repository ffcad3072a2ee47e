"""The options that several verbs share, with their help, and the engine that they name.

An option means the same in every verb. `flag` and `text` are the two kinds that need no more than
a sentence of help.
"""

from __future__ import annotations

import shlex
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Annotated, Any

from cyclopts import Parameter, Token

from crankstar.engine.engine import Engine
from crankstar.files import EngineFileError, changed
from crankstar.files.catalog import load, tree_of
from crankstar.language.quoting import seen
from crankstar.options import values as request
from crankstar.options.values import RequestError


def flag(sentence: str) -> Parameter:
    """A switch without a `--no-` form."""
    return Parameter(help=sentence, negative=())


def text(sentence: str, *names: str) -> Parameter:
    """A value that may begin with a minus sign."""
    return Parameter(name=names or None, help=sentence, allow_leading_hyphen=True)


def whole_number(sentence: str) -> Parameter:
    """A whole number; the parser itself would round 1.5."""
    return Parameter(help=sentence, converter=_whole)


def _whole(_kind: object, tokens: Sequence[Token]) -> int:
    try:
        return int(tokens[0].value)
    except ValueError:
        raise ValueError(f"unable to convert {seen(tokens[0].value)} into int") from None


def output(sentence: str) -> Parameter:
    """The file to write."""
    return Parameter(name=["--output", "-o"], help=sentence)


ENGINE = "Name from the catalog, engine file, or - for standard input."
ORDER_NAMES = ("--orders", "--order")
FLAT = Parameter(name="*", negative=(), allow_leading_hyphen=True, show_default=False)
"""A record of options, each of which is an option of the verb."""

EngineName = Annotated[str, Parameter(help=ENGINE)]
Speed = Annotated[
    str | None, text('Crank speed, such as "6000 rpm" (default: the speed in the file).', "--speed")
]
Orders = Annotated[
    str | None,
    text(
        "Crank orders, such as 1,2,4,6, or all (default: those up to 6 that occur).", *ORDER_NAMES
    ),
]
ReferencePoint = Annotated[
    str | None,
    text(
        'Point about which couples and roll are taken: z, or z, up and right, such as "-120 mm" or '
        '"0 mm, 35 mm, 0 mm", with z as in `crankstar show` (default: the middle of the cylinders, '
        "on the crank axis).",
        "--reference",
    ),
]
Theta = Annotated[
    str | None,
    text('Also the sum of all orders at these crank angles, such as "0 deg, 90 deg".', "--theta"),
]
Output = Annotated[str | None, output("File to write (default: standard output).")]
Settings = Annotated[
    list[str] | None,
    Parameter(
        name="--set",
        help='Change a value of the file, such as layout.bore_pitch="100 mm"; repeatable.',
        negative=(),
    ),
]
Json = Annotated[bool, flag("Print JSON.")]
Csv = Annotated[bool, flag("Print CSV.")]


def together(*readings: Callable[[], Any]) -> tuple[Any, ...]:
    """What each of them reads. Raises RequestError with the message of every one that fails."""
    values: list[Any] = []
    messages: dict[str, None] = {}
    for reading in readings:
        try:
            values.append(reading())
        except (RequestError, EngineFileError) as error:
            messages[str(error)] = None
    if messages:
        raise RequestError("\n".join(messages))
    return tuple(values)


def engine_and_speed(
    name: str, settings: list[str] | None, speed: str | None
) -> tuple[Engine, float | None]:
    """The engine of a name or file with the values of --set, and the speed of --speed [rad/s]."""
    engine, turning = together(
        partial(loaded_engine, name, settings), partial(request.speed, speed)
    )
    return engine, turning


def loaded_engine(name: str, settings: list[str] | None) -> Engine:
    """The engine of a name or file, with the values of --set."""
    return load(name, changes=request.settings(settings))


def changed_tree(name: str, settings: Sequence[str] | None) -> tuple[str, dict[str, Any]]:
    """The name of an engine and the tree of its file, with the values of --set."""
    shown, tree = tree_of(name)
    return shown, changed(tree, request.settings(settings), name=shown)


def command_text(verb: str, engine: str, options: Mapping[str, Sequence[str] | None]) -> str:
    """A command line: each option with each of its values."""
    pairs = [(option, value) for option, values in options.items() for value in values or ()]
    return shlex.join(["crankstar", verb, engine, *(word for pair in pairs for word in pair)])


def engine_text(engine: Engine) -> str:
    """An engine file in the explicit form, never written where it could not be read again."""
    from crankstar.files import engine_of, toml, tree_of

    content = toml(engine)
    engine_of(tree_of(content))
    return content
