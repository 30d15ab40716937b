"""The scaled problem against the given one: Δ is Δ̂ times one power of two, and the factors that were taken out."""

from __future__ import annotations

from fractions import Fraction
from math import log2
from typing import Any

import mpmath
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from receptance_truth import Receptance
from track_models import DAMPED, random_tracks
from vehicle_models import TYPICAL, random_vehicles

from mpsolve import tracks, vehicles
from mpsolve.errors import InputError, MpsolveError
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import Guide, Reduced, reduce_problem, scale_guide
from mpsolve.tracks.waveguide import Waveguide, moving

MP = mpmath.MPContext()
MP.dps = 45


def number(x: Fraction) -> Any:
    return MP.mpf(x.numerator) / x.denominator


def bordered(K: Any, C: Any, M: Any, B: Any, h: Any, places: Any, truth: Receptance, sigma: Any, rows: int) -> Any:
    """det [[S, −B], [Bᵀ, G + h]], the last `rows` rows of bodies divided by σ."""
    n = len(B)
    S = [[number(K[i][j]) + number(C[i][j]) * sigma + number(M[i][j]) * sigma**2 for j in range(n)] for i in range(n)]
    top = [[*S[i], *(-number(x) for x in B[i])] for i in range(n)]
    top = [[x / sigma for x in row] if i >= n - rows else row for i, row in enumerate(top)]
    G = {a - b: truth.value(a - b, sigma) for a in places for b in places}
    low = [
        [
            *(number(B[i][j]) for i in range(n)),
            *(G[a - b] + (number(h[j]) if j == k else 0) for k, b in enumerate(places)),
        ]
        for j, a in enumerate(places)
    ]
    return MP.det(MP.matrix(top + low))


def given_one(problem: Problem, sigma: Any) -> Any:
    """Δ(σ), in the problem's own units."""
    D, N = problem.track.waveguide.dispersion, problem.track.waveguide.numerator
    guide = Guide(0, 0, D, N, moving(D, problem.v), moving(N, problem.v), problem.v, Fraction(1))
    p = problem.pencil
    return bordered(p.K, p.C, p.M, p.B, p.h, p.places, Receptance(guide, 45), sigma, 0)


def scaled_one(reduced: Reduced, sigma: Any) -> Any:
    """Δ̂(σ̂) from the reduced matrices."""
    K, C, M = reduced.S
    places = [reduced.places[k] for k in reduced.index]
    return bordered(K, C, M, reduced.B, reduced.h, places, Receptance(reduced.guide, 45), sigma, 0)


def factor(reduced: Reduced, sigma: Any) -> Any:
    """What was taken out: σ^neutral det S_u / det² of the basis, in the problem's units."""
    parts = reduced.parts
    value = MP.mpc(sigma) ** parts.neutral
    if parts.unfelt is not None:
        M, C, K = parts.unfelt
        value *= MP.det(MP.matrix([
            [number(k) + number(c) * sigma + number(m) * sigma**2 for m, c, k in zip(*three, strict=True)]
            for three in zip(M, C, K, strict=True)
        ]))  # fmt: skip
    if parts.basis is not None:
        value /= MP.det(MP.matrix([[number(x) for x in row] for row in parts.basis])) ** 2
    return value


def check(problem: Problem) -> None:
    """Δ = ± 2^k Δ̂ · factor with the same k at all points."""
    reduced = reduce_problem(problem)
    unit = number(reduced.frequency_unit)
    ratios = []
    for scaled in (0.7 + 0.3j, 1.9 - 0.8j, 0.2 + 2.5j):
        sigma = MP.mpc(scaled) * unit
        ratios.append(given_one(problem, sigma) / (scaled_one(reduced, MP.mpc(scaled)) * factor(reduced, sigma)))
    order = MP.log(abs(ratios[0]), 2)
    assert abs(order - MP.nint(order)) < 1e-20
    for other in ratios:
        assert abs(other - ratios[0]) < 1e-20 * abs(ratios[0])
    assert abs(ratios[0].imag) < 1e-20 * abs(ratios[0])


UNFELT = vehicles.Vehicle(
    M=[[5, 0, 0], [0, 1, 0], [0, 0, 1]], C=[[0, 0, 0], [0, 0, 0], [0, 0, 0]],
    K=[[6, -3, -3], [-3, 3, 0], [-3, 0, 3]], B=[[1], [0], [0]], places=[0],
)  # fmt: skip
SHARED = vehicles.Vehicle(
    M=[[5000, 0], [0, 1]], C=[[2, 0], [0, 1]], K=[[9, -1], [-1, 3]], B=[[1], [2]], places=[0]
)  # one contact on two bodies of unlike weight
NEUTRAL = vehicles.Vehicle(M=[[3, 0], [0, 5]], C=[[2, -2], [-2, 2]], K=[[0, 0], [0, 0]], B=[[1], [0]], places=[0])


@pytest.mark.parametrize("name", DAMPED)
@pytest.mark.parametrize("v", [0, 25])
def test_masses_on_every_track(name: str, v: int) -> None:
    check(Problem(DAMPED[name], [vehicles.Mass(900), vehicles.Mass("0.4").at("2.5")], v=v))


@pytest.mark.parametrize(
    "vehicle", [*TYPICAL.values(), UNFELT, NEUTRAL, SHARED], ids=[*TYPICAL, "unfelt", "neutral", "shared"]
)
def test_every_vehicle(vehicle: vehicles.AnyVehicle) -> None:
    check(Problem(DAMPED["euler-bernoulli"], [vehicle, vehicles.Mass(3).at(50)], v=40))


@settings(max_examples=15)
@given(random_tracks(), random_vehicles(), st.sampled_from([0, "1/3", 5]))
def test_random_problems(track: tracks.Track, vehicle: vehicles.AnyVehicle, v: object) -> None:
    try:
        problem = Problem(track, vehicle, v=v)
        reduce_problem(problem)
        truth = Receptance(reduce_problem(problem).guide, 45)
        truth.value(0, MP.mpc(0.7 + 0.3j))
    except (MpsolveError, ZeroDivisionError):
        return
    check(problem)


@pytest.mark.parametrize("name", DAMPED)
def test_scaled_numbers_are_near_1(name: str) -> None:
    reduced = reduce_problem(Problem(DAMPED[name], TYPICAL["bogie"], v=25))
    sizes = [log2(abs(c)) for c in reduced.guide.D_rest.values()]
    assert max(sizes) < 3
    assert min(sizes) > -25
    for i in range(reduced.bodies):
        assert 1 / 4 <= sum(abs(rows[i][i]) for rows in reduced.S) <= 4


def test_places_are_different_and_ascending() -> None:
    placed = [vehicles.Mass(1).at(x) for x in (3, 0, 3, "1/3")]
    reduced = reduce_problem(Problem(DAMPED["string"], placed, v=10))
    unit = Fraction(2) ** reduced.guide.length
    assert [x * unit for x in reduced.places] == [0, Fraction(1, 3), 3]
    assert reduced.index == (0, 1, 2, 2)
    assert reduced.smallest_gap == Fraction(1, 3) / unit


def test_numbers_of_any_size_are_scaled() -> None:
    huge = Fraction(10) ** 150
    track = tracks.EulerBernoulli(EI=huge * huge, m=huge, k=huge, c=huge)
    reduced = reduce_problem(Problem(track, vehicles.Mass(huge), v=1))
    assert max(abs(c) for c in reduced.guide.D_rest.values()) < 8


def test_a_track_without_a_point_receptance_is_refused() -> None:
    one = Fraction(1)
    odd = Waveguide(
        (({(2, 0): one, (0, 1): one, (0, 0): one}, {(1, 0): one}), ({(1, 0): -one}, {(2, 0): one, (0, 0): one}))
    )
    assert max(i for i, _ in odd.numerator) == 2
    assert scale_guide(Problem(odd, vehicles.Mass(1), v=0)).degree == 4
    local = Waveguide((({(0, 1): one, (0, 0): one}, {(1, 0): one}), ({(1, 0): -one}, {(2, 0): -one, (0, 0): one})))
    with pytest.raises(InputError, match="point receptance"):
        reduce_problem(Problem(local, vehicles.Mass(1), v=0))
    still = Waveguide((({(0, 2): one, (0, 0): one},),))
    with pytest.raises(InputError, match="waves"):
        reduce_problem(Problem(still, vehicles.Mass(1), v=0))
