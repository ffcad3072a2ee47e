"""Help in the reader's language: titles and descriptions are messages of the catalogs."""

from __future__ import annotations

from collections.abc import Callable
from io import StringIO
from typing import Any

from cyclopts import App
from cyclopts.help import DefaultFormatter, HelpPanel
from cyclopts.help.inline_text import InlineText
from rich.console import Console, ConsoleOptions
from rich.text import Text

from crankstar.language.messages import _


class TranslatedHelp(DefaultFormatter):
    """The help of cyclopts with every text passed through `translate`."""

    def __init__(self, translate: Callable[[str], str] = _) -> None:
        super().__init__()
        self._translate = translate

    def __call__(self, console: Console, options: ConsoleOptions, panel: HelpPanel) -> None:
        """Render a panel."""
        entries = [
            entry.copy(description=self._translated(entry.description)) for entry in panel.entries
        ]
        if entries:
            title = self._translate(str(panel.title))
            super().__call__(console, options, panel.copy(title=title, entries=entries))

    def render_description(
        self, console: Console, options: ConsoleOptions, description: Any
    ) -> None:
        """Render the description of a command."""
        super().render_description(console, options, self._translated(description))

    def _translated(self, description: Any) -> Any:
        if not isinstance(description, InlineText):
            return description
        text = str(description.primary_renderable)
        return Text(self._translate(text) + ("\n" if description.force_empty_end else ""))


def sentences(app: App) -> list[str]:
    """Every text of the help of an application and of its commands."""
    texts: dict[str, None] = {}

    def recorded(text: str) -> str:
        texts[text] = None
        return text

    app.resolved_commands()  # so that the list of them has a line of each
    app.help_formatter = TranslatedHelp(recorded)
    for command in ([], *([name] for name in app if not name.startswith("-"))):
        app.help_print(command, console=Console(file=StringIO()))
    return sorted(text for text in texts if text)
