"""A server that runs: its port taken, its address said, served until it is interrupted."""

from __future__ import annotations

import asyncio
import errno
import logging
import os
import signal
import socket
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any

import h11
import uvicorn
from uvicorn.protocols.http.h11_impl import H11Protocol

from crankstar.language.messages import _, is_named
from crankstar.language.quoting import one_line
from crankstar.options.values import RequestError
from crankstar.server import guard
from crankstar.server.application import Opening, application
from crankstar.server.refusal import Refused, refused
from crankstar.server.watching import Watched
from crankstar.server.workers import Workers

TASK_SECONDS = 10.0
"""Processor time that an answer may take."""
LEAVE_SECONDS = 2
"""How long answers that are under way may take when the server is stopped."""
GREATEST_PROCESSES = 4
GREATEST_UNHEARD = 500
"""Askers that may wait until they are heard."""


def opened(host: str, port: int) -> socket.socket:
    """A listening socket; port 0 is any free port. Raises RequestError with advice."""
    try:
        family, kind, protocol, _name, address = socket.getaddrinfo(
            host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE
        )[0]
    except (OSError, UnicodeError, OverflowError):
        raise RequestError(
            _(
                "--host {host} is not an address of this machine; leave it out, or give one, as "
                "in 127.0.0.1",
                host=one_line(host),
            )
        ) from None
    taken = socket.socket(family, kind, protocol)
    try:
        if os.name == "posix":
            taken.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        taken.bind(address)
        taken.listen(GREATEST_UNHEARD)
    except OSError as error:
        taken.close()
        raise RequestError(_refusal(host, port, error)) from None
    taken.setblocking(False)
    return taken


def _refusal(host: str, port: int, error: OSError) -> str:
    if error.errno == errno.EADDRINUSE:
        return _(
            "--port {port} is in use, perhaps by another crankstar serve; choose another, as in "
            "--port {other}, or --port 0 for a free one",
            port=port,
            other=port + 1 if port < 65535 else 8000,
        )
    if error.errno == errno.EACCES:
        return _(
            "--port {port} is reserved for the administrator; choose one from 1024 up, as in "
            "--port 8000",
            port=port,
        )
    return _(
        "--host {host} cannot be used ({reason}); leave it out, or give an address of this machine",
        host=one_line(host),
        reason=error.strerror,
    )


def address_of(taken: socket.socket, host: str) -> str:
    """The address of the page, as one types it."""
    port = taken.getsockname()[1]
    names = {"": "127.0.0.1", "0.0.0.0": "127.0.0.1", "::": "[::1]"}  # noqa: S104
    return f"http://{names.get(host, f'[{host}]' if ':' in host else host)}:{port}/"


def serve(
    taken: socket.socket,
    *,
    host: str,
    opening: Opening,
    ready: Callable[[], None],
    watched: Watched | None = None,
) -> None:
    """Serve until an interrupt or a signal to end; `ready` is called when the server is up.

    Pages are in the language that is named, or in that of each browser.
    """
    workers = Workers(max(1, min(os.cpu_count() or 1, GREATEST_PROCESSES)), seconds=TASK_SECONDS)
    app = application(
        workers=workers, opening=opening, host=host, watched=watched, one_language=is_named()
    )
    settings: dict[str, Any] = {
        "lifespan": "on",
        "log_config": None,
        "access_log": False,
        "server_header": False,
        "ws": "none",
        "log_level": "error",
    }
    config = uvicorn.Config(
        app,
        **settings,
        http=_Protocol,
        loop="asyncio",
        timeout_graceful_shutdown=LEAVE_SECONDS,
        proxy_headers=False,
    )
    server = _Server(config, ready)

    def heard(_record: logging.LogRecord) -> bool:
        return not server.should_exit  # answers that the end cuts short are no errors

    log = logging.getLogger("uvicorn.error")
    log.addFilter(heard)
    try:
        server.run(sockets=[taken])
    finally:
        log.removeFilter(heard)


class _Protocol(H11Protocol):
    """HTTP with our own refusal of malformed requests; a silent client is disconnected."""

    _patience: asyncio.TimerHandle | None = None

    def connection_made(self, transport: asyncio.Transport) -> None:
        """Begins to wait for the head of a question."""
        super().connection_made(transport)
        self._wait()

    def data_received(self, data: bytes) -> None:
        """Takes what comes; a head that is still not whole must be so soon."""
        super().data_received(data)
        if self.conn.their_state is not h11.IDLE:
            self._wait_no_more()
        elif self._patience is None:
            self._wait()

    def connection_lost(self, exc: Exception | None) -> None:
        """Waits for nothing more."""
        self._wait_no_more()
        super().connection_lost(exc)

    def send_400_response(self, msg: str) -> None:
        """Refuses what came, and hangs up."""
        del msg
        self._hang_up(refused(400, "question.not-http"))

    def _wait(self) -> None:
        self._patience = self.loop.call_later(guard.QUESTION_SECONDS, self._too_late)

    def _wait_no_more(self) -> None:
        if self._patience is not None:
            self._patience.cancel()
            self._patience = None

    def _too_late(self) -> None:
        if self.transport.is_closing():
            return
        if self.conn.trailing_data[0]:
            self._hang_up(guard.too_late(guard.QUESTION_SECONDS))
        else:
            self.transport.close()  # a browser that opened a line to have it ready

    def _hang_up(self, refusal: Refused) -> None:
        heads = [
            (b"content-type", b"application/json"),
            (b"connection", b"close"),
            *guard.heads_always(),
        ]
        answer = (
            h11.Response(status_code=refusal.status, headers=heads),
            h11.Data(data=refusal.body),
            h11.EndOfMessage(),
        )
        self.transport.write(b"".join(self.conn.send(event) or b"" for event in answer))
        self.transport.close()


class _Server(uvicorn.Server):
    """The server, ended by signals without their being raised once more."""

    def __init__(self, config: uvicorn.Config, ready: Callable[[], None]) -> None:
        super().__init__(config)
        self._ready = ready

    async def startup(self, sockets: list[socket.socket] | None = None) -> None:
        """Begins to answer, and says so."""
        await super().startup(sockets)
        if self.started:
            self._ready()

    @contextmanager
    def capture_signals(self) -> Iterator[None]:
        """Let SIGINT and SIGTERM stop the server, each unless the parent has it ignored."""
        heeded = [
            number
            for number in (signal.SIGINT, signal.SIGTERM)
            if signal.getsignal(number) is not signal.SIG_IGN
        ]
        before = {number: signal.signal(number, self._stop) for number in heeded}
        try:
            yield
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)

    def _stop(self, _number: int, _frame: FrameType | None) -> None:
        self.should_exit = True  # a second signal must not break the orderly end


def is_loopback(host: str) -> bool:
    """Whether only this machine can reach a server that listens there."""
    return host in guard.LOOPBACK
