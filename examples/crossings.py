"""Certificates under certs/ for whole ranges: crossing masses, onsets, windows, a critical distance.

`python examples/crossings.py` proves each anew. Sections are the paper's.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from mpsolve import critical_distance, crossing_masses, onset_velocity, unstable_velocities

FOLDER = Path(__file__).resolve().parent.parent / "certs"

RESULTS: dict[str, Callable[[], object]] = {
    # Section 4.3 prints 21.9 for α = 0.99, η_b = 0.1 at the critical distance; it belongs to d = 1.1
    "crossing_masses_d1.1_alpha0.99": lambda: crossing_masses("0.99", "0.1", (0, "1.1")),
    # Section 4.3: first unstable grid velocities 0.97 and 0.67
    "onset_d1.0_eta70": lambda: onset_velocity("0.05", (70, 70), (0, "1")),
    "onset_d1.5_eta70": lambda: onset_velocity("0.05", (70, 70), (0, "1.5"), digits=100),
    "onset_single_mass_eta70": lambda: onset_velocity("0.05", 70),
    # a stable window between two unstable ranges
    "windows_d1.5_eta50": lambda: unstable_velocities("0.05", (50, 50), (0, "1.5"), alpha=(0, 1)),
    # the line just above the least imaginary part: it is global
    "critical_distance_eta_b0.5": lambda: critical_distance("0.99", "0.5", 70, d=("0.5", 2)),
}


def main() -> None:
    """Writes every certificate."""
    for name, prove in RESULTS.items():
        result = prove()
        certificate = result.certificate  # type: ignore[attr-defined]
        if certificate is None:
            raise SystemExit(f"{name}: {result.reason}")  # type: ignore[attr-defined]
        certificate.save(FOLDER / f"{name}.json")
        print(name)


if __name__ == "__main__":
    main()
