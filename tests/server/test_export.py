"""An engine as a file: every form over HTTP is what the package writes."""

from __future__ import annotations

import io
import json
import subprocess
import sys
from typing import Any

import numpy as np
import pytest
import trimesh
from openpyxl import load_workbook
from tests.web.serving import Server

from crankstar.exports import solids
from crankstar.files.catalog import load
from crankstar.server.forms import KINDS, Form

ENGINE = "v8-cross-plane"


@pytest.mark.many(first=3)
@pytest.mark.parametrize("form", KINDS)
def test_every_form_is_sent_as_a_file_to_keep(form: Form, server: Server) -> None:
    engine = "bmw-r1200" if form == "stl" else ENGINE  # millimetres need a stroke
    answer = server.ask("api/export", {"engine": engine, "form": form})
    assert answer.status == 200
    assert answer.heads["content-type"].split(";")[0] == KINDS[form]
    assert answer.heads["content-disposition"] == "attachment"
    assert "frame-ancestors 'none'" in answer.heads["content-security-policy"]
    assert len(answer.body) > 1000


@pytest.mark.release
def test_solids_stand_at_the_crank_angle_asked_for(server: Server) -> None:
    question = {"engine": ENGINE, "form": "glb", "theta_deg": 30.0}
    sent = server.ask("api/export", question).body
    scene: Any = trimesh.load(io.BytesIO(sent), file_type="glb")
    ours = solids.solids(load(ENGINE), theta=np.radians(30))
    assert {*scene.graph.nodes_geometry} == {solid.name for solid in ours}
    for solid in ours:
        frame, _ = scene.graph[solid.name]
        assert frame == pytest.approx(solid.frame, abs=1e-6)


def test_the_csv_is_that_of_the_command_line(server: Server) -> None:
    sent = server.ask("api/export", {"engine": ENGINE, "form": "csv"}).body.decode()
    told = subprocess.run(
        [sys.executable, "-m", "crankstar", "analyze", ENGINE, "--csv"],
        capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    assert sent == told


def test_the_spreadsheet_is_read_back_as_the_engine(server: Server) -> None:
    sent = server.ask("api/export", {"engine": ENGINE, "form": "xlsx"}).body
    book = load_workbook(io.BytesIO(sent))
    assert {"engine", "amplitudes"} <= {*book.sheetnames}
    rows = [row for sheet in book for row in sheet.iter_rows(values_only=True)]
    assert any(str(cell).startswith("This rests on") for row in rows for cell in row)


def test_a_wrong_form_or_engine_is_refused_in_sentences(server: Server) -> None:
    wrong = server.ask("api/export", {"engine": ENGINE, "form": "exe"})
    assert wrong.status == 422
    assert json.loads(wrong.body)["problems"][0]["path"] == "form"
    assert server.ask("api/export", {"engine": "no-such", "form": "glb"}).status == 422
    endless = {"engine": ENGINE, "form": "glb", "theta_deg": 1e9}
    assert server.ask("api/export", endless).status == 422
