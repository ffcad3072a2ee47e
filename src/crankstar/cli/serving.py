"""The verb that serves: serve."""

from __future__ import annotations

from typing import Annotated

from cyclopts import Parameter

from crankstar.cli.options import Estimating, Settings, command_text, engine_over_ranges, option
from crankstar.cli.output import complain, working
from crankstar.language.messages import _
from crankstar.options import values as request
from crankstar.options.values import RequestError

GREATEST_PORT = 65535


def serve(
    engine: Annotated[
        str, Parameter(help="Engine to open: name from the catalog, or file.")
    ] = "v8-cross-plane",
    /,
    *,
    host: Annotated[str, option("--host")] = "127.0.0.1",
    port: Annotated[int, option("--port")] = 8000,
    open_: Annotated[bool, option("--open")] = False,
    settings: Settings = None,
    estimate: Estimating = False,
) -> None:
    """Serve the page on this machine and recompute the engine at every edit."""
    number = request.within("--port", port, least=0, most=GREATEST_PORT) or 0
    with working(_("Starting ...")):
        try:
            from crankstar.server import running
        except ImportError as error:
            raise RequestError(
                "the server needs FastAPI and uvicorn ({reason}); install them with "
                'pip install "crankstar[server]"',
                reason=error,
            ) from None
        _loaded, tree = engine_over_ranges(engine, settings, estimate=estimate)
        taken = running.opened(host, number)
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

    shown = request.named(engine)
    flags = {"--estimate": [""] if estimate else None}
    command = command_text("serve", shown, {"--set": settings, **flags})
    with taken:
        running.serve(taken, host=host, opening=(tree, shown, command), ready=ready)
