"""One evaluation of the kernel, Δ, and Δ with Δ_q, a point, in float64, mpmath and balls.

Float64 is also held against the plain way: numpy.roots of D(p, q), eq. (18), point by point, and the residue
sums (37).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import flint
import numpy as np
from measure import median, seconds

from mpsolve import Case
from mpsolve.fields import MP, Float64, ball_arithmetic
from mpsolve.model.branch import pairing, track
from mpsolve.model.characteristic import characteristic, characteristic_rate
from mpsolve.model.kernel import AHEAD, kernel

CASE = Case(alpha="0.67", eta_b="0.05", eta_m=("70", "70"), positions=("0", "1.5"))
POINT = 0.15 - 0.02j
GRID = np.ravel(np.linspace(-0.4, 0.4, 64)[:, None] - 1j * np.linspace(0.01, 0.6, 64))
REPEATS = {64: 25, 128: 25, 1024: 9, 3322: 3}


def costs(model: Any, q: Any, repeats: int, points: int = 1) -> dict[str, float]:
    """Seconds a point."""
    distance = model.positions[1]
    functions: dict[str, Callable[[], Any]] = {
        "K": lambda: kernel(model, pairing(model, q), AHEAD, distance),
        "Δ": lambda: characteristic(model, q),
        "Δ, Δ_q": lambda: characteristic_rate(model, q),
    }
    return {name: median(lambda f=f: f(), repeats) / points for name, f in functions.items()}


def show(label: str, cost: dict[str, float]) -> None:
    columns = "   ".join(f"{name} {seconds(value)}" for name, value in cost.items())
    print(f"{label:22} {columns}   a point")


def residue_sums(model: Any, q: complex) -> complex:
    """Δ by (26), (37) from numpy's roots of (18)."""
    alpha, r = model.alpha, q - 1j * model.eta_b
    D = np.array([1, 0, -4 * model.A, 8 * alpha * r, 4 * model.beta2 - 4 * r * r])
    p_roots, slope = np.roots(D), np.polyder(D)
    upper, lower = p_roots[p_roots.imag > 0], p_roots[p_roots.imag < 0]

    def K(xi: float) -> Any:
        poles, sign = (upper, 1) if xi >= 0 else (lower, -1)
        return sign * 2j * np.pi * np.sum(np.exp(1j * poles * xi) / np.polyval(slope, poles))

    x, eta = model.positions, model.eta_m
    n, factor = len(x), 2 * q * q / np.pi
    rows = [[int(i == j) - factor * K(x[i] - x[j]) * eta[j] for j in range(n)] for i in range(n)]
    return complex(np.linalg.det(np.array(rows)))


def compare_arithmetics() -> None:
    model = track(CASE, Float64())
    show("float64, 1 point", costs(model, np.array([POINT]), 50))
    show(f"float64, {GRID.size} points", costs(model, GRID, 15, GRID.size))
    expected = complex(characteristic(model, POINT))
    for bits, repeats in REPEATS.items():
        mp = MP(bits)
        point = mp.context.mpc(POINT)
        show(f"mpmath, {bits} bits", costs(track(CASE, mp), point, repeats))
        value = complex(characteristic(track(CASE, mp), point))
        with ball_arithmetic(bits) as field:
            ball = flint.acb(POINT.real, POINT.imag)
            show(f"balls,  {bits} bits", costs(track(CASE, field), ball, repeats))
            enclosure = complex(characteristic(track(CASE, field), ball).mid())
        assert math.isclose(abs(value - expected), 0, abs_tol=1e-11 * abs(expected))
        assert math.isclose(abs(enclosure - expected), 0, abs_tol=1e-11 * abs(expected))


def compare_ways() -> None:
    model = track(CASE, Float64())
    ours = median(lambda: characteristic(model, GRID), 15)
    plain = median(lambda: [residue_sums(model, q) for q in GRID.tolist()], 3)
    print(
        f"Δ at {GRID.size} points        arrays {seconds(ours)}   numpy.roots in a loop {seconds(plain)}   "
        f"loop/arrays = {plain / ours:.0f}"
    )
    loop = np.array([residue_sums(model, q) for q in GRID.tolist()])
    assert np.allclose(characteristic(model, GRID), loop, rtol=1e-9, atol=0)


def test_three_arithmetics_agree() -> None:
    compare_arithmetics()


def test_arrays_agree_with_the_plain_way() -> None:
    compare_ways()


def main() -> None:
    compare_arithmetics()
    compare_ways()


if __name__ == "__main__":
    main()
