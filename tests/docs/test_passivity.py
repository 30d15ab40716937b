"""What the page on passivity says, against quadrature, time averages and certified roots."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from theory_pages import BEAM, GAP, MASS, PASSIVITY, V, dispersion, displayed, growing, integral

from mpsolve import Problem, certify, receptance, vehicles


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
    assert "pushes down just while they lift the rail" in PASSIVITY


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


def test_two_forces_are_worst_a_quarter_of_a_wave_apart() -> None:
    """Over distances: the least eigenvalue lies near a quarter of the wave that feeds most, the rear force later."""
    assert "a distance of about a quarter of a wavelength" in PASSIVITY
    q, apart = 14.5, np.linspace(0.5, 6, 111)
    waves = np.linspace(q / V, 3, 100_001)
    length = 2 * np.pi / waves[np.argmin(-(1 / dispersion(waves, q)).imag)]
    G = receptance(BEAM, [0, *-apart, *apart], q, v=V)[:, 0]
    here, behind, ahead = np.full(len(apart), G[0]), G[1 : len(apart) + 1], G[len(apart) + 1 :]
    matrices = np.array([[here, behind], [ahead, here]]).transpose(2, 0, 1)
    values, forces = np.linalg.eigh(-(matrices - matrices.conj().transpose(0, 2, 1)) / 2j)
    worst = int(np.argmin(values[:, 0]))
    rear, front = forces[worst, :, 0]
    assert apart[worst] / length == pytest.approx(0.25, abs=0.05)
    assert -np.angle(rear / front) == pytest.approx(np.pi / 2, abs=np.pi / 9)


def test_the_rail_s_damping_weighs_the_waves_as_the_page_says() -> None:
    """The form of the dampers alone, with weight 1 (foundation) and EIp⁴/k (rail), at the worst two forces."""
    assert "gain a quarter of the above at q = 11 rad/s, and at\nq = 16.6 rad/s they lose" in PASSIVITY

    def form(q: float, weight: Any) -> Any:
        def entry(lag: float) -> complex:
            return integral(
                lambda p: weight(p) * (q - V * p) / abs(dispersion(p, q)) ** 2 * np.exp(-1j * p * lag), 40
            )

        return np.array([[entry(0), entry(GAP)], [entry(-GAP), entry(0)]])

    for q, share in ((11.0, 0.25), (16.6, -0.27)):
        values, forces = np.linalg.eigh(form(q, np.ones_like))
        rail = (forces[:, 0].conj() @ form(q, lambda p: 6.4 * p**4) @ forces[:, 0]).real
        assert values[0] < 0
        assert rail / values[0] == pytest.approx(share, abs=0.02)
        least = np.linalg.eigvalsh(form(q, lambda p: 6.4 * p**4))[0]
        assert 0 < least / values[0] < (0.2 if q > 12 else 1)  # others gain at 16.6 too, less than a fifth
