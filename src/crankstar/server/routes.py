"""Questions about engines, and searches.

Each route looks what is asked, has it reckoned, and answers.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Annotated, Any, TypeVar

from fastapi import APIRouter, Path, Query, Request, Response
from fastapi.routing import APIRoute
from starlette.exceptions import HTTPException

from crankstar import files
from crankstar.language.quoting import one_line
from crankstar.page.records import Exhibit, Exhibition
from crankstar.page.workshop_records import Preset, SlidersShown, WorkshopShown
from crankstar.server import exporting, forms, messages, search_process, tasks
from crankstar.server.answers import Answers
from crankstar.server.refusal import Refused, refused
from crankstar.server.searches import Searches
from crankstar.server.watching import Watched
from crankstar.server.workers import Task

JSON = "application/json"
ASKED = "the request"
Statuses = dict[int | str, dict[str, Any]]
Handler = TypeVar("Handler", bound=Callable[..., Any])
REFUSED: Statuses = {
    status: {"model": messages.Refusal, "description": text}
    for status, text in {
        400: "The request broke off, or cannot be read.",
        403: "The request comes from a page of another site.",
        408: "The request did not arrive in time.",
        413: "The request is larger than 1 MB.",
        415: "The request is not JSON, or is compressed.",
        421: "The host of the request is not a name of this server.",
        422: "The request is wrong: every mistake, its key path and what would be right.",
        500: "A bug in crankstar.",
        503: "The computation takes too long, or too many requests are waiting.",
    }.items()
}
ANSWERED: Statuses = {status: REFUSED[status] for status in (403, 421, 500, 503)}
"""What may happen to any question."""
MISSING: Statuses = {
    404: {"model": messages.Refusal, "description": "There is nothing of that name."}
}
CROWDED: Statuses = {
    429: {"model": messages.Refusal, "description": "The most searches allowed are running."}
}


class NotStrictError(HTTPException):
    """A refusal as the one exception that the framework passes on where it reads a question."""

    def __init__(self, refusal: Refused) -> None:
        super().__init__(refusal.status)
        self.refusal = refusal


class StrictRequest(Request):
    """A request whose JSON is read as strictly as engine files.

    No key twice, nothing nested without end, sentences for mistakes.
    """

    async def json(self) -> Any:
        """The question as a tree. Raises NotStrictError."""
        if not hasattr(self, "_json"):
            try:
                self._json = strict(await self.body())
            except Refused as refusal:
                raise NotStrictError(refusal) from None
        return self._json


class StrictRoute(APIRoute):
    """A route whose questions are read strictly."""

    def get_route_handler(self) -> Any:
        """The handler, given strict requests."""
        plain = super().get_route_handler()

        async def handler(request: Request) -> Response:
            return await plain(StrictRequest(request.scope, request.receive))

        return handler


def strict(body: bytes) -> Any:
    """The tree of a question in JSON. Raises Refused."""
    try:
        text = body.decode("utf-8")
    except UnicodeDecodeError:
        raise refused(422, "question.not-text") from None
    if not text.lstrip().startswith("{"):
        raise refused(422, "question.not-object", example='{"engine": "v8-cross-plane"}')
    with tasks.mistakes_refused():
        return files.tree_of(text, name=ASKED)


def bounded(engine: Any) -> Any:
    """An engine that is asked about, once it is found to be no larger than one can be.

    Raises Refused.
    """
    if not isinstance(engine, dict):
        return engine
    with tasks.mistakes_refused():
        return files.changed(engine, {}, name=tasks.ENGINE)


router = APIRouter(prefix="/api", route_class=StrictRoute, responses=ANSWERED)
ASK: Statuses = {status: REFUSED[status] for status in (400, 408, 413, 415, 422)}


def answering(
    method: str,
    path: str,
    model: Any,
    summary: str,
    *,
    tag: str = "engines",
    responses: Statuses | None = None,
) -> Callable[[Handler], Handler]:
    """A route whose answer is a `model`; a question that is posted may be wrong in more ways."""
    return router.api_route(
        path,
        methods=[method],
        response_model=model,
        summary=summary,
        tags=[tag],
        responses=(ASK if method == "POST" else {}) | (responses or {}),
    )


async def _answer(request: Request, task: Task, *arguments: Any) -> Response:
    answers: Answers = request.app.state.answers
    return Response(await answers.to(task, *arguments), media_type=JSON)


def _searches(request: Request) -> Searches:
    return request.app.state.searches


@answering("GET", "/health", messages.Health, "Whether the server is there", tag="server")
async def health(request: Request) -> messages.Health:
    """Its version."""
    return messages.Health(version=request.app.version)


@answering("GET", "/opening", Exhibition, "What the page opens with", tag="server")
async def opening(request: Request) -> Response:
    """The engine that the server was started with, as an exhibition.

    Its fitted engine is asked for when it is wanted.
    """
    engine, shown, command = request.app.state.opening
    watched: Watched | None = request.app.state.watched
    tree = engine if watched is None else watched.tree
    return await _answer(request, tasks.opening, tree, shown, command)


@answering(
    "GET", "/watched", messages.WatchedShown, "The file that the server watches", tag="server"
)
async def watched_file(
    request: Request,
    after: Annotated[int, Query(description="the version that is known already", ge=0)] = 0,
) -> messages.WatchedShown:
    """Its version, 0 where none is watched; what is new after the version that is known."""
    watched: Watched | None = request.app.state.watched
    if watched is None:
        return messages.WatchedShown(version=0)
    if watched.version == after:
        return messages.WatchedShown(version=after)
    return messages.WatchedShown(
        version=watched.version,
        file=one_line(watched.path.name, longest=100),
        tree=watched.tree,
        problems=watched.problems,  # pyright: ignore[reportArgumentType]
    )


@answering("GET", "/schema", dict[str, Any], "The JSON Schema of engine files")
async def schema(request: Request) -> Response:
    """Both forms, with the unit and meaning of every key."""
    return await _answer(request, tasks.schema)


@answering("GET", "/catalog", list[messages.CatalogEntry], "The engines of the catalog")
async def catalog(request: Request) -> Response:
    """Their names, in alphabetical order, and what they are."""
    return await _answer(request, tasks.summaries)


@answering(
    "GET",
    "/catalog/{name}",
    dict[str, Any],
    "The file of an engine of the catalog",
    responses=MISSING,
)
async def catalog_engine(
    request: Request,
    name: Annotated[
        str, Path(description="its name", examples=["v8-cross-plane"], max_length=1000)
    ],
) -> Response:
    """As a tree of keys, exactly as in TOML."""
    return await _answer(request, tasks.catalog_answer, name)


@answering("POST", "/exhibit", Exhibit, "All that the page shows of an engine")
async def exhibit(request: Request, question: messages.ShownQuestion) -> Response:
    """An engine's scene, forces and couples by order, free response, tables, verdict and keys.

    Keys name the figures and derivations that can be asked for.
    """
    return await _answer(request, tasks.exhibit, bounded(question.engine), question.units)


@answering("POST", "/chart", dict[str, Any], "A figure of an engine")
async def chart(request: Request, question: messages.ChartQuestion) -> Response:
    """Vega-Lite; where the figure turns it has one parameter, `theta`, in degrees."""
    engine, beside = bounded(question.engine), bounded(question.beside)
    return await _answer(request, tasks.chart, engine, question.key, question.units, beside)


@answering("POST", "/derivation", messages.DerivationShown, "A derivation for an engine")
async def derivation(request: Request, question: messages.DerivationQuestion) -> Response:
    """How force or couple of an order come about, step by step, as HTML with MathML."""
    return await _answer(request, tasks.derivation, bounded(question.engine), question.key)


@answering("POST", "/fitted", messages.FittedShown, "An engine with weights and shafts")
async def fitted(request: Request, question: messages.FittedQuestion) -> Response:
    """The same engine with counterweights and balance shafts, as an exhibit.

    Null where there is nothing to do.
    """
    options = question.model_dump(
        include={"factor", "weights", "shafts", "bare"}, exclude_none=True
    )
    engine = bounded(question.engine)
    return await _answer(request, tasks.fitted, engine, options, question.units)


@answering("POST", "/estimate", messages.TreeShown, "An engine with estimated masses")
async def estimate(request: Request, question: messages.EngineQuestion) -> Response:
    """Its file as a tree, with masses and lengths that it leaves out, each marked as estimated."""
    return await _answer(request, tasks.estimate, bounded(question.engine))


@answering(
    "POST", "/arrangements", WorkshopShown, "What can be changed in an engine", tag="workshop"
)
async def workshop(request: Request, question: messages.WorkshopQuestion) -> Response:
    """The engine, with another number of cylinders if one is given: throws, banks, firing order.

    With it the cranks and firing orders that it could have instead, and its direct controls.
    """
    return await _answer(request, tasks.workshop, bounded(question.engine), question.cylinders)


@answering("POST", "/sliders", SlidersShown, "The curves behind sliders", tag="workshop")
async def sliders(request: Request, question: messages.ShownQuestion) -> Response:
    """What an engine leaves over the range of each control, as `crankstar sweep` computes it."""
    return await _answer(request, tasks.sliders, bounded(question.engine), question.units)


@answering("GET", "/presets", list[Preset], "Usual layouts to begin with", tag="workshop")
async def presets(request: Request) -> Response:
    """Each with its engine file, and what a small picture of it shows."""
    return await _answer(request, tasks.presets)


@answering("POST", "/toml", messages.TomlShown, "An engine file in TOML", tag="files")
async def toml(request: Request, question: messages.EngineQuestion) -> Response:
    """The tree as it is asked with, short or explicit; it is checked first."""
    return await _answer(request, tasks.toml, bounded(question.engine))


@answering("POST", "/read", messages.TreeShown, "The text of an engine file", tag="files")
async def read(request: Request, question: messages.TextQuestion) -> Response:
    """TOML or JSON to a tree of keys, once it is found to be an engine."""
    return await _answer(request, tasks.read, question.text)


@answering("POST", "/explicit", messages.TreeShown, "An engine, part by part", tag="files")
async def explicit(request: Request, question: messages.EngineQuestion) -> Response:
    """The same engine in the explicit form: every shaft, throw, weight and cylinder by itself."""
    return await _answer(request, tasks.explicit, bounded(question.engine))


@router.post(
    "/export",
    response_class=Response,
    summary="An engine as a file",
    tags=["files"],
    responses={200: {"content": {kind: {} for kind in {*forms.KINDS.values()}}}, **ASK},
)
async def export(request: Request, question: messages.ExportQuestion) -> Response:
    """Moving parts, a multibody model, tables, the report, or the page as one file, to be kept.

    It is sent as an attachment: no browser shows it under the address of this server.
    """
    asked = (bounded(question.engine), question.form, question.theta_deg, question.units)
    content = await request.app.state.answers.to(exporting.exported, *asked)
    heads = {"content-disposition": "attachment"}
    return Response(content, media_type=forms.KINDS[question.form], headers=heads)


@answering(
    "POST",
    "/search",
    messages.SearchShown,
    "Search for a better crank",
    tag="search",
    responses=CROWDED,
)
async def start_search(request: Request, question: messages.SearchQuestion) -> Response:
    """Starts a search, which goes on by itself; ask for it by its id."""
    asked = question.model_dump() | {"engine": bounded(question.engine)}
    await request.app.state.answers.workers.do(search_process.checked, asked)
    return Response(_searches(request).begun(asked), media_type=JSON)


Identity = Annotated[str, Path(description="the id of the search", max_length=100)]


@answering(
    "GET",
    "/search/{identity}",
    messages.SearchShown,
    "How far a search is",
    tag="search",
    responses=MISSING,
)
async def search(request: Request, identity: Identity) -> Response:
    """Its progress, or what it found, which is kept for some minutes."""
    return Response(_searches(request).shown(identity), media_type=JSON)


@answering(
    "DELETE",
    "/search/{identity}",
    messages.SearchShown,
    "Stop a search",
    tag="search",
    responses=MISSING,
)
async def stop_search(request: Request, identity: Identity) -> Response:
    """Stops a search that is under way.

    What it has found so far is shown, and said to be incomplete.
    """
    return Response(_searches(request).stopped(identity), media_type=JSON)
