"""Questions and answers of the API as records.

What an engine looks like is said by its own schema (`/api/schema`).
"""

from __future__ import annotations

from typing import Annotated, Any, Literal, cast

from pydantic import AfterValidator, BaseModel, ConfigDict, Field, WithJsonSchema

from crankstar.engine import records
from crankstar.language.faults import ValueFaultError
from crankstar.language.quoting import seen
from crankstar.options.words import SearchWords
from crankstar.page.records import Exhibit, Problem
from crankstar.remedy.counterweights import GREATEST_FACTOR, LEAST_FACTOR
from crankstar.server.forms import Form
from crankstar.stars.star import GREATEST_CYLINDERS

LONGEST_NAME = 100
EXAMPLE = {
    "format": 1,
    "name": "V2, 90 deg",
    "firing_order": [1, 2],
    "cylinder": {
        "bore": "90 mm",
        "stroke": "70 mm",
        "rod_length": "130 mm",
        "reciprocating_mass": "500 g",
    },
    "layout": {
        "type": "vee",
        "banks": [
            {"bearing": "-45 deg", "cylinders": [1]},
            {"bearing": "45 deg", "cylinders": [2]},
        ],
        "throws": ["0 deg"],
    },
}


def _engine(value: Any) -> Any:
    if isinstance(value, str) and len(value) > LONGEST_NAME:
        values = {"count": len(value), "greatest": LONGEST_NAME}
        raise ValueFaultError("question.long-name", **values)
    if not isinstance(value, str | dict):
        raise ValueFaultError("question.engine", given=seen(value))
    return value


EngineAsked = Annotated[
    Any,
    AfterValidator(_engine),
    WithJsonSchema(
        {
            "anyOf": [
                {
                    "type": "string",
                    "maxLength": LONGEST_NAME,
                    "description": "the name of an engine of the catalog",
                },
                {
                    "type": "object",
                    "description": "an engine file as a tree, in the short or the explicit form",
                },
            ],
            "examples": ["v8-cross-plane", EXAMPLE],
        }
    ),
]
Many = Annotated[int, Field(ge=2, le=GREATEST_CYLINDERS)]
Key = Annotated[str, Field(max_length=200, examples=["spectrum:quantity=force"])]


class Message(BaseModel):
    """What all of these share: nothing unknown in them."""

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True)


class EngineQuestion(Message):
    """An engine: its name in the catalog, or its file as a tree."""

    engine: EngineAsked


class ShownQuestion(EngineQuestion):
    """An engine, and the units in which it is to be shown."""

    units: Annotated[str, Field(max_length=200, examples=["us", "kN, kN m"])] | None = Field(
        default=None, description="as --units takes them; by default those of the server"
    )


class ChartQuestion(ShownQuestion):
    """A figure of an engine."""

    key: Key = Field(description="the key of a figure, as an exhibit names it")
    beside: EngineAsked | None = Field(
        default=None, description="an engine whose figure has the same scale, where it can"
    )


class DerivationQuestion(EngineQuestion):
    """A derivation of an engine."""

    key: Annotated[str, Field(max_length=200, examples=["force:2"])] = Field(
        description="its key, as an exhibit names it"
    )


class FittedQuestion(ShownQuestion):
    """The weights and balance shafts to fit an engine with; by default the verdict's advice."""

    factor: Annotated[float, Field(ge=LEAST_FACTOR, le=GREATEST_FACTOR)] | None = Field(
        default=None, description="balance factor of the counterweights"
    )
    weights: Literal["pins", "webs", "ends"] | None = Field(
        default=None, description="where the counterweights go"
    )
    bare: bool = Field(
        default=False,
        description="replace the counterweights of the file instead of adding to them",
    )
    shafts: Literal["none", "needed", "all"] | None = Field(
        default=None, description="which balance shafts"
    )


class ExportQuestion(ShownQuestion):
    """An engine as a file of a form."""

    form: Form = Field(
        description="moving parts (glb, stl), a model for EXUDYN (py), tables (csv, xlsx), the "
        "report, the page as one file"
    )
    theta_deg: Annotated[float, Field(ge=-36000, le=36000)] = Field(
        default=0.0, description="crank angle of the moving parts, degrees"
    )


class WorkshopQuestion(EngineQuestion):
    """An engine, as it is or with another number of cylinders."""

    cylinders: Annotated[int, Field(ge=1, le=records.GREATEST_CYLINDERS)] | None = Field(
        default=None, description="how many it is to have; left out, as many as it has"
    )


class TextQuestion(Message):
    """The text of an engine file, TOML or JSON."""

    text: str = Field(description="as long as a question may be")


class SearchQuestion(SearchWords):
    """The options of a search, of an in-line engine or of a number of cylinders."""

    model_config = ConfigDict(extra="forbid", frozen=True, strict=True, str_max_length=500)

    engine: EngineAsked | None = Field(
        default=None, description="an in-line engine whose cylinders they are"
    )
    cylinders: Many | None = Field(
        default=None, description="the number of cylinders, where there is no engine"
    )
    limit: Annotated[list[str], Field(max_length=20)] = cast(
        "list[str]", SearchWords.model_fields["limit"]
    )
    best: Annotated[int, Field(ge=1, le=200)] | None = cast(  # pyright: ignore[reportIncompatibleVariableOverride]
        "int | None", SearchWords.model_fields["best"]
    )


class Refusal(BaseModel):
    """Why a question is not answered: every mistake, its place and what would be right."""

    problems: list[Problem]


class WatchedShown(BaseModel):
    """The file that the server watches: its engine, and the mistakes that it has at present."""

    version: int = Field(description="grows with every change; 0: no file is watched")
    file: str = Field(default="", description="its name, without its directory")
    tree: dict[str, Any] | None = Field(
        default=None, description="its engine, as it was when it last had no mistake"
    )
    problems: list[Problem] = Field(default=[], description="what is wrong with it now")


class CatalogEntry(BaseModel):
    """An engine of the catalog."""

    name: str = Field(description="what to ask for it by")
    title: str
    layout: str
    cylinders: int
    cycle: str


class DerivationShown(BaseModel):
    """A derivation: HTML with MathML, every name in it escaped."""

    html: str


class FittedShown(BaseModel):
    """An engine with weights and balance shafts as an exhibit, or null where nothing is needed."""

    exhibit: Exhibit | None


class TomlShown(BaseModel):
    """An engine file."""

    toml: str


class TreeShown(BaseModel):
    """An engine file as a tree of keys."""

    tree: dict[str, Any]


class Found(BaseModel):
    """A row of what a search found."""

    cells: list[str]
    tree: dict[str, Any] = Field(description="the engine file that it makes")


class SearchShown(BaseModel):
    """How far a search has come, and what it found."""

    id: str
    state: Literal["running", "done", "cancelled", "failed"]
    done: int = Field(description="blocks that were searched")
    blocks: int = Field(description="of so many; 0 until that is known")
    note: str = Field(description="how fast it is and how long it will take yet, or why it failed")
    heads: list[str]
    rows: list[Found]
    sentences: list[str] = Field(
        description="what was asked, and what proves that the answer is complete"
    )


class Health(BaseModel):
    """That the server is there."""

    state: Literal["well"] = "well"
    version: str
