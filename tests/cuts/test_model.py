"""(eʷ − 1)/w and its slopes against a mean over [0, 1], and models of it against values."""

import numpy as np

from mpsolve.cuts.model import Model, _quotient


def test_the_quotient_has_its_slopes() -> None:
    w = np.array([0.0, 1e-9, 0.999, 1.001j, -3 + 2j])
    E, E1, E2 = _quotient(w)
    t = (np.arange(20000) + 0.5) / 20000
    for k, found in enumerate((E, E1, E2)):
        assert np.allclose(found, (t**k * np.exp(np.outer(w, t))).mean(1), atol=1e-8)


def test_models_of_the_quotient_hold_its_values() -> None:
    rng = np.random.default_rng(3)
    k = rng.normal(size=(6, 40)) + 1j * rng.normal(size=(6, 40))
    k[1:] *= 0.2
    f = Model(k, np.zeros(40), 2)
    model = f.quotient()
    for u in rng.uniform(-1, 1, (20, 2)):
        powers = np.array([1, u[0], u[1], u[0] ** 2, u[0] * u[1], u[1] ** 2])
        w = powers @ k
        assert (np.abs(powers @ model.k - np.expm1(w) / w) <= model.e).all()
    assert np.median(model.e) < 0.5
