"""The fast path: Δ and Δ_q on arrays against two plain ways, and the paper's study, or a part of it.

The plain ways take the p-roots of D(p, q), eq. (18), by `numpy.roots` point by point, or by batched companion
matrices, then the residue sums (37), (39). `python bench_frequencies.py study` runs all 366,660 cases of the
paper's ranges, in two processes.
"""

from __future__ import annotations

import os
import sys
import time
from typing import Any

import numpy as np
from measure import median, seconds

from mpsolve import Frequencies, Problem, frequencies, tracks, vehicles
from mpsolve.fast.cases import Cases
from mpsolve.fast.count import count_roots
from mpsolve.model.characteristic import characteristic_rate

POINTS = 4096
STUDY = (
    np.arange(1, 141) / 100,
    np.r_[0, np.arange(4, 100) / 100],
    np.array([10.0, 40.0, 70.0]),
    np.arange(1, 10) / 2,
)


def sample(n: int) -> tuple[Cases, Any]:
    """Random damped cases of the study's ranges, and a frequency for each."""
    rng = np.random.default_rng(5)
    eta_m = rng.uniform(10, 70, n)
    cases = Cases(
        rng.uniform(0.1, 1.4, n), np.zeros(n), rng.uniform(0.04, 0.9, n), eta_m, eta_m, rng.uniform(0.5, 4.5, n)
    )
    return cases, rng.uniform(0.05, 0.5, n) - 1j * rng.uniform(0.01, 0.3, n)


def quartic(cases: Cases, q: Any) -> Any:
    """Coefficients of D in p, the highest power first, shape (5, …)."""
    r, one = q - 1j * cases.eta_b, np.ones_like(q)
    A = cases.axial + cases.alpha**2
    return np.stack([one, 0 * q, -4 * A * one, 8 * cases.alpha * r, 4 * (1 - cases.eta_b**2) - 4 * r * r])


def residue_sums(cases: Cases, q: Any, D: Any, p: Any) -> tuple[Any, Any]:
    """Δ by (37) and Δ_q by (39), from the p-roots p of shape (…, 4), sorted by falling imaginary part."""
    D = D[..., None]
    slope, curve = (4 * p * p + 2 * D[2]) * p + D[3], 12 * p * p + 2 * D[2]
    alpha, r = cases.alpha[..., None], (q - 1j * cases.eta_b)[..., None]
    D_q, D_qp = 8 * (alpha * p - r), 8 * alpha

    def K(gap: Any, upper: bool) -> tuple[Any, Any]:
        side, sign = (slice(0, 2), 2j * np.pi) if upper else (slice(2, 4), -2j * np.pi)
        wave = np.exp(1j * p * gap[..., None])
        rate = wave * (D_q * curve / slope**3 - (D_qp + 1j * gap[..., None] * D_q) / slope**2)
        return sign * (wave / slope)[..., side].sum(-1), sign * rate[..., side].sum(-1)

    (contact, contact_q), (ahead, ahead_q), (behind, behind_q) = (
        K(0 * cases.d, True),
        K(cases.d, True),
        K(-cases.d, False),
    )
    a, a_q = 2 * q * q / np.pi * cases.eta_1, 4 * q / np.pi * cases.eta_1
    first, first_q = 1 - a * contact, -a_q * contact - a * contact_q
    value = first * first - a * a * ahead * behind
    return value, 2 * first * first_q - 2 * a * a_q * ahead * behind - a * a * (ahead_q * behind + ahead * behind_q)


def by_roots(cases: Cases, q: Any) -> Any:
    D = quartic(cases, q)
    results = []
    for k in range(len(q)):
        p = np.roots(D[:, k])
        results.append(residue_sums(cases[k], q[k], D[:, k], p[np.argsort(-p.imag)]))
    return np.array(results).T


def by_companions(cases: Cases, q: Any) -> Any:
    D = quartic(cases, q)
    companion = np.zeros((*q.shape, 4, 4), complex)
    companion[..., 0, :] = -np.moveaxis(D[1:], 0, -1)
    companion[..., [1, 2, 3], [0, 1, 2]] = 1
    p = np.linalg.eigvals(companion)
    p = np.take_along_axis(p, np.argsort(-p.imag, axis=-1), -1)
    return np.array(residue_sums(cases, q, D, p))


def compare_evaluations() -> None:
    cases, q = sample(POINTS)
    ours = np.array(characteristic_rate(cases.track, q))
    arrays = median(lambda: characteristic_rate(cases.track, q), 15) / POINTS
    print(f"Δ, Δ_q at {POINTS} points: arrays {seconds(arrays)} a point")
    for name, plain, repeats in (("numpy.roots in a loop", by_roots, 1), ("batched companions", by_companions, 5)):
        assert np.allclose(ours, plain(cases, q), rtol=1e-8, atol=0)
        cost = median(lambda plain=plain: plain(cases, q), repeats) / POINTS
        print(f"  {name:24} {seconds(cost)} a point   {cost / arrays:6.1f} times as much")
    count = median(lambda: count_roots(cases), 3) / POINTS
    print(f"  the number of roots of a case, by its winding number {seconds(count)}")


PAIR = Problem(tracks.EulerBernoulli(EI="0.25", m=1, k=1), vehicles.train(vehicles.Mass(40), 2, 1), v="0.5")


def run_study(part: tuple[Any, ...], workers: int, region: str = "sheet") -> Frequencies:
    """The paper's study by paths: velocity, damping c = 2 η_b, masses, distance."""
    alpha, eta_b, eta_m, d = np.ix_(*part)
    over = {"v": alpha, "track.c": 2 * eta_b, "vehicles.M": eta_m, "gap[0]": d}
    start = time.perf_counter()
    result = frequencies(PAIR, over, region, workers=workers)
    wall = time.perf_counter() - start
    number = result.count.size
    labels, counts = np.unique(result.status, return_counts=True)
    outcome = ", ".join(f"{count} {label}" for label, count in zip(labels.tolist(), counts.tolist(), strict=True))
    print(
        f"{region}: {number} cases, {workers} processes: {wall:.1f} s, {number / wall:.0f} cases a second; {outcome}"
    )
    return result


def test_arrays_agree_with_the_plain_ways() -> None:
    compare_evaluations()


def test_a_part_of_the_study() -> None:
    result = run_study((STUDY[0], STUDY[1][2:4], *STUDY[2:]), 1)
    assert (result.count >= 0).all()


def main() -> None:
    compare_evaluations()
    whole = "study" in sys.argv[1:]
    part, workers = STUDY if whole else (STUDY[0], STUDY[1][2:8], *STUDY[2:]), min(2, os.cpu_count() or 1)
    sheet = run_study(part, workers if whole else 1)
    damped = (part[0], part[1][part[1] > 0], *part[2:])
    below = run_study(damped, workers if whole else 1, "unstable")
    proved = sheet.unstable[:, part[1] > 0]
    assert ((below.count == proved) | (below.count < 0) | (proved < 0)).all()


if __name__ == "__main__":
    main()
