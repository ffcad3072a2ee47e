"""Searches over HTTP: start, progress, stop, limits; results are those of the package."""

from __future__ import annotations

import json
from itertools import count
from multiprocessing import Pipe
from time import monotonic
from types import SimpleNamespace
from typing import Any

import pytest
from tests.holding import PATIENCE, awaited
from tests.server import chores
from tests.web.serving import Server, serving

import crankstar
from crankstar import files
from crankstar.language.messages import spoken
from crankstar.options.search import search_of
from crankstar.options.words import SearchWords
from crankstar.server import processes, search_process, searches
from crankstar.server.messages import SearchQuestion
from crankstar.server.refusal import Refused, said
from crankstar.server.searches import Searches
from crankstar.stars import estimates
from crankstar.stars.answer import answer_to

LONG = {"cylinders": 15, "cycle": "two-stroke", "minimise": "M1,M2,M3", "front": True}
"""Takes minutes."""


def begun(server: Server, question: Any) -> Any:
    answer = server.ask("api/search", question)
    assert answer.status == 200, answer.body
    return answer.json


def looked(server: Server, search: Any) -> Any:
    return server.ask(f"api/search/{search['id']}").json


def stopped(server: Server, search: Any) -> Any:
    """The search once it has been stopped."""
    assert server.ask(f"api/search/{search['id']}", method="DELETE").status == 200
    search = ended(server, search)
    assert search["state"] == "cancelled"
    return search


def ended(server: Server, search: Any) -> Any:
    """The search once it has ended."""
    return awaited(lambda: over(looked(server, search)))


def over(search: Any) -> Any:
    """A search that has ended; None while it runs."""
    return None if search["state"] == "running" else search


@pytest.mark.release
def test_a_search_finds_what_the_package_finds_and_each_row_makes_its_engine(
    server: Server,
) -> None:
    search = ended(server, begun(server, {"cylinders": 7, "cycle": "two-stroke"}))
    ours = answer_to(search_of(7, SearchWords(cycle="two-stroke")).question)
    assert search["state"] == "done"
    assert search["done"] == search["blocks"] > 0
    assert "Proved complete" in search["sentences"][-1]
    assert len(search["rows"]) == len(ours.rows)
    for row in search["rows"]:
        engine = files.engine_of(row["tree"])
        assert (
            "-".join(map(str, engine.firing_order))
            == row["cells"][search["heads"].index("firing order")]
        )


@pytest.mark.release
def test_of_many_rows_the_first_are_sent_and_that_is_said(server: Server) -> None:
    search = ended(
        server, begun(server, {"cylinders": 7, "cycle": "two-stroke", "minimise": "M1", "best": 80})
    )
    assert len(search["rows"]) == search_process.ROWS
    told = next(sentence for sentence in search["sentences"] if "rows are shown" in sentence)
    assert told.startswith(f"{search_process.ROWS} of ")
    assert "`crankstar search` with -o FILE.csv" in told


@pytest.mark.release
def test_the_cranks_of_an_engine_keep_its_cylinders(server: Server) -> None:
    search = ended(server, begun(server, {"engine": "audi-25-tfsi", "minimise": "M1", "best": 3}))
    assert len(search["rows"]) == 3
    assert any("The engine as it is" in sentence for sentence in search["sentences"])
    audi = crankstar.load("audi-25-tfsi")
    for row in search["rows"]:
        assert [c.rod_length for c in files.engine_of(row["tree"]).cylinders] == [
            c.rod_length for c in audi.cylinders
        ]


@pytest.mark.parametrize(
    ("question", "path", "told"),
    [
        ({}, "", "an engine or a number of cylinders"),
        ({"engine": "i4", "cylinders": 4}, "", "an engine or a number of cylinders"),
        ({"engine": "v8-cross-plane"}, "", "stand two on a throw"),
        ({"engine": "no such"}, "engine", "no such engine"),
        ({"cylinders": 1}, "cylinders", "at least 2"),
        ({"cylinders": 7, "minimise": "M1--fix --best"}, "minimise", '"M1--fix --best"'),
        ({"cylinders": 7, "zero": "neighbours"}, "zero", "Use `avoid_adjacent`"),
        ({"cylinders": 7, "limit": ["M1"]}, "limit", "M1: "),
        ({"cylinders": 7, "best": 3, "front": True}, "", "`front`, `best`"),
        ({"cylinders": 7, "best": 201}, "best", "at most 200"),
        ({"cylinders": 7, "minimise": "M1" * 400}, "minimise", "500"),
        ({"cylinders": 7, "engine": {"name": "x"}}, "", "an engine or a number of cylinders"),
    ],
)
def test_a_faulty_question_is_refused_at_once_at_the_key_of_its_option(
    question: Any, path: str, told: str, server: Server
) -> None:
    answer = server.ask("api/search", question)
    assert answer.status == 422
    (problem,) = answer.json["problems"]
    assert problem["path"] == path
    assert told in problem["message"]


def test_a_search_that_is_too_great_says_so(server: Server) -> None:
    search = ended(server, begun(server, {"cylinders": 24, "cycle": "two-stroke"}))
    assert search["state"] == "failed"
    assert "Fix at least" in search["note"]


def test_a_search_that_takes_too_long_for_a_page_is_not_begun(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(estimates, "estimate", lambda _: 2 * search_process.LONGEST_SECONDS)
    near, _far = Pipe()
    reporter = search_process._Reporter(near)
    with pytest.raises(Refused) as caught:
        search_process.ended(SearchQuestion(cylinders=9, cycle="two-stroke").model_dump(), reporter)
    assert "takes about 20 min on one processor, too long for a page" in said(
        caught.value.faults[0]
    )


@pytest.mark.release
def test_searches_are_stopped_with_what_they_have_and_only_so_many_run_at_once() -> None:
    with serving() as server:
        first, second = begun(server, LONG), begun(server, LONG)
        crowded = server.ask("api/search", LONG)
        assert crowded.status == 429
        assert "searches are running" in crowded.json["problems"][0]["message"]
        stopped(server, second)
        awaited(lambda: looked(server, first)["done"])
        assert looked(server, first)["state"] == "running"
        (incomplete,) = [
            sentence for sentence in stopped(server, first)["sentences"] if "INCOMPLETE" in sentence
        ]
        assert incomplete.endswith(f" {search_process.RESUME}.")
        again = begun(server, {"cylinders": 4, "cycle": "two-stroke", "minimise": "M1"})
        assert ended(server, again)["state"] == "done"


@pytest.mark.release
def test_a_search_that_takes_much_longer_than_was_thought_is_stopped(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(searches, "STOPPED_SECONDS", 0.0)
    every = Searches()
    try:
        search = json.loads(every.begun(SearchQuestion.model_validate(LONG).model_dump()))
        search = awaited(lambda: over(json.loads(every.shown(search["id"]))))
        assert search["state"] == "cancelled"
    finally:
        every.end()


@pytest.mark.parametrize("compiles", [False, True], ids=["as it starts", "as it compiles"])
def test_a_search_is_stopped_at_once_before_anything_was_found(
    compiles: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An exception in the midst of compiling would be lost, or make it fail."""
    monkeypatch.setattr(search_process, "work", chores.compile_for_ever)
    every = Searches()
    try:
        identity = json.loads(every.begun(SearchQuestion.model_validate(LONG).model_dump()))["id"]
        if compiles:
            awaited(lambda: json.loads(every.shown(identity))["note"] == "compiling")
        every.stopped(identity)
        search = json.loads(every.shown(identity))
        assert search["state"] == "cancelled"
        assert search["sentences"] == ["Stopped before anything was found."]
        awaited(lambda: not every._searches[identity]._child.alive)
    finally:
        every.end()


def test_what_is_said_of_a_lost_search_is_in_the_language_of_the_server(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    class Lost:
        pipe = SimpleNamespace(close=lambda: None)

        def __init__(self, *_: Any) -> None: ...

        def receive(self, _: float) -> Any:
            raise EOFError

        def kill(self) -> None: ...

    monkeypatch.setattr(searches, "Child", Lost)
    monkeypatch.setattr(searches, "LOST", "force")
    with spoken("ja"):
        search = searches._Search({})
    awaited(lambda: search.state != "running")
    assert (search.state, search.note) == ("failed", "慣性力")


def test_a_process_speaks_the_language_of_the_server() -> None:
    with spoken("ja"):
        child = processes.Child(chores.say)
    assert child.receive(PATIENCE) == "慣性力"


def test_a_search_that_is_not_there_is_told_of(server: Server) -> None:
    for method in ("GET", "DELETE"):
        answer = server.ask("api/search/nothing", method=method)
        assert answer.status == 404
        assert "There is no such search" in answer.json["problems"][0]["message"]


def test_the_oldest_of_many_searches_are_forgotten(monkeypatch: pytest.MonkeyPatch) -> None:
    numbers = count()

    class Ended:
        state, ended = "done", monotonic()

        def __init__(self, _: Any) -> None:
            self.identity = str(next(numbers))

        def shown(self) -> bytes:
            return self.identity.encode()

    monkeypatch.setattr(searches, "_Search", Ended)
    monkeypatch.setattr(searches, "GREATEST_KEPT", 3)
    every = Searches()
    for _ in range(6):
        every.begun({})
    assert [every.shown(identity) for identity in ("3", "4", "5")] == [b"3", b"4", b"5"]
    for gone in ("0", "2"):
        with pytest.raises(Refused):
            every.shown(gone)
