"""Words: numbers, units and sentences as text, message catalogs, the sentences of faults.

| module, bottom to top | one line |
|---|---|
| `written` | text that keeps the numbers in it apart from its words |
| `messages` | sentences in the reader's language, from gettext catalogs |
| `alike` | analyses of several engines that say the same things, for ranges |
| `numbers` | numbers, amplitudes, units and durations as text |
| `units` | the units that are read and shown, with their factors |
| `quoting` | text from outside, quoted on one printable line |
| `shown_units` | the units in which results are shown, and quantities as text |
| `spelling` | signs that an encoding lacks, in ASCII |
| `engine_faults` | the sentence of each fault of an engine |
| `gas_faults` | the sentence of each fault of gas, trace and drive |
| `mount_faults` | the sentence of each fault of a block, its mounts and its foundation |
| `tolerance_faults` | the sentence of each fault of a tolerance |
| `torsion_faults` | the sentence of each fault of a chain that twists |
| `value_faults` | the sentence of each fault of a value and its unit |
| `file_faults` | the sentence of each fault of an engine file |
| `search_faults` | the sentence of each fault of a search |
| `server_faults` | the sentence of each fault of a question to the server |
| `glossary` | the terms of the field, with symbol, names and meanings in every language |
| `faults` | faults as records: path, code, values; their sentences |
"""
