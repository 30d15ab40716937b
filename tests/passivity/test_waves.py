"""Passivity of one contact by its waves: signs and slopes as sums of residues in floats have them."""

from fractions import Fraction

import numpy as np
import pytest
from free_cases import LAYERS

from mpsolve import tracks
from mpsolve.passivity.waves import Waves
from mpsolve.problem.reduced import track_guide
from mpsolve.tracks.waveguide import Track

BEAM = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c=1)
WIRE = tracks.String(T=1, m=1, k=1, c=1)


def waves_of(track: Track, upper: int) -> Waves:
    return Waves(track_guide(track, Fraction(0)), upper)


def truth(waves: Waves, q: float, v: float) -> float:
    """Im G(0, q): i Σ N/D_p over p-roots in the upper half-plane, from D at rest in P = ip, s = i(q − vp)."""
    p = np.polynomial.Polynomial([0, 1])
    s = 1j * (q - v * p)

    def at(polynomial: dict[tuple[int, int], Fraction]) -> np.polynomial.Polynomial:
        return sum(
            (float(c) * (1j * p) ** i * s**j for (i, j), c in polynomial.items()), np.polynomial.Polynomial([0])
        )

    D, N = at(waves.guide.D_rest), at(waves.guide.N_rest)
    roots = D.roots()
    up = roots[roots.imag > 0]
    assert len(up) == waves.upper
    return float((1j * N(up) / D.deriv()(up)).sum().imag)


@pytest.mark.parametrize("name", ["beam", "layers", "wire"])
def test_boxes_that_pass_are_passive_at_random_points(name: str) -> None:
    waves, top = {
        "beam": (waves_of(BEAM, 2), 1.3), "layers": (waves_of(LAYERS, 2), 1.5), "wire": (waves_of(WIRE, 1), 0.9)
    }[name]  # fmt: skip
    rng = np.random.default_rng(3)
    m = np.stack([rng.uniform(0.01, 1, 300), rng.uniform(0.1, top, 300)])
    r = np.stack([0.02 * m[0], 0.01 * np.ones(300)])
    passed = waves.passes(m - r, m + r)
    assert passed.sum() > 100
    for n in np.flatnonzero(passed)[:40]:
        q, v = m[:, n] + r[:, n] * rng.uniform(-1, 1, 2)
        assert truth(waves, q, v) < 0


def test_next_to_zero_the_slope_tells() -> None:
    waves = waves_of(BEAM, 2)  # passivity is lost at 1.18992…
    low, high = np.array([[0.0, 0.0, 0.0], [0.5, 1.18, 1.19]]), np.array([[0.1, 0.01, 0.01], [0.52, 1.181, 1.2]])
    assert list(waves.passes(low, high)) == [True, True, False]
    assert truth(waves, 0.005, 1.195) > 0


def test_the_mixed_slope_is_that_of_differences() -> None:
    waves, h = waves_of(BEAM, 2), 1e-3
    for q, v, size, rising in ((0.01, 1.155, 0.005, True), (0.1, 1.0, 0.005, True), (0.6, 1.0, 0.001, False)):
        mixed = (truth(waves, q + h, v + h) - truth(waves, q - h, v + h) - truth(waves, q + h, v - h)
                 + truth(waves, q - h, v - h))  # fmt: skip
        assert (mixed > 0) is rising
        low, high = np.array([[q - size], [v - size]]), np.array([[q + size], [v + size]])
        assert waves.rises(low, high)[0] == rising
