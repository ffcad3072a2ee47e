"""How thoroughly random engines are tried; signals and width as tests need them.

`HYPOTHESIS_PROFILE=long` for many, `explore` for others each time.
"""

import os
import signal
from collections import Counter
from collections.abc import Iterator

import pytest
from hypothesis import HealthCheck, settings

for name in ("COLUMNS", "CRANKSTAR_LANG", "LANGUAGE", "LC_ALL"):
    os.environ.pop(name, None)  # of the one who started the suite
os.environ["LC_MESSAGES"] = "C"

SLOW = [HealthCheck.too_slow]

settings.register_profile(
    "default",
    max_examples=8,
    derandomize=True,
    deadline=None,
    database=None,
    suppress_health_check=SLOW,
)
settings.register_profile("long", settings.get_profile("default"), max_examples=300)
settings.register_profile("explore", settings.get_profile("long"), derandomize=False)
settings.load_profile(os.environ.get("HYPOTHESIS_PROFILE", "default"))


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """What is tried of many cases: the first ones always, the others by `make release`."""
    seen: Counter[str] = Counter()
    for item in items:
        many = item.get_closest_marker("many")
        if many is None or item.get_closest_marker("long"):
            continue
        test = item.nodeid.partition("[")[0]
        seen[test] += 1
        if seen[test] > many.kwargs["first"]:
            item.add_marker("long")


@pytest.fixture
def interruptible() -> Iterator[None]:
    """Interrupts that are obeyed, here and in child processes.

    A suite started in the background (`nohup make test &`) inherits them ignored.
    """
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
