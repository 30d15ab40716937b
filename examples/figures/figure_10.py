"""Figure 10: the lowest imaginary part of all induced frequencies at α = 0.99; below zero the vibration grows.

a) η_M = 70 over η_b = 0.04, 0.05, …, 0.99, at the critical distance of each η_b (the distance at which that part is
lowest: 1.245 falling to 1.043). b) over η_M for η_b = 0.05, 0.1, 0.2, 0.5 (the caption prints 0.1 twice), at the
critical distance for η_M = 70. Dotted: zero. Section 4.3 gives η_M = 21.9 as the limit for η_b = 0.1; that belongs to
d = 1.1, and at the critical distance 20.73 is enough.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from induced import on_sheet
from style import LIMIT, agree, greys, page, run

from mpsolve import Case, certify, onset

ALPHA = 0.99
ETA_M = 70.0
ETA_B: Any = np.arange(4, 100) / 100
DISTANCES: Any = np.arange(100, 132, 2) / 100  # among which the critical one is looked for
CURVES = (0.05, 0.1, 0.2, 0.5)  # η_b of b)
MASSES: Any = np.arange(1.0, 101.0)


def lowest(eta_b: Any, eta_m: Any, d: Any) -> Any:
    """The least Im q at α = 0.99 in float64, nan where there is no induced frequency; the arrays broadcast."""
    q = on_sheet(ALPHA, eta_b, eta_m, d).roots
    least = np.where(np.isnan(q.real), np.inf, q.imag).min(axis=-1, initial=np.inf)
    return np.where(np.isfinite(least), least, np.nan)


def critical(eta_b: Any = ETA_B) -> tuple[Any, Any]:
    """The distance of the lowest Im q for η_M = 70, and that Im q, for each η_b: a parabola through three samples."""
    eta_b = np.asarray(eta_b, float)
    sampled = lowest(eta_b[:, None], ETA_M, DISTANCES)
    k = np.clip(sampled.argmin(axis=1), 1, len(DISTANCES) - 2)
    before, here, after = (sampled[np.arange(len(eta_b)), k + j] for j in (-1, 0, 1))
    shift = (before - after) / (2 * (before - 2 * here + after))
    return DISTANCES[k] + shift * (DISTANCES[1] - DISTANCES[0]), here + shift * (after - before) / 4


def check() -> None:
    """Critical distances of Section 4.3, one by certified frequencies; limiting masses there and at d = 1.1."""
    places, least = critical([0.04, 0.1, 0.2, 0.5, 0.99])
    agree(places[[0, -1]], [1.25, 1.05], 0.025)  # as printed, if the paper's distances are multiples of 0.05
    assert np.all(np.diff(places) < 0)
    assert np.all(np.diff(least) < 0)
    near = [_certified("0.5", ETA_M, d) for d in (places[3] - 0.02, places[3], places[3] + 0.02)]
    agree(least[3], near[1], 1e-6)
    assert near[1] < min(near[0], near[2])
    # 21.9 of Section 4.3 and 36.4 of conclusion (xii), which belong to d = 1.1, and to η_b = 0.1 and 0.05
    for eta_b, printed in (("0.1", 21.9), ("0.05", 36.4)):
        pair = Case(alpha="0.99", eta_b=eta_b, eta_m=(1, 1), positions=(0, "1.1"))
        mass = float(onset(pair, over={"eta_m": (1, 100)}).value)  # type: ignore[arg-type]
        agree(mass, printed, 0.05)
        below, above = lowest(float(eta_b), np.array([mass - 1e-6, mass + 1e-6]), 1.1)
        assert below > 0 > above
    assert _certified("0.1", 20.72, places[1]) > 0 > _certified("0.1", 20.73, places[1])
    assert lowest(0.1, 20.72, places[1]) > 0 > lowest(0.1, 20.73, places[1])


def _certified(eta_b: str, eta_m: float, d: float) -> float:
    case = Case(alpha="0.99", eta_b=eta_b, eta_m=(eta_m, eta_m), positions=(0, float(d)))
    return min(float(root.q.imag) for root in certify(case, digits=15).roots)


def visualize(path: Path | str = "figure_10.svg", eta_b: Any = ETA_B, masses: Any = MASSES) -> Path:
    """Writes the picture and returns its path; `eta_b` of a), `masses` η_M of b)."""
    with page(path, 1, 2, (3.4, 2.5)) as axes:
        left, right = axes[0]
        left.plot(eta_b, critical(eta_b)[1], color="black")
        left.set(xlabel="$η_b$", xlim=(0, 1), title="a)")
        places = critical(CURVES)[0]
        for damping, d, grey in zip(CURVES, places, greys(len(CURVES)), strict=True):
            name = f"$η_b = {damping:g}$, $\\hat d = {d:.2f}$"
            right.plot(masses, lowest(damping, masses, d), color=grey, label=name)
        right.set(xlabel="$η_M$", xlim=(0, float(masses[-1])), ylim=(-0.05, 0.1), title="b)")
        right.legend()
        for ax in (left, right):
            ax.axhline(0, **LIMIT)
            ax.set_ylabel("lowest Im $q$")
    return Path(path)


if __name__ == "__main__":
    run(check, visualize, "figure_10")
