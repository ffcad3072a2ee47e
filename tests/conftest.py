"""How thoroughly random engines are tried, which tests are of which tier; signals, width, fonts.

`HYPOTHESIS_PROFILE=release` tries many engines, others each time; a seed repeats them.
"""

import os
import signal
from collections import Counter
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import HealthCheck, settings
from hypothesis.internal.conjecture import providers
from tests.fonts import only_of_packages
from tests.pythons import installable

for name in ("COLUMNS", "CRANKSTAR_LANG", "LANGUAGE", "LC_ALL"):
    os.environ.pop(name, None)  # of the one who started the suite
os.environ["LC_MESSAGES"] = "C"

PACKAGE = Path(__file__).parents[1] / "src" / "crankstar"
USUAL_MODULE = 400
"""Lines of a module from which on it should perhaps be two."""

settings.register_profile(
    "gate",
    max_examples=8,
    derandomize=True,
    deadline=None,
    database=None,
    print_blob=True,
    suppress_health_check=[HealthCheck.too_slow],
)
settings.register_profile(
    "release", settings.get_profile("gate"), max_examples=300, derandomize=False
)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "gate"))
# It would also try numbers that stand in modules of the package, those that happen to be loaded:
# what is tried would hang on the tests before it in its process, and no seed would repeat it.
providers._get_local_constants = lambda: providers._local_constants  # of none


def pytest_report_header(config: pytest.Config) -> str | None:
    """The seed of `make release`, and the versions of Python in which it installs the package."""
    seed = config.getoption("hypothesis_seed")
    if seed is None:
        return None
    versions = {".".join(map(str, python.version)) for python in installable().values()}
    return (
        f"seed: {seed}; again: make release SEED={seed}\nPython: {' and '.join(sorted(versions))}"
    )


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Whether there is nothing quick in a file of tests: `make quick` has no time to import it."""
    if not config.option.markexpr.startswith("quick") or collection_path.suffix != ".py":
        return None
    if PACKAGE in collection_path.parents:
        return None
    return "mark.quick" not in collection_path.read_text(encoding="utf-8") or None


def searches(path: Path) -> bool:
    """Whether a module is of the search or uses it, whose loops are first to be compiled."""
    return "crankstar.stars" in path.read_text(encoding="utf-8") or "search" in path.parts


def pytest_configure(config: pytest.Config) -> None:
    """The same fonts on every machine, and interrupts that are obeyed, by child processes as well.

    A suite that is started in the background (`sh -c 'make test &'`) inherits them ignored.
    """
    signal.signal(signal.SIGINT, signal.default_int_handler)
    if "PYTEST_XDIST_WORKER" not in os.environ:  # which has those of the process that started it
        folder = TemporaryDirectory(prefix="crankstar-fonts-", ignore_cleanup_errors=True)
        config.add_cleanup(folder.cleanup)
        only_of_packages(Path(folder.name))


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """The tier of what cannot bear a mark.

    Doctests that search nothing are quick. What is tried of many cases: the first ones always, the
    others by `make release`.
    """
    seen: Counter[str] = Counter()
    for item in items:
        if PACKAGE in item.path.parents and not searches(item.path):
            item.add_marker("quick")
        many = item.get_closest_marker("many")
        if many is None or item.get_closest_marker("release"):
            continue
        test = item.nodeid.partition("[")[0]
        seen[test] += 1
        if seen[test] > many.kwargs["first"]:
            item.add_marker("release")


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Modules that have grown long: for the developer to consider, not to fail."""
    for path in sorted(PACKAGE.rglob("*.py")):
        lines = len(path.read_text(encoding="utf-8").splitlines())
        if lines > USUAL_MODULE:
            place = path.relative_to(PACKAGE.parent).as_posix()
            terminalreporter.write_line(f"{place} has {lines} lines: is it two modules?")


@pytest.fixture(scope="session")
def seed(pytestconfig: pytest.Config) -> int:
    """What random numbers other than those of hypothesis start from: zero but in `make release`."""
    return int(pytestconfig.getoption("hypothesis_seed") or 0)
