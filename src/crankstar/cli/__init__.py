"""The command line: verbs only. Every verb reads engines, asks a function, prints the result.

| module, bottom to top | one line |
|---|---|
| `help` | the help in the reader's language |
| `system_language` | the language of the system |
| `complaints` | what is wrong with a command line |
| `output` | where results go: terminal, pipe or file |
| `options` | options that several verbs share |
| `tabulating` | a Document as tables, JSON, CSV, a spreadsheet or Parquet |
| `speed_ranges` | what `analyze --speeds` prints |
| `inspect` | list, show, analyze, compare, verdict, strokes |
| `command_lines` | the command line of an analysis as it is read |
| `analyses` | the verbs of all analyses that are records |
| `estimating` | estimate |
| `deriving` | derive, errata |
| `search_options` | the options of search |
| `checkpoints` | the file in which a search is kept, and what of it is damaged |
| `search_job` | a search run, reported and kept in a file |
| `sequencing` | search, where star and firing order are searched together |
| `searching` | search |
| `balancing` | balance |
| `picturing` | plot |
| `drawing` | draw, animate |
| `sounding` | sound |
| `sweeping` | sweep |
| `showing` | page |
| `siting` | site |
| `reporting` | report |
| `serving` | serve |
| `exporting` | export |
| `files` | check, new, schema |
| `words` | the words of a command line before they are parsed |
| `application` | how a command line is read, the verbs by name, how the process ends |
"""

from crankstar.cli.application import app, main

__all__ = ["app", "main"]
