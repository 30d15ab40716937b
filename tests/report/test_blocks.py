"""Blocks keep their width, their columns and their words, whatever is in them."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from mpsolve.report.blocks import Columns, Document, Line, Section

WORDS = st.text("abc ±χ²,", max_size=40)
ROWS = st.lists(st.tuples(WORDS, WORDS, WORDS), min_size=1, max_size=5)


def test_a_document() -> None:
    columns = Columns([("q1", "2.5", "decays"), ("q10", "12.25", "")], ("", "Hz", "does"), frozenset((1,)))
    document = Document((Line("STABLE", "bold green"), Section("Vibrations", columns), Section("Said", "one\n  two")))
    assert document.text().splitlines() == [
        "STABLE",
        "",
        "Vibrations",
        "           Hz   does",
        "  ────────────────────",
        "  q1      2.5   decays",
        "  q10   12.25",
        "",
        "Said",
        "  one",
        "    two",
    ]
    coloured = document.text(colour=True)
    assert coloured.startswith("\x1b[1;32mSTABLE\x1b[0m\n")
    assert "\x1b[1mVibrations\x1b[0m" in coloured


@given(ROWS, st.integers(30, 100))
def test_columns_keep_every_word_within_the_width(rows: list[tuple[str, str, str]], width: int) -> None:
    lines = Document((Section("Rows", Columns(rows)),)).text(width).splitlines()
    longest = max((len(word) for row in rows for cell in row for word in cell.split()), default=0)
    if longest <= 12:  # the narrowest column
        assert max(map(len, lines)) <= max(width, 2 + 3 * 12 + 2 * 2)
    found = "".join("".join(lines[1:]).split())
    wanted = "".join("".join("".join(row).split()) for row in rows)
    assert sorted(found) == sorted(wanted)


@given(WORDS)
def test_a_line_keeps_its_words(text: str) -> None:
    shown = Document((Line(text),)).text(20)
    assert shown.split() == [part for word in text.split() for part in _cut(word)]


def _cut(word: str) -> list[str]:
    return [word[i : i + 20] for i in range(0, len(word), 20)]
