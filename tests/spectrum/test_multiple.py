"""Roots that nearly meet: apart where the digits tell them apart, else one ball with their number."""

from __future__ import annotations

from functools import cache

import pytest

from mpsolve import certify
from mpsolve.characteristic.floats import Floats
from mpsolve.characteristic.proved import Proved
from mpsolve.errors import PrecisionError
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.numbers.rootball import RootBall, Symmetry, on_grid, radius_of
from mpsolve.numbers.taylor import SAMPLES, Taylor
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.spectrum.enclose import enclose
from mpsolve.spectrum.multiple import _Roots, as_cluster, separate
from mpsolve.tracks import EulerBernoulli
from mpsolve.vehicles import Mass, Vehicle

BEAM = EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")


@cache
def far_apart() -> tuple[Proved, complex]:
    """Two masses that hardly feel each other: each root of one mass is two, some 1e-15 apart."""
    reduced = reduce_problem(Problem(BEAM, [Mass(10).at(0), Mass(10).at(100)], "0.67"))
    one = Floats(reduce_problem(Problem(BEAM, [Mass(10).at(0)], "0.67")))
    sigma = -0.018 + 0.3216j
    for _ in range(20):
        value, slope = one.delta([sigma])
        sigma -= (value / slope)[0]
    assert reduced.guide == one.reduced.guide
    return Proved(reduced), complex(sigma)


def overlap(a: RootBall, b: RootBall) -> bool:
    return bool(a.q.overlaps(b.q))


def test_a_cluster_has_its_number() -> None:
    proved, sigma = far_apart()
    with pytest.raises(PrecisionError):
        enclose(proved, sigma, 5)
    (ball,) = separate(proved, sigma, 5)
    assert ball.multiplicity == 2
    assert ball.q.rel_accuracy_bits() > 15


def test_more_digits_tell_them_apart() -> None:
    proved, sigma = far_apart()
    (cluster,) = separate(proved, sigma, 5)
    for digits in (15, 40):
        balls = separate(proved, sigma, digits)
        assert [ball.multiplicity for ball in balls] == [1, 1]
        assert not overlap(*balls)
        assert all(cluster.q.contains(ball.q) for ball in balls)
        assert all(ball.q.rel_accuracy_bits() > 3.3 * digits for ball in balls)


def test_the_gap_is_that_of_the_coupling() -> None:
    """Half the difference of the two roots is ε = √(G(d) G(−d)) over the slope of 1 + G(0) m s², to first order."""
    proved, sigma = far_apart()
    a, b = (complex(ball.q.mid() - separate(proved, sigma, 40)[0].q.mid()) for ball in separate(proved, sigma, 40))
    floats = Floats(proved.reduced)
    one = Floats(reduce_problem(Problem(BEAM, [Mass(10).at(0)], "0.67")))
    G = dict(
        zip(floats.border.distances, floats.receptance(floats_sigma(sigma), floats.border.distances)[0], strict=True)
    )
    slope = one.delta([sigma])[1][0]
    S = complex(sum(float(c) * sigma**k for k, c in enumerate(rows[0][0] for rows in proved.reduced.S)))
    (behind, ahead) = (G[x][0] for x in floats.border.distances if x)
    gap = abs(2 * S * (ahead * behind) ** 0.5 / slope / b_of(one)) * float(proved.reduced.frequency_unit)
    assert abs(abs(a - b) / gap - 1) < 1e-3


def b_of(one: Floats) -> float:
    """The determinant of one mass is −(b + S G/b)."""
    return float(one.border.direct[0].b)


def floats_sigma(sigma: complex) -> object:
    import numpy as np

    return np.array([sigma])


def test_a_simple_root_comes_back_simple() -> None:
    reduced = reduce_problem(Problem(BEAM, [Mass(10).at(0)], "0.67"))
    _, sigma = far_apart()
    (ball,) = separate(Proved(reduced), sigma, 15)
    assert ball.multiplicity == 1


def test_nothing_where_there_is_no_root() -> None:
    proved, sigma = far_apart()
    assert separate(proved, 2 * sigma + 0.3, 15) == []


@pytest.mark.parametrize(("share", "held"), [(0.5, True), (1.2, False), (3.0, False)])
def test_a_ball_is_given_only_with_both_roots_inside(share: float, held: bool) -> None:
    """z² = r² about a point: the disc inside the ball must hold both roots, not only the disc round it."""
    proved, _ = far_apart()
    with precision(200):
        centre = acb(1, 1)
        radius = abs(radius_of(on_grid(centre, 40, 2, Symmetry.NONE).exponent, 2)) * arb((1, 0))
        unit = proved.reduced.frequency_unit
        radius = radius / (arb(unit.numerator) / unit.denominator)
        r = radius * share
        zero = [acb(0)] * (SAMPLES - 3)
        series = Taylor(centre, (-acb(r * r), acb(0), acb(1), *zero), arb(1), arb((1, -10)))
        assert bool(as_cluster(proved, series, 2, 40)) is held


def overdamped(*places: int) -> Problem:
    """Each body creeps back on its damper: a root on the imaginary axis."""
    body = Vehicle(M=[[1]], C=[[10]], K=[[1]], B=[[1]], places=[0])
    return Problem(EulerBernoulli(EI="1/4", m=1, k=1, c=1), [body.at(x) for x in places], v="0.5")


def test_two_roots_on_the_axis_that_digits_do_not_tell_apart_are_in_the_certificate() -> None:
    found = certify(overdamped(0, 1000), region=("below", "0.4"), digits=15)
    assert (found.proved, found.count) == (True, 2), found.reason
    (both,) = found.roots
    assert both.multiplicity == 2
    assert both.q.real.contains(0)


def test_a_lone_root_of_a_series_next_to_the_axis_lies_on_it() -> None:
    """Where no box isolates it: its disc is its own mirror image."""
    one = overdamped(0)
    (root,) = certify(one, region=("below", "0.4"), digits=30, check=False).roots
    proved = Proved(reduce_problem(one))
    with precision(400):
        sigma = acb(0, 1) * root.q / arb(float(proved.reduced.frequency_unit))
        series = _Roots(proved).series((sigma.mid() + acb(0, arb(2) ** -90)).mid(), 20)
        assert series.centre.imag == 0
        (ball,) = as_cluster(proved, series, 1, 60)
    assert ball.symmetry is Symmetry.IMAGINARY
    assert ball.q.overlaps(root.q)
