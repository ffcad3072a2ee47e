"""What can be wrong with a search: a sentence for each code.

Placeholders without a value name options; each host writes them in its own way: `--fix`, `fix`.
"""

from __future__ import annotations

from crankstar.language.messages import N_, Plural

SENTENCES: dict[str, str | Plural] = {
    # stars
    "cycle": N_("The cycle is {given}; it can be {choices}."),
    "cylinders": N_("A crank star has {least} to {most} cylinders, not {given}."),
    "positions": N_("{given} positions are given for {cylinders} cylinders; give one for each."),
    "position": N_("A position along the shaft is not a finite number."),
    "symmetric": N_(
        "Only a four-stroke engine with an even number of evenly spaced cylinders has symmetric "
        "cranks."
    ),
    "fixed-cylinder": N_("There is no cylinder {cylinder}; there are 1 to {cylinders}."),
    "fixed-direction": N_(
        "Cylinder {cylinder} cannot have direction {direction}; there are directions 0 to {last}, "
        "and direction d is {step} d deg behind direction 0."
    ),
    "fixed-twice": N_(
        "Cylinder {cylinder} cannot have directions {first} and {second}; give it one."
    ),
    "fixed-mirror": N_(
        "Cylinders {first} and {second} of a symmetric crank have the same direction."
    ),
    "fixed-crowded": N_(
        "Direction {direction} is given to cylinders {cylinders}; it takes only {room}."
    ),
    "fixed-form": N_("{given}: give cylinder = direction, as in 1=0,4=3."),
    "star-throws": N_(
        "The star has {given} throws for {cylinders} cylinders; give a direction for each."
    ),
    "star-directions": N_("Each direction from 0 to {last} occurs {times} times in a star."),
    "gaps": N_("{given}: give the gaps from the front, in pitches, above 0, as in 1,1,1.5,1."),
    "gap-count": N_("{given} gaps are given; {cylinders} cylinders have {wanted}."),
    # stars of an engine
    "one-cylinder": N_("{engine} has one cylinder; a star needs two."),
    "one-throw": N_("{engine} has one throw; a star needs two."),
    "shared-pins": N_(
        "The cylinders of {engine} stand two on a throw; on the command line {minimise} "
        "M1,M2,twist searches their stars and firing orders."
    ),
    "not-in-line": N_(
        "The cylinders of {engine} do not stand in line, each on a throw of its own; give the "
        "number of throws instead."
    ),
    "geared": N_(
        "The crankshaft of {engine} is geared to the reference shaft; give the number of throws "
        "instead."
    ),
    "slave-rods": N_(
        "{engine} has slave rods or shared chambers; give the number of throws instead."
    ),
    "numbering": N_("Number the cylinders of {engine} 1, 2, 3 ... from the front."),
    "engine-cycle": N_("{engine} is a {own} engine; leave {cycle} out, or change its file."),
    "engine-gaps": N_("The positions of the cylinders are in the engine file; leave {gaps} out."),
    "later": N_("{given} angles are given for {cylinders} cylinders; give one for each."),
    # objectives and limits
    "no-quantity": N_(
        "There is no quantity {given}; choose from couples (M1, M2; M1V, M1H: in the vertical, in "
        "the horizontal plane), forces (F1), torsion (T3, with {mode_shape}), guide-force moments "
        "that twist the frame (X3) and neighbours."
    ),
    "roll-alike": N_(
        "{given}: the roll does not depend on the star, because all stars have the same throw "
        "directions; leave it out, and limit it with `crankstar balance`."
    ),
    "order": N_("{name}: the order can be above 0, up to {most}."),
    "half-order": N_("{name}: inertia forces have whole orders only."),
    "no-force": N_("{name}: the pistons of {engine} make no inertia force of this order."),
    "no-side": N_(
        "{name}: the pistons of {engine} do not act that way, nor does anything that is alike on "
        "all throws; leave it out."
    ),
    "horizontal-needs-engine": N_(
        "{name}: what acts horizontally comes from rotating masses, so that it needs an engine; "
        "of a number of cylinders M1 is vertical."
    ),
    "needs-shape": N_("{name} needs a torsional mode, as in {mode_shape} 1,0.5,-0.5,-1."),
    "two-stroke-x": N_("{name}: a two-stroke engine has whole orders of guide forces only."),
    "half-x": N_(
        "{name}: where two cylinders share a direction, half orders depend on the firing order; "
        "search for whole orders."
    ),
    "x-pitch": N_(
        "{name} of {engine} needs the distance of the cylinders: give layout.bore_pitch."
    ),
    "x-gas": N_("{name}: {problem}"),
    "x-none": N_("{name}: the guide forces have no such order; leave it out."),
    "x-unequal": N_("{name}: the cylinders of {engine} are not alike; leave it out."),
    "two-stroke-torsion": N_("{name}: a two-stroke engine has whole orders of torsion only."),
    "half-torsion": N_(
        "{name}: where two cylinders share a direction, half orders depend on the firing order; "
        "search for whole orders, or for twist, which also chooses the firing order."
    ),
    # stars with their firing sequences
    "sequence-cylinders": N_(
        "Star and firing order can be searched together for {least} to {most} cylinders, not "
        "{given}."
    ),
    "bank-odd": N_("A V engine has an even number of cylinders, not {cylinders}."),
    "bank-angle": N_("{given} deg: the bank angle can be above 0 deg, up to 180 deg."),
    "bank-uneven": N_(
        "With shared pins, {cylinders} cylinders fire evenly at bank angles that are multiples of "
        "{step} deg, which {given} deg is not; `crankstar vees` finds split pins."
    ),
    "bank-no-star": N_(
        "No crank of {cylinders} cylinders with shared pins fires evenly at a bank angle of "
        "{given} deg."
    ),
    "throw-gap-count": N_(
        "{given} gaps are given; the throws of {cylinders} cylinders have {wanted}."
    ),
    "several-shafts": N_("{engine} has not one crankshaft that turns at the speed of the engine."),
    "not-shared": N_(
        "The throws of {engine} do not all have one cylinder in line, or two at one bank angle."
    ),
    "not-even": N_("Cylinder {number} does not fire at its place in an even cycle."),
    "pin-apart": N_(
        "Cylinders {first} and {second} are on one pin and fire {apart} deg apart, but this bank "
        "angle asks for {wanted} or {other} deg."
    ),
    "order-uneven": N_("No crank with these pins fires evenly in this order."),
    "order-numbers": N_(
        "{given} is no firing order of cylinders 1 to {count}; give each number once."
    ),
    "order-capped": N_("{given} breaks a limit, so that it cannot be on this front."),
    "torsion-order": N_("{name}: gas torque has whole orders and halves only."),
    "shape-throws": N_(
        "{given} amplitudes are given; give one for each of {throws} throws or {cylinders} "
        "cylinders."
    ),
    "cap-sequence": N_(
        "{name} depends on the firing order; only what the star decides can be limited beside it."
    ),
    "cap-value": N_("A limit is a number from 0 up."),
    "no-goal": N_(
        "{given}: with the firing order, choose from couples (M1), forces (F2), torsion (T1.5), "
        "twist, the largest torsion of {orders}, and neighbours."
    ),
    "goal-balanced": N_("{name} is balanced between the two banks of each pin; leave it out."),
    "sequence-orders": N_(
        "{given}: give up to {most} orders of the gas torque, whole or halves, as in 0.5,1.5,2.5."
    ),
    "engine-bank": N_("The bank angle is in the engine file; leave {bank} out."),
    "orders-unused": N_("{orders} are those of twist; add it, as in {minimise} M1,M2,twist."),
    "sequence-bank": N_("{given}: give one bank angle, as in 90."),
    "too-many-stars": N_(
        "There are {stars} stars, and up to {most} can be gone through; choose another bank angle."
    ),
    "front-too-large": N_("The front has {most} points or more; name fewer goals."),
    "needs-engine": N_(
        "couple, the total over all orders, needs an engine, for its rod ratio; name orders, as in "
        "M1,M2."
    ),
    "alike-order": N_(
        "{name} is the same for every star, because all throws are in phase in this order; leave "
        "it out."
    ),
    "alike-throws": N_(
        "{name} is the same for every star, because the throws are evenly spaced; leave it out."
    ),
    "family-alike-order": N_(
        "{name} is the same for every star of {cylinders} cylinders, because all throws are in "
        "phase in this order; leave it out, or leave this number out of {numbers}."
    ),
    "family-alike-throws": N_(
        "{name} is the same for every star of {cylinders} cylinders, because the throws are evenly "
        "spaced; leave it out, or leave this number out of {numbers}."
    ),
    "weight": N_("{given}: the weight must be a number above 0, as in 2*M2."),
    "named-twice": N_("{name} is named {count} times; once is enough."),
    "none-named": N_("Name at least one quantity, as in M1,M2."),
    "too-many-objectives": N_("{count} objectives are named; there can be up to {most}."),
    "zero-neighbours": N_("Use {avoid_adjacent} to exclude neighbours in succession."),
    "limit-form": N_(
        '{given}: give a quantity and its greatest value, as in M2=1.5 or M2="800 kN m".'
    ),
    "unit-needs-engine": N_(
        "{name}: without an engine there are no newtons; give a number of {unit}, or name an "
        "engine instead of a number of cylinders."
    ),
    "unit-needs-newtons": N_(
        "{name}: without masses, sizes and speed of {engine} there are no newtons; give a number "
        "of {unit}, or add to its file what `crankstar analyze` names."
    ),
    "torsion-unit": N_("{name} has no unit; give a plain number."),
    "amount": N_("{problem}"),
    "limit-whole": N_("{given}: the number of neighbours must be whole."),
    "shape-form": N_("{given}: give an amplitude for each cylinder, as in 1,0.5,-0.5,-1."),
    "shape-count": N_("{given} amplitudes are given for {cylinders} cylinders; give one for each."),
    "shape-needs-engine": N_(
        "{given}: a number of cylinders has no modes of its own; give an engine, or amplitudes."
    ),
    "shape-uniform": N_("The amplitudes are all equal, which is not a vibration."),
    "shape-unused": N_("No order of torsion is searched for; name one, as in {minimise} M1,M2,T3."),
    "several-answers": N_("Ask for only one of {front}, {best}, {all} and {all_with}."),
    "best": N_("{given}: give a whole number from 1 to {most}."),
    "weights-unused": N_("Weights apply only to a list of the best; add {best} 20, or omit them."),
    "all-with-sums": N_("Name a force, couple or torsion in {minimise} that is to be equal."),
    "all-with-form": N_(
        "{given}: give a firing order of cylinders 1 to {cylinders}, or values, as in "
        "M1=0.2673,M2=1.0056."
    ),
    "all-with-text": N_(
        "{given}: give a firing order, as in 1-3-4-2, or values, as in M1=0.2673,M2=1.0056."
    ),
    "all-with-neighbours": N_(
        "Only moments can be required to be equal; to limit neighbours, add {limit} neighbours=1."
    ),
    "all-with-value": N_("{given}: give a value from 0 up, as in M1=0.2673."),
    # questions
    "other-stars": N_("{sum} is a sum over other stars: {cylinders} cylinders."),
    "limit-range": N_("{sum} cannot have a length from {least} to {greatest}."),
    "neighbours": N_("{given} neighbours in succession are not possible; give 0 or more."),
    "no-objective": N_("A list of the best needs an objective."),
    "several-objectives": N_("A list of the best has one objective; combine several into one."),
    "list-size": N_("A list of {given} stars is not possible; ask for at least 1."),
    "function-name": N_(
        "{given}: a function is named in one line of printable signs, as the heading of its column."
    ),
    "function-limit": N_("{name}: the limit is not a number."),
    "function-failed": N_("{name} fails for the star {star}: {error}"),
    "function-value": N_("{name} is {given} for the star {star}; it must be a finite number."),
    "function-stars": N_(
        "More than {most} stars are left for a Python function to evaluate; narrow the search with "
        "limits."
    ),
    "function-order-failed": N_("{name} fails for the firing order {order}: {error}"),
    "function-order-value": N_(
        "{name} is {given} for the firing order {order}; it must be a finite number."
    ),
    "function-orders": N_(
        "More than {most} firing orders are left for a Python function to evaluate; narrow the "
        "search with limits."
    ),
    "too-large": N_(
        "The two halves of a shaft with {free} free throws have {rows} arrangements; {most} can be "
        "held at once. Fix at least {fixed} throws."
    ),
    "too-large-symmetric": N_(
        "The two halves of a shaft with {free} free throws have {rows} arrangements; {most} can be "
        "held at once. Fix at least {fixed} throws, or ask for symmetric cranks."
    ),
    "near-zero": N_(
        "A sum differs from zero by less than the rounding error; ask for all stars ({all}) "
        "instead."
    ),
    # uneven angles
    "no-deviation": N_("Give at least one deviation of the firing intervals, in degrees."),
    "deviation": N_(
        "A deviation of {given} deg is not possible; give 0 or more, below the even interval of "
        "{even} deg."
    ),
    "term-weight": N_("{sum}: the weight is {given}; give 0 or more."),
    "term-limit": N_("{sum}: the greatest length is {given}; give 0 or more."),
    "no-term": N_("Give at least one vector sum a weight above 0."),
    "starts": N_("{given} starting points are not possible; give at least 1."),
    "no-angles": N_(
        "No angles with firing intervals within {deviation} deg of even ones keep {limits}; "
        "allow a greater deviation."
    ),
    "needs-sum": N_(
        "Name a couple, force or torsion in {minimise} that uneven angles are to reduce."
    ),
    # running
    "range-size": N_("A block range has at least 1 block, not {given}."),
    "worker-import": N_(
        "A worker cannot load crankstar ({error}); install the same version wherever workers run."
    ),
    "worker-lost": N_(
        "The worker of one part of the search was lost {times} times ({error}). The cause may be "
        'a lack of memory, or a script without: if __name__ == "__main__"'
    ),
    "executor": N_("The executor is broken and accepts no more work: {error}"),
    "scheduler-gone": N_("The scheduler at {address} is gone; a checkpoint keeps what was done."),
    "scheduler-silent": N_(
        "The scheduler at {address} has not answered, or has had no workers, for {seconds} s; a "
        "checkpoint keeps what was done."
    ),
    "no-distributed": N_(
        'A cluster needs dask.distributed; install it with: pip install "crankstar[cluster]"'
    ),
    "no-scheduler": N_(
        "No dask scheduler answers at {address}; start one with: dask scheduler, and give its "
        "address, as in tcp://host:8786"
    ),
    "no-workers": N_(
        "The scheduler at {address} has no workers; start one with: dask worker {address}"
    ),
    "checkpoint-version": N_(
        "The checkpoint {file} was written by another version of crankstar; name another file."
    ),
    "checkpoint-directory": N_("The checkpoint {file} is not a file; name one, or a new one."),
    "checkpoint-foreign": N_("{file} is not a checkpoint of a search; name another file."),
    "checkpoint-other": N_(
        "{file} is the checkpoint of another search; name another file, or repeat that search."
    ),
    "checkpoint-unreadable": N_(
        "The checkpoint {file} cannot be read ({error}); name another file with {checkpoint}."
    ),
    "checkpoint-unwritable": N_(
        "The checkpoint {file} cannot be written ({error}); name another file with {checkpoint}."
    ),
}
