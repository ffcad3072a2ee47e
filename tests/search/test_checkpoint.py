"""A search in a file: whatever happens to the file, the answer is the right one or a sentence."""

import json
import random
import resource
from dataclasses import replace
from pathlib import Path
from zlib import crc32

import pytest
from tests.search.asked import front

from crankstar.stars import checkpoint, regions, run
from crankstar.stars.answer import answer_to
from crankstar.stars.faults import SearchError
from crankstar.stars.halves import halves
from crankstar.stars.question import Best
from crankstar.stars.run import searched

QUESTION = front(9)
BLOCKS = halves(QUESTION).block_count


@pytest.fixture(scope="module")
def answer():
    return answer_to(QUESTION)


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """The lines of a checkpoint of the whole search, seven blocks to a stretch."""
    path = tmp_path_factory.mktemp("whole") / "file"
    searched(QUESTION, checkpoint=checkpoint.opened(path, QUESTION), range_size=7)
    return path.read_bytes().splitlines(keepends=True)


def resumed(path: Path, **more):
    return answer_to(QUESTION, checkpoint=checkpoint.opened(path, QUESTION), **more)


def with_sum(body):
    text = json.dumps(body, separators=(",", ":"))
    return (
        json.dumps({"done": body, "sum": crc32(text.encode())}, separators=(",", ":")).encode()
        + b"\n"
    )


def test_a_finished_search_is_answered_without_any_work(tmp_path, written, answer, monkeypatch):
    path = tmp_path / "file"
    path.write_bytes(b"".join(written))
    monkeypatch.setattr(run, "results_of", None)
    assert resumed(path) == answer
    assert path.read_bytes() == b"".join(written)


@pytest.mark.many(first=2)
@pytest.mark.parametrize("size", [1, 3, 7, 1000])
def test_a_search_goes_on_with_stretches_of_another_size(tmp_path, written, answer, size):
    path = tmp_path / "file"
    path.write_bytes(b"".join([written[0], written[2], written[4]]))
    told = []
    assert resumed(path, range_size=size, watch=told.append) == answer
    assert told[0].done == 14 + min(size, 7)
    assert told[-1].done == BLOCKS


@pytest.mark.release
def test_a_file_cut_at_any_byte_gives_the_same_answer(tmp_path, written, answer):
    path = tmp_path / "file"
    start = len(b"".join(written[:-1]))
    whole = b"".join(written)
    for length in [*range(len(written[0]) + 2), *range(start - 2, len(whole) + 1)]:
        path.write_bytes(whole[:length])
        assert resumed(path, range_size=BLOCKS) == answer
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(run, "results_of", None)
            assert resumed(path) == answer


@pytest.mark.many(first=16)
@pytest.mark.parametrize("seed", range(20))
def test_a_damaged_line_is_done_again(tmp_path, written, answer, seed):
    chance = random.Random(seed)  # noqa: S311
    lines = [bytearray(line) for line in written]
    for _ in range(3):
        line = chance.choice(lines[1:])
        line[chance.randrange(len(line))] = chance.randrange(256)
    path = tmp_path / "file"
    path.write_bytes(b"".join(lines))
    assert resumed(path) == answer


@pytest.mark.parametrize(
    "line",
    [
        b"\n",
        b"\0\0\0\n",
        b"[]\n",
        b"3\n",
        b"null\n",
        b'{"done":3,"sum":3}\n',
        b"[" * 100_000 + b"\n",
        "ü\n".encode(),
    ],
)
def test_a_line_of_another_shape_is_passed_over(tmp_path, written, answer, line):
    path = tmp_path / "file"
    path.write_bytes(b"".join([written[0], line, *written[2:], line]))
    assert resumed(path) == answer


@pytest.mark.parametrize(
    "span",
    [
        [0, 7],
        [3, 10],
        [0, BLOCKS],
        [6, 8],
        [BLOCKS - 1, BLOCKS],
        [0, BLOCKS + 1],
        [-1, 3],
        [5, 5],
        [9, 3],
    ],
)
def test_no_block_is_counted_twice(tmp_path, written, answer, span):
    body = json.loads(written[1])["done"]
    path = tmp_path / "file"
    path.write_bytes(b"".join([*written, with_sum({**body, "blocks": span})]))
    assert resumed(path) == answer


def test_two_searches_at_once_on_one_file_are_both_right(tmp_path, answer):
    path = tmp_path / "file"
    one, other = checkpoint.opened(path, QUESTION), checkpoint.opened(path, QUESTION)

    def meanwhile(progress):
        if progress.done == 10:
            assert answer_to(QUESTION, checkpoint=other, range_size=4) == answer

    assert answer_to(QUESTION, checkpoint=one, range_size=5, watch=meanwhile) == answer
    assert resumed(path) == answer


def test_the_strips_of_every_attempt_must_be_those_of_the_file(tmp_path, monkeypatch):
    monkeypatch.setattr(regions, "WANTED", 1e-3)
    monkeypatch.setattr(regions, "CHEAP", 0.0)
    wanted = answer_to(QUESTION)
    assert wanted.certificate.attempts > 2
    path = tmp_path / "file"
    assert resumed(path, range_size=7) == wanted
    lines = path.read_bytes().splitlines(keepends=True)
    path.write_bytes(b"".join(lines[: len(lines) // 2]))
    assert resumed(path, range_size=5) == wanted
    monkeypatch.setattr(regions, "WANTED", 2e-3)
    with pytest.raises(SearchError, match="another version"):
        resumed(path)


@pytest.mark.parametrize(
    "other",
    [
        front(8),
        replace(QUESTION, ask=Best(3), objectives=QUESTION.objectives[:1]),
        front(9, "four-stroke"),
    ],
)
def test_the_checkpoint_of_another_search_is_refused(tmp_path, written, other):
    path = tmp_path / "file"
    path.write_bytes(b"".join(written))
    with pytest.raises(SearchError, match="another search"):
        checkpoint.opened(path, other)
    with pytest.raises(SearchError, match="another search"):
        searched(other, checkpoint=checkpoint.opened(path, QUESTION))
    assert path.read_bytes() == b"".join(written)


@pytest.mark.parametrize(
    "content",
    [b"\x80\x04\x95\0\n", b'{"crankstar_search":2}\n', b"[]\n", b"format = 1", b"\n", b"\0" * 99],
)
def test_a_file_that_is_no_checkpoint_is_refused_and_left_alone(tmp_path, content):
    path = tmp_path / "file"
    path.write_bytes(content)
    with pytest.raises(SearchError, match="is not a checkpoint"):
        resumed(path)
    assert path.read_bytes() == content


def test_a_file_that_cannot_be_is_told(tmp_path):
    for path in (tmp_path, Path("/dev/zero")):
        with pytest.raises(SearchError, match="is not a file"):
            resumed(path)
    with pytest.raises(
        SearchError, match=r"cannot be written \(No such file.*; name another file with checkpoint"
    ):
        resumed(tmp_path / "no" / "file")


def test_a_file_that_cannot_be_written_any_more_ends_the_search(tmp_path):
    kept = checkpoint.opened(tmp_path / "file", QUESTION)

    def removed(_):
        (tmp_path / "file").unlink()
        (tmp_path / "file").mkdir()

    with pytest.raises(SearchError, match=r"cannot be written \(Is a directory\)"):
        searched(QUESTION, checkpoint=kept, watch=removed, range_size=3)


def test_a_full_disk_ends_the_search_and_costs_the_last_line_only(tmp_path, written, answer):
    path = tmp_path / "file"
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (len(b"".join(written[:3])) + 9, before[1]))
    try:
        with pytest.raises(SearchError, match=r"cannot be written \(the disk is full\)"):
            resumed(path, range_size=7)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert path.read_bytes().startswith(b"".join(written[:3]))
    told = []
    assert resumed(path, watch=told.append) == answer
    assert told[0].done > 14
