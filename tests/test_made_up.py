"""A track and a vehicle that no module knows go the whole way: receptance, certify, certificate, verifier."""

import numpy as np
import pytest
import sympy

from mpsolve import Problem, certify, receptance, tracks, vehicles, verify

P, OMEGA = sympy.symbols("p Omega")


@pytest.fixture(scope="module")
def problem() -> Problem:
    """A beam under tension on two unlike layers, coupled to it and to each other; a lever on contact springs."""
    beam = 2 * P**4 + P**2 / 2 - OMEGA**2 + sympy.Rational(1, 5) * sympy.I * OMEGA + 3
    one = -2 * OMEGA**2 + sympy.Rational(3, 10) * sympy.I * OMEGA + 4
    two = P**2 - OMEGA**2 + sympy.Rational(1, 5) * sympy.I * OMEGA + 2
    matrix = sympy.Matrix(
        [
            [beam, -1, sympy.Rational(-1, 2)],
            [-1, one, sympy.Rational(-1, 3)],
            [sympy.Rational(-1, 2), sympy.Rational(-1, 3), two],
        ]
    )
    lever = vehicles.Vehicle(
        M=[[8, 0], [0, 5]],
        C=[["0.1", 0], [0, "0.1"]],
        K=[[0, 0], [0, 0]],
        B=[[1, 1], ["-3/4", "3/4"]],
        places=["-3/4", "3/4"],
        k_contact=40,
        names=["middle", "tilt"],
    )
    return Problem(tracks.Waveguide(matrix, 0), [lever.at(0), vehicles.Mass(6).at("3.5")], v="0.8")


def test_receptance_is_the_integral_over_wavenumbers(problem: Problem) -> None:
    p = np.linspace(-400, 400, 2_000_001)
    omega, xi = 1.3, 0.6
    matrix = problem.track.waveguide.matrix
    at = lambda entry: sum(float(c) * (1j * p) ** i * (1j * (omega - 0.8 * p)) ** j for (i, j), c in entry.items())  # noqa: E731
    A = np.stack([np.stack([at(entry) + 0 * p for entry in row], -1) for row in matrix], -2)
    direct = np.trapezoid(np.exp(1j * p * xi) * np.linalg.inv(A)[:, 0, 0], p) / (2 * np.pi)
    assert receptance(problem.track, xi=[xi], omega=[omega], v="0.8")[0, 0] == pytest.approx(direct, abs=1e-7)


def test_certificate_carries_the_equations(problem: Problem, tmp_path) -> None:
    found = certify(problem, region="unstable", digits=20)
    assert found.proved, found.reason
    path = found.certificate.save(tmp_path / "made_up.json")
    verdict = verify(path)
    assert verdict.valid, verdict.reason
    assert "made" not in found.certificate.text.split('"equations"')[1].lower()  # equations, no names of models
    assert f"exactly {found.count}" in verdict.claim
