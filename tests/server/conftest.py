"""The server that the tests of its routes share."""

from tests.web.serving import server

__all__ = ["server"]
