"""Firing orders and intervals, strokes, exhaust; V engines that fire evenly.

| module, bottom to top | one line |
|---|---|
| `intervals` | the firing order with its angles and intervals |
| `numbering` | an engine with another firing order, or other cylinder numbers |
| `succession` | successive firings in a group; neighbours and pin partners |
| `timetable` | all ways to give each chamber one of its dead centres |
| `orders` | firing orders that a crank can fire: even, given, all possible |
| `weighing` | firing orders weighed by the sum or the twist of gas torque |
| `strokes` | strokes, valve or port events, common exhausts |
| `exhaust_orders` | the orders of the exhaust pulses of a group |
| `rows` | crankshafts of one row of cylinders that fire evenly |
| `vees` | V engines that fire evenly: throws, bank angle, pin split |
"""
