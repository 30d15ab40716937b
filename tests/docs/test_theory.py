"""The formulas of the theory pages, read from the pages, against the symbolic derivation and against quadrature."""

from __future__ import annotations

import re
from typing import Any

import numpy as np
import pytest
import sympy as sp
from theory_pages import BEAM, COUNTING, GAP, MASS, MODEL, PAIR, PLANE, V, dispersion, displayed, growing, integral

from mpsolve import certify, receptance, tracks
from mpsolve.batch.view import look
from mpsolve.derivation.tracks import Omega, derived, p, symbols_of

OWN = symbols_of(tracks.EulerBernoulli)
NAMES = {"EI": OWN.EI, "N_x": OWN.N, "m": OWN.m, "c": OWN.c, "k": OWN.k}


def polynomial(text: str) -> Any:
    """A polynomial in LaTeX with one-letter symbols, EI and N_x, as sympy's."""
    plain = text.replace(r"\,", " ").replace(r"\Omega", "Omega").rstrip(" .").replace("^", "**")
    plain = re.sub(r"(?<=[\w}]) +(?=[\w(])", "*", plain)
    return sp.sympify(plain, locals=NAMES | {"i": sp.I, "p": p, "Omega": Omega, "X": sp.I * p, "T": sp.I * Omega})


def test_the_dispersion_function_is_the_derived_one() -> None:
    shown = polynomial(displayed(MODEL, r"D(p, \Omega) =").partition("=")[2])
    assert sp.expand(shown - derived(tracks.EulerBernoulli).dispersion.subs({OWN.eta: 0, OWN.kp: 0})) == 0


def test_the_equation_of_motion_leads_to_it() -> None:
    """∂/∂x → ip and ∂/∂t → iΩ, as the page says."""
    left = displayed(MODEL, r"EI\,\frac").partition("=")[0]
    left = re.sub(
        r"\\frac\{\\partial(?:\^(\d))? w\}\{\\partial ([xt])(?:\^\d)?\}",
        lambda f: f"{f[2].upper()}^{f[1] or 1}",
        left,
    )
    shown = polynomial(left.replace(r"k\,w", "k"))
    assert sp.expand(shown - derived(tracks.EulerBernoulli).dispersion.subs({OWN.eta: 0, OWN.kp: 0})) == 0


def test_the_vehicle_s_matrix_is_that_of_its_equation_of_motion() -> None:
    assert "$S(q) = K + iqC - q^2 M$" in MODEL
    K, C, M, q, t = sp.symbols("K C M q t")
    y = sp.exp(sp.I * q * t)
    motion = M * y.diff(t, 2) + C * y.diff(t) + K * y
    assert sp.expand(sp.simplify(motion / y) - sp.sympify("K + I*q*C - q**2*M", locals={"C": C})) == 0


def bordered(q: complex, places: list[float]) -> Any:
    """[[S, −B], [Bᵀ, G + h]] of tight masses at these places, as the page shows it."""
    n = len(places)
    x = np.array(places)
    G = receptance(BEAM, (x[:, None] - x).ravel().tolist(), q, v=V)[:, 0].reshape(n, n)
    return np.block([[-(q**2) * MASS * np.eye(n), -np.eye(n)], [np.eye(n), G]])


def test_the_determinant_vanishes_at_a_certified_root() -> None:
    assert displayed(MODEL, r"\Delta(q)") == (
        r"\Delta(q) = \det\begin{pmatrix} S(q) & -B \\ B^T & G(q) + h \end{pmatrix} = 0 ."
    )
    q = growing()
    near = abs(np.linalg.det(bordered(q * (1 + 1e-3), [0, GAP])))
    assert abs(np.linalg.det(bordered(q, [0, GAP]))) < 1e-8 * near


def test_a_single_mass_obeys_the_short_formula() -> None:
    """det [[−q²M, −1], [1, G]] is 1 − q²MG: the page's 1 = q² M G(0, q)."""
    assert "$1 = q^2 M\\,G(0, q)$" in MODEL
    q, M, G = sp.symbols("q M G")
    assert sp.expand(sp.Matrix([[-(q**2) * M, -1], [1, G]]).det() - (1 - q**2 * M * G)) == 0


@pytest.mark.parametrize("xi", [0.0, 2.0, -1.5])
def test_the_receptance_is_the_integral_over_all_waves(xi: float) -> None:
    assert displayed(MODEL, r"G(\xi, q)").endswith(
        r"\frac{1}{2\pi}\int_{-\infty}^{\infty} \frac{N}{D}\, e^{ip\xi}\, dp ,"
    )
    found = integral(lambda wave: np.exp(1j * wave * xi) / dispersion(wave, 20.0)) / (2 * np.pi)
    assert found == pytest.approx(complex(receptance(BEAM, xi, 20.0, v=V)[0, 0]), rel=1e-5)


def test_cuts_are_where_the_page_says() -> None:
    """On a drawn cut q = vp + Ω, Ω a free wave at rest with real p: then D(p, q − vp) = 0."""
    assert displayed(PLANE, "q = vp") == r"q = vp + \Omega_k(p), \qquad p \text{ real},"
    for cut in look(PAIR).cuts:
        for q in cut[np.isfinite(cut)][::40]:
            roots = np.roots([6.4e6, 0, -60 * V**2, 120 * q * V - 770j * V, -60 * q**2 + 770j * q + 1e6])
            assert np.abs(roots.imag).min() < 1e-6 * np.abs(roots).max()


def test_the_count_is_that_of_the_formula() -> None:
    """n from the turn T of Δ over 0 … ρ and the pivots of the accretive matrix at ρ: what certify proves."""
    assert displayed(COUNTING, "n =") == (
        r"n = \frac{1}{\pi}\Big( \sum_k \mathrm{Arg}\,(\text{pivot}_k \text{ at } \rho) "
        r"+ (n_b - n_c - n_z)\,\frac{\pi}{2} - T \Big),"
    )
    rho, places = 400.0, [0, GAP]
    q = np.concatenate([[1e-6], np.geomspace(1e-3, 1, 200), np.linspace(1, rho, 20_000)[1:]])
    x = np.array(places)
    G = receptance(BEAM, (x[:, None] - x).ravel().tolist(), q, v=V).reshape(2, 2, -1)
    matrices = np.zeros((len(q), 4, 4), complex)
    matrices[:, 0, 0] = matrices[:, 1, 1] = -(q**2) * MASS
    matrices[:, :2, 2:], matrices[:, 2:, :2] = -np.eye(2), np.eye(2)
    matrices[:, 2:, 2:] = np.moveaxis(G, -1, 0)
    angle = np.unwrap(np.angle(np.linalg.det(matrices)))
    sigma, last = 1j * rho, matrices[-1].copy()
    last[:2, :2], last[2:, 2:] = last[:2, :2] / sigma, sigma * last[2:, 2:]
    pivots = []
    for _ in range(4):
        pivots.append(last[0, 0])
        last = last[1:, 1:] - np.outer(last[1:, 0], last[0, 1:]) / last[0, 0]
    n = (np.angle(pivots).sum() + 0 * np.pi / 2 - (angle[-1] - angle[0])) / np.pi
    assert n == pytest.approx(certify(PAIR, region="unstable", digits=15, check=False).unstable, abs=1e-3)
