"""The verifier's theorem of large real frequencies and its test of decay: numbers and tracks that prove nothing."""

from __future__ import annotations

import copy

import pytest
from flint import fmpq
from forging import as_file, stored

from mpsolve import Problem, Status, certify, tracks, vehicles
from mpsolve.certificate import verify2 as v2
from mpsolve.spectrum.regions import HalfPlane

BLOCK = stored("joined_masses")["theorem"]["blocks"][0]
START, END, KAPPA = BLOCK


def judged(**changed):
    content = stored("joined_masses")
    content["theorem"] |= changed
    return v2.verify_bytes(as_file(content)).reason


FALSE = {
    "a block counted twice": ({"blocks": [BLOCK, BLOCK]}, "overlap"),
    "a block twice with one back between": ({"blocks": [BLOCK, [END, START, [1, -40]], BLOCK]}, "block is empty"),
    "a block that gives": ({"blocks": [BLOCK, [END, [10676957, -23], [-1, -40]]]}, "block is empty"),
    "more is given than taken": ({"envelope": [1, 9]}, "do not absorb"),
    "a block that reaches too far": ({"blocks": [[START, [1, 10], KAPPA]]}, "to where the track gives"),
    "a bound that falls too fast": ({"alpha": 8}, "alpha is too large"),
    "no envelope": ({"envelope": [0, 0]}, "not positive"),
    "the bound falls as p⁻³, absorption as q^−5/2": ({"alpha": 3, "envelope": [24, -9]}, "absorption falls faster"),
    "no exponent": ({"gamma": [0, 0]}, "numbers are out of range"),
    "an exponent above 1": ({"gamma": [2, 1]}, "numbers are out of range"),
    "no part of short waves": ({"omega": [0, 0]}, "numbers are out of range"),
    "no block": ({"blocks": []}, "numbers are out of range"),
}


@pytest.mark.parametrize("name", FALSE)
def test_numbers_that_prove_nothing_are_refused(name):
    changed, why = FALSE[name]
    assert why in judged(**changed)


def test_other_numbers_that_prove_it():
    """α smaller than it might be, and a block too short to tell anything of two places."""
    assert judged(alpha=4, envelope=[24, -6]) == ""
    assert judged(blocks=[BLOCK, [END, [10676957, -23], [1, -40]]]) == ""


def test_a_bound_from_no_wavenumber_on_is_refused():
    content = stored("joined_masses")
    track = v2.read_track(content["equations"]["track"], content["equations"]["velocity"])
    parts = v2.absorption(v2.RING, track.D, track.N)
    v, C, X = track.v, v2.dyadic(content["theorem"]["envelope"], "envelope"), fmpq(9)

    def alpha(bounds):
        with v2.precision(128):
            return v2.tail_alpha(content["theorem"], 2, parts, {(): v}, v, X, fmpq(3, 2), bounds, ())

    assert alpha([(X / v, C)]) == 7
    for bounds, why in (([(-X / v, C)], "not positive"), ([(2 * X / v, C)], "not bounded beyond")):
        with pytest.raises(v2.Refused, match=why):
            alpha(bounds)


# --- decay ---------------------------------------------------------------------------------------------------


def two(one, other):
    """Two waveguides side by side with a spring between; the load is on the first."""
    return one * other - 1, other


P, S = v2.P_, v2.S_
BEAM, STRING = P**4 + S**2 + S + 3, S**2 + S + 3 - P**2
TRACKS = {
    "a beam": ((BEAM, v2.RING.constant(1)), None),
    "a beam on sleepers": (two(BEAM, S**2 + S + 3), None),
    "a beam on a string": (two(BEAM, STRING), None),
    "two strings alike": (two(STRING, STRING + 1), "waves of one speed"),
    "two strings": (two(STRING, STRING - 3 * P**2), None),
    "no inertia under the load": (two(P**4 + 2, S**2 + S + 3), "does not decay"),
    "no wave at all": (two(2 - P**2, STRING + S**3), "does not decay"),
}


@pytest.mark.parametrize("v", ["1/3", "3/2"])
@pytest.mark.parametrize("name", TRACKS)
def test_decay_at_high_frequency(name, v):
    (D, N), why = TRACKS[name]
    with_v = v2.RING.constant(fmpq(*map(int, v.split("/"))))
    if why is None:
        v2.check_decay(v2.RING, D, N, with_v)
    else:
        with pytest.raises(v2.Refused, match=why):
            v2.check_decay(v2.RING, D, N, with_v)


LAYERS = {"EI": 1, "m": 1, "k_pad": 2, "m_sleeper": 1, "k_ballast": 1}


def test_the_damping_of_the_rail_alone_bounds_what_short_waves_give():
    """Without damping the sleepers resonate under short waves at Ω² = 3, where D/p⁴ → 0: no C|D|² is enough there."""
    two = [vehicles.Mass(10), vehicles.Mass(20).at(1)]
    found = certify(Problem(tracks.TwoLayer(**LAYERS, eta="0.1"), two, v="1.6"), region="unstable", digits=15)
    assert (found.status, found.region, found.unstable) == (Status.PROVED, HalfPlane(), 2)
    assert "passes" in told(found.certificate.content)
    sharper = copy.deepcopy(found.certificate.content)
    m, e = sharper["theorem"]["envelope"]
    sharper["theorem"]["envelope"] = [m, e - 2]
    assert "may exceed the envelope" in told(sharper)
    shared = copy.deepcopy(found.certificate.content)  # the same numbers, but dampers between rail and sleepers
    rows = shared["equations"]["track"]["matrix"]
    for row, column, c in ((0, 1, "-1/10"), (1, 0, "-1/10"), (1, 1, "1/10")):
        rows[row][column].append([4, 1, c])
    assert told(shared) != "passes"


def told(content):
    verdict = v2.verify_bytes(as_file(content))
    return "passes" if verdict.valid else verdict.reason
