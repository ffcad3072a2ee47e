"""Faults of a search: records of `language.faults` with the name of an option as their path."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager

from crankstar.language.faults import Fault, sentence
from crankstar.language.quoting import one_line


class SearchError(ValueError):
    """A search that is not possible; carries every fault, not only the first."""

    def __init__(self, faults: Iterable[Fault]) -> None:
        self.faults: list[Fault] = []
        for each in faults:
            if each not in self.faults:
                self.faults.append(each)
        super().__init__(self.faults)

    def __str__(self) -> str:
        """Each fault on a line, after the option it is about."""
        return self.text()

    def text(self, named: Callable[[str], str] = str) -> str:
        """Each fault on a line, options named as the host writes them; one of several once."""
        options: dict[str, list[str]] = {}
        for fault in self.faults:
            own = options.setdefault(said(fault, named), [])
            own += [name for name in map(named, map(str, fault.path)) if name not in own]
        return "\n".join(
            f"{', '.join(names)}: {words}" if names else words for words, names in options.items()
        )

    def in_options(self) -> str:
        """Each fault on a line, after the options of a command line that it is about."""
        return self.text(lambda option: f"--{option.replace('_', '-')}")


class Faults(list[Fault]):
    """Faults gathered, so that all of them are reported at once."""

    def add(self, path: str, code: str, **values: object) -> None:
        """Note a fault."""
        self.append(fault(path, code, **values))

    @contextmanager
    def at(self, path: str = "") -> Iterator[None]:
        """Note what is raised inside, as faults of an option where they name none."""
        try:
            yield
        except SearchError as raised:
            self += [
                each if each.path else each._replace(path=_path(path)) for each in raised.faults
            ]


def said(fault: Fault, named: Callable[[str], str] = str) -> str:
    """The sentence of a fault, options named as the host writes them.

    >>> said(fault("mode_shape", "shape-unused"), lambda option: f"--{option}")
    'No order of torsion is searched for; name one, as in --minimise M1,M2,T3.'
    """
    return sentence(fault.code, fault.values, place="", named=named)


def fault(path: str, code: str, **values: object) -> Fault:
    """A fault of an option by its code; text from outside is quoted on one line."""
    plain = {
        name: one_line(value, longest=200) if isinstance(value, str) else value
        for name, value in values.items()
    }
    return Fault(_path(path), code, plain)


def _path(option: str) -> tuple[str, ...]:
    return (option,) if option else ()


def error(path: str, code: str, **values: object) -> SearchError:
    """A search that is not possible for one reason."""
    return SearchError([fault(path, code, **values)])
