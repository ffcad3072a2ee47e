"""The sentences of mistakes in the gas, the measured pressure and the drive of an engine."""

from __future__ import annotations

from crankstar.language.messages import N_, Plural

SENTENCES: dict[str, str | Plural] = {
    "gas.two-loads": N_(
        "{where} is given and so is {one}; how much a cycle does is said once: leave one out"
    ),
    "gas.same-name": N_("{where} is {name} twice; give each operating point its own name"),
    "gas.diesel-peak": N_(
        "{where} is given, but the peak of an ideal Diesel cycle is the pressure of compression; "
        'give imep or bmep, or process = "limited-pressure"'
    ),
    "gas.too-high": N_("{where} is {value} bar; no engine has more than {greatest} bar: bar, kPa?"),
    "gas.start": N_(
        "{where} is {value} deg; combustion starts within 90 deg of the dead centre, before it "
        "with a minus sign, such as -15 deg"
    ),
    "gas.duration": N_("{where} is {value} deg; give more than 0 and at most 180 deg"),
    "gas.trace-and-process": N_(
        "{where} is given and so is gas.trace; the pressure is computed or measured: leave one out"
    ),
    "gas.trace-and-load": N_(
        "{where} is given and so is gas.trace, which has a load of its own: leave one out"
    ),
    "drive.lengths": N_("{where} has {count} values for {angles} angles; give as many"),
    "drive.no-load": N_("{where} takes no work over the cycle; its mean is above 0"),
    "drive.angles": N_("{where} ascends within one cycle of {cycle} deg"),
    "trace.too-few": N_(
        "{where} has {count} samples; a trace needs at least {least} over its cycle"
    ),
    "trace.not-ascending": N_(
        "{where} goes from {before} to {after} deg; the angles of a trace ascend"
    ),
    "trace.more-than-a-cycle": N_(
        "{where} is {length} deg after the first sample; a cycle has {cycle} deg, and its end is "
        "the first sample of the next: leave out what repeats"
    ),
    "trace.gap": N_(
        "{where} has a gap of {step} deg; a trace is a whole cycle of {cycle} deg without gaps "
        "over {greatest} deg"
    ),
    "trace.lists": N_(
        "{where} has {count} lists; give one for all chambers, or {chambers}, one for each"
    ),
    "trace.chambers": N_("{where} are {numbers}; the engine's are {chambers}"),
    "trace.lengths": N_("{where} has {count} pressures for {angles} angles; give as many"),
    "trace.unit": N_(
        "{where} has a peak of {peak} bar; that of a cylinder is 2 to 500 bar: is the unit right?"
    ),
    "trace.missing": N_("{where} names {file}, which is not beside the engine file"),
    "trace.unreadable": N_("{where} names {file}, which cannot be read as text"),
    "trace.too-large": N_("{where} names {file}, which is larger than {greatest} MB"),
    "trace.no-columns": N_(
        "{where} names {file}, which has no two columns: crank angle in degrees, pressure in bar"
    ),
    "trace.row": N_(
        "{where} names {file}, whose line {line} is {cells}; give numbers, as many in each line"
    ),
    "trace.jump": N_(
        "{where} ends at {last} bar and begins at {first} bar; a cycle ends where the next begins"
    ),
}
