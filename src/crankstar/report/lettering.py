"""Fonts in a report: the letters that few fonts have, as a small part of a free font."""

from __future__ import annotations

from base64 import b64encode
from io import BytesIO
from pathlib import Path

from crankstar.charts.fonts import JAPANESE, SCRIPTS, Script, font_file, letters_of


def faces(text: str) -> tuple[str, str]:
    """The `@font-face` rules for the Japanese and Cyrillic letters of a text, and their families.

    Both are empty where the text has none, or where the packages with fonts are not installed.
    """
    rules, families = [], []
    for script in SCRIPTS:
        letters, place = letters_of(script, text), font_file(script)
        if letters and place is not None:
            family = f"crankstar {script.family}"
            data = b64encode(_part(place, script, letters)).decode()
            rules.append(
                f'@font-face {{ font-family: "{family}"; font-weight: 100 900; '
                f'src: url("data:font/woff;base64,{data}") format("woff"); }}\n'
            )
            families.append(f'"{family}"')
    return "".join(rules), ", ".join(families)


def rules_of(families: str) -> str:
    """The style in which these families serve letters that the usual fonts do not have."""
    if not families:
        return ""
    usual = f'system-ui, "Segoe UI", Roboto, "DejaVu Sans", {families}, sans-serif'
    return (
        f"body {{ font-family: {usual}; }}\n@page {{ font-family: {usual}; }}\n"
        f"svg text {{ font-family: Arial, Helvetica, {families}, sans-serif; }}\n"
        f"pre {{ font-family: ui-monospace, {families}, monospace; }}\n"
    )


def _part(path: Path, script: Script, letters: str) -> bytes:
    """The part of a font with these letters as WOFF, the same bytes every time."""
    from fontTools import subset
    from fontTools.ttLib import TTFont

    options = subset.Options(flavor="woff", layout_features=["kern"], recalc_timestamp=False)
    font = TTFont(str(path), recalcTimestamp=False)
    if script is JAPANESE:  # set in squares, without kerning; these tables take longest to read
        for tag in {"BASE", "GPOS", "GSUB"} & set(font.keys()):
            del font[tag]
    if script.family == "Noto Sans":  # a variable font, at its regular weight and width
        from fontTools.varLib.instancer import instantiateVariableFont

        font = instantiateVariableFont(font, {"wght": 400, "wdth": 100})
    subsetter = subset.Subsetter(options)
    subsetter.populate(text=letters)
    subsetter.subset(font)
    font.flavor = "woff"
    out = BytesIO()
    font.save(out, reorderTables=False)
    return out.getvalue()
