"""Proofs for all parameters, as short chains of steps; every identity in them is checked symbolically when asked for.

Notation: N = η_N − η_S, A = N + α², S² = p⁴ − 4Np² + 4, and D of eq. (18), taken from the derivation.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import sympy as sp

from .derivation import dispersion

_p, _q, _alpha, _eta_b, _axial, _shear = dispersion().arguments
_P, _Q, _a, _u, _z, _N = sp.symbols("P Q a u z N", positive=True)


@dataclass(frozen=True)
class Proof:
    """The steps in words; `holds` if every identity that they rest on was confirmed."""

    steps: tuple[str, ...]
    holds: bool


def _zero(expression: Any) -> bool:
    return bool(sp.expand(sp.numer(sp.together(expression))) == 0)


def _positive_terms(expression: Any, *symbols: Any) -> bool:
    """A polynomial in positive symbols of which no coefficient is negative, and which is not 0."""
    terms = sp.Poly(sp.expand(expression), *symbols).coeffs()
    return bool(terms) and all(term > 0 for term in terms)


def _undamped() -> Any:
    """D without damping, with N for η_N − η_S."""
    return dispersion().expression.subs({_eta_b: 0, _axial: _shear + _N})


@lru_cache(maxsize=1)
def undamped_roots_are_real() -> Proof:
    """For η_b = 0 and α < α_C = √(1 − N): every root on the sheet is real, for any masses."""
    A, D = _N + _alpha**2, _undamped()
    stiff = _p**4 - 4 * A * _p**2 + 4
    checks = (
        _zero(D - (stiff + 8 * _alpha * _p * _q - 4 * _q**2)),
        _zero(stiff - ((_p**2 - 2 * A) ** 2 + 4 * (1 - A**2))),
    )
    steps = (
        "A root q off the cut has a field w in L² with ∫D|ŵ|² dp/2π = 4q² Σ η_M,j |w(x_j)|² (eq. (15) times w̄).",
        "D = (p⁴ − 4Ap² + 4) + 8αpq − 4q² [identity]: so m q² − 2g q − κ = 0 with m = 4∫|ŵ|² + 4Σ η_M,j|w(x_j)|² > "
        "0, g = −(−4α∫p|ŵ|²) real, κ = ∫(p⁴ − 4Ap² + 4)|ŵ|².",
        "p⁴ − 4Ap² + 4 = (p² − 2A)² + 4(1 − A²) [identity] > 0 for |A| < 1, and term by term for A ≤ 0; "
        "A < 1 is α < α_C. So κ > 0.",
        "q = (g ± √(g² + mκ))/m is real: no root is unstable, and none is complex.",
    )
    return Proof(steps, all(checks))


@lru_cache(maxsize=1)
def lines_in_the_gap() -> Proof:
    """For η_b = 0, α < α_C: two equal masses have one or two pairs, in the order that conclusions (v), (vi) state."""
    D = _undamped()
    S2 = _p**4 - 4 * _N * _p**2 + 4
    growth = S2 - 4 * _alpha**2 * _p**2 + 4 * _alpha * _p * _q
    bound = 4 * (_Q + _a * _P) ** 2  # S² exceeds it at p = ±P
    ahead = bound - 4 * _a**2 * _P**2 + 4 * _a * _P * _Q
    behind = bound - 4 * _a**2 * _P**2 - 4 * _a * _P * _Q
    checks = (
        _zero(D - (S2 - 4 * (_q - _alpha * _p) ** 2)),
        _zero((_q**2 / D).diff(_q) * D**2 - 2 * _q * growth),
        _positive_terms(ahead, _Q, _a, _P),
        _positive_terms(behind, _Q, _a, _P),
    )
    steps = (
        *undamped_roots_are_real().steps[-1:],
        "In the gap 0 < q < q_lm = min_p(S/2 − αp): S > 2(q + α|p|), so D = S² − 4(q − αp)² [identity] > 0 for all "
        "real p, and [K(x_i − x_j, q)] = ∫ … dp/D is Hermitian and positive definite: 0 ≤ |K(d)| < K(0).",
        "∂(q²/D)/∂q = 2q (S² − 4α²p² + 4αpq)/D² [identity], and with S > 2(q + α|p|) the bracket exceeds a "
        "polynomial in q, α, |p| with positive coefficients only [expanded for p > 0 and p < 0]: q²K grows strictly "
        "with q.",
        "With a = 2η_M q²/π the roots are 1 = a(K(0) + |K(d)|) (lower line) and 1 = a(K(0) − |K(d)|) (higher line); "
        "both sides grow strictly from 0: at most one root each. K(0) → ∞ at q_lm, so the lower line always exists.",
        "a(K(0) − |K(d)|) ≤ aK(0) ≤ a(K(0) + |K(d)|) < 2aK(0): so q_doubled < q_lower ≤ q_single ≤ q_higher, with "
        "equality only where K(d) = 0.",
    )
    return Proof(steps, undamped_roots_are_real().holds and all(checks))


@lru_cache(maxsize=1)
def one_damped_mass_is_stable() -> Proof:
    """For N = 0, η_b > 0 and α ≤ 1: no mass, however heavy, is unstable."""
    D = dispersion().expression.subs({_axial: _shear})
    u = _q - _alpha * _p
    S2 = _p**4 + 4

    def square(side: int) -> Any:
        return S2.subs(_p, (_Q - side * _u) / _a)

    X, Y = square(1), square(-1)
    size = [(s - 4 * _u**2) ** 2 + 64 * _eta_b**2 * _u**2 for s in (X, Y)]
    rest = X + Y - 8 * _u**2 - 2 * (_Q**4 + 6 * _Q**2 * _u**2) / _a**4
    checks = (
        _zero(D - (S2 - 4 * u**2 + 8 * sp.I * _eta_b * u)),
        _zero(size[1] - size[0] - (Y - X) * (X + Y - 8 * _u**2)),
        _zero((Y - X) - 8 * _Q * _u * (_Q**2 + _u**2) / _a**4),
        _zero(rest.subs(_u, _a * sp.sqrt(_z)) - 2 * ((_z - 2 * _a**2) ** 2 + 4 * (1 - _a**4))),
    )
    steps = (
        "At real q, with u = q − αp: D = S² − 4u² + 8iη_b u [identity], so Im K(0, q) = −8η_b ∫ u/|D|² dp.",
        "The points u and −u (u > 0) have S² = X and Y; their |D|² differ by (Y − X)(X + Y − 8u²) [identity].",
        "Y − X = 8qu(q² + u²)/α⁴ > 0 [identity] for q > 0, and X + Y − 8u² ≥ 2((u²/α² − 2α²)² + 4(1 − α⁴)) "
        "[identity] ≥ 0 for α ≤ 1, where equality is left out by q > 0: |D|² is larger at −u, so Im K(0, q) < 0. At "
        "rest, α = 0, u = q and Im K(0, q) < 0 too.",
        "So 1 = (2η_M q²/π) K(0, q) has no real root q ≠ 0 for any η_M: none crosses the real axis; for η_M → 0 none "
        "is below it. The mass is stable.",
    )
    return Proof(steps, all(checks))


@lru_cache(maxsize=1)
def symmetries() -> dict[str, bool]:
    """For real p: D(−p, −q̄) = conj D(p, q), and without damping D(p, q̄) = conj D(p, q)."""
    real = sp.symbols("p_r alpha_r eta_r N_r S_r", real=True)
    at = dict(zip((_p, _alpha, _eta_b, _axial, _shear), real, strict=True))
    D = dispersion().expression.subs(at)
    mirrored = D.subs({real[0]: -real[0], _q: -sp.conjugate(_q)}, simultaneous=True)
    pair = _zero(sp.expand(sp.conjugate(D)) - sp.expand(mirrored))
    undamped = D.subs(real[2], 0)
    four = _zero(sp.expand(sp.conjugate(undamped)) - sp.expand(undamped.subs(_q, sp.conjugate(_q))))
    return {"pair": pair, "four": four}
