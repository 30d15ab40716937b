"""Figures: what they show is where the numbers say, in colour, in grey, on a page, in a file."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from figure_parts import MOTIONS, SPECTRUM

from mpsolve.errors import CertificateError, InputError
from mpsolve.report import figures_motion, figures_plane
from mpsolve.report.figures import GREY, figure_of, inline_svg, save_figure

SVG = "{http://www.w3.org/2000/svg}"
HREF = "{http://www.w3.org/1999/xlink}href"


def read_back(root: ET.Element, name: str, gid: str) -> list[tuple[float, float]]:
    """The points of a line or mark in the SVG, from its coordinates and the limits of its axes."""
    by_id = {element.get("id"): element for element in root.iter()}
    axes = by_id[f"{name}-axes"]
    frame = axes.find(f"{SVG}g/{SVG}path")
    assert frame is not None
    corners = np.array(re.findall(r"[ML] (\S+) (\S+)", frame.attrib["d"]), float)
    (left, top), (right, bottom) = corners.min(0), corners.max(0)
    x0, x1, y0, y1 = (float(axes.attrib[f"data-{key}"]) for key in ("x0", "x1", "y0", "y1"))
    group = by_id[f"{name}-{gid}"]
    pixels = [(float(u.attrib["x"]), float(u.attrib["y"])) for u in group.iter(f"{SVG}use")]
    if not pixels:
        path = group.find(f"{SVG}path")
        assert path is not None
        pixels = [(float(a), float(b)) for a, b in re.findall(r"[ML] (\S+) (\S+)", path.attrib["d"])]
    return [
        (x0 + (x - left) / (right - left) * (x1 - x0), y1 + (y - top) / (bottom - top) * (y0 - y1)) for x, y in pixels
    ]


DRAWN: dict[str, Callable[[Any, Any], Any]] = {
    "plane": lambda ax, _motion: figures_plane.q_plane(SPECTRUM, ax, GREY),
    "zoom": lambda ax, _motion: figures_plane.roots_zoom(MOTIONS, True, ax, GREY),
    "displacement": lambda ax, motion: figures_motion.displacements(motion, ax, None, GREY),
    "contact": lambda ax, motion: figures_motion.contact_forces(motion, ax, None, GREY),
}


@pytest.mark.parametrize("name", DRAWN)
def test_every_figure_returns_its_axes_and_can_be_grey(name: str, motion: Any, tmp_path: Path) -> None:
    returned = []

    def draw(ax: Any) -> Any:
        returned.append((ax, DRAWN[name](ax, motion)))
        return ax

    text = save_figure(draw, tmp_path / "a.svg").read_text("utf-8")
    assert all(given is back for given, back in returned)
    colours = set(re.findall(r"#([0-9a-f]{6})\b", text))
    assert colours
    for colour in colours:
        assert colour[:2] == colour[2:4] == colour[4:], f"{name} has the colour {colour}"


def test_a_page_can_hold_several_figures_and_their_places_can_be_read_back(motion: Any) -> None:
    pictures = {
        "plane": figure_of(lambda ax: figures_plane.q_plane(SPECTRUM, ax)),
        "w": figure_of(lambda ax: figures_motion.displacements(motion, ax)),
    }
    roots = {name: ET.fromstring(inline_svg(one, name, "A & B", "1 < 2")) for name, one in pictures.items()}
    ids = [element.get("id") for root in roots.values() for element in root.iter() if element.get("id")]
    assert len(ids) == len(set(ids))
    for name, root in roots.items():
        assert (root.get("role"), root.get("aria-labelledby")) == ("img", f"{name}-title")
        assert root.findtext(f"{SVG}title") == "A & B"
        assert root.findtext(f"{SVG}desc") == "1 < 2"
        used = {e.attrib[HREF] for e in root.iter() if HREF in e.attrib}
        used |= {found for e in root.iter() for v in e.attrib.values() for found in re.findall(r"url\((#[^)]*)\)", v)}
        assert used
        assert {one[1:] for one in used} <= set(ids)
        assert not root.findall(f".//{SVG}style")
    for k, root in enumerate(SPECTRUM.roots, 1):
        ((x, y),) = read_back(roots["plane"], "plane", f"root-{k}")
        assert abs(complex(x, y) - complex(root.q.mid())) < 1e-5
    points = read_back(roots["w"], "w", "w-1")
    assert len(points) > 100
    shown = [np.interp(x, motion.tau, motion.w[0]) for x, _ in points]
    assert np.allclose(shown, [y for _, y in points], atol=2e-3 * np.ptp(motion.w))


@pytest.mark.parametrize("kind", ["svg", "pdf", "png"])
def test_files_are_the_same_each_time(kind: str, tmp_path: Path) -> None:
    def draw(ax: Any) -> Any:
        return figures_plane.roots_zoom(MOTIONS, True, ax)

    first, second = (save_figure(draw, tmp_path / f"{name}.{kind}").read_bytes() for name in "ab")
    assert first == second
    assert len(first) > 2000


def test_names_that_cannot_be_written(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"does not end in \.svg, \.pdf, \.png"):
        save_figure(lambda ax: ax, tmp_path / "a.gif")
    with pytest.raises(CertificateError, match="cannot be written"):
        save_figure(lambda ax: ax, tmp_path / "none" / "a.svg")


def test_the_user_s_settings_change_nothing(tmp_path: Path) -> None:
    import matplotlib as mpl

    def draw(ax: Any) -> Any:
        return figures_plane.q_plane(SPECTRUM, ax)

    plain = save_figure(draw, tmp_path / "a.svg").read_bytes()
    with mpl.rc_context({"font.size": 20, "lines.linewidth": 9, "axes.facecolor": "red"}):
        assert save_figure(draw, tmp_path / "b.svg").read_bytes() == plain
        assert mpl.rcParams["font.size"] == 20
