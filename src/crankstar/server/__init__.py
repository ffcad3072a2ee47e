"""The local server: engines analysed as they are edited, over HTTP with JSON.

It keeps nothing of its clients but the searches they start: an engine comes whole with every
question. It opens no file by a name from outside, answers under names of this machine only, and
reveals no path of the machine.

| module, bottom to top | one line |
|---|---|
| `forms` | the forms in which an engine is given as a file |
| `messages` | questions and answers as records |
| `refusal` | a refusal: a status and every mistake |
| `processes` | a process spawned, spoken to over a pipe, ended with its parent |
| `tasks` | tasks of worker processes: a question to its answer as JSON |
| `exporting` | tasks that give a file: solids, tables, report, page |
| `workers` | worker processes with one task at a time and a time limit |
| `answers` | answers kept; each question computed once |
| `guard` | host, kind and size of a question; headers of every answer |
| `search_process` | a search in a process of its own |
| `searches` | searches under way: progress, answers, how they stop |
| `watching` | the file that the server was started with, read again when it is saved |
| `pages` | the page and its scripts, the description of the API |
| `galleries` | the catalog as pictures |
| `routes` | questions about engines, and searches |
| `application` | the application: routes, refusals, description |
| `running` | takes a port, prints the address, serves until interrupted |
"""
