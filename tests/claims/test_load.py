"""A paper is loaded by its path or its name; what is no paper is refused with a sentence."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import pytest

from mpsolve import InputError
from mpsolve.claims import Claim, Finding, Paper, Verdict
from mpsolve.claims.load import audit, checked, load
from mpsolve.claims.report import Report
from mpsolve.errors import PrecisionError

HEAD = "from mpsolve.claims import Paper\n"
EMPTY = HEAD + "PAPER = Paper({!r}, 'nobody', [])\n"


def made(folder: Path, **files: str) -> Path:
    folder.mkdir(exist_ok=True)
    for name, text in files.items():
        (folder / f"{name}.py").write_text(text, "utf-8")
    return folder


def test_by_path_however_it_is_written(toy: Paper, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = Path(toy.where)
    monkeypatch.chdir(folder.parent)
    assert toy is load("toy") is load(folder) is load(folder / ".." / "toy")
    assert str(folder) not in sys.path
    assert "toy" not in sys.modules
    assert load(folder / "__init__.py").claims[0].id == "i-a"


def test_two_folders_of_one_name_are_two_papers(tmp_path: Path) -> None:
    for place in ("one", "other"):
        made(tmp_path / place)
        made(tmp_path / place / "paper", paper=HEAD + "from .part import TITLE\nPAPER = Paper(TITLE, 'nobody', [])\n")
        made(tmp_path / place / "paper", part=f"TITLE = {place!r}\n")
    assert [load(tmp_path / place / "paper").title for place in ("one", "other")] == ["one", "other"]


def test_by_name(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made(tmp_path / "of_somebody", __init__="", late=EMPTY.format("Late"))
    monkeypatch.syspath_prepend(tmp_path)
    found = load("of_somebody.late")
    assert (found.title, found.where) == ("Late", "of_somebody.late")


@pytest.mark.parametrize(
    ("files", "said"),
    [
        ({}, "holds neither __init__.py nor paper.py"),
        ({"paper": "x = 1\n"}, "exports no paper"),
        ({"paper": "PAPER = 'a title'\n"}, "exports no paper"),
        ({"paper": "import no_such_thing\n"}, "cannot be imported .ModuleNotFoundError"),
        ({"paper": "PAPER = \n"}, "cannot be imported .SyntaxError"),
        ({"__init__": "from .part import PAPER\n", "part": "1 / 0\n"}, "cannot be imported .ZeroDivisionError"),
        ({"paper": HEAD + "PAPER = Paper('a', 'b', [], {'x': 'y'})\n"}, "x has a quote"),
    ],
)
def test_what_is_no_paper(files: dict[str, str], said: str, tmp_path: Path) -> None:
    before = set(sys.modules)
    folder = made(tmp_path / "broken", **files)
    with pytest.raises(InputError, match=said):
        load(folder)
    if "exports" not in said:
        assert not [name for name in set(sys.modules) - before if name.startswith("broken")]


@pytest.mark.parametrize("where", ["", "no/such/folder", "no_such_module", "json.no_such_module"])
def test_what_is_not_there(where: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InputError, match="examples/paper"):
        load(where)


def test_a_file_of_another_kind(tmp_path: Path) -> None:
    (tmp_path / "case.toml").write_text("", "utf-8")
    with pytest.raises(InputError, match="no Python file"):
        load(tmp_path / "case.toml")


def verdicts(report: Report) -> dict[str, Verdict]:
    return {claim.id: finding.verdict for claim, finding in report.entries}


def test_verdicts(toy_report: Report) -> None:
    assert list(verdicts(toy_report).items()) == [
        ("i-a", Verdict.PROVED),
        ("i-b", Verdict.REFUTED),
        ("ii", Verdict.AGREES),
        ("iii", Verdict.UNDECIDABLE),
    ]


def test_other_processes_load_the_paper_by_its_path(toy: Paper, toy_report: Report) -> None:
    """They cannot import it by its name, which is on no search path."""
    heard: list[float] = []
    found = audit(toy, ["i", "iii"], workers=2, tell=lambda _, part: heard.append(part))
    assert verdicts(found) == {name: one for name, one in verdicts(toy_report).items() if name != "ii"}
    assert [c.content["sha256"] for c in found.certificates.values()] == [
        c.content["sha256"] for c in toy_report.certificates.values()
    ]
    assert heard[-1] == 1


def test_slow_claims_begin_first(toy: Paper) -> None:
    begun: list[str] = []

    def noted(claim: Claim) -> Finding:
        begun.append(claim.id)
        return Finding(Verdict.PROVED, "So.")

    claims = [replace(claim, check=noted) for claim in toy.claims]
    report = audit(replace(toy, claims=claims, where=""), workers=1)
    assert begun == ["ii", "i-a", "i-b", "iii"]
    assert [claim.id for claim, _ in report.entries] == ["i-a", "i-b", "ii", "iii"]


def test_a_check_without_end_is_a_finding() -> None:
    def stuck(claim: Claim) -> Finding:
        raise PrecisionError(f"{claim.id} needs more digits")

    found = checked(Claim("none", "nowhere", "words", stuck))
    assert (found.verdict, found.stopped) == (Verdict.UNDECIDABLE, True)
    assert "none needs more digits" in found.sentence


def test_bad_input(toy: Paper) -> None:
    with pytest.raises(InputError, match="no claim"):
        audit(toy, ["iv"])
    with pytest.raises(InputError, match="workers"):
        audit(toy, workers=0)
