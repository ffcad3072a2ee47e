"""Best weights: no grid and no random weights beat them; bounds and limits are true."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import numpy as np
import pytest
from tests.newton import road

from crankstar import load, spectra, total
from crankstar.dynamics.bearings import bearing_loads
from crankstar.engine.copies import with_shaft, with_weights
from crankstar.engine.engine import Engine
from crankstar.engine.records import Shaft, Weight
from crankstar.files import engine_of
from crankstar.mechanics.balance import Reference, balance, unit_unbalance
from crankstar.remedy import (
    Aim,
    Limit,
    Plane,
    RemedyError,
    best_weights,
    end_webs,
    main_bearings,
    webs,
    without_counterweights,
)
from crankstar.remedy.aims import cones, measured, setting, with_unbalance
from crankstar.remedy.programme import Ceiling, lower_bound, solved

ENGINES = (
    "single",
    "harley-45",
    "triple-120",
    "v8-cross-plane",
    "gm-3800",
    "vw-vr6",
    "pratt-whitney-wasp",
    "kr250-racer",
    "merlin",
)
AIMS = {
    "peak force": Aim("force"),
    "peak couple": Aim("couple"),
    "rms force": Aim("force", rms=True),
    "rms couple": Aim("couple", rms=True),
    "bearing": Aim("bearing"),
    "pitch": Aim("couple", up=1.0, right=0.0),
    "mostly yaw": Aim("couple", rms=True, up=0.2, right=1.0),
    "M1V": Aim("couple", up=1.0, right=0.0, order=1.0),
    "F1H": Aim("force", up=0.0, right=1.0, order=1.0),
    "M1": Aim("couple", order=1.0),
}


def ends(engine: Engine) -> list[Plane]:
    return [Plane(shaft.name, z) for shaft in engine.shafts for z in end_webs(engine, shaft)]


@pytest.mark.many(first=16)
@pytest.mark.parametrize("aim", AIMS.values(), ids=AIMS.keys())
@pytest.mark.parametrize("name", ENGINES)
def test_no_weights_are_better(name: str, aim: Aim) -> None:
    engine = load(name)
    planes = ends(engine)
    found = best_weights(engine, planes=planes, aim=aim)
    case = setting(engine, planes)  # with the weights of the file, if it gives any
    best = np.array([[u.real, u.imag] for u in found.unbalance]).ravel()
    assert measured(case, aim, best) == pytest.approx(found.value, rel=1e-12, abs=1e-15)
    assert found.value - found.bound <= 1e-6 * max(found.before, 1e-12)  # the certificate closes
    generator = np.random.default_rng(4)
    for size in (1e-4, 1e-2, 0.3, 3.0):
        for _ in range(15):
            other = best + size * generator.normal(size=best.size)
            assert measured(case, aim, other) >= found.bound - 1e-12
            assert measured(case, aim, other) >= found.value - 1e-6 * found.before


@pytest.mark.parametrize(
    "name",
    [
        *(
            pytest.param(name, marks=pytest.mark.release)
            for name in ("single", "harley-45", "radial-9")
        ),
        "v2-90",
    ],
)
@pytest.mark.parametrize(
    "aim",
    [
        Aim("force"),
        *(
            pytest.param(aim, marks=pytest.mark.release)
            for aim in (Aim("force", rms=True), Aim("force", up=1.0, right=0.3))
        ),
    ],
)
def test_one_weight_is_where_a_grid_says(name: str, aim: Aim) -> None:
    engine = load(name)
    plane = [Plane("crank", engine.shafts[0].throws[0].z)]
    found = best_weights(engine, planes=plane, aim=aim)
    case = setting(without_counterweights(engine), plane)
    centre, reach = np.zeros(2), 6.0
    for _ in range(12):  # a grid, and a finer one about the best of it
        steps = np.linspace(-reach, reach, 13)
        grid = [centre + np.array([a, b]) for a in steps for b in steps]
        centre = min(grid, key=lambda x: measured(case, aim, x))
        reach /= 3
    assert found.value == pytest.approx(measured(case, aim, centre), rel=2e-5)
    assert abs(found.unbalance[0] - complex(*centre)) < 0.02 * max(1.0, abs(complex(*centre)))


def test_the_peak_is_that_of_the_finished_engine() -> None:
    for name in ("triple-120", "gm-3800", "kr250-racer", "harley-45"):
        engine = load(name)
        found = best_weights(engine, planes=ends(engine), aim=Aim("couple"))
        unit = unit_unbalance(engine) * engine.pitch
        walked = road(found.engine, reference=balance(engine).reference, speed=1.0)
        moment = np.sum([np.asarray(push.moment, float) for push in walked.pushes], axis=0)
        lengths = np.hypot(moment[:, 0], moment[:, 1]) / unit
        assert lengths.max() == pytest.approx(found.value, rel=1e-3, abs=1e-9)
        assert lengths.max() <= found.value * (1 + 1e-9) + 1e-9


def test_the_least_of_the_first_order_is_known() -> None:
    assert abs(
        best_weights(
            load("single"), planes=[Plane("crank", 0.0)], aim=Aim("force", rms=True)
        ).unbalance[0]
    ) == (
        pytest.approx(0.5)  # half of the reciprocating mass
    )
    cross = load("v8-cross-plane")
    found = best_weights(cross, planes=ends(cross), aim=Aim("couple", rms=True))
    span = found.planes[0].z - found.planes[1].z
    assert [abs(u) for u in found.unbalance] == pytest.approx([np.sqrt(10) / span] * 2)
    assert found.unbalance[0] == pytest.approx(-found.unbalance[1])
    six = load("gm-3800")
    rms = best_weights(six, planes=ends(six), aim=Aim("couple", rms=True))
    first = spectra.selected(total(balance(rms.engine)).couple, [1.0])
    assert abs(first.forward[0]) < 1e-12
    assert abs(first.backward[0]) == pytest.approx(
        np.sqrt(3) * np.sin(np.pi / 12), rel=1e-9
    )  # 0.4483


def test_limits_hold_and_cost_something() -> None:
    engine = load("yamaha-r1-crossplane")
    planes = [Plane("crank", z) for z in webs(engine, engine.shafts[0])]
    free = best_weights(engine, planes=planes, aim=Aim("bearing"))
    limit = Limit(Aim("couple"), 1.6)
    held = best_weights(
        engine, planes=planes, aim=Aim("bearing"), limits=[limit], greatest_unbalance=0.3
    )
    assert held.limits[0][1] <= 1.6 * (1 + 1e-6)
    assert max(map(abs, held.unbalance)) <= 0.3 * (1 + 1e-6)
    assert held.value >= free.value - 1e-9
    assert held.value - held.bound <= 1e-6


def external_moments(engine: Engine) -> tuple[float, float]:
    """M1V and M1H of a finished engine, m r w^2 a, from the moment over a turn."""
    theta = np.linspace(0, 2 * np.pi, 4096, endpoint=False)
    moment = spectra.value(total(balance(engine)).couple, theta)
    waves = (
        2 * abs(np.mean(part * np.exp(-1j * theta))) for part in (np.real(moment), np.imag(moment))
    )
    vertical, horizontal = (float(size) for size in waves)
    return vertical, horizontal


@pytest.mark.many(first=3)
@pytest.mark.parametrize("name", ["triple-120", "gm-3800", "yamaha-r1-crossplane"])
@pytest.mark.parametrize("share", [0.3, 1.2, 2.5])
def test_the_vertical_moment_is_paid_for_with_the_horizontal_one(name: str, share: float) -> None:
    """What turns with the crank adds to one as it takes from the other: M1V + M1H >= 2 |b|.

    b is the vector against the crank, which no weight reaches.
    """
    engine = without_counterweights(load(name))
    against = float(abs(spectra.selected(total(balance(engine)).couple, 1.0).backward[0]))
    pitch = Aim("couple", up=1.0, right=0.0, order=1.0)
    limit = Limit(Aim("couple", up=0.0, right=1.0, order=1.0), share * against)
    found = best_weights(engine, planes=ends(engine), aim=pitch, limits=[limit])
    vertical, horizontal = external_moments(found.engine)
    assert (found.value, found.limits[0][1]) == pytest.approx((vertical, horizontal), abs=1e-6)
    assert vertical == pytest.approx(max(2 * against - limit.at_most, 0.0), abs=1e-6)
    assert found.bound == pytest.approx(found.value, abs=1e-6)


@pytest.mark.release
def test_no_weights_of_a_minimisation_by_hand_have_a_smaller_vertical_moment() -> None:
    from scipy.optimize import minimize

    engine = without_counterweights(load("triple-120"))
    planes, most = ends(engine), 0.3
    pitch = Aim("couple", up=1.0, right=0.0, order=1.0)
    limit = Limit(Aim("couple", up=0.0, right=1.0, order=1.0), 1.5)
    found = best_weights(engine, planes=planes, aim=pitch, limits=[limit], greatest_unbalance=most)
    unit = unit_unbalance(engine)

    def finished(x: np.ndarray) -> tuple[float, float]:
        weights = [
            Weight(unbalance=float(abs(u)) * unit, angle=float(np.angle(u)), z=plane.z)
            for plane, u in zip(planes, x[0::2] + 1j * x[1::2], strict=True)
        ]
        return external_moments(with_weights(engine, {"crank": weights}))

    within = [
        {"type": "ineq", "fun": lambda x: limit.at_most - finished(x)[1]},
        {"type": "ineq", "fun": lambda x: most**2 - (x.reshape(-1, 2) ** 2).sum(axis=1)},
    ]
    starts = np.random.default_rng(2).normal(0, 0.1, (4, 2 * len(planes)))
    tried = [
        minimize(lambda x: finished(x)[0], start, method="SLSQP", constraints=within)
        for start in starts
    ]
    least = min(each.fun for each in tried if each.success)
    assert found.value == pytest.approx(least, rel=1e-4)
    assert found.bound <= least + 1e-6


def test_an_order_that_no_weight_changes_is_refused() -> None:
    engine = load("triple-120")
    with pytest.raises(RemedyError, match=r"pitch of order 2 does not depend .* of order 1;"):
        best_weights(engine, planes=ends(engine), aim=Aim("couple", up=1.0, right=0.0, order=2.0))
    with pytest.raises(RemedyError, match="one order, above 0, is that of a peak"):
        best_weights(engine, planes=ends(engine), aim=Aim("couple", rms=True, order=1.0))


def test_a_bound_on_the_unbalance_binds() -> None:
    engine = load("v8-cross-plane")
    for aim in (Aim("couple"), Aim("couple", rms=True)):
        found = best_weights(engine, planes=ends(engine), aim=aim, greatest_unbalance=0.5)
        assert [abs(u) for u in found.unbalance] == pytest.approx([0.5, 0.5], rel=1e-5)
        first = spectra.selected(total(balance(found.engine)).couple, [1.0])
        span = found.planes[0].z - found.planes[1].z
        assert abs(first.forward[0]) == pytest.approx(np.sqrt(10) - 0.5 * span, rel=1e-5)
        assert found.value - found.bound <= 1e-6


def test_multipliers_out_of_the_air_give_a_true_bound() -> None:
    engine = load("triple-120")
    case = setting(without_counterweights(engine), ends(engine))
    aim, limited = (
        cones(case, Aim("couple"), np.linspace(0, 6, 25)),
        cones(case, Aim("force"), np.linspace(0, 6, 9)),
    )
    ceiling = [Ceiling(limited, 0.4)]
    answer = solved(aim, ceiling, greatest=2.0)
    assert answer.x is not None
    least = max(cone.at(answer.x) for cone in aim)
    generator = np.random.default_rng(1)
    for _ in range(200):
        multipliers = [
            generator.normal(size=3) * generator.integers(0, 2) for _ in [*aim, *limited]
        ]
        multipliers = [
            np.append(abs(one[0]) * (place < len(aim)), one[1:])
            for place, one in enumerate(multipliers)
        ]
        assert lower_bound(aim, ceiling, multipliers, greatest=2.0) <= least + 1e-9
    # One that would be a bound if weights could not be moved at all, and is none because they can.
    highest = max(range(len(aim)), key=lambda place: float(np.linalg.norm(aim[place].shift)))
    along = [np.zeros(3) for _ in [*aim, *limited]]
    along[highest] = np.append(1.0, aim[highest].shift / np.linalg.norm(aim[highest].shift))
    assert (
        lower_bound(aim, ceiling, along, greatest=2.0)
        <= least
        < lower_bound(aim, ceiling, along, greatest=0.0)
    )
    assert answer.bound == pytest.approx(least, rel=1e-6)


@pytest.mark.parametrize(
    "name", ["i4", "v8-cross-plane", "gm-3800", "triple-120", "single", "kr250-racer"]
)
def test_bearing_loads_are_those_of_beams_between_bearings(name: str) -> None:
    """Each piece of the shaft between two bearings is a beam; moments about one give the other."""
    engine = without_counterweights(load(name))
    planes = ends(engine)
    generator = np.random.default_rng(7)
    x = generator.normal(size=2 * len(planes)) * np.repeat(
        [1 + 4 * (p.shaft == planes[-1].shaft) for p in planes], 2
    )
    weights = x[0::2] + 1j * x[1::2]
    result = balance(engine)
    guide = spectra.selected(bearing_loads(engine).guide, [1.0])
    greatest = 0.0
    for shaft in engine.shafts:
        bearings = main_bearings(engine, shaft)
        own: dict[float, np.ndarray] = {}
        loads_at: list[tuple[float, complex, complex]] = [
            (p.z, u if shaft.speed_ratio > 0 else 0j, 0j if shaft.speed_ratio > 0 else u)
            for p, u in zip(planes, weights, strict=True)
            if p.shaft == shaft.name
        ]
        one = spectra.selected(result.force, [1.0])
        for row, part in enumerate(result.parts):
            if part.shaft != shaft.name or part.kind in ("throw", "weight"):
                continue
            z = next(c.z for c in engine.cylinders if c.number == part.cylinder)
            loads_at.append((z, complex(one.forward[row, 0]), complex(one.backward[row, 0])))
        for cylinder, forward, backward in zip(
            engine.cylinders, guide.forward[:, 0], guide.backward[:, 0], strict=True
        ):
            if cylinder.shaft == shaft.name:  # the wall carries it, not the pin
                loads_at.append((cylinder.z, -complex(forward), -complex(backward)))
        rows = [
            row
            for row, part in enumerate(result.parts)
            if part.kind == "throw" and part.shaft == shaft.name
        ]
        loads_at += [
            (t.z, complex(one.forward[r, 0]), complex(one.backward[r, 0]))
            for r, t in zip(rows, shaft.throws, strict=True)
        ]
        for front, rear in pairwise(bearings):
            on = [load for load in loads_at if rear <= load[0] < front]
            for here, there in ((front, rear), (rear, front)):
                moment = np.array(
                    [sum((z - there) * f for z, f, _ in on), sum((z - there) * b for z, _, b in on)]
                )
                own[here] = own.get(here, np.zeros(2, complex)) + moment / (here - there)
        greatest = max(greatest, *(float(np.abs(pair).sum()) for pair in own.values()))
    case = setting(engine, planes)
    assert measured(case, Aim("bearing"), x) == pytest.approx(greatest, rel=1e-9)


@pytest.mark.release
@pytest.mark.parametrize("ratio", [2, -2, -1])
@pytest.mark.parametrize("middle", [0.0, 0.13])
def test_weights_of_a_setting_push_as_those_of_the_finished_engine(
    ratio: int, middle: float
) -> None:
    bare = with_shaft(
        load("audi-25-tfsi"), Shaft(name="second", speed_ratio=Fraction(ratio), right=0.1)
    )
    planes = [Plane("second", 0.21), Plane("second", -0.05), Plane("crank", 0.1)]
    reference = Reference(middle)
    x = np.array([0.3, -0.2, 0.11, 0.5, -0.4, 0.25])
    unit = unit_unbalance(bare)
    weights: dict[str, list[Weight]] = {"second": [], "crank": [*bare.shafts[0].weights]}
    for plane, u in zip(planes, x[0::2] + 1j * x[1::2], strict=True):
        weights[plane.shaft].append(
            Weight(unbalance=float(abs(u)) * unit, angle=float(np.angle(u)), z=plane.z)
        )
    finished = total(balance(with_weights(bare, weights), reference=reference))
    case = setting(bare, planes, reference=reference)
    for whole, mine in (
        (finished.force, with_unbalance(case, x, "force")),
        (finished.couple, with_unbalance(case, x, "couple")),
    ):
        theirs = spectra.selected(whole, mine.orders)
        assert np.allclose(mine.forward, theirs.forward, rtol=1e-9, atol=1e-9)
        assert np.allclose(mine.backward, theirs.backward, rtol=1e-9, atol=1e-9)


def test_a_crankshaft_that_turns_twice_as_fast_pushes_four_times_as_hard() -> None:
    tree = {
        "format": 1,
        "name": "geared",
        "shaft": [
            {"name": "slow", "throw": [{"angle": "0 deg", "radius": "40 mm", "z": "50 mm"}]},
            {
                "name": "fast",
                "speed_ratio": -2,
                "right": "0.2 m",
                "throw": [{"angle": "30 deg", "radius": "30 mm", "z": "-50 mm"}],
            },
        ],
        "cylinders": [
            {
                "number": 1,
                "shaft": "slow",
                "throw": 1,
                "z": "50 mm",
                "rod_length": "160 mm",
                "reciprocating_mass": "0.5 kg",
            },
            {
                "number": 2,
                "shaft": "fast",
                "throw": 1,
                "z": "-50 mm",
                "rod_length": "110 mm",
                "reciprocating_mass": "0.3 kg",
            },
        ],
    }
    engine = engine_of(tree)
    found = best_weights(
        engine, planes=[Plane("slow", 0.05), Plane("fast", -0.05)], aim=Aim("force")
    )
    assert found.value < 0.9 * found.before
    assert spectra.peak(total(balance(found.engine)).force).value == pytest.approx(
        found.value, rel=1e-9
    )


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        ({"planes": []}, "one plane or more"),
        ({"planes": [Plane("crank", 0.0), Plane("crank", 0.0)]}, "all different"),
        ({"planes": [Plane("cam", 0.0)]}, 'no crankshaft "cam"; the crankshafts are crank'),
        ({"planes": [Plane("crank", float("nan"))]}, "no position"),
        ({"greatest_unbalance": 0.0}, "give a larger one"),
        ({"greatest_unbalance": float("nan")}, "give a larger one"),
        ({"limits": [Limit(Aim("force"), -1.0)]}, "from 0 up"),
        (
            {"limits": [Limit(Aim("couple"), 0.1)]},
            r"peak couple, cannot be met.*the least is 1\.188 m r ω² a, 1\.088 m r ω² a more",
        ),
        (
            {
                "limits": [
                    Limit(Aim("force", rms=True), 0.05),
                    Limit(Aim("couple", rms=True), 0.93),
                ],
                "greatest_unbalance": 0.2,
            },
            "rms couple, cannot be met with these planes and unbalances up to 0.2 m r",
        ),
    ],
)
def test_what_cannot_be_done_is_told(arguments: dict[str, object], told: str) -> None:
    engine = load("triple-120")
    whole = {"planes": ends(engine), "aim": Aim("couple"), **arguments}
    with pytest.raises(RemedyError, match=told):
        best_weights(engine, **whole)


def test_limits_that_fight_each_other_are_told_together() -> None:
    engine = load("single")
    with pytest.raises(RemedyError, match="cannot be met together: within the others the least"):
        best_weights(
            engine,
            planes=[Plane("crank", 0.0)],
            aim=Aim("force"),
            limits=[
                Limit(Aim("force", rms=True, up=1, right=0), 0.3),
                Limit(Aim("force", rms=True, up=0, right=1), 0.3),
            ],
        )
