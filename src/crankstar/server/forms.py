"""The forms in which an engine is given as a file, and their media types."""

from __future__ import annotations

from typing import Literal

Form = Literal["glb", "stl", "py", "csv", "xlsx", "report", "page"]
HTML, SHEET = "text/html", "application/vnd.openxmlformats-officedocument.spreadsheetml.sheet"
KINDS: dict[Form, str] = {
    "glb": "model/gltf-binary",
    "stl": "model/stl",
    "py": "text/x-python",
    "csv": "text/csv",
    "xlsx": SHEET,
    "report": HTML,
    "page": HTML,
}
