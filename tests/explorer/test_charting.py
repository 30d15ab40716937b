"""A chart counts what grows, and marks the present problem and proved ones where they belong."""

from __future__ import annotations

import time
from fractions import Fraction

import numpy as np
import pytest

from mpsolve import InputError, Problem, certify, tracks, vehicles
from mpsolve.explorer.charting import ProvedPoint, chart_of
from mpsolve.explorer.session import Session

TRACK = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
PAIR = Problem(TRACK, vehicles.train(vehicles.Mass(10000), 2, "3.4"), v=150)


def test_counts_are_those_that_are_proved() -> None:
    chart = chart_of(PAIR, "v", "gap[0]")
    over = chart.found.over
    rng = np.random.default_rng(5)
    for _ in range(6):
        i, j = rng.integers(41), rng.integers(25)
        problem = PAIR.changed("v", float(over["v"][i, 0])).changed("gap[0]", float(over["gap[0]"][0, j]))
        assert certify(problem, region="unstable", digits=15, check=False).unstable == chart.found.count[i, j]


def test_points_stand_where_they_belong() -> None:
    chart = chart_of(PAIR, "v", "track.k")
    other = PAIR.changed("v", 200)
    away = PAIR.changed("track.c", 100)
    picture = chart.picture(PAIR, (ProvedPoint(other, False), ProvedPoint(away, True)))
    assert "proved: unstable" in picture
    assert "proved: stable" not in picture
    assert "this case" in picture
    assert "this case" not in chart.picture(away)


def test_axes_that_cannot_be() -> None:
    with pytest.raises(InputError, match="both axes"):
        chart_of(PAIR, "v", "v")
    with pytest.raises(InputError, match="is 0 now"):
        chart_of(PAIR, "v", "track.N")


def test_a_session_keeps_its_proofs() -> None:
    session = Session.of(PAIR)
    session.draw_chart("v", "track.k")
    proving = session.start_proof(("v", "track.k"))
    while proving.running:
        proving.poll()
        time.sleep(0.02)
    assert session.note_proof()
    assert not session.note_proof()
    assert "proved: stable" in session.chart_picture()
    assert len(session.proved) == 1
    assert "proved: stable all over" in session.chart_picture()


def test_a_proved_region_is_outlined_on_the_chart_of_its_parameters_only() -> None:
    region = {"v": (Fraction(100), Fraction(180)), "track.k": (Fraction(9 * 10**5), Fraction(11 * 10**5))}
    point = ProvedPoint(PAIR, True, region)
    outline = "proved: stable all over"
    assert outline in chart_of(PAIR, "v", "track.k").picture(PAIR, (point,))
    assert outline not in chart_of(PAIR, "v", "track.c").picture(PAIR, (point,))
    away = ProvedPoint(PAIR.changed("track.c", 100), True, region)
    assert outline not in chart_of(PAIR, "v", "track.k").picture(PAIR, (away,))
