"""The report on an engine: one HTML file that needs neither script nor network, and a PDF of it through a system Chromium.

| module | one line |
|---|---|
| `printing` | the report as a PDF, by a Chromium that is there |
| `document` | the sections put together, with the style sheet and its hash |
| `ending` | sources, conventions, the command that makes the report again |
| `whirling` | the paths of the ends of the crankshaft if nothing held the engine |
| `cures` | what weights and balance shafts do: before and after |
| `pages` | crankshaft, strokes, orders, vectors, derivations, another engine beside it |
| `title` | the first page: data, and the verdict |
| `gallery` | the figures, drawn while the words are being written |
| `matter` | what a report is about |
| `markup` | tables and sentences of the terminal as HTML |
"""

from crankstar.report.document import report
from crankstar.report.matter import Matter
from crankstar.report.printing import PrintingError, browser, pdf

__all__ = ["Matter", "PrintingError", "browser", "pdf", "report"]
