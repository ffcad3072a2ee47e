"""Work in other processes: its results, its errors; an interrupt reaches only who waits."""

import signal
import subprocess
import sys
import threading
from pathlib import Path

import pytest
from tests.holding import PATIENCE

from crankstar.stars.interrupts import aside


def test_what_work_gives_and_raises_comes_through():
    assert aside(lambda: 42) == 42
    with pytest.raises(ZeroDivisionError):
        aside(lambda: 1 // 0)


def test_an_interrupt_ends_the_waiting_and_not_the_work():
    begun, go, done = threading.Event(), threading.Event(), threading.Event()

    def work():
        begun.set()
        go.wait(PATIENCE)
        done.set()

    watch = threading.Thread(
        target=lambda: (
            begun.wait(PATIENCE)
            and signal.pthread_kill(threading.main_thread().ident or 0, signal.SIGINT)
        )
    )
    watch.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            aside(work)
    finally:
        watch.join()
    assert not done.is_set()
    go.set()
    assert done.wait(PATIENCE)


FIRST = """
import multiprocessing, signal
from crankstar.stars.interrupts import held_back
if __name__ == "__main__":
    with held_back():
        process = multiprocessing.get_context("spawn").Process(target=int)
        process.start()
        print(signal.SIGINT in signal.pthread_sigmask(signal.SIG_BLOCK, ()))
    process.join()
    print(signal.SIGINT in signal.pthread_sigmask(signal.SIG_BLOCK, ()))
"""


@pytest.mark.skipif(
    not hasattr(signal, "pthread_sigmask"), reason="interrupts cannot be held back here"
)
def test_the_first_process_of_a_program_is_kept_from_interrupts_like_the_later_ones(tmp_path: Path):
    script = tmp_path / "first.py"
    script.write_text(FIRST)
    ran = subprocess.run(
        [sys.executable, str(script)], capture_output=True, text=True, timeout=PATIENCE, check=True
    )
    assert ran.stdout.split() == ["True", "False"]
