"""The bound of growth: what it integrates is positive above it and not below, and no root grows faster."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle_general.named import TWO_LAYER, masses, problem
from oracle_general.package import as_problem

from mpsolve import Problem, tracks, vehicles
from mpsolve.certificate.solve import certify_problem
from mpsolve.passivity.growth import fastest_growth
from mpsolve.problem.reduced import Guide, reduce_problem


def on_beam(v: str, c: str = "0.1", number: int = 1, **more: Any) -> Problem:
    track = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c=c, **more)
    return Problem(track, vehicles.train(vehicles.Mass(40), number, "1.5"), v=v)


def least(guide: Guide, y: float) -> float:
    """In floats, over a grid of p and Ω: the least Re(σ/D) over its size, with D as the track gives it."""
    p, omega = np.meshgrid(np.linspace(-6, 6, 601), np.linspace(-6, 6, 601))
    s = y + 1j * omega
    D = sum(float(c) * (1j * p) ** i * s**j for (i, j), c in guide.D_rest.items())
    value = (s + 1j * float(guide.v) * p) / D
    return float((value.real / np.abs(value)).min())


@pytest.mark.parametrize(
    ("v", "c", "N"), [("0.5", "0.1", "0"), ("1.3", "1", "0"), ("1.3", "0", "0"), ("0.7", "0.5", "-1/2")]
)
def test_it_is_where_the_integrand_begins_to_be_positive(v: str, c: str, N: str) -> None:
    """A forged bound, a little lower, is no bound: there the integrand is below 0 somewhere."""
    guide = reduce_problem(on_beam(v, c, N=N)).guide
    y = float(fastest_growth(guide) or 0)
    assert y > 0
    assert least(guide, y * 1.001) > 0
    assert least(guide, y * 3) > 0
    assert least(guide, y * 0.97) < 0


@given(
    st.sampled_from(["0.6", "0.9", "1.2", "1.6"]),
    st.sampled_from(["0.05", "0.3", "1.5"]),
    st.lists(st.sampled_from(["2", "15", "90"]), min_size=1, max_size=4),
    st.sampled_from(["0.3", "1.1", "2.6"]),
)
@settings(max_examples=8, deadline=None, database=None, derandomize=True)
def test_no_root_grows_faster(v: str, c: str, weights: list[str], apart: str) -> None:
    row = [vehicles.Mass(m).at(k * Fraction(apart)) for k, m in enumerate(weights)]
    asked = Problem(tracks.EulerBernoulli(EI="0.25", m=1, k=1, c=c), row, v=v)
    bound = fastest_growth(reduce_problem(asked).guide)
    assert bound is not None
    unit = reduce_problem(asked).frequency_unit
    found = certify_problem(asked, region="unstable", digits=15, check=False)
    assert found.proved
    assert all(root.growth < float(bound * unit) for root in found.roots)


def test_other_tracks_have_none() -> None:
    two = as_problem(problem(TWO_LAYER, masses("500", "0"), "80"))
    assert fastest_growth(reduce_problem(two).guide) is None
    assert fastest_growth(reduce_problem(on_beam("0.5", eta="0.01")).guide) is None


def test_below_the_critical_velocity_an_undamped_beam_has_next_to_no_growth() -> None:
    bound = fastest_growth(reduce_problem(on_beam("0.9", "0")).guide)
    assert bound is not None
    assert bound < 1e-6
