"""The answer depends on the question only, not on workers, pieces or their failures."""

import os
import random
import signal
import socket
import subprocess
import sys
import threading
from concurrent.futures import BrokenExecutor, Executor, Future, ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import replace
from multiprocessing import active_children
from typing import Any

import psutil
import pytest
from tests.holding import PATIENCE, awaited
from tests.search.asked import every_kind, front

from crankstar.stars import checkpoint, distribution, executors, halves, regions, run
from crankstar.stars.answer import answer_to, read
from crankstar.stars.executors import Workers, cluster, of_workers, processes
from crankstar.stars.faults import SearchError
from crankstar.stars.run import searched
from crankstar.stars.work import results_of

KINDS = every_kind()
MIDDLE = front(12)
"""236 blocks."""


@pytest.fixture(autouse=True)
def patient(monkeypatch):
    """A scheduler may take its time to answer on a busy machine."""
    monkeypatch.setattr(executors, "SCHEDULER_SECONDS", PATIENCE)


@pytest.fixture(scope="module")
def answers():
    return {name: answer_to(question) for name, question in KINDS.items()}


@pytest.fixture(scope="module")
def middle():
    return answer_to(MIDDLE)


@pytest.fixture(scope="module")
def two():
    with processes(2) as workers:
        yield workers


@contextmanager
def local_cluster(workers):
    from distributed import LocalCluster

    found: Any = LocalCluster(
        n_workers=workers, threads_per_worker=1, dashboard_address=":0", silence_logs=50
    )
    with found:
        yield found


@pytest.fixture(scope="module")
def daskers():
    with local_cluster(2) as found:
        yield found


class Shuffled(Executor):
    """Works only when awaited, returns results in any order, loses some in every way."""

    def __init__(self, seed, losses=()):
        self.chance, self.losses, self.lost = random.Random(seed), losses, set()  # noqa: S311
        self.waiting, self.changed, self.open = [], threading.Condition(), True
        self.thread = threading.Thread(target=self.work)
        self.thread.start()

    def submit(self, fn, /, *args, **_):
        future = Future()
        with self.changed:
            self.waiting.append((future, fn, args))
            self.changed.notify()
        return future

    def work(self):
        while True:
            with self.changed:
                self.changed.wait_for(lambda: self.waiting or not self.open)
                if not self.open:
                    return
                self.chance.shuffle(self.waiting)
                future, fn, args = self.waiting.pop()
            key = (args[0].start, args[0].stop)
            if self.losses and key not in self.lost:
                self.lost.add(key)
                loss = self.chance.choice(self.losses)
                if loss is None:
                    future.cancel()
                    future.set_running_or_notify_cancel()
                else:
                    future.set_exception(loss)
            else:
                future.set_result(fn(*args))

    def shutdown(self, *_, **__):
        with self.changed:
            self.open = False
            self.changed.notify()
        self.thread.join()


LOSSES = (
    BrokenExecutor("gone"),
    ConnectionResetError("gone"),
    TimeoutError("gone"),
    EOFError(),
    None,
)


@pytest.mark.many(first=16)
@pytest.mark.parametrize("size", [1, 3, 50, 100_000])
@pytest.mark.parametrize("name", KINDS)
def test_the_answer_is_the_same_in_pieces_of_any_size(answers, name, size):
    assert answer_to(KINDS[name], range_size=size) == answers[name]


@pytest.mark.many(first=1)
@pytest.mark.parametrize("name", KINDS)
def test_the_answer_is_the_same_by_processes_threads_and_whoever_comes_first(answers, name, two):
    assert answer_to(KINDS[name], workers=two, range_size=4) == answers[name]
    with ThreadPoolExecutor(3) as threads:
        assert (
            answer_to(KINDS[name], workers=Workers(threads, count=3), range_size=3) == answers[name]
        )
    for losses in ((), LOSSES):
        with Shuffled(1, losses) as shuffled:
            assert (
                answer_to(KINDS[name], workers=Workers(shuffled, count=4), range_size=2)
                == answers[name]
            )


@pytest.mark.release
@pytest.mark.parametrize("name", KINDS)
def test_the_answer_is_the_same_by_a_cluster(answers, name, daskers, monkeypatch):
    monkeypatch.setattr(executors, "LOOK_SECONDS", PATIENCE)
    with cluster(daskers.scheduler_address) as workers:
        assert workers.count == 2
        assert answer_to(KINDS[name], workers=workers, range_size=7) == answers[name]


@pytest.mark.release
def test_the_answer_is_the_same_after_several_attempts(monkeypatch, two, answers):
    question, wanted = KINDS["front"], answers["front"]
    monkeypatch.setattr(regions, "WANTED", 1e-3)
    monkeypatch.setattr(regions, "CHEAP", 0.0)
    told = []
    found = answer_to(question, workers=two, range_size=50, watch=told.append)
    assert found.rows == wanted.rows
    assert found.certificate.attempts == told[-1].attempt + 1 > 2
    assert [p.seconds for p in told] == sorted(p.seconds for p in told)
    assert all(p.seconds_left is None or p.seconds_left >= 0 for p in told)


@pytest.mark.release
def test_a_lost_process_of_this_machine_changes_nothing(middle):
    others, killed = set(active_children()), []

    def kill(progress):
        if len(killed) < 2 and progress.done > 40 * (1 + len(killed)):
            one = min(set(active_children()) - others, key=lambda process: process.pid or 0)
            assert one.pid is not None
            with suppress(
                ProcessLookupError
            ):  # it ended this moment: with the next progress another is met
                os.kill(one.pid, signal.SIGKILL)
                killed.append(one)

    with processes(2) as workers:
        assert answer_to(MIDDLE, workers=workers, range_size=3, watch=kill) == middle
        assert len(killed) == 2
        assert answer_to(MIDDLE, workers=workers, range_size=20) == middle
    assert not {process.pid for process in active_children()} - {process.pid for process in others}


@pytest.mark.release
def test_a_lost_worker_of_a_cluster_changes_nothing(middle, daskers):
    killed = []

    def kill(progress):
        if progress.done > 40 and not killed:
            killed.append(daskers.workers[0].pid)
            os.kill(killed[0], signal.SIGKILL)

    with cluster(daskers.scheduler_address) as workers:
        assert answer_to(MIDDLE, workers=workers, range_size=3, watch=kill) == middle
    assert killed


def test_a_worker_that_is_lost_every_time_ends_the_search():
    with pytest.raises(SearchError, match="was lost 4 times"):
        searched(MIDDLE, workers=_Failing(BrokenExecutor("gone")))


class _Failing(Workers):
    """Fails with every stretch."""

    def __init__(self, fault):
        super().__init__(ThreadPoolExecutor(1), count=1)
        self.fault = fault

    def submit(self, part):
        assert part.start < part.stop
        future = Future()
        future.set_exception(self.fault)
        return future


@pytest.mark.parametrize("fault", [ZeroDivisionError("here"), MemoryError(), ValueError("there")])
def test_what_the_work_raises_comes_through(fault):
    with pytest.raises(type(fault)) as told:
        searched(MIDDLE, workers=_Failing(fault))
    assert told.value is fault


def test_workers_without_the_package_are_told():
    with pytest.raises(SearchError, match="install the same version"):
        searched(MIDDLE, workers=_Failing(ModuleNotFoundError("No module named 'crankstar'")))


def test_an_executor_that_takes_nothing_more_is_told():
    executor = ThreadPoolExecutor(1, initializer=lambda: 1 / 0)
    with suppress(BrokenExecutor):
        executor.submit(int).result()
    with pytest.raises(SearchError, match="accepts no more work"):
        searched(MIDDLE, workers=Workers(executor))


class _Asleep(Workers):
    """Never comes back; is interrupted while it is waited for."""

    def __init__(self):
        super().__init__(Shuffled(1), count=2)
        self.submitted, self.dropped = 0, False
        self.executor.shutdown()

    def submit(self, part):
        self.submitted += part.stop - part.start
        return Future()

    def look(self):
        raise KeyboardInterrupt

    def drop(self, under_way=()):
        assert len([*under_way]) == 2 * distribution.AHEAD
        self.dropped = True


def test_only_so_many_stretches_are_under_way_and_an_interrupt_drops_them():
    asleep = _Asleep()
    outcome = searched(MIDDLE, workers=asleep, range_size=1)
    assert outcome.interrupted
    assert not outcome.complete
    assert asleep.submitted == 2 * distribution.AHEAD
    assert asleep.dropped


@pytest.mark.many(first=1)
@pytest.mark.parametrize("at", [0, 1, 30])
def test_an_interrupt_gives_what_was_found_and_the_search_goes_on_from_there(
    at, middle, tmp_path, two
):
    path = tmp_path / "file"
    for who in (None, two):

        def interrupt(progress):
            if progress.done >= at and progress.rate:
                signal.raise_signal(signal.SIGINT)

        outcome = searched(
            MIDDLE,
            workers=who,
            range_size=5,
            checkpoint=checkpoint.opened(path, MIDDLE),
            watch=interrupt,
        )
        assert outcome.interrupted
        assert not outcome.complete
        assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
        part = read(outcome)
        assert part.certificate.interrupted
        assert not part.certificate.complete
        assert part.rows
        assert 0 < outcome.results.met < middle.certificate.met
    told = []
    assert (
        answer_to(
            MIDDLE, range_size=9, checkpoint=checkpoint.opened(path, MIDDLE), watch=told.append
        )
        == middle
    )
    assert told[0].done >= 5 + 9  # what was kept, and a stretch
    assert told[-1].seconds_left == 0


@pytest.mark.release
def test_processes_that_are_gone_before_their_pool_knows_leave_no_fault(monkeypatch):
    """A fault in the thread of the pool would be printed at the user; here it is an error."""

    def interrupt(progress):
        if progress.rate:
            signal.raise_signal(signal.SIGINT)

    with processes(2) as workers:
        pool: Any = workers.executor
        joined = []
        shutdown = pool.shutdown

        def late(**how):
            if thread := pool._executor_manager_thread:
                thread.join(timeout=PATIENCE)  # it ends when it finds that the processes have
                joined.append(not thread.is_alive())
            shutdown(**how)

        monkeypatch.setattr(pool, "shutdown", late)
        assert searched(MIDDLE, workers=workers, range_size=5, watch=interrupt).interrupted
    assert joined[0]


@pytest.mark.release
def test_a_search_stopped_in_a_wider_attempt_still_has_what_the_narrower_one_found(monkeypatch):
    monkeypatch.setattr(regions, "WANTED", 1e-3)
    monkeypatch.setattr(regions, "CHEAP", 0.0)
    seen = []
    monkeypatch.setattr(
        run,
        "complete",
        lambda question, found, tried: (
            seen.append(found) or regions.complete(question, found, tried)
        ),
    )
    whole = searched(KINDS["front"])
    before = next(found for found in seen if len(found))
    assert len(seen) > seen.index(before) + 1

    def interrupt(progress):
        if progress.attempt == seen.index(before) + 1:
            raise KeyboardInterrupt

    outcome = searched(KINDS["front"], range_size=1, watch=interrupt)
    assert outcome.interrupted
    assert outcome.attempts < whole.attempts + 1
    assert {star.tobytes() for star in before.stars} <= {
        star.tobytes() for star in outcome.results.stars
    }


def test_progress_counts_what_was_done_here_for_its_rate(tmp_path):
    path = tmp_path / "file"
    searched(MIDDLE, range_size=50, checkpoint=checkpoint.opened(path, MIDDLE))
    path.write_bytes(b"".join(path.read_bytes().splitlines(keepends=True)[:4]))
    told = []
    searched(MIDDLE, range_size=10, checkpoint=checkpoint.opened(path, MIDDLE), watch=told.append)
    first = told[0]
    assert (first.done, first.blocks) == (160, 236)
    assert first.rate <= 10 / 1e-9
    assert first.seconds_left == pytest.approx(76 / first.rate)
    assert first.rate * first.seconds <= 10 * 1.001 + first.rate * 0.5


@pytest.mark.release
def test_every_block_counts_and_so_does_the_proof(monkeypatch, answers):
    """A search that skips a block, or stops too early, fails the tests above."""
    question, wanted = KINDS["front"], answers["front"]
    for block in range(0, halves.halves(question).block_count, 13):
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(
                run,
                "results_of",
                lambda s, gap=block: results_of(replace(s, stop=s.start) if s.start == gap else s),
            )
            assert answer_to(question, range_size=1) != wanted
    monkeypatch.setattr(regions, "WANTED", 1e-3)
    monkeypatch.setattr(regions, "CHEAP", 0.0)
    monkeypatch.setattr(run, "complete", lambda *_: True)
    assert answer_to(question).rows != wanted.rows


SCRIPT = """
import sys
from tests.search.asked import front
from crankstar.stars import checkpoint, executors, run
from contextlib import nullcontext
question = front(15)
def told(progress):
    print(progress.done, progress.blocks, flush=True)
    if progress.done >= 32 and not sys.stdin.closed:
        sys.stdin.read()
        sys.stdin.close()
if __name__ == "__main__":
    with executors.processes(2) if sys.argv[1] == "2" else nullcontext() as workers:
        kept = checkpoint.opened(run.checkpoints.Path(sys.argv[2]), question)
        outcome = run.searched(question, workers=workers, range_size=8, checkpoint=kept, watch=told)
    print("ended", outcome.interrupted, outcome.complete, len(outcome.results), flush=True)
"""


@contextmanager
def started(workers, path):
    """A search in a process group of its own, held after some stretches until its input ends."""
    process = subprocess.Popen(
        [sys.executable, "-c", SCRIPT, workers, str(path)],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    with process:
        assert process.stdout
        while int(process.stdout.readline().split()[0]) < 32:
            pass
        yield process


@pytest.fixture(scope="module")
def fifteen():
    return answer_to(front(15))


@pytest.mark.release
@pytest.mark.parametrize("workers", [pytest.param("0", marks=pytest.mark.release), "2"])
def test_sigterm_ends_a_search_quietly_with_its_workers_and_its_semaphores(workers, tmp_path):
    with started(workers, tmp_path / "file") as process:
        children = psutil.Process(process.pid).children(recursive=True)
        process.terminate()
        _, err = process.communicate(timeout=PATIENCE)
    assert (process.returncode, err) == (-signal.SIGTERM, "")
    assert not psutil.wait_procs(children, timeout=PATIENCE)[1]


@pytest.mark.release
@pytest.mark.parametrize("workers", ["0", "2"])
def test_ctrl_c_ends_quietly_with_what_is_under_way_and_nothing_is_lost(workers, tmp_path, fifteen):
    """No stretch is given out after it: those under way may still come."""
    path = tmp_path / "file"
    with started(workers, path) as process:
        os.killpg(process.pid, signal.SIGINT)
        out, err = process.communicate(timeout=PATIENCE)
    assert err == ""
    assert out.splitlines()[-1].startswith("ended True False ")
    assert len(out.splitlines()) <= 1 + distribution.AHEAD * int(workers)
    assert process.returncode == 0
    told = []
    kept = checkpoint.opened(path, front(15))
    assert answer_to(front(15), checkpoint=kept, range_size=100, watch=told.append) == fifteen
    assert told[0].done > 32


@pytest.mark.release
def test_a_search_killed_in_the_middle_goes_on_and_leaves_no_processes(tmp_path, fifteen):
    path = tmp_path / "file"
    with started("2", path) as process:
        children = psutil.Process(process.pid).children(recursive=True)
        assert len(children) >= 2
        os.kill(process.pid, signal.SIGKILL)
        process.communicate(timeout=PATIENCE)
    _, alive = psutil.wait_procs(children, timeout=PATIENCE)
    assert not alive
    written = path.read_bytes()
    path.write_bytes(written[: len(written) - 40])
    assert (
        answer_to(front(15), checkpoint=checkpoint.opened(path, front(15)), range_size=64)
        == fifteen
    )


@pytest.mark.release
def test_a_scheduler_that_does_not_answer_is_told(monkeypatch):
    monkeypatch.setattr(executors, "SCHEDULER_SECONDS", 1.0)
    with socket.create_server(("127.0.0.1", 0)) as silent:
        port = silent.getsockname()[1]
        for address in (
            f"tcp://127.0.0.1:{port}",
            "tcp://127.0.0.1:1",
            "nonsense://x",
            "no.such.host.invalid:1",
            "",
        ):
            with pytest.raises(SearchError, match="No dask scheduler answers"), cluster(address):
                pass


def _impatient(monkeypatch):
    """A scheduler and its workers are given up soon, now that they are known to be gone."""
    monkeypatch.setattr(executors, "SCHEDULER_SECONDS", 2.0)
    monkeypatch.setattr(executors, "LOOK_SECONDS", 0.5)


CLUSTER = """
import sys
from distributed import LocalCluster
if __name__ == "__main__":
    with LocalCluster(
        n_workers=1, threads_per_worker=1, dashboard_address=":0", silence_logs=50
    ) as found:
        print(found.scheduler_address, flush=True)
        sys.stdin.read()
"""


@pytest.mark.release
@pytest.mark.parametrize("way", [signal.SIGKILL, signal.SIGSTOP])
def test_a_scheduler_that_dies_or_falls_silent_in_the_middle_is_told(way, monkeypatch):
    with subprocess.Popen(
        [sys.executable, "-c", CLUSTER],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    ) as process:
        assert process.stdout
        address = process.stdout.readline().strip()
        children = psutil.Process(process.pid).children(recursive=True)
        hit = []

        def strike(progress):
            if progress.done > 40 and not hit:
                hit.append(progress.done)
                _impatient(monkeypatch)
                process.send_signal(way)

        try:
            with pytest.raises(SearchError, match="The scheduler at"), cluster(address) as workers:
                searched(front(15), workers=workers, range_size=8, watch=strike)
            assert hit
        finally:
            for child in [psutil.Process(process.pid), *children]:
                with suppress(psutil.NoSuchProcess):
                    child.kill()


@pytest.mark.release
def test_a_cluster_without_workers_is_told(monkeypatch):
    from distributed import Client

    wait = Client.wait_for_workers
    monkeypatch.setattr(
        Client, "wait_for_workers", lambda client, count, **_: wait(client, count, timeout=0.1)
    )
    with (
        local_cluster(0) as found,
        pytest.raises(SearchError, match="has no workers; start one"),
        cluster(found.scheduler_address),
    ):
        pass


@pytest.mark.parametrize("module", ["distributed.cfexecutor", "crankstar.stars.run"])
def test_a_result_that_is_lost_as_it_comes_is_a_loss_of_workers(module: str) -> None:
    """Dask's executor takes it for a traceback and unpacks it; a TypeError of the work is none."""
    space: dict[str, Any] = {"__name__": module}
    exec("def received(result):\n    kind, fault, frames = result", space)  # noqa: S102
    with pytest.raises(TypeError) as caught:
        space["received"](object())
    assert of_workers(caught.value) == (module == "distributed.cfexecutor")


@pytest.mark.release
def test_a_cluster_that_loses_all_its_workers_is_told(monkeypatch):
    def lose(_):
        found.scale(0)
        awaited(lambda: not found.scheduler.workers)
        _impatient(monkeypatch)

    with (
        local_cluster(1) as found,
        cluster(found.scheduler_address) as workers,
        pytest.raises(SearchError, match="has had no workers, for 2 s"),
    ):
        searched(front(15), workers=workers, range_size=8, watch=lose)
