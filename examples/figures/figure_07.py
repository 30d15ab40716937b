"""Figure 7: maximum and minimum of the envelopes of the unsteady harmonic part at the rear mass, without damping.

η_M = 40, d = 0.5, 1, …, 4.5, over the velocity ratios at which both pairs of induced frequencies exist. With the
amplitudes A₁, A₂ of the two pairs in (36) they are |A₁| + |A₂| and ||A₁| − |A₂||, two lines of one grey for each
distance, light grey to black as it grows. They meet where the higher pair reaches the branch cut and its part fades.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from induced import LAST, end_of_line, on_sheet
from kernels import kernels
from style import agree, greys, page, run
from vibration import checked_vibration, pair_of_masses

ETA_M = 40
DISTANCES = ("0.5", "1", "1.5", "2", "2.5", "3", "3.5", "4", "4.5")
POINTS = 160


def velocities(d: str, points: int = POINTS) -> Any:
    """Velocity ratios from 0.01 almost to the proved one at which the higher pair ends, closer and closer."""
    end = end_of_line(ETA_M, d)
    return end - (end - 0.01) * np.linspace(1, 0.005, points) ** 2


def amplitudes(d: str, alpha: Any) -> Any:
    """|A_k| at ξ = 0 in float64, shape (len(alpha), 2), for unit constant forces; nan without both pairs."""
    found = on_sheet(alpha, 0, float(ETA_M), float(d))
    half = np.sort(
        np.where(found.roots.real > 0, found.roots.real, np.nan), axis=-1
    )  # undamped and subcritical: all real
    q = np.full((len(alpha), 2), np.nan)
    both = found.count == 4
    q[both] = half[both, :2]
    K, rate = kernels(alpha[:, None], 0.0, float(d), q, slope=True)
    contact, behind, ahead = K[..., 0, 0], K[..., 0, 1], K[..., 1, 0]
    a, a_q = 2 * ETA_M * q * q / np.pi, 4 * ETA_M * q / np.pi
    first, first_q = 1 - a * contact, -a_q * contact - a * rate[..., 0, 0]
    crossed = behind * ahead
    crossed_q = rate[..., 0, 1] * ahead + behind * rate[..., 1, 0]
    slope = 2 * first * first_q - 2 * a * a_q * crossed - a * a * crossed_q  # Δ_q of (26) over π²
    shape = (1 - a * (contact - behind)) * contact + (1 - a * (contact - ahead)) * behind
    with np.errstate(invalid="ignore"):
        return 2 * np.abs(4 * shape / (np.pi * q * slope))  # twice: the mirror image −q̄ is in the real part


def check() -> None:
    """Lines up to the printed velocities, amplitudes of the paper's image, least ones near 0, the end of a line."""
    for d, last in LAST[ETA_M].items():
        assert np.isfinite(amplitudes(d, np.array([last, last + 0.01]))).tolist() == [[True, True], [False, False]]
    for d, alpha in (("2", "0.5"), ("4.5", "0.6")):
        (drawn,) = amplitudes(d, np.array([float(alpha)]))
        agree(drawn, checked_vibration(pair_of_masses(alpha, ETA_M, d)).envelope.amplitudes, 1e-9)
        assert abs(drawn[0] - drawn[1]) < 0.02  # Section 4.2: a minimum can be practically zero
    first, second = amplitudes("4", np.array([0.5, 0.8])).T
    assert first[0] < second[0]
    assert first[1] > second[1]  # and exactly zero between them
    higher = amplitudes("1", velocities("1", 200))[:, 1]
    assert higher[-1] < 0.05 * higher.max()


def visualize(path: Path | str = "figure_07.svg", points: int = POINTS) -> Path:
    """Writes the picture and returns its path; `points`: velocity ratios of each line."""
    with page(path, 1, 1, (6.0, 3.6)) as axes:
        ax = axes[0, 0]
        for d, grey in zip(DISTANCES, greys(len(DISTANCES)), strict=True):
            alpha = velocities(d, points)
            first, second = amplitudes(d, alpha).T
            ax.plot(alpha, first + second, color=grey, label=f"$\\hat d = {d}$")
            ax.plot(alpha, abs(first - second), color=grey)
        ax.set(xlabel="$α$", ylabel="greatest and least amplitude", xlim=(0, 1), ylim=(0, None))
        ax.legend(ncols=2, loc="upper left")
    return Path(path)


if __name__ == "__main__":
    run(check, visualize, "figure_07")
