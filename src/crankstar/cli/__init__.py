"""The command line: verbs only. Every verb reads engines, asks a function, prints what it gives.

| module | one line |
|---|---|
| `looking`, `picturing`, `making` | the verbs: those that only look, that draw, that make or judge files |
| `options` | options that several verbs share |
| `application` | how a command line is read, and how the process ends |
"""

from crankstar.cli import looking, making, options, picturing
from crankstar.cli.application import app, main

__all__ = ["app", "looking", "main", "making", "options", "picturing"]
