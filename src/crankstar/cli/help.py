"""Help in the reader's language: titles and descriptions are messages of the catalogs."""

from __future__ import annotations

from collections.abc import Callable
from io import StringIO
from typing import Any

from cyclopts import App
from cyclopts.help import ColumnSpec, DefaultFormatter, DescriptionRenderer, HelpEntry, HelpPanel
from cyclopts.help.inline_text import InlineText
from cyclopts.help.specs import (
    DefaultStyled,
    get_default_command_columns,
    get_default_parameter_columns,
)
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
            self.column_specs = _columns(panel.format)
            super().__call__(console, options, panel.copy(title=title, entries=entries))

    def render_usage(self, console: Console, options: ConsoleOptions, usage: Any) -> None:
        """Render the line of the form that a command has."""
        del options
        if usage:
            line = Text(_("Usage: {usage}", usage=str(usage)), style="cyclopts.usage")
            console.print(DefaultStyled(line))

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


class _Described(DescriptionRenderer):
    """The description of an entry, and whether it is required, its choices and its default."""

    def __call__(self, entry: HelpEntry) -> Any:
        shown: Any = super().__call__(entry.copy(choices=None, default=None, required=False))
        if entry.choices:
            words = _("[choices: {choices}]", choices=", ".join(entry.choices))
            shown.append(Text(words, "cyclopts.choices"))
        if entry.default is not None:
            words = _("[default: {default}]", default=entry.default)
            shown.append(Text(words, "cyclopts.default"))
        if entry.required:
            shown.append(Text(_("[required]"), "cyclopts.required"))
        return shown


def _columns(kind: str) -> Callable[..., tuple[ColumnSpec, ...]]:
    """The columns of a panel, the last of them in the reader's language."""
    made = get_default_command_columns if kind == "command" else get_default_parameter_columns

    def columns(*given: Any) -> tuple[ColumnSpec, ...]:
        *others, last = made(*given)
        return (*others, last.copy(renderer=_Described()))

    return columns


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
