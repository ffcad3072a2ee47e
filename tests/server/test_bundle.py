"""The bundle as sent: cached for ever under its own address, compressed if accepted."""

from __future__ import annotations

import gzip
import re

import pytest
from tests.front_end import BUNDLE
from tests.web.serving import Server


@pytest.mark.release
def test_the_script_of_the_page_is_kept_under_the_address_that_the_page_names(
    server: Server,
) -> None:
    found = re.search(
        rb'<script type="module" src="/(app\.js\?v=\w+)"></script>', server.ask("").body
    )
    assert found is not None
    named = server.ask(found[1].decode())
    assert (named.status, named.body) == (200, BUNDLE.read_bytes())
    assert named.heads["content-type"].startswith("text/javascript")
    assert named.heads["cache-control"] == "public, max-age=31536000, immutable"
    for other in ("app.js", "app.js?v=0"):
        assert server.ask(other).heads["cache-control"] == "no-cache"


def test_who_has_the_script_is_not_sent_it_again(server: Server) -> None:
    tag = server.ask("app.js").heads["etag"]
    again = server.ask("app.js", heads={"If-None-Match": tag})
    assert (again.status, again.body, again.heads["etag"]) == (304, b"", tag)
    assert server.ask("app.js", heads={"If-None-Match": '"other"'}).status == 200


def test_the_script_is_compressed_for_who_understands_that(server: Server) -> None:
    small = server.ask("app.js", heads={"Accept-Encoding": "br, gzip"})
    assert small.heads["content-encoding"] == "gzip"
    assert gzip.decompress(small.body) == BUNDLE.read_bytes()
    plain = server.ask("app.js", heads={"Accept-Encoding": "identity"})
    assert "content-encoding" not in plain.heads
    assert plain.body == BUNDLE.read_bytes()
    assert small.heads["vary"] == plain.heads["vary"] == "accept-encoding"
