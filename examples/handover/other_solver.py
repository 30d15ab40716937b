"""What another solver takes from mpsolve: certified starting guesses, receptance tables, and the onset.

    python examples/handover/other_solver.py FOLDER

writes seeds.csv, seeds.json, seeds.npz and receptance.csv into FOLDER. `newton` stands for the other solver: it reads
seeds.csv as text and knows nothing of mpsolve. read_seeds, read_receptance and read_onset (.m: MATLAB and Octave,
.mpl: Maple) take the same there; shell.sh makes the files without Python, and the same in JSON.
"""

from __future__ import annotations

import csv
import sys
from pathlib import Path

import numpy as np

from mpsolve import Case, onset, receptance, seeds, tracks

GRID = {"alpha": ("0.5", "0.67"), "eta_b": ("0.05",), "eta_m": (70,), "d": ("1.5",)}
CASE = Case(alpha="0.67", eta_b="0.05", eta_m=(70, 70), positions=(0, "1.5"))
TRACK = tracks.EulerBernoulli(EI="1/4", m=1, k=1, c="0.1")  # the beam of CASE in the paper's units: c = 2 eta_b
XI = (-1.5, 0.0, 1.5)
OMEGA = np.linspace(0.02, 0.3, 15)


def write(folder: Path) -> list[Path]:
    """The tables, each in the forms that others read."""
    table = seeds(**GRID)
    files = [table.save(folder / f"seeds.{kind}") for kind in ("csv", "json", "npz")]
    G = receptance(TRACK, XI, OMEGA, v="0.67")
    path = folder / "receptance.csv"
    with path.open("w", newline="", encoding="utf-8") as stream:
        rows = csv.writer(stream)
        rows.writerow(["omega", *(f"{part}_G({xi:g})" for xi in XI for part in ("re", "im"))])
        for k, omega in enumerate(OMEGA.tolist()):
            rows.writerow([repr(omega), *(repr(float(x)) for z in G[:, k] for x in (z.real, z.imag))])
    return [*files, path]


def first_unstable() -> str:
    """The first unstable velocity ratio of the case, to 12 proved digits."""
    return str(onset(CASE, over={"v": (0, 1)}, digits=20).value.str(12, radius=False))


def newton(file: Path) -> list[tuple[complex, complex, float]]:
    """(seed, root, radius) for each row of seeds.csv: Newton's method in double precision, by the p-roots alone."""
    found = []
    with file.open(encoding="utf-8") as stream:
        for row in csv.DictReader(stream):
            alpha, eta_b, eta, d = (_number(row[name]) for name in ("alpha", "eta_b", "eta_m", "d"))
            seed = q = complex(float(row["q_re"]), float(row["q_im"]))
            q += 0.5 * float(row["radius"])  # any start within the radius will do
            for _ in range(60):
                step = 1e-7
                slope = (_delta(q + step, alpha, eta_b, eta, d) - _delta(q - step, alpha, eta_b, eta, d)) / (2 * step)
                q -= _delta(q, alpha, eta_b, eta, d) / slope
            found.append((seed, q, float(row["radius"])))
    return found


def _number(text: str) -> float:
    top, _, bottom = text.partition("/")
    return float(top) / float(bottom or 1)


def _delta(q: complex, alpha: float, eta_b: float, eta: float, d: float) -> complex:
    """Eq. (26) over π², by (37)."""
    roots = np.roots([1, 0, -4 * alpha**2, 8 * alpha * q - 8j * eta_b * alpha, 4 - 4 * q * q + 8j * eta_b * q])
    weights = 2j * np.pi / (4 * roots**3 - 8 * alpha**2 * roots + 8 * alpha * q - 8j * eta_b * alpha)
    upper = roots.imag > 0
    contact = weights[upper].sum()
    ahead = (weights * np.exp(1j * roots * d))[upper].sum()
    behind = -(weights * np.exp(-1j * roots * d))[~upper].sum()
    a = 2 * eta * q * q / np.pi
    return complex((1 - a * contact) ** 2 - a * a * ahead * behind)


if __name__ == "__main__":
    target = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    for path in write(target):
        print(path)
    for seed, root, radius in newton(target / "seeds.csv"):
        print(f"seed {seed:.12f}  root {root:.12f}  within {abs(root - seed):.1e} of it, radius {radius:.3f}")
    print("onset at alpha =", first_unstable())
