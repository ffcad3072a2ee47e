"""`crankstar serve` from start to end: messages, refusals, nothing left behind."""

from __future__ import annotations

import os
import re
import shlex
import signal
import socket
import subprocess
import sys
from contextlib import suppress
from http.client import HTTPException
from pathlib import Path
from threading import Thread

import pytest
from tests.holding import PATIENCE, awaited
from tests.web.serving import serving

from crankstar.files.catalog import tree_of
from crankstar.server.running import address_of

HINT = "Open it in a browser; Ctrl-C stops the server.\n"
WRONG = 'format = 1\nname = "wrong"\ncycle = "three-stroke"\n'


def refused(*words: str, env: dict[str, str] | None = None) -> str:
    """What a command line says that is refused."""
    line = [sys.executable, "-m", "crankstar", "serve", *words]
    ran = subprocess.run(
        line, capture_output=True, text=True, timeout=PATIENCE, check=False, env=env
    )
    assert ran.returncode == 2, ran.stderr
    assert "Traceback" not in ran.stderr
    assert ran.stdout == ""
    return ran.stderr


def children(process: int) -> list[int]:
    """The processes that a process has started, and those that these have."""
    own = [
        int(pid)
        for task in Path(f"/proc/{process}/task").glob("*/children")
        for pid in task.read_text().split()
    ]
    return own + [pid for child in own for pid in children(child)]


def alive(process: int) -> bool:
    try:
        return Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False


def interrupted(process: subprocess.Popen[str]) -> bool:
    """Whether a process has ended, its group having been interrupted once more."""
    with suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGINT)
    return process.poll() is not None


def ignores(process: int, number: signal.Signals) -> bool:
    """Whether a process ignores a signal."""
    state = Path(f"/proc/{process}/status").read_text()
    found = re.search(r"^SigIgn:\s*(\w+)", state, re.MULTILINE)
    assert found
    return bool(int(found[1], 16) >> (number - 1) & 1)


KILLED = pytest.param(signal.SIGKILL, marks=pytest.mark.release)


@pytest.mark.release
@pytest.mark.skipif(not Path("/proc").is_dir(), reason="counts processes by /proc")
@pytest.mark.parametrize("number", [signal.SIGTERM, KILLED])
def test_it_ends_without_a_word_and_leaves_no_process(number: signal.Signals) -> None:
    with serving("i4") as server:
        assert server.ask("api/exhibit", {"engine": "i4"}).status == 200
        assert server.ask("api/search", {"cylinders": 9, "cycle": "two-stroke"}).status == 200
        workers = children(server.process.pid)
        assert len(workers) >= 2
        code, said = server.end(number)
        assert code == (-signal.SIGKILL if number == signal.SIGKILL else 0)
        assert said == HINT
        awaited(lambda: not any(map(alive, workers)))


@pytest.mark.release
def test_an_interrupt_from_the_keyboard_which_every_process_gets_ends_it_just_so() -> None:
    with serving("i4", alone=True) as server:
        os.killpg(server.process.pid, signal.SIGINT)
        assert server.process.wait(PATIENCE) == 0
        server.listener.join(PATIENCE)
        assert "".join(server.said) == HINT


@pytest.mark.release
def test_an_interrupt_while_it_is_busy_ends_it_without_a_word() -> None:
    with serving("v8-cross-plane", alone=True) as server:

        def ask(number: int) -> None:
            tree = {**tree_of("v8-cross-plane")[1], "cylinder": {"rod_ratio": 3.5 + number / 100}}
            with suppress(OSError, HTTPException):
                server.ask("api/exhibit", {"engine": tree})

        askers = [Thread(target=ask, args=(number,), daemon=True) for number in range(150)]
        for asker in askers:
            asker.start()
        server.ask("api/health")
        os.killpg(server.process.pid, signal.SIGINT)
        assert server.process.wait(PATIENCE) == 0
        server.listener.join(PATIENCE)
        assert "".join(server.said) == HINT


@pytest.mark.release
@pytest.mark.skipif(not Path("/proc").is_dir(), reason="reads the signals ignored from /proc")
def test_an_interrupt_that_the_parent_ignores_does_not_end_it() -> None:
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        with serving("i4", alone=True) as server:
            assert ignores(server.process.pid, signal.SIGINT)
            os.kill(server.process.pid, signal.SIGINT)
            assert server.ask("api/health").status == 200
            assert server.end()[0] == 0
    finally:
        signal.signal(signal.SIGINT, before)


@pytest.mark.release
def test_who_interrupts_until_it_ends_is_told_no_more() -> None:
    with serving("i4", alone=True) as server:
        awaited(lambda: interrupted(server.process))
        server.listener.join(PATIENCE)
        assert "".join(server.said) == HINT


def test_it_opens_with_the_file_and_the_changes_it_is_given(tmp_path: Path) -> None:
    from crankstar.files.catalog import path_of

    source = path_of("v8-cross-plane")
    assert source is not None
    file = tmp_path / "my own.toml"
    file.write_bytes(source.read_bytes())
    with serving(str(file), "--set", "name=</script><b>mine") as server:
        shown = server.ask("api/opening").json
        assert shown["sources"] == ["my own.toml"]
        assert shlex.split(shown["command"]) == [
            "crankstar",
            "serve",
            "my own.toml",
            "--set",
            "name=</script><b>mine",
        ]
        assert shown["engines"][0]["name"] == "</script><b>mine"
        assert str(tmp_path) not in server.ask("api/opening").body.decode()


def test_a_port_in_use_is_told_with_the_next_step() -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
        said = refused("--port", str(port))
        assert f"--port {port} is in use" in said
        assert re.search(r"as in --port \d+, or --port 0", said)


@pytest.mark.parametrize(
    ("host", "name"),
    [
        ("127.0.0.1", "127.0.0.1"),
        ("0.0.0.0", "127.0.0.1"),  # noqa: S104
        ("::", "[::1]"),
        ("::1", "[::1]"),
        ("workshop.local", "workshop.local"),
    ],
)
def test_the_address_is_one_that_can_be_typed(host: str, name: str) -> None:
    with socket.create_server(("127.0.0.1", 0)) as taken:
        assert address_of(taken, host) == f"http://{name}:{taken.getsockname()[1]}/"


def test_an_engine_with_mistakes_is_refused_with_all_of_them(tmp_path: Path) -> None:
    file = tmp_path / "wrong.toml"
    file.write_text(WRONG)
    said = refused(str(file))
    assert "cycle is " in said
    assert "layout is missing" in said


def test_without_the_extra_it_says_what_to_install(tmp_path: Path) -> None:
    (tmp_path / "fastapi.py").write_text("raise ImportError('No module named fastapi')")
    said = refused("i4", env={**os.environ, "PYTHONPATH": str(tmp_path)})
    assert 'pip install "crankstar[server]"' in said


@pytest.mark.release
def test_it_says_so_when_other_machines_can_reach_it() -> None:
    with serving("--host", "0.0.0.0") as server:  # noqa: S104  # that is what is asked
        address = server.address.replace("0.0.0.0", "127.0.0.1")  # noqa: S104
        assert address == server.address
        assert server.ask("api/health").status == 200
        assert server.ask("api/health", heads={"Host": "evil.example"}).status == 421
        assert server.ask("api/health", heads={"Host": f"{socket.gethostname()}:80"}).status == 200
        assert server.ask("api/health", heads={"Host": "192.0.2.7"}).status == 200
        _, said = server.end()
        assert "anyone who can reach this machine" in said
