"""Integrals over cells of wavenumber against quadrature, and definite matrices against eigenvalues."""

from __future__ import annotations

import mpmath
import numpy as np

from mpsolve.numbers.affine import Affine
from mpsolve.passivity.hermitian import Density, _bend, _entry, _sinc, definite, positive


def test_the_functions_of_a_cell() -> None:
    x = np.concatenate([np.linspace(1e-9, 3, 200), np.geomspace(3, 500, 50)])
    with mpmath.workdps(40):
        exact = [mpmath.mpf(float(t)) for t in x]
        sinc = [mpmath.sin(t) / t for t in exact]
        bend = [(mpmath.sin(t) - t * mpmath.cos(t)) / t**2 for t in exact]
        for (values, lost), truth in ((_sinc(x), sinc), (_bend(x), bend)):
            error = [float(abs(mpmath.mpf(float(v)) - t)) for v, t in zip(values, truth, strict=True)]
            assert (np.array(error) <= lost).all()
            assert lost.max() < 1e-6


def a_density() -> Density:
    """Three cells of which one absorbs, over one box of a variable q."""
    takes = np.array([[True, True, False]])
    a, b, turn = np.array([[0.0, 2.0, -0.1]]), {"q": np.array([[0.0, 0.3, 0.0]])}, np.array([[0.0, 0.5, 0.0]])
    return Density(np.array([[-1.0, 0.5, 2.0]]), np.array([[0.5, 1.0, 0.5]]), a, b, turn, takes)


def test_one_contact() -> None:
    density = a_density()  # 4 − 0.1 − 0.6
    assert positive(density, np.array([3.29])).all()
    assert not positive(density, np.array([3.31])).any()


def test_an_entry_against_quadrature() -> None:
    density, nodes = a_density(), np.polynomial.legendre.leggauss(40)
    distance = Affine(np.array([[1.7]]), {"gap": np.array([[0.01]])}, np.array([[0.0]]))
    values, lost = _entry(density, distance, ["gap", "q"])
    for gap in (-1.0, 0.4, 1.0):
        for q in (-1.0, 1.0):
            total = 0.0
            for cell in range(3):
                m, h = density.middle[0, cell], density.half[0, cell]
                weight = density.a[0, cell] + density.b["q"][0, cell] * q + density.turn[0, cell] * nodes[0]
                total = total + h * (nodes[1] * weight * np.exp(1j * (m + h * nodes[0]) * (1.7 + 0.01 * gap))).sum()
            assert abs(total - values[0] @ [1, gap, q]) <= lost[0]
    assert lost[0] < 0.1


def test_two_contacts_at_a_distance() -> None:
    density = a_density()
    number = np.array([[-1, -1], [0, -1]])
    near, far = (Affine(np.array([[x]]), {}, np.array([[0.0]])) for x in (0.01, 3.0))
    assert definite(density, [far], number, np.array([0.5])).all()
    assert not definite(density, [near], number, np.array([0.5])).any()
