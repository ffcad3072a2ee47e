"""The command line: verbs only. Every verb reads engines, asks a function, prints what it gives.

| module | one line |
|---|---|
| `looking`, `picturing`, `showing`, `serving` | verbs to look, draw, show on a page, serve the page |
| `firing`, `making`, `reporting`, `searching` | verbs to list what can fire, make or judge files, report, search |
| `options` | options that several verbs share |
| `application` | how a command line is read, and how the process ends |
"""

from crankstar.cli import firing, looking, making, options, picturing, reporting, searching, serving, showing
from crankstar.cli.application import app, main

__all__ = ["app", "firing", "looking", "main", "making", "options", "picturing", "reporting", "searching", "serving", "showing"]
