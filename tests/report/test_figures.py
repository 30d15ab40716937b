"""Figures: what they show is where the numbers say, in colour, in grey, on a page, in a file."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from mpsolve import Case, PhysicalCase, certify
from mpsolve.errors import CertificateError, InputError
from mpsolve.report import figures_motion, figures_plane
from mpsolve.report.figures import GREY, figure_of, inline_svg, save_figure
from mpsolve.report.vibration import vibrations
from mpsolve.vibration.of_case import motion_of_case as response

CASE = Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5"))
SPECTRUM = certify(CASE)
MOTIONS = vibrations(SPECTRUM)
SVG = "{http://www.w3.org/2000/svg}"
HREF = "{http://www.w3.org/1999/xlink}href"


@pytest.fixture(scope="module")
def motion() -> Any:
    return response(CASE, tau=np.linspace(0, 200, 801))


def placed(ax: Any, gid: str) -> tuple[float, float]:
    """Where the mark of this id stands, in the units of the axes."""
    (line,) = [line for line in ax.lines if line.get_gid() == gid]
    (x,), (y,) = line.get_data()
    return float(x), float(y)


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


def test_the_plane_shows_roots_branch_points_and_halves() -> None:
    figure = figure_of(lambda ax: figures_plane.q_plane(SPECTRUM, ax))
    (ax,) = figure.axes
    for k, root in enumerate(SPECTRUM.roots, 1):
        x, y = placed(ax, f"root-{k}")
        assert abs(complex(x, y) - complex(root.q.mid())) < 1e-15
        (line,) = [line for line in ax.lines if line.get_gid() == f"root-{k}"]
        assert line.get_marker() == ("D" if y < 0 else "o")
    # q_lm is the least of ½√(p⁴ − 4Np² + 4β²) − αp over real p; here N = 0
    p = np.linspace(0, 4, 400_001)
    least = (np.sqrt(p**4 + 4 * (1 - 0.05**2)) / 2 - 0.67 * p).min()
    for side, name in ((-1, "left"), (1, "right")):
        x, y = placed(ax, f"branch-point-{name}")
        assert (abs(side * x - least) < 1e-9, y) == (True, 0.05)
    low, high = ax.get_ylim()
    assert low < min(float(root.q.imag) for root in SPECTRUM.roots) < 0.05 < high


@pytest.mark.parametrize(("alpha", "said"), [("0.67", ["−", ""]), ("0.99", ["±"])])
def test_branch_points_that_are_close_share_a_label(alpha: str, said: list[str]) -> None:
    close = certify(Case(alpha=alpha, eta_b="0.1", eta_m=(70, 70), positions=(0, "1.2")))
    figure = figure_of(lambda ax: figures_plane.q_plane(close, ax))
    labels = [text.get_text() for text in figure.axes[0].texts if "q_{lm}" in text.get_text()]
    assert labels == [f"{sign}$q_{{lm}}$ + i$η_b$" for sign in said]


def test_joined_cuts_have_no_branch_point() -> None:
    spectrum = certify(Case(alpha="1.2", eta_b="0.05", eta_m=10))
    (ax,) = figure_of(lambda ax: figures_plane.q_plane(spectrum, ax)).axes
    names = {line.get_gid() for line in ax.lines}
    assert {"cut-left", "cut-right"} < names
    assert "branch-point-left" not in names


def test_the_zoom_tells_frequency_and_time() -> None:
    (ax,) = figure_of(lambda ax: figures_plane.roots_zoom(MOTIONS, False, ax)).axes
    texts = [text.get_text() for text in ax.texts]
    growing = [motion for motion in MOTIONS if motion.root.q.imag < 0]
    assert len(texts) == len(MOTIONS) == 2
    assert len([text for text in texts if "doubles" in text]) == len(growing) == 1
    period = 2 * np.pi / float(growing[0].root.q.real)
    assert any(text.startswith(f"{1 / period:.4g}/τ\ndoubles") for text in texts)


def test_the_envelope_bounds_the_harmonic_part_and_is_reached(motion: Any) -> None:
    bound = motion.envelope
    assert np.all(abs(motion.harmonic) <= bound * (1 + 1e-12))
    for row, edge in zip(motion.harmonic, bound, strict=True):
        assert np.max(abs(row) / edge) > 0.99
    ax: Any = figure_of(lambda ax: figures_motion.displacements(motion, ax)).axes[0]
    (line,) = [one for one in ax.lines if one.get_gid() == "w-2"]
    assert np.array_equal(line.get_ydata(), motion.w[1])
    assert ax.yaxis_inverted()


def test_displacements_in_millimetres_are_those_of_a_load_at_rest() -> None:
    """A constant force P at rest on a Winkler beam sinks by Pχ/(2k), with χ⁴ = k/(4EI)."""
    from mpsolve.vehicles.load import Load

    beam = PhysicalCase(EI="6.4e6", m=60, k="1e6", v=0, c=7750, masses=[(100, 0)])
    found = response(beam, [Load(constant=50_000)], tau=[0, 400])
    ax: Any = figure_of(lambda ax: figures_motion.displacements(found, ax, figures_motion.Scale.of(beam))).axes[0]
    (line,) = [one for one in ax.lines if one.get_gid() == "w-1"]
    chi = (1e6 / (4 * 6.4e6)) ** 0.25
    assert abs(line.get_ydata()[-1] - 1e3 * 50_000 * chi / 2e6) < 1e-6
    assert abs(line.get_xdata()[-1] - 400 / np.sqrt(1e6 / 60)) < 1e-9


def test_contact_forces_and_where_they_vanish(motion: Any) -> None:
    ax: Any = figure_of(lambda ax: figures_motion.contact_forces(motion, ax)).axes[0]
    for k, loss in enumerate(motion.contact_loss, 1):
        (line,) = [one for one in ax.lines if one.get_gid() == f"force-{k}"]
        below = 1 + np.flatnonzero(line.get_ydata()[1:] <= 0)  # at τ = 0 the mass alone takes the load
        assert (loss is None) == (len(below) == 0)
        if loss is not None:
            x, y = placed(ax, f"loss-{k}")
            assert motion.tau[below[0] - 1] <= x <= motion.tau[below[0]]
            assert y == 0


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
