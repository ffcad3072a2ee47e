"""The charts of a marine engine.

| module, bottom to top | one line |
|---|---|
| `guide_moments` | guide-force moments of each order |
"""
