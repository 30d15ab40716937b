"""The paper's cases as problems: their receptance is (2/π) K, their characteristic function the paper's Δ."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import mpmath
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from oracle import Truth, cases, frequencies

import mpsolve
from mpsolve import Case, PhysicalCase, onset
from mpsolve.errors import InputError
from mpsolve.problem.cases import as_problem, value_at
from mpsolve.problem.problem import Problem
from mpsolve.tracks import String
from mpsolve.tracks.waveguide import Polynomial, moving
from mpsolve.vehicles import Mass

CTX = mpmath.MPContext()
CTX.prec = 160


def number(x: Fraction) -> Any:
    return CTX.mpf(x.numerator) / x.denominator


class General:
    """G and Δ̃ of a problem by residues, in mpmath: i Σ N e^{ipξ}/D_p over the upper p-roots."""

    def __init__(self, problem: Problem, q: Any) -> None:
        guide, self.pencil, self.q = problem.track.waveguide, problem.pencil, q
        D, N = (self._in_p(moving(a, problem.v)) for a in (guide.dispersion, guide.numerator))
        roots = CTX.polyroots(D, maxsteps=500, extraprec=200)
        self.upper = [(p, self._value(N, p) / self._slope(D, p)) for p in roots if p.imag > 0]
        self.lower = [(p, self._value(N, p) / self._slope(D, p)) for p in roots if p.imag < 0]

    def _in_p(self, a: Polynomial) -> list[Any]:
        """Coefficients in p, highest first, at P = ip, σ = iq."""
        i = CTX.mpc(0, 1)
        top = max(k for k, _ in a)
        rows = [
            sum(number(c) * (i * self.q) ** j for (m, j), c in a.items() if m == k) * i**k for k in range(top + 1)
        ]
        return rows[::-1]

    def _value(self, a: list[Any], p: Any) -> Any:
        return CTX.polyval(a, p)

    def _slope(self, a: list[Any], p: Any) -> Any:
        return CTX.polyval(a, p, derivative=True)[1]

    def G(self, xi: Any) -> Any:
        roots, sign = (self.upper, 1) if xi >= 0 else (self.lower, -1)
        return sign * CTX.mpc(0, 1) * sum(residue * CTX.expj(p * xi) for p, residue in roots)

    def determinant(self) -> Any:
        """det [[S, −B], [Bᵀ, G + diag h]]."""
        c, q = self.pencil, self.q
        n, m = c.size, c.contacts
        A = CTX.matrix(n + m, n + m)
        for i in range(n):
            for j in range(n):
                A[i, j] = number(c.K[i][j]) + CTX.mpc(0, 1) * q * number(c.C[i][j]) - q * q * number(c.M[i][j])
            for j in range(m):
                A[i, n + j], A[n + j, i] = -number(c.B[i][j]), number(c.B[i][j])
        for i in range(m):
            for j in range(m):
                A[n + i, n + j] = self.G(number(c.places[i] - c.places[j])) + (number(c.h[i]) if i == j else 0)
        return CTX.det(A)


def close(value: Any, truth: Any) -> bool:
    return bool(abs(value - truth) < CTX.mpf(10) ** -30 * (1 + abs(truth)))


@settings(max_examples=30)
@given(st.data())
def test_G_is_the_paper_s_kernel_and_the_determinant_its_delta(data: st.DataObject) -> None:
    case = data.draw(cases(data.draw(st.integers(1, 3)), most_damping=0.9))
    drawn = data.draw(frequencies(case))
    q = CTX.mpc(drawn.real, -abs(drawn.imag))
    truth, general = Truth(case, 48), General(as_problem(case), q)
    for xi in (0, CTX.mpf("0.75"), CTX.mpf(2), -CTX.mpf("0.75")):
        assert close(general.G(xi), 2 / CTX.pi * CTX.convert(truth.kernel(xi, q)))
    assert close(general.determinant(), CTX.convert(truth.delta(q)))


def test_the_physical_case_is_the_dimensionless_one_in_si() -> None:
    """χ = 1/2 1/m and √(k/m) = 100 rad/s: q in rad/s is 100 times the paper's, and Δ is the same."""
    physical = PhysicalCase(EI="1.6e6", m=40, k="4e5", v=90, c=500, kp=1000, N="2e4", masses=[(2000, 0), (900, 3)])
    case = physical.dimensionless
    assert (physical.chi, physical.time_scale) == (Fraction(1, 2), 100)
    for q in (CTX.mpc("0.7", "-0.3"), CTX.mpc("-1.1", "-0.05"), CTX.mpc("3", "-2")):
        truth = CTX.convert(Truth(case, 48).delta(q))
        assert close(General(as_problem(case), q).determinant(), truth)
        assert close(General(as_problem(physical), 100 * q).determinant(), truth)


def test_masses_at_one_place_move_as_one() -> None:
    """They stay apart in the problem, each with its contact, and Δ is that of their sum."""
    case = Case(alpha="0.3", eta_b="0.1", eta_m=(1, 2, 4), positions=(0, 0, 1))
    assert as_problem(case).pencil.places == (0, 0, 1)
    q = CTX.mpc("0.4", "-0.2")
    assert close(General(as_problem(case), q).determinant(), General(as_problem(case.merged), q).determinant())


def test_a_problem_is_itself() -> None:
    problem = Problem(String(T=1, m=1), Mass(1), v=0)
    assert as_problem(problem) is problem


@pytest.mark.parametrize(
    ("change", "key"),
    [({"alpha": "root4(2)"}, "alpha"), ({"eta_m": [1, "root4(2)"]}, "eta_m[2]"), ({"eta_s": "root4(3)"}, "eta_s")],
)
def test_irrational_ratios_are_refused(change: dict[str, Any], key: str) -> None:
    given_ = {"alpha": 0, "eta_b": "0.1", "eta_m": (1, 1), "positions": (0, 1)} | change
    with pytest.raises(InputError, match="PhysicalCase") as caught:
        as_problem(Case(**given_))
    assert caught.value.key == key
    with pytest.raises(InputError, match="of type str"):
        as_problem("case")


def test_mpmath_itself_agrees_at_one_point() -> None:
    """G by quadrature over real wavenumbers, (1/2π) ∫ e^{ipξ}/D dp."""
    problem = as_problem(Case(alpha="0.4", eta_b="0.2", eta_m=1, eta_s="0.3"))
    q, xi = mpmath.mpc(0.6, -0.3), 0.9
    omega = lambda p: q - 0.4 * p  # noqa: E731
    integrand = lambda p: mpmath.expj(p * xi) / (p**4 / 4 + 0.3 * p**2 + 1 + 0.4j * omega(p) - omega(p) ** 2)  # noqa: E731
    integral = mpmath.quad(integrand, [-200, -20, -5, -2, 0, 2, 5, 20, 200]) / (2 * mpmath.pi)
    value = General(problem, CTX.mpc(0.6, -0.3)).G(CTX.mpf(0.9))
    assert abs(complex(integral) - complex(value)) < 1e-6


def test_values_may_have_units_but_for_the_paper_s_ratios() -> None:
    """`onset(over={"v": ("0 km/h", "400 km/h")})` was refused, and 1 km/h of a Case taken for α = 0.28."""
    wire = Problem(String(T=1, m=1), Mass(1), v=0)
    assert value_at(wire, "v", "36 km/h") == 10
    assert value_at(wire, "track.m", "0.1") == Fraction(1, 10)
    with pytest.raises(InputError, match="ends: is '3 kg', whose unit is kg"):
        value_at(wire, "v", "3 kg", "ends")
    paper = Case(alpha="0.5", eta_b="0.1", eta_m=[3], positions=[0])
    assert value_at(paper, "v", "0.7") == Fraction(7, 10)
    with pytest.raises(InputError, match="v: is '1 km/h', but a Case holds the paper's ratios: give a number alone"):
        value_at(paper, "v", "1 km/h")
    with pytest.raises(InputError, match="is unknown"):
        value_at(paper, "V", 1)
    for ask in (mpsolve.frequencies, onset):
        with pytest.raises(InputError, match="a Case holds the paper's ratios"):
            ask(paper, over={"v": ["0 km/h", "1 km/h"]})  # type: ignore[operator]
