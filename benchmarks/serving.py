"""Fifty people editing engines at once on `crankstar serve`: the delay of each change.

Each of them changes how long the rods are, waits for the exhibit, looks at it for a second, and
changes it again; no two engines are alike, so that no answer is there already. Run it with: python
benchmarks/serving.py [PEOPLE] [SECONDS] [PAUSE]
"""

from __future__ import annotations

import http.client
import json
import os
import random
import sys
import threading
import time
from pathlib import Path
from urllib.parse import urlsplit

sys.path.insert(0, str(Path(__file__).parents[1]))

from tests.web.serving import Server, serving

from crankstar.files.catalog import tree_of

ENGINES = ("v8-cross-plane", "v12-60", "audi-25-tfsi", "radial-9")


class Person(threading.Thread):
    """Somebody who edits an engine."""

    def __init__(self, server: Server, number: int, until: float, pause: float) -> None:
        super().__init__(daemon=True)
        self.random = random.Random(number)  # noqa: S311
        self.place = urlsplit(server.address)
        self.tree = tree_of(ENGINES[number % len(ENGINES)])[1]
        self.until, self.pause = until, pause
        self.took: list[float] = []
        self.faults: list[str] = []

    def run(self) -> None:
        line = http.client.HTTPConnection(self.place.hostname or "", self.place.port, timeout=30)
        time.sleep(self.random.uniform(0, self.pause))
        while time.monotonic() < self.until:
            self.tree.setdefault("cylinder", {}).pop("rod_length", None)
            self.tree["cylinder"]["rod_ratio"] = self.random.uniform(3.5, 5.0)
            began = time.perf_counter()
            try:
                line.request(
                    "POST",
                    "/api/exhibit",
                    json.dumps({"engine": self.tree}),
                    {"Content-Type": "application/json"},
                )
                answer = line.getresponse()
                body = answer.read()
                if answer.status != 200:
                    self.faults.append(f"{answer.status}: {body[:200]!r}")
            except OSError as error:
                self.faults.append(repr(error))
            self.took.append(time.perf_counter() - began)
            time.sleep(self.random.uniform(0.5, 1.5) * self.pause)


def main(people: float = 50, seconds: float = 20.0, pause: float = 1.0) -> None:
    """Prints percentiles of the time from a question to its whole answer."""
    with serving() as server:
        server.ask("api/exhibit", {"engine": ENGINES[0]})  # the processes are there
        alone = Person(server, 0, time.monotonic() + 4, 0.02)
        alone.run()
        told("one person", alone.took, alone.faults)
        crowd = [
            Person(server, number, time.monotonic() + seconds, pause)
            for number in range(int(people))
        ]
        before = processor_seconds(server.process.pid)
        for person in crowd:
            person.start()
        for person in crowd:
            person.join()
        took = [each for person in crowd for each in person.took]
        used = processor_seconds(server.process.pid) - before
        print(
            f"{1e3 * used / len(took):.1f} ms of a processor for each change, the "
            "server's own share included"
        )
        faults = [fault for person in crowd for fault in person.faults]
        told(f"{people:.0f} people, {len(took) / seconds:.0f} changes a second", took, faults)


def processor_seconds(process: int) -> float:
    """What a process and those that it has started have used of the processors (Linux)."""
    fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
    started = [
        int(pid)
        for task in Path(f"/proc/{process}/task").glob("*/children")
        for pid in task.read_text().split()
    ]
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK") + sum(
        map(processor_seconds, started)
    )


def told(who: str, took: list[float], faults: list[str]) -> None:
    """One line of figures."""
    took = sorted(took)
    middle, most = (1e3 * took[int(len(took) * share)] for share in (0.5, 0.95))
    print(
        f"{who}: median {middle:.0f} ms, p95 {most:.0f} ms, longest {1e3 * took[-1]:.0f} "
        f"ms, {len(faults)} errors {faults[:3]}"
    )


if __name__ == "__main__":
    print(f"{os.cpu_count()} processors")
    main(*map(float, sys.argv[1:]))
