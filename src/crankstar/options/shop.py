"""The part of the vocabulary of options about a batch of parts, two planes, and faults."""

from __future__ import annotations

from crankstar.options.entries import Option

SHOP = {
    "--classes": Option(
        "text",
        'Widths of classes with which the match is compared, such as "1 g, 5 g" (default: 0.5, 1, '
        "2 and 5 g).",
        ("--class-widths", "--groups"),
    ),
    "--engine-file": Option(
        "text",
        "File in which the engine that comes of it is written, .toml, .json or .xlsx; of several "
        "engines each with its number.",
        ("--write-engine", "--save-engine"),
    ),
    "--engines": Option(
        "whole number", "Divide the batch among this number of engines.", ("--how-many-engines",)
    ),
    "--whole": Option(
        "nothing",
        "Minimise what the whole engine leaves with the counterweights of its file, instead of "
        "what the parts add to the engine with the mean of the list in every cylinder, for which its "
        "crankshaft is balanced afterwards.",
        ("--total", "--absolute"),
    ),
}
"""Of matching parts to cylinders."""
