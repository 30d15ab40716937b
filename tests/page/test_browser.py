"""The page in a real browser: no message on its console, nothing wider than a phone, readable in light and dark."""

from __future__ import annotations

import re
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from mpsolve.page.page import page_html
from mpsolve.page.parts import gather
from mpsolve.presets.written import input_file
from mpsolve.problem.inputfile import read_source
from tests.browsers import NONE, browser

driver = pytest.importorskip("playwright.sync_api", reason="playwright, which drives a browser, is not installed")
pytestmark = pytest.mark.skipif(browser() is None, reason=NONE)

CONTRAST = """() => {
  const light = c => { const v = c.map(x => x / 255).map(x => x <= .03928 ? x / 12.92 : ((x + .055) / 1.055) ** 2.4);
    return .2126 * v[0] + .7152 * v[1] + .0722 * v[2]; };
  const parse = s => s.match(/[\\d.]+/g).map(Number);
  const ground = e => { for (; e; e = e.parentElement) { const c = parse(getComputedStyle(e).backgroundColor);
    if (c.length < 4 || c[3] > .99) return c.slice(0, 3); } return [255, 255, 255]; };
  const bad = [];
  for (const e of document.querySelectorAll('p, h1, h2, h3, td, th, li, figcaption, a, dd, dt, svg text, summary')) {
    if (!e.textContent.trim()) continue;
    const style = getComputedStyle(e);
    const ink = parse(e.closest('svg') ? style.fill : style.color).slice(0, 3);
    const [a, b] = [light(ink), light(ground(e.closest('svg') ? e.closest('svg').parentElement : e))];
    const ratio = (Math.max(a, b) + .05) / (Math.min(a, b) + .05);
    if (ratio < 4.5) bad.push([e.textContent.slice(0, 40), ratio]);
  }
  return bad; }"""
MARKS = """() => {
  const light = c => { const v = c.map(x => x / 255).map(x => x <= .03928 ? x / 12.92 : ((x + .055) / 1.055) ** 2.4);
    return .2126 * v[0] + .7152 * v[1] + .0722 * v[2]; };
  const parse = s => s.match(/[\\d.]+/g).map(Number).slice(0, 3);
  const seen = {};
  for (const kind of ['.curve', '.curve.two', '.curve.three', '.curve.four', '.cut', '.root', '.root.unstable',
                      '.hatch', '.border', '.sure', '.here', '.ring', '.link', '.rail', '.frame', '.tick', '.body',
                      '.solid'])
    for (const e of document.querySelectorAll('svg ' + kind)) {
      const style = getComputedStyle(e);
      const ground = light(parse(getComputedStyle(e.closest('section')).backgroundColor));
      const drawn = [style.stroke, style.fill].filter(c => c.startsWith('rgb')).map(c => light(parse(c)));
      const ratio = Math.max(...drawn.map(c => (Math.max(c, ground) + .05) / (Math.min(c, ground) + .05)));
      seen[kind] = Math.min(seen[kind] ?? 99, ratio);
    }
  return seen; }"""
SMALL = """() => [...document.querySelectorAll('svg text')]
  .map(e => [e.textContent, e.getBoundingClientRect().height])
  .filter(([text, high]) => text && high < 9)"""
OVERLAPS = """() => { const bad = [];
  for (const svg of document.querySelectorAll('svg')) {
    const boxes = [...svg.querySelectorAll('text')].map(
      e => [e.textContent, e.getBoundingClientRect()]);
    boxes.forEach(([a, p], i) => boxes.slice(i + 1).forEach(([b, q]) => {
      const w = Math.min(p.right, q.right) - Math.max(p.left, q.left);
      const h = Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top);
      if (w > 2 && h > 4) bad.push([svg.getAttribute('aria-label'), a, b]); })); }
  return bad; }"""


HEADINGS = """() => [...document.querySelectorAll('h1, h2, h3, h4')].map(e => Number(e.tagName[1]))"""
FAST = re.sub(r"(?m)^v = .*", 'v = "3000 km/h"', Path("examples/two_layer_bogie.toml").read_text("utf-8"))
KINDS = {
    "layers": (lambda: Path("examples/two_layer_bogie.toml").read_text("utf-8"), 12.0),
    "ratios, unstable": (lambda: Path("examples/dimensionless.toml").read_text("utf-8"), 6.0),
    "beam in SI": (lambda: Path("examples/rail_60e1.toml").read_text("utf-8"), 6.0),
    "layers, unstable": (lambda: FAST, 12.0),
    "coach on a slab, with sources": (lambda: input_file("slab", "stem"), 20.0),
    "two pantographs, no motion": (lambda: input_file("contact-wire"), 6.0),
    "a train, hardly in time": (lambda: Path("examples/train_8_coaches.toml").read_text("utf-8"), 3.0),
}
QUICK = ("layers", "ratios, unstable")


@pytest.fixture(
    scope="module", params=[name if name in QUICK else pytest.param(name, marks=pytest.mark.slow) for name in KINDS]
)
def address(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> str:
    """A page of every kind."""
    make, seconds = KINDS[request.param]
    folder: Path = tmp_path_factory.mktemp("page")
    (folder / "file.toml").write_text(make(), "utf-8")
    source = read_source(folder / "file.toml")
    parts = gather(
        source.given, source.title, digits=15, seconds=seconds, tell=lambda *_: None, sources=source.sources
    )
    path = folder / "page.html"
    path.write_text(page_html(parts, "page"), encoding="utf-8")
    return path.as_uri()


@pytest.fixture(scope="module")
def chromium() -> Iterator[Any]:
    with driver.sync_playwright() as play:
        opened = play.chromium.launch(executable_path=browser(), args=["--no-sandbox"])
        yield opened
        opened.close()


@pytest.fixture(params=["light", "dark"])
def page(request: pytest.FixtureRequest, chromium: Any, address: str) -> Iterator[Any]:
    tab = chromium.new_page(color_scheme=request.param)
    said: list[str] = []
    tab.on("console", lambda message: said.append(message.text))
    tab.on("pageerror", lambda error: said.append(str(error)))
    tab.goto(address)
    yield tab
    assert said == []
    tab.close()


def test_every_text_can_be_read(page: Any) -> None:
    assert page.evaluate(CONTRAST) == []


def test_every_mark_stands_out_from_its_ground(page: Any) -> None:
    """3:1 for lines, hatching and marks, in light and in dark."""
    seen = page.evaluate(MARKS)
    drawn = {"model": ".rail", "growth": ".curve", "shape": ".body"}
    assert {kind for name, kind in drawn.items() if page.locator(f"#figure-{name}").count()} <= seen.keys()
    assert {kind: ratio for kind, ratio in seen.items() if ratio < 3} == {}


def test_nothing_is_wider_than_a_phone(page: Any) -> None:
    page.set_viewport_size({"width": 390, "height": 844})
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    assert page.evaluate(SMALL) == []


def test_headings_are_in_order(page: Any) -> None:
    levels = page.evaluate(HEADINGS)
    assert levels[0] == 1
    assert levels.count(1) == 1
    assert all(b <= a + 1 for a, b in pairwise(levels))


def test_no_label_lies_over_another(page: Any) -> None:
    for width in (1200, 390):
        page.set_viewport_size({"width": width, "height": 900})
        assert page.evaluate(OVERLAPS) == []


def test_the_keyboard_reaches_links_tables_and_details(page: Any) -> None:
    reached = set()
    for _ in range(60):
        page.keyboard.press("Tab")
        reached.add(
            page.evaluate("document.activeElement.tagName + (document.activeElement.getAttribute('href') || '')")
        )
    assert {"A#verdict", "A#proof", "DIV", "SUMMARY"} <= reached
