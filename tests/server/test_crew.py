"""Processes that reckon: one that takes too long or is lost is replaced, a question is reckoned once, answers are kept."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Awaitable, Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from tests.server import chores

from crankstar.server import crew as crews
from crankstar.server.answers import Answers
from crankstar.server.crew import Processes
from crankstar.server.refusal import Refused


def with_crew(work: Callable[[Processes], Awaitable[Any]], *, count: int = 1, seconds: float = 2.0) -> Any:
    """What comes of working with a crew."""

    async def whole() -> Any:
        crew = Processes(count, seconds=seconds)
        crew.begin()
        try:
            return await work(crew)
        finally:
            crew.end()

    with ThreadPoolExecutor(1) as thread:  # a browser's tests may have a loop of their own in this one
        return thread.submit(asyncio.run, whole()).result()


async def refusal(answer: Awaitable[bytes]) -> tuple[int, str]:
    with pytest.raises(Refused) as caught:
        await answer
    return caught.value.status, caught.value.problems[0][1]


def test_a_process_that_takes_too_long_or_is_lost_is_replaced_and_the_next_task_is_done() -> None:
    async def work(crew: Processes) -> list[Any]:
        first = await crew.do(chores.number)
        assert await crew.do(chores.number) == first
        late = await refusal(crew.do(chores.sleep, 60.0))
        second = await crew.do(chores.number)
        lost = await refusal(crew.do(chores.die))
        third = await crew.do(chores.number)
        assert len({first, second, third}) == 3
        return [late, lost]

    late, lost = with_crew(work, seconds=1.0)
    assert late == (503, crews.TOO_LONG.format(seconds=1.0))
    assert lost == (503, crews.LOST)


def test_a_process_that_cannot_say_what_it_found_is_replaced_without_a_word(tmp_path: Path, capfd: Any) -> None:
    async def work(crew: Processes) -> bytes:
        return await crew.do(chores.choke_once, str(tmp_path / "mark"))

    assert with_crew(work, seconds=20.0) == b"breathes"
    assert capfd.readouterr().err == ""


def test_a_process_that_is_just_being_started_when_all_ends_is_ended_too(monkeypatch: pytest.MonkeyPatch) -> None:
    reached, go_on = threading.Event(), threading.Event()

    @contextmanager
    def slow() -> Iterator[None]:
        reached.set()
        go_on.wait(20)
        yield

    monkeypatch.setattr(crews, "held_back", slow)
    crew = Processes(1, seconds=1.0)
    with ThreadPoolExecutor(2) as threads:
        starting = threads.submit(crew.workers[0].ready)
        assert reached.wait(20)
        ending = threads.submit(crew.end)
        with pytest.raises(TimeoutError):  # it waits for the start, or there would be nothing yet to end
            ending.result(0.3)
        go_on.set()
        starting.result(20)
        ending.result(20)
    assert crew.workers[0].process is None
    crew.workers[0].ready()  # nor is another begun after the end
    assert crew.workers[0].process is None


def test_refusals_come_through_and_mistakes_of_ours_are_told_without_the_words_of_the_machine(capfd: Any) -> None:
    async def work(crew: Processes) -> list[Any]:
        return [await refusal(crew.do(chores.refuse)), await refusal(crew.do(chores.fail)), await crew.do(chores.number)]

    refused, failed, number = with_crew(work)
    assert refused == (418, "this is a teapot")
    assert failed == (500, crews.FAILED)
    assert number.isdigit()
    assert "secret.py" in capfd.readouterr().err  # for the one who started the server


def test_a_process_works_on_while_another_is_busy() -> None:
    async def work(crew: Processes) -> bool:
        slow = asyncio.ensure_future(crew.do(chores.sleep, 1.0))
        await asyncio.sleep(0)
        quick = [await crew.do(chores.number) for _ in range(5)]
        assert len(set(quick)) == 1
        before = not slow.done()
        await slow
        return before

    assert with_crew(work, count=2, seconds=20.0)


def test_too_many_who_wait_are_sent_away_at_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(crews, "GREATEST_WAITING", 3)

    async def work(crew: Processes) -> list[Any]:
        crew.waiting = 0
        return await asyncio.gather(*(crew.do(chores.sleep, 0.05) for _ in range(8)), return_exceptions=True)

    answers = with_crew(work)
    refused = [answer for answer in answers if isinstance(answer, Refused)]
    assert {refusal.status for refusal in refused} == {503}
    assert answers.count(b"slept") == 8 - len(refused) == 3


def test_who_has_waited_too_long_for_a_process_is_sent_away(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(crews, "WAITING_SECONDS", 0.2)

    async def work(crew: Processes) -> tuple[int, str]:
        while crew.idle.empty():
            await asyncio.sleep(0.05)
        slow = asyncio.create_task(crew.do(chores.sleep, 1.0))
        await asyncio.sleep(0.05)
        told = await refusal(crew.do(chores.number))
        assert not slow.done()
        await slow
        assert (await crew.do(chores.number)).isdigit()
        return told

    assert with_crew(work, seconds=20.0) == (503, crews.BUSY)


def test_a_question_that_many_ask_is_reckoned_once_and_its_answer_kept(tmp_path: Path) -> None:
    file = str(tmp_path / "counted.txt")

    async def work(crew: Processes) -> list[bytes]:
        answers = Answers(crew)
        first = await asyncio.gather(*(answers.to(chores.count, file) for _ in range(10)))
        return [*first, await answers.to(chores.count, file)]

    assert set(with_crew(work)) == {b"counted"}
    assert (tmp_path / "counted.txt").read_text() == "once\n"


def test_who_leaves_does_not_take_the_answer_from_the_others_and_what_nobody_waits_for_is_dropped(tmp_path: Path) -> None:
    kept, dropped = str(tmp_path / "kept.txt"), str(tmp_path / "dropped.txt")

    async def work(crew: Processes) -> bytes:
        answers = Answers(crew)
        await answers.to(chores.sleep, 0.0)
        leaves, stays = (asyncio.ensure_future(answers.to(chores.count, kept)) for _ in range(2))
        alone = asyncio.ensure_future(answers.to(chores.count, dropped))
        await asyncio.sleep(0.1)
        leaves.cancel()
        alone.cancel()
        found = await stays
        await asyncio.sleep(0.5)
        return found

    assert with_crew(work) == b"counted"
    assert not (tmp_path / "dropped.txt").exists()


def test_answers_are_forgotten_when_there_are_too_many_of_them(tmp_path: Path) -> None:
    file = str(tmp_path / "counted.txt")

    async def work(crew: Processes) -> None:
        answers = Answers(crew, greatest=20)
        for _ in range(2):
            await answers.to(chores.count, file)
            for wait in (0.0, 0.001, 0.002, 0.003):
                await answers.to(chores.sleep, wait)
            assert answers.size <= 20

    with_crew(work)
    assert (tmp_path / "counted.txt").read_text() == "once\n" * 2
