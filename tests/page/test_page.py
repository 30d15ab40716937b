"""The page itself: whole without a network, its numbers those of the proof, its certificates valid."""

from __future__ import annotations

import base64
import html
import json
import math
import re
from html.parser import HTMLParser
from itertools import pairwise
from pathlib import Path

import pytest

from mpsolve import read_problem, verify
from mpsolve.page.page import page_html
from mpsolve.page.parts import Parts, gather


@pytest.fixture(scope="module")
def parts() -> Parts:
    source = read_problem("examples/rail_60e1.toml")
    return gather(source.given, source.title, digits=20, seconds=60, tell=lambda *_: None)


@pytest.fixture(scope="module")
def page(parts: Parts) -> str:
    return page_html(parts, "rail")


def test_it_needs_no_network(page: str) -> None:
    assert not re.search(r"""(?:src|href)=["'](?!data:|#)""", page)
    assert "<script src" not in page
    assert "url(http" not in page


def test_headings_are_in_order(page: str) -> None:
    levels = [int(x) for x in re.findall(r"<h([1-6])", page)]
    assert levels[0] == 1
    assert all(b <= a + 1 for a, b in pairwise(levels))


def test_every_digit_is_that_of_the_ball(parts: Parts, page: str) -> None:
    right = sorted((r for r in parts.spectrum.roots if not r.q.real < 0), key=lambda r: float(r.q.real.mid()))
    for k, root in enumerate(right, 1):
        for part, ball in (("re", root.q.real), ("im", root.q.imag)):
            shown = re.search(rf'id="q{k}-{part}">([^<]*)<', page)
            assert shown is not None
            value = shown[1].replace("±", "").replace("−", "-")
            assert abs(float(value) - float(ball.mid())) <= 1e-14 * abs(float(ball.mid())) + 1e-16


def test_damping_is_that_of_an_oscillator_which_halves_in_this_time(page: str) -> None:
    """Of e^(−δt) cos ωt: δ/√(δ² + ω²), from the frequency and growth of the table."""
    cells = re.findall(r'<td class="number">([^<]*)</td>' * 3, page)
    assert len(cells) == 2
    for frequency, growth, damping in cells:
        f, d = float(frequency), -float(growth.replace("−", "-"))
        assert float(damping) == pytest.approx(100 * d / math.hypot(d, 2 * math.pi * f), rel=6e-3)


def test_limits_follow_the_verdict(page: str) -> None:
    places = [page.index(f'<section id="{name}"') for name in ("verdict", "limits", "model", "vibrations")]
    assert places == sorted(places)


def test_certificates_inside_are_valid(page: str, tmp_path: Path) -> None:
    links = re.findall(r'download="([^"]*)" href="data:application/json;base64,([^"]*)"', page)
    assert links
    for name, content in links:
        path = tmp_path / name
        path.write_bytes(base64.b64decode(content))
        assert verify(path).valid


def test_the_numbers_stand_in_it_for_programs(parts: Parts, page: str) -> None:
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.S)
    assert found is not None
    data = json.loads(found[1])
    assert data["spectrum"]["count"] == parts.spectrum.count
    assert [card["question"] for card in data["cards"]]


def test_names_are_unique_and_text_is_escaped(parts: Parts) -> None:
    from dataclasses import replace

    page = page_html(replace(parts, title='<b>&"'), "x")
    assert "<b>&" not in page
    names: list[str] = []

    class Reader(HTMLParser):
        def handle_starttag(self, _tag: str, attributes: list[tuple[str, str | None]]) -> None:
            names.extend(str(value) for key, value in attributes if key == "id")

    Reader().feed(page)
    assert len(names) == len(set(names))


def test_what_looks_like_a_mistake_stands_on_the_first_screen() -> None:
    """km/h taken for m/s: the sentence that says so is above the details."""
    problem = read_problem("examples/two_layer_bogie.toml").problem.changed("v", 250)
    said = page_html(gather(problem, "", digits=15, seconds=0.01, tell=lambda *_: None), "x")
    first = said[: said.index('<section id="model"')]
    assert "Check the input: v is 250 m/s, which is 900 km/h" in html.unescape(first)
    assert first.index("Check the input") < first.index('<p class="word">')
