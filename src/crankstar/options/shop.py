"""The part of the vocabulary of options about a batch of parts, two planes, and faults."""

from __future__ import annotations

from crankstar.analysis.reader import Option

SHOP = {
    "--before": Option(
        "text",
        "CSV file with the same measurement before the fault; without it the engine file says what "
        "it was.",
        ("--healthy", "--baseline"),
    ),
    "--classes": Option(
        "text",
        'Widths of classes with which the match is compared, such as "1 g, 5 g" (default: 0.5, 1, '
        "2 and 5 g).",
        ("--class-widths", "--groups"),
    ),
    "--coefficients": Option(
        "text",
        "CSV file with the influence coefficients of the machine, as --save-coefficients writes "
        "it; then an initial run is enough.",
        ("--influence", "--influence-coefficients", "--known-coefficients"),
    ),
    "--correction-planes": Option(
        "text",
        'Places along the rotor at which it is corrected, such as "60 mm, 340 mm".',
        ("--correcting-planes",),
    ),
    "--cut": Option(
        "text", "Cylinders that do not fire, with commas, such as 3.", ("--dead", "--misfiring")
    ),
    "--engine-file": Option(
        "text",
        "File in which the engine that comes of it is written, .toml, .json or .xlsx; of several "
        "engines each with its number.",
        ("--write-engine", "--save-engine"),
    ),
    "--heavier": Option(
        "several texts",
        "Part that is heavier, as in piston.3=20g or big_end.2=15g; lighter with a minus sign; "
        "repeatable.",
        ("--heavy", "--lighter"),
    ),
    "--lost-weight": Option(
        "several texts",
        "Counterweight that is lost, by its number in the file, or a share of it, as in 2, "
        "2=30% or balancer.1; repeatable.",
        ("--lost", "--missing-weight"),
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
    "--save-coefficients": Option(
        "text",
        "CSV file in which the influence coefficients of the trial runs are written, for the next "
        "rotor.",
        ("--write-coefficients", "--coefficients-file"),
    ),
    "--weaker": Option(
        "several texts",
        "Cylinder with less of its combustion, as in 3=20%; repeatable.",
        ("--weak",),
    ),
    "--whole": Option(
        "nothing",
        "Minimise what the whole engine leaves with the counterweights of its file, instead of "
        "what the parts add to the engine with the mean of the fitted parts in every cylinder, for "
        "which its crankshaft is balanced afterwards.",
        ("--total", "--absolute"),
    ),
}
"""Of matching parts, of corrections in two planes, of faults."""
