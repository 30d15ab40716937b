"""Covers of strips of velocity: nothing is left below the loss, something is above it."""

from __future__ import annotations

from fractions import Fraction

import pytest
from passive_subjects import RAIL

from mpsolve import tracks
from mpsolve.errors import EffortError
from mpsolve.passivity.cover import Moving, Strip, cover
from mpsolve.problem.reduced import track_guide
from mpsolve.proof.effort import Effort

BEAM = Moving(track_guide(tracks.EulerBernoulli(EI="1/4", m=1, k=1, c=1), Fraction(0)), 2)  # lost at 1.18992…


def test_below_the_loss() -> None:
    assert len(cover(Strip(BEAM, 0.0, 1.1), 0.0, Effort(evaluations=5000))) == 0
    assert len(cover(Strip(BEAM, 1.1, 1.25), 0.6, Effort(evaluations=5000))) == 0


def test_above_the_loss() -> None:
    with pytest.raises(EffortError):
        cover(Strip(BEAM, 1.15, 1.25), 0.0, Effort(evaluations=1500))


def test_a_load_that_outruns_the_waves() -> None:
    wire = Moving(track_guide(tracks.String(T=1, m=1, k=1, c=1), Fraction(0)), 1)
    assert len(cover(Strip(wire, 0.5, 1.5), 0.0, Effort(evaluations=100))) == 1


def test_tracks_that_lose_a_wave_at_rest() -> None:
    """Kelvin–Voigt damping and layers: one of their waves runs to infinity as v → 0."""
    rail = {"EI": "6.4e6", "m": 60, "k": "1e6", "c": 770}
    damped = Moving(track_guide(tracks.EulerBernoulli(**rail, eta="1e-5"), Fraction(0)), 2)
    assert damped.loses_a_wave
    assert not BEAM.loses_a_wave
    assert len(cover(Strip(damped, 0.0, 0.1), 0.0, Effort(evaluations=5000))) == 0
    assert Strip(Moving(track_guide(RAIL, Fraction(0)), 2), 0.0, 0.2).X is not None
