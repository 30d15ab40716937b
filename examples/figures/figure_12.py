"""Figure 12: the velocity ratio at the onset of instability over η_M, one mass and two masses, η_b = 0.05.

The caption prints d = 0.5, 1, 1.5, Section 4.4 d = 1, 1.25, …, 2: here all of d = 0.5, 1, 1.25, 1.5, 1.75, 2. Dashed:
one mass; light grey to black: two masses by growing distance; dotted: α = 1. The lines give for each α the lightest
masses with a real frequency, found as in Section 4.4 (float64). Where a line turns back, some masses have a stable
window above a range of unstable velocities. Circles: first onsets, each proved.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from style import LIMIT, SINGLE, agree, greys, page, run
from vibration import pair_of_masses

from mpsolve import Case, certify, onset, onset_table, receptance, tracks

ETA_B = 0.05
DISTANCES = ("0.5", "1", "1.25", "1.5", "1.75", "2")
MASSES: Sequence[int] = (10, 20, 30, 40, 50, 60, 80, 100)  # the paper's: range(1, 101), some ten minutes
ALPHA: Any = np.linspace(0.4, 1.6, 241)
EDGE = 101.0  # of the picture
FREQUENCIES: Any = np.linspace(0.01, 1.5, 300)


def onsets(masses: Sequence[int] = MASSES, distances: Sequence[str] = DISTANCES) -> Any:
    """The proved first onset of one mass (column 0) and of two at each distance, shape (masses, 1 + distances)."""
    table = onset_table(
        {
            "quantity": "onset velocity",
            "digits": 10,
            "fixed": {"eta_b": str(ETA_B), "alpha": [0, 2]},
            "rows": {"parameter": "eta_m", "values": list(masses)},
            "columns": {"parameter": "d", "values": ["one mass", *distances]},
        }
    )
    return np.array(
        [[np.nan if entry.value is None else float(entry.value) for entry in row] for row in table.entries]
    )


def limit(d: str | None, alpha: Any = ALPHA) -> Any:
    """The least η_M at which an induced frequency is real, inf where none is, in float64; d None: one mass."""
    return np.array(
        [min((eta for eta in _masses(d, v) if eta > 0), default=np.inf) for v in np.asarray(alpha, float)]
    )


def _masses(d: str | None, alpha: float) -> list[float]:
    """η_M at each real root: brackets, made narrower twice, and a chord."""
    found = []
    for low, high in _brackets(d, alpha, FREQUENCIES):
        for _ in range(2):
            narrow = _brackets(d, alpha, np.linspace(low, high, len(FREQUENCIES)))
            low, high = narrow[0] if narrow else (low, high)
        ends = np.array([low, high])
        (one, other), _ = _condition(d, alpha, ends)
        q = low if one == other else low - one * (high - low) / (other - one)
        found.append(float(_condition(d, alpha, np.array([q]))[1][0] / q**2))
    return found


def _brackets(d: str | None, alpha: float, q: Any) -> list[tuple[float, float]]:
    signs = np.sign(_condition(d, alpha, q)[0])
    return [(float(q[k]), float(q[k + 1])) for k in np.nonzero(np.diff(signs))[0]]


def _condition(d: str | None, alpha: float, q: Any) -> tuple[Any, Any]:
    """A real function that vanishes where Δ has a real root q for a real mass, and a = η_M q² there.

    Δ = 1 − 2a G(0) + a² P, P = G(0)² − G(d)G(−d): its imaginary part gives a, its real part by (Im P)² the function.
    """
    beam = tracks.EulerBernoulli(EI="0.25", m=1, k=1, c=str(2 * ETA_B))
    here, ahead, behind = receptance(beam, [0.0, float(d or 1), -float(d or 1)], q, v=float(alpha))
    if d is None:
        return here.imag, 1 / here.real
    product = here**2 - ahead * behind
    i, j = here.imag, product.imag
    return j * j - 4 * i * here.real * j + 4 * i * i * product.real, 2 * i / j


def check() -> None:
    """Lines through proved masses and first onsets; which cross α = 1 (Section 4.4); a mass with a stable window."""
    for d, alpha in ((None, "1.2"), ("1.5", "0.7"), ("2", "1.5")):
        places = (0,) if d is None else (0, d)
        case = Case(alpha=alpha, eta_b=str(ETA_B), eta_m=[1] * len(places), positions=places)
        proved = onset(case, over={"eta_m": (1, 100)}).value
        agree(limit(d, [float(alpha)]), [float(proved)], 1e-8)  # type: ignore[arg-type]
    ((single, close),) = onsets((40,), ("1",))
    assert single > 1 > close
    agree(limit(None, [single]), [40], 1e-4)
    agree(limit("1", [close]), [40], 1e-4)
    assert np.all(np.isinf(limit(None, [0.5, 0.9, 1])))  # one mass: above α = 1 only
    # all curves cross α = 1 but, against the caption, that of d = 0.5
    assert [d for d in DISTANCES if np.isinf(limit(d, [1])[0])] == ["0.5"]
    window = [
        certify(pair_of_masses(alpha, 50, "1.5", str(ETA_B)), digits=15).unstable for alpha in ("0.7", "0.9", "0.99")
    ]
    assert window == [2, 0, 2]
    assert (limit("1.5", [0.7, 0.9, 0.99]) < 50).tolist() == [True, False, True]


def visualize(
    path: Path | str = "figure_12.svg", masses: Sequence[int] = MASSES, distances: Sequence[str] = DISTANCES
) -> Path:
    """Writes the picture and returns its path; `masses` η_M of the proved onsets, in some 1 s each and distance."""
    found = onsets(masses, distances)
    with page(path, 1, 1, (5.6, 4.2)) as axes:
        ax = axes[0, 0]
        looks: list[Any] = [SINGLE, *({"color": grey} for grey in greys(len(distances)))]
        for d, look, column in zip((None, *distances), looks, found.T, strict=True):
            eta = limit(d, ALPHA)
            name = "single mass" if d is None else f"$\\hat d = {d}$"
            ax.plot(np.where(eta < 1.2 * EDGE, eta, np.nan), ALPHA, label=name, **look)
            ax.plot(masses, column, "o", color=look["color"], markersize=3, clip_on=False)
        ax.axhline(1, **LIMIT)
        ax.set(xlabel="$η_M$", ylabel="$α$ at the onset of instability", xlim=(0, EDGE))
        ax.legend(loc="upper right")
    return Path(path)


if __name__ == "__main__":
    run(check, visualize, "figure_12")
