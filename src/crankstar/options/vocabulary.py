"""The vocabulary of options: what each takes and what it means, the same in every command.

A command adds at most how it uses the option. `OPTIONS` is in alphabetical order of the names.
"""

from __future__ import annotations

from crankstar.analysis.reader import Option, Reader
from crankstar.options.goals import GOALS
from crankstar.options.loads import LOADS
from crankstar.options.media import FILMS_AND_SOUNDS
from crankstar.options.scatter import SCATTER
from crankstar.options.shop import SHOP

_MOST = {
    "--all": Option("nothing", "All stars within the limits."),
    "--any": Option(
        "nothing", "List every order that the dead centres allow, the most even first."
    ),
    "--arrows": Option(
        "text",
        "Arrows on the engine with commas, of force and couple, or none (default: force,couple).",
        ("--no-arrows", "--forces"),
    ),
    "--at": Option(
        "text",
        "Point of the block whose vibration is told: along (z), or along, up and right in this "
        'order, such as "-120 mm" or "300 mm, 200 mm, 0 mm", or one of '
        "[[block.points]] by its name (default: the first of these, or the centre of mass).",
        ("--grip", "--place"),
    ),
    "--at-radius": Option(
        "text",
        'Radius at which it is drilled, such as "80 mm": of the rim, or of the axis of an axial '
        "hole.",
        ("--rim", "--drill-radius", "--correction-radius"),
    ),
    "--axial": Option(
        "nothing", "Holes parallel to the crank axis instead of towards it.", ("--parallel",)
    ),
    "--bank": Option(
        "text",
        'Bank angles, such as "60 deg, 90 deg" (default: the multiples of the firing interval up '
        "to 180 deg).",
        ("--banks", "--bank-angle", "--vee-angle", "--vee"),
    ),
    "--bare": Option(
        "nothing",
        "Replace the counterweights of the file instead of adding to them.",
        ("--replace-weights",),
    ),
    "--bearing-distances": Option(
        "text",
        "Distances of the front and the rear bearing from the centre of mass of the rotor, such as "
        '"210 mm, 260 mm" (default: equal).',
        ("--bearing-distance", "--distances"),
    ),
    "--beside": Option(
        "several texts", "Another engine, shown beside this one.", ("--with", "--and", "--compare")
    ),
    "--box": Option(
        "several texts",
        "Box in which balance shafts may lie, up and right of the crankshaft, such as "
        '"-120..-60 mm, -80..80 mm"; they stand where the block rolls least. Without --shafts, '
        "for the shafts of the file. Repeatable, one for each shaft.",
        ("--shaft-box", "--within"),
    ),
    "--by": Option(
        "text",
        "Also the share of each cylinder, bank, shaft or kind (of part).",
        ("--per", "--group-by"),
    ),
    "--chart": Option(
        "text", "Chart to draw: the front, or the stars of the first rows.", ("--plot",)
    ),
    "--checkpoint": Option(
        "text", "File in which the progress of the search is kept, to resume it.", ("--resume",)
    ),
    "--csv": Option("nothing", "Print CSV."),
    "--cycle": Option(
        "text",
        "Working cycle: four-stroke or two-stroke.",
        ("--two-stroke", "--four-stroke", "--strokes"),
    ),
    "--cylinders": Option("whole number", "Only engines with this number of cylinders."),
    "--density": Option(
        "text",
        'Density of the crankshaft, such as "7.2 g/cm^3" for cast iron (default: steel, 7.85).',
        ("--material",),
    ),
    "--diameter": Option(
        "text",
        'Diameter of the drill or of the slug, such as "12.7 mm" or "0.5 in".',
        ("--hole", "--drill", "--bit"),
    ),
    "--displacement": Option(
        "text",
        'Displacement of the whole engine, such as "1998 cc", for a file without sizes.',
        ("--capacity", "--volume"),
    ),
    "--dpi": Option("number", "Dots of a PNG per inch (default: 192).", ("--resolution", "--ppi")),
    "--estimate": Option(
        "nothing",
        "Estimate masses and lengths that the file leaves out, as `crankstar estimate` does; "
        "results have ranges.",
        ("--guess", "--assume"),
    ),
    "--explicit": Option("nothing", "Print a complete engine file in the explicit form."),
    "--factor": Option(
        "text",
        "Share of the reciprocating mass on each pin that is balanced, such as 0.5 or 52% "
        "(default: the file's, else 0.5).",
        ("--balance-factor", "--overbalance", "--underbalance"),
    ),
    "--font-size": Option(
        "text",
        "Size of the smallest letters on paper in points, 8 or more (default: 9).",
        ("--letters", "--text-size"),
    ),
    "--format": Option("text", "text, latex, markdown or html."),
    "--full": Option(
        "nothing",
        "Also the derivations step by step, tables by cylinder, the source of each value and the "
        "engine file.",
        ("--long", "--verbose", "--complete"),
    ),
    "--gaps": Option(
        "text",
        "Gaps between cylinders from the front in pitches, as in 1,1,1.4; else equal.",
        ("--pitch", "--spacing", "--bore-pitch"),
    ),
    "--grade": Option(
        "text",
        "Balance quality grade G in mm/s by ISO 21940-11, such as 6.3 or G6.3.",
        ("--quality", "--iso"),
    ),
    "--greatest": Option(
        "nothing", "Find the greatest value instead of the least.", ("--maximise", "--maximize")
    ),
    "--greatest-depth": Option(
        "text",
        'Greatest depth of a hole or length of a slug, such as "25 mm" (default: half the radius; '
        "with --axial it must be given); where one is not enough there are several.",
        ("--depth", "--max-depth", "--length"),
    ),
    "--greatest-split": Option(
        "text",
        'Greatest pin split, such as "30 deg"; 0 forbids it (default: none). Without --bank, also '
        "tries the usual bank angles that it makes possible.",
        ("--split", "--max-split"),
    ),
    "--greatest-unbalance": Option(
        "text",
        'With --minimise: greatest unbalance of one weight, such as "0.02 kg*m".',
        ("--max-unbalance",),
    ),
    "--height": Option(
        "text", 'Height of the picture, such as "80 mm" (default: what the chart needs).'
    ),
    "--holzer": Option("whole number", "Also Holzer's table of this mode.", ("--table",)),
    "--host": Option(
        "text", "Address to listen on; any but 127.0.0.1 admits other machines.", ("--address",)
    ),
    "--intervals": Option(
        "text",
        'Firing intervals, repeated to fill the cycle, such as "90, 150 deg"; 0 for cylinders that '
        "fire together (default: even).",
    ),
    "--json": Option("nothing", "Print JSON."),
    "--layout": Option(
        "text",
        "Only engines of this layout: inline, vee, boxer, tandem, opposed, radial, explicit.",
    ),
    "--level": Option(
        "nothing", "Move the two shafts of a pair to the heights at which the block does not roll."
    ),
    "--limit": Option(
        "several texts",
        "Greatest permissible value of a quantity, as in QUANTITY=VALUE, with a unit or in that of "
        "the result; repeatable.",
        ("--max", "--at-most"),
    ),
    "--mass": Option(
        "text",
        'Mass of the rotor as it is balanced, such as "28 kg".',
        ("--rotor-mass", "--weight"),
    ),
    "--minimise": Option(
        "text", "Quantity to minimise.", ("--minimize", "--least", "--objective", "--optimise")
    ),
    "--model": Option(
        "text",
        "Crankshaft on its main bearings: determinate (hinged at each) or continuous (one beam).",
        ("--beam",),
    ),
    "--notation": Option(
        "text",
        "Symbols: crankstar (r, l, λ = r/l), stroke (S, L = l/S) or sinitsyn (P_R, C_I, C_II, l0).",
        ("--symbols",),
    ),
    "--open": Option("nothing", "Open the page in the browser.", ("--browser",)),
    "--orders": Option(
        "text", "Crank orders with commas, such as 1,2,4, or all.", ("--order", "--harmonics")
    ),
    "--output": Option("text", "File to write.", ("--out", "--file")),
    "--over": Option(
        "several texts",
        "Value of the engine file to vary, such as balance_factor=0..1, "
        '"layout.banks[1].bearing=0..90 deg/91" (91 values), "speed=600..6000 rpm by 200" or '
        '"balance_factor=0, 0.5, 0.75"; twice to vary two at once.',
        ("--vary", "--range"),
    ),
    "--overwrite": Option("nothing", "Replace an existing file.", ("--force", "--replace")),
    "--pitch-share": Option(
        "number",
        "With --minimise couple: weight of pitch, 0 to 1; yaw has the rest (default: equal).",
    ),
    "--port": Option("whole number", "Port to listen on; 0 takes a free one."),
    "--power": Option(
        "whole number", "Highest power of λ in the series of each harmonic (default: 7)."
    ),
    "--prove": Option(
        "nothing", "Print the exact weights and shafts and prove the cancellation.", ("--proof",)
    ),
    "--quantity": Option(
        "text",
        "Quantity, such as force or couple, or several with commas.",
        ("--watch", "--quantities"),
    ),
    "--radius": Option(
        "text",
        'Radius of the centres of counterweights, for their masses, such as "60 mm" (default: the '
        "crank radius).",
    ),
    "--recommended": Option(
        "nothing",
        "Fit what `crankstar verdict` recommends: the counterweights that cancel what turns with "
        "the crankshafts, then balance shafts for the lowest order that remains.",
    ),
    "--reference": Option(
        "text",
        'Point about which couples and roll are taken: z, or z, up and right, such as "-120 mm" or '
        '"0 mm, 35 mm, 0 mm", with z as in `crankstar show` (default: the middle of the '
        "cylinders, on the crank axis).",
        ("--about", "--origin"),
    ),
    "--row": Option("whole number", "Write this row as an engine file.", ("--rows", "--write")),
    "--scheduler": Option(
        "text", "A dask scheduler with workers, as in tcp://host:8786.", ("--cluster", "--dask")
    ),
    "--set": Option(
        "several texts",
        'Change a value of the file, such as layout.bore_pitch="100 mm"; repeatable.',
        ("--change", "--settings"),
    ),
    "--shaft-place": Option(
        "text",
        'Up and right of the crankshaft, such as "-60 mm, 0 mm" (default: on its axis).',
        ("--shaft-places",),
    ),
    "--shaft-planes": Option(
        "text",
        "Positions of the weights along the balance shafts (default: beyond both ends).",
        ("--shaft-plane",),
    ),
    "--shaft-radius": Option(
        "text", "Radius of the centres of balance shaft weights (default: the crank radius)."
    ),
    "--shaft-spacing": Option(
        "text",
        'Horizontal distance between the two shafts of a pair, such as "120 mm" (default: 0).',
    ),
    "--shafts": Option(
        "text",
        "Add balance shafts: needed (the lowest order that remains; also without a value), all "
        '(first and second order), or speed ratios, such as -1 or "2, -2".',
        ("--balance-shafts", "--balancers"),
    ),
    "--signs": Option(
        "nothing", "Derive the six signs of balance instead: P_R, M_R, P_I, M_I, P_II, M_II."
    ),
    "--size": Option("text", "Width and height of the picture in pixels, such as 720x540."),
    "--slug": Option(
        "text",
        "Fit slugs of heavy metal opposite the heavy spot instead of drilling there: their "
        'density, such as "17 g/cm^3", or tungsten.',
        ("--heavy-metal", "--tungsten", "--mallory"),
    ),
    "--source": Option(
        "text", "Only this source, by its key in the references, such as yamamoto2012."
    ),
    "--speed": Option(
        "text",
        'Crank speed, such as "6000 rpm", "628 rad/s" or "100 Hz" (default: the speed in the '
        "file).",
    ),
    "--speeds": Option(
        "text",
        'Crank speeds, such as "600..6000 rpm by 200", "600..6000 rpm/28" (28 speeds) or '
        '"1000, 2000, 4000 rpm".',
        ("--speed-range", "--rpms"),
    ),
    "--star": Option(
        "whole number",
        "With --row: number of the star with this balance, mirror images and reverses not counted.",
    ),
    "--symbolic": Option(
        "text",
        "Keep a dimension as a symbol: alpha (half the bank angle), phi (crank phase of a twin) or "
        "n (cylinders in a row).",
    ),
    "--theme": Option(
        "text",
        "light, dark or print: the colours of the picture (default: light).",
        ("--colours", "--colors", "--dark", "--style"),
    ),
    "--theta": Option(
        "text",
        'Crank angles with commas, such as "0 deg, 90 deg".',
        ("--angle", "--angles", "--crank-angle"),
    ),
    "--tip": Option(
        "text",
        'Angle of the tip of the drill, such as "118 deg" (the default); 180 deg is flat, as the '
        "default for slugs.",
        ("--tip-angle",),
    ),
    "--together": Option(
        "nothing", "With --any: cylinders may fire together at the same dead centre."
    ),
    "--tolerance": Option(
        "text",
        'Greatest deviation of a firing from its place in the cycle, such as "2 deg" (default: '
        "0.0001 deg).",
    ),
    "--top": Option("whole number", "Number of rows to print; --csv and --json have all."),
    "--type": Option(
        "text",
        "Type of engine: petrol, diesel-car, diesel, motorcycle, aero or crosshead (default: by "
        "bore, cycle, layout and speed).",
        ("--kind", "--class"),
    ),
    "--unbalance": Option(
        "text",
        "Unbalance that the balancing machine shows, or a mass at a radius, plane by plane, with "
        'the direction of the heavy spot, such as "850 g*mm at 20 deg, 38 g at 4 in at 200 deg".',
        ("--residual", "--measured"),
    ),
    "--vectors": Option(
        "nothing",
        "Also the vectors that turn with the crankshaft and against it.",
        ("--forward", "--backward"),
    ),
    "--view": Option(
        "text",
        "From where one looks: isometric (the default), front, side, plan, or sheet: all four.",
        ("--camera", "--look", "--from"),
    ),
    "--weights": Option(
        "text",
        "Places of the counterweights: pins, webs, ends (the end webs), or positions along the "
        'shaft, such as "-200 mm, 200 mm".',
        ("--planes", "--counterweights"),
    ),
    "--width": Option(
        "text", 'Width of the picture, such as "120 mm" (default: what the chart needs).'
    ),
    "--workers": Option(
        "whole number",
        "Worker processes on this machine (default: one for each processor).",
        ("--jobs", "--processes"),
    ),
    "--yes": Option("nothing", "Search even if it takes more than an hour."),
}
OPTIONS = dict(sorted((_MOST | FILMS_AND_SOUNDS | GOALS | LOADS | SCATTER | SHOP).items()))
"""Every option by its name."""


def option_of(reader: Reader) -> Option:
    """What the option of a reader takes and means."""
    return reader.own or OPTIONS[reader.option]


def meaning(name: str, more: str = "") -> str:
    """The help of an option, and what it means in one command besides."""
    return f"{OPTIONS[name].meaning} {more}".rstrip()
