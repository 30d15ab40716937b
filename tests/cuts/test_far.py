"""How far the cut must be looked at: bounds against numbers in mpmath and the theorem at single points."""

from cut_cases import family

from mpsolve import Case
from mpsolve.cuts.balls import EdgeBalls
from mpsolve.cuts.far import _waves, far_reach, wavenumber_of
from mpsolve.numbers.balls import arb, precision
from mpsolve.problem.line import on_line
from mpsolve.spectrum.far_line import prove_far


def test_wavenumbers_reach_far_enough() -> None:
    whole = family()
    W = far_reach(whole)
    assert W is not None
    P, reach = wavenumber_of(whole, W)
    with precision(64):
        for p in (P, -P, 2 * P, -2 * P):
            for x in (0.5, 1.3):
                assert EdgeBalls(whole, -1).edge(arb(p), arb(x)).z.value.real > reach


def test_it_is_no_better_than_the_theorem_at_one_point() -> None:
    whole = family()
    W, line = far_reach(whole), on_line(whole.base)
    assert W is not None
    assert line is not None
    assert prove_far(line).W <= 2 * W


def test_nothing_is_claimed_of_other_vehicles_or_close_masses() -> None:
    assert far_reach(family(Case(alpha="0.9", eta_b="0.05", eta_m=(70, 40), positions=(0, "1e-9")))) is None


def test_waves_are_bounded_where_the_rest_is_small_only() -> None:
    assert _waves(3.0, 1.0, 1.0) is None
    small = _waves(1e-3, 1e-6, 1e-9)
    assert small is not None
    assert 2.4e-4 < small.decay < 2.7e-4  # P̂ moves by 2v/(4W) to first order
    assert small.at_contact > 0
