"""The response of the engine to the excitation.

| module, bottom to top | one line |
|---|---|
| `whirl` | shift, tilt and turn of the free rigid engine, order by order |
"""
