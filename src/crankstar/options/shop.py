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
    "--correction-planes": Option(
        "text",
        'Places along the rotor at which it is corrected, such as "60 mm, 340 mm".',
        ("--correcting-planes",),
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
    "--measuring-planes": Option(
        "text",
        'Places along the rotor at which its unbalance was measured, such as "0 mm, 400 mm".',
        ("--measured-planes", "--bearing-planes"),
    ),
    "--positions": Option(
        "text",
        "Where weights can be added: so many places at equal steps from 0 deg, such as 12, or "
        'their angles, such as "0, 45, 90 deg"; a correction is split between the two beside it.',
        ("--holes-at", "--bolts"),
    ),
    "--whole": Option(
        "nothing",
        "Minimise what the whole engine leaves with the counterweights of its file, instead of "
        "what the parts add to the engine with the mean of the list in every cylinder, for which "
        "its crankshaft is balanced afterwards.",
        ("--total", "--absolute"),
    ),
}
"""Of matching parts, of corrections in two planes, of faults."""
