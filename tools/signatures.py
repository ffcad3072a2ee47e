"""The types of the public functions, for editors and type checkers.

`python tools/signatures.py` writes the stubs anew: of the analyses from the questions of all of the
package, of the others from what is read of their arguments. A test compares them.
"""

from __future__ import annotations

import ast
import builtins
import re
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import MISSING
from inspect import Parameter, cleandoc, formatannotation, getsource, signature
from pathlib import Path
from textwrap import indent
from types import ModuleType
from typing import Any, get_type_hints

from crankstar.analysis.reader import Asked
from crankstar.analysis.record import Analysis
from crankstar.analysis.registry import NAMES, analysis
from crankstar.options import arguments, sources
from crankstar.options.vocabulary import OPTIONS
from crankstar.python import public
from crankstar.python.functions import arguments_of, function

FOLDER = Path(__file__).resolve().parents[1] / "src" / "crankstar" / "python"
STUB, PUBLIC = FOLDER / "analyses.pyi", FOLDER / "public.pyi"
HEAD = '''"""The functions of the analyses; made by tools/signatures.py."""

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, Literal

from crankstar.mechanics.excitation import Reference
from crankstar.options.sources import EngineLike
from crankstar.python.results import Result
'''


def stub() -> str:
    """The text of the stub."""
    records = [analysis(name) for name in sorted(NAMES)]
    return "\n\n".join([HEAD.rstrip(), *map(_function, records)]) + "\n"


def _function(record: Analysis) -> str:
    fields = arguments_of(record)
    hints = get_type_hints(record.question.value)
    follow = [
        f"{one.name}: {_taken(one, hints[one.name])}"
        + ("" if one.default is MISSING else f" = {one.default!r}")
        for one in fields
        if _follows(one)
    ]
    named = [
        f"{one.name}: {_taken(one, hints[one.name])} = {one.default!r}"
        for one in fields
        if not _follows(one)
    ]
    first: list[str] = []
    if record.engine != "none":
        first = ["engine: EngineLike" + " | None = None" * (record.engine == "optional"), "/"]
        named += ["changes: Mapping[str, Any] | None = None"]
        named += ["estimate: bool = False"] if record.estimates else []
    arguments = [*first, *follow, "*", *named]
    body = indent(f'"""{_doc(record)}\n"""', "    ")
    listed = "".join(f"    {each},\n" for each in arguments)
    return f"def {record.name}(\n{listed}) -> Result:\n{body}"


def _follows(one: Asked) -> bool:
    return one.default is MISSING or one.reader.follows


def _doc(record: Analysis) -> str:
    """What the function and its arguments are, without the example."""
    text = (function(record.name).__doc__ or "").partition("\n>>>")[0].rstrip()
    return "\n".join(_folded(text)).replace("\\", "\\\\")


def _folded(text: str, width: int = 92) -> Iterator[str]:
    """Its lines, long ones folded below their beginning."""
    for line in text.splitlines():
        margin = len(line) - len(line.lstrip())
        row = ""
        for word in line.split():
            longer = f"{row} {word}" if row else " " * margin + word
            if len(longer) > width:
                yield row
                longer = " " * (margin + 4 * (margin > 0)) + word
            row = longer
        yield row


def _taken(one: Asked, hint: Any) -> str:
    """What an argument may be: its value in SI units, or text as on the command line."""
    takes = "text" if one.reader.follows else OPTIONS[one.reader.option].takes
    if takes == "nothing":
        return "bool"
    kind = re.sub(r"Union\[(.*)\]$", lambda found: _parts(found[1]), formatannotation(hint))
    kind = kind.replace("collections.abc.", "").replace("typing.", "")
    kind = kind.replace("Sequence[", "Iterable[")
    if takes == "several texts":
        kind = "Iterable[str] | Mapping[Any, Any]" + " | None" * ("None" in kind)
    elif "lists.Listed" in kind:  # a file, a data frame, rows by heading
        return "Any"
    elif "excitation.Reference" in kind:
        return "Reference | float | str | None"
    elif "Measured" in kind:  # what a balancing machine shows
        kind = "str | None" if "None" in kind else "str"
    elif "crankstar." in kind:  # a record of its own, which is given as text or in a file
        kind = "Path | None" if "None" in kind else "Path"
    elif one.name == "orders":
        kind = kind.replace("str", "Iterable[float]")
    more = [] if takes == "whole number" else ["str"]
    parts = [*kind.split(" | "), *more]
    parts = [*dict.fromkeys("None" if each == "NoneType" else each for each in parts)]
    return " | ".join([*(each for each in parts if each != "None"), *["None"][: "None" in parts]])


def _parts(text: str) -> str:
    """What stands between the commas of a union, those in brackets apart."""
    return re.sub(r", (?![^\[]*\])", " | ", text)


def public_stub() -> str:
    """The text of the stub of the functions that are no analysis."""
    imports: dict[str, str] = {}
    functions: list[str] = []
    for name in sorted(each for names in public.HOMES.values() for each in names):
        made = getattr(public, name)
        asked = signature(made)
        known = _names_of(sys.modules[made.__module__]) | _names_of(sources) | _names_of(arguments)
        types = [each.annotation for each in asked.parameters.values()] + [asked.return_annotation]
        for word in re.findall(r"[A-Za-z_]\w*", re.sub(r"'[^']*'", "", " ".join(types))):
            if not hasattr(builtins, word):
                imports.setdefault(word, known[word])
        listed = ", ".join(_arguments([*asked.parameters.values()]))
        doc = cleandoc(made.__doc__ or "").partition("\n>>>")[0].rstrip().replace("\\", "\\\\")
        body = indent(f'"""{doc}\n"""', "    ")
        functions.append(f"def {name}({listed}) -> {asked.return_annotation}:\n{body}")
    head = '"""The functions that are no analysis; made by tools/signatures.py."""'
    own = "HOMES: dict[str, tuple[str, ...]]\nNAMES: set[str]"
    return "\n\n".join([head, *_imported(imports), own, *functions]) + "\n"


def _imported(names: dict[str, str]) -> Iterator[str]:
    """The lines that import names from their modules: of Python, of the package."""
    lines = {
        module: f"from {module} import " + ", ".join(sorted(n for n in names if names[n] == module))
        for module in sorted({*names.values()})
    }
    own = {module for module in lines if module.startswith("crankstar.")}
    yield "\n".join(line for module, line in lines.items() if module not in own)
    yield "\n".join(line for module, line in lines.items() if module in own)


def _arguments(parameters: list[Parameter]) -> Iterator[str]:
    """The arguments of a function, as source text."""
    named = False
    for place, each in enumerate(parameters):
        if each.kind is Parameter.KEYWORD_ONLY and not named:
            before = parameters[place - 1].kind if place else None
            named = True
            if before is not Parameter.VAR_POSITIONAL:
                yield "*"
        stars = {Parameter.VAR_POSITIONAL: "*", Parameter.VAR_KEYWORD: "**"}.get(each.kind, "")
        default = "" if each.default is Parameter.empty else f" = {each.default!r}"
        yield f"{stars}{each.name}: {each.annotation}{default}"
        after = parameters[place + 1].kind if place + 1 < len(parameters) else None
        if each.kind is Parameter.POSITIONAL_ONLY is not after:
            yield "/"


def _names_of(module: ModuleType) -> dict[str, str]:
    """The module of each name that a module imports, those for type checkers too, or defines."""
    out = dict.fromkeys(vars(module), module.__name__)
    for node in ast.walk(ast.parse(getsource(module))):
        if isinstance(node, ast.ImportFrom):
            out |= {each.asname or each.name: node.module or "" for each in node.names}
    return out


def formatted(text: str) -> str:
    """The stub as ruff writes it."""
    words = ("format", "--quiet", "--stdin-filename", str(STUB), "-")
    ruff = Path(sys.executable).parent / "ruff"
    done = subprocess.run(  # its own text
        [ruff, *words], input=text, capture_output=True, text=True, encoding="utf-8", check=True
    )
    return done.stdout


if __name__ == "__main__":
    STUB.write_text(formatted(stub()), encoding="utf-8")
    PUBLIC.write_text(formatted(public_stub()), encoding="utf-8")
