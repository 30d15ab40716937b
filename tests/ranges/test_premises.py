"""The track must be stable and damped by itself for all parameters: where exactly it is not, is known."""

from fractions import Fraction

import pytest
from free_cases import BEAM, LAYERS

from mpsolve import Problem, tracks, vehicles
from mpsolve.errors import InputError
from mpsolve.problem.family import family_of
from mpsolve.ranges.premises import require_no_wave_speed, require_stable_track


def family(track: object, **over: tuple[str, str]):  # type: ignore[no-untyped-def]
    ranges = {f"track.{name}": (Fraction(a), Fraction(b)) for name, (a, b) in over.items()}
    return family_of(Problem(track, vehicles.Mass(1), v="0.1"), ranges)


@pytest.mark.parametrize(
    "over",
    [
        {"k": ("0.1", "9")},
        {"N": ("-3", "0.999")},  # P⁴/4 + N P² + 1 at rest buckles at N = 1
        {"N": ("-3", "0.999"), "c": ("0.01", "3")},
        {"EI": ("0.1", "3"), "m": ("0.1", "3")},
    ],
)
def test_ranges_of_stable_tracks_pass(over: dict[str, tuple[str, str]]) -> None:
    require_stable_track(family(BEAM, **over))


@pytest.mark.parametrize("over", [{"N": ("0", "1.01")}, {"c": ("0", "1")}, {"N": ("0.5", "1.2"), "k": ("0.1", "9")}])
def test_a_point_that_buckles_or_is_undamped_is_refused(over: dict[str, tuple[str, str]]) -> None:
    with pytest.raises(InputError, match="stable and damped"):
        require_stable_track(family(BEAM, **over))


def test_layers_pass() -> None:
    require_stable_track(family(LAYERS, k_ballast=("5e7", "15e7"), c_pad=("1e3", "1e5"), m_sleeper=("1", "400")))


def test_a_damping_of_the_rail_that_may_be_none_is_told_by_its_name() -> None:
    rail = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770, eta="1e-4")
    with pytest.raises(InputError, match="fewer waves: begin above 0") as caught:
        require_no_wave_speed(
            family_of(Problem(rail, vehicles.Mass(900), v=100), {"track.eta": (Fraction(0), Fraction("1e-4"))})
        )
    assert caught.value.key == "track.eta"
