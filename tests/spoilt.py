"""Good engine files spoilt at random: lost keys, odd values, factors of 1000, typing slips."""

from __future__ import annotations

import copy
import datetime
import random
import tomllib
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from tests.texts import EXPLICIT, SHORT

import crankstar
from crankstar.files import engine_of, explicit
from crankstar.files.catalog import path_of
from crankstar.files.starters import STARTERS

TEXTS = [path.read_text(encoding="utf-8") for name in crankstar.names() if (path := path_of(name))]
TEXTS += [*STARTERS.values(), SHORT, EXPLICIT]
SHORT_TREES = [tomllib.loads(text) for text in TEXTS]
TREES = SHORT_TREES + [explicit(engine_of(tree)) for tree in SHORT_TREES]

NUMBERS: list[Any] = [
    0,
    1,
    -1,
    2,
    0.0,
    -0.0,
    1e-300,
    1e300,
    float("nan"),
    float("inf"),
    -float("inf"),
    10**30,
    10**400,
    3.5,
]
WORDS = [
    "",
    " ",
    "x",
    "1 mm",
    "-1 mm",
    "0 mm",
    "nan mm",
    "1e400 mm",
    "90 deg",
    "650 g",
    "6000 rpm",
    "1/0",
    "29/31",
    "-1",
    "vee",
]
WORDS += ["\x1b[31m", "\u202e", "a" * 300, "\ud800", "bank 1", "crank"]
OTHERS: list[Any] = [
    None,
    True,
    False,
    [],
    {},
    [[]],
    [{}],
    {"a": 1},
    [1, 2],
    ["x"],
    datetime.date(2020, 1, 1),
    (1, 2),
    b"x",
    1 + 2j,
]
ODD = [*NUMBERS, *WORDS, *OTHERS]

Box = Any
"""A table or a list of a tree."""


def places(tree: Box) -> list[tuple[Box, Any]]:
    """Every key of every table and index of every list, each with its table or list."""
    pairs = (
        tree.items()
        if isinstance(tree, dict)
        else enumerate(tree)
        if isinstance(tree, list)
        else ()
    )
    return [place for key, value in pairs for place in ((tree, key), *places(value))]


def delete(box: Box, key: Any, _: random.Random) -> None:
    del box[key]


def replace(box: Box, key: Any, chance: random.Random) -> None:
    box[key] = copy.deepcopy(chance.choice(ODD))


def scale(box: Box, key: Any, chance: random.Random) -> None:
    value, factor = box[key], 10.0 ** chance.choice([-9, -6, -4, -3, -2, -1, 1, 2, 3, 4, 6, 9, 12])
    if isinstance(value, str):
        number, _, unit = value.partition(" ")
        box[key] = f"{float(number) * factor:g} {unit}"
    else:
        box[key] = value * (
            chance.choice([-1, 0, 2, 10, 1000]) if isinstance(value, int) else factor
        )


def duplicate(box: Box, key: Any, _: random.Random) -> None:
    if isinstance(box, list):
        box.insert(key, copy.deepcopy(box[key]))
    else:
        box[f"{key}s"] = copy.deepcopy(box[key])


def rename(box: Box, key: Any, chance: random.Random) -> None:
    box[f"{key}{chance.choice(['s', '_', 'x'])}"] = box[key]
    del box[key]


def shift(box: Box, key: Any, chance: random.Random) -> None:
    box[key] += chance.choice([-1, 1, 0.5])


def shuffle(box: Box, key: Any, chance: random.Random) -> None:
    chance.shuffle(box[key])


def misspell(box: Box, key: Any, chance: random.Random) -> None:
    at = chance.randrange(len(box[key]))
    box[key] = box[key][:at] + chance.choice("0-+e. mxdegk\x00") + box[key][at + 1 :]


Mutation = Callable[[Box, Any, random.Random], None]
MUTATIONS: list[Mutation] = [
    delete,
    replace,
    scale,
    scale,
    duplicate,
    rename,
    shift,
    shuffle,
    misspell,
]


def mutated(tree: dict[str, Any], chance: random.Random) -> dict[str, Any]:
    """A copy of a tree with one to six things changed."""
    out = copy.deepcopy(tree)
    for _ in range(chance.choice([1, 1, 1, 2, 3, 6])):
        there = places(out)
        if there:
            box, key = chance.choice(there)
            with suppress(
                TypeError, ValueError, OverflowError, AttributeError, KeyError
            ):  # not all changes go with all values
                chance.choice(MUTATIONS)(box, key, chance)
    return out
