"""The report on paper: a PDF through the machine's Chromium, or a sentence why not."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.commands import Run
from tests.holding import awaited
from tests.tools import path_of

from crankstar.report import PrintingError, browser, pdf, printing

PAGE = (
    '<!DOCTYPE html><html lang="en"><meta charset="utf-8"><title>Proof &amp; print</title>'
    "<style>@page { size: A4 } p { break-after: page }</style><p>one</p><p>two</p>three</html>"
)


@pytest.fixture(scope="module")
def chromium() -> str:
    if os.environ.get("CRANKSTAR_NO_BROWSER") == "1":
        pytest.skip("CRANKSTAR_NO_BROWSER=1")
    return path_of("chromium")


def script(folder: Path, text: str) -> str:
    place = folder / "browser"
    place.write_text(f"#!/bin/sh\n{text}\n", encoding="utf-8")
    place.chmod(0o700)
    return str(place)


def ended(process: str) -> bool:
    """Whether a process is gone, or only to be collected."""
    try:
        return Path(f"/proc/{process}/stat").read_text(encoding="utf-8").split()[2] == "Z"
    except (FileNotFoundError, ProcessLookupError):
        return True


def pages(content: bytes) -> int:
    return len(re.findall(rb"/Type\s*/Page\b(?!s)", content))


@pytest.mark.release
def test_a_page_becomes_a_pdf_with_its_pages_and_title_and_without_a_date(chromium: str) -> None:
    content = pdf(PAGE, by=chromium)
    assert content.startswith(b"%PDF")
    assert pages(content) == 3
    assert b"Proof & print" in content
    assert b"/CreationDate (D:00000000000000" in content
    assert pdf(PAGE, by=chromium) == content


@pytest.mark.release
def test_a_page_is_printed_without_a_network(chromium: str) -> None:
    assert "--host-resolver-rules=MAP * ~NOTFOUND" in printing.OPTIONS
    assert pages(pdf('<img src="http://localhost:9/x.png">', by=chromium)) == 1


@pytest.mark.release
def test_a_report_is_printed(run: Run, tmp_path: Path, chromium: str) -> None:
    assert chromium
    ran = run("report", "single", "-o", "single.pdf")
    assert (ran.code, ran.out) == (0, "")
    content = (tmp_path / "single.pdf").read_bytes()
    assert content.startswith(b"%PDF")
    assert pages(content) >= 4
    assert len(re.findall(rb"/MediaBox \[0 0 59\d(?:\.\d+)? 84\d", content)) >= 1  # A4 in points
    assert [place.name for place in tmp_path.iterdir()] == ["single.pdf"]


def test_without_a_browser_the_sentence_says_what_to_do(
    refused: Callable[..., str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(printing, "which", lambda _: None)
    monkeypatch.setattr(printing, "ELSEWHERE", ())
    told = refused("report", "single", "-o", "x.pdf")
    assert "install one, or write the report as .html" in told
    assert not list(tmp_path.iterdir())


def test_a_browser_is_found_by_any_of_its_names(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(
        printing, "which", lambda name: "/there/msedge" if name == "msedge" else None
    )
    assert browser() == "/there/msedge"


@pytest.mark.parametrize(
    ("does", "told"),
    [
        ("exit 3", "exit code 3"),
        ("exit 0", "wrote no PDF"),
        (
            (
                'for a; do case "$a" in --print-to-pdf=*) echo "%PDF-1.4 half" > "${a#*=}";; '
                "esac; done"
            ),
            "wrote no PDF",
        ),
    ],
)
@pytest.mark.skipif(os.name == "nt", reason="a script for sh")
def test_a_browser_that_fails_is_told_of(tmp_path: Path, does: str, told: str) -> None:
    with pytest.raises(PrintingError, match=told) as caught:
        pdf(PAGE, by=script(tmp_path, does))
    assert "write the report as .html" in str(caught.value)
    assert str(tmp_path) not in str(caught.value)


@pytest.mark.skipif(os.name == "nt", reason="a script for sh")
def test_a_browser_that_hangs_is_stopped_with_all_that_it_started(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The patience with it begins here once it has started another process."""
    mark, wait = tmp_path / "child", printing.subprocess.Popen.wait
    hangs = script(tmp_path, f"sleep 3600 & echo $! > '{mark}.new'; mv '{mark}.new' '{mark}'; wait")

    def begun(process: Any, timeout: float | None = None) -> int:
        awaited(mark.exists)
        return wait(process, timeout)

    monkeypatch.setattr(printing.subprocess.Popen, "wait", begun)
    with pytest.raises(PrintingError, match=r"did not finish in 0.1 s and was stopped"):
        pdf(PAGE, by=hangs, patience=0.1)
    assert awaited(lambda: ended(mark.read_text(encoding="utf-8").strip()))


def test_a_browser_that_cannot_be_started_is_told_of(tmp_path: Path) -> None:
    place = tmp_path / "browser"
    place.write_text("no program", encoding="utf-8")
    with pytest.raises(PrintingError, match="cannot be started"):
        pdf(PAGE, by=str(place))


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (["single", "-o", "x.docx"], "the name must end in .html, .pdf"),
        (["single", "-o", "x"], "the name must end in .html, .pdf"),
        (["single", "-o", ""], '-o "": it is empty'),
        (["single", "-o", "/nowhere/x.html"], "cannot be written"),
        (["nothing", "-o", "x.html"], "there is no such engine"),
        (["single", "--beside", "nothing", "-o", "x.html"], "there is no such engine"),
        (["single", "--speed", "fast", "-o", "x.html"], "--speed"),
        (["single", "--orders", "0", "-o", "x.html"], "--orders"),
        (["single", "--set", "cylinder.bore=-1", "-o", "x.html"], "bore"),
    ],
)
def test_what_cannot_be_written_is_refused(
    refused: Callable[..., str], tmp_path: Path, arguments: list[str], told: str
) -> None:
    assert told in refused("report", *arguments)
    assert not list(tmp_path.iterdir())


@pytest.mark.release
def test_a_report_that_is_there_is_replaced_whole_and_the_command_in_it_names_no_directory(
    run: Run, tmp_path: Path
) -> None:
    (tmp_path / "r.html").write_text("before", encoding="utf-8")
    (tmp_path / "mine.toml").write_text(run("new", "vee").out, encoding="utf-8")
    ran = run(
        *("report", str(tmp_path / "mine.toml"), "--full"),
        *("--set", "layout.bore_pitch=100 mm", "-o", "r.html"),
    )
    assert (ran.code, ran.err) == (0, "Replaced r.html\n")
    page = (tmp_path / "r.html").read_text(encoding="utf-8")
    assert page.endswith("</html>\n")
    assert (
        "crankstar report mine.toml --full --set &#x27;layout.bore_pitch=100 mm&#x27; "
        "-o r.html" in page
    )
    assert str(tmp_path) not in page
    assert "bore_pitch = &quot;100 mm&quot;" in page
