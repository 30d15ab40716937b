import math

import numpy as np
import pytest

from mpsolve import Effort, Irregularity, Load, Problem, Status, certify, response, tracks, vehicles
from mpsolve.errors import InputError
from mpsolve.vibration.balls.enclosure import _alone, response_balls
from mpsolve.vibration.image import Image

BEAM = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c="0.1")
ONE = Problem(BEAM, vehicles.Mass(20), v="0.5")


@pytest.fixture(scope="module")
def alone():
    return response_balls(ONE, [Load(1)], times=["2", "10"], digits=12)


def test_one_mass_on_the_papers_beam_is_where_another_proof_has_it(alone):
    """Twice these, in balls, by the contour of the paper's beam: 0.17945305282196 and 2.16132387845662."""
    assert alone.status is Status.UNVERIFIED
    for ball, known in zip(alone.rail[0], (0.17945305282196 / 2, 2.16132387845662 / 2), strict=True):
        assert abs(float(ball.mid()) - known) < 1e-13
        assert float(ball.rad()) < 1e-12


def test_the_parts_are_where_another_proof_has_them(alone):
    for part, known in (
        (alone.harmonic, (-0.973148468037157 / 2, 1.00890052128798 / 2)),
        (alone.transient, (-0.00065849773106 / 2, -0.0008366614215332 / 2)),
    ):
        assert [float(x.mid()) for x in part[0]] == pytest.approx(known, abs=1e-13)


def test_all_channels_agree_with_float64(alone):
    other = response(ONE, [Load(1)], times=[2.0, 10.0])
    assert [float(x) for x in alone.contact_force[0]] == pytest.approx(other.contact_force[0], abs=1e-6)
    assert [float(x) for x in alone.vehicle["wheel"]] == pytest.approx(other.vehicle["wheel"], abs=1e-8)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("problem", "times"),
    [
        (Problem(BEAM, [vehicles.Mass(5).at(0), vehicles.Mass(5).at("0.5")], v="0.5"), ["4"]),
        (
            Problem(
                tracks.TwoLayer(
                    EI="6.4e6", m=60, m_sleeper=150, k_pad="1e8", c_pad="5e4", k_ballast="5e7", c_ballast="1e5"
                ),
                vehicles.Mass(800),
                v=60,
            ),
            ["0.01", "0.1"],
        ),
        (Problem(tracks.String(T=2, m=1, k=1, c="0.2"), vehicles.Mass(3), v="0.5"), ["1", "6"]),
    ],
)
def test_other_problems_are_proved_and_agree_with_float64(problem, times):
    found = response_balls(problem, times=times, digits=8)
    other = response(problem, times=[float(t) for t in times])
    assert found.status is Status.UNVERIFIED, found.reason
    size = np.abs(other.rail).max()
    for row, known in zip(found.rail, other.rail, strict=True):
        assert [float(x) for x in row] == pytest.approx(known, abs=3 * other.error.rail + 1e-8 * size)
        assert max(float(x.rad()) for x in row) < 1e-8 * size


def test_without_damping_the_motion_and_its_parts_are_proved():
    beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1)
    problem = Problem(beam, vehicles.Mass(20), v="0.5")
    found = response_balls(problem, [Load(1)], times=["3"], digits=6)
    assert found.status is Status.UNVERIFIED, found.reason
    assert float(found.rail[0, 0]) == pytest.approx(response(problem, [Load(1)], times=[3.0]).rail[0, 0], abs=1e-8)
    assert float(found.rail[0, 0].rad()) < 1e-5
    other = response(problem, [Load(1)], times=[3.0], spectrum=certify(problem, check=False))
    assert float(found.harmonic[0, 0]) == pytest.approx(other.harmonic[0, 0], abs=1e-8)
    assert float(found.harmonic[0, 0].rad()) < 1e-5


def test_a_load_that_turns_backwards_is_that_which_turns_forwards():
    """a sin(−ωt + φ) = −a sin(ωt − φ)."""
    one, other = (
        response_balls(ONE, [load], times=["4"], digits=6)
        for load in (Load(1, "0.3", "-0.2", 2), Load(1, "-0.3", "0.2", -2))
    )
    for part in ("rail", "steady", "harmonic"):
        assert getattr(one, part)[0, 0].overlaps(getattr(other, part)[0, 0])
        assert float(getattr(one, part)[0, 0].rad()) < 1e-5


def test_spent_effort_leaves_nothing_known():
    found = response_balls(ONE, times=["2"], digits=8, effort=Effort(evaluations=40))
    assert found.status is Status.UNDECIDED
    assert found.reason.code == "effort"
    assert not found.rail[0, 0].is_finite()


def test_roots_that_were_not_certified_are_kept_out_of_the_circles_round_others():
    """A body that decays (Im q = 0.0042) shares its frequency with the wheel, which grows (−0.0004).

    Known are residues of û, from the determinant in float64 on circles of radius 0.001 that hold one root alone.
    """
    tuned = vehicles.Oscillator(wheel=20, body="0.02", k="0.00145", c="0.0002")
    problem = Problem(BEAM, tuned, v="1.154")
    spectrum = certify(problem, region="unstable", digits=40, check=False)
    found = response_balls(problem, times=["4", "9"], digits=5, spectrum=spectrum)
    plain = response(problem, times=[4.0, 9.0], spectrum=spectrum)
    for part in (found.harmonic[0], plain.harmonic[0]):
        assert [float(x) for x in part] == pytest.approx([86.65035604, 76.02623938], abs=1e-6)


def test_how_far_round_a_place_all_roots_are_known():
    found = certify(ONE, region=("below", "0.04"), digits=20, check=False)
    image = Image(ONE, ())
    reach = float(found.region.reach) / image.rate
    alone = _alone(image, found)
    assert alone(0.3 + 0.2j) == pytest.approx(0.3 + 0.04 / image.rate)
    assert alone(0.01 + 1j * (reach - 0.001)) == pytest.approx(0.01)  # beyond the reach only what grows is known
    assert alone(-0.01 + 1j * (reach + 0.001)) < 0
    assert _alone(image, certify(ONE, region="unstable", digits=20, check=False))(0.3 + 0.2j) == 0.3
    assert _alone(image, certify(ONE, region="sheet", digits=20, check=False))(-5 + 0.2j) == math.inf


STRING = tracks.String(T=2, m=1, k=1, c="0.2")
LAYERS = tracks.TwoLayer(EI="0.25", m=1, m_sleeper=2, k_pad=3, c_pad="0.4", k_ballast=1, c_ballast="0.3")


@pytest.mark.parametrize(
    ("track", "v", "places", "times"),
    [
        (STRING, "0.5", ["1", "-2"], ["2"]),
        pytest.param(LAYERS, "0.5", ["-1", "0.7"], ["3"], marks=pytest.mark.slow),
        pytest.param(
            tracks.Timoshenko(EI=1, m=1, k=1, c="0.2", S=2, J="0.25"),
            "0.5",
            ["1", "-1"],
            ["3"],
            marks=pytest.mark.slow,
        ),
    ],
)
def test_places_that_waves_have_reached_are_proved(track, v, places, times):
    problem = Problem(track, vehicles.Mass(3), v=v)
    found = response_balls(problem, times=times, places=places, digits=6)
    assert found.status is Status.UNVERIFIED, found.reason
    floats = response(problem, times=[float(t) for t in times], places=places)
    size = np.abs(floats.rail).max()
    for ball, value in zip(found.rail.ravel(), floats.rail.ravel(), strict=True):
        assert float(ball.rad()) < 1e-5 * size
        assert abs(float(ball.mid()) - value) < float(ball.rad()) + 1e-8 * size


def test_a_place_that_waves_have_not_reached_is_refused_with_the_time():
    """The wave ahead takes 1/(√2 − 0.5) s over 1 m, and what stays on the track 1/0.5 s."""
    problem = Problem(STRING, vehicles.Mass(3), v="0.5")
    found = response_balls(problem, times=["1"], places=["1"], digits=6)
    assert found.status is Status.UNDECIDED
    assert "by waves at t = 1.0938" in found.reason.message
    layers = Problem(LAYERS, vehicles.Mass(3), v="0.5")
    assert "by waves at t = 2 " in response_balls(layers, times=["1"], places=["-1"], digits=6).reason.message


def test_echoes_between_contacts_are_refused_with_the_reason():
    pair = Problem(STRING, vehicles.train(vehicles.Mass(3), 2, 1), v="0.5")
    assert "echoes between contacts" in response_balls(pair, times=["5"], digits=6).reason.message


@pytest.mark.parametrize(
    ("options", "word"),
    [({"times": ["0"]}, "times"), ({"times": ["1"], "digits": 0}, "digits"), ({"times": []}, "times")],
)
def test_what_cannot_be_used_is_refused(options, word):
    with pytest.raises(InputError, match=word):
        response_balls(ONE, **options)


def test_the_spectrum_of_another_problem_is_refused():
    other = Problem(BEAM, vehicles.Mass(21), v="0.5")
    with pytest.raises(InputError, match="another problem"):
        response_balls(ONE, times=["1"], spectrum=certify(other, check=False))


def test_irregularities_are_no_loads_of_balls():
    with pytest.raises(TypeError):
        response_balls(ONE, times=["1"], irregularities=[Irregularity(1, 1)])
