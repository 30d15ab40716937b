"""The convective threshold is proved over the range below it and enclosed, the limit of long trains computed."""

from __future__ import annotations

from fractions import Fraction

import pytest
from endless_rows import masses
from flint import arb

from mpsolve import Effort, InputError, Problem, tracks, train_velocities, vehicles


def test_the_two_velocities_of_the_papers_beam() -> None:
    found = train_velocities(masses("0.3").problem, "1.5", ("0.15", "0.6"))
    assert found.proved
    assert found.calm is not None
    assert found.grows is not None
    assert (found.calm.stable, found.grows.stable) == (True, False)
    assert found.convective is not None
    assert found.stable_to is not None
    assert 0 < found.convective - found.stable_to < 1e-8
    assert 0 < found.grows.problem.v - found.convective < 1e-8
    assert found.threshold.contains(arb(found.convective))
    assert abs(found.convective - 0.190146901) < 1e-8
    assert found.limit is not None
    assert abs(found.limit - 0.445073) < 1e-6
    assert found.long is not None
    assert 0 < found.long.v - found.limit < 2e-5
    assert "threshold" in found.words
    with pytest.raises(TypeError):
        bool(found)


def test_a_range_in_which_nothing_grows() -> None:
    found = train_velocities(masses("0.3").problem, "1.5", ("0.05", "0.1"))
    assert (found.proved, found.threshold, found.convective, found.limit) == (True, None, None, None)
    assert found.stable_to == Fraction("0.1")
    assert "to 0.1" in found.words


def test_a_range_that_begins_with_growth() -> None:
    found = train_velocities(masses("0.3").problem, "1.5", ("0.3", "0.4"))
    assert (found.proved, found.threshold, found.stable_to) == (True, None, None)
    assert found.grows is not None
    assert found.grows.stable is False
    assert "already" in found.words


def test_little_effort_keeps_what_is_known() -> None:
    found = train_velocities(masses("0.3").problem, "1.5", ("0.15", "0.3"), effort=Effort(evaluations=300))
    assert (found.proved, found.threshold, found.stable_to) == (False, None, None)
    assert found.reason is not None
    assert found.reason.code == "effort"
    assert found.convective is not None
    assert found.grows is not None
    assert found.grows.stable is False
    assert found.words.startswith("undecided")


def test_ranges() -> None:
    for wrong in ((1, 0), 3, ("a", "b")):
        with pytest.raises(InputError, match="v"):
            train_velocities(masses("0.3").problem, "1.5", wrong)  # type: ignore[arg-type]


@pytest.mark.slow
def test_a_rail_on_sleepers_and_one_on_soft_ground_in_si() -> None:
    layers = tracks.TwoLayer(
        EI="6.38e6", m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper="250", k_ballast="100e6", c_ballast="8e4"
    )
    soft = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
    for track, vehicle, spacing, v, threshold in (
        (layers, vehicles.Mass(900), 3, (10, 1500), 502.344242),
        (soft, vehicles.Mass(10000), 3, (1, 400), 38.1196463),
    ):
        found = train_velocities(Problem(track, vehicle, v=v[0]), spacing, v)
        assert found.proved
        assert found.threshold.contains(arb(found.convective))
        assert abs(found.convective - threshold) < 2e-6 * threshold


def test_a_threshold_on_a_layered_track_is_enclosed() -> None:
    layers = tracks.TwoLayer(
        EI="6.38e6", m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper="250", k_ballast="100e6", c_ballast="8e4"
    )
    found = train_velocities(Problem(layers, vehicles.Mass(900), v=100), 3, (490, 510))
    assert found.proved
    assert found.threshold.contains(arb(found.convective))
    assert abs(found.convective - 502.344242) < 1e-5


@pytest.mark.slow
def test_the_threshold_of_a_row_of_coaches_is_enclosed() -> None:
    """Four axles on bogies under a body: the whole range is covered, resonances of all bodies included."""
    layers = tracks.TwoLayer(
        EI="6.38e6", m="60.2", k_pad="300e6", c_pad="3e4", m_sleeper="250", k_ballast="100e6", c_ballast="8e4"
    )
    bogie = vehicles.Bogie(wheel=900, frame=1500, inertia=800, wheelbase="2.5", k="1.2e6", c="1e4", k_contact="1e9")
    coach = vehicles.Coach(body=30000, inertia="1e6", bogie=bogie, pivots=17, k2="0.4e6", c2="2e4")
    found = train_velocities(Problem(layers, coach, v=100), 25, (560, 600))
    assert found.proved
    assert found.threshold.contains(arb(found.convective))
    assert abs(found.convective - 589.819917) < 1e-5
