"""The panels Torque and Sound, and gas in the rolling moment: they show what Python computes."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest
from playwright.sync_api import Locator, Page, expect
from tests.report.reading import plain
from tests.web.browsing import barriers, too_wide
from tests.web.engine_page import opened, written_of
from tests.web.overflow import overflows

from crankstar import cli, spectra
from crankstar.dynamics import sound
from crankstar.engine.engine import Engine
from crankstar.files import read_file
from crankstar.files.catalog import load
from crankstar.language.shown_units import SYSTEMS, shown_in
from crankstar.mechanics.balance import balance, total
from crankstar.mechanics.gas import cycle
from crankstar.mechanics.gas_torque import gas_torque, over_cycle, roll_with_gas

Build = Callable[..., Path]
Told = Callable[..., dict[str, Any]]
FIVE, BOXER = "audi-25-tfsi", "subaru-ej25"
FOUR = """
name = "four with a cycle"
cycle = "four-stroke"
firing_order = [1, 3, 4, 2]
speed = "3000 rpm"
[cylinder]
bore = "86 mm"
stroke = "86 mm"
rod_length = "150 mm"
reciprocating_mass = "520 g"
[layout]
type = "inline"
bore_pitch = "96 mm"
[gas]
compression_ratio = 10.5
[[gas.point]]
name = "idle"
speed = "800 rpm"
imep = "2 bar"
intake_pressure = "0.4 bar"
[[gas.point]]
name = "full load <b>"
imep = "11 bar"
[drive]
inertia = "0.2 kg m2"
"""
WITHOUT_SOUND = """() => {
  window.contexts = []
  window.AudioContext = class extends OfflineAudioContext {
    constructor() { super(2, 88200, 44100); contexts.push(this); this.begun = null }
    async resume() { setTimeout(() => { this.begun ??= this.startRendering() }) }
    async suspend() {}
    async close() {}
  }
}"""
"""In place of the loudspeakers two seconds of samples, as they stand once all has been set up."""
HEARD = """async () => {
  const buffer = await contexts.at(-1).begun
  return [0, 1].map(channel => [...buffer.getChannelData(channel).slice(44100)])
}"""
OFTEN = 1200.0
"""rpm at which the usual pace of the page is heard."""


@pytest.fixture
def told(capsys: pytest.CaptureFixture[str]) -> Told:
    """What `crankstar torque ... --json` prints."""

    def run(*words: str) -> dict[str, Any]:
        with pytest.raises(SystemExit) as left:
            cli.main(["torque", *words, "--json"])
        assert left.value.code in (0, None)
        return json.loads(capsys.readouterr().out)

    return run


def point_of(name: str) -> str:
    """The operating point that the panel opens with; empty where the file has none."""
    gas = load(name).gas
    return gas.points[0].name if gas is not None and gas.points else ""


def opening(name: str) -> list[str]:
    """The words with which the command line takes the same point."""
    point = point_of(name)
    return ["--point", point] if point else []


def number(text: str) -> float:
    """The number in a text."""
    found = re.search(r"[+-]?\d+\.?\d*(e[+-]?\d+)?", plain(text))
    assert found, text
    return float(found.group())


def by_order(page: Page) -> dict[str, dict[float, float]]:
    """Amplitudes by order from the table of the panel, by the words of its heads."""
    rows = page.locator("details.amplitudes table").first.evaluate(
        "table => [...table.rows].map(row => [...row.cells].map(cell => cell.textContent))"
    )
    heads = [head.split(" [")[0] for head in rows[0]]
    return {
        head: {float(row[0]): float(row[place]) for row in rows[1:]}
        for place, head in enumerate(heads)
    }


def facts(page: Page) -> dict[str, float]:
    """The numbers above the curves."""
    return {
        item.locator("dt").inner_text(): number(item.locator("dd").inner_text())
        for item in page.locator(".torque-facts").first.locator("> div").all()
    }


def compared(page: Page, answer: dict[str, Any]) -> None:
    """The panel has the amplitudes and the mean of the answer, and 0 where it has 0."""
    names = {"gas": "gas torque", "total": "together", "roll": "rolling moment"}
    shown = by_order(page)
    there = {row["order"]: row for row in answer["orders"]}
    assert len(shown["order"]) > 5
    for key, words in names.items():
        for order, size in shown.get(words, {}).items():
            expected = abs(complex(*there[order][key]))
            assert size == pytest.approx(expected, rel=6e-4), (key, order)
            assert (size == 0) == (expected == 0), (key, order)
    assert facts(page)["mean gas torque"] == pytest.approx(answer["mean_torque"], rel=6e-4)
    pressure = facts(page)["indicated mean effective pressure"]
    assert pressure == pytest.approx(answer["imep"] / 1e5, rel=6e-4)
    if "brake torque" in facts(page):
        assert facts(page)["brake torque"] == pytest.approx(answer["brake_torque"], rel=6e-4)


@pytest.mark.release
def test_torque_by_order_is_that_of_the_command_line(
    built_page: Build, page: Page, told: Told
) -> None:
    opened(page, built_page(FIVE), "a=0&tab=torque")
    page.get_by_role("checkbox", name="2", exact=True).check()
    compared(page, told(FIVE, *opening(FIVE), "--off", "2"))


@pytest.mark.release
@pytest.mark.parametrize(
    "name",
    [BOXER, "ferrari-f136", "kr250-racer", "pratt-whitney-wasp", "napier-deltic", "jumo-205"],
)
def test_torque_of_every_kind_of_engine_is_that_of_the_command_line(
    name: str, built_page: Build, page: Page, told: Told
) -> None:
    opened(page, built_page(name), "a=0&tab=torque")
    compared(page, told(name, *opening(name)))
    page.get_by_role("checkbox", name="1", exact=True).check()
    compared(page, told(name, *opening(name), "--off", "1"))
    page.get_by_role("radio", name="motored: no combustion").check()
    compared(page, told(name, *opening(name), "--motored"))


@pytest.mark.release
def test_an_operating_point_and_its_irregularity_are_those_of_python(
    tmp_path: Path, page: Page, told: Told
) -> None:
    place = tmp_path / "four.toml"
    place.write_text(FOUR, encoding="utf-8")
    opened(page, written_of(tmp_path, read_file(place)), "a=0&tab=torque")
    for name in ("idle", "full load <b>"):
        page.get_by_role("radio", name=name, exact=True).check()
        answer = told(str(place), "--point", name)
        compared(page, answer)
        uneven = facts(page)["degree of irregularity"]
        assert uneven == pytest.approx(answer["irregularity"], rel=6e-4)
    page.wait_for_function("() => location.hash.includes('torque.load=full')")
    expect(page.locator(".torque-basis .badge")).to_have_count(0)
    page.get_by_role("checkbox", name="4", exact=True).check()
    linear = facts(page)["degree of irregularity, linear estimate"]
    lame = told(str(place), "--point", "full load <b>", "--off", "4")["irregularity"]
    assert linear == pytest.approx(lame, rel=0.05)


def outputs(page: Page, place: int) -> list[float]:
    """The values at the crank angle below the curves at this place of the panel."""
    legend = page.locator(".cycle-curves").nth(place).locator("output")
    return [number(text) for text in legend.all_inner_texts()]


def rolled(engine: Engine, degrees: float, off: tuple[int, ...] = ()) -> float:
    """The rolling moment with gas, N m."""
    sums = total(balance(engine, speed=engine.speed))
    whole = roll_with_gas(sums, gas_torque(cycle(engine, point=point_of(FIVE), off=off)).total)
    return float(np.real(spectra.value(whole, math.radians(degrees))))


@pytest.mark.release
def test_the_values_at_the_crank_angle_are_those_of_the_pressure(
    built_page: Build, page: Page
) -> None:
    engine = load(FIVE)
    opened(page, built_page(FIVE), "a=130&tab=torque&torque.off=4")
    gas, inertia, both = outputs(page, 0)
    torque = over_cycle(cycle(engine, point=point_of(FIVE), off=(4,)), 720).sum(axis=0)[130]
    assert gas == pytest.approx(torque, abs=0.5)  # orders above 24 are not sent
    assert both == pytest.approx(gas + inertia, abs=0.11)
    assert outputs(page, 1)[0] == pytest.approx(rolled(engine, 130, (4,)), abs=0.2)
    line = page.locator(".plot-cursor").first.get_attribute("x1")
    assert float(line or "nan") == pytest.approx(1000 * 130 / 720)


@pytest.mark.release
def test_what_is_chosen_of_the_torque_goes_into_the_link(built_page: Build, page: Page) -> None:
    path = built_page(FIVE)
    opened(page, path, "a=0&tab=torque")
    box = page.get_by_role("checkbox", name="3", exact=True)
    box.focus()
    page.keyboard.press("Space")
    page.get_by_role("radio", name="one below the other").check()
    expect(page.locator(".cylinders-apart .cycle-curves")).to_have_count(5)
    page.wait_for_function(
        "() => ['torque.off=3', 'torque.cylinders=apart']"
        ".every(each => location.hash.includes(each))"
    )
    opened(page, path, page.evaluate("location.hash.slice(1)"))
    expect(page.get_by_role("checkbox", name="3", exact=True)).to_be_checked()


@pytest.mark.release
def test_an_engine_without_bores_says_what_gas_needs(built_page: Build, page: Page) -> None:
    opened(page, built_page("v8-cross-plane"), "a=0&tab=torque")
    expect(page.locator("p.needs")).to_contain_text("give cylinder.bore in the engine file")
    shown = by_order(page)
    sums = total(balance(load("v8-cross-plane")))
    fourth = abs(spectra.amplitude(spectra.selected(sums.torque, [4.0]))[0])
    assert shown["inertia torque"][4.0] == pytest.approx(fourth, rel=6e-4)
    assert shown["inertia torque"][2.0] == 0
    expect(page.get_by_role("checkbox", name="1", exact=True)).to_have_count(0)


@pytest.mark.release
def test_gas_is_in_the_rolling_moment_of_the_stage_where_it_is_chosen(
    built_page: Build, page: Page
) -> None:
    engine = load(FIVE)
    opened(page, built_page(FIVE), "a=100&tab=forces&of=couple")
    roll = page.locator(".now dl > div", has_text="Rolling moment").locator("output")
    still = float(np.real(spectra.value(total(balance(engine, speed=engine.speed)).torque, 1.0)))
    assert still != 0
    before = number(roll.inner_text())
    page.get_by_role("checkbox", name="Gas in the rolling moment, also on the stage").check()
    expect(page.locator(".now dt", has_text="(with gas)")).to_have_count(1)
    assert number(roll.inner_text()) == pytest.approx(rolled(engine, 100), rel=1e-3)
    page.get_by_role("checkbox", name="Gas in the rolling moment, also on the stage").uncheck()
    expect(page.locator(".now dt", has_text="(with gas)")).to_have_count(0)
    assert number(roll.inner_text()) == before


@pytest.mark.release
def test_torque_is_shown_in_the_units_of_the_page(built_page: Build, page: Page) -> None:
    opened(page, built_page(FIVE, figures=True), "a=0&tab=torque")
    newton = facts(page)["mean gas torque"]
    opened(page, built_page(FIVE, figures=True), "a=0&tab=torque&units=us")
    expect(page.locator(".cycle-curves figcaption").first).to_contain_text("lbf ft")
    assert facts(page)["mean gas torque"] == pytest.approx(newton / 1.3558179, rel=1e-3)


def lines(samples: Any, engine: Engine, rpm: float) -> Any:
    """Sizes of the orders of the cycle up to 8 turns, of whole cycles of a second."""
    spectrum = np.abs(np.fft.rfft(np.asarray(samples, float), axis=-1))
    step = 360 / engine.cycle_angle
    return spectrum[..., [round(n * step * rpm / 60) for n in range(1, int(8 / step) + 1)]]


def played(page: Page, name: str) -> Locator:
    """The button that has just been pressed to hear an engine."""
    page.get_by_role("button", name=f"Hear {name}").click()
    button = page.get_by_role("button", name=f"Stop the sound of {name}")
    expect(button).to_be_visible()
    return button


@pytest.mark.release
@pytest.mark.many(first=1)
@pytest.mark.parametrize("name", ["v8-cross-plane", "v8-flat-plane", "napier-deltic"])
def test_the_sound_has_the_orders_of_the_file_that_the_command_writes(
    name: str, built_page: Build, page: Page
) -> None:
    page.add_init_script(f"({WITHOUT_SOUND})()")
    opened(page, built_page(name), "a=0&tab=sound")
    assert page.evaluate("contexts.length") == 0
    engine = load(name)
    played(page, engine.name)
    heard = page.evaluate(HEARD)
    turning = OFTEN * math.pi / 30
    ride = sound.Ride(turning, turning, seconds=2.0)
    written = sound.sound(engine, ride=ride).samples[:, 22050:66150]
    own, others = lines(heard, engine, OFTEN), lines(written, engine, OFTEN)
    assert np.allclose(own / own.max(), others / others.max(), atol=4e-3)
    assert 0.2 < np.abs(heard).max() <= 0.9


@pytest.mark.release
def test_one_click_leads_from_one_sound_to_the_other_and_hiding_ends_it(
    built_page: Build, page: Page
) -> None:
    page.add_init_script(f"({WITHOUT_SOUND})()")
    opened(page, built_page("v8-flat-plane", "v8-cross-plane"), "a=0&tab=sound")
    flat, cross = load("v8-flat-plane").name, load("v8-cross-plane").name
    played(page, flat)
    played(page, cross)
    expect(page.get_by_role("button", name=f"Hear {flat}")).to_be_visible()
    assert page.evaluate("contexts.length") == 1
    page.get_by_role("button", name=f"Stop the sound of {cross}").press("Enter")
    played(page, flat)
    page.evaluate(
        """() => {
          Object.defineProperty(document, 'visibilityState', { get: () => 'hidden' })
          document.dispatchEvent(new Event('visibilitychange'))
        }"""
    )
    expect(page.get_by_role("button", name=f"Hear {flat}")).to_be_visible()


@pytest.mark.release
def test_the_speed_that_is_heard_follows_the_slider_of_the_page(
    built_page: Build, page: Page
) -> None:
    opened(page, built_page(FIVE), "a=0&tab=sound&speed=1")
    expect(page.get_by_role("radio", name="50 times that on the page: 3000 rpm")).to_be_checked()
    page.get_by_role("radio", name="of the engine file: 6500 rpm").check()
    page.wait_for_function("() => location.hash.includes('sound.speed=engine')")


@pytest.mark.release
def test_the_orders_of_the_exhaust_stand_beside_its_sound(built_page: Build, page: Page) -> None:
    opened(page, built_page("v8-cross-plane"), "a=0&tab=sound")
    heights = page.locator(".bars-group").evaluate_all(
        "all => all.map(each => [Number(each.dataset.order), each.querySelector('i').className,"
        " parseFloat(each.querySelector('i').style.height || 0)])"
    )
    sizes = {order: size for order, _kind, size in heights}
    assert sizes[4] == 100
    assert sizes[0.5] == pytest.approx(100 * 1.0824 / 4, abs=0.01)
    assert sizes[1.5] == pytest.approx(100 * 2.6131 / 4, abs=0.01)
    assert [order for order, kind, _size in heights if kind == "nought-bar"] == [1, 2, 3, 5, 6, 7]


@pytest.mark.release
@pytest.mark.parametrize(
    ("language", "width", "colours"),
    [("ru", 320, "dark"), ("ja", 390, "light"), ("en", 1024, "dark"), ("ru", 1440, "light")],
)
def test_torque_and_sound_can_be_read_by_everyone(
    language: str, width: int, colours: Literal["light", "dark"], built_page: Build, page: Page
) -> None:
    page.set_viewport_size({"width": width, "height": 900})
    page.emulate_media(color_scheme=colours)
    opened(
        page, built_page(FIVE, BOXER), f"a=0&lang={language}&torque.off=2&forces.gas=on&tab=torque"
    )
    found = {}
    for tab in ("torque", "sound"):
        page.locator(f"[data-tab={tab}]").dispatch_event("click")
        page.evaluate("document.querySelectorAll('details').forEach(one => one.open = true)")
        found[tab] = [*barriers(page), *too_wide(page), *overflows(page)]
    assert found == {"torque": [], "sound": []}


@pytest.mark.release
def test_a_browser_without_sound_says_so(built_page: Build, page: Page) -> None:
    page.add_init_script(
        "window.AudioContext = class { constructor() { throw Error('no sound') } }"
    )
    opened(page, built_page("v8-cross-plane"), "a=0&tab=sound")
    page.get_by_role("button", name="Hear").click()
    expect(page.locator(".trouble")).to_contain_text("no sound")
    expect(page.get_by_role("button", name="Stop the sound")).to_have_count(0)


@pytest.mark.release
def test_pressure_and_power_are_in_the_units_that_were_chosen(
    page: Page, tmp_path: Path, told: Told
) -> None:
    with shown_in(SYSTEMS["us"]):
        path = written_of(tmp_path, load(FIVE))
    opened(page, path, "a=0&tab=torque")
    answer = told(FIVE, *opening(FIVE))
    numbers, words = facts(page), page.locator(".torque-facts").first.inner_text()
    assert numbers["indicated mean effective pressure"] == pytest.approx(
        answer["imep"] / 6894.757, rel=6e-4
    )
    power = next(value for name, value in numbers.items() if name.startswith("brake power"))
    assert power == pytest.approx(answer["brake_power"] / 745.7, rel=6e-4)
    assert "psi" in words
    assert "hp" in words
    assert "bar" not in words
