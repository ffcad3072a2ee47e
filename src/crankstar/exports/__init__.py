"""An engine for other tools.

| module, bottom to top | one line |
|---|---|
| `exudyn` | a multibody model as a script for EXUDYN, with the reactions on the block |
"""
