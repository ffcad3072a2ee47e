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
from pathlib import Path
from typing import Any, NamedTuple
from urllib.parse import urlsplit

import pytest
from tests.holding import PATIENCE

READY = re.compile(r"^crankstar: .*?(http://\S+/)")
START = f"""
from crankstar.server import running, workers
running.TASK_SECONDS = workers.WAITING_SECONDS = {PATIENCE}
from crankstar.__main__ import main
main()
"""
"""The command, with as much patience with its workers as tests have with it."""
HELD = f"""
import sys
sys.path.insert(0, {str(Path(__file__).parents[2])!r})
from crankstar.server import search_process
from tests.server import chores
search_process.work = chores.search_until_stopped
"""
"""Before it: searches find the first, then wait until they are stopped."""


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
            http.client.HTTPConnection(place.hostname or "", place.port, timeout=PATIENCE)
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
            code = self.process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            self.process.kill()
            pytest.fail(f"the server did not end within {PATIENCE:g} s: {''.join(self.said)}")
        self.listener.join(PATIENCE)
        return code, "".join(self.said)


def command(*arguments: str, held: bool = False) -> list[str]:
    """The command line of a server at a free port."""
    start = HELD + START if held else START
    return [sys.executable, "-c", start, "serve", *arguments, "--port", "0"]


@contextmanager
def serving(*arguments: str, alone: bool = False, held: bool = False) -> Iterator[Server]:
    """A server started with these command-line arguments; it is always ended.

    `alone`: it leads a group of processes of its own, as one that was started in a terminal.
    `held`: its searches end only when they are stopped.
    """
    process = subprocess.Popen(
        command(*arguments, held=held), stderr=subprocess.PIPE, text=True, start_new_session=alone
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
            listener.join(PATIENCE)
            pytest.fail(f"the server did not start: {first}{''.join(said)}")
        yield Server(found[1], process, said, listener)
    finally:
        if process.poll() is None:
            process.terminate()
            try:
                process.wait(PATIENCE)
            except subprocess.TimeoutExpired:
                process.kill()
        process.wait()
        listener.join(PATIENCE)
        process.stderr.close()


@pytest.fixture(scope="session")
def server() -> Iterator[Server]:
    """A server that all tests share; it opens with v8-cross-plane."""
    with serving() as running:
        yield running
