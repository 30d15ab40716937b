"""The formulas of the theory pages, read from the pages, against the symbolic derivation and against quadrature."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

from mpsolve import Problem, certify, receptance, tracks, vehicles
from mpsolve.batch.view import look
from mpsolve.derivation.tracks import Omega, derived, p, symbols_of

THEORY = Path(__file__).parents[2] / "docs" / "theory"
MODEL, PLANE, PASSIVITY, COUNTING = (
    (THEORY / f"{name}.md").read_text("utf-8") for name in ("model", "plane", "passivity", "counting")
)
BEAM = tracks.EulerBernoulli(EI="6.4e6", m=60, k="1e6", c=770)
V, GAP, MASS = 250, 3.4, 10000
PAIR = Problem(BEAM, [vehicles.Mass(MASS).at(0), vehicles.Mass(MASS).at("3.4")], v=V)
OWN = symbols_of(tracks.EulerBernoulli)
NAMES = {"EI": OWN.EI, "N_x": OWN.N, "m": OWN.m, "c": OWN.c, "k": OWN.k}


def displayed(page: str, beginning: str) -> str:
    """The displayed formula that begins so."""
    (found,) = [
        one.strip()
        for one in re.findall(r"\$\$(.*?)\$\$", page, flags=re.DOTALL)
        if one.strip().startswith(beginning)
    ]
    return found


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


def growing() -> complex:
    (root,) = [r for r in certify(PAIR, region="unstable", digits=15, check=False).roots if r.q.real > 0]
    return complex(root.q)


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


def integral(of: Any, reach: float = 200.0, points: int = 800_001) -> complex:
    wave = np.linspace(-reach, reach, points)
    return complex(np.trapezoid(of(wave), wave))


def dispersion(wave: Any, q: float) -> Any:
    at_rest = q - V * wave
    return 6.4e6 * wave**4 - 60 * at_rest**2 + 770j * at_rest + 1e6


@pytest.mark.parametrize("xi", [0.0, 2.0, -1.5])
def test_the_receptance_is_the_integral_over_all_waves(xi: float) -> None:
    assert displayed(MODEL, r"G(\xi, q)").endswith(
        r"\frac{1}{2\pi}\int_{-\infty}^{\infty} \frac{N}{D}\, e^{ip\xi}\, dp ,"
    )
    found = integral(lambda wave: np.exp(1j * wave * xi) / dispersion(wave, 20.0)) / (2 * np.pi)
    assert found == pytest.approx(complex(receptance(BEAM, xi, 20.0, v=V)[0, 0]), rel=1e-5)


def test_what_one_force_gives_is_the_integral_of_the_waves() -> None:
    assert displayed(PASSIVITY, r"-\mathrm{Im}\, G").endswith(
        r"\frac{1}{2\pi}\int \frac{-\mathrm{Im}(N \bar D)}{|D|^2}\, dp ,"
    )
    found = integral(lambda wave: -np.conj(dispersion(wave, 20.0)).imag / abs(dispersion(wave, 20.0)) ** 2) / (
        2 * np.pi
    )
    assert found.real == pytest.approx(-receptance(BEAM, 0, 20.0, v=V)[0, 0].imag, rel=1e-5)


def test_what_two_forces_put_in_on_average_is_the_form_of_the_page() -> None:
    shown = displayed(PASSIVITY, r"\tfrac12\,q")
    assert r"F^* \Big(\!-\frac{G - G^*}{2i}\Big) F" in shown
    assert r"\begin{pmatrix} G(0) & G(-d) \\ G(d) & G(0) \end{pmatrix}" in shown
    q, F = 15.0, np.array([1.0, 0.4 - 0.8j])
    behind, here, ahead = receptance(BEAM, [-GAP, 0, GAP], q, v=V)[:, 0]
    G = np.array([[here, behind], [ahead, here]])
    form = 0.5 * q * (F.conj() @ (-(G - G.conj().T) / 2j) @ F).real
    t = np.arange(4096) / 4096 * 2 * np.pi / q
    force = (F[:, None] * np.exp(1j * q * t)).real
    speed = (1j * q * (G @ F)[:, None] * np.exp(1j * q * t)).real
    assert form == pytest.approx((force * speed).sum(axis=0).mean(), rel=1e-9)


def test_what_two_forces_put_in_is_the_sum_over_waves_of_the_page() -> None:
    """The form in the receptances, and the integral with |F₁ + F₂ exp(−ipd)|²: F₁ behind, F₂ ahead by d."""
    assert displayed(PASSIVITY, r"\frac{q}{4\pi}") == (
        r"\frac{q}{4\pi}\int -\mathrm{Im}\Big(\frac{N}{D}\Big)\, \big| F_1 + F_2\, e^{-ipd} \big|^2\, dp ."
    )
    q, F = 16.608, np.array([0.3 - 0.9j, 1.0])
    behind, here, ahead = receptance(BEAM, [-GAP, 0, GAP], q, v=V)[:, 0]
    G = np.array([[here, behind], [ahead, here]])
    form = 0.5 * q * (F.conj() @ (-(G - G.conj().T) / 2j) @ F).real

    def put_in(rear: complex, front: complex) -> float:
        shaken = integral(lambda p: -(1 / dispersion(p, q)).imag * abs(rear + front * np.exp(-1j * p * GAP)) ** 2)
        return q / (4 * np.pi) * shaken.real

    assert form < 0  # this pair gains
    assert put_in(*F) == pytest.approx(form, rel=1e-5)
    assert put_in(*F[::-1]) > 0  # front and rear are not the same


def test_the_rear_force_pushes_while_the_front_one_s_wave_lifts_the_rail() -> None:
    q = growing().real
    behind, here, ahead = receptance(BEAM, [-GAP, 0, GAP], q, v=V)[:, 0]
    G = np.array([[here, behind], [ahead, here]])
    worst = np.linalg.eigh(-(G - G.conj().T) / 2j)[1][:, 0]
    assert (1j * q * behind * worst[1] * worst[0].conj()).real < 0  # w counts downward: upward
    assert "pushes down just while that wave lifts the rail" in PASSIVITY


def test_a_damper_s_bill_is_shared_as_the_page_says() -> None:
    """A wave w on the page's beam: the load's mean power along z, seen from the vehicle, and along x times v."""
    assert "vertical force pays the share q/Ω" in PASSIVITY
    assert "the share −vp/Ω" in PASSIVITY
    q, wave, w = 16.608, 0.55, 0.7 - 0.2j
    load, at_rest = dispersion(wave, q) * w, q - V * wave
    burnt = 0.5 * 770 * at_rest**2 * abs(w) ** 2
    vertical = 0.5 * (load.conjugate() * 1j * q * w).real
    engine = -V * 0.5 * (load.conjugate() * 1j * wave * w).real
    assert at_rest < 0
    assert vertical < 0 < burnt < engine
    assert vertical == pytest.approx(burnt * q / at_rest)
    assert engine == pytest.approx(-burnt * V * wave / at_rest)


def test_no_vibration_begins_to_grow_unless_the_track_takes_nothing() -> None:
    """At an onset of two masses the power of their forces is zero beside what the worst and best pairs exchange."""
    v = 191.1833
    row = Problem(BEAM, [vehicles.Mass(MASS).at(0), vehicles.Mass(MASS).at("3.4")], v=v)
    (root,) = [r for r in certify(row, region="unstable", digits=15, check=False).roots if r.q.real > 0]
    q = float(root.q.real.mid())
    behind, here, ahead = receptance(BEAM, [-GAP, 0, GAP], q, v=v)[:, 0]
    G = np.array([[here, behind], [ahead, here]])
    taken = -(G - G.conj().T) / 2j
    force = np.linalg.svd(np.eye(2) - q**2 * MASS * G)[2][-1].conj()
    assert abs(force.conj() @ taken @ force) < 1e-3 * abs(np.linalg.eigvalsh(taken)).min()


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
