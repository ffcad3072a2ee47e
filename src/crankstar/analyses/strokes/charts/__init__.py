"""The charts of strokes and firing.

| module, bottom to top | one line |
|---|---|
| `timing_diagram` | open valves or ports and ignition of each cylinder over a cycle |
| `firing_rings` | the cylinders round a circle at their firing angles |
| `exhaust_orders` | the orders of the exhaust pulses |
"""
