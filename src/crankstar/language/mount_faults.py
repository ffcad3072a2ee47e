"""The sentences of mistakes in [block], [[mounts]] and [foundation] of an engine."""

from __future__ import annotations

from crankstar.language.messages import N_, Plural

SENTENCES: dict[str, str | Plural] = {
    "block.too-light": N_(
        "{where} is {value} kg, no more than the pistons and rods in it, {moving} kg; give the "
        "mass of the whole engine"
    ),
    "block.inertia-missing": N_(
        "{where} is missing, and other moments of inertia are given; give all three, or none"
    ),
    "block.inertia-impossible": N_(
        "{where} is {value}, more than {others} together ({sum}); a moment of inertia is at most "
        "the sum of the two others"
    ),
    "block.products-alone": N_(
        "{where} is given without moments of inertia; give inertia_up, inertia_right and inertia_z "
        "too"
    ),
    "block.products-impossible": N_(
        "{where} is {value}, which no body with these moments of inertia has; are sign and unit "
        "right?"
    ),
    "block.size-missing": N_(
        "{where} is missing, and another outer size is given; give length, width and height, or "
        "none"
    ),
    "block.point-twice": N_("{where} is {value} twice; give each point its own name"),
    "mounts.relative": N_(
        "{where} are given for an engine of which not all masses and sizes are known, which cannot "
        "be set against stiffness: give {keys}"
    ),
    "mounts.same-name": N_("{where} is {value} twice; give each mount its own name"),
    "mounts.length": N_(
        "{where} has {count} values; give one for all three axes of the mount, or three"
    ),
    "mounts.no-stiffness": N_(
        '{where} is nought along every axis; give stiffnesses, such as ["200 N/mm", "80 N/mm", '
        '"80 N/mm"]'
    ),
    "mounts.rubber-order": N_(
        "{where} has frequencies that do not rise; list each once, from low to high"
    ),
    "mounts.foot-order": N_(
        "{where} has frequencies that do not rise; list each once, from low to high"
    ),
    "mounts.foot-lag": N_(
        "{where} is not between 0 and 180 deg; what gives way follows the force, it does not lead"
    ),
    "mounts.foot-and-foundation": N_(
        "{where} is given beside feet of mounts ({names}), which say already how the ground gives "
        "way; leave one of them out"
    ),
    "mounts.one": N_(
        "{where} has one mount alone, {name}, about which the block can turn; give mounts at "
        "different places"
    ),
    "mounts.one-place": N_(
        "{where} has {count} mounts at one place, about which the block can turn; give mounts at "
        "different places"
    ),
    "mounts.free": N_(
        "{where} leave the block free to move in: {freedoms}; add a mount, or a stiffness that "
        "holds it there"
    ),
    "foundation.mounts-name": N_(
        "{where} is {value}, which names a mount of the engine; give the mount another name"
    ),
    "foundation.points-name": N_(
        "{where} is {value}, which names a point of the block; give the point another name"
    ),
    "doubt.block-mass": N_(
        "{where} is {value} kg, {share} kg per litre of the {litres} l of the engine; engines have "
        "{low} to {high}, those of cars {car_low} to {car_high}: is it the whole engine, that "
        "alone, and the unit right?"
    ),
    "doubt.foundation-mass": N_(
        "{where} is {value} kg, less than the pistons and rods that shake it, {moving} kg: is the "
        "unit right?"
    ),
    "doubt.slender": N_(
        "{where} is {value} kg m²: a body of this mass that reaches its mounts, {reach} mm from "
        "the axis, has more than {least} kg m²; is the unit right?"
    ),
    "doubt.mount-sag": N_(
        "{where} is {value} N/mm: what stands on these mounts sits down by {sag} mm under its "
        "weight; mounts of engines give way by less than {bound} mm, which takes {usual} N/mm or "
        "more: is the unit right?"
    ),
    "doubt.mount-soft": N_(
        "{where} is {value} N/mm along one axis, and the lowest mode on these mounts has "
        "{frequency} Hz; engines have more than {bound} Hz: is the unit right?"
    ),
    "doubt.mount-stiff": N_(
        "{where} is {value} N/mm, and the lowest mode on these mounts has {frequency} Hz; on "
        "mounts of engines it has less than {bound} Hz, which takes {usual} N/mm or less: is the "
        "unit right?"
    ),
    "doubt.mount-unlike": N_(
        "{where} is {value} N/mm, and the other mounts have about {others} N/mm: is the unit right?"
    ),
    "foundation.alone": N_(
        "{where} is given without mounts of the engine; give [[mounts]], or leave it out"
    ),
    "foundation.no-mounts": N_(
        "{where} is empty, and so the foundation stands on nothing; give [[foundation.mounts]], or "
        "leave the foundation out where it is rigid"
    ),
}
