"""The part of the vocabulary of options that is about tolerances."""

from __future__ import annotations

from crankstar.analysis.reader import Option

SCATTER = {
    "--builds": Option(
        "whole number",
        "Number of engines built at random, from 1000 to 1000000 (default: 100000).",
        ("--samples", "--draws", "--monte-carlo", "--count"),
    ),
    "--distribution": Option(
        "text",
        "How an error lies within its tolerance: normal, with a standard deviation of a third of "
        "it (default), or uniform.",
        ("--law", "--spread"),
    ),
    "--seed": Option(
        "whole number",
        "Number from which the random engines come; the same number gives the same ones "
        "(default: 1).",
        ("--random", "--random-seed"),
    ),
    "--typical": Option(
        "nothing",
        "Take published tolerances of pistons and rods of car engines for masses that the file "
        "gives none for.",
        ("--tolerances", "--assumed"),
    ),
}
"""Every option of tolerances by its name."""
