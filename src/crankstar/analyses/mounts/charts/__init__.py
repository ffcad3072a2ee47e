"""The charts of an engine on its mounts.

| module, bottom to top | one line |
|---|---|
| `words` | what charts of an engine on its mounts say |
| `layouts` | the mounts in three views, with the axes of the block |
| `modes` | the natural modes on the mounts, freedom by freedom |
| `responses` | vibration and forces on the mounts over the speed |
"""
