"""The independent truth: the paper's own residue sums over the p-roots of (18), in mpmath at any precision.

Nothing of the package's formulas is used: no resolvent cubic, no scaling, no balls. Cases are rational.
"""

from __future__ import annotations

from typing import Any

import flint
import mpmath
import numpy as np
from hypothesis import strategies as st

from mpsolve import Case


class Truth:
    """The functions of one case at `digits` decimal digits; arguments may be anything mpmath takes."""

    def __init__(self, case: Case, digits: int = 40) -> None:
        self.mp = mp = mpmath.MPContext()
        mp.dps = digits

        def number(x: Any) -> Any:
            return mp.mpf(x.as_fraction().numerator) / x.as_fraction().denominator

        self.alpha, self.eta_b = number(case.alpha), number(case.eta_b)
        self.axial = number(case.eta_n) - number(case.eta_s)
        self.eta_m, self.x = [number(v) for v in case.eta_m], [number(v) for v in case.positions]

    def quartic(self, q: Any) -> list[Any]:
        """Coefficients of D(p, q) in p, eq. (18), with the highest power first."""
        i, alpha, eta_b = self.mp.j, self.alpha, self.eta_b
        quadratic = -4 * (self.axial + alpha**2)
        return [1, 0, quadratic, 8 * alpha * q - 8 * i * eta_b * alpha, 4 - 4 * q**2 + 8 * i * eta_b * q]

    def p_roots(self, q: Any) -> tuple[list[Any], list[Any]]:
        """The p-roots above and below the real axis."""
        D = self.quartic(self.mp.mpmathify(q))
        start = [self.mp.mpc(p) for p in np.roots([complex(c) for c in D])]
        roots = self.mp.polyroots(D, maxsteps=500, extraprec=self.mp.prec, roots_init=start)
        upper, lower = [p for p in roots if p.imag > 0], [p for p in roots if p.imag < 0]
        assert len(upper) == len(lower) == 2, "q is on the cut"
        return upper, lower

    def kernel(self, g: Any, q: Any) -> Any:
        """(37), and its mirror image for g < 0."""
        return self._residue_sum(g, q, self.p_roots(q))

    def _residue_sum(self, g: Any, q: Any, p_roots: tuple[list[Any], list[Any]]) -> Any:
        poles, sign = (p_roots[0], 1) if g >= 0 else (p_roots[1], -1)
        D = self.quartic(self.mp.mpmathify(q))
        return 2 * self.mp.pi * self.mp.j * sign * sum(self.mp.expj(p * g) / _polynomial(D, p)[1] for p in poles)

    def kernel_rate(self, g: Any, q: Any) -> Any:
        """(39), corrected: 2πi Σ [D_q D_pp e^{ipg}/D_p³ − (D_q e^{ipg})_p/D_p²]."""
        upper, lower = self.p_roots(q)
        poles, sign = (upper, 1) if g >= 0 else (lower, -1)
        i, total = self.mp.j, 0
        for p in poles:
            _, slope, curve = _polynomial(self.quartic(self.mp.mpmathify(q)), p)
            D_q = -8 * q + 8 * self.alpha * p + 8 * i * self.eta_b
            D_qp, wave = 8 * self.alpha, self.mp.expj(p * g)
            total += D_q * curve * wave / slope**3 - (D_qp + i * g * D_q) * wave / slope**2
        return 2 * self.mp.pi * i * sign * total

    def delta(self, q: Any) -> Any:
        """(26) over π², and its like for any number of masses."""
        q, n = self.mp.mpmathify(q), len(self.x)
        p_roots = self.p_roots(q)
        K = {gap: self._residue_sum(gap, q, p_roots) for gap in {x - y for x in self.x for y in self.x}}
        factor = 2 * q**2 / self.mp.pi
        rows = [[(i == k) - factor * self.eta_m[k] * K[self.x[i] - self.x[k]] for k in range(n)] for i in range(n)]
        return self.mp.det(self.mp.matrix(rows))

    def resultant(self, q: Any) -> Any:
        """R: the product of all differences of an upper and a lower p-root."""
        upper, lower = self.p_roots(q)
        return self.mp.fprod(p - o for p in upper for o in lower)

    def root(self, seed: Any, offset: float = 1e-9) -> Any:
        """The root of Δ that the secant method reaches from `seed` and a second point beside it."""
        a = self.mp.mpmathify(seed)
        b = a * (1 + self.mp.mpf(offset))
        fa, fb = self.delta(a), self.delta(b)
        for _ in range(60):
            step = fb * (b - a) / (fb - fa)
            a, fa, b = b, fb, b - step
            if abs(step) < abs(b) * self.mp.mpf(10) ** (8 - self.mp.dps):
                return b
            fb = self.delta(b)
        raise ArithmeticError(f"no root of the truth near {complex(a)}")

    def middle(self, ball: Any) -> Any:
        """The middle of a ball, exactly, where the precision allows."""
        parts = [self.mp.ldexp(int(m), int(e)) for m, e in (x.mid().man_exp() for x in (ball.real, ball.imag))]
        return self.mp.mpc(*parts)

    def search(self, radius: float) -> list[complex]:
        """Roots with Re q ≥ 0, |q − iη_b| < radius, by the secant method in float64 from many starts."""
        shift = 1j * float(self.eta_b)
        rho, turn = np.meshgrid(np.geomspace(0.02, radius, 32), np.linspace(-0.498, 0.498, 24) * np.pi)
        a = (rho * np.exp(1j * turn)).ravel() + shift
        b = a * (1 + 1e-4)
        found: list[complex] = []
        with np.errstate(all="ignore"):
            fa, fb = self._delta_array(a), self._delta_array(b)
            for _ in range(40):
                step = np.where(fb == fa, 0, fb * (b - a) / (fb - fa))
                settled = (np.abs(step) < 1e-11 * np.abs(b)) & (np.abs(fb) < 1e-6)
                found += b[settled & (np.abs(b - shift) < radius) & (np.abs(b) > 1e-9)].tolist()
                keep = ~settled & (np.abs(b) < 4 * radius)
                step *= np.minimum(1, 0.2 * np.abs(b) / np.where(step == 0, 1, np.abs(step)))
                a, fa, b = b[keep], fb[keep], (b - step)[keep]
                fb = self._delta_array(b)
        distinct: list[complex] = []
        for q in (z if z.real > -1e-10 else -z.conjugate() for z in found):
            if all(abs(q - other) > 1e-7 * abs(q) for other in distinct):
                distinct.append(q)
        return sorted(distinct, key=abs)

    def _delta_array(self, q: Any) -> Any:
        """`delta` of an array of q in float64."""
        alpha, eta_b, quadratic = float(self.alpha), float(self.eta_b), float(self.quartic(0)[2])
        linear, constant = 8 * alpha * (q - 1j * eta_b), 4 - 4 * q**2 + 8j * eta_b * q
        companion = np.zeros((*q.shape, 4, 4), complex)
        companion[..., 0, 1:] = np.stack([0 * q - quadratic, -linear, -constant], -1)
        companion[..., [1, 2, 3], [0, 1, 2]] = 1
        p = np.linalg.eigvals(companion)
        p = np.take_along_axis(p, np.argsort(-p.imag, axis=-1), -1)
        residue = 1 / (4 * p**3 + 2 * quadratic * p + linear[..., None])
        x = np.array([float(v) for v in self.x])
        gap = (x[:, None] - x)[..., None]
        wave = np.exp(1j * p[..., None, None, :] * gap) * residue[..., None, None, :]
        K = 2j * np.pi * np.where(gap[..., 0] >= 0, wave[..., :2].sum(-1), -wave[..., 2:].sum(-1))
        eta_m = np.array([float(v) for v in self.eta_m])
        return np.linalg.det(np.eye(len(x)) - (2 * q**2 / np.pi)[..., None, None] * K * eta_m)


def _polynomial(coefficients: list[Any], p: Any) -> tuple[Any, Any, Any]:
    """Value and two derivatives."""
    value = slope = curve = 0
    for c in coefficients:
        curve = curve * p + 2 * slope
        slope = slope * p + value
        value = value * p + c
    return value, slope, curve


def holds(ball: Any, truth: Any) -> bool:
    """The number `truth` of mpmath (taken exactly) lies in the ball."""
    return bool(flint.acb(ball).contains(flint.acb(truth)))


def sharp(ball: Any, bits: float) -> bool:
    """The radius is below 2^−bits of the modulus."""
    ball = flint.acb(ball)
    return bool((ball - ball.mid()).abs_upper() < ball.abs_lower() * flint.arb(2) ** -bits)


def point(q: complex) -> Any:
    """The exact ball of a float64 number."""
    return flint.acb(q.real, q.imag)


def grid(low: float, high: float) -> st.SearchStrategy[float]:
    """Multiples of 2⁻¹⁰ from `low` to `high`: the same number in every arithmetic."""
    return st.integers(round(low * 1024), round(high * 1024)).map(lambda k: k / 1024)


@st.composite
def cases(draw: st.DrawFn, masses: int = 1, most_damping: float = 0.99) -> Case:
    """α in [0, 1.5], η_b below 1, N in (−2, β), masses within 0.1 … 100, gaps within 0.06 … 4."""
    eta_b = draw(grid(0, most_damping))
    highest = (1 - eta_b**2) ** 0.5 - 0.02
    gaps = draw(st.lists(grid(0.06, 4), min_size=masses - 1, max_size=masses - 1))
    return Case(
        alpha=draw(grid(0, 1.5)),
        eta_b=eta_b,
        eta_n=draw(grid(0, highest)) if draw(st.booleans()) else 0,
        eta_s=draw(grid(0, 2)) if draw(st.booleans()) else 0,
        eta_m=draw(st.lists(grid(0.1, 100), min_size=masses, max_size=masses)),
        positions=np.cumsum([0, *gaps]).tolist(),
    )


@st.composite
def frequencies(draw: st.DrawFn, case: Case, clearance: float = 2**-6) -> complex:
    """q off the cut line by at least `clearance`, on either side of it, and off 0."""
    height = draw(grid(clearance, 3)) * draw(st.sampled_from([-1, 1]))
    return complex(draw(grid(-3, 3)), float(case.eta_b) + height)
