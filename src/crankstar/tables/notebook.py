"""How a notebook shows an Engine and a Balance: registered here, so records know no tables."""

from __future__ import annotations

from typing import Any

from crankstar.engine.engine import Engine
from crankstar.mechanics.balance import Balance
from crankstar.tables.balance_orders import notebook_table
from crankstar.tables.engines import description
from crankstar.tables.html import document_html


def engine_html(engine: Engine) -> str:
    """The engine as tables."""
    return document_html(description(engine))


def balance_html(result: Balance) -> str:
    """The orders of a balance as a table."""
    return document_html(notebook_table(result))


def register(shell: Any) -> None:
    """Register both with the HTML formatter of an IPython shell."""
    formatter = shell.display_formatter.formatters["text/html"]
    formatter.for_type(Engine, engine_html)
    formatter.for_type(Balance, balance_html)
