"""Every option of every command is drawn from one vocabulary: one name, one value, one meaning."""

from __future__ import annotations

import re
from collections import Counter
from functools import cache
from typing import Any, Literal, get_args, get_origin

import pytest
from cyclopts import Argument
from tests.rules import test_docs as docs

from crankstar import cli
from crankstar.options.names import field_name, meant
from crankstar.options.vocabulary import OPTIONS

pytestmark = pytest.mark.quick

COMMANDS = sorted(name for name in cli.app if not name.startswith("-"))
BUILT_IN = {"--help", "--version"}


@cache
def options(command: str) -> dict[str, Argument]:
    """The options of a command by their first name."""
    arguments = cli.app[command].assemble_argument_collection()
    named = {
        name: argument
        for argument in arguments
        for name in argument.names
        if name.startswith("--") and argument.field_info.kind is not None and argument.parse
    }
    return {name: argument for name, argument in named.items() if name not in BUILT_IN}


def takes(annotation: Any) -> str:
    """What follows an option whose value has this type."""
    if get_origin(annotation) in (list, tuple):
        return "several texts"
    kinds = {annotation, *get_args(annotation)} - {type(None)}
    if any(get_origin(kind) is list for kind in kinds):
        return "several texts"
    if bool in kinds:
        return "nothing"
    if float in kinds:
        return "number"
    if int in kinds:
        return "whole number"
    assert str in kinds or any(get_origin(kind) is Literal for kind in kinds), annotation
    return "text"


@pytest.mark.parametrize("command", COMMANDS)
def test_every_option_of_a_command_takes_and_means_what_the_vocabulary_says(command: str) -> None:
    for name, argument in options(command).items():
        assert name in OPTIONS, f"{name} of {command}: add it to crankstar.options.vocabulary"
        assert takes(argument.hint) == OPTIONS[name].takes, (command, name)
        assert (argument.parameter.help or "").startswith(OPTIONS[name].meaning), (command, name)


@pytest.mark.parametrize("command", COMMANDS)
def test_an_option_has_one_long_name(command: str) -> None:
    arguments = cli.app[command].assemble_argument_collection()
    several = [a.names for a in arguments if sum(name.startswith("--") for name in a.names) > 1]
    assert several == []


def test_the_vocabulary_has_the_options_of_the_commands_and_no_other() -> None:
    assert set(OPTIONS) == {name for command in COMMANDS for name in options(command)}
    assert list(OPTIONS) == sorted(OPTIONS)


def test_an_option_has_one_meaning_and_a_name_that_nothing_else_has() -> None:
    meanings = Counter(option.meaning for option in OPTIONS.values())
    assert max(meanings.values()) == 1
    also = Counter(name for option in OPTIONS.values() for name in option.also)
    assert {name for name, count in also.items() if count > 1 or name in OPTIONS} == set()


@pytest.mark.parametrize("command", COMMANDS)
def test_every_other_name_of_an_option_suggests_it(command: str) -> None:
    offered = sorted(options(command))
    for option in offered:
        assert [meant(name, offered) for name in OPTIONS[option].also] == [option] * len(
            OPTIONS[option].also
        )


@pytest.mark.parametrize(
    ("line", "suggested"),
    [
        ("analyze i4 --order 1", "--orders"),
        ("analyze i4 --rpm 6000", "--speed"),
        ("sweep i4 --over balance_factor=0..1 --watch force", "--quantity"),
        ("search 7 --pitch 1,1,1,1,1,1", "--gaps"),
        ("vees 6 --two-stroke", "--cycle"),
        ("balance i4 --minimize couple", "--minimise"),
        ("balance i4 --minimize=couple", "--minimise"),
    ],
)
def test_a_deleted_or_usual_name_is_refused_with_the_right_one(
    line: str, suggested: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        cli.main(line.split())
    said = capsys.readouterr()
    assert (ended.value.code, said.out) == (2, "")
    assert f"Did you mean {suggested}?" in said.err


def test_the_page_of_the_command_line_has_every_option_with_its_commands() -> None:
    page = docs.hooks.filled(docs.text_of("docs/reference/command-line.md"))
    rows = re.findall(r"^\| `(--[\w-]+)` \| ([\w ]+) \| (.+) \| (.+) \|$", page, re.MULTILINE)
    assert [row[0] for row in rows] == sorted(OPTIONS)
    for name, kind, meaning, commands in rows:
        assert (kind, meaning.replace("\\|", "|")) == OPTIONS[name][:2]
        assert re.findall(r"`(\w+)`", commands) == [c for c in COMMANDS if name in options(c)]


def test_the_dialogs_of_the_server_use_the_names_of_the_options() -> None:
    from crankstar.options.balancing import BalanceOptions
    from crankstar.options.words import SearchWords

    named = {field_name(name) for name in OPTIONS}
    assert {*SearchWords.model_fields, *BalanceOptions.model_fields} <= named
