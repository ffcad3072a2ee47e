"""The engine itself as a picture or a film, without a browser.

A scene of the page is drawn at any crank angle as filled outlines, the far ones first.

| module, bottom to top | one line |
|---|---|
| `outlines` | circles, bands, sectors and gears as polygons |
| `palettes` | the colours of parts, on light and on dark ground |
| `motions` | where shafts, rods and pistons stand at crank angles |
| `looks` | from where the engine is seen, and what it fills |
| `panes` | a view or a sheet of four in its place, to scale |
| `bodies` | Scene -> convex bodies |
| `ordering` | which body is painted before which |
| `arrows` | force and couple as arrows |
| `painting` | the bodies at a crank angle as SVG |
| `drawings` | the whole drawing, at one crank angle or many |
| `films` | drawings one after the other as GIF, WebP, PNG or MP4 |
| `options` | how an engine is drawn, from the words of a command line |

Pillow and imageio-ffmpeg, which write films, come with `pip install "crankstar[film]"`.
"""
