"""What the page shows of an engine, as records that are sent to it.

| module, bottom to top | one line |
|---|---|
| `proportions` | bores, lengths and radii that a drawing needs, given or assumed |
| `unit_records` | units and printed tables, the base of all records |
| `form_words` | the schema of engine files in the reader's language |
| `cycle_records` | what happens over a working cycle: strokes, torque, exhaust |
| `torsion_records` | the twist of the crankshaft |
| `mount_records` | the block on its mounts |
| `records` | Exhibition, Exhibit and their parts |
| `crankshafts` | pins, webs, rods side by side, weights on webs |
| `gears` | gear wheels between shafts |
| `scene` | Engine -> Scene: the place of every part |
| `orders` | vectors of every order, the table of orders, the free response |
| `shown_units` | the units of an engine on the page, and those that are offered |
| `printed` | documents as tables of printed cells |
| `bearing_loads` | loads on main bearings and crank pins |
| `torque` | gas and inertia torque over a working cycle, the exhaust as a sound |
| `keys` | the figures and derivations that an engine has, by key |
| `torsion` | modes, critical speeds and forced vibration of the crankshaft that twists |
| `mount_driving` | what shakes the block on its mounts at any speed; its points |
| `mounts` | modes of the block on its mounts, vibration over speed |
| `told` | the analyses that have a panel of their own: tables, sentences and figures |
| `figures` | a figure as Vega-Lite, a derivation as HTML, by key |
| `exhibits` | Engine -> Exhibit, Exhibition; the engine with the recommended remedy |
| `workshop_records` | what the workshop is sent |
| `controls` | the numbers of an engine that are changed directly |
| `sliders` | the curves behind them, by sweeping |
| `workshop` | an engine with what can be changed in it; layouts to begin with |
| `library` | the whole contents of a file or a notebook, packed |
| `standalone` | the page as one file without a network |
| `widget` | the page as a notebook widget |
"""

from crankstar.page.exhibits import exhibit, exhibition, fitted

__all__ = ["exhibit", "exhibition", "fitted"]
