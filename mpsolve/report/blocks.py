"""A report as blocks: lines, and sections of text or of columns; set in a width, with colour for a terminal.

Reports of `certify` are set here rather than by rich, which takes as long to load as a small proof.
"""

from __future__ import annotations

import shlex
import textwrap
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import field

from mpsolve.frozen import frozen

WIDTH = 88
_INDENT, _GAP = 2, 2
_NARROWEST = 12  # of a column that is wrapped
_CODES = {"bold": "1", "red": "31", "green": "32", "yellow": "33", "magenta": "35", "cyan": "36"}


@frozen
class Line:
    """One paragraph without indentation. style: words of `_CODES`."""

    text: str
    style: str = ""

    def set(self, width: int, colour: bool) -> Iterator[str]:
        for line in _wrapped(self.text, width):
            yield _styled(line, self.style) if colour else line


@frozen
class Columns:
    """Rows of cells. heading: a row with a rule under it, or empty; right: the columns that are set to the right."""

    rows: Sequence[Sequence[str]]
    heading: Sequence[str] = ()
    right: frozenset[int] = frozenset()

    def set(self, width: int) -> Iterator[str]:
        rows = [list(row) for row in self.rows]
        named = [list(self.heading)] if self.heading else []
        gap = _GAP + bool(named)
        widths = _widths(named + rows, width, gap)
        for j, row in enumerate(named + rows):
            yield from self._row(row, widths, gap)
            if named and not j:
                yield "─" * (sum(widths) + gap * (len(widths) - 1))

    def _row(self, row: list[str], widths: list[int], gap: int) -> Iterator[str]:
        cells = [_wrapped(cell, width) for cell, width in zip(row, widths, strict=True)]
        for k in range(max(map(len, cells))):
            parts = [
                (cell[k] if k < len(cell) else "").rjust(width)
                if i in self.right
                else (cell[k] if k < len(cell) else "").ljust(width)
                for i, (cell, width) in enumerate(zip(cells, widths, strict=True))
            ]
            yield (" " * gap).join(parts).rstrip()


@frozen
class Section:
    """A heading over an indented body: a text, whose own line ends are kept, or columns."""

    heading: str
    body: str | Columns
    style: str = "bold"

    def set(self, width: int, colour: bool) -> Iterator[str]:
        yield _styled(self.heading, self.style) if colour else self.heading
        inner = width - _INDENT
        lines = self.body.set(inner) if isinstance(self.body, Columns) else iter(_wrapped(self.body, inner))
        for line in lines:
            yield f"{' ' * _INDENT}{line}".rstrip()


@frozen
class Document:
    """Blocks with an empty line between them."""

    blocks: tuple[Line | Section, ...] = field(default_factory=tuple)

    def text(self, width: int = WIDTH, colour: bool = False) -> str:
        """The report in lines of at most `width` characters, as far as its words allow."""
        parts = ("\n".join(block.set(width, colour)) for block in self.blocks)
        return "\n\n".join(parts) + "\n"


def certificate_words(path: str) -> str:
    """Where the certificate is, and how to check it."""
    return f"{path}\nCheck it with: mpsolve verify {shlex.quote(path)}"


def _wrapped(text: str, width: int) -> list[str]:
    """The lines of a text, those that are too long at their spaces; their own indentation is kept."""
    lines: list[str] = []
    for line in text.splitlines() or [""]:
        start = line[: len(line) - len(line.lstrip())]
        lines += textwrap.wrap(
            line, max(width, 1), subsequent_indent=start, break_on_hyphens=False, drop_whitespace=True
        ) or [""]
    return lines


def _widths(rows: Iterable[Sequence[str]], width: int, gap: int) -> list[int]:
    """Of each column what its longest cell takes; the widest gives way where all together are too wide."""
    columns = list(zip(*rows, strict=True))
    widths = [max(map(len, column)) for column in columns]
    while sum(widths) + gap * (len(widths) - 1) > width and max(widths) > _NARROWEST:
        widths[max(range(len(widths)), key=lambda i: (widths[i], i))] -= 1
    return widths


def _styled(text: str, style: str) -> str:
    codes = ";".join(_CODES[word] for word in style.split())
    return f"\x1b[{codes}m{text}\x1b[0m" if codes else text
