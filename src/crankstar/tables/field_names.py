"""The values of an engine file in the words of the field, by their key paths."""

from __future__ import annotations

from crankstar.files import keys_of
from crankstar.language.messages import N_, _

NAMES = {
    "absolute_damping": N_("damping against the ground"),
    "angle": N_("angle"),
    "balance_factor": N_("balance factor"),
    "bank_angle": N_("bank angle"),
    "bank_offset": N_("bank offset"),
    "bearing": N_("direction"),
    "bearing_stiffness": N_("bearing stiffness"),
    "bending_stiffness": N_("bending stiffness"),
    "big_end_mass": N_("big-end mass"),
    "bmep": N_("brake mean effective pressure"),
    "bore": N_("bore"),
    "bore_pitch": N_("bore pitch"),
    "centre": N_("centre of mass"),
    "combustion_duration": N_("duration of combustion"),
    "combustion_start": N_("start of combustion"),
    "compression_ratio": N_("compression ratio"),
    "crank_distance": N_("distance of the crankshafts"),
    "crankcase_pressure": N_("crankcase pressure"),
    "damping": N_("damping"),
    "diameter": N_("diameter"),
    "exhaust_pressure": N_("exhaust pressure"),
    "friction_pressure": N_("friction mean effective pressure"),
    "gamma": N_("ratio of specific heats"),
    "imep": N_("indicated mean effective pressure"),
    "inertia": N_("moment of inertia"),
    "intake_pressure": N_("intake pressure"),
    "intake_temperature": N_("intake temperature"),
    "journal_bore": N_("bore of the journal"),
    "journal_diameter": N_("journal diameter"),
    "journal_length": N_("journal length"),
    "knuckle_radius": N_("knuckle radius"),
    "lag": N_("lag"),
    "load_exponent": N_("load exponent"),
    "loss_factor": N_("loss factor"),
    "mass": N_("mass"),
    "offset": N_("cylinder offset"),
    "peak_pressure": N_("peak pressure"),
    "pin_angle": N_("pin angle"),
    "pin_bore": N_("bore of the pin"),
    "pin_diameter": N_("pin diameter"),
    "pin_length": N_("pin length"),
    "pin_split": N_("pin split"),
    "pitch_radius": N_("pitch radius"),
    "radius": N_("radius"),
    "reciprocating_mass": N_("reciprocating mass"),
    "right": N_("place to the right"),
    "rod_length": N_("rod length"),
    "rod_ratio": N_("rod ratio l/r"),
    "rotating_mass": N_("rotating mass"),
    "row_pitch": N_("row pitch"),
    "set_back": N_("set-back"),
    "shear_limit": N_("limit of the shear stress"),
    "shear_modulus": N_("shear modulus"),
    "slave_rod_length": N_("slave rod length"),
    "speed": N_("crank speed"),
    "speed_ratio": N_("speed ratio"),
    "stiffness": N_("stiffness"),
    "stroke": N_("stroke"),
    "throw": N_("throw angle"),
    "throw_mass": N_("throw mass"),
    "throws": N_("angle"),
    "unbalance": N_("unbalance"),
    "up": N_("height"),
    "wall_temperature": N_("wall temperature"),
    "web_thickness": N_("web thickness"),
    "web_width": N_("web width"),
    "wiebe_a": N_("Wiebe's a"),
    "wiebe_m": N_("Wiebe's m"),
    "z": N_("position z"),
}
"""By the last key of a path."""
OWNERS = {
    "articulated": N_("the slave rod"),
    "banks": N_("bank {number}"),
    "cranks": N_("crankshaft {number}"),
    "cylinders": N_("cylinder {number}"),
    "rod": N_("the rod"),
    "rows": N_("row {number}"),
    "shaft": N_("shaft {number}"),
    "throw": N_("throw {number}"),
    "throws": N_("throw {number}"),
    "weight": N_("weight {number}"),
}
"""What a value may belong to, by the key of its table."""


def field_name(path: str) -> str:
    """A value of an engine file as engineers call it, with what it belongs to.

    >>> field_name("cylinder.rod_length"), field_name("layout.throws[2]")
    ('rod length', 'angle of throw 2')
    >>> field_name("shaft[1].weight[3].unbalance")
    'unbalance of weight 3 of shaft 1'
    """
    keys = keys_of(path)
    names = [str(key) for key in keys if isinstance(key, str)]
    name = NAMES.get(names[-1])
    text = _(name) if name else names[-1].replace("_", " ")
    for index in range(len(keys) - 1, -1, -1):
        key, following = keys[index], keys[index + 1 : index + 2]
        owner = OWNERS.get(str(key))
        if owner is None or (not following) or isinstance(key, int):
            continue
        number = following[0] + 1 if isinstance(following[0], int) else ""
        text = _("{name} of {owner}", name=text, owner=_(owner, number=number))
    return text


def axis_name(path: str, unit: str) -> str:
    """The title of an axis: the value, and its unit in brackets."""
    return f"{field_name(path)} [{unit}]" if unit else field_name(path)
