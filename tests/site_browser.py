"""The built site in a real browser, page by page from its files.

`python tests/site_browser.py docs/_build` exits with 1 if a page has console errors, asks for anything outside its
folder, is wider than a phone, skips a heading, or has main text with too little contrast, or if the keyboard does not
reach search, menu and text. It exits with 0 and says so where no browser is installed.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.parse import unquote, urlparse

from browsers import NONE, browser

PHONE, DESK = {"width": 390, "height": 844}, {"width": 1280, "height": 900}
AA = 4.5
"""The contrast that WCAG 2 asks of text at level AA."""
ORDER = """() => { const all = [...document.querySelectorAll('main :is(h1,h2,h3,h4,h5,h6)')];
  const levels = all.map(h => +h.tagName[1]); const bad = [];
  if (levels.filter(n => n === 1).length !== 1) bad.push('not one h1');
  levels.forEach((n, k) => { if (k && n > levels[k - 1] + 1) bad.push(all[k].innerText.slice(0, 40)); });
  return bad; }"""
CONTRAST = """() => {
  const parts = c => (c.match(/[\\d.]+/g) || []).map(Number);
  const linear = x => x <= 0.03928 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
  const light = ([r, g, b]) => [r, g, b].map(x => linear(x / 255)).reduce(
    (sum, x, k) => sum + x * [0.2126, 0.7152, 0.0722][k], 0);
  const behind = e => { for (; e; e = e.parentElement) { const c = parts(getComputedStyle(e).backgroundColor);
    if (c.length === 3 || c[3] > 0.99) return c; } return [255, 255, 255]; };
  const least = {};
  for (const e of document.querySelectorAll('article :is(p, li, td, th, h1, h2, h3, h4, a, code, pre span)')) {
    if (!e.innerText || !e.innerText.trim() || e.closest('svg') || !e.offsetParent) continue;
    const [a, b] = [light(parts(getComputedStyle(e).color)), light(behind(e))];
    const ratio = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    const name = e.tagName.toLowerCase() + '.' + e.className;
    if (ratio < AA) least[name] = ratio.toFixed(2) + ' ' + e.innerText.slice(0, 30);
  }
  return Object.entries(least).map(([k, v]) => k + ' ' + v); }""".replace("AA", str(AA))
WIDER = """() => { const wide = document.documentElement.scrollWidth; if (wide <= innerWidth) return [];
  const out = [...document.querySelectorAll('main *')].filter(e => e.getBoundingClientRect().right > innerWidth + 1);
  return [wide + ' px: ' + out.slice(0, 3).map(e => e.tagName + '.' + e.className).join(', ')]; }"""
FOCUS = """() => { const e = document.activeElement;
  return [e.tagName, e.className, e.getAttribute('aria-label') || '', e.getAttribute('href') || ''].join(' '); }"""


@contextmanager
def opened() -> Iterator[Any]:
    """A browser without a window."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as play:
        chromium = play.chromium.launch(executable_path=browser(), args=["--no-sandbox"])
        yield chromium
        chromium.close()


def wrong(site: Path, chromium: Any, names: list[str] | None = None) -> dict[str, list[str]]:
    """By page: what is wrong with it."""
    site = site.resolve()
    pages = [site / name for name in names] if names else sorted(site.rglob("*.html"))
    tab = chromium.new_page(viewport=DESK)
    told: list[str] = []
    tab.on("console", lambda m: told.append(f"console: {m.text}") if m.type in ("error", "warning") else None)
    tab.on("pageerror", lambda e: told.append(f"error: {e}"))
    tab.on("request", lambda r: None if inside(r.url, site) else told.append(f"asks for {r.url}"))
    tab.on("requestfailed", lambda r: told.append(f"did not get {r.url}"))
    found: dict[str, list[str]] = {}
    for page in pages:
        told.clear()
        tab.goto(page.as_uri(), wait_until="load")
        said = [f"heading out of order: {one}" for one in tab.evaluate(ORDER)] if page.name != "genindex.html" else []
        for scheme in ("dark", "light"):
            tab.evaluate("scheme => { document.documentElement.dataset.theme = scheme }", scheme)
            said += [f"contrast, {scheme}: {one}" for one in tab.evaluate(CONTRAST)]
        tab.set_viewport_size(PHONE)
        said += [f"too wide at {PHONE['width']} px: {one}" for one in tab.evaluate(WIDER)]
        tab.set_viewport_size(DESK)
        if told or said:
            found[str(page.relative_to(site))] = [*told, *said]
    tab.close()
    return found


def inside(url: str, site: Path) -> bool:
    """Whether a request stays in the folder of the site, or is of the page itself."""
    parts = urlparse(url)
    return parts.scheme in ("data", "blob", "about") or (
        parts.scheme == "file" and Path(unquote(parts.path)).resolve().is_relative_to(site)
    )


def unreached(page: Path, chromium: Any) -> list[str]:
    """What Tab, Enter and Ctrl-K do not reach, in a wide window and on a phone."""
    bad = []
    for size in (DESK, PHONE):
        tab = chromium.new_page(viewport=size)
        tab.goto(page.as_uri(), wait_until="load")
        passed = set()
        for _ in range(60):
            tab.keyboard.press("Tab")
            passed.add(tab.evaluate(FOCUS))
        seen = " ".join(passed).lower()
        wanted = {"search": "search-button", "text": "#main-content"}
        wanted |= {"menu": "sidebar-toggle"} if size is PHONE else {"menu": "nav-link"}
        bad += [f"{name} at {size['width']} px" for name, mark in wanted.items() if mark not in seen]
        tab.keyboard.press("Control+k")
        tab.wait_for_timeout(300)
        if not tab.evaluate(FOCUS).startswith("INPUT"):
            bad.append(f"Ctrl-K at {size['width']} px")
        tab.close()
    return bad


def main(site: Path) -> int:
    if browser() is None:
        print(f"{NONE}: the site was not opened")
        return 0
    with opened() as chromium:
        found = wrong(site, chromium)
        found["index.html (keyboard)"] = unreached((site / "index.html").resolve(), chromium)
    for page, said in found.items():
        for one in said:
            print(f"{page}: {one}")
    return int(any(found.values()))


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
