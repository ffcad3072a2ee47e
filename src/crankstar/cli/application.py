"""The application: how a command line is read, and how the process ends whatever happens."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from importlib.metadata import version

from cyclopts import App, CycloptsError, UnusedCliTokensError

from crankstar.files import STANDARD_INPUT, EngineFileError
from crankstar.output import OutputError, abandon, complain
from crankstar.quantity import one_line, seen
from crankstar.request import NEEDED, RequestError

app = App(
    name="crankstar",
    help="How a piston engine shakes, why, and what to do about it. ENGINE is a name from the catalog or a file in TOML or "
    "JSON; - reads standard input.",
    version=lambda: version("crankstar"),
    help_format="plaintext",
    result_action="return_value",
    suppress_keyboard_interrupt=False,
)
app.register_install_completion_command(help="Install completion of commands and options for this shell.")


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line and leave the process: 0 done, 2 a bad request or file, 130 interrupted."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="replace")  # pyright: ignore[reportAttributeAccessIssue]
    try:
        code = app(_spelt_out(sys.argv[1:] if arguments is None else arguments), exit_on_error=False, print_error=False) or 0
        if sys.stdout is not None:
            sys.stdout.flush()
    except CycloptsError as error:
        code = _refuse(_told(error))
    except (RequestError, OutputError, EngineFileError) as error:
        code = _refuse(str(error))
    except (BrokenPipeError, SystemExit):  # the latter is how rich says it
        code = 0  # the reader of the pipe has what it wanted
    except OSError as error:
        place = "standard output, or a temporary file (TMPDIR)" if error.filename is None else one_line(str(error.filename))
        code = _refuse(f"{place}: cannot be written ({error.strerror or error}); make room, or name another file with -o")
    except MemoryError:
        code = _refuse("there is not enough memory for this engine; take fewer cylinders, or longer rods")
    except KeyboardInterrupt:
        code = 130
    abandon()
    sys.exit(code)


def _spelt_out(arguments: Sequence[str]) -> list[str]:
    """Arguments with the lone hyphen as a file name, which the parser would take for an option, and --shafts with its meaning."""
    pairs = zip(["", *arguments], arguments, strict=False)
    named = {"-o": "/dev/stdout", "--output": "/dev/stdout"}
    words = [named.get(before, STANDARD_INPUT) if word == "-" else word for before, word in pairs]
    for place in [place for place, word in enumerate(words) if word == "--shafts"][:1]:
        following = words[place + 1] if place + 1 < len(words) else "-o"
        if following.startswith("-") and not following[1:2].isdigit():
            words.insert(place + 1, NEEDED)
    return words


def _told(error: CycloptsError) -> str:
    """What is wrong with the words of a command line, and where to read on."""
    text = one_line(str(error).strip(), longest=300)
    text = text.replace("into int", "into a whole number").replace("into bool", "into yes or no")
    if isinstance(error, UnusedCliTokensError):
        text = f"too many arguments: {', '.join(map(seen, error.unused_tokens or ()))}"
    command = " ".join(["crankstar", *(error.command_chain or ())])
    return f"{text}\nSee: {command} --help"


def _refuse(message: str) -> int:
    complain(f"crankstar: {message}")
    return 2
