"""Reports as plain text: headings, what is under them indented, no line too long, none with blanks at its end."""

from __future__ import annotations

from rich.console import Group
from rich.text import Text

from mpsolve.report.blocks import WIDTH
from mpsolve.report.layout import plain, section


def test_a_section_is_indented_and_wrapped() -> None:
    said = plain(Group(*section("Roots", Text("word " * 60))))
    heading, *body = said.splitlines()
    assert heading == "Roots"
    assert body[-1] == ""
    assert all(line.startswith("  word") for line in body[:-1])
    assert all(len(line) <= WIDTH and line == line.rstrip() for line in body)
    assert said.count("word") == 60
