"""What the page shows of an engine, as records that are sent to it.

| module | one line |
|---|---|
| `records` | Exhibition, Exhibit and what they consist of |
"""
