"""How reports are laid out for a terminal: sections, columns, plain text of a fixed width."""

from __future__ import annotations

import io
from typing import Any

from rich.console import Console, Group
from rich.padding import Padding
from rich.text import Text

from mpsolve.report.blocks import WIDTH


def plain(report: Group) -> str:
    """A report as plain text of `WIDTH` columns."""
    stream = io.StringIO()
    console = Console(file=stream, width=WIDTH, force_terminal=False, color_system=None, legacy_windows=False)
    console.print(report, soft_wrap=False)
    return "\n".join(line.rstrip() for line in stream.getvalue().splitlines()) + "\n"


def section(heading: str, body: Any) -> list[Any]:
    """A heading, the body indented, and an empty line."""
    return [Text(heading, style="bold"), Padding(body, (0, 0, 0, 2)), Text("")]
