"""Parts of a cylinder as weighed: the masses they come to, what contradicts them, the bobweight."""

from __future__ import annotations

from typing import Any

import jsonschema
import numpy as np
import pytest

from crankstar import spectra
from crankstar.analyses.bobweight.document import parts_table
from crankstar.engine.engine import Engine
from crankstar.files import EngineFileError, engine_of, explicit, rewritten, schema, toml, tree_of
from crankstar.files.estimate import estimated
from crankstar.files.sheets import sheets_of
from crankstar.files.starters import STARTERS
from crankstar.files.workbook import workbook_bytes, workbook_tree
from crankstar.language.faults import where
from crankstar.mechanics.balance import balance, total
from crankstar.remedy import bobweight, loads, with_counterweights

PARTS = {
    "piston": "510 g",
    "pin": "142 g",
    "locks": "2 g",
    "rings": "46 g",
    "small_end": "178 g",
    "big_end": "422 g",
    "bearing_shells": "44 g",
    "oil": "2 g",
}
CROSS = """
name = "V8"
firing_order = [1, 8, 4, 3, 6, 5, 7, 2]
speed = "6500 rpm"
[cylinder]
stroke = "88.4 mm"
rod_length = "144.8 mm"
[layout]
type = "vee"
throws = ["45 deg", "135 deg", "315 deg", "225 deg"]
bore_pitch = "111.8 mm"
banks = [
  { bearing = "45 deg", cylinders = [1, 3, 5, 7] },
  { bearing = "-45 deg", cylinders = [2, 4, 6, 8] },
]
"""


def tree(**cylinder: Any) -> dict[str, Any]:
    """The V8 with its parts and other values of a cylinder; None leaves one out."""
    out = tree_of(CROSS)
    out["cylinder"] |= {"parts": dict(PARTS), **cylinder}
    return out


def mistakes(of: dict[str, Any]) -> dict[str, str]:
    """Place and code of every mistake."""
    with pytest.raises(EngineFileError) as refused:
        engine_of(of)
    return {where(fault.path): fault.code for fault in refused.value.faults}


def shaking(engine: Engine) -> np.ndarray:
    """Force and couple of all orders as one array."""
    summed = total(balance(engine, speed=engine.speed))
    return np.concatenate(
        [summed.force.forward, summed.force.backward, summed.couple.forward, summed.couple.backward]
    )


def test_the_parts_of_a_file_come_to_the_masses_of_its_cylinders_and_throws() -> None:
    engine = engine_of(tree())
    assert [c.reciprocating_mass for c in engine.cylinders] == pytest.approx([0.878] * 8)
    assert [t.rotating_mass for t in engine.shafts[0].throws] == pytest.approx([0.936] * 4)
    without = tree_of(CROSS)
    without["cylinder"] |= {"reciprocating_mass": "878 g", "rotating_mass": "468 g"}
    assert shaking(engine) == pytest.approx(shaking(engine_of(without)))


def test_parts_may_be_in_any_unit() -> None:
    ounces = {name: f"{float(text.split()[0]) / 28.349523125!r} oz" for name, text in PARTS.items()}
    engine = engine_of(tree(parts=ounces))
    assert engine.cylinders[0].reciprocating_mass == pytest.approx(0.878, rel=1e-12)


def test_a_rod_as_a_body_has_mass_and_centre_of_its_two_ends() -> None:
    rod = engine_of(tree(rod={"inertia": "0.002 kg*m^2"})).cylinders[0].rod
    assert rod is not None
    assert rod.mass == pytest.approx(0.6)
    assert rod.centre == pytest.approx(0.1448 * 178 / 600)
    small, big = rod.shares(0.1448)[::-1]
    assert (small, big) == pytest.approx((0.178, 0.422))


def test_a_rod_of_two_masses_shakes_as_the_body_with_their_inertia() -> None:
    """m_s b_s^2 + m_b b_b^2 about the centre of mass."""
    centre = 0.1448 * 178 / 600
    inertia = 0.178 * (0.1448 - centre) ** 2 + 0.422 * centre**2
    body = engine_of(tree(rod={"inertia": f"{inertia!r} kg*m^2"}))
    points = engine_of(tree())
    assert loads(body)[0].rotating == pytest.approx(loads(points)[0].rotating)
    for kind in ("force", "couple"):
        one, other = (getattr(total(balance(e, speed=600.0)), kind) for e in (body, points))
        assert spectra.peaks(one) == pytest.approx(spectra.peaks(other), rel=1e-9)


def test_a_cylinder_may_have_parts_of_its_own() -> None:
    of = tree()
    of["cylinders"] = [{"number": 2, "parts": {"big_end": "500 g", "piston": "490 g"}}]
    own = {c.number: c for c in engine_of(of).cylinders}
    assert own[2].reciprocating_mass == pytest.approx(0.858)
    assert own[1].reciprocating_mass == pytest.approx(0.878)
    assert own[2].parts is not None
    assert own[2].parts.oil == pytest.approx(0.002)
    assert [p.rotating for p in loads(engine_of(of))] == pytest.approx([1.014, *[0.936] * 3])


def test_parts_alone_of_what_goes_up_and_down_leave_the_rest_to_the_file() -> None:
    of = tree(parts={"piston": "510 g", "small_end": "178 g"}, rotating_mass="468 g")
    assert loads(engine_of(of))[0].rotating == pytest.approx(0.936)


@pytest.mark.parametrize(
    ("values", "expected"),
    [
        ({"reciprocating_mass": "900 g"}, {"cylinder.reciprocating_mass": "parts.reciprocating"}),
        ({"rotating_mass": "700 g"}, {"cylinder.rotating_mass": "parts.rotating"}),
        (
            {"rod": {"mass": "700 g", "centre": "90 mm", "inertia": "0.002 kg*m^2"}},
            {"cylinder.rod.mass": "parts.rod-mass", "cylinder.rod.centre": "parts.rod-centre"},
        ),
        (
            {"parts": {"small_end": "178 g", "piston": "1 g"}, "rod": {"inertia": 0.002}},
            {"cylinder.parts.big_end": "parts.end-missing"},
        ),
        ({"parts": PARTS | {"pistn": "1 g"}}, {"cylinder.parts.pistn": "key.misspelt"}),
        ({"parts": PARTS | {"crosshead": "1 g"}}, {"cylinder.parts.crosshead": "key.unknown"}),
        ({"parts": PARTS | {"piston": "-5 g"}}, {"cylinder.parts.piston": "at-least.example"}),
        ({"parts": PARTS | {"piston": "5 mm"}}, {"cylinder.parts.piston": "unit.other-dimension"}),
        ({"parts": "510 g"}, {"cylinder.parts": "type.example"}),
    ],
)
def test_wrong_and_contradictory_parts_are_refused_each_with_its_place(
    values: dict[str, Any], expected: dict[str, str]
) -> None:
    assert mistakes(tree(**values)).items() >= expected.items()


def test_the_mass_of_one_cylinder_must_agree_with_the_parts_of_all() -> None:
    of = tree()
    of["cylinders"] = [{"number": 3, "reciprocating_mass": "800 g"}]
    assert mistakes(of) == {"cylinders[1].reciprocating_mass": "parts.reciprocating"}
    of["cylinders"] = [{"number": 3, "reciprocating_mass": "878.2 g"}]
    assert engine_of(of).cylinders[2].reciprocating_mass == pytest.approx(0.8782)


def test_both_masses_of_a_contradiction_are_said_in_grams() -> None:
    with pytest.raises(EngineFileError, match=r"is 900 g, but .* come to 878 g; leave it out"):
        engine_of(tree(reciprocating_mass="0.9 kg"))


@pytest.mark.parametrize("rod", [None, {"inertia": "0.002 kg*m^2"}])
def test_an_engine_with_parts_comes_back_from_the_explicit_form(rod: Any) -> None:
    engine = engine_of(tree(**({"rod": rod} if rod else {}), throw_mass="150 g"))
    again = engine_of(tree_of(toml(engine)))
    assert again.cylinders[0].parts == engine.cylinders[0].parts
    assert shaking(again) == pytest.approx(shaking(engine))


def test_the_explicit_form_takes_its_masses_from_parts_too() -> None:
    of = explicit(engine_of(tree(throw_mass="150 g")))
    for own in of["cylinders"]:
        del own["reciprocating_mass"]
    for throw in of["shaft"][0]["throw"]:
        del throw["rotating_mass"]
    assert shaking(engine_of(of)) == pytest.approx(shaking(engine_of(tree(throw_mass="150 g"))))
    of["shaft"][0]["throw"][1]["rotating_mass"] = "1.2 kg"
    of["cylinders"][4]["reciprocating_mass"] = "1 kg"
    assert mistakes(of) == {
        "shaft[1].throw[2].rotating_mass": "parts.rotating",
        "cylinders[5].reciprocating_mass": "parts.reciprocating",
    }


@pytest.mark.release
def test_the_schema_knows_the_parts_in_both_forms() -> None:
    validator = jsonschema.Draft202012Validator(schema())
    validator.validate(tree())
    validator.validate(explicit(engine_of(tree())))
    assert not validator.is_valid(tree(parts={"pistn": "1 g"}))


@pytest.mark.release
@pytest.mark.parametrize("form", ["short", "own", "explicit"])
@pytest.mark.parametrize("parts", [{}, {"piston": "510 g"}, PARTS])
@pytest.mark.parametrize(
    "rod",
    [
        {},
        {"inertia": "0.002 kg*m^2"},
        {"mass": "600 g"},
        {"centre": "42.9 mm"},
        {"mass": "600 g", "centre": "42.96 mm"},
    ],
)
def test_the_schema_takes_the_rods_that_the_reader_takes(
    form: str, parts: dict[str, str], rod: dict[str, str]
) -> None:
    """Except that it knows no sums: that an end is missing, or that two values differ."""
    of = explicit(engine_of(tree())) if form == "explicit" else tree()
    for cylinder in of["cylinders"] if form == "explicit" else [of["cylinder"]]:
        for key in ("parts", "rod", "reciprocating_mass", "rotating_mass"):
            cylinder.pop(key, None)
        cylinder.update({"parts": parts} if parts else {"reciprocating_mass": "878 g"})
    target: dict[str, Any] = of["cylinders"][0] if form == "explicit" else of["cylinder"]
    if form == "own":
        of["cylinders"] = [target := {"number": 1}]
    target["rod"] = rod
    codes: set[str] = set()
    try:
        engine_of(of)
    except EngineFileError as error:
        codes = {fault.code for fault in error.faults}
    valid = jsonschema.Draft202012Validator(schema()).is_valid(of)
    assert valid or codes
    if codes and not any(code.startswith("parts.") for code in codes) and form != "own":
        assert not valid


def test_a_spreadsheet_of_an_engine_has_its_parts_and_gives_them_back() -> None:
    again = workbook_tree(workbook_bytes(sheets_of(tree())), "v8.xlsx")
    assert again["cylinder"]["parts"] == PARTS
    assert engine_of(again) == engine_of(tree())


def test_a_balanced_engine_keeps_the_parts_of_its_file() -> None:
    weighted = with_counterweights(engine_of(tree()), factor=0.5)
    again = rewritten(tree(), weighted)
    assert again["cylinder"]["parts"] == PARTS
    assert again["crankshaft"][0]["weight"][0]["unbalance"].endswith("kg*m")


def test_the_throws_own_mass_is_in_the_counterweight_and_in_no_bobweight() -> None:
    bare, heavy = (engine_of(tree(throw_mass=mass)) for mass in ("0 g", "200 g"))
    one, other = (bobweight(loads(engine)[0], 0.5) for engine in (bare, heavy))
    assert one == other == pytest.approx(1.814)
    one, other = (
        with_counterweights(engine, factor=0.5).shafts[0].weights[0].unbalance / 0.0442
        for engine in (bare, heavy)
    )
    assert (one, other) == pytest.approx((1.814, 1.814 + 2 * 0.2))


@pytest.mark.parametrize("throw_mass", ["0 g", "200 g"])
def test_counterweights_of_the_bobweights_leave_a_v8_no_primary_couple(throw_mass: str) -> None:
    """The card against the forces: what the parts of the card leave is nothing."""
    engine = engine_of(tree(throw_mass=throw_mass))
    left = total(balance(with_counterweights(engine, factor=0.5)))
    for vectors in (left.force, left.couple):
        first = spectra.selected(vectors, 1.0)
        assert abs(first.forward[0]) + abs(first.backward[0]) < 1e-12


def test_a_balance_factor_in_the_file_takes_up_the_throws_own_mass() -> None:
    of = tree(throw_mass="200 g")
    of["balance_factor"] = 0.5
    assert np.allclose(
        shaking(engine_of(of)),
        shaking(with_counterweights(engine_of(tree(throw_mass="200 g")), factor=0.5)),
    )


def test_estimated_crank_pins_are_the_throws_own_and_in_no_bobweight() -> None:
    of = tree_of(CROSS)
    of["cylinder"]["bore"] = "101.6 mm"
    filled = estimated(of)
    assert "cylinder.throw_mass" in [each.path for each in filled.filled]
    pin = loads(engine_of(filled.tree))[0]
    rod = engine_of(filled.tree).cylinders[0].rod
    assert rod is not None
    assert pin.rotating == pytest.approx(2 * rod.shares(0.1448)[0])
    assert pin.own > 0


@pytest.mark.parametrize("kind", sorted(STARTERS))
def test_the_template_says_which_part_belongs_in_which_key(kind: str) -> None:
    text = STARTERS[kind]
    said = {key: text[text.index(key) :].split("\n")[0] for key in ("throw_mass",)}
    assert "own" in said["throw_mass"]
    if kind != "explicit":
        line = text[text.index("rotating_mass =") :].split("\n")[0]
        assert "big end" in line
        assert "crank pin:" in line
        assert "crank pin, webs; in no bobweight" in said["throw_mass"]


@pytest.mark.parametrize("part", ["piston", "small_end", "big_end", "oil"])
@pytest.mark.parametrize("rod", [{}, {"mass": "0.62 kg", "centre": "30 mm"}])
def test_a_negative_part_is_the_only_mistake(part: str, rod: dict[str, str]) -> None:
    of = tree(parts={**PARTS, part: "-900 g"})
    if rod:
        of["cylinder"]["rod"] = {**rod, "inertia": "0.002 kg*m^2"}
    with pytest.raises(EngineFileError) as error:
        engine_of(of)
    assert [fault.path for fault in error.value.faults] == [("cylinder", "parts", part)]


def test_a_radial_without_stroke_is_told_once_what_it_lacks() -> None:
    of = tree_of(STARTERS["radial"])
    del of["cylinder"]["stroke"]
    with pytest.raises(EngineFileError) as error:
        engine_of(of)
    (fault,) = error.value.faults
    assert fault.code == "unit.several-radius"
    assert "gives no cylinder.stroke" in fault.sentence
    assert "cylinder.rod_length, layout.knuckle_radius" in fault.sentence


def test_one_cylinder_with_parts_of_its_own_is_named_in_the_singular() -> None:
    of = tree()
    of["cylinders"] = [{"number": 2, "parts": {"piston": "490 g"}}]
    (parts,) = parts_table(engine_of(of))
    assert [column.heading for column in parts.columns[2:]] == [
        "cylinders 1, 3, 4, 5, 6, 7, 8",
        "cylinder 2",
    ]
