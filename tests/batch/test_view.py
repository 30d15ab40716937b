"""What the explorer computes in floats agrees with what is proved."""

from __future__ import annotations

import numpy as np
import pytest

from mpsolve import Problem, certify, read_problem, tracks, vehicles
from mpsolve.batch.view import Window, fitting_window, look
from mpsolve.tracks.waveguide import moving

BOGIE = read_problem("examples/two_layer_bogie.toml").problem


@pytest.mark.parametrize("v", ["100", "1400"])
def test_the_roots_are_those_that_are_proved(v: str) -> None:
    problem = BOGIE.changed("v", v)
    view = look(problem, Window(1000.0, 60.0, 100.0))
    proved = [complex(root.q.mid()) for root in certify(problem, region=("below", view.height), digits=15).roots]
    inside = [q for q in proved if abs(q.real) < 1000]
    assert len(inside) == len(view.roots)
    for q in inside:
        assert np.abs(view.roots - q).min() < 1e-8 * abs(q)
    assert view.growing == sum(q.imag < 0 for q in inside)


def test_cuts_are_where_a_p_root_is_real() -> None:
    D = moving(BOGIE.track.waveguide.dispersion, BOGIE.v)
    degree = max(i for i, _ in D)
    for cut in look(BOGIE).cuts:
        for q in cut[::40]:
            row = [sum(float(c) * (1j * q) ** j for (i, j), c in D.items() if i == k) for k in range(degree, -1, -1)]
            P = np.roots(row)
            assert (np.abs(P.real) / np.abs(P)).min() < 1e-5


def test_neighbours_start_from_each_other() -> None:
    first = look(BOGIE)
    again = look(BOGIE.changed("v", "101"), first.window, first.roots)
    assert len(again.roots) == len(first.roots)


def test_what_cannot_be_is_said() -> None:
    buckled = Problem(tracks.EulerBernoulli(EI=1, m=1, k=1, c="0.1", N=10), vehicles.Mass(1), v=1)
    view = look(buckled)
    assert "track" in view.refused
    assert not len(view.roots)


def test_the_window_shows_the_lowest_cut() -> None:
    window = fitting_window(BOGIE)
    assert window.height > 126
    assert window.zoomed(0.5).width == window.width / 2
