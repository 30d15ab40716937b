"""What a finite track tells where the effort runs out."""

import numpy as np
import pytest

from mpsolve import Effort, InputError, Problem, finite_track, tracks, vehicles

BEAM = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c="2e4")
PROBLEM = Problem(BEAM, vehicles.Mass(1000), v=30)


def moved(**options):
    return finite_track(PROBLEM, length=60, modes=60, times=[0, "0.5"], **options)


def test_spent_effort_leaves_the_best_so_far_with_its_errors():
    whole = moved()
    assert whole.reason is None
    part = moved(effort=Effort(evaluations=whole.steps))
    assert part.reason is not None
    assert part.reason.code == "effort"
    assert part.steps < whole.steps
    assert np.isinf(part.error.modes)
    assert np.isinf(part.error.supports)
    assert np.abs(part.rail - whole.rail).max() <= part.error.time


def test_nothing_is_known_without_effort():
    none = moved(effort=Effort(evaluations=1))
    assert none.reason is not None
    assert np.isnan(none.rail).all()
    assert none.rail.shape == (1, 2)
    assert none.lift_off is None


def test_progress_hears_of_the_stages():
    heard = []
    moved(progress=lambda stage, share: heard.append((stage, share)))
    assert [stage for stage, _ in heard] == ["steps", "modes", "modes", "supports", "supports"]
    assert heard[-1][1] == 1.0


def test_what_is_no_effort_is_refused():
    with pytest.raises(InputError, match="effort"):
        moved(effort=3)
