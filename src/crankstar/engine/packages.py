"""What other packages add by entry points: loaded when it is wanted, told once where it cannot be.

One of them that is broken takes nothing else with it: it is skipped with a warning wherever all are
gone over, and refused only where it is asked for by its name.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Collection, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Generic, TypeVar

from crankstar.language.messages import MessageError, _
from crankstar.language.quoting import one_line

if TYPE_CHECKING:
    from importlib.metadata import EntryPoint

T = TypeVar("T")
Words = dict[str, str]


class PackageError(MessageError):
    """What a package adds and cannot be used; its text says which package, what and why."""


class PackageWarning(UserWarning):
    """What a package adds and was skipped."""


class Added(Generic[T]):
    """What other packages add to one group of entry points.

    kind       what each is, a sentence of the catalog of messages: "layout"
    taken      the names that this package has itself
    checked    (what was loaded, the words package, kind, name) -> it, fit for use; raises
               MessageError, or anything else, if it is none

    >>> Added("crankstar.no_such_group", "layout", (), lambda found, words: found).names()
    ()
    """

    def __init__(
        self, group: str, kind: str, taken: Collection[str], checked: Callable[[object, Words], T]
    ) -> None:
        self.group, self.kind, self.taken, self.checked = group, kind, taken, checked
        self._entries: dict[str, EntryPoint] | None = None
        self._found: dict[str, T | PackageError] = {}
        self._told: set[str] = set()

    def names(self) -> tuple[str, ...]:
        """The names in order, without loading what has them; a name that is taken is told of."""
        return tuple(sorted(self._by_name()))

    def __getitem__(self, name: str) -> T:
        """What has the name. Raises PackageError where it cannot be used, KeyError for no name."""
        entry = self._by_name()[name]
        if name not in self._found:
            self._found[name] = self._loaded(entry)
        found = self._found[name]
        if isinstance(found, PackageError):
            raise found
        return found

    @contextmanager
    def running(self, name: str) -> Iterator[None]:
        """Run what has the name: whatever it raises by itself is a PackageError.

        Of names of this package nothing is changed.
        """
        try:
            yield
        except MessageError:
            raise
        except Exception as error:
            if name in self.taken or name not in self._by_name():
                raise
            raise PackageError(
                "package {package}: its {kind} {name} fails ({why})",
                **self._words(self._by_name()[name]),
                why=told_of(error),
            ) from error

    @contextmanager
    def among_others(self, name: str) -> Iterator[None]:
        """Run what has the name beside what others have: where it fails, that is told, no more."""
        try:
            with self.running(name):
                yield
        except PackageError as error:
            self._tell(str(error))

    def usable(self) -> Iterator[str]:
        """The names of all that can be used; the others are told of, each once in a process."""
        for name in self.names():
            try:
                self[name]
            except PackageError as error:
                self._tell(str(error))
            else:
                yield name

    def _by_name(self) -> dict[str, EntryPoint]:
        """The entry points, which are slow to find; of those with one name the first."""
        if self._entries is None:
            from importlib.metadata import entry_points

            self._entries = {}
            for entry in entry_points(group=self.group):
                if entry.name in self.taken or entry.name in self._entries:
                    self._tell(
                        _(
                            "package {package}: its {kind} {name} is left out, since that name is "
                            "taken",
                            **self._words(entry),
                        )
                    )
                else:
                    self._entries[entry.name] = entry
        return self._entries

    def _loaded(self, entry: EntryPoint) -> T | PackageError:
        try:
            return self.checked(entry.load(), self._words(entry))
        except (Exception, SystemExit) as error:  # noqa: BLE001  # whatever it does
            return PackageError(
                "package {package}: its {kind} {name} cannot be loaded ({why})",
                **self._words(entry),
                why=told_of(error),
            )

    def _words(self, entry: EntryPoint) -> Words:
        package = entry.value.partition(":")[0] if entry.dist is None else entry.dist.name
        return {"package": one_line(package), "kind": _(self.kind), "name": one_line(entry.name)}

    def _tell(self, sentence: str) -> None:
        if sentence not in self._told:
            self._told.add(sentence)
            warnings.warn(sentence, PackageWarning, stacklevel=2)


def told_of(error: BaseException) -> str:
    """What an error of another package says, and where it was raised, on one printable line.

    >>> told_of(ZeroDivisionError("division by zero"))
    'ZeroDivisionError: division by zero'
    """
    said = str(error)
    if isinstance(error, MessageError | ImportError) and said:
        return one_line(said)
    words = f"{type(error).__name__}: {said}" if said else type(error).__name__
    trace = error.__traceback__
    while trace is not None and trace.tb_next is not None:
        trace = trace.tb_next
    if trace is not None:
        file = trace.tb_frame.f_code.co_filename.replace("\\", "/").rpartition("/")[2]
        words = f"{words}, {file}:{trace.tb_lineno}"
    return one_line(words)
