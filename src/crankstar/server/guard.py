"""Who may ask: the host named, the kind and size of a question; headers of every answer.

A page of another site may not ask through the browser of the server's user: neither under its own
name for this machine (the host is checked), nor across sites (the origin is checked, and a question
must be JSON, for which a browser asks permission), nor in a frame. Nobody may keep a question open
for long, or send one that fills the memory. Starlette's TrustedHostMiddleware is not used: it
takes a list of names, not "any address in numbers", and refuses in plain text.
"""

from __future__ import annotations

import asyncio
import ipaddress
import logging
import re
import socket
from collections.abc import Awaitable, Callable, Iterable, MutableMapping
from typing import Any

from crankstar.language.messages import LANGUAGES, language, spoken
from crankstar.language.quoting import one_line
from crankstar.server.refusal import Refused, refused

GREATEST_QUESTION = 1_000_000
"""Bytes."""
GREATEST_HEARD_OUT = 20_000_000
"""Bytes read of a question that is too long: a browser accepts the refusal only after them."""
QUESTION_SECONDS = 10.0
"""How long a question may take to come."""
MOST_PREFERENCES = 400
"""Letters of an Accept-Language that are read."""
QUALITY = re.compile(r"q=([01](?:\.\d{0,3})?)")
LOOPBACK = frozenset({"localhost", "127.0.0.1", "::1"})
PAGE_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; "
    "connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
)
"""What a page of this server may load and do: nothing inline, nothing from elsewhere."""
POLICY = "default-src 'none'; frame-ancestors 'none'"
ALWAYS = {
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-resource-policy": "same-origin",
    "cross-origin-opener-policy": "same-origin",
}
USUAL = {"content-security-policy": POLICY, "cache-control": "no-store"}


def heads_always() -> list[tuple[bytes, bytes]]:
    """The headers of an answer that says nothing else."""
    return [(name.encode(), value.encode()) for name, value in {**ALWAYS, **USUAL}.items()]


Message = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[Message]]
Send = Callable[[Message], Awaitable[None]]
Application = Callable[[Message, Receive, Send], Awaitable[None]]
log = logging.getLogger("crankstar.server")


def hosts_of(host: str) -> frozenset[str] | None:
    """The host names of a server at `host`; None: any IP address, and the machine's own names."""
    return LOOPBACK if host in LOOPBACK else None


def too_late(seconds: float) -> Refused:
    """The refusal of a question that is not whole after so long."""
    return refused(408, "question.late", seconds=seconds)


def preferred_language(header: str) -> str | None:
    """The language that an Accept-Language likes best of those there are; None without one.

    >>> preferred_language("fr-CH, fr;q=0.9, ja;q=0.7, en;q=0.8"), preferred_language("*")
    ('en', None)
    """
    liked: list[tuple[float, str]] = []
    for part in header[:MOST_PREFERENCES].lower().split(","):
        tag, _semicolon, weight = part.partition(";")
        share = QUALITY.fullmatch(weight.strip())
        if not weight or share:
            liked.append((float(share[1]) if share else 1.0, tag.split("-")[0].strip()))
    known = [(share, name) for share, name in liked if share > 0 and name in LANGUAGES]
    return max(known, key=lambda each: each[0], default=(0.0, None))[1]


class Guard:
    """Stands before an ASGI application."""

    def __init__(
        self,
        application: Application,
        *,
        host: str = "127.0.0.1",
        seconds: float = QUESTION_SECONDS,
        one_language: bool = False,
    ) -> None:
        self.application = application
        self.one_language = one_language
        self.hosts = hosts_of(host)
        self.own = {host.lower(), socket.gethostname().lower(), "localhost"}
        self.seconds = seconds

    def description(self) -> dict[str, Any]:
        """The description of the API (OpenAPI)."""
        # a FastAPI stands behind it
        return self.application.openapi()  # pyright: ignore[reportFunctionMemberAccess]

    async def __call__(self, scope: Message, receive: Receive, send: Send) -> None:
        """Refuses a question, or hands it on whole; one whose asker leaves is given up."""
        if scope["type"] != "http":
            if scope["type"] == "lifespan":
                await self.application(scope, receive, send)
            return
        answer = _Answer(send)
        try:
            heads = {
                name.decode("latin-1"): value.decode("latin-1") for name, value in scope["headers"]
            }
            self._check(scope, heads)
            body = await self._body(heads, receive)
            if scope["method"] == "HEAD":
                # asked as if for the whole answer; who sends it leaves its body out
                scope = {**scope, "method": "GET"}
            with spoken(self._language(scope["path"], heads.get("accept-language", ""))):
                await _until_left(self.application(scope, _given(body), answer.send), receive)
        except Refused as refusal:
            await answer.refuse(refusal)
        except asyncio.CancelledError:
            raise
        except Exception:
            log.exception("a question failed")
            await answer.refuse(refused(500, "question.failed"))

    def _language(self, path: str, header: str) -> str:
        """The language of an answer: what the asker likes best, else that of the server.

        A server of one language has its pages in it; what a page asks for is in that of the page.
        """
        if self.one_language and not path.startswith("/api/"):
            return language()
        return preferred_language(header) or language()

    def _check(self, scope: Message, heads: dict[str, str]) -> None:
        host = heads.get("host", "")
        if not self._known(host):
            raise refused(421, "question.host", host=one_line(host, longest=100))
        origin = heads.get("origin")
        if origin is not None and origin.lower() not in (
            f"http://{host.lower()}",
            f"https://{host.lower()}",
        ):
            raise refused(403, "question.origin")
        if scope["method"] == "POST" and not _is_json(heads.get("content-type", "")):
            raise refused(415, "question.not-json")
        if heads.get("content-encoding", "identity").strip().lower() != "identity":
            raise refused(415, "question.compressed")

    def _known(self, host: str) -> bool:
        name = _name_of(host)
        if self.hosts is not None:
            return name in self.hosts
        return name in self.own or _is_address(name)

    async def _body(self, heads: dict[str, str], receive: Receive) -> bytes:
        """The whole question. Raises Refused where it is too long, or too long in coming."""
        length = heads.get("content-length", "0")
        too_large = refused(413, "question.large", size=GREATEST_QUESTION // 1_000_000)
        if not length.isdecimal() or int(length[:20]) > GREATEST_HEARD_OUT:
            raise too_large
        parts: list[bytes] = []
        size = 0
        try:
            async with asyncio.timeout(self.seconds):
                while True:
                    message = await receive()
                    if message["type"] != "http.request":
                        raise refused(400, "question.broken-off")
                    parts.append(message.get("body", b""))
                    size += len(parts[-1])
                    if size > GREATEST_QUESTION:
                        parts.clear()
                    over = not message.get("more_body")
                    if size > (GREATEST_QUESTION if over else GREATEST_HEARD_OUT):
                        raise too_large
                    if over:
                        return b"".join(parts)
        except TimeoutError:
            raise too_late(self.seconds) from None


class _Answer:
    """An answer on its way to the browser, with the headers that every answer has."""

    def __init__(self, send: Send) -> None:
        self._send = send
        self.begun = False

    async def send(self, message: Message) -> None:
        """Sends a part of the answer."""
        if message["type"] == "http.response.start":
            self.begun = True
            heads = list(message.get("headers", ()))
            present = {name.lower() for name, _ in heads}
            added = [(name, value) for name, value in heads_always() if name not in present]
            message = {**message, "headers": [*heads, *added]}
        await self._send(message)

    async def refuse(self, refusal: Refused) -> None:
        """Sends a refusal, unless an answer has been begun."""
        if self.begun:
            return
        body = refusal.body
        heads = [
            (b"content-type", b"application/json"),
            (b"content-length", str(len(body)).encode()),
        ]
        if refusal.status in (408, 413):
            heads.append(
                (b"connection", b"close")
            )  # what is still to come of the question is not wanted
        await self.send({"type": "http.response.start", "status": refusal.status, "headers": heads})
        await self.send({"type": "http.response.body", "body": body})


def _given(body: bytes) -> Receive:
    """What hands a question on that has come already."""
    messages: list[Message] = [{"type": "http.request", "body": body, "more_body": False}]

    async def receive() -> Message:
        if messages:
            return messages.pop()
        await asyncio.Event().wait()  # until the application has ended
        raise AssertionError

    return receive


async def _until_left(answering: Awaitable[None], receive: Receive) -> None:
    """Answers, unless the asker leaves before."""
    work = asyncio.ensure_future(answering)
    leaving = asyncio.ensure_future(_left(receive))
    try:
        await asyncio.wait({work, leaving}, return_when=asyncio.FIRST_COMPLETED)
        if work.done():
            work.result()
    finally:
        await _ended([work, leaving])


async def _left(receive: Receive) -> None:
    while (await receive())["type"] != "http.disconnect":
        pass


async def _ended(tasks: Iterable[asyncio.Future[None]]) -> None:
    for task in tasks:
        task.cancel()
    await asyncio.gather(*tasks, return_exceptions=True)


def _is_json(kind: str) -> bool:
    return kind.split(";")[0].strip().lower() == "application/json"


def _name_of(host: str) -> str:
    """The name in a Host header, without its port."""
    name, colon, port = host.lower().rpartition(":")
    name = name if colon and port.isdecimal() else host.lower()
    return name[1:-1] if name.startswith("[") and name.endswith("]") else name


def _is_address(name: str) -> bool:
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True
