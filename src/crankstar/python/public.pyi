"""The functions that are no analysis; made by tools/signatures.py."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any, Literal

from crankstar.analysis.document import Document
from crankstar.derive.chapters import Chapter, Derivation
from crankstar.derive.six_signs import Sign
from crankstar.derive.steps import Quantity
from crankstar.dynamics.bearings import BearingLoads, Bending, Model
from crankstar.dynamics.uneven import Running
from crankstar.dynamics.whirl import Response
from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import Balance, Grouping
from crankstar.mechanics.excitation import Reference, Totals
from crankstar.mechanics.gas import Cycle
from crankstar.mechanics.gas_torque import GasTorque
from crankstar.mechanics.side_thrust import SideThrust
from crankstar.options.sources import EngineLike
from crankstar.page.widget import Given
from crankstar.python.searches import Found, Texts
from crankstar.python.sums import BalanceOf, UnitSystem
from crankstar.stars.progress import Progress
from crankstar.studies.sweep import Curve, Sweep
from crankstar.studies.variants import Tell

HOMES: dict[str, tuple[str, ...]]
NAMES: set[str]

def balance(
    engine: EngineLike,
    *,
    speed: float | str | None = None,
    units: UnitSystem = "SI",
    reference: Reference | float | str | None = None,
    orders: Iterable[float] | None = None,
) -> BalanceOf:
    """The Balance of an engine in N and N m at `speed` (rad/s), by default that of its file.

    In m r w^2 where units are "relative", and where masses, sizes or the speed are not known.
    `orders` keeps only those; `reference` is the point of the couples, by default the middle of the
    cylinders.
    """

def bearing_loads(
    engine: EngineLike,
    *,
    speed: float | str | None = None,
    units: UnitSystem = "SI",
    model: Model = "determinate",
    cycle: Cycle | None = None,
) -> BearingLoads:
    """Loads on all main bearings, crank pins and cylinder walls by crank order.

    In N at `speed` (rad/s), by default that of the cycle or the file; in m r w^2 where units are
    "relative", and where masses, sizes or the speed are not known. With a `cycle` those of its gas
    as well. A `continuous` shaft rests on rigid bearings, or on those of the stiffness that the
    file gives. Raises BearingError where gas needs a speed or masses that are not known.
    """

def bending_moment(
    engine: EngineLike,
    *,
    shaft: str | None = None,
    speed: float | str | None = None,
    units: UnitSystem = "SI",
    model: Model | None = None,
    cycle: Cycle | None = None,
) -> Bending:
    """The bending moment along a crankshaft, by default the first.

    `model=None`: in its two end bearings alone, so that no inner bearing helps. In N m at the speed
    of `bearing_loads`, in m r w^2 a where units are "relative".
    """

def compare(
    *engines: EngineLike,
    speed: float | str | None = None,
    reference: Reference | float | str | None = None,
    orders: Iterable[float] = (),
) -> Document:
    """The comparison of engines at `speed` (rad/s), else at their own, in tables for readers.

    Where one of them has no speed all are at `common_speed`.
    """

def cycle(
    engine: EngineLike,
    *,
    point: str = "",
    speed: float | str | None = None,
    motored: bool = False,
    off: Iterable[int] | int | str = (),
    weaker: Mapping[int, float | str] | None = None,
    imep: float | str | None = None,
    bmep: float | str | None = None,
    peak_pressure: float | str | None = None,
) -> Cycle:
    """The cycle of an engine at an operating point and speed, as `operating_state` has them.

    `speed` (rad/s) and a load (one of imep, bmep, peak_pressure, Pa) stand before what the file
    gives. A `motored` engine burns nothing, and so do the chambers of the cylinders that are `off`;
    those that are `weaker` lack a share of their combustion, by cylinder: the others burn what they
    would. What does not burn is compressed from the charge pressure of the point, and with a
    measured pressure from the one that the trace has. Between two points the pressure at each
    angle, and what comes of it, is between theirs, each at its own speed; a friction by correlation
    is that of the speed, and a load that is asked for comes out. Raises GasError.
    """

def derivation(
    engine: EngineLike,
    order: float | Fraction,
    quantity: Quantity = "force",
    *,
    reference: Reference | float | str | None = None,
    speed: float | str | None = None,
    power: int = 7,
) -> Derivation:
    """The derivation of one order of the force or the couple of an engine, step by step.

    `order` is a crank order above 0 and up to 24; the couple is taken about the middle of the
    cylinders' span unless a `reference` is given; numbers in newtons are for `speed` (rad/s), else
    for the speed of the engine file, and end with what they rest on; the series of A_k goes to
    lambda**power. Raises DerivationError.
    """

def driven(
    engine: EngineLike, cycle: Cycle, *, flywheel: float | str | None = None
) -> Running | None:
    """Steady running with the inertia of the engine file, or another `flywheel` (kg m^2).

    None where inertia, speed or masses are not known.
    """

def family(
    engine: EngineLike, order: float | Fraction, quantity: Quantity, *, symbol: str
) -> Chapter:
    """The closed form of one order for all engines that differ from this one in one dimension only.

    `symbol` is `alpha`, `phi` or `n`. Raises DerivationError where the engine has no such
    dimension.
    """

def flywheel_for(engine: EngineLike, cycle: Cycle, *, irregularity: float | str) -> float:
    """The inertia of flywheel and crankshaft for a degree of irregularity, kg m^2.

    With the load of the engine file, as `driven` has it. Zero where the moving parts alone are
    enough. Twice as even takes about twice the inertia:
    """

def gas_torque(cycle: Cycle, *, highest: float = 24.0) -> GasTorque:
    """The gas torque of each chamber over the angle of the reference crankshaft, up to an order."""

def grouped(result: Balance, by: Grouping) -> dict[object, Totals]:
    """The sums by one label, in order of first appearance; None collects parts without it."""

def load(name: str | Path, *, changes: Mapping[str, Any] | None = None) -> Engine:
    """An engine from the catalog by its name, or from a file by its path ("-": standard input).

    A catalog name comes first; say ./NAME for a file that is called the same. `changes` sets values
    by key path. Raises EngineFileError.
    """

def names() -> tuple[str, ...]:
    """The names of all engines in the catalog, in alphabetical order."""

def of_parts(result: Balance, **wanted: object) -> Totals:
    """The sum over the parts with these labels: `kind=`, `cylinder=`, `bank=`, `shaft=`."""

def search(
    about: int | EngineLike,
    /,
    *,
    cycle: Literal["two-stroke", "four-stroke"] | None = None,
    minimise: Texts | None = None,
    zero: Texts | None = None,
    limit: Texts | Mapping[str, Any] = (),
    gaps: Texts | None = None,
    fix: str | Mapping[int, int] | None = None,
    symmetric: bool = False,
    mode_shape: Texts | None = None,
    avoid_adjacent: bool = False,
    front: bool = False,
    best: int | None = None,
    all: bool = False,
    all_with: Texts | None = None,
    speed: float | str | None = None,
    changes: Mapping[str, Any] | None = None,
    estimate: bool = False,
    workers: int | None = None,
    tell: Callable[[Progress], None] | None = None,
) -> Found:
    """Better cranks: all arrangements of evenly spaced throws, searched with proof.

    `about` is the number of cylinders, or an engine in line (itself, name, path, keys), with
    `changes` by key path, at `speed` (rad/s), by default that of its file; `estimate` fills in
    what its file leaves out. The goals and limits are those of `crankstar search`, as text or as
    lists and dicts. `tell` is called with the Progress; so many `workers` are processes, which a
    script starts under `if __name__ == "__main__"`. Raises SearchError with every fault of what is
    asked.
    """

def side_thrust(engine: EngineLike, cycle: Cycle, *, samples: int = 720) -> SideThrust:
    """The side thrust of every piston over a working cycle of the reference crankshaft.

    A centred piston at top dead centre has its rod in line, and no side thrust; on its way down it
    presses to the thrust side:
    """

def signs(
    engine: EngineLike, *, reference: Reference | float | str | None = None
) -> tuple[Sign, ...]:
    """The six sums of an engine with one crankshaft.

    Moments are about the middle of the cylinders unless a `reference` is given. Raises
    DerivationError for an engine with several crankshafts.
    """

def sweep(
    engine: EngineLike,
    over: str | Sequence[str] | Mapping[str, Any],
    *,
    watch: str | Sequence[str | tuple[str, float]] = (),
    changes: Mapping[str, Any] | None = None,
    reference: Reference | float | str | None = None,
    orders: Iterable[float] | None = None,
    speed: float | str | None = "file",
    estimate: bool = False,
    tell: Tell | None = None,
) -> Sweep:
    """What `crankstar sweep --over` computes; `watched` gives its curves. Raises as `swept` does.

    `over` is one text, or two for two numbers that are varied at once, or a dict of their values by
    key path: numbers in SI units, or text with a unit. `watch` are results as `watched` takes them,
    each alone or with an order; the frame has these then. `estimate` fills in the masses and
    lengths that the file leaves out; they stay as they are while others are varied.
    """

def total(result: Balance) -> Totals:
    """The sum over the whole engine, rounding errors set to zero."""

def watched(sweep: Sweep, what: str, *, order: float | None = None) -> Curve:
    """One result of every variant: the peak of force, couple, moment or torque, or of a part.

    `what` is one of WATCHABLE: force, couple, roll (the rolling moment on the block),
    axis_moment (of the forces, about the crank axis), torque; .up, .right, the component that way;
    .forward, .backward, the vectors that turn with and against the crankshaft; couple.pitch and
    couple.yaw, the moments about the right and the up axis, as large as couple.up and couple.right.
    Or one of GAS_WATCHABLE: what gas does at the load of each engine's file; or a measure of an
    analysis: how its crankshaft vibrates, how it shakes on its mounts.
    All orders together over their period, or one `order`. Raises SweepError.
    """

def whirl(engine: EngineLike, *, orders: Iterable[float] | None = None) -> Response:
    """The free response of an engine as a body of the usual mass and shape: see `response`."""

def widget(engine: Given, beside: Given | None = None, *, units: str | None = None) -> Any:
    """The engine as a widget with the whole analysis; `beside` turns at the same crank angle.

    Its traits can be read, set and observed: `theta` (crank angle, degrees), `playing`, and `state`
    (camera, panels and so on, as in the address of a page: "camera=front&tab=verdict").
    `show(engine, beside)` puts other engines in the place of these. `units` are those it begins
    with, as `--units` takes them ("us", "kN, kN m"); the page offers others. Raises ImportError
    where anywidget is not installed, EngineFileError for a name or file that is none, UnitsError
    for units that are none, PageError where the front-end has not been built.
    """

def with_balance_shaft(
    engine: EngineLike,
    *,
    ratio: Fraction | int,
    planes: Iterable[float | str],
    up: float = 0.0,
    right: float = 0.0,
    share: float = 1.0,
) -> Engine:
    """The engine with one more shaft at `up`, `right` of the crankshaft, weights in these planes.

    `ratio` is its speed per turn of the crankshaft, negative against it; `planes` are places along
    it: two or more, or one in which the force alone acts. `share` is the part of force and couple
    that it cancels, the rest being left to other shafts. Raises RemedyError, also where there is
    nothing for it to balance.
    """

def with_counterweights(
    engine: EngineLike,
    *,
    factor: float,
    planes: Iterable[float | str] | None = None,
    bare: bool = False,
) -> Engine:
    """The engine with counterweights beside those that its crankshafts have; `bare`: instead.

    `factor` is the share of all the reciprocating mass on each pin that is balanced besides all of
    the rotating mass, by the weights that are there and by the new ones together: one half for
    most V8s, 0.52 with an overbalance of two per cent, from -1 to 3. `planes` are places along the
    shaft (z, m or bore pitches as the engine counts); without them a weight stands opposite every
    pin. Shafts without throws keep their weights. Raises RemedyError.
    """
