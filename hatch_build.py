"""The build hook: builds the page's bundle and the message catalogs for installs and packages."""

from __future__ import annotations

import runpy
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class BundleHook(BuildHookInterface):
    """Asks for node only where there is something to build: an sdist has the bundle in it."""

    PLUGIN_NAME = "custom"

    @property
    def maker(self) -> dict[str, Any]:
        """What web/bundle.py defines."""
        return runpy.run_path(str(Path(self.root) / "web" / "bundle.py"))

    def dependencies(self) -> list[str]:
        """The node to build with, from the Python package index.

        Nothing where the bundle fits its sources.
        """
        return [] if self.maker["fresh"]() else [self.maker["NODE"]]

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Build the bundle and the message catalogs, for wheels, sdists and editable installs."""
        del version, build_data
        self.maker["make"]()
        runpy.run_path(str(Path(self.root) / "tools" / "messages.py"))["compile_all"]()
