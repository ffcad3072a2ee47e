"""Statements of the founding documents beside the true values, with their places."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

CLAIMS: dict[str, Any] = json.loads(
    Path(__file__).with_name("claims.json").read_text(encoding="utf-8")
)
