"""Slanting cuts: the plane is turned exactly, and the zeros are those of mpmath and of the plane turned by hand."""

from __future__ import annotations

from fractions import Fraction

import mpmath
import pytest
from hypothesis import given
from hypothesis import strategies as st

from mpsolve import Cut, Disc, Polygon, Rectangle, roots
from mpsolve.errors import InputError
from mpsolve.zeros.evaluate import Evaluator
from mpsolve.zeros.parse import parse
from mpsolve.zeros.program import Expression, Program
from mpsolve.zeros.turned import composed, over, slant, times, turned_cut, turned_region

SLANT = "sqrt(-(3 - 4*i)*z/5) - 1/2 + z/7"  # √ of what is real and negative along 3 + 4i
gaussian = st.tuples(st.fractions(-9, 9, max_denominator=9), st.fractions(-9, 9, max_denominator=9)).filter(any)


def expression(text: str) -> Expression:
    program = Program()
    k = parse(program, text)
    return Expression(tuple(program.steps), k)


@given(gaussian, gaussian)
def test_quotients_of_complex_rationals_are_exact(a: tuple[Fraction, Fraction], b: tuple[Fraction, Fraction]) -> None:
    assert times(over(a, b), b) == a


@pytest.mark.parametrize(
    "text", [SLANT, "exp(z)/(z**3 - i*z + 2)", "(z - 1/3)**40", "log((z - 5)/(z + 2*i))", "pi*z"]
)
def test_the_composed_function_has_the_same_values(text: str) -> None:
    from flint import acb

    from mpsolve.numbers.balls import precision

    d = Fraction(3, 2), Fraction(-2)
    one, other = expression(text), composed(expression(text), d)
    with precision(128):
        w = acb(0.3, 0.7)
        here = Evaluator(one.steps).run(acb(1.5, -2) * w, 1)[one.numerator]
        there = Evaluator(other.steps).run(w, 1)[other.numerator]
        assert here.overlaps(there)
        assert float((here - there).abs_upper()) < 1e-20 * float(here.abs_upper())


def test_an_argument_that_is_real_on_the_cut_stays_real() -> None:
    from flint import acb

    there = composed(expression(SLANT), (Fraction(3), Fraction(4)))
    [argument] = [step[1] for step in there.steps if step[0] == "sqrt"]
    assert Evaluator(there.steps).run(acb(-1.7), 1)[argument].imag == 0


def test_a_zero_beside_a_slanting_ray_is_that_of_mpmath() -> None:
    answer = roots(SLANT, Rectangle(-3, 3, -3, 3), cuts=[Cut.ray(0, (3, 4))])
    assert answer.proved
    assert answer.count == 1
    assert "w = z/(3 + 4i)" in answer.note
    f = lambda z: mpmath.sqrt(-(3 - 4j) * z / 5) - mpmath.mpf(1) / 2 + z / 7  # noqa: E731
    truth = complex(mpmath.findroot(f, -0.13 - 0.23j))
    assert abs(complex(answer.roots[0].q) - truth) < 1e-13
    assert roots(SLANT, Disc(0, 3), cuts=[Cut.ray(0, (3, 4))]).count == 1


def test_two_slanting_cuts_give_the_zeros_of_the_plane_turned_by_hand() -> None:
    corners = [-5 - 5j, 4 - 5j, 4 + 6j, -5 + 6j]
    by_hand = roots(
        "sin(sqrt(z**2 + 1)) - (1 + i)*z",
        Polygon([over((Fraction(z.real), Fraction(z.imag)), (Fraction(1), Fraction(1))) for z in corners]),
        cuts=[Cut.ray(1j, 1j), Cut.ray(-1j, -1j)],
    )
    answer = roots(
        "sin(sqrt((z/(1 + i))**2 + 1)) - z",
        Rectangle(-5, 4, -5, 6),
        cuts=[Cut.ray(-1 + 1j, -1 + 1j), Cut.ray(1 - 1j, 1 - 1j)],
    )
    assert answer.proved
    assert by_hand.proved
    assert answer.count == by_hand.count == 2
    for one, other in zip(sorted(map(abs, _places(answer))), sorted(map(abs, _places(by_hand))), strict=True):
        assert abs(one - other * 2**0.5) < 1e-12


def _places(answer: object) -> list[complex]:
    return [complex(zero.q) for zero in answer.roots]  # type: ignore[attr-defined]


def test_a_segment_between_two_branch_points() -> None:
    # √((z − a)(z + a)) cut between ±a as z√(1 − a²/z²); zeros of that minus 3
    text = "z*sqrt(1 - (1 + 2*i)**2/z**2) - 3"
    cut = Cut.segment((-1, -2), (1, 2))
    answer = roots(text, Polygon([5 + 1j, 5 + 2j, 1 + 3j, 1 + 2.5j]), cuts=[cut])
    truth = complex(mpmath.sqrt(9 + (1 + 2j) ** 2))
    assert truth.imag < 0.8  # outside the first polygon
    assert answer.proved
    assert answer.count == 0
    found = roots(text, Rectangle(2, 4, 0, "1.5"), cuts=[cut])
    assert found.proved
    assert found.count == 1
    assert abs(complex(found.roots[0].q) - truth) < 1e-12


def test_cuts_of_two_slants_and_what_cannot_be_turned_is_refused() -> None:
    with pytest.raises(InputError, match="one slant"):
        slant([Cut.ray(0, 1 + 2j), Cut.ray(5, 1 + 1j)])
    with pytest.raises(InputError, match="3\\+4j"):
        roots(SLANT, Disc(0, 3), cuts=[Cut.ray(0, 1 + 2j)])
    assert slant([Cut.ray(0, 1j)]) is None
    assert slant([Cut.ray(0, 1 + 1j), Cut.ray(5, 1 - 1j)]) is not None
    for bad in (lambda: Cut.ray(0, 0), lambda: Cut.segment(1, 1)):
        with pytest.raises(InputError):
            bad()


def test_turned_cuts_lie_along_the_axes_and_regions_keep_their_corners() -> None:
    d = Fraction(3), Fraction(4)
    for cut in (Cut.ray(1, (3, 4)), Cut.ray(1, (-4, 3)), Cut.segment(1j, (3, 5))):
        there = turned_cut(cut, d)
        assert 0 in there.direction
        assert [times(tip, d) for tip in there.tips] == list(cut.tips)
    region = Rectangle(-1, 2, 0, 5)
    assert [times(p, d) for p in turned_region(region, d).polygon] == list(region.polygon)


def test_a_function_that_cannot_be_read_keeps_to_cuts_along_the_axes() -> None:
    with pytest.raises(InputError, match="axis"):
        roots(lambda z, _: z.sqrt() - 1, Rectangle(-3, 3, -3, 3), cuts=[Cut.ray(0, 3 + 4j)])


def test_a_cut_that_meets_a_corner_is_refused_and_the_plane_is_named() -> None:
    with pytest.raises(InputError, match=r"corner.*plane of w"):
        roots(SLANT, Rectangle(-3, 3, -4, 4), cuts=[Cut.ray(0, (3, 4))])
