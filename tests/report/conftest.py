"""Command lines run in an empty directory, as for files."""

from tests.files.conftest import refused, run

__all__ = ["refused", "run"]
