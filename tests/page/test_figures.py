"""The pictures of a page: lines follow roots, and what is missing is left out."""

from __future__ import annotations

import re

import numpy as np
import pytest

from mpsolve import read_problem
from mpsolve.page import figures
from mpsolve.page.charts import chart
from mpsolve.page.parts import Parts, gather, searched
from mpsolve.pictures.axes import BOTTOM, HIGH, LEFT, RIGHT, TOP, WIDE
from mpsolve.report.vibration import once as vibrations


@pytest.fixture(scope="module")
def parts() -> Parts:
    source = read_problem("examples/two_layer_bogie.toml")
    return gather(source.given, source.title, digits=15, seconds=60, tell=lambda *_: None, prove_chart=False)


def test_roots_are_followed_past_each_other() -> None:
    x = np.linspace(0, 1, 50)
    a, b = 10 + 5 * x + 0.5j, 12 - 1j * x
    rows = np.array([sorted(pair, key=lambda q: q.real) for pair in zip(a, b, strict=True)])
    rows[20, 1] = complex(np.nan, np.nan)
    lines = figures.followed(rows)
    assert len(lines) >= 2
    for line in lines:
        good = np.isfinite(line)
        assert min(np.nanmax(np.abs(line[good] - truth[good])) for truth in (a, b)) < 1e-12
        assert np.isnan(line.imag[~good]).all()


def test_every_picture_is_there(parts: Parts) -> None:
    shape = figures.shape(parts)
    assert shape is not None
    assert {name for name, _, _ in shape[1]} == set(parts.problem.pencil.names)
    names = [one.name for one in (*figures.lines(parts), *figures.motion(parts), figures.plane(parts))]
    assert names == ["growth", "frequency", "deflection", "force", "plane"]
    assert chart(parts) is not None


def test_numbers_on_the_lines_are_those_of_the_roots(parts: Parts) -> None:
    growth = figures.lines(parts)[0].svg
    assert "this case" in growth
    v, hertz = np.asarray(parts.lines.value.over["v"]), [root.frequency for root in vibrations(parts.spectrum)]
    tracks = figures.followed(np.where(parts.lines.value.roots.real >= -1e-9, parts.lines.value.roots, np.nan))
    at = int(np.abs(v - float(parts.problem.v)).argmin())
    numbers = figures._numbers(parts, v, tracks)
    named = {
        n: track[at].real / 2 / np.pi for n, track in zip(numbers, tracks, strict=True) if np.isfinite(track[at])
    }
    for k, f in enumerate(hertz, 1):
        assert named[str(k)] == pytest.approx(float(f), rel=0.05)
    assert len(set(numbers)) == len(numbers)
    assert growth.count("<polyline") >= 2


def test_captions_say_where_lines_end_and_where_the_cuts_are(parts: Parts) -> None:
    plane, growth = figures.plane(parts), figures.lines(parts)[0]
    assert plane is not None
    assert "higher up, out of this picture" in plane.caption
    cuts = re.findall(r'class="cut" points="([^"]*)"', plane.svg)
    points = [tuple(map(float, point.split(","))) for one in cuts for point in one.split()]
    assert not [(x, y) for x, y in points if LEFT < x < WIDE - RIGHT and TOP < y < HIGH - BOTTOM]
    height = float(searched(parts.problem.track))
    q = parts.lines.value.roots
    assert np.nanmax(q.imag) <= height * (1 + 1e-9)
    assert f"decays faster than {height:.4g} 1/s" in growth.caption
