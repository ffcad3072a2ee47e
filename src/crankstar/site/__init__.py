"""The engines of the catalog, or any others, as pictures that lead to their pages.

| module, bottom to top | one line |
|---|---|
| `miniatures` | small turning pictures of an engine, light and dark |
| `gallery` | the gallery as HTML, for the server too; its style |
| `pages` | the files of one engine: its page and its miniatures |
| `building` | a whole site, written in two processes and moved into place |

A site is files for any web host, and opens from disk as well. Every page asks for one script, which
they share; nothing comes from elsewhere.
"""
