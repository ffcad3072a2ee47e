"""The fonts that the programs of tests see: those of Python packages, none of the machine."""

from __future__ import annotations

import os
from importlib.util import find_spec
from pathlib import Path

FILES = {
    "fontpkg_noto_sans": ("files/NotoSans[wdth,wght].ttf", "files/NotoSans-Italic[wdth,wght].ttf"),
    "pylopdf_fonts_jp": ("NotoSansJP-Regular.otf",),
    "matplotlib": tuple(
        f"mpl-data/fonts/ttf/{name}.ttf"
        for name in ("DejaVuSans", "DejaVuSans-Bold", "DejaVuSansMono")
    ),
}
"""By package: the fonts that travel with this one, and the widest one in common use."""
USUAL = {
    "sans-serif": ("Noto Sans", "Noto Sans JP", "DejaVu Sans"),
    "system-ui": ("Noto Sans", "Noto Sans JP", "DejaVu Sans"),
    "serif": ("Noto Sans", "Noto Sans JP", "DejaVu Sans"),
    "monospace": ("DejaVu Sans Mono", "Noto Sans JP"),
}
"""What names of families that are no font stand for."""


def file(package: str, name: str) -> Path | None:
    """A file of an installed package; None where that is not installed."""
    spec = find_spec(package)
    found = Path(spec.origin).parent / name if spec and spec.origin else None
    return found if found and found.is_file() else None


def only_of_packages(folder: Path) -> None:
    """Have programs that are started from now on see these fonts only, by way of fontconfig.

    Browsers, Poppler and `fc-list` all ask it; the configuration is written into the folder.
    """
    fonts = folder / "fonts"
    fonts.mkdir()
    for package, names in FILES.items():
        for name in names:
            if (found := file(package, name)) is not None:
                (fonts / found.name).symlink_to(found)
    aliases = "".join(
        f'<alias binding="same"><family>{name}</family><prefer>'
        f"{''.join(f'<family>{each}</family>' for each in families)}</prefer></alias>\n"
        for name, families in USUAL.items()
    )
    configuration = folder / "fonts.conf"
    configuration.write_text(
        f'<?xml version="1.0"?>\n<!DOCTYPE fontconfig SYSTEM "urn:fontconfig:fonts.dtd">\n'
        f"<fontconfig><dir>{fonts}</dir><cachedir>{folder / 'cache'}</cachedir>\n"
        f"{aliases}</fontconfig>\n",
        encoding="utf-8",
    )
    os.environ["FONTCONFIG_FILE"] = str(configuration)
