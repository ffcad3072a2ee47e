"""The verb that serves: serve."""

from __future__ import annotations

import re
import shlex
from typing import Annotated

from cyclopts import Parameter

from crankstar.catalog import tree_of
from crankstar.cli.application import app
from crankstar.cli.options import Settings
from crankstar.files import changed, engine_of
from crankstar.output import complain, working
from crankstar.quantity import one_line
from crankstar.request import RequestError, named, setting

GREATEST_PORT = 65535


@app.command
def serve(
    engine: Annotated[str, Parameter(help="what the page opens with: a name from the catalog, or a file")] = "v8-cross-plane",
    /,
    *,
    host: Annotated[str, Parameter(help="address to listen at; others than 127.0.0.1 let other machines in")] = "127.0.0.1",
    port: Annotated[str, Parameter(help="port to listen at; 0 takes a free one")] = "8000",
    open_: Annotated[bool, Parameter(name="--open", help="open the page in the browser", negative=())] = False,
    settings: Settings = None,
) -> None:
    """Serve the page on this machine: engines edited live, analysed at every change."""
    if not re.fullmatch(r"\d{1,5}", port, re.ASCII) or int(port) > GREATEST_PORT:
        raise RequestError(f"--port {one_line(port)}: give a number from 0 to {GREATEST_PORT}, as in --port 8000")
    with working("starting ..."):
        try:
            from crankstar.server import running
        except ImportError as error:
            told = f'the server needs FastAPI and uvicorn ({error}); install them with: pip install "crankstar[server]"'
            raise RequestError(told) from None
        name, tree = tree_of(engine)
        tree = changed(tree, dict(setting(text) for text in settings or []), name=name)
        engine_of(tree, name=name)
        taken = running.opened(host, int(port))
    address = running.address_of(taken, host)

    def ready() -> None:
        complain(f"crankstar: serving at {address}\nOpen it in a browser; Ctrl-C ends it.")
        if not running.is_loopback(host):
            complain("Whoever can reach this machine can use it: it has no password.")
        if open_:
            import webbrowser

            webbrowser.open(address)

    shown = named(engine)
    words = [word for text in settings or () for word in ("--set", text)]
    command = shlex.join(["crankstar", "serve", shown, *words])
    with taken:
        running.serve(taken, host=host, opening=(tree, shown, command), ready=ready)
