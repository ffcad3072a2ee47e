"""The local server: engines analysed as they are edited, over HTTP with JSON.

It keeps nothing of its askers but the searches they start: an engine comes whole with every question. It opens no file by a
name that it is asked for, answers under names of this machine only, and never says where on the machine anything is.

| module | one line |
|---|---|
| `running` | a port taken, the address said, served until interrupted |
| `application` | the application: routes, refusals, description |
| `pages` | the page, its scripts, the description of the API for people |
| `routes` | questions about engines, and searches |
| `guard` | who may ask: host, kind and size of a question; what every answer says to the browser |
| `searches` | searches under way, their progress, what they found |
| `search_process` | a search in a process of its own |
| `answers` | answers kept, and each question reckoned once however many ask it |
| `tasks` | what the processes of the crew are given to do |
| `crew` | processes that reckon, and are ended when it takes too long |
| `messages` | questions and answers as records |
| `refusal` | what cannot be answered: a status and every mistake |
"""
