"""The functions of the analyses; made by tools/signatures.py."""

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, Literal

from crankstar.mechanics.excitation import Reference
from crankstar.options.sources import EngineLike
from crankstar.python.results import Result

def bearings(
    engine: EngineLike,
    /,
    *,
    speed: float | str | None = None,
    gas: bool = False,
    point: str | None = None,
    off: Iterable[int] | str = (),
    model: Literal["determinate", "continuous"] | str = "determinate",
    orders: Iterable[float] | str | None = None,
    changes: Mapping[str, Any] | None = None,
    estimate: bool = False,
) -> Result:
    """Compute loads on main bearings and crank pins, guide forces, bending of the crankshaft.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        speed: Crank speed, such as "6000 rpm", "628 rad/s" or "100 Hz" (default: the speed in
            the file).
        gas: With the gas pressure of an operating point.
        point: Operating point of the engine file, by its name, such as idle. Default: by speed,
            interpolated between two; without a speed the load of [gas], else the first point.
            With --gas.
        off: Cylinders that do not fire, as in 2,3; the others burn as much.
        model: Crankshaft on its main bearings: determinate (hinged at each) or continuous (one
            beam).
        orders: Crank orders with commas, such as 1,2,4, or all. Default: those up to 6 that
            occur.
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
        estimate: fill in what the file leaves out.
    """

def bobweight(
    engine: EngineLike,
    /,
    *,
    factor: float | str | None = None,
    changes: Mapping[str, Any] | None = None,
    estimate: bool = False,
) -> Result:
    """Print the bobweight card of a crankshaft: parts, bobweight of each pin, overbalance.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        factor: Share of the reciprocating mass on each pin that is balanced, such as 0.5 or 52%
            (default: the file's, else 0.5).
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
        estimate: fill in what the file leaves out.
    """

def correct(
    runs: Any = None,
    *,
    diameter: float | str | None = None,
    at_radius: float | str | None = None,
    greatest_depth: float | str | None = None,
    tip: float | str | None = None,
    density: float | str | None = None,
    slug: float | str | None = None,
    axial: bool = False,
    unbalance: str | None = None,
    measuring_planes: Iterable[float] | str | None = None,
    correction_planes: Iterable[float] | str | None = None,
    coefficients: Path | str | None = None,
    positions: Iterable[float] | str | None = None,
) -> Result:
    """Say what to add or to drill in two planes of a rotor.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        runs: CSV file (or .xlsx) with an initial run, and one with a trial weight in each
            plane.
        diameter: Diameter of the drill or of the slug, such as "12.7 mm" or "0.5 in".
        at_radius: Radius at which it is drilled, such as "80 mm": of the rim, or of the axis of
            an axial hole.
        greatest_depth: Greatest depth of a hole or length of a slug, such as "25 mm" (default:
            half the radius; with --axial it must be given); where one is not enough there are
            several.
        tip: Angle of the tip of the drill, such as "118 deg" (the default); 180 deg is flat, as
            the default for slugs.
        density: Density of the crankshaft, such as "7.2 g/cm^3" for cast iron (default: steel,
            7.85).
        slug: Fit slugs of heavy metal opposite the heavy spot instead of drilling there: their
            density, such as "17 g/cm^3", or tungsten.
        axial: Holes parallel to the crank axis instead of towards it.
        unbalance: Unbalance that the balancing machine shows, or a mass at a radius, plane by
            plane, with the direction of the heavy spot, such as "850 g*mm at 20 deg, 38 g at 4
            in at 200 deg". Two, in the measuring planes, with directions.
        measuring_planes: Places along the rotor at which its unbalance was measured, such as "0
            mm, 400 mm".
        correction_planes: Places along the rotor at which it is corrected, such as "60 mm, 340
            mm".
        coefficients: CSV file with the influence coefficients of the machine, as
            --save-coefficients writes it; then an initial run is enough.
        positions: Where weights can be added: so many places at equal steps from 0 deg, such as
            12, or their angles, such as "0, 45, 90 deg"; a correction is split between the two
            beside it.
    """

def diagnose(
    engine: EngineLike,
    /,
    measured: Any,
    *,
    before: Any = None,
    speed: float | str | None = None,
    point: str = "",
    changes: Mapping[str, Any] | None = None,
) -> Result:
    """Find the likeliest fault by measured vibration.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        measured: CSV file (or .xlsx): columns order, up, right, z, direction, amplitude, phase;
            also speed, error.
        before: CSV file with the same measurement before the fault; without it the engine file
            says what it was.
        speed: Crank speed, such as "6000 rpm", "628 rad/s" or "100 Hz" (default: the speed in
            the file).
        point: Operating point of the engine file, by its name, such as idle. Default: by speed,
            interpolated between two; without a speed the load of [gas], else the first point.
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
    """

def drill(
    engine: EngineLike | None = None,
    /,
    *,
    diameter: float | str | None = None,
    at_radius: float | str | None = None,
    greatest_depth: float | str | None = None,
    tip: float | str | None = None,
    density: float | str | None = None,
    slug: float | str | None = None,
    axial: bool = False,
    unbalance: str | None = None,
    factor: float | str | None = None,
    weights: Path | str | None = None,
    changes: Mapping[str, Any] | None = None,
    estimate: bool = False,
) -> Result:
    """Say what to drill, or which slugs to fit: for a measured unbalance, or for an engine's.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        diameter: Diameter of the drill or of the slug, such as "12.7 mm" or "0.5 in".
        at_radius: Radius at which it is drilled, such as "80 mm": of the rim, or of the axis of
            an axial hole.
        greatest_depth: Greatest depth of a hole or length of a slug, such as "25 mm" (default:
            half the radius; with --axial it must be given); where one is not enough there are
            several.
        tip: Angle of the tip of the drill, such as "118 deg" (the default); 180 deg is flat, as
            the default for slugs.
        density: Density of the crankshaft, such as "7.2 g/cm^3" for cast iron (default: steel,
            7.85).
        slug: Fit slugs of heavy metal opposite the heavy spot instead of drilling there: their
            density, such as "17 g/cm^3", or tungsten.
        axial: Holes parallel to the crank axis instead of towards it.
        unbalance: Unbalance that the balancing machine shows, or a mass at a radius, plane by
            plane, with the direction of the heavy spot, such as "850 g*mm at 20 deg, 38 g at 4
            in at 200 deg". A mass alone is at the radius of --at-radius.
        factor: Share of the reciprocating mass on each pin that is balanced, such as 0.5 or 52%
            (default: the file's, else 0.5).
        weights: Places of the counterweights: pins, webs, ends (the end webs), or positions
            along the shaft, such as "-200 mm, 200 mm". Default: ends.
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
        estimate: fill in what the file leaves out.
    """

def errata(*, source: str | None = None) -> Result:
    """List errors in published sources: each printed formula beside the correct one.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        source: Only this source, by its key in the references, such as yamamoto2012.
    """

def fault(
    engine: EngineLike,
    /,
    *,
    cut: Iterable[int] | str = (),
    weaker: Iterable[str] | Mapping[Any, Any] | str = (),
    heavier: Iterable[str] | Mapping[Any, Any] | str = (),
    lost_weight: Iterable[str] | Mapping[Any, Any] | str = (),
    speed: float | str | None = None,
    point: str = "",
    at: tuple[float, float, float] | str | None = None,
    orders: Iterable[float] | str | None = None,
    changes: Mapping[str, Any] | None = None,
) -> Result:
    """Tell what would be felt of a fault.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        cut: Cylinders that do not fire, with commas, such as 3.
        weaker: Cylinder with less of its combustion, as in 3=20%; repeatable.
        heavier: Part that is heavier, as in piston.3=20g or big_end.2=15g; lighter with a minus
            sign; repeatable.
        lost_weight: Counterweight that is lost, by its number in the file, or a share of it, as
            in 2, 2=30% or balancer.1; repeatable.
        speed: Crank speed, such as "6000 rpm", "628 rad/s" or "100 Hz" (default: the speed in
            the file).
        point: Operating point of the engine file, by its name, such as idle. Default: by speed,
            interpolated between two; without a speed the load of [gas], else the first point.
        at: Point of the block whose vibration is told: along (z), or along, up and right in
            this order, such as "-120 mm" or "300 mm, 200 mm, 0 mm", or one of [[block.points]]
            by its name (default: the first of these, or the centre of mass).
        orders: Crank orders with commas, such as 1,2,4, or all. Default: up to 6, with halves.
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
    """

def genset(
    engine: EngineLike,
    /,
    *,
    pole_pairs: int | None = None,
    engines: int | None = None,
    flywheel: float | str | None = None,
    irregularity: float | str | None = None,
    off: Iterable[int] | str = (),
    weaker: Iterable[str] | Mapping[Any, Any] | str = (),
    point: str = "",
    speed: float | str | None = None,
    changes: Mapping[str, Any] | None = None,
    estimate: bool = False,
) -> Result:
    """Compute how evenly a generating set runs, and what several do to one foundation.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        pole_pairs: Pairs of poles of the generator, on the crankshaft.
        engines: How many engines: alike on one foundation, or those among which a batch is
            divided. Default: 1.
        flywheel: Moment of inertia of crankshaft, flywheel and what is coupled to them, such as
            "0.25 kg*m^2" (default: drive.inertia of the file).
        irregularity: Degree of irregularity for which the flywheel is wanted, such as 1/50 or
            0.02.
        off: Cylinders that do not fire, as in 2,3; the others burn as much.
        weaker: Cylinder with less of its combustion, as in 3=20%; repeatable.
        point: Operating point of the engine file, by its name, such as idle. Default: by speed,
            interpolated between two; without a speed the load of [gas], else the first point.
        speed: Crank speed, such as "6000 rpm", "628 rad/s" or "100 Hz" (default: the speed in
            the file).
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
        estimate: fill in what the file leaves out.
    """

def grade(
    engine: EngineLike | None = None,
    /,
    *,
    mass: float | str | None = None,
    speed: float | str | None = None,
    grade: float | str | None = None,
    bearing_distances: tuple[float, float] | str | None = None,
    unbalance: str | None = None,
    changes: Mapping[str, Any] | None = None,
    estimate: bool = False,
) -> Result:
    """Print the unbalance that may remain by ISO 21940-11, or the grade that a measured one meets.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        mass: Mass of the rotor as it is balanced, such as "28 kg".
        speed: Crank speed, such as "6000 rpm", "628 rad/s" or "100 Hz" (default: the speed in
            the file).
        grade: Balance quality grade G in mm/s by ISO 21940-11, such as 6.3 or G6.3. Default:
            the usual ones.
        bearing_distances: Distances of the front and the rear bearing from the centre of mass
            of the rotor, such as "210 mm, 260 mm" (default: equal).
        unbalance: Unbalance that the balancing machine shows, or a mass at a radius, plane by
            plane, with the direction of the heavy spot, such as "850 g*mm at 20 deg, 38 g at 4
            in at 200 deg". Which grade does it meet?
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
        estimate: fill in what the file leaves out.
    """

def guide(
    engine: EngineLike,
    /,
    *,
    numbers: Iterable[int] | str = (5, 6, 7, 8, 9, 10, 11, 12),
    firing_orders: Iterable[str] | Mapping[Any, Any] | str = (),
    minimise: str | None = None,
    limit: Iterable[str] | Mapping[Any, Any] | str = (),
    chain_drive: Path | str | None = None,
    first_order: float | str | None = None,
    point: str = "",
    speed: float | str | None = None,
    changes: Mapping[str, Any] | None = None,
) -> Result:
    """List engines with the cylinders of one in rows of 5 to 12, with the best firing orders.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        numbers: Numbers of cylinders, such as 5..12 or 5,6,8. Default: 5..12.
        firing_orders: A firing order to be listed beside the best, as in 1-7-2-5-4-3-6;
            repeatable.
        minimise: Quantity to minimise. As in `search`, together; default: M1,M2.
        limit: Greatest permissible value of a quantity, as in QUANTITY=VALUE, with a unit or in
            that of the result; repeatable. As in `search`.
        chain_drive: From how many cylinders up the two middle ones are farther apart, and by
            how much, such as "9: 600 mm": the chain or the gears of the camshaft stand there.
        first_order: Weights at the ends of the crankshaft that make the first-order moment
            vertical, equal (as much vertical as horizontal) or horizontal, or so great a share
            horizontal, such as 0.3.
        point: Operating point of the engine file, by its name, such as idle. Default: by speed,
            interpolated between two; without a speed the load of [gas], else the first point.
        speed: Crank speed, such as "6000 rpm", "628 rad/s" or "100 Hz" (default: the speed in
            the file).
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
    """

def isolate(
    engine: EngineLike,
    /,
    *,
    minimise: str = "force",
    stiffness: tuple[float, float] | str | None = None,
    shift: tuple[float, float, float] | str = (0.0, 0.0, 0.0),
    sag: float | str | None = None,
    frequencies: tuple[float, float] | str | None = None,
    point: str = "",
    speeds: Iterable[float] | str = (),
    at: tuple[float, float, float] | str | None = None,
    starts: int | None = None,
    changes: Mapping[str, Any] | None = None,
) -> Result:
    """Find the stiffness and place of mounts, within limits, that pass on or shake least.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        minimise: Quantity to minimise. force (on the ground), mounts (the forces of all) or
            velocity (of the point): the greatest over the speeds; each also with rms in front;
            or roll (what is not roll in the mode of roll).
        stiffness: Within which the stiffnesses of the mounts may be chosen, such as "50..400
            N/mm" (default: those of the file).
        shift: How far each mount may be moved each way: "30 mm", or along, up and right as in
            "30 mm, 0 mm, 20 mm" (default: not at all).
        sag: How far the block may sit down on its mounts under its weight, such as "5 mm".
        frequencies: Band in which all natural frequencies on the mounts must lie, such as
            "5..15 Hz".
        point: Operating point of the engine file, by its name, such as idle. Default: by speed,
            interpolated between two; without a speed the load of [gas], else the first point.
        speeds: Crank speeds, such as "600..6000 rpm by 200", "600..6000 rpm/28" (28 speeds) or
            "1000, 2000, 4000 rpm". Default: those of the file.
        at: Point of the block whose vibration is told: along (z), or along, up and right in
            this order, such as "-120 mm" or "300 mm, 200 mm, 0 mm", or one of [[block.points]]
            by its name (default: the first of these, or the centre of mass).
        starts: From how many mounts the search starts, those of the file first. Default: 6.
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
    """

def marine(
    engine: EngineLike,
    /,
    *,
    point: str = "",
    speed: float | str | None = None,
    speeds: Iterable[float] | str = (),
    rated_power: float | str | None = None,
    first_order: float | str | None = None,
    compensate: Iterable[str] | Mapping[Any, Any] | str | None = None,
    phase_error: float | str | None = None,
    node: float | str | None = None,
    bracing: tuple[float, float] | str | None = None,
    orders: Iterable[float] | Literal["all"] | str | None = None,
    changes: Mapping[str, Any] | None = None,
    estimate: bool = False,
) -> Result:
    """Compute external and guide-force moments as project guides have them, and compensators.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        point: Operating point of the engine file, by its name, such as idle. Default: by speed,
            interpolated between two; without a speed the load of [gas], else the first point.
        speed: Crank speed, such as "6000 rpm", "628 rad/s" or "100 Hz" (default: the speed in
            the file).
        speeds: Crank speeds, such as "600..6000 rpm by 200", "600..6000 rpm/28" (28 speeds) or
            "1000, 2000, 4000 rpm". External moments go with its square.
        rated_power: Power against which moments are set, such as "12 MW" (default: that of the
            operating point).
        first_order: Weights at the ends of the crankshaft that make the first-order moment
            vertical, equal (as much vertical as horizontal) or horizontal, or so great a share
            horizontal, such as 0.3.
        compensate: Compensators for the vertical moment of an order, and the one place or two
            along the crankshaft at which they stand, such as "2: 6 m, -6 m"; repeatable.
        phase_error: By how much compensators are late, in degrees of their own turn, such as "5
            deg".
        node: Place along the crankshaft of a node of the hull, about which moments are told and
            compensated, such as "-25 m".
        bracing: Height of the top bracings over the crankshaft, and the distance of their two
            planes along it, such as "5.2 m, 8 m".
        orders: Crank orders with commas, such as 1,2,4, or all. Of both tables. Default: those
            of note.
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
        estimate: fill in what the file leaves out.
    """

def match(
    engine: EngineLike,
    /,
    weights: Any,
    *,
    orders: Iterable[float] | str = (1.0, 2.0),
    quantity: Iterable[Literal["force", "couple"]] | str = ("force", "couple"),
    engines: int = 1,
    classes: Iterable[float] | str = (0.0005, 0.001, 0.002, 0.005),
    whole: bool = False,
    speed: float | str | None = None,
    changes: Mapping[str, Any] | None = None,
) -> Result:
    """Match weighed pistons, pins and rods to the cylinders.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        weights: CSV file (or .xlsx) with the weights: columns no., piston, pin, small end, big
            end.
        orders: Crank orders with commas, such as 1,2,4, or all. Default: 1,2.
        quantity: Quantity, such as force or couple, or several with commas. Force, couple, or
            both (the default).
        engines: How many engines: alike on one foundation, or those among which a batch is
            divided.
        classes: Widths of classes with which the match is compared, such as "1 g, 5 g"
            (default: 0.5, 1, 2 and 5 g).
        whole: Minimise what the whole engine leaves with the counterweights of its file,
            instead of what the parts add to the engine with the mean of the fitted parts in
            every cylinder, for which its crankshaft is balanced afterwards.
        speed: Crank speed, such as "6000 rpm", "628 rad/s" or "100 Hz" (default: the speed in
            the file).
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
    """

def mounts(
    engine: EngineLike,
    /,
    *,
    point: str = "",
    speed: float | str | None = None,
    speeds: Iterable[float] | str = (),
    at: tuple[float, float, float] | str | None = None,
    orders: Iterable[float] | str | None = None,
    changes: Mapping[str, Any] | None = None,
) -> Result:
    """Compute how an engine shakes on its mounts: modes, motion of a point, forces passed on.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        point: Operating point of the engine file, by its name, such as idle. Default: by speed,
            interpolated between two; without a speed the load of [gas], else the first point.
        speed: Crank speed, such as "6000 rpm", "628 rad/s" or "100 Hz" (default: the speed in
            the file).
        speeds: Crank speeds, such as "600..6000 rpm by 200", "600..6000 rpm/28" (28 speeds) or
            "1000, 2000, 4000 rpm". Default: those of the file.
        at: Point of the block whose vibration is told: along (z), or along, up and right in
            this order, such as "-120 mm" or "300 mm, 200 mm, 0 mm", or one of [[block.points]]
            by its name (default: the first of these, or the centre of mass).
        orders: Crank orders with commas, such as 1,2,4, or all. Default: up to 24.
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
    """

def orders(
    engine: EngineLike,
    /,
    *,
    intervals: Iterable[float] | str | None = None,
    any_: bool = False,
    together: bool = False,
    tolerance: float | str | None = None,
    minimise: str | None = None,
    orders: Iterable[float] | str | None = None,
    mode_shape: str | None = None,
    point: str = "",
    top: int | None = None,
    changes: Mapping[str, Any] | None = None,
) -> Result:
    """List the firing orders that a crank can fire, with exhaust intervals and neighbours.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        intervals: Firing intervals, repeated to fill the cycle, such as "90, 150 deg"; 0 for
            cylinders that fire together (default: even).
        any_: List every order that the dead centres allow, the most even first.
        together: With --any: cylinders may fire together at the same dead centre.
        tolerance: Greatest deviation of a firing from its place in the cycle, such as "2 deg"
            (default: 0.0001 deg).
        minimise: Quantity to minimise. Torque, roll or twist of the gas, stress of torsion, or
            load on the bearings; sorts the orders.
        orders: Crank orders with commas, such as 1,2,4, or all. For --minimise. Default:
            0.5,1,1.5,2,2.5,3.
        mode_shape: For torsion: straight, mode N of the engine's [torsion], or the amplitude at
            each cylinder (default: its mode, if it has that table).
        point: Operating point of the engine file, by its name, such as idle. Default: by speed,
            interpolated between two; without a speed the load of [gas], else the first point.
        top: Number of rows to print; --csv and --json have all. Default: 20.
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
    """

def strokes(engine: EngineLike, /, *, changes: Mapping[str, Any] | None = None) -> Result:
    """Print strokes, valve events and exhaust intervals of each cylinder; find exhaust overlaps.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
    """

def tolerance(
    engine: EngineLike,
    /,
    *,
    quantity: Iterable[str] | str = (),
    orders: Iterable[float] | Literal["all"] | str | None = None,
    typical: bool = False,
    distribution: Literal["normal", "uniform"] | str = "normal",
    builds: int = 100000,
    seed: int = 1,
    speed: float | str | None = None,
    reference: Reference | float | str | None = None,
    changes: Mapping[str, Any] | None = None,
    estimate: bool = False,
) -> Result:
    """Scatter the masses, lengths and angles of an engine within their tolerances.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        quantity: Quantity, such as force or couple, or several with commas. Also roll, torque,
            force.up, force.right, couple.pitch, couple.yaw; bearing: the loads on main
            bearings.
        orders: Crank orders with commas, such as 1,2,4, or all. Default: those up to 6 that
            occur.
        typical: Take published tolerances of pistons and rods of car engines for masses that
            the file gives none for.
        distribution: How an error lies within its tolerance: normal, with a standard deviation
            of a third of it (default), or uniform.
        builds: Number of engines built at random, from 1000 to 1000000 (default: 100000).
        seed: Number from which the random engines come; the same number gives the same ones
            (default: 1).
        speed: Crank speed, such as "6000 rpm", "628 rad/s" or "100 Hz" (default: the speed in
            the file).
        reference: Point about which couples and roll are taken: z, or z, up and right, such as
            "-120 mm" or "0 mm, 35 mm, 0 mm", with z as in `crankstar show` (default: the middle
            of the cylinders, on the crank axis).
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
        estimate: fill in what the file leaves out.
    """

def torque(
    engine: EngineLike,
    /,
    *,
    speed: float | str | None = None,
    point: str = "",
    imep: float | str | None = None,
    bmep: float | str | None = None,
    peak_pressure: float | str | None = None,
    motored: bool = False,
    off: Iterable[int] | str = (),
    weaker: Iterable[str] | Mapping[Any, Any] | str = (),
    flywheel: float | str | None = None,
    irregularity: float | str | None = None,
    tangential: Iterable[float] | str = (),
    orders: Iterable[float] | Literal["all"] | str | None = None,
    changes: Mapping[str, Any] | None = None,
    estimate: bool = False,
) -> Result:
    """Compute gas and inertia torque, half orders included, and how evenly the engine runs.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        speed: Crank speed, such as "6000 rpm", "628 rad/s" or "100 Hz" (default: the speed in
            the file).
        point: Operating point of the engine file, by its name, such as idle. Default: by speed,
            interpolated between two; without a speed the load of [gas], else the first point.
        imep: Indicated mean effective pressure of the whole cycle, such as "10 bar".
        bmep: Brake mean effective pressure, such as "9 bar".
        peak_pressure: Greatest pressure of the cycle, such as "75 bar".
        motored: The engine is turned and burns nothing.
        off: Cylinders that do not fire, as in 2,3; the others burn as much.
        weaker: Cylinder with less of its combustion, as in 3=20%; repeatable.
        flywheel: Moment of inertia of crankshaft, flywheel and what is coupled to them, such as
            "0.25 kg*m^2" (default: drive.inertia of the file).
        irregularity: Degree of irregularity for which the flywheel is wanted, such as 1/50 or
            0.02.
        tangential: Harmonics of the tangential pressure of one cylinder at these indicated mean
            effective pressures, such as "4 bar, 8 bar".
        orders: Crank orders with commas, such as 1,2,4, or all. Default: those of note.
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
        estimate: fill in what the file leaves out.
    """

def torsion(
    engine: EngineLike,
    /,
    *,
    point: str = "",
    speed: float | str | None = None,
    speeds: Iterable[float] | str = (),
    orders: Iterable[float] | str | None = None,
    modes: int | None = None,
    holzer: int | None = None,
    off: Iterable[int] | str = (),
    weaker: Iterable[str] | Mapping[Any, Any] | str = (),
    changes: Mapping[str, Any] | None = None,
    estimate: bool = False,
) -> Result:
    """Compute torsional vibration: modes, critical speeds, response and stress of a crankshaft.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        point: Operating point of the engine file, by its name, such as idle. Default: by speed,
            interpolated between two; without a speed the load of [gas], else the first point.
        speed: Crank speed, such as "6000 rpm", "628 rad/s" or "100 Hz" (default: the speed in
            the file).
        speeds: Crank speeds, such as "600..6000 rpm by 200", "600..6000 rpm/28" (28 speeds) or
            "1000, 2000, 4000 rpm". Default: those of the file.
        orders: Crank orders with commas, such as 1,2,4, or all. Default: up to 24.
        modes: How many modes are shown. Default: 4.
        holzer: Also Holzer's table of this mode.
        off: Cylinders that do not fire, as in 2,3; the others burn as much.
        weaker: Cylinder with less of its combustion, as in 3=20%; repeatable.
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
        estimate: fill in what the file leaves out.
    """

def vees(
    cylinders: int | str,
    *,
    bank: Iterable[float] | str | None = None,
    greatest_split: float | str | None = None,
    cycle: Literal["two-stroke", "four-stroke"] | str = "four-stroke",
    top: int | None = None,
) -> Result:
    """List V engines that fire evenly: bank angle, pin split, throws and balance.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        cylinders: Number of cylinders, even, up to 16.
        bank: Bank angles, such as "60 deg, 90 deg" (default: the multiples of the firing
            interval up to 180 deg).
        greatest_split: Greatest pin split, such as "30 deg"; 0 forbids it (default: none).
            Without --bank, also tries the usual bank angles that it makes possible.
        cycle: Working cycle: four-stroke or two-stroke.
        top: Number of rows to print; --csv and --json have all. Default: 20.
    """

def verdict(
    engine: EngineLike,
    /,
    *,
    speed: float | str | None = None,
    changes: Mapping[str, Any] | None = None,
    estimate: bool = False,
) -> Result:
    """State in short sentences which orders balance, which remain, and what would cure them.

    Numbers are in SI units (rad/s, m, N); text has a unit, as on the command line.

        speed: Crank speed, such as "6000 rpm", "628 rad/s" or "100 Hz" (default: the speed in
            the file).
        changes: values of the engine file by key path, such as {"cylinder.stroke": "90 mm"}.
        estimate: fill in what the file leaves out.
    """
