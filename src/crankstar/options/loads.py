"""The part of the vocabulary of options about loads, twist and other programs."""

from __future__ import annotations

from crankstar.analysis.reader import Option

LOADS = {
    "--bmep": Option(
        "text", 'Brake mean effective pressure, such as "9 bar".', ("--brake-mean-pressure",)
    ),
    "--flywheel": Option(
        "text",
        "Moment of inertia of crankshaft, flywheel and what is coupled to them, such as "
        '"0.25 kg*m^2" (default: drive.inertia of the file).',
        ("--inertia",),
    ),
    "--frequencies": Option(
        "text",
        'Band in which all natural frequencies on the mounts must lie, such as "5..15 Hz".',
        ("--band", "--natural-frequencies"),
    ),
    "--irregularity": Option(
        "text",
        "Degree of irregularity for which the flywheel is wanted, such as 1/50 or 0.02.",
        ("--coefficient-of-fluctuation",),
    ),
    "--tangential": Option(
        "text",
        "Harmonics of the tangential pressure of one cylinder at these indicated mean effective "
        'pressures, such as "4 bar, 8 bar".',
        ("--tangential-pressure",),
    ),
    "--imep": Option(
        "text",
        'Indicated mean effective pressure of the whole cycle, such as "10 bar".',
        ("--mean-pressure",),
    ),
    "--gas": Option("nothing", "With the gas pressure of an operating point.", ("--gas-pressure",)),
    "--modes": Option("whole number", "How many modes are shown.", ("--number-of-modes",)),
    "--motored": Option("nothing", "The engine is turned and burns nothing.", ("--cold",)),
    "--off": Option(
        "text", "Cylinders that do not fire, as in 2,3; the others burn as much.", ("--misfire",)
    ),
    "--peak-pressure": Option(
        "text", 'Greatest pressure of the cycle, such as "75 bar".', ("--pmax",)
    ),
    "--bracing": Option(
        "text",
        "Height of the top bracings over the crankshaft, and the distance of their two planes "
        'along it, such as "5.2 m, 8 m".',
        ("--top-bracing", "--stays"),
    ),
    "--chain-drive": Option(
        "text",
        "From how many cylinders up the two middle ones are farther apart, and by how much, such "
        'as "9: 600 mm": the chain or the gears of the camshaft stand there.',
        ("--middle-gap", "--drive-gap"),
    ),
    "--compensate": Option(
        "several texts",
        "Compensators for the vertical moment of an order, and the one place or two along the "
        'crankshaft at which they stand, such as "2: 6 m, -6 m"; repeatable.',
        ("--compensator", "--compensators"),
    ),
    "--engines": Option(
        "whole number",
        "How many engines: alike on one foundation, or those among which a batch is divided.",
        ("--sets", "--how-many-engines"),
    ),
    "--first-order": Option(
        "text",
        "Weights at the ends of the crankshaft that make the first-order moment vertical, equal "
        "(as much vertical as horizontal) or horizontal, or so great a share horizontal, such as "
        "0.3.",
        ("--end-weights",),
    ),
    "--given": Option(
        "several texts",
        "A firing order to be listed beside the best, as in 1-7-2-5-4-3-6; repeatable.",
        ("--published",),
    ),
    "--numbers": Option("text", "Numbers of cylinders, such as 5..12 or 5,6,8.", ("--counts",)),
    "--node": Option(
        "text",
        "Place along the crankshaft of a node of the hull, about which moments are told and "
        'compensated, such as "-25 m".',
        ("--hull-node",),
    ),
    "--phase-error": Option(
        "text", 'By how much compensators are late, in degrees of their own turn, such as "5 deg".'
    ),
    "--pole-pairs": Option(
        "whole number", "Pairs of poles of the generator, on the crankshaft.", ("--poles",)
    ),
    "--rated-power": Option(
        "text",
        'Power against which moments are set, such as "12 MW" (default: that of the operating '
        "point).",
        ("--rating", "--mcr"),
    ),
    "--save": Option(
        "text", "File in which the engine is written with what is added to it: .toml, .json, .xlsx."
    ),
    "--sag": Option(
        "text",
        'How far the block may sit down on its mounts under its weight, such as "5 mm".',
        ("--static-deflection", "--settling"),
    ),
    "--shift": Option(
        "text",
        'How far each mount may be moved each way: "30 mm", or along, up and right as in "30 mm, '
        '0 mm, 20 mm" (default: not at all).',
        ("--move", "--places-within"),
    ),
    "--starts": Option(
        "whole number",
        "From how many mounts the search starts, those of the file first.",
        ("--restarts",),
    ),
    "--stiffness": Option(
        "text",
        'Within which the stiffnesses of the mounts may be chosen, such as "50..400 N/mm" '
        "(default: those of the file).",
        ("--rates", "--spring-rates"),
    ),
    "--to": Option(
        "text",
        "Program for which a .py is written: exudyn (the default), opentorsion or ross; or an "
        "export of another package.",
        ("--for", "--program"),
    ),
    "--point": Option(
        "text",
        "Operating point of the engine file, by its name, such as idle. Default: by speed, "
        "interpolated between two; without a speed the load of [gas], else the first point.",
        ("--load-point",),
    ),
}
