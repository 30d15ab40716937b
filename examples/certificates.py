"""The certificates under certs/: typical cases, each proved anew by `python examples/certificates.py`.

Sections and figures are the paper's. The test suite proves a few of them again and verifies every file.
"""

from __future__ import annotations

from pathlib import Path

from mpsolve import Case, PhysicalCase, Rectangle, Spectrum, certify, read_case
from mpsolve.report.figures import save_figure
from mpsolve.report.figures_plane import q_plane

HERE = Path(__file__).resolve().parent
FOLDER = HERE.parent / "certs"


def pair(alpha: str, eta_b: str, eta_m: str, d: str) -> Case:
    """Two equal masses at the distance d, the paper's cases."""
    return Case(alpha=alpha, eta_b=eta_b, eta_m=(eta_m, eta_m), positions=("0", d))


CASES: dict[str, Case | PhysicalCase] = {
    "rail_60e1": read_case(HERE / "rail_60e1.toml"),
    "stable_d1.0_alpha0.96": pair("0.96", "0.05", "70", "1"),  # Section 4.3: unstable from 0.97 on
    "unstable_d1.0_alpha0.97": pair("0.97", "0.05", "70", "1"),
    "stable_d1.5_alpha0.66": pair("0.66", "0.05", "70", "1.5"),  # Section 4.3: unstable from 0.67 on
    "unstable_d1.5_alpha0.67": pair("0.67", "0.05", "70", "1.5"),
    "undamped_subcritical": pair("0.5", "0", "40", "1"),  # Figure 2b
    "undamped_supercritical": pair("1.2", "0", "40", "1"),  # Figure 2b
    "damped_supercritical_d4.5": pair("1.2", "0.05", "40", "4.5"),
    "single_mass": Case(alpha="0.9", eta_b="0.05", eta_m="70"),
    "doubled_mass": pair("0.9", "0.05", "70", "0"),
    "at_rest": pair("0", "0.05", "10", "2"),
    "axial_force": Case(alpha="0.3", eta_b="0.1", eta_m=("10", "25"), positions=("0", "2"), eta_n="0.5"),
    "three_masses": Case(alpha="0.3", eta_b="0.05", eta_m=("10", "20", "30"), positions=("0", "2", "3")),
    "overdamped_line": pair("1", "1.2", "10", "1"),
    "rectangle": pair("0.67", "0.05", "70", "1.5"),
    "cluster_d100": pair("0.5", "0.05", "70", "100"),
    "thousand_digits": pair("0.67", "0.05", "70", "1.5"),
}
REGIONS = {"overdamped_line": "unstable", "rectangle": Rectangle("0.1", "0.2", "-0.1", "0.04")}
DIGITS = {"thousand_digits": 1000}


def prove(name: str) -> Spectrum:
    """The certified spectrum of one of the cases."""
    return certify(CASES[name], digits=DIGITS.get(name, 30), region=REGIONS.get(name, "sheet"))  # type: ignore[arg-type]


def visualize(path: Path | str = "certificate.svg", name: str = "unstable_d1.5_alpha0.67") -> Path:
    """Writes the q-plane of one of the cases, proved anew, with its certified roots; returns the path."""
    return save_figure(lambda ax: q_plane(prove(name), ax), path)


def main() -> None:
    """Writes every certificate."""
    for name in CASES:
        spectrum = prove(name)
        if not (spectrum.proved and spectrum.certificate):
            raise SystemExit(f"{name}: {spectrum.reason}")
        spectrum.certificate.save(FOLDER / f"{name}.json")
        print(f"{name}: {spectrum.count} induced frequencies, {spectrum.unstable} unstable")


if __name__ == "__main__":
    main()
