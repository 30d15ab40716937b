"""A paper holds together: names, quotes, the choice of claims."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from mpsolve import InputError
from mpsolve.claims import Paper


def test_names_of_claims(toy: Paper) -> None:
    assert [claim.id for claim in toy.chosen(["i"])] == ["i-a", "i-b"]
    assert [claim.id for claim in toy.chosen(["ii", "i-b"])] == ["i-b", "ii"]  # the order of the paper
    assert toy.chosen([]) == tuple(toy.claims)
    with pytest.raises(InputError, match="'iv' is no claim: give one of i-a, i-b"):
        toy.chosen(["i", "iv"])


def test_quotes_are_the_papers_words(toy: Paper) -> None:
    assert toy.quote(toy.claim("i-a")) == "Two roots were found."
    assert toy.quote(toy.claim("i-b")) == "There are 3 roots."


def test_a_paper_that_does_not_hold_together(toy: Paper) -> None:
    with pytest.raises(InputError, match="i-a is the name of two claims"):
        replace(toy, claims=[*toy.claims, toy.claims[0]])
    with pytest.raises(InputError, match="iv has a quote"):
        replace(toy, quotes={"iv": "words"})
    with pytest.raises(InputError, match="v has a quote or a place in `slow`"):
        replace(toy, slow=["v"])


def test_the_command_that_checks_it_again(toy: Paper, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.chdir(Path(toy.where).parent)
    assert toy.command == "mpsolve audit toy"
    monkeypatch.chdir(tmp_path)
    assert toy.command == f"mpsolve audit {toy.where}"
    assert replace(toy, where="some.module").command == "mpsolve audit some.module"
    assert replace(toy, where="").command == "mpsolve audit FOLDER"
