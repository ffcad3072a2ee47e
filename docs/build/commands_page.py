"""Every command, argument and option, from the records of which the program makes its help."""

from __future__ import annotations

from typing import Any

from crankstar.cli import app


def page() -> str:
    """A section per command: what it does, how it is called, a table of its options."""
    return "\n\n".join(section(name) for name in sorted(app) if not name.startswith("-"))


def section(name: str) -> str:
    """One command."""
    command = app[name]
    arguments = [
        argument for argument in command.assemble_argument_collection() if argument.names[0] != "*"
    ]
    options = [argument for argument in arguments if argument.names[0].startswith("-")]
    places = [argument for argument in arguments if not argument.names[0].startswith("-")]
    words = " ".join((command.help or "").split())
    call = " ".join(["crankstar", name, *map(_place, places), *(["[OPTIONS]"] if options else [])])
    rows = [
        f"| {', '.join(f'`{one}`' for one in argument.names)} | {_meaning(argument)} |"
        for argument in (*places, *options)
    ]
    lines = [f"## {name}", "", words, "", "```text", call, "```"]
    if rows:
        lines += ["", "| argument | meaning |", "|---|---|", *rows]
    return "\n".join(lines)


def _place(argument: Any) -> str:
    name = argument.names[0]
    return name if argument.required else f"[{name}]"


def _meaning(argument: Any) -> str:
    words = " ".join((argument.parameter.help or "").split()).replace("|", "\\|")
    return words.replace("<", "&lt;") or "-"
