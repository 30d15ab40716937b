"""Root balls as entries: pairs once, roots on an axis by themselves, and discs that hold the balls."""

from __future__ import annotations

from fractions import Fraction

from mpsolve.certificate.entries import root_entries
from mpsolve.numbers.balls import acb, arb, precision
from mpsolve.numbers.rootball import RootBall, Symmetry, on_grid


def ball(re: float, im: float, symmetry: Symmetry = Symmetry.NONE) -> RootBall:
    with precision(128):
        return on_grid(acb(arb(re), arb(im)), 60, 1, symmetry)


def test_a_pair_is_one_entry_and_others_stand_alone() -> None:
    one, left = ball(0.3, -0.1), ball(-0.7, 0.2)
    up = ball(0.0, 0.4, Symmetry.IMAGINARY)
    found = root_entries((one, one.mirrored, up, left))
    assert [entry.pair for entry in found] == [True, False, False]
    assert [entry.multiplicity for entry in found] == [1, 1, 1]


def test_the_disc_holds_the_ball() -> None:
    one = ball(0.3, -0.1)
    (entry,) = root_entries((one, one.mirrored))
    unit = Fraction(2) ** entry.exponent
    for middle, part in ((entry.re, one.q.real), (entry.im, one.q.imag)):
        mantissa, exponent = part.mid().man_exp()
        assert middle * unit == Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    mantissa, exponent = one.q.real.rad().man_exp()
    side = Fraction(int(mantissa)) * Fraction(2) ** int(exponent)
    assert entry.radius**2 > 2 * side**2


def test_a_real_root_by_symmetry() -> None:
    (entry,) = root_entries((ball(0.3, 0.0, Symmetry.REAL), ball(-0.3, 0.0, Symmetry.REAL)))
    assert (entry.im, entry.pair) == (0, True)


def test_the_order_is_not_that_of_the_search() -> None:
    balls = (ball(0.3, -0.1), ball(0.7, 0.2), ball(0.3, -0.4))
    found = [(entry.re, entry.im) for entry in root_entries(balls)]
    assert found == [(entry.re, entry.im) for entry in root_entries(balls[::-1])]
    assert found[0] == (root_entries(balls[1:2])[0].re, root_entries(balls[1:2])[0].im)


def test_a_cluster_about_the_axis_stands_alone() -> None:
    """It is its own mirror image, and no pair."""
    with precision(128):
        both = on_grid(acb(0, arb(0.4)), 60, 2, Symmetry.NONE)
    (entry,) = root_entries((both,))
    assert (entry.re, entry.pair, entry.multiplicity) == (0, False, 2)
