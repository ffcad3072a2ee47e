"""Every refusal has one shape and a sentence, and reveals nothing of the machine."""

from __future__ import annotations

import gzip
import http.client
import json
import re
import socket
from contextlib import closing
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest
from tests.holding import PATIENCE
from tests.web.serving import Answer, Server

import crankstar
from crankstar.language.faults import Fault
from crankstar.server import guard
from crankstar.server.refusal import Refused

PLACES = {
    str(Path.cwd()),
    str(Path.home()),
    str(Path(crankstar.__file__).parent),
    "site-packages",
    "Traceback",
    ".py",
}
"""What no answer may hold."""
WHOLE = b"GET /api/health HTTP/1.1\r\nHost: localhost\r\n\r\n"


def words(answer: Answer, status: int) -> list[str]:
    """The sentences of a refusal, once its shape is found to be right."""
    assert answer.status == status, answer.body
    assert answer.heads["content-type"] == "application/json"
    assert answer.heads["x-content-type-options"] == "nosniff"
    assert answer.json.keys() == {"problems"}
    shape = {"path", "code", "values", "message"}
    assert all(problem.keys() == shape for problem in answer.json["problems"])
    assert not [place for place in PLACES if place in answer.body.decode()]
    told = [f"{problem['path']}: {problem['message']}" for problem in answer.json["problems"]]
    assert told
    return told


@pytest.mark.parametrize(
    ("body", "message"),
    [
        (b"", "is missing"),
        (b"[]", "is not a JSON object"),
        (b"null", "is not a JSON object"),
        (b'"v8"', "is not a JSON object"),
        (b"{", "is not JSON"),
        (b'{"engine": "i4"', "is not JSON"),
        (b"{}", "engine: is missing"),
        (
            b'{"engine": 3}',
            (
                "engine: is 3; give the name of an engine of the catalog, or the keys of an "
                "engine file"
            ),
        ),
        (b'{"engine": null}', "engine: is null; give the name"),
        (b'{"engine": []}', "engine: is a list; give the name"),
        (b'{"engine": "i4", "more": 1}', "more: unknown key"),
        (b'{"engine": "i4", "engine": "i6"}', 'has the key "engine" twice'),
        (b'{"engine": {"name": "a", "name": "b"}}', 'has the key "name" twice'),
        (b'{"engine": {"speed": NaN, "layout": {"type": "inline"}}}', "speed is nan"),
        (b'{"engine": {"speed": 1e999, "layout": {"type": "inline"}}}', "speed is inf"),
        (b'{"engine": {"speed": ' + b"9" * 5000 + b"}}", "a number of thousands of digits"),
        (b'{"engine": ' + b"[" * 100_000 + b"]" * 100_000 + b"}", "nested too deeply"),
        (b'{"engine": {"a": ' + b'{"a": ' * 20 + b"1" + b"}" * 20 + b"}}", "nested too deeply"),
        (b'{"engine": {"a": [' + b"1," * 30_000 + b"1]}}", "no engine needs so many"),
        (b'{"engine": {"\\ud800": "\\udfff"}}', "text of whole characters is needed"),
        (b'\xff{"engine": "i4"}', "not text in UTF-8"),
        (b'{"engine": "' + b"i" * 200 + b'"}', "has 200 letters"),
    ],
)
def test_a_question_that_cannot_be_read_is_told_of_in_words(
    body: bytes, message: str, server: Server
) -> None:
    told = words(server.ask("api/exhibit", body, method="POST"), 422)
    assert any(message in one for one in told), told


@pytest.mark.parametrize(
    ("path", "question", "message"),
    [
        ("api/chart", {"engine": "i4"}, "key: is missing"),
        ("api/chart", {"engine": "i4", "key": "nonsense"}, "there is no such figure"),
        ("api/chart", {"engine": "i4", "key": "hodograph:order=nan"}, "key: "),
        ("api/chart", {"engine": "i4", "key": "hodograph:order=1e400"}, "key: "),
        ("api/chart", {"engine": "i4", "key": "hodograph:order=-1"}, "key: "),
        ("api/chart", {"engine": "i4", "key": "hodograph:order=2:quantity=__class__"}, "key: "),
        ("api/chart", {"engine": "i4", "key": "hodograph:reference=2"}, "key: "),
        ("api/chart", {"engine": "i4", "key": "forces:angles=1"}, "key: "),
        ("api/derivation", {"engine": "i4", "key": "force"}, "there is no such derivation"),
        ("api/derivation", {"engine": "i4", "key": "force:1e9"}, "there is no such derivation"),
        ("api/derivation", {"engine": "i4", "key": "force:" + "9" * 19}, "key: "),
        ("api/fitted", {"engine": "i4", "factor": "a"}, 'factor: is "a"; a number is needed'),
        ("api/fitted", {"engine": "i4", "factor": 3.1}, "factor: is 3.1; it must be at most 3"),
        (
            "api/fitted",
            {"engine": "i4", "weights": "wings"},
            'weights: is "wings"; it can be "pins", "webs" or "ends"',
        ),
        ("api/read", {"text": ""}, "is empty"),
        ("api/read", {"text": "\0"}, "is not a text file"),
        ("api/read", {"text": "\ufffdPNG\r\n"}, "is not a text file"),
        ("api/read", {"text": "PK\x03\x04\0"}, "is a spreadsheet"),
        ("api/arrangements", {"engine": "kr250-racer", "cylinders": 34}, "up to 32"),
        ("api/arrangements", {"engine": "kr250-racer", "cylinders": 25}, "up to 32"),
        ("api/read", {"text": "a = "}, "is not TOML"),
        ("api/read", {"text": "{"}, "is not JSON"),
        ("api/read", {"text": 5}, "text: is 5; text is needed"),
    ],
)
def test_a_question_that_asks_for_what_there_is_not_is_told_so(
    path: str, question: Any, message: str, server: Server
) -> None:
    told = words(server.ask(path, question), 422)
    assert any(message in one for one in told), told


def test_other_addresses_methods_and_kinds_are_refused_in_the_same_shape(server: Server) -> None:
    assert words(server.ask("api/nothing"), 404)
    assert words(server.ask("nothing.php"), 404)
    for other in (
        "api/search/%00..%2f",
        "api/search/x/",
        "api/catalog/i4/",
        "docs/",
    ):  # none is led elsewhere
        assert words(server.ask(other), 404)
    assert words(server.ask("api/search/%00..%2f", method="DELETE"), 404)
    assert words(server.ask("api/exhibit"), 405)
    put = server.ask("api/exhibit", b"x", method="PUT", heads={"Content-Type": "text/plain"})
    assert words(put, 405)
    assert put.heads["allow"] == "POST"
    assert words(server.ask("api/health", method="DELETE"), 405)
    assert words(server.ask("", method="BREW"), 405)
    assert server.ask("api/search/x", method="PUT").heads["allow"] == "DELETE, GET, HEAD"
    assert server.ask("openapi.json", {}).heads["allow"] == "GET, HEAD"
    assert server.ask("api/exhibit").heads["allow"] == "POST"
    plain = server.ask("api/exhibit", b'{"engine": "i4"}', heads={"Content-Type": "text/plain"})
    assert "application/json" in words(plain, 415)[0]
    form = server.ask(
        "api/exhibit", b"engine=i4", heads={"Content-Type": "application/x-www-form-urlencoded"}
    )
    assert words(form, 415)
    packed = server.ask(
        "api/exhibit", gzip.compress(b'{"engine": "i4"}'), heads={"Content-Encoding": "gzip"}
    )
    assert "not be compressed" in words(packed, 415)[0]


@pytest.mark.parametrize("path", ["nothing", "pictures/nothing-light.webp", "api/search/x"])
def test_an_address_mistyped_in_a_browser_leads_on(path: str, server: Server) -> None:
    wanted = {"Accept": "text/html,application/xhtml+xml,*/*;q=0.8", "Accept-Language": "ru"}
    answer = server.ask(path, heads=wanted)
    assert answer.status == 404
    assert answer.heads["content-type"].startswith("text/html")
    text = answer.body.decode()
    assert 'lang="ru"' in text
    assert {'href="/"', 'href="/gallery"'} <= set(re.findall(r'href="[^"]*"', text))
    assert re.search("<p>[^<]*[а-я]{3}", text)
    assert words(server.ask(path), 404)


def test_who_asks_for_the_heads_gets_them_without_the_answer(server: Server) -> None:
    for path, status in (
        ("", 200),
        ("api/health", 200),
        ("api/nothing", 404),
        ("api/exhibit", 405),
    ):
        whole, heads = server.ask(path), server.ask(path, method="HEAD")
        assert (heads.status, heads.body) == (status, b"")
        assert {**heads.heads, "date": ""} == {**whole.heads, "date": ""}


def test_a_question_that_is_too_large_is_not_read(server: Server) -> None:
    body = b'{"engine": "' + b" " * guard.GREATEST_QUESTION + b'"}'
    assert "larger than 1 MB" in words(server.ask("api/exhibit", body), 413)[0]
    assert words(announced(server, length="99999999999"), 413)


def test_what_is_no_question_at_all_is_refused_in_the_same_shape(server: Server) -> None:
    assert words(announced(server, length="9" * 30), 400)
    with socket.create_connection(_place(server)) as line:
        line.sendall(b"\x16\x03\x01 a handshake\r\n\r\n")
        line.settimeout(PATIENCE)
        said = b"".join(iter(lambda: line.recv(65536), b""))
    assert said.startswith(b"HTTP/1.1 400 ")
    assert json.loads(said.split(b"\r\n\r\n")[1])["problems"]


def test_a_question_without_end_is_not_kept(server: Server) -> None:
    line = _line(server)
    line.putrequest("POST", "/api/exhibit")
    line.putheader("Content-Type", "application/json")
    line.putheader("Transfer-Encoding", "chunked")
    line.endheaders()
    try:
        for _ in range(400):
            line.send(b"10000\r\n" + b" " * 0x10000 + b"\r\n")
        assert line.getresponse().status == 413
    except (BrokenPipeError, ConnectionResetError):
        pass  # it hung up on us, as it may, also before its answer is read
    line.close()


@pytest.mark.parametrize(
    "host",
    [
        "evil.example",
        "evil.example:8000",
        "127.0.0.1.evil.example",
        "localhost.evil.example",
        "",
        "a b",
    ],
)
def test_a_server_is_only_asked_under_names_of_this_machine(host: str, server: Server) -> None:
    answer = server.ask("api/health", heads={"Host": host})
    assert "the address that it printed" in words(answer, 421)[0]


@pytest.mark.parametrize("host", ["localhost", "127.0.0.1", "LOCALHOST:1", "[::1]:8000"])
def test_it_answers_to_the_names_of_this_machine(host: str, server: Server) -> None:
    assert server.ask("api/health", heads={"Host": host}).status == 200


def test_a_page_of_another_site_may_not_ask(server: Server) -> None:
    for origin in ("https://evil.example", "null", "http://127.0.0.1:1"):
        assert words(server.ask("api/exhibit", {"engine": "i4"}, heads={"Origin": origin}), 403)
    own = server.ask("api/exhibit", {"engine": "i4"}, heads={"Origin": server.address.rstrip("/")})
    assert own.status == 200
    assert "access-control-allow-origin" not in own.heads


SELF = (
    "script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; "
)


@pytest.mark.parametrize(
    ("path", "policy", "kept"),
    [
        ("", SELF, "no-cache"),
        ("docs", SELF, "no-cache"),
        ("page.css", "", "no-cache"),
        ("api/health", "", "no-store"),
        ("api/nothing", "", "no-store"),
        ("openapi.json", "", "no-store"),
    ],
)
def test_every_answer_tells_the_browser_to_be_careful(
    path: str, policy: str, kept: str, server: Server
) -> None:
    heads = server.ask(path).heads
    assert heads["content-security-policy"] == f"default-src 'none'; {policy}frame-ancestors 'none'"
    assert heads["cache-control"] == kept
    assert (heads["cross-origin-resource-policy"], heads["cross-origin-opener-policy"]) == (
        "same-origin",
        "same-origin",
    )
    assert (heads["x-content-type-options"], heads["referrer-policy"]) == ("nosniff", "no-referrer")
    assert "server" not in heads


def test_of_many_mistakes_the_first_hundred_are_told() -> None:
    faults = [Fault((f"key{place}",), "question.missing") for place in range(150)]
    shown = json.loads(Refused(422, faults).body)["problems"]
    assert [problem["path"] for problem in shown] == [*(f"key{place}" for place in range(100)), ""]
    assert shown[-1]["message"] == "... and 50 more"


def test_an_asker_who_leaves_is_forgotten(server: Server) -> None:
    line = _line(server)
    line.putrequest("POST", "/api/exhibit")
    line.putheader("Content-Type", "application/json")
    line.putheader("Content-Length", "100")
    line.endheaders()
    line.send(b"{")
    line.close()
    assert server.ask("api/health").status == 200


@pytest.mark.release
def test_a_question_that_comes_too_slowly_is_given_up(server: Server) -> None:
    with socket.create_connection(_place(server)) as line:
        line.sendall(
            b"POST /api/exhibit HTTP/1.1\r\nHost: localhost\r\nContent-Type: "
            b"application/json\r\nContent-Length: 100\r\n\r\n{"
        )
        line.settimeout(PATIENCE)
        said = b"".join(iter(lambda: line.recv(65536), b""))
        assert b" 408 " in said.split(b"\r\n")[0]
        assert json.loads(said.split(b"\r\n\r\n")[1])["problems"]


@pytest.mark.release
@pytest.mark.parametrize("said_before", [b"", WHOLE], ids=["at first", "after an answer"])
@pytest.mark.parametrize(
    "head", [b"", b"GET / HTTP/1.1\r\nHost: localh"], ids=["nothing", "half a head"]
)
def test_who_does_not_say_what_is_asked_is_hung_up_on(
    said_before: bytes, head: bytes, server: Server
) -> None:
    with socket.create_connection(_place(server)) as line:
        line.settimeout(PATIENCE)
        line.sendall(said_before)
        answered = b""
        while said_before and not answered.endswith(b"}"):
            answered += line.recv(65536)
        line.sendall(head)
        said = b"".join(iter(lambda: line.recv(65536), b""))
        assert said.startswith(b"HTTP/1.1 408 ") if head else said == b""


def announced(server: Server, *, length: str) -> Answer:
    """What is answered to the head of a question alone.

    Of a body that comes after the refusal the server hangs up unread, which may cost its answer.
    """
    with closing(_line(server)) as line:
        line.putrequest("POST", "/api/exhibit")
        line.putheader("Content-Type", "application/json")
        line.putheader("Content-Length", length)
        line.endheaders()
        answer = line.getresponse()
        heads = {name.lower(): value for name, value in answer.getheaders()}
        return Answer(answer.status, heads, answer.read())


def _place(server: Server) -> tuple[str, int]:
    place = urlsplit(server.address)
    return place.hostname or "", place.port or 0


def _line(server: Server) -> http.client.HTTPConnection:
    return http.client.HTTPConnection(*_place(server), timeout=PATIENCE)
