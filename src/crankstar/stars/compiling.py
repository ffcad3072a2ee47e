"""Compiled loops, kept on disk where there is room: the only module that imports numba.

Numba's own cache loads all of NumPy and SciPy before it opens a file (half a second), raises what
the disk raises, and fails on what cannot be unpickled since a class was renamed. It has no public
hook for that: `KeptCode` replaces two of its methods.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from pickle import UnpicklingError
from typing import Any

from numba import njit
from numba.core.caching import FunctionCache
from numba.core.runtime.nrt import rtsys


class KeptCode(FunctionCache):
    """The machine code of a function on disk, loaded as it is and saved where that is possible."""

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """The code for a signature; None where it must be compiled."""
        rtsys.initialize(target_context)
        try:
            return self._load_overload(sig, target_context)
        except (AttributeError, EOFError, ImportError, OSError, TypeError, UnpicklingError):
            with suppress(OSError):
                self.flush()
            return None

    def save_overload(self, sig: Any, data: Any) -> None:
        """Keep code for the next process; where there is no room, that compiles anew."""
        with suppress(OSError):
            super().save_overload(sig, data)


def compiled(function: Callable[..., Any]) -> Any:
    """A function compiled on its first call, without the interpreter lock.

    Without a place for a cache each process compiles it anew.
    """
    dispatcher: Any = njit(nogil=True)(function)
    with suppress(RuntimeError):  # no directory that can be written to
        dispatcher._cache = KeptCode(function)
    return dispatcher
