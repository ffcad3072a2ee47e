"""The command line: verbs only. Every verb reads engines, asks a function, prints what it gives.

| module | one line |
|---|---|
| `looking`, `picturing`, `making`, `searching` | the verbs: to look, to draw, to make or judge files, to search |
| `options` | options that several verbs share |
| `application` | how a command line is read, and how the process ends |
"""

from crankstar.cli import looking, making, options, picturing, searching
from crankstar.cli.application import app, main

__all__ = ["app", "looking", "main", "making", "options", "picturing", "searching"]
