"""The motion in balls: held against a second way to it, against its initial conditions, and against itself."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import flint
import numpy as np
import pytest
from continued import Continued
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import Truth, grid

from mpsolve import Case, response
from mpsolve.certificate.sheet import certify_sheet as certify
from mpsolve.discs import DiscField
from mpsolve.errors import InputError, PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import track
from mpsolve.motion.enclosure import Enclosure, enclose_response
from mpsolve.motion.forcing import tones
from mpsolve.motion.rigorous_path import Route, float_track, guide, route
from mpsolve.motion.rigorous_sheet import prove_clear
from mpsolve.motion.rigorous_tail import far, tail
from mpsolve.vehicles.load import Load

arb, acb = flint.arb, flint.acb

PAPER = Case(alpha="0.5", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5"))
LONE = Case(alpha="0.5", eta_b="0.05", eta_m=("70",), positions=("0",))
UNDAMPED = Case(alpha="0.5", eta_b=0, eta_m=("70", "20"), positions=("0", "0.5"))
CENTRE = 0.617  # next to q_lm of these three
FAST = Case(alpha="1.2", eta_b="0.1", eta_m=("20", "5"), positions=("0", "0.5"))
FAST_UNDAMPED = Case(alpha="1.4", eta_b=0, eta_m=("10",), positions=("0",))


def radius(values: Any) -> float:
    return max(float(x.rad()) for x in np.ravel(values))


def hold(enclosed: Enclosure, truth: list[list[Any]]) -> bool:
    """The truth is good to far more digits than the balls' radius; it is taken without a radius."""
    pairs = zip(enclosed.w.ravel(), (x for row in truth for x in row), strict=True)
    return all(ball.contains(x.mid()) for ball, x in pairs)


@pytest.mark.parametrize(
    ("case", "loads", "xi", "centre", "digits"),
    [
        (PAPER, [Load(1, "0.3", "0.4", 1), Load("0.5")], (0, -3, 6), CENTRE, 10),
        (LONE, [Load("0.7", "0.3", "-0.2", 2)], (0, 1), CENTRE, 10),
        # a force beyond the limiting frequency without damping: its pole is on the cut
        (UNDAMPED, [Load(1, "0.3", "0.8", 1), Load("0.5")], (0, -1), CENTRE, 10),
        # joined cuts: the centre is the branch point |q_lm|, and without damping q = 0 lies on the cut
        (FAST, [Load(1, "0.3", "0.4", 1), Load("0.5")], (0, -3, 6), 0.300, 8),
        (FAST_UNDAMPED, [Load("0.7", "0.3", "0.2", 2)], (0, 1), 0.623, 10),
    ],
)
def test_the_balls_hold_the_motion_from_a_second_way_to_twice_the_digits(
    case: Case, loads: list[Load], xi: Any, centre: float, digits: int
) -> None:
    tau = (12, 20)
    enclosed = enclose_response(case, loads, xi, tau, digits=digits)
    other = Continued(case, loads)
    truth = other.motion(xi, tau, centre, depth=0.4, corner=0.8, height=0.1, end=24, step=0.2, order=24)
    again = other.motion(xi, tau, centre, depth=0.3, corner=0.75, height=0.11, end=23, step=0.2, order=24)
    error = max(float(abs(a - b)) for r, s in zip(truth, again, strict=True) for a, b in zip(r, s, strict=True))
    assert error < 10.0 ** (-2 * digits)
    assert hold(enclosed, truth)
    assert radius(enclosed.w) < 10.0**-digits


@pytest.mark.parametrize("digits", [3, 24])
def test_coarse_and_fine_balls_hold_the_same_motion(digits: int) -> None:
    tau = (5, 20, 40)
    fine = enclose_response(LONE, tau=tau, digits=15)
    other = enclose_response(LONE, tau=tau, digits=digits)
    assert all(a.overlaps(b) for a, b in zip(fine.w.ravel(), other.w.ravel(), strict=True))
    assert radius(other.w[:, 1:]) < 10.0**-digits


def test_the_balls_of_the_papers_case_are_narrow_and_start_from_rest() -> None:
    enclosed = enclose_response(PAPER, tau=(0, "0.5", 1, 10, 200))
    assert enclosed.w.shape == enclosed.steady.shape == enclosed.harmonic.shape == enclosed.transient.shape == (2, 5)
    assert radius(enclosed.w[:, 1:]) < 1e-11
    assert radius(enclosed.w[:, 2:]) < 1e-15
    assert radius(enclosed.w[:, 0]) < 2e-9
    assert all(w.contains(0) for w in enclosed.w[:, 0])
    assert all(abs(x) < 1e-9 for x in enclosed.transient[:, 4])  # e^{−η_b τ} = 5e-5, times the cut's own decay
    sizes = [
        min(abs(float(x)) for x in part[:, 0]) for part in (enclosed.steady, enclosed.harmonic, enclosed.transient)
    ]
    assert min(sizes) > 1e-5  # what cancels at the start


def test_a_dropped_root_shows_at_the_start() -> None:
    spectrum = certify(PAPER)
    farthest = max(abs(float(root.q.real)) for root in spectrum.roots)
    roots = tuple(root for root in spectrum.roots if abs(float(root.q.real)) < farthest)
    assert 0 < len(roots) < len(spectrum.roots)
    wrong = enclose_response(PAPER, tau=0, spectrum=replace(spectrum, roots=roots))
    assert not any(w.contains(0) for w in wrong.w[:, 0])


@settings(max_examples=4)
@given(
    alpha=grid(0, 1.5),
    eta_b=st.sampled_from([0, 0.0625, 0.375]),
    eta_m=st.sampled_from([(4,), (70,), (20, 5)]),
    gap=grid(0.25, 2),
    frequency=st.sampled_from([0, 0.3125, 1.5]),
)
def test_the_motion_starts_from_rest(alpha: float, eta_b: float, eta_m: Any, gap: float, frequency: float) -> None:
    case = Case(alpha=alpha, eta_b=eta_b, eta_m=eta_m, positions=(0, gap)[: len(eta_m)])
    loads = [Load(1, 0.5, frequency, 1)] * len(eta_m)
    enclosed = enclose_response(case, loads, tau=(0, "0.01"), digits=10)
    assert all(w.contains(0) for w in enclosed.w[:, 0])
    assert radius(enclosed.w) < 1e-5
    # w grows as the image at infinity has it, like τ²/η_M times the force on the mass: (2)
    for j, eta in enumerate(eta_m):
        force = 1 + 0.5 * np.sin(1)
        assert float(enclosed.w[j, 1]) == pytest.approx(force / eta * 1e-4, rel=0.1, abs=1e-5)


THREE = Case(alpha="0.5", eta_b="0.05", eta_m=("40", "10", "40"), positions=("0", "0.5", "1.25"))


def test_three_masses_in_balls() -> None:
    loads = [Load(1, "0.3", "0.4", 1), Load("0.5"), Load()]
    enclosed = enclose_response(THREE, loads, xi=(0, -1), tau=(0, 3, 20), digits=8)
    assert all(w.contains(0) for w in enclosed.w[:, 0])
    assert radius(enclosed.w) < 1e-5
    assert radius(enclosed.w[:, 1:]) < 1e-8
    found = response(THREE, loads, (0, -1), (0, 3, 20)).w
    assert np.max(np.abs(np.vectorize(float)([x.mid() for x in np.ravel(enclosed.w)]) - found.ravel())) < 1e-5


@pytest.mark.parametrize(
    ("eta_m", "positions", "delta"),
    [
        ((40, 10, 40), (0, "0.5", "1.25"), 0.13),
        ((3, 70, 20), (0, 2, "2.75"), 0.05),
        ((9, 8, 7, 6), (0, 1, 2, 3), 0.02),
    ],
)
@pytest.mark.parametrize("alpha", ["0", "0.9", "1.3"])
def test_what_the_masses_scatter_far_out_is_bounded(alpha: str, eta_m: Any, positions: Any, delta: float) -> None:
    """(B/diag B)⁻¹ from the p-roots themselves, on the continued sheet, at points of the strip from W on."""
    case = Case(alpha=alpha, eta_b="0.1", eta_m=eta_m, positions=positions)
    with ball_arithmetic(80) as field:
        W = next(W for W in 2.0 ** np.arange(3, 14) if bounded(track(case, field), delta, W))
        bound = float(far(track(case, field), delta, W).inverse)
    x, eta, n = np.array(list(map(float, case.positions))), np.array(list(map(float, eta_m))), len(eta_m)
    largest = 0.0
    for w in np.add.outer(W + np.linspace(0.01, 20, 300), 1j * np.array([0, delta / 2, delta])).ravel():
        r = w * w / 2
        q, A = r + 0.1j, float(alpha) ** 2
        p = np.roots([1, 0, -4 * A, 8 * float(alpha) * r, 4 * (1 - 0.01) - 4 * r * r])
        p = np.array([p[np.argmin(np.abs(p - z * w))] for z in (1, 1j, -1, -1j)])
        c = 1 / (4 * p**3 - 8 * A * p + 8 * float(alpha) * r)
        gap = x[:, None] - x
        ahead = sum(c[k] * np.exp(1j * p[k] * np.maximum(gap, 0)) for k in (1, 2))
        behind = -sum(c[k] * np.exp(1j * p[k] * np.minimum(gap, 0)) for k in (0, 3))
        B = np.eye(n) - 4j * q * q * eta[:, None] * np.where(gap >= 0, ahead, behind)
        largest = max(largest, float(np.abs(np.linalg.inv(B / np.diag(B)[:, None])).max()))
    assert bound / 100 < largest < bound


def bounded(model: Any, delta: float, W: float) -> bool:
    try:
        return far(model, delta, W).inverse is not None
    except PrecisionError:
        return False


def test_far_positions_and_merged_masses() -> None:
    merged = Case(alpha="0.5", eta_b="0.05", eta_m=("30", "40"), positions=("0", "0"))
    one = enclose_response(merged, [Load("0.25"), Load("0.75")], (0, 40), (5,), digits=8)
    other = enclose_response(LONE, None, (0, 40), (5,), digits=8)
    assert all(a.overlaps(b) for a, b in zip(one.w.ravel(), other.w.ravel(), strict=True))
    assert radius(one.w) < 1e-8


def test_no_path_is_proved_above_a_branch_point_or_a_zero() -> None:
    with ball_arithmetic(80) as field:
        plane: Any = DiscField()
        ball, discs = track(LONE, field), track(LONE, plane)
        way = route(LONE, ball, [0j], 0, 10)
        assert way.delta == 0.5  # q'(p) = 0 at Re q = 1.19, Im q − η_b = 0.31, which this path passes above
        with pytest.raises(PrecisionError, match="branch points may lie"):
            prove_clear(ball, discs, guide(float_track(LONE), way), way, 12.0)
        low = route(LONE, ball, [0j], 0, 10, lowered=0.35)
        assert prove_clear(ball, discs, guide(float_track(LONE), low), low, 12.0) > 0
        paper = track(PAPER, field)
        assert far(paper, 0.1, 64.0).product < 1
        with pytest.raises(PrecisionError, match="off-diagonal"):
            far(paper, np.log(2) / 3, 1024.0)


def test_the_side_of_the_path_on_which_a_pole_lies() -> None:
    with ball_arithmetic(80) as field:
        ball = track(LONE, field)
        way = route(LONE, ball, [0j], 0, 10)
        top = (way.frequency(ball, acb(way.v0))).mid()
        assert top.real.is_zero()
        for q, passed in ((0.9 * top, True), (1.1 * top, False), (acb(0, -3), True), (acb(5, 0), True)):
            assert way.passes_above(ball, q) is passed
        assert way.passes_above(ball, acb(5, 1)) is False
        with pytest.raises(PrecisionError, match="too close"):
            way.passes_above(ball, top)
        back = way.frequency(ball, way.inverse(ball, acb(0.3, 0.2)))
        assert back.contains(acb(0.3, 0.2))


@pytest.mark.parametrize("case", [LONE, PAPER])
def test_the_tail_bounds_the_image_below_the_cut(case: Case) -> None:
    """W̃ of the paper's residue sums, close below the cut, where the sheets agree."""
    loads, truth = [Load(1, "0.3", "0.4", 1)] * case.count, Truth(case)
    mp = truth.mp
    with ball_arithmetic(80) as field:
        ball = track(case, field)
        gaps = [((x > o) - (x < o), arb(x) - arb(o)) for x in (0,) for o in map(float, case.positions)]
        at, parts = far(ball, 0.1, 50.0), tones(case, loads, field)
        bound = at.image(parts, gaps)
        bounds = tail(ball, Route(CENTRE, -1j, 0.3 + 0.1j), parts, [gaps], 60.0)
        assert float(bounds[0]) == pytest.approx(float(at.image(parts, gaps)) * 60.0**-4 / (4 * np.pi), rel=0.3)
    for u in (50.5, 90.0, 400.0):
        q = mp.mpc(CENTRE + u * u / 2, float(case.eta_b) - 1e-9)
        s, w = mp.j * q, mp.mpf("0.4")
        F = 4 / s + 4 * mp.mpf("0.3") * (s * mp.sin(1) + w * mp.cos(1)) / (s * s + w * w)
        x, eta, factor = truth.x, truth.eta_m, 2 * q * q / mp.pi
        K = [[truth.kernel(a - b, q) for b in x] for a in x]
        order = range(len(x))
        S = mp.lu_solve(
            mp.matrix([[(i == k) - factor * eta[i] * K[i][k] for k in order] for i in order]), mp.matrix([F] * len(x))
        )
        image = abs(sum(S[j] * K[0][j] for j in order)) / mp.pi * abs(2 * (q - mp.j * truth.eta_b)) ** 3
        assert float(bound) / 60 < float(image) < float(bound)


@pytest.mark.parametrize(
    ("case", "arguments", "message"),
    [
        (Case(alpha="0.5", eta_b="1.1", eta_m=(5,), positions=(0,)), {}, "eta_b"),
        (LONE, {"tau": -1}, "before 0"),
        (LONE, {"tau": 1e5}, "beyond 2000"),
        (LONE, {"xi": 200}, "nearer positions"),
        (LONE, {"digits": 0}, "whole number"),
        (LONE, {"loads": [Load(), Load()]}, "one for each"),
    ],
)
def test_what_is_not_covered_is_refused(case: Case, arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(InputError, match=message):
        enclose_response(case, **arguments)


def test_a_spectrum_must_be_of_the_case_and_proved() -> None:
    spectrum = certify(LONE)
    with pytest.raises(InputError, match="spectrum"):
        enclose_response(PAPER, spectrum=spectrum)
    with pytest.raises(PrecisionError, match="undecided"):
        enclose_response(LONE, spectrum=certify(LONE, max_pieces=1))


def test_no_times_or_positions_give_empty_arrays() -> None:
    assert enclose_response(LONE, tau=()).w.shape == (1, 0)
    assert enclose_response(LONE, xi=(), tau=1).w.shape == (0, 1)
