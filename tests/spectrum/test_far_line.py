"""The theorem far out: bounds of the waves against another root finder, and turns of arg Δ̂ against floats."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from typing import Any

import numpy as np
import pytest
from flint import arb

from mpsolve import tracks, vehicles
from mpsolve.characteristic.floats import Floats
from mpsolve.characteristic.start import start
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import precision, rational_ball
from mpsolve.problem.line import Line, on_line
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.spectrum import far_line
from mpsolve.spectrum.closing import edge_splitting
from mpsolve.spectrum.far_line import Beam, _floor, _waves, beyond, prove_far, spread_beyond, turn_beyond


def made(
    v: object = "0.67", c: object = "0.1", sizes: tuple[object, ...] = (70, 70), gap: object = "3/2", **more: object
) -> Line:
    track = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c=c, **more)
    masses = [vehicles.Mass(M).at(j * Fraction(str(gap))) for j, M in enumerate(sizes)]
    found = on_line(reduce_problem(Problem(track, masses, v=v)))
    assert found is not None
    return found


def beam_of(line: Line) -> Beam:
    values = map(rational_ball, (*line.beam, line.lower.guide.v, line.height))
    gap = line.lower.smallest_gap
    return Beam(*values, None if gap is None else rational_ball(gap))


@pytest.mark.parametrize("more", [{}, {"kp": "0.2"}, {"N": "0.4"}], ids=str)
@pytest.mark.parametrize(("v", "z"), [("0", 4.0), ("0.67", 5.0), ("1.3", 12.0)])
def test_bounds_hold_what_waves_on_the_edge_show(v: str, z: float, more: dict[str, str]) -> None:
    """Roots by numpy's companion matrix; the bounds are not much wider."""
    line = made(v, **more)
    EI, T, k, m = (float(x) for x in line.beam)
    v_ = float(line.lower.guide.v)
    with precision(64):
        c0 = float((rational_ball(line.beam[0]) / rational_ball(line.beam[3])).sqrt())
        parts = list(_waves(beam_of(line), arb(c0) / z))
    assert len(parts) == 16
    for number, bounds in enumerate(parts):
        shown = []
        for y in np.linspace(number, number + 1, 9) * c0 / z / 16:
            if not y:
                continue
            z_ = c0 / y
            p = np.roots([EI, 0, -T - m * v_**2, 2 * m * z_ * v_, k - m * z_**2])  # of D̃(ip, iz)
            weights = 1 / np.abs(np.polyval([4 * EI, 0, -2 * (T + m * v_**2), 2 * m * z_ * v_], p))
            real = abs(p.imag) < 1e-9 * abs(p)
            assert real.sum() == 2
            alpha, beta = weights[real]
            still = weights[~real][0] ** 2 / (alpha * beta)
            rate = abs(p[~real].imag).min() * np.sqrt(y)
            shown.append([still, (alpha + beta) ** 2 / (4 * alpha * beta), rate])
        for values, bound in zip(np.array(shown).T, bounds, strict=True):
            low, high = float(bound.lower()), float(bound.upper())
            assert low <= values.min() + 1e-12
            assert values.max() <= high + 1e-12
            assert high - low < 0.5


@pytest.mark.parametrize("sizes", [(70,), (70, 70), (1, 200, 5), ("0.1", "0.001"), (70, 65, 60, 55)])
@pytest.mark.parametrize(("v", "c"), [("0", "0.2"), ("0.67", "0.2"), ("1.3", "1.2")])
def test_the_turn_is_that_of_floats(v: str, c: str, sizes: tuple[object, ...]) -> None:
    """Along the edge to far out in steps of the argument far below π, and round a quarter of a circle to −iR."""
    line = made(v, c, sizes)
    far, up = prove_far(line), start(line.lower.guide).up
    assert far.reach < 60
    found = turn_beyond(line, up, far)
    R = 400 * far.reach
    edge = np.linspace(np.sqrt(far.reach), np.sqrt(R), 15_000) ** 2 * (1 - 1e-9j)
    arc = R * np.exp(-1j * np.linspace(1e-9, np.pi / 2, 10_000))
    value = Floats(line.lower).delta(1j * np.concatenate([edge, arc[1:]]))[0]
    steps = np.angle(value[1:] / value[:-1])
    assert abs(steps).max() < 0.5
    assert abs(value).min() > 0
    left = 0.05  # of the waves' weights at R
    assert abs(steps.sum() - float(found.mid())) < float(found.rad()) + left
    assert float(found.rad()) <= float(far.spread.upper()) + 1e-6


def test_more_is_asked_of_light_masses_nowhere() -> None:
    assert prove_far(made(sizes=(70, 70))).reach == prove_far(made(sizes=("1e-6", 70))).reach


def test_reflection_of_masses_in_the_worst_of_random_phases() -> None:
    """Of all sizes: they reflect less than the bound, and the determinant stays above it."""
    rng = np.random.default_rng(5)
    C, X, active = 1.02, 1.05, 0.03
    r = 1 / np.sqrt(1 + 1.05**2 + 1.02**2 - 1)  # 1 + q = X² + C²
    worst, least = r, 1.0
    for k in range(1, 4):
        K = 10 ** rng.uniform(-4, 3, 20_000)
        D = C - active * K - 1j * (X + K)
        z = worst * np.exp(2j * np.pi * rng.random(20_000))
        least *= abs(1 + z / D).min()
        worst = abs((z * (D - 2 * C) - 1) / (D + z)).max()
        with precision(64):
            floor = _floor(k + 1, arb(r), arb(active))
        assert floor is not None
        assert float(floor) <= least * (1 + 1e-12)
    with precision(64):
        assert _floor(4, arb(0.9), arb(0.3)) is None
        assert _floor(4, arb(0.99), arb(0.1)) is None


def test_close_masses_are_told_apart_further_out_only() -> None:
    line = made(sizes=(70,) * 4)
    with precision(64):
        beam = beam_of(line)
        assert spread_beyond(beam, 4, arb(3)) is None
        assert spread_beyond(beam, 4, arb(40)) is not None
        assert spread_beyond(beam, 4, arb(0.04)) is None  # below the height of the cuts
    reaches = [prove_far(made(gap=gap)).reach for gap in ("1", "1e-2", "1e-4")]
    assert reaches == sorted(set(reaches))
    with pytest.raises(PrecisionError, match="too close together"):
        prove_far(made(gap="1e-8"))


def test_a_range_of_beams_has_a_reach_for_all() -> None:
    line = made()
    with precision(64):
        beam = beam_of(line)
        wide = Beam(beam.EI, beam.T, beam.k, beam.m, arb("0.5").union(arb("0.9")), beam.height, beam.gap)
        found = beyond(wide, 2, 1.0)
        assert found is not None
        for v in ("0.5", "0.67", "0.9"):
            one = Beam(beam.EI, beam.T, beam.k, beam.m, arb(v), beam.height, beam.gap)
            spread = spread_beyond(one, 2, arb(found.reach))
            assert spread is not None
            assert spread.upper() <= found.spread.upper()


@pytest.mark.parametrize("v", ["0", "0.67", "1.3"])
def test_travelling_waves_on_the_wrong_sides_are_not_taken(v: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Floats choose the sides of two roots that both have Re P = 0: the signs of their weights prove them."""
    line = made(v)
    far, up = prove_far(line), start(line.lower.guide).up

    def exchanged(*args: Any) -> Any:
        found = edge_splitting(*args)
        P = list(found.roots or ())
        a, c = (k for k, x in enumerate(P) if x.real.contains(0))
        P[a], P[c] = P[c], P[a]
        return replace(found, roots=tuple(P))

    assert turn_beyond(line, up, far).is_finite()
    monkeypatch.setattr(far_line, "edge_splitting", exchanged)
    with pytest.raises(PrecisionError, match="not told apart"):
        turn_beyond(line, up, far)


def test_masses_at_one_place_turn_as_their_sum() -> None:
    """A mass M under a contact with factor b counts as M/b²."""
    M = [[90 if i == j == 0 else 20 if i == j == 1 else 50 if i == j else 0 for j in range(3)] for i in range(3)]
    none = [[0] * 3] * 3
    car = vehicles.Vehicle(M=M, C=none, K=none, B=[[0, 3, 0], [0, 0, -1], [2, 0, 0]], places=[0, "1.5", "1.5"])
    track = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")
    lines = [on_line(reduce_problem(Problem(track, [car], v="0.67"))), made(sizes=("12.5", 30))]
    turns = [turn_beyond(line, start(line.lower.guide).up, prove_far(line)) for line in lines if line is not None]
    assert len(turns) == 2
    assert abs(float(turns[0].mid() - turns[1].mid())) < 1e-9
