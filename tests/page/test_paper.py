"""On paper: pages are numbered, certificates attached, colours written into the drawings."""

from __future__ import annotations

from pathlib import Path

import pytest

from mpsolve import InputError, read_problem
from mpsolve.page.paper import require_printer, save_pdf, with_colours
from mpsolve.page.parts import gather


def test_colours_stand_in_each_drawing() -> None:
    page = with_colours('<svg class="picture" viewBox="0 0 1 1"><animate x="1"/></svg>')
    assert "<style>" in page
    assert "var(" not in page
    assert "<animate" not in page


def test_a_pdf_with_its_certificates(tmp_path: Path) -> None:
    try:
        require_printer()
    except InputError as error:
        pytest.skip(f"nothing prints here: {error}")
    source = read_problem("examples/rail_60e1.toml")
    parts = gather(source.given, source.title, digits=15, seconds=5, tell=lambda *_: None)
    content = save_pdf(parts, "rail", tmp_path / "rail.pdf").read_bytes()
    assert content.startswith(b"%PDF-")
    assert b"EmbeddedFile" in content
