"""The scatter of an engine built to its tolerances: law, random engines, what matters most."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple

import numpy as np

from crankstar.analyses.tolerance.builds import DEVIATION, Builds, Tell, builds, out_of_reach
from crankstar.analyses.tolerance.error_sources import ErrorSource, sources_of
from crankstar.analyses.tolerance.linear_law import (
    Linear,
    amplitudes,
    bearing_lines,
    bearing_signals,
    linear,
    named,
    parted,
    variances,
    worst,
)
from crankstar.analyses.tolerance.question import (
    FEWEST_BUILDS,
    GREATEST_SEED,
    MOST_BUILDS,
    SIGNALS,
    Distribution,
)
from crankstar.engine.engine import Engine
from crankstar.files import engine_of
from crankstar.files.tolerances import Tolerance, tolerances_of
from crankstar.files.typical_tolerances import typical
from crankstar.language.messages import MessageError
from crankstar.language.numbers import NEGLIGIBLE
from crankstar.language.quoting import seen
from crankstar.mechanics.balance import Units, balance, default_reference, scales
from crankstar.mechanics.excitation import Reference
from crankstar.mechanics.mechanism import mechanism
from crankstar.mechanics.occurring_orders import check_orders
from crankstar.mechanics.remains import USUAL_ORDERS, orders_shown, summed
from crankstar.spectra import ROUNDING, Real, checked
from crankstar.studies.fields import Source, source_of

BUILDS = 100_000
MOST_ERRORS = 4000
"""Independent errors of one engine."""
GREATEST_ORDER = 1000.0
VISIBLE = 1e-7
"""Share of what the parts push below which neither the engine nor its scatter has an order."""


class ScatterError(MessageError):
    """A scatter that cannot be worked out, as a sentence that says what would be right."""


class OrderScatter(NamedTuple):
    """One order of a signal: nominal amplitude, rms of its deviation, worst case, quantiles.

    All in `unit`; `rms_found` is that of the random engines; `shares` are the parts of the
    tolerances in the variance, by path, which add up to one. `half_of`, `one_in_20`, `one_in_100`:
    the amplitudes that this share of the random engines exceeds.
    """

    signal: str
    order: float
    unit: str
    nominal: float
    rms: float
    worst: float
    half_of: float
    one_in_20: float
    one_in_100: float
    rms_found: float
    shares: Mapping[str, float]


@dataclass(frozen=True)
class Scatter:
    """An engine built to its tolerances; `scatter` computes it.

    `rows` are the orders of each signal; `idle` the tolerances that move no force; `assumed` those
    that the file does not give. `builds` has the amplitudes of every random engine.

    >>> four = scatter("i4", changes={"cylinder.rotating_mass": "0.5 +- 0.01"}, count=1000)
    >>> len(four.errors), [row.order for row in four.rows if row.signal == "force"]
    (4, [1.0, 2.0, 4.0, 6.0])
    """

    engine: Engine
    tolerances: Mapping[str, Tolerance]
    errors: tuple[ErrorSource, ...]
    idle: tuple[str, ...]
    assumed: Mapping[str, str]
    orders: tuple[float, ...]
    rows: tuple[OrderScatter, ...]
    units: Units
    speed: float | None
    reference: Reference
    distribution: Distribution
    count: int
    seed: int
    builds: Builds

    def of(self, signal: str, order: float) -> OrderScatter:
        """One order of a signal. Raises ScatterError where there is none."""
        for row in self.rows:
            if row.signal == signal and abs(row.order - order) < 1e-9:
                return row
        raise ScatterError(
            "{signal} has no order {order} here; there are: {rows}",
            signal=signal,
            order=f"{order:g}",
            rows=", ".join(f"{row.signal} {row.order:g}" for row in self.rows) or "-",
        )

    def amplitudes(self, signal: str, order: float) -> Real:
        """The amplitude of an order of a signal in every random engine [engine].

        Raises ScatterError.
        """
        row = self.of(signal, order)
        return self.builds.amplitudes[signal][:, self.orders.index(row.order)]


def scatter(
    engine: str | Engine,
    *,
    changes: Mapping[str, Any] | None = None,
    speed: float | Literal["file"] | None = "file",
    reference: Reference | None = None,
    orders: Sequence[float] | None = None,
    assume: Literal["typical"] | None = None,
    distribution: Distribution = "normal",
    count: int = BUILDS,
    seed: int = 1,
    bearings: bool = False,
    estimate: bool = False,
    tell: Tell | None = None,
) -> Scatter:
    """How far engines built to the tolerances of a file scatter; as `crankstar tolerance`.

    `engine` is a name or a file, since an Engine has no tolerances; `changes` are values by key
    path, with tolerances as in a file.
    In N and N m at `speed` (rad/s; "file": that of the file), without one in units of m r w^2.
    `assume`: "typical" takes published tolerances for masses that the file gives none for.
    `distribution`: "normal" with a standard deviation of a third of the bound, or "uniform".
    `count` engines are built at random, the same ones for the same `seed`. `bearings`: the loads on
    main bearings as well, signals "bearing 1" and so on.
    Raises ScatterError, EngineFileError, OrderError for an order that does not occur.

    Six pistons with 3 g scatter each (1 g of standard deviation), whatever the crank: order 1 has
    sqrt(6) m r w^2 of 1 g.

    >>> six = scatter("i6", changes={"cylinder.reciprocating_mass": "0.5 kg +- 3 g",
    ...     "cylinder.stroke": "90 mm"}, speed=628.3185, count=2000, orders=[1])
    >>> round(six.of("force", 1).rms, 1), six.of("force", 1).nominal
    (43.5, 0.0)
    """
    asked = None if speed == "file" else speed
    source = source_of(engine, changes=changes, estimate=estimate, speed=asked)
    if isinstance(engine, Engine) and assume is None and not tolerances_of(source.tree):
        raise ScatterError(
            "an Engine has no tolerances, which stand in its file: give the name or the path of "
            'the file, or changes with tolerances, or assume="typical"'
        )
    return scatter_of(
        source,
        speed=speed,
        reference=reference,
        orders=orders,
        assume=assume,
        distribution=distribution,
        count=count,
        seed=seed,
        bearings=bearings,
        tell=tell,
    )


def scatter_of(
    source: Source,
    *,
    speed: float | Literal["file"] | None = "file",
    reference: Reference | None = None,
    orders: Sequence[float] | None = None,
    assume: Literal["typical"] | None = None,
    distribution: Distribution = "normal",
    count: int = BUILDS,
    seed: int = 1,
    bearings: bool = False,
    tell: Tell | None = None,
) -> Scatter:
    """The scatter of the tree of a file. Raises as `scatter` does."""
    check(distribution, count, orders, seed=seed, assume=assume)
    own = engine_of(source.tree, name=source.name) if source.engine is None else source.engine
    check_orders(own, orders or (), gas=False)
    given = tolerances_of(source.tree)
    assumed = typical(source.tree, own, given) if assume == "typical" else {}
    added = {path: each.tolerance for path, each in assumed.items() if path not in given}
    tolerances = {**given, **added}
    sources = sources_of(source.tree, tolerances, own, name=source.name)
    _check_errors(own, tolerances, sources.errors, assumable=assume is None)
    at = own.speed if speed == "file" else speed
    scale, units = scales(own, at)
    point = reference or default_reference(own)
    wanted = tuple(checked(np.asarray(orders, float))) if orders else _usual(own)
    wanted = tuple(float(order) for order in sorted(set(wanted)))
    how: dict[str, Any] = {"orders": wanted, "reference": point, "scale": scale}
    lines = linear(own, sources.errors, **how)
    signals = SIGNALS
    if bearings:
        lines |= bearing_lines(own, sources.errors, orders=wanted, scale=scale)
        signals = (*SIGNALS, *bearing_signals(own))
    made = builds(
        own,
        sources.errors,
        lines,
        signals=signals,
        count=count,
        seed=seed,
        distribution=distribution,
        tell=tell,
        **how,
    )
    rows = _rows(own, sources.errors, lines, made, wanted, units, distribution, bool(orders))
    return Scatter(
        engine=own,
        tolerances=tolerances,
        errors=sources.errors,
        idle=sources.idle,
        assumed={path: assumed[path].source for path in added},
        orders=wanted,
        rows=rows,
        units=units,
        speed=at if units.force == "N" else None,
        reference=point,
        distribution=distribution,
        count=count,
        seed=seed,
        builds=made,
    )


def check(
    distribution: str,
    count: int,
    orders: Sequence[float] | None,
    *,
    seed: int = 1,
    assume: str | None = None,
) -> None:
    """Refuse what cannot be asked. Raises ScatterError."""
    for name, word, words in (
        ("distribution", distribution, [*DEVIATION]),
        ("assume", "typical" if assume is None else assume, ["typical"]),
    ):
        if word not in words:
            raise ScatterError(
                "{name} is {value}; give one of {choices}",
                name=name,
                value=seen(word),
                choices=", ".join(words),
            )
    for name, number, least, most in (
        ("count", count, FEWEST_BUILDS, MOST_BUILDS),
        ("seed", seed, 0, GREATEST_SEED),
    ):
        if isinstance(number, bool) or not isinstance(number, int) or not least <= number <= most:
            raise ScatterError(
                "{name} is {value}; give a whole number from {least} to {most}",
                name=name,
                value=seen(number),
                least=least,
                most=most,
            )
    if orders is not None and not all(0 < order <= GREATEST_ORDER for order in orders):
        raise ScatterError(
            "the orders are not possible; give crank orders above 0 up to {most}, or none",
            most=f"{GREATEST_ORDER:g}",
        )


def _check_errors(
    engine: Engine,
    tolerances: Mapping[str, Tolerance],
    errors: Sequence[ErrorSource],
    *,
    assumable: bool,
) -> None:
    if not tolerances and assumable:
        raise ScatterError(
            '{engine} has no tolerances; write them behind the values, as in "650 g +- 2 g", or '
            "take published ones with {option}",
            engine=engine.name,
            option="--typical",
        )
    if not errors:
        raise ScatterError(
            "no force of {engine} depends on the values that have tolerances ({paths}); give one "
            'to a mass, a length or an angle, as in "650 g +- 2 g"',
            engine=engine.name,
            paths=", ".join(tolerances) or "-",
        )
    if len(errors) > MOST_ERRORS:
        raise ScatterError(
            "{engine} has {count} independent errors; at most {most} can be worked out",
            engine=engine.name,
            count=len(errors),
            most=MOST_ERRORS,
        )
    row = out_of_reach(mechanism(engine), errors)
    if row is not None:
        raise ScatterError(
            "within these tolerances of rod length, stroke and offset cylinder {number} might not "
            "turn: its rod hardly reaches, or its stroke vanishes; make them smaller",
            number=engine.cylinders[row].number,
        )


def _usual(engine: Engine) -> tuple[float, ...]:
    """Orders that the nominal engine shows, and all whole ones up to 6, which errors may bring."""
    result = balance(engine)
    shown = orders_shown(result, summed(result))
    return (*shown, *np.arange(1.0, USUAL_ORDERS + 1).tolist())


def _rows(
    engine: Engine,
    errors: Sequence[ErrorSource],
    lines: Mapping[str, Linear],
    made: Builds,
    orders: Sequence[float],
    units: Units,
    distribution: Distribution,
    every: bool,
) -> tuple[OrderScatter, ...]:
    """The orders of each signal; those of which there is nothing are left out unless asked for."""
    bounds = np.array([error.bound for error in errors])
    sigma = DEVIATION[distribution] * bounds
    rows: list[OrderScatter] = []
    least = _least(lines, bounds)
    for signal in made.amplitudes:
        whole, _part = parted(signal)
        own = component(lines[whole], signal, sense=engine.sense)
        each = variances(own, sigma)
        nominal, most = amplitudes(own.nominal), worst(own, bounds)
        nominal = np.where(nominal > NEGLIGIBLE * most, nominal, 0.0)
        quantiles = np.quantile(made.amplitudes[signal], (0.5, 0.95, 0.99), axis=0)
        for index, order in enumerate(orders):
            if most[index] <= least[whole] and not every:
                continue
            rows.append(
                OrderScatter(
                    signal=signal,
                    order=order,
                    unit=_unit(units, whole),
                    nominal=float(nominal[index]),
                    rms=float(np.sqrt(each[:, index].sum())),
                    worst=float(most[index]),
                    half_of=float(quantiles[0, index]),
                    one_in_20=float(quantiles[1, index]),
                    one_in_100=float(quantiles[2, index]),
                    rms_found=float(np.sqrt(made.mean_square[signal][index])),
                    shares=_shares(errors, each[:, index]),
                )
            )
    return tuple(rows)


def component(own: Linear, signal: str, *, sense: int) -> Linear:
    """The linear law of a component of a quantity, or of the whole."""
    whole, _part = parted(signal)
    nominal, rates = (named({whole: part}, signal, sense=sense) for part in own)
    return Linear(nominal, rates)


def _least(lines: Mapping[str, Linear], bounds: Real) -> dict[str, float]:
    """Amplitudes below which there is nothing, beside the greatest of all orders."""
    out = {}
    for name, own in lines.items():
        reach = amplitudes(own.nominal) + bounds @ amplitudes(own.rates)
        out[name] = VISIBLE * float(reach.max(initial=0.0))
    return out


def _shares(errors: Sequence[ErrorSource], each: Real) -> dict[str, float]:
    """What each tolerance has in the variance, the greatest first; of nothing, nothing."""
    total = float(each.sum())
    out: dict[str, float] = {}
    for error, own in zip(errors, each.tolist(), strict=True):
        share = own / total if own > ROUNDING * total else 0.0
        out[error.path] = out.get(error.path, 0.0) + share
    return dict(sorted(out.items(), key=lambda item: -item[1]))


def _unit(units: Units, quantity: str) -> str:
    if quantity == "couple":
        return units.couple
    return units.moment if quantity in ("roll", "torque") else units.force
