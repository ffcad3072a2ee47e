"""What can be wrong with a question to the local server: a sentence for each code.

The codes of `QUESTION` are pydantic's kinds of errors, `given` is the wrong value.
"""

from __future__ import annotations

from crankstar.language.messages import N_, Plural

QUESTION = {
    "missing": N_("is missing; see /docs for the keys of this request"),
    "extra_forbidden": N_("unknown key; see /docs for the keys of this request"),
    "string_type": N_("is {given}; text is needed"),
    "int_type": N_("is {given}; a whole number is needed"),
    "float_type": N_("is {given}; a number is needed"),
    "bool_type": N_("is {given}; true or false is needed"),
    "list_type": N_("is {given}; a list is needed"),
    "model_attributes_type": N_("is {given}; an object is needed"),
    "greater_than_equal": N_("is {given}; it must be at least {ge}"),
    "less_than_equal": N_("is {given}; it must be at most {le}"),
    "literal_error": N_("is {given}; it can be {expected}"),
    "string_too_long": N_("is {given}; at most {max_length} letters are allowed"),
    "too_long": N_("is {given}; at most {max_length} entries are allowed"),
    "other": N_("is {given}, which cannot be used here; see /docs"),
}
SENTENCES: dict[str, str | Plural] = {
    **{f"question.{kind}": sentence for kind, sentence in QUESTION.items()},
    "question.long-name": N_("has {count} letters; names of the catalog have at most {greatest}"),
    "question.engine": N_(
        "is {given}; give the name of an engine of the catalog, or the keys of an engine file"
    ),
    "question.no-text": N_("is empty; give the text of an engine file"),
    "question.subject": N_("Give either an engine or a number of cylinders."),
    "question.long-search": N_(
        "This search takes about {duration} on one processor, too long for a page. Fix throws, "
        "ask for symmetric cranks or require a sum to vanish; or use `crankstar search`, which "
        "has no limit."
    ),
    "question.no-text-file": N_("is not a text file in UTF-8; an engine file is TOML or JSON"),
    "question.spreadsheet": N_(
        "is a spreadsheet, which only the command line reads; `crankstar show engine.xlsx "
        "--explicit -o engine.toml` writes a file to open here"
    ),
    "question.not-text": N_("The request is not text in UTF-8."),
    "question.not-object": N_("The request is not a JSON object, as in {example}."),
    "question.late": N_("The request did not arrive within {seconds} s."),
    "question.broken-off": N_("The request broke off."),
    "question.not-http": N_("This is not an HTTP request."),
    "question.not-json": N_(
        "The request must be JSON, with the header Content-Type: application/json."
    ),
    "question.compressed": N_(
        "The request must not be compressed. Leave out the header Content-Encoding."
    ),
    "question.large": N_("The request is larger than {size} MB; an engine file has a few kB."),
    "question.host": N_("{host} is not a name of this server. Use the address that it printed."),
    "question.origin": N_(
        "The request comes from a page of another site. Open the page of this server itself."
    ),
    "question.address": N_("There is no such address; see /docs."),
    "question.method": N_("This address does not allow this method; see /docs."),
    "question.unanswerable": N_("This request cannot be answered."),
    "question.unbuilt": N_("{name} is not part of this installation"),
    "question.more": N_("... and {count} more"),
    "question.too-long": N_(
        "The computation took longer than {seconds} s and was stopped. Reduce the request, or "
        "use the command line, which has no limit."
    ),
    "question.busy": N_("Too many requests are waiting. Try again in a moment."),
    "question.lost": N_(
        "The process that computed this was lost, perhaps for lack of memory. Reduce the request."
    ),
    "question.failed": N_(
        "The request failed because of a bug in crankstar. The details are in the terminal of "
        "the server."
    ),
    "question.crowded": N_(
        "{count} searches are running, the most allowed. Wait until one ends, or stop it."
    ),
    "question.no-search": N_("There is no such search. Answers are kept for a quarter of an hour."),
    "request": "{sentence}",
}
