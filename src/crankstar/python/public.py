"""The functions that are no analysis, their arguments read as people write them.

The stub beside this module has their types, which `python tools/signatures.py` writes.

>>> from crankstar.python.public import load, total
>>> load("v2-90").name
'V-twin, 90 deg, one crank pin'
"""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any

from crankstar.options.arguments import read

HOMES: dict[str, tuple[str, ...]] = {
    "derive": ("family", "signs"),
    "dynamics.uneven": ("driven", "flywheel_for"),
    "dynamics.whirl": ("whirl",),
    "files.catalog": ("load", "names"),
    "mechanics.balance": ("grouped", "of_parts", "total"),
    "mechanics.gas": ("cycle",),
    "mechanics.gas_torque": ("gas_torque",),
    "mechanics.side_thrust": ("side_thrust",),
    "page.widget": ("widget",),
    "python.derivations": ("derivation",),
    "python.searches": ("search",),
    "python.sums": ("balance", "bearing_loads", "bending_moment"),
    "remedy.counterweights": ("with_counterweights",),
    "remedy.shafts": ("with_balance_shaft",),
    "studies.sweep": ("sweep", "watched"),
    "tables.comparison": ("compare",),
}
"""The module of each function; it is loaded on first use."""
NAMES = {name for names in HOMES.values() for name in names}


def __getattr__(name: str) -> Callable[..., Any]:
    """The function of this name. Raises AttributeError."""
    for module, public in HOMES.items():
        if name in public:
            globals()[name] = made = read(getattr(import_module(f"crankstar.{module}"), name))
            return made
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
