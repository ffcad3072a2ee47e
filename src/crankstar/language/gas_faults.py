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
    "gas.not-of-process": N_(
        "{where} has no effect with an ideal cycle, as {process}; leave it out, or take the "
        "process heat-release"
    ),
    "gas.not-of-trace": N_(
        "{where} has no effect beside gas.trace, a measured pressure: leave it out"
    ),
    "gas.warm-beside-trace": N_(
        "{where} has no effect beside gas.trace, a measured pressure, without variable_gamma or "
        "wall_temperature: leave it out"
    ),
    "gas.gamma-twice": N_(
        "{where} is given and so is variable_gamma, by which gamma follows the temperature: leave "
        "one out"
    ),
    "gas.friction-twice": N_("{where} is given and so is gas.friction_pressure: leave one out"),
    "doubt.spark-ratio": N_(
        "{where} is {value}; spark ignition knocks above {bound}: for a Diesel give "
        'gas.ignition = "compression"'
    ),
    "doubt.diesel-ratio": N_(
        "{where} is {value}; compression does not ignite fuel below {bound}: for spark ignition "
        'give gas.ignition = "spark"'
    ),
    "doubt.ratio": N_(
        "{where} is {value}; hardly any engine has less than {least} or more than {most}"
    ),
    "doubt.usual": N_(
        "{where} is {value} {unit}; hardly any engine has less than {least} {unit} or more than "
        "{most} {unit}"
    ),
    "doubt.gamma": N_("{where} is {value}; the gas in a cylinder has 1.2 to 1.42"),
    "doubt.scavenging": N_(
        "{where} is {intake} bar and the exhaust has {exhaust} bar; the charge of a two-stroke "
        "engine drives the exhaust out with more pressure, not less"
    ),
    "doubt.late": N_(
        "{where}: combustion ends at {end} deg, and the exhaust opens at {opened} deg; what burns "
        "later is left out: give a shorter combustion, or a smaller valves.exhaust_opens"
    ),
    "doubt.peak": N_(
        "{where}: the pressure reaches {value} bar; hardly any engine has more than {bound} bar: "
        "are load, compression ratio and intake pressure right?"
    ),
    "doubt.imep": N_(
        "{where}: the indicated mean effective pressure is {value} bar; hardly any engine has more "
        "than {bound} bar"
    ),
    "doubt.small-load": N_(
        "{where} is {value} Pa, next to nothing; engines idle at 1 bar and more: is it a number of "
        "bar? A number without a unit is in pascal"
    ),
    "doubt.charge": N_(
        "{where} is {intake} bar, with which {load} bar of indicated mean effective pressure has "
        "the air-fuel ratio {value}; below {bound} the fuel cannot burn: give the pressure of the "
        "charge, or less load"
    ),
    "doubt.shadowed": N_(
        "{where} ({name}) is at {rpm} rpm, where the load of the table [gas] stands too and counts "
        "unless --point names the other: leave one out, or give it a speed of its own"
    ),
    "doubt.ignition": N_(
        "{where} is {value}, and gas.ignition is {ignition}; no engine has both: change one of them"
    ),
    "doubt.no-work": N_(
        "{where}: friction takes {friction} bar, more than the indicated mean effective pressure "
        "of {load} bar: the engine does not run by itself"
    ),
    "doubt.process-ignition": N_(
        "{where} is {value}, and gas.process is {process}, by which ignition is taken to be by "
        "{ignition}; no engine has both: change one of them"
    ),
    "doubt.great-friction": N_(
        "{where} is {value} bar; hardly any engine has more than {bound} bar"
    ),
    "doubt.friction": N_(
        "{where} is not given, and at {rpm} rpm the correlation of friction, measured up to "
        "{bound} rpm, where it gives {usual} bar, gives {value} bar, which may be far too much"
    ),
    "doubt.load-course": N_(
        "{where} has a mean over the angle of the cycle of only {mean} % of its maximum; "
        "hardly any driven machine has less than {least} %: are the signs and angles right?"
    ),
    "doubt.no-cycle": N_("{where}: {message}"),
    "doubt.cycle": N_(
        "{where} is four-stroke, given or by default, and the stroke is {ratio} times "
        "the bore; only two-stroke engines with crossheads have more than {most}: give {where} = "
        '"two-stroke" if it is one'
    ),
    "doubt.cycle-of-stroke": N_(
        "{where} is four-stroke, given or by default, and no four-stroke engine has a "
        "stroke of {stroke} mm, more than {most} mm: give {where} = "
        '"two-stroke" if it is one'
    ),
    "doubt.overlap": N_(
        "{where}: intake and exhaust are open together for {value} deg, and four-stroke engines "
        'have at most {most} deg; if these are ports, give cycle = "two-stroke"'
    ),
    "doubt.rod-ratio": N_(
        "{where}: the rod is {value} times as long as the crank radius, and only crosshead engines "
        "have less than {least}; if {value} is meant as rod length over stroke, rod_ratio is "
        "{meant}"
    ),
    "doubt.central-rods": N_(
        "{where} is not given: {count} rods turn about one crankpin in one plane, where two can at "
        "most, and a master that is named has no effect; engines with more have one master "
        "rod, and the others on its knuckle pins, {low} to {high} crank radii from the crankpin "
        "(our judgement)"
    ),
    "doubt.pin-split": N_(
        "{where} makes firing less even: it fires at intervals of {intervals} deg, and without the "
        "split at {without} deg"
    ),
    "doubt.firing-split": N_(
        "{where}: the engine fires at intervals of {intervals} deg; with throws at {throws} deg "
        "and a pin_split of {split} deg it fires every {even} deg"
    ),
    "doubt.firing-throws": N_(
        "{where}: the engine fires at intervals of {intervals} deg; with throws at {throws} deg it "
        "fires every {even} deg"
    ),
    "doubt.piston-mass": N_(
        "{where}: {value} kg go up and down, more than a solid bar of steel as thick as the bore "
        "and as long as stroke and rod, {solid} kg; is the unit right?"
    ),
    "doubt.piston-light": N_(
        "{where}: {value} g go up and down, less than any piston with a bore of {bore} mm weighs; "
        "is the unit right?"
    ),
    "doubt.turning-mass": N_(
        "{where} is {value} kg, more than a solid bar of steel as thick as the bore and as long as "
        "stroke and rod, {solid} kg; is the unit right?"
    ),
    "doubt.rod-long": N_(
        "{where} is {value} crank radii; rods of engines have 2.5 to 7: is the unit right?"
    ),
    "doubt.rod-centre": N_(
        "{where} is {value} mm, not between the ends of a rod of {length} mm; is the unit right?"
    ),
    "doubt.same-place": N_(
        "cylinders {first} and {second} of a bank stand in the same place; are the positions right?"
    ),
    "doubt.unbalance": N_(
        "{where} is {value} kg m, more than solid bars of steel as thick as the bores would have "
        "on the crank pins, {solid} kg m; is the unit right?"
    ),
    "doubt.far": N_("{where} is {value} m away from an engine of {size} m; is the unit right?"),
    "doubt.bore-pitch": N_(
        "{where} is {value} mm, but the next cylinder of its bank is only {pitch} mm away; is the "
        "unit right?"
    ),
    "doubt.piston-speed": N_(
        "{where} is {rpm} rpm, with which the mean piston speed is {value} m/s; hardly any engine "
        "has more than {bound} m/s: is it the speed of the engine, and the stroke right?"
    ),
    "doubt.estimate-scale": N_(
        "{where} is {value} mm; the masses are estimated from engines with bores of {low} to "
        "{high} mm, and their ranges hold for those only: weigh the parts if you can"
    ),
    "doubt.stroke": N_(
        "{where} is {value} mm beside a stroke of {stroke} mm; is the unit of one of them wrong?"
    ),
    "doubt.rod-inertia": N_(
        "{where} is {value} kg m²; rods of this mass, length and centre have about {usual} kg m²"
    ),
    "doubt.rod-without-inertia": N_(
        "{where} is not given; taken as that of two masses at the ends of the rod, {value} kg m²; "
        "rods have {low} to {high} kg m²"
    ),
    "doubt.flywheel": N_(
        "{where} is {value} kg m², less than the pistons and rods have, {moving} kg m²: crankshaft "
        "and flywheel together have more"
    ),
    "doubt.great-flywheel": N_(
        "{where} is {value} kg m², {times} times that of the pistons and rods; hardly any engine "
        "has more than {most} times: is the unit right?"
    ),
    "doubt.drive-chain": N_(
        "{where} is {value} kg m², and the masses of [torsion] together have {chain} kg m² at the "
        "crankshaft, without pistons and rods: is part of it left out, or not of the same set?"
    ),
    "doubt.pitch-radius": N_(
        "{where} is {value} mm; wheels of two crankshafts that mesh directly have half the "
        "distance of their shafts, {half} mm"
    ),
    "doubt.wheels-overlap": N_(
        "{where} is {value} mm, more than half the distance of two crankshafts, {half} mm: their "
        "wheels would overlap"
    ),
    "doubt.uneven-set": N_(
        "{where} is {value} kg m², with which the speed at {rpm} rpm varies by one part in about "
        "{parts}, and with {enough} kg m² by one in 100; generating sets have one part in 75 to "
        "300, and none is as uneven under load: are flywheel and rotor not in it?"
    ),
    "doubt.uneven": N_(
        "{where} is {value} kg m², with which the speed at {rpm} rpm varies by one part in about "
        "{parts}, and with {enough} kg m² by one in 30; at full speed engines have one part in 20 "
        "or more, and none, we judge, is as uneven: are flywheel and what is driven not in it?"
    ),
    "drive.lengths": N_("{where} has {count} values for {angles} angles; give as many"),
    "drive.no-load": N_(
        "{where} takes no work: its mean over the angle of the cycle is {mean} % of its maximum; "
        "it must be above 0"
    ),
    "drive.angles": N_("{where} ascends within one cycle of {cycle} deg"),
    "drive.gap": N_(
        "{where} has a gap of {gap} deg, from {start} to {end} deg; give values of the whole cycle"
    ),
    "drive.gap-of-a-turn": N_(
        "{where} has a gap of {gap} deg, from {start} to {end} deg; a load course is that of the "
        "whole cycle of {cycle} deg: if these are the values of one turn, give them again for the "
        "second, at {again} deg"
    ),
    "drive.open-course": N_(
        "{where} is {first} at {start} deg and {last} at {end} deg, which is the same angle: give "
        "both the same, or leave the last out"
    ),
    "drive.output-and-gears": N_(
        '{where} is given, and with gearing = "output" no crankshaft is the output: leave one out'
    ),
    "drive.no-such-crankshaft": N_("{where} is {name}; give one of the crankshafts: {names}"),
    "drive.shares": N_(
        "{where} has {count} values; give one for each crankshaft, {crankshafts} in all"
    ),
    "drive.too-great-shares": N_(
        "{where} adds up to {sum}; the shares of all crankshafts add up to 1 at most"
    ),
    "trace.too-few": N_(
        "{where} has too few samples, {count}; a trace needs at least {least} over its cycle"
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
    "trace.constant": N_(
        "{where} goes from {least} to {peak} bar only, and compression alone makes more of it: is "
        "it the pressure in a cylinder?"
    ),
    "trace.peak": N_(
        "{where} has its peak at {place} deg; angle 0 is the dead centre at which the chamber "
        "fires, and the peak is within 90 deg of it: add {shift} deg to the angles, or is it the "
        "trace of another cycle?"
    ),
    "trace.not-read": N_(
        "{where} is {value}; no file of this name is read here: give what it holds as a table, "
        "such as {example}"
    ),
    "trace.unnamed": N_("{where} is an empty name; give that of a CSV file"),
    "trace.missing": N_("{where} names {file}, but there is no file {place}"),
    "trace.folder": N_("{where} names {file}, which is a folder"),
    "trace.irregular": N_("{where} names {file}, which is no regular file"),
    "trace.unreadable": N_("{where} names {file}, which cannot be read as text"),
    "trace.too-large": N_("{where} names {file}, which is larger than {greatest} MB"),
    "trace.no-columns": N_(
        "{where} names {file}, which has no two columns: crank angle in degrees, pressure in bar"
    ),
    "trace.head": N_(
        "{where} names {file}, whose heading {head} does not have the unit of {dimension}; write "
        "one, as in [{example}]"
    ),
    "trace.head-gauge": N_(
        "{where} names {file}, whose heading {head} says gauge pressure; give absolute pressures: "
        "add that of the surroundings, 1.013 bar at sea level"
    ),
    "trace.gauge": N_(
        "{where} names {file}, in whose column {head} stands {value}; absolute pressures are above "
        "0: add that of the surroundings to gauge pressures"
    ),
    "trace.row": N_(
        "{where} names {file}, whose line {line} is {cells}; give numbers, as many in each line"
    ),
    "trace.jump": N_(
        "{where} ends at {last} bar and begins at {first} bar; a cycle ends where the next begins"
    ),
}
