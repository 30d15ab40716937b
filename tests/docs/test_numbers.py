"""No page has a typed number that the library could make: what stands in prose is input, literature or tested."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
MADE = {"_build", "_generated", "_extensions", "jupyter_execute"}
PAGES = [page for page in sorted(DOCS.rglob("*.md")) if not MADE & set(page.relative_to(DOCS).parts)]
STORIES = sorted((ROOT / "examples" / "findings").glob("[a-z]*.md"))
LITERATURE = {"theory/papers.md", "theory/infinite-train.md"}
"""Pages with years, volumes and pages of print, which stand in their lists of papers."""
TOLD = {
    "about/tried-by-readers.md": "what readers said, and what pages said to them at that time",
    "reference/by-example.md": "exit statuses",
}
INPUT = {
    "start/tutorial.md": {"300", "150"}  # kg of a sleeper, and half of it
}
TESTED = {
    "theory/passivity.md": {"16.6": "tests/docs/test_passivity.py"},
    "theory/infinite-train.md": dict.fromkeys(("0.44507", "0.452", "0.455", "128"), "tests/endless/test_doubling.py"),
    "how-to/paper.md": {"138": "tests/examples/paper/test_paper.py"},
}
IN_STORIES = {"decomposition_planes": {"1997", "2001", "320"}}
"""Years of papers, and the velocity in m/s that the script of the finding takes."""
CELL = re.compile(r"^```\{code-cell\}.*?^```", flags=re.DOTALL | re.MULTILINE)


def prose(text: str) -> str:
    """A page without cells, code, formulas, addresses of links, and what is filled in when it is built."""
    for pattern in (r"\A---\n.*?^---\n", r"^```.*?^```", r"^(?: {4}.*\n)+", r"\$\$.*?\$\$", r"\$[^$\n]*\$"):
        text = re.sub(pattern, "", text, flags=re.DOTALL | re.MULTILINE if ".*?" in pattern else re.MULTILINE)
    return re.sub(r"`[^`]*`", "", re.sub(r"\]\([^)]*\)", "]", text))


def typed(text: str) -> set[str]:
    """Numbers of three figures and more."""
    found = {one.rstrip(".,") for one in re.findall(r"(?<![\w.,])\d[\d.,]*", prose(text))}
    return {one for one in found if len(re.sub(r"\D", "", one).lstrip("0")) >= 3}


def in_cells(number: str, text: str) -> bool:
    """Whether a cell of the page takes this number."""
    code = " ".join(CELL.findall(text))
    return re.search(rf"(?<![\d.]){re.escape(number.replace(',', ''))}(?![\d.e])", code) is not None


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(DOCS)))
def test_a_number_in_prose_goes_into_a_cell_or_is_tested(page: Path) -> None:
    name, text = str(page.relative_to(DOCS)), page.read_text("utf-8")
    if name in TOLD:
        return
    if name in LITERATURE:
        text = text.split("## Literature")[0] if "## Literature" in text else ""
    known = INPUT.get(name, set()) | set(TESTED.get(name, {}))
    assert {one for one in typed(text) if not in_cells(one, text)} == known


def test_numbers_that_tests_hold_stand_in_those_tests() -> None:
    for numbers in TESTED.values():
        for number, test in numbers.items():
            assert re.search(rf"(?<![\d.]){re.escape(number)}(?!\d)", (ROOT / test).read_text("utf-8")), number


@pytest.mark.parametrize("story", STORIES, ids=lambda story: story.stem)
def test_the_words_of_a_finding_leave_their_numbers_open(story: Path) -> None:
    assert typed(story.read_text("utf-8")) == IN_STORIES.get(story.stem, set())


def test_a_typed_number_is_found() -> None:
    page = "It is 311 m/s.\n\n```{code-cell} ipython3\nv = 250\n```\n\nAt 250 m/s, `12345`, $1234$.\n"
    assert typed(page) == {"311", "250"}
    assert (in_cells("250", page), in_cells("311", page)) == (True, False)
