"""Many who edit at the same time: each gets the answer to the own question."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import pytest
from tests.web.serving import Server

from crankstar.files.catalog import tree_of

PEOPLE, EDITS = 16, 3


@pytest.mark.release
def test_everybody_gets_the_answer_to_the_own_question(server: Server) -> None:
    tree = tree_of("v8-cross-plane")[1]

    def edit(person: int) -> list[tuple[int, str, float]]:
        found = []
        for number in range(EDITS):
            angle = 20 + 2 * person + number / 2
            banks = [
                {**bank, "bearing": f"{sign * angle} deg"}
                for sign, bank in zip((1, -1), tree["layout"]["banks"], strict=True)
            ]
            own = {
                **tree,
                "name": f"{person}.{number}",
                "layout": {**tree["layout"], "banks": banks},
                "firing_order": [],
            }
            answer = server.ask("api/exhibit", {"engine": own})
            found.append(
                (
                    answer.status,
                    answer.json["name"],
                    answer.json["scene"]["cylinders"][0]["bearing"] * 57.29577951308232,
                )
            )
        return found

    with ThreadPoolExecutor(PEOPLE) as crowd:
        answers = list(crowd.map(edit, range(PEOPLE)))
    for person, found in enumerate(answers):
        for number, (status, name, bearing) in enumerate(found):
            assert (status, name) == (200, f"{person}.{number}")
            assert abs(abs(bearing) - (20 + 2 * person + number / 2)) < 1e-6
