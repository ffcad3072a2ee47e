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
from tests.server import chores

from crankstar.server import processes, workers
from crankstar.server.answers import Answers
from crankstar.server.refusal import Refused
from crankstar.server.workers import Workers


def with_workers(
    work: Callable[[Workers], Awaitable[Any]], *, count: int = 1, seconds: float = 2.0
) -> Any:
    """What comes of working with workers."""

    async def whole() -> Any:
        pool = Workers(count, seconds=seconds)
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


@pytest.mark.long
def test_a_process_that_takes_too_long_or_is_lost_is_replaced_and_the_next_task_is_done() -> None:
    async def work(pool: Workers) -> list[Any]:
        first = await pool.do(chores.number)
        assert await pool.do(chores.number) == first
        late = await refusal(pool.do(chores.sleep, 60.0))
        second = await pool.do(chores.number)
        lost = await refusal(pool.do(chores.die))
        third = await pool.do(chores.number)
        assert len({first, second, third}) == 3
        return [late, lost]

    late, lost = with_workers(work, seconds=1.0)
    assert late == (503, "question.too-long", {"seconds": 1.0})
    assert lost == (503, "question.lost", {})


def test_a_process_that_cannot_say_what_it_found_is_replaced_without_a_word(
    tmp_path: Path, capfd: Any
) -> None:
    async def work(pool: Workers) -> bytes:
        return await pool.do(chores.choke_once, str(tmp_path / "mark"))

    assert with_workers(work, seconds=20.0) == b"breathes"
    assert capfd.readouterr().err == ""


def test_a_process_that_is_just_being_started_when_all_ends_is_ended_too(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    reached, go_on = threading.Event(), threading.Event()

    @contextmanager
    def slow() -> Iterator[None]:
        reached.set()
        go_on.wait(20)
        yield

    monkeypatch.setattr(processes, "held_back", slow)
    pool = Workers(1, seconds=1.0)
    with ThreadPoolExecutor(2) as threads:
        starting = threads.submit(pool.workers[0].ready)
        assert reached.wait(20)
        ending = threads.submit(pool.end)
        with pytest.raises(
            TimeoutError
        ):  # it waits for the start, or there would be nothing yet to end
            ending.result(0.3)
        go_on.set()
        starting.result(20)
        ending.result(20)
    assert pool.workers[0].child is None
    pool.workers[0].ready()  # nor is another begun after the end
    assert pool.workers[0].child is None


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


def test_a_process_works_on_while_another_is_busy() -> None:
    async def work(pool: Workers) -> bool:
        slow = asyncio.ensure_future(pool.do(chores.sleep, 1.0))
        await asyncio.sleep(0)
        quick = [await pool.do(chores.number) for _ in range(5)]
        assert len(set(quick)) == 1
        before = not slow.done()
        await slow
        return before

    assert with_workers(work, count=2, seconds=20.0)


def test_too_many_who_wait_are_sent_away_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(workers, "GREATEST_WAITING", 3)

    async def work(pool: Workers) -> list[Any]:
        pool.waiting = 0
        return await asyncio.gather(
            *(pool.do(chores.sleep, 0.05) for _ in range(8)), return_exceptions=True
        )

    answers = with_workers(work)
    refused = [answer for answer in answers if isinstance(answer, Refused)]
    assert {refusal.status for refusal in refused} == {503}
    assert answers.count(b"slept") == 8 - len(refused) == 3


def test_who_has_waited_too_long_for_a_process_is_sent_away(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(workers, "WAITING_SECONDS", 0.2)

    async def work(pool: Workers) -> tuple[int, str, Any]:
        while pool.idle.empty():
            await asyncio.sleep(0.05)
        slow = asyncio.create_task(pool.do(chores.sleep, 1.0))
        await asyncio.sleep(0.05)
        told = await refusal(pool.do(chores.number))
        assert not slow.done()
        await slow
        assert (await pool.do(chores.number)).isdigit()
        return told

    assert with_workers(work, seconds=20.0) == (503, "question.busy", {})


def test_a_question_that_many_ask_is_reckoned_once_and_its_answer_kept(tmp_path: Path) -> None:
    file = str(tmp_path / "counted.txt")

    async def work(pool: Workers) -> list[bytes]:
        answers = Answers(pool)
        first = await asyncio.gather(*(answers.to(chores.count, file) for _ in range(10)))
        return [*first, await answers.to(chores.count, file)]

    assert set(with_workers(work)) == {b"counted"}
    assert (tmp_path / "counted.txt").read_text() == "once\n"


def test_who_leaves_does_not_take_the_answer_from_the_others_and_what_nobody_waits_for_is_dropped(
    tmp_path: Path,
) -> None:
    kept, dropped = str(tmp_path / "kept.txt"), str(tmp_path / "dropped.txt")

    async def work(pool: Workers) -> bytes:
        answers = Answers(pool)
        await answers.to(chores.sleep, 0.0)
        leaves, stays = (asyncio.ensure_future(answers.to(chores.count, kept)) for _ in range(2))
        alone = asyncio.ensure_future(answers.to(chores.count, dropped))
        await asyncio.sleep(0.1)
        leaves.cancel()
        alone.cancel()
        found = await stays
        await asyncio.sleep(0.5)
        return found

    assert with_workers(work) == b"counted"
    assert not (tmp_path / "dropped.txt").exists()


def test_answers_are_forgotten_when_there_are_too_many_of_them(tmp_path: Path) -> None:
    file = str(tmp_path / "counted.txt")

    async def work(pool: Workers) -> None:
        answers = Answers(pool, greatest=20)
        for _ in range(2):
            await answers.to(chores.count, file)
            for wait in (0.0, 0.001, 0.002, 0.003):
                await answers.to(chores.sleep, wait)
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

    assert with_workers(work, seconds=20.0) == b"OPENBLAS_NUM_THREADS=1 MKL_NUM_THREADS=3"
    assert "OPENBLAS_NUM_THREADS" not in os.environ
