"""An engine for other tools.

| module, bottom to top | one line |
|---|---|
| `solids` | the moving parts at a crank angle: glTF (.glb) and STL |
| `exudyn` | a multibody model as a script for EXUDYN, with the reactions on the block |
| `torsion` | the chain that twists as a script for openTorsion or ROSS |
| `added` | exports that other packages add |
"""
