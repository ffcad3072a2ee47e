"""The report: numbers of `analyze`, proofs, no script, the same bytes for the same engine."""

from __future__ import annotations

import json
import re
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from tests.report.reading import Reader, amplitude, plain, vouched

import crankstar
from crankstar import derive, spectra
from crankstar.analyses.verdict.facts import verdict
from crankstar.analysis.document import Column, Table
from crankstar.files import catalog, engine_of
from crankstar.mechanics.balance import balance
from crankstar.report import Subject, report
from crankstar.report.title import data, status
from crankstar.tables.balance_orders import answer
from crankstar.tables.html import part_html
from crankstar.tables.machine import tree

HOSTILE = "</script><img src=x onerror=alert(1)><style>*{}</style> & \"'`\\ 01"
ENGINES = (
    "v8-cross-plane",
    "audi-25-tfsi",
    *(pytest.param(name, marks=pytest.mark.release) for name in ("kr250-production", "jumo-205")),
)


def subject(name: str, **more: Any) -> Subject:
    """An engine of the catalog with a full report."""
    _, tree = catalog.tree_of(name)
    command = f"crankstar report {name} -o report.html"
    return Subject(engine_of(tree, name=name), tree, command, **{"full": True, **more})


@cache
def written(name: str) -> str:
    return report(subject(name))


@pytest.mark.release
@pytest.mark.parametrize("name", ENGINES)
def test_a_report_is_well_formed_and_nothing_in_it_can_run_or_be_fetched(name: str) -> None:
    read = Reader(written(name))
    assert not {"script", "link", "img", "iframe", "object", "embed", "form", "base"} & {
        tag.name for tag in read.tags
    }
    for tag in read.tags:
        assert not [
            key
            for key in tag.attributes
            if key.startswith("on") or key in ("style", "src", "xlink:href")
        ]
        # links lead to places of the report itself
        assert tag.attributes.get("href", "#").startswith("#")
    (style,) = read.styles()
    assert vouched(style) in read.policy()
    assert read.policy().startswith("default-src 'none'; style-src 'sha256-")
    assert "@import" not in style
    assert not re.search(r'url\((?!"data:font/woff2?;base64,)', style)
    names = [tag.attributes["id"] for tag in read.tags if "id" in tag.attributes]
    assert len(names) == len(set(names))
    linked = {tag.attributes["href"][1:] for tag in read.tags if "href" in tag.attributes}
    assert linked <= set(names)


@pytest.mark.release
@pytest.mark.parametrize("name", ENGINES)
def test_every_section_is_there(name: str) -> None:
    sections = [
        tag.attributes["id"]
        for tag in Reader(written(name)).tags
        if tag.name == "section" and "id" in tag.attributes
    ]
    always = [
        "views",
        "data",
        "verdict",
        "crankshaft",
        "strokes",
        "orders",
        "vectors",
        "turn",
        "bearings",
        "whirl",
        "remedies",
    ]
    if crankstar.load(name).gas is not None:
        always.insert(always.index("bearings"), "gas")
    assert sections == [*always, "derivations", "sources", "conventions", "again"]
    assert written(name).count("<svg") >= 10
    assert "<!--figure" not in written(name)


def size_of(order: dict[str, Any], quantity: str) -> float:
    """The greatest value of an order in the machine-readable answer."""
    return sum(abs(complex(*order[quantity][way])) for way in ("forward", "backward"))


@pytest.mark.release
@pytest.mark.parametrize("name", ENGINES)
def test_the_table_of_orders_says_what_the_machine_readable_answer_says(name: str) -> None:
    """Table values times the harmonic of the first piston are the answer of --json."""
    engine = crankstar.load(name)
    result = balance(engine)
    public = tree(answer(engine, result))
    read = Reader(written(name))
    for quantity in ("force", "couple"):
        title = f"{quantity.capitalize()} by the vector stars"
        if title not in read.tables:
            assert all(size_of(one, quantity) < 1e-9 for one in public["orders"])
            continue
        heads, *rows = read.table(title)
        by_order = {one["order"]: one for one in public["orders"]}
        shown = [float(row[0]) for row in rows]
        assert sorted(shown, key=lambda order: -size_of(by_order[order], quantity)) == shown
        for order, one in by_order.items():
            assert order in shown or size_of(one, quantity) < 1e-9
        for row in rows:
            one = by_order[float(row[0])]
            cells = {
                head.split("[")[0].strip(): cell for head, cell in zip(heads, row, strict=True)
            }
            harmonic = abs(float(cells["Aₖ"] or 1.0)) if cells["Aₖ"] != "-" else 1.0
            forward, backward = (complex(*one[quantity][way]) for way in ("forward", "backward"))
            for head, size in (
                ("vertical", forward + backward.conjugate()),
                ("horizontal", (forward - backward.conjugate()) / 1j),
            ):
                assert abs(amplitude(cells[head])) * harmonic == pytest.approx(
                    abs(size), rel=2e-4, abs=1e-9
                )


@pytest.mark.release
def test_forces_in_newtons_are_those_of_the_answer_at_the_speed_of_the_engine() -> None:
    engine = crankstar.load("audi-25-tfsi")
    public = tree(answer(engine, balance(engine, speed=engine.speed)))
    heads, *rows = Reader(written("audi-25-tfsi")).table("Couple on the block")
    sizes = {one["order"]: size_of(one, "couple") for one in public["orders"]}
    for row in rows:
        assert "[N m]" in heads[-1]
        newton_metres = float(row[-1])
        assert newton_metres == pytest.approx(sizes[float(row[0])], rel=1e-4, abs=1e-6)


@pytest.mark.release
def test_loads_with_gas_are_those_of_the_bearings_with_the_cycle_of_the_report() -> None:
    engine = crankstar.load("audi-25-tfsi")
    loads = crankstar.bearing_loads(engine, cycle=crankstar.cycle(engine, speed=engine.speed))
    heads, *rows = Reader(written("audi-25-tfsi")).table("Loads on main bearings from gas")
    assert any("[kN]" in head for head in heads)
    place = next(n for n, head in enumerate(heads) if head.startswith("greatest"))
    told = [1e3 * float(row[place]) for row in rows]
    assert told == pytest.approx(spectra.peaks(loads.load).tolist(), rel=1e-4)
    assert "over a cycle, with gas" in written("audi-25-tfsi")
    assert "over a cycle, with gas" not in written("v8-cross-plane")


@pytest.mark.release
def test_a_short_report_of_many_bearings_draws_the_greatest_loads_and_says_so() -> None:
    page = report(subject("man-s90mc-c", full=False))
    words = re.sub(r"<[^>]+>", " ", page[page.index('<section id="bearings"') :])
    words = " ".join(words[: words.index("Free response")].split())
    assert "3 of 8 main bearings are drawn" in words
    assert "crankstar report --full" in words
    for number in range(1, 9):  # the table has all of them
        assert re.search(rf"\b{number} \S+ assumed", words)


@pytest.mark.release
def test_a_speed_that_is_asked_for_is_the_one_of_every_number() -> None:
    page = report(subject("audi-25-tfsi", speed=100.0, orders=(1.0, 2.0)))
    heads, *rows = Reader(page).table("Couple on the block")
    engine = crankstar.load("audi-25-tfsi")
    public = tree(answer(engine, balance(engine, speed=100.0), orders=[1.0, 2.0]))
    sizes = {one["order"]: size_of(one, "couple") for one in public["orders"]}
    for row in rows:
        assert "[N m]" in heads[-1]
        newton_metres = float(row[-1])
        assert newton_metres == pytest.approx(sizes[float(row[0])], rel=1e-4)
    assert len(rows) == 2
    assert "954.93 rpm" in page
    before, gas, after = page.split('id="again"')[0].split('id="sources"')[0].partition('id="gas"')
    assert gas
    rest = before + after.partition('id="bearings"')[2]
    # the figure that compares it with its cure says which speed the file has instead
    places = [found.start() for found in re.finditer("6500 rpm", rest)]
    assert all("954.93 rpm, as asked for; in" in rest[at - 400 : at] for at in places)


@pytest.mark.release
@pytest.mark.parametrize("name", ENGINES)
def test_the_verdict_and_every_source_are_in_it(name: str) -> None:
    engine = crankstar.load(name)
    shown = plain(Reader(written(name)).text())
    assert all(plain(fact.sentence) in shown for fact in verdict(engine))
    rows = Reader(written(name)).table("Sources of the values")[1:]
    assert rows == [
        [path, origin.status, origin.source] for path, origin in engine.provenance.items()
    ]


@pytest.mark.release
@pytest.mark.parametrize("name", ENGINES)
def test_numbers_that_are_read_have_true_minus_signs_and_raised_powers(name: str) -> None:
    read = Reader(written(name))
    shown = [data for path, data in read.texts if not {"style", "pre", "svg", "math"} & set(path)]
    assert not [data for data in shown if re.search(r"(?<![\w.])-\d|\de[-+−]\d", data)]
    assert any("−0.00" in data for data in shown)
    assert any("·10⁻⁵" in data for data in shown) or name == "audi-25-tfsi"
    file = "".join(data for path, data in read.texts if "pre" in path)
    assert "−" not in file  # what is copied stays as a program reads it


def test_where_two_crankshafts_turn_against_each_other_counterweights_take_both_halves() -> None:
    from crankstar import spectra
    from crankstar.mechanics.balance import total
    from crankstar.remedy import fitting

    for name, about in (("napier-deltic", "couple"), ("kr250-racer", "force")):
        found = fitting.recommended(crankstar.load(name))
        assert found is not None
        left = spectra.selected(getattr(total(balance(found.after)), about), [1.0])
        assert abs(left.forward[0]) + abs(left.backward[0]) < 1e-9


@pytest.mark.release
def test_a_long_table_may_run_over_pages_and_a_lone_cylinder_has_no_millimetres() -> None:
    columns = (Column("a"), Column("b"))
    assert 'class="table short"' in part_html(Table("", columns, ((1.0, 2.0),) * 8))
    assert 'class="table"' in part_html(Table("", columns, ((1.0, 2.0),) * 14))
    assert Reader(written("single")).table("Weights")[0][1] == "z[r]"
    racer = Reader(report(subject("kr250-racer"))).table("Shafts")
    assert racer[0][-1].endswith("[m r]")
    assert racer[2][-1] == "0.5"  # the balance factor of the racer is a half
    assert Reader(written("jumo-205")).table("Shafts")[7][0] == "second, -1000 mm up, 0 mm right"


@pytest.mark.release
def test_values_that_nobody_vouches_for_are_marked_beside_them() -> None:
    page = written("audi-25-tfsi")
    assert (
        '<dt>Rod length between centres</dt><dd>144 mm <span class="doubt">unverified</span></dd>'
        in page
    )
    assert "<dt>Bore</dt><dd>82.5 mm</dd>" in page
    assert (
        '<dt>Speed for the forces</dt><dd>6500 rpm <span class="doubt">placeholder</span></dd>'
        in page
    )
    assert "<dt>Swept volume</dt><dd>2480.4 cm³</dd>" in page  # pi/4 * 8.25² * 9.28 * 5


@pytest.mark.release
@pytest.mark.parametrize("name", ["v8-cross-plane", "audi-25-tfsi"])
def test_derivations_are_there_with_what_is_proved_to_be_zero(name: str) -> None:
    engine = crankstar.load(name)
    page = written(name)
    proved = [
        f"{quantity} of order {order}"
        for quantity in ("force", "couple")
        for order in (1, 2, 4, 6)
        if derive.derivation(engine, order, quantity).zero
    ]
    assert f"Proved to be exactly zero: {', '.join(proved)}." in page
    assert page.count('<section class="derivation">') == 8
    assert "<math" in page


@pytest.mark.release
def test_orders_that_are_named_are_derived_in_full() -> None:
    page = report(subject("i4", orders=(4.0,)))
    assert page.count('<section class="derivation">') == 2  # of the force and the couple
    assert "Every cylinder along its own axis" in page


@pytest.mark.release
def test_the_same_engine_gives_the_same_bytes() -> None:
    assert report(subject("single")) == written("single")


def test_the_name_of_an_engine_is_text_everywhere() -> None:
    tree = {**catalog.tree_of("i4")[1], "name": HOSTILE, "notes": HOSTILE, "source": HOSTILE}
    engine = engine_of(tree, name="hostile")
    page = report(Subject(engine, tree, f"crankstar report {HOSTILE}", beside=engine))
    read = Reader(page)
    assert not {"script", "img"} & {tag.name for tag in read.tags}
    assert sum(tag.name == "style" for tag in read.tags) == 1
    (style,) = read.styles()
    assert vouched(style) in read.policy()
    assert "<" not in style
    assert ("h1", HOSTILE) in {(path[-1], data) for path, data in read.texts if path}


@pytest.mark.release
def test_the_running_title_cannot_leave_its_string() -> None:
    name = 'a"; } * { display: none } \\'
    tree = {**catalog.tree_of("single")[1], "name": name}
    (style,) = Reader(report(Subject(engine_of(tree, name="x"), tree, ""))).styles()
    assert style.endswith('"; } }\n')
    assert "display: none }" not in style.split("@top-left")[-1]


@pytest.mark.release
def test_another_engine_stands_beside_it() -> None:
    page = report(subject("i4", beside=crankstar.load("v8-flat-plane")))
    read = Reader(page)
    rows = read.tables["Force"]
    assert rows[0][2].startswith("V8, flat-plane")
    second = next(row for row in rows if row[0] == "2")
    assert float(second[2]) == pytest.approx(
        2**0.5 * float(second[1]), rel=1e-3
    )  # 4√2 A2 beside 4 A2


@pytest.mark.release
def test_an_engine_without_a_firing_order_has_no_strokes_but_a_sentence() -> None:
    tree = {
        key: value
        for key, value in catalog.tree_of("v8-cross-plane")[1].items()
        if key != "firing_order"
    }
    page = report(Subject(engine_of(tree, name="x"), tree, ""))
    assert "gives no firing order" in page
    assert "Strokes and events" not in page


def test_remedies_leave_what_a_balance_says_they_leave() -> None:
    heads, *rows = Reader(written("v8-cross-plane")).table("Remaining unbalance")
    (couple,) = (row for row in rows if row[:2] == ["1", "couple"])
    assert couple[heads.index("before")] == "3.1623"  # √10
    assert couple[heads.index("now")] == "0"


@pytest.mark.release
def test_the_file_in_the_report_is_the_engine() -> None:
    """What is printed at the end can be read again and is the same engine."""
    import tomllib

    (file,) = [
        data
        for path, data in Reader(written("audi-25-tfsi")).texts
        if path[-2:] == ("pre", "code") and "format" in data
    ]
    assert engine_of(tomllib.loads(file), name="again") == crankstar.load("audi-25-tfsi")


def test_a_cross_plane_crankshaft_whirls_in_a_circle() -> None:
    rows = Reader(written("v8-cross-plane")).table("Paths by order")
    assert rows[1][1] == rows[1][3] == "circle with the crank"


@pytest.mark.release
def test_a_file_that_toml_has_no_words_for_is_shown_as_json(tmp_path: Path) -> None:
    tree = {**catalog.tree_of("single")[1], "speed": None}
    place = tmp_path / "x.json"
    place.write_text(json.dumps(tree), encoding="utf-8")
    page = report(Subject(crankstar.load("single"), tree, "", full=True))
    assert "&quot;speed&quot;: null" in page


@pytest.mark.parametrize(
    ("name", "length", "ratio"),
    [
        ("parallel-twin-180", "unverified", ""),  # stroke from memory, l/r published
        ("bmw-m52b28", "", ""),
        ("audi-25-tfsi", "unverified", "unverified"),  # the length from memory, l/r from it
    ],
)
def test_a_rod_length_is_as_doubtful_as_what_it_is_derived_from(
    name: str, length: str, ratio: str
) -> None:
    marks = {
        datum.label: status(own.engine, datum.keys)
        for own in [subject(name)]
        for datum in data(own)
    }
    assert marks["Rod length between centres"] == length
    assert marks["Crank radius over rod length, λ"] == ratio
