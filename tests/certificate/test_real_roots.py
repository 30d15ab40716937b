"""Real zeros with their multiplicities, against algebra and mpmath; bad input refused."""

from __future__ import annotations

import flint
import mpmath
import pytest

from mpsolve import InputError, Rectangle, Status, real_roots, roots


def test_real_zeros_with_multiplicity() -> None:
    answer = real_roots("(z - 1)**3*(z**2 - 2*z - 24.11)", -10, 10)
    assert [(zero.multiplicity, float(zero.q)) for zero in answer.roots] == [
        (1, pytest.approx(1 - 25.11**0.5)),
        (3, pytest.approx(1)),
        (1, pytest.approx(1 + 25.11**0.5)),
    ]
    assert answer.status is Status.PROVED
    assert real_roots("tan(z)", -10, 10).count == 7
    energies = real_roots("tan(sqrt(2*z)) + sqrt(z/(3*pi**2 - z))", "0.1", 29)
    f = lambda x: mpmath.tan(mpmath.sqrt(2 * x)) + mpmath.sqrt(x / (3 * mpmath.pi**2 - x))  # noqa: E731
    for zero, guess in zip(energies.roots, (4, 17), strict=True):
        assert abs(f(mpmath.mpf(float(zero.q)))) < 1e-10, guess
    ends = real_roots("sin(z)", 0, 10)
    assert ends.count == 4
    double = real_roots("sin(z)**2 - 1", -10, 10)
    assert double.reason is not None
    assert double.reason.code == "open-tile"
    assert real_roots("cosh(z) - 2", -2, 2).count == 2


def test_bad_input_is_refused_in_a_sentence() -> None:
    with pytest.raises(InputError, match="ends in order"):
        real_roots("z", 1, 0)
    with pytest.raises(InputError, match="real axis"):
        real_roots("z + i", 0, 1)


NEARLY_REAL = "z - 1 + sqrt(-1)/3 - 0.333333333333333333333333333333*sqrt(-1)"
"""Its only zero is 1 − 3.3·10⁻³¹ i, by hand."""


@pytest.mark.parametrize("f", [NEARLY_REAL, "z + log(-2)", "z - 1 + sqrt(log(1/2))/10**40"])
def test_constants_that_are_complex_without_an_i_are_not_taken_for_real(f: str) -> None:
    with pytest.raises(InputError, match="real axis"):
        real_roots(f, -3, 3)


def test_a_zero_next_to_the_real_axis_is_not_said_to_lie_on_it() -> None:
    for digits in (15, 40):
        (zero,) = roots(NEARLY_REAL, Rectangle(-3, 3, -4, 4), digits=digits).roots
        assert not zero.real
        assert zero.q.imag.contains(flint.fmpq(-1, 3 * 10**30))
