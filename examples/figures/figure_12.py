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
from kernels import kernels
from style import LIMIT, SINGLE, agree, greys, page, run
from vibration import pair_of_masses

from mpsolve import Case, certify, onset, stability_table

ETA_B = 0.05
DISTANCES = ("0.5", "1", "1.25", "1.5", "1.75", "2")
MASSES: Sequence[int] = (10, 20, 30, 40, 50, 60, 80, 100)  # the paper's: range(1, 101), some ten minutes
ALPHA: Any = np.linspace(0.4, 1.6, 481)
EDGE = 101.0  # of the picture
FREQUENCIES: Any = np.linspace(0.01, 1.5, 300)


def onsets(masses: Sequence[int] = MASSES, distances: Sequence[str] = DISTANCES) -> Any:
    """The proved first onset of one mass (column 0) and of two at each distance, shape (masses, 1 + distances)."""
    over: Any = {"v": (0, 2)}
    pair = Case(alpha="0.5", eta_b=str(ETA_B), eta_m=(1, 1), positions=(0, 1))
    table = stability_table(pair, over=over, rows={"eta_m": list(masses)}, columns={"d": list(distances)})
    alone = [onset(Case(alpha="0.5", eta_b=str(ETA_B), eta_m=m), over=over, check=False).value for m in masses]
    single = [np.nan if value is None else float(value.mid()) for value in alone]
    proved = [[float(e.text) if e.status == "proved" else np.nan for e in row] for row in table.entries]
    return np.column_stack([single, proved])


def limit(d: str | None, alpha: Any = ALPHA) -> Any:
    """The least η_M at which an induced frequency is real, inf where none is, in float64; d None: one mass."""
    alpha = np.asarray(alpha, float)
    row, column = np.nonzero(np.diff(np.sign(_condition(d, alpha[:, None], FREQUENCIES)[0]), axis=1))
    velocity, low, high = alpha[row], FREQUENCIES[column], FREQUENCIES[column + 1]
    sign = np.sign(_condition(d, velocity, low)[0])
    for _ in range(48):  # bisections
        middle = (low + high) / 2
        same = np.sign(_condition(d, velocity, middle)[0]) == sign
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    eta = np.pi / (2 * low**2) * _condition(d, velocity, low)[1]
    least = np.full(len(alpha), np.inf)
    np.minimum.at(least, row, np.where(eta > 0, eta, np.inf))
    return least


def _condition(d: str | None, alpha: Any, q: Any) -> tuple[Any, Any]:
    """A real function that vanishes where Δ has a real root q for a real mass, and a = 2 η_M q²/π there.

    Δ = 1 − 2a K(0) + a² P, P = K(0)² − K(d)K(−d): its imaginary part gives a, its real part by (Im P)² the function.
    """
    K = kernels(alpha, ETA_B, float(d or 1), q)[0]
    contact = K[..., 0, 0]
    if d is None:
        return contact.imag, 1 / contact.real
    product = contact**2 - K[..., 0, 1] * K[..., 1, 0]
    i, j = contact.imag, product.imag
    return j * j - 4 * i * contact.real * j + 4 * i * i * product.real, 2 * i / j


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
