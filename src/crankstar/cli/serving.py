"""The verb that serves: serve; and the gallery, which opens where no verb is named."""

from __future__ import annotations

import os
import sys
from functools import partial
from pathlib import Path
from types import ModuleType
from typing import Annotated, Any

from cyclopts import Parameter

from crankstar.cli.options import Estimating, Settings, beside, command_text, option, read_engine
from crankstar.cli.output import complain, working
from crankstar.files.catalog import path_of
from crankstar.files.read_files import STANDARD_INPUT
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.forms import named
from crankstar.options.values import RequestError

GREATEST_PORT = 65535
USUAL_PORT = 8000
USUAL_ENGINE = "v8-cross-plane"
LOCAL = "127.0.0.1"


def serve(
    engine: Annotated[
        str, Parameter(help="Engine to open: name from the catalog, or file.")
    ] = USUAL_ENGINE,
    /,
    *,
    host: Annotated[str, option("--host")] = LOCAL,
    port: Annotated[int, option("--port")] = USUAL_PORT,
    open_: Annotated[bool, option("--open")] = False,
    settings: Settings = None,
    estimate: Estimating = False,
) -> None:
    """Serve the page on this machine; an engine file is watched, and edits are computed at once."""

    def read() -> dict[str, Any]:
        return read_engine(engine, settings, estimate=estimate).tree

    with working(_("Starting ...")):
        number = beside(partial(request.within, "--port", port, least=0, most=GREATEST_PORT), read)
        running = _server()
        tree = read()
        taken = running.opened(host, number or 0)
    address = running.address_of(taken, host)
    watched = None
    if path_of(engine) is None and engine != STANDARD_INPUT:
        from crankstar.server.watching import Watched

        watched = Watched(Path(engine), tree, read)

    def ready() -> None:
        _said(address)
        if watched is not None:
            complain(
                _("The page follows {file}: save it, and it is drawn anew.", file=watched.path.name)
            )
        if not running.is_loopback(host):
            complain(_("There is no password: anyone who can reach this machine can use it."))
        if open_:
            _open(address)

    shown = named(engine)
    flags = {"--estimate": [""] if estimate else None}
    command = command_text("serve", shown, {"--set": settings, **flags})
    with taken:
        running.serve(
            taken, host=host, opening=(tree, shown, command), ready=ready, watched=watched
        )


def gallery_wanted() -> bool:
    """Whether a bare `crankstar` may open a browser: in a terminal, on a desktop, with a server."""
    if any(stream is None or not stream.isatty() for stream in (sys.stdin, sys.stdout, sys.stderr)):
        return False
    if os.environ.get("CI") or os.environ.get("TERM") == "dumb":
        return False
    if not _desktop():
        return False
    from importlib.util import find_spec

    return all(find_spec(name) is not None for name in ("fastapi", "uvicorn", "PIL", "vl_convert"))


def gallery() -> None:
    """Serve the catalog as pictures on this machine, and open it in the browser."""
    with working(_("Starting ...")):
        running = _server()
        try:
            taken = running.opened(LOCAL, USUAL_PORT)
        except RequestError:  # another server is there
            taken = running.opened(LOCAL, 0)
    address = running.address_of(taken, LOCAL)

    def ready() -> None:
        _said(f"{address}gallery")
        complain(_("crankstar --help lists the commands."))
        _open(f"{address}gallery")

    opening = (USUAL_ENGINE, USUAL_ENGINE, f"crankstar serve {USUAL_ENGINE}")
    with taken:
        running.serve(taken, host=LOCAL, opening=opening, ready=ready)


def _server() -> ModuleType:
    """The server that runs. Raises RequestError where its libraries are not installed."""
    try:
        from crankstar.server import running
    except ImportError as error:
        raise RequestError(
            "the server needs FastAPI and uvicorn ({reason}); install them with "
            'pip install "crankstar[server]"',
            reason=error,
        ) from None
    return running


def _desktop() -> bool:
    """Whether there is a browser with a window; one in the terminal would take it over."""
    if sys.platform in ("darwin", "win32"):
        return True
    screens = ("BROWSER", "DISPLAY", "WAYLAND_DISPLAY", "WSL_DISTRO_NAME")
    if not any(os.environ.get(name) for name in screens):
        return False
    import webbrowser

    try:
        webbrowser.get()
    except webbrowser.Error:
        return False
    return True


def _said(address: str) -> None:
    complain(
        _(
            "crankstar: serving at {address}\nOpen it in a browser; Ctrl-C stops the server.",
            address=address,
        )
    )


def _open(address: str) -> None:
    import webbrowser

    webbrowser.open(address)
