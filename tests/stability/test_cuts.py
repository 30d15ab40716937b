"""Cut points: the known ones, all of them and no others, and the edge that they lie on."""

from __future__ import annotations

import random
from dataclasses import replace

import flint
import numpy as np
import pytest

from mpsolve import Case, InputError, certify
from mpsolve.discs import DiscField
from mpsolve.errors import PrecisionError
from mpsolve.fields import ball_arithmetic
from mpsolve.model.branch import track
from mpsolve.model.edge import edge_value
from mpsolve.stability.cuts import cut_points
from mpsolve.stability.entire import quotient_rate
from mpsolve.stability.rim import edge_ball, slopes_ball, value_ball
from mpsolve.stability.rimboxes import assess

arb, acb = flint.arb, flint.acb

GAP = [
    (40, "0.5", 0.7404667534244332),
    (40, "1.0", 0.8613973457309659),
    (40, "1.5", 0.8779598896530904),
    (40, "2.0", 0.8767027102481949),
    (40, "2.5", 0.8815965440490775),
    (40, "3.0", 0.8930651540437504),
    (40, "3.5", 0.9018714001934055),
    (40, "4.0", 0.9058656917635258),
    (40, "4.5", 0.9086376448631609),
    (10, "0.5", 0.3726617837720695),
    (10, "1.0", 0.6612147919610002),
    (10, "1.5", 0.7233633054232281),
]

DAMPED = {
    70: [
        (0.97909502330842, 0.050671551546303, "below", False),
        (1.0416516647631, 0.046375555444716, "above", True),
        (1.2030725666739, 0.18486675300131, "below", True),
    ],
    10: [(0.96401964508021, 0.04998450905392, "below", False), (1.0341486510408, 0.049175750380428, "above", True)],
}


@pytest.mark.parametrize(("eta", "distance", "alpha"), GAP)
def test_the_twelve_ends_of_the_gap(eta, distance, alpha):
    """Section 4.2 of the paper, without damping: one each."""
    (point,) = found = cut_points(0, (eta, eta), (0, distance), alpha=("0.01", "0.99"))
    assert found.proved
    assert (point.side, point.appears) == ("gap", False)
    assert abs(point.alpha - alpha) < 1e-15
    assert point.alpha.rad() < 1e-30


def test_the_gap_is_searched_up_to_its_closure():
    found = cut_points(0, (40, 40), (0, 1), alpha=("0.2", "0.99999"))
    assert found.proved
    assert len(found) == 1
    assert not cut_points(0, 40, 0, alpha=("0.1", "0.9"))


@pytest.mark.slow
def test_a_root_leaves_the_gap_where_the_count_drops():
    (first, second) = found = cut_points(0, (40, 20, 30), (0, 1, "2.5"), alpha=("0.3", "0.95"))
    assert found.proved
    before, between, after = (certify(_case(a), digits=15).count for a in ("0.7", "0.83", "0.9"))
    assert (before - between, between - after) == (2, 2)
    assert 0.7 < float(first.alpha) < 0.83 < float(second.alpha) < 0.9
    assert not any(point.appears for point in found)


def _case(alpha: str) -> Case:
    return Case(alpha=alpha, eta_b=0, eta_m=(40, 20, 30), positions=(0, 1, "2.5"))


def _agrees(found, truth):
    assert len(found) == len(truth)
    for point, (alpha, r, side, appears) in zip(found, truth, strict=True):
        assert (point.side, point.appears) == (side, appears)
        assert abs(point.alpha - alpha) < 1e-12
        assert abs(point.q.real - r) < 1e-12
        assert point.q.imag.overlaps(arb("0.05"))
        assert point.alpha.rad() < abs(point.alpha) * arb(10) ** -30


def test_damped_cut_points_are_complete():
    found = cut_points("0.05", (70, 70), (0, "1.5"), alpha=("0.5", "1.3"))
    assert found.proved
    _agrees(found, DAMPED[70])


@pytest.mark.slow
@pytest.mark.parametrize("eta", [10, 70])
def test_damped_cut_points_over_a_wide_range(eta):
    found = cut_points("0.05", (eta, eta), (0, "1.5"), alpha=("0.01", "1.25"))
    assert found.proved
    _agrees(found, DAMPED[eta])


def test_what_is_open_is_said():
    found = cut_points(0, (40, 40), (0, 1), alpha=("0.99", "1.01"))
    assert not found.proved
    assert any(strip.start <= 1 <= strip.end for strip in found.strips)
    assert found.reason


@pytest.mark.parametrize(
    ("changes", "key"),
    [({"eta_b": 1}, "eta_b"), ({"alpha": (1, "0.5")}, "alpha"), ({"eta_b": "0.5", "eta_n": "0.9"}, "eta_n")],
)
def test_what_cannot_be_is_refused(changes, key):
    with pytest.raises(InputError, match=key):
        cut_points(**{"eta_b": 0, "eta_m": (40, 40), "positions": (0, 1), "alpha": ("0.1", "0.2")} | changes)


# --- the edge -----------------------------------------------------------------------------------------------


def _random_cases(count: int):
    rng = random.Random(3)
    for _ in range(count):
        n = rng.choice([1, 2, 2, 3, 5])
        yield (
            rng,
            Case(
                alpha=round(rng.uniform(0.01, 1.6), 3),
                eta_b=rng.choice(["0", "0.05", "0.9"]),
                eta_n=rng.choice(["0", "0.2", "-0.5", "0.4"]),
                eta_m=[round(rng.uniform(1, 60), 2) for _ in range(n)],
                positions=[1.1 * j for j in range(n)],
            ),
        )


def test_the_edge_by_wave_number_is_the_edge_by_frequency():
    """Two independent ways to the boundary values, both sides, and slopes against differences."""
    step, seen = arb(2) ** -40, set()
    for rng, case in _random_cases(60):
        with ball_arithmetic(128) as field:
            model, p = track(case, field), arb(rng.uniform(-4, 4))
            edge = edge_ball(model, p)
            if not edge.r > 0:
                continue
            try:
                truth = edge_value(model, edge.r)
            except PrecisionError:
                continue
            below = bool(edge.r_rate < 0)
            seen.add(below)
            value, along_p, along_alpha = slopes_ball(model, p)
            assert value.overlaps(truth.plus if below else truth.minus.conjugate())
            assert value.rel_accuracy_bits() > 40
            by_p = (value_ball(model, p + step) - value_ball(model, p - step)) / (2 * step)
            ahead, back = (replace(model, alpha=model.alpha + sign * step) for sign in (1, -1))
            by_alpha = (value_ball(ahead, p) - value_ball(back, p)) / (2 * step)
            for one, two in ((along_p, by_p), (along_alpha, by_alpha)):
                assert abs(complex(one.mid()) - complex(two.mid())) < 1e-7 * (abs(complex(one.mid())) + 1)
    assert seen == {True, False}


def test_discs_of_the_edge_hold_the_balls():
    """Over random boxes: slopes are enclosed, and a box that is free holds no zero of the balls at its points."""
    generator = np.random.default_rng(1)
    for rng, case in _random_cases(8):
        p, t = generator.uniform(-4, 4, 60), generator.uniform(0.05, 1.5, 60)
        h, g = (2.0 ** -generator.integers(3, 14, 60) for _ in range(2))
        seen = assess(track(case, DiscField()), np.stack([p - h, p + h, t - g, t + g], axis=1), np.inf)
        assert seen.sure.mean() > 0.5
        with ball_arithmetic(100) as field:
            for k in np.flatnonzero(seen.sure):
                at = replace(track(case, field), alpha=arb(t[k] + g[k] * rng.uniform(-1, 1)))
                _, along_p, along_alpha = slopes_ball(at, arb(p[k] + h[k] * rng.uniform(-1, 1)))
                for disc, ball in ((seen.along_p, along_p), (seen.along_alpha, along_alpha)):
                    z = complex(ball.mid())
                    assert abs(z - disc.m[k]) <= disc.r[k] * (1 + 1e-9) + 1e-9 * abs(z)


@pytest.mark.parametrize("w", [0, 1e-3, 0.4 + 0.1j, 0.5j, 3 - 2j])
def test_quotient_rate_is_the_integral(w):
    """E'(w) = ∫ t e^{tw} dt by Simpson's rule."""
    t = np.linspace(0, 1, 2001)
    weights = np.where(np.arange(2001) % 2, 4, 2) / 6000
    weights[[0, -1]] /= 2
    truth = complex(np.sum(weights * t * np.exp(t * w)))
    with ball_arithmetic(64):
        ball = quotient_rate(acb(complex(w).real, complex(w).imag), 64)
        assert abs(complex(ball.mid()) - truth) < 1e-12
        assert abs(ball - ball.mid()) < 1e-14
