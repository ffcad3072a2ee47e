"""The functions of the analyses, those of other packages too, each made when it is asked for.

The stub beside this module has their types.

>>> from crankstar.python.analyses import torsion
>>> torsion.__name__
'torsion'
"""

from __future__ import annotations

from collections.abc import Callable

from crankstar.python.functions import function
from crankstar.python.results import Result


def __getattr__(name: str) -> Callable[..., Result]:
    """The function of an analysis. Raises AttributeError; PackageError of a broken package."""
    try:
        return function(name)
    except KeyError:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}") from None
