"""The sentences of mistakes in the tables [torsion] and [oil] of an engine, and in a chain."""

from __future__ import annotations

from crankstar.language.messages import N_, Plural

SENTENCES: dict[str, str | Plural] = {
    "oil.clearance": N_(
        "{where} is {value} um for a diameter of {diameter} mm; radial clearances are about "
        "{usual} um: um, mm?"
    ),
    "oil.length": N_(
        "{where} is {value} mm for a diameter of {diameter} mm; give the length of one bearing"
    ),
    "torsion.not-first": N_(
        "{where} is given for an engine whose crankshaft, {name}, is not the first of its shafts: "
        "list it first"
    ),
    "torsion.no-inertia": N_(
        "{where} has no inertia of the throws; give inertia (with rods and pistons) or "
        'bare_inertia (the crankshaft alone), such as "0.035 kg*m^2"'
    ),
    "torsion.two-inertias": N_(
        "{where} is given and so is torsion.inertia, which has rods and pistons in it: leave one "
        "out"
    ),
    "torsion.relative": N_(
        "{where} needs the masses and sizes of rods and pistons: give {keys}, or torsion.inertia "
        "instead"
    ),
    "torsion.no-stiffness": N_(
        '{where} has no stiffness between the throws; give stiffness, such as "1.2 MN*m/rad", or '
        "the table torsion.dimensions"
    ),
    "torsion.two-stiffnesses": N_(
        "{where} is given and so is torsion.stiffness; the stiffness is known or estimated: leave "
        "one out"
    ),
    "torsion.one-throw": N_(
        "{where} is that between neighbouring throws of a crankshaft, and none has two: leave it "
        "out; the stiffness of what hangs on a throw is that of a disc or a coupling"
    ),
    "torsion.length": N_("{where} has {count} values; give one for all, or {wanted}, front first"),
    "torsion.bore": N_(
        "{where} is {value} mm, and the shaft around it has {outer} mm; a bore is less"
    ),
    "torsion.bore-alone": N_("{where} is given without {key}: give both, or none"),
    "fatigue.no-dimensions": N_(
        "{where} needs the sizes of a crank throw; give the table torsion.dimensions, also beside "
        "a stiffness"
    ),
    "fatigue.range": N_(
        "{where} is {value} mm; stress concentration factors are known from {low} to {high} mm "
        "({least} to {greatest} of the pin diameter): give all five in torsion.fatigue"
    ),
    "fatigue.overlap": N_(
        "{where} is {value} mm, and pin and journal overlap by {overlap} of it; stress "
        "concentration factors are known up to {greatest}: give all five in torsion.fatigue"
    ),
    "doubt.throw-inertia": N_(
        "{where} is {value} kg m², less than rods and pistons alone have there, {moving} kg m²: is "
        "it the bare_inertia of the crankshaft?"
    ),
    "doubt.soft-crank": N_(
        "{where} is {value} N m/rad, with which the throws alone vibrate at {frequency} Hz; those "
        "of crankshafts of that size have more than {bound} Hz: is the unit right?"
    ),
    "doubt.stiff-crank": N_(
        "{where} is {value} N m/rad, with which the throws alone vibrate at {frequency} Hz; a "
        "steel shaft of that length has less than {bound} Hz: is the unit right?"
    ),
    "doubt.soft-disc": N_(
        "{where} is {value} N m/rad, on which {inertia} kg m² vibrate at {frequency} Hz; drive "
        "lines have more than {bound} Hz: is the unit right?"
    ),
    "doubt.crank-beam": N_(
        "{where} is {value} N m², that of a solid shaft of steel of {diameter} mm; with cylinders "
        "of {size} mm it is one of {low} to {high} mm: is the unit right?"
    ),
    "doubt.crank-support": N_(
        "{where} is {value} N/mm; main bearings with their walls have {low} to {high} N/mm with "
        "cylinders of {size} mm: is the unit right?"
    ),
    "doubt.throw-length": N_(
        "{where}: a journal, a pin and two webs are {value} mm long together, and the throws are "
        "{pitch} mm apart"
    ),
    "disc.same-name": N_("{where} is {value} twice; give each disc its own name"),
    "disc.place-name": N_(
        "{where} is {value}, which names a place of the crankshaft; give the disc another name"
    ),
    "disc.rigid-loss": N_(
        "{where} has no effect on a disc that is rigidly coupled; give a stiffness, or leave it out"
    ),
    "disc.first": N_(
        "{where} is {value}; the first disc of a chain hangs on nothing: leave it out"
    ),
    "disc.first-shaft": N_(
        "{where} has no effect: the first disc of a chain hangs on nothing; give it with the disc "
        "that hangs on it"
    ),
    "disc.no-damping": N_(
        "{where} is 0 without a stiffness, so that nothing holds the disc; leave it out where the "
        "disc turns rigidly with what it hangs on"
    ),
    "fatigue.beyond-web": N_(
        "{where} is {value} mm, in a web that is {web} mm thick; give less than that"
    ),
    "disc.on-nothing": N_(
        "{where} is missing, and so the disc hangs on nothing; say what it hangs on: {names}"
    ),
    "disc.no-such-place": N_("{where} is {value}, which is not there; there are {names}"),
    "torsion.fatigue-cranks": N_(
        "{where} is given for an engine with {count} crankshafts; fatigue is computed of one: "
        "leave it out"
    ),
    "coupling.crankshaft": N_(
        "{where} is {value}, which is no crankshaft beside the first; there are {names}"
    ),
    "coupling.twice": N_("{where}: {value} is turned twice; gears do not close to a loop"),
    "coupling.still": N_(
        "{where} is {value}, on the crankshaft {name}, which nothing turns yet; list its own "
        "coupling before"
    ),
    "coupling.rigid": N_(
        "{where} is missing beside a damping: give both, or neither where it is rigid"
    ),
    "coupling.missing": N_(
        "{where} for {name} is missing: say what turns that crankshaft, such as "
        '[[torsion.coupling]] with crankshaft = {name}, at = "rear", to = "rear"'
    ),
    "disc.on-itself": N_("{where} is {value}, the disc itself; say what it hangs on: {names}"),
    "disc.on-a-later": N_(
        "{where} is {value}, a disc listed later; a disc hangs on one before it, and chains do not "
        "close to a loop"
    ),
}
