"""The verb that serves: serve."""

from __future__ import annotations

import re
import shlex
from typing import Annotated

from cyclopts import Parameter

from crankstar.cli.application import app
from crankstar.cli.options import Settings
from crankstar.cli.output import complain, working
from crankstar.files import changed, engine_of
from crankstar.files.catalog import tree_of
from crankstar.language.messages import _
from crankstar.language.quoting import one_line
from crankstar.options.values import RequestError, named, setting

GREATEST_PORT = 65535


@app.command
def serve(
    engine: Annotated[
        str, Parameter(help="Engine to open: name from the catalog, or file.")
    ] = "v8-cross-plane",
    /,
    *,
    host: Annotated[
        str, Parameter(help="Address to listen on; any but 127.0.0.1 admits other machines.")
    ] = "127.0.0.1",
    port: Annotated[str, Parameter(help="Port to listen on; 0 takes a free one.")] = "8000",
    open_: Annotated[
        bool, Parameter(name="--open", help="Open the page in the browser.", negative=())
    ] = False,
    settings: Settings = None,
) -> None:
    """Serve the page on this machine and recompute the engine at every edit."""
    if not re.fullmatch(r"\d{1,5}", port, re.ASCII) or int(port) > GREATEST_PORT:
        raise RequestError(
            _(
                "--port {port}: give a number from 0 to {greatest}, such as 8000",
                port=one_line(port),
                greatest=GREATEST_PORT,
            )
        )
    with working("starting ..."):
        try:
            from crankstar.server import running
        except ImportError as error:
            raise RequestError(
                _(
                    "the server needs FastAPI and uvicorn ({reason}); install them with "
                    'pip install "crankstar[server]"',
                    reason=error,
                )
            ) from None
        name, tree = tree_of(engine)
        tree = changed(tree, dict(setting(text) for text in settings or []), name=name)
        engine_of(tree, name=name)
        taken = running.opened(host, int(port))
    address = running.address_of(taken, host)

    def ready() -> None:
        complain(
            _(
                "crankstar: serving at {address}\nOpen it in a browser; Ctrl-C stops the server.",
                address=address,
            )
        )
        if not running.is_loopback(host):
            complain(_("There is no password: anyone who can reach this machine can use it."))
        if open_:
            import webbrowser

            webbrowser.open(address)

    shown = named(engine)
    words = [word for text in settings or () for word in ("--set", text)]
    command = shlex.join(["crankstar", "serve", shown, *words])
    with taken:
        running.serve(taken, host=host, opening=(tree, shown, command), ready=ready)
