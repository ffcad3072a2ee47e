"""Worker processes: slow or lost ones are replaced, each question is computed once."""

from __future__ import annotations

import asyncio
import os
import threading
from collections.abc import Awaitable, Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from tests.holding import PATIENCE, awaited, reached
from tests.server import chores

from crankstar.server import processes, workers
from crankstar.server.answers import Answers
from crankstar.server.refusal import Refused
from crankstar.server.workers import Workers


@pytest.fixture(autouse=True)
def patient(monkeypatch: pytest.MonkeyPatch) -> None:
    """A process may take its time to start on a busy machine."""
    monkeypatch.setattr(workers, "WAITING_SECONDS", PATIENCE)


@pytest.fixture
def pipe(tmp_path: Path) -> Path:
    """A named pipe that holds a process."""
    place = tmp_path / "pipe"
    os.mkfifo(place)
    return place


def with_workers(work: Callable[[Workers], Awaitable[Any]], *, count: int = 1) -> Any:
    """What comes of working with workers."""

    async def whole() -> Any:
        pool = Workers(count, seconds=PATIENCE)
        pool.begin()
        try:
            return await work(pool)
        finally:
            pool.end()

    with ThreadPoolExecutor(
        1
    ) as thread:  # a browser's tests may have a loop of their own in this one
        return thread.submit(asyncio.run, whole()).result()


async def refusal(answer: Awaitable[bytes]) -> tuple[int, str, Any]:
    with pytest.raises(Refused) as caught:
        await answer
    (fault,) = caught.value.faults
    return caught.value.status, fault.code, fault.values


@pytest.mark.release
def test_a_process_that_takes_too_long_or_is_lost_is_replaced_and_the_next_task_is_done() -> None:
    async def work(pool: Workers) -> list[Any]:
        first = await pool.do(chores.number)
        assert await pool.do(chores.number) == first
        pool.seconds = 0.5
        late = await refusal(pool.do(chores.for_ever))
        pool.seconds = PATIENCE
        second = await pool.do(chores.number)
        lost = await refusal(pool.do(chores.die))
        third = await pool.do(chores.number)
        assert len({first, second, third}) == 3
        return [late, lost]

    late, lost = with_workers(work)
    assert late == (503, "question.too-long", {"seconds": 0.5})
    assert lost == (503, "question.lost", {})


@pytest.mark.release
def test_a_task_is_ended_by_its_processor_time_and_not_because_it_had_to_wait(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    async def work(pool: Workers) -> Any:
        first = await pool.do(chores.number)
        pool.seconds = 0.2
        monkeypatch.setattr(workers, "GREATEST_SLOWNESS", PATIENCE / pool.seconds)
        assert await pool.do(chores.naps, 2 * pool.seconds) == b"rested"
        assert await pool.do(chores.number) == first
        late = await refusal(pool.do(chores.computes_for_ever))
        assert await pool.do(chores.number) != first
        return late

    assert with_workers(work) == (503, "question.too-long", {"seconds": 0.2})


@pytest.mark.release
def test_a_process_that_cannot_say_what_it_found_is_replaced_without_a_word(
    tmp_path: Path, capfd: Any
) -> None:
    async def work(pool: Workers) -> bytes:
        return await pool.do(chores.choke_once, str(tmp_path / "mark"))

    assert with_workers(work) == b"breathes"
    assert capfd.readouterr().err == ""


def test_a_process_that_is_just_being_started_when_all_ends_is_ended_too(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    starts, go_on = threading.Event(), threading.Event()

    @contextmanager
    def slow() -> Iterator[None]:
        starts.set()
        go_on.wait(PATIENCE)
        yield

    monkeypatch.setattr(processes, "held_back", slow)
    pool = Workers(1, seconds=1.0)
    with ThreadPoolExecutor(2) as threads:
        starting = threads.submit(pool.workers[0].ready)
        assert starts.wait(PATIENCE)
        ending = threads.submit(pool.end)
        awaited(lambda: pool.workers[0].ended)
        assert not ending.done()  # it waits for the start, or there would be nothing yet to end
        go_on.set()
        starting.result(PATIENCE)
        ending.result(PATIENCE)
    assert pool.workers[0].child is None
    pool.workers[0].ready()  # nor is another begun after the end
    assert pool.workers[0].child is None


@pytest.mark.release
def test_refusals_come_through_and_mistakes_of_ours_are_told_without_the_words_of_the_machine(
    capfd: Any,
) -> None:
    async def work(pool: Workers) -> list[Any]:
        return [
            await refusal(pool.do(chores.refuse)),
            await refusal(pool.do(chores.fail)),
            await pool.do(chores.number),
        ]

    refused, failed, number = with_workers(work)
    assert refused == (418, "request", {"sentence": "this is a teapot"})
    assert failed == (500, "question.failed", {})
    assert number.isdigit()
    assert "secret.py" in capfd.readouterr().err  # for the one who started the server


@pytest.mark.release
def test_a_process_works_on_while_another_is_busy(pipe: Path) -> None:
    async def work(pool: Workers) -> bytes:
        slow = asyncio.ensure_future(pool.do(chores.held, str(pipe)))
        with await asyncio.to_thread(reached, pipe):
            quick = [await pool.do(chores.number) for _ in range(5)]
            assert len(set(quick)) == 1
            assert not slow.done()
        return await slow

    assert with_workers(work, count=2) == b"held"


def test_too_many_who_wait_are_sent_away_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workers, "GREATEST_WAITING", 3)

    async def work(pool: Workers) -> list[Any]:
        pool.waiting = 0
        return await asyncio.gather(
            *(pool.do(chores.other, 1) for _ in range(8)), return_exceptions=True
        )

    answers = with_workers(work)
    refused = [answer for answer in answers if isinstance(answer, Refused)]
    assert {refusal.status for refusal in refused} == {503}
    assert answers.count(b"other") == 8 - len(refused) == 3


def test_who_has_waited_too_long_for_a_process_is_sent_away(
    monkeypatch: pytest.MonkeyPatch, pipe: Path
) -> None:
    async def work(pool: Workers) -> tuple[int, str, Any]:
        slow = asyncio.create_task(pool.do(chores.held, str(pipe)))
        with await asyncio.to_thread(reached, pipe), monkeypatch.context() as patch:
            patch.setattr(workers, "WAITING_SECONDS", 0.01)
            told = await refusal(pool.do(chores.number))
            assert not slow.done()
        await slow
        assert (await pool.do(chores.number)).isdigit()
        return told

    assert with_workers(work) == (503, "question.busy", {})


def test_a_question_that_many_ask_is_reckoned_once_and_its_answer_kept(tmp_path: Path) -> None:
    file = str(tmp_path / "counted.txt")

    async def work(pool: Workers) -> list[bytes]:
        answers = Answers(pool)
        first = await asyncio.gather(*(answers.to(chores.count, file) for _ in range(10)))
        return [*first, await answers.to(chores.count, file)]

    assert set(with_workers(work)) == {b"counted"}
    assert (tmp_path / "counted.txt").read_text() == "once\n"


def test_who_leaves_does_not_take_the_answer_from_the_others_and_what_nobody_waits_for_is_dropped(
    tmp_path: Path, pipe: Path
) -> None:
    kept, dropped = str(tmp_path / "kept.txt"), str(tmp_path / "dropped.txt")

    async def work(pool: Workers) -> bytes:
        answers = Answers(pool)
        leaves, stays = (
            asyncio.ensure_future(answers.to(chores.count, kept, str(pipe))) for _ in range(2)
        )
        with await asyncio.to_thread(reached, pipe):
            alone = asyncio.ensure_future(answers.to(chores.count, dropped))
            while not pool.waiting:
                await asyncio.sleep(0)
            leaves.cancel()
            alone.cancel()
            while pool.waiting:
                await asyncio.sleep(0)
        found = await stays
        await pool.do(chores.number)  # after what was dropped, were it still done
        return found

    assert with_workers(work) == b"counted"
    assert not (tmp_path / "dropped.txt").exists()


def test_answers_are_forgotten_when_there_are_too_many_of_them(tmp_path: Path) -> None:
    file = str(tmp_path / "counted.txt")

    async def work(pool: Workers) -> None:
        answers = Answers(pool, greatest=20)
        for _ in range(2):
            await answers.to(chores.count, file)
            for number in range(4):
                await answers.to(chores.other, number)
            assert answers.size <= 20

    with_workers(work)
    assert (tmp_path / "counted.txt").read_text() == "once\n" * 2


def test_a_worker_has_one_thread_for_matrices_and_its_maker_keeps_its_own_number(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv("MKL_NUM_THREADS", "3")
    monkeypatch.delenv("OPENBLAS_NUM_THREADS", raising=False)

    async def work(pool: Workers) -> bytes:
        return await pool.do(chores.threads)

    assert with_workers(work) == b"OPENBLAS_NUM_THREADS=1 MKL_NUM_THREADS=3"
    assert "OPENBLAS_NUM_THREADS" not in os.environ
