"""How far the cut must be looked at: bounds against numbers in mpmath and the theorem at single points."""

from cut_cases import family

from mpsolve import Case
from mpsolve.cuts.balls import EdgeBalls
from mpsolve.cuts.far import far_reach, wavenumber_of
from mpsolve.numbers.balls import arb, precision
from mpsolve.problem.line import on_line
from mpsolve.spectrum.far_line import prove_far


def test_wavenumbers_reach_far_enough() -> None:
    whole = family()
    far = far_reach(whole)
    assert far is not None
    P, reach = wavenumber_of(whole, far)
    assert reach == far
    with precision(64):
        for p in (P, -P, 2 * P, -2 * P):
            for x in (0.5, 1.3):
                assert EdgeBalls(whole, -1).edge(arb(p), arb(x)).z.value.real > reach


def test_it_is_no_better_than_the_theorem_at_one_point() -> None:
    whole = family()
    far, line = far_reach(whole), on_line(whole.base)
    assert far is not None
    assert line is not None
    assert prove_far(line).reach <= 2 * far


def test_nothing_is_claimed_of_other_vehicles_or_close_masses() -> None:
    assert far_reach(family(Case(alpha="0.9", eta_b="0.05", eta_m=(70, 40), positions=(0, "1e-9")))) is None


def test_where_no_theorem_tells_some_of_the_cut_is_looked_at() -> None:
    P, reach = wavenumber_of(family(), None)
    assert 0 < reach < 1e3
    assert P > 0
