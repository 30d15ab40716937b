"""The theorem far out: bounds against samples by another root finder, and no root beyond what it claims."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest

from mpsolve import tracks, vehicles
from mpsolve.errors import PrecisionError
from mpsolve.problem.line import Line, on_line
from mpsolve.problem.problem import Problem
from mpsolve.problem.reduced import reduce_problem
from mpsolve.spectrum.candidates import Area, search
from mpsolve.spectrum.far_line import _floor, _waves, is_free, prove_far


def made(v: object = "0.67", c: object = "0.1", sizes: tuple[object, ...] = (70, 70), gap: object = "3/2") -> Line:
    track = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c=c)
    masses = [vehicles.Mass(M).at(j * Fraction(str(gap))) for j, M in enumerate(sizes)]
    found = on_line(reduce_problem(Problem(track, masses, v=v)))
    assert found is not None
    return found


@pytest.mark.parametrize("W", [4.0, 16.0])
def test_bounds_hold_what_samples_inside_the_circle_show(W: float) -> None:
    """Roots by numpy's companion matrix; the bounds are not much wider."""
    line = made()
    (found,) = _waves(line, np.array([W]))
    assert found is not None
    EI, T, k, m = (float(x) for x in line.beam)
    v = float(line.lower.guide.v) / np.sqrt(EI / m)
    truth = np.zeros(5)
    for radius in (0.3, 0.8, 1.0):
        for u in radius / W * np.exp(1j * np.linspace(-np.pi, np.pi, 97)):
            c = [1, 0, (T / EI + v * v) * u * u, -2 * v * u, 1 + k / EI * u**4]
            corners = np.exp(0.25j * np.pi * np.array([-3, 3, -1, 1]))
            P = np.array([min(np.roots(c), key=lambda p, z=z: abs(p - z)) for z in corners])
            a, na, nb, b = (1, 1, -1, -1) / np.polyval(np.polyder(c), P)
            here = [
                abs(a + na - np.sqrt(0.5) / 2),
                abs(-16j * a * b - 1),
                abs(4 * np.exp(-0.25j * np.pi) * (a + b) - 2),
                abs(P[1:3] - corners[1:3]).max(),
                abs(np.array([a, na, nb, b])).max(),
            ]
            truth = np.maximum(truth, here)
    bounds = np.array([found.at_contact, found.product, found.skew, found.decay, found.largest])
    assert (bounds >= truth).all()
    assert (bounds < 6 * truth).all()


@pytest.mark.parametrize("sizes", [(70,), (70, 70), (1, 200, 5), ("0.1", "0.1"), (70, 65, 60, 55)])
@pytest.mark.parametrize("v", ["0", "0.67", "1.3"])
def test_no_root_is_found_beyond_the_reach(sizes: tuple[object, ...], v: str) -> None:
    line = made(v, "0.2", sizes)
    far = prove_far(line)
    reach, eta = far.reach, float(line.height)
    assert reach < 3000
    grid = (np.geomspace(1, 3, 40)[:, None] * reach - 1j * np.linspace(0, 2, 12)[None, :]).ravel() + 1j * eta
    problem = reduce_problem(line.lower.problem)
    roots = search(problem, Area(0.0, 3 * reach, eta - 3 * reach, eta), grid, 0)
    assert all(abs(q - 1j * eta) < reach or q.imag > eta for q in roots)


def test_reflection_of_pinned_points() -> None:
    """Pinned points in the worst of random phases reflect less than they get, and the bound is below theirs."""
    rng = np.random.default_rng(5)
    d, worst, least = 1 - 1j, 1 / np.sqrt(2), 1.0
    for _ in range(3):
        z = worst * np.exp(2j * np.pi * rng.random(4000))
        least *= 1 - worst / np.sqrt(2)
        worst = abs((z * (d - 2) - 1) / (d + z)).max()
        assert worst < 1
    floor = _floor(4, np.sqrt(0.5), 0.0, 0.0)
    assert floor is not None
    assert 0.9 * least < floor <= least
    assert _floor(4, np.sqrt(0.5) + 0.2, 0.2, 0.1) is None


def test_too_small_a_circle_proves_nothing() -> None:
    line = made(sizes=(70,) * 4)
    (waves,) = _waves(line, np.array([3.0]))
    assert waves is not None
    assert not is_free(line, 3.0, waves)
    assert prove_far(made(gap="1e-3")).reach > prove_far(made(gap="1")).reach
    with pytest.raises(PrecisionError, match="too close together"):
        prove_far(made(gap="1e-8"))
