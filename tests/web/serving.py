"""A real `crankstar serve` on a free port, with a process of its own, for as long as it is needed."""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import urllib.error
import urllib.request
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any, NamedTuple

import pytest

READY = re.compile(r"serving at (http://\S+/)")
END_SECONDS = 10


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

    def ask(self, path: str, question: Any = None, *, method: str | None = None, heads: dict[str, str] | None = None) -> Answer:
        """An answer of the API: POST with a question, GET without."""
        body = question if isinstance(question, bytes | None) else json.dumps(question).encode()
        wanted = {"Content-Type": "application/json", **(heads or {})}
        request = urllib.request.Request(self.address + path, body, wanted, method=method)  # noqa: S310  # our own address
        try:
            with urllib.request.urlopen(request, timeout=60) as answer:  # noqa: S310
                return Answer(answer.status, _lower(answer.headers), answer.read())
        except urllib.error.HTTPError as error:
            with error:
                return Answer(error.code, _lower(error.headers), error.read())

    def end(self, number: int = signal.SIGTERM) -> tuple[int, str]:
        """Ends the server by a signal; its exit code and all that it has said since it was ready."""
        self.process.send_signal(number)
        try:
            _, said = self.process.communicate(timeout=END_SECONDS)
        except subprocess.TimeoutExpired:
            self.process.kill()
            _, said = self.process.communicate()
            pytest.fail(f"the server did not end within {END_SECONDS} s: {said}")
        return self.process.returncode, said


def _lower(heads: Any) -> dict[str, str]:
    return {name.lower(): value for name, value in heads.items()}


def command(*arguments: str) -> list[str]:
    """The command line of a server at a free port."""
    return [sys.executable, "-m", "crankstar", "serve", *arguments, "--port", "0"]


@contextmanager
def serving(*arguments: str) -> Iterator[Server]:
    """A server, started with these words of the command line, and ended in the end whatever happens."""
    process = subprocess.Popen(command(*arguments), stderr=subprocess.PIPE, text=True, env={**os.environ, "COLUMNS": "200"})
    assert process.stderr is not None
    try:
        first = process.stderr.readline()
        found = READY.search(first)
        if found is None:
            process.kill()
            pytest.fail(f"the server did not start: {first}{process.communicate()[1]}")
        yield Server(found[1], process)
    finally:
        if process.poll() is None:
            process.terminate()
            try:
                process.wait(END_SECONDS)
            except subprocess.TimeoutExpired:
                process.kill()
        process.communicate()


@pytest.fixture(scope="session")
def server() -> Iterator[Server]:
    """A server that all tests share; it opens with v8-cross-plane."""
    with serving() as running:
        yield running
