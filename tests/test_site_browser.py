"""What the walk through the site in a browser finds is found: each fault in a page of its own."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from browsers import NONE, browser
from site_browser import inside, opened, unreached, wrong

pytest.importorskip("playwright.sync_api", reason="playwright, which drives a browser, is not installed")
pytestmark = pytest.mark.skipif(browser() is None, reason=NONE)

GOOD = "<main><article><h1>One</h1><h2>Two</h2><p>Some words.</p></article></main>"
FAULTS = {
    "console": "<script>console.error('oh')</script>",
    "error": "<script>nothing()</script>",
    "asks for": '<img src="https://a.invalid/x.png" alt="">',
    "did not get": '<img src="none.png" alt="">',
    "heading out of order": "<main><h4>Four</h4></main>",
    "contrast": '<article><p style="color: #aaa">pale</p></article>',
    "too wide": '<main><div style="width: 900px">wide</div></main>',
}


@pytest.fixture(scope="module")
def chromium() -> Iterator[Any]:
    with opened() as one:
        yield one


def page(body: str) -> str:
    return f'<!doctype html><meta charset="utf-8"><meta name="viewport" content="width=device-width">{body}'


def test_each_fault_is_found(tmp_path: Path, chromium: Any) -> None:
    (tmp_path / "good.html").write_text(page(GOOD), "utf-8")
    for number, body in enumerate(FAULTS.values()):
        (tmp_path / f"{number}.html").write_text(page(GOOD + body), "utf-8")
    found = wrong(tmp_path, chromium)
    assert "good.html" not in found
    for number, name in enumerate(FAULTS):
        assert any(said.startswith(name) for said in found[f"{number}.html"]), name


def test_a_page_without_search_and_menu_is_found(tmp_path: Path, chromium: Any) -> None:
    (tmp_path / "index.html").write_text(page(GOOD), "utf-8")
    assert {one.split(" at ")[0] for one in unreached(tmp_path / "index.html", chromium)} == {
        "search", "text", "menu", "Ctrl-K",
    }  # fmt: skip


def test_what_is_inside(tmp_path: Path) -> None:
    assert inside((tmp_path / "a b.html").as_uri(), tmp_path)
    assert inside("data:image/png;base64,", tmp_path)
    assert not inside((tmp_path.parent / "other.html").as_uri(), tmp_path)
    assert not inside("https://a.invalid/", tmp_path)
