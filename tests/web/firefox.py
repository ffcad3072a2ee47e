"""Firefox without a window, asked by WebDriver BiDi, which it speaks itself."""

from __future__ import annotations

import base64
import json
import os
import re
import shutil
import subprocess
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from websockets.sync.client import ClientConnection, connect

COMMANDS = ("firefox-esr", "firefox")
LISTENS = re.compile(r"WebDriver BiDi listening on (ws://\S+)")
SECONDS = 120.0


def firefox() -> str | None:
    """The path of Firefox, if this machine has one."""
    return next(filter(None, map(shutil.which, COMMANDS)), None)


class Window:
    """A window of 1280 by 800 pixels; what its pages complain about on the console is kept."""

    def __init__(self, connection: ClientConnection) -> None:
        self._connection = connection
        self._asked = 0
        self.complaints: list[str] = []
        self._call("session.new", capabilities={})
        self._call("session.subscribe", events=["log.entryAdded"])
        self._context = self._call("browsingContext.getTree")["contexts"][0]["context"]
        size = {"width": 1280, "height": 800}
        self._call("browsingContext.setViewport", context=self._context, viewport=size)

    def _call(self, method: str, **parameters: Any) -> dict[str, Any]:
        self._asked += 1
        question = {"id": self._asked, "method": method, "params": parameters}
        self._connection.send(json.dumps(question))
        while True:
            answer = json.loads(self._connection.recv(timeout=SECONDS))
            if answer.get("method") == "log.entryAdded":
                if answer["params"]["level"] in ("error", "warn"):
                    self.complaints.append(str(answer["params"]["text"]))
            elif answer.get("id") == self._asked:
                if answer["type"] != "success":
                    raise RuntimeError(f"{method}: {answer['message']}")
                return answer["result"]

    def goto(self, address: str) -> None:
        self._call("browsingContext.navigate", context=self._context, url=address, wait="complete")

    def evaluate(self, expression: str) -> Any:
        """What a function of JavaScript, written out, returns, awaited."""
        said = self._call(
            "script.evaluate",
            expression=f"Promise.resolve(({expression})()).then(JSON.stringify)",
            target={"context": self._context},
            awaitPromise=True,
        )
        if said["type"] != "success":
            raise RuntimeError(said["exceptionDetails"]["text"])
        return json.loads(said["result"].get("value", "null"))

    def screenshot(self) -> bytes:
        """The window as PNG."""
        shot = self._call("browsingContext.captureScreenshot", context=self._context)
        return base64.b64decode(shot["data"])


@contextmanager
def window(program: str, profile: Path) -> Iterator[Window]:
    """A window of Firefox with a profile of its own."""
    process = subprocess.Popen(
        [program, "--headless", "--no-remote", "--profile", profile, "--remote-debugging-port=0"],
        stderr=subprocess.PIPE,
        text=True,
        # its sandbox does not work for root, nor in many containers
        env={**os.environ, "HOME": str(profile), "MOZ_DISABLE_CONTENT_SANDBOX": "1"},
    )
    assert process.stderr is not None
    try:
        found = None
        for line in process.stderr:
            if found := LISTENS.search(line):
                break
        assert found, "Firefox has ended"
        with connect(f"{found[1]}/session", max_size=None, open_timeout=SECONDS) as connection:
            yield Window(connection)
    finally:
        process.terminate()
        process.communicate(timeout=SECONDS)
