"""What can be wrong with an engine file and its values: a sentence for each code."""

from __future__ import annotations

from crankstar.language.messages import N_, Plural
from crankstar.language.value_faults import DIMENSIONS

KINDS = {
    "picture": N_("a picture (SVG)"),
    "page": N_("a page (HTML)"),
    "list": N_("a list (CSV)"),
    "engine": N_("an engine file"),
}
"""Kinds of files, where one of another kind is wanted."""
NAMED: dict[str, dict[str, str]] = {
    "found": KINDS,
    "dimension": DIMENSIONS,
    "measured": DIMENSIONS,
    "side": {"intake": N_("intake"), "exhaust": N_("exhaust")},
    "unit": {"crank radii": N_("crank radii"), "bore pitches": N_("bore pitches")},
    "cycle_name": {"two-stroke": N_("two-stroke"), "four-stroke": N_("four-stroke")},
    "kind": {
        "whole-number": N_("a whole number"),
        "number": N_("a number"),
        "finite-number": N_("a finite number"),
        "text": N_("text"),
        "whole-text": N_("text of whole characters"),
        "list": N_("a list"),
        "table": N_("a table"),
    },
}
"""Values that are names of things, with the words for them; others stand as they are."""

SENTENCES: dict[str, str | Plural] = {
    "workshop.explicit": N_(
        "{where}: the explicit form lists every part; give the file a layout to change the number "
        "of cylinders"
    ),
    "workshop.cylinders": N_(
        "{where} is {value}; this layout has {step} more or fewer at a time, up to {greatest}"
    ),
    "workshop.no-crank": N_("{where} is {value}; no crankshaft of this layout has so many"),
    "text": N_("{text}"),
    "key.misspelt": N_("{where} is not a key of an engine file; did you mean {meant}?"),
    "key.belongs-at-top": N_(
        "{where} is not a key of this table; it belongs at the top of the file, above the first "
        "[table]"
    ),
    "key.belongs-in": N_("{where} is not a key of this table; it belongs in {table}: {path}"),
    "key.unknown": N_("{where} is not a key of an engine file; there are: {keys}"),
    "cylinders.counted": N_(
        "{where} cannot set the number of cylinders; there are as many as firing_order, or {key}, "
        "lists"
    ),
    "key.no-text": N_("{where} has the key {value}; keys are text of whole characters"),
    "provenance.misspelt": N_("{where} names no value of this file; did you mean {meant}?"),
    "provenance.range-known": N_(
        '{where} is of estimated values alone; write status = "estimated", or leave it out'
    ),
    "provenance.range": N_(
        "{where} has a range, which only these may have: {keys}; leave range out"
    ),
    "provenance.multiples": N_(
        "{where} is {value}; give multiples of the value without a unit, such as [0.9, 1.1]"
    ),
    "provenance.two-ends": N_(
        "{where} is {value}; give two multiples of the value, the lowest and the highest, such as "
        "[0.9, 1.1]"
    ),
    "provenance.ends": N_(
        "{where} is {value}; give the lowest and the highest multiple of the value, with 1 between "
        "them, such as [0.9, 1.1]"
    ),
    "provenance.no-range": N_(
        "{where} is estimated, but has no range; give the lowest and the highest multiple of the "
        "value, as in range = [0.8, 1.25], or call it unverified or a placeholder"
    ),
    "provenance.absent": N_(
        "{where} is estimated, but the file does not have the value; add it, or take its source out"
    ),
    "provenance.moves-with": N_(
        "{where} is {value}; name another key of [provenance] that has a range and moves with none "
        "itself, or cylinder.rod for the inertia of a rod"
    ),
    "provenance.wide": N_("{where} is too wide: at {end} times the value {mistake}"),
    "provenance.wide-together": N_(
        "{where}: the ranges are too wide: at the ends of several {mistake}"
    ),
    "provenance.unknown": N_(
        "{where} names no value of this file; give a key path, such as cylinder.bore"
    ),
    "type.list-of-tables": N_(
        "{where} is {value}; a list of tables is needed, each of them headed [[{key}]]"
    ),
    "type": N_("{where} is {value}; {kind} is needed"),
    "type.example": N_("{where} is {value}; {kind} is needed, such as {example}"),
    "missing": N_("{where} is missing; give it"),
    "missing.example": N_("{where} is missing; give it, as in {key} = {example}"),
    "greater-than": N_("{where} is {value}; it must be greater than {bound}"),
    "greater-than.example": N_(
        "{where} is {value}; it must be greater than {bound}, such as {example}"
    ),
    "at-least": N_("{where} is {value}; it must be at least {bound}"),
    "at-least.example": N_("{where} is {value}; it must be at least {bound}, such as {example}"),
    "at-most": N_("{where} is {value}; it must be at most {bound}"),
    "at-most.example": N_("{where} is {value}; it must be at most {bound}, such as {example}"),
    "choice": N_("{where} is {value}; it can be {choices}"),
    "too-many": N_("{where} has {size} entries; at most {bound} are allowed"),
    "too-few": Plural(
        "{where} has {size} entries; at least {count} is needed",
        "{where} has {size} entries; at least {count} are needed",
    ),
    "too-long": N_("{where} has {size} letters; at most {bound} are allowed"),
    "invalid": N_("{where} is {value}; {message}"),
    "parts.reciprocating": N_(
        "{where} is {given}, but the parts that go up and down come to {total}; leave it out, or "
        "correct the parts"
    ),
    "parts.rotating": N_(
        "{where} is {given}, but the parts on the crank pin come to {total}; leave it out, or "
        "correct the parts (the crankshaft's own crank pin and webs are throw_mass)"
    ),
    "parts.end-missing": N_(
        "{where} is missing, and the rod is given as a rigid body; give both ends of the rod, or "
        "neither"
    ),
    "parts.rod-mass": N_(
        "{where} is {given}, but the two ends of the rod come to {total}; leave it out, or correct "
        "the parts"
    ),
    "parts.rod-centre": N_(
        "{where} is {given} from the big end, but by its two ends the rod's centre of mass lies at "
        "{centre}; leave it out, or correct the parts"
    ),
    "file.missing": N_("there is no such file; `crankstar list` names the engines of the catalog"),
    "file.not-in-catalog": N_(
        "there is no such engine in the catalog, and no such file; `crankstar list` names the "
        "engines of the catalog"
    ),
    "file.not-in-catalog-near": N_(
        "there is no such engine in the catalog, and no such file; did you mean {near}?"
    ),
    "catalog.unknown": N_(
        "there is no such engine in the catalog; `crankstar list` names those it has"
    ),
    "catalog.unknown-near": N_("there is no such engine in the catalog; did you mean {near}?"),
    "file.unreadable": N_("{where} cannot be read ({reason}); name another file"),
    "file.too-large": N_("{where} is larger than {greatest} MB; an engine file has a few kB"),
    "file.empty": N_("{where} is empty; `crankstar new vee` writes one to start from"),
    "file.not-text": N_("{where} is not a text file in UTF-8; an engine file is TOML or JSON"),
    "file.no-openpyxl": N_(
        "to read a spreadsheet openpyxl is needed; install it with: pip install "
        '"crankstar[spreadsheet]"'
    ),
    "file.spreadsheet-protected": N_(
        "{where} is protected by a password, or an old .xls; save it as .xlsx without a password"
    ),
    "file.not-spreadsheet": N_(
        "{where} is not a spreadsheet in the form .xlsx; `crankstar new vee -o mine.xlsx` writes "
        "one to start from"
    ),
    "file.spreadsheet-large": N_(
        "{where} unpacks to more than {greatest} MB; an engine file has a few kB"
    ),
    "sheet.missing": N_(
        "there is no sheet {sheet}; the sheets are: {sheets}. `crankstar new vee -o mine.xlsx` "
        "writes one to start from"
    ),
    "sheet.missing-near": N_(
        "there is no sheet {sheet}; rename the sheet {meant}, or write a form with `crankstar new "
        "vee -o mine.xlsx`"
    ),
    "sheet.empty": N_(
        "the sheet {sheet} is empty; `crankstar new vee -o mine.xlsx` writes one to start from"
    ),
    "sheet.unknown": N_("the sheet {sheet} is no table of an engine; there are: {sheets}"),
    "sheet.unknown-near": N_("the sheet {sheet} is no table of an engine; did you mean {meant}?"),
    "sheet.too-long": N_(
        "the sheet {sheet} reaches to the cell {corner}; delete what stands or is formatted beyond "
        "row {rows} and column {columns}"
    ),
    "sheet.heading-missing": N_(
        "{cell}: the first row must have the headings {headings}; there is no {missing}"
    ),
    "sheet.heading-twice": N_("{cell}: the heading {heading} stands twice"),
    "sheet.heading-near": N_("{cell}: the heading {heading} is not read; did you mean {meant}?"),
    "cell.row-number": N_(
        "{cell} is {value}; this row is number {right} of its table: number the rows from 1, or "
        "clear the column"
    ),
    "cell.merged": N_("the cells {cell} are merged; unmerge them and fill each cell"),
    "cell.key-twice": N_("{cell}: the key {key} stands twice; leave one of them out"),
    "cell.two-units": N_(
        "{cell} is {value}, but the unit beside it is {unit}; write the unit in one of them"
    ),
    "cell.no-key": N_("{cell} is {value}, but the row has no key in the column {heading}"),
    "cell.no-heading": N_(
        "{cell} is {value}, but its column has no heading in the first row; name what it is, or "
        "clear the cell"
    ),
    "cell.no-row": N_(
        "{cell} is {value}; it must be the number of a row of the sheet {sheet}, from 1 to {count}"
    ),
    "cell.no-rows": N_(
        "{cell} is {value}, the number of a row of the sheet {sheet}, which has none; fill in its "
        "rows"
    ),
    "cell.formula": N_(
        "{where} is a formula without a stored value; open the file in a spreadsheet program and "
        "save it, or write the number"
    ),
    "cell.error": N_("{where} is {value}, an error of a formula; write the value"),
    "cell.date": N_(
        "{where} is a date; format the cell as text or as a number and write the value again"
    ),
    "file.input-closed": N_("standard input is closed; pipe an engine file into it, or name one"),
    "file.name-impossible": N_(
        "this is not a name a file can have; name an engine of the catalog or a file"
    ),
    "file.directory": N_("this is a directory; name a file in it"),
    "file.not-regular": N_("this is not a regular file; use - to read standard input"),
    "file.key-twice": N_("{where} has the key {key} twice in one table; give it once"),
    "file.not-toml": N_(
        "{where} is not TOML: {reason}{line}; `crankstar new vee` writes a file to compare with"
    ),
    "file.not-toml-unit": N_(
        "{where} is not TOML: {reason}{line}; a number with a unit stands in quotation "
        "marks, as in "
        "{example}"
    ),
    "file.not-toml-twice": N_(
        "{where} is not TOML: {reason}{line}; the same key or table stands twice, give it once"
    ),
    "file.not-json": N_(
        "{where} is not JSON: {reason}; `crankstar new vee` writes a file in TOML to compare with"
    ),
    "file.json-no-object": N_(
        "{where} is JSON, but not an object; an engine file in JSON starts with a brace, as in "
        "{example}"
    ),
    "file.other-kind": N_(
        "{where} is {found}; an engine file is wanted, in TOML, JSON or Excel (.xlsx), or the name "
        "of an engine, which `crankstar list` lists"
    ),
    "file.too-deep": N_(
        "{where} is nested too deeply; an engine file has at most {greatest} levels"
    ),
    "file.long-number": N_(
        "{where} holds a number of thousands of digits; write it shorter, as in 0.0825"
    ),
    "file.not-a-table": N_("{where} is {value}; a table of keys is needed"),
    "file.too-many-values": N_(
        "{where} has {size} entries, and the file more than {greatest} values; no engine needs so "
        "many"
    ),
    "file.nothing-to-estimate-from": N_(
        "there is no bore, stroke or displacement to estimate masses from; give one, such as "
        '--set cylinder.bore="86 mm" or, with `crankstar estimate`, --displacement "2 l"'
    ),
    "file.explicit-without-bore": N_(
        "masses of a file in explicit form are estimated from the bore; give bore in every entry "
        'of [[cylinders]], such as bore = "86 mm"'
    ),
    "file.displacement-and-sizes": N_(
        "the file gives a bore or a stroke, which the displacement would contradict; leave "
        "--displacement out"
    ),
    "file.no-proportions": N_(
        "no masses of engines of type {kind} have been published to estimate from; give "
        'cylinder.reciprocating_mass, such as --set cylinder.reciprocating_mass="5500 kg", or '
        "another --type"
    ),
    "file.no-estimate": N_(
        "{mistake}; it is estimated from a bore of {bore} and a stroke of {stroke}: correct "
        "cylinder.bore or cylinder.stroke"
    ),
    "file.too-many-ranges": N_(
        "{count} estimated values have a range; {greatest} can have one of their own. In "
        "[provenance] leave range out of some of {paths}, or let them move with another by "
        "moves_with"
    ),
    "set.in-list": N_(
        "{where} cannot be set; {whole} is a list of {size}; name one of them by its place, as in "
        "[1], or give all of it"
    ),
    "set.at-points": N_("{where} has no effect, as each operating point has its own: give {paths}"),
    "set.not-a-list": N_("{where} cannot be set; {whole} is not a list"),
    "set.not-a-table": N_("{where} cannot be set; {whole} is not a table; give all of it"),
    "form.mixed": N_(
        "{where} belongs to the explicit form, layout and cylinder belong to the short one; leave "
        "one out (`crankstar show --explicit`)"
    ),
    "form.drive-line": N_(
        "this is a drive line without cylinders: `crankstar torsion`, `check`, `export --to "
        "opentorsion` or `ross` and `plot` with torsion-modes or campbell take it; an engine needs "
        "cylinders in a table [layout], and its discs as [[torsion.disc]]"
    ),
    "layout.missing": N_(
        "{where} is missing; say how the cylinders are arranged in a table [layout] with type = "
        '"vee" (`crankstar new vee` writes one), or give [[shaft]] and [[cylinders]]'
    ),
    "layout.not-a-table": N_('{where} is {value}; a table is needed, [layout] with type = "vee"'),
    "layout.type-missing": N_("{where} is missing; it can be {choices}"),
    "layout.type-unknown": N_("{where} is {value}; it can be {choices}"),
    "layout.type-misspelt": N_("{where} is {value}; did you mean {meant}?"),
    "layout.of-package": N_("{where}: {why}"),
    "layout.raised": N_(
        "{where}: package {package}: its layout {name} ends with an error ({why}); that is a "
        "mistake in the package, not in this file"
    ),
    "layout.no-engine": N_(
        "{where}: package {package}: its layout {name} gives {made}, where a layout gives an "
        "Engine; that is a mistake in the package, not in this file"
    ),
}
"""By code, `{where}` the place; what is wrong first, then what would be right."""
