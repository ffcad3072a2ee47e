"""Fronts over stars and firing orders: whoever works, stopped and resumed; Python functions."""

from __future__ import annotations

import dataclasses
import signal
from concurrent.futures import BrokenExecutor, Future, ThreadPoolExecutor
from itertools import count as count_of
from pathlib import Path
from threading import Event
from typing import Any

import numpy as np
import pytest
from tests.holding import PATIENCE
from tests.search import plain_orders as plain

from crankstar import cli
from crankstar.options.sequences import sequences_of
from crankstar.options.words import SearchWords, SequenceWords
from crankstar.stars import checkpoint, executors, sequence_kernels, sequence_rows, sequence_work
from crankstar.stars.executors import Workers, cluster, processes, threads
from crankstar.stars.faults import SearchError
from crankstar.stars.progress import Progress
from crankstar.stars.sequence_fronts import SequenceFront, beaten, sequence_front
from crankstar.stars.shafts import Fired, Shaft, shaft_of
from crankstar.stars.vector_sums import (
    Cap,
    Goal,
    SequenceQuestion,
    couple,
    function_goal,
    straight,
    torsion,
)
from crankstar.tables.search_sequences import search_sequences


def asked(cylinders: int, minimise: str, bank: str | None = None) -> SequenceQuestion:
    words = SearchWords(minimise=minimise)
    return sequences_of(cylinders, words, SequenceWords(bank=bank)).question


EIGHT = asked(8, "M1,M2,twist")


@pytest.fixture
def many_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    """Small questions are divided as large ones are."""
    monkeypatch.setattr(sequence_work, "OF_A_PART", 1)


@pytest.fixture(scope="module")
def whole() -> SequenceFront:
    return sequence_front(EIGHT)


def same(front: SequenceFront, other: SequenceFront) -> bool:
    """All but the number of sequences that were formed, which is chance."""
    return dataclasses.replace(front, formed=other.formed) == other


class Losing(Workers):
    """Threads of which every third part is lost once."""

    def __init__(self, pool: ThreadPoolExecutor) -> None:
        super().__init__(pool, count=2)
        self.seen: set[int] = set()

    def submit(self, part: Any) -> Future[Any]:
        if part.start % 3 == 0 and part.start not in self.seen:
            self.seen.add(part.start)
            lost: Future[Any] = Future()
            lost.set_exception(BrokenExecutor("gone"))
            return lost
        return super().submit(part)


@pytest.mark.release
@pytest.mark.usefixtures("many_parts")
def test_threads_processes_and_lost_workers_change_nothing(whole: SequenceFront) -> None:
    with threads(3) as workers:
        assert same(sequence_front(EIGHT, workers=workers), whole)
    with ThreadPoolExecutor(2) as pool:
        losing = Losing(pool)
        assert same(sequence_front(EIGHT, workers=losing), whole)
        assert len(losing.seen) > 10


@pytest.mark.release
@pytest.mark.usefixtures("many_parts")
def test_processes_and_a_cluster_find_the_same_front(whole: SequenceFront) -> None:
    from distributed import LocalCluster

    with processes(2) as workers:
        assert same(sequence_front(EIGHT, workers=workers), whole)
    found: Any = LocalCluster(
        n_workers=1, threads_per_worker=1, dashboard_address=":0", silence_logs=50
    )
    with found, cluster(found.scheduler_address) as workers:
        assert same(sequence_front(EIGHT, workers=workers), whole)


@pytest.mark.many(first=1)
@pytest.mark.usefixtures("many_parts")
@pytest.mark.parametrize("count", [0, 1, 2])
def test_an_interrupted_front_goes_on_from_its_checkpoint(
    whole: SequenceFront, tmp_path: Path, count: int
) -> None:
    path = tmp_path / "kept"

    def interrupt(now: Progress) -> None:
        if now.done >= 20:
            signal.raise_signal(signal.SIGINT)

    pool = threads(count) if count else None
    with pool or threads(1) as workers:
        given = workers if count else None
        kept = checkpoint.opened(path, EIGHT)
        begun = sequence_front(EIGHT, workers=given, checkpoint=kept, watch=interrupt)
        assert not begun.complete
        assert 0 < begun.stars < whole.stars
        told: list[Progress] = []
        kept = checkpoint.opened(path, EIGHT)
        # the same workers can be given work again
        ended = sequence_front(EIGHT, workers=given, checkpoint=kept, watch=told.append)
    assert same(ended, whole)
    assert told[0].done > 20
    assert told[-1].done == told[-1].blocks
    assert told[-1].seconds_left == 0


@pytest.mark.release
@pytest.mark.parametrize("count", [0, 1])
def test_a_part_that_is_halted_is_shown_and_not_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, count: int
) -> None:
    """Ten in line in one part; the loops come up whenever their buffer is full."""
    about, path = asked(10, "M1,M2"), tmp_path / "kept"
    whole = sequence_front(about)
    monkeypatch.setattr(sequence_work, "PARTS", 1)
    monkeypatch.setattr(sequence_work, "BUFFER", 0)
    loops, calls = sequence_kernels.visited, count_of(1)
    pool = threads(1)
    pool_halt: Event | None = None

    def visited(*given: Any) -> bool:
        number = next(calls)
        if number == 3:
            signal.raise_signal(signal.SIGINT)
        if number > 3 and pool_halt is not None:
            pool_halt.wait(PATIENCE)  # the loops come up only when all is over
        return loops(*given)

    monkeypatch.setattr(sequence_kernels, "visited", visited)
    with pool as workers:
        pool_halt = workers.halt if count else None
        given = workers if count else None
        kept = checkpoint.opened(path, about)
        halted = sequence_front(about, workers=given, checkpoint=kept)
    assert not halted.complete
    assert halted.points
    assert 0 < halted.stars < whole.stars
    assert path.read_bytes().count(b"\n") == 1  # the head alone
    monkeypatch.setattr(sequence_kernels, "visited", loops)
    again = sequence_front(about, checkpoint=checkpoint.opened(path, about))
    assert same(again, whole)


@pytest.mark.release
@pytest.mark.usefixtures("many_parts")
def test_a_damaged_checkpoint_is_searched_again_where_it_is(
    whole: SequenceFront, tmp_path: Path
) -> None:
    path = tmp_path / "kept"
    sequence_front(EIGHT, checkpoint=checkpoint.opened(path, EIGHT))
    lines = path.read_bytes().splitlines(keepends=True)
    assert len(lines) > 30
    spoilt = [*lines[:5], b"nonsense\n", lines[6].replace(b"1", b"2", 3), *lines[9:-1]]
    path.write_bytes(b"".join(spoilt) + lines[-1][:40])
    told: list[Progress] = []
    kept = checkpoint.opened(path, EIGHT)
    assert same(sequence_front(EIGHT, checkpoint=kept, watch=told.append), whole)
    assert len(told) == 5  # two damaged, two missing, one broken off


def test_a_checkpoint_of_another_question_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "kept"
    kept = checkpoint.opened(path, EIGHT)
    sequence_front(EIGHT, checkpoint=kept)
    other = asked(8, "M1,twist")
    with pytest.raises(SearchError, match="another search"):
        sequence_front(other, checkpoint=kept)
    with pytest.raises(SearchError, match="another search"):
        checkpoint.opened(path, other)


@pytest.mark.release
def test_a_checkpoint_with_other_parts_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "kept"
    sequence_front(EIGHT, checkpoint=checkpoint.opened(path, EIGHT))
    monkeypatch.setattr(sequence_work, "OF_A_PART", 1)
    with pytest.raises(SearchError, match="another version"):
        sequence_front(EIGHT, checkpoint=checkpoint.opened(path, EIGHT))


@pytest.mark.release
def test_the_command_keeps_a_checkpoint_and_takes_a_cluster(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    place = str(tmp_path / "kept")
    line = ["search", "6", "--minimise", "M1,twist", "--checkpoint", place]
    first, second = (printed(line, capsys) for _ in range(2))
    assert first == second
    assert "Proved complete" in first
    taken: list[str] = []

    def stand_in(address: str) -> Any:
        taken.append(address)
        return threads(1)

    monkeypatch.setattr(executors, "cluster", stand_in)
    words = ["search", "6", "--minimise", "M1,twist", "--scheduler", "tcp://here:1"]
    assert printed(words, capsys) == first
    assert taken == ["tcp://here:1"]


def printed(line: list[str], capsys: pytest.CaptureFixture[str], code: int = 0) -> str:
    with pytest.raises(SystemExit) as ended:
        cli.main(line)
    told = capsys.readouterr()
    assert ended.value.code == code
    return told.err if code else told.out


@pytest.mark.release
@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--checkpoint", ""], "it is empty"),
        (["--scheduler", " "], "it is empty"),
        (["--checkpoint", "a.csv", "-o", "a.csv"], "this is the checkpoint"),
    ],
)
def test_a_mistake_of_who_works_is_said(
    words: list[str], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert said in printed(["search", "6", "--minimise", "twist", *words], capsys, code=2)


# ---- Python functions


def travel(shaft: Shaft, fired: Fired) -> float:
    """How far the firing jumps along the shaft in a cycle, which no sum of vectors says."""
    order = np.array(shaft.firing_order(fired))
    return float(np.abs(order - np.roll(order, -1)).max() + 0.01 * order[1])


def with_travel(about: SequenceQuestion, **more: Any) -> SequenceQuestion:
    goal = function_goal("travel", lambda fired: travel(about.shaft, fired), **more)
    return dataclasses.replace(about, goals=(*about.goals, goal))


@pytest.mark.many(first=4)
@pytest.mark.parametrize(
    ("cylinders", "bank", "words"),
    [
        (5, None, "M1,M2"),
        (6, None, "M1,twist"),
        (6, None, "neighbours"),
        (7, None, "M1,twist"),
        (6, "120", "M1,twist"),
        (8, "90", "M1,twist,neighbours"),
        (10, "72", "twist"),
    ],
)
@pytest.mark.usefixtures("many_parts")
def test_a_function_is_judged_for_every_order(cylinders: int, bank: str | None, words: str) -> None:
    """Beside all permutations that fit, judged by their numbers alone."""
    about = with_travel(asked(cylinders, words, bank))
    orders, fires = plain.angles(cylinders, 720, float(bank or 0))
    places = np.repeat(np.array(about.shaft.places, float), about.shaft.rods)
    columns = []
    for goal in about.goals[:-1]:
        if goal.neighbours:
            columns.append(plain.neighbours(orders, vee=bank is not None))
            continue
        sums = [
            plain.torsion(float(one.order), fires, np.array(one.weights, float))
            if one.kind == "T"
            else plain.shaking(one.kind, int(one.order), fires, places, float(bank or 0))
            for one in goal.sums
        ]
        columns.append(np.max(sums, axis=0))
    own = orders.astype(int)
    columns.append(np.abs(own - np.roll(own, -1, axis=1)).max(axis=1) + 0.01 * own[:, 1])
    wanted = plain.front(np.column_stack(columns))
    with threads(2) as workers:
        found = sequence_front(about, workers=workers)
    assert found.evaluated == len(orders)
    assert [point.orders for point in found.points] == [count for _, count in wanted]
    ours = np.array([point.values for point in found.points])
    assert np.allclose(ours, [values for values, _ in wanted], rtol=0, atol=1e-8)


@pytest.mark.release
def test_a_function_alone_and_its_limit_choose_the_orders() -> None:
    six = shaft_of(6)
    orders, _ = plain.angles(6, 720, 0)
    own = orders.astype(int)
    plainly = np.abs(own - np.roll(own, -1, axis=1)).max(axis=1) + 0.01 * own[:, 1]
    goal = function_goal("travel", lambda fired: travel(six, fired))
    (point,) = sequence_front(SequenceQuestion(six, (goal,))).points
    assert point.values == (plainly.min(),)
    assert point.orders == (np.abs(plainly - plainly.min()) < 1e-9).sum()
    couples = SequenceQuestion(six, (Goal("M1", (couple(six, 1),)),))
    for greatest in (4.035, 3.035):
        about = with_travel(couples, greatest=greatest)
        found = sequence_front(about).points
        assert all(each.values[1] <= greatest for each in found)
        assert bool(found) == bool((plainly <= greatest).any())
        assert about.within(six.fired_in((1, 5, 3, 6, 2, 4))) == (greatest > plainly.max())


def test_mirror_images_are_judged_once_where_a_function_says_that_they_are_alike() -> None:
    six = shaft_of(6)
    calls: list[Fired] = []

    def gap(fired: Fired) -> float:
        calls.append(fired)
        order = six.firing_order(fired)
        return abs(order.index(6) - 3)

    couples = Goal("M1", (couple(six, 1),))
    apart = sequence_front(SequenceQuestion(six, (couples, function_goal("gap", gap))))
    whole, calls[:] = len(calls), []
    goal = function_goal("gap", gap, symmetric=True)
    alike = sequence_front(SequenceQuestion(six, (couples, goal)))
    assert whole == six.count * six.sequences
    assert whole / 2 <= len(calls) < 0.7 * whole
    assert [(p.values, p.orders) for p in alike.points] == [
        (p.values, p.orders) for p in apart.points
    ]


@pytest.mark.parametrize(
    ("names", "code"),
    [
        (["", "x"], "function-name"),
        ([" "], "function-name"),
        (["a\nb"], "function-name"),
        (["M1"], "named-twice"),
        (["x", "x"], "named-twice"),
    ],
)
def test_the_goals_of_a_question_have_names_of_their_own(names: list[str], code: str) -> None:
    about = asked(6, "M1,M2")
    functions = [function_goal(name, lambda _fired: 0.0) for name in names]
    with pytest.raises(SearchError) as raised:
        dataclasses.replace(about, goals=(*about.goals, *functions))
    assert [fault.code for fault in raised.value.faults] == [code]


def test_what_a_function_cannot_do_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    six = shaft_of(6)
    couples = SequenceQuestion(six, (Goal("M1", (couple(six, 1),)),))

    def front_of(function: Any, **more: Any) -> SequenceFront:
        goal = function_goal("mine", function, **more)
        return sequence_front(dataclasses.replace(couples, goals=(*couples.goals, goal)))

    with pytest.raises(SearchError, match=r"mine fails for the firing order 1-.*ZeroDivision"):
        front_of(lambda _fired: 1 / 0)
    with pytest.raises(SearchError, match="mine is nan for the firing order 1-"):
        front_of(lambda _fired: float("nan"))
    with pytest.raises(SearchError, match="the limit is not a number"):
        front_of(len, greatest=float("nan"))
    ten = shaft_of(12)
    twist = Goal("T0.5", (torsion(ten, straight(ten)[0] / 2, straight(ten)),))
    many = SequenceQuestion(ten, (twist, function_goal("mine", len)))
    with pytest.raises(SearchError, match="More than 200,000 firing orders"):
        sequence_front(many)
    monkeypatch.setattr(sequence_rows, "GREATEST_LIST", 50)
    with pytest.raises(SearchError, match="More than 50 firing orders"):
        front_of(len)


@pytest.mark.release
def test_limits_leave_few_enough_orders_of_many_for_a_function() -> None:
    """Of a twelve in line 1.2 million stars; without both couples and order 3 they are few."""
    twelve = shaft_of(10)
    caps = (Cap(couple(twelve, 1)), Cap(couple(twelve, 2)))
    first = function_goal("second", lambda fired: float(twelve.firing_order(fired)[1]))
    found = sequence_front(SequenceQuestion(twelve, (first,), caps))
    assert 0 < found.evaluated < 200_000
    assert all(
        couple(twelve, 1).length(twelve, fired) == 0
        for point in found.points
        for fired in (point.fired, *point.like)
    )


def test_a_table_tells_of_a_function_and_of_the_order_that_was_typed() -> None:
    about = with_travel(asked(6, "M1,twist"), unit="mm")
    usual = about.shaft.fired_in((1, 5, 3, 6, 2, 4))
    front = sequence_front(about)
    values, _ = beaten(front, usual)
    assert values[2] == pytest.approx(4.05)
    document = search_sequences(front, why=usual)
    told = " ".join(line for part in document.parts for line in getattr(part, "lines", ()))
    assert "1-5-3-6-2-4 is" in told
    assert "travel is a Python function, called for each of the 120 firing orders" in told


@pytest.mark.release
def test_a_function_that_is_asked_again_goes_on_from_a_checkpoint(tmp_path: Path) -> None:
    about, path = with_travel(asked(6, "M1,twist")), tmp_path / "kept"
    plainly = sequence_front(about)
    assert same(sequence_front(about, checkpoint=checkpoint.opened(path, about)), plainly)
    size = path.stat().st_size
    assert same(sequence_front(about, checkpoint=checkpoint.opened(path, about)), plainly)
    assert path.stat().st_size == size
