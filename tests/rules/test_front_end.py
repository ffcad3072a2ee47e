"""The contract of web/ and the package: types, a current bundle, licences, the lock file."""

from __future__ import annotations

import gzip
import json
import re
import runpy
import shutil
import subprocess
import sys
import tomllib
from base64 import b64decode
from pathlib import Path

import pytest
from tests.front_end import BUNDLE, FIGURES, ROOT, WEB, node
from tests.pythons import installable

MAKER = runpy.run_path(str(WEB / "bundle.py"))
SCRIPTS = (BUNDLE, FIGURES)
MEGABYTE = 1_000_000


def test_the_types_of_the_front_end_are_those_of_the_records() -> None:
    schema = subprocess.run(
        [sys.executable, WEB / "build" / "schema.py"], capture_output=True, text=True, check=True
    ).stdout
    made = node("build/types.mjs", text=schema)
    assert "export interface Exhibition" in made
    assert (WEB / "src" / "exhibit.ts").read_text(encoding="utf-8") == made, "run: make types"


@pytest.mark.parametrize("script", SCRIPTS, ids=lambda script: script.name)
def test_the_packed_script_of_a_page_is_that_of_the_bundle(script: Path) -> None:
    packed = script.with_name(f"{script.name}.gz").read_bytes()
    assert gzip.decompress(packed) == script.read_bytes()


def test_the_page_and_the_package_carry_the_licences_of_what_they_contain() -> None:
    beside = (BUNDLE.parent / "third-party-licences.txt").read_text(encoding="utf-8")
    inside = BUNDLE.read_text(encoding="utf-8")
    for package, owner in (
        ("three", "three.js authors"),
        ("preact", "Jason Miller"),
        ("vega-view", "University of Washington Interactive Data Lab"),
        ("vega-lite", "University of Washington Interactive Data Lab"),
        ("d3-array", "Mike Bostock"),
        ("i18next", "i18next"),
    ):
        assert re.search(rf"^{package} [\d.]+ \(\S+\)$", beside, re.MULTILINE), package
        assert owner in beside
    assert beside.replace("`", "'").strip() in inside


def test_the_bundle_is_made_from_the_sources_that_are_there() -> None:
    assert MAKER["fresh"](), "run: make bundle"


@pytest.mark.many(first=3)
@pytest.mark.parametrize(
    "changed",
    [
        "src/index.tsx",
        "src/host/host.ts",
        "package-lock.json",
        "vite.config.ts",
        "build/catalogs.mjs",
    ],
)
def test_a_change_of_any_source_makes_the_bundle_stale(changed: str, tmp_path: Path) -> None:
    web = tmp_path / "web"
    shutil.copytree(WEB, web, ignore=shutil.ignore_patterns("node_modules"))
    copy = runpy.run_path(str(web / "bundle.py"))
    assert copy["digest"]() == MAKER["digest"](), "it tells contents, not places and times"
    (web / changed).write_bytes((web / changed).read_bytes() + b"\n")
    assert copy["digest"]() != MAKER["digest"]()


def test_the_bundle_is_at_most_two_megabytes_and_loads_nothing() -> None:
    assert sum(script.stat().st_size for script in SCRIPTS) <= 2 * MEGABYTE
    for text in (script.read_text(encoding="utf-8") for script in SCRIPTS):
        assert not re.search(r"\bimport\s*[\"'(]\s*[\"']?https?:", text)
        assert not re.search(r"\bfrom\s*[\"']", text[-2000:]), "each script stands alone"


def test_what_draws_figures_is_in_its_own_script_alone() -> None:
    page, figures = (script.read_text(encoding="utf-8") for script in SCRIPTS)
    assert "Duplicate signal name" in figures, "as Vega says it"
    assert "Duplicate signal name" not in page
    assert not re.search(r"^\s*(import|export)\b", figures, re.MULTILINE), "a plain script"


def test_versions_of_the_front_end_are_exact_and_the_lock_names_no_place() -> None:
    package = json.loads((WEB / "package.json").read_text(encoding="utf-8"))
    lock = json.loads((WEB / "package-lock.json").read_text(encoding="utf-8"))
    wanted = {**package["dependencies"], **package["devDependencies"]}
    assert all(re.fullmatch(r"\d+\.\d+\.\d+", version) for version in wanted.values())
    locked = {name: entry for name, entry in lock["packages"].items() if name}
    assert {name: locked[f"node_modules/{name}"]["version"] for name in wanted} == wanted
    assert all("resolved" not in entry and "version" in entry for entry in locked.values())


def test_node_to_build_with_is_the_same_in_the_build_hook_and_for_the_checks() -> None:
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"][
        "optional-dependencies"
    ]
    assert MAKER["NODE"] in extras["lint"]


def run(*command: str | Path, cwd: Path, **environment: str) -> str:
    """The output of a program in an environment that knows nothing of the checkout."""
    done = subprocess.run(
        command,
        cwd=cwd,
        capture_output=True,
        text=True,
        check=False,
        env={"PATH": "/usr/bin:/bin", **environment},
    )
    assert not done.returncode, done.stdout[-2000:] + done.stderr[-2000:]
    return done.stdout


def bare(python: str, folder: Path) -> list[str | Path]:
    """The pip of a new environment in a folder."""
    run(python, "-m", "venv", folder, cwd=folder.parent)
    return [folder / "bin/python", "-m", "pip", "--quiet", "--disable-pip-version-check"]


@pytest.mark.release
@pytest.mark.parametrize("version", ["oldest", "newest"])
def test_sdist_and_wheel_have_the_page_in_them_and_install_without_node(
    version: str, tmp_path: Path
) -> None:
    subprocess.run(
        [sys.executable, "-m", "hatchling", "build", "-t", "sdist", "-d", str(tmp_path)],
        cwd=ROOT,
        check=True,
        capture_output=True,
    )
    (sdist,) = tmp_path.glob("*.tar.gz")
    pip = bare(installable()[version].path, tmp_path / "fresh")
    # npm would ask this address, at which nobody answers
    nobody = {"npm_config_registry": "http://127.0.0.1:9/"}
    run(*pip, "wheel", "--no-deps", "-w", "wheels", sdist, cwd=tmp_path, **nobody)
    (wheel,) = (tmp_path / "wheels").glob("*.whl")
    run(*pip, "install", "-c", ROOT / "constraints.txt", f"{wheel}[charts]", cwd=tmp_path)
    crankstar = tmp_path / "fresh/bin/crankstar"
    run(crankstar, "page", "v8-cross-plane", "-o", "v8.html", cwd=tmp_path)
    page = (tmp_path / "v8.html").read_text(encoding="utf-8")
    assert "<title>V8, cross-plane crank" in page
    packed = re.search(r'id="crankstar-script">([^<]+)<', page)
    assert packed
    script = gzip.decompress(b64decode(packed[1])).decode()
    owners = ("three.js authors", "Jason Miller", "Interactive Data")
    assert all(owner in script for owner in owners)
    assert MEGABYTE / 2 < len(page.encode()) <= 3 * MEGABYTE


@pytest.mark.release
@pytest.mark.parametrize("version", ["oldest", "newest"])
def test_the_source_directory_installs_as_the_readme_says(version: str, tmp_path: Path) -> None:
    asked = '".[all]"'
    assert f"\npip install {asked} " in (ROOT / "README.md").read_text(encoding="utf-8")
    pip = bare(installable()[version].path, tmp_path / "fresh")
    run(*pip, "install", json.loads(asked), cwd=ROOT)
    crankstar = tmp_path / "fresh/bin/crankstar"
    assert "Secondary couple: 1534.3 N m" in run(crankstar, "analyze", "audi-25-tfsi", cwd=tmp_path)
    searched = run(crankstar, "search", "7", "--cycle", "two-stroke", cwd=tmp_path)
    assert "1-4-7-2-3-5-6" in searched
    for command in ("page", "report"):
        run(crankstar, command, "audi-25-tfsi", "-o", f"{command}.html", cwd=tmp_path)
        assert "</html>" in (tmp_path / f"{command}.html").read_text(encoding="utf-8")
