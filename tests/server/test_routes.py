"""Every route of the server answers as described, with the physics of the package."""

from __future__ import annotations

import json
import tomllib
from typing import Any

import pytest
from tests.web.serving import Server

import crankstar
from crankstar import files
from crankstar.files import catalog
from crankstar.language.faults import where
from crankstar.page import exhibits, figures
from crankstar.page.records import Exhibit, Exhibition
from crankstar.page.workshop import workshop
from crankstar.remedy import fitting

V8 = catalog.tree_of("v8-cross-plane")[1]
HOSTILE = "</script><img src=x onerror=alert(1)>"


def test_it_says_that_it_is_well(server: Server) -> None:
    assert server.ask("api/health").json == {"state": "well", "version": crankstar.__version__}


def test_the_page_opens_with_the_engine_that_was_named(server: Server) -> None:
    found = Exhibition.model_validate_json(server.ask("api/opening").body)
    assert found.sources == ("v8-cross-plane",)
    assert found.engines[0].file == V8


def test_the_schema_and_the_catalog_are_those_of_the_package(server: Server) -> None:
    assert server.ask("api/schema").json == json.loads(json.dumps(files.schema()))
    entries = server.ask("api/catalog").json
    assert [entry["name"] for entry in entries] == list(crankstar.names())
    assert entries[0].keys() == {"name", "title", "layout", "cylinders", "cycle"}
    assert server.ask("api/catalog/v8-cross-plane").json == V8


@pytest.mark.release
@pytest.mark.parametrize("engine", ["v8-cross-plane", V8], ids=["by name", "as a tree"])
def test_an_exhibit_is_what_the_package_makes_of_the_same_engine(
    engine: Any, server: Server
) -> None:
    answer = server.ask("api/exhibit", {"engine": engine})
    assert answer.status == 200
    ours = exhibits.exhibit(crankstar.load("v8-cross-plane"), file=V8, relatives=False)
    assert Exhibit.model_validate_json(answer.body) == Exhibit.model_validate_json(
        ours.model_dump_json()
    )


def test_an_edit_changes_the_exhibit_and_asking_again_gives_the_same(server: Server) -> None:
    turned = json.loads(json.dumps(V8))
    turned["layout"]["banks"][0]["bearing"] = "30 deg"
    turned["layout"]["banks"][1]["bearing"] = "-30 deg"
    first, again, other = (
        server.ask("api/exhibit", {"engine": tree}) for tree in (turned, turned, V8)
    )
    assert first.body == again.body
    assert first.json["total"] != other.json["total"]
    bearings = {round(cylinder["bearing"], 6) for cylinder in first.json["scene"]["cylinders"]}
    assert bearings == {0.523599, -0.523599}


@pytest.mark.release
def test_figures_and_derivations_are_asked_for_by_the_keys_of_the_exhibit(server: Server) -> None:
    engine = crankstar.load("v8-cross-plane")
    exhibit = server.ask("api/exhibit", {"engine": V8}).json
    for figure in (
        *{chart["figure"]: chart["key"] for chart in exhibit["charts"]}.values(),
        "spectrum:fitted",
    ):
        answer = server.ask("api/chart", {"engine": V8, "key": figure})
        assert answer.status == 200, answer.body
        assert answer.json == json.loads(json.dumps(figures.chart(engine, figure)))
    for derivation in exhibit["derivations"][:2]:
        answer = server.ask("api/derivation", {"engine": V8, "key": derivation["key"]})
        assert answer.json == {"html": figures.derivation(engine, derivation["key"])}


@pytest.mark.release
def test_an_engine_is_fitted_as_its_verdict_advises_or_as_one_likes(server: Server) -> None:
    plain = server.ask("api/fitted", {"engine": "v8-cross-plane"}).json["exhibit"]
    assert plain["remedies"]
    engine = files.engine_of(plain["file"])
    assert any(shaft.weights for shaft in engine.shafts)
    webs = server.ask(
        "api/fitted", {"engine": "i4", "factor": 0.5, "weights": "pins", "shafts": "needed"}
    ).json["exhibit"]
    assert [shaft.speed_ratio for shaft in files.engine_of(webs["file"]).shafts] == [1, 2, -2]
    assert server.ask("api/fitted", {"engine": "v12-60", "shafts": "none"}).json == {
        "exhibit": None
    }


@pytest.mark.release
def test_an_engine_is_fitted_with_what_is_asked_for(server: Server) -> None:
    asked = {"factor": 1.0, "weights": "ends", "shafts": "all"}
    shown = server.ask("api/fitted", {"engine": "triple-120", **asked}).json["exhibit"]
    weighted = fitting.by_factor(catalog.load("triple-120"), factor=1.0, weights="ends")
    after = fitting.with_shafts(weighted, ratios="all", places=fitting.ShaftPlaces())
    given = catalog.tree_of("triple-120")[1]
    assert shown["file"] == files.rewritten_by_parts(given, after)
    assert shown["file"]["layout"] == given["layout"]


def test_a_fitted_engine_that_cannot_be_had_is_refused_in_words(server: Server) -> None:
    answer = server.ask("api/fitted", {"engine": "v12-60", "shafts": "needed"})
    assert answer.status == 422
    assert "needs no balance shafts" in answer.json["problems"][0]["message"]


def test_a_file_is_written_in_the_form_it_had_and_read_again(server: Server) -> None:
    text = server.ask("api/toml", {"engine": V8}).json["toml"]
    assert tomllib.loads(text) == V8
    assert server.ask("api/read", {"text": text}).json == {"tree": V8}
    assert server.ask("api/read", {"text": json.dumps(V8)}).json == {"tree": V8}


def test_what_is_null_in_a_tree_is_left_out_of_its_file(server: Server) -> None:
    text = server.ask("api/toml", {"engine": V8 | {"speed": None}}).json["toml"]
    assert tomllib.loads(text) == V8


def test_every_mistake_of_an_engine_is_told_at_once_in_the_sentences_of_the_files(
    server: Server,
) -> None:
    wrong = {
        **V8,
        "cycle": "three-stroke",
        "cylinder": {**V8["cylinder"], "bore": "87.5 kg"},
        "extra": 1,
    }
    with pytest.raises(files.EngineFileError) as caught:
        files.engine_of(wrong)
    told = [
        {
            "path": where(fault.path),
            "code": fault.code,
            "values": json.loads(json.dumps(fault.values)),
            "message": fault.sentence,
        }
        for fault in caught.value.faults
    ]
    assert len(told) >= 3
    for path in ("api/exhibit", "api/toml", "api/fitted"):
        answer = server.ask(path, {"engine": wrong})
        assert (answer.status, answer.json) == (422, {"problems": told})
    assert server.ask("api/read", {"text": json.dumps(wrong)}).json == {"problems": told}


def test_a_hostile_name_is_text_wherever_it_comes_back(server: Server) -> None:
    tree = V8 | {"name": HOSTILE}
    assert server.ask("api/exhibit", {"engine": tree}).json["name"] == HOSTILE
    for key in ("force:1", "couple:1"):
        html = server.ask("api/derivation", {"engine": tree, "key": key}).json["html"]
        assert "<img" not in html
    answer = server.ask("api/exhibit", {"engine": HOSTILE})
    assert answer.status == 422
    assert answer.heads["content-type"] == "application/json"
    missing = server.ask("api/catalog/%3Cimg%20src=x%3E")
    assert (missing.status, b"<img" in missing.body) == (404, False)


@pytest.mark.parametrize(
    "name",
    [
        "/etc/passwd",
        "../catalog/i4.toml",
        "i4.toml",
        "./i4",
        "-",
        "/dev/stdin",
        "",
        " ",
        "a\0b",
        "\ud800",
        "i4\n",
        "I4",
    ],
)
def test_no_file_is_ever_opened_by_a_name_from_outside(name: str, server: Server) -> None:
    for path in ("api/exhibit", "api/toml"):
        answer = server.ask(path, {"engine": name})
        assert answer.status == 422
        (problem,) = answer.json["problems"]
        assert problem["path"] == "engine"
        assert problem["message"].startswith("there is no such engine in the catalog; ")
        assert (
            "/api" not in problem["message"]
        )  # a link to a page can name an engine, and people read what is said then


def test_a_part_of_a_name_is_met_with_the_names_that_have_it(server: Server) -> None:
    told = (
        "there is no such engine in the catalog; did you mean v8-cross-plane, v8-flat-plane, "
        "yamaha-r1-crossplane?"
    )
    near = ["v8-cross-plane", "v8-flat-plane", "yamaha-r1-crossplane"]
    fault = {"code": "catalog.unknown-near", "values": {"near": near}, "message": told}
    asked = server.ask("api/exhibit", {"engine": "plane"})
    assert asked.json["problems"] == [{"path": "engine", **fault}]
    missing = server.ask("api/catalog/plane")
    assert (missing.status, missing.json["problems"]) == (404, [{"path": "", **fault}])


def test_names_in_addresses_do_not_lead_out_of_the_catalog(server: Server) -> None:
    for name in ("..%2Fcatalog%2Fi4", "%2Fetc%2Fpasswd", "i4.toml", "%00", "%ff", "." * 300):
        answer = server.ask(f"api/catalog/{name}")
        assert answer.status in (404, 422), name
        assert answer.json["problems"]


@pytest.mark.release
def test_the_workshop_offers_what_the_package_offers(server: Server) -> None:
    answer = server.ask("api/arrangements", {"engine": "i4", "cylinders": 5})
    assert answer.json == workshop(catalog.tree_of("i4")[1], cylinders=5).model_dump(mode="json")
    assert (
        server.ask("api/arrangements", {"engine": "v8-cross-plane", "cylinders": 9}).status == 422
    )
    curves = server.ask("api/sliders", {"engine": "v2-90"}).json["sliders"]
    assert curves[0]["key"] == "layout.bank_angle"
    assert {preset["key"] for preset in server.ask("api/presets").json} >= {"single", "v8-cross"}


def test_mistakes_of_an_engine_beside_are_told_as_its_own(server: Server) -> None:
    for beside, path in (("nope", "beside"), ({"name": 7}, "beside.name")):
        answer = server.ask("api/chart", {"engine": "i4", "key": "spectrum", "beside": beside})
        assert answer.status == 422
        assert path in [problem["path"] for problem in answer.json["problems"]]


@pytest.mark.parametrize(
    ("heads", "words"),
    [
        ({}, "No primary couple."),
        ({"Accept-Language": "ja"}, "一次慣性偶力なし。"),
        ({"Accept-Language": "ja-JP,en;q=0.5"}, "一次慣性偶力なし。"),
        ({"Accept-Language": "fr"}, "No primary couple."),
        ({"Accept-Language": "fr, en;q=0.2, ja;q=0.3, ru;q=0"}, "一次慣性偶力なし。"),
        ({"Accept-Language": "ja;q=nonsense, *;q=2, ;q=0.1,,"}, "No primary couple."),
    ],
)
def test_an_engine_is_told_of_in_the_language_that_is_asked_for(
    heads: dict[str, str], words: str, server: Server
) -> None:
    answer = server.ask("api/exhibit", {"engine": "v8-flat-plane"}, heads=heads)
    told = " ".join(fact["sentence"] for fact in answer.json["verdict"])
    assert words in told


def test_a_refusal_is_in_the_language_that_is_asked_for(server: Server) -> None:
    def told(language: str) -> str:
        heads = {"Accept-Language": language}
        answer = server.ask("api/exhibit", {"engine": "nonsense"}, heads=heads)
        return answer.json["problems"][0]["message"]

    assert "no such engine" in told("en")
    assert "каталог" in told("ru")
