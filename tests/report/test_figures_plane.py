"""The q-plane shows roots, branch points and cuts where the numbers say."""

from __future__ import annotations

import numpy as np
import pytest
from figure_parts import MOTIONS, SPECTRUM, placed

from mpsolve import Case, certify
from mpsolve.report import figures_plane
from mpsolve.report.figures import figure_of


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
