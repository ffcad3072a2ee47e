"""A real `crankstar serve` on a free port, in a process of its own."""

from __future__ import annotations

import http.client
import json
import re
import signal
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass
from typing import Any, NamedTuple
from urllib.parse import urlsplit

import pytest

READY = re.compile(r"^crankstar: .*?(http://\S+/)")
END_SECONDS = 60
PATIENT = """from crankstar.__main__ import main
from crankstar.server import running, workers
running.TASK_SECONDS = workers.WAITING_SECONDS = 120.0
main()"""
"""The command line, with answers that take long where the machine has other things to do.

How a server refuses what takes too long is tested by its workers.
"""


class Answer(NamedTuple):
    """What a server answered: status, headers (names in lower case), body."""

    status: int
    heads: dict[str, str]
    body: bytes

    @property
    def json(self) -> Any:
        return json.loads(self.body)


@dataclass
class Server:
    """A server that is running. `address` ends with a slash."""

    address: str
    process: subprocess.Popen[str]
    said: list[str]
    listener: threading.Thread

    def ask(
        self,
        path: str,
        question: Any = None,
        *,
        method: str | None = None,
        heads: dict[str, str] | None = None,
    ) -> Answer:
        """An answer of the API: POST with a question, GET without."""
        body = question if isinstance(question, bytes | None) else json.dumps(question).encode()
        wanted = {"Content-Type": "application/json", **(heads or {})}
        place = urlsplit(self.address)
        with closing(
            http.client.HTTPConnection(place.hostname or "", place.port, timeout=120)
        ) as line:
            line.request(method or ("GET" if body is None else "POST"), f"/{path}", body, wanted)
            answer = line.getresponse()
            return Answer(
                answer.status,
                {name.lower(): value for name, value in answer.getheaders()},
                answer.read(),
            )

    def end(self, number: int = signal.SIGTERM) -> tuple[int, str]:
        """End the server by a signal; its exit code, and its output after the address."""
        self.process.send_signal(number)
        try:
            code = self.process.wait(END_SECONDS)
        except subprocess.TimeoutExpired:
            self.process.kill()
            pytest.fail(f"the server did not end within {END_SECONDS} s: {''.join(self.said)}")
        self.listener.join(END_SECONDS)
        return code, "".join(self.said)


def command(*arguments: str) -> list[str]:
    """The command line of a server at a free port."""
    return [sys.executable, "-c", PATIENT, "serve", *arguments, "--port", "0"]


@contextmanager
def serving(*arguments: str, alone: bool = False) -> Iterator[Server]:
    """A server started with these command-line arguments; it is always ended.

    `alone`: it leads a group of processes of its own, as one that was started in a terminal.
    """
    process = subprocess.Popen(
        command(*arguments), stderr=subprocess.PIPE, text=True, start_new_session=alone
    )
    assert process.stderr is not None
    said: list[str] = []
    listener = threading.Thread(target=said.extend, args=(process.stderr,), daemon=True)
    try:
        first = process.stderr.readline()
        listener.start()
        found = READY.search(first)
        if found is None:
            process.kill()
            listener.join(END_SECONDS)
            pytest.fail(f"the server did not start: {first}{''.join(said)}")
        yield Server(found[1], process, said, listener)
    finally:
        if process.poll() is None:
            process.terminate()
            try:
                process.wait(END_SECONDS)
            except subprocess.TimeoutExpired:
                process.kill()
        process.wait()
        listener.join(END_SECONDS)
        process.stderr.close()


@pytest.fixture(scope="session")
def server() -> Iterator[Server]:
    """A server that all tests share; it opens with v8-cross-plane."""
    with serving() as running:
        yield running
