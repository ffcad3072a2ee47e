"""The part of the vocabulary of options that is about films and sounds."""

from __future__ import annotations

from crankstar.analysis.reader import Option

FILMS_AND_SOUNDS = {
    "--frames-per-second": Option(
        "number", "Pictures of a film in a second (default: 25).", ("--fps", "--rate", "--frames")
    ),
    "--pipe": Option(
        "several texts",
        'Length of the exhaust pipes, such as "0.8 m" (default: 1 m), or of that of one cylinder, '
        'such as "1=0.6 m"; repeatable.',
        ("--pipes", "--primaries"),
    ),
    "--rpm": Option(
        "text",
        "Speed, or the first and the last of a rising or falling one, in rpm: 3000 or 800..6000 "
        "(default).",
    ),
    "--seconds": Option(
        "number",
        "How long a turn of the crankshaft takes in a film (default: 3), or a sound (default: 8).",
        ("--duration",),
    ),
}
"""Every option of films and sounds by its name."""
