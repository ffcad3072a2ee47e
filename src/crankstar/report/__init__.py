"""The report on an engine: one HTML file without script or network, or a PDF of it.

| module, bottom to top | one line |
|---|---|
| `markup` | sections, figures and tables as HTML |
| `subject` | the engine, its speed and orders |
| `views` | the engine itself, as `crankstar draw` has it |
| `gallery` | the figures |
| `title` | the data sheet, and what the verdict says besides the front page |
| `front` | the front page for a reader in a hurry, and the contents |
| `pages` | crankshaft, strokes, orders, vectors, derivations, comparison |
| `gas` | the gas cycle, torque over it, how evenly the engine runs |
| `bearings` | loads on the main bearings, bending of the crankshaft |
| `analyses` | the section of an analysis that is a record |
| `whirling` | the paths of the crankshaft's ends in an unmounted engine |
| `remedies` | counterweights and balance shafts: before and after |
| `frame` | the drawing of axes, angles and signs |
| `sources` | the last pages: sources, conventions, the command |
| `numbering` | the numbers of sections, figures and tables, and references to them |
| `lettering` | parts of free fonts for Japanese and Cyrillic letters |
| `document` | all sections, with the style sheet and its hash |
| `printing` | the PDF, printed by an installed Chromium |
| `paging` | the PDF with pages in its contents |
"""

from crankstar.report.document import report
from crankstar.report.paging import printed
from crankstar.report.printing import PrintingError, browser, pdf
from crankstar.report.subject import Subject

__all__ = ["PrintingError", "Subject", "browser", "pdf", "printed", "report"]
