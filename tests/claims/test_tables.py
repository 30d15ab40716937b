"""The terminal and the JSON say the same."""

from __future__ import annotations

import json

from mpsolve.claims.report import Report
from mpsolve.claims.tables import as_data, document
from mpsolve.report.layout import plain


def test_json_and_terminal_say_the_same(toy_report: Report) -> None:
    data, text = as_data(toy_report), plain(document(toy_report))
    assert (data["title"], data["paper"]) == ("One mass & its <roots>", "Nobody, one mass")
    assert (data["notation"], data["complete"]) == ("A root is a root.", False)
    assert json.loads(json.dumps(data)) == data
    entries = {entry["id"]: entry for entry in data["claims"]}
    assert list(entries) == ["i-a", "i-b", "ii", "iii"]
    assert sum(data["summary"].values()) == len(entries)
    for entry in data["claims"]:
        assert entry["id"] in text
        assert entry["sentence"].split()[0] in text
    assert toy_report.summary in text.replace("\n", " ")
    first = entries["i-a"]
    assert (first["claim"], first["tried"]) == ("Two roots were found.", "There are 2 roots.")
    assert (first["printed"], first["looked at"]) == ({"roots": ["2"]}, {"eta_m": ["10"]})
    assert (first["certificates"], first["no certificate"]) == (["i-a_spectrum.json"], "")
    assert first["numbers"] == [{"what": "roots", "value": "2"}]
    assert entries["ii"]["no certificate"] in " ".join(text.split())
    assert "→ 2 & more" in text
