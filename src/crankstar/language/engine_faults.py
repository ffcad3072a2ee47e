"""What can be wrong with an engine: a sentence for each code."""

from __future__ import annotations

from crankstar.language.messages import N_, Plural

SENTENCES: dict[str, str | Plural] = {
    "relative.repeated": N_("{where} names the same thing twice; name each once"),
    "shaft.name-repeated": N_(
        "{where} is {value}, the name of {times} shafts; give each its own name"
    ),
    "shaft.reference-ratio": N_(
        "{where} is {value}; the first shaft is the reference crankshaft and has ratio 1 (for one "
        'that turns the other way give rotation = "counter-clockwise")'
    ),
    "shaft.reference-place": N_(
        "{where} is not at 0, 0; the first shaft is the reference crankshaft, leave out its up and "
        "right"
    ),
    "shaft.period-too-long": N_(
        "{where}: the geared shafts come back to the start only after {turns} turns; up to "
        "{greatest} are possible"
    ),
    "weight.no-such-throw": Plural(
        "{where} is {value}, but the shaft has {count} throw; name it, or leave it out",
        "{where} is {value}, but the shaft has {count} throws; name one of them, or leave it out",
    ),
    "weight.no-throws": N_("{where} is {value}, but the shaft has no throws; leave it out"),
    "weight.no-place": N_("{where} has neither throw nor z; say where along the shaft it is"),
    "bearings.counted-twice": N_("{where} is given beside bearings; keep one of the two"),
    "bearings.no-throws": N_(
        "{where} is {value}, but the shaft has no throws; give the places of its bearings instead"
    ),
    "bearings.too-many": Plural(
        "{where} is {value}, but a shaft with pins at {count} place has at most {most} main "
        "bearings beside them; give their places as bearings",
        "{where} is {value}, but a shaft with pins at {count} places has at most {most} main "
        "bearings beside them; give their places as bearings",
    ),
    "bearings.too-few": N_(
        "{where} has one place; a shaft runs in two main bearings or more, give them all or none"
    ),
    "bearings.one-stiffness": N_(
        "{where} is given without {other}; give both, or neither for rigid bearings"
    ),
    "bearings.outside": N_(
        "{where} is {value} {unit}, outside the crankshaft, whose pins lie between z = {rear} and "
        "{front} {unit}; a main bearing may be up to {room} {unit} beyond them"
    ),
    "bearings.out-of-order": N_(
        "{where} is {value} {unit}, in front of the {before} {unit} before it; list the main "
        "bearings from front to rear"
    ),
    "bearings.overlap": N_(
        "{where} is {value} {unit} and overlaps the main bearing at {before} {unit} before it; "
        "they must be at least {least} {unit} apart"
    ),
    "bearings.on-a-pin": N_(
        "{where} is {value} {unit}, the place of crank pin {throw}; a main bearing stands beside "
        "the pins"
    ),
    "webs.outside": N_(
        "{where} is {value} {unit}, outside the crankshaft, whose pins lie between z = {rear} and "
        "{front} {unit}; a web may be up to {room} {unit} beyond them"
    ),
    "webs.out-of-order": N_(
        "{where} is {value} {unit}, in front of the {before} {unit} before it; list the webs from "
        "front to rear"
    ),
    "webs.overlap": N_(
        "{where} is {value} {unit} and overlaps the web at {before} {unit} before it; they must be "
        "at least {least} {unit} apart"
    ),
    "webs.on-a-pin": N_(
        "{where} is {value} {unit}, the place of crank pin {throw}; a web stands beside its pin"
    ),
    "webs.on-a-bearing": N_(
        "{where} is {value} {unit}, the place of main bearing {bearing}; a web stands between a "
        "pin and a bearing"
    ),
    "webs.missing": N_(
        "{where}: throw {throw} has no web beside it; give the planes of all webs, or of none"
    ),
    "crankshaft.too-many": Plural(
        "{where} has {size} tables, but the layout has {count} crankshaft; give at most one for "
        "each",
        "{where} has {size} tables, but the layout has {count} crankshafts; give at most one for "
        "each",
    ),
    "cylinder.no-mass": N_(
        '{where} is 0, and no other cylinder has a reciprocating mass; give one, such as "650 g"'
    ),
    "cylinder.number-repeated": N_(
        "{where} is {value}, the number of {times} cylinders; give each its own number"
    ),
    "cylinder.no-such-shaft": N_(
        "{where} is {value}, and there is no such shaft; there are: {shafts}"
    ),
    "cylinder.no-such-throw": Plural(
        "{where} is {value}, but shaft {shaft} has {count} throw; name it, or add a "
        "[[shaft.throw]]",
        "{where} is {value}, but shaft {shaft} has throws 1 to {count}; name one of them, or add a "
        "[[shaft.throw]]",
    ),
    "cylinder.no-throws": N_(
        "{where} is {value}, but shaft {shaft} has no throws; add a [[shaft.throw]]"
    ),
    "chamber.too-many-pistons": N_(
        "{where}: combustion chamber {chamber} has {count} pistons; one or two can share a chamber"
    ),
    "chamber.different-speeds": N_(
        "{where}: the pistons of combustion chamber {chamber} work on shafts of different speed; "
        "two can share a chamber where their shafts turn equally fast"
    ),
    "rod.too-short": N_(
        "{where} is {value} {unit}, too short to turn with crank radius {radius} {unit}; at least "
        "{least} {unit} is needed"
    ),
    "rod.too-short-with-offset": N_(
        "{where} is {value} {unit}, too short to turn with crank radius {radius} {unit} and offset "
        "{offset} {unit}; at least {least} {unit} is needed"
    ),
    "rod.slave-too-short": N_(
        "{where} is {value} {unit}, and the articulated rod is too short to reach its "
        "cylinder over "
        "the whole turn; at least {least} {unit} is needed"
    ),
    "rod.too-long": N_(
        "{where} is {value} {unit}, too long for an engine; it can be at most {greatest} {unit}"
    ),
    "rod.no-such-master": N_(
        "{where} is {value}, and there is no such cylinder; there are: {numbers}"
    ),
    "rod.articulated-on-itself": N_(
        "{where} is {value}: cylinder {value} is articulated on itself; one rod of a "
        "group must sit "
        "on the crank pin"
    ),
    "rod.articulated-in-loop": N_(
        "{where} is {value}: cylinders {numbers} are articulated in a loop; one rod of a "
        "group must "
        "sit on the crank pin"
    ),
    "rod.chain-too-long": N_(
        "{where} leads over {rods} rods to the crank pin; at most {greatest} can sit one on the "
        "other"
    ),
    "rod.other-throw": N_(
        "{where} works on shaft {shaft} throw {throw}, its master on {master_shaft} throw "
        "{master_throw}; they must be the same"
    ),
    "firing_angles.count": Plural(
        "{where} has {count} angle, but firing_order has {firings} cylinders; give one angle for "
        "each, in the same order",
        "{where} has {count} angles, but firing_order has {firings} cylinders; give one angle "
        "for each, in the same order",
    ),
    "firing_angles.off-dead-centre": N_(
        "{where} is {value} deg; cylinder {number} is at top dead centre at {angle} deg and every "
        "{period} deg from there, the nearest is {nearest} deg"
    ),
    "firing_angles.not-ascending": N_(
        "{where} is not in order; the angles must ascend within one cycle of {cycle} deg, as "
        "firing_order lists them"
    ),
    "firing_order.repeated": Plural(
        "{where} has cylinder {numbers} more than once; each fires once a cycle",
        "{where} has cylinders {numbers} more than once; each fires once a cycle",
    ),
    "firing_order.no-such-cylinder": Plural(
        "{where} has cylinder {numbers}, and there is no such cylinder; there are: {chambers}",
        "{where} has cylinders {numbers}, and there are no such cylinders; there are: {chambers}",
    ),
    "firing_order.incomplete": Plural(
        "{where} misses cylinder {numbers}; each of {chambers} must fire",
        "{where} misses cylinders {numbers}; each of {chambers} must fire",
    ),
    "firing_order.unfit": N_(
        "{where} is {order}, which this geometry cannot fire in one cycle of {cycle} deg. Top dead "
        "centres, in degrees of crank angle: {centres}. Check the order, the throws and the "
        "bearings."
    ),
    "firing_order.unfit-together": N_(
        "{where} is {order}, which this geometry cannot fire in one cycle of {cycle} deg. Top dead "
        "centres, in degrees of crank angle: {centres}. Cylinders {together} are at dead centre "
        "together; if they are meant to fire together, give firing_angles."
    ),
    "firing_order.unfit-other-banks": N_(
        "{where} is {order}, which this geometry cannot fire in one cycle of {cycle} deg. Top dead "
        "centres, in degrees of crank angle: {centres}. It would fit with the banks on the other "
        "sides (bearings in degrees: {banks}); left may have meant the driver's left."
    ),
    "firing_order.unfit-other-rotation": N_(
        "{where} is {order}, which this geometry cannot fire in one cycle of {cycle} deg. Top dead "
        "centres, in degrees of crank angle: {centres}. It would fit with the crankshaft turning "
        'the other way (rotation = "{rotation}").'
    ),
    "firing_order.unfit-other-pins": N_(
        "{where} is {order}, which this geometry cannot fire in one cycle of {cycle} deg. Top dead "
        "centres, in degrees of crank angle: {centres}. It would fire evenly with the banks on the "
        "other sides (bearings in degrees: {banks}) and the throws at {throws} deg."
    ),
    "firing_order.unfit-uneven-banks": N_(
        "{where} is {order}, which this geometry cannot fire in one cycle of {cycle} deg. Top dead "
        "centres, in degrees of crank angle: {centres}. It would fit with the banks on the other "
        "sides (bearings in degrees: {banks}), but unevenly, at intervals of {intervals} deg."
    ),
    "firing_order.unfit-uneven-rotation": N_(
        "{where} is {order}, which this geometry cannot fire in one cycle of {cycle} deg. Top dead "
        "centres, in degrees of crank angle: {centres}. It would fit with the crankshaft turning "
        'the other way (rotation = "{rotation}"), but unevenly, at intervals of {intervals} deg.'
    ),
    "firing_order.unfit-other-banks-or-rotation": N_(
        "{where} is {order}, which this geometry cannot fire in one cycle of {cycle} deg. Top dead "
        "centres, in degrees of crank angle: {centres}. It would fit with the banks on the other "
        "sides (bearings in degrees: {banks}), or with the crankshaft turning the other way "
        '(rotation = "{rotation}").'
    ),
    "strokes.no-firing-order": N_(
        "{where} is missing, and the stroke of each cylinder depends on it; give it, as in "
        "firing_order = [1, 3, 4, 2] (`crankstar orders` lists the orders that the crank can fire)"
    ),
    "strokes.different-periods": Plural(
        "{where}: cylinder {numbers} is at top dead centre every {period} deg of the reference "
        "crankshaft, the strokes of a {cycle_name} engine need it every {turn} deg; all "
        "crankshafts must turn equally fast",
        "{where}: cylinders {numbers} are at top dead centre every {period} deg of the reference "
        "crankshaft, the strokes of a {cycle_name} engine need it every {turn} deg; all "
        "crankshafts must turn equally fast",
    ),
    "valves.angle": N_(
        "{where} is {value} deg; it must lie between -180 and 180 deg, such as {example} deg"
    ),
    "valves.open-too-long": N_(
        "{where} keeps the {side} open for {length} deg, from 10 to 360 deg are possible; "
        "usual are "
        "{opens} = {usual_opens} deg, {closes} = {usual_closes} deg"
    ),
    "valves.open-too-long-assumed": N_(
        "{where} keeps the {side} open for {length} deg ({assumed} is assumed to be "
        "{assumed_angle} deg), from 10 to 360 deg are possible; usual are {opens} = {usual_opens} "
        "deg, {closes} = {usual_closes} deg"
    ),
    "valves.overlap": N_(
        "{where} keeps intake and exhaust open together for {overlap} deg; at most 180 deg are "
        "possible, 30 deg are usual"
    ),
    "manifold.empty": N_(
        "{where} has no cylinders; name those whose exhausts meet in it, or leave it out"
    ),
    "manifold.no-such-cylinder": Plural(
        "{where} has cylinder {numbers}, and there is no such cylinder; there are: {chambers}",
        "{where} has cylinders {numbers}, and there are no such cylinders; there are: {chambers}",
    ),
    "manifold.repeated": Plural(
        "{where} has cylinder {numbers} more than once; each leads into one manifold",
        "{where} has cylinders {numbers} more than once; each leads into one manifold",
    ),
    "manifold.incomplete": Plural(
        "{where} misses cylinder {numbers}; each leads into one manifold, a pipe of its own is "
        "[{first}]",
        "{where} misses cylinders {numbers}; each leads into one manifold, a pipe of its own is "
        "[{first}]",
    ),
    "rod_ratio.beside-length": N_(
        "{where} is given beside rod_length, from which it follows; keep one of the two"
    ),
    "layout.number-repeated": N_(
        "{where}: the number {number} stands {times} times; number each cylinder once"
    ),
    "override.no-such-cylinder": N_(
        "{where} is {value}, and there is no such cylinder; the layout has {numbers}"
    ),
    "override.repeated": N_(
        "{where}: cylinder {value} has more than one [[cylinders]] table; put all of it in one"
    ),
    "layout.knuckle-too-far": N_(
        "{where} is not shorter than the rod; knuckle pins sit on the master rod"
    ),
    "layout.strokes-on-a-pin": N_(
        "{where}: cylinders {numbers} share a crank pin but differ in stroke; give them the same "
        "stroke, or pins of their own"
    ),
    "layout.throws-missing": N_(
        "{where} is missing; give it, or a firing_order of cylinders 1, 2, ... from which evenly "
        "spaced throws follow"
    ),
    "layout.throws-of-cylinders": Plural(
        "{where} has {count} angle; give {each} (one for each cylinder)",
        "{where} has {count} angles; give {each} (one for each cylinder)",
    ),
    "layout.throws-of-pins": Plural(
        "{where} has {count} angle; give {pins} (one for each pin) or {each} (one for "
        "each cylinder)",
        "{where} has {count} angles; give {pins} (one for each pin) or {each} (one for each "
        "cylinder)",
    ),
    "layout.boxer-banks": Plural(
        "{where} has {count} bank; a boxer has two, opposite each other",
        "{where} has {count} banks; a boxer has two, opposite each other",
    ),
    "layout.boxer-throws": Plural(
        "{where} has {count} angle; give {pins}, the pins of the first bank (those of the second "
        "are opposite)",
        "{where} has {count} angles; give {pins}, the pins of the first bank (those of the second "
        "are opposite)",
    ),
    "layout.master-elsewhere": N_(
        "{where} is {value}, and there is no such cylinder in the row; there are: {numbers}"
    ),
    "layout.banks-unlike": Plural(
        "{where} has {count} cylinder, but the first bank has {first}; banks must have the same "
        "number",
        "{where} has {count} cylinders, but the first bank has {first}; banks must have the same "
        "number",
    ),
    "layout.positions-count": Plural(
        "{where} has {count} place; give {pins}, one for each cylinder of a bank",
        "{where} has {count} places; give {pins}, one for each cylinder of a bank",
    ),
    "layout.position-descending": N_(
        "{where} is {value}, less than the {before} before it; positions are distances behind the "
        "first cylinder, from front to rear"
    ),
    "layout.position-negative": N_(
        "{where} is {value}; positions are distances behind the first cylinder, from 0 up"
    ),
    "numbering.no-such-cylinder": N_(
        "{where}: there is no cylinder {number} to renumber; there are: {numbers}"
    ),
    "numbering.chambers-collide": N_(
        "{where}: two combustion chambers would have the same number; number the chambers as well"
    ),
    "text.control": N_("{where} contains the control character {character}; use printable text"),
    "text.empty": N_("{where} is empty; give it some text"),
    "text.lines": N_("{where} has line breaks or tabs; give it on one line"),
    "ratio.none": N_(
        "{where} is {value}; a whole number or a ratio of teeth is needed, such as "
        '"29/31", negative if the shaft turns the other way'
    ),
    "ratio.zero": N_("{where} is 0; leave out a shaft that does not turn"),
    "ratio.teeth": N_(
        "{where} is {value}, not a ratio of two numbers of teeth up to {greatest}; write "
        "it as one, "
        'such as "1/3"'
    ),
    "ratio.range": N_(
        "{where} is {value}; the shafts of an engine turn at most {greatest} times faster "
        "or slower "
        "than each other"
    ),
    "orders.odd-period": N_(
        "cylinder {number} is at top dead centre every {period} deg, which does not divide a cycle "
        "of {cycle} deg; it cannot fire alike in every cycle"
    ),
    "orders.too-many": N_(
        "there are {total} firing orders, too many to list; give intervals, or a smaller tolerance"
    ),
    "orders.more-than": N_(
        "there are more than {greatest} firing orders; give intervals, or a smaller tolerance"
    ),
    "orders.uneven": Plural(
        "Even firing needs a dead centre every {interval} deg from cylinder {anchor} on; cylinder "
        "{numbers} is at top dead centre at {angles} deg.",
        "Even firing needs a dead centre every {interval} deg from cylinder {anchor} on; cylinders "
        "{numbers} are at top dead centre at {angles} deg.",
    ),
    "orders.crowded": N_(
        "Even firing needs a dead centre every {interval} deg from cylinder {anchor} on; cylinders "
        "{numbers} can fire only at {angles} deg."
    ),
    "vees.cylinders": N_(
        "a V engine of {value} cylinders cannot be searched; give an even number from 2 "
        "to {greatest}"
    ),
    "vees.no-bank-angle": N_(
        "no bank angle up to 180 deg is a multiple of the firing interval, {interval} "
        "deg; give bank "
        "angles"
    ),
    "vees.bank-angle": N_("a bank angle must be above 0 and at most 180 deg"),
    "vees.pin-split": N_("the largest pin split must be 0 deg or more"),
    "orders.intervals-count": Plural(
        "{count} interval is given for {firings} firings in a cycle; give {firings}",
        "{count} intervals are given for {firings} firings in a cycle; give {firings}",
    ),
    "orders.intervals-sum": N_(
        "the intervals {values} deg do not make up a cycle; give intervals from 0 up, together "
        "{cycle} deg"
    ),
    "orders.tolerance": N_(
        "the tolerance is {value} deg; give less than half of the smallest interval, {most} deg"
    ),
}
"""By code, `{where}` the place; what is wrong first, then what would be right."""
