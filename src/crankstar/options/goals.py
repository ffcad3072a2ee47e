"""The part of the vocabulary of options about searches: what is asked for, and of which cranks."""

from __future__ import annotations

from crankstar.analysis.reader import Option

GOALS = {
    "--all-with": Option(
        "text",
        "All stars with the same moments as a firing order, as in 1-6-3-4-5-2-7, or with values, "
        "as in M1=0.2673,M2=1.0056.",
        ("--firing-order",),
    ),
    "--avoid-adjacent": Option("nothing", "No cylinders side by side fire in succession."),
    "--best": Option("whole number", "List this many of the best stars."),
    "--fix": Option(
        "text",
        "Fixed throws, as in 1=0,4=3: direction d is 360 d/n deg behind direction 0.",
        ("--fixed", "--throws"),
    ),
    "--front": Option(
        "nothing",
        "The Pareto front: where one quantity can improve only at the expense of another.",
        ("--pareto",),
    ),
    "--judge": Option(
        "text",
        "Stress, bearings: what the whole engine makes of the best way of each row, with gas, as "
        "columns.",
    ),
    "--mode-shape": Option(
        "text",
        "For torsion: straight, mode N of the engine's [torsion], or the amplitude at each "
        "cylinder (default: its mode, if it has that table).",
    ),
    "--why": Option(
        "text", "A firing order to judge, as in 1-5-3-6-2-4: what beats it, and in what."
    ),
    "--zero": Option("text", "Quantities that must vanish, as in M2."),
    "--symmetric": Option("nothing", "Only cranks whose rear half mirrors the front half."),
    "--uneven": Option(
        "text",
        "Refine the throw angles of --row, with firing intervals within so many degrees of even "
        "ones, as in 1,2,5.",
    ),
}
